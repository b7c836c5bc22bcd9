//! Charts (d): a vibrating follower, and a follower in flight.

use nalgebra::{Matrix2, Vector2};

use super::Watch;
use crate::chart::Chart;
use gaitcam::drive::Drive;
use gaitcam::dynamics::Surface;
use gaitcam::dynamics::contact::{self, Limits};
use gaitcam::dynamics::flexible::Linear;
use gaitcam::dynamics::flexible::{Train, steady};
use gaitcam::error::Result;
use gaitcam::law::Law;
use gaitcam_test_support::thesis;

/// Natural frequency of the follower relative to the cam speed.
const RATIO: f64 = 8.5;
/// Damping ratio of the follower.
const ZETA: f64 = 0.05;
/// Angle of the response, rad.
const TURN: f64 = std::f64::consts::TAU;

/// State (deflection, slope) of x″ + 2ζrx′ + r²x = sin θ.
type State = [f64; 2];

fn rate(theta: f64, z: State) -> State {
    [
        z[1],
        theta.sin() - 2.0 * ZETA * RATIO * z[1] - RATIO * RATIO * z[0],
    ]
}

fn moved(z: State, h: f64, terms: &[(f64, State)]) -> State {
    let mut out = z;
    for (w, k) in terms {
        out[0] += h * w * k[0];
        out[1] += h * w * k[1];
    }
    out
}

/// Response from rest in closed form, the exact result.
fn exact(theta: f64) -> State {
    let (p, q) = (RATIO * RATIO - 1.0, 2.0 * ZETA * RATIO);
    let d = p * p + q * q;
    let steady = |t: f64| (p * t.sin() - q * t.cos()) / d;
    let slope = |t: f64| (p * t.cos() + q * t.sin()) / d;
    let (x0, v0) = (-steady(0.0), -slope(0.0));
    let wd = RATIO * (1.0 - ZETA * ZETA).sqrt();
    let sigma = ZETA * RATIO;
    let (a, b) = (x0, (v0 + sigma * x0) / wd);
    let (s, c) = (wd * theta).sin_cos();
    let fade = (-sigma * theta).exp();
    [
        steady(theta) + fade * (a * c + b * s),
        slope(theta) + fade * ((b * wd - sigma * a) * c - (a * wd + sigma * b) * s),
    ]
}

fn rk4(n: usize) -> State {
    let h = TURN / n as f64;
    (0..n).fold([0.0; 2], |z, i| {
        let t = h * i as f64;
        let k1 = rate(t, z);
        let k2 = rate(t + 0.5 * h, moved(z, h, &[(0.5, k1)]));
        let k3 = rate(t + 0.5 * h, moved(z, h, &[(0.5, k2)]));
        let k4 = rate(t + h, moved(z, h, &[(1.0, k3)]));
        let sixth = 1.0 / 6.0;
        moved(
            z,
            h,
            &[
                (sixth, k1),
                (2.0 * sixth, k2),
                (2.0 * sixth, k3),
                (sixth, k4),
            ],
        )
    })
}

/// Leapfrog integration (kick, drift, kick). The damping is part of the kicks, with the new velocity.
fn leapfrog(n: usize) -> State {
    let h = TURN / n as f64;
    let drag = ZETA * RATIO * h;
    let pull = |t: f64, x: f64| t.sin() - RATIO * RATIO * x;
    let mut z = [0.0; 2];
    for i in 0..n {
        let t = h * i as f64;
        let half = z[1] * (1.0 - drag) + 0.5 * h * pull(t, z[0]);
        z[0] += h * half;
        z[1] = (half + 0.5 * h * pull(t + h, z[0])) / (1.0 + drag);
    }
    z
}

