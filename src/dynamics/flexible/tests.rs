use super::*;
use crate::cam::Cam;
use crate::dynamics::recover::recover;
use crate::dynamics::thesis;
use crate::law::Wave;
use crate::poly::bernstein;
use std::f64::consts::{PI, TAU};

fn open(poly: PiecewisePoly, waves: Vec<Vec<Wave>>) -> Law {
    Law::with_waves(poly, waves, false)
}

/// Cycloidal rise of unit lift over unit angle. The next functions return other motions of the same lift and angle.
fn cycloidal() -> Law {
    let wave = Wave {
        rate: TAU,
        cos: 0.0,
        sin: -1.0 / TAU,
    };
    open(
        PiecewisePoly::new(vec![0.0, 1.0], 1, vec![0.0, 1.0]),
        vec![vec![wave]],
    )
}

fn simple_harmonic() -> Law {
    let wave = Wave {
        rate: PI,
        cos: -0.5,
        sin: 0.0,
    };
    open(
        PiecewisePoly::new(vec![0.0, 1.0], 0, vec![0.5]),
        vec![vec![wave]],
    )
}

fn parabolic() -> Law {
    open(
        PiecewisePoly::new(vec![0.0, 0.5, 1.0], 2, vec![0.0, 0.0, 0.5, 0.5, 1.0, 1.0]),
        Vec::new(),
    )
}

fn power(p: &[f64]) -> Law {
    open(
        PiecewisePoly::new(vec![0.0, 1.0], p.len() - 1, bernstein::from_power(p)),
        Vec::new(),
    )
}

/// Modified-sine rise of unit lift. The acceleration is a quarter sine of rate 4π up to 1/8 and a half sine of rate 4π/3 in the middle.
fn modified_sine() -> Law {
    let c = 1.0 / (PI + 4.0);
    let at = |x: f64| c * (PI * x - 0.25 * (4.0 * PI * x).sin());
    // Lift in the middle: s = c(2 + πx − (9/4) sin(4πx/3 + π/3)). Lift at the end: c(4 + πx − ¼ sin 4πx).
    let line = |x: f64, c0: f64| c * (c0 + PI * x);
    let poly = PiecewisePoly::new(
        vec![0.0, 0.125, 0.875, 1.0],
        1,
        vec![
            line(0.0, 0.0),
            line(0.125, 0.0),
            line(0.125, 2.0),
            line(0.875, 2.0),
            line(0.875, 4.0),
            line(1.0, 4.0),
        ],
    );
    let sine = |rate: f64, amplitude: f64, phase: f64| Wave {
        rate,
        cos: amplitude * phase.sin(),
        sin: amplitude * phase.cos(),
    };
    let waves = vec![
        vec![sine(4.0 * PI, -0.25 * c, 0.0)],
        vec![sine(4.0 * PI / 3.0, -2.25 * c, PI / 2.0)],
        vec![sine(4.0 * PI, -0.25 * c, 3.5 * PI)],
    ];
    let law = open(poly, waves);
    assert!((law.svaj(0.1).s - at(0.1)).abs() < 1e-15);
    law
}

