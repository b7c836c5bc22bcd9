//! Design of the next cam. The repeatable difference between log and design is attributed to the machine and corrected.

use serde::Serialize;

use super::fitted::Fitted;
use super::least_squares::{difference, dot};
use super::log::Log;
use super::model::{ANGLES, Effect, Machine, Term, angle};
use super::run::held;
use super::{Identified, identified};
use crate::drive::{Drive, DriveKind};
use crate::error::{LogError, NoNewCamError, Result};
use crate::force::ForceCurve;
use crate::poly::amplitudes;
use crate::problem::Problem;
use crate::scene::{Harmonic, Scene};
use crate::synth::{self, Design, Search};
use crate::units::{Dimension, Quantity};

/// Minimum ratio of amplitude to noise for which a harmonic is corrected.
const ABOVE_NOISE: f64 = 2.0;
/// Maximum order of a corrected harmonic, as a multiple of the number of harmonics of the target. At higher orders, resonances of the real machine
/// could reverse the sign of a correction.
const IN_BAND: usize = 3;
/// Assumed relative uncertainty of stiffness and mass, and of the added damping ratio of the guide.
const UNSURE: f64 = 0.05;
/// Fraction of the correction that is applied if the design already contains an earlier correction. Coulomb friction changes its sign with the
/// velocity, so full corrections could oscillate.
const AGAIN: f64 = 0.5;
/// Number of times that the law is designed again with the force change of the identified parameters, which depends on the law.
const ROUNDS: usize = 2;

/// Force error before the correction and predicted error after it, N.
///
/// ```
/// use gaitcam::identify::Recut;
///
/// let recut = Recut { before_rms_n: 12.0, predicted_rms_n: 2.0 };
/// assert_eq!(serde_json::to_value(&recut).unwrap()["predicted_rms_n"], 2.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Recut {
    /// RMS difference between repeatable force and target, N. On a moving axis, the mean is excluded because it is the weight.
    pub before_rms_n: f64,
    /// Predicted RMS force error of the new cam, N. It contains the remaining noise, the effect of the limits and the harmonics that are
    /// not corrected. It also contains the friction, which changes its sign at other angles than before.
    pub predicted_rms_n: f64,
}

/// Maximum relative difference between the speeds of log and design for which the log is used to correct the force error.
const OTHER_SPEED: f64 = 0.1;

