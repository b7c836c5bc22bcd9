//! The edges to cut, in the frame of the drawing; used by every exporter.
//!
//! A disc has one closed edge, a conjugate pair one for each cam, a sliding cam one with two ends. A
//! barrel's groove, unrolled, has two walls with two ends each, even where its law closes: there the
//! drawing is wrapped.

use gaitcam::cam::{Cam, Wall};
use gaitcam::synth::Design;

/// One edge to cut.
#[derive(Debug, Clone, Copy)]
pub struct Edge<'a> {
    /// Its layer in a DXF.
    pub layer: &'static str,
    cam: &'a Cam,
    place: Place,
}

/// Where the edge lies from the cam's contact points.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// On them, moved up by so much, m.
    Raised(f64),
    /// On the roller's other side, moved up by so much, m; whether the roller cuts it away somewhere.
    Opposite { raised: f64, undercut: bool },
    /// Turned by half a turn: the second cam of a pair as it stands on the shaft.
    HalfTurned,
}

/// A point of an edge with its tangent in the sense of growing θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Cam angle at which it touches the follower, rad (m of travel for a sliding cam).
    pub theta: f64,
    /// The point, m.
    pub p: [f64; 2],
    /// Unit tangent.
    pub t: [f64; 2],
    /// Centre of the roller that touches here, m (the point itself for a flat face).
    pub pitch: [f64; 2],
}

impl<'a> Edge<'a> {
    /// The profile of a cam alone.
    pub fn of(cam: &'a Cam) -> Self {
        Edge {
            layer: "CUT_PROFILE",
            cam,
            place: Place::Raised(0.0),
        }
    }

    /// Every edge of a design; the first is the profile (a barrel's lower wall).
    pub fn all(synthesis: &'a Design) -> Vec<Self> {
        let cam = &synthesis.cam;
        let mut edges = vec![Edge::of(cam)];
        if let Some(groove) = &synthesis.groove {
            edges[0].place = Place::Raised(groove.axis_offset(Wall::Lower));
            let bulge = groove.smallest_bulge(cam.follower.base_radius(), Wall::Upper);
            edges.push(Edge {
                layer: "CUT_UPPER_WALL",
                cam,
                place: Place::Opposite {
                    raised: groove.axis_offset(Wall::Upper),
                    undercut: bulge.value <= 0.0,
                },
            });
        }
        if let Some(pair) = &synthesis.conjugate {
            edges.push(Edge {
                layer: "CUT_SECOND_PROFILE",
                cam: &pair.second,
                place: Place::HalfTurned,
            });
        }
        edges
    }

    /// The curves on which the centres of rollers run, each as the edge that its pitch points belong to.
    pub fn pitch_curves(synthesis: &'a Design) -> Vec<Self> {
        if synthesis.cam.follower.roller_radius() == 0.0 {
            return Vec::new();
        }
        let first = Edge {
            layer: "REF_PITCH_CURVE",
            ..Edge::of(&synthesis.cam)
        };
        let second = synthesis.conjugate.as_ref().map(|pair| Edge {
            layer: "REF_SECOND_PITCH_CURVE",
            cam: &pair.second,
            place: Place::HalfTurned,
        });
        [first].into_iter().chain(second).collect()
    }

    /// Its name in an SVG.
    pub fn id(&self) -> String {
        id(self.layer)
    }

    /// Whether it leads back to its first point.
    pub fn is_closed(&self) -> bool {
        self.cam.law.is_closed() && !self.cam.follower.is_unrolled()
    }

    /// Whether the roller cuts parts of it away: its tangent turns back in cusps.
    pub fn is_undercut(&self) -> bool {
        match self.place {
            Place::Opposite { undercut, .. } => undercut,
            _ => self.cam.curvature().undercut,
        }
    }

    /// Angles between which the law is one piece.
    pub fn breaks(&self) -> &[f64] {
        self.cam.law.breaks()
    }

