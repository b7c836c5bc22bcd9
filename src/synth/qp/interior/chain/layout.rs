//! Where the coefficients of a chain stand among its unknowns, and how rows go over to windows.

use crate::synth::qp::basis::Entries;
use crate::synth::qp::interior::system::Line;
use crate::synth::qp::lifted::Lifted;

/// Where the coefficients of a chain stand among its unknowns.
#[derive(Debug, Clone)]
pub struct Layout {
    pub spans: usize,
    pub degree: usize,
    /// K.
    pub highest: usize,
    /// 1/fᵢ of the step from each order below K to the next.
    pub steps: Vec<Vec<f64>>,
}

impl Layout {
    /// For derivatives up to order `highest`.
    pub fn new(lifted: &Lifted, highest: usize) -> Self {
        let inverse = |factors: &Vec<f64>| factors.iter().map(|f| 1.0 / f).collect();
        Layout {
            spans: lifted.dimension(),
            degree: lifted.degree(),
            highest,
            steps: lifted.factors()[..highest].iter().map(inverse).collect(),
        }
    }

    /// Numbers of a window.
    pub fn window(&self) -> usize {
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
    pub fn in_window(&self, i: isize, k: usize) -> usize {
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
        let (n, last) = (self.spans, self.window_of(entries));
        if entries.iter().all(|e| (last + n - e.0) % n <= self.degree) {
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
    pub fn span_of(&self, coefficients: impl Iterator<Item = (usize, usize)>) -> usize {
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
    pub fn over_window(
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
            let by = -value * self.steps[order][(span + n - step) % n];
            self.add_back(span, order + 1, step, by, out);
        }
    }

    /// The unknowns of a window, one after the other.
    pub fn indices(&self, span: usize) -> impl Iterator<Item = usize> + '_ {
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
