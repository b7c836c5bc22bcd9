//! Profiles at a cusp, sizes near a right angle, breaks at a very small distance.

use std::f64::consts::PI;

use gaitcam::cam::{Cam, Follower, ProfilePoint, smallest_prime_circle};
use gaitcam::dynamics::liftoff_speed;
use gaitcam::poly::PiecewisePoly;
use gaitcam_test_support::thesis;
use gaitcam_test_support::turn;

fn rise_cam(prime: f64, roller: f64) -> Cam {
    let law = turn(&[
        ("cycloidal", 0.02, 40.0),
        ("dwell", 0.0, 140.0),
        ("cycloidal", -0.02, 40.0),
        ("dwell", 0.0, 140.0),
    ]);
    Cam {
        law,
        follower: Follower::RollerTranslating {
            prime_radius: prime,
            offset: 0.0,
            roller_radius: roller,
        },
    }
}

/// ρ → R_f from both sides: a nanometre changes the result, although |ρ − R_f| alone would not show it.
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
        // The absolute value is 1 nm in both cases, although only one of them is undercut.
        assert!((found.convex.value.abs() - 1e-9).abs() < 1e-13);
    }
}

/// All values are finite at the cusp itself.
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
    // Naive method: circle through three points of the profile 1° apart.
    let [a, b, c] = [-1.0, 0.0, 1.0].map(|k| cam.point(sharpest.at + k * PI / 180.0));
    let side = |p: &ProfilePoint, q: &ProfilePoint| (p.x - q.x).hypot(p.y - q.y);
    let area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).abs();
    let radius = side(&a, &b) * side(&b, &c) * side(&c, &a) / (2.0 * area);
    assert!(radius > 1e-8, "{radius:e}");
}

/// tan φ = v/(s + D) with D → 0: the angle tends to 90°, and the circle in closed form stays accurate.
#[test]
fn pressure_angles_near_a_right_angle_keep_their_digits() {
    let law = rise_cam(0.03, 0.0).law;
    for short in [1e-2, 1e-4, 1e-6, 1e-8] {
        let angle = 0.5 * PI - short;
        let size = smallest_prime_circle(&law, angle, angle, Some(0.0));
        // Naive method: maximum of |v|/tan φ − s over whole degrees. The true maximum is between them.
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

/// A piece with a width down to 1e-12 rad between two others: joints and extremes are correct.
#[test]
fn breaks_that_all_but_merge_do_no_harm() {
    let wide = |tiny: f64| {
        let breaks = [0.0, 1.0, 1.0 + tiny, 2.0];
        // One cubic polynomial, cut into three pieces.
        let whole = PiecewisePoly::new(vec![0.0, 2.0], 3, vec![0.0, 1.0, 2.0, -1.0]);
        (whole.cut_at(&breaks[1..3]), whole)
    };
    for tiny in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (cut, whole) = wide(tiny);
        let (a, b) = (cut.extremes(), whole.extremes());
        assert!((a.1.value - b.1.value).abs() < 1e-14 && (a.0.value - b.0.value).abs() < 1e-14);
        assert!((cut.derivative().eval(1.5) - whole.derivative().eval(1.5)).abs() < 1e-12);
        // Naive method for the short piece: differences of its coefficients divided by its width.
        let middle = (0..cut.pieces()).find(|i| cut.breaks()[*i] == 1.0).unwrap();
        let slope = cut.derivative().piece(middle)[0];
        let lost = (slope - whole.derivative().eval(1.0)).abs();
        assert!(lost <= 4e-15 / tiny + 1e-14, "{tiny:e}: {lost:e}");
    }
}

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
