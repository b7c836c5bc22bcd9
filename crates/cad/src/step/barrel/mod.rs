//! A barrel: a cylinder with its groove, bored for the shaft.
//!
//! Walls are the exact envelope of the roller from the groove's floor to the cylinder, both of which are cylinders
//! about the axis. Where a groove of several turns crosses itself its walls end at each other.

mod sectors;
mod wall;

use std::collections::BTreeMap;

use gaitcam::cam::{BarrelGroove, LEAST_WALL, Wall};
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::units::Quantity;

use self::sectors::Bound;
pub use self::sectors::Sectors;
use super::file::{File, Piece};
use super::{Dot, hole_pieces};

const MM: f64 = 1000.0;

/// Heights between which the barrel lies, m: a roller's radius, at least 3 mm, beyond the groove on both sides.
pub fn ends(groove: &BarrelGroove) -> [f64; 2] {
    let (low, high) = groove.law().extremes(0);
    let land = groove.roller_radius() + groove.roller_radius().max(LEAST_WALL);
    [
        low.value + groove.axis_offset(Wall::Lower) - land,
        high.value + groove.axis_offset(Wall::Upper) + land,
    ]
}

/// Adds the barrel's solid to a file.
pub fn add(file: &mut File, groove: &BarrelGroove, design: &Design) -> Result<usize> {
    let (inner, _) = groove.depth();
    if !groove.law().is_closed() {
        return Err(WriteError::OpenGroove.into());
    }
    if [Wall::Lower, Wall::Upper]
        .iter()
        .any(|wall| groove.smallest_bulge(inner, *wall).value <= 0.0)
    {
        return Err(WriteError::UndercutProfile.into());
    }
    if let Some(bore) = design
        .problem
        .cam
        .hole()
        .filter(|b| b.reach() + LEAST_WALL > inner)
    {
        return Err(WriteError::BoreTooLarge {
            bore: Quantity::length(bore.diameter),
            free: Quantity::length(2.0 * (inner - LEAST_WALL)),
        }
        .into());
    }
    let radii = wall::radii(groove).ok_or(WriteError::TooSharp)?;
    let sectors = Sectors::of(groove, radii).ok_or(WriteError::GrooveCrossings)?;
    let mut barrel = Barrel {
        groove,
        sectors: &sectors,
        ends: ends(groove).map(|z| MM * z),
        file,
        nodes: Vec::new(),
        lines: BTreeMap::new(),
        faces: Vec::new(),
    };
    barrel.nodes = (0..sectors.cuts.len())
        .map(|k| barrel.nodes_of(k))
        .collect();
    let mut arcs = [Vec::new(), Vec::new()];
    for k in 0..sectors.cuts.len() {
        barrel.sector(k, &mut arcs)?;
    }
    Ok(barrel.close(arcs, design))
}

/// Where the sectors' edges begin and end at one cut: on a wall, or on the rim of an end of the barrel.
struct Node {
    place: Place,
    /// Its vertex on the floor, and on the surface; the rims have the latter alone.
    vertices: [Option<usize>; 2],
    /// Its points there, mm.
    points: [[f64; 3]; 2],
    /// The edge along the wall between both.
    edge: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Below,
    On(Bound),
    Above,
}

/// Floor and surface of the groove, as indices of what both have.
const FLOOR: usize = 0;
const SURFACE: usize = 1;

/// The edges of a wall in a sector, along growing θ.
struct Strip {
    bound: Bound,
    /// On the floor and on the surface.
    edges: [Vec<usize>; 2],
}

struct Barrel<'a> {
    groove: &'a BarrelGroove,
    sectors: &'a Sectors<'a>,
    /// mm.
    ends: [f64; 2],
    file: &'a mut File,
    /// At each cut, from below.
    nodes: Vec<Vec<Node>>,
    /// Lines between nodes that follow one another on the floor or the surface: cut, level, lower vertex, upper vertex.
    lines: BTreeMap<(usize, usize, usize, usize), usize>,
    faces: Vec<usize>,
}

