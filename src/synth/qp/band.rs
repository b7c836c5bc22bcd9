//! Cholesky factors of symmetric matrices that are banded but for a few last rows.
//!
//! The Gram matrix of periodic B-splines is banded with two corner blocks. Ordering the last unknowns
//! as a border leaves a plain band and a small dense block; cost is linear in the number of spans.

use super::double::Number;

/// Symmetric positive definite matrix: half-bandwidth `band` on the first `n − border` unknowns, full
/// rows for the last `border`.
#[derive(Debug, Clone)]
pub struct ArrowMatrix<T = f64> {
    n: usize,
    band: usize,
    border: usize,
    /// Lower band of the leading block: entry (i, i−k) at `core[i*(band+1) + k]`.
    core: Vec<T>,
    /// Border rows, each of length n (its own block in the last columns, lower part used).
    rows: Vec<T>,
}

/// Factor L of an [`ArrowMatrix`], same layout.
#[derive(Debug, Clone)]
pub struct ArrowFactor<T = f64>(ArrowMatrix<T>);

impl<T: Number> ArrowMatrix<T> {
    /// The zero matrix. Unknowns coupled beyond `band` must both lie in the last `border` ones, or one of
    /// them must.
    pub fn zero(n: usize, band: usize, border: usize) -> Self {
        let border = border.min(n);
        let core = vec![T::of(0.0); (n - border) * (band + 1)];
        ArrowMatrix {
            n,
            band,
            border,
            core,
            rows: vec![T::of(0.0); border * n],
        }
    }

    /// Half-bandwidth and border.
    pub fn pattern(&self) -> (usize, usize) {
        (self.band, self.border)
    }

    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.n
    }

    /// Adds `value` to entries (i, j) and (j, i).
    ///
    /// # Panics
    /// When the entry lies outside the pattern: a fault of the caller.
    pub fn add(&mut self, i: usize, j: usize, value: T) {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        let m = self.n - self.border;
        if i >= m {
            let entry = &mut self.rows[(i - m) * self.n + j];
            *entry = *entry + value;
        } else {
            assert!(i - j <= self.band, "entry outside the band");
            let entry = &mut self.core[i * (self.band + 1) + (i - j)];
            *entry = *entry + value;
        }
    }

    /// Adds the symmetric block of band + 1 unknowns from `first` on, laid out as the band itself: entry
    /// (k, l), l ≤ k, at `block[k*(band+1) + k − l]`, zero elsewhere. Returns whether all of it lies in the
    /// band, as it must; otherwise nothing is added.
    pub fn add_block(&mut self, first: usize, block: &[T]) -> bool {
        let w = self.band + 1;
        if block.len() != w * w || first + w > self.n - self.border {
            return false;
        }
        for (entry, value) in self.core[first * w..].iter_mut().zip(block) {
            *entry = *entry + *value;
        }
        true
    }

    /// Adds `factor` times another matrix of the same pattern.
    pub fn add_scaled(&mut self, other: &ArrowMatrix<T>, factor: T) {
        let own = self.core.iter_mut().chain(&mut self.rows);
        for (a, b) in own.zip(other.core.iter().chain(&other.rows)) {
            *a = *a + factor * *b;
        }
    }

    /// Multiplies every entry.
    pub fn scale(&mut self, factor: T) {
        let all = self.core.iter_mut().chain(&mut self.rows);
        all.for_each(|a| *a = *a * factor);
    }

    /// Entry (i, j).
    pub fn get(&self, i: usize, j: usize) -> T {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        let m = self.n - self.border;
        if i >= m {
            self.rows[(i - m) * self.n + j]
        } else if i - j <= self.band {
            self.core[i * (self.band + 1) + (i - j)]
        } else {
            T::of(0.0)
        }
    }

    /// Every stored entry of the lower triangle as (row, column, value).
    pub fn lower_entries(&self) -> Vec<(usize, usize, T)> {
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
                    .filter(|e| e.2 != T::of(0.0)),
            );
        }
        out
    }

    /// Product with a vector.
    pub fn times(&self, x: &[T]) -> Vec<T> {
        let (m, w) = (self.n - self.border, self.band + 1);
        let mut y = vec![T::of(0.0); self.n];
        for i in 0..m {
            y[i] = y[i] + self.core[i * w] * x[i];
            for k in 1..=self.band.min(i) {
                let value = self.core[i * w + k];
                y[i] = y[i] + value * x[i - k];
                y[i - k] = y[i - k] + value * x[i];
            }
        }
        for i in m..self.n {
            let row = &self.rows[(i - m) * self.n..][..=i];
            for (j, &value) in row[..i].iter().enumerate() {
                y[i] = y[i] + value * x[j];
                y[j] = y[j] + value * x[i];
            }
            y[i] = y[i] + row[i] * x[i];
        }
        y
    }

    /// Largest diagonal entry.
    pub fn largest_diagonal(&self) -> f64 {
        (0..self.n).fold(0.0, |m, i| self.get(i, i).rounded().max(m))
    }

    /// Cholesky factor, or `None` when a pivot is not positive.
    pub fn factor(mut self) -> Option<ArrowFactor<T>> {
        let (n, w) = (self.n, self.band + 1);
        let m = n - self.border;
        // Column of the factor under the pivot, inside the band.
        let mut column = vec![T::of(0.0); self.band];
        for j in 0..m {
            let pivot = positive_root(self.core[j * w])?;
            self.core[j * w] = pivot;
            let inverse = T::of(1.0) / pivot;
            let below = self.band.min(m - 1 - j);
            for p in 1..=below {
                // Entry (j + p, j + q) stands at (j + p)·w + p − q: rows run backwards.
                let row = &mut self.core[(j + p) * w..][..=p];
                let l = row[p] * inverse;
                row[p] = l;
                column[p - 1] = l;
                for (entry, &c) in row[..p].iter_mut().zip(column[..p].iter().rev()) {
                    *entry = *entry - l * c;
                }
            }
            for r in 0..self.border {
                let (above, own) = self.rows.split_at_mut(r * n);
                let l = own[j] * inverse;
                own[j] = l;
                for (entry, &c) in own[j + 1..].iter_mut().zip(&column[..below]) {
                    *entry = *entry - l * c;
                }
                for (q, other) in above.chunks_exact(n).enumerate() {
                    own[m + q] = own[m + q] - l * other[j];
                }
                own[m + r] = own[m + r] - l * l;
            }
        }
        for r in 0..self.border {
            for q in 0..r {
                let (above, own) = self.rows.split_at_mut(r * n);
                let other = &above[q * n + m..][..=q];
                let done = product(&own[m..m + q], other);
                own[m + q] = (own[m + q] - done) / other[q];
            }
            let own = &mut self.rows[r * n + m..][..=r];
            let square = product(&own[..r], &own[..r]);
            own[r] = positive_root(own[r] - square)?;
        }
        Some(ArrowFactor(self))
    }
}

