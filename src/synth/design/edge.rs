//! Edges of the workpiece that are cut, in drawing coordinates. Exporters and plots use these edges.
//!
//! A disc has one closed edge, and a conjugate pair has one closed edge for each cam. A translating cam has one edge with two ends. The unrolled
//! groove of a barrel has two walls with two ends each, even if its law is closed.

use super::Design;
use crate::cam::{Cam, Wall};

/// Edge of the workpiece that is cut, as a function of the cam angle.
///
/// ```
/// use gaitcam::scene::built_in;
/// use gaitcam::synth::Edge;
///
/// let pair = built_in("camdas_07_conjugate_roller").unwrap().scene().unwrap().design().unwrap();
/// let edges = Edge::all(&pair);
/// assert!(edges.len() == 2 && edges.iter().all(|edge| edge.is_closed()));
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Edge<'a> {
    /// Layer of the edge in a DXF file.
    pub layer: &'static str,
    cam: &'a Cam,
    place: Place,
}

/// Position of the edge relative to the contact points of the cam.
#[derive(Debug, Clone, Copy)]
enum Place {
    /// The contact points, shifted in +y by this distance, m.
    Raised(f64),
    /// The points of the roller opposite to the contact points, shifted in +y by `raised`, m. `undercut` states whether the wall at these
    /// points is undercut.
    Opposite { raised: f64, undercut: bool },
    /// The contact points, rotated by half a turn, as for the second cam of a pair on its shaft.
    HalfTurned,
}

/// Point of an edge, with the tangent in the direction of increasing cam angle θ.
///
/// ```
/// use gaitcam::scene::built_in;
/// use gaitcam::synth::{Edge, EdgePoint};
///
/// let design = built_in("footbridge").unwrap().scene().unwrap().design().unwrap();
/// let EdgePoint { p, t, .. } = Edge::of(&design.cam).at(0.5);
/// // A profile runs clockwise about its centre.
/// assert!(p[0] * t[1] - p[1] * t[0] < 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Cam angle at which the point touches the follower, rad (m of travel for a translating cam).
    pub theta: f64,
    /// Coordinates of the point, m.
    pub p: [f64; 2],
    /// Unit tangent of the edge.
    pub t: [f64; 2],
    /// Centre of the roller in contact, m. For a flat face, it is the contact point.
    pub pitch: [f64; 2],
}

impl<'a> Edge<'a> {
    /// Edge that is the profile of a single cam.
    pub fn of(cam: &'a Cam) -> Self {
        Edge {
            layer: "CUT_PROFILE",
            cam,
            place: Place::Raised(0.0),
        }
    }

    /// All edges of a design. The first one is the profile (for a barrel the lower wall).
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

    /// Pitch curves (paths of the roller centre) of the cam and of the second cam; empty without a roller. The field `pitch` of the points
    /// contains them.
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

    /// Whether the edge is closed.
    pub fn is_closed(&self) -> bool {
        self.cam.law.is_closed() && !self.cam.follower.is_unrolled()
    }

    /// Whether the edge is undercut. An undercut edge has cusps, at which its tangent reverses.
    pub fn is_undercut(&self) -> bool {
        match self.place {
            Place::Opposite { undercut, .. } => undercut,
            _ => self.cam.curvature().undercut,
        }
    }

    /// Cam angles of the breaks between the spans of the law, rad (m for a translating cam).
    pub fn breaks(&self) -> &[f64] {
        self.cam.law.breaks()
    }

    /// Point of the edge at the cam angle `theta`, rad (m for a translating cam).
    pub fn at(&self, theta: f64) -> EdgePoint {
        let point = self.cam.point(theta);
        let [nx, ny] = self.cam.normal(&point);
        let (p, pitch) = ([point.x, point.y], [point.pitch_x, point.pitch_y]);
        // A profile is traversed clockwise: its tangent is the outward normal rotated clockwise by a quarter turn.
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

    /// `n` points at equal steps of the cam angle. A closed edge does not repeat its first point. The points of an open edge include both
    /// ends.
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
