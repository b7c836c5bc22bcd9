//! Rows over windows.

use super::QUINTIC;
use super::layout::Layout;
use crate::synth::qp::basis::Entries;

/// Rows over windows, sorted by them; rows on unknowns beside the law alone come last.
pub struct Windowed {
    /// Rows of span i are those from first[i] to first[i + 1].
    pub first: Vec<usize>,
    /// Numbers of each row over its window.
    pub values: Vec<f64>,
    /// Row, unknown beside the law, value; by row.
    beside: Vec<(usize, usize, f64)>,
}

impl Windowed {
    /// From rows by their windows, the entries of which come first.
    pub fn new(layout: &Layout, rows: &[(Option<usize>, Entries)]) -> Self {
        let (n, w) = (layout.spans, layout.window());
        let mut first = vec![0; n + 2];
        let mut values = Vec::with_capacity(rows.len() * w);
        let mut beside = Vec::new();
        for (row, (window, entries)) in rows.iter().enumerate() {
            first[window.unwrap_or(n) + 1] += 1;
            let own = if window.is_some() { w } else { 0 };
            values.extend(entries[..own].iter().map(|e| e.1));
            beside.extend(entries[own..].iter().map(|&(i, a)| (row, i, a)));
        }
        for i in 0..=n {
            first[i + 1] += first[i];
        }
        Windowed {
            first,
            values,
            beside,
        }
    }

    /// Entries of a row beside the law.
    pub fn beside(&self, row: usize) -> &[(usize, usize, f64)] {
        if self.beside.is_empty() {
            return &[];
        }
        let from = self.beside.partition_point(|e| e.0 < row);
        let own = self.beside[from..].partition_point(|e| e.0 == row);
        &self.beside[from..from + own]
    }

    /// The value of each row.
    pub fn values(&self, layout: &Layout, u: &[f64]) -> Vec<f64> {
        match layout.window() {
            QUINTIC => self.values_of(QUINTIC, layout, u),
            w => self.values_of(w, layout, u),
        }
    }

    #[inline(always)]
    fn values_of(&self, w: usize, layout: &Layout, u: &[f64]) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.first[layout.spans + 1]);
        let mut y = vec![0.0; w];
        for span in 0..layout.spans {
            let own = &self.values[self.first[span] * w..self.first[span + 1] * w];
            if own.is_empty() {
                continue;
            }
            for (y, i) in y.iter_mut().zip(layout.indices(span)) {
                *y = u[i];
            }
            let value = |row: &[f64]| (0..w).map(|k| row[k] * y[k]).sum::<f64>();
            out.extend(own.chunks_exact(w).map(value));
        }
        out.resize(self.first[layout.spans + 1], 0.0);
        for &(row, i, a) in &self.beside {
            out[row] += a * u[i];
        }
        out
    }

    /// Adds each row `by` times to a vector of all unknowns.
    pub fn add_to(&self, layout: &Layout, by: &[f64], out: &mut [f64]) {
        match layout.window() {
            QUINTIC => self.add_to_of(QUINTIC, layout, by, out),
            w => self.add_to_of(w, layout, by, out),
        }
    }

    #[inline(always)]
    fn add_to_of(&self, w: usize, layout: &Layout, by: &[f64], out: &mut [f64]) {
        let mut sum = vec![0.0; w];
        for span in 0..layout.spans {
            let rows = self.first[span]..self.first[span + 1];
            if rows.is_empty() {
                continue;
            }
            sum.fill(0.0);
            let own = &self.values[rows.start * w..rows.end * w];
            for (row, by) in own.chunks_exact(w).zip(&by[rows]) {
                (0..w).for_each(|k| sum[k] += by * row[k]);
            }
            for (sum, i) in sum.iter().zip(layout.indices(span)) {
                out[i] += sum;
            }
        }
        for &(row, i, a) in &self.beside {
            out[i] += a * by[row];
        }
    }
}
