//! Files and streams that are read, and files that are written only on request.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Stdio;

use serde_json::Value;

use crate::support::{command, object, run_in, stdout, walk};

const SCENE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenes/camdas_03_flat.toml"
);

fn is_empty(folder: &Path) -> bool {
    fs::read_dir(folder).unwrap().next().is_none()
}

#[test]
fn json_without_a_folder_writes_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let output = run_in(folder.path(), &["synth", SCENE, "--json"]);
    assert_eq!(output.status.code(), Some(0));
    let summary: Value = object(&output);
    assert_eq!(summary["outcome"], "built");
    assert!(is_empty(folder.path()));
}

#[test]
fn no_png_leaves_the_other_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let output = run_in(folder.path(), &["synth", SCENE, "--out", "a", "--no-png"]);
    assert_eq!(output.status.code(), Some(0));
    let there = |name: &str| folder.path().join("a").join(name).exists();
    assert!(there("cam.svg") && !there("cam.png"));
}

#[test]
fn the_scene_that_was_read_is_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    let own = format!("# mine\n{}", fs::read_to_string(SCENE).unwrap());
    fs::write(&scene, &own).unwrap();
    let output = run_in(folder.path(), &["synth", "scene.toml", "--out", "."]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(fs::read_to_string(&scene).unwrap(), own);
    assert!(folder.path().join("scene.used.toml").exists());
    // A summary as scene is an input, too.
    let output = run_in(folder.path(), &["synth", "summary.json", "--out", "."]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn a_scene_comes_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = command(folder.path())
        .args(["synth", "-", "--json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let text = fs::read(SCENE).unwrap();
    child.stdin.take().unwrap().write_all(&text).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn errors_are_json_where_json_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let output = run_in(
        folder.path(),
        &["synth", "--json", "--set", "limits.stroke=3 kg"],
    );
    assert_eq!(output.status.code(), Some(2));
    let error: Value = object(&output);
    assert!(error["error"]["code"].is_string() && error["error"]["message"].is_string());
}

#[test]
fn names_that_are_no_file_names_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in [" ", "a\nb", "-rf", "*", "~", "a\u{202e}b"] {
        let set = format!("name={name}");
        let output = run_in(folder.path(), &["synth", SCENE, "--set", &set]);
        assert_eq!(output.status.code(), Some(2), "{name:?}");
        assert!(
            output.stderr.len() < 2200 && is_empty(folder.path()),
            "{name:?}"
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_folders_are_no_scenes() {
    let folder = tempfile::tempdir().unwrap();
    for path in ["/dev/zero", "/dev/urandom", "/"] {
        let output = run_in(folder.path(), &["synth", path]);
        assert_eq!(output.status.code(), Some(2), "{path}");
    }
}

#[test]
fn the_console_says_the_verdict_first_and_all_in_25_lines() {
    let folder = tempfile::tempdir().unwrap();
    let scene = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/heel_tester_fitted.toml"
    );
    let output = run_in(folder.path(), &["synth", scene, "--out", "a", "--no-png"]);
    let text = stdout(&output);
    assert!(text.lines().count() <= 25, "{text}");
    assert!(text.starts_with("heel_tester_fitted: acceptable"), "{text}");
}

#[test]
fn no_name_of_a_walker_is_a_formula_in_the_table() {
    let here = tempfile::tempdir().unwrap();
    let folder = here.path().join("walks");
    fs::create_dir(&folder).unwrap();
    for name in ["=1+1.csv", "+y.csv", "-z.csv", "@x.csv"] {
        walk(&folder.join(name));
    }
    fs::write(here.path().join("p.toml"), "[gait]\nfile = \"walks/\"\n").unwrap();
    run_in(here.path(), &["synth", "p.toml", "--no-png", "--out", "R"]);
    let table = fs::read_to_string(here.path().join("R/walkers.csv")).unwrap();
    assert_eq!(table.lines().count(), 5, "{table}");
    for row in table.lines().skip(1) {
        assert!(row.starts_with('\''), "{row}");
    }
}
