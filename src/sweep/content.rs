//! A sweep together with the content of its recordings. Any computer can compute any row of the sweep without further files.
//!
//! Row i depends only on the sweep and on i. Recordings are therefore stored by content and not by path.

use std::collections::HashMap;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value, json};

use super::carried::Files;
use super::kernel::{Clock, Halts};
use super::made::scatter::Scattered;
use super::plan::axis::Values as AxisValues;
use super::plan::key::Key;
use super::plan::{Plan, Sampling, row_count};
use super::runner::Runner;
use super::table::records::Records;
use crate::error::Result;
use crate::halt::Halt;
use crate::scene::{self, Gait, Scene, Source};
use crate::synth::Design;

/// Subject of a sweep, which determines the content of its rows.
///
/// ```
/// use gaitcam::sweep::{Plan, Sampling, Subject, Sweep};
///
/// let plan = Plan::of(toml::Table::new(), &["limits.stroke=40 mm:60 mm:5"], Sampling::Grid)?;
/// let sweep = Sweep::with_files(Subject::Designs(plan), Default::default())?;
/// assert_eq!(sweep.rows()?, 5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Subject {
    /// Designs of many scenes.
    Designs(Plan),
    /// One design, manufactured many times with errors within tolerances.
    Scatter(Scattered),
}

/// A sweep together with the content of its recordings.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::sweep::Sweep;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let sweep = Sweep::over(&scene, &["limits.stroke=45 mm:60 mm:4"])?;
/// let table = sweep.table()?;
/// assert!((table.numbers("limits.stroke_m").unwrap()[1] - 0.05).abs() < 1e-15);
/// assert_eq!(table.words("verdict").unwrap().at(3), Some("acceptable"));
/// // A load model needs no file. The fingerprint identifies the sweep.
/// assert_eq!((sweep.rows()?, sweep.files().len()), (4, 0));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Subject of the sweep, which determines the content of its rows.
    pub subject: Subject,
    files: Files,
}

impl Sweep {
    /// Creates a sweep over all combinations of the values of keys. The force of the scene must not come from a recording. Each element of
    /// `vary` is `KEY=START:STOP:COUNT` or `KEY=A,B`. The last key varies fastest.
    ///
    /// # Errors
    ///
    /// A key or a value cannot be varied. See [`Plan::of`] and [`Plan::validate`].
    pub fn over(scene: &Scene, vary: &[&str]) -> Result<Sweep> {
        let plan = Plan::of(scene.to_table(), vary, Sampling::Grid)?;
        Sweep::with_files(Subject::Designs(plan), Files::new())
    }

    /// Creates a sweep and reads its recordings. `files` returns the file access for a base scene, given by its index.
    ///
    /// # Errors
    ///
    /// A recording is missing, or a folder contains no recordings. The plan or a tolerance is invalid.
    pub fn new<'a, F: scene::Files + 'a>(
        subject: Subject,
        files: impl Fn(usize) -> &'a F,
    ) -> Result<Sweep> {
        subject.validate()?;
        let mut carried = Files::new();
        let mut contents: HashMap<(usize, u64), Arc<Vec<u8>>> = HashMap::new();
        for (scene, gait) in subject.recordings()? {
            let files = files(scene);
            for name in gait.files(files)? {
                let bytes = files.read(&name)?;
                // Files with equal content share one copy in memory.
                let shared = contents
                    .entry((bytes.len(), checksum(&bytes)))
                    .or_insert(bytes);
                let name = name.to_string_lossy().into_owned();
                carried.insert((scene, name), Arc::clone(shared));
            }
        }
        let files = carried;
        Ok(Sweep { subject, files })
    }

    /// Creates a sweep from recordings that are already read.
    ///
    /// # Errors
    ///
    /// The errors of [`Plan::validate`], or a tolerance is invalid.
    pub fn with_files(subject: Subject, files: Files) -> Result<Sweep> {
        subject.validate()?;
        Ok(Sweep { subject, files })
    }

    /// Contents of the stored files from which the rows are computed.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Number of rows of the sweep.
    ///
    /// # Errors
    ///
    /// The number of rows exceeds 2⁵³.
    pub fn rows(&self) -> Result<u64> {
        self.subject.rows()
    }

    /// The varied keys, in the order of their columns.
    pub fn keys(&self) -> Vec<Key> {
        match &self.subject {
            Subject::Designs(plan) => plan.keys(),
            Subject::Scatter(_) => Vec::new(),
        }
    }

    /// Description of the sweep as JSON data. Two descriptions are equal if and only if the sweeps are equal.
    pub fn description(&self) -> Value {
        let mut out = match &self.subject {
            Subject::Designs(plan) => plan.description(),
            Subject::Scatter(scatter) => scatter.description(),
        };
        let files = self.files.iter().map(|((scene, name), bytes)| {
            let sum = format!("{:016x}", checksum(bytes));
            json!({"scene": scene, "name": name, "bytes": bytes.len(), "checksum": sum})
        });
        let files: Vec<Value> = files.collect();
        if !files.is_empty() {
            out["files"] = json!(files);
        }
        out["version"] = json!(env!("CARGO_PKG_VERSION"));
        out
    }

