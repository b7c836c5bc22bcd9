//! Plan view and side view of a cam with dimensions.

use std::f64::consts::TAU;

use super::layout::{ABOVE, BELOW, BESIDE, LABELS, Layout};
use super::leader;
use super::pen::{Pen, Stroke};
use super::piece::{Piece, bore_edge};
use super::radii::farthest;
use crate::outline::zero_mark;
use crate::words::Labels;

const MM: f64 = 1000.0;
/// Number of points with which the outline of the cam is drawn.
const POINTS: usize = 1440;
/// Minimum half height of a column of labels, mm.
const LEAST_HEIGHT: f64 = 20.0;
/// Horizontal distance between the labels and the circle around the cam, mm.
const OFF: f64 = 5.0;
/// Length by which the centre lines extend beyond the outline, mm.
const OVER: f64 = 4.0;
/// Distance between the side view and the dimension below it, mm.
const UNDER: f64 = 8.0;
/// Angles at which the arrow of rotation begins and ends, measured from the mark of θ = 0, rad.
const ARROW: [f64; 2] = [0.12, 0.5];
/// Number of points on the edge of the bore, without the corners of the keyway.
const EDGE: usize = 180;

/// Positions of the labels. The first number is the side (1 right, −1 left). The second number is the height above the centre, as a
/// fraction of the half height of a column of labels.
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

/// Minimum height above the centre for the label of the keyway, as a fraction of the half height of a column of labels.
const HIGH: f64 = 0.5;

/// Label with the object to which its leader points.
struct Label {
    text: [String; 2],
    /// Target of the leader: a circle about the centre or a point. A circle is given by its radius on the sheet, mm.
    of: Target,
}

enum Target {
    Circle(f64),
    Point([f64; 2]),
    /// A point on the sheet, mm. Its label is at or above the height `HIGH`.
    Below([f64; 2]),
}

/// Plan view and side view of a cam, placed on the sheet.
pub struct Views<'a> {
    piece: &'a Piece<'a>,
    words: &'a Labels,
    /// Position of the cam's centre in the plan view, mm.
    centre: [f64; 2],
    /// Millimetres on the sheet per metre of the cam.
    scale: f64,
    /// Radius on the sheet of the circle that contains the plan view, mm.
    around: f64,
    /// Horizontal position of the left edge of the side view, mm.
    side: f64,
}

impl<'a> Views<'a> {
    /// Places the two views side by side in the middle of their common area.
    pub fn new(piece: &'a Piece<'a>, layout: &Layout, words: &'a Labels) -> Self {
        let scale = MM * layout.scale.factor();
        let around = scale * piece.radius();
        let area = layout.views;
        let wide = 2.0 * (around + LABELS) + scale * piece.thickness + BESIDE;
        let start = area.left + 0.5 * (area.width() - wide);
        let middle = 0.5 * (area.bottom + BELOW + area.top - ABOVE);
        Views {
            piece,
            words,
            centre: [start + LABELS + around, middle],
            scale,
            around,
            side: start + 2.0 * (LABELS + around),
        }
    }

    /// Draws both views with their dimensions.
    pub fn draw(&self, pen: &mut Pen) {
        let points = self.piece.edge.points(POINTS);
        let outline: Vec<[f64; 2]> = points.iter().map(|e| self.place(e.p)).collect();
        self.plan(pen, &outline);
        self.labels(pen);
        self.side_view(pen, &outline);
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [cx, cy] = self.centre;
        [cx + self.scale * x, cy + self.scale * y]
    }

    fn plan(&self, pen: &mut Pen, outline: &[[f64; 2]]) {
        let ([x, y], reach) = (self.centre, self.around + OVER);
        pen.cross(self.centre, reach, Stroke::Centre);
        pen.ring(outline, Stroke::Outline);
        let (base, prime) = (self.piece.base(), self.piece.prime());
        pen.circle(self.centre, self.scale * base, Stroke::Centre);
        if prime > base {
            pen.circle(self.centre, self.scale * prime, Stroke::Centre);
        }
        if let Some(bore) = &self.piece.bore {
            let edge: Vec<[f64; 2]> = (bore_edge(bore, EDGE).into_iter())
                .map(|p| self.place(p))
                .collect();
            pen.ring(&edge, Stroke::Outline);
        }
        let reach_of_bore = self.piece.bore.map_or(0.0, |b| b.reach());
        let mark = zero_mark(base, reach_of_bore).map(|p| self.place(p));
        pen.line(&mark, Stroke::Outline);
        pen.note("θ = 0", [x, y + reach + 2.0]);
        // The arrow is outside the outline, near the mark of θ = 0.
        let radius = self.around + 0.75 * OVER;
        pen.rotation(self.centre, radius, ARROW, self.piece.clockwise);
    }

