//! Tasks of lab/peers/speed/run.py with gaitcam. It prints one line of JSON for each, with processor times.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::sync::LazyLock;
use std::time::Instant;

use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::Drive;
use gaitcam::force::ForceCurve;
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::synthesise;
use gaitcam_lab::tiers::{Bound, Task};

const WEIGHT: f64 = 700.0;
const GRAVITY: f64 = 9.81;
const F: f64 = 1.85;
const SPANS: usize = 32;

/// Force of the tasks, the same as in lab/peers/speed/common.py.
fn force(theta: f64) -> f64 {
    let factors = [
        0.37 * (F - 0.95),
        0.054 + 0.0044 * F,
        0.026 + 0.0050 * F,
        0.010 + 0.0051 * F,
    ];
    let waves = (1..)
        .zip(factors)
        .map(|(i, a)| a * (f64::from(i) * theta).sin());
    WEIGHT * (1.0 + waves.sum::<f64>())
}

/// Processor time of this thread, s, with a resolution of a few milliseconds; elapsed time if the system does not provide it.
fn processor_time() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|t| t.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |n| 1e-9 * n)
}

/// Minimum duration of a block of runs, s, because of the resolution of the clock.
const BLOCK: f64 = 0.2;
/// Number of blocks for the median.
const BLOCKS: usize = 7;

/// Median processor time after a warm-up, s.
fn median(mut run: impl FnMut()) -> f64 {
    let mut block = |count: usize| {
        let start = processor_time();
        (0..count).for_each(|_| run());
        processor_time() - start
    };
    let mut count = 1;
    while block(count) < BLOCK {
        count *= 2;
    }
    let mut times: Vec<f64> = (0..BLOCKS).map(|_| block(count) / count as f64).collect();
    times.sort_by(f64::total_cmp);
    times[BLOCKS / 2]
}

fn tell(task: &str, seconds: f64, error: &str) {
    println!("{{\"task\": \"{task}\", \"seconds\": {seconds:e}, \"error\": \"{error}\"}}");
}

fn error(drive: &Drive, law: &Law) -> f64 {
    let n = 20_010;
    let square: f64 = (0..n)
        .map(|i| TAU * f64::from(i) / f64::from(n))
        .map(|x| (drive.force(law.svaj(x)) - force(x)).powi(2))
        .sum();
    100.0 * (square / f64::from(n)).sqrt() / WEIGHT
}

/// Default scene with changes.
fn scene_with(changes: &[&str]) -> Scene {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a key of the scene");
    }
    scene::read(&table).expect("a scene")
}

/// Profile point of the double-dwell cam by standard formulae: cycloidal lift, envelope of the roller.
fn envelope(theta: f64) -> [f64; 2] {
    let (quarter, lift) = (0.25 * TAU, 0.02);
    let x = theta / quarter;
    let rise = |u: f64| u - (TAU * u).sin() / TAU;
    let rate = |u: f64| lift / quarter * (1.0 - (TAU * u).cos());
    let (s, v) = match x {
        x if x < 1.0 => (lift * rise(x), rate(x)),
        x if x < 2.0 => (lift, 0.0),
        x if x < 3.0 => (lift * (1.0 - rise(x - 2.0)), -rate(x - 2.0)),
        _ => (0.0, 0.0),
    };
    let height = 0.05 + s;
    let lean = v.atan2(height);
    let [a, b] = [0.01 * lean.sin(), height - 0.01 * lean.cos()];
    let (sin, cos) = theta.sin_cos();
    [cos * a + sin * b, cos * b - sin * a]
}

fn main() {
    let samples = (0..1024)
        .map(|i| force(TAU * f64::from(i) / 1024.0))
        .collect();
    let target = ForceCurve::from_samples("peers", 1.0 / F, samples).expect("a curve");
    let free = Task {
        target: &target,
        drive: Drive::moving_axis(WEIGHT / GRAVITY, GRAVITY, TAU * F),
        degree: 5,
        spans: SPANS,
        bounds: &[],
    };
    let law = no_limits(&free);
    jerk_limit(&free, 0.6 * peak(&law, 3));
    acceleration_and_jerk(&free, &law);
    double_dwell();
}

