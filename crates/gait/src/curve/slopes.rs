//! Slopes for the cubic interpolation between samples.
//!
//! The slope at a sample is computed from five samples with the fourth-order centred difference. Where the second differences change
//! slowly, as at a smooth maximum, this slope is not limited, and the interpolation is of fourth order. Elsewhere its magnitude is limited
//! to three times the smaller of the adjacent differences (bound of Fritsch and Carlson). The interpolation then does not overshoot at a
//! sharp heel strike. At a local extreme of the samples, the factor is 1.5 instead of 3, and the slope may have either sign.

use crate::statistics::{larger, smaller};

/// Slopes, per sample, at all samples of a period and at its end. The period has four or more samples.
pub fn slopes(f: &[f64]) -> Vec<f64> {
    let n = f.len();
    let mut out = Vec::with_capacity(n + 1);
    out.extend([0, 1].map(|i| slope_at(f, i)));
    // Zipped slices instead of windows, so that the compiler computes several slopes at once.
    let pairs = f.iter().zip(&f[1..]).zip(f[2..].iter().zip(&f[3..]));
    let fives = pairs.zip(&f[4..]);
    out.extend(fives.map(|(((a, b), (c, d)), e)| limited([*a, *b, *c, *d, *e])));
    out.extend([n - 2, n - 1, n].map(|i| slope_at(f, i)));
    out
}

/// Slope, per sample, at one sample of a period; indices are cyclic.
pub fn slope_at(f: &[f64], i: usize) -> f64 {
    let n = f.len();
    limited([n - 2, n - 1, 0, 1, 2].map(|k| f[(i + k) % n]))
}

/// Maximum ratio of adjacent second differences, in either direction, for which the slope is not limited. The three second differences of
/// five samples must also have the same sign.
///
/// With second differences p, q, r, the centred difference is the preceding difference of the samples plus q/2 + (p − r)/12. If both
/// conditions are satisfied, the centred difference is between the preceding and the following difference.
const STEADY: f64 = 6.0;

/// Slope, per sample, at the third of five samples. It is limited by selections instead of branches, so that the compiler vectorises the
/// loop.
fn limited(f: [f64; 5]) -> f64 {
    let centred = 2.0 / 3.0 * (f[3] - f[1]) - 1.0 / 12.0 * (f[4] - f[0]);
    let (before, after) = (f[2] - f[1], f[3] - f[2]);
    let (least, most) = (smaller(before, after), larger(before, after));
    // `either` is positive only at a local extreme. Where the samples rise, `least` is positive. Where they fall, `most` is negative.
    let either = larger(1.5 * smaller(-least, most), 0.0);
    let (low, high) = (smaller(3.0 * most, -either), larger(3.0 * least, either));
    let limited = smaller(larger(centred, low), high);
    let bend = after - before;
    let (with_before, with_after) = (
        bend * (before - (f[1] - f[0])),
        bend * (f[4] - f[3] - after),
    );
    let square = bend * bend;
    let bends_steadily = (STEADY * smaller(with_before, with_after) > square)
        & (larger(with_before, with_after) <= STEADY * square);
    if bends_steadily { centred } else { limited }
}
