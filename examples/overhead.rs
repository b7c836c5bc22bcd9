//! Processor times of calls without Python, s, as JSON, for the comparison in `python/tests/test_overhead.py`.

use std::time::Instant;

use gaitcam::Problem;
use gaitcam::halt::Halt;
use gaitcam::scene;
use gaitcam::sweep::{Files, Method, Plan, Sampling, Subject, Sweep};
use gaitcam::synth::{Search, design};

/// Processor time of this thread, s, on which the load of the machine has no influence; elapsed time if there is no such clock.
fn processor_s(begun: Instant) -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|t| t.parse::<f64>().ok());
    nanoseconds.map_or(begun.elapsed().as_secs_f64(), |ns| 1e-9 * ns)
}

/// Mean time of a call, after a first call that fills the caches.
fn mean(rounds: usize, mut call: impl FnMut()) -> f64 {
    call();
    let origin = Instant::now();
    let begun = processor_s(origin);
    for _ in 0..rounds {
        call();
    }
    (processor_s(origin) - begun) / rounds as f64
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = scene::parse(scene::DEFAULT)?;
    let synth_s = mean(2000, || {
        let target = scene.model_force().ok().flatten();
        let search = Search::default();
        if let Ok(problem) = Problem::resolve(&scene, target.as_ref())
            && let Ok(design) = design(&problem, &search)
        {
            let _ = design.relaxed_with(&search);
        }
    });
    let mut table = scene::table(scene::DEFAULT)?;
    scene::set(&mut table, "law.family=harmonic")?;
    let axes = [
        "gait.step_frequency=1.5 Hz:2.4 Hz",
        "gait.body_weight=500 N:900 N",
    ];
    let (method, count, seed) = (Method::Latin, 100_000, 1);
    let sampling = Sampling::Sample {
        method,
        count,
        seed,
    };
    let subject = Subject::Designs(Plan::of(table, &axes, sampling)?);
    let sweep = Sweep::with_files(subject, Files::new())?;
    let runner = sweep.runner(&Halt::never, None)?;
    let sweep_s = mean(5, || {
        std::hint::black_box(runner.run(0..100_000, 1, &|| false));
    });
    println!("{{\"synth_s\": {synth_s}, \"sweep_s\": {sweep_s}}}");
    Ok(())
}
