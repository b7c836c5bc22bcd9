//! `gaitcam gait`: what a recording holds, and its mean cycle.

use std::path::Path;

use super::{BAD_INPUT, BUILT, GaitArgs, files, input, say};
use crate::error::{Error, Place, Result};
use crate::gait::{self, Feet, ReadOptions};
use crate::units::{Dimension, parse};

/// Describes every file; the exit code is 2 when one of them holds no cycle.
pub fn run(args: &GaitArgs) -> Result<u8> {
    if args.out.is_some() && args.files.len() > 1 {
        return Err(Error::argument(
            "--out",
            "one curve file cannot hold the cycles of several recordings",
        )
        .help("give one recording at a time"));
    }
    let feet: Feet = args
        .feet
        .parse()
        .map_err(|e: Error| e.at(Place::Argument("--feet".to_string())))?;
    let mut code = BUILT;
    let mut objects = Vec::new();
    for path in &args.files {
        match describe(args, path, feet) {
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

fn describe(args: &GaitArgs, path: &Path, feet: Feet) -> Result<Described> {
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
    let recording = gait::read(path, &bytes, &options)?;
    drop(bytes);
    let stances = gait::stances(&recording);
    let cycle =
        gait::cycle(&recording, &stances, feet).map_err(|e| e.at(Place::File(path.to_path_buf())));
    let shown = cycle.as_ref().map_err(ToString::to_string);
    let text = format!(
        "{}\n{}",
        path.display(),
        gait::table(
            &recording,
            &stances,
            shown.as_ref().map_err(String::as_str).copied()
        )
    );
    let object = gait::json(&recording, &stances, cycle.as_ref().ok());
    if let (Some(out), Ok(cycle)) = (&args.out, &cycle) {
        let from = format!("mean cycle of {}", path.display());
        files::write_whole(
            out,
            gait::csv(&cycle.curve, &[&from, &cycle.how]).as_bytes(),
        )?;
    }
    Ok(Described {
        text,
        object,
        fault: cycle.err(),
    })
}
