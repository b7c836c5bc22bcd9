//! Definition of a sweep as the user gives it, for the command, the Python package and the page.

use std::sync::Arc;

use gaitcam::error::{Placed, Result, SweepError};
use gaitcam::scene::{self, Files, set_value};
use gaitcam::sweep::{
    Axis, Key, List, Method, NamedScene, Plan, Sampling, Scattered, Subject, Sweep, Values,
};
use serde::{Deserialize, Serialize};
use toml::Table;

/// Default number of cams that are sampled from the manufacturing tolerances.
const SAMPLES: u64 = 10_000;

/// Key to be varied, with its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Varied {
    /// Text in the syntax of `gaitcam sweep --vary`: `KEY=START:STOP:COUNT` or `KEY=A,B`. For a sample, the text is `KEY=START:STOP`.
    Text(String),
    /// Key, and its values as written in a scene file.
    Listed(String, Vec<String>),
    /// Key that ends with its SI unit, as in column names, and its values in SI units.
    Numbers(String, Vec<f64>),
}

impl Varied {
    fn axis(&self, is_sampled: bool) -> Result<Axis> {
        match self {
            Varied::Text(text) => Axis::parse(text, is_sampled),
            Varied::Listed(key, values) => Axis::list(key, values.iter().map(String::as_str)),
            Varied::Numbers(column, values) => Ok(Axis {
                key: Key::of_column(column),
                values: Values::Numbers(values.clone()),
            }),
        }
    }
}

/// Completes a scene that is invalid only because it lacks varied keys. Each of these keys is set to its first value. Any other scene is
/// returned unchanged.
pub fn completed(table: Table, varied: &[Varied], is_sampled: bool) -> Table {
    if scene::read(&table).is_ok() {
        return table;
    }
    let mut whole = table.clone();
    for varied in varied {
        let written = varied
            .axis(is_sampled)
            .and_then(|axis| axis.begin(&mut whole));
        if written.is_err() {
            return table;
        }
    }
    match scene::read(&whole) {
        Ok(_) => whole,
        Err(_) => table,
    }
}

/// Definition of a sweep. It varies keys of scenes over a list, a grid or a sample of values, or it samples one scene with manufacturing
/// tolerances.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweepQuestion {
    /// Base scenes of the sweep. They are not part of the serialised definition.
    #[serde(skip)]
    pub scenes: Vec<NamedScene>,
    /// Keys whose values are combined row by row: the first row contains the first value of each key, and so on.
    pub list: Vec<Varied>,
    /// File names of recordings. Each recording is combined with all values of `vary`.
    pub recordings: Vec<String>,
    /// Keys of which all combinations of values are computed.
    pub vary: Vec<Varied>,
    /// Number of sampled points; `None` if all combinations of values are computed.
    pub sample: Option<u64>,
    /// Sampling method: Latin hypercube or Sobol sequence.
    pub method: Method,
    /// Seed of the random number generator.
    pub seed: u64,
    /// Manufacturing tolerances as text, such as `profile=0.02 mm`.
    pub tolerances: Vec<String>,
}

impl SweepQuestion {
    /// Prepares the sweep and reads its recordings. `files` returns the access to the files of the base scene with the given index.
    ///
    /// # Errors
    ///
    /// The errors of [`SweepQuestion::subject`] and [`Sweep::new`].
    pub fn sweep<'a, F: Files + 'a>(&self, files: impl Fn(usize) -> &'a F) -> Result<Sweep> {
        Sweep::new(self.subject()?, files)
    }

    /// Converts the definition to the subject of a sweep: varied designs, or sampled tolerances of one design.
    ///
    /// # Errors
    ///
    /// A key or value cannot be varied, or tolerances are combined with varied keys.
    pub fn subject(&self) -> Result<Subject> {
        if !self.tolerances.is_empty() {
            return self.scattered().map(Subject::Scatter);
        }
        let mut scenes = self.scenes.clone();
        let mut axes = Vec::new();
        if let Some(first) = self.recordings.first() {
            // The first recording completes scenes without a recording. In the rows, each recording in turn replaces it.
            for scene in &mut scenes {
                set_value(&mut scene.table, "gait.file", first.as_str().into())?;
            }
            let names = self.recordings.iter().map(|name| Arc::from(name.as_str()));
            axes.push(Axis {
                key: Key::words("gait.file"),
                values: Values::Words(names.collect()),
            });
        }
        for varied in &self.vary {
            axes.push(varied.axis(self.sample.is_some())?);
        }
        let list = self.list.iter().map(|varied| varied.axis(false));
        let columns = list.collect::<Result<Vec<Axis>>>()?;
        let (method, seed) = (self.method, self.seed);
        Ok(Subject::Designs(Plan {
            scenes,
            list: (!columns.is_empty()).then_some(List { columns }),
            axes,
            sampling: self
                .sample
                .map_or(Sampling::Grid, |count| Sampling::Sample {
                    method,
                    count,
                    seed,
                }),
        }))
    }

    fn scattered(&self) -> Result<Scattered> {
        let nothing_varies =
            self.list.is_empty() && self.recordings.is_empty() && self.vary.is_empty();
        match &self.scenes[..] {
            [scene] if nothing_varies => Ok(Scattered {
                scene: scene.clone(),
                tolerances: self.tolerances.clone(),
                count: self.sample.unwrap_or(SAMPLES),
                seed: self.seed,
            }),
            _ => Err(SweepError::ScatterAlone.at_key("tolerance")),
        }
    }
}
