//! Approximation of the profile by circular arcs within a given tolerance.
//!
//! Two points of the profile, with their exact tangents, are joined by a biarc. A biarc consists of two arcs with a common tangent where
//! they meet. An interval whose biarc exceeds the tolerance is halved.

use gaitcam::cam::Cam;
use gaitcam::synth::{Edge, EdgePoint};

/// Maximum range of the cam angle for one biarc, rad.
const WIDEST: f64 = std::f64::consts::FRAC_PI_2;
/// Number of parts into which an interval is divided for the first, coarse measurement of the distance.
const TRIED: usize = 16;
const PROVED: usize = 64;
/// Maximum number of times that an interval is halved. More halvings are needed only at a corner.
const DEEPEST: usize = 14;
/// Bulge below which an arc becomes a chord, because the radius would have a large rounding error.
const FLAT: f64 = 1e-10;

/// Curve of consecutive circular arcs.
#[derive(Debug, Clone, PartialEq)]
pub struct Arcs {
    /// Vertices x, y (m) and the bulge of the following edge. The bulge is the tangent of a quarter of the arc's angle, positive
    /// counter-clockwise. For an open chain, the last bulge is 0.
    pub vertices: Vec<[f64; 3]>,
    /// Whether the last edge ends at the first vertex.
    pub closed: bool,
    /// Maximum distance between the exact profile and the arcs, m, at 63 points between the ends of each pair of arcs.
    pub deviation: f64,
}

impl Arcs {
    /// Vertices x, y (m) of a polyline of chords that is within `distance` (m) of the arcs. All bulges are 0.
    pub fn chords(&self, distance: f64) -> Vec<[f64; 3]> {
        let count = self.vertices.len();
        let mut out = Vec::with_capacity(count);
        for (i, &[x, y, bulge]) in self.vertices.iter().enumerate() {
            out.push([x, y, 0.0]);
            let [u, v, _] = self.vertices[(i + 1) % count];
            let half = 2.0 * libm::atan(bulge);
            if half == 0.0 {
                continue;
            }
            // The height of an arc with the angle 2h and the radius r is r(1 − cos h).
            let chord = [u - x, v - y];
            let radius = 0.5 * libm::hypot(chord[0], chord[1]) / libm::sin(half).abs();
            let widest = libm::acos((1.0 - distance / radius).clamp(-1.0, 1.0));
            let parts = (half.abs() / widest).ceil().max(1.0);
            for k in 1..parts as usize {
                // The point at the fraction f of the arc has the distance sin(f h)/sin(h) chords from the start. Its direction is the
                // direction of the chord, rotated by (f − 1) h.
                let along = k as f64 / parts * half;
                let (long, (sin, cos)) = (
                    libm::sin(along) / libm::sin(half),
                    libm::sincos(along - half),
                );
                out.push([
                    x + long * (cos * chord[0] - sin * chord[1]),
                    y + long * (sin * chord[0] + cos * chord[1]),
                    0.0,
                ]);
            }
        }
        out
    }
}

/// Biarc: start, joint and end, and the bulges of both arcs.
struct Biarc {
    points: [[f64; 2]; 3],
    bulges: [f64; 2],
    /// Direction of the common tangent at the joint, not normalised.
    tangent: [f64; 2],
}

/// Approximates the profile by arcs within `tolerance` m. The result is `None` if the profile is undercut (its tangent reverses at cusps) or if the
/// velocity of the law jumps. It is also `None` if the tolerance is not positive or below the rounding errors.
pub fn fit(cam: &Cam, tolerance: f64) -> Option<Arcs> {
    along(&Edge::of(cam), tolerance)
}

/// Approximates an edge, which may be open, by circular arcs within `tolerance` m. `None` under the conditions given for [`fit`].
pub(super) fn along(edge: &Edge, tolerance: f64) -> Option<Arcs> {
    let sensible = tolerance.is_finite() && tolerance > 0.0;
    if !sensible || edge.is_undercut() {
        return None;
    }
    let mut out = Arcs {
        vertices: Vec::new(),
        closed: edge.is_closed(),
        deviation: 0.0,
    };
    let mut last = None;
    for w in edge.breaks().windows(2) {
        let parts = ((w[1] - w[0]) / WIDEST).ceil().max(1.0) as usize;
        let at = |k: usize| edge.at(w[0] + (w[1] - w[0]) * k as f64 / parts as f64);
        for k in 0..parts {
            let (from, to) = (at(k), at(k + 1));
            follow(edge, from, to, tolerance, DEEPEST, &mut out)?;
            last = Some(to);
        }
    }
    if let Some(EdgePoint { p: [x, y], .. }) = last.filter(|_| !out.closed) {
        out.vertices.push([x, y, 0.0]);
    }
    (out.deviation <= tolerance).then_some(out)
}

