//! `--time-limit` holds where designs are costly.

use std::time::Instant;

use crate::support::{gaitcam, object};

/// Refused designs whose relaxations take seconds to a minute, and a sequence of many spans.
const COSTLY: [&[&str]; 4] = [
    &["heel_tester_fitted", "limits.prime_radius=45 mm"],
    &[
        "heel_tester_fitted",
        "law.spans=120",
        "limits.pressure_angle=20 deg",
    ],
    &[
        "footbridge",
        "law.family=spline",
        "law.spans=400",
        "law.minimise=size",
    ],
    &[
        "footbridge",
        "law.spans=400",
        "law.minimise=peak-jerk",
        "limits.jerk=10 m/s^3",
    ],
];

#[test]
fn a_time_limit_ends_every_costly_design_with_what_is_known() {
    const LIMIT: f64 = 0.3;
    for scene in COSTLY {
        let folder = tempfile::tempdir().unwrap();
        let limit = LIMIT.to_string();
        let mut arguments = vec!["synth", scene[0], "--json", "--time-limit", &limit, "--out"];
        arguments.push(folder.path().to_str().unwrap());
        arguments.extend(scene[1..].iter().flat_map(|change| ["--set", change]));
        let begun = Instant::now();
        let run = gaitcam(&arguments);
        let taken = begun.elapsed().as_secs_f64();
        let summary: serde_json::Value = object(&run);
        assert_eq!(summary["out_of_time"], true, "{scene:?} took {taken} s");
        // What was cut short is no proof: only a conflict of limits is called infeasible.
        let outcome = summary["outcome"].as_str().unwrap();
        let conflict = summary["infeasible"]["conflict"].as_array();
        match outcome {
            "out-of-time" => assert!(conflict.is_none() && summary.get("relaxations").is_none()),
            _ => assert!(
                outcome == "infeasible" && !conflict.unwrap().is_empty(),
                "{scene:?}"
            ),
        }
        assert_eq!(run.status.code(), Some(3));
        assert!(taken < 1.1 * LIMIT + 1.0, "{scene:?} took {taken} s");
        assert!(folder.path().join("summary.json").is_file(), "{scene:?}");
    }
}
