//! Linearisation of the non-convex limits about a law.

use super::at_size::AtSize;
use super::trial::ROOM;
use crate::cam::{Criterion, LimitKind};
use crate::law::Law;
use crate::poly::{Peak, PiecewisePoly};
use crate::synth::limits::{NonconvexLimits, ProfileSize, relative};
use crate::synth::qp::{Limit, OFFSET, Program, RADIUS, RISE, Row, Solution, Values};

/// Number of grid intervals per span of the law. The limits are linearised at the ends of these intervals.
const ROWS_PER_PIECE: usize = 4;
/// Clearance h, relative to the largest term of h, above which no row is added for a point. The line search checks such points.
const FAR: f64 = 0.6;
/// Clearance h/w below which the limits are also linearised at the minima of h.
const NEAR: f64 = 0.05;
/// Distance, relative to the span, below which two points coincide.
const COINCIDENT: f64 = 1e-6;
/// Relative distance of a limited quantity from its bound, below which a convex limit may become active in the next step.
const SOON: f64 = 0.03;
/// Maximum violation, relative to w, for which the margin of a limit is increased.
pub const NEARLY: f64 = 1e-3;

/// Margins h/w that the linearised limits keep, one for each limit.
pub struct Room {
    /// Minimum margin, common to all limits.
    level: f64,
    each: Vec<f64>,
}

impl Room {
    pub fn above(level: f64) -> Room {
        Room {
            level,
            each: Vec::new(),
        }
    }

    fn of(&self, limit: usize) -> f64 {
        let least = self.level + 2.0 * ROOM;
        self.each.get(limit).map_or(least, |own| own.max(least))
    }

    /// Increases the margin of each slightly violated limit by twice its violation, because minima of h move between iterations. Margins of
    /// satisfied limits are unchanged.
    pub fn widen(&mut self, clear: &[f64]) {
        self.each.resize(clear.len(), f64::NEG_INFINITY);
        for (own, clear) in self.each.iter_mut().zip(clear) {
            let missed = self.level - clear;
            if missed > 0.0 && missed < NEARLY {
                *own = own.max(self.level + 2.0 * missed);
            }
        }
    }
}