/// Designs the next cam. Returns its scene, with the learned force as `machine.learned_force`, the predicted error, and the identified parameters.
/// `force` is the target of the scene.
///
/// The new scene keeps the nominal parameters of the machine. The effect of identified parameters is part of the learned force, computed for the new
/// law.
///
/// The corrected error is the mean over the cycles of all logs whose speed is within 1 % of the speed nearest to the design. Logs at other speeds are
/// used only for the identification.
///
/// # Errors
///
/// - The errors of [`super::identify`].
/// - The design has no target.
/// - No log is within 10 % of the speed of the design.
/// - The residual is only noise.
/// - The errors of the new design.
pub fn recut(
    design: &Design,
    scene: &Scene,
    force: Option<&ForceCurve>,
    logs: &[Log],
    search: &Search,
) -> Result<(Scene, Recut, Identified)> {
    let fitted = Fitted::of(design, scene, logs)?;
    let place = fitted.nearest(design);
    let (log, run) = (&logs[place], &fitted.runs[place]);
    let Some(target) = design.target() else {
        return Err(log.refused(LogError::NoTarget));
    };
    let (clock, speed) = (&run.clock, run.cycles.speed);
    if (speed / design.problem.drive.speed - 1.0).abs() > OTHER_SPEED {
        let [speed, design] =
            [speed, design.problem.drive.speed].map(|w| Quantity::new(w, Dimension::AngularSpeed));
        return Err(log.refused(LogError::OtherSpeed { speed, design }));
    }
    let found = identified(design, scene, &fitted);
    let measured = &fitted.measured_at(place);
    let count = measured.mean.len();
    let noise = measured.variance();
    let from = usize::from(design.problem.drive.kind == DriveKind::MovingAxis);
    // The required force is a function of time. As a function of the cam angle, it differs from the target of the design if the speed
    // varies differently.
    let in_time = design.target_in_time().unwrap_or(target);
    let wanted: Vec<f64> = clock.time.iter().map(|t| in_time.at(*t)).collect();
    let taken = (0..ANGLES).map(|i| target.at(angle(i)));
    let moved: Vec<f64> = wanted.iter().zip(taken).map(|(w, t)| w - t).collect();
    let wanted = clock.harmonics(&wanted, count);
    let before = repeated(&difference(&measured.mean, &wanted), &noise, from);
    let nominal = (0..ANGLES).map(|i| design.force_at(angle(i)) + moved[i]);
    let nominal: Vec<f64> = nominal.collect();
    let news = difference(&measured.mean, &clock.harmonics(&nominal, count));
    let band = IN_BAND * held(&wanted);
    let whole = match scene.machine.learned_force.is_empty() {
        true => 1.0,
        false => AGAIN,
    };
    let part = |n: usize| whole * convergent(&design.problem.drive, n as f64 * speed);
    let (learned, left) = shrunk(&news, &noise, from, band, part);
    if learned.iter().all(|x| *x == 0.0) {
        let newtons = |x: f64| Quantity::force(design.problem.drive.newtons(x));
        let scatter: f64 = noise[1..].iter().sum();
        let (residual, noise) = (newtons(rms(&news, from)), newtons((0.5 * scatter).sqrt()));
        return Err(log.refused(NoNewCamError::Noise { residual, noise }));
    }
    let is_used = |(i, _): &(usize, &Term)| found.parameters[*i].identifiable;
    let used: Vec<(f64, &Term)> = (fitted.terms.iter().enumerate().filter(is_used))
        .filter(|(_, t)| t.key != "log.bias" && t.key != "drive.preload")
        .map(|(i, t)| (fitted.fit.each[i].value - t.nominal, t))
        .collect();
    // Friction that is not identified is not part of the model, but its sign changes with the velocity of the new law.
    let rubbing = (fitted.terms.iter().enumerate())
        .filter(|(i, t)| t.effect == Effect::Coulomb && !found.parameters[*i].identifiable)
        .map(|(i, t)| (fitted.fit.each[i].value - t.nominal, t));
    let rubbing: Vec<(f64, &Term)> = used.iter().copied().chain(rubbing).collect();
    // Force change caused by the parameter changes, for the law of a design.
    let changed_by = |terms: &[(f64, &Term)], of: &Design| -> Vec<f64> {
        let machine = Machine::new(of, scene, clock);
        let mut sum = vec![0.0; ANGLES];
        for (by, term) in terms {
            let effect = machine.effect(term.effect);
            sum.iter_mut().zip(effect).for_each(|(x, e)| *x += by * e);
        }
        sum
    };
    let changed = |of: &Design| changed_by(&used, of);
    let own: Vec<f64> = clock.at_angles(&learned);
    let first = changed(design);
    let mut next = scene.clone();
    let mut made = design.clone();
    for round in 0..=ROUNDS {
        let now = if round == 0 {
            first.clone()
        } else {
            changed(&made)
        };
        let sum = (0..ANGLES).map(|i| own[i] + now[i] - first[i]);
        next.machine.learned_force = joined(design, &sum.collect::<Vec<_>>(), band, from);
        if used.is_empty() && round > 0 {
            break;
        }
        made = synth::design(&Problem::resolve(&next, force)?, search)?;
    }
    // Difference of the force changes under the new and the previous law, minus the part for which the new law was designed.
    let [now, before_it] = [&made, design].map(|of| changed_by(&rubbing, of));
    let taken = |i: usize| {
        made.problem.learned_force(angle(i)) - design.problem.learned_force(angle(i)) - own[i]
    };
    let moved: Vec<f64> = (0..ANGLES)
        .map(|i| now[i] - before_it[i] - taken(i))
        .collect();
    let after = [left, made.force.rms_error_n, spread(&moved, from)];
    let after = design.problem.drive.newtons(dot(&after, &after).sqrt());
    let recut = Recut {
        before_rms_n: design.problem.drive.newtons(before),
        predicted_rms_n: after,
    };
    Ok((next, recut, found))
}

