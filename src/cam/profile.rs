//! The profile: where cam and follower touch, seen in the cam's frame.

use super::{Cam, Follower, flat, roller};
use crate::law::Svaj;

/// One row of the profile; lengths in m, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// Cam angle at which this point touches the follower.
    pub theta: f64,
    /// Contact point on the finished cam, cam frame.
    pub x: f64,
    /// Contact point on the finished cam, cam frame.
    pub y: f64,
    /// Roller centre, cam frame (the contact point itself for a flat face).
    pub pitch_x: f64,
    /// Roller centre, cam frame (the contact point itself for a flat face).
    pub pitch_y: f64,
    /// Signed radius of curvature of the finished cam: positive convex, negative concave.
    pub rho: f64,
    /// Signed pressure angle.
    pub pressure_angle: f64,
}

impl Cam {
    /// The profile point that touches the follower at `theta`.
    pub fn point(&self, theta: f64) -> ProfilePoint {
        self.point_of(theta, theta.sin_cos(), self.law.svaj(theta))
    }

    /// `n` profile points at equal steps of the cam angle, from the law's first angle on. The curve of a
    /// closed law closes on point 0, which is not repeated; an open law ends on its last point.
    pub fn profile(&self, n: usize) -> Vec<ProfilePoint> {
        let (start, length) = self.law.extent();
        let steps = if self.law.is_closed() {
            n
        } else {
            n.saturating_sub(1).max(1)
        };
        (0..n)
            .map(|i| {
                let theta = start + length * i as f64 / steps as f64;
                self.point(theta)
            })
            .collect()
    }

    fn point_of(&self, theta: f64, (sin, cos): (f64, f64), at: Svaj) -> ProfilePoint {
        let turn = |p: [f64; 2]| [cos * p[0] + sin * p[1], cos * p[1] - sin * p[0]];
        match self.follower {
            Follower::FlatTranslating { base_radius } => {
                let [x, y] = turn(flat::contact(at, base_radius));
                let rho = flat::rho(at, base_radius);
                ProfilePoint {
                    theta,
                    x,
                    y,
                    pitch_x: x,
                    pitch_y: y,
                    rho,
                    pressure_angle: 0.0,
                }
            }
            Follower::RollerTranslating {
                prime_radius,
                offset,
                roller_radius,
            } => {
                let pitch = roller::pitch(&self.follower, at);
                let [pitch_x, pitch_y] = turn(pitch.centre);
                let [nx, ny] = turn(pitch.normal());
                ProfilePoint {
                    theta,
                    x: pitch_x - roller_radius * nx,
                    y: pitch_y - roller_radius * ny,
                    pitch_x,
                    pitch_y,
                    rho: 1.0 / pitch.curvature() - roller_radius,
                    pressure_angle: roller::pressure_angle(at, prime_radius, offset),
                }
            }
        }
    }
}
