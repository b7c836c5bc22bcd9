//! Roots, maxima and critical points of a polynomial on [0, 1] in Bernstein form. Intervals are bisected until each contains one change of sign.

use super::{SHORT, derivative, eval, split};

/// Number of bisections after which a further bisection of the interval [0, 1] does not change its ends.
const MAX_DEPTH: u32 = 54;

/// All u in the open interval (0, 1) at which the polynomial changes sign, or touches zero up to rounding errors, in ascending order. A
/// polynomial that is identically zero has no roots.
pub fn roots(b: &[f64]) -> Vec<f64> {
    let mut out = Vec::new();
    add_roots(b, &mut out);
    out
}

/// Appends the roots, as computed by [`roots`], to a list.
pub fn add_roots(b: &[f64], out: &mut Vec<f64>) {
    let scale = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if scale > 0.0 && scale.is_finite() {
        // Coefficients below this value are rounding errors of larger coefficients and count as zero.
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

/// Calls `then` with the coefficients of the derivative.
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

/// Appends all u in (0, 1) at which the slope changes sign to a list.
pub fn add_critical(b: &[f64], out: &mut Vec<f64>) {
    with_derivative(b, |slope| add_roots(slope, out));
}

/// The root in (0, 1) of p(1−u)² + 2qu(1−u) + ru², whose end values have different signs.
fn crossing_of_quadratic(p: f64, q: f64, r: f64) -> f64 {
    // With t = u/(1−u), the equation is r t² + 2q t + p = 0. Its roots have different signs, and both forms avoid cancellation.
    let root = (q * q - p * r).sqrt();
    let far = if q >= 0.0 { -(q + root) } else { root - q };
    let (first, second) = (far / r, p / far);
    let t = if first > 0.0 { first } else { second };
    t / (1.0 + t)
}

/// Difference between adjacent coefficients below which the difference may be a rounding error.
pub fn rounding(b: &[f64]) -> f64 {
    64.0 * f64::EPSILON * b.iter().fold(0.0_f64, |m, x| m.max(x.abs()))
}

/// Calls `visit(u, value)` for every local maximum on [0, 1] above `level`. An end counts as a maximum if the polynomial rises towards it.
pub fn peaks_above(b: &[f64], level: f64, mut visit: impl FnMut(f64, f64)) {
    let n = b.len() - 1;
    let mut push = |u: f64, value: f64| {
        if value > level {
            visit(u, value);
        }
    };
    // Because of rounding, a maximum on a break may appear to be outside the pieces on both sides.
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

/// Writes the coefficients of the polynomial on the two halves of the interval to `left` and `right`.
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

/// The root in (0, 1) of a polynomial whose end values have different signs, by Newton's method with bisection as a safeguard.
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
    use super::super::{binomial, product};
    use super::*;

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
    fn a_maximum_that_rounding_puts_beyond_an_end_is_found_at_the_end() {
        // This is the maximum of a stroke on a break at 270°. The slopes on both sides of the break indicate that the maximum is on the
        // other side.
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
        // The power recurrence of T_20(2u − 1) would lose digits. The Bernstein coefficients are known: (−1)^(n−k) C(2n, 2k)/C(n, k).
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
