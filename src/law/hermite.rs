//! Polynomial through boundary conditions of any order at any angles (Hermite–Birkhoff interpolation).
//!
//! The unknowns are Bernstein coefficients on the whole interval, because the matrix for monomials of degree 8 already has a condition number of
//! 1.7e6 (theory §2). Monomial coefficients are used only for output, see [`bernstein::to_power`](crate::poly::bernstein::to_power).

use crate::error::{LawError, Result};
use crate::poly::{PiecewisePoly, bernstein};
use crate::units::Quantity;
use nalgebra::{DMatrix, DVector};

/// A condition on a law at one angle: the derivative of the given order has the given value.
///
/// ```
/// use gaitcam::law::{Condition, hermite_birkhoff};
///
/// // At rest at both ends of a rise of 1: 3x² − 2x³.
/// let condition = |theta, order, value| Condition { theta, order, value };
/// let ends = [condition(0.0, 0, 0.0), condition(0.0, 1, 0.0), condition(1.0, 0, 1.0), condition(1.0, 1, 0.0)];
/// let rise = hermite_birkhoff(&ends, 0.0, 1.0)?;
/// assert!((rise.eval(0.25) - 0.15625).abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Angle at which the condition applies, rad.
    pub theta: f64,
    /// Order of the derivative: 0 = lift, 1 = velocity, 2 = acceleration, 3 = jerk, …
    pub order: usize,
    /// Prescribed value of the derivative, m/radᵒʳᵈᵉʳ.
    pub value: f64,
}

/// Maximum degree of the polynomial. With a higher degree, the rounding errors of the data are amplified too much.
const MAX_DEGREE: usize = 40;
/// Ratio of the minimum to the maximum singular value below which the conditions do not determine the polynomial.
const RANK: f64 = 1e-14;

/// The unique polynomial of degree n − 1 that satisfies n conditions, on [start, end] rad, as a single span. The errors of the conditions are of the
/// size of rounding errors, relative to the largest value of the polynomial.
///
/// ```
/// use gaitcam::law::{Condition, hermite_birkhoff};
///
/// // From rest at 0 to rest at lift 1: 3x² − 2x³.
/// let on = |theta, order, value| Condition { theta, order, value };
/// let conditions = [on(0.0, 0, 0.0), on(0.0, 1, 0.0), on(1.0, 0, 1.0), on(1.0, 1, 0.0)];
/// let cubic = hermite_birkhoff(&conditions, 0.0, 1.0)?;
/// assert!((cubic.eval(0.25) - 0.15625).abs() < 1e-15);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
///
/// - There are no conditions.
/// - An angle is outside the interval.
/// - Two conditions prescribe the same derivative at the same angle.
/// - An order is above the degree.
/// - The conditions do not determine a polynomial, which is possible if orders are skipped.
pub fn hermite_birkhoff(conditions: &[Condition], start: f64, end: f64) -> Result<PiecewisePoly> {
    check(conditions, start, end)?;
    let n = conditions.len();
    let width = end - start;
    // Rows are scaled so that the maximum weight of each derivative is near 1.
    let scales: Vec<f64> = conditions
        .iter()
        .map(|c| (0..c.order).fold(1.0, |f, r| f * width / (n - 1 - r) as f64))
        .collect();
    let derivatives = basis_derivatives(n, conditions.iter().map(|c| c.order).max().unwrap_or(0));
    let matrix = DMatrix::from_fn(n, n, |i, k| {
        let c = &conditions[i];
        let u = (c.theta - start) / width;
        bernstein::eval(&derivatives[c.order][k], u) * scales[i] / width.powi(c.order as i32)
    });
    let values = DVector::from_fn(n, |i, _| conditions[i].value * scales[i]);
    let svd = matrix.clone().svd(false, false);
    if svd.singular_values.min() <= RANK * svd.singular_values.max() {
        return Err(not_fixed(n).into());
    }
    let lu = matrix.clone().full_piv_lu();
    let mut b = lu.solve(&values).ok_or_else(|| not_fixed(n))?;
    // One step of iterative refinement removes the rounding errors of the elimination.
    if let Some(correction) = lu.solve(&(&values - &matrix * &b)) {
        b += correction;
    }
    let coef = b.iter().copied().collect();
    Ok(PiecewisePoly::new(vec![start, end], n - 1, coef))
}

/// Bernstein coefficients of the derivatives of every basis function with respect to u, as `[order][basis function]`.
fn basis_derivatives(n: usize, highest: usize) -> Vec<Vec<Vec<f64>>> {
    let unit = |k: usize| (0..n).map(|i| f64::from(u8::from(i == k))).collect();
    let mut out: Vec<Vec<Vec<f64>>> = vec![(0..n).map(unit).collect()];
    for order in 0..highest {
        let next = out[order].iter().map(|b| bernstein::derivative(b));
        out.push(next.collect());
    }
    out
}

