//! Where a law breaks its limits: exact worst points, from the roots of the limits' own derivatives.

use super::basis::{Basis, Entries, add};
use super::program::{EXTRAS, Limit, Meaning, Program, Row};
use crate::law::Law;
use crate::poly::{Peak, PiecewisePoly, SplineSpace, bernstein};

/// Coefficients of one piece; more than the highest degree of a spline in a scene.
const WIDEST: usize = 12;

impl Program {
    /// Exact worst points at which a limit is exceeded by more than the tolerance.
    pub fn broken(&self, x: &[f64], extra: &[f64; EXTRAS]) -> Vec<(usize, Peak)> {
        let mut out = Vec::new();
        let allowed = |limit: &Limit| {
            let bound = self.room(limit, x, extra);
            bound + self.settings.tolerance * limit.size(bound)
        };
        self.each_peak_above(x, allowed, |index, peak| out.push((index, peak)));
        out
    }

    /// Largest excess over any limit, relative to its scale; 0 when all hold.
    pub fn violation(&self, x: &[f64], extra: &[f64; EXTRAS]) -> f64 {
        let mut worst = 0.0_f64;
        self.each_peak_above(
            x,
            |limit| self.room(limit, x, extra),
            |index, peak| {
                let limit = &self.limits[index];
                let bound = self.room(limit, x, extra);
                worst = worst.max((peak.value - bound) / limit.size(bound));
            },
        );
        worst
    }

    /// Visits every local maximum of every limit's left side above its level, limit by limit.
    pub fn each_peak_above(
        &self,
        x: &[f64],
        level: impl Fn(&Limit) -> f64,
        mut visit: impl FnMut(usize, Peak),
    ) {
        if self.limits.is_empty() {
            return;
        }
        let mut law: Option<Law> = None;
        let mut splines = None;
        let highest = self.limits.iter().map(Limit::highest_order).max();
        for (index, limit) in self.limits.iter().enumerate() {
            let level = level(limit);
            if let (Basis::Spline { space, .. }, None) = (&self.basis, limit.shape)
                && space.degree() < WIDEST
            {
                let pieces =
                    splines.get_or_insert_with(|| Pieces::new(space, x, highest.unwrap_or(0)));
                pieces.peaks_above(space, limit, level, |peak| visit(index, peak));
                continue;
            }
            let law = law.get_or_insert_with(|| self.basis.law(x));
            let curve = self.curve(law, limit);
            for mut peak in curve.peaks_above(level, limit.domain.0, limit.domain.1) {
                // A shape cuts the curve finer than the basis: places are told in the basis' pieces.
                if let Basis::Spline { space, .. } = &self.basis {
                    (peak.piece, peak.u) = space.locate(peak.at);
                }
                visit(index, peak);
            }
        }
    }

    /// The row of a limit at a place.
    pub fn row(&self, index: usize, peak: Peak) -> Row {
        let limit = &self.limits[index];
        let by_piece = matches!(self.basis, Basis::Spline { .. });
        let mut entries = if by_piece {
            self.basis.row_on(peak.piece, peak.u, &limit.weights)
        } else {
            self.basis.row(peak.at, &limit.weights)
        };
        let touching = self.reference(limit).map_or_else(Entries::new, |lowest| {
            let weight = -limit.weights[0];
            lowest.iter().map(|&(i, b)| (i, weight * b)).collect()
        });
        touching.iter().for_each(|&entry| add(&mut entries, entry));
        let shape = limit.shape.map_or(0.0, |i| self.shapes[i].eval(peak.at));
        Row {
            limit: Some(index),
            name: limit.name,
            peak,
            weights: limit.weights,
            entries,
            touching,
            extra: limit.extra,
            bound: limit.bound + shape,
            // A law at rest lies on the base circle and on the edge of steadiness: no room can be kept there.
            scale: if limit.meaning == Meaning::Structure {
                0.0
            } else {
                limit.scale
            },
            multiplier: 0.0,
        }
    }

