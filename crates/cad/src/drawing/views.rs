//! Plan and side view of one cam with their dimensions.

use std::f64::consts::TAU;

use gaitcam::cam::{Bore, Keyway};

use super::layout::{ABOVE, Area, BELOW, BESIDE, LABELS, Layout};
use super::leader::{self, LETTERS};
use super::pen::{Anchor, Pen, Stroke};
use super::piece::Piece;
use super::radii::farthest;
use crate::outline::zero_mark;
use crate::words::Words;

const MM: f64 = 1000.0;
/// Points of the outline.
const POINTS: usize = 1440;
/// Least height of the labels' column above and below the centre, mm.
const LEAST_HEIGHT: f64 = 20.0;
/// Distance of labels from the circle around the cam, mm.
const OFF: f64 = 5.0;
/// Length of centre lines beyond the outline, mm.
const OVER: f64 = 4.0;
/// Distance of the side view's dimensions from it, mm: of the first, and of the thickness of a plate with a hub.
const UNDER: f64 = 8.0;
pub const UNDER_HUB: f64 = 16.0;
/// Where the arrow of rotation begins and ends, from the mark of θ = 0, rad.
const ARROW: [f64; 2] = [0.12, 0.5];
/// Points of the bore's edge between its corners.
const EDGE: u32 = 180;

/// Where the labels stand: side, and height as a part of the column's.
const SLOTS: [[f64; 2]; 8] = [
    [1.0, 0.3],
    [-1.0, 0.3],
    [1.0, -0.3],
    [-1.0, -0.3],
    [1.0, 0.8],
    [-1.0, 0.8],
    [1.0, -0.8],
    [-1.0, -0.8],
];

/// Height from which on a place lies above the keyway.
const HIGH: f64 = 0.5;

/// One label with what it points at.
struct Label {
    text: [String; 2],
    /// Circle about the centre that it names, by its radius on the sheet, or a point of the sheet.
    of: Target,
}

enum Target {
    Circle(f64),
    Point([f64; 2]),
    /// A point that is pointed at from above.
    Below([f64; 2]),
}

/// The views on the sheet.
pub struct Views<'a> {
    piece: &'a Piece<'a>,
    words: &'a Words,
    /// The cam's centre in the plan view, mm.
    centre: [f64; 2],
    /// Millimetres on the sheet per metre of the cam.
    scale: f64,
    /// Radius of the circle around everything in the plan view, mm.
    around: f64,
    /// Left edge of the side view.
    side: f64,
}

impl<'a> Views<'a> {
    /// Places both views in the middle of their area.
    pub fn new(piece: &'a Piece<'a>, layout: &Layout, words: &'a Words) -> Self {
        let scale = MM * layout.scale.factor();
        let around = scale * piece.radius();
        let Area {
            left,
            bottom,
            right,
            top,
        } = layout.views;
        let wide = 2.0 * (around + LABELS) + scale * piece.width() + BESIDE;
        let start = left + 0.5 * (right - left - wide);
        let middle = 0.5 * (bottom + BELOW + top - ABOVE);
        Views {
            piece,
            words,
            centre: [start + LABELS + around, middle],
            scale,
            around,
            side: start + 2.0 * (LABELS + around),
        }
    }

