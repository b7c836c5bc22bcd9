//! Keys of `summary.json` on which other programs rely.

use serde_json::Value;

use crate::TIME;
use gaitcam_test_support::designs::{footbridge, heel_tester, impossible};

/// Keys of summary.json on which other programs rely.
const CONTRACT: &str = r#"{"name": "", "outcome": "built|infeasible", "verdict": "acceptable|not-for-high-speed|unacceptable",
 "force": {"rms_error_n": 0, "max_error_n": 0, "rms_error_percent_of_mean": 0, "target_mean_n": 0, "mean_n": 0, "min_n": 0, "max_n": 0},
 "drive": {"kind": "", "mass_kg": 0, "speed_rad_per_s": 0},
 "law": {"family": "", "pieces": 0, "degree": 0, "coefficients": [], "stroke_m": 0, "v_max_m_per_rad": 0, "v_min_m_per_rad": 0,
         "a_max_m_per_rad2": 0, "a_min_m_per_rad2": 0, "j_max_m_per_rad3": 0, "j_min_m_per_rad3": 0},
 "cam": {"follower": "", "base_radius_m": 0, "prime_radius_m": 0, "radius_min_m": 0, "radius_max_m": 0, "offset_m": 0, "rho_min_m": 0, "rho_min_at_rad": 0,
         "pressure_angle_max_rad": 0, "pressure_angle_min_rad": 0, "face_width_m": 0},
 "checks": [{"name": "", "worst": 0, "limit": 0, "at_rad": 0, "pass": true}],
 "binding": [{"limit": "", "multiplier": 0, "at_rad": 0}],
 "solver": {"tier": "spectral|equality|qp|socp|scp", "status": "", "iterations": 0, "solve_s": 0, "certified": true},
 "time": {"total_s": 0}}"#;

/// Checks that every key of `pattern` is in `value` with the same kind. Returns the additional keys.
fn extra_keys(pattern: &Value, value: &Value, path: &str) -> Vec<String> {
    match (pattern, value) {
        (Value::Object(p), Value::Object(v)) => {
            for key in p.keys() {
                assert!(v.contains_key(key), "{path}.{key} is missing");
            }
            v.iter()
                .flat_map(|(key, value)| match p.get(key) {
                    Some(pattern) => extra_keys(pattern, value, &format!("{path}.{key}")),
                    None => vec![format!("{path}.{key}")],
                })
                .collect()
        }
        (Value::Array(p), Value::Array(v)) => match p.first() {
            Some(pattern) => v
                .iter()
                .flat_map(|v| extra_keys(pattern, v, path))
                .collect(),
            None => Vec::new(),
        },
        (p, v) => {
            let same = std::mem::discriminant(p) == std::mem::discriminant(v);
            assert!(same || v.is_null(), "{path} is {v}");
            Vec::new()
        }
    }
}

#[test]
fn summary_json_has_every_key_of_the_contract() {
    let contract: Value = serde_json::from_str(CONTRACT).unwrap();
    // What is said beyond the contract.
    let always = [
        ".continuity",
        ".cam_das",
        ".machine",
        ".verdict_text",
        ".reason",
        ".reasons",
        ".easing",
        ".remarks",
        ".out_of_time",
        ".load_factors",
        ".law.phase_rad",
        ".law.functions",
        ".solver.certificate",
    ];
    for (s, more) in [
        (footbridge(), None),
        (heel_tester(), None),
        (impossible(), Some(".infeasible")),
    ] {
        let text = gaitcam_output::json::summary(&s, TIME).to_string();
        let read: Value = serde_json::from_str(&text).unwrap();
        let mut found = extra_keys(&contract, &read, "");
        found.retain(|key| !always.contains(&key.as_str()));
        assert_eq!(found, Vec::from_iter(more));
    }
    let read = gaitcam_output::json::summary(&footbridge(), TIME);
    assert_eq!(read["outcome"], "built");
    assert_eq!(read["solver"]["solve_s"], 0.001);
    assert_eq!(read["cam"]["follower"], "flat-translating");
    let stroke = read["law"]["stroke_m"].as_f64().unwrap();
    assert!((stroke - footbridge().cam.law.stroke()).abs() < 1e-15);
    assert!(gaitcam_output::json::summary(&heel_tester(), TIME)["cam"]["face_width_m"].is_null());
}

