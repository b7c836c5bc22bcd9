//! Geometry of every follower compared with an independent method: closed forms and differences along the profile.

use super::{oscillating, roller};
use gaitcam::cam::{Cam, Follower, ProfilePoint};
use gaitcam_test_support::{near, turn};
use std::f64::consts::TAU;

#[test]
fn oscillating_radii_follow_the_closed_forms() {
    // theory §6, inward convention: C = m − A cos ξ(1+ξ′), Dd = A sin ξ(1+ξ′); mirrored: ξ′ → −ξ′.
    for cam in oscillating() {
        for i in 0..300 {
            let theta = TAU * (f64::from(i) + 0.3) / 300.0;
            let at = cam.law.svaj(theta);
            let point = cam.point(theta);
            let xi = cam.follower.start_angle().unwrap() + at.s;
            match cam.follower {
                Follower::FlatOscillating {
                    pivot_distance,
                    face_offset,
                    ..
                } => {
                    let (m, v) = (pivot_distance.abs(), pivot_distance.signum() * at.v);
                    let rho = m
                        * (xi.sin() * (1.0 + 2.0 * v) / (1.0 + v).powi(2)
                            + xi.cos() * at.a / (1.0 + v).powi(3));
                    near(point.rho, face_offset + rho, 1e-13);
                }
                Follower::RollerOscillating {
                    pivot_distance,
                    arm,
                    ..
                }
                | Follower::MushroomOscillating {
                    pivot_distance,
                    arm,
                    ..
                } => {
                    let (m, v) = (pivot_distance.abs(), pivot_distance.signum() * at.v);
                    let c = m - arm * xi.cos() * (1.0 + v);
                    let d = arm * xi.sin() * (1.0 + v);
                    let square = c * c + d * d;
                    let rho = square.powf(1.5)
                        / (square * (1.0 + v) - m * c * v - m * arm * xi.sin() * at.a);
                    let found = point.rho + cam.follower.roller_radius();
                    near(found, rho, 1e-9 * rho.abs());
                    let tan = (arm * (1.0 + v) - m * xi.cos()) / (m * xi.sin());
                    near(
                        point.pressure_angle.tan(),
                        pivot_distance.signum() * tan,
                        1e-12,
                    );
                }
                _ => unreachable!(),
            }
        }
    }
}

fn every_rotating_cam() -> Vec<Cam> {
    let law = turn(&[
        ("4-5-6-7", 0.02, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -0.02, 110.0),
        ("dwell", 0.0, 70.0),
    ]);
    let mut out = oscillating();
    for follower in [
        Follower::FlatTranslating { base_radius: 0.05 },
        roller(0.05, 0.007, 0.01),
        roller(0.05, -0.007, 0.0),
        Follower::MushroomTranslating {
            prime_radius: 0.24,
            offset: 0.003,
            arc_radius: 0.2,
        },
    ] {
        out.push(Cam::new(law.clone(), follower).unwrap());
    }
    out
}