/// Modified-trapezoid rise of unit lift. The acceleration is constant from 1/8 to 3/8, between sinusoidal flanks.
fn modified_trapezoid() -> Law {
    let peak = 8.0 * PI / (2.0 + PI);
    let r = 4.0 * PI;
    // Piecewise: acceleration peak·sin(4πx), peak, peak·cos(4π(x − 3/8)), … antisymmetric about ½.
    let (mut s, mut v) = (0.0, 0.0);
    let mut coef = Vec::new();
    let mut waves = Vec::new();
    for (width, kind, sign) in [
        (0.125, 's', 1.0),
        (0.25, 'k', 1.0),
        (0.25, 'c', 1.0),
        (0.25, 'k', -1.0),
        (0.125, 'd', 1.0),
    ] {
        let p = sign * peak;
        let (poly, wave): ([f64; 3], Option<(f64, f64)>) = match kind {
            's' => ([s, v + p / r, 0.0], Some((0.0, -p / (r * r)))),
            'k' => ([s, v, 0.5 * p], None),
            'c' => ([s + p / (r * r), v, 0.0], Some((-p / (r * r), 0.0))),
            // −peak·cos(4πx'), from −peak back to zero.
            _ => ([s - p / (r * r), v, 0.0], Some((p / (r * r), 0.0))),
        };
        let (wc, ws) = wave.unwrap_or((0.0, 0.0));
        let scaled = [poly[0], poly[1] * width, poly[2] * width * width];
        coef.extend(bernstein::from_power(&scaled));
        waves.push(vec![Wave {
            rate: r,
            cos: wc,
            sin: ws,
        }]);
        let (sin, cos) = (r * width).sin_cos();
        s = poly[0] + width * (poly[1] + width * poly[2]) + wc * cos + ws * sin;
        v = poly[1] + 2.0 * width * poly[2] + r * (ws * cos - wc * sin);
    }
    let law = open(
        PiecewisePoly::new(vec![0.0, 0.125, 0.375, 0.625, 0.875, 1.0], 2, coef),
        waves,
    );
    assert!((law.svaj(1.0).s - 1.0).abs() < 1e-14 && law.svaj(1.0).v.abs() < 1e-13);
    law
}

/// Amplitude of the residual vibration after a rise, in the units of the lift. The follower is undamped with the natural frequency `ratio`, in
/// radians per radian of the cam (λ·2π/β for a rise in β).
///
/// The follower starts at rest at the first angle of the law. Steps of the velocity at the start and at the end of the law (into the dwell) are
/// included.
fn residual_vibration(law: &Law, ratio: f64) -> f64 {
    let model = Model {
        linear: Linear {
            rates: Matrix2::new(0.0, ratio, -ratio, 0.0),
            input: Vector2::new(0.0, -1.0 / ratio),
        },
        force: law.combination([0.0, 0.0, 1.0, 0.0], 0.0),
        contact: Vector2::zeros(),
        scale: ratio,
    };
    let kicks = kicks(law, &model);
    let kick = |piece: usize| {
        let own = kicks.iter().find(|k| k.0 == piece);
        own.map_or_else(Vector2::zeros, |k| k.1)
    };
    let first = law.svaj_on(0, 0.0);
    let start = Vector2::new(0.0, -first.v / ratio);
    let states = (model.linear).through(&model.force, start, kick);
    let last = states.last().copied().unwrap_or_default();
    let end = law.svaj_on(law.breaks().len() - 2, 1.0);
    last[0].hypot(last[1] + end.v / ratio)
}

#[test]
fn residual_vibrations_are_the_closed_forms_to_1e_6() {
    // Closed forms of theory §7 without damping. λ is the rise time divided by the natural period.
    for i in 0..200 {
        let lambda = 0.513 + 0.0713 * f64::from(i);
        let ratio = TAU * lambda;
        let l2 = lambda * lambda;
        let forms = [
            (
                cycloidal(),
                (PI * lambda).sin().abs() / (PI * lambda * (l2 - 1.0).abs()),
            ),
            (
                simple_harmonic(),
                (PI * lambda).cos().abs() / (4.0 * l2 - 1.0).abs(),
            ),
            (
                parabolic(),
                16.0 * (0.5 * PI * lambda).sin().powi(2) / (2.0 * PI * lambda).powi(2),
            ),
        ];
        for (law, exact) in forms {
            let got = residual_vibration(&law, ratio);
            assert!((got - exact).abs() < 1e-12, "{lambda} {got} {exact}");
        }
    }
}

