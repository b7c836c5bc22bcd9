//! The cam as a body: area, centre of area, unbalance, and the hole that cancels it.
//!
//! Green's theorem turns the integrals over the area into sums over the profile. On each piece of the law the
//! polygon through equally spaced points has an error that is a series in the square of the step, so Romberg's
//! extrapolation gives the integrals to rounding.

use super::{Bore, Cam};

/// Most halvings of a piece, and the coarsest division.
const LEVELS: usize = 9;
const COARSEST: usize = 4;
/// Relative difference of two levels that is treated as rounding.
const AGREED: f64 = 1e-14;
/// Wall that a hole leaves to the bore and to the profile, m.
pub const LEAST_WALL: f64 = 0.003;
/// A centre of area closer to the centre of rotation is rounding of the profile, m.
const BALANCED: f64 = 1e-9;
/// Places tried for a hole between bore and profile, and profile points that it must stay clear of.
const PLACES: usize = 400;
const PROFILE: usize = 1440;

/// A plate with the cam's outline and its bore.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // An eccentric disc of 30 mm about (10 mm, 0): its area, and its centre of area.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// let body = cam.body(None).unwrap();
/// assert!((body.area - std::f64::consts::PI * 0.03 * 0.03).abs() < 1e-9);
/// assert!((body.centroid[0] - 0.01).abs() < 1e-9 && body.centroid[1].abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanArea {
    /// Area, m².
    pub area: f64,
    /// Centre of area in the cam's frame, m.
    pub centroid: [f64; 2],
}

/// A round hole through the plate.
///
/// ```
/// use gaitcam::cam::{Bore, Cam, Follower};
/// use gaitcam::law::Law;
///
/// // A disc of 31 mm about (1 mm, 0): the hole takes as much moment away as π R² e.
/// let law = Law::harmonic(0.001, &[(0.0, 0.001)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.03 })?;
/// let hole = cam.balance_hole(Some(Bore::plain(0.012))).unwrap();
/// let taken = 0.25 * hole.diameter * hole.diameter * hole.centre[0];
/// assert!((taken / (0.031 * 0.031 * 0.001) - 1.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Its centre in the cam's frame, m.
    pub centre: [f64; 2],
    /// Its diameter, m.
    pub diameter: f64,
}

impl PlanArea {
    /// Static moment of the area about the centre of rotation, m³: times thickness and density it is the
    /// unbalance.
    pub fn moment(&self) -> f64 {
        self.area * self.eccentricity()
    }

    /// Distance of the centre of area from the centre of rotation, m.
    fn eccentricity(&self) -> f64 {
        self.centroid[0].hypot(self.centroid[1])
    }

    /// Whether it turns without unbalance.
    pub fn is_balanced(&self) -> bool {
        self.eccentricity() < BALANCED
    }
}

impl Cam {
    /// The plate with its bore. `None` for a cam that does not turn, whose law does not
    /// close, or that is undercut: its profile bounds no area.
    pub fn body(&self, bore: Option<Bore>) -> Option<PlanArea> {
        if self.follower.is_unrolled() || !self.law.is_closed() || self.curvature().undercut {
            return None;
        }
        let mut sums = [0.0; 3];
        for pair in self.law.breaks().windows(2) {
            let piece = self.piece_moments(pair[0], pair[1]);
            for (sum, x) in sums.iter_mut().zip(piece) {
                // The profile runs clockwise.
                *sum -= x;
            }
        }
        let [area, x, y] = sums;
        let [hole, hole_y] = bore.map_or([0.0; 2], |bore| [bore.area(), bore.moment()]);
        let left = area - hole;
        (left > 0.0).then(|| PlanArea {
            area: left,
            centroid: [x / left, (y - hole_y) / left],
        })
    }