#[test]
fn radii_and_pressure_angles_agree_with_differences_along_the_profile() {
    // A second route: the profile as a bare curve. Clockwise, so ρ > 0 where it turns right.
    let h = 2e-4;
    for cam in every_rotating_cam() {
        assert!(!cam.curvature().undercut, "{:?}", cam.follower);
        for i in 0..200 {
            let theta = TAU * (f64::from(i) + 0.37) / 200.0;
            let p: Vec<_> = (-2..=2)
                .map(|k| cam.point(theta + h * f64::from(k)))
                .collect();
            let d = |f: fn(&ProfilePoint) -> f64| {
                let first = (f(&p[0]) - 8.0 * f(&p[1]) + 8.0 * f(&p[3]) - f(&p[4])) / (12.0 * h);
                let second = (-f(&p[0]) + 16.0 * f(&p[1]) - 30.0 * f(&p[2]) + 16.0 * f(&p[3])
                    - f(&p[4]))
                    / (12.0 * h * h);
                (first, second)
            };
            let ((x1, x2), (y1, y2)) = (d(|p| p.x), d(|p| p.y));
            let rho = (x1 * x1 + y1 * y1).powf(1.5) / (y1 * x2 - x1 * y2);
            let curvature = 1.0 / cam.point(theta).rho;
            near(1.0 / rho, curvature, 2e-4 * (1.0 + curvature.abs()));
            if cam.follower.is_flat() {
                continue;
            }
            // Motion of the circle's centre in space when only s grows, against the profile's normal.
            let motion = |ds: f64| {
                let raised = Cam {
                    law: cam.law.raised(ds),
                    follower: cam.follower,
                };
                let q = raised.point(theta);
                [q.pitch_x, q.pitch_y]
            };
            let (up, down) = (motion(1e-6), motion(-1e-6));
            let (mx, my) = (up[0] - down[0], up[1] - down[1]);
            // Outward normal: left of the clockwise tangent.
            let (nx, ny) = (-y1, x1);
            let phi = (mx * ny - my * nx).atan2(mx * nx + my * ny);
            near(phi, cam.point(theta).pressure_angle, 1e-6);
        }
    }
}

#[test]
fn extremes_bound_every_sample_and_are_reached() {
    for cam in every_rotating_cam() {
        let profile = cam.profile(20_000);
        let (low, high) = cam.pressure_angle_extremes();
        let angles = profile.iter().map(|p| p.pressure_angle);
        near(
            angles.clone().fold(f64::INFINITY, f64::min),
            low.value,
            1e-6,
        );
        near(angles.fold(f64::NEG_INFINITY, f64::max), high.value, 1e-6);
        let curvature = cam.curvature();
        let sharpest = profile
            .iter()
            .map(|p| p.rho)
            .filter(|r| *r > 0.0)
            .fold(f64::INFINITY, f64::min);
        near(curvature.convex.value, sharpest, 1e-6);
        near(
            cam.point(curvature.convex.at).rho,
            curvature.convex.value,
            1e-9,
        );
    }
}

#[test]
fn contact_wanders_as_far_as_the_face_is_wide() {
    for cam in every_rotating_cam()
        .into_iter()
        .filter(|c| c.follower.is_flat())
    {
        let (low, high) = cam.contact_travel().unwrap();
        let along = |theta: f64| {
            // Contact in space, measured from the foot of centre or pivot on the face.
            let p = cam.point(theta);
            let (sin, cos) = theta.sin_cos();
            let (x, y) = (cos * p.x - sin * p.y, sin * p.x + cos * p.y);
            match cam.follower {
                Follower::FlatOscillating {
                    pivot_distance,
                    face_offset,
                    ..
                } => ((x - pivot_distance).powi(2) + y * y - face_offset * face_offset).sqrt(),
                _ => x,
            }
        };
        let all: Vec<f64> = (0..7200)
            .map(|i| along(TAU * f64::from(i) / 7200.0))
            .collect();
        near(
            all.iter().copied().fold(f64::INFINITY, f64::min),
            low.value,
            1e-6,
        );
        near(all.iter().copied().fold(0.0, f64::max), high.value, 1e-6);
        near(cam.face_width().unwrap(), high.value - low.value, 1e-15);
    }
}

#[test]
fn normals_point_out_of_the_cam() {
    for cam in every_rotating_cam() {
        for i in 0..100 {
            let theta = TAU * (f64::from(i) + 0.21) / 100.0;
            let p = cam.point(theta);
            let [nx, ny] = cam.normal(&p);
            // From the contact the circle's centre lies along the normal.
            let radius = cam.follower.roller_radius();
            near(p.pitch_x - p.x, radius * nx, 1e-13);
            near(p.pitch_y - p.y, radius * ny, 1e-13);
            let (before, after) = (cam.point(theta - 1e-5), cam.point(theta + 1e-5));
            let (tx, ty) = (after.x - before.x, after.y - before.y);
            let length = tx.hypot(ty);
            near(-ty / length, nx, 1e-6);
            near(tx / length, ny, 1e-6);
        }
    }
}
