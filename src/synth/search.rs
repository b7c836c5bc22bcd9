//! The conditions of a search: what earlier designs have computed, when to end, what is of use.

use std::convert::Infallible;
use std::sync::{Arc, Mutex};

use super::ForceReport;
use super::qp::{Basis, Quadratic};
use crate::drive::Drive;
use crate::halt::Halt;
use crate::law::Law;
use crate::scene::Minimise;

/// What a search has that is not part of the problem: its cache and its end.
///
/// Clones share their cache: to be used for problems of the same force and the same demands on the law.
///
/// ```
/// use gaitcam::halt::Halt;
/// use gaitcam::synth::{Search, design};
/// use gaitcam::{Problem, scene};
///
/// // Out of time before the search begins: the best there is, and it says so.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let design = design(&problem, &Search::until(Halt::when(|| true)))?;
/// assert!(design.out_of_time || design.infeasible.is_some());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Search {
    pub(super) cache: Arc<Cache>,
    /// When the search is to end.
    pub(super) halt: Halt,
    /// Only a design that passes is of use: one that cannot reach the accuracy need not be finished.
    pub(super) only_passing: bool,
}

/// Results that do not depend on limits. In brackets: instructions that a sweep of ten strokes needs more without it.
#[derive(Debug, Default)]
pub(super) struct Cache {
    /// Objectives of convex programs (8 %).
    pub objectives: Kept<ObjectiveKey, Objective>,
    /// Distance of the force of a law from the target (7 %; where no limit is active most of a row).
    pub reports: Kept<ReportKey, ForceReport>,
    /// Fewest spans that reach an accuracy without limits (3 %).
    pub spans: Kept<SpanKey, usize>,
    /// Laws raised to the base circle (3 %; where no limit is active a third of a row).
    pub raised: Kept<Law, Law>,
}

/// What an objective depends on beside force and demands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ObjectiveKey {
    pub spans: usize,
    pub degree: usize,
    pub minimise: Minimise,
    pub phase: f64,
    pub drive: Drive,
}

/// What is minimised, over its functions.
#[derive(Debug, Clone)]
pub(super) struct Objective {
    pub basis: Basis,
    pub whole: Quadratic,
    /// The force distance alone.
    pub force: Quadratic,
}

/// What the number of spans without limits depends on beside force and demands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SpanKey {
    /// Force error asked for, N RMS.
    pub wanted: f64,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    pub drive: Drive,
    pub degree: usize,
}

/// What the distance of a force from the target depends on beside the target.
#[derive(Debug, PartialEq)]
pub(super) struct ReportKey {
    pub law: Law,
    pub drive: Drive,
    pub phase: f64,
}

/// Values by what they depend on beside force and demands; the oldest go together once there are many.
#[derive(Debug)]
pub(super) struct Kept<K, V>(Mutex<Vec<(K, V)>>);

/// Values kept of one kind.
const MOST: usize = 64;

impl Search {
    /// A search with nothing computed yet, which ends when `halt` says so.
    #[must_use]
    pub fn until(halt: Halt) -> Search {
        Search {
            halt,
            ..Search::default()
        }
    }

    /// The same search with another end.
    #[must_use]
    pub fn ended_by(&self, halt: &Halt) -> Search {
        Search {
            halt: halt.clone(),
            ..self.clone()
        }
    }

    /// The same search, which takes the time that it needs and returns designs that fail too.
    pub(super) fn without_end(&self) -> Search {
        Search {
            halt: Halt::never(),
            only_passing: false,
            ..self.clone()
        }
    }

    /// The same search, for designs that pass and no others.
    pub(super) fn for_passing_designs(&self) -> Search {
        Search {
            only_passing: true,
            ..self.clone()
        }
    }
}

impl<K, V> Default for Kept<K, V> {
    fn default() -> Self {
        Kept(Mutex::default())
    }
}

impl<K: PartialEq, V: Clone> Kept<K, V> {
    /// The value of a key, computed if it is not kept.
    pub fn get(&self, key: K, compute: impl FnOnce(&K) -> V) -> V {
        let value = self.try_get(key, |key| Ok::<_, Infallible>(compute(key)));
        value.unwrap_or_else(|never| match never {})
    }

    /// The same where it may fail.
    pub fn try_get<E>(&self, key: K, compute: impl FnOnce(&K) -> Result<V, E>) -> Result<V, E> {
        if let Ok(list) = self.0.lock()
            && let Some((_, value)) = list.iter().rev().find(|(known, _)| *known == key)
        {
            return Ok(value.clone());
        }
        let value = compute(&key)?;
        if let Ok(mut list) = self.0.lock() {
            if list.len() >= MOST {
                list.clear();
            }
            list.push((key, value.clone()));
        }
        Ok(value)
    }
}
