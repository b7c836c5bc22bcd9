//! Violations of limits by a law. The points of maximum violation are computed exactly, from roots of derivatives of the limits.

use super::pieces::{Curve, Pieces};
use super::{Limit, PEAK, Program, Row, Values};
use crate::Names;
use crate::basis::{Basis, Entries, WIDEST, add};
use crate::poly::{Peak, PiecewisePoly, SplineSpace, bernstein};

impl<N: Names> Program<N> {
    /// Local maxima that exceed their limit by more than the tolerance, with the indices of the limits.
    pub fn broken(&self, x: &[f64], extra: &Values) -> Vec<(usize, Peak)> {
        self.peaks_near(x, extra, -self.settings.tolerance)
    }

    /// Maximum excess over a limit, relative to the scale of the limit. The result is 0 if all limits are satisfied.
    pub fn violation(&self, x: &[f64], extra: &Values) -> f64 {
        let of_means = self.rms.iter().map(|limit| limit.excess(x));
        let of_limits = self.worst(&self.peaks_near(x, extra, 0.0), x, extra);
        of_means.fold(of_limits.max(0.0), f64::max)
    }

    /// Local maxima of the left sides of limits that exceed the bound, or are below the bound by less than `near` times the scale.
    pub fn peaks_near(&self, x: &[f64], extra: &Values, near: f64) -> Vec<(usize, Peak)> {
        let mut out = Vec::new();
        let level = |limit: &Limit<N>| {
            let bound = self.room(limit, x, extra);
            bound - near * limit.size(bound)
        };
        self.each_peak_above(x, level, |index, peak| out.push((index, peak)));
        out
    }

    /// Selects the given local maxima that exceed their limit by more than the tolerance.
    pub fn broken_among(
        &self,
        peaks: &[(usize, Peak)],
        x: &[f64],
        extra: &Values,
    ) -> Vec<(usize, Peak)> {
        let broken = peaks.iter().filter(|(index, peak)| {
            let limit = &self.limits[*index];
            let bound = self.room(limit, x, extra);
            peak.value > bound + self.settings.tolerance * limit.size(bound)
        });
        broken.copied().collect()
    }

    /// Maximum excess of the given local maxima and of the permanent rows, relative to the scale of the limits.
    pub fn worst(&self, peaks: &[(usize, Peak)], x: &[f64], extra: &Values) -> f64 {
        let excess = peaks.iter().map(|(index, peak)| {
            let limit = &self.limits[*index];
            let bound = self.room(limit, x, extra);
            (peak.value - bound) / limit.size(bound)
        });
        excess.fold(self.excess_of_rows(x, extra), f64::max)
    }

    /// Maximum excess of the permanent rows that have a scale, relative to this scale.
    pub fn excess_of_rows(&self, x: &[f64], extra: &Values) -> f64 {
        let rows = self.fixed.iter().filter(|row| row.scale > 0.0);
        rows.map(|row| -row.slack(x, extra) / row.scale)
            .fold(0.0, f64::max)
    }

    /// Value of the peak variable, raised to the actual peak of the law. An excess over the peak then increases the objective and the
    /// duality gap, and is not a violation.
    pub fn own_peak(&self, x: &[f64], extra: &Values) -> f64 {
        let mut raised = 0.0_f64;
        if self.limits.iter().any(Limit::is_peak) {
            let level = |limit: &Limit<N>| match limit.is_peak() {
                true => self.room(limit, x, extra),
                false => f64::INFINITY,
            };
            self.each_peak_above(x, level, |index, peak| {
                let limit = &self.limits[index];
                let excess = peak.value - self.room(limit, x, extra);
                raised = raised.max(excess / limit.extra[PEAK].abs());
            });
        }
        extra[PEAK] + raised
    }

    /// Calls `visit` for each local maximum of the left side of a limit that is above `level` for this limit. The limits are processed in
    /// order.
    pub fn each_peak_above(
        &self,
        x: &[f64],
        level: impl Fn(&Limit<N>) -> f64,
        mut visit: impl FnMut(usize, Peak),
    ) {
        if self.limits.is_empty() {
            return;
        }
        let (mut pieces, mut room) = (None, Curve::default());
        for (index, limit) in self.limits.iter().enumerate() {
            let level = level(limit);
            if let Some(space) = self.spline_of(limit) {
                let pieces = pieces.get_or_insert_with(|| self.pieces(space, x));
                pieces.peaks_above(space, limit, level, &mut room, |peak| visit(index, peak));
                continue;
            }
            let curve = self.left_side(x, limit);
            for mut peak in curve.peaks_above(level, limit.domain.0, limit.domain.1) {
                // A shape subdivides the curve, so the position is converted to the pieces of the basis.
                (peak.piece, peak.u) = self.basis.locate(peak.at);
                visit(index, peak);
            }
        }
    }