fn check(conditions: &[Condition], start: f64, end: f64) -> Result<()> {
    let n = conditions.len();
    if n == 0 {
        return Err(LawError::NoCondition.into());
    }
    if !(start.is_finite() && end.is_finite() && start < end) {
        return Err(LawError::Interval { start, end }.into());
    }
    if n > MAX_DEGREE + 1 {
        return Err(LawError::ManyConditions {
            conditions: n,
            degree: n - 1,
            most: MAX_DEGREE + 1,
        }
        .into());
    }
    // Angles converted from degrees may differ from the ends by rounding errors.
    let slack = 1e-9 * (end - start);
    for (i, c) in conditions.iter().enumerate() {
        let condition = i + 1;
        if !c.theta.is_finite() || !c.value.is_finite() {
            return Err(LawError::ConditionNotFinite { condition }.into());
        }
        if c.theta < start - slack || c.theta > end + slack {
            return Err(LawError::ConditionOutside {
                condition,
                at: Quantity::angle(c.theta),
                start: Quantity::angle(start),
                end: Quantity::angle(end),
            }
            .into());
        }
        if c.order >= n {
            return Err(LawError::ConditionOrder {
                condition,
                order: c.order,
                degree: n - 1,
            }
            .into());
        }
        let twin = conditions[..i]
            .iter()
            .position(|d| d.order == c.order && (d.theta - c.theta).abs() <= slack);
        if let Some(j) = twin {
            return Err(LawError::ConditionTwice {
                first: j + 1,
                second: condition,
                order: c.order,
                at: Quantity::angle(c.theta),
            }
            .into());
        }
    }
    Ok(())
}

fn not_fixed(n: usize) -> LawError {
    LawError::NotFixed {
        conditions: n,
        degree: n - 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(theta: f64, order: usize, value: f64) -> Condition {
        Condition {
            theta,
            order,
            value,
        }
    }

    #[test]
    fn rest_to_rest_conditions_give_3_4_5() {
        let mut conditions = vec![on(2.0, 0, 5.0), on(3.5, 0, 6.0)];
        for order in 1..3 {
            conditions.extend([on(2.0, order, 0.0), on(3.5, order, 0.0)]);
        }
        let p = hermite_birkhoff(&conditions, 2.0, 3.5).unwrap();
        let power = bernstein::to_power(p.piece(0));
        for (c, e) in power.iter().zip([5.0, 0.0, 0.0, 10.0, -15.0, 6.0]) {
            assert!((c - e).abs() < 1e-12);
        }
    }

    #[test]
    fn a_polynomial_of_degree_thirty_meets_its_conditions() {
        // sin on [0, 6]: values and slopes at 15 points and one second derivative.
        let mut conditions = Vec::new();
        for i in 0..15 {
            let x = 3.0 - 3.0 * (std::f64::consts::PI * f64::from(i) / 14.0).cos();
            conditions.extend([on(x, 0, x.sin()), on(x, 1, x.cos())]);
        }
        conditions.push(on(0.0, 2, 0.0));
        let p = hermite_birkhoff(&conditions, 0.0, 6.0).unwrap();
        for i in 0..=100 {
            let x = 0.06 * f64::from(i);
            assert!((p.eval(x) - x.sin()).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn sets_that_fix_no_polynomial_are_refused() {
        let code = |c: &[Condition]| hermite_birkhoff(c, 0.0, 1.0).unwrap_err().code();
        assert_eq!(code(&[]), "law-no-condition");
        assert_eq!(code(&[on(0.0, 1, 1.0), on(1.0, 1, 0.0)]), "law-not-fixed");
        // Birkhoff's example: s at both ends and v at the middle do not determine a parabola.
        let middle = [on(0.0, 0, 0.0), on(0.5, 1, 1.0), on(1.0, 0, 0.0)];
        assert_eq!(code(&middle), "law-not-fixed");
        let twice = [on(0.0, 0, 0.0), on(0.0, 0, 1.0)];
        assert_eq!(code(&twice), "law-condition-twice");
        assert_eq!(code(&[on(2.0, 0, 0.0)]), "law-condition-outside");
        let high = [on(0.0, 2, 0.0), on(0.5, 0, 0.0)];
        assert_eq!(code(&high), "law-condition-order");
        assert_eq!(code(&[on(0.0, 0, f64::NAN)]), "law-condition-not-finite");
    }
}
