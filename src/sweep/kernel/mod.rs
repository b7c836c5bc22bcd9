//! Computation of rows from a batch of parameters. It has no side effects and does not depend on the number of threads.
//!
//! Keys with words determine the structure of a scene. The scene of each combination of words is read once per batch, and the numbers of
//! each row are then set directly. A harmonic law that satisfies its limits is computed in closed form. All other rows are computed like a
//! single design.
//!
//! Forces are cached with the results that are computed from them. A grid with few step frequencies is therefore faster than a sample.

use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, RwLock};

use toml::Table;

use crate::cam::Verdict;
use crate::error::{Error, Result, SweepError};
use crate::halt::Halt;
use crate::problem::{ForceCycle, Problem};
use crate::scene::{self, Gait, Scene, Source};
use crate::sweep::carried::{Files, force};
use crate::sweep::plan::batch::{Batch, Column};
use crate::sweep::plan::key::Key;
use crate::sweep::plan::{NamedScene, Plan};
use crate::sweep::table::results::{Outcome, Row};
use crate::synth::{Search, closed_form, design};

/// Clock with an arbitrary zero, which returns the time in s.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);
/// Function that returns the time limit of a row that starts at the time of the call.
pub type Halts<'a> = &'a (dyn Fn() -> Halt + Sync);

/// Maximum number of cached forces. Before a further force is added, all earlier forces are removed.
const KEPT_FORCES: usize = 1024;
/// Computes the rows of batches, with a cache of forces.
pub struct Kernel<'a> {
    scenes: &'a [NamedScene],
    keys: Vec<Key>,
    files: &'a Files,
    halts: Halts<'a>,
    clock: Option<Clock<'a>>,
    /// Whether a numeric key of the section `gait` is varied. One recording then gives several forces.
    varies_gait: bool,
    cycles: RwLock<BTreeMap<CycleName, Result<Arc<ForceCycle>>>>,
}

/// Key of a cached force. It consists of the source of the force and the bits of the step frequency.
type CycleName = (Arc<str>, u64);

/// Scene for one combination of words, with its numbers.
#[derive(Default)]
struct Base {
    /// The scene with the numbers of one of its rows. `None` if the numbers of the first row are invalid. The scene must then be read for
    /// each row.
    scene: Option<Scene>,
    /// Text that identifies the source of the force; `None` if the force depends on numbers of the row.
    source: Option<Arc<str>>,
}

impl<'a> Kernel<'a> {
    /// Creates a kernel for the scenes and the varied keys of a plan. `files` contains the recordings of the scenes.
    pub fn new(
        plan: &'a Plan,
        files: &'a Files,
        halts: Halts<'a>,
        clock: Option<Clock<'a>>,
    ) -> Self {
        let keys = plan.keys();
        let reads = |key: &Key| key.is_number() && key.name().starts_with("gait.");
        Kernel {
            varies_gait: keys.iter().any(reads),
            scenes: &plan.scenes,
            keys,
            files,
            halts,
            clock,
            cycles: RwLock::default(),
        }
    }

    /// Varied keys in the order of the columns of a batch.
    pub fn keys(&self) -> &[Key] {
        &self.keys
    }

    /// Whether the computing time of each row is recorded.
    pub fn has_clock(&self) -> bool {
        self.clock.is_some()
    }

    fn now(&self) -> f64 {
        self.clock.map_or(0.0, |clock| clock())
    }

