//! Cholesky factors of symmetric matrices that are banded except for the last few rows and columns (the border).
//!
//! The Gram matrix of periodic B-splines is banded with two corner blocks. If the last unknowns are treated as the border, the leading
//! block is banded and only the border is dense. The cost is linear in the number of spans.

use super::frame::dot;

/// Number of band entries per column for quintic splines, the default. The loops are faster if this number is a constant.
const QUINTIC: usize = 6;

/// Symmetric positive definite matrix with half-bandwidth `band` for the first `n − border` unknowns. The last `border` rows (and columns)
/// are dense.
#[derive(Debug, Clone)]
pub struct ArrowMatrix {
    n: usize,
    band: usize,
    border: usize,
    /// Lower band of the leading block by columns: entry (j + k, j) is `core[j*(band+1) + k]`.
    core: Vec<f64>,
    /// Border rows, each of length n. Their last columns contain the diagonal block of the border, of which only the lower triangle is
    /// used.
    rows: Vec<f64>,
}

/// Cholesky factor L of an [`ArrowMatrix`] in the same layout. The diagonal entries are stored inverted, so that substitution multiplies
/// instead of dividing.
#[derive(Debug, Clone)]
pub struct ArrowFactor(ArrowMatrix);

impl ArrowMatrix {
    /// Zero matrix with `n` unknowns. If two unknowns are coupled at a distance above `band`, at least one of them must be among the last
    /// `border` unknowns.
    pub fn zero(n: usize, band: usize, border: usize) -> Self {
        let border = border.min(n);
        let core = vec![0.0; (n - border) * (band + 1)];
        ArrowMatrix {
            n,
            band,
            border,
            core,
            rows: vec![0.0; border * n],
        }
    }

    /// Number of unknowns, which is the number of rows.
    pub fn dimension(&self) -> usize {
        self.n
    }

    /// Half-bandwidth of the leading block and number of border rows.
    pub fn shape(&self) -> (usize, usize) {
        (self.band, self.border)
    }

    /// Adds `value` to the entries (i, j) and (j, i).
    ///
    /// # Panics
    ///
    /// If the entry is outside the pattern, which is an error of the caller.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        let m = self.n - self.border;
        if i >= m {
            let entry = &mut self.rows[(i - m) * self.n + j];
            *entry += value;
        } else {
            assert!(i - j <= self.band, "entry outside the band");
            let entry = &mut self.core[j * (self.band + 1) + (i - j)];
            *entry += value;
        }
    }

    /// Adds a symmetric block for the band + 1 unknowns from `first` on. Entry (k, l), l ≤ k, is `block[l*(band+1) + k − l]`, as in the
    /// layout of the band. Returns whether the block lies in the band. If it does not, nothing is added.
    pub fn add_block(&mut self, first: usize, block: &[f64]) -> bool {
        let w = self.band + 1;
        if block.len() != w * w || first + w > self.n - self.border {
            return false;
        }
        for (entry, value) in self.core[first * w..].iter_mut().zip(block) {
            *entry += *value;
        }
        true
    }

    /// Adds the circulant matrix whose entries at distance k from the diagonal are `row[k]`, with indices modulo n.
    pub fn add_circulant(&mut self, row: &[f64]) {
        let (n, m, w) = (self.n, self.n - self.border, self.band + 1);
        for (j, column) in self.core.chunks_exact_mut(w).enumerate() {
            for (entry, value) in column[..w.min(m - j)].iter_mut().zip(row) {
                *entry += *value;
            }
        }
        for j in (m + 1).saturating_sub(row.len())..n {
            for (apart, &value) in row.iter().enumerate() {
                let i = (j + apart) % n;
                if i >= m || j >= m {
                    self.add_pair(i, j, apart, value);
                }
            }
        }
    }

    /// Adds `value` to the entries (i, j) and (j, i), for two functions whose indices differ by `apart` before they are reduced modulo n.
    /// If i = j although `apart` is positive, twice `value` is added to the diagonal.
    pub fn add_pair(&mut self, i: usize, j: usize, apart: usize, value: f64) {
        let twice = if i == j && apart > 0 { 2.0 } else { 1.0 };
        self.add(i, j, twice * value);
    }

    /// Adds `factor` times another matrix with the same pattern.
    pub fn add_scaled(&mut self, other: &ArrowMatrix, factor: f64) {
        let own = self.core.iter_mut().chain(&mut self.rows);
        for (a, b) in own.zip(other.core.iter().chain(&other.rows)) {
            *a += factor * *b;
        }
    }

    /// Multiplies every entry by a factor.
    pub fn scale(&mut self, factor: f64) {
        let all = self.core.iter_mut().chain(&mut self.rows);
        all.for_each(|a| *a *= factor);
    }

    /// Entry (i, j) of the matrix.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        let m = self.n - self.border;
        if i >= m {
            self.rows[(i - m) * self.n + j]
        } else if i - j <= self.band {
            self.core[j * (self.band + 1) + (i - j)]
        } else {
            0.0
        }
    }

    /// Sum of all entries of the matrix.
    pub fn sum(&self) -> f64 {
        let lower: f64 = self.core.iter().chain(&self.rows).sum();
        let diagonal: f64 = (0..self.n).map(|i| self.get(i, i)).sum();
        2.0 * lower - diagonal
    }

    /// Stored entries of the lower triangle as (row, column, value).
    pub fn lower_entries(&self) -> Vec<(usize, usize, f64)> {
        let m = self.n - self.border;
        let mut out = Vec::new();
        for i in 0..self.n {
            let first = if i < m {
                i.saturating_sub(self.band)
            } else {
                0
            };
            out.extend(
                (first..=i)
                    .map(|j| (i, j, self.get(i, j)))
                    .filter(|e| e.2 != 0.0),
            );
        }
        out
    }

    /// Product of the matrix and a vector.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let (m, w) = (self.n - self.border, self.band + 1);
        let mut y = vec![0.0; self.n];
        for (i, column) in self.core.chunks_exact(w).enumerate() {
            let own = x[i];
            let (mut sum, below) = (column[0] * own, w.min(m - i));
            for ((&value, &x), y) in column[1..below]
                .iter()
                .zip(&x[i + 1..])
                .zip(&mut y[i + 1..])
            {
                sum += value * x;
                *y += value * own;
            }
            y[i] += sum;
        }
        for i in m..self.n {
            let row = &self.rows[(i - m) * self.n..][..=i];
            for (j, &value) in row[..i].iter().enumerate() {
                y[i] += value * x[j];
                y[j] += value * x[i];
            }
            y[i] += row[i] * x[i];
        }
        y
    }

    /// Maximum entry of the diagonal.
    pub fn largest_diagonal(&self) -> f64 {
        (0..self.n).fold(0.0, |m, i| self.get(i, i).max(m))
    }

    /// Cholesky factor; `None` if a pivot is not positive.
    pub fn factor(mut self) -> Option<ArrowFactor> {
        let (n, w) = (self.n, self.band + 1);
        let m = n - self.border;
        match w {
            QUINTIC => factor_of_width(&mut self.core, QUINTIC)?,
            _ => factor_of_width(&mut self.core, w)?,
        }
        for r in 0..self.border {
            let (above, own) = self.rows.split_at_mut(r * n);
            let own = &mut own[..m + r + 1];
            forward_in_band(&self.core, w, &mut own[..m], 0);
            for (q, other) in above.chunks_exact(n).enumerate() {
                let done = dot(&own[..m + q], &other[..m + q]);
                own[m + q] = (own[m + q] - done) * other[m + q];
            }
            let square = dot(&own[..m + r], &own[..m + r]);
            own[m + r] = 1.0 / positive_root(own[m + r] - square)?;
        }
        Some(ArrowFactor(self))
    }
}

