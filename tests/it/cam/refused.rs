//! Infeasible cams, verdicts and interference.

use gaitcam::cam::{
    Body, Cam, Closure, Conjugate, Continuity, Follower, SizeLimits, Verdict, smallest_for,
};
use gaitcam::law::{Extent, Law, assemble, constant_breadth};
use gaitcam_test_support::{segments, turn};

fn up_and_down(motion: &str, lift: f64) -> Law {
    turn(&[
        (motion, lift, 90.0),
        ("dwell", 0.0, 90.0),
        (motion, -lift, 90.0),
        ("dwell", 0.0, 90.0),
    ])
}

fn roller(prime_radius: f64, offset: f64, roller_radius: f64) -> Follower {
    Follower::RollerTranslating {
        prime_radius,
        offset,
        roller_radius,
    }
}

#[test]
fn a_conjugate_that_cannot_exist_says_from_where_on_it_can() {
    let cam = Cam::new(
        up_and_down("cycloidal", 0.3),
        Follower::RollerOscillating {
            pivot_distance: 0.1,
            arm: 0.08,
            prime_radius: 0.05,
            roller_radius: 0.01,
        },
    )
    .unwrap();
    let none = Conjugate::new(&cam, Closure::Angle(0.5), None)
        .unwrap_err()
        .to_string();
    let from = none
        .split("at least ")
        .nth(1)
        .unwrap()
        .split('°')
        .next()
        .unwrap();
    let least: f64 = from.parse().unwrap();
    let pair = Conjugate::new(&cam, Closure::Angle((least + 0.001).to_radians()), None).unwrap();
    assert!(!pair.second.curvature().undercut);
    let less = Conjugate::new(&cam, Closure::Angle((least - 0.5).to_radians()), None);
    assert!(less.is_err() || less.unwrap().second.curvature().undercut);
}

#[test]
fn the_smallest_base_radius_stops_at_the_cusp_for_every_follower() {
    let lift = 0.25;
    let law = up_and_down("cycloidal", lift);
    for pivot_distance in [0.1, -0.1] {
        for follower in [
            Follower::RollerOscillating {
                pivot_distance,
                arm: 0.09,
                prime_radius: 0.05,
                roller_radius: 0.01,
            },
            Follower::FlatOscillating {
                pivot_distance,
                face_offset: 0.0,
                base_radius: 0.04,
            },
        ] {
            let cam = Cam {
                law: law.clone(),
                follower,
            };
            let base = smallest_for(&cam, &SizeLimits::no_undercut()).unwrap();
            let at = |base: f64| Cam {
                law: law.clone(),
                follower: follower.with_base_radius(base),
            };
            assert!(at(base).curvature().convex.value >= 0.0);
            let smaller = at(0.999 * base);
            assert!(
                smaller.check().is_err() || smaller.curvature().undercut,
                "{follower:?} {base}"
            );
        }
    }
}

