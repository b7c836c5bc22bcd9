//! Piecewise Chebyshev interpolants of smooth functions, used to compute extremes from roots instead of samples.

use std::f64::consts::PI;

use super::{PiecewisePoly, bernstein};

/// Degree of the interpolant on each part. A part is halved until this degree is sufficient.
const DEGREE: usize = 12;
/// Maximum number of halvings of a part, reached at a cusp or jump inside a piece.
const MAX_HALVINGS: u32 = 30;
/// Maximum number of parts of one piece. A cusp needs one part per halving. For a function with noise, no number would be sufficient.
const MOST_PARTS: usize = 512;
/// Fraction of the scale below which the last coefficients are rounding noise of the function, if halving does not reduce them.
const NOISE: f64 = 1e-9;

/// Piecewise polynomial that agrees with `f` to about `tolerance` times the scale of `f` on every interval of `breaks`. `f` must be smooth
/// between the breaks. It is evaluated only strictly inside the intervals, with the index of the interval.
///
/// The function is interpolated at Chebyshev points, and intervals are halved until the last coefficients are negligible.
pub fn stand_in(breaks: &[f64], tolerance: f64, f: impl Fn(usize, f64) -> f64) -> PiecewisePoly {
    let transform = Transform::new();
    let first: Vec<Values> = (breaks.windows(2).enumerate())
        .map(|(piece, w)| transform.nodes_on([w[0], w[1]]).map(|x| f(piece, x)))
        .collect();
    joined(&transform, breaks, tolerance, 0.0, &first, f)
}

/// Piecewise polynomials, computed as in [`stand_in`], for several functions that are evaluated together. Each function is a difference of
/// large terms. `terms` contains the sizes of these terms, because their rounding errors limit the accuracy.
pub fn stand_ins_for_differences(
    breaks: &[f64],
    tolerance: f64,
    terms: &[f64],
    f: impl Fn(usize, f64) -> Vec<f64>,
) -> Vec<PiecewisePoly> {
    let transform = Transform::new();
    let mut first = vec![vec![[0.0; DEGREE + 1]; breaks.len() - 1]; terms.len()];
    for (piece, w) in breaks.windows(2).enumerate() {
        let nodes = transform.nodes_on([w[0], w[1]]);
        for (node, x) in nodes.into_iter().enumerate() {
            for (own, value) in first.iter_mut().zip(f(piece, x)) {
                own[piece][node] = value;
            }
        }
    }
    let each = first.iter().zip(terms).enumerate();
    each.map(|(k, (first, terms))| {
        let own = |piece: usize, x: f64| f(piece, x)[k];
        joined(&transform, breaks, tolerance, *terms, first, own)
    })
    .collect()
}

/// Values of a function at the nodes of a part.
type Values = [f64; DEGREE + 1];

/// Interpolant of a function. `first` contains the values of the function at the nodes of whole intervals.
fn joined(
    transform: &Transform,
    breaks: &[f64],
    tolerance: f64,
    terms: f64,
    first: &[Values],
    f: impl Fn(usize, f64) -> f64,
) -> PiecewisePoly {
    let mut out_breaks = vec![breaks[0]];
    let mut coef = Vec::new();
    // The scale of the whole function is determined first. Relative to its own scale, a piece that contains only rounding errors (a dwell) would be
    // halved up to the maximum depth.
    let sizes = first.iter().flatten().map(|value| value.abs());
    let mut scale = sizes.filter(|s| s.is_finite()).fold(terms, f64::max);
    for (piece, (w, values)) in breaks.windows(2).zip(first).enumerate() {
        let whole = Part::of(transform, values, [w[0], w[1]], (f64::INFINITY, 0));
        let on_piece = |x: f64| f(piece, x);
        for part in parts(transform, &on_piece, whole, tolerance, &mut scale) {
            out_breaks.push(part.ends[1]);
            coef.extend(transform.bernstein(&part.chebyshev));
        }
    }
    PiecewisePoly::new(out_breaks, DEGREE, coef)
}

struct Transform {
    nodes: [f64; DEGREE + 1],
    /// Values of the Chebyshev polynomials T_k at the nodes.
    waves: [[f64; DEGREE + 1]; DEGREE + 1],
    /// Bernstein coefficients of the Chebyshev polynomials T_k(2u − 1).
    chebyshev: Vec<Vec<f64>>,
}

impl Transform {
    fn new() -> Self {
        let n = DEGREE + 1;
        let mut nodes = [0.0; DEGREE + 1];
        for (i, x) in nodes.iter_mut().enumerate() {
            *x = libm::cos(PI * (i as f64 + 0.5) / n as f64);
        }
        let chebyshev = (0..=DEGREE)
            .map(|k| {
                let own: Vec<f64> = (0..=k)
                    .map(|i| {
                        let sign = if (k - i) % 2 == 0 { 1.0 } else { -1.0 };
                        sign * bernstein::binomial(2 * k, 2 * i) / bernstein::binomial(k, i)
                    })
                    .collect();
                bernstein::elevate(&own, DEGREE)
            })
            .collect();
        let waves = std::array::from_fn(|k| {
            std::array::from_fn(|i| libm::cos(PI * k as f64 * (i as f64 + 0.5) / n as f64))
        });
        Transform {
            nodes,
            waves,
            chebyshev,
        }
    }

