//! Scene files for the cams of a set.

use super::CYCLES;
use gaitcam::cover::Cover;
use gaitcam::error::Result;
use gaitcam::force::Walker;
use gaitcam::scene::set_value;
use gaitcam_app::design::{law_of_cam, scene_of_cover};
use gaitcam_app::{Input, ResultFolder};

/// Writes one scene per cam. Each scene excludes the walkers that are assigned to other cams.
pub(super) fn write_scenes(
    folder: &ResultFolder,
    input: &mut Input,
    cover: &Cover,
    walkers: &[Walker],
) -> Result<()> {
    for cam in 0..cover.cams.len() {
        let mut table = input.whole.clone();
        let served = |w: &&Walker| {
            cover
                .each
                .iter()
                .any(|a| a.cam == cam && a.error.walker == w.name)
        };
        let mut out: Vec<String> = walkers
            .iter()
            .filter(|w| !served(w))
            .map(|w| w.name.clone())
            .collect();
        out.dedup();
        let name = format!("{}_{}_{}", input.scene.name, cover.cams.len(), cam + 1);
        let own = [
            ("name", name.into()),
            ("gait.file", format!("../{CYCLES}").into()),
            ("gait.leave_out", out.into()),
        ];
        for (key, value) in own.into_iter().chain(law_of_cam(cover, cam)) {
            set_value(&mut table, key, value)?;
        }
        let text = toml::to_string(&table).unwrap_or_default();
        folder.write(&scene_of_cover(cover.cams.len(), cam + 1), text.as_bytes())?;
    }
    Ok(())
}
