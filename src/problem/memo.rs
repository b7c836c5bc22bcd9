//! What is already found for one force and one law.

use std::sync::{Arc, Mutex};

use super::target::Target;
use crate::drive::Drive;
use crate::halt::Halt;
use crate::scene::DriveSpec;

/// The settled force and the numbers of spans found for one wanted force and the same demands on the law.
///
/// Limits and sizes enter neither, so problems that differ in them alone share what was found: clones of a problem
/// do by themselves, rows of a sweep by [`synthesise_with`](crate::synth::synthesise_with). To be shared only between
/// problems of the same force, settled alike, and the same demands on the law.
#[derive(Debug, Clone, Default)]
pub(crate) struct Memo(Arc<Known>);

#[derive(Debug, Default)]
struct Known {
    spans: Mutex<Vec<(SpanKey, usize)>>,
    targets: Mutex<Vec<(TargetKey, Settled)>>,
}

/// Entries kept of each kind: rows of one force and law differ in drive and accuracy, in turn.
const KEPT: usize = 64;

/// What the search for spans depends on beside force and law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpanKey {
    /// Force error asked for, N RMS.
    pub wanted: f64,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    /// The machine.
    pub drive: Drive,
    /// Degree of the splines.
    pub degree: usize,
}

/// What the settled force depends on beside the wanted one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TargetKey {
    /// The machine as it was written.
    pub drive: DriveSpec,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
}

/// A machine with every number, and the force in step with it.
pub(super) type Settled = (Drive, Option<Target>);

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
    /// What is already found; between problems of the same force and the same demands only.
    pub(crate) memo: Memo,
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

impl Memo {
    /// The number of spans for a key, found by `search` where it is not known.
    pub(crate) fn fewest_spans<E>(
        &self,
        key: SpanKey,
        search: impl FnOnce() -> Result<usize, E>,
    ) -> Result<usize, E> {
        found(&self.0.spans, key, search)
    }

    /// Machine and target for a key, settled by `settle` where they are not known.
    pub(super) fn settled<E>(
        &self,
        key: TargetKey,
        settle: impl FnOnce() -> Result<Settled, E>,
    ) -> Result<Settled, E> {
        found(&self.0.targets, key, settle)
    }
}

fn found<K: PartialEq, V: Clone, E>(
    list: &Mutex<Vec<(K, V)>>,
    key: K,
    search: impl FnOnce() -> Result<V, E>,
) -> Result<V, E> {
    if let Ok(list) = list.lock()
        && let Some((_, value)) = list.iter().rev().find(|(known, _)| *known == key)
    {
        return Ok(value.clone());
    }
    let value = search()?;
    if let Ok(mut list) = list.lock() {
        if list.len() >= KEPT {
            list.clear();
        }
        list.push((key, value.clone()));
    }
    Ok(value)
}
