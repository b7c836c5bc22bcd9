//! A designed cam and the machine in which it runs.

use std::path::{Path, PathBuf};

use super::{Input, SceneArgs, at_flag, scene};
use crate::console::error::CliError;
use crate::console::language;
use crate::input::searching;
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::scene::{Scene, set};
use gaitcam::synth::Outcome;
use gaitcam_app::design::{is_of_machine, put_on};

/// A command-line flag that sets a key of the machine.
pub struct Flag<'a> {
    /// Name of the flag with its dashes, such as `--friction`.
    pub name: &'static str,
    /// Key of the scene that the flag sets.
    pub key: &'static str,
    /// Value of the flag as typed by the user, with its unit.
    pub value: &'a str,
}

/// The scene of a cam, and the scene of the machine in which it runs.
pub struct CamInMachine {
    /// Scene from which the cam was designed.
    pub input: Input,
    /// The scene of the design with the drive and machine of this run.
    pub running: Scene,
    /// Whether the machine in this run differs from the machine of the design.
    pub other_machine: bool,
}

impl CamInMachine {
    /// Folder for files that are made from a design: the folder given by the user, otherwise the results folder of its scene.
    ///
    /// # Errors
    /// The name of the scene cannot be a file name.
    pub fn folder(&self, given: &Path) -> Result<PathBuf> {
        match given.is_dir() {
            true => Ok(given.to_path_buf()),
            false => super::result_folder(&self.input, None, ""),
        }
    }

    /// Reads the cam that the arguments specify. If they specify a scene, the changes of `--set` apply to its design. If they specify a
    /// result (its folder or summary.json), the changes apply to the machine, because the cam already exists. `flags` change the machine
    /// in both cases.
    ///
    /// # Errors
    ///
    /// A change of a result concerns the cam and not the machine. Otherwise as for [`scene`].
    pub fn read(args: &SceneArgs, flags: &[Flag]) -> Result<CamInMachine> {
        let result = args.scene.as_deref().and_then(summary_of);
        let on_machine: &[String] = if result.is_some() { &args.set } else { &[] };
        let input = match result {
            None => scene(args)?,
            Some(summary) => scene(&SceneArgs::of(summary))?,
        };
        let mut table = input.table.clone();
        for change in on_machine {
            let key = change.split('=').next().unwrap_or_default().trim();
            if !is_of_machine(key) {
                let key = key.to_string();
                return Err(CliError::CamIsMade { key }.at_argument("--set"));
            }
            set(&mut table, change).map_err(at_flag("--set"))?;
        }
        for Flag { name, key, value } in flags {
            // The value is quoted, so that a number without a unit is rejected as in a scene.
            set(&mut table, &format!("{key}={value:?}")).map_err(at_flag(name))?;
        }
        let of_flag = |e: Error| {
            let flag = |key: &String| flags.iter().find(|flag| flag.key == key);
            match &e.place {
                Place::Key(key) if flag(key).is_some() => {
                    let name = flag(key).map_or("", |flag| flag.name).to_string();
                    e.placed(Place::Argument(name))
                }
                _ => e,
            }
        };
        let running = Input::new(table, input.files.clone(), None).map_err(of_flag)?;
        let running = running.scene;
        let another = !on_machine.is_empty() || running.drive != input.scene.drive;
        Ok(CamInMachine {
            other_machine: another && running != input.scene,
            running,
            input,
        })
    }

    /// Sentence that states why a key has no effect in this run; `None` if the key has an effect.
    pub fn unused(&self, key: &str) -> Option<String> {
        let note = self.running.no_effect_of(key)?;
        Some(note.sentence(language::current()))
    }

    /// The designed cam in the machine of this run. The second value is the reason why the cam has no target at this speed; `None` if it
    /// has a target.
    ///
    /// # Errors
    ///
    /// The scene, its force or the drive of this run is invalid.
    pub fn design(&self) -> Result<(Outcome, Option<Error>)> {
        match searching::answer(&self.input)? {
            Outcome::Built(design) if self.other_machine => {
                let (design, missing) = put_on(*design, &self.running)?;
                Ok((Outcome::Built(Box::new(design)), missing))
            }
            outcome => Ok((outcome, None)),
        }
    }
}

/// Path of the summary in a result folder, or `path` itself if it is a JSON file.
fn summary_of(path: &Path) -> Option<PathBuf> {
    if path.is_dir() {
        return Some(path.join("summary.json"));
    }
    (path.extension().is_some_and(|e| e == "json")).then(|| path.to_path_buf())
}
