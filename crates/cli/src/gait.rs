//! `gaitcam gait`: what a recording holds, and its mean cycle.

use std::path::{Path, PathBuf};

use super::{BAD_INPUT, BUILT, GaitArgs, input, say};
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::{self, Feet, ReadOptions};
use gaitcam::units::{Dimension, parse};
use gaitcam::wording::Language;
use gaitcam_output as output;

/// Stances drawn in the picture; the mean is of all.
const DRAWN: usize = 60;

/// Describes every file; the exit code is 2 when one of them holds no cycle.
pub fn run(args: &GaitArgs) -> Result<u8> {
    let places = args
        .out
        .as_deref()
        .map(|out| places(out, &args.files))
        .transpose()?;
    let feet: Feet = args
        .feet
        .parse()
        .map_err(|e: Error| e.at(Place::Argument("--feet".to_string())))?;
    let mut code = BUILT;
    let mut objects = Vec::new();
    for (i, path) in args.files.iter().enumerate() {
        let place = places.as_ref().map(|p| p[i].as_path());
        match describe(args, path, place, feet) {
            Ok(Described {
                text,
                object,
                fault,
            }) => {
                if !args.json {
                    say(&text);
                }
                objects.push(object);
                if let Some(fault) = fault {
                    eprintln!("gaitcam: {fault}");
                    code = BAD_INPUT;
                }
            }
            Err(e) => {
                eprintln!("gaitcam: {e}");
                code = BAD_INPUT;
            }
        }
    }
    if args.json && !objects.is_empty() {
        let value = if objects.len() == 1 {
            objects.remove(0)
        } else {
            serde_json::Value::Array(objects)
        };
        say(&serde_json::to_string_pretty(&value).unwrap_or_default());
    }
    Ok(code)
}

struct Described {
    text: String,
    object: serde_json::Value,
    fault: Option<Error>,
}

fn describe(args: &GaitArgs, path: &Path, place: Option<&Path>, feet: Feet) -> Result<Described> {
    let quantity = |flag: &str, text: &Option<String>, dimension| {
        text.as_deref()
            .map(|t| parse(t, dimension).map_err(|e| e.at(Place::Argument(flag.to_string()))))
            .transpose()
    };
    let unit = args.unit.as_deref().map(|u| {
        u.parse()
            .map_err(|e: Error| e.at(Place::Argument("--unit".to_string())))
    });
    let options = ReadOptions {
        time: args.time.clone(),
        force: args.force.clone(),
        unit: unit.transpose()?,
        rate_hz: quantity("--rate", &args.rate, Dimension::Frequency)?,
        mass_kg: quantity("--mass", &args.mass, Dimension::Mass)?,
        metadata: input::metadata(path),
    };
    let bytes = input::read_bytes(path)?;
    if let Some(curve) = force::one_cycle(path, &bytes, &options)? {
        if let Some(place) = place {
            let from = format!("cycle of {}", path.display());
            gaitcam_output::folder::write_whole(place, force::csv(&curve, &[&from]).as_bytes())?;
        }
        return Ok(Described {
            text: format!(
                "{}\n{}",
                path.display(),
                force::cycle_table(&curve, Language::En)
            ),
            object: force::cycle_json(&curve),
            fault: None,
        });
    }
    let recording = force::read(path, &bytes, &options)?;
    drop(bytes);
    let stances = force::stances(&recording);
    let cycle =
        force::cycle(&recording, &stances, feet).map_err(|e| e.at(Place::File(path.to_path_buf())));
    let shown = cycle.as_ref().map_err(ToString::to_string);
    let text = format!(
        "{}\n{}",
        path.display(),
        force::table(
            &recording,
            &stances,
            shown.as_ref().map_err(String::as_str).copied(),
            Language::En
        )
    );
    let object = force::json(&recording, &stances, cycle.as_ref().ok());
    if let (Some(place), Ok(cycle)) = (place, &cycle) {
        let from = format!("mean cycle of {}", path.display());
        gaitcam_output::folder::write_whole(
            place,
            force::csv(&cycle.curve, &[&from, &cycle.source.to_string()]).as_bytes(),
        )?;
        if let Some(overlay) = force::overlay(&recording, &stances, DRAWN) {
            let name = path
                .file_name()
                .map_or_else(String::new, |n| n.to_string_lossy().into());
            let picture = output::recording::stances(&name, &overlay, cycle);
            gaitcam_output::folder::write_whole(
                &place.with_extension("svg"),
                picture.svg().as_bytes(),
            )?;
            gaitcam_output::folder::write_whole(&place.with_extension("png"), &picture.png())?;
        }
    }
    Ok(Described {
        text,
        object,
        fault: cycle.err(),
    })
}

/// Where each recording's mean cycle goes: the one file named, or `NAME_cycle.csv` in a folder.
///
/// The pictures stand beside it, with `.svg` and `.png` for `.csv`.
fn places(out: &Path, recordings: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let csv = out
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if !csv || out.is_dir() {
        let folder = gaitcam_output::folder::Folder::open(out)?;
        let mut places: Vec<PathBuf> = Vec::new();
        for recording in recordings {
            let stem = recording.file_stem().unwrap_or_default().to_string_lossy();
            // Recordings of one name from two folders are numbered.
            let numbered = (1..).map(|k| match k {
                1 => format!("{stem}_cycle.csv"),
                k => format!("{stem}_cycle_{k}.csv"),
            });
            let mut free = numbered.map(|name| folder.path().join(name));
            places.extend(free.find(|p| !places.contains(p)));
        }
        return Ok(places);
    }
    if recordings.len() > 1 {
        return Err(Error::argument(
            "--out",
            "one curve file cannot hold the cycles of several recordings",
        )
        .help("give a folder, or one recording at a time"));
    }
    let same =
        |p: &PathBuf| matches!((p.canonicalize(), out.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if recordings.iter().any(same) {
        return Err(
            Error::argument("--out", "the mean cycle would replace the recording itself")
                .help("give another name"),
        );
    }
    // As synth does: a folder that is not there yet is made.
    if let Some(folder) = out.parent().filter(|f| !f.as_os_str().is_empty()) {
        gaitcam_output::folder::Folder::open(folder)?;
    }
    Ok(vec![out.to_path_buf()])
}
