//! Small dense systems that may be singular: Gauss' elimination with both pivots.

/// A pivot below this part of the first belongs to what follows from the rest.
const DEPENDENT: f64 = 1e-13;

/// A symmetric matrix, balanced and eliminated; what is dependent answers zero.
pub struct Eliminated {
    size: usize,
    /// Rows, one after the other: below the diagonal the factors, above it what they leave.
    m: Vec<f64>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Unit of each row and column.
    units: Vec<f64>,
    rank: usize,
}

impl Eliminated {
    pub fn new(mut m: Vec<f64>, size: usize) -> Self {
        let units = balanced(&mut m, size);
        let mut rows: Vec<usize> = (0..size).collect();
        let mut columns = rows.clone();
        let mut first = 0.0;
        let mut rank = 0;
        while rank < size {
            let (mut best, mut at) = (0.0, (rank, rank));
            for i in rank..size {
                for j in rank..size {
                    let value = f64::abs(m[i * size + j]);
                    if value > best {
                        (best, at) = (value, (i, j));
                    }
                }
            }
            if rank == 0 {
                first = best;
            }
            if best <= DEPENDENT * first {
                break;
            }
            for j in 0..size {
                m.swap(rank * size + j, at.0 * size + j);
            }
            for i in 0..size {
                m.swap(i * size + rank, i * size + at.1);
            }
            rows.swap(rank, at.0);
            columns.swap(rank, at.1);
            let pivot = m[rank * size + rank];
            for i in rank + 1..size {
                let by = m[i * size + rank] / pivot;
                m[i * size + rank] = by;
                if by != 0.0 {
                    for j in rank + 1..size {
                        m[i * size + j] -= by * m[rank * size + j];
                    }
                }
            }
            rank += 1;
        }
        Eliminated {
            size,
            m,
            rows,
            columns,
            units,
            rank,
        }
    }

    /// Solves in place.
    pub fn solve(&self, x: &mut [f64]) {
        let n = self.size;
        let mut y: Vec<f64> = self.rows.iter().map(|&i| x[i] * self.units[i]).collect();
        for i in 0..n {
            for k in 0..i.min(self.rank) {
                y[i] -= self.m[i * n + k] * y[k];
            }
        }
        x.fill(0.0);
        for i in (0..self.rank).rev() {
            let row = &self.m[i * n..][..n];
            let known = row[i + 1..self.rank].iter().zip(&y[i + 1..]);
            let sum: f64 = known.map(|(m, y)| m * y).sum();
            y[i] = (y[i] - sum) / row[i];
            x[self.columns[i]] = y[i] * self.units[self.columns[i]];
        }
    }
}

/// Scales rows and columns alike until the largest entry of each is near one; returns their units.
fn balanced(m: &mut [f64], size: usize) -> Vec<f64> {
    let mut units = vec![1.0; size];
    for _ in 0..4 {
        for i in 0..size {
            let largest = m[i * size..][..size]
                .iter()
                .fold(0.0_f64, |a, b| a.max(b.abs()));
            if largest > 0.0 {
                let by = 1.0 / largest.sqrt();
                units[i] *= by;
                for j in 0..size {
                    m[i * size + j] *= by;
                    m[j * size + i] *= by;
                }
            }
        }
    }
    units
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_saddle_of_wide_range_is_solved_and_what_follows_from_it_answers_zero() {
        // x₀ and x₁ under two demands, the second ten times the first.
        let m = vec![
            1e8, 0.0, 1.0, 10.0, //
            0.0, 1e-4, 1.0, 10.0, //
            1.0, 1.0, 0.0, 0.0, //
            10.0, 10.0, 0.0, 0.0,
        ];
        let mut x = vec![0.0, 0.0, 2.0, 20.0];
        Eliminated::new(m, 4).solve(&mut x);
        // Nearest to zero in the weights 1e8 and 1e-4.
        let expected = 2.0 * 1e-4 / (1e8 + 1e-4);
        assert!((x[0] / expected - 1.0).abs() < 1e-12, "{x:?}");
        assert!((x[1] - 2.0).abs() < 1e-11);
    }
}
