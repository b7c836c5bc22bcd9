//! Comparison of a force over the cam angle with a target over time.

use std::f64::consts::TAU;

use serde::Serialize;

/// Difference between a force and its target over time, at the optimal phase and a given mean speed.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::{Drive, Motor, TorqueLine};
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // The target is the force of the cam at constant speed, shifted by 0.6 rad. The optimal phase removes this shift.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let mut run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// let force = |i: i32| 98.1 - 0.9 * (f64::from(i).to_radians() - 0.6).sin();
/// run.target = Some((0..360).map(force).collect());
/// let line = TorqueLine::Slope(10.0);
/// run.machine.motor = Some(Motor { line, nominal: None, inertia: 1e6, friction: 0.0, gear: 1.0, efficiency: 1.0 });
/// assert!(simulate(&run, Model::Rigid)?.force_time.unwrap().rms_error_n < 1e-4);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct InTime {
    /// Root mean square of the difference over the period, N.
    pub rms_error_n: f64,
    /// Root mean square of the difference, in percent of the mean of the target over time.
    pub rms_error_percent_of_mean: f64,
}

/// Maximum number of Gauss–Newton iterations for the phase.
const ROUNDS: usize = 20;
const SAME: f64 = 1e-4;
/// Number of equally spaced phases at which the error is evaluated in the search for its minima.
const PHASES: usize = 48;
const STEP: usize = 6;
/// Minimum relative decrease of the mean square error for which another minimum is selected.
const LOWER: f64 = 1e-6;

/// Difference between forces at equal angles and a target at equal times of one period, minimised over the phase of the target. Each force
/// is given with the shaft speed, rad/s, and the time, s, at its angle. Forces and target begin at the same angle.
pub fn error_in_time(
    forces: &[f64],
    speed: &[f64],
    time: &[f64],
    period: f64,
    target: &[f64],
) -> InTime {
    let rows: Vec<Weighed> = (0..forces.len())
        .map(|i| Weighed {
            force: forces[i],
            part: time[i] / period,
            weight: TAU / forces.len() as f64 / speed[i] / period,
        })
        .collect();
    let target = Cubic(target);
    let mut least = target.least_from(0.0, &rows);
    let few: Vec<Weighed> = rows.iter().copied().step_by(STEP).collect();
    let phase = |i: usize| i as f64 / PHASES as f64;
    let coarse: Vec<f64> = (0..PHASES)
        .map(|i| target.distance(phase(i), &few)[0])
        .collect();
    for i in 1..PHASES {
        if coarse[i] < coarse[i - 1] && coarse[i] <= coarse[(i + 1) % PHASES] {
            let other = target.least_from(phase(i), &rows);
            if other < (1.0 - LOWER) * least {
                least = other;
            }
        }
    }
    let mean = target.0.iter().sum::<f64>() / target.0.len() as f64;
    let rms_error_n = f64::sqrt(least);
    InTime {
        rms_error_n,
        rms_error_percent_of_mean: 100.0 * rms_error_n / mean.abs(),
    }
}

/// A force with the time at which it acts and its duration, both as fractions of the period.
#[derive(Clone, Copy)]
struct Weighed {
    force: f64,
    part: f64,
    weight: f64,
}

/// Samples of one period with cubic interpolation between them.
pub struct Cubic<'a>(pub &'a [f64]);

impl Cubic<'_> {
    /// Minimum mean square difference near a phase of the target, by the Gauss–Newton method.
    fn least_from(&self, phase: f64, rows: &[Weighed]) -> f64 {
        let mut shift = phase;
        let mut least = f64::INFINITY;
        for _ in 0..ROUNDS {
            let [square, slope, bend] = self.distance(shift, rows);
            least = square.min(least);
            if bend == 0.0 {
                break;
            }
            let change = slope / bend;
            if change.abs() < SAME {
                return (square - change * slope).max(0.0);
            }
            shift += change;
        }
        least
    }

    /// Mean square difference between the forces and the target at a phase, with half its slope (sign reversed) and its Gauss–Newton
    /// curvature.
    fn distance(&self, shift: f64, rows: &[Weighed]) -> [f64; 3] {
        let mut out = [0.0; 3];
        for row in rows {
            let (wanted, rate) = self.at(row.part + shift);
            let off = row.force - wanted;
            out[0] += row.weight * off * off;
            out[1] += row.weight * off * rate;
            out[2] += row.weight * rate * rate;
        }
        out
    }

    /// Value and slope at a fraction of the period, by Catmull–Rom interpolation. The slope is per period.
    pub fn at(&self, part: f64) -> (f64, f64) {
        let n = self.0.len();
        let x = (part - part.floor()) * n as f64;
        let i = x as usize;
        let u = x - i as f64;
        let wrapped = |k: usize| if k < n { k } else { k - n };
        let y = [n - 1, 0, 1, 2].map(|k| self.0[wrapped(i + k)]);
        let (m, p) = (0.5 * (y[2] - y[0]), 0.5 * (y[3] - y[1]));
        let rise = y[2] - y[1];
        let (square, cube) = (3.0 * rise - 2.0 * m - p, m + p - 2.0 * rise);
        let value = y[1] + u * (m + u * (square + u * cube));
        let slope = m + u * (2.0 * square + 3.0 * u * cube);
        (value, slope * n as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_phase_is_the_best_of_the_whole_turn() {
        let count = 720;
        let walk = |x: f64| {
            700.0 + 250.0 * x.cos() - 200.0 * (2.0 * x + 1.0).cos() + 90.0 * (5.0 * x).sin()
        };
        let target: Vec<f64> = (0..count)
            .map(|i| walk(TAU * i as f64 / count as f64))
            .collect();
        let time: Vec<f64> = (0..count).map(|i| i as f64 / count as f64).collect();
        let speed = vec![TAU; count];
        for k in 0..36 {
            let delay = TAU * f64::from(k) / 36.0;
            let poor = |t: &f64| walk(TAU * t - delay) + 60.0 * (3.0 * TAU * t).cos();
            let forces: Vec<f64> = time.iter().map(poor).collect();
            let found = error_in_time(&forces, &speed, &time, 1.0, &target).rms_error_n;
            let at = |shift: usize| {
                let off = |i: usize| forces[i] - target[(i + shift) % count];
                ((0..count).map(|i| off(i).powi(2)).sum::<f64>() / count as f64).sqrt()
            };
            let least = (0..count).map(at).fold(f64::INFINITY, f64::min);
            assert!(
                found < least * (1.0 + 1e-9) && found > 0.99 * least,
                "{delay}: {found} {least}"
            );
        }
    }
}
