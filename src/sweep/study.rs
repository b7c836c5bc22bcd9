//! A sweep with the content of its recordings, so that any machine can compute any of its rows.
//!
//! Row i follows from the study and from i alone: recordings are part of it by their content, not by their path.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Value, json};

use super::kernel::Halts;
use super::made::scatter::Scattered;
use super::plan::axis::Values as AxisValues;
use super::plan::{Plan, row_count};
use super::runner::Runner;
use super::table::records::Records;
use crate::error::{ForceError, Placed, Result, SweepError};
use crate::force::{self, ForceCurve};
use crate::scene::{PopulationReader, Scene, Source, is_table_of_walkers};

/// A file that rows name: index of the base scene, and the path as the scene writes it.
pub type Named = (usize, String);

/// Files that rows name, with their content.
///
/// ```
/// use gaitcam::sweep::Files;
///
/// let mut files = Files::new();
/// files.insert((0, "walk.csv".to_string()), b"time,Fz\n".to_vec().into());
/// assert_eq!(files[&(0, "walk.csv".to_string())].len(), 8);
/// ```
pub type Files = BTreeMap<Named, Arc<[u8]>>;

/// Contents of the rows.
///
/// ```
/// use gaitcam::sweep::{Axis, NamedScene, Plan, Sampling, Study, Subject};
///
/// let scene = NamedScene { name: "a".to_string(), table: toml::Table::new() };
/// let axes = vec![Axis::parse("limits.stroke=40 mm:60 mm:5", false)?];
/// let plan = Plan { scenes: vec![scene], list: None, axes, sampling: Sampling::Grid };
/// let study = Study::with_files(Subject::Designs(plan), Default::default())?;
/// assert_eq!(study.rows()?, 5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Subject {
    /// Designs of many scenes.
    Designs(Plan),
    /// One design, made with errors within tolerances.
    Scatter(Scattered),
}

/// A sweep with the content of every recording that it names.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::sweep::{Axis, NamedScene, Plan, Sampling, Study, Subject};
///
/// let table = scene::built_in("footbridge")?.toml.parse().unwrap();
/// let scenes = vec![NamedScene { name: "footbridge".to_string(), table }];
/// let axes = vec![Axis::parse("gait.body_weight=600 N:800 N:5", false)?];
/// let plan = Plan { scenes, list: None, axes, sampling: Sampling::Grid };
/// // A load model needs no file; the fingerprint tells this sweep from any other.
/// let study = Study::with_files(Subject::Designs(plan), Default::default())?;
/// assert_eq!((study.rows()?, study.files().len()), (5, 0));
/// assert_eq!(study.fingerprint(), study.fingerprint());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Contents of the rows.
    pub subject: Subject,
    files: Files,
}

impl Study {
    /// A study; `read` gives the files that a name in a base scene stands for, by their names: one, or those of a folder.
    ///
    /// # Errors
    /// A recording that is not there, a folder without one, and as [`Plan::validate`].
    pub fn new(
        subject: Subject,
        mut read: impl FnMut(usize, &Path) -> Result<Vec<(PathBuf, Vec<u8>)>>,
    ) -> Result<Study> {
        let mut files = Files::new();
        let mut contents: HashMap<(usize, u64), Arc<[u8]>> = HashMap::new();
        for (scene, name) in subject.recordings()? {
            let own = read(scene, Path::new(&name))?;
            if own.is_empty() {
                return Err(ForceError::NoWalkers.in_file(Path::new(&name)));
            }
            let beside: BTreeSet<PathBuf> = own
                .iter()
                .filter_map(|file| force::metadata_name(&file.0))
                .collect();
            let subjects = beside.iter().filter_map(|path| read(scene, path).ok());
            let all: Vec<(PathBuf, Vec<u8>)> = own.into_iter().chain(subjects.flatten()).collect();
            for (path, bytes) in all {
                // Equal files are held once.
                let shared = contents
                    .entry((bytes.len(), checksum(&bytes)))
                    .or_insert_with(|| bytes.into());
                let name = path.to_string_lossy().into_owned();
                files.insert((scene, name), Arc::clone(shared));
            }
        }
        Study::with_files(subject, files)
    }

    /// A study from files that were read before.
    ///
    /// # Errors
    /// As [`Plan::validate`].
    pub fn with_files(subject: Subject, files: Files) -> Result<Study> {
        match &subject {
            Subject::Designs(plan) => plan.validate()?,
            Subject::Scatter(scatter) => {
                scatter.read()?;
            }
        }
        Ok(Study { subject, files })
    }

    /// The files that rows name, with their content.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Number of rows.
    ///
    /// # Errors
    /// More rows than row numbers can count.
    pub fn rows(&self) -> Result<u64> {
        let rows = match &self.subject {
            Subject::Designs(plan) => plan.rows(),
            Subject::Scatter(scatter) => u128::from(scatter.count),
        };
        row_count(rows)
    }

