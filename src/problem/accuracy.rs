//! Accuracy of the force: permitted error, and weights of the force error in ranges of the cycle.

use std::f64::consts::TAU;

use super::Problem;
use super::target::weight_at;
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::scene::{LimitKind, Minimise};

/// Default permitted RMS force error, relative to the mean force.
const USUAL_ACCURACY: f64 = 0.005;
/// Relative difference between mean force and weight below which they count as equal, because masses are given with four digits.
const SAME_MEAN: f64 = 1e-3;

impl Problem {
    /// RMS force error, N, for which the automatic number of spans or harmonics is chosen; 0 without a target force.
    pub fn wanted_error(&self) -> f64 {
        self.error_at_noise().unwrap_or(self.asked_error())
    }

    /// RMS force error, N, from the required accuracy. Without a required accuracy, it is 0.5 % of the mean target force. Spread and noise
    /// of the recording are not taken into account.
    pub fn asked_error(&self) -> f64 {
        self.accuracy.unwrap_or(USUAL_ACCURACY) * self.target_mean()
    }

    /// RMS force error, N, above which a design fails. If the scene requires an accuracy, the result is this accuracy times the mean force.
    /// Otherwise it is the larger of two values. The first is the step-to-step spread. The second is the root sum of squares of the sensor
    /// noise and 0.5 % of the mean. `None` without a target force, or if the scene switches this check off.
    pub fn largest_error(&self) -> Option<f64> {
        let force = self.force.filter(|_| !self.limits.unjudged.accuracy)?;
        let asked = self.asked_error();
        let automatic = || libm::hypot(asked, self.sensor_noise()).max(force.spread_n);
        Some(self.accuracy.map_or_else(automatic, |_| asked))
    }

    /// Default minimum contact force of the verdict, N. It is 0 on a moving axis. It is also 0 on a fixed axis with a force and without
    /// form closure. `None` for other machines, or if the scene switches this check off.
    pub fn usual_force_min(&self) -> Option<f64> {
        let form_closed = self.cam.conjugate.is_some()
            || self.cam.breadth.is_some()
            || self.cam.follower == FollowerKind::Barrel;
        let pressed = match self.drive.kind {
            DriveKind::MovingAxis => true,
            DriveKind::FixedAxis => !self.drive.is_idle() && !form_closed,
            DriveKind::Hydraulic => false,
        };
        (pressed && !self.limits.unjudged.contact_force).then_some(0.0)
    }

    /// RMS force error, N, for which the automatic number of spans or harmonics is chosen, if the spread or the noise of the recording
    /// determines it. `None` if the scene requires an accuracy, or if spread and noise do not increase this error.
    pub fn error_at_noise(&self) -> Option<f64> {
        let asked = self.asked_error();
        let error = libm::hypot(asked.max(self.noise()), self.sensor_noise());
        (self.accuracy.is_none() && error > asked).then_some(error)
    }

    /// RMS sensor noise in the samples of a single cycle, N; 0 if there are several cycles, whose spread includes the noise. The force
    /// error of a smooth law cannot be smaller than the noise.
    pub fn sensor_noise(&self) -> f64 {
        let single = self.force.filter(|force| force.spread_n == 0.0);
        single.map_or(0.0, |force| force.noise_n)
    }

    /// Magnitude of the mean target force, N; 0 without a target.
    pub fn target_mean(&self) -> f64 {
        self.force.map_or(0.0, |force| force.mean_n.abs())
    }

    /// Force error, N, below which a fit would follow the noise: one fifth of the step-to-step spread. Such an error increases the spread
    /// by 2 %.
    fn noise(&self) -> f64 {
        0.2 * self.force.map_or(0.0, |force| force.spread_n)
    }

    /// Whether the scene requires a positive contact force, but the drive has neither a spring nor a positive force at rest. The mean force
    /// over a turn is then not positive, so the requirement is infeasible.
    pub(crate) fn presses_too_little(&self) -> bool {
        let asked = self.limits[LimitKind::ForceMin].is_some_and(|least| least > 0.0);
        asked && self.drive.spring_rate <= 0.0 && self.drive.rest_force <= 0.0
    }

    /// Permitted RMS force error, N, as [`Problem::largest_error`]. `None` if a tolerance band replaces the accuracy.
    pub fn allowed_error(&self) -> Option<f64> {
        self.largest_error().filter(|_| self.band.is_none())
    }

    /// Permitted RMS force error, N, if it is a limit of the law. `None` in three cases: the unweighted force error is minimised, the
    /// permitted error is 0, or the mean force of the drive differs from the mean target force.
    pub fn limited_error(&self) -> Option<f64> {
        let is_minimised = self.objective() == Minimise::ForceError && !self.is_weighed();
        let asked = self.allowed_error().filter(|most| *most > 0.0)?;
        (!is_minimised && self.mean_force_gap().is_none()).then_some(asked)
    }

    /// Whether the cam is designed for several walkers or cycles.
    pub fn serves_several(&self) -> bool {
        self.walkers.as_ref().is_some_and(|w| w.each.len() > 1)
    }

    /// Permitted RMS force error, N, for a design for one walker or cycle. `None` for several walkers, because the force error of each
    /// walker is limited separately.
    pub fn judged_error(&self) -> Option<f64> {
        self.allowed_error().filter(|_| !self.serves_several())
    }

    /// Mean target force minus the weight of the mass on a moving axis, N. A cam cannot change the mean over a turn (theory §1). `None` for
    /// another drive, without a permitted error, or if the difference is within the rounding error of the mass.
    pub fn mean_force_gap(&self) -> Option<f64> {
        let gap = self.target_mean() - self.drive.rest_force;
        let judged = self.drive.kind == DriveKind::MovingAxis && self.judged_error().is_some();
        (judged && gap.abs() > SAME_MEAN * self.target_mean()).then_some(gap)
    }

    /// Whether the force error has different weights in ranges of the cycle.
    pub fn is_weighed(&self) -> bool {
        !self.weights.is_empty()
    }

    /// Weight of the squared force error at a cam angle, rad.
    pub fn weight(&self, theta: f64) -> f64 {
        weight_at(&self.weights, theta + self.phase)
    }

    /// Cam angles within the turn, rad, at which the weight can jump, in ascending order.
    pub fn weight_edges(&self) -> Vec<f64> {
        let ends = self.weights.iter().flat_map(|w| [w.from, w.to]);
        let mut edges: Vec<f64> = ends.map(|at| (at - self.phase).rem_euclid(TAU)).collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        edges
    }

    /// Minimum weight of the force error over the cycle, at most 1.
    pub fn least_weight(&self) -> f64 {
        (self.weights.iter()).fold(1.0, |least, w| least.min(w.weight))
    }
}