    /// The point at `theta`.
    pub fn at(&self, theta: f64) -> EdgePoint {
        let point = self.cam.point(theta);
        let [nx, ny] = self.cam.normal(&point);
        let (p, pitch) = ([point.x, point.y], [point.pitch_x, point.pitch_y]);
        // A profile runs clockwise: its tangent is the outward normal turned to the right.
        let t = [ny, -nx];
        let up = |[x, y]: [f64; 2], by: f64| [x, y + by];
        let (p, t, pitch) = match self.place {
            Place::Raised(by) => (up(p, by), t, up(pitch, by)),
            Place::Opposite { raised, .. } => {
                let other = [2.0 * pitch[0] - p[0], 2.0 * pitch[1] - p[1]];
                (up(other, raised), t, up(pitch, raised))
            }
            Place::HalfTurned => (p.map(|x| -x), t.map(|x| -x), pitch.map(|x| -x)),
        };
        EdgePoint { theta, p, t, pitch }
    }

    /// `n` points at equal steps of the cam angle: a closed edge does not repeat its first, an open one
    /// ends on its last.
    pub fn points(&self, n: usize) -> Vec<EdgePoint> {
        let (start, length) = self.cam.law.extent();
        let steps = if self.is_closed() {
            n
        } else {
            n.saturating_sub(1).max(1)
        };
        let at = |i: usize| self.at(start + length * i as f64 / steps as f64);
        (0..n).map(at).collect()
    }
}

/// Half the length of the centre mark's strokes, m.
const MARK: f64 = 0.003;

/// What is on a layer, named as in an SVG.
pub fn id(layer: &str) -> String {
    let name = layer.split_once('_').map_or(layer, |(_, name)| name);
    name.to_lowercase().replace('_', "-")
}

/// Reference lines of the drawing, with their layers, m: the centre of a disc, the foot of
/// a sliding cam, the seams at which an unrolled barrel begins each turn.
pub fn marks(synthesis: &Design) -> Vec<(&'static str, [[f64; 2]; 2])> {
    let follower = &synthesis.cam.follower;
    let (start, length) = synthesis.cam.law.extent();
    if !follower.is_unrolled() {
        return vec![
            ("REF_CENTRE", [[-MARK, 0.0], [MARK, 0.0]]),
            ("REF_CENTRE", [[0.0, -MARK], [0.0, MARK]]),
        ];
    }
    if synthesis.groove.is_none() {
        return vec![("REF_FOOT", [[start, 0.0], [start + length, 0.0]])];
    }
    let radius = follower.base_radius();
    let (low, high) = synthesis.cam.law.extremes(0);
    let room = follower.roller_radius() + MARK;
    let turns = (length / std::f64::consts::TAU).round() as usize;
    (0..=turns)
        .map(|k| {
            let x = radius * (start + length * k as f64 / turns.max(1) as f64);
            ("REF_SEAM", [[x, low.value - room], [x, high.value + room]])
        })
        .collect()
}

/// The mark of θ = 0, along the follower's motion (+y) from halfway between bore and base circle up to the
/// base circle; radii and result in one unit.
pub fn zero_mark(base: f64, bore: f64) -> [[f64; 2]; 2] {
    [[0.0, 0.5 * (base + bore)], [0.0, base]]
}

/// Arrow in the sense of rotation: an arc about the centre, on the side away from the mark of θ = 0.
pub struct Arrow {
    /// Whether θ falls: the profile's angle grows counter-clockwise.
    pub clockwise: bool,
    /// Its radius.
    pub radius: f64,
    /// Where it begins, and its tip.
    pub ends: [[f64; 2]; 2],
    /// The other ends of the two strokes of its head.
    pub head: [[f64; 2]; 2],
}

impl Arrow {
    /// Angle of the arc, rad.
    pub const ANGLE: f64 = std::f64::consts::FRAC_PI_3;

    /// Halfway between bore and base circle.
    pub fn new(base: f64, bore: f64, clockwise: bool) -> Self {
        let radius = 0.5 * (base + bore);
        let sense = if clockwise { -1.0 } else { 1.0 };
        let middle = -std::f64::consts::FRAC_PI_2;
        let at = |r: f64, part: f64| {
            let angle = middle + sense * part * Self::ANGLE;
            [r * angle.cos(), r * angle.sin()]
        };
        Arrow {
            clockwise,
            radius,
            ends: [at(radius, -0.5), at(radius, 0.5)],
            head: [at(0.94 * radius, 0.38), at(1.06 * radius, 0.38)],
        }
    }
}
