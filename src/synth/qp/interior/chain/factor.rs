//! Bellman's recursion: the controls taken out from the last span to the first, and the way back.

use super::layout::Layout;
use super::rows::Windowed;
use super::{Chain, QUINTIC, moved_up};
use crate::synth::qp::interior::dense;
use crate::synth::qp::interior::system::Line;

/// Part of the largest entry of H that keeps controls which nothing holds, and parts of the rows' where that is too little.
const HELD: f64 = 1e-15;
const HELD_BY_ROWS: [f64; 2] = [1e-15, 1e-12];

/// Numbers of a window, its highest order, and size: a window and, beside it, demands and then unknowns beside the law.
type Shape = (usize, usize, usize);

impl Chain {
    /// The factor with each row's outer product by its weight, the demands as multipliers and `added` (row, column,
    /// value) on the unknowns beside the law.
    pub fn factor(
        &self,
        rows: &Windowed,
        weights: &[f64],
        demands: &[Line],
        added: &[(usize, usize, f64)],
    ) -> Option<Factor> {
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let pushes = || largest(weights) * largest(&rows.values).powi(2);
        let w = self.layout.window();
        let size = w + demands.len() + self.beside;
        // Loops of known length cost half: quintics with demands that the turn closes, or with one more.
        let of = |held: f64| match (w, self.layout.highest, size) {
            (QUINTIC, 2, 11) => {
                self.factor_of((QUINTIC, 2, 11), held, rows, weights, demands, added)
            }
            (QUINTIC, 2, 12) => {
                self.factor_of((QUINTIC, 2, 12), held, rows, weights, demands, added)
            }
            (QUINTIC, 3, 11) => {
                self.factor_of((QUINTIC, 3, 11), held, rows, weights, demands, added)
            }
            (QUINTIC, 3, 12) => {
                self.factor_of((QUINTIC, 3, 12), held, rows, weights, demands, added)
            }
            shape => self.factor_of(shape, held, rows, weights, demands, added),
        };
        let by_rows = || {
            HELD_BY_ROWS
                .into_iter()
                .find_map(|part| of(part * pushes()))
        };
        of(HELD * largest(&self.windows)).or_else(by_rows)
    }