    /// Rows at both ends and the middle of every piece, for limits whose bound is itself a variable.
    pub fn seed_rows(&self, rows: &mut Vec<Row>) {
        let variable = |l: &Limit| l.extra.iter().any(|e| *e != 0.0);
        let breaks = self.basis.breaks();
        for (index, limit) in self.limits.iter().enumerate().filter(|(_, l)| variable(l)) {
            ends_and_middles(&breaks, limit, |peak| rows.push(self.row(index, peak)));
        }
    }

    /// Ends and middles of pieces where the law without limits breaks one: many of them touch in the end,
    /// and rows are cheaper than rounds.
    pub fn add_neighbours(&self, rows: &mut Vec<Row>, x: &[f64]) {
        let law = self.basis.law(x);
        let breaks = self.basis.breaks();
        for (index, limit) in self.limits.iter().enumerate() {
            if limit.shape.is_some() || matches!(self.basis, Basis::Harmonic { .. }) {
                continue;
            }
            ends_and_middles(&breaks, limit, |peak| {
                let [s, v, a, j, _] = limit.weights;
                let value = law.weighed_on(peak.piece, peak.u, [s, v, a, j]);
                if value > self.room(limit, x, &[0.0; EXTRAS]) {
                    rows.push(self.row(index, peak));
                }
            });
        }
    }

    /// Starts and middles of all pieces, for laws of many spans: what is not written down there escapes as a
    /// spike into the next piece, round after round.
    pub fn add_everywhere(&self, rows: &mut Vec<Row>) {
        let breaks = self.basis.breaks();
        for (index, limit) in self.limits.iter().enumerate() {
            ends_and_middles(&breaks, limit, |peak| {
                if peak.u < 1.0 {
                    rows.push(self.row(index, peak));
                }
            });
        }
    }

    /// Left side of a limit less its shape, over the whole law.
    fn curve(&self, law: &Law, limit: &Limit) -> PiecewisePoly {
        let w = limit.weights;
        let mut curve = law.combination([w[0], w[1], w[2], w[3]], 0.0);
        if w[4] != 0.0 {
            let snap = law.combination([0.0, 0.0, 0.0, 1.0], 0.0).derivative();
            curve = PiecewisePoly::combine(&[(1.0, &curve), (w[4], &snap)], 0.0);
        }
        if let Some(shape) = limit.shape.map(|i| &self.shapes[i]) {
            let own = curve.cut_at(shape.breaks());
            curve =
                PiecewisePoly::combine(&[(1.0, &own), (-1.0, &shape.cut_at(own.breaks()))], 0.0);
        }
        curve
    }
}

fn ends_and_middles(breaks: &[f64], limit: &Limit, mut visit: impl FnMut(Peak)) {
    for piece in 0..breaks.len() - 1 {
        for u in [0.0, 0.5, 1.0] {
            let at = breaks[piece] + u * (breaks[piece + 1] - breaks[piece]);
            if at >= limit.domain.0 && at <= limit.domain.1 {
                visit(Peak {
                    piece,
                    u,
                    at,
                    value: 0.0,
                });
            }
        }
    }
}

/// Bernstein coefficients of s, v, a, j and the fourth derivative on every span, up to the highest that is asked for.
struct Pieces {
    by_order: [Vec<f64>; 5],
}

impl Pieces {
    fn new(space: &SplineSpace, x: &[f64], highest: usize) -> Self {
        let spans = space.spans();
        let degree = space.degree();
        let n = degree + 1;
        let mut by_order: [Vec<f64>; 5] = std::array::from_fn(|k| {
            let each = if k > highest {
                0
            } else {
                n.saturating_sub(k).max(1)
            };
            Vec::with_capacity(spans.len() * each)
        });
        let mut local = [0.0; WIDEST];
        let mut b = [0.0; WIDEST];
        for (i, span) in spans.iter().enumerate() {
            let e = space.extraction(i);
            for (k, value) in local[..n].iter_mut().enumerate() {
                *value = x[space.index(i, k)];
            }
            for (k, value) in b[..n].iter_mut().enumerate() {
                let row = &e[k * n..(k + 1) * n];
                *value = row.iter().zip(&local).map(|(e, c)| e * c).sum();
            }
            by_order[0].extend_from_slice(&b[..n]);
            for (order, out) in by_order.iter_mut().enumerate().take(highest + 1).skip(1) {
                if order > degree {
                    out.push(0.0);
                    continue;
                }
                let factor = (degree + 1 - order) as f64 / span.width;
                for k in 0..n - order {
                    b[k] = factor * (b[k + 1] - b[k]);
                }
                out.extend_from_slice(&b[..n - order]);
            }
        }
        Pieces { by_order }
    }