/// Sum of the learned force of the design and the correction, as harmonics of the cam angle, N. For an arm, it is the force at the lever of the
/// drive.
fn joined(design: &Design, news: &[f64], band: usize, from: usize) -> Vec<Harmonic> {
    let problem = &design.problem;
    let sum: Vec<f64> = (0..ANGLES)
        .map(|i| problem.learned_force(angle(i)) + news[i])
        .map(|f| design.problem.drive.newtons(f))
        .collect();
    let terms = amplitudes(&sum);
    let mean = if from == 0 { terms[0].0 } else { 0.0 };
    let constant = Harmonic {
        factor: (1e6 * mean).round() / 1e6,
        phase: 0.0,
    };
    let short = |x: f64| (1e6 * x).round() / 1e6;
    let harmonic = |(a, b): &(f64, f64)| Harmonic {
        factor: short(libm::hypot(*a, *b)),
        phase: short(libm::atan2(*a, *b)),
    };
    let all = terms[1..=band].iter().map(harmonic);
    std::iter::once(constant).chain(all).collect()
}

/// RMS of harmonics. The mean is included if `from` = 0.
fn rms(harmonics: &[f64], from: usize) -> f64 {
    let mean = if from == 0 { harmonics[0].powi(2) } else { 0.0 };
    (mean + 0.5 * dot(&harmonics[1..], &harmonics[1..])).sqrt()
}

/// RMS of values at equally spaced angles. The mean is included if `from` = 0.
fn spread(values: &[f64], from: usize) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let square = dot(values, values) / count;
    let without = if from == 0 { 0.0 } else { mean * mean };
    (square - without).max(0.0).sqrt()
}

/// RMS of the repeatable part of harmonics. The variance of the noise is subtracted from the mean square.
fn repeated(harmonics: &[f64], noise: &[f64], from: usize) -> f64 {
    let scatter = 0.5 * noise[1..].iter().sum::<f64>() + if from == 0 { noise[0] } else { 0.0 };
    (rms(harmonics, from).powi(2) - scatter).max(0.0).sqrt()
}

/// Fraction of a correction at an angular frequency, rad/s, for which repeated corrections converge.
///
/// The gain from the lift to the force is k − m ω² + i c ω, with the relative uncertainty `UNSURE` of its terms. Corrections converge if the fraction
/// times the ratio of true to nominal gain is below 2. Near the resonance of a spring, this ratio is uncertain (Bristow, Tharayil and Alleyne 2006).
fn convergent(drive: &Drive, frequency: f64) -> f64 {
    let inertia = drive.mass * frequency * frequency;
    let gain = libm::hypot(drive.spring_rate - inertia, drive.damping * frequency);
    let critical = 2.0 * (drive.spring_rate * drive.mass).sqrt();
    let unsure = UNSURE * (drive.spring_rate + inertia + critical * frequency);
    let sum = gain + unsure;
    if sum > 0.0 { gain / sum } else { 1.0 }
}

/// Harmonics of the correction, and RMS of the remaining force error, N. A harmonic above its noise is multiplied by the fraction `made` and by its
/// likely repeatable part. The remainder contains the other harmonics and the noise. Both results are zero if the residual is only noise.
fn shrunk(
    news: &[f64],
    noise: &[f64],
    from: usize,
    band: usize,
    made: impl Fn(usize) -> f64,
) -> (Vec<f64>, f64) {
    let mut out = vec![0.0; news.len()];
    let mut left = 0.0;
    let groups = (1..=news.len() / 2).map(|n| (n, 2 * n - 1..2 * n + 1, 0.5));
    let mean = (from == 0).then_some((0, 0..1, 1.0));
    for (n, own, part) in mean.into_iter().chain(groups) {
        let energy = dot(&news[own.clone()], &news[own.clone()]);
        let scatter: f64 = noise[own.clone()].iter().sum();
        if n > band || energy <= ABOVE_NOISE * ABOVE_NOISE * scatter {
            left += part * (energy - scatter).max(0.0);
            continue;
        }
        let (kept, made) = (1.0 - scatter / energy, made(n));
        left += part * kept * (scatter + (1.0 - made).powi(2) * energy);
        own.for_each(|j| out[j] = made * kept * news[j]);
    }
    let [all, scatter] = [dot(&news[1..], &news[1..]), noise[1..].iter().sum::<f64>()];
    let spread = noise[1..].iter().map(|v| v * v).sum::<f64>();
    let is_noise = all <= scatter + super::fit::EXCESS * (2.0 * spread).sqrt();
    let has_mean = from == 0 && out[0] != 0.0;
    if is_noise && !has_mean {
        return (vec![0.0; news.len()], 0.0);
    }
    (out, left.sqrt())
}
