//! Pictures of many designs: heat map, parallel coordinates, fronts, histograms. Plain numbers in.

mod axes;
mod front;
mod heat_map;
mod histogram;
mod parallel;

pub use front::front;
pub use heat_map::{Best, heat_map};
pub use histogram::histogram;
pub use parallel::parallel;

use crate::plot::sheet::Frame;

/// Size of the pictures, points.
const SIZE: (u32, u32) = (1100, 720);
/// Lettering, points.
const LETTERS: f64 = 16.0;

/// A column with its name and unit for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// `limits.stroke, m`.
    pub label: String,
    /// One value per design; those that are not finite are left out of the picture.
    pub values: Vec<f64>,
    /// Names of the values 0, 1, 2 … where they are words.
    pub words: Vec<String>,
}

/// SI units of labels with the ones that people use and the factor between them.
const SHOWN: [(&str, &str, f64); 6] = [
    ("m", "mm", 1e3),
    ("m/rad", "mm/rad", 1e3),
    ("m/rad²", "mm/rad²", 1e3),
    ("m/rad³", "mm/rad³", 1e3),
    ("rad", "°", 180.0 / std::f64::consts::PI),
    ("Pa", "MPa", 1e-6),
];

/// A label in the unit that people use, and SI's factor to it: `stroke, m` is read as `stroke, mm`.
pub fn unit_for_people(label: &str) -> (String, f64) {
    let known = label.rsplit_once(", ").and_then(|(name, unit)| {
        let row = SHOWN.iter().find(|row| row.0 == unit)?;
        Some((name, row))
    });
    match known {
        Some((name, (_, unit, factor))) => (format!("{name}, {unit}"), *factor),
        None => (label.to_string(), 1.0),
    }
}

impl Quantity {
    /// The same in the unit that people use, and the factor to it.
    fn shown(&self) -> (Quantity, f64) {
        let (label, factor) = unit_for_people(&self.label);
        let shown = Quantity {
            label,
            values: self.values.iter().map(|v| factor * v).collect(),
            words: self.words.clone(),
        };
        (shown, factor)
    }
}

fn frame(right_room: f64) -> Frame {
    Frame {
        left: 7.6 * LETTERS,
        right: f64::from(SIZE.0) - right_room,
        top: 4.2 * LETTERS,
        bottom: f64::from(SIZE.1) - 4.6 * LETTERS,
    }
}

/// Several quantities in the units that people use, with the factors to them.
fn shown<const N: usize>(all: [&Quantity; N]) -> ([Quantity; N], [f64; N]) {
    let both = all.map(Quantity::shown);
    let factors = both.each_ref().map(|b| b.1);
    (both.map(|b| b.0), factors)
}
