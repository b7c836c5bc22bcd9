//! `gaitcam ecam` and `synth --ecam`: files of a result, and the printed text.

use std::fs;

use crate::support::{gaitcam, object, stderr, stdout};

#[test]
fn a_result_gets_the_file_of_each_controller_and_synth_writes_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (made, both) = (path("made"), path("both"));
    let run = gaitcam(&["synth", "footbridge", "--no-png", "--out", &made]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    for (dialect, file) in [
        ("codesys", "ecam_codesys.st"),
        ("twincat", "ecam_twincat.st"),
        ("segments", "ecam_segments.csv"),
        ("rockwell", "ecam_rockwell.st"),
        ("csv", "ecam_csv.csv"),
    ] {
        let run = gaitcam(&["ecam", &made, "--dialect", dialect, "--json"]);
        let found = object(&run);
        assert_eq!(found["dialect"], dialect);
        assert!(found["added_percent"].as_f64().unwrap() < 0.01, "{found}");
        let error = found["rms_error_n"].as_f64().unwrap();
        assert!((error - 3.46).abs() < 0.02, "{error}");
        let run = gaitcam(&[
            "synth",
            "footbridge",
            "--no-png",
            "--ecam",
            dialect,
            "--out",
            &both,
        ]);
        assert!(stdout(&run).contains(file), "{}", stdout(&run));
        let [own, other] =
            [&made, &both].map(|f| fs::read_to_string(format!("{f}/{file}")).unwrap());
        assert_eq!(own, other);
    }
    // A result is whole after it, and its own file alone was added.
    let run = gaitcam(&["compare", &made, &both]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
}

#[test]
fn a_number_of_points_that_misses_the_force_is_refused_with_one_that_does_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let made = folder.path().join("made");
    let made = made.to_str().unwrap();
    gaitcam(&["synth", "footbridge", "--no-png", "--out", made]);
    let points = |n: &str| gaitcam(&["ecam", made, "--dialect", "rockwell", "--points", n]);
    let refused = points("3600");
    assert_eq!(refused.status.code(), Some(2));
    let said = stderr(&refused);
    let better = said
        .split("give --points ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap();
    assert!(!fs::exists(format!("{made}/ecam_rockwell.st")).unwrap());
    assert_eq!(points(better).status.code(), Some(0), "{said}");
    for bad in ["0", "3", "1000000", "-1", "many"] {
        assert_eq!(points(bad).status.code(), Some(2), "{bad}");
    }
    for bad in [["ecam", made], ["ecam", "no-such-folder"]] {
        assert_eq!(gaitcam(&bad).status.code(), Some(2));
    }
}