/// Coefficients of the Dormand-Prince pair of orders 5 and 4: stages, their times, error.
const A: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
    ],
    &[
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
    ],
    &[
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
const C: [f64; 6] = [0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
const E: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Response by the Dormand-Prince pair with step control.
fn adaptive(tolerance: f64) -> State {
    let (mut t, mut h, mut z) = (0.0, 1e-3, [0.0; 2]);
    let scale = 1.0 / (RATIO * RATIO);
    while t < TURN {
        h = f64::min(h, TURN - t);
        let mut k = vec![rate(t, z)];
        let mut next = z;
        for (row, c) in A.iter().zip(C) {
            let terms: Vec<(f64, State)> = row.iter().copied().zip(k.iter().copied()).collect();
            next = moved(z, h, &terms);
            k.push(rate(t + c * h, next));
        }
        let terms: Vec<(f64, State)> = E.into_iter().zip(k).collect();
        let error = moved([0.0; 2], h, &terms);
        let size = (error[0].abs().max(error[1].abs() / RATIO) / (tolerance * scale)).max(1e-10);
        if size <= 1.0 {
            t += h;
            z = next;
            if TURN - t < 1e-14 {
                break;
            }
        }
        h *= (0.9 * size.powf(-0.2)).clamp(0.2, 5.0);
    }
    z
}

/// Response in closed form for each piece, the method of gaitcam for flexible followers.
fn pieces(forcing: &gaitcam::poly::PiecewisePoly) -> State {
    let linear = Linear {
        rates: Matrix2::new(0.0, 1.0, -RATIO * RATIO, -2.0 * ZETA * RATIO),
        input: Vector2::new(0.0, 1.0),
    };
    let states = linear.through(forcing, Vector2::zeros(), |_| Vector2::zeros());
    states.last().map_or([f64::NAN; 2], |z| [z[0], z[1]])
}

/// Chart of a follower with 8.5 times the cam's speed, from rest over one turn of a sine.
pub fn vibration(watch: &Watch) -> Result<Chart> {
    let truth = exact(TURN);
    let amplitude = 1.0 / (RATIO * RATIO - 1.0);
    let distance =
        |z: State| ((z[0] - truth[0]).abs().max((z[1] - truth[1]).abs() / RATIO)) / amplitude;
    let mut rows = Vec::new();
    for n in [16, 32, 64, 128, 512, 2048, 8192] {
        let (z, timing) = watch.time(|| rk4(std::hint::black_box(n)));
        rows.push(timing.row("RK4", format!("{n} steps"), distance(z)));
        let (z, timing) = watch.time(|| leapfrog(std::hint::black_box(n)));
        rows.push(timing.row("leapfrog", format!("{n} steps"), distance(z)));
    }
    for exponent in [3, 6, 9, 12] {
        let tolerance = 10f64.powi(-exponent);
        let (z, timing) = watch.time(|| adaptive(std::hint::black_box(tolerance)));
        rows.push(timing.row(
            "adaptive Dormand–Prince 5(4)",
            format!("tolerance 1e-{exponent}"),
            distance(z),
        ));
    }
    let law = Law::harmonic(0.0, &[(0.0, 1.0)]);
    let forcing = law.combination([1.0, 0.0, 0.0, 0.0], 0.0);
    let (z, timing) = watch.time(|| pieces(&forcing));
    let row = timing.row(
        "closed form",
        format!("{} pieces", forcing.pieces()),
        distance(z),
    );
    rows.push(row.by_default());
    let drive = Drive::moving_axis(1.0, 9.81, 11.624);
    let train = Train::from_frequency(&drive, RATIO * drive.speed / TURN, ZETA)?;
    let (settled, timing) = watch.time(|| steady(&law, &drive, &train));
    let settled = settled?;
    let mut row = timing.row(
        "closed form, periodic",
        format!("{} angles", settled.theta.len()),
        distance(z),
    );
    row.note =
        "the settled motion at once; an integrator needs about 16 turns for 1e-11".to_string();
    row.error = steady_error(&settled, &drive);
    rows.push(row);
    Ok(Chart {
        file: "speed_accuracy_d1".to_string(),
        title: "(d1) Vibrating follower".to_string(),
        task: format!("One mass, natural frequency {RATIO} times the cam's speed, damping ratio {ZETA}, from rest over one turn of a sine; RK4 is unstable below 19 steps, leapfrog below 27."),
        error: "error of the state after one turn, part of the response".to_string(),
        advice: "Use the closed form. It has no step size and no stability limit, is exact to rounding, and is faster than an adaptive integrator at 1e-7 (lab/peers/ode tests a crate). For a rough result, RK4 with 100 fixed steps per turn is sufficient.".to_string(),
        rows,
        ..Chart::default()
    })
}

/// Maximum error of the steady deflection compared with the closed form of a sine, relative to its amplitude.
fn steady_error(steady: &gaitcam::dynamics::flexible::Steady, drive: &Drive) -> f64 {
    let (p, q) = (RATIO * RATIO - 1.0, 2.0 * ZETA * RATIO);
    let d = p * p + q * q;
    let sag = -drive.rest_force / (drive.mass * (RATIO * drive.speed).powi(2));
    let worst = (steady.theta.iter().zip(&steady.deflection))
        .map(|(t, x)| (x - sag - (p * t.sin() - q * t.cos()) / d).abs())
        .fold(0.0, f64::max);
    worst * d.sqrt()
}

const FAST: f64 = 35.0;

/// Angle at which the mass on the eccentric lands, by bisection on the parabola; the exact result.
fn landing() -> f64 {
    let (e, g) = (thesis::LIFT, 9.81 / (FAST * FAST));
    let leaves = (g / e).asin();
    let gap = |t: f64| {
        let d = t - leaves;
        e * leaves.sin() + e * leaves.cos() * d - 0.5 * g * d * d - e * t.sin()
    };
    let (mut low, mut high) = (leaves + 1.0, leaves + 4.0);
    for _ in 0..100 {
        let mid = 0.5 * (low + high);
        if gap(mid) > 0.0 {
            low = mid
        } else {
            high = mid
        }
    }
    low
}

/// Landing angle by small steps, with contact whenever the mass would penetrate the cam. Simulators without events use this method.
fn stepped(n: usize, interpolate: bool) -> f64 {
    let (e, g) = (thesis::LIFT, 9.81 / (FAST * FAST));
    let h = TURN / n as f64;
    let (mut y, mut v, mut flying) = (0.0, e, false);
    for i in 1..2 * n {
        let t = h * i as f64;
        let (y_next, v_next) = (y + h * v - 0.5 * g * h * h, v - g * h);
        let cam = e * t.sin();
        let over = y_next - cam;
        if flying && over <= 0.0 {
            let before = y - e * (t - h).sin();
            return if interpolate {
                t - h + h * before / (before - over)
            } else {
                t
            };
        }
        flying = over > 0.0 && e * t.sin() > g;
        if flying || over > 0.0 {
            (y, v) = (y_next, v_next);
            flying = true;
        } else {
            (y, v) = (cam, e * t.cos());
        }
    }
    f64::NAN
}

/// Chart of the landing angle of the mass on the eccentric of theory §3 at 35 rad/s.
pub fn flight(watch: &Watch) -> Result<Chart> {
    let truth = landing();
    let mut rows = Vec::new();
    for n in [100, 1000, 10_000, 100_000] {
        for (name, interpolate) in [
            ("fixed steps", false),
            ("fixed steps, crossing interpolated", true),
        ] {
            let (at, timing) = watch.time(|| stepped(std::hint::black_box(n), interpolate));
            rows.push(timing.row(name, format!("{n} a turn"), (at - truth).abs()));
        }
    }
    let cam = thesis::eccentric();
    let drive = thesis::real(FAST);
    let surfaces = [Surface::new(cam.law, &drive)];
    let once = Limits {
        turns: 1,
        ..Limits::default()
    };
    let plastic = 0.0;
    let (run, timing) = watch.time(|| contact::run(&surfaces, &drive, plastic, &once));
    let at = run.impacts.first().map_or(f64::NAN, |i| i.at);
    let row = timing.row(
        "event-driven, flight in closed form",
        "one turn",
        (at - truth).abs(),
    );
    rows.push(row.by_default());
    Ok(Chart {
        file: "speed_accuracy_d2".to_string(),
        title: "(d2) Follower that loses contact".to_string(),
        task: format!("Eccentric of 10 mm with a free mass at {FAST} rad/s; lift-off at 53.208°, landing at {:.6}°.", truth.to_degrees()),
        error: "error of the landing angle, rad".to_string(),
        levels: vec![(f64::to_radians(0.1), "0.1°".to_string())],
        advice: "Use the event-driven simulation. Time stepping that finds the landing to a hundredth of a degree is slower.".to_string(),
        rows,
        ..Chart::default()
    })
}
