//! A sweep over one scene in three lines.

use super::plan::axis::Axis;
use super::plan::sample::Method;
use super::plan::{NamedScene, Plan, Sampling, row_count};
use super::runner::Runner;
use super::table::records::Records;
use crate::error::{Result, SweepError};
use crate::halt::Halt;
use crate::scene::Scene;

/// Designs one cam for every combination of values of a scene's keys, on all cores.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::sweep::Sweep;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let table = Sweep::over(&scene).vary("limits.stroke", "45 mm:60 mm:4").run()?;
/// assert!((table.numbers("limits.stroke_m").unwrap()[1] - 0.05).abs() < 1e-15);
/// assert_eq!(table.words("verdict").unwrap().at(3), Some("acceptable"));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sweep {
    scene: NamedScene,
    vary: Vec<(String, String)>,
    sampling: Sampling,
}

impl Sweep {
    /// A sweep over a scene whose force is a load model, or that has none; scenes that name a recording are rows of a
    /// [`Plan`].
    pub fn over(scene: &Scene) -> Sweep {
        Sweep {
            scene: NamedScene {
                name: scene.name.clone(),
                table: scene.to_table(),
            },
            vary: Vec::new(),
            sampling: Sampling::Grid,
        }
    }

    /// Varies a key: `START:STOP:COUNT` for equal steps or `A,B,C`. Every combination of the values of all varied keys
    /// is a row; the last key runs fastest.
    #[must_use]
    pub fn vary(mut self, key: &str, values: &str) -> Sweep {
        self.vary.push((key.to_string(), values.to_string()));
        self
    }

    /// Takes `count` points of the varied ranges, now written `START:STOP`, in place of every combination.
    #[must_use]
    pub fn sample(mut self, method: Method, count: u64, seed: u64) -> Sweep {
        self.sampling = Sampling::Sample {
            method,
            count,
            seed,
        };
        self
    }

    /// Computes all rows; the columns are those of the table of `gaitcam sweep`.
    ///
    /// # Errors
    /// A key or values that cannot be varied, as [`Axis::parse`] and [`Plan::validate`].
    pub fn run(self) -> Result<Records> {
        let is_sampled = self.sampling != Sampling::Grid;
        let axis =
            |(key, values): &(String, String)| Axis::parse(&format!("{key}={values}"), is_sampled);
        let plan = Plan {
            scenes: vec![self.scene],
            list: None,
            axes: self.vary.iter().map(axis).collect::<Result<_>>()?,
            sampling: self.sampling,
        };
        plan.validate()?;
        let rows = row_count(plan.rows())?;
        let no_file = |_: usize, _: &Scene| Err(SweepError::NoForceError.into());
        let runner = Runner::of_plan(&plan, &no_file, &Halt::never, None);
        let jobs = std::thread::available_parallelism().map_or(1, usize::from);
        Ok(runner.run(0..rows, jobs, &|| false))
    }
}