/// Maximum absolute value of a derivative.
fn peak(law: &Law, order: usize) -> f64 {
    let (low, high) = law.extremes(order);
    high.value.max(-low.value)
}

/// Least-squares law without limits, on which the limits of other tasks are based.
fn no_limits(free: &Task) -> Law {
    let law = free.free().expect("a law");
    let seconds = median(|| drop(black_box(black_box(free).free())));
    tell(
        "no limits, quintic 32 spans",
        seconds,
        &format!("{:.4} % RMS", error(&free.drive, &law)),
    );
    let whole = scene_with(&[]);
    let seconds = median(|| drop(black_box(synthesise(&whole, Some(free.target)))));
    tell(
        "no limits, quintic, public call",
        seconds,
        "spans sought, cam sized, limits and force checked, optimum proved",
    );
    law
}

fn jerk_limit(free: &Task, most: f64) {
    let bounds = [Bound { order: 3, most }];
    let held = Task {
        bounds: &bounds,
        ..*free
    };
    let law = held.exchange().expect("feasible");
    let seconds = median(|| drop(black_box(black_box(&held).exchange())));
    let words = format!(
        "{:.4} % RMS, limit {:+.1e}",
        error(&free.drive, &law),
        peak(&law, 3) / most - 1.0
    );
    tell("jerk limit, quintic 32 spans", seconds, &words);
    let limit = format!("limits.jerk={} m/s^3", most * free.drive.speed.powi(3));
    let changes = ["law.spans=32", "accuracy.rms=20 %", limit.as_str()];
    let whole = scene_with(&changes);
    let seconds = median(|| drop(black_box(synthesise(&whole, Some(free.target)))));
    tell("jerk limit, quintic 32 spans, public call", seconds, &words);
}

/// Runs the task with limits on acceleration and jerk at 95 % of the law without limits.
fn acceleration_and_jerk(free: &Task, free_law: &Law) {
    let bounds = [2, 3].map(|order| Bound {
        order,
        most: 0.95 * peak(free_law, order),
    });
    let both = Task {
        bounds: &bounds,
        ..*free
    };
    let law = both.exchange().expect("feasible");
    let excess = (bounds.iter())
        .map(|b| peak(&law, b.order) / b.most - 1.0)
        .fold(f64::NEG_INFINITY, f64::max);
    let words = format!(
        "{:.4} % RMS, limits {excess:+.1e}",
        error(&free.drive, &law)
    );
    let ready = both.program();
    let seconds = median(|| drop(black_box(black_box(&ready).solve())));
    tell(
        "acceleration and jerk at 95 %, quintic 32 spans",
        seconds,
        &words,
    );
    let seconds = median(|| drop(black_box(black_box(&both).exchange())));
    tell(
        "acceleration and jerk at 95 %, quintic 32 spans, assembled too",
        seconds,
        &words,
    );
}

fn double_dwell() {
    let quarter = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).expect("in the catalogue"),
        lift,
        angle: 0.25 * TAU,
    };
    let segments = [
        quarter("cycloidal", 0.02),
        quarter("dwell", 0.0),
        quarter("cycloidal", -0.02),
        quarter("dwell", 0.0),
    ];
    let follower = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.0,
        roller_radius: 0.01,
    };
    let build = || {
        let law = program(black_box(&segments), Extent::TURN).expect("a full turn");
        Cam { law, follower }.profile(3600)
    };
    let seconds = median(|| drop(black_box(build())));
    let worst = (build().iter())
        .map(|p| {
            let [x, y] = envelope(p.theta);
            (p.x - x).hypot(p.y - y)
        })
        .fold(0.0, f64::max);
    tell(
        "double-dwell roller cam, 3600 points",
        seconds,
        &format!(
            "x and y off the roller's envelope by {:.1e} mm",
            1e3 * worst
        ),
    );
}
