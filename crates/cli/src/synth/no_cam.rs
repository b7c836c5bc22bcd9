//! Output for a scene that has no cam.

use std::path::Path;
use std::time::Instant;

use serde_json::json;

use crate::console::exit_code;
use crate::console::language;
use crate::console::terminal::{print, print_json};
use crate::console::words;
use crate::input::Input;
use gaitcam::cam::Verdict;
use gaitcam::error::{Error, Result};
use gaitcam_app::ResultFolder;
use gaitcam_app::design;

/// Prints the reason why there is no cam and writes it to summary.json. Returns the exit code.
pub fn no_cam(
    as_json: bool,
    input: &Input,
    folder: Option<ResultFolder>,
    error: &Error,
    start: Instant,
) -> Result<u8> {
    let scene = input.resolved();
    let total_s = start.elapsed().as_secs_f64();
    let json = design::summary_without_cam(&input.scene.name, error, &scene, total_s);
    let place = match folder {
        Some(folder) => Some(design::finish(folder, input, &scene, &json)?),
        None => None,
    };
    if as_json {
        print_json(&json);
        return Ok(exit_code::NO_SUCH_CAM);
    }
    let verdict = words::name(Verdict::Unacceptable.name());
    let why = error.sentence(language::current());
    print(&format!("{}: {verdict}\n  {why}", input.scene.name));
    if let Some(place) = place {
        print(&files_in(&place, "summary.json"));
    }
    Ok(exit_code::NO_SUCH_CAM)
}

/// Sentence with the folder of the written files and the file to open first.
pub fn files_in(folder: &Path, first: &str) -> String {
    let first = folder.join(first).display().to_string();
    let folder = folder.display().to_string();
    words::fill("run-files", &json!({"folder": folder, "first": first}))
}
