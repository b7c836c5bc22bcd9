//! Plan of a sweep: base scenes, combined with a list, a grid or a sample of values. The scene of each row depends only on the row number.

pub(super) mod axis;
pub(super) mod batch;
pub(super) mod key;
pub(super) mod sample;

use serde_json::{Value, json};
use toml::Table;

use self::axis::{Axis, AxisValue, Values};
use self::batch::{Batch, Column};
use self::key::Key;
use self::sample::{Method, SOBOL_AXES};
use crate::error::{Place, Result, SweepError};
use crate::scene;

/// A base scene with its name.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::sweep::NamedScene;
///
/// let table = scene::built_in("footbridge")?.toml.parse().unwrap();
/// let base = NamedScene { name: "footbridge.toml".to_string(), table };
/// assert_eq!(scene::read(&base.table)?.name, "footbridge");
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NamedScene {
    /// Name of the scene in tables, usually the name of its file.
    pub name: String,
    /// TOML table of the scene.
    pub table: Table,
}

impl NamedScene {
    /// Creates a named scene from its table. The name is the value of the key `name`, or `cam` without this key. It does not depend on the
    /// file.
    pub fn of(table: Table) -> NamedScene {
        let name = table.get("name").and_then(|name| name.as_str());
        let name = name.unwrap_or("cam").to_string();
        NamedScene { name, table }
    }
}

/// Values of several keys that are listed row by row.
///
/// ```
/// use gaitcam::sweep::{Axis, List};
///
/// let columns = vec![
///     Axis::list("limits.stroke", ["50 mm", "55 mm"].into_iter())?,
///     Axis::list("law.family", ["spline", "harmonic"].into_iter())?,
/// ];
/// assert_eq!(List { columns }.rows(), 2);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    /// Listed keys, with one value for each row of the list.
    pub columns: Vec<Axis>,
}

impl List {
    /// Number of rows of the list.
    pub fn rows(&self) -> u64 {
        self.columns.first().and_then(Axis::count).unwrap_or(0)
    }

    /// Rejects a list whose columns have different lengths.
    fn check(&self) -> Result<()> {
        let first = self.rows();
        for column in &self.columns {
            let values = column.count().unwrap_or(0);
            if values != first {
                let key = column.key.name().to_string();
                return Err(SweepError::ListLengths { key, values, first }.into());
            }
        }
        Ok(())
    }
}

/// Method that combines the values of the axes into rows.
///
/// ```
/// use gaitcam::sweep::{Method, Plan, Sampling};
///
/// let sampling = Sampling::Sample { method: Method::Latin, count: 1000, seed: 1 };
/// let plan = Plan::of(toml::Table::new(), &["limits.stroke=40 mm:60 mm"], sampling)?;
/// assert_eq!(plan.rows(), 1000);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// All combinations of the values. The last axis varies fastest.
    Grid,
    /// Combinations of values that are sampled from all axes.
    Sample {
        /// Method that distributes the sampled points.
        method: Method,
        /// Number of sampled points.
        count: u64,
        /// Seed of the random numbers.
        seed: u64,
    },
}

/// Plan of a sweep. Its rows are all combinations of base scenes, rows of the list, and combinations of axis values. The axes vary fastest.
///
/// ```
/// use gaitcam::sweep::{Plan, Sampling};
///
/// let vary = ["limits.stroke=40 mm:60 mm:5", "law.family=spline,harmonic"];
/// let plan = Plan::of(toml::Table::new(), &vary, Sampling::Grid)?;
/// assert_eq!(plan.rows(), 5 * 2);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Base scenes of the sweep.
    pub scenes: Vec<NamedScene>,
    /// List of values of several keys; `None` without a list.
    pub list: Option<List>,
    /// Varied keys, each with its values.
    pub axes: Vec<Axis>,
    /// Method that combines the values of the axes into rows.
    pub sampling: Sampling,
}

/// Maximum number of combinations of words for which a value is checked before the sweep starts.
const TRIED_COMBINATIONS: u128 = 256;
/// Maximum number of values of each list that are checked before the sweep starts.
const TRIED_VALUES: u64 = 64;

impl Plan {
    /// Creates a plan for one scene. Each element of `vary` is `KEY=START:STOP:COUNT` or `KEY=A,B`. For a sample, a range is
    /// `KEY=START:STOP`.
    ///
    /// # Errors
    ///
    /// The errors of [`Axis::parse`].
    pub fn of(table: Table, vary: &[&str], sampling: Sampling) -> Result<Plan> {
        let axis = |text: &&str| Axis::parse(text, sampling != Sampling::Grid);
        Ok(Plan {
            scenes: vec![NamedScene::of(table)],
            list: None,
            axes: vary.iter().map(axis).collect::<Result<_>>()?,
            sampling,
        })
    }

