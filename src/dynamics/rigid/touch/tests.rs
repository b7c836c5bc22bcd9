use super::*;
use crate::law::Law;
use std::f64::consts::TAU;

/// One follower of every kind, where possible on both sides of the cam, with a suitable stroke.
pub fn everything() -> Vec<(Follower, f64)> {
    let mut all = vec![(Follower::FlatTranslating { base_radius: 0.05 }, 0.01)];
    for roller_radius in [0.0, 0.012] {
        all.push((
            Follower::RollerTranslating {
                prime_radius: 0.06,
                offset: -0.011,
                roller_radius,
            },
            0.01,
        ));
    }
    all.push((
        Follower::MushroomTranslating {
            prime_radius: 0.12,
            offset: 0.009,
            arc_radius: 0.08,
        },
        0.01,
    ));
    for side in [1.0, -1.0] {
        for roller_radius in [0.0, 0.01] {
            all.push((
                Follower::RollerOscillating {
                    pivot_distance: side * 0.09,
                    arm: 0.07,
                    prime_radius: 0.05,
                    roller_radius,
                },
                0.12,
            ));
        }
        all.push((
            Follower::MushroomOscillating {
                pivot_distance: side * 0.13,
                arm: 0.1,
                prime_radius: 0.09,
                arc_radius: 0.05,
            },
            0.08,
        ));
        all.push((
            Follower::FlatOscillating {
                pivot_distance: side * 0.11,
                face_offset: 0.006,
                base_radius: 0.045,
            },
            0.07,
        ));
    }
    all
}

fn cams() -> Vec<Cam> {
    everything()
        .into_iter()
        .map(|(follower, stroke)| Cam {
            law: Law::harmonic(0.5 * stroke, &[(-0.5 * stroke, 0.0), (0.0, 0.06 * stroke)]),
            follower,
        })
        .collect()
}

pub fn slides() -> Vec<Cam> {
    let follower = Follower::TranslatingCam {
        base_height: 0.02,
        roller_radius: 0.008,
    };
    let wave = |length: f64| {
        crate::law::program(
            &[
                segment("4-5-6-7", 0.02, 0.5 * length),
                segment("4-5-6-7", -0.02, 0.5 * length),
            ],
            crate::law::Extent::Length(length),
        )
        .unwrap()
    };
    let barrel = Follower::Barrel {
        radius: 0.03,
        roller_radius: 0.005,
    };
    let turns = crate::law::program(
        &[
            segment("4-5-6-7", 0.03, TAU),
            segment("4-5-6-7", -0.03, TAU),
        ],
        crate::law::Extent::Turns(2),
    )
    .unwrap();
    vec![
        Cam {
            law: wave(0.12),
            follower,
        },
        Cam {
            law: turns,
            follower: barrel,
        },
    ]
}

fn segment(name: &str, lift: f64, angle: f64) -> crate::law::Segment {
    crate::law::Segment {
        motion: crate::law::Rise::from_name(name).unwrap(),
        lift,
        angle,
    }
}

fn name(cam: &Cam, theta: f64) -> String {
    format!("{} at {theta}", cam.follower.name())
}

#[test]
fn the_normal_force_does_the_work_that_the_shaft_gives() {
    for cam in cams().into_iter().chain(slides()) {
        for i in 0..24 {
            let (start, length) = cam.law.extent();
            let theta = start + length * (f64::from(i) + 0.3) / 24.0;
            let at = cam.law.svaj(theta);
            let own = FollowerContact::of(&cam.follower);
            let contact = own.geometry.contact(at);
            let [of_follower, of_cam] = own.kind().velocities(contact.point);
            // The normal force N = Q/(n·G), applied at the contact point of the cam, gives the torque Q·v.
            let through = dot(contact.normal, of_cam) / dot(contact.normal, of_follower);
            assert!((through - at.v).abs() < 1e-14, "{}", name(&cam, theta));
            // The contact normal equals the profile normal, rotated to the fixed frame.
            let a = cam.normal(&cam.point(theta));
            let turn = if matches!(
                cam.follower,
                Follower::TranslatingCam { .. } | Follower::Barrel { .. }
            ) {
                0.0
            } else {
                theta
            };
            let (sin, cos) = turn.sin_cos();
            let fixed = [cos * a[0] - sin * a[1], sin * a[0] + cos * a[1]];
            let off = (fixed[0] - contact.normal[0]).hypot(fixed[1] - contact.normal[1]);
            assert!(off < 1e-12, "{}", name(&cam, theta));
        }
    }
}

