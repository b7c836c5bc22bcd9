//! Walkers of a population. The machine is adjusted for each walker.
//!
//! Symbols: F force of the reference machine, R its force at rest, M its moved mass and ω its speed. F_w, R_w, M_w and ω_w are these
//! quantities for walker w.
//!
//! The force of the machine for walker w is F_w = R_w + β_w (F − R). Mass and speed determine R_w and the factor β_w, which is M_w ω_w²/(M
//! ω²) on a moving axis. The forces for all walkers are therefore linear in the same law.

use std::f64::consts::TAU;

use super::machine;
use super::mean_force::MeanForce;
use super::target::Target;
use crate::drive::{Drive, DriveKind};
use crate::error::{Placed, Result, SynthError};
use crate::force::{ForceCurve, Population, Walker};
use crate::scene::{Adjust, ErrorMeasure, Robust, Scene};

/// Relative tolerance of the check that the force coefficients of two drives are proportional.
const SAME: f64 = 1e-12;

/// A walker, or one cycle of a walker, for whom a cam is designed.
///
/// ```
/// use gaitcam::{Problem, scene};
///
/// // The same cam at another speed and mass. The factor is β = M ω²/(M₀ ω₀²), with mass and speed of the reference machine in the
/// // denominator.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.6 Hz:2 Hz:2")?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let served = &problem.walkers.as_ref().unwrap().each;
/// assert!((served[1].factor / served[0].factor - (2.0_f64 / 1.6).powi(2)).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Served {
    /// Name of the walker.
    pub name: String,
    /// Weight of the cycle in a mean over all cycles. The sum of all weights is 1.
    pub share: f64,
    /// Drive of the machine after its adjustment for the walker.
    pub drive: Drive,
    /// Factor β of the force of this walker's machine, relative to the reference machine.
    pub factor: f64,
    /// Force to which the force error is related, N. For relative errors, it is the mean of the walker's target. For absolute errors, it is
    /// the mean of the common target, which is equal for all walkers.
    pub unit: f64,
    /// Target force, N, at the phase of the cam. It is scaled as the scene requires.
    pub target: ForceCurve,
    /// Walking speed, m/s; `None` if it is unknown.
    pub speed_m_per_s: Option<f64>,
}

/// All walkers for whom a cam is designed.
///
/// ```
/// use gaitcam::scene::Robust;
/// use gaitcam::{Problem, scene};
///
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.4 Hz:2.4 Hz:11")?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let walkers = problem.walkers.unwrap();
/// assert_eq!((walkers.each.len(), walkers.robust), (11, Robust::Mean));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Walkers {
    /// All cycles of all walkers.
    pub each: Vec<Served>,
    /// Number of walkers; a walker may have several cycles.
    pub count: usize,
    /// Function of the walkers' force errors that the design minimises, such as their mean square.
    pub robust: Robust,
    /// Measure of the force errors: relative to the mean force, or in newtons.
    pub error: ErrorMeasure,
    /// Quantities of the machine that are adjusted for each walker.
    pub adjust: Adjust,
}

impl Walkers {
    /// Walkers of the force. `reference` is the drive of the reference machine, and `mean` the mean of its target. `None` if the force does
    /// not belong to a population.
    pub(super) fn of(
        scene: &Scene,
        force: Option<&ForceCurve>,
        reference: &Drive,
        mean: Option<MeanForce>,
    ) -> Result<Option<Walkers>> {
        let Some(population) = force.and_then(|f| f.population.as_deref()) else {
            return Ok(None);
        };
        let adjust = adjusted(scene)?;
        let with = |adjust| Walkers::adjusted(scene, population, reference, mean, adjust);
        let is_asked = scene.gait.as_ref().is_some_and(|g| g.adjust.is_some());
        if is_asked || reference.kind == DriveKind::MovingAxis {
            return with(adjust).map(Some);
        }
        // For a machine with springs, dampers and masses together, the forces at two speeds are not proportional.
        let fixed = Adjust {
            speed: false,
            ..adjust
        };
        with(adjust).or_else(|_| with(fixed)).map(Some)
    }

