//! Chart (f): effect of including the motor in the design of a law.

use super::Watch;
use crate::chart::Chart;
use gaitcam::error::Result;
use gaitcam::scene::built_in;

/// Inertias of the flywheel, kg m².
const WHEELS: [&str; 4] = ["0.5", "1", "2", "8"];

/// Chart of laws for constant speed and laws for the motor, both simulated with the motor, for several flywheels.
pub fn chart(watch: &Watch) -> Result<Chart> {
    let mut rows = Vec::new();
    for (method, shaft) in [
        ("law for constant speed", "constant"),
        ("law for its motor", "motor"),
    ] {
        for wheel in WHEELS {
            let scene = (built_in("footbridge")?.scene()?)
                .with("machine.inertia", &format!("{wheel} kg m^2"))?
                .with("machine.motor.slope", "10 N m s/rad")?
                .with("law.shaft", shaft)?;
            let (design, timing) = watch.time(|| scene.design());
            let shaft_of = design?.shaft;
            let error = shaft_of.as_ref().and_then(|s| s.force_time);
            let mut row = timing.row(
                method,
                format!("{wheel} kg m²"),
                error.map_or(f64::NAN, |e| 0.01 * e.rms_error_percent_of_mean),
            );
            row.default = shaft == "motor";
            if let Some(s) = shaft_of {
                row.note = format!("speed ripples by {:.0} %", 100.0 * s.shaft.ripple);
            }
            rows.push(row);
        }
    }
    Ok(Chart {
        file: "speed_accuracy_f".to_string(),
        title: "(f) A shaft with its motor".to_string(),
        task: "Footbridge force, a motor whose torque decreases by 10 N·m per rad/s, flywheels of 0.5 to 8 kg m²: force on the shaft with this motor.".to_string(),
        error: "RMS force error over time, part of the mean".to_string(),
        levels: vec![(0.005, "0.5 %".to_string())],
        advice: "Give motor and inertia if the speed varies. The law for the motor has a force error below 0.4 % with every flywheel. The law for constant speed has an error of 1 % with a flywheel of 8 kg m², and of 6 % with 0.5 kg m².".to_string(),
        rows,
        ..Chart::default()
    })
}
