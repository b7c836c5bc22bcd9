//! Where methods fail: what the naive way does (shown failing) and what gaitcam does, digits counted.
//! reports/stability.md tells the same in words.

use gaitcam::cam::{Cam, Follower, ProfilePoint, smallest_prime_circle};
use gaitcam::drive::Drive;
use gaitcam::dynamics::rigid::liftoff_speed;
use gaitcam::dynamics::thesis;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Condition, Extent, Law, Rise, Segment, hermite_birkhoff, program};
use gaitcam::poly::{PiecewisePoly, SplineSpace, gauss_legendre};
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam_evidence::tiers::{Between, Bound, Settings, Task};
use nalgebra::DMatrix;
use std::f64::consts::{PI, TAU};

// ---------------------------------------------------------------- conditioning

fn spline_gram(degree: usize, spans: usize, order: usize) -> DMatrix<f64> {
    let space = SplineSpace::periodic_uniform(degree, spans, TAU);
    let mut weights = vec![0.0; order + 1];
    weights[order] = 1.0;
    let mut gram = DMatrix::zeros(spans, spans);
    for span in 0..spans {
        for (u, w) in gauss_legendre(degree + 1) {
            let row = space.row(span, u, &weights);
            for (i, a) in row.iter().enumerate() {
                for (j, b) in row.iter().enumerate() {
                    gram[(space.index(span, i), space.index(span, j))] += w * a * b;
                }
            }
        }
    }
    gram
}

#[test]
fn periodic_splines_stay_as_well_conditioned_however_many_spans() {
    for (degree, stated) in [(3, 18.5), (4, 45.7), (5, 112.8)] {
        for spans in [32, 128] {
            let values = spline_gram(degree, spans, 0).symmetric_eigenvalues();
            let found = values.max() / values.min();
            assert!(
                (found / stated - 1.0).abs() < 0.01,
                "{degree} {spans}: {found}"
            );
        }
    }
}

#[test]
fn fitting_through_accelerations_knows_all_but_the_constant() {
    for spans in [16, 32, 64] {
        let mut values: Vec<f64> = spline_gram(5, spans, 2)
            .symmetric_eigenvalues()
            .iter()
            .copied()
            .collect();
        values.sort_by(f64::total_cmp);
        let top = values[spans - 1];
        assert!(values[0].abs() < 1e-12 * top, "one null vector");
        // Condition of the collocation, the root of the Gram's: about 0.04 N².
        let condition = (top / values[1]).sqrt();
        let law = 0.04 * (spans * spans) as f64;
        assert!(
            condition / law > 0.5 && condition / law < 2.0,
            "{spans}: {condition} {law}"
        );
    }
}

// ---------------------------------------------------------------- polynomials

#[test]
fn interpolation_at_equal_steps_grows_as_runge_found_and_splines_do_not() {
    let runge = |u: f64| 1.0 / (1.0 + 25.0 * (2.0 * u - 1.0).powi(2));
    // Largest errors of the interpolant on [−1, 1]: 1.9156 at degree 10, 59.8 at degree 20.
    for (degree, stated) in [(10, 1.9156), (20, 59.82)] {
        let conditions: Vec<Condition> = (0..=degree)
            .map(|i| i as f64 / degree as f64)
            .map(|u| Condition {
                theta: u,
                order: 0,
                value: runge(u),
            })
            .collect();
        let poly = hermite_birkhoff(&conditions, 0.0, 1.0).unwrap();
        let worst = (0..=10_000)
            .map(|i| i as f64 / 1e4)
            .map(|u| (poly.eval(u) - runge(u)).abs());
        let worst = worst.fold(0.0, f64::max);
        assert!((worst / stated - 1.0).abs() < 0.01, "{degree}: {worst}");
    }
    let curve = ForceCurve::from_samples(
        "runge",
        1.0,
        (0..1024).map(|i| runge(f64::from(i) / 1024.0)).collect(),
    );
    let target = curve.unwrap();
    let drive = hydraulic();
    let mut last = f64::INFINITY;
    for spans in [10, 20, 40, 80] {
        let law = free(&target, drive, spans);
        let worst = worst_force(&law, &drive, &target);
        assert!(worst < last, "{spans}: {worst}");
        last = worst;
    }
    assert!(last < 1e-3, "{last}");
}

fn hydraulic() -> Drive {
    Drive {
        spring_rate: 1.0,
        ..Drive::moving_axis(0.0, 0.0, TAU)
    }
}

