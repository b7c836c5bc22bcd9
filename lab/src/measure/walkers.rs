//! Chart (g): number of walkers that a cam is designed for.

use super::Watch;
use crate::chart::Chart;
use gaitcam::cover::served_by;
use gaitcam::error::Result;
use gaitcam::scene::{Scene, built_in};

/// Number of walkers for the comparison of all cams, at equal steps of the step frequency within the range.
const JUDGED: usize = 41;

fn scene(robust: &str, walkers: usize) -> Result<Scene> {
    (built_in("footbridge")?.scene()?)
        .with("law.robust", robust)?
        .with("gait.step_frequency", &format!("1.4 Hz:2.4 Hz:{walkers}"))
}

/// Chart of cams for few and many walkers, compared by their objective over all walkers.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let none = || crate::fault("a range of step frequencies has walkers");
    let mut rows = Vec::new();
    for (method, robust) in [("least mean error", "mean"), ("least worst error", "worst")] {
        let judged = scene(robust, JUDGED)?;
        let all = judged.model_force()?.ok_or_else(none)?;
        for count in [2, 3, 5, 9, 17, 33] {
            let known = scene(robust, count)?;
            let (design, timing) = watch.time(|| known.design());
            let served = served_by(&judged, &[design?], &all)?;
            let errors = || served.iter().map(|s| 0.01 * s.error.rms_error_percent);
            let error = match robust {
                "worst" => errors().fold(0.0, f64::max),
                _ => errors().sum::<f64>() / served.len() as f64,
            };
            let row = timing.row(method, format!("{count} walkers"), error);
            rows.push(row);
        }
    }
    Ok(Chart {
        file: "speed_accuracy_g".to_string(),
        title: "(g) One cam for many walkers".to_string(),
        task: format!(
            "Young's force at 1.4 to 2.4 steps per second: cams for 2 to 33 walkers at equal steps of the range, evaluated for {JUDGED} walkers."
        ),
        error: "mean or largest RMS force error of the walkers, as it is minimised, part of the mean force".to_string(),
        advice: "Design for nine walkers of a range. More walkers do not change the maximum error. With 33 walkers the mean error is 4 % smaller, but the time is at least twice as long.".to_string(),
        rows,
        ..Chart::default()
    })
}
