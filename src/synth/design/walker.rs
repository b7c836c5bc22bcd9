//! Comparison of the recorded walk with the cam at constant speed. Both forces act on a vibration mode with a natural frequency near the step
//! frequency.

use std::f64::consts::TAU;

use serde::Serialize;

use super::Design;
use crate::dynamics::RepeatedForce;
use crate::force::{ForceCurve, StepStatistics, Walk};

/// Number of equally spaced angles at which the force of the cam is computed.
const SAMPLES: usize = 1024;

/// Responses of a lightly damped mode to the recorded walk and to the cam, at resonance.
///
/// ```
/// use gaitcam::force::{Feet, ReadOptions, force_curve};
/// use gaitcam::scene;
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_long_walk.csv"));
/// let force = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let design = scene::parse("gait.file = \"walk.csv\"")?.design_for(&force)?;
/// let walker = design.walker().unwrap();
/// assert_eq!(walker.strides, 48);
/// // A cam that repeats one stride is more severe at resonance than a person whose steps vary by 2.5 %.
/// assert!(walker.resonance[1].ratio > 1.1);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OfWalker {
    /// Number of recorded strides.
    pub strides: usize,
    /// Mean step frequency of the recorded strides, Hz.
    pub step_frequency_hz: f64,
    /// Comparison for each damping ratio.
    pub resonance: Vec<AtResonance>,
}

/// Maximum responses of a mode of 1 kg. Its natural frequency varies from 0.9 to 1.1 times the step frequency.
///
/// ```
/// use gaitcam::synth::AtResonance;
///
/// let at = AtResonance { damping_ratio: 0.005, recorded: 6216.0, mean_stride: 8726.0, ratio: 8726.0 / 6216.0, resolved: true };
/// assert!((at.ratio - 1.404).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AtResonance {
    /// Damping ratio of the mode.
    pub damping_ratio: f64,
    /// RMS acceleration under the recorded strides, repeated periodically, m/s².
    pub recorded: f64,
    /// RMS acceleration under the cam at constant speed, m/s².
    pub mean_stride: f64,
    /// Response to the cam divided by the response to the recorded walk.
    pub ratio: f64,
    /// Whether the number N of recorded strides is sufficient for this damping ratio: 2π ζ N ≥ 1. With fewer strides, the response to the
    /// recorded walk is overestimated.
    pub resolved: bool,
}

impl Design {
    /// Force of the recorded strides, N, scaled like the target force. `None` unless the design is feasible, the cam makes one turn per
    /// stride, and eight consecutive strides of one walker are recorded.
    pub fn walk(&self) -> Option<Walk> {
        let walk = self.force_of_one()?.walk.clone()?;
        Some(walk.scaled(1.0 / self.problem.drive.lever))
    }

    /// Force of a generated walk, N. Each step has the shape of the target force, with random duration and amplitude. `None` without a
    /// target, for fewer than eight strides, for an infeasible design, or if the cam does not turn once per cycle.
    ///
    /// ```
    /// use gaitcam::force::StepStatistics;
    /// use gaitcam::scene;
    ///
    /// let design = scene::built_in("footbridge")?.scene()?.design()?;
    /// let walk = design.generated_walk(&StepStatistics::default()).unwrap();
    /// // The mean step of the default force takes 1/1.85 s.
    /// assert!((walk.step_frequency_hz() - 1.85).abs() < 1e-9);
    /// # Ok::<(), gaitcam::error::Error>(())
    /// ```
    pub fn generated_walk(&self, statistics: &StepStatistics) -> Option<Walk> {
        // With a motor, the target over the cam angle contains the varying speed of the shaft. The walk is a force over time, so the target
        // over time is used.
        let target = self.force_of_one().and(self.target_in_time())?;
        let drive = &self.problem.drive;
        let steps = self.problem.steps_per_turn.unwrap_or(2) as f64;
        let step_s = TAU / drive.speed.abs() / steps;
        // The cycle of the force begins where the cam angle equals minus the phase.
        let force = |phase: f64| drive.newtons(target.at(TAU * phase / steps - self.problem.phase));
        Walk::generated(step_s, statistics, force)
    }

    /// Target of a single walker, for a feasible design whose cam turns once per cycle; otherwise `None`.
    fn force_of_one(&self) -> Option<&ForceCurve> {
        let law = &self.cam.law;
        let turns = law.is_closed() && law.extent() == (0.0, TAU);
        let is_alone = self.population.is_none() && self.infeasible.is_none();
        self.target().filter(|_| turns && is_alone)
    }

    /// Force of the cam at constant speed, N, at equally spaced angles of one turn.
    fn steady_force(&self) -> Vec<f64> {
        let drive = &self.problem.drive;
        let force = drive.force_curve(self.pressing());
        let at = |i: usize| drive.newtons(force.eval(TAU * i as f64 / SAMPLES as f64));
        (0..SAMPLES).map(at).collect()
    }

    /// The recorded walk, its spectral lines, and the spectral lines of this cam at constant speed. `None` if [`Design::walk`] is `None`.
    pub fn repeated(&self) -> Option<(Walk, [RepeatedForce; 2])> {
        let walk = self.walk()?;
        let recorded = RepeatedForce::of(&walk);
        let period = TAU / self.problem.drive.speed.abs();
        let cam = RepeatedForce::new(&self.steady_force(), period, 1);
        Some((walk, [recorded, cam]))
    }

    /// Maximum responses to the recorded walk and to this cam at constant speed. `None` if [`Design::walk`] is `None`.
    pub fn walker(&self) -> Option<OfWalker> {
        let (walk, [recorded, cam]) = self.repeated()?;
        let resonance = RepeatedForce::DAMPING_RATIOS.map(|damping_ratio| {
            let (recorded_peak, mean_stride) =
                (recorded.peak(damping_ratio), cam.peak(damping_ratio));
            AtResonance {
                damping_ratio,
                recorded: recorded_peak,
                mean_stride,
                ratio: mean_stride / recorded_peak,
                resolved: recorded.resolves(damping_ratio),
            }
        });
        Some(OfWalker {
            strides: walk.strides(),
            step_frequency_hz: walk.step_frequency_hz(),
            resonance: resonance.to_vec(),
        })
    }
}
