//! Rejected sweeps: message before anything is written.

use std::fs;
use std::path::Path;

use super::{refused, sweep};
use crate::support::stderr;

#[test]
fn bad_sweeps_are_refused_before_anything_is_written() {
    refused(&[], "cli-nothing-varies");
    refused(&["--vary", "limits.strok=1 mm:2 mm:3"], "scene-no-such-key");
    refused(&["--vary", "name=a,b"], "sweep-fixed");
    refused(&["--vary", "limits.stroke=1 mm:2 mm:0"], "sweep-no-values");
    refused(&["--vary", "law.family="], "sweep-no-values");
    refused(&["--vary", "limits.stroke=1:2:3"], "units-no-unit");
    let many = [
        "limits.stroke=1 mm:2 mm:1000000",
        "limits.jerk=1 m/s^3:2 m/s^3:1000000",
    ];
    refused(&["--vary", many[0], "--vary", many[1]], "cli-many-rows");
    refused(&["--list", "no-such-file.csv"], "file-cannot-read");
    refused(&["--sample", "5"], "cli-nothing-varies");
    refused(&["--recordings", "no-such-folder"], "file-cannot-read");
    let folder = tempfile::tempdir().unwrap();
    let output = sweep(&folder.path().join("t.txt"), &["--vary", "law.degree=3,5"]);
    assert!(stderr(&output).contains("neither .csv nor .parquet"));
    if !cfg!(feature = "parquet") {
        let output = sweep(
            &folder.path().join("t.parquet"),
            &["--vary", "law.degree=3,5"],
        );
        assert!(
            stderr(&output).contains("feature \"parquet\"") && stderr(&output).contains(".csv")
        );
    }
    let partial = folder.path().join("t.csv.partial");
    let own: [fn(&Path); 2] = [
        |place| fs::write(place, "my own notes").unwrap(),
        |place| std::os::unix::fs::symlink("/dev/zero", place).unwrap(),
    ];
    for put in own {
        put(&partial);
        let output = sweep(
            &folder.path().join("t.csv"),
            &["--vary", "law.degree=3,5", "--resume"],
        );
        let said = stderr(&output);
        assert!(said.contains("not the partial table of a sweep"), "{said}");
        fs::remove_file(&partial).unwrap();
    }
}
