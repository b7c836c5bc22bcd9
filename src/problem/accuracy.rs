//! Accuracy of the force: what is required, and the weight of each part of the cycle.

use std::f64::consts::TAU;

use super::Problem;
use super::target::weight_at;
use crate::cam::FollowerKind;
use crate::drive::DriveKind;
use crate::scene::Minimise;

/// RMS force error, part of the mean force, that is small enough where the scene asks for none.
const USUAL_ACCURACY: f64 = 0.005;
/// A mean force that differs from the weight by a smaller part is the same: masses are written with four
/// digits.
const SAME_MEAN: f64 = 1e-3;

impl Problem {
    /// Force error, N RMS, at which an automatic size of the law is large enough; 0 where no force is
    /// wanted.
    pub fn wanted_error(&self) -> f64 {
        self.error_at_noise().unwrap_or(self.asked_error())
    }

    /// The same, whatever the recording's spread.
    pub fn asked_error(&self) -> f64 {
        self.accuracy.unwrap_or(USUAL_ACCURACY) * self.target_mean()
    }

    /// Force error, N RMS, above which a design misses its force: the accuracy asked for, otherwise 0.5 % of
    /// the mean or the step-to-step spread of the recording, whichever is larger; `None` where no force is
    /// wanted or the scene has it not judged.
    pub fn largest_error(&self) -> Option<f64> {
        let force = self.force.filter(|_| !self.limits.unjudged.accuracy)?;
        let asked = self.asked_error();
        Some(self.accuracy.map_or(asked.max(force.spread_n), |_| asked))
    }

    /// Smallest contact force that is judged where the scene gives none, N: 0 where only force closes the
    /// contact, on a moving axis or by whatever presses on a fixed one.
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

    /// Where the spread of the recording, not an accuracy, decides the size of the law: that error, N.
    pub fn error_at_noise(&self) -> Option<f64> {
        let noise = self.noise();
        (self.accuracy.is_none() && noise > self.asked_error()).then_some(noise)
    }

    /// |mean| of the target force, N; 0 without one.
    pub fn target_mean(&self) -> f64 {
        self.force.map_or(0.0, |force| force.mean_n.abs())
    }

    /// Error below which a fit would follow the noise: a fifth of the step-to-step spread, N.
    ///
    /// Such an error adds 2 % to the walker's own variation (1 + 0.2² under the root).
    fn noise(&self) -> f64 {
        0.2 * self.force.map_or(0.0, |force| force.spread_n)
    }

    /// [`Problem::largest_error`], unless a band stands for the accuracy.
    pub fn allowed_error(&self) -> Option<f64> {
        self.largest_error().filter(|_| self.band.is_none())
    }

    /// The same where it limits the law: something else than the force error over the turn is minimised, and a cam may
    /// reach it.
    pub fn limited_error(&self) -> Option<f64> {
        let is_minimised = self.objective() == Minimise::ForceError && !self.is_weighed();
        let asked = self.allowed_error().filter(|most| *most > 0.0)?;
        (!is_minimised && self.mean_force_gap().is_none()).then_some(asked)
    }

    /// Whether one cam serves several walkers, or one in several cycles.
    pub fn serves_several(&self) -> bool {
        self.walkers.as_ref().is_some_and(|w| w.each.len() > 1)
    }

    /// The force error above which the design of one force misses it: of several walkers not the error of their mean is judged
    /// but theirs.
    pub fn judged_error(&self) -> Option<f64> {
        self.allowed_error().filter(|_| !self.serves_several())
    }

    /// Mean target force less the weight that a moving axis carries, N: no cam changes the mean over a turn
    /// (theory §1). `None` within the rounding of a mass.
    pub fn mean_force_gap(&self) -> Option<f64> {
        let gap = self.target_mean() - self.drive.rest_force;
        let judged = self.drive.kind == DriveKind::MovingAxis && self.judged_error().is_some();
        (judged && gap.abs() > SAME_MEAN * self.target_mean()).then_some(gap)
    }

    /// Whether parts of the cycle count more or less than once.
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

    /// The lowest weight of any part of the cycle.
    pub fn least_weight(&self) -> f64 {
        (self.weights.iter()).fold(1.0, |least, w| least.min(w.weight))
    }
}
