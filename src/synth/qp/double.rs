//! Numbers of twice the digits, for laws of many spans.
//!
//! A value and what its rounding left over, about 32 digits together: sums after Knuth (two-sum), products after
//! Dekker (1971) with the factors split, because not every processor multiplies and adds in one rounding.

use super::frame;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the banded factorisation asks of its numbers.
pub trait Number:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Rounding of the numbers, relative.
    const EPSILON: f64;

    /// A number that needs no more digits.
    fn of(value: f64) -> Self;

    /// The nearest number of usual digits.
    fn rounded(self) -> f64;

    /// The square root of a positive number.
    fn root(self) -> Self;

    /// The product of two numbers of usual digits.
    fn product(a: f64, b: f64) -> Self;

    /// Inner product.
    fn dot(a: &[Self], b: &[Self]) -> Self {
        let products = a.iter().zip(b).map(|(&a, &b)| a * b);
        products.fold(Self::of(0.0), |sum, product| sum + product)
    }
}

impl Number for f64 {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn of(value: f64) -> Self {
        value
    }

    #[inline]
    fn rounded(self) -> f64 {
        self
    }

    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn product(a: f64, b: f64) -> Self {
        a * b
    }

    fn dot(a: &[f64], b: &[f64]) -> f64 {
        frame::dot(a, b)
    }
}

/// high + low, |low| at most half a rounding of high.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// a + b where |a| ≥ |b|.
    fn ordered(a: f64, b: f64) -> Double {
        let high = a + b;
        Double {
            high,
            low: b - (high - a),
        }
    }

    fn sum(a: f64, b: f64) -> Double {
        let high = a + b;
        let of_b = high - a;
        Double {
            high,
            low: (a - (high - of_b)) + (b - of_b),
        }
    }
}

/// Halves of a number's digits, whose products are exact.
fn split(a: f64) -> (f64, f64) {
    // 2²⁷ + 1 (Dekker).
    let c = 134_217_729.0 * a;
    let high = c - (c - a);
    (high, a - high)
}

impl Add for Double {
    type Output = Double;

    fn add(self, other: Double) -> Double {
        let sum = Double::sum(self.high, other.high);
        Double::ordered(sum.high, sum.low + (self.low + other.low))
    }
}

impl Neg for Double {
    type Output = Double;

    fn neg(self) -> Double {
        Double {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Double {
    type Output = Double;

    fn sub(self, other: Double) -> Double {
        self + -other
    }
}

impl Mul for Double {
    type Output = Double;

    fn mul(self, other: Double) -> Double {
        let whole = Double::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Double::ordered(whole.high, whole.low + cross)
    }
}

impl Div for Double {
    type Output = Double;

    fn div(self, other: Double) -> Double {
        let first = self.high / other.high;
        let left = self - other * Double::of(first);
        let second = left.high / other.high;
        let left = left - other * Double::of(second);
        Double::ordered(first, second) + Double::of(left.high / other.high)
    }
}

impl Number for Double {
    // 2⁻¹⁰⁴.
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;

    fn of(value: f64) -> Double {
        Double {
            high: value,
            low: 0.0,
        }
    }

    fn rounded(self) -> f64 {
        self.high + self.low
    }

    fn root(self) -> Double {
        let first = self.high.sqrt();
        let left = self - Double::product(first, first);
        Double::ordered(first, 0.5 * left.high / first)
    }

    fn product(a: f64, b: f64) -> Double {
        let high = a * b;
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        Double {
            high,
            low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1/3 three times, √2 squared, and a difference that usual digits lose.
    #[test]
    fn thirty_digits_are_kept() {
        let one = Double::of(1.0);
        let third = one / Double::of(3.0);
        assert!((third + third + third - one).rounded().abs() < 1e-31);
        let root = Double::of(2.0).root();
        assert!((root * root - Double::of(2.0)).rounded().abs() < 1e-31);
        let tiny = 1e-25;
        assert!(((one + Double::of(tiny)) - one).rounded() / tiny - 1.0 < 1e-6);
        // (1 + ε)² = 1 + 2ε + ε², ε = 2⁻⁴⁰: the square is exact in two parts.
        let e = 2.0_f64.powi(-40);
        let square = Double::product(1.0 + e, 1.0 + e);
        assert_eq!((square - one - Double::of(2.0 * e)).rounded(), e * e);
    }
}
