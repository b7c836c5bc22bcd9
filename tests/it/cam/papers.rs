//! Cams compared with published numbers, closed forms and finite differences.

use super::{oscillating, roller};
use gaitcam::cam::{
    BarrelGroove, Cam, Closure, Conjugate, Follower, Rollers, SizeLimits, Wall,
    smallest_base_radius, smallest_for, smallest_prime_circle,
};
use gaitcam::law::{Condition, Extent, Law, Rise, Segment, hermite_birkhoff, program};
use gaitcam::poly::PiecewisePoly;
use gaitcam_test_support::{near, turn};
use std::f64::consts::{PI, TAU};

/// Law of the paper with its dwell, inches (theory §2).
fn heel_tester() -> Law {
    let k = 30.0 * (PI * 0.75 * 0.75_f64).powi(2);
    let end = 256.32_f64.to_radians();
    let mut conditions: Vec<Condition> = [
        (0.0, 0.0),
        (56.88, 110.282),
        (123.84, 79.338),
        (198.72, 106.667),
        (256.32, 0.0),
    ]
    .into_iter()
    .map(|(degrees, force): (f64, f64)| Condition {
        theta: degrees.to_radians(),
        order: 0,
        value: force / k,
    })
    .collect();
    for theta in [0.0, end] {
        for order in 1..3 {
            conditions.push(Condition {
                theta,
                order,
                value: 0.0,
            });
        }
    }
    let rise = hermite_birkhoff(&conditions, 0.0, end).unwrap();
    let mut coef = rise.piece(0).to_vec();
    coef.extend([0.0; 9]);
    Law::from_poly(PiecewisePoly::new(vec![0.0, end, TAU], 8, coef), true)
}

#[test]
fn heel_tester_pressure_angles_and_radius_are_those_recomputed() {
    // theory §2: Rp = 3 in, ε = 0, roller 1 in.
    let cam = Cam::new(heel_tester(), roller(3.0, 0.0, 1.0)).unwrap();
    let (low, high) = cam.pressure_angle_extremes();
    near(high.value.to_degrees(), 26.572, 5e-4);
    near(high.at.to_degrees(), 33.66, 5e-3);
    near(low.value.to_degrees(), -25.739, 5e-4);
    near(low.at.to_degrees(), 222.75, 5e-3);
    let curvature = cam.curvature();
    near(curvature.convex.value + 1.0, 2.3024, 5e-5);
    assert!(!curvature.undercut);
}

#[test]
fn thesis_eccentric_and_double_harmonic_cams() {
    // theory §3: eccentric r = 0.03, e = 0.01 m is a circle; sliding speed ω·d.
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    let disc = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 }).unwrap();
    for p in disc.profile(360) {
        near((p.x - 0.01).hypot(p.y), 0.03, 1e-15);
        near(p.rho, 0.03, 1e-15);
    }
    let omega = 11.624;
    near(omega * (0.02 + disc.law.extremes(0).1.value), 0.46496, 5e-6);
    // Double harmonic 135/135/90, Rb = 0.03, h = 0.01: the recomputed column.
    let law = turn(&[
        ("double-harmonic", 0.01, 135.0),
        ("double-harmonic", -0.01, 135.0),
        ("dwell", 0.0, 90.0),
    ]);
    let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.03 }).unwrap();
    let rho = cam.curvature().convex;
    near(rho.value, 0.022222, 5e-7);
    near(rho.at.to_degrees(), 135.0, 1e-4);
    near(cam.face_width().unwrap(), 0.0173205, 5e-8);
}

#[test]
fn half_a_turn_of_an_eccentric_disc_under_a_roller_is_the_catalogue_rise() {
    // The roller's centre stands e sin θ + √(L² − e² cos² θ) from the shaft, L = 0.038 m, e = 0.01 m.
    let half = Rise::Eccentric { ratio: 3.8 }.law().unwrap();
    for i in 0..=50 {
        let x = f64::from(i) / 50.0;
        let (sin, cos) = (-0.5 * PI + PI * x).sin_cos();
        let height = 0.01 * sin + (0.038_f64.powi(2) - (0.01 * cos).powi(2)).sqrt();
        near(half.svaj(x).s, (height - 0.028) / 0.02, 1e-13);
    }
}

