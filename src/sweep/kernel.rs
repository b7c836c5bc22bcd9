//! From a batch of parameters to a batch of answers: pure, and the same for any number of threads.
//!
//! Words decide the structure of a scene, numbers only fill it in. Each combination of words is read once
//! per batch; its rows then set their numbers directly. Rows of the spectral tier come from a force that is
//! taken apart once; all others go through the synthesis like a single scene.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, RwLock};

use toml::Table;

use super::batch::{Batch, Column};
use super::key::Key;
use super::plan::NamedScene;
use super::results::{Results, Row};
use crate::error::{Error, Placed, Result, SweepError};
use crate::force::{self, ForceCurve};
use crate::halt::Halt;
use crate::problem::{Problem, open_questions};
use crate::scene::{self, Gait, LawSpec, Scene, Source};
use crate::synth::spectral::{self, HarmonicTarget};
use crate::synth::{Search, design};

/// Gives the force curve that a scene names in a file; the first argument is the base scene's index.
pub type Targets<'a> = &'a (dyn Fn(usize, &Scene) -> Result<ForceCurve> + Sync);
/// Seconds since any moment.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);
/// Gives the end of the searches of a row that begins now.
pub type Halts<'a> = &'a (dyn Fn() -> Halt + Sync);

/// Targets kept at a time; a sweep over more recordings or speeds than this forgets the oldest batch.
const KEPT_TARGETS: usize = 1024;

/// Turns batches into results.
pub struct Kernel<'a> {
    scenes: &'a [NamedScene],
    keys: Vec<Key>,
    targets: Targets<'a>,
    halts: Halts<'a>,
    clock: Option<Clock<'a>>,
    harmonics: RwLock<HashMap<TargetName, Option<Arc<HarmonicTarget>>>>,
    wanted: Mutex<Vec<Arc<Wanted>>>,
}

/// What names a force, and the bits of its step frequency.
type TargetName = (Arc<str>, u64);

/// A combination of words, read.
#[derive(Default)]
struct Base {
    /// `None` when it has to be read row by row, because the numbers of its first row do not fit it.
    scene: Option<Scene>,
    /// What names its force: the recording with its options, or the model and feet.
    source: Arc<str>,
    /// Whether the closed form may answer.
    closed: bool,
    /// Step frequency and harmonics of the row before.
    last: Option<(u64, Option<Arc<HarmonicTarget>>)>,
    /// What the row before wanted.
    before: Option<Arc<Wanted>>,
}

/// What rows ask for, and what was found for it: rows that differ in limits and sizes alone share it.
struct Wanted {
    /// Base scene; recordings are named relative to it.
    scene: usize,
    gait: Option<Gait>,
    law: LawSpec,
    force: Option<ForceCurve>,
    /// Its cache serves every row.
    search: Search,
}

/// What is wanted that is kept at a time.
const KEPT_WANTED: usize = 256;

impl Wanted {
    fn is_of(&self, index: usize, scene: &Scene) -> bool {
        self.scene == index && self.gait == scene.gait && self.law == scene.law
    }
}

impl<'a> Kernel<'a> {
    /// A kernel for base scenes and varied keys.
    pub fn new(
        scenes: &'a [NamedScene],
        keys: Vec<Key>,
        targets: Targets<'a>,
        halts: Halts<'a>,
        clock: Option<Clock<'a>>,
    ) -> Self {
        Kernel {
            scenes,
            keys,
            targets,
            halts,
            clock,
            harmonics: RwLock::new(HashMap::new()),
            wanted: Mutex::default(),
        }
    }

    /// The varied keys, in the order of a batch's columns.
    pub fn keys(&self) -> &[Key] {
        &self.keys
    }

    /// Whether rows are timed.
    pub fn has_clock(&self) -> bool {
        self.clock.is_some()
    }

    fn now(&self) -> f64 {
        self.clock.map_or(0.0, |clock| clock())
    }

