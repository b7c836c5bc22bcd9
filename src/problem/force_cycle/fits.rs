//! Cache of splines that are fitted to the force alone.

use std::sync::Arc;

use splineqp::{Basis, Quadratic};

use super::kept::Cache;
use crate::drive::Drive;
use crate::error::Result;
use crate::problem::machine::Scaling;

/// Key of a cached fit to a cycle of force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitKey {
    /// Scaling of the cycle to the target.
    pub scaling: Scaling,
    /// Drive of the machine.
    pub drive: Drive,
    /// Degree of the splines.
    pub degree: usize,
}

/// Fit to the force with a number of spans: basis functions of the law, objective of the program, and the term of the objective for the
/// force error.
pub type Objective = (Basis, Quadratic, Quadratic);

/// Cached fits to one cycle of force.
#[derive(Debug, Default)]
pub struct Fits {
    objectives: Cache<Arc<(FitKey, usize, Objective)>>,
    /// Minimum numbers of spans. The second element contains the required RMS force error, N, and the lower bound of the search.
    spans: Cache<(FitKey, [f64; 2], usize)>,
}

impl Fits {
    /// Objective for a number of spans. It is taken from the cache or computed by `find`.
    ///
    /// # Errors
    ///
    /// The errors of `find`.
    pub fn objective(
        &self,
        key: FitKey,
        spans: usize,
        find: impl FnOnce() -> Result<Objective>,
    ) -> Result<Objective> {
        let is_same = |own: &Arc<(FitKey, usize, Objective)>| (own.0, own.1) == (key, spans);
        let found = || Ok(Arc::new((key, spans, find()?)));
        let found = self.objectives.get(is_same, found);
        found.map(|found| found.2.clone())
    }

    /// Minimum number of spans, at least `least`, for an RMS force error of at most `accuracy`, N. It is taken from the cache or computed
    /// by `find`.
    ///
    /// # Errors
    ///
    /// The errors of `find`.
    pub fn spans(
        &self,
        key: FitKey,
        accuracy: f64,
        least: usize,
        find: impl FnOnce() -> Result<usize>,
    ) -> Result<usize> {
        let asked = [accuracy, least as f64];
        let is_same = |own: &(FitKey, [f64; 2], usize)| (own.0, own.1) == (key, asked);
        let found = self.spans.get(is_same, || Ok((key, asked, find()?)));
        found.map(|found| found.2)
    }
}
