//! `simulation.json`, `dynamics.csv` and the table of the console.

use gaitcam::cam::Measures;
use gaitcam::dynamics::{Model, Run, simulate};
use gaitcam_output::{Language, simulation};
use gaitcam_test_support::designed;

#[test]
fn the_files_of_a_simulation_have_the_documented_keys_and_columns() {
    let design = designed("footbridge");
    let mut run = Run::new(design.cam, design.drive, 1440);
    // Fast enough to lose contact, so that every key has a value.
    run.drive.speed *= 3.0;
    run.machine.restitution = 0.5;
    let out = simulate(&run, Model::Contact).unwrap();
    assert!(out.contact_lost);
    let json = simulation::json(&out);
    let keys: Vec<&String> = json.as_object().unwrap().keys().collect();
    assert_eq!(
        keys,
        [
            "model",
            "why",
            "contact_lost",
            "lost_fraction",
            "force",
            "torque",
            "liftoff_speed_rad_per_s",
            "settle_cycles",
            "details"
        ]
    );
    for key in ["min", "max", "rms_error_n"] {
        assert!(json["force"].get(key).is_some());
    }
    for key in ["min", "max", "mean", "rms"] {
        assert!(json["torque"][key].is_number());
    }
    let csv = simulation::csv(&out);
    assert!(csv.starts_with("theta_rad,contact_force_n,torque_nm,"));
    let rows = csv.lines().count() - 1;
    assert!(
        rows >= 1440 && rows.is_multiple_of(1440),
        "whole turns of 1440 rows: {rows}"
    );
    assert!(simulation::table(&out, Measures::Translating, Language::En).contains("lift-off"));
}