    /// Computes every row; a scene at fault is a row with its error. `None` where `stop` ended the work between two
    /// rows.
    pub fn run(&self, batch: &Batch, stop: &dyn Fn() -> bool) -> Option<Results> {
        let mut results = Results::with_capacity(batch.len());
        let mut bases: Vec<Base> = Vec::new();
        let mut known: HashMap<(u32, Vec<&str>), usize> = HashMap::new();
        let words: Vec<&Vec<Arc<str>>> = batch
            .columns
            .iter()
            .filter_map(|c| match c {
                Column::Words(w) => Some(w),
                Column::Numbers(_) => None,
            })
            .collect();
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
        let scene = self.read(batch, row).ok();
        let source: Arc<str> = match scene.as_ref().and_then(|s| s.gait.as_ref()) {
            None => Arc::from(""),
            Some(gait) => match &gait.source {
                Source::Model(name) => Arc::from(format!("{name} {}", gait.feet.name())),
                Source::File(_) => Arc::from(format!("{} {gait:?}", batch.scene[row])),
            },
        };
        Base {
            closed: scene.as_ref().is_some_and(spectral::suits),
            scene,
            source,
            last: None,
            before: None,
        }
    }

    /// The scene of a row as a user would have written it.
    fn read(&self, batch: &Batch, row: usize) -> Result<Scene> {
        scene::read(&self.table(batch, row)?)
    }

