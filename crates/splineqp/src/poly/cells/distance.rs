//! Distance between a piecewise polynomial and cells, without building their difference.

use pulp::{Arch, Simd, WithSimd};

use super::Cells;
use super::rule::{Rule, restricted};
use crate::poly::{PiecewisePoly, bernstein};

/// A break nearer to the end of a cell than this, in cells, counts as that end.
const SAME: f64 = 1e-9;
/// Relative rounding error of a value at a node.
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
        match own.degree() + 1 {
            0..=4 => Search::<4>::new(self, own).distance(),
            5..=6 => Search::<6>::new(self, own).distance(),
            7..=8 => Search::<8>::new(self, own).distance(),
            9..=12 => Search::<12>::new(self, own).distance(),
            _ => Search::<32>::new(self, own).distance(),
        }
    }
}

/// A range of one cell on one piece of the polynomial; its ends in cells.
struct Part {
    piece: usize,
    cell: usize,
    from: f64,
    to: f64,
    /// Upper bound of the absolute difference on a whole cell; infinite on a part of one.
    bound: f64,
}

/// The search for the distance of a piecewise polynomial from cells.
///
/// On whole cells the square is summed at nodes of a quadrature that is exact for it. The largest difference lies at the end
/// of a piece or where its slope is zero; from there to a node of the same cell it changes by ½·gap²·max|d″| at most. That
/// bound leaves few cells in which the largest difference is computed from roots.
struct Search<'a, const Q: usize> {
    cells: &'a Cells,
    own: &'a PiecewisePoly,
    rule: Rule<Q>,
    /// Binomials of the pieces' degree.
    binomials: Vec<f64>,
    parts: Vec<Part>,
    /// Largest difference at a node.
    level: f64,
    square: f64,
}

/// Whole cells of one piece. A type of its own, because a closure is not sure to be compiled for the processor's vectors.
struct Whole<'s, 'a, const Q: usize> {
    search: &'s mut Search<'a, Q>,
    piece: usize,
    ends: (f64, f64),
    cells: std::ops::Range<usize>,
}

impl<const Q: usize> WithSimd for Whole<'_, '_, Q> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.search.add_whole(self.piece, self.ends, self.cells);
    }
}

impl<'a, const Q: usize> Search<'a, Q> {
    fn new(cells: &'a Cells, own: &'a PiecewisePoly) -> Self {
        let n = own.degree();
        Search {
            cells,
            own,
            rule: Rule::new(),
            binomials: (0..=n).map(|k| bernstein::binomial(n, k)).collect(),
            parts: Vec::with_capacity(cells.count() + 2 * own.pieces()),
            level: 0.0,
            square: 0.0,
        }
    }

    fn distance(mut self) -> Distance {
        (0..self.own.pieces()).for_each(|piece| self.visit(piece));
        let scale = self.cells.per_length();
        let least = self.level * (1.0 - ROUNDING);
        let n = self.own.degree().max(3);
        let gram = bernstein::gram(n);
        let (mut of_parts, mut largest) = (0.0, 0.0);
        let (mut difference, mut other) = (vec![0.0; n + 1], vec![0.0; n + 1]);
        for part in self.parts.iter().filter(|p| p.bound >= least) {
            self.difference(part, &mut difference, &mut other);
            if part.bound.is_infinite() {
                of_parts += (part.to - part.from) / scale * bernstein::square(&gram, &difference);
            }
            for _ in 0..2 {
                let level = largest;
                bernstein::peaks_above(&difference, level, |_, value| largest = value.max(largest));
                difference.iter_mut().for_each(|d| *d = -*d);
            }
        }
        Distance {
            square: self.square / scale + of_parts,
            largest,
        }
    }

