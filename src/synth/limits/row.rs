//! Rows of a convex program, as the limits write them.

use crate::cam::Criterion;
use crate::synth::qp::{Limit, Meaning};

/// Relative rounding of a limit that the program holds: twice its own tolerance.
pub const SLACK: f64 = 2.0 * crate::synth::qp::TOLERANCE;
/// A sized quantity (prime circle by bisection or root) may miss its limit by this part: rounding of the
/// geometry, not of the law.
pub const GEOMETRY: f64 = 1e-8;

/// Σ weights·svaj ≤ bound, a violation counted as a part of `scale`.
pub fn row(
    name: impl Into<Criterion>,
    weights: [f64; 5],
    bound: f64,
    scale: f64,
    meaning: Meaning,
) -> Limit {
    Limit {
        meaning,
        ..Limit::new(name, weights, bound, scale)
    }
}

/// The same counted in its own bound, or in a typical lift where that is 0.
pub fn own_scale(bound: f64, length: f64) -> f64 {
    if bound == 0.0 { length } else { bound.abs() }
}

/// A weight on one derivative.
pub fn only(order: usize, weight: f64) -> [f64; 5] {
    let mut weights = [0.0; 5];
    weights[order] = weight;
    weights
}

/// The scene's value is the bound times a factor.
pub fn same(factor: f64) -> Meaning {
    Meaning::Value {
        factor,
        offset: 0.0,
    }
}

/// A derivative within a range of the given width, from 0 on or from where a variable says.
pub fn range(
    name: impl Into<Criterion>,
    order: usize,
    width: f64,
    length: f64,
    window: Option<usize>,
) -> Vec<Limit> {
    let name = name.into();
    let mut top = row(
        name,
        only(order, 1.0),
        width,
        own_scale(width, length),
        same(1.0),
    );
    let Some(variable) = window else {
        return vec![top];
    };
    top.extra[variable] = -1.0;
    let mut bottom = row(name, only(order, -1.0), 0.0, width, Meaning::Structure);
    bottom.extra[variable] = 1.0;
    vec![top, bottom]
}
