//! Polynomial family: one polynomial through all points, with dwells before the first and after the last point.

use std::f64::consts::TAU;

use super::solved::SolvedLaw;
use crate::error::{Placed, Result, SynthError};
use crate::law::{Condition, Law, hermite_birkhoff};
use crate::poly::{PiecewisePoly, bernstein};
use crate::problem::Problem;
use crate::scene::Family;
use crate::synth::optimum::ForcePrice;
use crate::synth::report::method::Method;
use crate::synth::report::parameters::Functions;
use crate::synth::report::solver::{SolverReport, Tier};
use crate::units::Quantity;

/// Difference between first and last lift, relative to the length scale, below which the law counts as closed.
const SAME_LIFT: f64 = 1e-9;

/// Polynomial law of a problem. The monomial coefficients in (θ − θ₀)/β are used only for output. θ₀ is the angle of the first point, and β
/// the angle from the first to the last point.
///
/// # Errors
///
/// The conditions do not determine a polynomial of the requested degree, a given force does not determine the lift, or first and last lift
/// differ.
pub fn polynomial_law(problem: &Problem) -> Result<SolvedLaw> {
    let conditions = conditions(problem)?;
    let [start, end] = range(problem)?;
    let fixed = conditions.len() - 1;
    if let Some(degree) = problem.law.degree.filter(|d| *d != fixed) {
        return Err(wrong_degree(fixed, degree).at_key("law.degree"));
    }
    let poly = hermite_birkhoff(&conditions, start, end).map_err(|e| e.at_key("law.point"))?;
    let piece = poly.piece(0).to_vec();
    let (first, last) = (piece[0], piece[fixed]);
    if (first - last).abs() > SAME_LIFT * problem.length() {
        return Err(SynthError::LawOpen {
            rise: Quantity::length(last - first),
        }
        .at_key("law.point"));
    }
    let mut breaks = Vec::new();
    let mut coef = Vec::new();
    if start > 0.0 {
        breaks.push(0.0);
        coef.extend(vec![first; fixed + 1]);
    }
    breaks.extend([start, end]);
    coef.extend(&piece);
    if end < TAU {
        breaks.push(TAU);
        coef.extend(vec![last; fixed + 1]);
    }
    Ok(SolvedLaw {
        law: Law::from_poly(PiecewisePoly::new(breaks, fixed, coef), true),
        family: Family::Polynomial,
        degree: fixed,
        spans: 0,
        functions: Functions::Monomial {
            range: [start, end],
        },
        coefficients: bernstein::to_power(&piece),
        circle: None,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: SolverReport::of(Tier::Equality, Method::Interpolation, 0),
        price: ForcePrice::unlimited(problem),
    })
}

/// Angles of the first and the last point, rad, between which the law is a polynomial.
fn range(problem: &Problem) -> Result<[f64; 2]> {
    let angles = problem.law.points.iter().map(|p| p.angle);
    let start = angles.clone().fold(f64::INFINITY, f64::min);
    let end = angles.fold(f64::NEG_INFINITY, f64::max);
    if !(start >= -1e-9 && end <= TAU + 1e-9 && end > start) {
        return Err(SynthError::NoRange {
            start: Quantity::angle(start),
            end: Quantity::angle(end),
        }
        .at_key("law.point"));
    }
    Ok([start.max(0.0), end.min(TAU)])
}

/// Error for a number of conditions that does not correspond to the requested degree.
fn wrong_degree(fixed: usize, degree: usize) -> SynthError {
    let conditions = fixed + 1;
    if degree < fixed {
        SynthError::DegreeTooLow {
            conditions,
            fixed,
            degree,
            excess: fixed - degree,
        }
    } else {
        SynthError::DegreeTooHigh {
            conditions,
            fixed,
            degree,
            missing: degree - fixed,
        }
    }
}

fn conditions(problem: &Problem) -> Result<Vec<Condition>> {
    let mut out = Vec::new();
    for (i, p) in problem.law.points.iter().enumerate() {
        let lift = match (p.lift, p.force) {
            (Some(lift), _) => Some(lift),
            (None, Some(force)) => Some(problem.lift_of_force(force).ok_or_else(|| {
                SynthError::ForceGivesNoLift.at_key(&format!("law.point[{}].force", i + 1))
            })?),
            (None, None) => None,
        };
        for (order, value) in [lift, p.velocity, p.acceleration, p.jerk]
            .into_iter()
            .enumerate()
        {
            if let Some(value) = value {
                out.push(Condition {
                    theta: p.angle,
                    order,
                    value,
                });
            }
        }
    }
    if out.is_empty() {
        return Err(SynthError::PointsEmpty.at_key("law.point"));
    }
    Ok(out)
}
