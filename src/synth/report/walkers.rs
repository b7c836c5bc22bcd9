//! Force errors of one cam for several walkers.

use serde::Serialize;

use crate::scene::ErrorMeasure;

/// Force errors of one cam for a population of walkers.
///
/// ```
/// use gaitcam::scene;
///
/// // If the maximum error over all step frequencies is minimised, it is at least 20 % smaller than with the minimum mean error.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.4 Hz:2.4 Hz:11")?;
/// let mean = scene.design()?.population.unwrap();
/// let worst = scene.with("law.robust", "worst")?.design()?.population.unwrap();
/// assert!(worst.worst_percent < 0.8 * mean.worst_percent);
/// assert!(worst.gap <= 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OfPopulation {
    /// Number of walkers, regardless of the number of their cycles.
    pub walkers: usize,
    /// Number of cycles of all walkers.
    pub cycles: usize,
    /// Name of the objective over the walkers: mean, worst or tail.
    pub robust: String,
    /// Measure of the errors: relative to the mean force of each walker, or absolute.
    pub error: &'static str,
    /// Square root of the objective, in percent of each walker's mean force. For absolute errors, it is in percent of the mean force of all
    /// walkers. It is compared with `accuracy.rms`.
    pub objective_percent: f64,
    /// Maximum RMS force error, in percent of the mean force of the walker.
    pub worst_percent: f64,
    /// Weighted mean of the RMS force errors, in percent of the mean force of each walker.
    pub mean_percent: f64,
    /// Mean of the largest RMS force errors, in percent. The mean covers the worst tenth of the walkers, or the fraction given in the
    /// objective.
    pub cvar_percent: f64,
    /// Maximum RMS force error, N.
    pub worst_n: f64,
    /// Weighted mean of the RMS force errors, N.
    pub mean_n: f64,
    /// Mean of the largest RMS force errors, N.
    pub cvar_n: f64,
    /// Name of the walker with the maximum RMS force error.
    pub worst_walker: String,
    /// Difference between the objective, a mean square, and its proved lower bound, relative to the objective.
    pub gap: f64,
    /// Lower bound of `objective_percent` over all laws and phases; `None` if the phases are not adjustable.
    pub bound_percent: Option<f64>,
    /// Number of designs that were computed.
    pub rounds: usize,
    /// Index of the cycle with the maximum error in `each`.
    #[serde(skip)]
    pub worst: usize,
    /// Force error of each cycle.
    #[serde(skip)]
    pub each: Vec<WalkerError>,
}

/// Force error of a cam for one cycle of a walker, with the adjusted machine.
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
    /// Name of the walker.
    pub walker: String,
    /// Mass of the machine for this walker, kg.
    pub mass_kg: f64,
    /// Speed of the cam for this walker, rad/s.
    pub speed_rad_per_s: f64,
    /// Phase of the walker's cycle at cam angle 0, rad.
    pub phase_rad: f64,
    /// RMS force error, in percent of the mean force of the walker.
    pub rms_error_percent: f64,
    /// RMS force error, N.
    pub rms_error_n: f64,
    /// Weight of the cycle in a mean over the walkers.
    pub share: f64,
    /// Walking speed, m/s, if known.
    pub speed_m_per_s: Option<f64>,
}

impl WalkerError {
    /// RMS force error in percent or in newtons, depending on the measure.
    pub fn measured(&self, error: ErrorMeasure) -> f64 {
        match error {
            ErrorMeasure::Relative => self.rms_error_percent,
            ErrorMeasure::Absolute => self.rms_error_n,
        }
    }
}
