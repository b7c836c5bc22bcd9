//! Accuracy of the force: required value, and weights of the ranges of the cycle.

use std::f64::consts::TAU;

use super::Problem;
use super::target::weight_at;
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::scene::{LimitKind, Minimise};

/// Default of the permitted RMS force error, relative to the mean force.
const USUAL_ACCURACY: f64 = 0.005;
/// Relative difference of mean force and weight below which both are equal, since masses have four digits.
const SAME_MEAN: f64 = 1e-3;

impl Problem {
    /// RMS force error, N, at which the automatic number of spans or harmonics is sufficient; 0 without a target force.
    pub fn wanted_error(&self) -> f64 {
        self.error_at_noise().unwrap_or(self.asked_error())
    }

    /// RMS force error that is sufficient without regard to the spread of the recording, N.
    pub fn asked_error(&self) -> f64 {
        self.accuracy.unwrap_or(USUAL_ACCURACY) * self.target_mean()
    }

    /// RMS force error, N, above which a design fails. It is the required accuracy. Without one it is 0.5 % of the mean plus the sensor noise or the
    /// step-to-step spread of the recording, whichever is larger. `None` without a target force, or if the scene switches this check off.
    pub fn largest_error(&self) -> Option<f64> {
        let force = self.force.filter(|_| !self.limits.unjudged.accuracy)?;
        let asked = self.asked_error();
        let automatic = || libm::hypot(asked, self.sensor_noise()).max(force.spread_n);
        Some(self.accuracy.map_or_else(automatic, |_| asked))
    }

    /// Default minimum contact force of the verdict, N: 0 if only the force keeps the contact, as on a moving axis.
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

    /// The error, N, if the spread or noise of the recording, not an accuracy, determines the number of spans or harmonics.
    pub fn error_at_noise(&self) -> Option<f64> {
        let asked = self.asked_error();
        let error = libm::hypot(asked.max(self.noise()), self.sensor_noise());
        (self.accuracy.is_none() && error > asked).then_some(error)
    }

    /// RMS sensor noise in the samples of a single cycle, N. The error of a smooth law cannot be smaller. The spread of several cycles includes this
    /// noise.
    pub fn sensor_noise(&self) -> f64 {
        let single = self.force.filter(|force| force.spread_n == 0.0);
        single.map_or(0.0, |force| force.noise_n)
    }

    /// Absolute mean of the target force, N; 0 without a target.
    pub fn target_mean(&self) -> f64 {
        self.force.map_or(0.0, |force| force.mean_n.abs())
    }

    /// Error below which a fit would follow the noise, N: a fifth of the step-to-step spread. It adds 2 % to the variation of the walker.
    fn noise(&self) -> f64 {
        0.2 * self.force.map_or(0.0, |force| force.spread_n)
    }

    /// Whether the scene requires a positive contact force although the drive has neither a spring nor a force at rest. The mean force over a turn is
    /// then zero.
    pub(crate) fn presses_too_little(&self) -> bool {
        let asked = self.limits[LimitKind::ForceMin].is_some_and(|least| least > 0.0);
        asked && self.drive.spring_rate <= 0.0 && self.drive.rest_force <= 0.0
    }

    /// [`Problem::largest_error`], unless a band replaces the accuracy.
    pub fn allowed_error(&self) -> Option<f64> {
        self.largest_error().filter(|_| self.band.is_none())
    }

    /// [`Problem::largest_error`], if it is a limit of the law. This requires that the objective is not the force error over the turn, and that a cam
    /// can satisfy the limit.
    pub fn limited_error(&self) -> Option<f64> {
        let is_minimised = self.objective() == Minimise::ForceError && !self.is_weighed();
        let asked = self.allowed_error().filter(|most| *most > 0.0)?;
        (!is_minimised && self.mean_force_gap().is_none()).then_some(asked)
    }

    /// Whether the cam is designed for several walkers or cycles.
    pub fn serves_several(&self) -> bool {
        self.walkers.as_ref().is_some_and(|w| w.each.len() > 1)
    }

    /// Maximum force error of a single force. For several walkers, the error of each is limited, not the error of their mean.
    pub fn judged_error(&self) -> Option<f64> {
        self.allowed_error().filter(|_| !self.serves_several())
    }

    /// Mean target force minus the weight that a moving axis carries, N. A cam cannot change the mean over a turn (theory §1). `None` within the
    /// rounding of a mass.
    pub fn mean_force_gap(&self) -> Option<f64> {
        let gap = self.target_mean() - self.drive.rest_force;
        let judged = self.drive.kind == DriveKind::MovingAxis && self.judged_error().is_some();
        (judged && gap.abs() > SAME_MEAN * self.target_mean()).then_some(gap)
    }

    /// Whether the ranges of the cycle have different weights.
    pub fn is_weighed(&self) -> bool {
        !self.weights.is_empty()
    }

    /// Weight of the force error at a cam angle.
    pub fn weight(&self, theta: f64) -> f64 {
        weight_at(&self.weights, theta + self.phase)
    }

    /// Cam angles inside the turn at which the weight may jump, in ascending order.
    pub fn weight_edges(&self) -> Vec<f64> {
        let ends = self.weights.iter().flat_map(|w| [w.from, w.to]);
        let mut edges: Vec<f64> = ends.map(|at| (at - self.phase).rem_euclid(TAU)).collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        edges
    }

    /// Minimum weight over the cycle.
    pub fn least_weight(&self) -> f64 {
        (self.weights.iter()).fold(1.0, |least, w| least.min(w.weight))
    }
}