    /// Computes all rows of a batch. For an invalid scene, the row contains the error. `None` if `stop` returned true before a row.
    pub fn run(&self, batch: &Batch, stop: &dyn Fn() -> bool) -> Option<Vec<Row>> {
        let mut results = Vec::with_capacity(batch.len());
        let mut bases: Vec<Base> = Vec::new();
        let mut known: HashMap<(u32, Vec<&str>), usize> = HashMap::new();
        let words: Vec<&Vec<Arc<str>>> = batch.columns.iter().filter_map(Column::words).collect();
        let mut previous: Option<(usize, usize)> = None;
        for row in 0..batch.len() {
            if stop() {
                return None;
            }
            let start = self.now();
            let same = previous.filter(|&(other, _)| {
                batch.scene[other] == batch.scene[row]
                    && words.iter().all(|w| Arc::ptr_eq(&w[other], &w[row]))
            });
            let index = match same {
                Some((_, index)) => index,
                None => {
                    let name = (batch.scene[row], words.iter().map(|w| &*w[row]).collect());
                    *known.entry(name).or_insert_with(|| {
                        let base = guarded(|| self.base(batch, row));
                        bases.push(base.unwrap_or_default());
                        bases.len() - 1
                    })
                }
            };
            previous = Some((row, index));
            let answer = guarded(|| self.row(batch, row, &mut bases[index]));
            let mut answer = answer.unwrap_or_else(Row::error);
            answer.time_s = self.now() - start;
            results.push(answer);
        }
        Some(results)
    }

    fn base(&self, batch: &Batch, row: usize) -> Base {
        let index = batch.scene[row] as usize;
        let Ok(scene) = self.read(batch, row) else {
            return Base::default();
        };
        let is_one = scene.gait.as_ref().is_none_or(is_multiple);
        Base {
            source: (is_one || !self.varies_gait).then(|| source(index, &scene)),
            scene: Some(scene),
        }
    }

    /// Reads the scene of a row from its table.
    fn read(&self, batch: &Batch, row: usize) -> Result<Scene> {
        scene::read(&self.table(batch, row)?)
    }

    /// Table of the scene of a row: the base scene with the values of the row, in SI units.
    ///
    /// # Errors
    ///
    /// A value cannot be set.
    pub fn table(&self, batch: &Batch, row: usize) -> Result<Table> {
        let scene = batch.scene[row] as usize;
        let named = self
            .scenes
            .get(scene)
            .ok_or(SweepError::NoScene { scene })?;
        let mut table = named.table.clone();
        // Words are set first, because they may replace the entries of numbers.
        for (key, column) in self.keys.iter().zip(&batch.columns) {
            if let Column::Words(w) = column {
                key.write_words(&mut table, &w[row])?;
            }
        }
        for (key, column) in self.keys.iter().zip(&batch.columns) {
            if let Column::Numbers(x) = column {
                key.write_number(&mut table, x[row])?;
            }
        }
        Ok(table)
    }

    fn row(&self, batch: &Batch, row: usize, base: &mut Base) -> Row {
        let index = batch.scene[row] as usize;
        if let Some(scene) = &mut base.scene
            && self.set_numbers(batch, row, scene)
            && scene::check(scene).is_ok()
        {
            let named = base.source.clone();
            let source = named.unwrap_or_else(|| source(index, scene));
            return self.designed_row(index, scene, &source);
        }
        match self.read(batch, row) {
            Ok(scene) => self.designed_row(index, &scene, &source(index, &scene)),
            Err(e) => Row::error(e.to_string()),
        }
    }

    /// Sets the numbers of a row in a scene. Returns `false` if a number cannot be set directly. The scene must then be read again.
    fn set_numbers(&self, batch: &Batch, row: usize, scene: &mut Scene) -> bool {
        for (key, column) in self.keys.iter().zip(&batch.columns) {
            if let Column::Numbers(x) = column
                && !key.set(scene, x[row])
            {
                return false;
            }
        }
        true
    }

