//! Cache of splines that are fitted to the force alone.

use std::sync::Arc;

use splineqp::{Basis, Quadratic};

use super::kept::Kept;
use crate::drive::Drive;
use crate::error::Result;
use crate::problem::machine::Scaling;

/// Key of a fit to a cycle of force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitKey {
    /// Scaling of the cycle to the target.
    pub scaling: Scaling,
    /// Drive of the machine.
    pub drive: Drive,
    /// Degree of the splines.
    pub degree: usize,
}

/// Basis functions of the law, objective of the program, and the part of the objective that measures the force error.
pub type Objective = (Basis, Quadratic, Quadratic);

/// Cached fits to one cycle of force.
#[derive(Debug, Default)]
pub struct Fits {
    objectives: Kept<Arc<(FitKey, usize, Objective)>>,
    /// Minimum numbers of spans. The key contains the required RMS force error, N, and the smallest number tried.
    spans: Kept<(FitKey, [f64; 2], usize)>,
}

impl Fits {
    /// Objective for a number of spans: the cached one, or the result of `find`.
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

    /// Minimum number of spans for an accuracy, N RMS, starting at `least`: the cached one, or the result of `find`.
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
