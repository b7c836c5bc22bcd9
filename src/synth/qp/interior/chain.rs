//! A law of many spans as a chain of stages, whose controls are eliminated one by one.
//!
//! In the coefficients of the lift the matrix of N spans has a condition of N⁴ and more (theory §9). Here the unknowns
//! are the coefficients of s and of each derivative up to the highest, K, that objective and limits ask for, tied by
//! c′ᵢ = fᵢ (cᵢ − cᵢ₋₁) as the stages of a control problem are. Whatever a law of degree d has in span i follows from
//!
//! ```text
//! yᵢ = (s, v, …, c⁽ᴷ⁾)ᵢ, c⁽ᴷ⁾ᵢ₋₁, …, c⁽ᴷ⁾ᵢ₋₍d₋K₎        d + 1 numbers, the window of span i
//! ```
//!
//! and the next window from the first d of them and the next c⁽ᴷ⁾, the control. Bellman's recursion minimises over the
//! controls from the last span to the first (Betts, Practical Methods for Optimal Control, ch. 4; Rao, Wright and
//! Rawlings, JOTA 99, 1998); what the window before the first span, the demands and the variables beside the law leave is
//! a small dense system. That the turn closes is d demands: the window after the last span is the one before the first.
//! Cost is in proportion to the spans, and usual digits are enough.

use super::dense;
use super::system::Line;
use crate::synth::qp::basis::Entries;
use crate::synth::qp::lifted::Lifted;

/// Size of a window of quintics, which are the rule: loops of known length cost half.
const QUINTIC: usize = 6;
/// Part of the largest entry that keeps controls which nothing holds.
const HELD: f64 = 1e-15;

/// Where the coefficients of a chain stand among its unknowns.
#[derive(Debug, Clone)]
pub struct Layout {
    spans: usize,
    degree: usize,
    /// K.
    highest: usize,
    /// fᵢ of the step from each order below K to the next.
    factors: Vec<Vec<f64>>,
}

impl Layout {
    /// For derivatives up to order `highest`.
    pub fn new(lifted: &Lifted, highest: usize) -> Self {
        Layout {
            spans: lifted.dimension(),
            degree: lifted.degree(),
            highest,
            factors: lifted.factors()[..highest].to_vec(),
        }
    }

    /// K.
    pub fn highest(&self) -> usize {
        self.highest
    }

    /// Numbers of a window.
    fn window(&self) -> usize {
        self.degree + 1
    }

    /// Unknowns of the law: all orders, each with the window before the first span.
    pub fn unknowns(&self) -> usize {
        (self.highest + 1) * (self.spans + self.degree)
    }

    /// Unknown of c⁽ᵏ⁾ᵢ; i < 0 lies before the first span.
    fn at(&self, order: usize, i: isize) -> usize {
        let first = order * (self.spans + self.degree) + self.degree;
        first.wrapping_add_signed(i)
    }

    /// Unknown of the `k`th number of the window of span `i`.
    fn in_window(&self, i: isize, k: usize) -> usize {
        if k <= self.highest {
            self.at(k, i)
        } else {
            self.at(self.highest, i - (k - self.highest) as isize)
        }
    }

    /// Unknown of coefficient `i` of an order, as the law counts them.
    pub fn own(&self, order: usize, i: usize) -> usize {
        self.at(order, i as isize)
    }

    /// A row over the coefficients of all orders, as the program has it, over its window.
    pub fn row(&self, entries: &Entries) -> Entries {
        if entries.is_empty() {
            return Entries::new();
        }
        let span = self.window_of(entries);
        let n = self.spans;
        let mut out = vec![0.0; self.window()];
        let terms = entries.iter().map(|&(i, a)| (i / n, i % n, a));
        self.over_window(span, terms, &mut out);
        self.indices(span).zip(out).collect()
    }

    /// The window of such a row.
    pub fn window_of(&self, entries: &Entries) -> usize {
        let n = self.spans;
        self.span_of(entries.iter().map(|&(i, _)| (i / n, i % n)))
    }

    /// A row over the coefficients of the lift. One within a window goes over to derivatives there, which have the digits
    /// that its differences lose.
    pub fn of_lift(&self, entries: &Entries) -> Entries {
        if entries.len() <= self.window() {
            self.row(entries)
        } else {
            let own = entries.iter().map(|&(i, a)| (self.own(0, i), a));
            own.collect()
        }
    }

    /// The lift's coefficients, `length` times the unknowns from `start` on: those of the highest order summed up, at the mean
    /// level of its own.
    pub fn lift(&self, lifted: &Lifted, start: &[f64], u: &[f64], length: f64) -> Vec<f64> {
        let of = |order: usize| {
            u[self.own(order, 0)..][..self.spans]
                .iter()
                .map(|u| u * length)
        };
        let level = of(0).sum::<f64>() / self.spans as f64;
        let highest: Vec<f64> = of(self.highest).collect();
        lifted.integrated(start, &highest, self.highest, level)
    }