/// Smallest of several clearances h/w; infinite for an empty list.
pub fn least_of(clear: &[f64]) -> f64 {
    clear.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Initial rows of the next program: the active rows of the last solution, and the maxima of limits near their bounds.
pub fn contacts(program: &Program, solution: &Solution) -> Vec<Row> {
    let mut out = program.seeds_of(&solution.active);
    let soon = |limit: &Limit| {
        let room = program.room(limit, &solution.x, &solution.extra);
        room - SOON * limit.size(room)
    };
    program.each_peak_above(&solution.x, soon, |index, peak| {
        let known = |r: &Row| r.limit == Some(index) && r.peak.piece == peak.piece;
        if !out.iter().any(known) {
            out.push(program.row(index, peak));
        }
    });
    out
}

/// Fixed rows of the program, followed by the linearised limits h₀ + ∇h·step ≥ margin·w at the points where h can become zero in one step.
pub fn linearised(
    program: &Program,
    current: &Solution,
    at_size: &AtSize,
    room: &Room,
) -> Vec<Row> {
    let law = Law::of(&program.basis, &current.x);
    let limits = &at_size.of(current);
    let (size, free) = (limits.size(), at_size.free());
    let mut out = program.fixed.clone();
    for place in places(program, current, &law, limits) {
        let at = law.svaj_on(place.piece, place.u);
        for (k, s) in limits.slacks(at, place.at).into_iter().enumerate() {
            if s.h > FAR * s.largest {
                continue;
            }
            // Σ −∂h·x ≤ h₀ − Σ ∂h·x₀, with a margin for the check.
            let mut bound = s.h
                - room.of(k) * s.w
                - s.by_lift * at.s
                - s.by_velocity * at.v
                - s.by_acceleration * at.a
                - s.by_jerk * at.j;
            let mut extra = Values::NONE;
            let by_size = [
                (RISE, s.by_rise, size.rise),
                (OFFSET, s.by_offset, size.offset),
                (RADIUS, s.by_radius, size.radius),
            ];
            for (which, by, own) in by_size.into_iter().filter(|x| free[x.0] && x.1 != 0.0) {
                extra[which] = -by;
                bound -= by * own;
            }
            let weights = [-s.by_lift, -s.by_velocity, -s.by_acceleration, -s.by_jerk];
            out.push(row(program, s.name, place, &weights, extra, bound, s.w));
        }
    }
    out
}

/// Points at which the limits are linearised: a grid, the minima of h between the grid points, and the active points of the last program.
fn places(program: &Program, current: &Solution, law: &Law, limits: &NonconvexLimits) -> Vec<Peak> {
    let mut places = grid(program);
    // The rows of the grid bound h between their points only to second order, so the minima of h also become rows.
    for curve in relative(law, limits) {
        let low = PiecewisePoly::combine(&[(-1.0, &curve)], 0.0).peaks_above(-NEAR, 0.0, f64::MAX);
        places.extend(low.into_iter().map(|dip| {
            let (piece, u) = law.poly().locate(dip.at);
            Peak::place(piece, u, dip.at)
        }));
    }
    // A minimum of h moves from one law to the next. Rows on both sides of an active point bracket the minimum, as in a secant method.
    let touched = current.active.iter().filter(|r| r.limit.is_none());
    for peak in touched.map(|r| r.peak) {
        let near = |p: &Peak| p.piece == peak.piece && (p.u - peak.u).abs() < COINCIDENT;
        if !places.iter().any(near) {
            places.push(peak);
        }
    }
    places
}

/// Points of linearisation that do not depend on the law: a grid over all spans.
fn grid(program: &Program) -> Vec<Peak> {
    let mut out = Vec::new();
    for (piece, ends) in program.basis.breaks().windows(2).enumerate() {
        for k in 0..=ROWS_PER_PIECE {
            let u = k as f64 / ROWS_PER_PIECE as f64;
            out.push(Peak::place(piece, u, ends[0] + u * (ends[1] - ends[0])));
        }
    }
    out
}

/// Row of a program that does not come from one of its limits.
fn row(
    program: &Program,
    name: Criterion,
    peak: Peak,
    weights: &[f64],
    extra: Values,
    bound: f64,
    scale: f64,
) -> Row {
    let mut all = [0.0; 5];
    all[..weights.len()].copy_from_slice(weights);
    let entries = program.basis.row_on(peak.piece, peak.u, weights);
    Row {
        weights: all,
        extra,
        scale,
        ..Row::of_no_limit(name, peak, entries, bound)
    }
}

/// Rows of the sufficient restriction a + (2X₀/ρ − 1)X − X₀²/ρ ≥ 0 at the points of the grid. The symbols are defined in the module `scp`.
/// X₀ is the value of X for the last law, but at least 4ρ/3, for which the restriction is sufficient.
pub fn restricted(program: &Program, current: &Solution, size: ProfileSize) -> Vec<Row> {
    let present = program.present();
    let law = Law::of(&program.basis, &current.x);
    let sufficient = 4.0 / 3.0 * size.rho;
    let mut out = Vec::new();
    let name = Criterion::from(LimitKind::Curvature);
    for place in grid(program) {
        let at = law.svaj_on(place.piece, place.u);
        let x0 = (size.rise + at.s).max(sufficient);
        let by_x = 2.0 * x0 / size.rho - 1.0;
        let mut bound = -x0 * x0 / size.rho;
        let mut extra = Values::NONE;
        if present[RISE] {
            extra[RISE] = -by_x;
        } else {
            bound += by_x * size.rise;
        }
        let weights = [-by_x, 0.0, -1.0];
        out.push(row(program, name, place, &weights, extra, bound, x0));
        if present[RISE] {
            let mut high_enough = Values::NONE;
            high_enough[RISE] = -1.0;
            out.push(row(
                program,
                name,
                place,
                &[-1.0],
                high_enough,
                -sufficient,
                x0,
            ));
        }
    }
    out
}