fn follow(
    edge: &Edge,
    from: EdgePoint,
    to: EdgePoint,
    tolerance: f64,
    depth: usize,
    out: &mut Arcs,
) -> Option<()> {
    let biarc = Biarc::between(from, to);
    let circles = biarc.circles();
    // Maximum distance between profile and biarc at `count` points, or the first distance above the tolerance.
    let stray = |count: usize| {
        let mut most: f64 = 0.0;
        for k in 1..count {
            let theta = from.theta + (to.theta - from.theta) * k as f64 / count as f64;
            most = most.max(biarc.distance(edge.at(theta).p, circles));
            if most > tolerance {
                break;
            }
        }
        most
    };
    let fits = stray(TRIED) <= tolerance;
    let proved = if fits { stray(PROVED) } else { f64::INFINITY };
    if proved <= tolerance {
        for k in 0..2 {
            let [x, y] = biarc.points[k];
            out.vertices.push([x, y, biarc.bulges[k]]);
        }
        out.deviation = out.deviation.max(proved);
        return Some(());
    }
    let depth = depth.checked_sub(1)?;
    let middle = edge.at(0.5 * (from.theta + to.theta));
    follow(edge, from, middle, tolerance, depth, out)?;
    follow(edge, middle, to, tolerance, depth, out)
}

impl Biarc {
    /// Biarc between the points P₀ and P₁ with the unit tangents T₀ and T₁. The inner corners of its control polygon are P₀ + d T₀ and P₁ − d T₁, and
    /// the distance between these corners is 2d.
    fn between(from: EdgePoint, to: EdgePoint) -> Self {
        let v = [to.p[0] - from.p[0], to.p[1] - from.p[1]];
        let t = [from.t[0] + to.t[0], from.t[1] + to.t[1]];
        let vv = dot(v, v);
        let vt = dot(v, t);
        // d²·2(1 − T₀·T₁) + 2d·v·t − v·v = 0, in the form that is also valid for T₀ = T₁.
        let bend = 2.0 * (1.0 - dot(from.t, to.t));
        let root = (vt * vt + bend * vv).sqrt();
        let d = if vt + root > 0.0 {
            vv / (vt + root)
        } else {
            0.5 * vv.sqrt()
        };
        let joint = [0, 1].map(|k| 0.5 * (from.p[k] + d * from.t[k] + to.p[k] - d * to.t[k]));
        let first = [joint[0] - from.p[0], joint[1] - from.p[1]];
        let second = [to.p[0] - joint[0], to.p[1] - joint[1]];
        // The angle between chord and tangent is half the angle of the arc. The bulge is the tangent of a quarter of the arc's angle.
        let bulge = |a: [f64; 2], b: [f64; 2]| libm::tan(0.5 * libm::atan2(cross(a, b), dot(a, b)));
        let arms = [
            to.p[0] - d * to.t[0] - from.p[0] - d * from.t[0],
            to.p[1] - d * to.t[1] - from.p[1] - d * from.t[1],
        ];
        Biarc {
            points: [from.p, joint, to.p],
            bulges: [bulge(from.t, first), bulge(second, to.t)],
            tangent: arms,
        }
    }

    /// Circles of both arcs; `None` for an arc that is a chord.
    fn circles(&self) -> [Option<Circle>; 2] {
        [0, 1].map(|k| circle(self.points[k], self.points[k + 1], self.bulges[k]))
    }

    /// Distance between a biarc and a point near it, m.
    fn distance(&self, q: [f64; 2], circles: [Option<Circle>; 2]) -> f64 {
        let joint = self.points[1];
        let k = usize::from(dot([q[0] - joint[0], q[1] - joint[1]], self.tangent) > 0.0);
        match circles[k] {
            Some((centre, radius)) => {
                (libm::hypot(q[0] - centre[0], q[1] - centre[1]) - radius).abs()
            }
            None => from_chord(q, self.points[k], self.points[k + 1]),
        }
    }
}

/// Distance of `q` from the line through `a` and `b`, in the unit of the coordinates.
fn from_chord(q: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let c = [b[0] - a[0], b[1] - a[1]];
    let length = libm::hypot(c[0], c[1]);
    if length == 0.0 {
        return libm::hypot(q[0] - a[0], q[1] - a[1]);
    }
    (cross(c, [q[0] - a[0], q[1] - a[1]]) / length).abs()
}

/// Circle, given by its centre and its radius.
pub(super) type Circle = ([f64; 2], f64);

/// Centre and radius of the arc from `a` to `b`; `None` for a chord.
pub(super) fn circle(a: [f64; 2], b: [f64; 2], bulge: f64) -> Option<Circle> {
    let c = [b[0] - a[0], b[1] - a[1]];
    let length = libm::hypot(c[0], c[1]);
    if length == 0.0 || bulge.abs() < FLAT {
        return None;
    }
    let radius = length * (1.0 + bulge * bulge) / (4.0 * bulge);
    let rise = length * (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = [
        0.5 * (a[0] + b[0]) - rise * c[1] / length,
        0.5 * (a[1] + b[1]) + rise * c[0] / length,
    ];
    Some((centre, radius.abs()))
}

/// Points of an arc with extreme x or y, without the ends of the arc. The arc is shorter than a semicircle.
pub(super) fn crests(a: [f64; 2], b: [f64; 2], bulge: f64) -> Vec<[f64; 2]> {
    let Some(([x, y], r)) = circle(a, b, bulge) else {
        return Vec::new();
    };
    let c = [b[0] - a[0], b[1] - a[1]];
    // A counter-clockwise arc is on the right-hand side of its chord.
    let on_arc = |q: &[f64; 2]| bulge * cross(c, [q[0] - a[0], q[1] - a[1]]) < 0.0;
    [[x + r, y], [x - r, y], [x, y + r], [x, y - r]]
        .into_iter()
        .filter(on_arc)
        .collect()
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
