//! Comparison of the force of a cam with the target.

use serde::Serialize;

use crate::drive::Drive;
use crate::law::Law;
use crate::problem::Problem;

/// Comparison of the force of a cam with the target force. All values are exact for the continuous law.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // On a moving axis, the mean force of every law is M·g.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let force = synthesise(&scene, scene.model_force()?.as_ref())?.force;
/// assert!((force.mean_n - 700.0).abs() < 1e-6);
/// assert!(force.rms_error_percent_of_mean <= 0.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ForceReport {
    /// Root mean square of the force error over the cycle, N.
    pub rms_error_n: f64,
    /// Maximum absolute force error, N.
    pub max_error_n: f64,
    /// RMS force error in percent of the mean target.
    pub rms_error_percent_of_mean: f64,
    /// Mean of the target, N.
    pub target_mean_n: f64,
    /// Mean force of the cam, N.
    pub mean_n: f64,
    /// Minimum force of the cam, N.
    pub min_n: f64,
    /// Maximum force of the cam, N.
    pub max_n: f64,
}

impl ForceReport {
    /// Comparison of the force of a law with the target, exact on the spans of law and target.
    pub(in crate::synth) fn of(problem: &Problem, law: &Law) -> ForceReport {
        let own = problem.force_curve(law);
        let (low, high) = problem.force_extremes(law);
        let (start, length) = law.extent();
        let mut report = ForceReport {
            mean_n: own.integral() / length,
            min_n: low.value,
            max_n: high.value,
            ..ForceReport::default()
        };
        if let Some(target) = &problem.target {
            report.target_mean_n = target.mean_n();
            [report.rms_error_n, report.max_error_n] = target.error_of(law, &problem.drive);
            report.rms_error_percent_of_mean =
                100.0 * report.rms_error_n / report.target_mean_n.abs();
            debug_assert!(start == 0.0);
        }
        report
    }

    /// Converts a report with moments about the pivot of an arm, N·m, to forces at the lever of the arm, N. Other reports are unchanged.
    #[must_use]
    pub fn newtons(self, drive: &Drive) -> ForceReport {
        ForceReport {
            rms_error_n: drive.newtons(self.rms_error_n),
            max_error_n: drive.newtons(self.max_error_n),
            rms_error_percent_of_mean: self.rms_error_percent_of_mean,
            target_mean_n: drive.newtons(self.target_mean_n),
            mean_n: drive.newtons(self.mean_n),
            min_n: drive.newtons(self.min_n),
            max_n: drive.newtons(self.max_n),
        }
    }
}