fn free(target: &ForceCurve, drive: Drive, spans: usize) -> Law {
    let task = Task {
        target,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    };
    task.free().unwrap().law
}

fn worst_force(law: &Law, drive: &Drive, target: &ForceCurve) -> f64 {
    (0..4000)
        .map(|i| TAU * (f64::from(i) + 0.5) / 4000.0)
        .map(|x| (drive.force(law.svaj(x)) - target.at(x)).abs())
        .fold(0.0, f64::max)
}

/// Noise of 1 % BW: the second difference of the force is all noise, the fit's acceleration is not.
#[test]
fn differences_of_a_noisy_force_drown_and_the_fit_does_not() {
    let clean = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let n = 600;
    let step = TAU / f64::from(n);
    let mut seed = 12345_u64;
    let mut noise = || {
        // Sum of four uniforms: variance 1/3.
        let mut uniform = || {
            seed = seed
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        (0..4).map(|_| uniform()).sum::<f64>() * 3f64.sqrt()
    };
    let samples: Vec<f64> = (0..n)
        .map(|i| clean.at(step * f64::from(i)) + 7.0 * noise())
        .collect();
    let noisy = ForceCurve::from_samples("noisy", clean.period_s, samples.clone()).unwrap();
    let drive = hydraulic();
    let law = free(&noisy, drive, 16);
    let exact = free(&clean, drive, 64);
    let rms = |f: &dyn Fn(usize) -> f64| {
        ((0..n as usize).map(|i| f(i).powi(2)).sum::<f64>() / f64::from(n)).sqrt()
    };
    let at = |i: usize| step * i as f64;
    let around = |i: usize, d: i32| samples[(i as i32 + d).rem_euclid(n) as usize];
    let signal = rms(&|i| exact.svaj(at(i)).v);
    let differences = rms(&|i| (around(i, 1) - around(i, -1)) / (2.0 * step) - exact.svaj(at(i)).v);
    let fitted = rms(&|i| law.svaj(at(i)).v - exact.svaj(at(i)).v);
    assert!(
        differences > 0.8 * signal,
        "differences {differences} of {signal}"
    );
    assert!(fitted < 0.05 * signal, "fit {fitted} of {signal}");
    let second = rms(&|i| {
        (around(i, 1) - 2.0 * around(i, 0) + around(i, -1)) / (step * step) - exact.svaj(at(i)).a
    });
    assert!(second > 20.0 * rms(&|i| exact.svaj(at(i)).a));
    assert!(
        rms(&|i| law.svaj(at(i)).a - exact.svaj(at(i)).a) < 0.25 * rms(&|i| exact.svaj(at(i)).a)
    );
}

// ---------------------------------------------------------------- programs

fn design(changes: &[&str]) -> Result<Design, String> {
    gaitcam_test_support::design(scene::DEFAULT, changes).map_err(|e| e.to_string())
}

fn finite(design: &Design) {
    let law = &design.cam.law;
    for i in 0..720 {
        let at = law.svaj(TAU * f64::from(i) / 720.0);
        assert!([at.s, at.v, at.a, at.j].iter().all(|x| x.is_finite()));
    }
    let f = &design.force;
    assert!(
        [f.rms_error_n, f.max_error_n, f.mean_n, f.min_n, f.max_n]
            .iter()
            .all(|x| x.is_finite())
    );
    assert!(
        design
            .checks
            .iter()
            .all(|c| c.worst.is_finite() && c.limit.is_finite()),
        "{:?}",
        design.checks
    );
}

/// The same demand twice is rank-deficient, and harmless; two that differ are a contradiction by name.
#[test]
fn equal_demands_are_taken_once_and_contradictions_are_named() {
    let twice = |second: &str| {
        let point = |lift: &str| format!("{{ angle = \"90 deg\", lift = \"{lift}\" }}");
        design(&[&format!("law.point=[{}, {}]", point("5 mm"), point(second))])
    };
    let good = twice("5 mm").unwrap();
    finite(&good);
    assert!((good.cam.law.svaj(0.5 * PI).s - 0.005).abs() < 1e-9);
    match twice("6 mm") {
        Err(words) => assert!(words.contains("point"), "{words}"),
        Ok(answer) => assert!(
            answer
                .infeasible
                .is_some_and(|i| i.conflict[0].name().contains("point"))
        ),
    }
}

/// Up 20 mm and down again in one turn takes 16 h/T² of acceleration (theory §1, Favard): limits just above,
/// at and below the least possible are built or refused, never wrong.
#[test]
fn a_program_on_the_edge_of_feasibility_is_answered_either_way() {
    let period: f64 = 1.0 / 1.85;
    let least = 16.0 * 0.02 / (period * period);
    let with = |most: f64| {
        design(&[
            "law.point=[{ angle = \"0 deg\", lift = \"0 mm\" }, { angle = \"180 deg\", lift = \"20 mm\" }]",
            &format!("limits.acceleration={most} m/s^2"),
            "law.spans=16",
        ])
        .unwrap()
    };
    let builds = |most: f64| with(most).infeasible.is_none();
    let (mut low, mut high) = (0.9 * least, 2.0 * least);
    assert!(!builds(low) && builds(high));
    for _ in 0..10 {
        let mid = 0.5 * (low + high);
        if builds(mid) {
            high = mid;
        } else {
            low = mid;
        }
    }
    assert!(
        high >= least * (1.0 - 1e-9) && high < 1.2 * least,
        "{high} {least}"
    );
    for most in [low, high, high * (1.0 + 1e-6)] {
        let answer = with(most);
        finite(&answer);
        if answer.infeasible.is_none() {
            let (down, up) = answer.cam.law.extremes(2);
            let worst = up.value.max(-down.value) * answer.drive.speed.powi(2);
            assert!(worst <= most * (1.0 + 1e-6), "{worst} {most}");
        }
    }
}

/// One jerk sample a span leaves the limit broken; rows, cones and the exchange keep it (theory §9).
#[test]
fn samples_break_the_limit_that_rows_cones_and_exchange_keep() {
    let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
    let free = Task {
        target: &target,
        drive,
        degree: 5,
        spans: 32,
        bounds: &[],
    };
    let jerk = |law: &Law| {
        let (low, high) = law.extremes(3);
        high.value.max(-low.value)
    };
    let most = 0.6 * jerk(&free.free().unwrap().law);
    let bounds = [Bound { order: 3, most }];
    let task = Task {
        bounds: &bounds,
        ..free
    };
    let conic = |b| {
        jerk(
            &task
                .conic(b)
                .unwrap()
                .solve(Settings::default())
                .unwrap()
                .law,
        ) / most
    };
    assert!(conic(Between::Samples(1)) > 1.1);
    assert!(conic(Between::Coefficients) < 1.0 + 1e-7);
    assert!(conic(Between::Cone) < 1.0 + 1e-7);
    assert!(jerk(&task.exchange().unwrap().law) / most <= 1.0 + 1e-9);
}

// ---------------------------------------------------------------- profiles

fn rise_cam(prime: f64, roller: f64) -> Cam {
    let segment = |motion: &str, lift: f64, degrees: f64| Segment {
        motion: Rise::from_name(motion).unwrap(),
        lift,
        angle: f64::to_radians(degrees),
    };
    let segments = [
        segment("cycloidal", 0.02, 40.0),
        segment("dwell", 0.0, 140.0),
        segment("cycloidal", -0.02, 40.0),
        segment("dwell", 0.0, 140.0),
    ];
    let law = program(&segments, Extent::TURN).unwrap();
    Cam {
        law,
        follower: Follower::RollerTranslating {
            prime_radius: prime,
            offset: 0.0,
            roller_radius: roller,
        },
    }
}

/// ρ → R_f from both sides: a nanometre decides, and |ρ − R_f| alone would hide it.
#[test]
fn a_nanometre_of_roller_decides_about_undercut() {
    let pitch = rise_cam(0.03, 0.0).curvature().convex.value;
    assert!(
        pitch > 0.009 && pitch < 0.01,
        "theory §6: 9.675 mm, here {pitch}"
    );
    for (roller, undercut) in [(pitch - 1e-9, false), (pitch + 1e-9, true)] {
        let cam = rise_cam(0.03, roller);
        let found = cam.curvature();
        assert_eq!(found.undercut, undercut, "{roller}");
        assert!((found.convex.value - (pitch - roller)).abs() < 1e-13);
        // The absolute value says "1 nm radius, convex" on both sides.
        assert!((found.convex.value.abs() - 1e-9).abs() < 1e-13);
    }
}

/// At the cusp itself everything stays finite.
#[test]
fn a_cusp_has_finite_points_and_a_plain_verdict() {
    let pitch = rise_cam(0.03, 0.0).curvature().convex.value;
    let cam = rise_cam(0.03, pitch);
    for p in cam.profile(7200) {
        assert!(
            [p.x, p.y, p.rho, p.pressure_angle]
                .iter()
                .all(|v| v.is_finite())
                || p.rho.is_infinite()
        );
    }
    let sharpest = cam.curvature().convex;
    assert!(sharpest.value.abs() < 1e-15);
    // The naive way: the circle through three points of the profile 1° apart.
    let [a, b, c] = [-1.0, 0.0, 1.0].map(|k| cam.point(sharpest.at + k * PI / 180.0));
    let side = |p: &ProfilePoint, q: &ProfilePoint| (p.x - q.x).hypot(p.y - q.y);
    let area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).abs();
    let radius = side(&a, &b) * side(&b, &c) * side(&c, &a) / (2.0 * area);
    assert!(radius > 1e-8, "{radius:e}");
}

