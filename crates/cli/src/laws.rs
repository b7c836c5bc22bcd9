//! `gaitcam laws`: the catalogue of rise laws.

use serde_json::json;

use super::{BUILT, say};
use gaitcam::error::Result;
use gaitcam::law::{Ends, Rise};

/// What the two ends can join, once where they agree.
fn joined(ends: &Ends) -> String {
    let (start, end) = (ends.start.joins(), ends.end.joins());
    if start == end {
        start.to_string()
    } else {
        format!("{start} → {end}")
    }
}

/// Prints the catalogue as a table, or as a list of objects.
pub fn run(as_json: bool) -> Result<u8> {
    let mut rows = Vec::new();
    for rise in Rise::catalogue() {
        let f = rise.factors()?;
        let ends = rise.ends()?;
        rows.push((rise.name().to_string(), f, ends));
    }
    if as_json {
        let finite = |x: f64| if x.is_finite() { json!(x) } else { json!(null) };
        let list: Vec<_> = rows
            .iter()
            .map(|(name, f, ends)| {
                json!({
                    "name": name,
                    "cv": finite(f.cv), "ca": finite(f.ca), "cj": finite(f.cj), "ct": finite(f.ct),
                    "v": [finite(f.v.0), finite(f.v.1)], "a": [finite(f.a.0), finite(f.a.1)], "j": [finite(f.j.0), finite(f.j.1)],
                    "joins": [ends.start.joins(), ends.end.joins()],
                    "continuity_with_dwell": [ends.start.continuity_with_dwell(), ends.end.continuity_with_dwell()],
                })
            })
            .collect();
        say(&serde_json::to_string_pretty(&list).unwrap_or_default());
        return Ok(BUILT);
    }
    say("Rise by 1 in time 1: peak velocity Cv, acceleration Ca, jerk Cj, torque Ct = max|a·v|");
    say(&format!(
        "{:<22} {:>9} {:>9} {:>10} {:>9}  joins",
        "law", "Cv", "Ca", "Cj", "Ct"
    ));
    for (name, f, ends) in rows {
        let jerk = if f.cj.is_finite() {
            format!("{:.4}", f.cj)
        } else {
            "∞".to_string()
        };
        say(&format!(
            "{name:<22} {:>9.5} {:>9.5} {jerk:>10} {:>9.5}  {}",
            f.cv,
            f.ca,
            f.ct,
            joined(&ends)
        ));
    }
    Ok(BUILT)
}
