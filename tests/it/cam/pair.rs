//! Two cams on one shaft over a plate (Campillo de Blas 2017).

use gaitcam::cam::{Cam, Carrier, Follower, Pair};
use gaitcam::drive::Drive;
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use std::f64::consts::{PI, TAU};

fn segments(list: &[(&str, f64, f64)]) -> Vec<Segment> {
    list.iter()
        .map(|&(motion, lift, degrees)| Segment {
            motion: Rise::from_name(motion).unwrap(),
            lift,
            angle: degrees.to_radians(),
        })
        .collect()
}

fn turn(list: &[(&str, f64, f64)]) -> Law {
    program(&segments(list), Extent::TURN).unwrap()
}

#[test]
fn two_cams_over_a_plate_carry_in_turn() {
    // Campillo de Blas (2017): double harmonic 135/135/90, two cams half a turn apart.
    let law = turn(&[
        ("double-harmonic", 0.01, 135.0),
        ("double-harmonic", -0.01, 135.0),
        ("dwell", 0.0, 90.0),
    ]);
    let cam = Cam::new(law.clone(), Follower::FlatTranslating { base_radius: 0.03 }).unwrap();
    let pair = Pair::new(&cam).unwrap();
    for i in 0..3600 {
        let theta = TAU * f64::from(i) / 3600.0;
        let (one, two) = (law.svaj(theta).s, law.svaj(theta + PI).s);
        let height = 0.03 + one.max(two);
        assert!((pair.shaft_height(theta) - height).abs() < 1e-15, "{theta}");
        assert!((pair.gap(theta) - (one - two).abs()).abs() < 1e-15);
        let carrier = pair.carrier(theta);
        assert!(
            (one - two).abs() < 1e-12
                || carrier
                    == if one > two {
                        Carrier::First
                    } else {
                        Carrier::Second
                    }
        );
    }
    // By symmetry s(θ) = s(270° − θ): equal at 45° and 225°, where the second cam is half a turn off.
    let at: Vec<f64> = pair.handovers().iter().map(|h| h.at.to_degrees()).collect();
    assert_eq!(at.len(), 2);
    assert!(
        (at[0] - 45.0).abs() < 1e-9 && (at[1] - 225.0).abs() < 1e-9,
        "{at:?}"
    );
    let drive = Drive::moving_axis(1.0, 9.81, 11.624);
    for handover in pair.handovers() {
        // The lower branch falls as fast as the higher one rises.
        let v = law.svaj(45_f64.to_radians()).v;
        assert!((handover.velocity_jump - 2.0 * v).abs() < 1e-12);
        assert!((Pair::blow(&drive, handover) - 11.624 * 2.0 * v).abs() < 1e-11);
    }
    let force = pair.force(&drive, 135_f64.to_radians());
    assert!((force - 7.40791).abs() < 5e-6);
    let [one, two, both] = pair.separate_forces(&drive, 1.0);
    assert!((one + two - both).abs() < 1e-15);
    // Two quarter dwells face each other: both touch there.
    let shared = turn(&[
        ("3-4-5", 0.01, 60.0),
        ("3-4-5", -0.01, 60.0),
        ("dwell", 0.0, 240.0),
    ]);
    let pair =
        Pair::new(&Cam::new(shared, Follower::FlatTranslating { base_radius: 0.1 }).unwrap())
            .unwrap();
    assert_eq!(pair.carrier(150_f64.to_radians()), Carrier::Both);
    assert_eq!(pair.carrier(60_f64.to_radians()), Carrier::First);
    assert_eq!(pair.carrier(240_f64.to_radians()), Carrier::Second);
    assert!(
        pair.height()
            .joints()
            .iter()
            .all(|j| j.jump.v.abs() < 1e-12)
    );
}
