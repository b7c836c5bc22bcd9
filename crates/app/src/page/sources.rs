//! Files of a request, and the force curve that is computed from them.

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
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, Scene};

/// Stored file, with its name in the scene.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Named {
    /// Name of the file as written in the scene.
    pub name: String,
    /// Hash of the bytes of the file.
    pub hash: Hash,
}

/// Files of one request. A file is looked up first among the stored files, then among the built-in files, then in the folder of the host.
pub struct Files<'a> {
    pub engine: &'a Engine,
    pub host: &'a dyn Host,
    named: Vec<Named>,
    /// Hashes of the files that were used for the response, by name.
    used: RefCell<BTreeMap<String, Hash>>,
}

impl<'a> Files<'a> {
    /// Creates the files of a request. `named` contains the stored files with their names in the scene.
    pub fn new(engine: &'a Engine, host: &'a dyn Host, named: Vec<Named>) -> Files<'a> {
        let used = RefCell::default();
        Files {
            engine,
            host,
            named,
            used,
        }
    }

    /// Content and hash of the file with this name in the scene.
    ///
    /// # Errors
    ///
    /// The errors of [`Host::read`].
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

    /// Parsed scene of a table, and a copy of the table. In the copy, the file name of every motion is replaced by the rows of the file.
    ///
    /// # Errors
    ///
    /// A file cannot be read or contains no motion, or the scene is invalid.
    pub fn scene(&self, table: &Table) -> Result<(Scene, Table)> {
        let mut read = |file: &Path| Ok((file.to_path_buf(), self.bytes(file)?.1.to_vec()));
        let whole = scene::with_motions(table, &mut read)?;
        Ok((scene::read(&whole)?, whole))
    }

    /// Force curve of a scene, and the hash of its file or of its load model. `None` if the scene has no force.
    ///
    /// # Errors
    ///
    /// The load model, the file or the recording is invalid.
    pub fn target(&self, scene: &Scene) -> Result<Option<(ForceCurve, Hash)>> {
        let Some(gait) = &scene.gait else {
            return Ok(None);
        };
        let names = gait.files(self)?;
        if names.is_empty() {
            return Ok(gait.force(self)?.map(|curve| {
                let hash = of_curve(&curve);
                (curve, hash)
            }));
        }
        let hash = |name: &PathBuf| {
            self.bytes(name)
                .map_or(String::new(), |(h, _)| h.to_string())
        };
        let hashes = names.iter().map(hash).collect::<Vec<_>>().join(" ");
        let hash = match &names[..] {
            [name] => self.bytes(name)?.0,
            _ => Hash::of(hashes.as_bytes()),
        };
        let key = Hash::of(format!("{hashes} {gait:?}").as_bytes());
        let known = lock(&self.engine.curves).get(&key);
        let Some(curve) = known.map_or_else(|| gait.force(self), |curve| Ok(Some(curve)))? else {
            return Ok(None);
        };
        lock(&self.engine.curves).put(key, curve.clone());
        Ok(Some((curve, hash)))
    }

    /// Hash of all inputs of a design: the text of its scene, and the files that were read for this request.
    pub fn of_scene(&self, text: &str) -> Hash {
        let files = format!("{:?}\n", self.used.borrow());
        Hash::of_parts(&[files.as_bytes(), text.as_bytes()])
    }
}

impl scene::Files for Files<'_> {
    fn has(&self, name: &Path) -> bool {
        self.bytes(name).is_ok()
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        Ok(self.bytes(name)?.1)
    }

    fn names(&self) -> Vec<PathBuf> {
        self.named.iter().map(|n| PathBuf::from(&n.name)).collect()
    }
}

