//! Cache of splines that are fitted to the force without limits. Rows of a sweep with different limits share these fits.

use super::Problem;
use super::force_cycle::{FitKey, Fits, Objective};
use crate::error::Result;
use crate::scene::Minimise;

/// Number of spans above which objectives are not cached. They need much memory, and their computation is fast.
const MOST_SPANS: usize = 100;

impl Problem {
    /// Cache that belongs to the force of the problem, and the key of this problem in the cache. `None` unless the unweighted force error
    /// is minimised without conditions and segments.
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

    /// Objective for a number of spans, computed by `find` or taken from the cache. Problems that differ only in their limits share it.
    ///
    /// # Errors
    ///
    /// The errors of `find`.
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

    /// Minimum number of spans, at least `least`, for which a spline without limits has an RMS force error of at most `accuracy`, N. It is
    /// computed by `find` or taken from the cache. Problems that differ only in their limits share it.
    ///
    /// # Errors
    ///
    /// The errors of `find`.
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
