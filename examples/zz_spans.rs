use gaitcam::drive::Drive;
use gaitcam::gait::{Feet, model};
use gaitcam::synth::lab::{Bound, Task};
use std::time::Instant;
fn main() {
    let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let drive = Drive::moving_axis(
        target.mean_n() / 9.81,
        9.81,
        std::f64::consts::TAU / target.period_s,
    );
    for spans in [8usize, 32, 100, 320, 1000, 3200, 10000] {
        let free = Task {
            target: &target,
            drive,
            degree: 5,
            spans,
            bounds: &[],
        };
        let t = Instant::now();
        let answer = free.free().unwrap();
        let eq = t.elapsed().as_secs_f64();
        let (low, high) = answer.law.extremes(2);
        let (jl, jh) = answer.law.extremes(3);
        for (part, what) in [(0.9, 3), (0.6, 3), (0.8, 2)] {
            let most = part
                * if what == 3 {
                    jh.value.max(-jl.value)
                } else {
                    high.value.max(-low.value)
                };
            let bounds = [Bound { order: what, most }];
            let task = Task {
                bounds: &bounds,
                ..free.clone()
            };
            let t = Instant::now();
            let r = task.exchange();
            println!(
                "{spans} eq {:.1} us  order {what} {part}: {:.3} ms {}",
                1e6 * eq,
                1e3 * t.elapsed().as_secs_f64(),
                match r {
                    Ok(a) => format!("{} it", a.iterations),
                    Err(e) => e.to_string(),
                }
            );
        }
    }
}