    /// Chebyshev nodes on the interval [a, b].
    fn nodes_on(&self, [a, b]: [f64; 2]) -> [f64; DEGREE + 1] {
        self.nodes.map(|x| a + (b - a) * 0.5 * (1.0 + x))
    }

    /// Chebyshev coefficients of the interpolant for the given values at the nodes.
    fn of(&self, values: &Values) -> [f64; DEGREE + 1] {
        std::array::from_fn(|k| {
            let terms = values.iter().zip(&self.waves[k]);
            let sum: f64 = terms.map(|(v, wave)| v * wave).sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / (DEGREE + 1) as f64
        })
    }

    /// Bernstein coefficients of a polynomial in Chebyshev form.
    fn bernstein(&self, chebyshev: &[f64; DEGREE + 1]) -> [f64; DEGREE + 1] {
        let mut out = [0.0; DEGREE + 1];
        for (c, row) in chebyshev.iter().zip(&self.chebyshev) {
            for (o, r) in out.iter_mut().zip(row) {
                *o += c * r;
            }
        }
        out
    }
}

/// Chebyshev interpolant on one part of a piece.
struct Part {
    ends: [f64; 2],
    chebyshev: [f64; DEGREE + 1],
    /// Maximum absolute value of the function at the nodes.
    largest: f64,
    /// Maximum absolute value of the last coefficients. The next field is the same maximum before the last halving.
    tail: f64,
    parent_tail: f64,
    halvings: u32,
}

impl Part {
    fn of(
        transform: &Transform,
        values: &Values,
        ends: [f64; 2],
        (parent_tail, halvings): (f64, u32),
    ) -> Part {
        let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let chebyshev = transform.of(values);
        let last = &chebyshev[DEGREE - 2..];
        Part {
            ends,
            chebyshev,
            largest,
            tail: last.iter().fold(0.0_f64, |m, x| m.max(x.abs())),
            parent_tail,
            halvings,
        }
    }

    /// Whether the part needs a further halving and the halving would reduce the error.
    fn is_rough(&self, tolerance: f64, scale: f64) -> bool {
        let [a, b] = self.ends;
        let mid = 0.5 * (a + b);
        let splittable =
            self.halvings < MAX_HALVINGS && mid > a && mid < b && self.largest.is_finite();
        let noise = self.tail < NOISE * scale && self.tail > 0.5 * self.parent_tail;
        self.tail > tolerance * scale && splittable && !noise
    }
}

/// Divides a piece into parts and returns them from left to right. The part with the largest error is halved until all parts are accurate
/// or their maximum number is reached.
fn parts(
    transform: &Transform,
    f: &impl Fn(f64) -> f64,
    whole: Part,
    tolerance: f64,
    scale: &mut f64,
) -> Vec<Part> {
    *scale = scale.max(whole.largest);
    let mut rough: Vec<Part> = vec![whole];
    let mut done: Vec<Part> = Vec::new();
    while !rough.is_empty() && rough.len() + done.len() < MOST_PARTS {
        let by_tail = |a: &usize, b: &usize| rough[*a].tail.total_cmp(&rough[*b].tail);
        let roughest = (0..rough.len()).max_by(by_tail).unwrap_or(0);
        let part = rough.swap_remove(roughest);
        if !part.is_rough(tolerance, *scale) {
            done.push(part);
            continue;
        }
        let [a, b] = part.ends;
        let mid = 0.5 * (a + b);
        let from = (part.tail, part.halvings + 1);
        for ends in [[a, mid], [mid, b]] {
            let values = transform.nodes_on(ends).map(f);
            let half = Part::of(transform, &values, ends, from);
            *scale = scale.max(half.largest);
            rough.push(half);
        }
    }
    done.append(&mut rough);
    done.sort_by(|p, q| p.ends[0].total_cmp(&q.ends[0]));
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_of_the_function_is_not_halved_for_ever() {
        // The digits of the function beyond the eleventh are arbitrary.
        let f = |_: usize, x: f64| x.sin() + 1e-11 * (1e7 * x).sin();
        let p = stand_in(&[0.0, 3.0], 1e-13, f);
        assert!(p.pieces() < 100, "{}", p.pieces());
        assert!((p.extremes().1.value - 1.0).abs() < 1e-10);
    }

    #[test]
    fn rounding_of_large_terms_is_not_halved_for_ever() {
        // The function is 1 + x − 1 with rounding. Its small values have the noise of 1.
        let f = |_: usize, x: f64| vec![(1.0 + 1e-7 * x.sin()) - 1.0];
        let p = &stand_ins_for_differences(&[0.0, 3.0], 1e-11, &[1.0], f)[0];
        assert!(p.pieces() < 10, "{}", p.pieces());
        assert!((p.extremes().1.value - 1e-7).abs() < 1e-11);
    }

    #[test]
    fn extremes_of_a_rational_function_are_found_to_twelve_digits() {
        // x/(1 + x²) on [−3, 5] has the extremes ±½ at ±1.
        let p = stand_in(&[-3.0, 0.5, 5.0], 1e-13, |_, x| x / (1.0 + x * x));
        let (low, high) = p.extremes();
        assert!((high.value - 0.5).abs() < 1e-12 && (low.value + 0.5).abs() < 1e-12);
        assert!((high.at - 1.0).abs() < 1e-6 && (low.at + 1.0).abs() < 1e-6);
    }
}
