//! Detection of the part of a profile that was not measured.

use std::f64::consts::TAU;

/// Two thresholds for the distance between neighbouring points above which the gap counts as unmeasured. The first is a fraction of the
/// length of the outline, the second a multiple of the mean distance of the points.
const GAP: (f64, f64) = (0.05, 4.0);

/// First and last cam angle, rad, of the longest unmeasured part of the outline; `None` if the measured points cover the outline. `outline`
/// contains points at equal steps of the cam angle. `angles` are the measured cam angles, rad, in ascending order.
pub fn unmeasured(outline: &[[f64; 2]], angles: &[f64]) -> Option<[f64; 2]> {
    let n = outline.len();
    let length = |i: usize| {
        let (a, b) = (outline[i], outline[(i + 1) % n]);
        libm::hypot(b[0] - a[0], b[1] - a[1])
    };
    // Length of the outline up to each sample.
    let mut along = vec![0.0; n + 1];
    for i in 0..n {
        along[i + 1] = along[i] + length(i);
    }
    let place = |theta: f64| {
        let x = theta / TAU * n as f64;
        let i = (x as usize).min(n - 1);
        along[i] + (x - i as f64) * (along[i + 1] - along[i])
    };
    let next = angles.iter().skip(1).chain(angles.first());
    let gap = |(from, to): (&f64, &f64)| {
        let gap = place(*to) - place(*from);
        let gap = if to > from { gap } else { gap + along[n] };
        (gap, [*from, *to])
    };
    let (gap, ends) = (angles.iter().zip(next).map(gap)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    // Mean distance without the gap, because all points may lie close together.
    let mean = (along[n] - gap) / (angles.len() as f64 - 1.0);
    (gap > GAP.0 * along[n] && gap > GAP.1 * mean).then_some(ends)
}
