//! One polynomial on u ∈ [0, 1] in Bernstein form.
//!
//! Coefficients `b[0..=n]` stand for Σ bₖ C(n,k) uᵏ (1−u)ⁿ⁻ᵏ. The polynomial lies between the smallest
//! and the largest coefficient; both end coefficients are its end values.

/// Depth at which halving an interval of 1 no longer changes its ends.
const MAX_DEPTH: u32 = 54;

/// Coefficients of a polynomial that needs no memory of its own.
const SHORT: usize = 16;

/// Binomial coefficients of the degrees below [`SHORT`].
const BINOMIALS: [[f64; SHORT]; SHORT] = {
    let mut rows = [[0.0; SHORT]; SHORT];
    let mut n = 0;
    while n < SHORT {
        rows[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    rows
};

/// Value at `u`; stable for u in [0, 1], valid outside.
pub fn eval(b: &[f64], u: f64) -> f64 {
    let n = b.len() - 1;
    if n == 0 {
        return b[0];
    }
    let v = 1.0 - u;
    if let Some(row) = BINOMIALS.get(n) {
        let mut power = 1.0;
        let mut sum = b[0] * v;
        for (bi, binomial) in b[1..n].iter().zip(&row[1..n]) {
            power *= u;
            sum = (sum + power * binomial * bi) * v;
        }
        return sum + power * u * b[n];
    }
    let mut power = 1.0;
    let mut binomial = 1.0;
    let mut sum = b[0] * v;
    for (i, &bi) in b.iter().enumerate().take(n).skip(1) {
        power *= u;
        binomial *= (n - i + 1) as f64 / i as f64;
        sum = (sum + power * binomial * bi) * v;
    }
    sum + power * u * b[n]
}

/// Coefficients of d/du, one degree lower (a constant gives `[0]`).
pub fn derivative(b: &[f64]) -> Vec<f64> {
    let n = b.len() - 1;
    if n == 0 {
        return vec![0.0];
    }
    b.windows(2).map(|w| (w[1] - w[0]) * n as f64).collect()
}

/// Coefficients of the antiderivative in u that is 0 at u = 0, one degree higher.
pub fn antiderivative(b: &[f64]) -> Vec<f64> {
    let scale = 1.0 / b.len() as f64;
    let mut out = Vec::with_capacity(b.len() + 1);
    let mut sum = 0.0;
    out.push(sum);
    for &bi in b {
        sum += bi * scale;
        out.push(sum);
    }
    out
}

/// The same polynomial written at degree `to` (at least its own). A constant stays one, to the last bit.
pub fn elevate(b: &[f64], to: usize) -> Vec<f64> {
    let mut out = Vec::with_capacity(to.max(b.len()) + 1);
    out.extend_from_slice(b);
    for n in b.len()..=to {
        out.push(out[n - 1]);
        for i in (1..n).rev() {
            out[i] += (i as f64 / n as f64) * (out[i - 1] - out[i]);
        }
    }
    out
}

/// Product of two polynomials; the degrees add.
pub fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let (m, n) = (a.len() - 1, b.len() - 1);
    let mut out = vec![0.0; m + n + 1];
    let second: Vec<f64> = b.iter().zip(binomials(n)).map(|(b, c)| b * c).collect();
    for (i, (ai, c)) in a.iter().zip(binomials(m)).enumerate() {
        let ai = ai * c;
        for (o, bj) in out[i..].iter_mut().zip(&second) {
            *o += ai * bj;
        }
    }
    for (value, c) in out.iter_mut().zip(binomials(m + n)) {
        *value /= c;
    }
    out
}

/// C(n, k) for k = 0 … n, each from the one before; exact up to 2⁵³.
fn binomials(n: usize) -> impl Iterator<Item = f64> {
    (0..=n).scan(1.0, move |c, k| {
        let this = *c;
        *c = this * (n - k) as f64 / (k + 1) as f64;
        Some(this)
    })
}

/// ∫ of the product of two basis polynomials of degree n over [0, 1], row by row:
/// C(n, i)·C(n, j)/C(2n, i + j)/(2n + 1).
pub fn gram(n: usize) -> Vec<f64> {
    let rows: Vec<f64> = binomials(n).collect();
    let sums: Vec<f64> = binomials(2 * n).collect();
    let unit = 1.0 / (2 * n + 1) as f64;
    (0..=n)
        .flat_map(|i| (0..=n).map(move |j| (i, j)))
        .map(|(i, j)| rows[i] * rows[j] / sums[i + j] * unit)
        .collect()
}

/// Binomial coefficient as a float; exact up to 2⁵³.
pub fn binomial(n: usize, k: usize) -> f64 {
    let k = k.min(n - k);
    (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64)
}

/// Bernstein coefficients on u ∈ [0, 1] of Σ pₖ uᵏ.
pub fn from_power(p: &[f64]) -> Vec<f64> {
    let n = p.len() - 1;
    (0..=n)
        .map(|i| {
            (0..=i)
                .map(|k| p[k] * binomial(i, k) / binomial(n, k))
                .sum()
        })
        .collect()
}

/// Monomial coefficients pₖ of Σ pₖ uᵏ: for output only, monomials lose digits.
pub fn to_power(b: &[f64]) -> Vec<f64> {
    let n = b.len() - 1;
    let mut differences = b.to_vec();
    let mut out = Vec::with_capacity(n + 1);
    for k in 0..=n {
        out.push(binomial(n, k) * differences[0]);
        for i in 0..n - k {
            differences[i] = differences[i + 1] - differences[i];
        }
    }
    out
}

/// Splits at `u` into the coefficients of both halves (de Casteljau).
pub fn split(b: &[f64], u: f64) -> (Vec<f64>, Vec<f64>) {
    let n = b.len();
    let mut work = b.to_vec();
    let mut left = Vec::with_capacity(n);
    let mut right = vec![0.0; n];
    for k in 0..n {
        left.push(work[0]);
        right[n - 1 - k] = work[n - 1 - k];
        for i in 0..n - 1 - k {
            work[i] += u * (work[i + 1] - work[i]);
        }
    }
    (left, right)
}

/// Coefficients of the same polynomial on [lo, hi], 0 ≤ lo < hi ≤ 1, as a polynomial on [0, 1].
pub fn between(b: &[f64], lo: f64, hi: f64) -> Vec<f64> {
    let left = if hi < 1.0 { split(b, hi).0 } else { b.to_vec() };
    if lo > 0.0 {
        split(&left, lo / hi).1
    } else {
        left
    }
}

/// Smallest and largest coefficient: bounds of the polynomial on [0, 1].
pub fn hull(b: &[f64]) -> (f64, f64) {
    b.iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &x| {
            (lo.min(x), hi.max(x))
        })
}