/// Square root of a pivot; `None` if the pivot is not positive and finite.
fn positive_root(pivot: f64) -> Option<f64> {
    (pivot > 0.0 && pivot.is_finite()).then(|| pivot.sqrt())
}

/// Subtracts `part` times the vector `other` from the vector `from`, up to the shorter length.
#[inline(always)]
fn take_off(from: &mut [f64], other: &[f64], part: f64) {
    for (x, &l) in from.iter_mut().zip(other) {
        *x -= l * part;
    }
}

/// Replaces x by L⁻¹x for the banded block alone. All entries of x before `start` are zero.
fn forward_in_band(core: &[f64], w: usize, x: &mut [f64], start: usize) {
    match w {
        QUINTIC => forward_of_width(core, QUINTIC, x, start),
        _ => forward_of_width(core, w, x, start),
    }
}

#[inline(always)]
fn forward_of_width(core: &[f64], w: usize, x: &mut [f64], start: usize) {
    for (i, column) in core.chunks_exact(w).enumerate().skip(start) {
        let value = x[i] * column[0];
        x[i] = value;
        let (column, below) = (&column[1..], &mut x[i + 1..]);
        // If the whole column is inside the matrix, its length is constant.
        match below.get_mut(..w - 1) {
            Some(below) => take_off(below, column, value),
            None => take_off(below, column, value),
        }
    }
}

/// Replaces x by L⁻ᵀx for the banded block alone.
fn backward_in_band(core: &[f64], w: usize, x: &mut [f64]) {
    match w {
        QUINTIC => backward_of_width(core, QUINTIC, x),
        _ => backward_of_width(core, w, x),
    }
}

#[inline(always)]
fn backward_of_width(core: &[f64], w: usize, x: &mut [f64]) {
    for (i, column) in core.chunks_exact(w).enumerate().rev() {
        let (own, below) = x[i..].split_at_mut(1);
        let done = match below.get(..w - 1) {
            Some(below) => plain_dot(&column[1..], below),
            None => plain_dot(&column[1..], below),
        };
        own[0] = (own[0] - done) * column[0];
    }
}

