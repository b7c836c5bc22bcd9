//! Accuracy of the force: required value, and weights of the parts of the cycle.

use std::f64::consts::TAU;

use super::Problem;
use super::target::weight_at;
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::scene::{LimitKind, Minimise};

/// Default RMS force error, relative to the mean force, that is small enough.
const USUAL_ACCURACY: f64 = 0.005;
/// Relative difference of mean force and weight that counts as none, since masses have four digits.
const SAME_MEAN: f64 = 1e-3;

impl Problem {
    /// Force error, N RMS, at which an automatic size of the law is large enough; 0 without a target force.
    pub fn wanted_error(&self) -> f64 {
        self.error_at_noise().unwrap_or(self.asked_error())
    }

    /// The sufficient force error without regard to the recording's spread.
    pub fn asked_error(&self) -> f64 {
        self.accuracy.unwrap_or(USUAL_ACCURACY) * self.target_mean()
    }

    /// Force error, N RMS, above which a design fails: the required accuracy, otherwise 0.5 % of the mean beside the sensor noise or the
    /// step-to-step spread of the recording, whichever is larger. `None` without a target force, or if the scene does not judge it.
    pub fn largest_error(&self) -> Option<f64> {
        let force = self.force.filter(|_| !self.limits.unjudged.accuracy)?;
        let asked = self.asked_error();
        let automatic = || asked.hypot(self.sensor_noise()).max(force.spread_n);
        Some(self.accuracy.map_or_else(automatic, |_| asked))
    }

    /// Default minimum contact force that is judged, N: 0 if only force closes the contact, as on a moving axis.
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

    /// The error, N, if spread or noise of the recording determines the size of the law, not an accuracy.
    pub fn error_at_noise(&self) -> Option<f64> {
        let asked = self.asked_error();
        let error = asked.max(self.noise()).hypot(self.sensor_noise());
        (self.accuracy.is_none() && error > asked).then_some(error)
    }

    /// Sensor noise, N RMS, in the samples of a single cycle: no law that is smooth comes closer to them. The spread of several cycles
    /// includes it.
    pub fn sensor_noise(&self) -> f64 {
        let single = self.force.filter(|force| force.spread_n == 0.0);
        single.map_or(0.0, |force| force.noise_n)
    }

    /// Absolute mean of the target force, N; 0 without one.
    pub fn target_mean(&self) -> f64 {
        self.force.map_or(0.0, |force| force.mean_n.abs())
    }

    /// Error below which a fit would follow the noise: a fifth of the step-to-step spread, N. It adds 2 % to the walker's own variation.
    fn noise(&self) -> f64 {
        0.2 * self.force.map_or(0.0, |force| force.spread_n)
    }

    /// Whether a positive contact force is asked of a drive whose mean over a turn is zero: without a spring and a force at rest.
    pub(crate) fn presses_too_little(&self) -> bool {
        let asked = self.limits[LimitKind::ForceMin].is_some_and(|least| least > 0.0);
        asked && self.drive.spring_rate <= 0.0 && self.drive.rest_force <= 0.0
    }

    /// [`Problem::largest_error`], unless a band replaces the accuracy.
    pub fn allowed_error(&self) -> Option<f64> {
        self.largest_error().filter(|_| self.band.is_none())
    }

    /// The largest error if it limits the law: the objective is not the force error over the turn, and a cam may reach it.
    pub fn limited_error(&self) -> Option<f64> {
        let is_minimised = self.objective() == Minimise::ForceError && !self.is_weighed();
        let asked = self.allowed_error().filter(|most| *most > 0.0)?;
        (!is_minimised && self.mean_force_gap().is_none()).then_some(asked)
    }

    /// Whether one cam serves several walkers or cycles.
    pub fn serves_several(&self) -> bool {
        self.walkers.as_ref().is_some_and(|w| w.each.len() > 1)
    }

    /// The largest force error of a single force; for several walkers their errors are judged, not that of their mean.
    pub fn judged_error(&self) -> Option<f64> {
        self.allowed_error().filter(|_| !self.serves_several())
    }

    /// Mean target force less the weight that a moving axis carries, N: a cam cannot change the mean over a turn (theory §1). `None` within the
    /// rounding of a mass.
    pub fn mean_force_gap(&self) -> Option<f64> {
        let gap = self.target_mean() - self.drive.rest_force;
        let judged = self.drive.kind == DriveKind::MovingAxis && self.judged_error().is_some();
        (judged && gap.abs() > SAME_MEAN * self.target_mean()).then_some(gap)
    }

    /// Whether parts of the cycle have different weights.
    pub fn is_weighed(&self) -> bool {
        !self.weights.is_empty()
    }

    /// Weight of the force error at a cam angle.
    pub fn weight(&self, theta: f64) -> f64 {
        weight_at(&self.weights, theta + self.phase)
    }

    /// Cam angles inside the turn at which the weight may jump, in order.
    pub fn weight_edges(&self) -> Vec<f64> {
        let ends = self.weights.iter().flat_map(|w| [w.from, w.to]);
        let mut edges: Vec<f64> = ends.map(|at| (at - self.phase).rem_euclid(TAU)).collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        edges
    }

    /// The minimum weight of any part of the cycle.
    pub fn least_weight(&self) -> f64 {
        (self.weights.iter()).fold(1.0, |least, w| least.min(w.weight))
    }
}
