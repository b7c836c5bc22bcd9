//! `gaitcam compare`: comparison of several results.

mod read;
mod table;

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};

use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::lengths::LengthArgs;
use crate::console::terminal::{print, print_json};
use crate::console::words;
use gaitcam::cam::{Unit, Verdict};
use gaitcam::error::Result;
use gaitcam_app::folder::Folder;
use gaitcam_output::Picture;
use gaitcam_output::overlay::{Strip, diagrams_over, profiles};
use gaitcam_output::sweep_report::{self, Page};
use read::Design;

/// A picture of the page, as a tuple: file name without ending, heading, picture.
type Drawn = (&'static str, String, Picture);

const EXAMPLES: &str = "Examples:
  gaitcam compare out/footbridge out/heel
  gaitcam compare out/a out/b out/c --out out/three
  gaitcam compare out/a out/b --json";

/// Arguments of `gaitcam compare`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct CompareArgs {
    /// Output folders of gaitcam synth
    #[arg(required = true, num_args = 2..)]
    folders: Vec<PathBuf>,
    /// Folder for the table and the diagrams
    #[arg(long, value_name = "DIR", default_value = "out/compare")]
    out: PathBuf,
    #[command(flatten)]
    lengths: LengthArgs,
    /// Print the summaries as JSON
    #[arg(long)]
    pub json: bool,
}

/// Prints the table, and writes it together with overlaid diagrams. The exit code is 3 if a design is unacceptable.
pub fn run(args: &CompareArgs) -> Result<u8> {
    args.lengths.units.display();
    let mut designs = args
        .folders
        .iter()
        .map(|f| Design::read(f))
        .collect::<Result<Vec<Design>>>()?;
    // Results with equal names are distinguished by their folders.
    let all: Vec<String> = designs.iter().map(|d| d.name.clone()).collect();
    for d in &mut designs {
        if all.iter().filter(|n| **n == d.name).count() > 1 {
            d.name = d.folder.display().to_string();
        }
    }
    let folder = Folder::open(&args.out)?;
    let drawn = pictures(&designs);
    for (name, _, picture) in &drawn {
        folder.write_picture(name, picture)?;
    }
    folder.write("compare.md", table::markdown(&designs).as_bytes())?;
    folder.write("compare.html", page(&designs, &drawn).as_bytes())?;
    if args.json {
        let list: Vec<Value> = designs
            .iter()
            .map(|d| json!({ "folder": d.folder.display().to_string(), "summary": d.summary }))
            .collect();
        print_json(&list.into());
    } else {
        print(&table::text(&designs));
        let place = folder.path().display().to_string();
        print(&words::fill("compare-diagrams", &json!({"folder": place})));
    }
    let unacceptable = |d: &Design| d.summary["verdict"] == Verdict::Unacceptable.name();
    let any = designs.iter().any(unacceptable);
    Ok(if any { NO_SUCH_CAM } else { BUILT })
}

/// HTML page with the table and the diagrams.
fn page(designs: &[Design], drawn: &[Drawn]) -> String {
    let names: Vec<&str> = designs.iter().map(|d| d.name.as_str()).collect();
    let title = words::fill("compare-title", &json!({"name": names.join(", ")}));
    let page = Page {
        title,
        pictures: drawn
            .iter()
            .map(|(_, heading, picture)| (heading.as_str(), picture))
            .collect(),
        tables: vec![(words::text("compare-figures"), table::table(designs))],
        ..Page::default()
    };
    sweep_report::html(&page, language::current())
}

fn pictures(designs: &[Design]) -> [Drawn; 3] {
    let names: Vec<String> = designs.iter().map(|d| d.name.clone()).collect();
    let across = match designs.iter().filter(|d| d.slides()).count() {
        0 => "compare-over-angle",
        n if n == designs.len() => "compare-over-travel",
        _ => "compare-over-both",
    };
    let across = words::fill(across, &json!({"unit": Unit::length().name}));
    let [heads, lifts, profile, scale, force] = [
        "compare-laws",
        "compare-lifts",
        "compare-profiles",
        "compare-scale",
        "compare-forces",
    ]
    .map(words::text);
    let (forces, force_names) = forces(designs, &names);
    let laws = laws(designs);
    let outlines = outlines(designs);
    let language = language::current();
    [
        (
            "compare_svaj",
            heads.clone(),
            diagrams_over(&across, &heads, &lifts, &names, &laws, language),
        ),
        (
            "compare_profiles",
            profile.clone(),
            profiles(&profile, &scale, &names, &outlines, language),
        ),
        (
            "compare_force",
            force.clone(),
            diagrams_over(&across, &force, "", &force_names, &[forces], language),
        ),
    ]
}

/// Diagram with the forces of all cams and all different targets, and the names of the curves.
fn forces(designs: &[Design], names: &[String]) -> (Strip, Vec<String>) {
    let curve = |d: &Design, column| d.law.curve(column, d.across(), 1.0);
    let mut curves: Vec<_> = designs.iter().map(|d| curve(d, "force_n")).collect();
    let mut names = names.to_vec();
    for d in designs {
        let target = curve(d, "target_n");
        if !target.is_empty() && !curves[designs.len()..].contains(&target) {
            curves.push(target);
            names.push(words::fill("compare-target", &json!({"name": d.name})));
        }
    }
    let strip = Strip {
        quantity: words::text("compare-force"),
        curves,
    };
    (strip, names)
}

/// Diagrams of lift, velocity, acceleration and jerk. Lifts of oscillating followers are plotted in degrees in the same diagrams.
fn laws(designs: &[Design]) -> Vec<Strip> {
    let length = Unit::length();
    let mixed = if designs.iter().any(Design::swings) {
        format!("{} (°)", length.name)
    } else {
        length.name.to_string()
    };
    ["s_", "v_", "a_", "j_"]
        .into_iter()
        .zip(["", "/rad", "/rad²", "/rad³"])
        .map(|(column, per)| Strip {
            quantity: format!("{}, {mixed}{per}", &column[..1]),
            curves: designs
                .iter()
                .map(|d| {
                    let lift = if d.swings() {
                        1f64.to_degrees()
                    } else {
                        length.factor
                    };
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
            // The first point of a disc cam is repeated to close its curve. The curve of a translating or barrel cam stays open.
            let turning = d.summary["cam"]["follower"] != "translating-cam"
                && d.summary["cam"]["follower"] != "barrel";
            if let (true, Some(&first)) = (turning, points.first()) {
                points.push(first);
            }
            points
        })
        .collect()
}
