//! Designs a second of the sweep kernel, on one thread and on all.
//!
//! `cargo bench --bench sweep`. Numbers are rows a second in memory: no file.

use divan::Bencher;
use divan::counter::ItemsCount;
use gaitcam::error::{Error, Result};
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::scene::{self, Scene};
use gaitcam::sweep::{Axis, Method, NamedScene, Plan, Runner, Sampling};

fn main() {
    divan::main();
}

fn none(_: usize, _: &Scene) -> Result<ForceCurve> {
    Err(Error::own("no-recordings", "no recordings"))
}

fn plan(changes: &[&str], vary: &[&str], sample: Option<u64>) -> Plan {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a change");
    }
    Plan {
        scenes: vec![NamedScene {
            name: "footbridge".to_string(),
            table,
        }],
        list: None,
        axes: vary
            .iter()
            .map(|v| Axis::parse(v, sample.is_some()).expect("an axis"))
            .collect(),
        sampling: sample.map_or(Sampling::Grid, |count| Sampling::Sample {
            method: Method::Latin,
            count,
            seed: 1,
        }),
    }
}

fn rate(bencher: Bencher, plan: &Plan, threads: usize) {
    let rows = plan.rows() as u64;
    let runner = Runner::of_plan(plan, &none, &Halt::never, None);
    let bencher = bencher.counter(ItemsCount::new(rows));
    bencher.bench_local(|| runner.run(0..rows, threads, &|| false).len());
}

/// Walking speed × body weight × curvature on a grid: 100 speeds share their shapes.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn spectral_grid(bencher: Bencher, threads: usize) {
    let vary = [
        "gait.step_frequency=1.5 Hz:2.4 Hz:100",
        "gait.body_weight=400 N:1000 N:40",
        "limits.curvature=1 mm:20 mm:20",
    ];
    rate(
        bencher,
        &plan(&["law.family=harmonic"], &vary, None),
        threads,
    );
}

/// Every row has a walking speed of its own.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn spectral_sample(bencher: Bencher, threads: usize) {
    let vary = [
        "gait.step_frequency=1.5 Hz:2.4 Hz",
        "gait.body_weight=400 N:1000 N",
    ];
    rate(
        bencher,
        &plan(&["law.family=harmonic"], &vary, Some(20_000)),
        threads,
    );
}

/// A spring-loaded follower: no two rows share a law.
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
    rate(bencher, &plan(&changes, &vary, Some(20_000)), threads);
}

/// Splines of 32 spans whose stroke limit binds: the certified quadratic program.
#[divan::bench(args = [1, 2], sample_count = 3)]
fn qp_32_spans(bencher: Bencher, threads: usize) {
    let vary = ["limits.stroke=40 mm:48 mm"];
    rate(
        bencher,
        &plan(&["law.spans=32", "accuracy.rms=20 %"], &vary, Some(64)),
        threads,
    );
}