#[test]
fn simple_harmonic_roller_cam_of_cam_das() {
    // theory §5, Ejemplo1RT: Rb 50, SHM ±50 in 180°, mm; roller 5 and 500.
    let law = turn(&[
        ("simple-harmonic", 50.0, 180.0),
        ("simple-harmonic", -50.0, 180.0),
    ]);
    for (radius, phi, low, high) in [
        (5.0, 18.2100, 70.9934, 95.8333),
        (500.0, 2.4919, 74.4563, 76.1905),
    ] {
        let cam = Cam::new(law.clone(), roller(50.0 + radius, 0.0, radius)).unwrap();
        let (least, most) = cam.pressure_angle_extremes();
        near(most.value.to_degrees(), phi, 5e-5);
        near(least.value.to_degrees(), -phi, 5e-5);
        near(cam.curvature().convex.value, low, 5e-5);
        let flattest = cam.profile(36000).iter().map(|p| p.rho).fold(0.0, f64::max);
        near(flattest, high, 5e-5);
    }
    // Ejemplo10EX: under a flat face a circle of Rb + L/2.
    let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 50.0 }).unwrap();
    for p in cam.profile(90) {
        near(p.rho, 75.0, 1e-12);
    }
}

#[test]
fn conjugate_of_ejemplo8_has_a_base_of_80() {
    // theory §5: 225 = 45 + 100 + 80, mm.
    let law = turn(&[
        ("double-harmonic", 0.1, 180.0),
        ("double-harmonic", -0.1, 180.0),
    ]);
    let first = Cam::new(law, Follower::FlatTranslating { base_radius: 0.045 }).unwrap();
    let pair = Conjugate::new(&first, Closure::Distance(0.225), None).unwrap();
    near(pair.second.follower.base_radius(), 0.08, 1e-15);
    near(pair.second.law.svaj(0.0).s, 0.1, 1e-15);
    let none = Conjugate::new(&first, Closure::Distance(0.14), None)
        .unwrap_err()
        .to_string();
    assert!(
        none.contains("140 mm") && none.contains("145 mm") && none.contains("to avoid undercut"),
        "{none}"
    );
    assert!(Conjugate::new(&first, Closure::Angle(1.0), None).is_err());
}

/// Barrel cam with a rise and a fall of 40 mm by Berzak's law D, one turn each: barrel of 30 mm with a groove to 21 mm.
fn barrel_thesis() -> BarrelGroove {
    let rise = Segment {
        motion: Rise::BerzakD,
        lift: 0.04,
        angle: TAU,
    };
    let law = program(
        &[
            rise.clone(),
            Segment {
                lift: -0.04,
                ..rise
            },
        ],
        Extent::Turns(2),
    )
    .unwrap();
    BarrelGroove::new(law, 0.021, 0.03, Rollers::One { radius: 0.005 }).unwrap()
}

#[test]
fn groove_of_the_barrel_thesis() {
    let groove = barrel_thesis();
    // theory §4: table at 21 mm (not the radius of the text), text at 30 mm.
    let phi = |degrees: f64, radius: f64| {
        groove
            .pressure_angle(degrees.to_radians(), radius)
            .to_degrees()
    };
    near(phi(90.0, 0.021), 18.166, 1e-3);
    near(phi(180.0, 0.021), 28.745, 1e-3);
    near(phi(90.0, 0.03), 12.936, 5e-4);
    near(phi(180.0, 0.03), 21.005, 5e-4);
    let rho = |degrees: f64, radius: f64| groove.rho_pitch(degrees.to_radians(), radius);
    near(1e3 * rho(90.0, 0.021), -96.540, 1e-3);
    near(1e3 * rho(270.0, 0.021), 96.540, 1e-3);
    near(1e3 * rho(90.0, 0.03), -182.553, 1e-3);
    near(
        1e3 * groove.rho_wall(90_f64.to_radians(), 0.021, Wall::Lower),
        -101.540,
        1e-3,
    );
    near(
        1e3 * groove.rho_wall(270_f64.to_radians(), 0.021, Wall::Lower),
        91.540,
        1e-3,
    );
    assert!(groove.smallest_bulge(0.021, Wall::Lower).value > 0.0);
    assert!(
        BarrelGroove::new(
            groove.law().clone(),
            0.03,
            0.02,
            Rollers::One { radius: 0.005 }
        )
        .is_err()
    );
}