    #[inline(always)]
    fn factor_of(
        &self,
        (w, k, size): Shape,
        held: f64,
        rows: &Windowed,
        weights: &[f64],
        demands: &[Line],
        added: &[(usize, usize, f64)],
    ) -> Option<Factor> {
        let layout = &self.layout;
        let (n, d) = (layout.spans, w - 1);
        let law = layout.unknowns();
        let beside = w + demands.len();
        let mut touched = Touched::new(layout, demands);
        let mut m = vec![0.0; size * size];
        let mut gains = vec![0.0; n * size];
        let mut pivots = vec![0.0; n];
        for span in (0..n).rev() {
            let own = &self.windows[span * w * w..][..w * w];
            for (row, own) in m.chunks_exact_mut(size).zip(own.chunks_exact(w)) {
                for (m, v) in row[..w].iter_mut().zip(own) {
                    *m += v;
                }
            }
            let here = rows.first[span]..rows.first[span + 1];
            for (row, &weight) in here.clone().zip(&weights[here]) {
                let own = &rows.values[row * w..][..w];
                for (m, &a) in m.chunks_exact_mut(size).zip(own) {
                    let by = weight * a;
                    (0..w).for_each(|l| m[l] += by * own[l]);
                }
                for &(_, i, a) in rows.beside(row) {
                    let i = beside + i - law;
                    for (k, &b) in own.iter().enumerate() {
                        m[k * size + i] += weight * a * b;
                    }
                    for &(_, j, b) in rows.beside(row) {
                        m[i * size + beside + j - law] += weight * a * b;
                    }
                }
            }
            touched.add(span as isize, |coordinate, demand, value| {
                m[coordinate * size + w + demand] += value;
            });
            for order in 0..k {
                let by = layout.steps[order][span];
                for row in m[..w * size].chunks_exact_mut(size) {
                    row[order + 1] += by * row[order];
                }
                let (above, below) = m.split_at_mut((order + 1) * size);
                let from = &above[order * size..];
                for (to, from) in below[..size].iter_mut().zip(from) {
                    *to += by * from;
                }
            }
            let pivot = m[k * size + k] + held;
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            let inverse = 1.0 / pivot;
            pivots[span] = inverse;
            let gain = &mut gains[span * size..][..size];
            gain.copy_from_slice(&m[k * size..][..size]);
            gain.iter_mut().for_each(|g| *g *= inverse);
            moved_up(gain, k, w);
            eliminate(&mut m, size, k, w, pivot, gain);
        }
        // The window before the first span, the demands and the unknowns beside the law.
        let rest = size - 1;
        let mut left = vec![0.0; rest * rest];
        let place = |i: usize| if i < d { i } else { i + 1 };
        for i in 0..rest {
            for j in 0..rest {
                // Beside the window one half is kept.
                let (i, j, p, q) = if i < d {
                    (i, j, i, j)
                } else {
                    (i, j, j.min(i), j.max(i))
                };
                left[i * rest + j] = m[place(p) * size + place(q)];
            }
        }
        touched.add(-1, |coordinate, demand, value| {
            left[coordinate * rest + d + demand] += value;
            left[(d + demand) * rest + coordinate] += value;
        });
        for (demand, line) in demands.iter().enumerate() {
            for &(i, a) in line.entries.iter().filter(|e| e.0 >= law) {
                let (p, q) = (d + demand, d + demands.len() + i - law);
                left[p * rest + q] += a;
                left[q * rest + p] += a;
            }
        }
        let mut add = |i: usize, j: usize, value: f64| {
            let first = d + demands.len();
            left[(first + i - law) * rest + first + j - law] += value;
        };
        let last = rows.first[n]..rows.first[n + 1];
        for (row, &weight) in last.clone().zip(&weights[last]) {
            for &(_, i, a) in rows.beside(row) {
                for &(_, j, b) in rows.beside(row) {
                    add(i, j, weight * a * b);
                }
            }
        }
        for &(i, j, value) in added {
            add(i, j, value);
        }
        Some(Factor {
            size,
            gains,
            pivots,
            left: dense::Eliminated::new(left, rest),
        })
    }
}

/// Takes the control out: what is left over the window before stands in the same places, its last number free. Of what
/// stands beside the window the upper half is kept.
#[inline(always)]
fn eliminate(m: &mut [f64], size: usize, k: usize, w: usize, pivot: f64, gain: &[f64]) {
    let d = w - 1;
    for i in 0..d {
        // Rows and columns behind the control move up by one, up to the window's end.
        if i >= k {
            m.copy_within((i + 1) * size..(i + 2) * size, i * size);
        }
        let row = &mut m[i * size..][..size];
        moved_up(row, k, w);
        let by = gain[i] * pivot;
        row.iter_mut().zip(gain).for_each(|(m, g)| *m -= by * g);
    }
    m[d * size..][..size].fill(0.0);
    for i in w..size {
        let by = gain[i] * pivot;
        // A demand that no later span touches.
        if by != 0.0 {
            let own = m[i * size + i..][..size - i].iter_mut();
            own.zip(&gain[i..]).for_each(|(m, g)| *m -= by * g);
        }
    }
}

/// Where the demands touch the windows.
struct Touched {
    /// Span, number of its window, demand, value; by span.
    entries: Vec<(isize, usize, usize, f64)>,
}

impl Touched {
    fn new(layout: &Layout, demands: &[Line]) -> Self {
        let stride = layout.spans + layout.degree;
        let mut entries = Vec::new();
        for (demand, line) in demands.iter().enumerate() {
            for &(i, value) in line.entries.iter().filter(|e| e.0 < layout.unknowns()) {
                let (order, span) = (i / stride, (i % stride) as isize - layout.degree as isize);
                // Before the first span there is one window only.
                let (span, coordinate) = if span < 0 {
                    (-1, order + (-1 - span) as usize)
                } else {
                    (span, order)
                };
                entries.push((span, coordinate, demand, value));
            }
        }
        entries.sort_by_key(|e| e.0);
        Touched { entries }
    }

