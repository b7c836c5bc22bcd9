//! Time base: rate from a time column, resampling of unevenly spaced samples, and gaps.

use crate::error::{ReadError, Result};
use crate::quantity::seconds;
use crate::recording::ClockSource;
use crate::statistics::ranked;

/// Uniform time base for the samples of a file.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TimeBase {
    pub rate_hz: f64,
    /// Time of the first sample, as in the file, s.
    pub start_s: f64,
    /// How the sampling rate was obtained: from the user, the time column or the header, or by an assumption.
    pub source: ClockSource,
    /// Times of the samples from the first sample, in sampling intervals, if they are too uneven to be treated as uniform.
    uneven: Option<Vec<f64>>,
    /// Spans without samples: start and end, s from the first sample.
    pub gaps_s: Vec<(f64, f64)>,
    /// Number of single missing samples, and time of the first of them, s from the first sample.
    pub missed: Option<(usize, f64)>,
}

/// Maximum deviation of a sample from its uniform time, in sampling intervals, that is accepted without resampling.
const SLACK: f64 = 0.75;

/// A step between two times is a gap if it exceeds this multiple of the usual step.
const GAP: f64 = 2.5;

impl TimeBase {
    /// Uniform time base with a known rate.
    pub fn even(rate_hz: f64, source: ClockSource) -> Self {
        TimeBase {
            rate_hz,
            start_s: 0.0,
            source,
            uneven: None,
            gaps_s: Vec::new(),
            missed: None,
        }
    }

    /// The time base with another time of the first sample, s, as in the file.
    #[must_use]
    pub fn starting_at(self, start_s: f64) -> Self {
        TimeBase { start_s, ..self }
    }

    /// Time base from non-decreasing times in seconds. The rate is (n − 1)/duration, because single steps are rounded.
    ///
    /// If there are gaps, the rate is computed only from the samples outside the gaps.
    ///
    /// # Errors
    ///
    /// There are fewer than two samples; the time does not increase.
    pub fn from_times(times: &[f64]) -> Result<Self> {
        let n = times.len();
        let [first, .., last] = times else {
            return Err(ReadError::FewSamples { samples: n }.into());
        };
        let whole = last - first;
        if whole <= 0.0 {
            let at = seconds(*first);
            return Err(ReadError::TimeStandsStill { at }.into());
        }
        let usual = usual_step(times);
        let is_gap = |w: &&[f64]| w[1] - w[0] > GAP * usual;
        let gaps: Vec<(f64, f64)> = times
            .windows(2)
            .filter(is_gap)
            .map(|w| (w[0] - first, w[1] - first))
            .collect();
        let lost: f64 = gaps.iter().map(|(a, b)| b - a).sum();
        let steps = (n - 1 - gaps.len()) as f64;
        let step = if steps > 0.0 && whole > lost {
            (whole - lost) / steps
        } else {
            usual
        };
        // The resampled values must not require much more memory than the samples in the file.
        let slots = whole / step;
        if slots > 4.0 * n as f64 + 1000.0 {
            let (lost, whole) = (seconds(lost), seconds(whole));
            return Err(ReadError::MostlyGaps { lost, whole }.into());
        }
        let strays = times
            .iter()
            .enumerate()
            .any(|(i, t)| (t - first - i as f64 * step).abs() > SLACK * step);
        let uneven = (strays || !gaps.is_empty())
            .then(|| times.iter().map(|t| (t - first) / step).collect());
        Ok(TimeBase {
            rate_hz: 1.0 / step,
            start_s: *first,
            source: ClockSource::Times,
            uneven,
            gaps_s: gaps,
            missed: missed(times, usual),
        })
    }

    /// Whether the samples must be resampled at uniform times.
    pub fn is_uneven(&self) -> bool {
        self.uneven.is_some()
    }

    /// Values at uniform times, by linear interpolation. A value between a missing and another value is also missing.
    pub fn resampled(&self, values: Vec<f64>) -> Vec<f64> {
        let Some(at) = &self.uneven else {
            return values;
        };
        let last = at.last().copied().unwrap_or(0.0);
        let count = last.round() as usize + 1;
        let mut line = polyline(at, &values);
        (0..count).map(|k| line((k as f64).min(last))).collect()
    }
}

/// Linear interpolation between two or more samples at non-decreasing positions. At the position of a sample, its value is returned
/// exactly, because adjacent values may be missing.
pub(super) fn polyline(at: &[f64], values: &[f64]) -> impl FnMut(f64) -> f64 {
    let mut i = 0;
    move |place| {
        while i + 2 < at.len() && at[i + 1] <= place {
            i += 1;
        }
        let (a, b) = (at[i], at[i + 1]);
        let x = if b > a { (place - a) / (b - a) } else { 1.0 };
        match x.clamp(0.0, 1.0) {
            x if x < 1e-9 => values[i],
            x if x > 1.0 - 1e-9 => values[i + 1],
            x => values[i] + x * (values[i + 1] - values[i]),
        }
    }
}

