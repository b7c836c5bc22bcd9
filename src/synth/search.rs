//! Options of a search: the stop condition, and the kinds of designs that are useful.

use crate::halt::Halt;

/// Options of a search that are not part of the problem.
///
/// ```
/// use gaitcam::halt::Halt;
/// use gaitcam::synth::{Search, design};
/// use gaitcam::{Problem, scene};
///
/// // The stop condition is polled between programs, so a design that needs only one program is complete.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let design = design(&problem, &Search::until(Halt::when(|| true)))?;
/// assert!(!design.out_of_time && design.infeasible.is_none());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Search {
    /// Stop condition, which is polled during the search.
    pub(crate) halt: Halt,
    /// Whether only a passing design is useful. A design that is proved not to reach the accuracy is then not completed.
    pub(super) only_passing: bool,
    /// Whether the law may be below the base circle. This option is used to diagnose conditions that no cam satisfies.
    pub(super) below_base_circle: bool,
    /// Minimum number of spans in the search for an automatic number, from the design of a similar problem.
    pub(super) least_spans: usize,
}

impl Search {
    /// A search with a stop condition.
    #[must_use]
    pub fn until(halt: Halt) -> Search {
        Search {
            halt,
            ..Search::default()
        }
    }

    /// The same search with another stop condition.
    #[must_use]
    pub fn ended_by(&self, halt: &Halt) -> Search {
        Search {
            halt: halt.clone(),
            ..self.clone()
        }
    }

    /// The same search, with laws that may be below the base circle.
    pub(super) fn below_base_circle(&self) -> Search {
        Search {
            below_base_circle: true,
            ..self.clone()
        }
    }

    /// The same search, for which only passing designs are useful.
    pub(super) fn for_passing_designs(&self) -> Search {
        Search {
            only_passing: true,
            ..self.clone()
        }
    }
}