    /// Spline space of the law if the left side of a limit can be evaluated on its spans. `None` for harmonics, for a limit with a shape
    /// and for high degrees.
    fn spline_of(&self, limit: &Limit<N>) -> Option<&SplineSpace> {
        match &self.basis {
            Basis::Spline { space, .. } => {
                (limit.shape.is_none() && space.degree() < WIDEST).then_some(space)
            }
            Basis::Harmonic { .. } => None,
        }
    }

    fn pieces(&self, space: &SplineSpace, x: &[f64]) -> Pieces {
        let highest = self.limits.iter().map(Limit::highest_order).max();
        let highest = highest.unwrap_or(0);
        Pieces::new(space, x, highest)
    }

    /// Row of the limit with the index `index` at the point `peak`.
    pub fn row(&self, index: usize, peak: Peak) -> Row<N> {
        let limit = &self.limits[index];
        let by_piece = matches!(self.basis, Basis::Spline { .. });
        let mut entries = if by_piece {
            self.basis.row_on(peak.piece, peak.u, &limit.weights)
        } else {
            self.basis.row(peak.at, &limit.weights)
        };
        let reference = self
            .reference_of(limit)
            .map_or_else(Entries::new, |lowest| {
                let weight = -limit.weights[0];
                lowest.iter().map(|&(i, b)| (i, weight * b)).collect()
            });
        reference.iter().for_each(|&entry| add(&mut entries, entry));
        let shape = limit.shape.map_or(0.0, |i| self.shapes[i].eval(peak.at));
        Row {
            limit: Some(index),
            name: limit.name,
            peak,
            weights: limit.weights,
            entries,
            reference,
            extra: limit.extra,
            bound: limit.bound + shape,
            scale: if limit.has_room { limit.scale } else { 0.0 },
            multiplier: 0.0,
        }
    }

    /// Rows at both ends and the middle of every piece, for limits with a variable bound.
    pub fn seed_rows(&self, rows: &mut Vec<Row<N>>) {
        let variable = |l: &Limit<N>| !l.extra.is_none();
        let breaks = self.basis.breaks();
        for (index, limit) in self.limits.iter().enumerate().filter(|(_, l)| variable(l)) {
            for (piece, ends) in breaks.windows(2).enumerate() {
                for u in [0.0, 0.5, 1.0] {
                    let at = ends[0] + u * (ends[1] - ends[0]);
                    if limit.covers(at) {
                        rows.push(self.row(index, Peak::place(piece, u, at)));
                    }
                }
            }
        }
    }

    /// Adds rows at ends and middles of pieces where the unlimited law violates a limit. Many of these rows become active, and additional
    /// rows need less time than additional iterations.
    pub fn add_neighbours(&self, rows: &mut Vec<Row<N>>, x: &[f64]) {
        let (mut pieces, mut curve) = (None, Curve::default());
        for (index, limit) in self.limits.iter().enumerate() {
            let Some(space) = self.spline_of(limit) else {
                continue;
            };
            let pieces = pieces.get_or_insert_with(|| self.pieces(space, x));
            let room = self.room(limit, x, &Values::NONE);
            pieces.each_above(space, limit, room, &mut curve, |curve, piece| {
                let span = &space.spans()[piece];
                let mut room_for_one = [0.0; WIDEST];
                let b = curve.on(piece, &mut room_for_one);
                for (u, value) in [
                    (0.0, b[0]),
                    (0.5, bernstein::eval(b, 0.5)),
                    (1.0, b[b.len() - 1]),
                ] {
                    let at = span.start + u * span.width;
                    if value > room && limit.covers(at) {
                        rows.push(self.row(index, Peak::place(piece, u, at)));
                    }
                }
            });
        }
    }

    /// Left side of a limit minus its shape, over the whole law.
    fn left_side(&self, x: &[f64], limit: &Limit<N>) -> PiecewisePoly {
        let mut curve = self.basis.combination(x, &limit.weights);
        if let Some(shape) = limit.shape.map(|i| &self.shapes[i]) {
            let own = curve.cut_at(shape.breaks());
            curve =
                PiecewisePoly::combine(&[(1.0, &own), (-1.0, &shape.cut_at(own.breaks()))], 0.0);
        }
        curve
    }
}
