//! Duration of the synthesis by method. The required times are given at each benchmark; reports/benchmarks.md contains the last results.

use std::f64::consts::{PI, TAU};

use gaitcam::cam::smallest_prime_circle;
use gaitcam::drive::Drive;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene;
use gaitcam::synth::synthesise;
use gaitcam_lab::tiers::{Between, Bound, Task, spectral};

fn main() {
    divan::main();
}

fn footbridge() -> (ForceCurve, Drive) {
    let target = model("young", Some(1.85), 700.0, Feet::Both).expect("a known model");
    let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
    (target, drive)
}

/// Default scene from force curve to checked cam. Required: 2 ms.
#[divan::bench]
fn default_scene(bencher: divan::Bencher) {
    let table = scene::DEFAULT.parse().expect("the built-in scene");
    let scene = scene::read(&table).expect("the built-in scene");
    let (target, _) = footbridge();
    bencher.bench(|| synthesise(divan::black_box(&scene), Some(&target)).expect("a law"));
}

/// Inversion of 1000 samples with 20 harmonics. Required: 20 µs.
#[divan::bench]
fn spectral_1000_samples_20_harmonics(bencher: divan::Bencher) {
    let (curve, drive) = footbridge();
    let samples = (0..1000)
        .map(|i| curve.at(TAU * f64::from(i) / 1000.0))
        .collect();
    let target = ForceCurve::from_samples("1000", curve.period_s, samples).expect("a curve");
    bencher.bench(|| spectral(divan::black_box(&target), drive, 20).expect("no resonance"));
}

/// Least squares with equality constraints, quintic. The time is linear up to 10 000 spans.
#[divan::bench(args = [32, 100, 1000, 10_000])]
fn equality_quintic(bencher: divan::Bencher, spans: usize) {
    let (target, drive) = footbridge();
    let task = Task {
        target: &target,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    };
    bencher.bench(|| divan::black_box(&task).free().expect("a law"));
}

/// Limits on velocity, acceleration and jerk at this percentage of the law without limits, on 32 quintic spans.
fn limits(spans: usize, percent: f64) -> Vec<Bound> {
    let (target, drive) = footbridge();
    let task = Task {
        target: &target,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    };
    let free = task.free().expect("a law");
    [2, 3]
        .map(|order| {
            let (low, high) = free.extremes(order);
            Bound {
                order,
                most: 0.01 * percent * high.value.max(-low.value),
            }
        })
        .to_vec()
}

/// Program with limits that hold at all angles, by exchange of rows: typical (limits just active) and worst case (tight limits).
#[divan::bench(args = [95.0, 60.0, 30.0])]
fn certified_qp_quintic_32_spans_at_percent(bencher: divan::Bencher, percent: f64) {
    let (target, drive) = footbridge();
    let bounds = limits(32, percent);
    let task = Task {
        target: &target,
        drive,
        degree: 5,
        spans: 32,
        bounds: &bounds,
    };
    bencher.bench(|| divan::black_box(&task).exchange().expect("feasible"));
}

/// Program with these limits as Bernstein rows, all given at once.
#[divan::bench(args = [95.0, 60.0, 30.0])]
fn bernstein_rows_quintic_32_spans_at_percent(bencher: divan::Bencher, percent: f64) {
    let (target, drive) = footbridge();
    let bounds = limits(32, percent);
    let task = Task {
        target: &target,
        drive,
        degree: 5,
        spans: 32,
        bounds: &bounds,
    };
    bencher.bench(|| {
        let conic = divan::black_box(&task)
            .conic(Between::Coefficients)
            .expect("rows");
        conic.solve(1e-9).expect("feasible")
    });
}

/// Complete scene with jerk, acceleration and curvature limits.
#[divan::bench]
fn scene_with_jerk_acceleration_and_curvature(bencher: divan::Bencher) {
    let mut table = scene::DEFAULT.parse().expect("the built-in scene");
    for change in [
        "limits.jerk=150 m/s^3",
        "limits.acceleration=5 m/s^2",
        "law.spans=32",
    ] {
        scene::set(&mut table, change).expect("a key of the scene");
    }
    let scene = scene::read(&table).expect("a scene");
    let (target, _) = footbridge();
    bencher.bench(|| synthesise(divan::black_box(&scene), Some(&target)).expect("a law"));
}

fn rise_and_fall() -> Law {
    let third = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).expect("in the catalogue"),
        lift,
        angle: TAU / 3.0,
    };
    let segments = [
        third("3-4-5", 0.02),
        third("3-4-5", -0.02),
        third("dwell", 0.0),
    ];
    program(&segments, Extent::TURN).expect("a full turn")
}

/// Prime circle in closed form from exact extrema of the law.
#[divan::bench]
fn prime_circle_closed_form(bencher: divan::Bencher) {
    let law = rise_and_fall();
    bencher.bench(|| smallest_prime_circle(divan::black_box(&law), PI / 6.0, PI / 6.0, None));
}

/// Prime circle from 1000 points of a law.
#[divan::bench]
fn prime_circle_per_1000_points(bencher: divan::Bencher) {
    let law = rise_and_fall();
    let points: Vec<(f64, f64)> = (0..1000)
        .map(|i| law.svaj(TAU * f64::from(i) / 1000.0))
        .map(|at| (at.s, at.v))
        .collect();
    let t = (PI / 6.0).tan();
    bencher.bench(|| {
        let worst = |sign: f64| {
            divan::black_box(&points)
                .iter()
                .map(|(s, v)| sign * v - t * s)
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let (rise, fall) = (worst(1.0), worst(-1.0));
        let height = (rise + fall) / (2.0 * t);
        height.hypot(rise - t * height)
    });
}
