//! Rows of a sweep per second.

use gaitcam::halt::Halt;
use gaitcam::scene;
use gaitcam::sweep::{Files, Method, Plan, Sampling, Subject, Sweep};

use super::table::Report;
use crate::timing::{Times, times};

/// Times of the kernel for `rows` rows.
fn swept(changes: &[&str], vary: &[&str], rows: u64, threads: usize) -> Times {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a change");
    }
    let sampling = Sampling::Sample {
        method: Method::Latin,
        count: rows,
        seed: 1,
    };
    let plan = Plan::of(table, vary, sampling).expect("axes");
    let sweep = Sweep::with_files(Subject::Designs(plan), Files::new()).expect("a plan");
    let runner = sweep.runner(&Halt::never, None).expect("a plan");
    times(|| runner.run(0..rows, threads, &|| false).len())
}

pub(crate) fn sweeps(report: &mut Report) {
    let both = [
        "gait.step_frequency=1.5 Hz:2.4 Hz",
        "gait.body_weight=400 N:1000 N",
    ];
    // The number of rows is large, so that the start of the threads (about 2 ms) has little influence.
    let rows = 128_000;
    let spectral = |threads| swept(&["law.family=harmonic"], &both, rows, threads);
    let (one, two) = (spectral(1), spectral(2));
    report.rate(
        "sweep",
        "spectral designs, each with a speed of its own, one thread",
        100_000.0,
        rows,
        one,
    );
    report.rate(
        "sweep",
        "spectral designs, each with a speed of its own, two threads",
        100_000.0,
        rows,
        two,
    );
    report.at_least(
        "sweep",
        "two threads over one, fastest runs",
        1.8,
        one.fastest / two.fastest,
    );
    let changes = ["law.spans=32", "accuracy.rms=20 %"];
    let rows = 64;
    let qp = swept(&changes, &["limits.stroke=40 mm:48 mm"], rows, 2);
    report.rate(
        "sweep",
        "certified QP scenes of 32 spans, the stroke binding, two threads",
        4000.0,
        rows,
        qp,
    );
}
