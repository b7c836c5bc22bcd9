//! Slopes of the interpolation between samples.
//!
//! The slope per sample at the middle of five samples is the fourth-order centred difference, limited to three times the
//! smaller neighbouring step, so that a sharp heel strike is not overshot (Fritsch and Carlson's bound). At a local extreme
//! of the samples half that bound applies to either sign, so that a smooth peak between two samples is not flattened.

/// Slopes at all samples of a period, four or more, and at its end.
pub fn slopes(f: &[f64]) -> Vec<f64> {
    let n = f.len();
    let mut out = vec![0.0; n + 1];
    inner(f, &mut out[2..n - 2], limited);
    for i in [0, 1, n - 2, n - 1] {
        out[i] = slope_at(f, i);
    }
    out[n] = out[0];
    out
}

/// Applies `slope` at all samples but the first two and the last two.
#[inline]
fn inner(f: &[f64], out: &mut [f64], slope: impl Fn([f64; 5]) -> f64) {
    let n = out.len();
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| &f[k..k + n]);
    for i in 0..n {
        out[i] = slope([a[i], b[i], c[i], d[i], e[i]]);
    }
}

/// The slope at one sample of a period, counted round.
pub fn slope_at(f: &[f64], i: usize) -> f64 {
    let n = f.len();
    limited([n - 2, n - 1, 0, 1, 2].map(|k| f[(i + k) % n]))
}

/// Slopes at all samples but the first two and the last two, less the centred differences: zero but near crests and steps.
///
/// ```
/// // At a step of the samples the centred differences would overshoot.
/// let steps = [0.0, 0.0, 0.0, 800.0, 800.0, 800.0];
/// assert!(gaitcam_gait::slope_corrections(&steps).iter().all(|correction| *correction < -400.0));
/// ```
pub fn slope_corrections(f: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; f.len() - 4];
    inner(f, &mut out, |five| limited(five) - centred(five));
    out
}

fn centred(f: [f64; 5]) -> f64 {
    2.0 / 3.0 * (f[3] - f[1]) - 1.0 / 12.0 * (f[4] - f[0])
}

/// Selections instead of branches: the compiler computes several slopes at once.
fn limited(f: [f64; 5]) -> f64 {
    let (before, after) = (f[2] - f[1], f[3] - f[2]);
    let centred = centred(f);
    let smaller = smaller(before.abs(), after.abs());
    let is_steady = before * after > 0.0;
    let bound = if is_steady { 3.0 } else { 1.5 } * smaller;
    let within = -self::smaller(-self::smaller(centred, bound), bound);
    if is_steady & (centred * before < 0.0) {
        0.0
    } else {
        within
    }
}

/// The smaller of two numbers, neither NaN; one instruction, unlike `f64::min`.
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