    /// Computes the row of a scene, if possible in closed form.
    fn designed_row(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Row {
        let problem = match self.problem(index, scene, source) {
            Ok(problem) => problem,
            Err(e) => return refused(&e),
        };
        if let Some(figures) = closed_form::figures(&problem) {
            return Row::spectral(&figures, problem.target.as_ref());
        }
        match design(&problem, &Search::until((self.halts)())) {
            // A search that its time limit ended early has no reproducible result, so the row contains an error.
            Ok(design) if design.out_of_time => {
                Row::error(Error::from(SweepError::OutOfTime).to_string())
            }
            Ok(design) => Row::of(&design),
            Err(e) => refused(&e),
        }
    }

    /// Resolves the problem of a scene. The force of the problem is taken from the cache.
    fn problem(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Result<Problem> {
        let Some(gait) = &scene.gait else {
            return Problem::of_multiple(scene, None);
        };
        let cycle = self.cycle(index, scene, gait, source)?;
        let times = if is_multiple(gait) {
            gait.model_weight()
        } else {
            1.0
        };
        Problem::of_multiple(scene, Some((&cycle, times)))
    }

    /// Force of a scene from the cache. A force that is proportional to the body weight is computed for a weight of 1 N.
    fn cycle(
        &self,
        index: usize,
        scene: &Scene,
        gait: &Gait,
        source: &Arc<str>,
    ) -> Result<Arc<ForceCycle>> {
        let frequency = gait.step_frequency.filter(|_| is_multiple(gait));
        let name = (source.clone(), frequency.unwrap_or(0.0).to_bits());
        if let Ok(cycles) = self.cycles.read()
            && let Some(cycle) = cycles.get(&name)
        {
            return cycle.clone();
        }
        let cycle = match gait.is_recording() {
            true => force(self.files, index, scene).map(ForceCycle::new),
            false => model_cycle(gait),
        };
        let cycle = cycle.map(Arc::new);
        if let Ok(mut cycles) = self.cycles.write() {
            if cycles.len() >= KEPT_FORCES {
                cycles.clear();
            }
            cycles.insert(name, cycle.clone());
        }
        cycle
    }
}

/// Row of a scene for which no cam was designed, because the scene is infeasible or invalid.
fn refused(why: &Error) -> Row {
    let row = Row::error(why.to_string());
    if !why.is_answer() {
        return row;
    }
    Row {
        outcome: Outcome::Infeasible,
        verdict: Some(Verdict::Unacceptable),
        ..row
    }
}

/// Force of a load model or of load factors in the scene. If the force is proportional to the body weight, it is computed for a weight of 1
/// N.
fn model_cycle(gait: &Gait) -> Result<ForceCycle> {
    if !is_multiple(gait) {
        let force = gait.model_force()?.ok_or(SweepError::NoForceError)?;
        return Ok(ForceCycle::new(force));
    }
    if let Some(series) = gait.series(gait.step_frequency, 1.0)? {
        return Ok(ForceCycle::of_series(series));
    }
    let force = gait.force_of_weight(1.0)?.ok_or(SweepError::NoForceError)?;
    Ok(ForceCycle::new(force))
}

/// Whether the force is proportional to the body weight. This is the case if it does not come from a recording and has a single step
/// frequency.
fn is_multiple(gait: &Gait) -> bool {
    !gait.is_recording() && gait.step_frequencies.is_none()
}

/// Text that identifies the source of the force. It describes the recording with its options, or the load model and the feet.
fn source(index: usize, scene: &Scene) -> Arc<str> {
    let Some(gait) = &scene.gait else {
        return Arc::from("");
    };
    Arc::from(match &gait.source {
        Source::Model(name) if is_multiple(gait) => format!("{name} {}", gait.feet.name()),
        Source::Harmonics(list) if is_multiple(gait) => format!("{list:?} {}", gait.feet.name()),
        _ => format!("{index} {gait:?}"),
    })
}

/// Result of a computation. A panic becomes an error, so that other rows can still be computed.
fn guarded<T>(work: impl FnOnce() -> T) -> std::result::Result<T, String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).map_err(|cause| {
        let words = cause.downcast_ref::<String>().map(String::as_str);
        let words = words.or_else(|| cause.downcast_ref::<&str>().copied());
        let words = words.and_then(|w| w.lines().next()).unwrap_or("");
        format!("a fault of gaitcam itself ({words}); please report it with the scene")
    })
}

#[cfg(test)]
mod tests;
