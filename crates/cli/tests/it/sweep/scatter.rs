//! One design, manufactured many times within tolerances.

use super::{refused, rows, sweep};
use crate::support::{object, stderr};

#[test]
fn scatter_of_no_width_is_the_design_and_wider_tolerances_cost_yield() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("t.csv");
    let run = |tolerance: &str| -> serde_json::Value {
        let output = sweep(
            &out,
            &[
                "--tolerance",
                tolerance,
                "--tolerance",
                "speed=0.5 %",
                "--sample",
                "2000",
                "--band",
                "1 %",
                "--json",
            ],
        );
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        object(&output)
    };
    let (narrow, wide) = (run("mass=0 %"), run("mass=3 %"));
    assert_eq!(narrow["yield"], 1.0);
    // 3 % of the mass miss the mean force by up to 3 %: two thirds of the cams leave a band of 1 %.
    let share = wide["yield"].as_f64().unwrap();
    assert!(share > 0.2 && share < 0.4, "{share}");
    assert_eq!(rows(&out).len(), 2001);
    refused(&["--tolerance", "colour=1 mm"], "sweep-no-tolerance");
    refused(&["--tolerance", "profile=1"], "units-no-unit");
    refused(
        &["--tolerance", "mass=1 %", "--vary", "law.degree=3,5"],
        "sweep-scatter-alone",
    );
}
