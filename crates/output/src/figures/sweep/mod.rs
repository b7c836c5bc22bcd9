//! Figures of many designs: heat map, parallel coordinates, fronts, histograms. The input is plain numbers.

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
use gaitcam::wording::people;

/// Size of the figures, points.
const SIZE: (u32, u32) = (1100, 720);
/// Size of the lettering, points.
const LETTERS: f64 = 16.0;

/// A column with its displayed name and unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Label of the column, such as `limits.stroke, m`.
    pub label: String,
    /// One value per design; non-finite values are not drawn.
    pub values: Vec<f64>,
    /// Names of the values 0, 1, 2 … if they are words.
    pub words: Vec<String>,
}

/// Label with the common unit, and the factor from SI: `stroke, m` becomes `stroke, mm`.
pub fn unit_for_people(label: &str) -> (String, f64) {
    match label.rsplit_once(", ") {
        Some((name, unit)) => {
            let si = unit.replace('²', "^2").replace('³', "^3");
            match people(&si) {
                (same, _) if same == si => (label.to_string(), 1.0),
                (shown, factor) => (format!("{name}, {shown}"), factor),
            }
        }
        None => (label.to_string(), 1.0),
    }
}

impl Quantity {
    /// The column in its common unit, and the factor to it.
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

/// Several columns in common units, with the factors to them.
fn shown<const N: usize>(all: [&Quantity; N]) -> ([Quantity; N], [f64; N]) {
    let both = all.map(Quantity::shown);
    let factors = both.each_ref().map(|b| b.1);
    (both.map(|b| b.0), factors)
}
