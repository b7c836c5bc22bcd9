//! Linear least squares with some non-negative unknowns, and pseudoinverses.

use nalgebra::{DMatrix, DVector};

/// Fraction of the maximum singular value below which a singular value counts as zero. It applies to normalised columns.
const RANK: f64 = 1e-9;

/// One column of the linear model: the effect of one unknown on all data.
#[derive(Debug, Clone)]
pub(super) struct Column {
    pub values: Vec<f64>,
    pub is_positive: bool,
}

/// Least-squares problem with some non-negative unknowns (Lawson and Hanson 1974), with normalised columns.
pub(super) struct Bounded {
    columns: DMatrix<f64>,
    is_positive: Vec<bool>,
    pub scales: Vec<f64>,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl Bounded {
    pub fn new(columns: &[Column]) -> Bounded {
        let size = |c: &Column| dot(&c.values, &c.values).sqrt();
        let scales: Vec<f64> = columns.iter().map(size).collect();
        let rows = columns.first().map_or(0, |c| c.values.len());
        let columns_of = |i: usize, j: usize| columns[j].values[i] / scales[j];
        let matrix = DMatrix::from_fn(rows, columns.len(), columns_of);
        let qr = matrix.clone().qr();
        Bounded {
            is_positive: columns.iter().map(|c| c.is_positive).collect(),
            q: qr.q(),
            r: qr.r(),
            columns: matrix,
            scales,
        }
    }

    pub fn scaled(&self, i: usize) -> Vec<f64> {
        self.columns.column(i).as_slice().to_vec()
    }

    pub fn is_free(&self, values: &[f64], i: usize) -> bool {
        !self.is_positive[i] || values[i] > 0.0
    }

    pub fn model(&self, values: &[f64]) -> Vec<f64> {
        let sum = &self.columns * DVector::from_column_slice(values);
        sum.as_slice().to_vec()
    }

    /// Solves the problem for the data `y`. Returns the unknowns and the residual sum of squares.
    pub fn solve(&self, y: &[f64]) -> (Vec<f64>, f64) {
        let y = DVector::from_column_slice(y);
        let right = self.q.tr_mul(&y);
        let count = self.scales.len();
        let mut passive: Vec<bool> = self.is_positive.iter().map(|p| !p).collect();
        let mut x = self.passive(&right, &passive);
        for _ in 0..4 * count {
            let gradient = self.r.tr_mul(&(&right - &self.r * &x));
            let pulls = (0..count).filter(|i| !passive[*i] && gradient[*i] > RANK * right.norm());
            let Some(next) = pulls.max_by(|a, b| gradient[*a].total_cmp(&gradient[*b])) else {
                break;
            };
            passive[next] = true;
            loop {
                let full = self.passive(&right, &passive);
                let negative = |i: &usize| passive[*i] && self.is_positive[*i] && full[*i] <= 0.0;
                let blocked = (0..count).filter(negative);
                let part = |i: usize| x[i] / (x[i] - full[i]).max(f64::MIN_POSITIVE);
                let first = blocked.min_by(|a, b| part(*a).total_cmp(&part(*b)));
                let Some(first) = first else {
                    x = full;
                    break;
                };
                let part = part(first).clamp(0.0, 1.0);
                x = &x + part * (full - &x);
                (passive[first], x[first]) = (false, 0.0);
            }
        }
        let left = (&right - &self.r * &x).norm_squared();
        (
            x.as_slice().to_vec(),
            y.norm_squared() - right.norm_squared() + left,
        )
    }

    fn passive(&self, right: &DVector<f64>, passive: &[bool]) -> DVector<f64> {
        let places: Vec<usize> = (0..passive.len()).filter(|i| passive[*i]).collect();
        let mut out = DVector::zeros(passive.len());
        if places.is_empty() {
            return out;
        }
        let svd = self.r.select_columns(&places).svd(true, true);
        let limit = RANK * svd.singular_values.max();
        if let Ok(found) = svd.solve(right, limit) {
            places
                .iter()
                .zip(found.iter())
                .for_each(|(i, x)| out[*i] = *x);
        }
        out
    }
}

/// Rows of the pseudoinverse of a matrix that is given by its columns. A row is not finite if its column is a linear combination of the others.
pub(super) fn inverse(columns: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let Some(first) = columns.first() else {
        return Vec::new();
    };
    let sizes: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
    let matrix = DMatrix::from_fn(first.len(), columns.len(), |i, j| columns[j][i] / sizes[j]);
    let svd = matrix.svd(true, true);
    let (Some(u), Some(vt)) = (&svd.u, &svd.v_t) else {
        return vec![vec![f64::NAN; first.len()]; columns.len()];
    };
    let limit = RANK * svd.singular_values.max();
    let entry = |j: usize, i: usize| -> f64 {
        let terms = (0..svd.singular_values.len()).map(|k| {
            let (v, s) = (vt[(k, j)], svd.singular_values[k]);
            match s > limit {
                true => v * u[(i, k)] / s,
                false if v.abs() > 1e-6 => f64::NAN,
                false => 0.0,
            }
        });
        terms.sum::<f64>() / sizes[j]
    };
    (0..columns.len())
        .map(|j| (0..first.len()).map(|i| entry(j, i)).collect())
        .collect()
}

pub(super) fn product(rows: &[Vec<f64>], y: &[f64]) -> Vec<f64> {
    let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
    rows.iter().map(|row| finite(dot(row, y))).collect()
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounded_solution_satisfies_the_conditions_of_its_optimum() {
        // The conditions are x ≥ 0, gradient ≥ 0 where x = 0, and gradient = 0 where x > 0. They are checked for every sign of two
        // directions.
        let columns = [
            [1.0, 2.0, 0.0, 1.0],
            [0.5, 1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0, 0.2],
        ];
        let columns = columns.map(|c| Column {
            values: c.to_vec(),
            is_positive: true,
        });
        let solver = Bounded::new(&columns);
        for k in 0..64_i32 {
            let y: Vec<f64> = (0..4).map(|i| f64::from(k >> i & 3) - 1.5).collect();
            let (x, left) = solver.solve(&y);
            let error = difference(&y, &solver.model(&x));
            assert!((dot(&error, &error) - left).abs() < 1e-12);
            for (i, x) in x.iter().enumerate() {
                let gradient = dot(&solver.scaled(i), &error);
                assert!(*x >= 0.0 && gradient < 1e-9 && (*x == 0.0 || gradient > -1e-9));
            }
        }
    }
}
