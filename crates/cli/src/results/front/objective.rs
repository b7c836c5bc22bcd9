//! Objectives of a front: parsing of the flags, names and values for display.

use crate::console::words;
use crate::input::at_flag;
use gaitcam::error::Result;
use gaitcam::sweep::Objective;
use gaitcam_output::sweep_plots::unit_for_people;

/// Objectives from the flags `--minimise` and `--maximise`, or the default objectives without these flags. `names` are the columns of the
/// table.
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

/// Name of an objective with the unit in which it is displayed.
pub fn label(objective: &Objective) -> String {
    unit_for_people(&words::column(&objective.name)).0
}

/// Value of an objective, computed from its cost, as text in the displayed unit.
pub fn shown(objective: &Objective, cost: f64) -> String {
    let unit = unit_for_people(&words::column(&objective.name)).1;
    words::number(unit * objective.value(cost))
}