/// Inner product up to the shorter length, for short vectors.
#[inline(always)]
fn plain_dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (&a, &b)| sum + a * b)
}

/// Replaces the banded block by its Cholesky factor; `None` if a pivot is not positive.
#[inline(always)]
fn factor_of_width(core: &mut [f64], w: usize) -> Option<()> {
    let m = core.len() / w;
    for j in 0..m {
        let (column, later) = core[j * w..].split_at_mut(w);
        let inverse = 1.0 / positive_root(column[0])?;
        column[0] = inverse;
        column[1..].iter_mut().for_each(|l| *l *= inverse);
        // Stored entries below the last row of the matrix are zero.
        for (p, own) in (1..w).zip(later.chunks_exact_mut(w)) {
            take_off(&mut own[..w - p], &column[p..], column[p]);
        }
    }
    Some(())
}

impl ArrowFactor {
    /// All stored entries of L as (row, column, value).
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let entries = self.0.lower_entries().into_iter();
        entries.map(|(i, j, l)| (i, j, if i == j { 1.0 / l } else { l }))
    }

    /// Solves the linear system for the right-hand side `x` and writes the solution to `x`.
    pub fn solve(&self, x: &mut [f64]) {
        self.forward(x);
        self.backward(x);
    }

    /// Replaces the vector x by L⁻¹x.
    pub fn forward(&self, x: &mut [f64]) {
        let a = &self.0;
        let m = a.n - a.border;
        // Rows of limits have few adjacent entries. Everything before the first entry remains zero.
        let start = x.iter().position(|v| *v != 0.0).unwrap_or(a.n);
        let start = start.min(m);
        forward_in_band(&a.core, a.band + 1, &mut x[..m], start);
        for (i, row) in (m..).zip(a.rows.chunks_exact(a.n)) {
            let done = dot(&row[start..i], &x[start..i]);
            x[i] = (x[i] - done) * row[i];
        }
    }

    /// Replaces the vector x by L⁻ᵀx.
    pub fn backward(&self, x: &mut [f64]) {
        let a = &self.0;
        let m = a.n - a.border;
        for (i, row) in (m..a.n).zip(a.rows.chunks_exact(a.n)).rev() {
            let value = x[i] * row[i];
            x[i] = value;
            take_off(&mut x[..i], row, value);
        }
        backward_in_band(&a.core, a.band + 1, &mut x[..m]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrow_solve_agrees_with_a_dense_solve() {
        for (n, band, border) in [(12, 2, 3), (7, 3, 7), (9, 1, 0), (1, 0, 1)] {
            let mut a = ArrowMatrix::zero(n, band, border);
            for i in 0..n {
                a.add(i, i, 10.0 + i as f64);
                for j in 0..i {
                    if i - j <= band || i >= n - border {
                        a.add(i, j, ((i * 7 + j * 3) % 5) as f64 / 5.0 - 0.4);
                    }
                }
            }
            let dense = nalgebra::DMatrix::from_fn(n, n, |i, j| a.get(i, j));
            let b: Vec<f64> = (0..n).map(|i| (i as f64).sin() + 1.0).collect();
            let expected = dense
                .lu()
                .solve(&nalgebra::DVector::from_vec(b.clone()))
                .unwrap();
            let mut x = b.clone();
            a.clone().factor().unwrap().solve(&mut x);
            assert!(
                x.iter()
                    .zip(expected.iter())
                    .all(|(p, q)| (p - q).abs() < 1e-13)
            );
            let back = a.times(&x);
            assert!(back.iter().zip(&b).all(|(p, q)| (p - q).abs() < 1e-12));
        }
    }

    #[test]
    fn a_circulant_is_what_its_functions_add_one_by_one() {
        for (n, degree) in [(1, 3), (2, 5), (5, 5), (6, 5), (7, 3), (12, 5)] {
            let row: Vec<f64> = (0..=degree).map(|k| 1.0 + 0.3 * k as f64).collect();
            let mut own = ArrowMatrix::zero(n, degree, degree);
            own.add_circulant(&row);
            let mut expected = nalgebra::DMatrix::zeros(n, n);
            for i in 0..n {
                expected[(i, i)] += row[0];
                for (apart, value) in row.iter().enumerate().skip(1) {
                    let j = (i + apart) % n;
                    expected[(i, j)] += value;
                    expected[(j, i)] += value;
                }
            }
            let found = nalgebra::DMatrix::from_fn(n, n, |i, j| own.get(i, j));
            assert!((found - expected).amax() < 1e-14, "{n} {degree}");
        }
    }

    #[test]
    fn an_indefinite_matrix_has_no_factor() {
        let mut a = ArrowMatrix::zero(2, 1, 0);
        a.add(0, 0, 1.0);
        a.add(1, 0, 2.0);
        a.add(1, 1, 1.0);
        assert!(a.factor().is_none());
    }
}
