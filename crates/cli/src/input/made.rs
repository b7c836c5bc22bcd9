//! A cam that is made, and the machine that it runs on.

use std::path::{Path, PathBuf};

use super::{Input, SceneArgs, at_flag, scene};
use crate::console::error::CliError;
use crate::input::searching;
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::scene::{Scene, set};
use gaitcam::synth::Design;
use gaitcam_files::design::{is_of_machine, put_on};

/// The scene of a cam, and the scene of the machine around it.
pub struct Made {
    /// What the cam was designed from.
    pub input: Input,
    /// The same, with the drive and machine that run it.
    pub running: Scene,
    /// Whether that is another machine than the one the cam was designed for.
    pub other_machine: bool,
}

impl Made {
    /// The cam that the arguments name. The changes of a scene are part of its design; those of a result (its folder or
    /// summary.json) are changes of the machine, since its cam is cut. `speed` runs either at another speed.
    ///
    /// # Errors
    /// A change of the cam of a result; otherwise as [`scene`].
    pub fn read(args: &SceneArgs, speed: Option<&str>) -> Result<Made> {
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
        if let Some(speed) = speed {
            // Quoted, so that a bare number is refused as on every other flag.
            set(&mut table, &format!("drive.speed={speed:?}")).map_err(at_flag("--speed"))?;
        }
        let of_speed = |e: Error| match &e.place {
            Place::Key(key) if speed.is_some() && key == "drive.speed" => {
                e.placed(Place::Argument("--speed".to_string()))
            }
            _ => e,
        };
        let running = Input::new(table, input.folder.clone(), None).map_err(of_speed)?;
        let running = running.scene;
        Ok(Made {
            other_machine: running != input.scene,
            running,
            input,
        })
    }

    /// The cam as designed, on the machine that runs it; and why there is no target at the speed of that machine.
    ///
    /// # Errors
    /// Faults of the scene, its force or the other drive.
    pub fn design(&self) -> Result<(Design, Option<Error>)> {
        let mut design = searching::design(&self.input)?;
        let missing = match self.other_machine {
            true => put_on(&mut design, &self.running)?,
            false => None,
        };
        Ok((design, missing))
    }
}

/// The summary of a result folder, or the path of a summary itself.
fn summary_of(path: &Path) -> Option<PathBuf> {
    if path.is_dir() {
        return Some(path.join("summary.json"));
    }
    (path.extension().is_some_and(|e| e == "json")).then(|| path.to_path_buf())
}
