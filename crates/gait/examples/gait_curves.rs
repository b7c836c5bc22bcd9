//! Writes the built-in force cycles to a folder: `gait_curves data/gait_curves`.
//!
//! Each cycle is a load model of the catalogue. Comments in the file state its source and reliability.

use std::path::Path;

use gaitcam_gait::error::{Error, Result};
use gaitcam_gait::{Feet, catalogue, model};

/// File, model, step frequency (Hz), load (N) and feet of each curve.
pub const CURVES: &[(&str, &str, Option<f64>, f64, Feet)] = &[
    (
        "young_1.85Hz_700N.csv",
        "young",
        Some(1.85),
        700.0,
        Feet::Both,
    ),
    ("setra_2Hz_700N.csv", "setra", Some(2.0), 700.0, Feet::Both),
    (
        "li2010_1.9Hz_700N_one_foot.csv",
        "li-2010",
        Some(1.9),
        700.0,
        Feet::One,
    ),
    (
        "iso22675_one_foot.csv",
        "iso-22675",
        None,
        1000.0,
        Feet::One,
    ),
];

/// Text of one of the files.
pub fn text(name: &str, frequency: Option<f64>, load: f64, feet: Feet) -> Result<String> {
    let curve = model(name, frequency, load, feet)?;
    let found = catalogue().iter().find(|m| m.name == name);
    let info =
        found.ok_or_else(|| Error::own("no-model", format!("{name} is not in the catalogue")))?;
    let whose = if feet == Feet::Both {
        "both feet, one step"
    } else {
        "one foot, one stride, zero in swing"
    };
    let f = frequency.map_or(String::new(), |f| format!(", step frequency {f} Hz"));
    let lines = [
        format!("{whose}; load {load} N{f}"),
        format!("{}: {}", info.name, info.formula),
        format!("source: {}; status: {}", info.source, info.status.name()),
    ];
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    Ok(curve.to_csv(&lines))
}

fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "data/gait_curves".to_string());
    for (file, name, frequency, load, feet) in CURVES {
        std::fs::write(
            Path::new(&folder).join(file),
            text(name, *frequency, *load, *feet)?,
        )?;
    }
    Ok(())
}