    fn labels(&self, pen: &mut Pen) {
        let mut free: Vec<[f64; 2]> = SLOTS.to_vec();
        for label in self.labelled() {
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

    /// Index of the free label position that is nearest to the point `p`. Positions below the height `from` are not considered. `from` is a
    /// fraction of the half height of a column of labels.
    fn nearest(&self, free: &[[f64; 2]], p: [f64; 2], from: f64) -> Option<usize> {
        let far = |k: usize| {
            let [x, y] = self.slot(free[k]);
            libm::hypot(x - p[0], y - p[1])
        };
        (0..free.len())
            .filter(|&k| free[k][1] >= from)
            .min_by(|&a, &b| far(a).total_cmp(&far(b)))
    }

    /// Labels for the dimensions of the cam. The label of the maximum radius is the first, because it is placed first.
    fn labelled(&self) -> Vec<Label> {
        let (words, piece) = (self.words, self.piece);
        let mut out = Vec::new();
        let mut add = |text: [String; 2], of: Target| out.push(Label { text, of });
        let named = |key: &str, size: String| [words.text(key), size];
        let angle = |[x, y]: [f64; 2]| libm::atan2(x, y).rem_euclid(TAU).to_degrees();
        let circle = |radius: f64| Target::Circle(self.scale * radius);
        let far = farthest(&piece.edge, 20 * POINTS).p;
        let long = words.length(libm::hypot(far[0], far[1]), 3);
        let at = words.fixed(angle(far), 1);
        let size = format!("R {long}  φ {at}°");
        add(
            named("drawing-largest-radius", size),
            Target::Point(self.place(far)),
        );
        let (base, prime) = (piece.base(), piece.prime());
        let size = |radius: f64| format!("R {}", words.length(radius, 3));
        add(named("drawing-base-circle", size(base)), circle(base));
        if prime > base {
            add(named("drawing-prime-circle", size(prime)), circle(prime));
        }
        if let Some(bore) = &piece.bore {
            add(leader::bore(bore, words), circle(bore.radius()));
            if let Some(key) = bore.keyway {
                let corner = [0.5 * key.width, bore.radius() + key.depth];
                let text = leader::keyway(bore, &key, words);
                add(text, Target::Below(self.place(corner)));
            }
        }
        out
    }

    /// Position of a leader's end on the sheet, mm, for a label position.
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
                let far = libm::hypot(dx, dy);
                [self.centre[0] + r * dx / far, self.centre[1] + r * dy / far]
            }
        };
        pen.label(&label.text, from, end, slot[0]);
    }

    /// Draws the side view of the cam from the right, with the bore as hidden lines.
    fn side_view(&self, pen: &mut Pen, outline: &[[f64; 2]]) {
        let ends = outline
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
                [low.min(p[1]), high.max(p[1])]
            });
        let thick = self.scale * self.piece.thickness;
        let (left, right) = (self.side, self.side + thick);
        pen.frame([left, ends[0]], [right, ends[1]], Stroke::Outline);
        let y = self.centre[1];
        pen.line(&[[left - OVER, y], [right + OVER, y]], Stroke::Centre);
        if let Some(bore) = self.piece.bore {
            let key = bore.keyway.map_or(0.0, |key| key.depth);
            let edges = [-bore.radius(), bore.radius() + key];
            for edge in edges.map(|off| y + self.scale * off) {
                pen.line(&[[left, edge], [right, edge]], Stroke::Hidden);
            }
        }
        let thickness = self.words.length(self.piece.thickness, 2);
        pen.level(&thickness, [left, right], ends[0], ends[0] - UNDER);
    }
}
