//! Follower of chart (d1) by the adaptive integrator Dopri5 of the crate `ode_solvers`: one mass with 8.5 times the cam's speed, from rest over one
//! turn of a sine. It prints one line of JSON for every tolerance. `cargo run --release --manifest-path lab/peers/ode/Cargo.toml`;
//! lab/peers/speed/run.py adds the result to the report.

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dopri5, System, Vector2};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

const RATIO: f64 = 8.5;
const ZETA: f64 = 0.05;

/// Follower with the equation x″ + 2ζrx′ + r²x = sin θ.
struct Follower;

impl System<f64, Vector2<f64>> for Follower {
    fn system(&self, theta: f64, z: &Vector2<f64>, rate: &mut Vector2<f64>) {
        rate[0] = z[1];
        rate[1] = theta.sin() - 2.0 * ZETA * RATIO * z[1] - RATIO * RATIO * z[0];
    }
}

/// State after one turn in closed form.
fn exact() -> [f64; 2] {
    let (p, q) = (RATIO * RATIO - 1.0, 2.0 * ZETA * RATIO);
    let d = p * p + q * q;
    // Steady motion at 0, which is the same at 2π. The difference from rest at 0 decays.
    let (x0, v0) = (q / d, -p / d);
    let wd = RATIO * (1.0 - ZETA * ZETA).sqrt();
    let sigma = ZETA * RATIO;
    let (a, b) = (x0, (v0 + sigma * x0) / wd);
    let (s, c) = (wd * TAU).sin_cos();
    let fade = (-sigma * TAU).exp();
    [
        -x0 + fade * (a * c + b * s),
        -v0 + fade * ((b * wd - sigma * a) * c - (a * wd + sigma * b) * s),
    ]
}

/// State after one turn by Dopri5. Only the end is requested, because dense output would extrapolate to it from the first step.
fn dopri5(tolerance: f64) -> Vector2<f64> {
    let rest = Vector2::zeros();
    let absolute = tolerance / (RATIO * RATIO);
    let mut run = Dopri5::from_param(
        Follower,
        0.0,
        TAU,
        TAU,
        rest,
        tolerance,
        absolute,
        0.9,
        0.04,
        0.2,
        10.0,
        TAU,
        0.0,
        100_000,
        u32::MAX,
        OutputType::Sparse,
    );
    run.integrate().expect("a smooth system");
    *run.y_out().last().expect("an end")
}

fn tell(name: &str, tolerance: f64, run: fn(f64) -> Vector2<f64>) {
    let truth = exact();
    let z = run(tolerance);
    let amplitude = 1.0 / (RATIO * RATIO - 1.0);
    let off = (z[0] - truth[0]).abs().max((z[1] - truth[1]).abs() / RATIO) / amplitude;
    let mut times: Vec<f64> = (0..101)
        .map(|_| {
            let start = Instant::now();
            black_box(run(black_box(tolerance)));
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "{{\"method\": \"{name}, tolerance {tolerance:.0e}\", \"seconds\": {:e}, \"error\": {off:e}}}",
        times[50]
    );
}

fn main() {
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        tell("Dopri5", tolerance, dopri5);
    }
}