#[test]
fn friction_takes_from_the_shaft_what_rubbing_burns() {
    let (speed, mu) = (7.0, 0.15);
    for cam in cams() {
        for i in 0..24 {
            let theta = TAU * (f64::from(i) + 0.3) / 24.0;
            let at = cam.law.svaj(theta);
            for force in [30.0, -4.0] {
                let got = touch(&cam.follower, speed, mu, at, force);
                let burnt = if rubs(&cam.follower) {
                    mu * got.normal.abs() * got.sliding.abs()
                } else {
                    0.0
                };
                let power = got.torque * speed;
                assert!(
                    (power - force * at.v * speed - burnt).abs() < 1e-12 * (1.0 + power.abs()),
                    "{}",
                    name(&cam, theta)
                );
            }
        }
    }
}

#[test]
fn curvature_and_walk_are_those_of_the_profile() {
    for cam in cams().into_iter().chain(slides()) {
        let (start, length) = cam.law.extent();
        for i in 0..17 {
            let theta = start + length * (f64::from(i) + 0.41) / 17.0;
            let p = cam.point(theta);
            let (own, at) = (FollowerContact::of(&cam.follower), cam.law.svaj(theta));
            let (walk, curvature) = own.walk(&own.geometry.contact(at), at);
            let radius = cam.follower.roller_radius();
            if radius > 0.0 || cam.follower.is_flat() {
                let own = if radius > 0.0 { 1.0 / radius } else { 0.0 };
                let both = 1.0 / p.rho + own;
                assert!(
                    (curvature - both).abs() < 1e-9 * both.abs(),
                    "{}: {} {both}",
                    name(&cam, theta),
                    curvature
                );
            }
            let h = 1e-6 * length;
            let (a, b) = (cam.point(theta - h), cam.point(theta + h));
            let walked = (b.x - a.x).hypot(b.y - a.y) / (2.0 * h);
            assert!(
                (walk.abs() - walked).abs() < 1e-7 * (1.0 + walked),
                "{}: {} {walked}",
                name(&cam, theta),
                walk
            );
        }
    }
}

#[test]
fn emitted_points_give_back_the_lift_under_every_follower() {
    use crate::dynamics::recover::{Cycle, recover_cam};
    for cam in cams().into_iter().chain(slides()) {
        let cycle = Cycle::of(&cam.law);
        let stroke = cam.law.stroke();
        let worst = |n: usize| {
            let emitted = recover_cam(&cam, &cam.profile(n), cycle).unwrap();
            let (start, length) = cam.law.extent();
            let mut worst = [0.0_f64; 3];
            for i in 0..1009 {
                let theta = start + length * f64::from(i) / 1009.0;
                let (a, b) = (emitted.law.svaj(theta), cam.law.svaj(theta));
                let scale = stroke * (TAU / length).powi(2);
                let off = [
                    (a.s - b.s) / stroke,
                    (a.v - b.v) * length / (TAU * stroke),
                    (a.a - b.a) / scale,
                ];
                for (w, x) in worst.iter_mut().zip(off) {
                    *w = w.max(x.abs());
                }
            }
            worst
        };
        let (coarse, fine) = (worst(360), worst(1440));
        let knife = !cam.follower.is_flat() && cam.follower.roller_radius() == 0.0;
        let slides = cycle != Cycle::TURN;
        // The fourth derivative of a programme jumps at its joints, where the convergence is only of second order.
        let limit = if slides { 2e-5 } else { 1e-6 };
        assert!(
            fine[0] < 1e-8 && fine[1] < 1e-7 && fine[2] < limit,
            "{}: {fine:?}",
            cam.follower.name()
        );
        if !slides && !knife {
            let order = (coarse[2] / fine[2]).log2() / 2.0;
            assert!(order > 1.9, "{}: order {order}", cam.follower.name());
        }
    }
}
