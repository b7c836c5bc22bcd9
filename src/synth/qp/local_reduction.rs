//! All contacts moved at once: Newton's method on the places where the law touches its limits.
//!
//! At a contact the limit's left side c(θ) = a(θ)ᵀx has a local maximum equal to the bound. When x moves by
//! dx the maximum moves by dθ = −a′ᵀdx/c″, and the objective along the moving contacts gains the curvature
//! Σ λ (a′ᵀdx)²/(−c″) (local reduction of a semi-infinite program, Hettich and Kortanek 1993). Each step is
//! therefore the equality-constrained optimum with H + Σ λ/(−c″) a′a′ᵀ, still banded, and violations
//! square from step to step where an exchange of rows only quarters them.

use super::active_set::ActiveSet;
use super::basis::{Basis, apply};
use super::equality::Unlimited;
use super::program::{EXTRAS, Limit, Program, Row, Solution};
use crate::poly::Peak;

/// Improves a law whose contacts are nearly right; `level` is where an open level is pinned.
///
/// Returns `None` where contacts are not of the simple kind or a limit is broken at a place that was none.
pub fn refine(
    program: &Program,
    unlimited: &Unlimited,
    start: &Solution,
    level: f64,
) -> Option<Solution> {
    let Basis::Spline { .. } = program.basis else {
        return None;
    };
    let settings = &program.settings.local_reduction;
    let mut current = start.clone();
    for _ in 0..settings.steps {
        let rows = gathered(program, &current);
        let mut hessian = unlimited.hessian.clone();
        for row in &rows {
            stiffen(program, &current.x, row, &mut hessian);
        }
        let factor = hessian.factor()?;
        let mut set = ActiveSet::about(program, unlimited, &factor, level);
        if !(rows.iter().enumerate()).all(|(i, row)| set.hold(i, row)) {
            return None;
        }
        set.refresh();
        if set.weakest() < -settings.negative_multiplier {
            return None;
        }
        let mut next = set.solution(program, &rows, start.rounds);
        next.iterations = current.iterations + 1;
        current = next;
        if current.violation <= program.settings.tolerance {
            // A row moved to where its contact went takes the curvature's part of the gradient along.
            current.active = gathered(program, &current);
            return Some(current);
        }
        if current.violation > settings.divergence * start.violation {
            return None;
        }
    }
    None
}

/// Active rows brought to the exact local maxima beside them; rows that share one are one contact.
fn gathered(program: &Program, solution: &Solution) -> Vec<Row> {
    let extra = [0.0; EXTRAS];
    let mut peaks: Vec<(usize, Peak)> = Vec::new();
    let near = |l: &Limit| {
        let bound = program.room(l, &solution.x, &extra);
        bound - program.settings.local_reduction.below * l.scale.max(bound.abs())
    };
    program.each_peak_above(&solution.x, near, |index, peak| peaks.push((index, peak)));
    let mut out: Vec<Row> = Vec::new();
    for row in &solution.active {
        let width = program.width(row.peak.piece);
        let nearest = row.limit.and_then(|limit| {
            peaks
                .iter()
                .filter(|(index, peak)| *index == limit && (peak.at - row.peak.at).abs() < width)
                .min_by(|a, b| {
                    let distance = |p: &Peak| (p.at - row.peak.at).abs();
                    distance(&a.1).total_cmp(&distance(&b.1))
                })
        });
        let moved = match nearest {
            // On an arc that lies on its bound there is no highest place: a row there stays.
            Some(&(limit, peak))
                if sharpness(program, &solution.x, &program.limits[limit], &peak).is_some() =>
            {
                Row {
                    multiplier: row.multiplier,
                    ..program.row(limit, peak)
                }
            }
            _ => row.clone(),
        };
        let same = |r: &&mut Row| {
            r.limit == moved.limit
                && r.limit.is_some()
                && (r.peak.at - moved.peak.at).abs() < 1e-9 * width
        };
        match out.iter_mut().find(same) {
            Some(twin) => twin.multiplier += moved.multiplier,
            None => out.push(moved),
        }
    }
    out
}

/// How fast a limit's left side falls away from a maximum inside a piece: −c″; `None` on arcs that lie on
/// their bound, at ends of pieces, and where the limit is not a sum of the first derivatives.
fn sharpness(program: &Program, x: &[f64], limit: &Limit, peak: &Peak) -> Option<f64> {
    let inside = peak.u > 0.0 && peak.u < 1.0;
    let w = limit.weights;
    if !inside || w[4] != 0.0 || limit.shape.is_some() {
        return None;
    }
    let twice = [0.0, 0.0, w[0], w[1], w[2], w[3]];
    let falls = -apply(&program.basis.row_on(peak.piece, peak.u, &twice), x);
    let width = program.width(peak.piece);
    let flat = program.settings.local_reduction.flat;
    (falls * width * width > flat * limit.scale.max(limit.bound.abs())).then_some(falls)
}

/// Adds λ/(−c″) a′a′ᵀ for a contact inside its piece.
fn stiffen(program: &Program, x: &[f64], row: &Row, hessian: &mut super::band::ArrowMatrix) {
    let Some(limit) = row.limit.map(|i| &program.limits[i]) else {
        return;
    };
    let Some(falls) = sharpness(program, x, limit, &row.peak) else {
        return;
    };
    let w = limit.weights;
    let once = [0.0, w[0], w[1], w[2], w[3]];
    let slope = program.basis.row_on(row.peak.piece, row.peak.u, &once);
    let weight = row.multiplier / falls;
    for (p, &(i, a)) in slope.iter().enumerate() {
        for &(j, b) in &slope[..=p] {
            hessian.add(i, j, weight * a * b);
        }
    }
}
