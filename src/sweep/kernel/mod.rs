//! From a batch of parameters to a batch of rows: without side effects, and the same for any number of threads.
//!
//! Words decide the structure of a scene, numbers only fill it in. Each combination of words is read once per batch; its
//! rows then set their numbers directly. A harmonic law that keeps its limits follows from the harmonics of the force;
//! every other row is designed like a single scene.
//!
//! Forces are kept with their harmonics: a grid of a few step frequencies runs twelve times as fast as a sample in which
//! every row has its own.

use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, OnceLock, RwLock};

use toml::Table;

use crate::cam::Verdict;
use crate::error::{Error, Result, SweepError};
use crate::force::ForceCurve;
use crate::halt::Halt;
use crate::problem::{MeanForce, Requirements, open_questions};
use crate::scene::{self, Gait, Scene, Source};
use crate::sweep::plan::NamedScene;
use crate::sweep::plan::batch::{Batch, Column};
use crate::sweep::plan::key::Key;
use crate::sweep::table::results::{Outcome, Row};
use crate::synth::spectral::{self, Series};
use crate::synth::{self, Search, answer};

/// Gives the force curve that a scene names in a file; the first argument is the base scene's index.
pub type Targets<'a> = &'a (dyn Fn(usize, &Scene) -> Result<ForceCurve> + Sync);
/// Seconds since any moment.
pub type Clock<'a> = &'a (dyn Fn() -> f64 + Sync);
/// Gives the end of the searches of a row that begins now.
pub type Halts<'a> = &'a (dyn Fn() -> Halt + Sync);

/// Forces kept at a time; a sweep over more recordings or step frequencies forgets all of them.
const KEPT_FORCES: usize = 1024;
/// Turns batches into results.
pub struct Kernel<'a> {
    scenes: &'a [NamedScene],
    keys: Vec<Key>,
    targets: Targets<'a>,
    halts: Halts<'a>,
    clock: Option<Clock<'a>>,
    /// Whether numbers of recordings vary, by which a file gives several forces.
    varies_reading: bool,
    forces: RwLock<BTreeMap<ForceName, Arc<Force>>>,
}

/// The source of a force, and the bits of its step frequency.
type ForceName = (Arc<str>, u64);

/// A force by its source: of a load model for one step frequency and any body weight.
#[derive(Default)]
struct Force {
    /// Of a recording; `None` of a load model.
    curve: Option<Result<ForceCurve>>,
    /// `None` where the force has no Fourier series that a closed form takes.
    series: OnceLock<Option<Series>>,
}