#[test]
fn walls_of_the_barrel_thesis_are_the_unrolled_ones() {
    let groove = barrel_thesis();
    // Unrolled walls (theory §4): z = s ± R_f cos φ, δ = θ ∓ (R_f/R) sin φ.
    let theta = 1.0;
    let (at, angle) = (groove.law().svaj(theta), groove.pressure_angle(theta, 0.03));
    for (wall, sign) in [(Wall::Upper, 1.0), (Wall::Lower, -1.0)] {
        let delta = theta - sign * 0.005 / 0.03 * angle.sin();
        let z = at.s + sign * 0.005 * angle.cos();
        let p = groove.wall_point(theta, 0.03, wall);
        near(p[2], z, 1e-15);
        // Space and unrolled walls differ by R_f³ sin³φ/(3R²) along the groove.
        near(
            -p[1].atan2(p[0]),
            delta,
            0.005_f64.powi(3) / 0.03_f64.powi(3) * angle.sin().powi(3),
        );
    }
}

#[test]
fn smallest_prime_circles_have_their_closed_form() {
    // theory §6: 3-4-5 rise and fall, lift 1.
    let law = |beta: f64| {
        turn(&[
            ("3-4-5", 1.0, beta),
            ("dwell", 0.0, 180.0 - beta),
            ("3-4-5", -1.0, beta),
            ("dwell", 0.0, 180.0 - beta),
        ])
    };
    let deg = |x: f64| x.to_radians();
    for (beta, radius) in [(60.0, 2.63648), (90.0, 1.62006), (120.0, 1.12016)] {
        let circle = smallest_prime_circle(&law(beta), deg(30.0), deg(30.0), None);
        near(circle.radius, radius, 5.1e-6);
        near(circle.offset, 0.0, 1e-12);
        // The closed form against the general search, offset fixed.
        let cam = Cam::new(law(beta), roller(3.0, 0.0, 0.0)).unwrap();
        let limits = SizeLimits {
            rho_min: f64::NEG_INFINITY,
            pressure_rise: deg(30.0),
            pressure_fall: deg(30.0),
            pivot_beside: false,
        };
        near(smallest_for(&cam, &limits).unwrap(), circle.radius, 1e-6);
    }
    let circle = smallest_prime_circle(&law(60.0), deg(30.0), deg(45.0), None);
    near(circle.radius, 1.88131, 5.1e-6);
    near(circle.offset, 0.47052, 5.1e-6);
    let rise_only = smallest_prime_circle(&rise_only(60.0), deg(30.0), deg(30.0), None);
    near(rise_only.radius, 1.52217, 5.1e-6);
    near(rise_only.offset, 0.76109, 5.1e-6);
    // Flat face: −min(s + a)/h.
    for (beta, radius) in [(60.0, 4.33369), (90.0, 1.41139), (120.0, 0.39177)] {
        near(smallest_base_radius(&law(beta), 0.0), radius, 5.1e-6);
    }
}

