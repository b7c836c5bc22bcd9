//! How well a cam serves each of several walkers.

use serde::Serialize;

use crate::scene::ErrorMeasure;

/// How well one cam serves a population.
///
/// ```
/// use gaitcam::scene;
///
/// // One cam for every cadence: the walker of 1.4 Hz or 2.4 Hz errs most, and by much less than with the mean cam.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.4 Hz:2.4 Hz:11")?;
/// let mean = scene.design()?.population.unwrap();
/// let worst = scene.with("law.robust", "worst")?.design()?.population.unwrap();
/// assert!(worst.worst_percent < 0.8 * mean.worst_percent);
/// assert!(worst.gap <= 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OfPopulation {
    /// Walkers, whatever the number of their cycles.
    pub walkers: usize,
    /// Cycles of all walkers.
    pub cycles: usize,
    /// What was minimised.
    pub robust: String,
    /// In what errors were compared: relative, absolute.
    pub error: &'static str,
    /// Root of what was minimised, in percent of each walker's mean force, or of the mean of all where errors are absolute: what
    /// `accuracy.rms` is compared with.
    pub objective_percent: f64,
    /// Largest RMS force error, percent of the walker's mean force.
    pub worst_percent: f64,
    /// Mean of the RMS force errors, by weight.
    pub mean_percent: f64,
    /// Mean of the largest of them: of the last tenth, or of what the objective names.
    pub cvar_percent: f64,
    /// The same in newtons: largest,
    pub worst_n: f64,
    /// mean,
    pub mean_n: f64,
    /// and mean of the largest.
    pub cvar_n: f64,
    /// Whose error is the largest, as errors are compared.
    pub worst_walker: String,
    /// The objective less its proved lower bound, part of the objective (a mean square).
    pub gap: f64,
    /// No law at any phases of the walkers has a smaller `objective_percent` than this; `None` where the phases are given.
    pub bound_percent: Option<f64>,
    /// Designs that were computed.
    pub rounds: usize,
    /// Place of the cycle with the largest error.
    #[serde(skip)]
    pub worst: usize,
    /// Each cycle.
    #[serde(skip)]
    pub each: Vec<WalkerError>,
}

/// How well a cam serves a walker.
///
/// ```
/// use gaitcam::scene;
///
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.6 Hz:2 Hz:3")?;
/// let each = scene.design()?.population.unwrap().each;
/// assert_eq!(each[1].walker, "1.8 Hz");
/// assert!((each[1].speed_rad_per_s - std::f64::consts::TAU * 1.8).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WalkerError {
    /// Who.
    pub walker: String,
    /// Mass to which the machine is set, kg.
    pub mass_kg: f64,
    /// Speed of the cam, rad/s.
    pub speed_rad_per_s: f64,
    /// Phase of the walker's cycle at cam angle 0, rad.
    pub phase_rad: f64,
    /// RMS force error, percent of the mean force.
    pub rms_error_percent: f64,
    /// RMS force error, N.
    pub rms_error_n: f64,
    /// What the walker counts in a mean.
    pub share: f64,
    /// Walking speed, m/s, where it is known.
    pub speed_m_per_s: Option<f64>,
}

impl WalkerError {
    /// The RMS force error in percent or in newtons, as errors are compared.
    pub fn measured(&self, error: ErrorMeasure) -> f64 {
        match error {
            ErrorMeasure::Relative => self.rms_error_percent,
            ErrorMeasure::Absolute => self.rms_error_n,
        }
    }
}