    /// Area between the centre and a piece of the profile, and its first moments.
    fn piece_moments(&self, from: f64, to: f64) -> [f64; 3] {
        let mut rows: Vec<[f64; 3]> = Vec::new();
        for level in 0..LEVELS {
            let n = COARSEST << level;
            let at = |i: usize| {
                let p = self.point(from + (to - from) * i as f64 / n as f64);
                [p.x, p.y]
            };
            let mut current = vec![fan((0..=n).map(at))];
            for (k, before) in rows.iter().enumerate() {
                let factor = 4f64.powi(k as i32 + 1);
                let last = current[k];
                current.push([0, 1, 2].map(|m| (factor * last[m] - before[m]) / (factor - 1.0)));
            }
            let converged = rows.last().is_some_and(|old| {
                let new = current[current.len() - 1];
                (0..3).all(|m| (new[m] - old[m]).abs() <= AGREED * new[m].abs())
            });
            rows = current;
            if converged {
                break;
            }
        }
        rows.last().copied().unwrap_or_default()
    }

    /// The smallest round hole that brings the centre of area to the centre of rotation and leaves walls of
    /// [`LEAST_WALL`]; `None` if none fits or the cam is balanced.
    pub fn balance_hole(&self, bore: Option<Bore>) -> Option<Hole> {
        self.balance_hole_outside(bore, bore.map_or(0.0, |b| b.reach()))
    }

    /// As above, with the hole outside a circle of radius `inner` m about the centre.
    pub(super) fn balance_hole_outside(&self, bore: Option<Bore>, inner: f64) -> Option<Hole> {
        let body = self.body(bore)?;
        if body.is_balanced() {
            return None;
        }
        let moment = body.moment();
        let along = body.centroid.map(|x| x / body.eccentricity());
        let profile: Vec<[f64; 2]> = self.profile(PROFILE).iter().map(|p| [p.x, p.y]).collect();
        let squares: Vec<f64> = profile.iter().map(|p| p[0] * p[0] + p[1] * p[1]).collect();
        let reach = squares.iter().fold(0.0_f64, |m, s| m.max(*s)).sqrt();
        let farthest = farthest_along(&profile, along);
        let onward: Vec<f64> = profile
            .iter()
            .map(|p| along[0] * p[0] + along[1] * p[1])
            .collect();
        // A hole farther out is smaller: take the first that fits, from outside inwards.
        (0..PLACES).rev().find_map(|i| {
            let distance = reach * (i + 1) as f64 / PLACES as f64;
            let radius = (moment / (std::f64::consts::PI * distance)).sqrt();
            if distance >= farthest || distance - inner - radius < LEAST_WALL {
                return None;
            }
            // |p − c|² = |p|² − 2 p·c + |c|².
            let nearest = squares
                .iter()
                .zip(&onward)
                .map(|(square, along)| square - 2.0 * distance * along)
                .fold(f64::INFINITY, |m, x| if x < m { x } else { m });
            let wall = (nearest + distance * distance).max(0.0).sqrt();
            (wall - radius >= LEAST_WALL).then_some(Hole {
                centre: along.map(|x| distance * x),
                diameter: 2.0 * radius,
            })
        })
    }
}

/// How far the profile reaches along a unit vector from the centre, m.
fn farthest_along(profile: &[[f64; 2]], along: [f64; 2]) -> f64 {
    let beside = |p: &[f64; 2]| along[0] * p[1] - along[1] * p[0];
    let onward = |p: &[f64; 2]| along[0] * p[0] + along[1] * p[1];
    let n = profile.len();
    (0..n)
        .map(|i| (&profile[i], &profile[(i + 1) % n]))
        .filter(|(a, b)| (beside(a) > 0.0) != (beside(b) > 0.0))
        .map(|(a, _)| onward(a))
        .fold(0.0, f64::max)
}

/// Area and first moments of the triangles between the origin and a polyline, positive counter-clockwise.
fn fan(points: impl Iterator<Item = [f64; 2]>) -> [f64; 3] {
    let mut sums = [0.0; 3];
    let mut before: Option<[f64; 2]> = None;
    for p in points {
        if let Some(q) = before {
            let cross = q[0] * p[1] - q[1] * p[0];
            sums[0] += cross / 2.0;
            sums[1] += (q[0] + p[0]) * cross / 6.0;
            sums[2] += (q[1] + p[1]) * cross / 6.0;
        }
        before = Some(p);
    }
    sums
}