#[test]
fn the_smallest_prime_circle_is_the_nearest_point_of_its_half_planes() {
    // Steep on one side and shallow on the other, and the same turned round: every candidate becomes the answer.
    let law = |up: f64, down: f64| turn(&[("3-4-5", 1.0, up), ("3-4-5", -1.0, down)]);
    let mut seen = [0; 3];
    for (up, down) in [(300.0, 60.0), (60.0, 300.0), (180.0, 180.0), (150.0, 210.0)] {
        let law = law(up, down);
        for (rise, fall) in [(30.0, 30.0), (55.0, 70.0), (75.0, 75.0), (80.0, 20.0)] {
            let (rise, fall) = (f64::to_radians(rise), f64::to_radians(fall));
            let circle = smallest_prime_circle(&law, rise, fall, None);
            // Convex in the offset: the radius of each by the law's own samples, the least by golden section.
            let samples: Vec<_> = (0..7200)
                .map(|i| law.svaj(TAU * f64::from(i) / 7200.0))
                .collect();
            let radius = |e: f64| {
                let limit = |v: f64| if v > 0.0 { rise } else { fall };
                let need = samples
                    .iter()
                    .map(|at| (at.v - e).abs() / limit(at.v).tan() - at.s);
                need.fold(0.0, f64::max).hypot(e)
            };
            let (mut low, mut high) = (-10.0, 10.0);
            for _ in 0..60 {
                let (a, b) = (low + 0.382 * (high - low), high - 0.382 * (high - low));
                if radius(a) < radius(b) {
                    high = b
                } else {
                    low = a
                }
            }
            near(circle.radius, radius(low), 1e-5);
            near(radius(circle.offset), circle.radius, 1e-5);
            seen[usize::from(circle.offset > 1e-3) + 2 * usize::from(circle.offset < -1e-3)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
}

#[test]
fn a_cam_that_never_comes_to_a_point_needs_no_base_radius() {
    // s + a is the mean lift of a first harmonic.
    let law = Law::harmonic(3.0, &[(0.0, 1.0)]);
    near(smallest_base_radius(&law, 4.0), 1.0, 1e-12);
    near(smallest_base_radius(&law, 2.0), 0.0, 0.0);
}

/// Law with a rise only. It is open, so that a fall has no influence.
fn rise_only(beta: f64) -> Law {
    let up = Segment {
        motion: Rise::Poly345,
        lift: 1.0,
        angle: beta.to_radians(),
    };
    program(&[up], Extent::Length(beta.to_radians())).unwrap()
}

/// Cycloidal law with a lift of 20 mm: rise, dwell, fall and dwell of a quarter turn each (theory §6).
fn reference_law() -> Law {
    turn(&[
        ("cycloidal", 20.0, 90.0),
        ("dwell", 0.0, 90.0),
        ("cycloidal", -20.0, 90.0),
        ("dwell", 0.0, 90.0),
    ])
}

#[test]
fn reference_cam_has_its_known_radii() {
    let cam = Cam::new(reference_law(), roller(50.0, 0.0, 10.0)).unwrap();
    let rho = cam.curvature().convex.value;
    near(rho, 29.42456, 5e-6);
    near(rho + 10.0, 39.42456, 5e-6);
    near(
        cam.pressure_angle_extremes().1.value.to_degrees(),
        23.2330,
        5e-5,
    );
    let flat = Cam::new(
        reference_law(),
        Follower::FlatTranslating { base_radius: 40.0 },
    )
    .unwrap();
    near(flat.curvature().convex.value, 7.14737, 5e-6);
    near(smallest_base_radius(&flat.law, 5.0), 37.85263, 5e-6);
}

#[test]
fn mistakes_of_other_programs_stay_out() {
    // theory §6, last paragraph. A profile drawn as plain Rb + s at the angle θ lies 0.95 mm off the true
    // one for the roller, 5.35 mm for the flat face (vector from the true contact's own polar angle).
    let cam = Cam::new(reference_law(), roller(50.0, 0.0, 10.0)).unwrap();
    let flat = Cam::new(
        reference_law(),
        Follower::FlatTranslating { base_radius: 40.0 },
    )
    .unwrap();
    for (cam, expected) in [(&cam, 0.95), (&flat, 5.35)] {
        let profile = cam.profile(7200);
        let distance = |x: f64, y: f64| {
            profile
                .iter()
                .map(|p| (p.x - x).hypot(p.y - y))
                .fold(f64::INFINITY, f64::min)
        };
        let off = (0..720)
            .map(|i| {
                let theta = TAU * f64::from(i) / 720.0;
                let radius = 40.0 + cam.law.svaj(theta).s;
                distance(radius * theta.sin(), radius * theta.cos())
            })
            .fold(0.0, f64::max);
        near(off, expected, 5e-3);
    }
    // Flat ρ: 7.15, not 31.61; at Rb 30 it is −2.85 and undercut.
    let small = Cam::new(
        reference_law(),
        Follower::FlatTranslating { base_radius: 30.0 },
    )
    .unwrap();
    near(small.curvature().convex.value, -2.85263, 5e-6);
    assert!(small.curvature().undercut);
    // Sign of ρ: 40° rise, Rp 30: convex pitch radius 9.675 < R_f 10 is undercut.
    let steep = turn(&[
        ("cycloidal", 20.0, 40.0),
        ("dwell", 0.0, 140.0),
        ("cycloidal", -20.0, 40.0),
        ("dwell", 0.0, 140.0),
    ]);
    let cam = Cam::new(steep, roller(30.0, 0.0, 10.0)).unwrap();
    near(cam.curvature().convex.value + 10.0, 9.675, 5e-4);
    assert!(cam.curvature().undercut);
}

#[test]
fn the_pitch_radius_of_oscillating_followers_is_constant_in_a_dwell() {
    for cam in oscillating() {
        let (first, last) = (1.1 * PI / 2.0, 1.9 * PI / 2.0);
        let radius = |theta: f64| {
            let p = cam.point(theta);
            p.pitch_x.hypot(p.pitch_y)
        };
        let rho = cam.point(first).rho;
        for i in 0..20 {
            let theta = first + (last - first) * f64::from(i) / 20.0;
            near(radius(theta), radius(first), 1e-13);
            near(cam.point(theta).rho, rho, 1e-12);
            near(
                cam.point(theta).rho,
                cam.point(theta).x.hypot(cam.point(theta).y),
                1e-12,
            );
        }
    }
}