    /// Number of rows of the plan. If the number exceeds the maximum of `u128`, the result is this maximum.
    pub fn rows(&self) -> u128 {
        let list = self.list.as_ref().map_or(1, |l| u128::from(l.rows()));
        let sampling = match self.sampling {
            Sampling::Sample { count, .. } => u128::from(count),
            Sampling::Grid => self
                .axes
                .iter()
                .map(|a| u128::from(a.count().unwrap_or(1)))
                .fold(1, u128::saturating_mul),
        };
        (self.scenes.len() as u128)
            .saturating_mul(list)
            .saturating_mul(sampling)
    }

    /// The varied keys, in the order of their columns.
    pub fn keys(&self) -> Vec<Key> {
        self.all_axes().map(|a| a.key.clone()).collect()
    }

    fn all_axes(&self) -> impl Iterator<Item = &Axis> {
        let listed = self.list.iter().flat_map(|l| l.columns.iter());
        listed.chain(self.axes.iter())
    }

    /// Parameters of `count` consecutive rows. `first` is the number of the first row.
    pub fn batch(&self, first: u64, count: usize) -> Batch {
        let mut batch = Batch {
            scene: Vec::with_capacity(count),
            columns: self
                .all_axes()
                .map(|a| Column::with_capacity(a.key.is_number(), count))
                .collect(),
        };
        let listed = self.list.as_ref().map_or(0, |l| l.columns.len());
        let list_rows = self.list.as_ref().map_or(1, List::rows).max(1);
        let counts: Vec<u64> = self
            .axes
            .iter()
            .map(|a| a.count().unwrap_or(1).max(1))
            .collect();
        let inner = match self.sampling {
            Sampling::Sample { count, .. } => count.max(1),
            Sampling::Grid => counts.iter().product::<u64>().max(1),
        };
        for row in first..first + count as u64 {
            let (outer, point) = (row / inner, row % inner);
            batch.scene.push((outer / list_rows) as u32);
            if let Some(list) = &self.list {
                for (column, axis) in batch.columns.iter_mut().zip(&list.columns) {
                    column.push(axis.value(outer % list_rows));
                }
            }
            let columns = &mut batch.columns[listed..];
            match self.sampling {
                Sampling::Grid => {
                    let mut rest = point;
                    for (k, axis) in self.axes.iter().enumerate().rev() {
                        columns[k].push(axis.value(rest % counts[k]));
                        rest /= counts[k];
                    }
                }
                Sampling::Sample {
                    method,
                    count,
                    seed,
                } => {
                    for (k, axis) in self.axes.iter().enumerate() {
                        columns[k].push(axis.sampled(method.coordinate(point, count, k, seed)));
                    }
                }
            }
        }
        batch
    }

    /// Checks that the plan is valid. It must have rows. Each key must be one that can be varied, and must occur only once. Each value must
    /// be valid in at least one combination with values of the other keys.
    ///
    /// # Errors
    ///
    /// The plan has no rows, or the columns of its list have different lengths. A key cannot be varied, has no effect, occurs twice, or has
    /// a value that no scene accepts. The axes of a sample are missing or too many for the Sobol sequence.
    pub fn validate(&self) -> Result<()> {
        let axes: Vec<&Axis> = self.all_axes().collect();
        if self.rows() == 0 {
            return Err(SweepError::NoRows.into());
        }
        if let Some(list) = &self.list {
            list.check()?;
        }
        for (i, axis) in axes.iter().enumerate() {
            let name = axis.key.name();
            if name == "name" {
                let (key, known) = (name.to_string(), Key::names().join(", "));
                return Err(SweepError::Fixed { key, known }.into());
            }
            if axes[..i].iter().any(|a| a.key.name() == name) {
                let key = name.to_string();
                return Err(SweepError::KeyTwice { key }.into());
            }
        }
        if let Sampling::Sample { method, .. } = self.sampling {
            if self.axes.is_empty() {
                return Err(SweepError::NothingToSample.into());
            }
            if method == Method::Sobol && self.axes.len() > SOBOL_AXES {
                return Err(SweepError::SobolAxes { most: SOBOL_AXES }.into());
            }
        }
        for scene in &self.scenes {
            for axis in &axes {
                for value in trial_values(axis) {
                    self.try_value(scene, axis, &value)?;
                }
            }
        }
        Ok(())
    }