/// tan φ = v/(s + D) with D → 0: the angle tends to 90° and the closed-form circle keeps its digits.
#[test]
fn pressure_angles_near_a_right_angle_keep_their_digits() {
    let law = rise_cam(0.03, 0.0).law;
    for short in [1e-2, 1e-4, 1e-6, 1e-8] {
        let angle = 0.5 * PI - short;
        let size = smallest_prime_circle(&law, angle, angle, Some(0.0));
        // The naive way: the largest |v|/tan φ − s over whole degrees. Its worst angle lies between them.
        let sampled = (0..360)
            .map(|i| law.svaj(f64::from(i) * PI / 180.0))
            .map(|at| at.v.abs() / angle.tan() - at.s)
            .fold(0.0, f64::max);
        assert!(
            short > 1e-3 || sampled < 0.5 * size.radius,
            "{short:e}: {sampled:e} {:e}",
            size.radius
        );
        assert!(size.radius.is_finite() && size.radius >= 0.0);
        let follower = Follower::RollerTranslating {
            prime_radius: size.radius.max(1e-15),
            offset: 0.0,
            roller_radius: 0.0,
        };
        let cam = Cam {
            law: law.clone(),
            follower,
        };
        let (low, high) = cam.pressure_angle_extremes();
        let worst = high.value.max(-low.value);
        assert!(worst <= angle + 1e-12, "{short:e}: {worst}");
        assert!(
            short < 1e-5 || worst > angle - 1e-9,
            "{short:e}: {}",
            worst - angle
        );
    }
}