/// Hash of a force curve that was not read from a file.
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

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::fs;

    use gaitcam::error::{FileError, Placed};
    use gaitcam::force::{Walker, population_csv};
    use gaitcam::halt::Halt;
    use gaitcam::scene::{Gait, set};
    use gaitcam::sweep::{Plan, Sampling, Subject, Sweep};

    use super::*;
    use crate::Disk;
    use crate::page::Start;

    struct NoFolder;

    impl Host for NoFolder {
        fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
            let fault = "missing".to_string();
            Err(FileError::CannotRead { fault }.in_file(path))
        }

        fn seconds(&self) -> f64 {
            0.0
        }

        fn halt(&self) -> Halt {
            Halt::never()
        }

        fn start(&self) -> Start {
            Start::default()
        }
    }

    /// Force of a stance at a fraction of its duration, relative to the weight.
    fn stance(x: f64) -> f64 {
        match (0.0..1.0).contains(&x) {
            true => 1.2 * ((PI * x).sin() + 0.25 * (3.0 * PI * x).sin()),
            false => 0.0,
        }
    }

    /// Force of one plate for a walk over a row of plates, sampled at 200 Hz, N.
    fn steps(plate: usize) -> impl Iterator<Item = f64> {
        let at =
            move |i: i32| 700.0 * stance((0.005 * f64::from(i) - 0.4 - 0.55 * plate as f64) / 0.68);
        (0..800).map(at)
    }

    fn plate(plate: usize) -> Vec<u8> {
        let head = format!(
            "NO_OF_SAMPLES\t800\nFREQUENCY\t200\nTIME_STAMP\t2015-10-06, 12:24:07\nFIRST_SAMPLE\t1\n\
             FORCE_PLATE_NAME\tForce-plate {plate}\nForce_X\tForce_Y\tForce_Z\n"
        );
        let rows = steps(plate).map(|f| format!("1.0\t-2.0\t{f:.3}\n"));
        (head + &rows.collect::<String>()).into_bytes()
    }

    fn walk(seed: f64) -> Vec<u8> {
        let columns: Vec<Vec<f64>> = (0..4).map(|k| steps(k).collect()).collect();
        let row = |i: usize| {
            let forces = columns.iter().map(|c| format!(",{:.3}", seed * c[i]));
            format!("{:.3}{}\n", 0.005 * i as f64, forces.collect::<String>())
        };
        let rows: String = (0..800).map(row).collect();
        format!("time_s,fz1_n,fz2_n,fz3_n,fz4_n\n{rows}").into_bytes()
    }

    fn stances() -> Vec<u8> {
        let names = (1..=101).map(|i| format!(",F_V_PRO_{i}"));
        let row = |who: &str, part: f64| {
            let forces = (0..101).map(|i| format!(",{:.4}", part * stance(f64::from(i) / 101.0)));
            format!("{who},1{}\n", forces.collect::<String>())
        };
        let head = format!("SUBJECT_ID,SESSION_ID{}\n", names.collect::<String>());
        (head + &row("A", 1.0) + &row("B", 0.9)).into_bytes()
    }

    fn walkers() -> Vec<u8> {
        let model = |weight| {
            let mut gait = Gait::model("young");
            gait.step_frequency = Some(1.85);
            gait.body_weight = Some(weight);
            gait.model_force().unwrap().unwrap()
        };
        let walkers = [600.0, 800.0].map(|w| Walker::new(&format!("of {w} N"), model(w)));
        population_csv(&walkers).into_bytes()
    }

    /// Every kind of force in a scene, as changes of a scene without a force.
    const KINDS: [&[&str]; 13] = [
        &["gait.model=young", "gait.step_frequency=1.85 Hz"],
        &["gait.model=young", "gait.step_frequency=1.6 Hz:2.2 Hz:4"],
        &[
            "gait.harmonics=[\"0.4\", \"0.1\"]",
            "gait.step_frequency=2 Hz",
        ],
        &["gait.file=walk.csv"],
        &["gait.file=cycle.csv", "gait.period=1 s"],
        &["gait.file=one.tsv + two.tsv + three.tsv + four.tsv"],
        &[
            "gait.file=in/GRF_F_V_PRO_left.csv",
            "gait.unit=BW",
            "gait.feet=one",
        ],
        &["gait.file=people"],
        &["gait.file=people", "gait.leave_out=[\"b.csv\"]"],
        &["gait.file=[\"walk.csv\", \"people/b.csv\"]"],
        &["gait.file=[\"people\", \"walk.csv\"]"],
        &["gait.file=walkers.csv"],
        &[
            "gait.file=../data/gait_curves/heel_tester_critical_points.csv",
            "gait.feet=one",
        ],
    ];

    #[test]
    fn every_kind_of_force_is_the_same_for_command_page_and_sweep() {
        let folder = tempfile::tempdir().unwrap();
        let cycle = "time,Fz\n0,600\n0.25,800\n0.5,600\n0.75,400\n";
        let all: [(&str, Vec<u8>); 11] = [
            ("walk.csv", walk(1.0)),
            ("cycle.csv", cycle.into()),
            ("one.tsv", plate(0)),
            ("two.tsv", plate(1)),
            ("three.tsv", plate(2)),
            ("four.tsv", plate(3)),
            ("in/GRF_F_V_PRO_left.csv", stances()),
            (
                "in/GRF_metadata.csv",
                b"SUBJECT_ID,BODY_MASS\nA,70\nB,90\n".to_vec(),
            ),
            ("people/a.csv", walk(0.9)),
            ("people/b.csv", walk(1.1)),
            ("walkers.csv", walkers()),
        ];
        let engine = Engine::default();
        let mut named = Vec::new();
        for (name, bytes) in all {
            let place = folder.path().join(name);
            fs::create_dir_all(place.parent().unwrap()).unwrap();
            fs::write(place, &bytes).unwrap();
            let (name, hash) = (name.to_string(), engine.keep(bytes));
            named.push(Named { name, hash });
        }
        let disk = Disk::beside(&folder.path().join("scene.toml"));
        for changes in KINDS {
            let text = "[drive]\nmass = \"auto\"\nspeed = \"auto\"\n[law]\nfamily = \"harmonic\"\n";
            let mut table: Table = text.parse().unwrap();
            changes
                .iter()
                .for_each(|change| set(&mut table, change).unwrap());
            let scene = scene::read(&table).unwrap();
            let gait = scene.gait.as_ref().unwrap();
            let told = gait
                .force(&disk)
                .unwrap_or_else(|e| panic!("{changes:?}: {e}"))
                .unwrap();
            let page = Files::new(&engine, &NoFolder, named.clone());
            let (shown, _) = page.target(&scene).unwrap().unwrap();
            assert_eq!(
                (shown.period_s, &shown.force_n),
                (told.period_s, &told.force_n),
                "{changes:?}"
            );
            let vary = ["limits.stroke=500 mm,600 mm"];
            let plan = Plan::of(table, &vary, Sampling::Grid).unwrap();
            let sweep = Sweep::new(Subject::Designs(plan), |_| &disk).unwrap();
            let again = Sweep::with_files(sweep.subject.clone(), sweep.files().clone()).unwrap();
            let rows = again
                .run(0..1, 1, &Halt::never, &|| false)
                .unwrap()
                .unwrap();
            let stroke = rows.numbers("stroke_m").unwrap()[0];
            let mut scene = scene;
            scene.limits = scene.limits.with(gaitcam::LimitKind::Stroke, 0.5);
            let design = scene
                .design_for(&told)
                .unwrap_or_else(|e| panic!("{changes:?}: {e}"));
            let own = design.cam.law.stroke();
            assert!(
                (stroke / own - 1.0).abs() < 1e-6,
                "{changes:?}: {stroke} is not {own}"
            );
        }
    }
}
