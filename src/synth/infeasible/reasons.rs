//! Conflicts and suggested changes as reasons for the verdict, with values in displayed units.

use crate::cam::{Criterion, Measures};
use crate::synth::report::limited::Relaxation;
use crate::synth::report::named::unit;
use crate::synth::report::reason::{Change, Reason, quantity};
use crate::wording::{Language, exact};

/// Reason that names the limits in conflict: one limit that is infeasible alone, or several limits.
pub fn conflicting(conflict: &[Criterion]) -> Reason {
    let mut limits = conflict.to_vec();
    match limits.pop() {
        Some(limit) if limits.is_empty() => Reason::LimitInfeasible { limit },
        Some(last) => {
            limits.push(last);
            Reason::LimitsInfeasible { limits }
        }
        None => Reason::DemandsInfeasible {
            demands: Vec::new(),
        },
    }
}

/// Suggested changes with values and units. Relaxations without a sufficient value are omitted.
pub fn changes(relaxations: &[Relaxation], measures: Measures) -> Vec<Change> {
    let change = |r: &Relaxation| {
        Some(Change::Change {
            key: r.key,
            limit: r.limit,
            from: quantity(measures, r.limit, r.from),
            to: quantity(measures, r.limit, r.to?),
        })
    };
    relaxations.iter().filter_map(change).collect()
}

/// Reason that lists the suggested changes, or states that no single change is sufficient.
pub fn smallest_relaxations(relaxations: &[Relaxation], measures: Measures) -> Reason {
    let changes = changes(relaxations, measures);
    match changes.len() {
        0 => Reason::NoRelaxation,
        1 => Reason::Relaxation { changes },
        _ => Reason::Relaxations { changes },
    }
}

/// Value of a limit in its displayed unit, for a cam with this kind of motion (`measures`). The text has enough digits to be entered again in
/// a scene.
pub fn in_units(measures: Measures, limit: Criterion, value: f64, language: Language) -> String {
    let unit = unit(measures, limit);
    let value = unit.factor * value;
    // A value that differs from zero only by rounding errors is zero.
    let value = if value.abs() < 1e-9 { 0.0 } else { value };
    unit.after(&exact(language, value))
}