    /// Visits the local maxima of a limit's left side above `level` within its domain.
    fn peaks_above(
        &self,
        space: &SplineSpace,
        limit: &Limit,
        level: f64,
        mut visit: impl FnMut(Peak),
    ) {
        let curve = self.left_side(space, limit);
        let n = curve.len() / space.spans().len();
        let on = |piece: usize| &curve[piece * n..(piece + 1) * n];
        for (piece, span) in space.spans().iter().enumerate() {
            let b = on(piece);
            if b.iter().all(|b| *b <= level) {
                continue;
            }
            let from = (limit.domain.0 - span.start) / span.width;
            let to = (limit.domain.1 - span.start) / span.width;
            if from >= 1.0 || to <= 0.0 {
                continue;
            }
            let mut found = |u: f64, value: f64| {
                visit(Peak {
                    piece,
                    u,
                    at: span.start + u * span.width,
                    value,
                });
            };
            if from > 0.0 || to < 1.0 {
                let (from, to) = (from.max(0.0), to.min(1.0));
                let inside = bernstein::between(b, from, to);
                bernstein::peaks_above(&inside, level, |u, value| {
                    found(from + u * (to - from), value);
                });
                continue;
            }
            // Where the curve goes on over a break, its piece's end is a maximum only if the neighbour's is;
            // of two such ends the left one counts.
            let climbs_on = piece + 1 < space.spans().len() && n > 1 && {
                let next = on(piece + 1);
                // A crest on the break itself may seem to climb on, by rounding.
                let flat = bernstein::rounding(next);
                joins(b[n - 1], next[0], level) && next[1] > next[0] + flat
            };
            let came_down = piece > 0 && n > 1 && {
                let last = on(piece - 1);
                joins(last[n - 1], b[0], level)
            };
            bernstein::peaks_above(b, level, |u, value| {
                if !(u == 1.0 && climbs_on || u == 0.0 && came_down) {
                    found(u, value);
                }
            });
        }
    }

    /// Bernstein coefficients of Σ wₖ s⁽ᵏ⁾ on every span, all of one degree.
    fn left_side(&self, space: &SplineSpace, limit: &Limit) -> Vec<f64> {
        let degree = space.degree();
        let lowest = limit.weights.iter().position(|w| *w != 0.0).unwrap_or(0);
        let n = (degree + 1).saturating_sub(lowest).max(1);
        let mut sums = vec![0.0; n * space.spans().len()];
        let mut lifted = [0.0; WIDEST];
        for (order, &weight) in limit.weights.iter().enumerate().skip(lowest) {
            if weight == 0.0 || order > degree {
                continue;
            }
            let own = degree + 1 - order;
            let pieces = self.by_order[order].chunks_exact(own);
            for (sum, piece) in sums.chunks_exact_mut(n).zip(pieces) {
                lifted[..own].copy_from_slice(piece);
                for m in own..n {
                    elevate(&mut lifted, m);
                }
                for (s, l) in sum.iter_mut().zip(&lifted) {
                    *s += weight * l;
                }
            }
        }
        sums
    }
}

/// Whether two values on both sides of a break are one to rounding.
fn joins(left: f64, right: f64, level: f64) -> bool {
    (left - right).abs() <= 1e-12 * left.abs().max(level.abs())
}

/// Writes the `m` Bernstein coefficients at the front of `b` one degree higher.
fn elevate(b: &mut [f64], m: usize) {
    b[m] = b[m - 1];
    for i in (1..m).rev() {
        let t = i as f64 / m as f64;
        b[i] = t * b[i - 1] + (1.0 - t) * b[i];
    }
}