/// A combination of words, read.
#[derive(Default)]
struct Base {
    /// `None` when it has to be read row by row, because the numbers of its first row do not fit it.
    scene: Option<Scene>,
    /// The source of its force; `None` where the numbers of a row decide.
    source: Option<Arc<str>>,
    /// Whether the closed form may apply.
    is_closed: bool,
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
        let reads = |key: &Key| key.is_number() && key.name().starts_with("gait.");
        Kernel {
            varies_reading: keys.iter().any(reads),
            scenes,
            keys,
            targets,
            halts,
            clock,
            forces: RwLock::default(),
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
        let gait = scene.gait.as_ref();
        let is_file = gait.is_some_and(Gait::is_recording);
        Base {
            source: (!is_file || !self.varies_reading).then(|| source(index, &scene)),
            is_closed: spectral::suits(&scene),
            scene: Some(scene),
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
            let named = base.source.clone();
            let source = named.unwrap_or_else(|| source(index, scene));
            let closed = || self.closed_row(index, scene, &source);
            let closed = if base.is_closed { closed() } else { None };
            return closed.unwrap_or_else(|| self.designed_row(index, scene, &source));
        }
        match self.read(batch, row) {
            Ok(scene) => self.designed_row(index, &scene, &source(index, &scene)),
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

    /// The row of a harmonic law that keeps its limits, from the harmonics of the force.
    fn closed_row(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Option<Row> {
        let gait = scene.gait.as_ref()?;
        let is_many = gait.step_frequencies.is_some();
        if is_many || scene.machine.motor.is_given() || scene.machine.has_floor() {
            return None;
        }
        let scale = match &gait.source {
            Source::File(_) => 1.0,
            Source::Model(_) | Source::Harmonics(_) => gait.model_weight(),
        };
        let force = self.force(index, scene, source)?;
        let series = force.series.get_or_init(|| series(gait, &force));
        let series = series.as_ref()?;
        let mean_n = scale * series.mean_force.mean_n;
        let mean_force = MeanForce {
            mean_n,
            ..series.mean_force
        };
        let required = Requirements::of(scene, Some(mean_force)).ok()?;
        let recording = force.curve.as_ref().and_then(|curve| curve.as_ref().ok());
        spectral::figures(&required, series).map(|f| Row::spectral(&f, recording))
    }

    /// The row of a scene that is designed like any other.
    fn designed_row(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Row {
        let search = Search::until((self.halts)());
        let answer = self
            .curve(index, scene, source)
            .and_then(|force| answer(scene, force.as_ref(), &search));
        match answer {
            // A result that a clock cut short differs from run to run.
            Ok(synth::Outcome::Built(design)) if design.out_of_time => {
                Row::error(Error::from(SweepError::OutOfTime).to_string())
            }
            Ok(synth::Outcome::Built(design)) => Row::of(&design),
            Ok(synth::Outcome::NoCam(why)) => Row {
                outcome: Outcome::Infeasible,
                verdict: Some(Verdict::Unacceptable),
                ..Row::error(why.to_string())
            },
            Err(e) => Row::error(e.to_string()),
        }
    }

    fn curve(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Result<Option<ForceCurve>> {
        let Some(gait) = &scene.gait else {
            return Ok(None);
        };
        if gait.is_recording() {
            let force = self.force(index, scene, source);
            return force.and_then(|f| f.curve.clone()).transpose();
        }
        gait.model_force()
    }

    /// The force of a scene, cached; `None` of a scene without one.
    fn force(&self, index: usize, scene: &Scene, source: &Arc<str>) -> Option<Arc<Force>> {
        let gait = scene.gait.as_ref()?;
        let is_file = gait.is_recording();
        let frequency = gait.step_frequency.filter(|_| !is_file).unwrap_or(0.0);
        let name = (source.clone(), frequency.to_bits());
        if let Some(force) = self.forces.read().ok()?.get(&name) {
            return Some(force.clone());
        }
        let force = Arc::new(Force {
            curve: is_file.then(|| (self.targets)(index, scene)),
            series: OnceLock::new(),
        });
        let mut forces = self.forces.write().ok()?;
        if forces.len() >= KEPT_FORCES {
            forces.clear();
        }
        forces.insert(name, force.clone());
        Some(force)
    }
}

/// The source of a scene's force: the recording with its options, or the model and feet.
fn source(index: usize, scene: &Scene) -> Arc<str> {
    let Some(gait) = &scene.gait else {
        return Arc::from("");
    };
    Arc::from(match &gait.source {
        Source::Model(name) => format!("{name} {}", gait.feet.name()),
        Source::Harmonics(list) => format!("{list:?} {}", gait.feet.name()),
        Source::File(_) => format!("{index} {gait:?}"),
    })
}

/// The Fourier series of a force, of a load model for a body weight of 1 N.
fn series(gait: &Gait, force: &Force) -> Option<Series> {
    if gait.is_recording() {
        let curve = force.curve.as_ref()?.as_ref().ok()?;
        let is_certain = open_questions(Some(gait), Some(curve)).is_empty();
        let is_one = curve.population.is_none();
        return (is_certain && is_one).then(|| Series::of_curve(curve.clone()));
    }
    if let Some((period_s, waves)) = gait.series().ok()? {
        let (mean_n, spread_n) = (1.0, 0.0);
        let mean_force = MeanForce {
            mean_n,
            period_s,
            spread_n,
        };
        return Some(Series::new(mean_force, waves, None));
    }
    gait.force_of_weight(1.0).ok()?.map(Series::of_curve)
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

#[cfg(test)]
mod tests;