    /// The table of a row: the base scene with its values written in, in SI.
    ///
    /// # Errors
    /// A value that its key refuses.
    pub fn table(&self, batch: &Batch, row: usize) -> Result<Table> {
        let scene = batch.scene[row] as usize;
        let named = self
            .scenes
            .get(scene)
            .ok_or(SweepError::NoScene { scene })?;
        let mut table = named.table.clone();
        // Words first: they may replace what numbers belong to.
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
            let answer = if base.closed {
                closed_row(self, index, base)
            } else {
                None
            };
            if let Some(answer) = answer {
                return answer;
            }
            if let Some(scene) = &base.scene {
                return self.answer(index, scene, &mut base.before);
            }
        }
        match self.read(batch, row) {
            Ok(scene) => self.answer(index, &scene, &mut base.before),
            Err(e) => Row::error(e.to_string()),
        }
    }

    /// Sets the row's numbers; false when one of them is for the scene's reader to judge.
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

    /// The synthesis of one scene. What rows of the same force and law have found is not sought again.
    fn answer(&self, index: usize, scene: &Scene, before: &mut Option<Arc<Wanted>>) -> Row {
        let wanted = match before {
            Some(wanted) if wanted.is_of(index, scene) => wanted.clone(),
            _ => match self.wanted(index, scene) {
                Ok(wanted) => wanted,
                Err(e) => return Row::error(e.to_string()),
            },
        };
        *before = Some(wanted.clone());
        let search = wanted.search.ended_by(&(self.halts)());
        let answer = Problem::resolve(scene, wanted.force.as_ref())
            .and_then(|problem| design(&problem, &search));
        match answer {
            // What a clock cut short is no answer that another run would give.
            Ok(design) if design.out_of_time => {
                Row::error(Error::from(SweepError::OutOfTime).to_string())
            }
            Ok(design) => Row::of(&design),
            Err(e) => Row::error(e.to_string()),
        }
    }

    /// What a row asks for; of what was asked before, with what was found.
    fn wanted(&self, index: usize, scene: &Scene) -> Result<Arc<Wanted>> {
        let kept = || self.wanted.lock().ok();
        let known = |list: &Vec<Arc<Wanted>>| {
            let same = list.iter().rev().find(|w| w.is_of(index, scene));
            same.cloned()
        };
        if let Some(wanted) = kept().and_then(|list| known(&list)) {
            return Ok(wanted);
        }
        let wanted = Arc::new(Wanted {
            scene: index,
            gait: scene.gait.clone(),
            law: scene.law.clone(),
            force: self.target(index, scene)?,
            search: Search::default(),
        });
        if let Some(mut list) = kept() {
            if list.len() >= KEPT_WANTED {
                list.clear();
            }
            list.push(wanted.clone());
        }
        Ok(wanted)
    }

    fn target(&self, index: usize, scene: &Scene) -> Result<Option<ForceCurve>> {
        let Some(gait) = &scene.gait else {
            return Ok(None);
        };
        match &gait.source {
            Source::File(_) => (self.targets)(index, scene).map(Some),
            Source::Model(name) => {
                force::model(name, gait.step_frequency, gait.model_weight(), gait.feet)
                    .map(Some)
                    .map_err(|e| e.at_key("gait.model"))
            }
        }
    }

    /// The harmonics of a scene's force, taken apart once.
    fn harmonic_target(
        &self,
        index: usize,
        scene: &Scene,
        source: &Arc<str>,
        frequency: u64,
    ) -> Option<Arc<HarmonicTarget>> {
        let name = (source.clone(), frequency);
        if let Some(target) = self.harmonics.read().ok()?.get(&name) {
            return target.clone();
        }
        let (target, cheap) = match self.take_apart(index, scene) {
            Some((target, cheap)) => (Some(Arc::new(target)), cheap),
            None => (None, false),
        };
        let mut harmonics = self.harmonics.write().ok()?;
        if harmonics.len() >= KEPT_TARGETS {
            if cheap {
                return target;
            }
            harmonics.clear();
        }
        harmonics.insert(name, target.clone());
        target
    }

    /// A target, and whether it costs less than keeping it.
    fn take_apart(&self, index: usize, scene: &Scene) -> Option<(HarmonicTarget, bool)> {
        let gait = scene.gait.as_ref()?;
        let Source::Model(name) = &gait.source else {
            let curve = (self.targets)(index, scene).ok()?;
            if !open_questions(Some(gait), Some(&curve)).is_empty() {
                return None;
            }
            return Some((HarmonicTarget::of_curve(curve)?, false));
        };
        let fourier = force::fourier(name, gait.step_frequency, gait.feet).ok()?;
        let harmonics = fourier.and_then(|(period_s, terms)| {
            HarmonicTarget::of_harmonics(period_s, terms, force::SAMPLES)
        });
        if let Some(target) = harmonics {
            return Some((target, true));
        }
        let curve = force::model(name, gait.step_frequency, 1.0, gait.feet).ok()?;
        Some((HarmonicTarget::of_curve(curve)?, false))
    }
}

/// A panic is an internal error; it must not stop the other rows.
fn guarded<T>(work: impl FnOnce() -> T) -> std::result::Result<T, String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).map_err(|cause| {
        let words = cause.downcast_ref::<String>().map(String::as_str);
        let words = words.or_else(|| cause.downcast_ref::<&str>().copied());
        let words = words.and_then(|w| w.lines().next()).unwrap_or("");
        format!("a fault of gaitcam itself ({words}); please report it with the scene")
    })
}

/// The closed form of a row whose numbers are set.
fn closed_row(kernel: &Kernel, index: usize, base: &mut Base) -> Option<Row> {
    let scene = base.scene.as_ref()?;
    let gait = scene.gait.as_ref()?;
    let (frequency, scale) = match &gait.source {
        Source::File(_) => (0, 1.0),
        Source::Model(_) => (
            gait.step_frequency.unwrap_or(0.0).to_bits(),
            gait.model_weight(),
        ),
    };
    if base.last.as_ref().is_none_or(|l| l.0 != frequency) {
        let target = kernel.harmonic_target(index, scene, &base.source, frequency);
        base.last = Some((frequency, target));
    }
    let target = base.last.as_ref()?.1.as_ref()?;
    spectral::figures(scene, target, scale).map(|f| Row::spectral(&f, target))
}

#[cfg(test)]
mod tests;
