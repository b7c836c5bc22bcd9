//! Distance between a piecewise polynomial and cubic cells. The difference is computed on one part at a time.

use super::{Cells, restricted};
use crate::poly::{PiecewisePoly, bernstein};

/// Distance, in cells, below which a break coincides with the end of a cell.
const SAME: f64 = 1e-9;
/// A function exceeds the larger of its absolute end values on an interval by at most this factor × maximum absolute second derivative ×
/// width².
const BEYOND_ENDS: f64 = 1.0 / 8.0;

/// Distance between two functions over their common range, exact up to rounding errors.
///
/// ```
/// use splineqp::poly::{Cells, Distance, PiecewisePoly};
///
/// // Level at 0, 1 and 2 with the values 0, 1 and 0, against the constant 0.
/// let cells = Cells::new(vec![0.0, 1.0, 0.0], vec![0.0; 3], 2.0);
/// let zero = PiecewisePoly::new(vec![0.0, 2.0], 3, vec![0.0; 4]);
/// let Distance { largest, .. } = cells.distance(&zero);
/// assert!((largest - 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Integral of the squared difference of the two functions.
    pub square: f64,
    /// Maximum absolute difference of the two functions.
    pub largest: f64,
}

/// A range within one cell and one piece. The ends are in units of cells.
struct Part {
    piece: usize,
    from: f64,
    to: f64,
}

impl Cells {
    /// Distance between the cells and a piecewise polynomial on the first period.
    pub fn distance(&self, own: &PiecewisePoly) -> Distance {
        Distance {
            square: self.square_distance(own),
            largest: self.largest_distance(own),
        }
    }

    /// Integral of the squared difference between the cells and a piecewise polynomial.
    pub fn square_distance(&self, own: &PiecewisePoly) -> f64 {
        let mut difference = Difference::new(self, own);
        let gram = bernstein::gram(own.degree().max(3));
        let square = |part: Part| {
            let width = (part.to - part.from) / self.per_length();
            width * bernstein::square(&gram, difference.on(&part))
        };
        self.parts(own).map(square).sum()
    }

    /// Maximum absolute difference. The second derivative bounds the excess over the values at the ends of a cell. The exact maximum is
    /// therefore computed on a few cells only.
    pub fn largest_distance(&self, own: &PiecewisePoly) -> f64 {
        let scale = self.per_length();
        let mut level = 0.0_f64;
        // Parts, each with an upper bound of the absolute difference on it.
        let mut bounds: Vec<(f64, Part)> = Vec::with_capacity(self.count() + own.pieces());
        for (piece, ends) in own.breaks().windows(2).enumerate() {
            let (start, end) = (ends[0] * scale, ends[1] * scale);
            let coefficients = own.piece(piece);
            let bend = second_derivative(coefficients) / ((end - start) * (end - start));
            let value = |x: f64| bernstein::eval(coefficients, (x - start) / (end - start));
            let mut before = (value(start) - self.at_place(start)).abs();
            for part in parts_of(piece, (start, end)) {
                let after = (value(part.to) - self.at_place(part.to)).abs();
                level = level.max(before).max(after);
                let bent = self.bend(self.cell(0.5 * (part.from + part.to)));
                let width = part.to - part.from;
                let beyond = BEYOND_ENDS * (bend + bent) * width * width;
                bounds.push((before.max(after) + beyond, part));
                before = after;
            }
        }
        let mut difference = Difference::new(self, own);
        for (bound, part) in bounds {
            if bound > level {
                level = largest(difference.on(&part), level);
            }
        }
        level
    }

    /// Ranges on which both functions are a single polynomial.
    fn parts(&self, own: &PiecewisePoly) -> impl Iterator<Item = Part> {
        let scale = self.per_length();
        let pieces = own.breaks().windows(2).enumerate();
        pieces.flat_map(move |(piece, ends)| parts_of(piece, (ends[0] * scale, ends[1] * scale)))
    }

    /// Maximum absolute second derivative on a cell, in units of cells.
    fn bend(&self, cell: usize) -> f64 {
        let [f0, s0, f1, s1] = self.ends(cell);
        let rise = 3.0 * (f1 - f0);
        2.0 * (rise - 2.0 * s0 - s1)
            .abs()
            .max((s0 + 2.0 * s1 - rise).abs())
    }
}

/// Parts of one piece between the ends of cells. All positions are in units of cells.
fn parts_of(piece: usize, (start, end): (f64, f64)) -> impl Iterator<Item = Part> {
    let mut from = start;
    std::iter::from_fn(move || {
        let next = (from + SAME).floor() + 1.0;
        let to = if next < end - SAME { next } else { end };
        let part = (from < end).then_some(Part { piece, from, to });
        from = to;
        part
    })
}

/// Difference of a polynomial and cells, in Bernstein form.
struct Difference<'a> {
    cells: &'a Cells,
    own: &'a PiecewisePoly,
    values: Vec<f64>,
    cubic: Vec<f64>,
}

impl<'a> Difference<'a> {
    fn new(cells: &'a Cells, own: &'a PiecewisePoly) -> Self {
        let zeros = vec![0.0; own.degree().max(3) + 1];
        Difference {
            cells,
            own,
            values: zeros.clone(),
            cubic: zeros,
        }
    }

    /// Bernstein coefficients of the difference on a part of a piece.
    fn on(&mut self, part: &Part) -> &mut [f64] {
        let (own, scale) = (self.own, self.cells.per_length());
        let ends = &own.breaks()[part.piece..part.piece + 2];
        let (start, end) = (ends[0] * scale, ends[1] * scale);
        let place = |x: f64| (x - start) / (end - start);
        let range = (place(part.from), place(part.to));
        restricted(own.piece(part.piece), range, &mut self.values);
        let cell = self.cells.cell(0.5 * (part.from + part.to));
        let base = cell as f64;
        let range = (part.from - base, part.to - base);
        restricted(&self.cells.cubic(cell), range, &mut self.cubic);
        let values = self.values.iter_mut().zip(&self.cubic);
        values.for_each(|(own, cubic)| *own -= cubic);
        &mut self.values
    }
}

/// Upper bound of the absolute second derivative on [0, 1], from the Bernstein coefficients.
fn second_derivative(b: &[f64]) -> f64 {
    let n = (b.len() - 1) as f64;
    let bends = b.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs());
    n * (n - 1.0) * bends.fold(0.0, f64::max)
}

/// Maximum absolute value on [0, 1] if it is above `level`, otherwise `level`.
fn largest(b: &mut [f64], mut level: f64) -> f64 {
    for _ in 0..2 {
        if b.iter().any(|b| *b > level) {
            let above = level;
            bernstein::peaks_above(b, above, |_, value| level = level.max(value));
        }
        b.iter_mut().for_each(|b| *b = -*b);
    }
    level
}
