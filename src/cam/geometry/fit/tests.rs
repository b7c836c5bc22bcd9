//! Lengths that are invalid for every law: the error and the suggested values.

use crate::cam::{Cam, Follower};
use crate::error::Error;
use crate::error::{ArmFault, CamError, CamInputError};
use crate::law::Law;
use crate::units::Quantity;

/// One period of a wave between 0 and `lift`.
fn wave(lift: f64) -> Law {
    Law::harmonic(0.5 * lift, &[(-0.5 * lift, 0.0)])
}

fn roller(prime_radius: f64, offset: f64, roller_radius: f64) -> Follower {
    Follower::RollerTranslating {
        prime_radius,
        offset,
        roller_radius,
    }
}

fn refusal(law: Law, follower: Follower) -> Error {
    Cam::new(law, follower).unwrap_err()
}

fn is_near(quantity: Quantity, truth: f64) -> bool {
    (quantity.value - truth).abs() < 1e-9
}

#[test]
fn impossible_rollers_are_refused_with_what_would_be_right() {
    let length = Quantity::length;
    let offset = refusal(wave(0.02), roller(0.05, 0.05, 0.01));
    let as_large = CamError::Offset {
        offset: length(0.05),
        prime: length(0.05),
    };
    assert_eq!(offset.fault(), Some(&as_large));
    let thick = refusal(wave(0.02), roller(0.05, 0.0, 0.06));
    let fills = CamError::RollerFillsCam {
        radius: length(0.06),
        prime: length(0.05),
    };
    assert_eq!(thick.fault(), Some(&fills));
    let deep = refusal(wave(0.02).raised(-0.05), roller(0.04, 0.0, 0.01));
    assert!(
        matches!(deep.fault(), Some(CamError::BelowCentre { least, .. }) if is_near(*least, 0.05)),
        "{deep}"
    );
}

#[test]
fn impossible_arms_are_refused_with_what_would_be_right() {
    let arm = |arm: f64, prime_radius: f64, lift: f64| {
        let follower = Follower::RollerOscillating {
            pivot_distance: 0.1,
            arm,
            prime_radius,
            roller_radius: 0.01,
        };
        refusal(wave(lift), follower)
    };
    // The prime circle lies between 50 and 150 mm from the pivot.
    for (length, wrong) in [(0.04, ArmFault::Short), (0.2, ArmFault::Long)] {
        let error = arm(length, 0.05, 0.2);
        let Some(CamError::ArmReach {
            fault, least, most, ..
        }) = error.fault()
        else {
            panic!("{error}");
        };
        assert!(*fault == wrong && is_near(*least, 0.05) && is_near(*most, 0.15));
    }
    let inside = arm(0.14, 0.09, 0.6);
    assert!(
        matches!(inside.fault(), Some(CamError::PivotInside { pivot, reach, .. })
            if is_near(*pivot, 0.1) && reach.value > 0.1),
        "{inside}"
    );
    // A swing of 2.9 rad passes a dead centre.
    let swung = arm(0.08, 0.05, 2.9);
    assert!(
        matches!(swung.fault(), Some(CamError::Swing { .. })),
        "{swung}"
    );
}

#[test]
fn impossible_flat_faces_are_refused_with_what_would_be_right() {
    let flat = |base_radius: f64, lift: f64| {
        let follower = Follower::FlatOscillating {
            pivot_distance: 0.1,
            face_offset: 0.0,
            base_radius,
        };
        refusal(wave(lift), follower)
    };
    let near = flat(0.12, 0.1);
    assert!(
        matches!(near.fault(), Some(CamError::FaceReach { least, .. }) if is_near(*least, 0.12)),
        "{near}"
    );
    for base_radius in [-0.01, f64::NAN] {
        let error = refusal(wave(0.02), Follower::FlatTranslating { base_radius });
        assert!(
            matches!(error.fault(), Some(CamInputError::NotPositive { .. })),
            "{error}"
        );
    }
    // With three waves in a turn, the maximum speed of the arm is 3 · 0.4 = 1.2 times the cam speed.
    let three = Law::harmonic(0.4, &[(0.0, 0.0), (0.0, 0.0), (-0.4, 0.0)]);
    let follower = Follower::FlatOscillating {
        pivot_distance: 0.1,
        face_offset: 0.0,
        base_radius: 0.02,
    };
    let fast = refusal(three, follower);
    assert!(
        matches!(fast.fault(), Some(CamError::FaceSpeed { speed, .. }) if (speed.abs() - 1.2).abs() < 1e-9),
        "{fast}"
    );
}
