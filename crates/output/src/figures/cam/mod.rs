//! Figure of the cam with its follower, true to scale.

mod follower;
mod pressure;
mod table;

use std::f64::consts::TAU;

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::plot::layout::Layout;
use crate::plot::palette::{AXIS, BLUE, GREEN, INK, ORANGE, PAPER, PURPLE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::plot::sheet::{Canvas, Drawn, Frame, Lettering, Plane, fill, stroke, trace, units};
use crate::plot::text::wrapped;
use crate::pose::{Bounds, Pose, face_reach, pose, turned};
use crate::words::{self, Words};
use gaitcam::cam::{Follower, ProfilePoint};
use gaitcam::synth::Design;
use gaitcam::synth::Edge;
use gaitcam::wording::Language;
use pressure::Pressures;
use table::values_at;

const MM: f64 = 1000.0;
/// Number of vertices of each drawn curve.
const POINTS: usize = 720;
/// Lengths of dash and gap in the line of the base circle, points.
const BASE: [f64; 2] = [7.0, 5.0];
const PRIME: [f64; 2] = [13.0, 4.0];
const PITCH: [f64; 2] = [4.0, 4.0];
/// Width of the column of values next to the cam, em.
const VALUES: f64 = 12.2;
/// Width of the empty margin around the drawing, as a fraction of its larger dimension.
const MARGIN: f64 = 0.04;

/// Figure of the cam at the start of the law, with base circle, prime circle, pitch curve, follower and main dimensions.
pub fn cam(synthesis: &Design, language: Language) -> Picture {
    cam_in(synthesis, Layout::ALONE, &words::words(language))
}

pub(crate) fn cam_in(synthesis: &Design, layout: Layout, words: &Words) -> Picture {
    layout.picture(words.language(), |f| {
        f.title(&synthesis.problem.name, &words.text("figure-cam"))?;
        let e = f.e;
        let (width, height) = (f64::from(layout.size.0), f64::from(layout.size.1));
        let top = if layout.title { 4.2 * e } else { e };
        let scene = Scene::new(synthesis);
        let facts = scene.facts(words);
        let values = values_at(&facts);
        let table = width - (values + VALUES) * e;
        let frame = Frame {
            left: 2.0 * e,
            right: table - e,
            top,
            bottom: height - 1.5 * e,
        };
        let (plane, scale) = scene.plane(f.canvas, frame);
        scene.draw(&plane)?;
        let y = scene.lines(&f, [table, top + 2.0 * e], words)?;
        let mut y = scene.scale(&f, [table, y], words)? + 0.8 * e;
        for (name, value) in &facts {
            f.write(name, [table, y], Lettering::new(e, QUIET))?;
            for line in wrapped(value.split(' '), VALUES - 0.4) {
                f.write(&line, [table + values * e, y], Lettering::new(e, INK))?;
                y += 1.75 * e;
            }
        }
        f.scale_bar([table, height - 2.5 * e], scale, 0.2 * width)
    })
}

/// Objects of the drawing, and dimensions derived from them, mm.
struct Scene<'a> {
    synthesis: &'a Design,
    rows: Vec<ProfilePoint>,
    /// Points of the other edges of the cam, m: upper wall of a groove, or second cam of a pair. The first profile is in `rows`.
    others: Vec<Vec<[f64; 2]>>,
    start: f64,
    /// Contact pressure at the points of `rows`; `None` if it is not drawn.
    pressures: Option<Pressures>,
    pose: Pose,
    base: f64,
    prime: f64,
    /// Maximum distance of the profile from the centre, mm.
    reach: f64,
}

