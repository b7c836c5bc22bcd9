//! The files that a question names, and the force curve of its scene.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use toml::Table;

use crate::page::hash::Hash;
use crate::page::kept::{Engine, Host};
use crate::page::lock;
use gaitcam::error::Result;
use gaitcam::force::{self, ForceCurve, ReadOptions};
use gaitcam::scene::{self, Gait, PopulationReader, Scene, Source, is_table_of_walkers};

/// A file by the name that the scene gives it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Named {
    /// Its name.
    pub name: String,
    /// Hash of its bytes.
    pub hash: Hash,
}

/// The files of one question: kept ones that it names, then those that came with the program, then those of the host.
pub struct Files<'a> {
    pub engine: &'a Engine,
    pub host: &'a dyn Host,
    named: Vec<Named>,
    /// What was read for the answer.
    used: RefCell<BTreeMap<String, Hash>>,
}

impl<'a> Files<'a> {
    /// The files of a question.
    pub fn new(engine: &'a Engine, host: &'a dyn Host, named: Vec<Named>) -> Files<'a> {
        let used = RefCell::default();
        Files {
            engine,
            host,
            named,
            used,
        }
    }

    /// A file by the name that a scene gives it.
    ///
    /// # Errors
    /// As [`Host::read`].
    pub fn bytes(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
        let name = path.to_string_lossy();
        let named = self.named.iter().find(|n| n.name == name);
        let kept = named.and_then(|n| Some((n.hash.clone(), self.engine.kept(&n.hash)?)));
        let (hash, bytes) = match (kept, scene::built_in_file(path)) {
            (Some(kept), _) => kept,
            (None, Some(bytes)) => (Hash::of(bytes), Arc::new(bytes.to_vec())),
            (None, None) => self.host.read(path)?,
        };
        let mut used = self.used.borrow_mut();
        used.insert(name.into_owned(), hash.clone());
        Ok((hash, bytes))
    }

    /// The scene of a table with the rows of every motion in place of the file that it names, and that table.
    ///
    /// # Errors
    /// Files that are not to be had or that hold no motion; faults of the scene.
    pub fn scene(&self, table: &Table) -> Result<(Scene, Table)> {
        let mut read = |file: &Path| Ok((file.to_path_buf(), self.bytes(file)?.1.to_vec()));
        let whole = scene::with_motions(table, &mut read)?;
        Ok((scene::read(&whole)?, whole))
    }

    /// The force curve that a scene names, if it names one, with the hash of its file, or of the curve of a load model.
    ///
    /// # Errors
    /// Faults of the load model, the file or the recording.
    pub fn target(&self, scene: &Scene) -> Result<Option<(ForceCurve, Hash)>> {
        let Some(gait) = &scene.gait else {
            return Ok(None);
        };
        let path = match (gait.model_force()?, &gait.source) {
            (Some(curve), _) => {
                let hash = of_curve(&curve);
                return Ok(Some((curve, hash)));
            }
            (None, Source::Model(_) | Source::Harmonics(_)) => return Ok(None),
            (None, Source::File(path)) => path,
        };
        if !gait.more_files.is_empty() {
            return self.population(gait, path).map(Some);
        }
        let (hash, bytes) = self.bytes(path)?;
        if is_table_of_walkers(path, &bytes) {
            return self.population(gait, path).map(Some);
        }
        let (options, subjects) = self.options(gait, path)?;
        let how = format!("{hash} {subjects:?} {gait:?}");
        let key = Hash::of(how.as_bytes());
        let known = lock(&self.engine.curves).get(&key);
        let curve = match known {
            Some(curve) => curve,
            None => force::force_curve(path, &bytes, &options, gait.feet)?,
        };
        lock(&self.engine.curves).put(key, curve.clone());
        Ok(Some((curve, hash)))
    }

    /// The mean cycle of the walkers that a scene names, with the hash of their files.
    fn population(&self, gait: &Gait, path: &Path) -> Result<(ForceCurve, Hash)> {
        let paths = std::iter::once(path).chain(gait.more_files.iter().map(PathBuf::as_path));
        let mut reader = PopulationReader::new(gait);
        let mut hashes = Vec::new();
        for path in paths {
            let (hash, bytes) = match self.bytes(path) {
                Ok(both) => both,
                Err(why) => {
                    reader.refuse(path, why);
                    continue;
                }
            };
            let subjects = force::metadata_name(path).and_then(|p| self.bytes(&p).ok());
            reader.take(path, &bytes, || subjects.map(|(_, bytes)| bytes.to_vec()));
            hashes.push(hash.to_string());
        }
        let curve = reader.mean(path)?;
        Ok((curve, Hash::of(hashes.join(" ").as_bytes())))
    }

    /// How the recording of a scene is read, with the hash of the file about the persons.
    fn options(&self, gait: &Gait, path: &Path) -> Result<(ReadOptions, Option<Hash>)> {
        let subjects = force::metadata_name(path).and_then(|p| self.bytes(&p).ok());
        let (hash, bytes) = subjects.unzip();
        let options = gait.read_options(bytes.map(|bytes| bytes.to_vec()))?;
        Ok((options, hash))
    }

    /// The hash of all that a scene's design depends on; its files are read already.
    pub fn of_scene(&self, text: &str) -> Hash {
        let files = format!("{:?}\n", self.used.borrow());
        Hash::of_parts(&[files.as_bytes(), text.as_bytes()])
    }
}

/// The hash of a curve that is in no file.
fn of_curve(curve: &ForceCurve) -> Hash {
    let force = curve.force_n.iter().flat_map(|x| x.to_le_bytes());
    let numbers: Vec<u8> = curve
        .period_s
        .to_le_bytes()
        .into_iter()
        .chain(force)
        .collect();
    Hash::of(&numbers)
}