    /// Walkers of a population. `adjust` states which quantities of the machine are adjusted for each walker.
    fn adjusted(
        scene: &Scene,
        population: &Population,
        reference: &Drive,
        mean: Option<MeanForce>,
        adjust: Adjust,
    ) -> Result<Walkers> {
        let mut set = scene.clone();
        if adjust.mass {
            set.drive.mass = None;
        } else if reference.kind == DriveKind::MovingAxis {
            set.drive.mass = Some(reference.mass);
        }
        set.drive.speed = (!adjust.speed).then_some(reference.speed);
        let samples = population.walkers.iter().map(|w| w.curve.force_n.len());
        let samples = samples.max().unwrap_or_default();
        let served = |(walker, share): (&Walker, f64)| {
            let curve = resampled(&walker.curve, samples);
            let (drive, scaling) = machine::of_force(&set, Some(MeanForce::of(&curve)))?;
            let target = scaling.of(&curve);
            Ok(Served {
                name: walker.name.clone(),
                share,
                factor: factor(&drive, reference)?,
                drive,
                unit: match scene.law.error {
                    ErrorMeasure::Relative => target.mean_n().abs(),
                    ErrorMeasure::Absolute => mean.map_or(0.0, |mean| mean.mean_n.abs()),
                },
                target,
                speed_m_per_s: walker.speed_m_per_s,
            })
        };
        let each: Result<Vec<Served>> = population.each().map(served).collect();
        Ok(Walkers {
            each: each?,
            count: population.count(),
            robust: scene.law.robust,
            error: scene.law.error,
            adjust,
        })
    }

    /// Copy in which each cycle starts at the phase, rad, with the same index in `phases`.
    #[must_use]
    pub(crate) fn at_phases(&self, phases: &[f64]) -> Walkers {
        let mut out = self.clone();
        for (walker, phase) in out.each.iter_mut().zip(phases).filter(|w| *w.1 != 0.0) {
            walker.target = super::force_cycle::begun_at(&walker.target, *phase);
        }
        out
    }

    /// Copy in which all cycles start at the phase `phase`, rad.
    #[must_use]
    pub(super) fn begun_at(&self, phase: f64) -> Walkers {
        let mut out = self.clone();
        for walker in &mut out.each {
            walker.target = super::force_cycle::begun_at(&walker.target, phase);
        }
        out
    }
}

/// Quantities of the machine that are adjusted for each walker. The scene determines them; otherwise the defaults are used.
fn adjusted(scene: &Scene) -> Result<Adjust> {
    let (spec, is_moving) = (&scene.drive, scene.drive.kind == DriveKind::MovingAxis);
    let Some(adjust) = scene.gait.as_ref().and_then(|g| g.adjust) else {
        return Ok(Adjust {
            mass: is_moving && spec.mass.is_none(),
            speed: spec.speed.is_none(),
            phase: false,
        });
    };
    let given = [
        ("drive.mass", adjust.mass && spec.mass.is_some()),
        ("drive.speed", adjust.speed && spec.speed.is_some()),
    ];
    if let Some((key, _)) = given.into_iter().find(|g| g.1) {
        let key = key.to_string();
        return Err(SynthError::AdjustsGiven { key }.at_key("gait.adjust"));
    }
    if adjust.mass && !is_moving {
        return Err(SynthError::MassNotAdjustable.at_key("gait.adjust"));
    }
    Ok(adjust)
}

/// Factor β of the force of a machine, relative to the reference machine.
fn factor(own: &Drive, reference: &Drive) -> Result<f64> {
    let (own, all) = (own.weights(), reference.weights());
    let largest = (0..all.len()).max_by(|i, j| all[*i].abs().total_cmp(&all[*j].abs()));
    let factor = largest.map_or(1.0, |i| own[i] / all[i]);
    let differs = |(own, all): (&f64, &f64)| (own - factor * all).abs() > SAME * own.abs();
    if own.iter().zip(&all).any(differs) {
        return Err(SynthError::SpeedNotAdjustable.at_key("gait.adjust"));
    }
    Ok(factor)
}

/// Copy of a cycle with another number of samples, computed by interpolation.
fn resampled(curve: &ForceCurve, samples: usize) -> ForceCurve {
    if curve.force_n.len() == samples {
        return curve.clone();
    }
    let at = |i: usize| curve.at(TAU * i as f64 / samples as f64);
    curve.with_forces((0..samples).map(at).collect())
}

impl super::Problem {
    /// Copy of the problem for a single target in phase with the cam, without walkers. `slopes` are the slopes of the cubics of the target,
    /// N per sample.
    #[must_use]
    pub(crate) fn for_target(&self, curve: ForceCurve, slopes: Vec<f64>) -> super::Problem {
        let mut out = self.clone();
        out.target = Some(Target::with_slopes(curve, slopes));
        out.walkers = None;
        out.phase_is_free = false;
        out
    }
}