#[test]
fn an_infeasible_summary_names_the_conflict_and_writes_no_nan() {
    let read = gaitcam_output::json::summary(&impossible(), TIME);
    assert_eq!(read["outcome"], "infeasible");
    assert_eq!(read["infeasible"]["conflict"][0], "stroke");
    assert_eq!(read["infeasible"]["relaxations"][0]["to"], 0.0483);
    assert!(read["infeasible"]["relaxations"][1]["to"].is_null());
    assert!(read["force"]["rms_error_n"].is_null());
    assert!(!read.to_string().contains("NaN"));
}

#[test]
fn without_a_target_there_is_no_error_and_where_nothing_presses_no_force() {
    let of = |name: &str, changes: &[&str]| {
        let text = gaitcam_test_support::scene_file(name);
        let design = gaitcam_test_support::design(&text, changes).unwrap();
        gaitcam_output::json::summary(&design, TIME)["force"].clone()
    };
    assert!(of("camdas_03_flat", &[]).is_null());
    let heavy = of(
        "camdas_03_flat",
        &["drive.mass=2 kg", "drive.spring_rate=100 N/m"],
    );
    for key in [
        "rms_error_n",
        "max_error_n",
        "rms_error_percent_of_mean",
        "target_mean_n",
    ] {
        assert!(heavy[key].is_null(), "{key}: {heavy}");
    }
    assert!(heavy["max_n"].as_f64().unwrap() > heavy["min_n"].as_f64().unwrap());
}

/// Positions of numbers and names of the design in `summary.json`, and in the data of the design itself.
const CORE: [(&str, &str); 26] = [
    ("/name", "/problem/name"),
    ("/verdict", "/verdict"),
    ("/force", "/force"),
    ("/drive/kind", "/problem/drive/kind"),
    ("/drive/mass_kg", "/problem/drive/mass"),
    ("/drive/speed_rad_per_s", "/problem/drive/speed"),
    ("/law/family", "/family"),
    ("/law/degree", "/degree"),
    ("/law/functions", "/functions"),
    ("/law/coefficients", "/coefficients"),
    ("/law/phase_rad", "/problem/phase"),
    ("/checks/0/name", "/checks/0/name"),
    ("/checks/0/worst", "/checks/0/worst"),
    ("/checks/0/limit", "/checks/0/limit"),
    ("/checks/0/at_rad", "/checks/0/at"),
    ("/checks/0/pass", "/checks/0/pass"),
    ("/binding", "/binding"),
    ("/easing", "/easing"),
    ("/relaxations", "/relaxations"),
    ("/infeasible/conflict", "/infeasible/conflict"),
    ("/infeasible/relaxations", "/infeasible/relaxations"),
    ("/out_of_time", "/out_of_time"),
    ("/solver/tier", "/solver/tier"),
    ("/solver/iterations", "/solver/iterations"),
    ("/solver/certified", "/solver/certified"),
    ("/solver/certificate", "/solver/certificate"),
];

#[test]
fn the_data_of_a_design_holds_what_its_summary_says() {
    for design in [footbridge(), heel_tester(), impossible()] {
        let summary = gaitcam_output::json::summary(&design, TIME);
        let data = serde_json::to_value(&design).unwrap();
        let mut found = 0;
        for (shown, kept) in CORE {
            // What a design has not, its summary leaves out.
            let Some(shown) = summary.pointer(shown) else {
                continue;
            };
            let kept = data.pointer(kept).unwrap_or_else(|| panic!("{kept}"));
            assert_eq!(shown, kept);
            found += 1;
        }
        assert!(found >= 18, "{found}");
        // The cam: its follower with its lengths, and the law that its stroke is taken from.
        let follower = summary["cam"]["follower"].as_str().unwrap();
        let lengths = &data["cam"]["follower"][follower];
        let base = (lengths["base_radius"].as_f64()).unwrap_or_else(|| {
            lengths["prime_radius"].as_f64().unwrap() - lengths["roller_radius"].as_f64().unwrap()
        });
        assert!((summary["cam"]["base_radius_m"].as_f64().unwrap() - base).abs() < 1e-15);
        let pieces = data["cam"]["law"]["poly"]["breaks"]
            .as_array()
            .unwrap()
            .len();
        assert_eq!(summary["law"]["pieces"], pieces - 1);
        // Data alone: a sentence has words with blanks between them.
        assert!(!data["reasons"].to_string().contains("\"en\""));
    }
}