#[test]
fn the_worst_residual_vibrations_are_those_of_the_table() {
    // Table of theory §7, two digits: maximum residual vibration over λ ∈ [5, 6] and over λ ∈ [10, 11].
    let p345 = power(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0]);
    let p4567 = power(&[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0]);
    for (law, near, far) in [
        (cycloidal(), 2.0e-3, 2.8e-4),
        (p345, 3.1e-3, 4.2e-4),
        (p4567, 1.6e-3, 1.1e-4),
        (modified_sine(), 5.3e-3, 4.3e-4),
        (modified_trapezoid(), 5.4e-3, 3.4e-4),
        (parabolic(), 1.6e-2, 3.4e-3),
    ] {
        for (start, stated) in [(5.0, near), (10.0, far)] {
            let worst = (0..=1000)
                .map(|i| residual_vibration(&law, TAU * (start + f64::from(i) * 1e-3)))
                .fold(0.0, f64::max);
            let digits = 10.0_f64.powf(stated_exponent(stated) - 1.0);
            assert!(
                (worst - stated).abs() <= 0.5001 * digits,
                "{worst} {stated}"
            );
        }
    }
}

fn stated_exponent(x: f64) -> f64 {
    x.log10().floor()
}

#[test]
fn the_steady_state_of_a_harmonic_cam_is_the_textbook_amplification() {
    // Lift s = h sin θ, one mass, excitation through k₁ and c₁. The contact force has the amplitude −(k₁ + i c₁ ω) X with X = −F̂/((k + k₁)
    // − mω² + i(c + c₁)ω).
    let law = Law::harmonic(0.0, &[(0.0, 0.01)]);
    let drive = Drive {
        spring_rate: 900.0,
        damping: 3.0,
        ..thesis::real(30.0)
    };
    let (k1, c1) = (20000.0, 14.0);
    let train = Train {
        stiffness: k1,
        damping: c1,
    };
    let steady = steady(&law, &drive, &train).unwrap();
    let (m, w) = (1.0, 30.0);
    // Both springs share the static rest force.
    let static_n = drive.rest_force * k1 / (k1 + 900.0);
    let f = (-0.01 * (m * w * w - 900.0), 0.01 * 3.0 * w);
    let den = (900.0 + k1 - m * w * w, (3.0 + c1) * w);
    let square = den.0 * den.0 + den.1 * den.1;
    // N̂ = (k₁ + i c₁ω) F̂/den, F = Im(F̂ e^{iθ}).
    let num = (k1 * f.0 - c1 * w * f.1, k1 * f.1 + c1 * w * f.0);
    let n = (
        (num.0 * den.0 + num.1 * den.1) / square,
        (num.1 * den.0 - num.0 * den.1) / square,
    );
    for (t, got) in steady.theta.iter().zip(&steady.contact) {
        let exact = static_n + n.0 * t.sin() + n.1 * t.cos();
        assert!((got - exact).abs() < 1e-11, "{t} {got} {exact}");
    }
    // With an output profile of 1440 points, the extremes equal the extremes of the exact sinusoid.
    let cam = Cam {
        law,
        ..thesis::eccentric()
    };
    let emitted = recover(&cam.follower, &cam.profile(1440)).unwrap();
    let fine = super::steady(&emitted.law, &drive, &train).unwrap();
    let (low, high) = fine.contact_extremes();
    let swing = n.0.hypot(n.1);
    assert!(
        (high.value - static_n - swing).abs() < 1e-7,
        "{}",
        high.value - static_n - swing
    );
    assert!((low.value - static_n + swing).abs() < 1e-7);
}

#[test]
fn resonance_on_a_harmonic_is_named_and_damping_holds_it() {
    let cam = thesis::double_harmonic();
    let drive = thesis::real(thesis::SPEED);
    let hertz = 5.0 * thesis::SPEED / TAU;
    let undamped = Train::from_frequency(&drive, hertz, 0.0).unwrap();
    let message = steady(&cam.law, &drive, &undamped).unwrap_err().to_string();
    assert!(
        message.contains("resonance") && message.contains(" 5 times"),
        "{message}"
    );
    let damped = Train::from_frequency(&drive, hertz, 0.01).unwrap();
    assert!(
        steady(&cam.law, &drive, &damped)
            .unwrap()
            .contact
            .iter()
            .all(|n| n.is_finite())
    );
}

