//! Distance between a piecewise polynomial and cells, without building their difference.

use super::{Cells, restricted};
use crate::poly::{PiecewisePoly, bernstein};

/// A break nearer to the end of a cell than this, in cells, counts as that end.
const SAME: f64 = 1e-9;

/// Distance of two functions over their common range, exact up to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Integral of the squared difference.
    pub square: f64,
    /// Largest absolute difference.
    pub largest: f64,
}

impl Cells {
    /// Distance from a piecewise polynomial on the first period.
    pub fn distance(&self, own: &PiecewisePoly) -> Distance {
        let scale = self.per_length();
        let n = own.degree().max(3);
        let gram = bernstein::gram(n);
        let (mut difference, mut cubic) = (vec![0.0; n + 1], vec![0.0; n + 1]);
        let mut out = Distance::default();
        for (piece, ends) in own.breaks().windows(2).enumerate() {
            let (start, end) = (ends[0] * scale, ends[1] * scale);
            let place = |x: f64| (x - start) / (end - start);
            let mut from = start;
            while from < end {
                let next = (from + SAME).floor() + 1.0;
                let to = if next < end - SAME { next } else { end };
                let (cell, range) = (self.cell(0.5 * (from + to)), (place(from), place(to)));
                restricted(own.piece(piece), range, &mut difference);
                let base = cell as f64;
                restricted(&self.cubic(cell), (from - base, to - base), &mut cubic);
                difference.iter_mut().zip(&cubic).for_each(|(d, c)| *d -= c);
                out.square += (to - from) / scale * bernstein::square(&gram, &difference);
                out.largest = largest(&mut difference, out.largest);
                from = to;
            }
        }
        out
    }
}

/// The largest absolute value on [0, 1], if above `level`, else that.
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
