//! Mean, median, standard deviation and extremes of values.

use std::array::from_fn;

/// Arithmetic mean; NaN without values.
pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Mean and standard deviation over all values (divisor n).
pub(super) fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let mean = mean(values);
    let square = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
    (mean, (square / values.len() as f64).sqrt())
}

/// Standard deviation estimated from a sample (divisor n − 1); `None` for fewer than two values.
pub(super) fn sample_deviation(values: &[f64]) -> Option<f64> {
    let mean = mean(values);
    let square = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
    (values.len() > 1).then(|| (square / (values.len() as f64 - 1.0)).sqrt())
}

/// Two-sided quantile of Student's t distribution for 95 %. It is tabulated up to ten degrees of freedom and computed by the Cornish–Fisher
/// expansion above (error below 2e-3).
pub(super) fn student_95(degrees: f64) -> f64 {
    const TABLE: [f64; 10] = [
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
    ];
    let z = 1.959_964_f64;
    match TABLE.get((degrees.max(1.0) as usize) - 1) {
        Some(t) => *t,
        None => {
            let first = (z.powi(3) + z) / (4.0 * degrees);
            z + first + (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / (96.0 * degrees * degrees)
        }
    }
}

/// Median: the middle value, or the mean of the two middle values; `None` without values.
pub(super) fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let (a, b) = (values.len().checked_sub(1)? / 2, values.len() / 2);
    Some(0.5 * (values[a] + values[b]))
}

/// Value with index `rank` among the sorted values; `None` if there are fewer values.
pub(super) fn ranked(mut values: Vec<f64>, rank: usize) -> Option<f64> {
    (rank < values.len()).then(|| *values.select_nth_unstable_by(rank, f64::total_cmp).1)
}

/// Finite values among every n-th value, with n chosen so that at most `most` values are taken.
pub(super) fn sample(values: &[f64], most: usize) -> Vec<f64> {
    let step = values.len() / most + 1;
    let thin = values.iter().step_by(step).copied();
    thin.filter(|x| x.is_finite()).collect()
}

/// Smaller of two numbers that are not NaN. Unlike `f64::min`, the comparison is one instruction.
pub(super) fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Larger of two numbers that are not NaN. Unlike `f64::max`, the comparison is one instruction.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Minimum and maximum; `None` without values.
pub(super) fn ends(values: &[f64]) -> Option<(f64, f64)> {
    let first = *values.first()?;
    // Eight values at once: no comparison depends on the previous one. Each takes one instruction, because no value is NaN.
    let (mut low, mut high) = ([first; 8], [first; 8]);
    let (eights, rest) = values.as_chunks::<8>();
    for eight in eights {
        low = from_fn(|k| smaller(low[k], eight[k]));
        high = from_fn(|k| larger(high[k], eight[k]));
    }
    let all = rest.iter().chain(&low).chain(&high).copied();
    Some((all.clone().fold(first, smaller), all.fold(first, larger)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_deviates_by_n_minus_one_and_a_whole_by_n() {
        // 1, 2, 6: squares about the mean 3 sum to 14.
        let values = [1.0, 2.0, 6.0];
        assert!((sample_deviation(&values).unwrap() - 7.0_f64.sqrt()).abs() < 1e-15);
        let (mean, deviation) = mean_and_deviation(&values);
        assert_eq!(mean, 3.0);
        assert!((deviation - (14.0_f64 / 3.0).sqrt()).abs() < 1e-15);
        assert_eq!(sample_deviation(&[4.0, 4.0]), Some(0.0));
        assert_eq!(sample_deviation(&[4.0]), None);
    }

    #[test]
    fn quantiles_of_student_are_those_of_the_tables() {
        for (degrees, t) in [
            (1.0, 12.706),
            (4.0, 2.776),
            (10.0, 2.228),
            (12.0, 2.179),
            (30.0, 2.042),
            (120.0, 1.980),
        ] {
            assert!((student_95(degrees) - t).abs() < 2.5e-3, "{degrees}");
        }
    }

    #[test]
    fn ends_are_found_among_the_eights_and_behind_them() {
        for n in [1_usize, 7, 8, 9, 19] {
            for k in 0..n {
                let mut values = vec![0.0; n];
                values[k] = 5.0;
                let low = if n == 1 { 5.0 } else { 0.0 };
                assert_eq!(ends(&values), Some((low, 5.0)), "{n} {k}");
                values[k] = -5.0;
                let high = if n == 1 { -5.0 } else { 0.0 };
                assert_eq!(ends(&values), Some((-5.0, high)), "{n} {k}");
            }
        }
        assert_eq!(ends(&[]), None);
    }

    #[test]
    fn the_median_of_two_is_their_mean() {
        assert_eq!(median(vec![1.2, 1.0]), Some(1.1));
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(Vec::new()), None);
    }
}
