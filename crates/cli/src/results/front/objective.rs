//! Objectives: names in flags and for display.

use crate::console::words;
use crate::input::at_flag;
use gaitcam::error::Result;
use gaitcam::sweep::Objective;
use gaitcam_output::sweep_plots::unit_for_people;

/// Objectives of both flags, or the default ones without flags.
pub fn of_flags(
    minimise: Option<&str>,
    maximise: Option<&str>,
    names: &[String],
) -> Result<Vec<Objective>> {
    let usual = Objective::usual().join(",");
    let minimise = match (minimise, maximise) {
        (None, None) => Some(usual.as_str()),
        (given, _) => given,
    };
    let mut out = Vec::new();
    for (flag, list, maximised) in [
        ("--minimise", minimise, false),
        ("--maximise", maximise, true),
    ] {
        for name in list.into_iter().flat_map(|list| list.split(',')) {
            out.push(Objective::of(name, maximised, names).map_err(at_flag(flag))?);
        }
    }
    Ok(out)
}

/// Name of an objective with its customary unit.
pub fn label(objective: &Objective) -> String {
    unit_for_people(&words::column(&objective.name)).0
}

/// Cost in its customary unit as text.
pub fn shown(objective: &Objective, cost: f64) -> String {
    let unit = unit_for_people(&words::column(&objective.name)).1;
    words::number(unit * objective.value(cost))
}
