//! How far a piecewise polynomial is from cells, without building the difference.

use pulp::{Arch, NullaryFnOnce};

use super::Cells;
use super::rule::{Rule, restricted};
use crate::poly::{PiecewisePoly, bernstein};

/// Breaks nearer to the end of a cell than this part of it stand there.
const SAME: f64 = 1e-9;
/// What rounding may take of a value at a node, relative.
const ROUNDING: f64 = 1e-9;

/// Distance of two functions over their common range, exact up to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Integral of the squared difference.
    pub square: f64,
    /// Largest absolute difference.
    pub largest: f64,
}

impl Cells {
    /// Distance from a piecewise polynomial on the first period.
    pub fn distance(&self, own: &PiecewisePoly) -> Distance {
        let degree = own.degree().max(3);
        match degree + 1 {
            0..=4 => Search::<4>::new(self, own).distance(),
            5..=6 => Search::<6>::new(self, own).distance(),
            7..=8 => Search::<8>::new(self, own).distance(),
            9..=12 => Search::<12>::new(self, own).distance(),
            _ => Search::<32>::new(self, own).distance(),
        }
    }
}

/// A range on one cell and one piece of the other function.
struct Part {
    piece: usize,
    cell: usize,
    from: f64,
    to: f64,
}

/// A whole cell on which no difference is larger than `bound`.
struct Seen {
    piece: usize,
    cell: usize,
    bound: f64,
}

/// The search for the distance of a piecewise polynomial from cells.
///
/// On whole cells the square is summed at nodes that make it exact. The largest difference lies at the end of a piece or
/// where its slope is zero; from there to a node of the same cell it changes by ½·gap²·max|d″| at most. So few cells
/// remain in which it is sought exactly.
struct Search<'a, const Q: usize> {
    cells: &'a Cells,
    own: &'a PiecewisePoly,
    rule: Rule<Q>,
    /// Binomials of the pieces' degree.
    binomials: Vec<f64>,
    parts: Vec<Part>,
    seen: Vec<Seen>,
    /// Largest difference at a node.
    level: f64,
    square: f64,
}

impl<'a, const Q: usize> Search<'a, Q> {
    fn new(cells: &'a Cells, own: &'a PiecewisePoly) -> Self {
        let n = own.degree();
        Search {
            cells,
            own,
            rule: Rule::new(),
            binomials: (0..=n).map(|k| bernstein::binomial(n, k)).collect(),
            parts: Vec::new(),
            seen: Vec::with_capacity(cells.count()),
            level: 0.0,
            square: 0.0,
        }
    }

    fn distance(mut self) -> Distance {
        for piece in 0..self.own.pieces() {
            self.visit(piece);
        }
        self.square /= self.cells.per_length();
        self.add_parts();
        let least = self.level * (1.0 - ROUNDING);
        let mut largest = 0.0;
        let likely = self.seen.iter().filter(|s| s.bound >= least);
        let likely = likely.map(|s| (s.piece, s.cell, s.cell as f64, s.cell as f64 + 1.0));
        let parts = (self.parts.iter()).map(|p| (p.piece, p.cell, p.from, p.to));
        let mut difference = vec![0.0; self.own.degree().max(3) + 1];
        let mut other = difference.clone();
        for (piece, cell, from, to) in likely.chain(parts) {
            self.difference((piece, cell, from, to), &mut difference, &mut other);
            raise(&difference, &mut largest);
            difference.iter_mut().for_each(|d| *d = -*d);
            raise(&difference, &mut largest);
        }
        Distance {
            square: self.square,
            largest,
        }
    }

    /// Whole cells of a piece at the rule's nodes; the parts of cells at its ends are kept for later.
    fn visit(&mut self, piece: usize) {
        let scale = self.cells.per_length();
        let ends = &self.own.breaks()[piece..piece + 2];
        let (start, end) = (ends[0] * scale, ends[1] * scale);
        let (first, last) = ((start - SAME).ceil(), (end + SAME).floor());
        if last < first {
            let cell = self.cells.cell(start);
            self.part(piece, cell, start, end);
            return;
        }
        if first - start > SAME {
            self.part(piece, self.cells.cell(start), start, first);
        }
        if last > first {
            self.whole(piece, (start, end), first as usize..last as usize);
        }
        if end - last > SAME {
            self.part(piece, self.cells.cell(last), last, end);
        }
    }

    fn part(&mut self, piece: usize, cell: usize, from: f64, to: f64) {
        self.parts.push(Part {
            piece,
            cell,
            from,
            to,
        });
    }

    fn whole(&mut self, piece: usize, (start, end): (f64, f64), cells: std::ops::Range<usize>) {
        let scaled: Vec<f64> = (self.own.piece(piece).iter())
            .zip(&self.binomials)
            .map(|(b, c)| b * c)
            .collect();
        let width = end - start;
        let bend = second_derivative(self.own.piece(piece)) / (width * width);
        let found = Arch::new().dispatch(Differences {
            rule: &self.rule,
            values: &self.cells.values[cells.start..=cells.end],
            slopes: &self.cells.slopes[cells.start..=cells.end],
            piece: &scaled,
            first: (cells.start as f64 - start) / width,
            step: 1.0 / width,
            bend,
            level: self.level,
        });
        self.square += found.square;
        self.level = found.level;
        let seen = cells.zip(found.bounds);
        let seen = seen.map(|(cell, bound)| Seen { piece, cell, bound });
        self.seen.extend(seen);
    }

