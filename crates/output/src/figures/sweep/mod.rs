//! Figures of many designs: heat map, parallel coordinates, fronts, histograms. The input consists of plain numbers and labels.

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
/// Font size, points.
const LETTERS: f64 = 16.0;

/// A column of a table of designs: label with unit, and values.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Label of the column, such as `limits.stroke, m`.
    pub label: String,
    /// One value per design; non-finite values are not drawn.
    pub values: Vec<f64>,
    /// Names of the values 0, 1, 2 … if the values are words, otherwise empty.
    pub words: Vec<String>,
}

/// Label with a customary unit, and the factor that converts SI values to this unit. `stroke, m` becomes `stroke, mm` with the factor 1000.
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
    /// The column in its customary unit, and the factor that converts SI values to this unit.
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

/// Copies of several columns with values in customary units. The second result is the conversion factor of each column from its SI unit.
fn shown<const N: usize>(all: [&Quantity; N]) -> ([Quantity; N], [f64; N]) {
    let both = all.map(Quantity::shown);
    let factors = both.each_ref().map(|b| b.1);
    (both.map(|b| b.0), factors)
}
