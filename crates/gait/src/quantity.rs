//! Measured quantities for notes and errors, rounded to four significant digits.

use crate::units::{Dimension, Quantity};

/// Number of significant digits of a measured quantity.
const DIGITS: i32 = 4;

pub(super) fn seconds(value: f64) -> Quantity {
    Quantity::time(rounded(value))
}

pub(super) fn newtons(value: f64) -> Quantity {
    Quantity::force(rounded(value))
}

pub(super) fn hertz(value: f64) -> Quantity {
    Quantity::new(rounded(value), Dimension::Frequency)
}

pub(super) fn kilograms(value: f64) -> Quantity {
    Quantity::new(rounded(value), Dimension::Mass)
}

/// A fraction, displayed as a percentage with two digits.
pub(super) fn share(value: f64) -> Quantity {
    Quantity::share(digits(value, 2))
}

/// Rounds a ratio to three significant digits, because calibrations are not more accurate.
pub(super) fn short(value: f64) -> f64 {
    digits(value, 3)
}

fn rounded(value: f64) -> f64 {
    digits(value, DIGITS)
}

fn digits(value: f64, count: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let places = count - 1 - libm::log10(value.abs()).floor() as i32;
    // After division by a power of ten, the number has a short text. After multiplication by 0.01, it may have a long text.
    if places >= 0 {
        let scale = 10f64.powi(places);
        (value * scale).round() / scale
    } else {
        let scale = 10f64.powi(-places);
        (value / scale).round() * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_are_kept() {
        for (x, wanted) in [
            (109.477, 109.5),
            (1.026_79, 1.027),
            (9.997_78, 9.998),
            (0.018_33, 0.018_33),
        ] {
            assert_eq!(rounded(x), wanted);
        }
        assert_eq!(rounded(123_456.0), 123_500.0);
        assert_eq!(rounded(0.0), 0.0);
    }
}
