//! Smooth periodic functions, represented by cubics on equal cells, with their least-squares approximations and distances from polynomials.
//!
//! A target force has a thousand cells and a law about ten pieces, so the sums over cells need most of the computing time.

mod distance;
mod nearest;
#[cfg(test)]
mod tests;

pub use distance::Distance;

/// Cubic Hermite spline with the period `length`: a cubic on each of n equal cells.
///
/// ```
/// use splineqp::poly::Cells;
///
/// // Level at 0 and at 1, with values 0 and 1 there.
/// let cells = Cells::new(vec![0.0, 1.0, 0.0], vec![0.0; 3], 2.0);
/// assert!((cells.at(0.5) - 0.5).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// Values at the n + 1 ends of the cells. The last value equals the first one.
    values: Vec<f64>,
    /// Slopes at the ends of the cells, per length of a cell.
    slopes: Vec<f64>,
    length: f64,
}

/// Value and slope at the start of a cell, then value and slope at its end.
type Ends = [f64; 4];

impl Cells {
    /// Creates the function from the values and slopes at the ends of its cells. A slope is the derivative multiplied by the length of one
    /// cell. The first cell begins at 0. The last value equals the first value, so n cells have n + 1 values.
    pub fn new(values: Vec<f64>, slopes: Vec<f64>, length: f64) -> Self {
        Cells {
            values,
            slopes,
            length,
        }
    }

    /// The function multiplied by a factor, plus a constant.
    #[must_use]
    pub fn scaled(&self, factor: f64, constant: f64) -> Cells {
        let values = self.values.iter().map(|f| factor * f + constant);
        let slopes = self.slopes.iter().map(|s| factor * s);
        Cells::new(values.collect(), slopes.collect(), self.length)
    }

    /// Number of cells of the function.
    pub fn count(&self) -> usize {
        self.values.len() - 1
    }

    /// Bernstein coefficients of the cubic on a cell.
    pub fn cubic(&self, cell: usize) -> [f64; 4] {
        by_ends(self.ends(cell))
    }

    /// Value at a position in the first period.
    pub fn at(&self, x: f64) -> f64 {
        self.at_place(x * self.per_length())
    }

    /// Values at positions u ∈ [0, 1] of a range (start, width) in the first period. `places` contains pairs of a position u and a
    /// quadrature weight. The weights are not used.
    pub fn on(&self, (start, width): (f64, f64), places: &[(f64, f64)], out: &mut [f64]) {
        let (first, step) = (start * self.per_length(), width * self.per_length());
        for (f, (u, _)) in out.iter_mut().zip(places) {
            *f = self.at_place(first + u * step);
        }
    }

    /// Mean over the period of the squared difference from a constant.
    pub fn mean_square_from(&self, level: f64) -> f64 {
        // Mean of y² over the cells, with y = f − level. A cell has the value y and the slope s at its start, y′ and s′ at its end.
        let square = |cell: usize| {
            let [f0, s0, f1, s1] = self.ends(cell);
            let (y0, y1) = (f0 - level, f1 - level);
            y0 * (312.0 * y0 + 108.0 * y1 - 26.0 * s1) + s0 * (8.0 * s0 + 26.0 * y1 - 6.0 * s1)
        };
        let sum: f64 = (0..self.count()).map(square).sum();
        sum / (420 * self.count()) as f64
    }

    /// Number of cells per unit of length.
    fn per_length(&self) -> f64 {
        self.count() as f64 / self.length
    }

    /// Index of the cell at a position. The position is in units of cells.
    fn cell(&self, place: f64) -> usize {
        (place as u32 as usize).min(self.count() - 1)
    }

    fn ends(&self, cell: usize) -> Ends {
        let (f, s) = (&self.values, &self.slopes);
        [f[cell], s[cell], f[cell + 1], s[cell + 1]]
    }

    /// Value at a position in units of cells.
    fn at_place(&self, place: f64) -> f64 {
        let i = self.cell(place);
        cubic(&self.cubic(i), place - i as f64)
    }
}

/// Bernstein coefficients of a cubic from value and slope at its start and at its end.
pub fn by_ends([f0, s0, f1, s1]: Ends) -> [f64; 4] {
    const THIRD: f64 = 1.0 / 3.0;
    [f0, f0 + THIRD * s0, f1 - THIRD * s1, f1]
}

/// Value at u of a cubic in Bernstein form.
fn cubic([a, b, c, d]: &[f64; 4], u: f64) -> f64 {
    let v = 1.0 - u;
    v * v * (v * a + 3.0 * u * b) + u * u * (3.0 * v * c + u * d)
}

/// Bernstein coefficients of a polynomial restricted to the interval from `low` to `high`. The length of `out` determines the degree of the
/// result.
fn restricted(b: &[f64], (low, high): (f64, f64), out: &mut [f64]) {
    let own = b.len() - 1;
    let c = &mut out[..=own];
    c.copy_from_slice(b);
    if high < 1.0 {
        for k in 1..=own {
            for i in (k..=own).rev() {
                c[i] += (1.0 - high) * (c[i - 1] - c[i]);
            }
        }
    }
    if low > 0.0 {
        let u = low / high.min(1.0);
        for k in 1..=own {
            for i in 0..=own - k {
                c[i] += u * (c[i + 1] - c[i]);
            }
        }
    }
    for m in own + 1..out.len() {
        out[m] = out[m - 1];
        for i in (1..m).rev() {
            let t = i as f64 / m as f64;
            out[i] = t * out[i - 1] + (1.0 - t) * out[i];
        }
    }
}
