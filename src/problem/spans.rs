//! Numbers of spans that are already found.

use std::sync::{Arc, Mutex};

use crate::drive::Drive;
use crate::halt::Halt;

/// The fewest spans that reach an accuracy without limits, for one force and one law.
///
/// Limits and sizes do not enter that search, so problems that differ in them alone share what was found:
/// clones of a problem do by themselves, rows of a sweep by [`synthesise_with`](crate::synth::synthesise_with).
/// To be shared only between problems of the same force and the same demands on the law.
#[derive(Debug, Clone, Default)]
pub struct SpanMemo(Arc<Mutex<Vec<(Key, usize)>>>);

/// Entries kept: rows of one force and law differ in drive and accuracy, in turn.
const KEPT: usize = 64;

/// What the search depends on beside force and law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Key {
    /// Force error asked for, N RMS.
    pub wanted: f64,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    /// The machine.
    pub drive: Drive,
    /// Degree of the splines.
    pub degree: usize,
}

/// What designs made one after another share, and when their searches are to end.
///
/// ```
/// use gaitcam::halt::Halt;
/// use gaitcam::problem::Shared;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise_with;
///
/// // Out of time before the search begins: the best there is, and it says so.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let shared = Shared::until(Halt::when(|| true));
/// let design = synthesise_with(&scene, scene.model_force()?.as_ref(), &shared)?;
/// assert!(design.out_of_time || design.infeasible.is_some());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Shared {
    /// Numbers of spans already found; between problems of the same force and the same demands only.
    pub(crate) spans: SpanMemo,
    /// When searches are to end.
    pub halt: Halt,
}

impl Shared {
    /// Nothing found yet, and searches end when `halt` says so.
    #[must_use]
    pub fn until(halt: Halt) -> Shared {
        Shared {
            halt,
            ..Shared::default()
        }
    }
}

impl SpanMemo {
    /// The number of spans for a key, found by `search` where it is not known.
    pub(crate) fn fewest<E>(
        &self,
        key: Key,
        search: impl FnOnce() -> Result<usize, E>,
    ) -> Result<usize, E> {
        if let Ok(list) = self.0.lock()
            && let Some((_, spans)) = list.iter().find(|(known, _)| *known == key)
        {
            return Ok(*spans);
        }
        let spans = search()?;
        if let Ok(mut list) = self.0.lock() {
            if list.len() >= KEPT {
                list.clear();
            }
            list.push((key, spans));
        }
        Ok(spans)
    }
}
