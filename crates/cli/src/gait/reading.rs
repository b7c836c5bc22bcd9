//! Reads, describes and writes one recording for `gaitcam gait`.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::language;
use crate::console::words;
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::force::{self, Cycle, Feet, Foot, ForceCurve, Interpretation, ReadOptions};
use gaitcam::scene::{BETWEEN_PLATES, content};
use gaitcam_app::Disk;
use gaitcam_app::disk::metadata;
use gaitcam_app::folder::write_whole;
use gaitcam_output as output;
use gaitcam_output::gait as tables;

/// Result of reading a recording.
#[derive(Default)]
pub(super) struct Read {
    /// Path of the recording, or paths of the files of its force plates.
    pub(super) paths: Vec<PathBuf>,
    /// Interpretation of the recording; `None` if the file contains exactly one cycle.
    pub(super) understood: Option<Interpretation>,
    /// Mean cycle of the recording; `None` if it cannot be computed.
    pub(super) cycle: Option<Cycle>,
    /// Cycle of a file that contains exactly one cycle; `None` for other files.
    pub(super) given: Option<ForceCurve>,
    /// Error because of which the recording has no cycle; `None` if it has one.
    pub(super) fault: Option<Error>,
    /// Description of the recording for the console.
    pub(super) text: String,
    pub(super) object: Value,
}

/// Reads one recording from its file, or from the files of its force plates. If `all` is set, the text lists every stance.
pub(super) fn read(options: ReadOptions, paths: &[PathBuf], feet: Feet, all: bool) -> Result<Read> {
    let path = paths[0].as_path();
    if path.extension().is_some_and(|e| e == "toml") {
        return Err(CliError::SceneNotRecording.in_file(path));
    }
    let options = ReadOptions {
        metadata: metadata(path),
        ..options
    };
    let shown = |path: &Path| path.display().to_string();
    let bytes = content(&Disk::default(), Path::new(&together(paths, shown)))?;
    let place = || Place::File(path.to_path_buf());
    let heading = together(paths, shown);
    if let Some(curve) = force::one_cycle(path, &bytes, &options, feet)? {
        let table = tables::cycle_table(&curve, language::current());
        return Ok(Read {
            paths: paths.to_vec(),
            text: format!("{heading}\n{table}"),
            object: tables::cycle_json(&curve),
            given: Some(curve),
            ..Read::default()
        });
    }
    let recording = force::read(path, &bytes, &options)?;
    drop(bytes);
    let stances = force::stances(&recording);
    let cycle = force::cycle(&recording, &stances, feet).map_err(|e| e.at(place()));
    let name = together(paths, |path: &Path| {
        let name = path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    });
    let mean = cycle.as_ref().ok();
    let understood = Interpretation::of(&name, &recording, &stances, mean, feet);
    // The reason for a rejection is printed only once, on standard error.
    let table = tables::table(
        &understood,
        &recording,
        &stances,
        cycle.as_ref().map_err(|_| ""),
        all,
        language::current(),
    );
    let table = table.trim_end();
    let object = tables::json(&understood, &recording, &stances, mean);
    let (cycle, fault) = match cycle {
        Ok(cycle) => (Some(cycle), None),
        Err(fault) => (None, Some(fault)),
    };
    Ok(Read {
        paths: paths.to_vec(),
        understood: Some(understood),
        cycle,
        fault,
        text: format!("{heading}\n{table}"),
        object,
        ..Read::default()
    })
}

/// Names of the files of a recording, joined by ` + `. `name` returns the name of one file.
pub(super) fn together(paths: &[PathBuf], name: impl Fn(&Path) -> String) -> String {
    let names = paths.iter().map(|path| name(path));
    names.collect::<Vec<_>>().join(BETWEEN_PLATES)
}

impl Read {
    /// Result for a recording that cannot be read.
    pub(super) fn failed(paths: &[PathBuf], fault: Error) -> Read {
        Read {
            paths: paths.to_vec(),
            fault: Some(fault),
            object: json!({"kind": null, "cycle": null}),
            ..Read::default()
        }
    }

    /// Paths of the files of the recording, joined by ` + `.
    pub(super) fn shown(&self) -> String {
        together(&self.paths, |path| path.display().to_string())
    }

    /// Cycle of the recording: the mean cycle or, for a file that contains exactly one cycle, this cycle.
    pub(super) fn curve(&self) -> Option<&ForceCurve> {
        let mean = self.cycle.as_ref().map(|c| &c.curve);
        mean.or(self.given.as_ref())
    }

    /// Writes the cycle. For a recording of several steps, a picture is also written, even if the recording has no mean cycle.
    pub(super) fn write(&self, place: &Path) -> Result<()> {
        if let Some(curve) = &self.given {
            let from = of_files("gait-cycle-of", &self.shown());
            write_cycle(place, curve, None, &[&from])?;
        }
        if let Some(cycle) = &self.cycle {
            let from = of_files("gait-mean-cycle-of", &self.shown());
            let feet = self.understood.as_ref().and_then(|u| u.feet.foot());
            let source = cycle.source.to_string();
            write_cycle(place, &cycle.curve, feet, &[&from, &source])?;
        }
        let Some(understood) = &self.understood else {
            return Ok(());
        };
        let curve = self.cycle.as_ref().map(|c| &c.curve);
        let picture = output::recording::recording(understood, curve, language::current());
        write_picture(place, &picture)
    }
}

/// Writes a cycle as CSV, or as an OpenSim file if its name ends in `.mot`.
pub(super) fn write_cycle(
    place: &Path,
    curve: &ForceCurve,
    foot: Option<Foot>,
    comments: &[&str],
) -> Result<()> {
    let is_mot = place
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("mot"));
    let text = match is_mot {
        true => curve.to_mot(foot, comments),
        false => curve.to_csv(comments),
    };
    write_whole(place, text.as_bytes())
}

/// Writes a picture as `.svg` and `.png`, with the path `place` apart from the ending.
pub(super) fn write_picture(place: &Path, picture: &output::Picture) -> Result<()> {
    write_whole(&place.with_extension("svg"), picture.svg().as_bytes())?;
    write_whole(&place.with_extension("png"), &picture.png())
}

/// Message `key` in which the file names replace the placeholder.
pub(super) fn of_files(key: &str, files: &str) -> String {
    words::fill(key, &json!({"file": files}))
}
