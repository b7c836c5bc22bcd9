//! Construction of laws span by span.

use super::{Law, Wave};
use crate::poly::{PiecewisePoly, bernstein};

/// A law under construction, to which spans are added in ascending order.
#[derive(Debug, Clone, Default)]
pub(super) struct Pieces {
    breaks: Vec<f64>,
    coef: Vec<Vec<f64>>,
    waves: Vec<Vec<Wave>>,
}

impl Pieces {
    pub fn starting_at(start: f64) -> Self {
        Pieces {
            breaks: vec![start],
            ..Pieces::default()
        }
    }

    /// End angle of the last span, rad. Without spans, it is the start of the law.
    pub fn reached(&self) -> f64 {
        self.breaks[self.breaks.len() - 1]
    }

    /// Adds a span that ends at `end`, with Bernstein coefficients and sinusoids relative to its start. A span of zero length is ignored.
    pub fn push(&mut self, end: f64, coef: Vec<f64>, waves: Vec<Wave>) {
        if end > self.reached() {
            self.breaks.push(end);
            self.coef.push(coef);
            self.waves.push(waves);
        }
    }

    /// Adds spans with the lift base + lift·`shape`, where the extent of `shape` is scaled to `width`. If `mirrored`, the lift is base + lift·(1 −
    /// shape(1 − x)) instead.
    pub fn push_shape(&mut self, shape: &Law, width: f64, base: f64, lift: f64, mirrored: bool) {
        let (first, length) = shape.extent();
        let stretch = width / length;
        let start = self.reached();
        let n = shape.poly().pieces();
        let breaks = shape.breaks();
        for k in 0..n {
            let i = if mirrored { n - 1 - k } else { k };
            let own_width = breaks[i + 1] - breaks[i];
            let mut coef = shape.poly().piece(i).to_vec();
            let mut waves = shape.waves(i).to_vec();
            let (mut base, mut lift) = (base, lift);
            if mirrored {
                coef.reverse();
                waves.iter_mut().for_each(|w| *w = w.mirrored(own_width));
                base += lift;
                lift = -lift;
            }
            coef.iter_mut().for_each(|c| *c = base + lift * *c);
            for w in &mut waves {
                *w = Wave {
                    rate: w.rate / stretch,
                    cos: lift * w.cos,
                    sin: lift * w.sin,
                };
            }
            let done = if mirrored {
                first + length - breaks[i]
            } else {
                breaks[i + 1] - first
            };
            let end = if k + 1 == n {
                start + width
            } else {
                start + done * stretch
            };
            self.push(end, coef, waves);
        }
    }

    /// Adds the part of `law` between `from` and `to`, which lie in the same period of the law.
    pub fn push_part(&mut self, law: &Law, from: f64, to: f64) {
        let start = self.reached();
        for i in 0..law.poly().pieces() {
            let (a, b) = (law.breaks()[i], law.breaks()[i + 1]);
            let (left, right) = (a.max(from), b.min(to));
            if right <= left {
                continue;
            }
            let mut coef = law.poly().piece(i).to_vec();
            if right < b {
                coef = bernstein::split(&coef, (right - a) / (b - a)).0;
            }
            if left > a {
                coef = bernstein::split(&coef, (left - a) / (right - a)).1;
            }
            let waves = law.waves(i).iter().map(|w| w.from(left - a)).collect();
            self.push(start + (right - from), coef, waves);
        }
    }

    /// Sets the end of the last span exactly, to remove the rounding errors of sums.
    pub fn end_exactly_at(&mut self, end: f64) {
        if let Some(last) = self.breaks.last_mut() {
            *last = end;
        }
    }

    /// Law that consists of the spans. At least one span is necessary.
    pub fn finish(self, closed: bool) -> Law {
        let degree = self.coef.iter().map(|c| c.len() - 1).max().unwrap_or(0);
        let elevated = self.coef.iter().flat_map(|c| bernstein::elevate(c, degree));
        let poly = PiecewisePoly::new(self.breaks, degree, elevated.collect());
        Law::with_waves(poly, self.waves, closed)
    }
}
