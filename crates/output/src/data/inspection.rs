//! Inspection of a measured cam as JSON, and the table of its deviations.

use gaitcam::cam::{Deviation, Inspection};
use gaitcam::drive::Drive;
use gaitcam::sweep::{Behaviour, Field, MadeCam, Records};
use gaitcam::synth::Design;
use serde_json::{Value, json};

/// `inspection.json`: fitted position, deviations, and behaviour of the machine with the cam as designed and as manufactured. `lines`
/// contains the line number of each point in the file of measured points.
pub fn json(
    design: &Design,
    inspected: &Inspection,
    made: Option<&MadeCam>,
    lines: &[usize],
) -> Value {
    let [least, most] = inspected.extremes().map_or([None; 2], |e| e.map(Some));
    let place =
        |d: Option<Deviation>| d.map(|d| json!({"deviation_m": d.normal, "at_rad": d.theta}));
    let drive = &design.problem.drive;
    let outliers = inspected.deviations.iter().filter(|d| d.is_outlier);
    let outlier =
        |d: &Deviation| json!({"line": lines[d.row], "deviation_m": d.normal, "at_rad": d.theta});
    json!({
        "name": design.problem.name,
        "points": inspected.deviations.len(),
        "turn_rad": inspected.turn,
        "centre_m": inspected.centre,
        "fits_as_well_rad": inspected.alike,
        "deviation": {"rms_m": inspected.rms(), "min": place(least), "max": place(most)},
        "outliers": outliers.map(outlier).collect::<Vec<Value>>(),
        "unmeasured_rad": inspected.unmeasured,
        "waves": made.map(|m| m.waves),
        "left_m": made.map(|m| m.left),
        "designed": made.map(|m| behaviour(&m.designed, drive)),
        "made": made.map(|m| behaviour(&m.made, drive)),
    })
}

fn behaviour(b: &Behaviour, drive: &Drive) -> Value {
    let newtons = |force: f64| drive.newtons(force);
    json!({
        "force_rms_error_n": b.rms_error_n.map(newtons),
        "force_max_error_n": b.max_error_n.map(newtons),
        "force_min_n": newtons(b.min_n),
        "force_max_n": newtons(b.max_n),
        "acceleration_max": b.acceleration,
        "liftoff_speed_rad_per_s": b.liftoff_speed,
    })
}

/// `inspection.csv`: line number, cam angle and deviation of each point, in the order of the cam angles.
pub fn table(inspected: &Inspection, lines: &[usize]) -> Records {
    let column = |name: &str, of: &dyn Fn(&Deviation) -> f64| {
        Field::numbers(name, inspected.deviations.iter().map(of).collect())
    };
    let fields = vec![
        column("line", &|d| lines[d.row] as f64),
        column("theta_rad", &|d| d.theta),
        column("deviation_m", &|d| d.normal),
    ];
    Records { fields }
}
