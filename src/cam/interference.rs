//! Interference: roller, face or arm against another part of the cam than the one it touches.
//!
//! Undercut is local; this looks at the whole profile, which CAM-DAS leaves to visual inspection. It samples: the
//! profile is taken at n points, so depths below its sagitta (about step²/8ρ) are not seen.

use super::{Cam, Follower, Geometry};

/// The body that interferes with the cam.
///
/// ```
/// use gaitcam::cam::{Body, Cam, Follower};
/// use gaitcam::law::Law;
///
/// // A roller of 12 mm on a prime circle of 40 mm touches nothing else.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let follower = Follower::RollerTranslating { prime_radius: 0.04, offset: 0.0, roller_radius: 0.012 };
/// let found = Cam::new(law, follower)?.interference(360, 0.0, 1e-6);
/// assert!(found.iter().all(|i| i.body != Body::Roller));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// The roller or the mushroom's arc.
    Roller,
    /// The flat face.
    Face,
    /// The arm from pivot to roller centre, or the stem above a translating roller.
    Arm,
}

/// The worst interference of one body.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // The face of an eccentric disc lies along its edge and in no part of it.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// assert!(cam.interference(360, 0.0, 1e-6).is_empty());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interference {
    /// The interfering body.
    pub body: Body,
    /// Cam angle at which it is worst, rad.
    pub at: f64,
    /// Cam angle whose profile point is in the way, rad.
    pub point: f64,
    /// How deep that point lies inside the body, m.
    pub depth: f64,
}

impl Cam {
    /// The worst interference of every body, for a cam sampled at `n` points (720 is plenty); the arm or
    /// stem is a bar of the given width, m, in the plane of the cam (0: it runs in another plane and
    /// is not checked). Depths below `tolerance`, m, are not reported. Empty: none found.
    ///
    /// An arm that rests on a small roller must be narrower than the roller, or it is reported.
    pub fn interference(&self, n: usize, arm_width: f64, tolerance: f64) -> Vec<Interference> {
        let profile = self.profile(n);
        let geometry = Geometry::new(&self.follower);
        let mut worst: Vec<Interference> = Vec::new();
        for here in &profile {
            let frame = geometry.frame(here.theta);
            let stand = Here {
                contact: frame.in_space([here.x, here.y]),
                centre: frame.in_space([here.pitch_x, here.pitch_y]),
                motion: self.motion(here.theta),
            };
            for other in &profile {
                let point = frame.in_space([other.x, other.y]);
                for (body, depth) in depths(&self.follower, &stand, point, arm_width) {
                    if depth <= tolerance {
                        continue;
                    }
                    let found = Interference {
                        body,
                        at: here.theta,
                        point: other.theta,
                        depth,
                    };
                    match worst.iter_mut().find(|w| w.body == body) {
                        Some(w) if w.depth >= depth => {}
                        Some(w) => *w = found,
                        None => worst.push(found),
                    }
                }
            }
        }
        worst
    }
}

/// The follower in space at one instant.
struct Here {
    contact: [f64; 2],
    centre: [f64; 2],
    /// Direction of the lift, which is the normal of a flat face.
    motion: [f64; 2],
}

/// How deep a point of the cam lies in each body; negative outside.
fn depths(
    follower: &Follower,
    here: &Here,
    point: [f64; 2],
    arm_width: f64,
) -> impl Iterator<Item = (Body, f64)> {
    let half = 0.5 * arm_width;
    let [x, y] = here.centre;
    let touching = if follower.is_flat() {
        let [nx, ny] = here.motion;
        let [cx, cy] = here.contact;
        (Body::Face, nx * (point[0] - cx) + ny * (point[1] - cy))
    } else {
        let distance = (point[0] - x).hypot(point[1] - y);
        (Body::Roller, follower.roller_radius() - distance)
    };
    let arm = match follower {
        Follower::RollerTranslating { .. } | Follower::TranslatingCam { .. } => {
            // The stem stands on the roller's centre.
            (point[1] > y).then(|| half - (point[0] - x).abs())
        }
        Follower::RollerOscillating { pivot_distance, .. } => {
            Some(half - distance_to_segment(point, [*pivot_distance, 0.0], [x, y]))
        }
        _ => None,
    };
    let arm = arm.filter(|_| half > 0.0).map(|depth| (Body::Arm, depth));
    [Some(touching), arm].into_iter().flatten()
}

fn distance_to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
    let t = t.clamp(0.0, 1.0);
    (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy)
}
