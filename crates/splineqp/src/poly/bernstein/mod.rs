//! A polynomial on u ∈ [0, 1] in Bernstein form.
//!
//! The coefficients `b[0..=n]` represent Σ bₖ C(n,k) uᵏ (1−u)ⁿ⁻ᵏ. The polynomial lies between the minimum and the maximum coefficient. The
//! first and the last coefficient are its values at u = 0 and u = 1.

mod roots;

pub use roots::{add_critical, add_roots, peaks_above, roots, rounding};

/// Maximum number of coefficients of a polynomial that are stored on the stack.
const SHORT: usize = 16;

/// Binomial coefficients for the degrees below [`SHORT`].
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

/// Value at `u`. The computation is numerically stable for u in [0, 1] and valid for any u.
#[inline]
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

/// Coefficients of the derivative d/du. The degree is one lower. The derivative of a constant is `[0]`.
pub fn derivative(b: &[f64]) -> Vec<f64> {
    let n = b.len() - 1;
    if n == 0 {
        return vec![0.0];
    }
    b.windows(2).map(|w| (w[1] - w[0]) * n as f64).collect()
}

/// Coefficients of the antiderivative in u with the value 0 at u = 0. The degree is one higher.
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

/// The same polynomial with the degree `to`, which is at least its present degree. A constant remains exactly constant.
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

/// Product of two polynomials. The degree of the product is the sum of their degrees.
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

/// Binomial coefficients C(n, k) for k = 0 … n, each computed from the previous one; exact up to 2⁵³.
fn binomials(n: usize) -> impl Iterator<Item = f64> {
    (0..=n).scan(1.0, move |c, k| {
        let this = *c;
        *c = this * (n - k) as f64 / (k + 1) as f64;
        Some(this)
    })
}

/// Integrals over [0, 1] of the products of two Bernstein polynomials of degree n, as a matrix by rows: C(n, i)·C(n, j)/C(2n, i + j)/(2n +
/// 1).
pub fn gram(n: usize) -> Vec<f64> {
    let rows: Vec<f64> = binomials(n).collect();
    let sums: Vec<f64> = binomials(2 * n).collect();
    let unit = 1.0 / (2 * n + 1) as f64;
    (0..=n)
        .flat_map(|i| (0..=n).map(move |j| (i, j)))
        .map(|(i, j)| rows[i] * rows[j] / sums[i + j] * unit)
        .collect()
}

/// Integral of the squared polynomial over [0, 1], with the matrix from [`gram`].
pub fn square(gram: &[f64], b: &[f64]) -> f64 {
    (b.iter().zip(gram.chunks_exact(b.len())))
        .map(|(x, row)| x * row.iter().zip(b).map(|(g, y)| g * y).sum::<f64>())
        .sum()
}

/// Binomial coefficient as a floating-point number; exact up to 2⁵³.
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

/// Monomial coefficients pₖ of the polynomial Σ pₖ uᵏ. They are only for output, because this form is ill-conditioned.
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

/// Splits the polynomial at `u`. Returns the coefficients of both parts (de Casteljau).
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

/// Coefficients of the polynomial restricted to [lo, hi], 0 ≤ lo < hi ≤ 1, as a polynomial on [0, 1].
pub fn between(b: &[f64], lo: f64, hi: f64) -> Vec<f64> {
    let left = if hi < 1.0 { split(b, hi).0 } else { b.to_vec() };
    if lo > 0.0 {
        split(&left, lo / hi).1
    } else {
        left
    }
}

/// Minimum and maximum coefficient, which are bounds of the polynomial on [0, 1].
#[inline]
pub fn hull(b: &[f64]) -> (f64, f64) {
    b.iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &x| {
            (lo.min(x), hi.max(x))
        })
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
}