/// Every u in the open interval (0, 1) at which the polynomial changes sign, in increasing order, plus
/// points where it touches zero to within rounding. An identically zero polynomial has none.
pub fn roots(b: &[f64]) -> Vec<f64> {
    let mut out = Vec::new();
    add_roots(b, &mut out);
    out
}

/// Adds the roots, as [`roots`] finds them, to a list.
pub fn add_roots(b: &[f64], out: &mut Vec<f64>) {
    let scale = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if scale > 0.0 && scale.is_finite() {
        // Coefficients below this are rounding of the larger ones: subdivision would chase them.
        let zero = scale * 4.0 * f64::EPSILON;
        match *b {
            [p, q] if p * q < 0.0 => out.push(p / (p - q)),
            [_] | [_, _] => {}
            [p, q, r] if p * r < 0.0 && p.abs() > zero && r.abs() > zero => {
                out.push(crossing_of_quadratic(p, q, r));
            }
            _ => isolate(b, 0.0, 1.0, zero, 0, out),
        }
    }
}

/// Hands the coefficients of d/du to `then`.
fn with_derivative<T>(b: &[f64], then: impl FnOnce(&[f64]) -> T) -> T {
    let n = b.len() - 1;
    if n == 0 || n > SHORT {
        return then(&derivative(b));
    }
    let mut slope = [0.0; SHORT];
    for (d, w) in slope.iter_mut().zip(b.windows(2)) {
        *d = (w[1] - w[0]) * n as f64;
    }
    then(&slope[..n])
}

/// Adds every u in (0, 1) at which the slope changes sign to a list.
pub fn add_critical(b: &[f64], out: &mut Vec<f64>) {
    with_derivative(b, |slope| add_roots(slope, out));
}

