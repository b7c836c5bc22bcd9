//! `gaitcam compare`: several results side by side.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::exit_code::BUILT;
use crate::input::files::read_bytes;
use crate::result_folder::settle;
use crate::terminal::{print, print_json};
use gaitcam::error::{Error, Result};
use gaitcam_output::folder::Folder;
use gaitcam_output::overlay::{Strip, diagrams_over, profiles};

/// Which results.
#[derive(Args, Debug)]
pub struct CompareArgs {
    /// Folders that gaitcam synth wrote
    #[arg(required = true, num_args = 2..)]
    folders: Vec<PathBuf>,
    /// Folder for the table and the diagrams
    #[arg(long, value_name = "DIR", default_value = "out/compare")]
    out: PathBuf,
    /// Print the summaries as JSON
    #[arg(long)]
    pub json: bool,
}

/// One result read back.
struct Design {
    name: String,
    folder: PathBuf,
    summary: Value,
    law: Columns,
    profile: Columns,
}

impl Design {
    /// Whether the cam slides, so that its θ is metres of travel.
    fn slides(&self) -> bool {
        self.summary["cam"]["follower"] == "translating-cam"
    }

    /// From θ to what is drawn to the right: degrees, or mm.
    fn across(&self) -> f64 {
        if self.slides() {
            1e3
        } else {
            1f64.to_degrees()
        }
    }
}

/// A table of numbers by column; empty fields are NaN.
struct Columns {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Columns {
    fn read(path: &Path) -> Result<Columns> {
        let bytes = read_bytes(path)?;
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        let broken = |line: usize, what: String| {
            Error::line(path, line, what).help("write it again with gaitcam synth")
        };
        let names = reader
            .headers()
            .map_err(|e| broken(1, e.to_string()))?
            .iter()
            .map(str::to_string)
            .collect();
        let mut rows = Vec::new();
        for (i, record) in reader.records().enumerate() {
            let record = record.map_err(|e| broken(i + 2, e.to_string()))?;
            let row = record
                .iter()
                .map(|x| {
                    if x.is_empty() {
                        Ok(f64::NAN)
                    } else {
                        x.parse()
                    }
                })
                .collect::<std::result::Result<Vec<f64>, _>>()
                .map_err(|_| broken(i + 2, "holds a field that is no number".to_string()))?;
            rows.push(row);
        }
        Ok(Columns { names, rows })
    }

