//! Splines fitted to the force alone.

use std::sync::Arc;

use splineqp::{Basis, Quadratic};

use super::kept::Kept;
use crate::drive::Drive;
use crate::error::Result;
use crate::problem::machine::Scaling;

/// What a fit to a cycle of force depends on beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitKey {
    /// How the target follows from the cycle.
    pub scaling: Scaling,
    /// The machine.
    pub drive: Drive,
    /// Degree of the splines.
    pub degree: usize,
}

/// The functions, what is minimised, and the force distance alone.
pub type Objective = (Basis, Quadratic, Quadratic);

/// What was found for one cycle of force.
#[derive(Debug, Default)]
pub struct Fits {
    objectives: Kept<Arc<(FitKey, usize, Objective)>>,
    /// With the accuracy asked for, N RMS, and the number tried first.
    spans: Kept<(FitKey, [f64; 2], usize)>,
}

impl Fits {
    /// The objective over so many spans.
    ///
    /// # Errors
    /// Those of `find`.
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

    /// The fewest spans that reach an accuracy, tried from `least` on.
    ///
    /// # Errors
    /// Those of `find`.
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