impl<'a> Scene<'a> {
    fn new(synthesis: &'a Design) -> Self {
        let cam = &synthesis.cam;
        let (start, length) = cam.law.extent();
        let rows = if cam.follower.is_unrolled() {
            // The profile of an unrolled cam has two ends, even if its law is closed.
            let step = length / (POINTS - 1) as f64;
            (0..POINTS)
                .map(|i| cam.point(start + step * i as f64))
                .collect()
        } else {
            cam.profile(POINTS)
        };
        let pressures = Pressures::of(synthesis, rows.iter().map(|p| p.theta));
        let others = Edge::all(synthesis)[1..]
            .iter()
            .map(|edge| edge.points(POINTS).iter().map(|e| e.p).collect())
            .collect();
        let reach = rows
            .iter()
            .map(|p| libm::hypot(p.x, p.y))
            .fold(0.0, f64::max)
            * MM;
        Scene {
            synthesis,
            rows,
            others,
            start,
            pressures,
            pose: pose(cam, start),
            base: MM * cam.follower.base_radius(),
            prime: MM * cam.follower.prime_radius(),
            reach,
        }
    }

    /// Whether the face of the follower is an arc of limited length.
    fn is_mushroom(&self) -> bool {
        self.synthesis.cam.follower.kind().is_mushroom()
    }

    fn has_roller(&self) -> bool {
        if self.is_mushroom() {
            return false;
        }
        self.prime != self.base || matches!(self.synthesis.cam.follower, Follower::Barrel { .. })
    }

    /// Whether the profile is drawn along a straight line: translating cam or unrolled barrel cam.
    fn is_straight(&self) -> bool {
        self.synthesis.cam.follower.is_unrolled()
    }

    /// Position of the pivot of the arm, mm; `None` for a translating follower.
    fn pivot(&self) -> Option<[f64; 2]> {
        let pivot = self.synthesis.cam.follower.pivot();
        pivot.map(|p| p.map(|x| MM * x))
    }

    /// Bounds of all objects of the drawing, mm.
    fn bounds(&self) -> Bounds {
        let round = if self.is_straight() {
            0.0
        } else if self.has_roller() {
            self.prime
        } else {
            self.base
        };
        let mut out = Bounds {
            low: [-round; 2],
            high: [round; 2],
        };
        let now = |p: [f64; 2]| turned(p.map(|x| MM * x), self.start);
        for p in &self.rows {
            out.hold(now([p.x, p.y]), 0.0);
            if self.has_roller() {
                out.hold(now([p.pitch_x, p.pitch_y]), 0.0);
            }
        }
        for &p in self.others.iter().flatten() {
            out.hold(now(p), 0.0);
        }
        if let Some(pivot) = self.pivot() {
            out.hold(pivot, 0.06 * self.reach);
        }
        match self.pose {
            Pose::Face { at, angle } if self.pivot().is_some() => {
                let ([x, y], high) = (at.map(|c| MM * c), self.face().1);
                out.hold(
                    [x + high * libm::cos(angle), y + high * libm::sin(angle)],
                    0.0,
                );
            }
            Pose::Face { at, .. } => {
                let (low, high) = self.face();
                out.hold([low, MM * at[1]], 0.0);
                out.hold([high, MM * at[1] + self.stem()], 0.0);
            }
            Pose::Roller { centre, radius } => {
                let ([x, y], r) = (centre.map(|c| MM * c), MM * radius);
                if self.is_mushroom() {
                    out.hold([x - self.reach, y - r], 0.0);
                    out.hold([x + self.reach, y - r + self.stem()], 0.0);
                } else if self.pivot().is_some() {
                    out.hold([x, y], r);
                } else {
                    out.hold([x - r, y], 0.0);
                    out.hold([x + r, y + r + self.stem()], 0.0);
                }
            }
        }
        out
    }

    /// Length of the drawn stem, mm.
    fn stem(&self) -> f64 {
        0.38 * self.reach
    }

    /// Ends of the face along x, mm: the range of the contact, slightly extended.
    fn face(&self) -> (f64, f64) {
        let (low, high) = face_reach(&self.synthesis.cam).unwrap_or((0.0, 0.0));
        let more = 0.08 * self.reach;
        (MM * low - more, MM * high + more)
    }

