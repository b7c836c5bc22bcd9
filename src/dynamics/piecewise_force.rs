//! Sums of a law's derivatives without a temporary per piece: emitted profiles have thousands of pieces.

use crate::law::{Joint, Law, Svaj};
use crate::poly::PiecewisePoly;

/// w₀s + w₁v + w₂a + constant over the law, as [`Law::combination`] gives it.
///
/// Polynomial laws are summed in one pass, coefficient by coefficient; others are left to the law.
pub fn combination(law: &Law, weights: [f64; 3], constant: f64) -> PiecewisePoly {
    let [w0, w1, w2] = weights;
    let p = law.poly();
    let n = p.degree();
    if n < 2 || (0..p.pieces()).any(|i| !law.waves(i).is_empty()) {
        return law.combination([w0, w1, w2, 0.0], constant);
    }
    let degree = n as f64;
    let mut coef = Vec::with_capacity(p.pieces() * (n + 1));
    for i in 0..p.pieces() {
        let b = p.piece(i);
        let width = p.breaks()[i + 1] - p.breaks()[i];
        let first = degree * w1 / width;
        let second = degree * (degree - 1.0) * w2 / (width * width);
        for k in 0..=n {
            let x = k as f64 / degree;
            // v at degree n: mean of its neighbours of degree n − 1; a the same twice over.
            let slope = |j: usize| b[j + 1] - b[j];
            let bend = |j: usize| b[j + 2] - 2.0 * b[j + 1] + b[j];
            let mut v = 0.0;
            if k > 0 {
                v += x * slope(k - 1);
            }
            if k < n {
                v += (1.0 - x) * slope(k);
            }
            let mut a = 0.0;
            let pairs = degree * (degree - 1.0);
            if k >= 2 {
                a += (k * (k - 1)) as f64 / pairs * bend(k - 2);
            }
            if k >= 1 && k < n {
                a += (2 * k * (n - k)) as f64 / pairs * bend(k - 1);
            }
            if k + 2 <= n {
                a += ((n - k) * (n - k - 1)) as f64 / pairs * bend(k);
            }
            coef.push(constant + w0 * b[k] + first * v + second * a);
        }
    }
    PiecewisePoly::new(p.breaks().to_vec(), n, coef)
}

/// Steps of lift or velocity at the breaks of a law, those of rounding size left out.
pub fn steps(law: &Law) -> Vec<Joint> {
    let p = law.poly();
    let size = (0..p.pieces())
        .flat_map(|i| p.piece(i))
        .fold(0.0_f64, |m, b| m.max(b.abs()));
    let waves = (0..p.pieces()).flat_map(|i| law.waves(i));
    let size = waves.fold(size, |m, w| m.max(w.cos.abs()).max(w.sin.abs()));
    let none = 1e-12 * size;
    let stepped = |j: &Joint| j.jump.v.abs() > none || j.jump.s.abs() > none;
    let n = p.degree();
    if n < 1 || (0..p.pieces()).any(|i| !law.waves(i).is_empty()) {
        return law.joints().into_iter().filter(stepped).collect();
    }
    let rate = |i: usize, k: usize| {
        let b = p.piece(i);
        (b[k + 1] - b[k]) * n as f64 / (p.breaks()[i + 1] - p.breaks()[i])
    };
    (usize::from(!law.is_closed())..p.pieces())
        .map(|i| {
            let before = (i + p.pieces() - 1) % p.pieces();
            Joint {
                at: p.breaks()[i],
                jump: Svaj {
                    s: p.piece(i)[0] - p.piece(before)[n],
                    v: rate(i, 0) - rate(before, n - 1),
                    ..Svaj::default()
                },
            }
        })
        .filter(stepped)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{recover::recover, thesis};

    #[test]
    fn one_pass_gives_what_the_law_gives() {
        let cam = thesis::double_harmonic();
        let law = recover(&cam.follower, &cam.profile(90)).unwrap().law;
        let (a, b) = (
            combination(&law, [3.0, -0.7, 0.4], 2.0),
            law.combination([3.0, -0.7, 0.4, 0.0], 2.0),
        );
        assert_eq!(a.breaks(), b.breaks());
        for i in 0..a.pieces() {
            for (x, y) in a.piece(i).iter().zip(b.piece(i)) {
                assert!((x - y).abs() < 1e-13);
            }
        }
        assert!(steps(&law).is_empty());
    }
}
