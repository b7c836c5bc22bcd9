//! Input scenes of the commands: a scene file, standard input or a built-in scene, with the changes from the command line.

pub mod made;
pub mod recordings;
pub mod searching;

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use toml::Table;

use crate::console::error::{CliError, NameFault};
use crate::console::internal;
use gaitcam::error::{Error, Placed, Result, SceneError};
use gaitcam::scene;
use gaitcam::units::{Dimension, parse as parse_quantity};
use gaitcam_app::read::read_standard_input;
use gaitcam_app::scene::{named, parse};
use gaitcam_app::{Disk, inputs};

pub use gaitcam_app::Input;
pub use gaitcam_app::read::not_csv;

/// Arguments of commands whose scene can be changed.
#[derive(Args, Debug, Default, Clone)]
pub struct SceneArgs {
    /// Scene file, name of a built-in scene (gaitcam scenes), or - for standard input; default footbridge
    pub scene: Option<PathBuf>,
    /// Change a value: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

impl SceneArgs {
    /// Arguments of commands whose scene cannot be changed.
    pub fn of(path: PathBuf) -> SceneArgs {
        let (scene, set) = (Some(path), Vec::new());
        SceneArgs { scene, set }
    }
}

/// Reads the scene (by default the built-in footbridge) and applies the changes.
pub fn scene(args: &SceneArgs) -> Result<Input> {
    completed(args, |table| table)
}

/// Reads the scene and applies the changes, as [`scene`] does. `complete` then adds keys whose values come from other arguments.
pub fn completed(args: &SceneArgs, complete: impl Fn(Table) -> Table) -> Result<Input> {
    let (mut table, files, file) = written(args)?;
    for change in &args.set {
        scene::set(&mut table, change).map_err(at_flag("--set"))?;
    }
    let table = complete(table);
    internal::keep(&table);
    let input = Input::new(table, files, file)?;
    // An unreadable folder is reported later, when its recordings are read.
    input
        .paths()
        .into_iter()
        .flatten()
        .for_each(|path| inputs::note(&path));
    Ok(input)
}

/// TOML table of a scene without the changes of `--set`, input files of the scene, and path of the scene file.
pub fn written(args: &SceneArgs) -> Result<(Table, Disk, Option<PathBuf>)> {
    let none = Disk::default;
    Ok(match &args.scene {
        None => (parse(scene::DEFAULT, None)?, none(), None),
        Some(path) if path == Path::new("-") => {
            (parse(&read_standard_input()?, None)?, none(), None)
        }
        Some(path) => {
            let (table, files) = named(path)?;
            (table, files, Some(path.clone()))
        }
    })
}

/// Returns a function that adds a flag to an error as the source of the error, unless the error already states its source.
pub fn at_flag(flag: &str) -> impl Fn(Error) -> Error {
    move |e| e.at_argument(flag)
}

/// Value of a flag with a unit, converted to SI; `None` if the flag is not given.
pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>> {
    text.map(|t| parse_quantity(t, dimension).map_err(at_flag(flag)))
        .transpose()
}

/// Positive value of a flag with a unit, converted to SI; `None` if the flag is not given.
pub fn positive(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>> {
    let value = quantity(flag, text, dimension)?;
    match (value, text) {
        (Some(x), Some(typed)) if x <= 0.0 => {
            let (typed, example) = (typed.to_string(), dimension.example().to_string());
            Err(SceneError::NotPositive { typed, example }.at_argument(flag))
        }
        _ => Ok(value),
    }
}

/// Parsed value of a flag; `None` if the flag is not given.
pub fn parsed<T: FromStr<Err = Error>>(flag: &str, text: Option<&str>) -> Result<Option<T>> {
    text.map(|t| t.parse().map_err(at_flag(flag))).transpose()
}

/// Folder for the results of a scene: `out` if given, otherwise `out/NAME` followed by `ending`, where NAME is the name of the scene.
pub fn result_folder(input: &Input, out: Option<&Path>, ending: &str) -> Result<PathBuf> {
    if let Some(out) = out {
        return Ok(out.to_path_buf());
    }
    let name = &input.scene.name;
    check_file_name(name)?;
    Ok(PathBuf::from("out").join(format!("{name}{ending}")))
}

/// Rejects a scene name that cannot be used as a file name.
fn check_file_name(name: &str) -> Result<()> {
    let fault = if name.trim().is_empty() {
        NameFault::Blank
    } else if name.starts_with('-') {
        NameFault::Dash
    } else if name.chars().any(|c| c.is_control() || is_invisible(c)) {
        NameFault::Control
    } else if name == "." || name == ".." || name.chars().any(|c| "/\\:*?\"<>|~".contains(c)) {
        NameFault::NotPlain
    } else {
        return Ok(());
    };
    let shown: String = name.escape_debug().take(60).collect();
    Err(CliError::SceneName { shown, fault }.at_key("name"))
}

/// Whether a character is invisible or changes the direction of text (Unicode bidirectional controls and similar).
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}
