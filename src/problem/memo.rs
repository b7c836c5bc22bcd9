//! What is already found for one force and one law.

use std::any::Any;
use std::sync::{Arc, Mutex};

use super::target::Target;
use crate::drive::Drive;
use crate::halt::Halt;
use crate::scene::DriveSpec;

/// What was found for one wanted force and the same demands on the law: the settled force, numbers of spans, objectives,
/// the figures of laws.
///
/// Limits enter none of it but proofs, which hold their own limits beside them; so problems that differ in limits alone
/// share what was found: clones of a problem do by themselves, rows of a sweep by
/// [`synthesise_with`](crate::synth::synthesise_with). To be shared only between problems of the same force, settled
/// alike, and the same demands on the law.
#[derive(Debug, Clone, Default)]
pub(crate) struct Memo(Arc<Mutex<Vec<Box<dyn Any + Send>>>>);

/// Findings of one kind, each beside all that it depends on.
type Findings<K, V> = Vec<(K, V)>;

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
    /// What belongs to a key, sought where it is not known. The key holds all that it depends on beside force and demands;
    /// each kind of finding has a key of its own type.
    ///
    /// # Errors
    /// Those of the search.
    pub(crate) fn found<K, V, E>(
        &self,
        key: K,
        search: impl FnOnce() -> Result<V, E>,
    ) -> Result<V, E>
    where
        K: PartialEq + Send + 'static,
        V: Clone + Send + 'static,
    {
        let known = |list: &mut Findings<K, V>| {
            let same = list.iter().rev().find(|(known, _)| *known == key);
            same.map(|(_, value)| value.clone())
        };
        if let Some(value) = self.on_findings(known).flatten() {
            return Ok(value);
        }
        let value = search()?;
        self.keep(key, value.clone());
        Ok(value)
    }

    /// Whether a finding of the key's kind says so.
    pub(crate) fn any<K, V>(&self, says: impl Fn(&K, &V) -> bool) -> bool
    where
        K: Send + 'static,
        V: Send + 'static,
    {
        let look = |list: &mut Findings<K, V>| list.iter().any(|(key, value)| says(key, value));
        self.on_findings(look).unwrap_or(false)
    }

    /// Keeps a finding.
    pub(crate) fn keep<K, V>(&self, key: K, value: V)
    where
        K: Send + 'static,
        V: Send + 'static,
    {
        self.on_findings(|list| {
            if list.len() >= KEPT {
                list.clear();
            }
            list.push((key, value));
        });
    }

    /// Looks at the findings of one kind; `None` after a panic of another thread.
    fn on_findings<K, V, R>(&self, look: impl FnOnce(&mut Findings<K, V>) -> R) -> Option<R>
    where
        K: Send + 'static,
        V: Send + 'static,
    {
        let mut kinds = self.0.lock().ok()?;
        let at = kinds.iter().position(|kind| kind.is::<Findings<K, V>>());
        let at = at.unwrap_or_else(|| {
            kinds.push(Box::new(Findings::<K, V>::new()));
            kinds.len() - 1
        });
        kinds[at].downcast_mut().map(look)
    }
}
