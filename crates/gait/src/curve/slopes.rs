//! Slopes of the interpolation between samples.
//!
//! The slope per sample at the middle of five samples is the fourth-order centred difference. Where the samples bend
//! steadily, as at a smooth crest, it stays: the cubics are of fourth order there. Elsewhere it is limited to three times
//! the smaller neighbouring step, so that a sharp heel strike is not overshot (Fritsch and Carlson's bound), and at a
//! local extreme of the samples to half of that, of either sign.

/// Slopes at all samples of a period, four or more, and at its end.
pub fn slopes(f: &[f64]) -> Vec<f64> {
    let n = f.len();
    let mut out = vec![0.0; n + 1];
    // Five slices of one length: no index is checked, and several slopes are computed at once.
    let inner = &mut out[2..n - 2];
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| &f[k..k + inner.len()]);
    for (i, slope) in inner.iter_mut().enumerate() {
        *slope = limited([a[i], b[i], c[i], d[i], e[i]]);
    }
    for i in [0, 1, n - 2, n - 1] {
        out[i] = slope_at(f, i);
    }
    out[n] = out[0];
    out
}

/// The slope at one sample of a period, counted round.
pub fn slope_at(f: &[f64], i: usize) -> f64 {
    let n = f.len();
    limited([n - 2, n - 1, 0, 1, 2].map(|k| f[(i + k) % n]))
}

/// The second differences of five samples agree in sign and within this factor where the samples bend steadily. With
/// second differences p, q, r the centred difference is the step before plus q/2 + (p − r)/12: between both steps then.
const STEADY: f64 = 6.0;

/// Selections instead of branches: the compiler computes several slopes at once.
fn limited(f: [f64; 5]) -> f64 {
    let steps = [f[1] - f[0], f[2] - f[1], f[3] - f[2], f[4] - f[3]];
    let centred = 2.0 / 3.0 * (f[3] - f[1]) - 1.0 / 12.0 * (f[4] - f[0]);
    let (before, after) = (steps[1], steps[2]);
    let smaller_step = smaller(before.abs(), after.abs());
    let is_monotone = before * after > 0.0;
    let bound = if is_monotone { 3.0 } else { 1.5 } * smaller_step;
    let within = -smaller(-smaller(centred, bound), bound);
    let is_opposed = is_monotone & (centred * before < 0.0);
    let limited = if is_opposed { 0.0 } else { within };
    let bends = [steps[1] - steps[0], after - before, steps[3] - after];
    let (with_before, with_after) = (bends[1] * bends[0], bends[1] * bends[2]);
    let square = bends[1] * bends[1];
    let least = smaller(with_before, with_after);
    let most = -smaller(-with_before, -with_after);
    let bends_steadily = (STEADY * least > square) & (most <= STEADY * square);
    if bends_steadily { centred } else { limited }
}

/// The smaller of two numbers, neither NaN; one instruction, unlike `f64::min`.
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
