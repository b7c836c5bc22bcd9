//! Newton's method for the active points of a program for the coefficients alone, with the banded factor.
//!
//! At an active point, the left side of the limit c(θ) = a(θ)ᵀx has a local maximum equal to the bound. If x changes by dx, the angle of
//! the maximum changes by dθ = −a′ᵀdx/c″. The curvature of the Lagrangian therefore increases by Σ λ (a′ᵀdx)²/(−c″) (local reduction of a
//! semi-infinite program, Hettich and Kortanek 1993). Each step solves a program with equality constraints at the active points and the
//! matrix H + Σ λ/(−c″) a′a′ᵀ, which is still banded. Violations decrease quadratically. An exchange of rows reduces violations only by a
//! factor of four.

use super::Contacts;
use crate::Names;
use crate::equality::Unlimited;
use crate::poly::Peak;
use crate::program::{Program, Row, Solution, Values};
use crate::solve::active_set::ActiveSet;

/// Improves a law whose active points are nearly exact. The points `peaks` are the local maxima near their bounds. A free level is fixed at
/// `level`. `None` if a step fails or the violation increases too much.
pub fn on_band<N: Names>(
    program: &Program<N>,
    unlimited: &Unlimited,
    start: &Solution<N>,
    mut peaks: Vec<(usize, Peak)>,
    level: f64,
) -> Option<Solution<N>> {
    let settings = &program.settings.refinement;
    let contacts = Contacts::new(program);
    let mut current = start.clone();
    current.active = contacts.gathered(&current, &peaks);
    for _ in 0..settings.band_steps {
        let (x, active) = step(&contacts, unlimited, &current, level)?;
        peaks = program.peaks_near(&x, &Values::NONE, settings.below);
        current.violation = program.worst(&peaks, &x, &Values::NONE);
        (current.x, current.active) = (x, active);
        current.iterations += 1;
        // Each active row is moved to the nearest local maximum. The gradient of the moved row includes the contribution of the curvature.
        current.active = contacts.gathered(&current, &peaks);
        if current.violation <= program.settings.tolerance {
            return Some(current);
        }
        if current.violation > settings.divergence * start.violation {
            return None;
        }
    }
    None
}

/// Optimum with the active rows of `from` as equalities, and the rows with positive multipliers. `None` if rows are dependent or a
/// multiplier is negative.
fn step<N: Names>(
    contacts: &Contacts<N>,
    unlimited: &Unlimited,
    from: &Solution<N>,
    level: f64,
) -> Option<(Vec<f64>, Vec<Row<N>>)> {
    let program = contacts.program;
    let hessian = contacts.with_curvature(unlimited.hessian.clone(), from);
    let factor = hessian.factor()?;
    let mut set = ActiveSet::new(program, unlimited, &factor, level);
    let mut rows = from.active.iter().enumerate();
    if !rows.all(|(i, r)| set.dual.hold(Some(i), &r.entries, r.bound, r.multiplier)) {
        return None;
    }
    set.dual.refresh();
    let multipliers = || set.dual.multipliers().map(|m| m.1);
    let largest = multipliers().fold(0.0_f64, |m, p| m.max(p.abs()));
    let least = multipliers().fold(f64::INFINITY, f64::min);
    let negative = program.settings.refinement.negative_multiplier;
    let active = set.active(&from.active);
    (least >= -negative * largest).then_some((set.dual.x, active))
}
