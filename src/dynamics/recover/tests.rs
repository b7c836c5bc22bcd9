use std::f64::consts::TAU;

use super::*;
use crate::cam::Cam;
use crate::dynamics::thesis;

fn worst_acceleration_error(cam: &Cam, n: usize) -> f64 {
    let emitted = recover(&cam.follower, &cam.profile(n)).unwrap();
    (0..7200)
        .map(|i| TAU * (f64::from(i) + 0.37) / 7200.0)
        .map(|t| (emitted.law.svaj(t).a - cam.law.svaj(t).a).abs())
        .fold(0.0, f64::max)
}

#[test]
fn acceleration_of_the_emitted_points_converges_better_than_second_order() {
    let roller = Cam {
        law: thesis::double_harmonic().law,
        follower: Follower::RollerTranslating {
            prime_radius: 0.04,
            offset: 0.004,
            roller_radius: 0.01,
        },
    };
    for cam in [thesis::eccentric(), thesis::double_harmonic(), roller] {
        let coarse = worst_acceleration_error(&cam, 360);
        let fine = worst_acceleration_error(&cam, 1440);
        let order = (coarse / fine).log2() / 2.0;
        assert!(order > 2.5, "{order} {coarse} {fine}");
    }
}

#[test]
fn a_knife_edge_finds_its_slopes_from_heights_alone() {
    let cam = Cam {
        law: thesis::eccentric().law,
        follower: Follower::RollerTranslating {
            prime_radius: 0.03,
            offset: 0.0,
            roller_radius: 0.0,
        },
    };
    let error = worst_acceleration_error(&cam, 1440);
    assert!(error < 1e-8, "{error}");
}

#[test]
fn rows_that_are_not_equal_steps_are_refused_by_row() {
    let cam = thesis::eccentric();
    let mut points = cam.profile(360);
    points[17].theta += 0.01;
    let message = recover(&cam.follower, &points).unwrap_err().to_string();
    assert!(message.contains("row 17"), "{message}");
    let mut points = cam.profile(360);
    points[5].x = f64::NAN;
    assert!(recover(&cam.follower, &points).is_err());
    assert!(recover(&cam.follower, &cam.profile(4)).is_err());
}

#[test]
fn a_profile_undercut_for_a_flat_face_is_refused() {
    let law = Law::harmonic(0.01, &[(0.0, 0.0), (0.0, 0.0), (0.01, 0.0)]);
    let cam = Cam {
        law,
        follower: Follower::FlatTranslating { base_radius: 0.03 },
    };
    let message = recover(&cam.follower, &cam.profile(720))
        .unwrap_err()
        .to_string();
    assert!(message.contains("undercut"), "{message}");
}
