//! The conditions of a search: when to end, what is of use.

use crate::halt::Halt;

/// What a search has that is not part of the problem.
///
/// ```
/// use gaitcam::halt::Halt;
/// use gaitcam::synth::{Search, design};
/// use gaitcam::{Problem, scene};
///
/// // Time is looked at between programs: a design of one program is complete.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let design = design(&problem, &Search::until(Halt::when(|| true)))?;
/// assert!(!design.out_of_time && design.infeasible.is_none());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Search {
    /// When the search is to end.
    pub(crate) halt: Halt,
    /// Only a design that passes is of use: one that cannot reach the accuracy need not be finished.
    pub(super) only_passing: bool,
    /// The law may dip below the base circle: shows what demands ask that no cam does.
    pub(super) below_base_circle: bool,
    /// Spans with which a search for their number begins: those of a design for nearly the same problem.
    pub(super) least_spans: usize,
}

impl Search {
    /// A search that ends when `halt` says so.
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

    /// The same search, for laws that may dip below the base circle.
    pub(super) fn below_base_circle(&self) -> Search {
        Search {
            below_base_circle: true,
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
