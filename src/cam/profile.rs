//! The profile: where cam and follower touch, seen in the cam's frame.

use super::Cam;
use super::geometry::{Contacts, Geometry};

/// One row of the profile; lengths in m, angles in rad.
///
/// A translating cam and an unrolled barrel have their profile over the travel: x along it, y up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// Cam angle at which this point touches the follower (m of travel for a translating cam).
    pub theta: f64,
    /// Contact point on the finished cam, cam frame.
    pub x: f64,
    /// Contact point on the finished cam, cam frame.
    pub y: f64,
    /// Centre of roller or arc, cam frame (the contact point itself for a flat face).
    pub pitch_x: f64,
    /// Centre of roller or arc, cam frame (the contact point itself for a flat face).
    pub pitch_y: f64,
    /// Signed radius of curvature of the finished cam: positive convex, negative concave.
    pub rho: f64,
    /// Signed pressure angle.
    pub pressure_angle: f64,
}

impl Cam {
    /// The profile point that touches the follower at `theta`.
    pub fn point(&self, theta: f64) -> ProfilePoint {
        let geometry = Geometry::new(&self.follower);
        let contact = geometry.contact(self.law.svaj(theta));
        let frame = match geometry.straight() {
            Some(scale) => Frame::Moved(scale * theta),
            None => {
                let (sin, cos) = theta.sin_cos();
                Frame::Turned { sin, cos }
            }
        };
        let [x, y] = frame.seen(contact.point);
        let [pitch_x, pitch_y] = frame.seen(contact.pitch);
        ProfilePoint {
            theta,
            x,
            y,
            pitch_x,
            pitch_y,
            rho: contact.rho,
            pressure_angle: contact.tan_pressure.atan(),
        }
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
        let step = length / steps as f64;
        let geometry = Geometry::new(&self.follower);
        let (sin_step, cos_step) = step.sin_cos();
        let mut contacts = Contacts::new();
        let mut out = Vec::with_capacity(n);
        self.law.walk(start, step, n, |batch| {
            geometry.contacts(batch, &mut contacts);
            // The frame turns by rotation within a batch: rounding stays below 1e-14.
            let (mut sin, mut cos) = batch.theta[0].sin_cos();
            for k in 0..batch.len {
                let theta = batch.theta[k];
                let frame = match geometry.straight() {
                    Some(scale) => Frame::Moved(scale * theta),
                    None => Frame::Turned { sin, cos },
                };
                let [x, y] = frame.seen([contacts.x[k], contacts.y[k]]);
                let [pitch_x, pitch_y] = frame.seen([contacts.pitch_x[k], contacts.pitch_y[k]]);
                out.push(ProfilePoint {
                    theta,
                    x,
                    y,
                    pitch_x,
                    pitch_y,
                    rho: contacts.rho[k],
                    pressure_angle: contacts.tan_pressure[k].atan(),
                });
                (sin, cos) = (
                    sin * cos_step + cos * sin_step,
                    cos * cos_step - sin * sin_step,
                );
            }
        });
        out
    }
}

/// The cam's frame at one instant.
#[derive(Clone, Copy)]
enum Frame {
    Turned { sin: f64, cos: f64 },
    Moved(f64),
}

impl Frame {
    /// A point fixed in space as the cam sees it.
    #[inline]
    fn seen(self, p: [f64; 2]) -> [f64; 2] {
        match self {
            Frame::Turned { sin, cos } => [cos * p[0] + sin * p[1], cos * p[1] - sin * p[0]],
            Frame::Moved(by) => [p[0] + by, p[1]],
        }
    }
}
