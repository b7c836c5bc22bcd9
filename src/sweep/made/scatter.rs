//! A sweep over the manufacturing errors of one design. Row i contains the manufactured cam number i.

use std::ops::Range;

use serde_json::{Value, json};

use super::tolerance::{Scatter, Tolerance, ToleranceSample};
use crate::error::{Result, SweepError};
use crate::halt::Halt;
use crate::problem::Problem;
use crate::scene::{self, Gait};
use crate::sweep::carried::{Files, force};
use crate::sweep::plan::NamedScene;
use crate::sweep::table::records::{Field, Records};
use crate::synth::{Design, Search, design};

/// One design that is manufactured many times, with errors within tolerances.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::sweep::{NamedScene, Part, Scattered};
///
/// let table = scene::built_in("footbridge")?.toml.parse().unwrap();
/// let scattered = Scattered {
///     scene: NamedScene { name: "footbridge".to_string(), table },
///     tolerances: vec!["profile=0.02 mm".to_string(), "mass=1 %".to_string()],
///     count: 1000,
///     seed: 1,
/// };
/// assert_eq!(scattered.read()?[1].part, Part::Mass);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scattered {
    /// Scene of the design.
    pub scene: NamedScene,
    /// Tolerances as written by the user, such as `profile=0.02 mm`.
    pub tolerances: Vec<String>,
    /// Number of manufactured cams.
    pub count: u64,
    /// Seed of the random manufacturing errors.
    pub seed: u64,
}

/// Columns of a table of manufacturing samples, in addition to the column `row`.
pub const SAMPLE_COLUMNS: [&str; 6] = [
    "profile_m",
    "base_radius_m",
    "mass_kg",
    "speed_rad_per_s",
    "force_rms_error_n",
    "force_rms_error_percent",
];

/// Computes the manufacturing samples of a design as rows of a table.
pub struct Samples {
    scatter: Scatter,
    tolerances: Vec<Tolerance>,
    count: u64,
    seed: u64,
}

impl Scattered {
    /// Parses the tolerances of the sweep.
    ///
    /// # Errors
    ///
    /// The errors of [`Tolerance::parse`].
    pub fn read(&self) -> Result<Vec<Tolerance>> {
        self.tolerances
            .iter()
            .map(|t| Tolerance::parse(t))
            .collect()
    }

    /// Description of the sweep as JSON data. Two descriptions are equal if and only if the sweeps are equal.
    pub fn description(&self) -> Value {
        json!({
            "scenes": [{"name": self.scene.name, "text": self.scene.table.to_string()}],
            "tolerances": self.tolerances,
            "sample": {"method": "latin", "count": self.count, "seed": self.seed},
            "rows": self.count,
        })
    }

    /// Designs the cam of the scene and prepares its manufacturing samples.
    ///
    /// # Errors
    ///
    /// The scene or its force is invalid, or the scene has no feasible cam.
    pub(in crate::sweep) fn samples(&self, files: &Files, halt: Halt) -> Result<Samples> {
        let scene = scene::read(&self.scene.table)?;
        let is_recording = scene.gait.as_ref().is_some_and(Gait::is_recording);
        let target = if is_recording {
            Some(force(files, 0, &scene)?)
        } else {
            scene.model_force()?
        };
        let problem = Problem::resolve(&scene, target.as_ref())?;
        let design = design(&problem, &Search::until(halt))?;
        if design.infeasible.is_some() {
            return Err(SweepError::NoDesign.into());
        }
        self.samples_of(&design)
    }

    /// Prepares the manufacturing samples of a given design.
    ///
    /// # Errors
    ///
    /// A tolerance is invalid, or the manufacturing errors of the design cannot be sampled.
    pub(in crate::sweep) fn samples_of(&self, design: &Design) -> Result<Samples> {
        Ok(Samples {
            scatter: Scatter::new(design)?,
            tolerances: self.read()?,
            count: self.count,
            seed: self.seed,
        })
    }
}

impl Samples {
    /// Table of the samples in a range of rows.
    pub fn records(&self, rows: Range<u64>) -> Records {
        let count = (rows.end - rows.start) as usize;
        let (scatter, tolerances) = (&self.scatter, &self.tolerances);
        let mut fields = vec![Field::rows(rows.start, count)];
        let sample = |row| numbers(scatter.sample(tolerances, row, self.count, self.seed));
        let samples: Vec<_> = rows.map(sample).collect();
        for (k, name) in SAMPLE_COLUMNS.iter().enumerate() {
            fields.push(Field::numbers(name, samples.iter().map(|s| s[k]).collect()));
        }
        Records { fields }
    }
}

/// Values of a manufacturing sample, in the order of [`SAMPLE_COLUMNS`].
fn numbers(made: ToleranceSample) -> [f64; SAMPLE_COLUMNS.len()] {
    [
        made.profile_m,
        made.base_radius_m,
        made.mass_kg,
        made.speed_rad_per_s,
        made.force_rms_error_n,
        made.force_rms_error_percent,
    ]
}
