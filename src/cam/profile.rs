//! The profile: where cam and follower touch, seen in the cam's frame.

use super::Cam;
use super::geometry::{Contacts, Frame, Geometry};
use crate::law::{BATCH, Batch, Joint, Svaj, Turns};
#[cfg(feature = "vector")]
use pulp::{Arch, NullaryFnOnce};

/// Jumps below this part of the largest value of their derivative are rounding.
const NO_JUMP: f64 = 1e-9;

/// One row of the profile; lengths in m, angles in rad.
///
/// A translating cam and an unrolled barrel have their profile over the travel: x along it, y up.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // A roller of 10 mm at rest on its prime circle of 40 mm: a disc of 30 mm.
/// let rest = Law::harmonic(0.0, &[]);
/// let follower = Follower::RollerTranslating { prime_radius: 0.04, offset: 0.0, roller_radius: 0.01 };
/// let point = Cam::new(rest, follower)?.point(1.0);
/// assert!((point.x.hypot(point.y) - 0.03).abs() < 1e-15);
/// assert!((point.pitch_x.hypot(point.pitch_y) - 0.04).abs() < 1e-15);
/// assert!((point.rho - 0.03).abs() < 1e-15 && point.pressure_angle.abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
        self.point_of(theta, self.law.svaj(theta))
    }

    fn point_of(&self, theta: f64, at: Svaj) -> ProfilePoint {
        let geometry = Geometry::new(&self.follower);
        let contact = geometry.contact(at);
        let frame = geometry.frame(theta);
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

    /// The profile points on both sides of every angle at which a derivative of the law up to `order`
    /// (2: acceleration, 3: jerk) jumps, in order of their angles. An emitted profile carries them: it is
    /// smooth between them.
    pub fn breakpoints(&self, order: usize) -> Vec<[ProfilePoint; 2]> {
        let none = [0, 1, 2, 3].map(|k| NO_JUMP * self.law.bound(k));
        let jumps = |joint: &Joint| {
            let jump = joint.jump;
            let apart = [jump.s, jump.v, jump.a, jump.j];
            (0..=order.min(3)).any(|k| apart[k].abs() > none[k])
        };
        let joints = self.law.joints().into_iter().filter(jumps);
        joints
            .map(|joint| joint.sides.map(|at| self.point_of(joint.at, at)))
            .collect()
    }

    /// `n` profile points at equal steps of the cam angle, from the law's first angle on. The curve of a
    /// closed law closes on point 0, which is not repeated; an open law ends on its last point.
    pub fn profile(&self, n: usize) -> Vec<ProfilePoint> {
        let rows = Rows { cam: self, n };
        #[cfg(feature = "vector")]
        return Arch::new().dispatch(rows);
        #[cfg(not(feature = "vector"))]
        rows.points()
    }
}

/// Computation of a profile, by feature `vector` with the widest vector registers of the processor; the results do
/// not depend on their width.
struct Rows<'a> {
    cam: &'a Cam,
    n: usize,
}

#[cfg(feature = "vector")]
impl NullaryFnOnce for Rows<'_> {
    type Output = Vec<ProfilePoint>;

    #[inline(always)]
    fn call(self) -> Vec<ProfilePoint> {
        self.points()
    }
}

impl Rows<'_> {
    #[inline(always)]
    fn points(self) -> Vec<ProfilePoint> {
        let Rows { cam, n } = self;
        let (start, length) = cam.law.extent();
        let steps = if cam.law.is_closed() {
            n
        } else {
            n.saturating_sub(1).max(1)
        };
        let step = length / steps as f64;
        let geometry = Geometry::new(&cam.follower);
        let turns = Turns::of(step);
        let mut contacts = Contacts::default();
        let mut rows = [ProfilePoint::default(); BATCH];
        let mut out = Vec::with_capacity(n);
        let mut walk = cam.law.walk(start, step, n);
        while let Some(batch) = walk.next_batch() {
            geometry.contacts(batch, &mut contacts);
            match geometry.straight() {
                Some(scale) => contacts.move_along(scale, batch),
                None => contacts.turn_back(batch.theta[0], &turns),
            }
            for (k, row) in rows.iter_mut().enumerate() {
                *row = ProfilePoint {
                    theta: batch.theta[k],
                    x: contacts.x[k],
                    y: contacts.y[k],
                    pitch_x: contacts.pitch_x[k],
                    pitch_y: contacts.pitch_y[k],
                    rho: contacts.rho[k],
                    pressure_angle: contacts.pressure_angle[k],
                };
            }
            out.extend_from_slice(&rows[..batch.len]);
        }
        out
    }
}

impl Contacts {
    /// From the fixed frame to the cam's, which moves straight by scale·θ.
    #[inline(always)]
    fn move_along(&mut self, scale: f64, batch: &Batch) {
        for k in 0..BATCH {
            self.x[k] += scale * batch.theta[k];
            self.pitch_x[k] += scale * batch.theta[k];
        }
    }

    /// From the fixed frame to the cam's, which turns in the steps of `turns` from `theta` on.
    #[inline(always)]
    fn turn_back(&mut self, theta: f64, turns: &Turns) {
        let (sin, cos) = theta.sin_cos();
        for k in 0..BATCH {
            let frame = Frame::Turned {
                sin: sin * turns.cos[k] + cos * turns.sin[k],
                cos: cos * turns.cos[k] - sin * turns.sin[k],
            };
            [self.x[k], self.y[k]] = frame.seen([self.x[k], self.y[k]]);
            [self.pitch_x[k], self.pitch_y[k]] = frame.seen([self.pitch_x[k], self.pitch_y[k]]);
        }
    }
}