#[test]
fn stiff_and_slow_machines_end_in_the_rigid_force() {
    let cam = thesis::double_harmonic();
    for (drive, hertz) in [
        (thesis::real(thesis::SPEED), 1e4),
        (thesis::real(1e-3), 50.0),
        (thesis::real(1e-12), 50.0),
        (thesis::real(0.0), 50.0),
    ] {
        let train = Train::from_frequency(&drive, hertz, 0.02).unwrap();
        let steady = steady(&cam.law, &drive, &train).unwrap();
        for (t, n) in steady.theta.iter().zip(&steady.contact) {
            assert!((n - drive.force(cam.law.svaj(*t))).abs() < 1e-5, "{n}");
        }
    }
}

#[test]
fn a_stiff_smooth_machine_above_50_hertz_is_rigid_within_0_2_percent() {
    // Theory §10 gives RMS errors of 0.20 % of the body weight at 50 Hz, 0.60 % at 30 Hz and 0.05 % at 100 Hz for smooth walking targets.
    // The eccentric has one harmonic. With the ratio r of shaft speed to natural frequency, its error is r²·(amplitude)/√2.
    let cam = thesis::eccentric();
    let drive = thesis::real(thesis::SPEED);
    let train = Train::from_frequency(&drive, 50.0, 0.05).unwrap();
    let steady = steady(&cam.law, &drive, &train).unwrap();
    let n = steady.theta.len() as f64;
    let sum: f64 = steady
        .theta
        .iter()
        .zip(&steady.contact)
        .map(|(t, f)| (f - drive.force(cam.law.svaj(*t))).powi(2))
        .sum();
    assert!((sum / n).sqrt() / drive.rest_force < 0.002);
}

#[test]
fn a_fluid_column_in_series_shares_its_give() {
    // Massless fluid column in series with the spring of the specimen. The static force is F = s·k·k₁/(k + k₁).
    let law = thesis::double_harmonic().law;
    let drive = Drive::hydraulic(1e11, 0.02, thesis::SPEED);
    let k = drive.spring_rate;
    let train = Train {
        stiffness: 9.0 * k,
        damping: 0.0,
    };
    let got = steady(&law, &drive, &train).unwrap();
    for (t, f) in got.theta.iter().zip(&got.output) {
        assert!((f - 0.9 * k * law.svaj(*t).s).abs() < 1e-12 * k);
    }
    // With a damper, the column is a first-order lag. At one harmonic, output/input = (k₁ + i c₁ω)/(k + k₁ + i c₁ω).
    let wave = Law::harmonic(0.0, &[(0.0, 0.01)]);
    let c = 0.3 * k / thesis::SPEED;
    let train = Train {
        stiffness: 9.0 * k,
        damping: c,
    };
    let got = steady(&wave, &drive, &train).unwrap();
    let (a, b) = (9.0, 0.3);
    let (re, im) = (
        (a * 10.0 + b * b) / (100.0 + b * b),
        (b * 10.0 - a * b) / (100.0 + b * b),
    );
    for ((t, f), n) in got.theta.iter().zip(&got.output).zip(&got.contact) {
        let exact = 0.01 * k * (re * t.sin() + im * t.cos());
        assert!((f - exact).abs() < 1e-11 * k && (n - exact).abs() < 1e-11 * k);
    }
}

#[test]
fn a_follower_on_a_law_with_a_velocity_step_is_struck() {
    // The lift rises and falls with the constant slopes ±1. Without damping, only the velocity steps excite the follower.
    let poly = PiecewisePoly::new(vec![0.0, PI, TAU], 1, vec![0.0, PI, PI, 0.0]);
    let law = Law::from_poly(poly, true);
    let drive = Drive {
        rest_force: 0.0,
        ..thesis::real(1.0)
    };
    let train = Train {
        stiffness: 2.5 * 2.5,
        damping: 0.0,
    };
    let got = steady(&law, &drive, &train).unwrap();
    // Periodic solution of x″ + w²x = 2δ(π) − 2δ(0). By symmetry, x at the kinks is ∓tan(wπ/2)/w.
    let exact = (2.5 * PI / 2.0).tan() / 2.5;
    assert!(
        (got.deflection[0].abs() - exact.abs()).abs() < 1e-12,
        "{:?} {exact}",
        got.deflection
    );
}
