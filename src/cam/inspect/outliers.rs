//! Detection of measured points far outside the scatter of the other points.

use super::fit::Foot;

/// Two thresholds that the deviation of an outlier from the median exceeds. The first is a number of standard deviations, estimated from
/// the median absolute deviation. The second is a fraction of the maximum radius.
const OUTLIER: (f64, f64) = (10.0, 1e-6);
/// Ratio of standard deviation and median absolute deviation of a normal distribution.
const NORMAL: f64 = 1.4826;
/// Maximum fraction of outliers. If more points deviate, the deviations are attributed to the shape of the cam.
const FEW: f64 = 0.05;

/// Marks the points that are not outliers; `None` if too many points are far from the other points.
pub fn without_outliers(feet: &[Foot], size: f64) -> Option<Vec<bool>> {
    let middle_of = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied()
    };
    let middle = middle_of(feet.iter().map(|f| f.distance).collect())?;
    let off = |f: &Foot| (f.distance - middle).abs();
    let scatter = NORMAL * middle_of(feet.iter().map(off).collect())?;
    let most = (OUTLIER.0 * scatter).max(OUTLIER.1 * size);
    let kept: Vec<bool> = feet.iter().map(|f| off(f) <= most).collect();
    let outliers = kept.iter().filter(|kept| !**kept).count();
    (outliers as f64 <= FEW * feet.len() as f64).then_some(kept)
}
