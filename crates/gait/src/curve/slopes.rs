//! Slopes of the interpolation between samples.
//!
//! The slope per sample at the middle of five samples is the fourth-order centred difference. It is used unchanged where the samples bend steadily,
//! as at a smooth crest: the cubics are of fourth order there. Elsewhere it is limited to three times the smaller neighbouring step, so that a sharp
//! heel strike is not overshot (Fritsch and Carlson's bound), and at a local extreme of the samples to half of that, of either sign.

use crate::statistics::{larger, smaller};

/// Slopes at all samples of a period, four or more, and at its end.
pub fn slopes(f: &[f64]) -> Vec<f64> {
    let n = f.len();
    let mut out = Vec::with_capacity(n + 1);
    out.extend([0, 1].map(|i| slope_at(f, i)));
    // Slices side by side instead of windows: the compiler computes several slopes at once.
    let pairs = f.iter().zip(&f[1..]).zip(f[2..].iter().zip(&f[3..]));
    let fives = pairs.zip(&f[4..]);
    out.extend(fives.map(|(((a, b), (c, d)), e)| limited([*a, *b, *c, *d, *e])));
    out.extend([n - 2, n - 1, n].map(|i| slope_at(f, i)));
    out
}

/// The slope at one sample of a period, with cyclic index.
pub fn slope_at(f: &[f64], i: usize) -> f64 {
    let n = f.len();
    limited([n - 2, n - 1, 0, 1, 2].map(|k| f[(i + k) % n]))
}

/// The second differences of five samples agree in sign and within this factor where the samples bend steadily. With
/// second differences p, q, r the centred difference is the step before plus q/2 + (p − r)/12: between both steps then.
const STEADY: f64 = 6.0;

/// Selections instead of branches, so that the compiler vectorises the slopes.
fn limited(f: [f64; 5]) -> f64 {
    let centred = 2.0 / 3.0 * (f[3] - f[1]) - 1.0 / 12.0 * (f[4] - f[0]);
    let (before, after) = (f[2] - f[1], f[3] - f[2]);
    let (least, most) = (smaller(before, after), larger(before, after));
    // Above 0 at a local extreme alone. Where the samples rise `least` is above 0, where they fall `most` is below.
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