    /// The study as data: equal studies have equal descriptions.
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

    /// A checksum of the whole study, hexadecimal.
    pub fn fingerprint(&self) -> String {
        format!(
            "{:016x}",
            checksum(self.description().to_string().as_bytes())
        )
    }

    /// Metadata of a table of its rows: fingerprint and version.
    pub fn metadata(&self) -> Vec<(String, String)> {
        let entry = |key: &str, value: String| (format!("gaitcam.{key}"), value);
        vec![
            entry("fingerprint", self.fingerprint()),
            entry("version", env!("CARGO_PKG_VERSION").to_string()),
        ]
    }

    /// The rows of a range over `jobs` threads; `None` where `stop` ended the work before all were computed. `halts`
    /// gives the end of the search of a row that begins now. Without times: they do not follow from the plan.
    ///
    /// # Errors
    /// Manufacturing samples of a scene without a feasible cam.
    pub fn run(
        &self,
        rows: Range<u64>,
        jobs: usize,
        halts: Halts,
        stop: &dyn Fn() -> bool,
    ) -> Result<Option<Records>> {
        let targets = |index: usize, scene: &Scene| self.target(index, scene);
        let runner = match &self.subject {
            Subject::Designs(plan) => Runner::of_plan(plan, &targets, halts, None),
            Subject::Scatter(scatter) => Runner::of_samples(scatter.samples(&targets, halts())?),
        };
        let count = rows.end - rows.start;
        let records = runner.run(rows, jobs, stop);
        Ok((records.len() as u64 == count).then_some(records))
    }

    /// The force curve of a recording.
    fn target(&self, index: usize, scene: &Scene) -> Result<ForceCurve> {
        let Some((gait, Source::File(path))) = scene.gait.as_ref().map(|g| (g, &g.source)) else {
            return Err(SweepError::NoForceError.into());
        };
        let content = |path: &Path| {
            let name = path.to_string_lossy().into_owned();
            self.files.get(&(index, name)).map(|b| &b[..])
        };
        let carried = |path: &Path| {
            let missing = || SweepError::NotCarried.in_file(path);
            content(path).ok_or_else(missing)
        };
        let metadata = |path: &Path| Some(content(&force::metadata_name(path)?)?.to_vec());
        let named = std::iter::once(path).chain(&gait.more_files);
        let all: Vec<PathBuf> = named.flat_map(|path| self.files_at(index, path)).collect();
        let is_one = matches!(&all[..], [one] if one == path);
        if !is_one || is_table_of_walkers(path, carried(path)?) {
            let mut reader = PopulationReader::new(gait);
            for path in &all {
                match carried(path) {
                    Ok(bytes) => reader.take(path, bytes, || metadata(path)),
                    Err(why) => reader.refuse(path, why),
                }
            }
            return reader.mean(path);
        }
        let options = gait.read_options(metadata(path))?;
        force::force_curve(path, carried(path)?, &options, gait.feet)
    }

    /// The files that a name stands for: itself, or those that are carried of a folder.
    fn files_at(&self, scene: usize, path: &Path) -> Vec<PathBuf> {
        let of_scene = self.files.keys().filter(|key| key.0 == scene);
        let own = of_scene.map(|key| PathBuf::from(&key.1));
        let inside = own.filter(|file| file.starts_with(path) && !is_about_subjects(file));
        let mut inside: Vec<PathBuf> = inside.collect();
        inside.sort();
        if inside.is_empty() {
            inside.push(path.to_path_buf());
        }
        inside
    }
}

/// Whether a file is a table of subjects, which stands beside recordings and is none.
fn is_about_subjects(file: &Path) -> bool {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    stem.to_lowercase().ends_with("metadata")
}

impl Subject {
    /// The names of recordings in rows, each with its base scene.
    ///
    /// # Errors
    /// A value of `gait.file` that is none.
    fn recordings(&self) -> Result<Vec<Named>> {
        let plan = match self {
            Subject::Designs(plan) => plan,
            Subject::Scatter(scatter) => {
                let own = files_of(&scatter.scene.table);
                return Ok(own.into_iter().map(|name| (0, name)).collect());
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
                out.extend(files_of(&named.table).into_iter().map(|name| (scene, name)));
                continue;
            };
            for value in values {
                let mut table = toml::Table::new();
                axis.key.write_words(&mut table, value)?;
                out.extend(files_of(&table).into_iter().map(|name| (scene, name)));
            }
        }
        out.sort();
        out.dedup();
        Ok(out)
    }
}

/// The files that a scene names.
fn files_of(table: &toml::Table) -> Vec<String> {
    let file = table.get("gait").and_then(|gait| gait.get("file"));
    let names = match file {
        Some(toml::Value::Array(all)) => all.iter().collect(),
        one => Vec::from_iter(one),
    };
    let names = names.into_iter().filter_map(toml::Value::as_str);
    names.map(str::to_string).collect()
}

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &b| {
        (sum ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
    })
}
