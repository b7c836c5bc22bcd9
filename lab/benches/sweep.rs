//! Designs per second of the sweep kernel, on one thread and on all.
//!
//! `cargo bench --bench sweep`. The numbers are rows per second in memory, without a file.

use divan::Bencher;
use divan::counter::ItemsCount;
use gaitcam::halt::Halt;
use gaitcam::scene;
use gaitcam::sweep::{Files, Method, Plan, Sampling, Subject, Sweep};

fn main() {
    divan::main();
}

fn sweep(changes: &[&str], vary: &[&str], sample: Option<u64>) -> Sweep {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a change");
    }
    let sampling = sample.map_or(Sampling::Grid, |count| Sampling::Sample {
        method: Method::Latin,
        count,
        seed: 1,
    });
    let plan = Plan::of(table, vary, sampling).expect("axes");
    Sweep::with_files(Subject::Designs(plan), Files::new()).expect("values that exist")
}

fn rate(bencher: Bencher, sweep: &Sweep, threads: usize) {
    let rows = sweep.rows().expect("a number of rows");
    let runner = sweep.runner(&Halt::never, None).expect("a plan");
    let bencher = bencher.counter(ItemsCount::new(rows));
    bencher.bench_local(|| runner.run(0..rows, threads, &|| false).len());
}

/// Grid of walking speed × body weight × curvature. The 100 speeds share their shapes.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn spectral_grid(bencher: Bencher, threads: usize) {
    let vary = [
        "gait.step_frequency=1.5 Hz:2.4 Hz:100",
        "gait.body_weight=400 N:1000 N:40",
        "limits.curvature=1 mm:20 mm:20",
    ];
    rate(
        bencher,
        &sweep(&["law.family=harmonic"], &vary, None),
        threads,
    );
}

/// Sample in which every row has a different walking speed.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn spectral_sample(bencher: Bencher, threads: usize) {
    let vary = [
        "gait.step_frequency=1.5 Hz:2.4 Hz",
        "gait.body_weight=400 N:1000 N",
    ];
    rate(
        bencher,
        &sweep(&["law.family=harmonic"], &vary, Some(20_000)),
        threads,
    );
}

/// Follower with a spring: no two rows have the same law.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn spectral_spring(bencher: Bencher, threads: usize) {
    let changes = [
        "law.family=harmonic",
        "drive.kind=fixed-axis",
        "drive.mass=2 kg",
        "limits.stroke=1 m",
    ];
    let vary = [
        "drive.spring_rate=9000 N/m:20000 N/m",
        "drive.preload=100 N:150 N",
    ];
    rate(bencher, &sweep(&changes, &vary, Some(20_000)), threads);
}

/// Splines of 32 spans with an active stroke limit: the certified quadratic program.
#[divan::bench(args = [1, 2], sample_count = 3)]
fn qp_32_spans(bencher: Bencher, threads: usize) {
    let vary = ["limits.stroke=40 mm:48 mm"];
    rate(
        bencher,
        &sweep(&["law.spans=32", "accuracy.rms=20 %"], &vary, Some(64)),
        threads,
    );
}
