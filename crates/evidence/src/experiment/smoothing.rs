//! The smoothest periodic curve near given values: the fewest harmonics that stay within a tolerance.

use std::f64::consts::TAU;

use gaitcam::poly::amplitudes;

/// A truncated Fourier series, c₀ + Σ (cₙ cos nθ + sₙ sin nθ).
pub struct Series {
    mean: f64,
    pub terms: Vec<(f64, f64)>,
}

impl Series {
    /// Values and derivatives by the angle at `n` equal steps of one turn.
    pub fn sample(&self, n: usize) -> (Vec<f64>, Vec<f64>) {
        let at = |i: usize| {
            let (mut value, mut slope) = (self.mean, 0.0);
            for (k, (c, s)) in self.terms.iter().enumerate() {
                let order = (k + 1) as f64;
                // The index is reduced first so that high harmonics keep their phase.
                let (sin, cos) = (TAU * (((k + 1) * i) % n) as f64 / n as f64).sin_cos();
                value += c * cos + s * sin;
                slope += order * (s * cos - c * sin);
            }
            (value, slope)
        };
        (0..n).map(at).unzip()
    }
}

/// The fewest leading harmonics (at most `most`) that stay within `tolerance` of every value.
pub fn fewest_harmonics(values: &[f64], tolerance: f64, most: usize) -> Option<Series> {
    let n = values.len();
    let all = amplitudes(values);
    let (mean, all) = (all[0].0, &all[1..]);
    let series = |k: usize| Series {
        mean,
        terms: all[..k].to_vec(),
    };
    let fits = |s: &Series| {
        let (smooth, _) = s.sample(n);
        values
            .iter()
            .zip(&smooth)
            .all(|(a, b)| (a - b).abs() <= tolerance)
    };
    let most = most.min(all.len().saturating_sub(1));
    let mut low = 0;
    let mut high = 1;
    while high < most && !fits(&series(high)) {
        low = high;
        high = (2 * high).min(most);
    }
    if !fits(&series(high)) {
        return None;
    }
    while high - low > 1 {
        let middle = (low + high) / 2;
        if fits(&series(middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(series(high))
}
