//! Sweeps of the command: no loss of rows after any kind of termination, messages for invalid input.

mod damaged;
mod front;
mod interrupted;
mod refused;
mod scatter;
mod shards;
mod table;

use std::fs;
use std::path::Path;
use std::process::{Child, Output, Stdio};

use crate::support::{ROOT, command, gaitcam, object, stderr};

fn sweep(out: &Path, arguments: &[&str]) -> Output {
    gaitcam(&[&["sweep"], arguments, &["--out", out.to_str().unwrap()]].concat())
}

fn start(out: &Path, arguments: &[&str]) -> Child {
    command(Path::new(ROOT))
        .arg("sweep")
        .args(arguments)
        .arg("--out")
        .arg(out)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// The table without its last column, the time.
fn rows(table: &Path) -> Vec<String> {
    let text = fs::read_to_string(table).unwrap();
    text.lines()
        .map(|l| l.rsplit_once(',').unwrap().0.to_string())
        .collect()
}

/// Asserts that the arguments are rejected with this message before anything is written.
fn refused(arguments: &[&str], code: &str) {
    let folder = tempfile::tempdir().unwrap();
    let output = sweep(
        &folder.path().join("t.csv"),
        &[arguments, &["--json"]].concat(),
    );
    assert_eq!(
        output.status.code(),
        Some(2),
        "{arguments:?}: {}",
        stderr(&output)
    );
    assert_eq!(
        object(&output)["error"]["code"],
        code,
        "{arguments:?}: {}",
        stderr(&output)
    );
    assert!(
        fs::read_dir(folder.path()).unwrap().next().is_none(),
        "{arguments:?} left a file"
    );
}

const SLOW: [&str; 6] = [
    "--vary",
    "gait.step_frequency=1.5 Hz:2.3 Hz:10",
    "--vary",
    "limits.stroke=35 mm:60 mm:12",
    "--vary",
    "law.family=spline,harmonic,program",
];
