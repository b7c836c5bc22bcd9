//! Limits of the system for a process: file size, number of threads.

use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::process::Command;

use crate::support::{both, limited, run_in, stderr};

/// Commands that write files.
const WRITING: [&[&str]; 7] = [
    &["synth", "footbridge", "--out", "design"],
    &["simulate", "footbridge", "--out", "run"],
    &[
        "synth",
        "--front",
        "force_error:stroke",
        "--points",
        "3",
        "--out",
        "front",
    ],
    &[
        "sweep",
        "--vary",
        "gait.step_frequency=1.5 Hz:2.4 Hz:300",
        "--out",
        "table.csv",
    ],
    &[
        "sweep",
        "--vary",
        "gait.step_frequency=1.5 Hz:2.4 Hz:300",
        "--jobs",
        "2",
        "--out",
        "two.csv",
    ],
    &[
        "cover",
        "--set",
        "gait.step_frequency=1.4 Hz:2.4 Hz:5",
        "--cams",
        "1:2",
        "--out",
        "cover",
    ],
    &[
        "synth",
        "footbridge",
        "--solid",
        "--tool",
        "5 mm",
        "--out",
        "solid",
    ],
];

#[test]
fn a_limit_on_the_size_of_files_is_said_and_keeps_the_earlier_result() {
    let here = tempfile::tempdir().unwrap();
    for arguments in WRITING {
        let output = limited(here.path(), "--fsize=3000", arguments);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(said.starts_with("gaitcam: "), "{arguments:?}: {said}");
        assert!(said.contains("File too large"), "{arguments:?}: {said}");
    }
    let design = WRITING[0];
    assert_eq!(run_in(here.path(), design).status.code(), Some(0));
    let before = fs::read(here.path().join("design/summary.json")).unwrap();
    let again = limited(here.path(), "--fsize=3000", design);
    assert_eq!(again.status.code(), Some(2), "{}", both(&again));
    let after = fs::read(here.path().join("design/summary.json")).unwrap();
    assert!(before == after);
}

#[test]
fn where_no_thread_can_begin_the_work_is_done_on_the_first_or_refused() {
    let here = tempfile::tempdir().unwrap();
    let folder = here.path();
    // Limits on threads do not hold for root: run as another user, who needs a readable program and a writable folder.
    fs::set_permissions(folder, Permissions::from_mode(0o777)).unwrap();
    let program = folder.join("gaitcam");
    fs::copy(env!("CARGO_BIN_EXE_gaitcam"), &program).unwrap();
    let is_root = fs::metadata("/proc/self").unwrap().uid() == 0;
    for arguments in WRITING {
        let mut command = Command::new(if is_root { "setpriv" } else { "env" });
        if is_root {
            command.args(["--reuid=65534", "--regid=65534", "--clear-groups"]);
        }
        command.args(["prlimit", "--nproc=1"]).arg(&program);
        let output = command
            .args(arguments)
            .current_dir(folder)
            .output()
            .unwrap();
        // The library of spreadsheets works on threads alone.
        let has_spreadsheet = arguments.contains(&"--solid") || arguments[0] == "simulate";
        let code = if has_spreadsheet { 2 } else { 0 };
        let said = both(&output);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(
            !said.is_empty() && !said.contains("internal error"),
            "{said}"
        );
    }
    // All columns but the last, which is the time of a row.
    let rows = |name: &str| -> Vec<String> {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let row = |line: &str| line.rsplit_once(',').unwrap().0.to_string();
        text.lines().map(row).collect()
    };
    assert_eq!(rows("table.csv").len(), 301);
    assert_eq!(rows("table.csv"), rows("two.csv"));
}
