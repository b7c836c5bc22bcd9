//! Chart (h): number of points of an electronic cam against the error of the controller.

use super::Watch;
use crate::chart::{Across, Chart};
use gaitcam::error::Result;
use gaitcam::scene::built_in;
use gaitcam_cad::ecam::{Dialect, make};

/// Chart of every dialect with few and many points.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let design = built_in("footbridge")?.scene()?.design()?;
    let chosen = Dialect::ALL.map(|dialect| make(&design, dialect, None).map(|cam| cam.intervals));
    let mut rows = Vec::new();
    for (dialect, chosen) in Dialect::ALL.into_iter().zip(chosen) {
        let chosen = chosen?;
        let mut counts = vec![12, 24, 48, 96, 192, 384, 768, 1536, chosen];
        counts.sort_unstable();
        counts.dedup();
        for count in counts {
            let (cam, timing) = watch.time(|| make(&design, dialect, Some(count)));
            // Too few points are rejected, and so are so many points that the rounding of numbers distorts the force.
            let Ok(cam) = cam else { continue };
            let mut row = timing.row(
                dialect.name(),
                format!("{count} intervals"),
                cam.replayed.share,
            );
            row.points = Some(count);
            row.default = count == chosen;
            rows.push(row);
        }
    }
    Ok(Chart {
        file: "speed_accuracy_h".to_string(),
        title: "(h) Electronic cams".to_string(),
        task: "The law of the default design as a file for five controllers, evaluated in the number format of each controller. Numbers of points with a too large force error are rejected and not drawn.".to_string(),
        error: "RMS force added by the controller, part of the mean".to_string(),
        across: Across::Points,
        levels: vec![(1e-4, "0.01 %".to_string())],
        advice: "Use the automatic number of points. A controller with quintics reproduces this law exactly with its eight spans; a controller with cubic splines reproduces it to 0.01 % with 128 points. More points are worse if numbers are rounded, and points that are not ends of spans reduce the accuracy.".to_string(),
        rows,
    })
}
