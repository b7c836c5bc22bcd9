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

/// A row of the law's contact with a limit.
struct Contact {
    row: Row,
    /// −c″ there, where the limit's left side has a maximum inside a piece.
    falls: Option<f64>,
}

/// Improves a law whose contacts are nearly right; `peaks` are its maxima near their bounds, `level` is where an open
/// level is pinned.
///
/// Returns `None` where contacts are not of the simple kind or a limit is broken at a place that was none.
pub fn refine(
    program: &Program,
    unlimited: &Unlimited,
    start: &Solution,
    mut peaks: Vec<(usize, Peak)>,
    level: f64,
) -> Option<Solution> {
    let Basis::Spline { .. } = program.basis else {
        return None;
    };
    let settings = &program.settings.local_reduction;
    let none = [0.0; EXTRAS];
    let mut contacts = gathered(program, &start.x, &start.active, &peaks);
    for step in 1..=settings.steps {
        let (x, active) = on_band(program, unlimited, &contacts, level)?;
        peaks = program.peaks_near(&x, &none, settings.below);
        let violation = program.worst(&peaks, &x, &none);
        // A row moved to where its contact went takes the curvature's part of the gradient along.
        contacts = gathered(program, &x, &active, &peaks);
        if violation <= program.settings.tolerance {
            return Some(Solution {
                x,
                extra: none,
                active: contacts.into_iter().map(|c| c.row).collect(),
                used_rows: true,
                iterations: start.iterations + step,
                rounds: start.rounds,
                violation,
            });
        }
        if violation > settings.divergence * start.violation {
            return None;
        }
    }
    None
}

/// The optimum on the contacts and those that push, in the coefficients of the lift.
fn on_band(
    program: &Program,
    unlimited: &Unlimited,
    contacts: &[Contact],
    level: f64,
) -> Option<(Vec<f64>, Vec<Row>)> {
    let mut hessian = unlimited.hessian.clone();
    for (slope, weight) in contacts.iter().filter_map(|c| stiff(program, c)) {
        for (p, &(i, a)) in slope.entries.iter().enumerate() {
            for &(j, b) in &slope.entries[..=p] {
                hessian.add(i, j, weight * a * b);
            }
        }
    }
    let factor = hessian.factor()?;
    let mut set = ActiveSet::about(program, unlimited, &factor, level);
    let mut rows = contacts.iter().map(|c| &c.row).enumerate();
    if !rows.all(|(i, row)| set.hold(i, row)) {
        return None;
    }
    set.refresh();
    let negative = program.settings.local_reduction.negative_multiplier;
    let active = set.pushing(|i| &contacts[i].row);
    (set.weakest() >= -negative).then_some((set.x, active))
}

/// Active rows brought to the exact local maxima beside them; rows that share one are one contact.
fn gathered(program: &Program, x: &[f64], active: &[Row], peaks: &[(usize, Peak)]) -> Vec<Contact> {
    let mut out: Vec<Contact> = Vec::with_capacity(active.len());
    for row in active {
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
        let fallen = |peak: &Peak| sharpness(program, x, &program.limits[row.limit?], peak);
        let falls = nearest.and_then(|(_, peak)| fallen(peak));
        let moved = match nearest {
            Some(&(limit, peak)) if falls.is_some() => Contact {
                row: Row {
                    multiplier: row.multiplier,
                    ..program.row(limit, peak)
                },
                falls,
            },
            // On an arc that lies on its bound there is no highest place: a row there stays.
            _ => Contact {
                row: row.clone(),
                falls: fallen(&row.peak),
            },
        };
        let same = |c: &&mut Contact| {
            c.row.limit == moved.row.limit
                && c.row.limit.is_some()
                && (c.row.peak.at - moved.row.peak.at).abs() < 1e-9 * width
        };
        match out.iter_mut().find(same) {
            Some(twin) => twin.row.multiplier += moved.row.multiplier,
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

/// a′ and λ/(−c″) of a contact inside its piece.
fn stiff(program: &Program, contact: &Contact) -> Option<(Row, f64)> {
    let (row, falls) = (&contact.row, contact.falls?);
    let [s, v, a, j, _] = row.weights;
    let once = [0.0, s, v, a, j];
    let slope = Row {
        entries: program.basis.row_on(row.peak.piece, row.peak.u, &once),
        weights: once,
        bound: 0.0,
        scale: 0.0,
        ..row.clone()
    };
    Some((slope, row.multiplier / falls))
}