#[test]
fn continuity_and_the_class_of_cam_das() {
    let flat = |law: Law| Cam {
        law,
        follower: Follower::FlatTranslating { base_radius: 0.2 },
    };
    let continuous = |cam: &Cam| {
        let c = Continuity::of(cam);
        [c.s, c.v, c.a, c.j]
    };
    let smooth = flat(up_and_down("4-5-6-7", 0.02));
    assert_eq!(continuous(&smooth), [true; 4]);
    assert_eq!(smooth.cam_das_class(), Verdict::Acceptable);
    // CAM-DAS (Serrano Muñoz 2010, Ejemplo4): "discontinuity in jerk: not fit for high speeds".
    let jerky = flat(up_and_down("3-4-5", 0.02));
    assert_eq!(continuous(&jerky), [true, true, true, false]);
    assert_eq!(jerky.cam_das_class(), Verdict::NotForHighSpeed);
    let struck = flat(turn(&[
        ("simple-harmonic", 0.02, 90.0),
        ("dwell", 0.0, 60.0),
        ("simple-harmonic", -0.02, 90.0),
        ("dwell", 0.0, 120.0),
    ]));
    assert_eq!(continuous(&struck)[..3], [true, true, false]);
    assert_eq!(struck.first_jump(2), Some(0.0));
    assert_eq!(struck.cam_das_class(), Verdict::Unacceptable);
    // Constant breadth is CAM-DAS's one exception (Serrano Muñoz 2010, Ejemplo5).
    let breadth = constant_breadth(&segments(&[
        ("simple-harmonic", 0.02, 120.0),
        ("dwell", 0.0, 60.0),
    ]))
    .unwrap();
    assert_eq!(flat(breadth).cam_das_class(), Verdict::Acceptable);
    let torn = assemble(
        &segments(&[
            ("constant-velocity", 0.02, 90.0),
            ("dwell", 0.0, 90.0),
            ("constant-velocity", -0.02, 90.0),
            ("dwell", 0.0, 90.0),
        ]),
        Extent::TURN,
    )
    .unwrap();
    let torn = flat(torn);
    assert_eq!(continuous(&torn)[..2], [true, false]);
    assert_eq!(torn.cam_das_class(), Verdict::Unacceptable);
}

#[test]
fn interference_is_found_where_it_is_and_only_there() {
    // A good cam is free, with its stem as wide as the roller.
    let law = up_and_down("cycloidal", 0.02);
    let good = Cam::new(law.clone(), roller(0.05, 0.0, 0.01)).unwrap();
    assert!(good.interference(720, 0.02, 1e-6).is_empty());
    let flat = Cam::new(law.clone(), Follower::FlatTranslating { base_radius: 0.05 }).unwrap();
    assert!(flat.interference(720, 0.0, 1e-9).is_empty());
    // An undercut flat cam sticks out beyond the face.
    let bad = Cam::new(law, Follower::FlatTranslating { base_radius: 0.03 }).unwrap();
    let found = bad.interference(720, 0.0, 1e-9);
    assert!(
        found.len() == 1 && found[0].body == Body::Face && found[0].depth > 1e-5,
        "{found:?}"
    );
    // A roller larger than the valley between two hills touches the far flank, though no point is undercut
    // by itself: the pitch curve crosses itself.
    let hills = turn(&[
        ("4-5-6-7", 0.02, 20.0),
        ("4-5-6-7", -0.02, 20.0),
        ("dwell", 0.0, 20.0),
        ("4-5-6-7", 0.02, 20.0),
        ("4-5-6-7", -0.02, 20.0),
        ("dwell", 0.0, 260.0),
    ]);
    let cam = Cam {
        law: hills,
        follower: roller(0.05, 0.0, 0.012),
    };
    let found = cam.interference(1440, 0.0, 1e-6);
    assert!(found.iter().any(|i| i.body == Body::Roller), "{found:?}");
    // An arm in the plane of the cam, long over a low hub, is hit by the nose of the cam.
    let law = up_and_down("cycloidal", 0.35);
    for pivot_distance in [0.1, -0.1] {
        let arm = Cam::new(
            law.clone(),
            Follower::RollerOscillating {
                pivot_distance,
                arm: 0.1,
                prime_radius: 0.035,
                roller_radius: 0.008,
            },
        )
        .unwrap();
        assert!(arm.interference(720, 0.0, 1e-6).is_empty());
        let found = arm.interference(720, 0.015, 1e-6);
        assert!(found.len() == 1 && found[0].body == Body::Arm, "{found:?}");
        let face = Cam::new(
            up_and_down("cycloidal", 0.1),
            Follower::FlatOscillating {
                pivot_distance,
                face_offset: 0.01,
                base_radius: 0.05,
            },
        )
        .unwrap();
        assert!(!face.curvature().undercut);
        assert!(face.interference(720, 0.0, 1e-9).is_empty());
    }
}