    /// The window that holds all coefficients (order, index): that of the last of them.
    fn span_of(&self, coefficients: impl Iterator<Item = (usize, usize)>) -> usize {
        let n = self.spans;
        let mut last = None;
        for (_, i) in coefficients {
            // The later of two neighbours on a closed turn.
            last = Some(match last {
                Some(l) if (i + n - l) % n <= self.degree => i,
                Some(l) => l,
                None => i,
            });
        }
        last.unwrap_or(0)
    }

    /// Σ value·c⁽ᵏ⁾ᵢ of (order, index, value) over the window of span `span`, which holds them all.
    fn over_window(
        &self,
        span: usize,
        terms: impl Iterator<Item = (usize, usize, f64)>,
        out: &mut [f64],
    ) {
        out.fill(0.0);
        let n = self.spans;
        for (order, i, value) in terms {
            self.add_back(span, order, (span + n - i) % n, value, out);
        }
    }

    /// Adds value·c⁽ᵏ⁾ of `back` spans before: cᵢ₋₁ = cᵢ − c′ᵢ/fᵢ, order for order.
    fn add_back(&self, span: usize, order: usize, back: usize, value: f64, out: &mut [f64]) {
        if order == self.highest {
            out[self.highest + back] += value;
            return;
        }
        out[order] += value;
        let n = self.spans;
        for step in 0..back {
            let by = -value / self.factors[order][(span + n - step) % n];
            self.add_back(span, order + 1, step, by, out);
        }
    }

    /// The unknowns of a window, one after the other.
    fn indices(&self, span: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.window()).map(move |k| self.in_window(span as isize, k))
    }

    /// That the turn closes: the first d numbers of the last window are those before the first span.
    pub fn closing(&self) -> Vec<Line> {
        let last = self.spans as isize - 1;
        let closed = |k: usize| {
            let ends = [
                (self.in_window(last, k), 1.0),
                (self.in_window(-1, k), -1.0),
            ];
            Line::new(ends.to_vec(), 0.0)
        };
        (0..self.degree).map(closed).collect()
    }
}

/// ½uᵀHu of a chain.
#[derive(Debug, Clone)]
pub struct Chain {
    pub layout: Layout,
    /// Symmetric matrix of each window, row by row.
    windows: Vec<f64>,
    /// Unknowns beside the law.
    pub beside: usize,
}

