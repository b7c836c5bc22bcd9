//! Random combinations of motions and lengths: an error message, or a cam with correct extremes.

use gaitcam::cam::{Cam, Follower};
use gaitcam::law::{Extent, Rise, Segment, program};
use gaitcam::wording::Language;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn motion() -> impl Strategy<Value = Rise> {
    let smooth: Vec<Rise> = Rise::catalogue()
        .into_iter()
        .chain([Rise::Dwell, Rise::Eccentric { ratio: 2.5 }])
        .collect();
    prop::sample::select(smooth)
}

fn segments() -> impl Strategy<Value = Vec<Segment>> {
    prop::collection::vec((motion(), -1.0..1.0_f64, 0.2..1.0_f64), 2..6).prop_map(|list| {
        let total: f64 = list.iter().map(|s| s.2).sum();
        let net: f64 = list.iter().map(|s| s.1).sum();
        let mut rest = -net;
        list.into_iter()
            .map(|(motion, lift, share)| {
                let lift = if motion == Rise::Dwell {
                    0.0
                } else {
                    let own = 0.01 * (lift + rest);
                    rest = 0.0;
                    own
                };
                Segment {
                    motion,
                    lift,
                    angle: TAU * share / total,
                }
            })
            .collect()
    })
}

fn follower() -> impl Strategy<Value = Follower> {
    let length = 0.01..0.12_f64;
    let pivot = prop_oneof![0.05..0.2_f64, -0.2..-0.05_f64];
    let offset = -0.02..0.02_f64;
    let base = length.clone();
    prop_oneof![
        length
            .clone()
            .prop_map(|base_radius| Follower::FlatTranslating { base_radius }),
        (length.clone(), offset, 0.0..0.02_f64).prop_map(
            |(prime_radius, offset, roller_radius)| Follower::RollerTranslating {
                prime_radius,
                offset,
                roller_radius
            }
        ),
        (pivot.clone(), length.clone(), length.clone(), 0.0..0.02_f64).prop_map(
            |(pivot_distance, arm, prime_radius, roller_radius)| Follower::RollerOscillating {
                pivot_distance,
                arm,
                prime_radius,
                roller_radius
            }
        ),
        (pivot, -0.01..0.01_f64, base).prop_map(|(pivot_distance, face_offset, base_radius)| {
            Follower::FlatOscillating {
                pivot_distance,
                face_offset,
                base_radius,
            }
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn programmes_are_refused_in_words_or_joined(list in segments()) {
        match program(&list, Extent::TURN) {
            Err(e) => prop_assert!(!e.what(Language::En).is_empty() && e.help(Language::En).is_some(), "{e}"),
            Ok(law) => {
                let scale = law.extremes(1).1.value.abs().max(law.stroke());
                for joint in law.joints() {
                    prop_assert!(joint.jump.s.abs() <= 1e-9 * scale && joint.jump.v.abs() <= 1e-8 * scale);
                }
            }
        }
    }

    #[test]
    fn accepted_cams_keep_within_their_extremes(
        up in 0.5..1.5_f64, rest in 0.5..1.5_f64, down in 0.5..1.5_f64, lift in 0.001..0.05_f64, follower in follower(),
    ) {
        let segment = |motion: Rise, lift: f64, angle: f64| Segment { motion, lift, angle };
        let law = program(
            &[
                segment(Rise::ModifiedSine, lift, up),
                segment(Rise::Dwell, 0.0, rest),
                segment(Rise::Poly345, -lift, down),
                segment(Rise::Dwell, 0.0, TAU - up - rest - down),
            ],
            Extent::TURN,
        )
        .unwrap();
        match Cam::new(law, follower) {
            Err(e) => prop_assert!(e.help(Language::En).is_some(), "{e}"),
            Ok(cam) => {
                let (low, high) = cam.pressure_angle_extremes();
                let curvature = cam.curvature();
                for p in cam.profile(500) {
                    prop_assert!(p.x.is_finite() && p.y.is_finite());
                    prop_assert!(p.pressure_angle >= low.value - 1e-9 && p.pressure_angle <= high.value + 1e-9);
                    if p.rho > 0.0 || cam.follower.is_flat() {
                        prop_assert!(p.rho >= curvature.convex.value - 1e-9 * p.rho.abs() - 1e-12, "{} {}", p.rho, curvature.convex.value);
                    }
                }
            }
        }
    }
}
