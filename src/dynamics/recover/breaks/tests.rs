use crate::cam::{Cam, Follower};
use crate::dynamics::recover::{Cycle, recover_cam};
use crate::law::{Extent, Rise, Segment, program};
use std::f64::consts::TAU;

/// A cam with rise, dwell, fall and dwell. The ends of these segments do not coincide with rows of the profile.
fn cam(motion: &Rise, follower: Follower) -> Option<Cam> {
    let part = |motion: &Rise, lift: f64, degrees: f64| Segment {
        motion: motion.clone(),
        lift,
        angle: degrees.to_radians(),
    };
    let segments = [
        part(motion, 0.02, 87.3),
        part(&Rise::Dwell, 0.0, 61.1),
        part(motion, -0.02, 101.7),
        part(&Rise::Dwell, 0.0, 109.9),
    ];
    let law = program(&segments, Extent::TURN).ok()?;
    Some(Cam { law, follower })
}

#[test]
fn every_law_of_the_catalogue_comes_back_without_overshoot_at_its_jumps() {
    let followers = [
        Follower::FlatTranslating { base_radius: 0.3 },
        Follower::RollerTranslating {
            prime_radius: 0.3,
            offset: 0.02,
            roller_radius: 0.01,
        },
        Follower::RollerTranslating {
            prime_radius: 0.3,
            offset: 0.02,
            roller_radius: 0.0,
        },
    ];
    let mut built = 0;
    for motion in Rise::catalogue() {
        for follower in followers {
            let Some(cam) = cam(&motion, follower) else {
                continue;
            };
            built += 1;
            let emitted = recover_cam(&cam, &cam.profile(720), Cycle::TURN).unwrap();
            let (low, high) = cam.law.extremes(2);
            let largest = high.value.max(-low.value);
            let apart = |i: usize| {
                let theta = TAU * i as f64 / 5003.0;
                (emitted.law.svaj(theta).a - cam.law.svaj(theta).a).abs()
            };
            let worst = (0..5003).map(apart).fold(0.0, f64::max) / largest;
            // For a knife edge, the slopes are computed only from differences of the heights.
            let allowed = if follower.roller_radius() > 0.0 || follower.is_flat() {
                5e-4
            } else {
                1e-2
            };
            assert!(
                worst < allowed,
                "{} {follower:?}: {worst:.1e}",
                motion.name()
            );
            let (got_low, got_high) = emitted.law.extremes(2);
            let over = (got_high.value - high.value).max(low.value - got_low.value) / largest;
            assert!(over < allowed, "{}: {over:.1e}", motion.name());
            assert!(emitted.mismatch < 1e-9, "{}", emitted.mismatch);
        }
    }
    assert!(built >= 45, "{built}");
}

#[test]
fn a_dwell_between_two_jumps_stays_a_dwell() {
    let face = Follower::FlatTranslating { base_radius: 0.3 };
    let cam = cam(&Rise::Parabolic, face).unwrap();
    let law = recover_cam(&cam, &cam.profile(720), Cycle::TURN)
        .unwrap()
        .law;
    for degrees in [88.0, 120.0, 148.0, 251.0, 300.0, 359.9] {
        let at = law.svaj(f64::to_radians(degrees));
        assert!(
            at.v.abs() < 1e-13 && at.a.abs() < 1e-11,
            "{degrees}° {at:?}"
        );
    }
}

#[test]
fn breakpoints_beside_a_row_on_a_row_and_at_the_first_row_change_nothing() {
    for shift in [0.0, 1e-12, 1e-7, 1e-4, 0.003, 0.1, 0.3, 0.49] {
        let step = TAU / 720.0;
        let part = |motion: Rise, lift: f64, angle: f64| Segment {
            motion,
            lift,
            angle,
        };
        let first = step * (100.0 + shift);
        let law = program(
            &[
                part(Rise::Parabolic, 0.02, first),
                part(Rise::Parabolic, -0.02, TAU - first),
            ],
            Extent::TURN,
        )
        .unwrap();
        // The law is shifted, so that the first angle of the cycle is also close to a jump.
        let law = law.ahead(step * shift);
        let face = Follower::FlatTranslating { base_radius: 0.3 };
        let cam = Cam {
            law,
            follower: face,
        };
        let emitted = recover_cam(&cam, &cam.profile(720), Cycle::TURN).unwrap();
        assert_eq!(emitted.law.extent(), (0.0, TAU));
        let (low, high) = cam.law.extremes(2);
        let (got_low, got_high) = emitted.law.extremes(2);
        assert!((got_low.value / low.value - 1.0).abs() < 1e-7, "{shift}");
        assert!((got_high.value / high.value - 1.0).abs() < 1e-7, "{shift}");
    }
}