/// The one root in (0, 1) of p(1−u)² + 2qu(1−u) + ru² whose ends differ in sign.
fn crossing_of_quadratic(p: f64, q: f64, r: f64) -> f64 {
    // In t = u/(1−u): r t² + 2q t + p = 0, whose roots differ in sign; both forms avoid cancellation.
    let root = (q * q - p * r).sqrt();
    let far = if q >= 0.0 { -(q + root) } else { root - q };
    let (first, second) = (far / r, p / far);
    let t = if first > 0.0 { first } else { second };
    t / (1.0 + t)
}

/// Difference of neighbouring coefficients that may be rounding.
pub fn rounding(b: &[f64]) -> f64 {
    64.0 * f64::EPSILON * b.iter().fold(0.0_f64, |m, x| m.max(x.abs()))
}

/// Visits every local maximum on [0, 1] above `level` as (u, value), the ends included where the
/// polynomial rises towards them.
pub fn peaks_above(b: &[f64], level: f64, mut visit: impl FnMut(f64, f64)) {
    let n = b.len() - 1;
    let mut push = |u: f64, value: f64| {
        if value > level {
            visit(u, value);
        }
    };
    // A crest on the end itself may seem to lie beyond it on both sides of a break, by rounding.
    let flat = rounding(b);
    if n == 0 || b[1] <= b[0] + flat {
        push(0.0, b[0]);
    }
    if n > 0 {
        let mut slope = [0.0; SHORT];
        let slope: &mut [f64] = if n <= slope.len() {
            &mut slope[..n]
        } else {
            &mut vec![0.0; n]
        };
        for (d, w) in slope.iter_mut().zip(b.windows(2)) {
            *d = w[1] - w[0];
        }
        for u in roots(slope) {
            push(u, eval(b, u));
        }
        if b[n - 1] <= b[n] + flat {
            push(1.0, b[n]);
        }
    }
}

fn isolate(b: &[f64], lo: f64, hi: f64, zero: f64, depth: u32, out: &mut Vec<f64>) {
    let changes = sign_changes(b, zero);
    if changes == 0 {
        return;
    }
    if changes == 1 && b[0].abs() > zero && b[b.len() - 1].abs() > zero {
        out.push(lo + (hi - lo) * bracketed_root(b));
        return;
    }
    let mid = 0.5 * (lo + hi);
    if depth >= MAX_DEPTH || mid <= lo || mid >= hi {
        out.push(mid);
        return;
    }
    let n = b.len();
    let (mut short_left, mut short_right) = ([0.0; SHORT], [0.0; SHORT]);
    let (long_left, long_right);
    let (left, right) = if n <= SHORT {
        halve(b, &mut short_left[..n], &mut short_right[..n]);
        (&short_left[..n], &short_right[..n])
    } else {
        (long_left, long_right) = split(b, 0.5);
        (&long_left[..], &long_right[..])
    };
    let found = out.len();
    isolate(left, lo, mid, zero, depth + 1, out);
    let at_middle = right[0].abs() <= zero
        && left[..left.len() - 1].iter().any(|x| x.abs() > zero)
        && right[1..].iter().any(|x| x.abs() > zero);
    if at_middle && out[found..].last().is_none_or(|&r| mid - r > 1e-14) {
        out.push(mid);
    }
    let before = out.len();
    isolate(right, mid, hi, zero, depth + 1, out);
    if at_middle && out.get(before).is_some_and(|&r| r - mid < 1e-14) {
        out.remove(before);
    }
}

/// Splits in the middle.
fn halve(b: &[f64], left: &mut [f64], right: &mut [f64]) {
    right.copy_from_slice(b);
    for (k, left) in left.iter_mut().enumerate() {
        *left = right[0];
        for i in 0..b.len() - 1 - k {
            right[i] += 0.5 * (right[i + 1] - right[i]);
        }
    }
}

fn sign_changes(b: &[f64], zero: f64) -> usize {
    let mut last = 0.0_f64;
    let mut changes = 0;
    for &x in b {
        if x.abs() <= zero {
            continue;
        }
        if last * x < 0.0 {
            changes += 1;
        }
        last = x.signum();
    }
    changes
}

/// The one root in (0, 1) of a polynomial whose end values differ in sign: Newton, kept in the bracket.
fn bracketed_root(b: &[f64]) -> f64 {
    with_derivative(b, |slope| root_by_newton(b, slope))
}

