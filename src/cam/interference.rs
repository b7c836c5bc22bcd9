//! Interference of roller, face or arm with the cam away from the contact. Undercut is a local interference at the contact. This check
//! covers the whole profile. In CAM-DAS, the user has to check it visually. The profile is sampled at n points, so depths below the sagitta
//! between two points (about step²/8ρ, with the radius of curvature ρ) are not detected.

use super::{Cam, Follower, Geometry, ProfilePoint};

/// Part of the follower that can interfere with the cam.
///
/// ```
/// use gaitcam::cam::{Body, Cam, Follower};
/// use gaitcam::law::Law;
///
/// // A roller of radius 12 mm on a prime circle of 40 mm touches the cam only at the contact.
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
    /// The flat face of the follower.
    Face,
    /// The arm from pivot to roller centre, or the stem above a translating roller.
    Arm,
}

/// Maximum interference of one part of the follower with the cam.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // The face touches an eccentric disc only at its edge.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// assert!(cam.interference(360, 0.0, 1e-6).is_empty());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interference {
    /// Part of the follower that interferes.
    pub body: Body,
    /// Cam angle of the maximum interference, rad.
    pub at: f64,
    /// Cam angle of the interfering profile point, rad.
    pub point: f64,
    /// Depth of this profile point inside the part of the follower, m.
    pub depth: f64,
}

impl Cam {
    /// Maximum interference of every part of the follower with a cam that is sampled at `n` points (720 is sufficient). The arm or stem is
    /// a bar of the given width, m, in the plane of the cam. A width of 0 means that it is in another plane and is not checked. Depths
    /// below `tolerance`, m, are not reported. The result is empty without interference.
    ///
    /// An arm with a small roller must be narrower than the roller. Otherwise, interference is reported.
    pub fn interference(&self, n: usize, arm_width: f64, tolerance: f64) -> Vec<Interference> {
        let profile = self.profile(n);
        let geometry = Geometry::new(&self.follower);
        let mut worst: Vec<Interference> = Vec::new();
        for here in &profile {
            let frame = geometry.frame(here.theta);
            let in_space = |p: &ProfilePoint| frame.in_space([p.x, p.y]);
            let centre = [here.pitch_x, here.pitch_y];
            let touching = if self.follower.is_flat() {
                let ([nx, ny], [x, y]) = (self.motion(here.theta), in_space(here));
                let depth = |p: &ProfilePoint| {
                    let [px, py] = in_space(p);
                    nx * (px - x) + ny * (py - y)
                };
                (Body::Face, deepest(&profile, depth))
            } else {
                // Squared distances are sufficient here. They are computed in the cam's frame, because this loop takes most of the time of
                // a design with a roller.
                let near =
                    |p: &ProfilePoint| -((p.x - centre[0]).powi(2) + (p.y - centre[1]).powi(2));
                let (square, point) = deepest(&profile, near);
                let depth = self.follower.roller_radius() - (-square).sqrt();
                (Body::Roller, (depth, point))
            };
            let centre = frame.in_space(centre);
            let arm = (arm_width > 0.0).then(|| {
                let depth = |p: &ProfilePoint| {
                    0.5 * arm_width - to_arm(&self.follower, centre, in_space(p))
                };
                (Body::Arm, deepest(&profile, depth))
            });
            for (body, (depth, point)) in [Some(touching), arm].into_iter().flatten() {
                if depth <= tolerance {
                    continue;
                }
                let found = Interference {
                    body,
                    at: here.theta,
                    point: profile[point].theta,
                    depth,
                };
                match worst.iter_mut().find(|w| w.body == body) {
                    Some(w) if w.depth >= depth => {}
                    Some(w) => *w = found,
                    None => worst.push(found),
                }
            }
        }
        worst
    }
}

/// Maximum depth, m, and index of the first point with this depth.
fn deepest(profile: &[ProfilePoint], depth: impl Fn(&ProfilePoint) -> f64) -> (f64, usize) {
    let larger = |most: (f64, usize), (i, p)| {
        let depth = depth(p);
        if depth > most.0 { (depth, i) } else { most }
    };
    let points = profile.iter().enumerate();
    points.fold((f64::NEG_INFINITY, 0), larger)
}

/// Distance of a point in the fixed frame from the middle line of the arm, or of the stem above the roller, m.
fn to_arm(follower: &Follower, [x, y]: [f64; 2], point: [f64; 2]) -> f64 {
    match follower {
        Follower::RollerTranslating { .. } | Follower::TranslatingCam { .. } if point[1] > y => {
            (point[0] - x).abs()
        }
        Follower::RollerOscillating { pivot_distance, .. } => {
            distance_to_segment(point, [*pivot_distance, 0.0], [x, y])
        }
        _ => f64::INFINITY,
    }
}

fn distance_to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
    let t = t.clamp(0.0, 1.0);
    libm::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)
}