    /// Parts of cells add their squares in Bernstein form, which is exact on any range.
    fn add_parts(&mut self) {
        let n = self.own.degree().max(3);
        let gram = bernstein::gram(n);
        let mut difference = vec![0.0; n + 1];
        let mut other = difference.clone();
        let scale = self.cells.per_length();
        let mut sum = 0.0;
        for p in &self.parts {
            self.difference((p.piece, p.cell, p.from, p.to), &mut difference, &mut other);
            let rows = gram.chunks_exact(n + 1).zip(&difference);
            let square: f64 = rows
                .map(|(row, own)| {
                    own * row.iter().zip(&difference).map(|(g, d)| g * d).sum::<f64>()
                })
                .sum();
            sum += (p.to - p.from) / scale * square;
        }
        self.square += sum;
    }

    /// The difference on a range of one cell, in Bernstein form.
    fn difference(
        &self,
        (piece, cell, from, to): (usize, usize, f64, f64),
        difference: &mut [f64],
        other: &mut [f64],
    ) {
        let scale = self.cells.per_length();
        let ends = &self.own.breaks()[piece..piece + 2];
        let (start, end) = (ends[0] * scale, ends[1] * scale);
        let place = |x: f64| (x - start) / (end - start);
        restricted(self.own.piece(piece), (place(from), place(to)), difference);
        let base = cell as f64;
        restricted(&self.cells.cubic(cell), (from - base, to - base), other);
        for (d, o) in difference.iter_mut().zip(other) {
            *d -= *o;
        }
    }
}

/// The differences on whole cells of one piece, one or more.
struct Differences<'a, const Q: usize> {
    rule: &'a Rule<Q>,
    /// At the ends of the cells.
    values: &'a [f64],
    slopes: &'a [f64],
    /// Bernstein coefficients times their binomials.
    piece: &'a [f64],
    /// Place on the piece at the first cell's start, and the step by a cell.
    first: f64,
    step: f64,
    /// Largest |second derivative| of the piece by cells.
    bend: f64,
    level: f64,
}

/// What they are.
struct Found {
    square: f64,
    /// Largest at a node, or the level before.
    level: f64,
    /// What none on a cell exceeds.
    bounds: Vec<f64>,
}

impl<const Q: usize> NullaryFnOnce for Differences<'_, Q> {
    type Output = Found;

    #[inline(always)]
    fn call(self) -> Found {
        let gap = self.rule.widest_gap();
        let reach = 0.5 * gap * gap;
        let (f, s) = (self.values, self.slopes);
        let count = f.len() - 1;
        let mut bounds = Vec::with_capacity(count);
        let (mut squares, mut highest) = ([0.0; Q], [self.level; Q]);
        for i in 0..count {
            let ends = [f[i], s[i], f[i + 1], s[i + 1]];
            let wanted = self.rule.on_cell(&ends);
            let from = self.first + i as f64 * self.step;
            let own = values(self.piece, self.rule.places(from, from + self.step));
            let mut most = [0.0; Q];
            for q in 0..Q {
                let d = own[q] - wanted[q];
                squares[q] += d * d;
                most[q] = d.abs();
                highest[q] = if most[q] > highest[q] {
                    most[q]
                } else {
                    highest[q]
                };
            }
            let here = most
                .iter()
                .fold(0.0, |m: f64, d| if *d > m { *d } else { m });
            let [f0, s0, f1, s1] = ends;
            let rise = 3.0 * (f1 - f0);
            let bends = [rise - 2.0 * s0 - s1, s0 + 2.0 * s1 - rise].map(f64::abs);
            let bent = 2.0
                * if bends[1] > bends[0] {
                    bends[1]
                } else {
                    bends[0]
                };
            bounds.push(here + reach * (self.bend + bent));
        }
        let end = self.first + count as f64 * self.step;
        for (i, place, wanted) in [(0, self.first, f[0]), (count - 1, end, f[count])] {
            let [own] = values(self.piece, [place]);
            bounds[i] = (own - wanted).abs().max(bounds[i]);
        }
        let weighed = squares.iter().zip(&self.rule.weights).map(|(s, w)| s * w);
        Found {
            square: weighed.sum(),
            level: highest.iter().fold(0.0, |m, x| m.max(*x)),
            bounds,
        }
    }
}

/// Largest |second derivative| by u that the Bernstein coefficients allow.
fn second_derivative(b: &[f64]) -> f64 {
    let n = (b.len() - 1) as f64;
    let bends = b.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs());
    n * (n - 1.0) * bends.fold(0.0, f64::max)
}

/// Values of Σ cₖ uᵏ(1−u)ⁿ⁻ᵏ (binomials already in cₖ).
#[inline(always)]
fn values<const Q: usize>(c: &[f64], u: [f64; Q]) -> [f64; Q] {
    let mut power = [1.0; Q];
    let mut sum = [c[0]; Q];
    for &ck in &c[1..] {
        for q in 0..Q {
            power[q] *= u[q];
            sum[q] = sum[q] * (1.0 - u[q]) + power[q] * ck;
        }
    }
    sum
}

/// Lifts `largest` to the highest value on [0, 1], where that is higher.
fn raise(b: &[f64], largest: &mut f64) {
    let level = *largest;
    bernstein::peaks_above(b, level, |_, value| *largest = largest.max(value));
}
