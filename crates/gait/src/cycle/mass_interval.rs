//! Confidence interval of a mass that is computed from the mean force. It covers the uncertainty of steps, stride time and unloaded levels.

use super::Average;
use super::single::by_side;
use crate::interpretation::RecordedStride;
use crate::recording::{CycleSource, PeriodSource, Recording};
use crate::stance::{Stance, Stances};
use crate::statistics::{mean, sample_deviation, student_95};
use crate::units::G;

/// Typical relative standard deviations of the mean force: from stride to stride, and from stance to stance. The typical variance is pooled
/// with the measured variance as if it had `USUAL_DEGREES` degrees of freedom.
const OF_STRIDES: f64 = 0.015;
const OF_STANCES: f64 = 0.03;
const USUAL_DEGREES: f64 = 4.0;
/// Standard deviation, over walkers, of half the relative difference between the impulses of the left and the right foot.
const OF_FEET: f64 = 0.06;
/// Relative standard uncertainty of a stride time that was computed from a typical duty factor.
const OF_DUTY: f64 = 0.05;
/// Standard uncertainty of an unloaded level: fraction of the standard deviation of the noise, and minimum value, N.
const OF_LEVEL: (f64, f64) = (0.3, 0.4);
/// Two-sided normal quantile for 95 %.
const NORMAL_95: f64 = 1.96;

/// Lower and upper limit of the 95 % interval of a mass, kg. `None` for insoles, because their calibration is unknown.
pub(super) fn mass_interval(
    recording: &Recording,
    stances: &Stances,
    average: &Average,
    strides: &[RecordedStride],
    mass_kg: f64,
) -> Option<(f64, f64)> {
    if recording.insole {
        return None;
    }
    let steps = of_steps(recording, stances, average, strides);
    let parts = [steps, of_clock(average), of_levels(recording, mass_kg)];
    let half = parts.iter().map(|u| u * u).sum::<f64>().sqrt();
    Some((mass_kg * (1.0 - half).max(0.0), mass_kg * (1.0 + half)))
}

/// Relative half width of the interval that is due to the variation of the steps.
fn of_steps(
    recording: &Recording,
    stances: &Stances,
    average: &Average,
    strides: &[RecordedStride],
) -> f64 {
    let used = || stances.used.iter().filter(|s| !s.unlike);
    let impulses = |side: &[&Stance]| side.iter().map(|s| s.impulse_ns).collect::<Vec<f64>>();
    match average.source {
        CycleSource::WholeStrides { .. } => {
            let kept = strides.iter().filter(|s| s.rejected.is_none());
            let means = kept.map(|s| s.impulse_ns / (s.to_s - s.from_s));
            of_mean(&means.collect::<Vec<f64>>(), OF_STRIDES)
        }
        CycleSource::TotalForce { strides } => {
            student_95(USUAL_DEGREES) * OF_STRIDES / (strides.max(1) as f64).sqrt()
        }
        CycleSource::RightAndLeft { .. } | CycleSource::TwoFeet { .. } => {
            let (left, right) = by_side(&used().collect::<Vec<_>>(), recording);
            let [left, right] = [left, right].map(|side| of_mean(&impulses(&side), OF_STANCES));
            0.5 * libm::hypot(left, right)
        }
        CycleSource::AnyFoot { .. } | CycleSource::OneFoot { .. } => {
            let own = of_mean(&impulses(&used().collect::<Vec<_>>()), OF_STANCES);
            libm::hypot(own, NORMAL_95 * OF_FEET)
        }
    }
}

/// Relative half width of the 95 % interval of a mean. Its variance is a weighted mean of the sample variance of the values and of the
/// square of the typical relative standard deviation `usual`.
fn of_mean(values: &[f64], usual: f64) -> f64 {
    let degrees = (values.len() as f64 - 1.0).max(0.0);
    let own = sample_deviation(values).unwrap_or(0.0) / mean(values).abs().max(f64::MIN_POSITIVE);
    let all = USUAL_DEGREES + degrees;
    let square = (USUAL_DEGREES * usual * usual + degrees * own * own) / all;
    student_95(all) * (square / values.len().max(1) as f64).sqrt()
}

/// Relative half width of the interval that is due to the uncertainty of the stride time. It is zero for a mean over whole strides, which
/// does not depend on the stride time.
fn of_clock(average: &Average) -> f64 {
    let period = average.period;
    match average.source {
        CycleSource::WholeStrides { .. } | CycleSource::TotalForce { .. } => 0.0,
        _ if period.from == PeriodSource::UsualDuty => NORMAL_95 * OF_DUTY,
        _ => {
            let deviation = period.uncertainty_s().or(period.spread_s);
            NORMAL_95 * deviation.unwrap_or(0.0) / period.seconds
        }
    }
}

/// Relative half width of the interval that is due to the uncertainty of the unloaded levels.
fn of_levels(recording: &Recording, mass_kg: f64) -> f64 {
    let of = |noise_n: f64| (OF_LEVEL.0 * noise_n).max(OF_LEVEL.1);
    let squares = recording.live().map(|(_, c)| of(c.noise_n).powi(2));
    NORMAL_95 * squares.sum::<f64>().sqrt() / (mass_kg * G).max(f64::MIN_POSITIVE)
}
