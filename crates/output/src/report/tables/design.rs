//! Tables of the design: law, drive, cam, loads and load factors.

use std::fmt::Write;

use super::{Rows, cells, row, table};
use crate::facts::{Group, facts};
use crate::report::heading;
use crate::words::Words;
use gaitcam::drive::DriveKind;
use gaitcam::synth::Design;
use gaitcam_base::text::escaped;

/// Writes the tables of the design: law, drive, cam, loads and load factors.
pub fn numbers(out: &mut String, synthesis: &Design, words: &Words) {
    heading(out, &words.text("report-data"));
    out.push_str("<div class=\"columns\">\n");
    for group in Group::ALL {
        let facts = facts(synthesis, group, words.language());
        let rows: Rows = facts.into_iter().map(|f| (f.name, f.value)).collect();
        if !rows.is_empty() {
            table(out, words, heading_of(group), &rows);
        }
    }
    if synthesis.problem.drive.kind == DriveKind::MovingAxis {
        load_factors(out, synthesis, words);
    }
    out.push_str("</div>\n");
}

fn heading_of(group: Group) -> &'static str {
    match group {
        Group::Law => "report-law",
        Group::Drive => "report-drive",
        Group::Cam => "report-cam",
        Group::Machine => "report-loads",
    }
}

/// Load factor below which its phase is not displayed.
const LEAST_FACTOR: f64 = 5e-5;

/// Writes the harmonics of the target and the achieved force as fractions of the weight. Codes for footbridges use the same definition.
fn load_factors(out: &mut String, synthesis: &Design, words: &Words) {
    let all = synthesis.load_factors();
    if all.is_empty() {
        return;
    }
    let weight = synthesis
        .problem
        .weight_n
        .unwrap_or(synthesis.force.target_mean_n);
    let weight = words.number(synthesis.problem.drive.newtons(weight));
    let name = escaped(&words.fill("report-load-factors", &[("weight", &weight)]));
    let _ = write!(out, "<div><h3>{name}</h3><table><tr>");
    let heads = [
        "report-harmonic",
        "report-frequency",
        "report-factor-target",
        "report-factor-achieved",
    ];
    for head in heads {
        let _ = write!(out, "<th scope=\"col\">{}</th>", escaped(&words.text(head)));
    }
    out.push_str("</tr>\n");
    for f in &all {
        row(out, &format!("{}", f.of_step));
        let angled = |factor: f64, phase: f64| {
            if factor < LEAST_FACTOR {
                return words.fixed(factor, 4);
            }
            // −180° is shown as 180°.
            let phase = if phase.to_degrees() < -179.95 {
                -phase
            } else {
                phase
            };
            format!("{} ∠ {}", words.fixed(factor, 4), words.degrees(phase))
        };
        let frequency = format!("{} Hz", words.number(f.frequency_hz));
        let target = angled(f.target, f.target_phase_rad);
        let achieved = angled(f.achieved, f.achieved_phase_rad);
        cells(out, &[frequency, target, achieved]);
    }
    out.push_str("</table></div>\n");
}