/// Number of steps that are twice as long as the others, and the time in the middle of the first such step. `None` if the other steps are
/// too unequal.
fn missed(times: &[f64], usual: f64) -> Option<(usize, f64)> {
    let steps = || times.windows(2).map(|w| (w[1] - w[0]) / usual);
    let even = |s: &f64| (0.75..1.25).contains(s);
    let twice = |s: &f64| (1.75..2.25).contains(s);
    let count = steps().filter(twice).count();
    let all = times.len() - 1;
    // Most steps are equal and hardly any are double, unlike the steps of rounded times.
    if count == 0 || 20 * count > all || steps().filter(even).count() + 2 * count < all {
        return None;
    }
    let first = steps().position(|s| twice(&s))?;
    Some((count, 0.5 * (times[first] + times[first + 1]) - times[0]))
}

/// Median of the steps between adjacent times, from a thinned set of steps. If the median is zero because of rounding, the mean step is
/// returned.
pub(super) fn usual_step(times: &[f64]) -> f64 {
    let thin = times.len() / 4096 + 1;
    let neighbours = times.windows(2).step_by(thin);
    let steps: Vec<f64> = neighbours.map(|w| w[1] - w[0]).collect();
    let middle = steps.len() / 2;
    match ranked(steps, middle) {
        Some(s) if s > 0.0 => s,
        _ => (times[times.len() - 1] - times[0]) / (times.len() - 1).max(1) as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_times_give_the_true_rate() {
        // 600 Hz written with four decimals: steps of 0.0016 and 0.0017.
        let times: Vec<f64> = (0..1501)
            .map(|i| (f64::from(i) / 600.0 * 1e4).round() / 1e4)
            .collect();
        let base = TimeBase::from_times(&times).unwrap();
        assert!((base.rate_hz - 600.0).abs() < 0.05, "{}", base.rate_hz);
        assert!(!base.is_uneven());
        // 2000 Hz written with three decimals repeats every time.
        let times: Vec<f64> = (0..4001)
            .map(|i| (f64::from(i) / 2000.0 * 1e3).floor() / 1e3)
            .collect();
        assert!((TimeBase::from_times(&times).unwrap().rate_hz - 2000.0).abs() < 1.0);
    }

    #[test]
    fn a_sample_that_is_missing_is_counted_and_rounding_is_none() {
        let even: Vec<f64> = (0..500).map(|i| 0.01 * f64::from(i)).collect();
        assert_eq!(TimeBase::from_times(&even).unwrap().missed, None);
        let mut lacking = even;
        lacking.remove(320);
        let base = TimeBase::from_times(&lacking).unwrap();
        let (count, at) = base.missed.unwrap();
        assert!(count == 1 && (at - 3.2).abs() < 1e-9);
        // (n − 1)/duration, as for any other file.
        assert!((base.rate_hz - 498.0 / 4.99).abs() < 1e-9);
        let rounded: Vec<f64> = (0..4001)
            .map(|i| (f64::from(i) / 1600.0 * 1e3).floor() / 1e3)
            .collect();
        assert_eq!(TimeBase::from_times(&rounded).unwrap().missed, None);
    }

    #[test]
    fn a_straight_line_survives_jitter_and_a_gap() {
        let times: Vec<f64> = (0..600)
            .filter(|i| !(200..230).contains(i))
            .map(|i| 5.0 + 0.01 * f64::from(i) + 0.002 * (f64::from(i) * 0.7).sin())
            .collect();
        let base = TimeBase::from_times(&times).unwrap();
        assert!((base.rate_hz - 100.0).abs() < 0.2, "{}", base.rate_hz);
        assert_eq!(base.gaps_s.len(), 1);
        let line = base.resampled(times.iter().map(|t| 3.0 * (t - times[0])).collect());
        for (k, y) in line.iter().enumerate().take(line.len() - 1) {
            assert!((y - 3.0 * k as f64 / base.rate_hz).abs() < 1e-9);
        }
    }

    #[test]
    fn one_sample_still_time_and_endless_gaps_are_refused() {
        assert!(TimeBase::from_times(&[1.0]).is_err());
        assert!(TimeBase::from_times(&[1.0, 1.0]).is_err());
        let e = TimeBase::from_times(&[0.0, 1e-6, 2e-6, 1e6]).unwrap_err();
        assert!(e.to_string().contains("samples are missing"), "{e}");
    }
}
