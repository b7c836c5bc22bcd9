//! How far two piecewise polynomials are apart, without building their difference.

use super::bernstein::{self, binomial};
use super::piecewise::PiecewisePoly;

/// Breaks nearer than this part of the range are one.
const SAME: f64 = 1e-13;

/// Distance of two functions over their common range, exact up to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distance {
    /// Integral of the squared difference.
    pub square: f64,
    /// Largest absolute difference.
    pub largest: f64,
}

/// The distance of two functions on the same range, whatever their breaks and degrees.
pub fn distance(a: &PiecewisePoly, b: &PiecewisePoly) -> Distance {
    let n = a.degree().max(b.degree());
    let gram = gram(n);
    let (xa, xb) = (a.breaks(), b.breaks());
    let same = SAME * (xa[xa.len() - 1] - xa[0]);
    let mut out = Distance::default();
    let (mut difference, mut other) = (vec![0.0; n + 1], vec![0.0; n + 1]);
    let (mut i, mut k) = (0, 0);
    let mut from = xa[0].max(xb[0]);
    while i < a.pieces() && k < b.pieces() {
        let to = xa[i + 1].min(xb[k + 1]);
        if to - from > same {
            restricted(a, i, from, to, &mut difference);
            restricted(b, k, from, to, &mut other);
            for (d, o) in difference.iter_mut().zip(&other) {
                *d -= o;
            }
            out.square += (to - from) * square(&gram, &difference);
            let (low, high) = bernstein::hull(&difference);
            if high.max(-low) > out.largest {
                raise(&difference, &mut out.largest);
                difference.iter_mut().for_each(|d| *d = -*d);
                raise(&difference, &mut out.largest);
            }
            from = to;
        }
        if xa[i + 1] - to <= same {
            i += 1;
        }
        if xb[k + 1] - to <= same {
            k += 1;
        }
    }
    out
}

/// Lifts `largest` to the highest value on [0, 1], where that is higher.
fn raise(b: &[f64], largest: &mut f64) {
    let level = *largest;
    bernstein::peaks_above(b, level, |_, value| *largest = largest.max(value));
}

/// Coefficients of one piece on [from, to], written in the degree that `out` has room for.
fn restricted(f: &PiecewisePoly, piece: usize, from: f64, to: f64, out: &mut [f64]) {
    let (start, end) = (f.breaks()[piece], f.breaks()[piece + 1]);
    let own = f.degree();
    let c = &mut out[..=own];
    c.copy_from_slice(f.piece(piece));
    let width = end - start;
    let (low, high) = ((from - start) / width, (to - start) / width);
    if high < 1.0 {
        for k in 1..=own {
            for i in (k..=own).rev() {
                c[i] += (1.0 - high) * (c[i - 1] - c[i]);
            }
        }
    }
    if low > 0.0 {
        let u = low / high.min(1.0);
        for k in 1..=own {
            for i in 0..=own - k {
                c[i] += u * (c[i + 1] - c[i]);
            }
        }
    }
    for m in own + 1..out.len() {
        out[m] = out[m - 1];
        for i in (1..m).rev() {
            let t = i as f64 / m as f64;
            out[i] = t * out[i - 1] + (1.0 - t) * out[i];
        }
    }
}

/// ∫ BᵢBⱼ over [0, 1] of the Bernstein polynomials of degree n, row by row.
fn gram(n: usize) -> Vec<f64> {
    let at = |i: usize, j: usize| {
        binomial(n, i) * binomial(n, j) / (binomial(2 * n, i + j) * (2 * n + 1) as f64)
    };
    (0..(n + 1) * (n + 1))
        .map(|k| at(k / (n + 1), k % (n + 1)))
        .collect()
}

fn square(gram: &[f64], d: &[f64]) -> f64 {
    let rows = gram.chunks_exact(d.len()).zip(d);
    rows.map(|(row, own)| own * row.iter().zip(d).map(|(g, d)| g * d).sum::<f64>())
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(n: usize, degree: usize, phase: f64) -> PiecewisePoly {
        let breaks = (0..=n)
            .map(|i| 3.0 * (i as f64 / n as f64).powf(1.1))
            .collect();
        let coef = (0..n * (degree + 1))
            .map(|i| (i as f64 * 0.7 + phase).sin())
            .collect();
        PiecewisePoly::new(breaks, degree, coef)
    }

    #[test]
    fn distance_is_that_of_the_difference_built_piece_by_piece() {
        for (n, p, m, q) in [(7, 3, 5, 5), (1, 1, 40, 3), (12, 4, 12, 2), (3, 9, 50, 3)] {
            let (a, b) = (wave(n, p, 0.3), wave(m, q, 1.1));
            let own = a.cut_at(b.breaks());
            let difference =
                PiecewisePoly::combine(&[(1.0, &own), (-1.0, &b.cut_at(own.breaks()))], 0.0);
            let (low, high) = difference.extremes();
            let found = distance(&a, &b);
            let square = difference.integral_of_square();
            assert!(
                (found.square / square - 1.0).abs() < 1e-12,
                "{found:?} {square}"
            );
            let largest = high.value.max(-low.value);
            assert!(
                (found.largest / largest - 1.0).abs() < 1e-12,
                "{found:?} {largest}"
            );
        }
    }

    #[test]
    fn a_function_is_no_distance_from_itself_cut_finer() {
        let a = wave(9, 5, 0.2);
        let breaks: Vec<f64> = (1..100).map(|i| 0.03 * f64::from(i)).collect();
        let found = distance(&a, &a.cut_at(&breaks));
        assert!(found.largest < 1e-14 && found.square < 1e-28, "{found:?}");
    }
}