    /// Draws them.
    pub fn draw(&self, pen: &mut Pen) {
        let outline: Vec<[f64; 2]> = self
            .piece
            .edge
            .points(POINTS)
            .iter()
            .map(|e| self.place(e.p))
            .collect();
        self.plan(pen, &outline);
        self.labels(pen);
        self.side_view(pen, &outline);
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.centre[0] + self.scale * x,
            self.centre[1] + self.scale * y,
        ]
    }

    fn plan(&self, pen: &mut Pen, outline: &[[f64; 2]]) {
        let ([x, y], reach) = (self.centre, self.around + OVER);
        pen.line(&[[x - reach, y], [x + reach, y]], Stroke::Centre);
        pen.line(&[[x, y - reach], [x, y + reach]], Stroke::Centre);
        pen.ring(outline, Stroke::Outline);
        let (base, prime) = (self.piece.base(), self.piece.prime());
        pen.circle(self.centre, self.scale * base, Stroke::Centre);
        if prime > base {
            pen.circle(self.centre, self.scale * prime, Stroke::Centre);
        }
        if let Some(bore) = &self.piece.bore {
            pen.ring(&self.hole(bore), Stroke::Outline);
        }
        if let Some(hub) = self.piece.hub {
            pen.circle(
                self.centre,
                0.5 * self.scale * hub.diameter,
                Stroke::Outline,
            );
        }
        if let Some(hole) = self.piece.balance {
            let ([x, y], r) = (self.place(hole.centre), 0.5 * self.scale * hole.diameter);
            pen.circle([x, y], r, Stroke::Outline);
            pen.line(&[[x - r - 1.5, y], [x + r + 1.5, y]], Stroke::Thin);
            pen.line(&[[x, y - r - 1.5], [x, y + r + 1.5]], Stroke::Thin);
        }
        let reach_of_bore = self.piece.bore.map_or(0.0, |b| b.reach());
        let mark = zero_mark(base, reach_of_bore).map(|p| self.place(p));
        pen.line(&mark, Stroke::Outline);
        pen.text("θ = 0", [x, y + reach + 2.0], LETTERS, Anchor::Middle);
        self.rotation(pen);
    }

    /// Arrow in the sense of rotation, outside the outline near the mark of θ = 0.
    fn rotation(&self, pen: &mut Pen) {
        let sense = if self.piece.clockwise { -1.0 } else { 1.0 };
        let radius = self.around + 0.75 * OVER;
        let arc: Vec<[f64; 2]> = (0..=24)
            .map(|i| {
                let from_mark = ARROW[0] + (ARROW[1] - ARROW[0]) * f64::from(i) / 24.0;
                let angle = 0.25 * TAU + sense * from_mark;
                [
                    self.centre[0] + radius * angle.cos(),
                    self.centre[1] + radius * angle.sin(),
                ]
            })
            .collect();
        pen.line(&arc, Stroke::Thin);
        let angle = 0.25 * TAU + sense * ARROW[1];
        pen.arrowhead(
            arc[arc.len() - 1],
            [-sense * angle.sin(), sense * angle.cos()],
        );
    }

    fn labels(&self, pen: &mut Pen) {
        let mut free: Vec<[f64; 2]> = SLOTS.to_vec();
        for label in self.wanted() {
            let slot = match label.of {
                Target::Point(p) => self.nearest(&free, p, -1.0),
                Target::Below(p) => self.nearest(&free, p, HIGH),
                Target::Circle(_) => (!free.is_empty()).then_some(0),
            };
            if let Some(slot) = slot {
                let slot = free.remove(slot);
                self.label(pen, &label, slot);
            }
        }
    }

    /// The free place nearest to a point, among those at least at the height `from`, a part of the column's.
    fn nearest(&self, free: &[[f64; 2]], p: [f64; 2], from: f64) -> Option<usize> {
        let far = |k: usize| {
            let [x, y] = self.slot(free[k]);
            (x - p[0]).hypot(y - p[1])
        };
        (0..free.len())
            .filter(|&k| free[k][1] >= from)
            .min_by(|&a, &b| far(a).total_cmp(&far(b)))
    }

    /// Largest radius first: it takes the place nearest to it.
    fn wanted(&self) -> Vec<Label> {
        let words = self.words;
        let radius = |r: f64| words.decimal(format!("R {:.3}", MM * r));
        let far = farthest(&self.piece.edge, 20 * POINTS);
        let angle = far.p[0].atan2(far.p[1]).rem_euclid(TAU).to_degrees();
        let long = words.decimal(format!(
            "R {:.3}  φ {angle:.1}°",
            MM * far.p[0].hypot(far.p[1])
        ));
        let mut out = vec![
            Label {
                text: [words.text("drawing-largest-radius"), long],
                of: Target::Point(self.place(far.p)),
            },
            Label {
                text: [words.text("drawing-base-circle"), radius(self.piece.base())],
                of: Target::Circle(self.scale * self.piece.base()),
            },
        ];
        if self.piece.prime() > self.piece.base() {
            out.push(Label {
                text: [
                    words.text("drawing-prime-circle"),
                    radius(self.piece.prime()),
                ],
                of: Target::Circle(self.scale * self.piece.prime()),
            });
        }
        if let Some(bore) = self.piece.bore {
            let size = words.decimal(format!("Ø {:.3} H7", MM * bore.diameter));
            out.push(Label {
                text: [words.text("drawing-bore"), size],
                of: Target::Circle(self.scale * bore.radius()),
            });
            out.extend(bore.keyway.map(|key| self.keyway(&bore, &key)));
        }
        if let Some(hole) = self.piece.balance {
            let [x, y] = hole.centre;
            let angle = x.atan2(y).rem_euclid(TAU).to_degrees();
            let place = format!(
                "Ø {:.2}  R {:.3}  φ {angle:.2}°",
                MM * hole.diameter,
                MM * x.hypot(y)
            );
            out.push(Label {
                text: [words.text("drawing-balance"), words.decimal(place)],
                of: Target::Point(self.place(hole.centre)),
            });
        }
        if let Some(hub) = self.piece.hub {
            let size = words.decimal(format!("Ø {:.2}", MM * hub.diameter));
            out.push(Label {
                text: [words.text("drawing-hub"), size],
                of: Target::Circle(0.5 * self.scale * hub.diameter),
            });
        }
        out
    }

    /// The keyway: width with the fit of the key's seat, and the bore's height through it, by which it is measured.
    fn keyway(&self, bore: &Bore, key: &Keyway) -> Label {
        let words = self.words;
        let size = words.decimal(format!(
            "{:.1} JS9, {:.2}",
            MM * key.width,
            MM * (bore.diameter + key.depth)
        ));
        let corner = [0.5 * key.width, bore.radius() + key.depth];
        Label {
            text: [words.text("drawing-keyway"), size],
            of: Target::Below(self.place(corner)),
        }
    }

    /// The edge of the bore.
    fn hole(&self, bore: &Bore) -> Vec<[f64; 2]> {
        let mut angles: Vec<f64> = (0..EDGE)
            .map(|i| TAU * f64::from(i) / f64::from(EDGE))
            .collect();
        angles.extend(bore.corners());
        angles.sort_by(f64::total_cmp);
        let at = |a: f64| self.place([bore.edge(a) * a.cos(), bore.edge(a) * a.sin()]);
        angles.into_iter().map(at).collect()
    }

    /// Where a label's leader ends.
    fn slot(&self, [side, part]: [f64; 2]) -> [f64; 2] {
        [
            self.centre[0] + side * (self.around + OFF),
            self.centre[1] + part * self.around.max(LEAST_HEIGHT),
        ]
    }

    fn label(&self, pen: &mut Pen, label: &Label, slot: [f64; 2]) {
        let end = self.slot(slot);
        let from = match label.of {
            Target::Point(p) | Target::Below(p) => p,
            Target::Circle(r) => {
                let [dx, dy] = [end[0] - self.centre[0], end[1] - self.centre[1]];
                let far = dx.hypot(dy);
                [self.centre[0] + r * dx / far, self.centre[1] + r * dy / far]
            }
        };
        leader::label(pen, &label.text, from, end, slot[0]);
    }

    /// The cam from the right, with the bore hidden.
    fn side_view(&self, pen: &mut Pen, outline: &[[f64; 2]]) {
        let ends = outline
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
                [low.min(p[1]), high.max(p[1])]
            });
        let thick = self.scale * self.piece.thickness;
        let (left, right) = (self.side, self.side + thick);
        let far = self.side + self.scale * self.piece.width();
        pen.frame([left, ends[0]], [right, ends[1]], Stroke::Outline);
        let y = self.centre[1];
        pen.line(&[[left - OVER, y], [far + OVER, y]], Stroke::Centre);
        if let Some(bore) = self.piece.bore {
            let key = bore.keyway.map_or(0.0, |key| key.depth);
            let edges = [-bore.radius(), bore.radius() + key];
            for edge in edges.map(|off| y + self.scale * off) {
                pen.line(&[[left, edge], [far, edge]], Stroke::Hidden);
            }
        }
        let text = |x: f64| self.words.decimal(format!("{:.2}", MM * x));
        let thickness = text(self.piece.thickness);
        let below = if self.piece.hub.is_some() {
            UNDER_HUB
        } else {
            UNDER
        };
        leader::level(pen, &thickness, [left, right], ends[0], ends[0] - below);
        if let Some(hub) = self.piece.hub {
            let (half, out) = (0.5 * self.scale * hub.diameter, self.scale * hub.length);
            pen.frame([right, y - half], [right + out, y + half], Stroke::Outline);
            let whole = text(self.piece.thickness + hub.length);
            leader::level(pen, &whole, [left, right + out], ends[0], ends[0] - UNDER);
        }
    }
}
