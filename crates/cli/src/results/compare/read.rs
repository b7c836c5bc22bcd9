//! Reading of the files in a result folder.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::console::error::CliError;
use gaitcam::cam::Measures;
use gaitcam::error::{Placed, Result};
use gaitcam_app::result_folder;
use gaitcam_app::scene::not_json;

/// Files of one result of `synth`.
pub struct Design {
    /// Name of the design. If several designs have the same name, it is replaced by the name of the folder.
    pub name: String,
    /// Path of the result folder.
    pub folder: PathBuf,
    /// Content of summary.json as JSON.
    pub summary: Value,
    /// Columns of law.csv. They are empty for a result without a cam.
    pub law: Columns,
    /// Columns of profile.csv. They are empty for a result without a cam.
    pub profile: Columns,
}

impl Design {
    /// Reads a folder that `gaitcam synth` wrote.
    pub fn read(folder: &Path) -> Result<Design> {
        let path = folder.join("summary.json");
        let bytes = result_folder::read(folder, "summary.json")?;
        let summary: Value = serde_json::from_slice(&bytes).map_err(|e| not_json(&path, &e))?;
        // A result without a cam has no tables.
        let table = |name: &str| match summary["outcome"] == "infeasible" {
            true => Ok(Columns::default()),
            false => Columns::read(folder, name),
        };
        Ok(Design {
            name: summary["name"].as_str().unwrap_or("cam").to_string(),
            folder: folder.to_path_buf(),
            law: table("law.csv")?,
            profile: table("profile.csv")?,
            summary,
        })
    }

    /// Whether the cam translates, so that θ is a travel in metres.
    pub fn slides(&self) -> bool {
        self.summary["cam"]["follower"] == "translating-cam"
    }

    /// Whether the follower oscillates, so that its lift is an angle.
    pub fn swings(&self) -> bool {
        self.law.names.iter().any(|n| n == "s_rad")
    }

    /// Units of the design, from the motion of follower and cam (straight, oscillating or translating).
    pub fn measures(&self) -> Measures {
        match (self.slides(), self.swings()) {
            (true, _) => Measures::Straight,
            (false, true) => Measures::Oscillating,
            (false, false) => Measures::Translating,
        }
    }

    /// Whether the design has a target force.
    pub fn has_target(&self) -> bool {
        self.summary["force"]["target_mean_n"]
            .as_f64()
            .is_some_and(|mean| mean != 0.0)
    }

    /// Factor that converts θ to the unit of the horizontal axis: degrees, or the displayed unit of length.
    pub fn across(&self) -> f64 {
        self.measures().angle().factor
    }
}

/// Table of numbers with named columns. Empty fields are NaN.
#[derive(Default)]
pub struct Columns {
    /// Names of the columns, which end with their units.
    pub names: Vec<String>,
    /// Values of the table, row by row.
    pub rows: Vec<Vec<f64>>,
}

impl Columns {
    fn read(folder: &Path, name: &str) -> Result<Columns> {
        let (path, bytes) = (&folder.join(name), result_folder::read(folder, name)?);
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        let broken =
            |line: usize, fault: String| CliError::BrokenTable { fault }.at_line(path, line);
        let names = reader
            .headers()
            .map_err(|e| broken(1, e.to_string()))?
            .iter()
            .map(str::to_string)
            .collect();
        let mut rows = Vec::new();
        for (i, record) in reader.records().enumerate() {
            let record = record.map_err(|e| broken(i + 2, e.to_string()))?;
            let row = record.iter().map(number).collect::<Option<Vec<f64>>>();
            rows.push(row.ok_or_else(|| CliError::FieldNotNumber.at_line(path, i + 2))?);
        }
        Ok(Columns { names, rows })
    }

    /// Points of the column whose name starts with `prefix`: θ multiplied by `across`, and the value multiplied by `factor`.
    pub fn curve(&self, prefix: &str, across: f64, factor: f64) -> Vec<(f64, f64)> {
        let Some(k) = self.names.iter().position(|n| n.starts_with(prefix)) else {
            return Vec::new();
        };
        self.rows
            .iter()
            .filter(|r| r[k].is_finite())
            .map(|r| (across * r[0], factor * r[k]))
            .collect()
    }
}

fn number(field: &str) -> Option<f64> {
    if field.is_empty() {
        return Some(f64::NAN);
    }
    field.parse().ok()
}