fn root_by_newton(b: &[f64], slope: &[f64]) -> f64 {
    let n = b.len() - 1;
    let (mut lo, mut hi) = (0.0, 1.0);
    let rising = b[0] < 0.0;
    let mut u = b[0] / (b[0] - b[n]);
    for _ in 0..80 {
        let f = eval(b, u);
        if f == 0.0 {
            break;
        }
        if (f < 0.0) == rising {
            lo = u;
        } else {
            hi = u;
        }
        let step = f / eval(slope, u);
        let newton = u - step;
        let next = if newton > lo && newton < hi {
            newton
        } else {
            0.5 * (lo + hi)
        };
        if (next - u).abs() <= 2.0 * f64::EPSILON * u.abs().max(1e-300) || hi - lo <= f64::EPSILON {
            u = next;
            break;
        }
        u = next;
    }
    u
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_and_bernstein_forms_agree() {
        let p = [1.0, -2.0, 0.5, 3.0, -0.25];
        let b = from_power(&p);
        for i in 0..=20 {
            let u = f64::from(i) / 20.0;
            let direct = p.iter().rev().fold(0.0, |s, c| s * u + c);
            assert!((eval(&b, u) - direct).abs() < 1e-14);
        }
        for (x, y) in to_power(&b).iter().zip(p) {
            assert!((x - y).abs() < 1e-13);
        }
    }

    #[test]
    fn derivative_integral_and_product_follow_their_definitions() {
        let a = [0.3, -1.0, 2.0, 0.7];
        let b = [1.0, 4.0, -2.0];
        let (da, ia, ab) = (derivative(&a), antiderivative(&a), product(&a, &b));
        let h = 1e-6;
        for i in 1..10 {
            let u = f64::from(i) / 10.0;
            let slope = (eval(&a, u + h) - eval(&a, u - h)) / (2.0 * h);
            assert!((eval(&da, u) - slope).abs() < 1e-8);
            let area_slope = (eval(&ia, u + h) - eval(&ia, u - h)) / (2.0 * h);
            assert!((area_slope - eval(&a, u)).abs() < 1e-8);
            assert!((eval(&ab, u) - eval(&a, u) * eval(&b, u)).abs() < 1e-14);
        }
    }

    #[test]
    fn roots_of_a_product_of_linear_factors_are_found() {
        for expected in [
            vec![0.1, 0.5, 0.9],
            vec![0.25, 0.500_001, 0.500_002],
            vec![0.5],
            vec![],
        ] {
            let mut b = vec![1.0];
            for r in &expected {
                b = product(&b, &[-r, 1.0 - r]);
            }
            let found = roots(&b);
            assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
            for (f, e) in found.iter().zip(&expected) {
                assert!((f - e).abs() < 1e-9, "{f} {e}");
            }
        }
        let double = product(&[-0.3, 0.7], &[-0.3, 0.7]);
        assert!(roots(&double).iter().any(|r| (r - 0.3).abs() < 1e-7));
        assert!(roots(&[0.0; 4]).is_empty());
    }

    #[test]
    fn a_crest_that_rounding_puts_beyond_an_end_is_seen_there() {
        // The crest of a stroke that a break at 270° shared: each side put it on the other.
        let tiny = 1e-17;
        for b in [
            [0.04, 0.048, 0.049 + tiny, 0.049],
            [0.049, 0.049 + tiny, 0.048, 0.04],
        ] {
            let mut seen = 0.0_f64;
            peaks_above(&b, 0.04, |_, value| seen = seen.max(value));
            assert!((seen - 0.049).abs() < 1e-15, "{b:?}: {seen}");
        }
    }

    #[test]
    fn chebyshev_of_degree_twenty_has_its_twenty_roots() {
        // T_20(2u − 1) by its power recurrence would lose digits; Bernstein coefficients are known:
        // (−1)^(n−k) C(2n, 2k)/C(n, k).
        let n = 20;
        let b: Vec<f64> = (0..=n)
            .map(|k| {
                let sign = if (n - k) % 2 == 0 { 1.0 } else { -1.0 };
                sign * binomial(2 * n, 2 * k) / binomial(n, k)
            })
            .collect();
        let found = roots(&b);
        assert_eq!(found.len(), n);
        for (i, r) in found.iter().enumerate() {
            let angle = std::f64::consts::PI * (2 * (n - i) - 1) as f64 / (2 * n) as f64;
            assert!((r - 0.5 * (1.0 + angle.cos())).abs() < 1e-9);
        }
    }
}
