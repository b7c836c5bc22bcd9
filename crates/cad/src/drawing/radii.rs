//! Table of radii. It contains the radius of the profile at given polar angles. It also contains the position of a probing ball that touches the
//! cam after moving along the ray towards the cam's centre.

use gaitcam::synth::{Edge, EdgePoint};

/// Number of intervals of the profile that are checked for intersections with a ray.
const SAMPLES: usize = 2880;
/// Number of bisection steps after which only rounding errors remain.
const HALVINGS: usize = 60;

/// Row of the table of radii; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radius {
    /// Polar angle from the mark of θ = 0 (+y), rad. It is positive clockwise, in the direction in which the profile is traversed.
    pub angle: f64,
    /// Distance of the profile point from the cam's centre.
    pub profile: f64,
    /// Distance of the ball's centre from the cam's centre when the ball touches the profile.
    pub ball: f64,
}

/// Table of `count` rows at equal steps of the polar angle, for a ball of radius `ball` m.
///
/// If a ray intersects the profile several times, the outermost intersection is used, because a probe touches it first.
pub fn radii(edge: &Edge, ball: f64, count: usize) -> Vec<Radius> {
    let [start, .., end] = *edge.breaks() else {
        return Vec::new();
    };
    let at = |i: usize| start + (end - start) * i as f64 / SAMPLES as f64;
    let mut points: Vec<EdgePoint> = (0..=SAMPLES).map(|i| edge.at(at(i))).collect();
    if let Some(last) = points.last_mut() {
        // The first and the last point are equal in every digit, so that a ray cannot pass between them.
        *last = EdgePoint {
            theta: end,
            ..edge.at(start)
        };
    }
    (0..count)
        .map(|k| {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            let [profile, ball] = [0.0, ball].map(|off| outermost(edge, &points, angle, off));
            Radius {
                angle,
                profile,
                ball,
            }
        })
        .collect()
}

/// The point that is farthest from the centre, among `count` points of an edge.
pub fn farthest(edge: &Edge, count: usize) -> EdgePoint {
    let distance = |e: &EdgePoint| libm::hypot(e.p[0], e.p[1]);
    edge.points(count)
        .into_iter()
        .max_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or_else(|| edge.at(0.0))
}

/// Value between `low` and `high` at which the condition changes, found by bisection.
fn crossing(condition: impl Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    let at_low = condition(low);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if condition(middle) == at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Point at the distance `off` (m) outside the profile, along its normal.
fn moved(point: &EdgePoint, off: f64) -> [f64; 2] {
    // The profile is traversed clockwise, so the outward direction is to the left of its tangent.
    [point.p[0] - off * point.t[1], point.p[1] + off * point.t[0]]
}

/// Distance, m, from the centre to the farthest intersection of a ray with the parallel curve of the profile at the distance `off` (m). The ray
/// starts at the centre, at a polar angle in rad. The result is 0 without an intersection.
fn outermost(edge: &Edge, points: &[EdgePoint], angle: f64, off: f64) -> f64 {
    let (sin, cos) = libm::sincos(angle);
    let turned = |e: &EdgePoint| {
        let [x, y] = moved(e, off);
        [cos * x - sin * y, sin * x + cos * y]
    };
    let side = |e: &EdgePoint| turned(e)[0];
    let along = |e: &EdgePoint| turned(e)[1];
    let mut most: f64 = 0.0;
    for pair in points.windows(2) {
        let sides = [&pair[0], &pair[1]].map(|e| side(e) > 0.0);
        if sides[0] != sides[1] && along(&pair[0]) > 0.0 {
            let is_left = |theta| side(&edge.at(theta)) > 0.0;
            let theta = crossing(is_left, pair[0].theta, pair[1].theta);
            most = most.max(along(&edge.at(theta)));
        }
    }
    most
}