    /// Checksum of the description of the sweep, as a hexadecimal number.
    pub fn fingerprint(&self) -> String {
        format!(
            "{:016x}",
            checksum(self.description().to_string().as_bytes())
        )
    }

    /// Metadata for a table of the rows, as pairs of name and value: fingerprint and version.
    pub fn metadata(&self) -> Vec<(String, String)> {
        let entry = |key: &str, value: String| (format!("gaitcam.{key}"), value);
        vec![
            entry("fingerprint", self.fingerprint()),
            entry("version", env!("CARGO_PKG_VERSION").to_string()),
        ]
    }

    /// Computes a range of rows with `jobs` threads; `None` if `stop` ended the computation early. `halts` returns the time limit of a row
    /// that starts at the time of the call. The rows contain no computing times, because these differ from run to run.
    ///
    /// # Errors
    ///
    /// Manufacturing samples require a design, but the scene is invalid or has no feasible cam.
    pub fn run(
        &self,
        rows: Range<u64>,
        jobs: usize,
        halts: Halts,
        stop: &dyn Fn() -> bool,
    ) -> Result<Option<Records>> {
        let count = rows.end - rows.start;
        let records = self.runner(halts, None)?.run(rows, jobs, stop);
        Ok((records.len() as u64 == count).then_some(records))
    }

    /// Computes all rows with as many threads as the computer has cores.
    ///
    /// # Errors
    ///
    /// The errors of [`Sweep::run`].
    pub fn table(&self) -> Result<Records> {
        let jobs = std::thread::available_parallelism().map_or(1, usize::from);
        let records = self.run(0..self.rows()?, jobs, &Halt::never, &|| false)?;
        Ok(records.unwrap_or_default())
    }

    /// Creates a runner, which computes several ranges of rows with a shared cache. If `clock` (s) is given, the rows contain their
    /// computing times.
    ///
    /// # Errors
    ///
    /// The errors of [`Sweep::run`].
    pub fn runner<'a>(&'a self, halts: Halts<'a>, clock: Option<Clock<'a>>) -> Result<Runner<'a>> {
        Ok(match &self.subject {
            Subject::Designs(plan) => Runner::of_plan(plan, &self.files, halts, clock),
            Subject::Scatter(scatter) => Runner::of_samples(scatter.samples(&self.files, halts())?),
        })
    }
}

impl Subject {
    fn validate(&self) -> Result<()> {
        match self {
            Subject::Designs(plan) => plan.validate(),
            Subject::Scatter(scatter) => scatter.read().map(drop),
        }
    }

    /// Number of rows of the subject.
    ///
    /// # Errors
    ///
    /// The number of rows exceeds 2⁵³.
    pub fn rows(&self) -> Result<u64> {
        row_count(match self {
            Subject::Designs(plan) => plan.rows(),
            Subject::Scatter(scatter) => u128::from(scatter.count),
        })
    }

    /// The recordings from which the rows are computed, each with the index of its base scene.
    ///
    /// # Errors
    ///
    /// A value of `gait.file` is not a file name.
    fn recordings(&self) -> Result<Vec<(usize, Gait)>> {
        let plan = match self {
            Subject::Designs(plan) => plan,
            Subject::Scatter(scatter) => {
                let own = gait_of(&scatter.scene.table);
                return Ok(own.into_iter().map(|gait| (0, gait)).collect());
            }
        };
        let lists = plan.list.iter().flat_map(|l| l.columns.iter());
        let varied = lists
            .chain(&plan.axes)
            .find(|a| a.key.name() == "gait.file");
        let mut out = Vec::new();
        for (scene, named) in plan.scenes.iter().enumerate() {
            let Some((axis, AxisValues::Words(values))) = varied.map(|axis| (axis, &axis.values))
            else {
                out.extend(gait_of(&named.table).map(|gait| (scene, gait)));
                continue;
            };
            for value in values {
                let mut table = toml::Table::new();
                axis.key.write_words(&mut table, value)?;
                out.extend(gait_of(&table).map(|gait| (scene, gait)));
            }
        }
        Ok(out)
    }
}

impl Scattered {
    /// Creates a runner for manufacturing samples of a given design.
    ///
    /// # Errors
    ///
    /// A tolerance is invalid, or the manufacturing errors of the design cannot be sampled.
    pub fn runner(&self, design: &Design) -> Result<Runner<'static>> {
        self.samples_of(design).map(Runner::of_samples)
    }
}

/// Recordings of a scene; `None` if the force of the scene does not come from a recording.
fn gait_of(table: &toml::Table) -> Option<Gait> {
    let names = match table.get("gait")?.get("file")? {
        toml::Value::Array(all) => all.iter().collect(),
        one => vec![one],
    };
    let mut names = names.into_iter().filter_map(toml::Value::as_str);
    Some(Gait {
        source: Source::File(names.next()?.into()),
        more_files: names.map(PathBuf::from).collect(),
        ..Gait::default()
    })
}

/// Checksum of bytes by the 64-bit hash FNV-1a (Fowler, Noll, Vo).
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &b| {
        (sum ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
    })
}
