//! A sweep with the content of its recordings, so that any machine can compute any of its rows.
//!
//! Row i follows from the study and from i alone: recordings are part of it by their content, not by their path.

use std::collections::{BTreeMap, HashMap};
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
use crate::error::{Placed, Result, SweepError};
use crate::force::ForceCurve;
use crate::scene::{self, Gait, Scene, Source};

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
pub type Files = BTreeMap<Named, Arc<Vec<u8>>>;

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
    /// A study; `files` gives the files of a base scene by its index.
    ///
    /// # Errors
    /// A recording that is not there, a folder without one, and as [`Plan::validate`].
    pub fn new<'a, F: scene::Files + 'a>(
        subject: Subject,
        files: impl Fn(usize) -> &'a F,
    ) -> Result<Study> {
        let mut carried = Files::new();
        let mut contents: HashMap<(usize, u64), Arc<Vec<u8>>> = HashMap::new();
        for (scene, gait) in subject.recordings()? {
            let files = files(scene);
            for name in gait.files(files)? {
                let bytes = files.read(&name)?;
                // Equal files are held once.
                let shared = contents
                    .entry((bytes.len(), checksum(&bytes)))
                    .or_insert(bytes);
                let name = name.to_string_lossy().into_owned();
                carried.insert((scene, name), Arc::clone(shared));
            }
        }
        Study::with_files(subject, carried)
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
        let carried = Carried {
            files: &self.files,
            scene: index,
        };
        let gait = scene.gait.as_ref();
        let force = gait.map(|gait| gait.force(&carried)).transpose()?;
        force
            .flatten()
            .ok_or_else(|| SweepError::NoForceError.into())
    }
}

/// The files that a study carries for one base scene.
struct Carried<'a> {
    files: &'a Files,
    scene: usize,
}

impl Carried<'_> {
    fn find(&self, name: &Path) -> Option<&Arc<Vec<u8>>> {
        self.files
            .get(&(self.scene, name.to_string_lossy().into_owned()))
    }
}

impl scene::Files for Carried<'_> {
    fn has(&self, name: &Path) -> bool {
        self.find(name).is_some()
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        let missing = || SweepError::NotCarried.in_file(name);
        self.find(name).cloned().ok_or_else(missing)
    }

    fn names(&self) -> Vec<PathBuf> {
        let own = self.files.keys().filter(|key| key.0 == self.scene);
        own.map(|key| PathBuf::from(&key.1)).collect()
    }
}

impl Subject {
    /// The recordings that rows name, each with the index of its base scene.
    ///
    /// # Errors
    /// A value of `gait.file` that is none.
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

/// The recordings that a scene names.
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

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &b| {
        (sum ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
    })
}