    /// Visits those of a span, the last one first.
    fn add(&mut self, span: isize, mut visit: impl FnMut(usize, usize, f64)) {
        while let Some(&(s, coordinate, demand, value)) = self.entries.last() {
            if s != span {
                return;
            }
            visit(coordinate, demand, value);
            self.entries.pop();
        }
    }
}

/// The controls' gains and what they leave.
pub struct Factor {
    size: usize,
    /// Of each span: the control's answer to the window before (and a zero), demands and unknowns beside the law.
    gains: Vec<f64>,
    /// Inverse of each control's pivot.
    pivots: Vec<f64>,
    left: dense::Eliminated,
}

impl Factor {
    /// Solves K u + Eᵀν = x, E u = y in place of x; returns ν.
    pub fn solve(&self, chain: &Chain, x: &mut [f64], y: &[f64]) -> Vec<f64> {
        match (chain.layout.window(), chain.layout.highest, self.size) {
            (QUINTIC, 2, 11) => self.solve_of((QUINTIC, 2, 11), chain, x, y),
            (QUINTIC, 2, 12) => self.solve_of((QUINTIC, 2, 12), chain, x, y),
            (QUINTIC, 3, 11) => self.solve_of((QUINTIC, 3, 11), chain, x, y),
            (QUINTIC, 3, 12) => self.solve_of((QUINTIC, 3, 12), chain, x, y),
            shape => self.solve_of(shape, chain, x, y),
        }
    }

    #[inline(always)]
    fn solve_of(&self, (w, k, size): Shape, chain: &Chain, x: &mut [f64], y: &[f64]) -> Vec<f64> {
        let layout = &chain.layout;
        let (n, d) = (layout.spans, w - 1);
        let law = layout.unknowns();
        let rest = size - 1;
        x.iter_mut().for_each(|x| *x = -*x);
        // v over a window (d + 1 numbers), then demands and unknowns beside the law.
        let mut v = vec![0.0; size];
        let mut controls = vec![0.0; n];
        for span in (0..n).rev() {
            let v = &mut v[..size];
            chain.pulled_back(x, span, v);
            let gain = &self.gains[span * size..][..size];
            let own = v[k];
            controls[span] = own * self.pivots[span];
            moved_up(v, k, w);
            v.iter_mut().zip(gain).for_each(|(v, g)| *v -= own * g);
        }
        let mut z = Vec::with_capacity(rest);
        z.extend((0..d).map(|j| -(v[j] + x[layout.in_window(-1, j)])));
        let after = &v[w..];
        z.extend(y.iter().zip(after).map(|(y, v)| y - v));
        z.extend(
            x[law..]
                .iter()
                .zip(&after[y.len()..])
                .map(|(x, v)| -(x + v)),
        );
        self.left.solve(&mut z);
        x.fill(0.0);
        for j in 0..d {
            x[layout.in_window(-1, j)] = z[j];
        }
        let mut state = z[..d].to_vec();
        state.push(0.0);
        for span in 0..n {
            let gain = &self.gains[span * size..][..size];
            // What the span before has found comes last: nothing else waits for it.
            let mut control = -controls[span];
            for (g, z) in gain[w..].iter().zip(&z[d..]) {
                control -= g * z;
            }
            for (g, s) in gain[..d].iter().zip(&state).rev() {
                control -= g * s;
            }
            state.copy_within(k..d, k + 1);
            state[k] = control;
            x[layout.own(k, span)] = control;
            for order in (0..k).rev() {
                state[order] += state[order + 1] * layout.steps[order][span];
                x[layout.own(order, span)] = state[order];
            }
        }
        x[law..].copy_from_slice(&z[d + y.len()..]);
        z[d..d + y.len()].to_vec()
    }
}