/// Rows over windows, sorted by them; rows on unknowns beside the law alone come last.
pub struct Windowed {
    /// Rows of span i are those from first[i] to first[i + 1].
    first: Vec<usize>,
    /// Numbers of each row over its window.
    values: Vec<f64>,
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
    fn beside(&self, row: usize) -> &[(usize, usize, f64)] {
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

impl Chain {
    /// The objective, `factor` times; entries of the lower triangle may come in several parts.
    pub fn new(layout: Layout, lifted: &Lifted, factor: f64, beside: usize) -> Self {
        let (n, w) = (layout.spans, layout.window());
        let mut windows = vec![0.0; n * w * w];
        let (mut a, mut b) = (vec![0.0; w], vec![0.0; w]);
        for &(i, j, value) in lifted.blocks() {
            let (p, q) = ((i / n, i % n), (j / n, j % n));
            let span = layout.span_of([p, q].into_iter());
            layout.over_window(span, [(p.0, p.1, 1.0)].into_iter(), &mut a);
            layout.over_window(span, [(q.0, q.1, 1.0)].into_iter(), &mut b);
            let half = if i == j { 0.5 } else { 1.0 } * value * factor;
            let own = &mut windows[span * w * w..][..w * w];
            for (k, row) in own.chunks_exact_mut(w).enumerate() {
                for (l, entry) in row.iter_mut().enumerate() {
                    *entry += half * (a[k] * b[l] + b[k] * a[l]);
                }
            }
        }
        Chain {
            layout,
            windows,
            beside,
        }
    }

    /// Hu.
    pub fn times(&self, u: &[f64]) -> Vec<f64> {
        let w = self.layout.window();
        let mut out = vec![0.0; u.len()];
        let mut y = vec![0.0; w];
        for (span, own) in self.windows.chunks_exact(w * w).enumerate() {
            for (y, i) in y.iter_mut().zip(self.layout.indices(span)) {
                *y = u[i];
            }
            for (row, i) in own.chunks_exact(w).zip(self.layout.indices(span)) {
                out[i] += row.iter().zip(&y).map(|(a, y)| a * y).sum::<f64>();
            }
        }
        out
    }

    /// The largest part of a gradient over all unknowns that no control, no window before the first span and no unknown
    /// beside the law can balance: what a stage's tie takes over is pushed on to the stage before.
    pub fn unbalanced(&self, gradient: &[f64]) -> f64 {
        let layout = &self.layout;
        let (d, k) = (layout.degree, layout.highest);
        let mut most = 0.0_f64;
        let mut v = vec![0.0; d + 1];
        for span in (0..layout.spans).rev() {
            self.pulled_back(gradient, span, &mut v);
            most = most.max(v[k].abs());
            moved_up(&mut v, k, d + 1);
        }
        for (j, v) in v[..d].iter().enumerate() {
            most = most.max((v + gradient[layout.in_window(-1, j)]).abs());
        }
        let beside = &gradient[layout.unknowns()..];
        beside.iter().fold(most, |m, g| m.max(g.abs()))
    }

    /// A gradient by the window after a span's, from one by that window: over (x, control) of the span before.
    #[inline(always)]
    fn pulled_back(&self, gradient: &[f64], span: usize, v: &mut [f64]) {
        let layout = &self.layout;
        for (order, v) in v.iter_mut().enumerate().take(layout.highest + 1) {
            *v += gradient[layout.own(order, span)];
        }
        for order in 0..layout.highest {
            v[order + 1] += v[order] / layout.factors[order][span];
        }
    }

    /// The factor with each row's outer product by its weight, the demands as multipliers and `dense` added to the
    /// unknowns beside the law.
    pub fn factor(
        &self,
        rows: &Windowed,
        weights: &[f64],
        demands: &[Line],
        added: &[(usize, usize, f64)],
    ) -> Option<Factor> {
        match self.layout.window() {
            QUINTIC => self.factor_of(QUINTIC, rows, weights, demands, added),
            w => self.factor_of(w, rows, weights, demands, added),
        }
    }

    #[inline(always)]
    fn factor_of(
        &self,
        w: usize,
        rows: &Windowed,
        weights: &[f64],
        demands: &[Line],
        added: &[(usize, usize, f64)],
    ) -> Option<Factor> {
        let layout = &self.layout;
        let (n, d, k) = (layout.spans, w - 1, layout.highest);
        let law = layout.unknowns();
        // A window and, beside it, demands and then unknowns beside the law.
        let size = w + demands.len() + self.beside;
        let beside = w + demands.len();
        let mut touched = Touched::new(layout, demands);
        let largest = self.windows.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
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
            for row in rows.first[span]..rows.first[span + 1] {
                let own = &rows.values[row * w..][..w];
                let weight = weights[row];
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
                let by = 1.0 / layout.factors[order][span];
                for row in m[..w * size].chunks_exact_mut(size) {
                    row[order + 1] += by * row[order];
                }
                let (above, below) = m.split_at_mut((order + 1) * size);
                let from = &above[order * size..];
                for (to, from) in below[..size].iter_mut().zip(from) {
                    *to += by * from;
                }
            }
            let pivot = m[k * size + k] + HELD * largest;
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
        for row in rows.first[n]..rows.first[n + 1] {
            for &(_, i, a) in rows.beside(row) {
                for &(_, j, b) in rows.beside(row) {
                    add(i, j, weights[row] * a * b);
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

/// A window's numbers without the control, at `k`: those behind it move up, the last is free.
#[inline(always)]
fn moved_up(numbers: &mut [f64], k: usize, w: usize) {
    numbers.copy_within(k + 1..w, k);
    numbers[w - 1] = 0.0;
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
        match chain.layout.window() {
            QUINTIC => self.solve_of(QUINTIC, chain, x, y),
            w => self.solve_of(w, chain, x, y),
        }
    }

    #[inline(always)]
    fn solve_of(&self, w: usize, chain: &Chain, x: &mut [f64], y: &[f64]) -> Vec<f64> {
        let layout = &chain.layout;
        let (n, d, k) = (layout.spans, w - 1, layout.highest);
        let law = layout.unknowns();
        let rest = self.size - 1;
        x.iter_mut().for_each(|x| *x = -*x);
        // v over a window (d + 1 numbers), then demands and unknowns beside the law.
        let mut v = vec![0.0; self.size];
        let mut controls = vec![0.0; n];
        for span in (0..n).rev() {
            chain.pulled_back(x, span, &mut v);
            let gain = &self.gains[span * self.size..][..self.size];
            let own = v[k];
            controls[span] = own * self.pivots[span];
            moved_up(&mut v, k, w);
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
            let gain = &self.gains[span * self.size..][..self.size];
            let mut control = -controls[span];
            for (g, s) in gain[..d].iter().zip(&state) {
                control -= g * s;
            }
            for (g, z) in gain[w..].iter().zip(&z[d..]) {
                control -= g * z;
            }
            state.copy_within(k..d, k + 1);
            state[k] = control;
            x[layout.own(k, span)] = control;
            for order in (0..k).rev() {
                state[order] += state[order + 1] / layout.factors[order][span];
                x[layout.own(order, span)] = state[order];
            }
        }
        x[law..].copy_from_slice(&z[d + y.len()..]);
        z[d..d + y.len()].to_vec()
    }
}
