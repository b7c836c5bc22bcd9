//! Sums of harmonics and their samples at equal steps of one turn.

use std::cell::RefCell;
use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

thread_local! {
    /// Planner of Fourier transforms. It is reused, because planning takes longer than one transform of usual length.
    static PLANNER: RefCell<RealFftPlanner<f64>> = RefCell::new(RealFftPlanner::new());
}

fn forward(n: usize) -> Arc<dyn RealToComplex<f64>> {
    PLANNER.with_borrow_mut(|p| p.plan_fft_forward(n))
}

fn inverse(n: usize) -> Arc<dyn ComplexToReal<f64>> {
    PLANNER.with_borrow_mut(|p| p.plan_fft_inverse(n))
}

/// Mean and (cosine, sine) amplitudes of the harmonics 1 … n/2 of n ≥ 1 samples at equal steps of a turn. The first entry is (mean, 0). The
/// sample at θ is the mean plus Σ aₕ cos hθ + bₕ sin hθ. For even n, the last cosine coincides with its alias at the samples, so its
/// amplitude is twice its coefficient in this sum.
pub fn amplitudes(samples: &[f64]) -> Vec<(f64, f64)> {
    let n = samples.len();
    let fft = forward(n);
    let mut input = samples.to_vec();
    let mut output = fft.make_output_vec();
    if fft.process(&mut input, &mut output).is_err() {
        unreachable!("both buffers are of the transform's own length");
    }
    let scale = 2.0 / n as f64;
    let mut out: Vec<(f64, f64)> = (output.iter())
        .map(|c| (c.re * scale, -c.im * scale))
        .collect();
    out[0] = (0.5 * out[0].0, 0.0);
    out
}

/// Samples of a derivative of Σ aₕ cos hθ + bₕ sin hθ at θ = 2πi/n, i = 0 … n − 1. `order` is the order of the derivative. `terms` contains
/// (aₕ, bₕ) for h = 1 … < n/2. The result is exact up to rounding errors relative to the maximum value.
pub fn samples(terms: &[(f64, f64)], order: u32, n: usize) -> Vec<f64> {
    debug_assert!(2 * terms.len() < n);
    let fft = inverse(n);
    let mut spectrum = fft.make_input_vec();
    for (h, &(a, b)) in (1..).zip(terms) {
        // a cos + b sin = Re((a − ib) e^{ihθ}). The transform adds the complex conjugate.
        spectrum[h] = Complex64::new(0.5 * a, -0.5 * b) * Complex64::new(0.0, h as f64).powu(order);
    }
    let mut out = fft.make_output_vec();
    if fft.process(&mut spectrum, &mut out).is_err() {
        unreachable!("the buffers are the transform's own, the mean is real");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn samples_and_amplitudes_are_inverse_to_each_other() {
        for n in [9, 64, 1440, 1001] {
            let terms: Vec<(f64, f64)> = (1..=(n - 1) / 2)
                .map(|h| ((h % 7) as f64 - 3.0, 1.0 / h as f64))
                .collect();
            let [s, v, a] = [0, 1, 2].map(|order| samples(&terms, order, n));
            for i in [0, 1, n / 3, n - 1] {
                let theta = TAU * i as f64 / n as f64;
                let mut direct = [0.0; 3];
                for (h, &(p, q)) in (1..).zip(&terms) {
                    let rate = f64::from(h);
                    let (sin, cos) = (rate * theta).sin_cos();
                    direct[0] += p * cos + q * sin;
                    direct[1] += rate * (q * cos - p * sin);
                    direct[2] -= rate * rate * (p * cos + q * sin);
                }
                let size = n as f64;
                assert!((s[i] - direct[0]).abs() < 1e-14 * 3.0 * size);
                assert!((v[i] - direct[1]).abs() < 1e-14 * 3.0 * size.powi(2));
                assert!((a[i] - direct[2]).abs() < 1e-14 * 3.0 * size.powi(3));
            }
            let back = amplitudes(&s);
            assert!(back[0].0.abs() < 1e-13);
            for ((p, q), back) in terms.iter().zip(&back[1..]) {
                assert!((back.0 - p).abs() < 1e-12 && (back.1 - q).abs() < 1e-12);
            }
        }
    }
}
