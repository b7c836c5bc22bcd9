//! Extreme value of a function, with its position.

use serde::Serialize;

/// An extreme value and its abscissa.
///
/// ```
/// use splineqp::poly::PiecewisePoly;
///
/// // 2x(1 − x) on [0, 1], by its Bernstein coefficients 0, 1, 0.
/// let (low, high) = PiecewisePoly::new(vec![0.0, 1.0], 2, vec![0.0, 1.0, 0.0]).extremes();
/// assert!(low.value == 0.0 && high.value == 0.5 && high.at == 0.5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Extreme {
    /// Abscissa of the extreme, in the units of the function's breaks.
    pub at: f64,
    /// Value of the function at the extreme.
    pub value: f64,
}

impl Extreme {
    /// Applies a function to the value. The abscissa is unchanged.
    pub fn map(self, f: impl FnOnce(f64) -> f64) -> Extreme {
        Extreme {
            at: self.at,
            value: f(self.value),
        }
    }

    /// Maximum absolute value of a function with the given minimum and maximum, and its abscissa.
    pub fn largest((low, high): (Extreme, Extreme)) -> Extreme {
        if high.value >= -low.value {
            high
        } else {
            low.map(|value| -value)
        }
    }
}
