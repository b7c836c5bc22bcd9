//! Fits of splines to the force alone, which rows of a sweep that differ in their limits share.

use super::Problem;
use super::force_cycle::{FitKey, Fits, Objective};
use crate::error::Result;
use crate::scene::Minimise;

/// Objectives over more spans are not kept: they take much memory, and more time to solve than to make.
const MOST_SPANS: usize = 100;

impl Problem {
    /// What was found for its force, where the distance from that is all that is minimised.
    fn fits(&self) -> Option<(FitKey, &Fits)> {
        let is_alone = self.objective() == Minimise::ForceError
            && !self.is_weighed()
            && !self.has_demands()
            && self.law.segments.is_empty();
        let target = self.target.as_ref().filter(|_| is_alone)?;
        let (scaling, cycle) = target.scaled_cycle();
        let key = FitKey {
            scaling,
            drive: self.drive,
            degree: self.spline_degree,
        };
        Some((key, &cycle.fits))
    }

    /// The objective over so many spans, found once for problems that differ in their limits.
    ///
    /// # Errors
    /// Those of `find`.
    pub(crate) fn objective_over(
        &self,
        spans: usize,
        find: impl FnOnce() -> Result<Objective>,
    ) -> Result<Objective> {
        match self.fits().filter(|_| spans <= MOST_SPANS) {
            Some((key, fits)) => fits.objective(key, spans, find),
            None => find(),
        }
    }

    /// The fewest spans from `least` on that reach an accuracy, N RMS, without limits, found once for problems
    /// that differ in their limits.
    ///
    /// # Errors
    /// Those of `find`.
    pub(crate) fn spans_without_limits(
        &self,
        accuracy: f64,
        least: usize,
        find: impl FnOnce() -> Result<usize>,
    ) -> Result<usize> {
        match self.fits() {
            Some((key, fits)) => fits.spans(key, accuracy, least, find),
            None => find(),
        }
    }
}