    /// Rejects a value of `axis` that is invalid in every tried combination with the other keys. The combinations use every word of a key
    /// with words, and the first value of a key with numbers. If a value is invalid only in some combinations, the rows of these
    /// combinations contain an error.
    fn try_value(&self, scene: &NamedScene, axis: &Axis, value: &AxisValue) -> Result<()> {
        let others: Vec<&Axis> = self.all_axes().filter(|a| a.key != axis.key).collect();
        let choices: Vec<u64> = others
            .iter()
            .map(|a| match &a.values {
                Values::Words(list) => list.len() as u64,
                _ => 1,
            })
            .collect();
        let total = choices
            .iter()
            .map(|c| u128::from(*c))
            .fold(1, u128::saturating_mul);
        let mut fault = None;
        for combination in 0..total.min(TRIED_COMBINATIONS) as u64 {
            let mut table = scene.table.clone();
            let mut rest = combination;
            for (other, choices) in others.iter().zip(&choices) {
                other.value(rest % choices).write(&other.key, &mut table)?;
                rest /= choices;
            }
            value.write(&axis.key, &mut table)?;
            match scene::read(&table) {
                Ok(read) => match read.no_effect_of(axis.key.name()) {
                    None => return Ok(()),
                    Some(error) => fault = Some(error),
                },
                // Individually valid keys can be inconsistent with each other. The row of such a scene contains the error, and other rows
                // may be valid.
                Err(_) if scene::read_keys(&table).is_ok() => return Ok(()),
                Err(e)
                    if e.place == Place::Key(axis.key.name().to_string())
                        || e.place == Place::Key(parent(axis.key.name())) =>
                {
                    fault = Some(e);
                }
                Err(_) => return Ok(()),
            }
        }
        fault.map_or(Ok(()), Err)
    }

    /// Names of the base scenes; `None` if there is only one.
    pub fn scene_names(&self) -> Option<Vec<String>> {
        let names = self.scenes.iter().map(|s| s.name.clone());
        (self.scenes.len() > 1).then(|| names.collect())
    }

    /// Description of the plan as JSON data, which is stored with its table. Two descriptions are equal if and only if the plans are equal.
    pub fn description(&self) -> Value {
        let scene = |s: &NamedScene| json!({"name": s.name, "text": s.table.to_string()});
        let mut out = json!({"scenes": self.scenes.iter().map(scene).collect::<Value>()});
        if let Some(list) = &self.list {
            let columns = list.columns.iter();
            let text = |a: &Axis| format!("{}={}", a.key.name(), a.text());
            let text: Vec<String> = columns.clone().map(text).collect();
            let names: Vec<&str> = columns.map(|a| a.key.name()).collect();
            let sum = crc32fast::hash(text.join("\n").as_bytes());
            out["list"] = json!({"rows": list.rows(), "keys": names, "checksum": sum});
        }
        out["vary"] = json!({});
        for axis in &self.axes {
            out["vary"][axis.key.name()] = json!(axis.text());
        }
        if let Sampling::Sample {
            method,
            count,
            seed,
        } = self.sampling
        {
            out["sample"] = json!({"method": method.name(), "count": count, "seed": seed});
        }
        out["rows"] = json!(self.rows() as u64);
        out
    }
}

/// Maximum number of rows. Up to this limit, all integers are exact as 64-bit floating-point numbers. Many programs read row numbers as
/// such numbers.
const MOST_ROWS: u64 = 1 << 53;

/// Converts the number of rows, if it does not exceed the maximum.
///
/// # Errors
///
/// The number of rows exceeds 2⁵³.
pub(super) fn row_count(rows: u128) -> Result<u64> {
    let count = u64::try_from(rows).ok().filter(|n| *n <= MOST_ROWS);
    count.ok_or_else(|| {
        let rows = rows.to_string();
        SweepError::TooManyRows { rows }.into()
    })
}

fn parent(key: &str) -> String {
    key.rsplit_once('.').map_or(key, |p| p.0).to_string()
}

fn trial_values(axis: &Axis) -> Vec<AxisValue> {
    match (&axis.values, axis.count()) {
        (Values::Words(_) | Values::Numbers(_), Some(n)) => {
            (0..n.min(TRIED_VALUES)).map(|i| axis.value(i)).collect()
        }
        // The permitted numbers of each key form an interval. If the first and the last value are valid, all values between them are valid.
        _ => vec![axis.sampled(0.0), axis.sampled(1.0)],
    }
}

#[cfg(test)]
mod tests;