/// Two segments of which one is a thousand-millionth of a radian wide: joints and extremes stay right.
#[test]
fn breaks_that_all_but_merge_do_no_harm() {
    let wide = |tiny: f64| {
        let breaks = [0.0, 1.0, 1.0 + tiny, 2.0];
        // sin-like cubic through all pieces: one polynomial cut in three.
        let whole = PiecewisePoly::new(vec![0.0, 2.0], 3, vec![0.0, 1.0, 2.0, -1.0]);
        (whole.cut_at(&breaks[1..3]), whole)
    };
    for tiny in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (cut, whole) = wide(tiny);
        let (a, b) = (cut.extremes(), whole.extremes());
        assert!((a.1.value - b.1.value).abs() < 1e-14 && (a.0.value - b.0.value).abs() < 1e-14);
        assert!((cut.derivative().eval(1.5) - whole.derivative().eval(1.5)).abs() < 1e-12);
        // The naive way through the short piece: differences of its coefficients over its width.
        let middle = (0..cut.pieces()).find(|i| cut.breaks()[*i] == 1.0).unwrap();
        let slope = cut.derivative().piece(middle)[0];
        let lost = (slope - whole.derivative().eval(1.0)).abs();
        assert!(lost <= 4e-15 / tiny + 1e-14, "{tiny:e}: {lost:e}");
    }
}

/// A dwell of 1e-9 rad between two demands.
#[test]
fn a_dwell_of_a_thousand_millionth_of_a_radian_is_solved_or_refused() {
    let dwell = "law.dwell=[{ from = \"90 deg\", to = \"90.0000000573 deg\" }]";
    if let Ok(answer) = design(&[dwell]) {
        finite(&answer);
    }
}

// ---------------------------------------------------------------- dynamics

#[test]
fn lift_off_speeds_have_their_closed_form() {
    for (cam, stated) in [
        (thesis::eccentric(), 31.320920),
        (thesis::double_harmonic(), 23.490690),
    ] {
        let found = liftoff_speed(&cam.law, &thesis::real(10.0)).unwrap();
        assert!((found - stated).abs() < 1e-5, "{found}");
    }
}

