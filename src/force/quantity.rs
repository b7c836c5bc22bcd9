//! Quantities of this module, for notes and errors.

use crate::units::{Dimension, Quantity};

pub(super) fn seconds(value: f64) -> Quantity {
    Quantity::time(value)
}

pub(super) fn newtons(value: f64) -> Quantity {
    Quantity::force(value)
}

pub(super) fn hertz(value: f64) -> Quantity {
    Quantity::new(value, Dimension::Frequency)
}

pub(super) fn kilograms(value: f64) -> Quantity {
    Quantity::new(value, Dimension::Mass)
}