    /// Splits a piece at the ends of the cells.
    fn visit(&mut self, piece: usize) {
        let scale = self.cells.per_length();
        let ends = &self.own.breaks()[piece..piece + 2];
        let (start, end) = (ends[0] * scale, ends[1] * scale);
        let (first, last) = ((start - SAME).ceil(), (end + SAME).floor());
        if last < first {
            self.add_part(piece, start, end);
            return;
        }
        if first - start > SAME {
            self.add_part(piece, start, first);
        }
        if last > first {
            let cells = first as usize..last as usize;
            let search = &mut *self;
            Arch::new().dispatch(Whole {
                search,
                piece,
                ends: (start, end),
                cells,
            });
        }
        if end - last > SAME {
            self.add_part(piece, last, end);
        }
    }

    fn add_part(&mut self, piece: usize, from: f64, to: f64) {
        self.parts.push(Part {
            piece,
            cell: self.cells.cell(from),
            from,
            to,
            bound: f64::INFINITY,
        });
    }

    /// Whole cells of one piece, one or more, at the rule's nodes.
    #[inline(always)]
    fn add_whole(&mut self, piece: usize, (start, end): (f64, f64), cells: std::ops::Range<usize>) {
        let own = self.own.piece(piece);
        let scaled: Vec<f64> = own
            .iter()
            .zip(&self.binomials)
            .map(|(b, c)| b * c)
            .collect();
        let (width, gap) = (end - start, self.rule.widest_gap());
        let (bend, reach) = (second_derivative(own) / (width * width), 0.5 * gap * gap);
        let (first, step) = ((cells.start as f64 - start) / width, 1.0 / width);
        let (count, before) = (cells.len(), self.parts.len());
        let (mut squares, mut highest) = ([0.0; Q], [self.level; Q]);
        for (i, cell) in cells.clone().enumerate() {
            let ends = self.cells.ends(cell);
            let target = self.rule.on_cell(&ends);
            let from = first + i as f64 * step;
            let own = values(&scaled, self.rule.places(from, from + step));
            let mut most = [0.0; Q];
            for q in 0..Q {
                let d = own[q] - target[q];
                squares[q] += d * d;
                most[q] = d.abs();
                highest[q] = larger(most[q], highest[q]);
            }
            let here = most.iter().fold(0.0, |m: f64, d| larger(*d, m));
            let [f0, s0, f1, s1] = ends;
            let rise = 3.0 * (f1 - f0);
            let bends = [rise - 2.0 * s0 - s1, s0 + 2.0 * s1 - rise].map(f64::abs);
            let bent = 2.0 * larger(bends[1], bends[0]);
            self.parts.push(Part {
                piece,
                cell,
                from: cell as f64,
                to: cell as f64 + 1.0,
                bound: here + reach * (bend + bent),
            });
        }
        let last = first + count as f64 * step;
        let at = |cell: usize| self.cells.values[cell];
        for (i, place, target) in [
            (before, first, at(cells.start)),
            (before + count - 1, last, at(cells.end)),
        ] {
            let [own] = values(&scaled, [place]);
            let bound = &mut self.parts[i].bound;
            *bound = (own - target).abs().max(*bound);
        }
        let weighted = squares.iter().zip(&self.rule.weights).map(|(s, w)| s * w);
        self.square += weighted.sum::<f64>();
        self.level = highest.iter().fold(0.0, |m, x| m.max(*x));
    }

    /// The difference on a part, in Bernstein form.
    fn difference(&self, part: &Part, difference: &mut [f64], other: &mut [f64]) {
        let scale = self.cells.per_length();
        let ends = &self.own.breaks()[part.piece..part.piece + 2];
        let (start, end) = (ends[0] * scale, ends[1] * scale);
        let place = |x: f64| (x - start) / (end - start);
        let range = (place(part.from), place(part.to));
        restricted(self.own.piece(part.piece), range, difference);
        let base = part.cell as f64;
        let range = (part.from - base, part.to - base);
        restricted(&self.cells.cubic(part.cell), range, other);
        for (d, o) in difference.iter_mut().zip(other) {
            *d -= *o;
        }
    }
}

/// Maximum without the handling of NaN that [`f64::max`] has, which costs vector code.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Upper bound of |d²/du²| by the Bernstein coefficients.
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