impl Barrel<'_> {
    /// The nodes of a cut with their vertices and edges.
    fn nodes_of(&mut self, k: usize) -> Vec<Node> {
        let n = self.sectors.cuts.len();
        let mut bounds: Vec<Bound> = Vec::new();
        let before = &self.sectors.openings[(k + n - 1) % n];
        let here = before.iter().flatten().map(|b| {
            // The sector before the first cut ends a turn later.
            let cut = if k == 0 { n } else { k };
            self.sectors.at_cut(cut, *b).1
        });
        let after = self.sectors.openings[k].iter().flatten();
        let all = here.chain(after.map(|b| self.sectors.at_cut(k, *b).1));
        for bound in all {
            if !bounds.contains(&bound) {
                bounds.push(bound);
            }
        }
        let last = self.sectors.radii.len() - 1;
        let mut nodes: Vec<Node> = bounds.into_iter().map(|b| self.wall_node(k, b)).collect();
        nodes.sort_by(|a, b| a.points[SURFACE][2].total_cmp(&b.points[SURFACE][2]));
        let angle = self.sectors.angle(k, last);
        let rim = |file: &mut File, place: Place, z: f64| {
            let r = MM * self.sectors.radii[last];
            let p = [r * angle.cos(), -r * angle.sin(), z];
            Node {
                place,
                vertices: [None, Some(file.vertex(p))],
                points: [p; 2],
                edge: None,
            }
        };
        nodes.insert(0, rim(self.file, Place::Below, self.ends[0]));
        nodes.push(rim(self.file, Place::Above, self.ends[1]));
        nodes
    }

    fn wall_node(&mut self, k: usize, bound: Bound) -> Node {
        let count = self.sectors.radii.len();
        let at = |r: usize| wall::at_cut(self.groove, self.sectors, k, bound, r);
        let sites: Vec<[f64; 3]> = (0..count).step_by(2).map(at).collect();
        let space = wall::across(&self.sectors.radii);
        let points = [sites[0], sites[sites.len() - 1]];
        let vertices = points.map(|p| self.file.vertex(p));
        let curve = self
            .file
            .spline_curve(&space.control(&sites), &space.knots());
        Node {
            place: Place::On(bound),
            vertices: vertices.map(Some),
            points,
            edge: Some(self.file.edge(vertices[FLOOR], vertices[SURFACE], curve)),
        }
    }

    /// Index of a cut's nodes, where `k` may be the cut after the last, and of a node there.
    fn node(&self, k: usize, place: Place) -> (usize, usize) {
        let n = self.sectors.cuts.len();
        let (cut, place) = match place {
            Place::On(bound) => {
                let (cut, bound) = self.sectors.at_cut(k, bound);
                (cut, Place::On(bound))
            }
            Place::Below | Place::Above => (k % n, place),
        };
        let index = self.nodes[cut].iter().position(|node| node.place == place);
        (cut, index.unwrap_or(0))
    }

    /// The faces of a sector; the arcs of the barrel's ends go to `arcs`.
    fn sector(&mut self, k: usize, arcs: &mut [Vec<usize>; 2]) -> Result<()> {
        let openings = self.sectors.openings[k].clone();
        let mut strips: Vec<[Strip; 2]> = Vec::new();
        for [low, high] in &openings {
            strips.push([self.wall(k, *low)?, self.wall(k, *high)?]);
        }
        let [bottom, top] = [Place::Below, Place::Above].map(|place| self.arc(k, place));
        arcs[0].push(bottom);
        arcs[1].push(top);
        for [low, high] in &strips {
            self.round_face(k, FLOOR, Side::Strip(low), Side::Strip(high));
        }
        let mut below = Side::Arc(bottom, Place::Below);
        for [low, high] in &strips {
            self.round_face(k, SURFACE, below, Side::Strip(low));
            below = Side::Strip(high);
        }
        self.round_face(k, SURFACE, below, Side::Arc(top, Place::Above));
        Ok(())
    }

    /// An arc of an end's rim, counter-clockwise seen from +z: against growing θ.
    fn arc(&mut self, k: usize, place: Place) -> usize {
        let [from, to] = [k + 1, k].map(|k| {
            let (cut, node) = self.node(k, place);
            &self.nodes[cut][node]
        });
        let z = from.points[SURFACE][2];
        let ends = [from, to].map(|node| node.vertices[SURFACE].unwrap_or(0));
        let (_, outer) = self.groove.depth();
        let circle = self.file.circle([0.0; 2], MM * outer, z);
        self.file.edge(ends[0], ends[1], circle)
    }

    /// The faces of one wall.
    fn wall(&mut self, k: usize, bound: Bound) -> Result<Strip> {
        let parts = wall::parts(self.groove, self.sectors, k, bound).ok_or(WriteError::TooSharp)?;
        let across = wall::across(&self.sectors.radii);
        let mut strip = Strip {
            bound,
            edges: [Vec::new(), Vec::new()],
        };
        let end = |this: &Self, k: usize| {
            let (cut, node) = this.node(k, Place::On(bound));
            let node = &this.nodes[cut][node];
            (
                node.vertices.map(|v| v.unwrap_or(0)),
                node.edge.unwrap_or(0),
            )
        };
        let mut left = end(self, k);
        let count = parts.len();
        for (i, part) in parts.into_iter().enumerate() {
            let last = part.net.len() - 1;
            let right = if i + 1 == count {
                end(self, k + 1)
            } else {
                let column = &part.net[last];
                let vertices = [column[0], column[column.len() - 1]].map(|p| self.file.vertex(p));
                let curve = self.file.spline_curve(column, &across.knots());
                (vertices, self.file.edge(vertices[0], vertices[1], curve))
            };
            let along = part.along.knots();
            for level in [FLOOR, SURFACE] {
                let row: Vec<[f64; 3]> = (part.net.iter())
                    .map(|column| column[level * (column.len() - 1)])
                    .collect();
                let curve = self.file.spline_curve(&row, &along);
                let edge = self.file.edge(left.0[level], right.0[level], curve);
                strip.edges[level].push(edge);
            }
            let surface = self
                .file
                .spline_surface(&part.net, [&along, &across.knots()]);
            // Along the groove × outwards is +z: out of the barrel on the lower wall, into it on the upper one.
            let up = bound.wall == Wall::Lower;
            let [floor, rim] = [FLOOR, SURFACE].map(|level| strip.edges[level][i]);
            let mut ring = vec![
                (floor, true),
                (right.1, true),
                (rim, false),
                (left.1, false),
            ];
            if !up {
                ring.reverse();
                for edge in &mut ring {
                    edge.1 = !edge.1;
                }
            }
            let ring = self.file.ring(&ring);
            self.faces.push(self.file.face(surface, ring, &[], up));
            left = right;
        }
        Ok(strip)
    }

    /// A face of the floor or the surface between two sides, seen from outside: growing θ goes to the left.
    fn round_face(&mut self, k: usize, level: usize, below: Side, above: Side) {
        let mut ring: Vec<(usize, bool)> = Vec::new();
        match below {
            // An arc runs to the right, a wall to the left.
            Side::Arc(arc, _) => ring.push((arc, true)),
            Side::Strip(strip) => ring.extend(strip.edges[level].iter().rev().map(|e| (*e, false))),
        }
        ring.extend(
            self.upwards(k, level, below.place(), above.place())
                .into_iter()
                .map(|e| (e, true)),
        );
        match above {
            Side::Arc(arc, _) => ring.push((arc, false)),
            Side::Strip(strip) => ring.extend(strip.edges[level].iter().map(|e| (*e, true))),
        }
        let left = self.upwards(k + 1, level, below.place(), above.place());
        ring.extend(left.into_iter().rev().map(|e| (e, false)));
        let (inner, outer) = self.groove.depth();
        let radius = MM * [inner, outer][level];
        let surface = self.file.cylinder([0.0; 2], radius, self.ends[0]);
        let ring = self.file.ring(&ring);
        self.faces.push(self.file.face(surface, ring, &[], true));
    }

    /// The lines at a cut between two places, upwards.
    fn upwards(&mut self, k: usize, level: usize, from: Place, to: Place) -> Vec<usize> {
        let (cut, first) = self.node(k, from);
        let (_, last) = self.node(k, to);
        (first..last)
            .map(|i| {
                let pair = [&self.nodes[cut][i], &self.nodes[cut][i + 1]];
                let ends = pair.map(|node| node.vertices[level].unwrap_or(0));
                let points = pair.map(|node| node.points[level]);
                let file = &mut *self.file;
                *(self.lines.entry((cut, level, ends[0], ends[1]))).or_insert_with(|| {
                    let line = file.line(points[0], points[1]);
                    file.edge(ends[0], ends[1], line)
                })
            })
            .collect()
    }

    /// Both ends, the hole for the shaft, the mark of θ = 0, and the whole.
    fn close(mut self, arcs: [Vec<usize>; 2], design: &Design) -> usize {
        let hole = (design.problem.cam.hole()).map(|bore| {
            // On a barrel θ = 0 is at +x: the keyway is turned there.
            let turn = |[x, y]: [f64; 2]| [y, -x];
            let pieces: Vec<Piece> = (hole_pieces(&bore).into_iter())
                .map(|piece| match piece {
                    Piece::Line(ends) => Piece::Line(ends.map(turn)),
                    Piece::Arc {
                        ends,
                        centre,
                        radius,
                    } => Piece::Arc {
                        ends: ends.map(turn),
                        centre,
                        radius,
                    },
                    Piece::Spline(_) => piece,
                })
                .collect();
            self.file.wall(&pieces, self.ends, true, &mut self.faces)
        });
        let dot = design.problem.cam.mark.then(|| {
            let reach = design.problem.cam.hole().map_or(0.0, |b| b.reach());
            let place = 0.5 * (reach + self.groove.depth().1);
            let dot = Dot::at(
                [MM * place, 0.0],
                MM * (place - reach),
                self.ends[1] - self.ends[0],
            );
            dot.add_to(self.file, self.ends[1], &mut self.faces)
        });
        // Counter-clockwise seen from +z is against growing θ.
        let rims = arcs.map(|mut arcs| {
            arcs.reverse();
            arcs
        });
        let below: Vec<&[usize]> = hole.iter().map(|r| r.low.as_slice()).collect();
        let above: Vec<&[usize]> = hole.iter().chain(&dot).map(|r| r.high.as_slice()).collect();
        self.file
            .cap(self.ends[0], false, &rims[0], &below, &mut self.faces);
        self.file
            .cap(self.ends[1], true, &rims[1], &above, &mut self.faces);
        self.file.solid("barrel", &self.faces)
    }
}

/// What bounds a face of floor or surface above or below.
#[derive(Clone, Copy)]
enum Side<'a> {
    /// A rim's arc.
    Arc(usize, Place),
    /// A wall.
    Strip(&'a Strip),
}

impl Side<'_> {
    fn place(self) -> Place {
        match self {
            Side::Arc(_, place) => place,
            Side::Strip(strip) => Place::On(strip.bound),
        }
    }
}
