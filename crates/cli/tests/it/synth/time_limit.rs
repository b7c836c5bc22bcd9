//! Designs that take long end at the time limit of `--time-limit`.

use std::fs;
use std::path::Path;

use crate::support::{ROOT, limited, object};

/// Infeasible designs whose relaxations take seconds to a minute, and a sequence with many spans.
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

/// Limit of the system: the command is ended after 2 s of processor time.
const TWO_SECONDS: &str = "--cpu=2";

#[test]
fn a_time_limit_ends_every_costly_design_with_what_is_known() {
    for scene in COSTLY {
        let folder = tempfile::tempdir().unwrap();
        let mut arguments = vec!["synth", scene[0], "--json", "--time-limit", "0.3", "--out"];
        arguments.push(folder.path().to_str().unwrap());
        arguments.extend(scene[1..].iter().flat_map(|change| ["--set", change]));
        let run = limited(Path::new(ROOT), TWO_SECONDS, &arguments);
        let summary: serde_json::Value = object(&run);
        assert_eq!(summary["out_of_time"], true, "{scene:?}");
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
        assert!(folder.path().join("summary.json").is_file(), "{scene:?}");
    }
}

/// Scene with an unlimited snap and an arm for which no base radius is large enough.
const ARM: &str = r#"
name = "arm"
[drive]
kind = "fixed-axis"
inertia = "0.18 kg m^2"
speed = "3.7 rad/s"
spring_rate = "1660 N m/rad"
preload = "7 N m"
[law]
family = "spline"
degree = 7
spans = 48
minimise = "peak-snap"
[[law.point]]
angle = "160 deg"
lift = "0"
velocity = "7.2 rad/rad"
[cam]
follower = "roller-oscillating"
roller_radius = "10 mm"
pivot_distance = "200 mm"
arm = "80 mm"
[limits]
force_min = "none"
[accuracy]
rms = "none"
"#;

#[test]
fn a_time_limit_holds_for_fronts_covers_and_arms_without_a_cam() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("arm.toml"), ARM).unwrap();
    let costly: [&[&str]; 4] = [
        &["synth", "arm.toml", "--no-png"],
        &[
            "synth",
            "heel_tester_fitted",
            "--front",
            "force_error:prime_radius",
            "--points",
            "3",
        ],
        &[
            "synth",
            "heel_tester_fitted",
            "--set",
            "limits.prime_radius=45 mm",
            "--no-png",
        ],
        &[
            "cover",
            "--set",
            "gait.step_frequency=1.4 Hz:2.4 Hz:40",
            "--cams",
            "1:6",
        ],
    ];
    for arguments in costly {
        let arguments = [arguments, &["--time-limit", "0.3", "--out", "out"]].concat();
        let run = limited(folder.path(), TWO_SECONDS, &arguments);
        assert_eq!(run.status.code(), Some(3), "{arguments:?}: {run:?}");
    }
}