    /// Coordinate system with equal scales in both directions, centred in the frame, and its scale, points per mm.
    fn plane<'c>(&self, canvas: &Canvas<'c>, frame: Frame) -> (Plane<'c>, f64) {
        let Bounds { low, high } = self.bounds();
        let [w, h] = [0, 1].map(|k| high[k] - low[k]);
        let blank = MARGIN * w.max(h);
        let room = [frame.right - frame.left, frame.bottom - frame.top];
        let scale = (room[0] / (w + 2.0 * blank)).min(room[1] / (h + 2.0 * blank));
        let [x, y] = [0, 1].map(|k| {
            let (middle, half) = (0.5 * (low[k] + high[k]), 0.5 * room[k] / scale);
            [middle - half, middle + half]
        });
        (frame.plane(canvas, x, y), scale)
    }

    fn draw(&self, plane: &Plane) -> Drawn {
        let here = |x: f64, y: f64| {
            let [x, y] = turned([MM * x, MM * y], self.start);
            (x, y)
        };
        let outline: Vec<(f64, f64)> = self.rows.iter().map(|p| here(p.x, p.y)).collect();
        if self.is_straight() {
            // Outline of the plate between the profile and the lower edge of the cam.
            let mut body = outline.clone();
            if let (Some(first), Some(last)) = (outline.first(), outline.last()) {
                let foot = self.foot();
                body.extend([(last.0, foot), (first.0, foot)]);
            }
            fill(plane, &body, BLUE.mix(0.13))?;
        } else if self.synthesis.cam.law.is_closed() {
            fill(plane, &outline, BLUE.mix(0.13))?;
        }
        if !self.is_straight() {
            dashed(plane, circle(self.base), GREEN, BASE)?;
        }
        if let Some(bore) = self
            .synthesis
            .problem
            .cam
            .hole()
            .filter(|_| !self.is_straight())
        {
            let mut angles: Vec<f64> = (0..=360).map(|i| f64::from(i).to_radians()).collect();
            angles.extend(bore.corners().iter().map(|a| a.rem_euclid(TAU)));
            angles.sort_by(f64::total_cmp);
            let rim: Vec<(f64, f64)> = (angles.iter())
                .map(|&a| here(bore.edge(a) * libm::cos(a), bore.edge(a) * libm::sin(a)))
                .collect();
            fill(plane, &rim, PAPER)?;
            trace(plane, rim, stroke(BLUE, 1.6))?;
        }
        if self.has_roller() {
            if !self.is_straight() {
                dashed(plane, circle(self.prime), PURPLE, PRIME)?;
            }
            let pitch = self.rows.iter().map(|p| here(p.pitch_x, p.pitch_y));
            dashed(plane, self.whole(pitch.collect()), ORANGE, PITCH)?;
        }
        self.other_edges(plane, here)?;
        let outline = self.whole(outline);
        match &self.pressures {
            Some(pressures) => pressures.draw(plane, &outline)?,
            None => trace(plane, outline, stroke(BLUE, 2.6))?,
        }
        self.centre(plane)?;
        self.follower(plane)?;
        let contact = self.synthesis.cam.point(self.start);
        dot(plane, here(contact.x, contact.y), RED)?;
        let sharpest = self.synthesis.cam.curvature().convex;
        if sharpest.value.is_finite() {
            let p = self.synthesis.cam.point(sharpest.at);
            let (x, y) = here(p.x, p.y);
            let ring = EmptyElement::at((x, y)) + Circle::new((0, 0), units(5.5), stroke(RED, 2.0));
            plane.draw(&ring)?;
        }
        Ok(())
    }

    /// Draws the upper wall of a groove with the body above it, or the second cam of a pair.
    fn other_edges(&self, plane: &Plane, here: impl Fn(f64, f64) -> (f64, f64)) -> Drawn {
        for other in &self.others {
            let edge: Vec<(f64, f64)> = other.iter().map(|&[x, y]| here(x, y)).collect();
            if !self.is_straight() {
                fill(plane, &edge, PURPLE.mix(0.1))?;
                trace(plane, self.whole(edge), stroke(PURPLE, 2.2))?;
                continue;
            }
            let top = edge.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
            let mut body = edge.clone();
            if let (Some(first), Some(last)) = (edge.first(), edge.last()) {
                let ceiling = top + 0.04 * self.reach;
                body.extend([(last.0, ceiling), (first.0, ceiling)]);
            }
            fill(plane, &body, BLUE.mix(0.13))?;
            trace(plane, edge, stroke(BLUE, 2.6))?;
        }
        Ok(())
    }

    /// Vertical position of the lower edge of an unrolled cam in the drawing, mm.
    fn foot(&self) -> f64 {
        let heights = self.rows.iter().map(|p| MM * p.y);
        let low = heights.fold(f64::INFINITY, f64::min);
        match self.synthesis.cam.follower {
            Follower::TranslatingCam { .. } => low.min(0.0),
            _ => low - 0.04 * self.reach,
        }
    }

    /// Copy of a curve. If the profile is closed, the first point of the curve is repeated at its end.
    fn whole(&self, mut curve: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
        if !self.is_straight() && self.synthesis.cam.law.is_closed() && !curve.is_empty() {
            curve.push(curve[0]);
        }
        curve
    }

    /// Draws the centre mark and the direction of rotation.
    fn centre(&self, plane: &Plane) -> Drawn {
        if self.is_straight() {
            return Ok(());
        }
        let arm = 0.07 * self.reach;
        for path in [[(-arm, 0.0), (arm, 0.0)], [(0.0, -arm), (0.0, arm)]] {
            trace(plane, path, stroke(INK, 1.4))?;
        }
        dot(plane, (0.0, 0.0), INK)?;
        // The arrow is counter-clockwise for a positive speed. It is drawn in the direction of the centroid of the profile.
        let r = (0.45 * self.base.min(self.reach)).max(0.22 * self.reach);
        let middle = self.bulk().unwrap_or(0.7);
        let sense = if self.synthesis.problem.drive.speed < 0.0 {
            -1.0
        } else {
            1.0
        };
        let (from, to) = (middle - 1.05 * sense, middle + 1.05 * sense);
        let arc: Vec<(f64, f64)> = (0..=60)
            .map(|i| {
                let a = from + (to - from) * f64::from(i) / 60.0;
                (r * libm::cos(a), r * libm::sin(a))
            })
            .collect();
        trace(plane, arc, stroke(INK, 2.0))?;
        let head = 0.16 * r;
        let tip = to + sense * head / r;
        let corner = |rho: f64, a: f64| (rho * libm::cos(a), rho * libm::sin(a));
        let arrow = [
            corner(r, tip),
            corner(r + 0.5 * head, to - 0.3 * sense * head / r),
            corner(r - 0.5 * head, to - 0.3 * sense * head / r),
        ];
        fill(plane, &arrow, INK)
    }

    /// Direction from the cam centre to the centroid of the profile points, rad; `None` if the cam is nearly circular about its centre.
    fn bulk(&self) -> Option<f64> {
        let n = self.rows.len().max(1) as f64;
        let (x, y) = self
            .rows
            .iter()
            .fold((0.0, 0.0), |(x, y), p| (x + MM * p.x / n, y + MM * p.y / n));
        let [x, y] = turned([x, y], self.start);
        (libm::hypot(x, y) > 0.1 * self.reach).then(|| libm::atan2(y, x))
    }
}

fn circle(radius: f64) -> Vec<(f64, f64)> {
    (0..=240)
        .map(|i| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(i) / 240.0);
            (radius * cos, radius * sin)
        })
        .collect()
}

fn dashed(plane: &Plane, path: Vec<(f64, f64)>, colour: RGBAColor, [on, off]: [f64; 2]) -> Drawn {
    plane.draw(&DashedPathElement::new(
        path,
        units(on),
        units(off),
        stroke(colour, 1.6),
    ))
}

/// Draws a part of the follower as an opaque area with an outline. `edge` is the width of the outline, points.
fn part(plane: &Plane, outline: Vec<(f64, f64)>, edge: f64) -> Drawn {
    fill(plane, &outline, PAPER)?;
    fill(plane, &outline, AXIS.mix(0.35))?;
    trace(plane, outline, stroke(INK, edge))
}

fn dot(plane: &Plane, at: (f64, f64), colour: RGBAColor) -> Drawn {
    plane.draw(&Circle::new(at, units(4.0), colour.filled()))
}
