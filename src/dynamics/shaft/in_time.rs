//! A force that is given over the cam angle, held against a target over time.

use std::f64::consts::TAU;

use serde::Serialize;

/// Distance of a force to its target over time, the phase set right and the mean speed given.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::{Drive, Motor, TorqueLine};
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // A target that is the force of the steady cam a tenth of a turn later: the phase is set right.
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
    /// Root mean square over the period, N.
    pub rms_error_n: f64,
    /// The same as percent of the target's mean over time.
    pub rms_error_percent_of_mean: f64,
}

/// Rounds of the phase at most, and its change, parts of the period, at which they end: by how much the error still falls with
/// that change follows from the slope.
const ROUNDS: usize = 20;
const SAME: f64 = 1e-4;

/// The distance of forces at equal angles, with speed, rad/s, and time, s, from a target at equal times of one period
/// that begins at the same angle.
pub fn error_in_time(
    forces: &[f64],
    speed: &[f64],
    time: &[f64],
    period: f64,
    target: &[f64],
) -> InTime {
    let weights: Vec<f64> = speed
        .iter()
        .map(|w| TAU / forces.len() as f64 / w / period)
        .collect();
    let cubic = Cubic(target);
    let (mut shift, mut square) = (0.0, 0.0);
    for _ in 0..ROUNDS {
        let (mut slope, mut bend) = (0.0, 0.0);
        square = 0.0;
        for ((force, t), w) in forces.iter().zip(time).zip(&weights) {
            let (wanted, rate) = cubic.at(t / period + shift);
            let off = force - wanted;
            square += w * off * off;
            slope += w * off * rate;
            bend += w * rate * rate;
        }
        if bend == 0.0 {
            break;
        }
        let change = slope / bend;
        if change.abs() < SAME {
            square = (square - change * slope).max(0.0);
            break;
        }
        shift += change;
    }
    let mean = target.iter().sum::<f64>() / target.len() as f64;
    let rms_error_n = f64::sqrt(square);
    InTime {
        rms_error_n,
        rms_error_percent_of_mean: 100.0 * rms_error_n / mean.abs(),
    }
}

/// Samples of one period with cubics between them.
pub struct Cubic<'a>(pub &'a [f64]);

impl Cubic<'_> {
    /// Value and slope at a share of the period, by Catmull and Rom's cubics.
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