/// The root of a pivot, if it has one.
fn positive_root<T: Number>(pivot: T) -> Option<T> {
    let value = pivot.rounded();
    (value > 0.0 && value.is_finite()).then(|| pivot.root())
}

fn product<T: Number>(a: &[T], b: &[T]) -> T {
    a.iter()
        .zip(b)
        .fold(T::of(0.0), |sum, (&a, &b)| sum + a * b)
}

impl<T: Number> ArrowFactor<T> {
    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.0.n
    }

    /// Half-bandwidth and border.
    pub fn pattern(&self) -> (usize, usize) {
        self.0.pattern()
    }

    /// Solves in place.
    pub fn solve(&self, x: &mut [T]) {
        self.forward(x);
        self.backward(x);
    }

    /// Replaces b by L⁻¹b.
    pub fn forward(&self, x: &mut [T]) {
        let a = &self.0;
        let (n, w) = (a.n, a.band + 1);
        let m = n - a.border;
        // Rows of limits touch a few neighbours: what stands before the first stays zero.
        let start = x.iter().position(|v| *v != T::of(0.0)).unwrap_or(n);
        for i in start..m {
            let first = i.saturating_sub(a.band).max(start);
            // Entry (i, k) stands at i·w + i − k: reversed beside x[first..i].
            let row = &a.core[i * w + 1..i * w + 1 + (i - first)];
            let known = x[first..i].iter().rev();
            let sum = (row.iter().zip(known)).fold(T::of(0.0), |sum, (&l, &x)| sum + l * x);
            x[i] = (x[i] - sum) / a.core[i * w];
        }
        let start = start.min(m);
        for r in 0..a.border {
            let row = &a.rows[r * n..(r + 1) * n];
            let sum = product(&row[start..m + r], &x[start..m + r]);
            x[m + r] = (x[m + r] - sum) / row[m + r];
        }
    }

    /// Replaces y by L⁻ᵀy.
    pub fn backward(&self, x: &mut [T]) {
        let a = &self.0;
        let (n, w) = (a.n, a.band + 1);
        let m = n - a.border;
        for r in (0..a.border).rev() {
            let row = &a.rows[r * n..(r + 1) * n];
            let value = x[m + r] / row[m + r];
            x[m + r] = value;
            for (x, &l) in x[..m + r].iter_mut().zip(row) {
                *x = *x - l * value;
            }
        }
        for i in (0..m).rev() {
            let value = x[i] / a.core[i * w];
            x[i] = value;
            let first = i.saturating_sub(a.band);
            let row = &a.core[i * w + 1..i * w + 1 + (i - first)];
            for (x, &l) in x[first..i].iter_mut().rev().zip(row) {
                *x = *x - l * value;
            }
        }
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
    fn an_indefinite_matrix_has_no_factor() {
        let mut a = ArrowMatrix::zero(2, 1, 0);
        a.add(0, 0, 1.0);
        a.add(1, 0, 2.0);
        a.add(1, 1, 1.0);
        assert!(a.factor().is_none());
    }
}