    /// (θ times `across`, value times `factor`) of the column whose name starts with `prefix`.
    fn curve(&self, prefix: &str, across: f64, factor: f64) -> Vec<(f64, f64)> {
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

fn read(folder: &Path) -> Result<Design> {
    settle(folder);
    let path = folder.join("summary.json");
    let summary: Value = serde_json::from_slice(&read_bytes(&path)?)
        .map_err(|e| Error::line(&path, e.line(), format!("is not JSON ({e})")))?;
    if summary["outcome"] == "infeasible" {
        return Err(
            Error::file(&path, "holds no cam: its outcome is infeasible")
                .help("relax its limits as the summary says, or leave it out"),
        );
    }
    let name = summary["name"].as_str().unwrap_or("cam").to_string();
    Ok(Design {
        name,
        folder: folder.to_path_buf(),
        summary,
        law: Columns::read(&folder.join("law.csv"))?,
        profile: Columns::read(&folder.join("profile.csv"))?,
    })
}

/// Rows of the slate: heading, keys into summary.json, factor, decimals.
const SLATE: [(&str, [&str; 2], f64, usize); 15] = [
    ("RMS error, N", ["force", "rms_error_n"], 1.0, 4),
    (
        "RMS error, % of mean",
        ["force", "rms_error_percent_of_mean"],
        1.0,
        3,
    ),
    ("largest error, N", ["force", "max_error_n"], 1.0, 3),
    ("smallest force, N", ["force", "min_n"], 1.0, 2),
    ("largest force, N", ["force", "max_n"], 1.0, 2),
    ("mass, kg", ["drive", "mass_kg"], 1.0, 3),
    ("speed, rad/s", ["drive", "speed_rad_per_s"], 1.0, 4),
    ("stroke, mm (mrad)", ["law", "stroke_m"], 1e3, 3),
    ("largest a, mm/rad²", ["law", "a_max_m_per_rad2"], 1e3, 3),
    ("largest j, mm/rad³", ["law", "j_max_m_per_rad3"], 1e3, 3),
    ("base radius, mm", ["cam", "base_radius_m"], 1e3, 3),
    ("smallest convex radius, mm", ["cam", "rho_min_m"], 1e3, 3),
    (
        "largest pressure angle, °",
        ["cam", "pressure_angle_max_rad"],
        180.0 / std::f64::consts::PI,
        2,
    ),
    ("face width, mm", ["cam", "face_width_m"], 1e3, 3),
    ("solved in, ms", ["solver", "solve_s"], 1e3, 3),
];

/// Prints the slate and writes it with overlaid diagrams.
pub fn run(args: &CompareArgs) -> Result<u8> {
    let mut designs = args
        .folders
        .iter()
        .map(|f| read(f))
        .collect::<Result<Vec<Design>>>()?;
    // Equal names are told apart by their folders.
    let all: Vec<String> = designs.iter().map(|d| d.name.clone()).collect();
    for d in &mut designs {
        if all.iter().filter(|n| **n == d.name).count() > 1 {
            d.name = d.folder.display().to_string();
        }
    }
    let folder = Folder::open(&args.out)?;
    let names: Vec<String> = designs.iter().map(|d| d.name.clone()).collect();
    let across = match designs.iter().filter(|d| d.slides()).count() {
        0 => "cam angle θ, degrees",
        n if n == designs.len() => "travel of the cam x, mm",
        _ => "cam angle θ, degrees; of a sliding cam its travel, mm",
    };
    let mut pictures = vec![
        (
            "compare_svaj",
            diagrams_over(
                across,
                "Laws",
                "lift and its derivatives",
                &names,
                &laws(&designs),
            ),
        ),
        (
            "compare_profiles",
            profiles("Profiles", "at one scale", &names, &outlines(&designs)),
        ),
    ];
    let forces = Strip {
        quantity: "force, N".to_string(),
        curves: designs
            .iter()
            .map(|d| d.law.curve("force_n", d.across(), 1.0))
            .collect(),
    };
    pictures.push((
        "compare_force",
        diagrams_over(across, "Forces", "of every cam", &names, &[forces]),
    ));
    for (name, picture) in &pictures {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        folder.write(&format!("{name}.png"), &picture.png())?;
    }
    let table = slate(&designs);
    folder.write("compare.md", table.as_bytes())?;
    if args.json {
        let list: Vec<Value> = designs
            .iter()
            .map(|d| json!({ "folder": d.folder.display().to_string(), "summary": d.summary }))
            .collect();
        print_json(&list.into());
    } else {
        print(&table);
        print(&format!("Diagrams in {}", folder.path().display()));
    }
    Ok(BUILT)
}

fn slate(designs: &[Design]) -> String {
    let mut rows = vec![
        [
            vec![String::new()],
            designs.iter().map(|d| d.name.clone()).collect(),
        ]
        .concat(),
        std::iter::repeat_n("---".to_string(), designs.len() + 1).collect(),
    ];
    for (heading, key) in [("verdict", "verdict"), ("outcome", "outcome")] {
        let word = |d: &Design| d.summary[key].as_str().unwrap_or("—").to_string();
        rows.push(
            [
                vec![heading.to_string()],
                designs.iter().map(word).collect(),
            ]
            .concat(),
        );
    }
    for (heading, group) in [
        ("law", ["law", "family"]),
        ("follower", ["cam", "follower"]),
    ] {
        let word = |d: &Design| {
            d.summary[group[0]][group[1]]
                .as_str()
                .unwrap_or("—")
                .to_string()
        };
        rows.push(
            [
                vec![heading.to_string()],
                designs.iter().map(word).collect(),
            ]
            .concat(),
        );
    }
    for (heading, [group, key], factor, decimals) in SLATE {
        let value = |d: &Design| {
            d.summary[group][key]
                .as_f64()
                .map_or("—".to_string(), |x| format!("{:.decimals$}", factor * x))
        };
        rows.push(
            [
                vec![heading.to_string()],
                designs.iter().map(value).collect(),
            ]
            .concat(),
        );
    }
    rows.iter()
        .map(|r| format!("| {} |\n", r.join(" | ")))
        .collect()
}

/// Lift to jerk; arms in degrees in the same strips.
fn laws(designs: &[Design]) -> Vec<Strip> {
    let arm = |d: &Design| d.law.names.iter().any(|n| n == "s_rad");
    let mixed = if designs.iter().any(arm) {
        "mm (°)"
    } else {
        "mm"
    };
    ["s_", "v_", "a_", "j_"]
        .into_iter()
        .zip(["", "/rad", "/rad²", "/rad³"])
        .map(|(column, per)| Strip {
            quantity: format!("{}, {mixed}{per}", &column[..1]),
            curves: designs
                .iter()
                .map(|d| {
                    let lift = if arm(d) { 1f64.to_degrees() } else { 1e3 };
                    d.law.curve(column, d.across(), lift)
                })
                .collect(),
        })
        .collect()
}

fn outlines(designs: &[Design]) -> Vec<Vec<[f64; 2]>> {
    designs
        .iter()
        .map(|d| {
            let mut points: Vec<[f64; 2]> = d.profile.rows.iter().map(|r| [r[1], r[2]]).collect();
            // A disc's curve closes on its first point; a straight cam stays open.
            let turning = d.summary["cam"]["follower"] != "translating-cam"
                && d.summary["cam"]["follower"] != "barrel";
            if let (true, Some(&first)) = (turning, points.first()) {
                points.push(first);
            }
            points
        })
        .collect()
}