// ---------------------------------------------------------------- sizes of numbers

/// Forces from a flea's to a rocket's: the relative answer does not move, or the refusal is in words.
#[test]
fn units_may_be_tiny_or_huge() {
    let usual = design(&[]).unwrap();
    for weight in ["1e-6 N", "1e-3 N", "1e4 N", "1e9 N"] {
        match design(&[&format!("gait.body_weight={weight}")]) {
            Ok(answer) => {
                finite(&answer);
                let (a, b) = (
                    answer.force.rms_error_percent_of_mean,
                    usual.force.rms_error_percent_of_mean,
                );
                assert!((a - b).abs() < 1e-6 * b, "{weight}: {a} {b}");
                let (a, b) = (answer.cam.law.stroke(), usual.cam.law.stroke());
                assert!((a / b - 1.0).abs() < 1e-9, "{weight}: stroke {a} {b}");
            }
            Err(words) => assert!(words.contains("weight"), "{weight}: {words}"),
        }
    }
}

/// Numbers below the normal range, and near its top: an answer or words, never NaN.
#[test]
fn denormals_and_giants_are_answered_or_refused_in_words() {
    for change in [
        "gait.body_weight=1e-310 N",
        "gait.body_weight=1e300 N",
        "drive.mass=1e-310 kg",
        "drive.mass=1e300 kg",
        "drive.speed=1e-310 rad/s",
        "drive.speed=1e200 rad/s",
        "limits.stroke=1e-310 m",
        "limits.jerk=1e-310 m/s^3",
        "limits.acceleration=1e300 m/s^2",
        "limits.curvature=1e-310 m",
        "cam.base_radius=1e-310 m",
        "accuracy.rms=1e-310 %",
    ] {
        let answer = std::panic::catch_unwind(|| design(&[change]));
        match answer {
            Ok(Ok(answer)) => finite(&answer),
            Ok(Err(words)) => assert!(words.len() > 10, "{change}: {words}"),
            Err(_) => panic!("{change}: panicked"),
        }
    }
}

/// A force that is flat but for a spike of a nanonewton, and one that jumps by a thousand means.
#[test]
fn ill_scaled_targets_are_followed_or_refused() {
    let n = 512;
    let spike = |size: f64| {
        let force = (0..n)
            .map(|i| 700.0 + if i == 100 { size } else { 0.0 })
            .collect();
        ForceCurve::from_samples("spike", 1.0, force).unwrap()
    };
    let scene = scene::read(&scene::DEFAULT.parse().unwrap()).unwrap();
    for size in [1e-9, 1e-3, 7e5] {
        match synthesise(&scene, Some(&spike(size))) {
            Ok(answer) => {
                finite(&answer);
                assert!((answer.force.mean_n / answer.force.target_mean_n - 1.0).abs() < 1e-9);
            }
            Err(e) => assert!(e.to_string().len() > 10),
        }
    }
}

/// The wrap-around joint is a joint like the others: lift and derivatives meet across 2π.
#[test]
fn laws_join_across_the_turn() {
    let answer = design(&["limits.jerk=150 m/s^3"]).unwrap();
    let law = &answer.cam.law;
    let last = law.breaks().len() - 2;
    let (a, b) = (law.svaj_on(last, 1.0), law.svaj_on(0, 0.0));
    let (low, high) = law.extremes(3);
    let scale = high.value.max(-low.value);
    for (x, y) in [(a.s, b.s), (a.v, b.v), (a.a, b.a), (a.j, b.j)] {
        assert!((x - y).abs() < 1e-11 * scale, "{x} {y}");
    }
    for k in [-3.0, -1.0, 1.0, 1e3] {
        let moved = law.svaj(1.0 + k * TAU);
        assert!((moved.s - law.svaj(1.0).s).abs() < 1e-12 * k.abs().max(1.0));
    }
    // A force with a step at the wrap: followed, without ringing beyond the step's own size.
    let step: Vec<f64> = (0..512)
        .map(|i| 600.0 + 200.0 * f64::from(i) / 512.0)
        .collect();
    let target = ForceCurve::from_samples("saw", 1.0, step).unwrap();
    let scene = scene::read(&scene::DEFAULT.parse().unwrap()).unwrap();
    let answer = synthesise(&scene, Some(&target)).unwrap();
    finite(&answer);
    assert!(answer.force.max_error_n < 200.0);
}
