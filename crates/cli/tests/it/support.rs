//! Runs of the command, its output, and recordings as input.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Root of the repository, which contains the scenes and recordings.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The command in a folder, in English, with an empty standard input.
pub fn command(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gaitcam"));
    command
        .current_dir(folder)
        .env_remove("LC_ALL")
        .env_remove("LANG")
        .stdin(Stdio::null());
    command
}

/// Runs the command from the root of the repository.
pub fn gaitcam(arguments: &[&str]) -> Output {
    run_in(Path::new(ROOT), arguments)
}

/// Runs the command from a folder.
pub fn run_in(folder: &Path, arguments: &[&str]) -> Output {
    command(folder).args(arguments).output().unwrap()
}

/// Runs the command from a folder under a limit of `prlimit`.
pub fn limited(folder: &Path, limit: &str, arguments: &[&str]) -> Output {
    let mut limited = Command::new("prlimit");
    limited.args([limit, env!("CARGO_BIN_EXE_gaitcam")]);
    let limited = limited.args(arguments).current_dir(folder);
    limited.output().unwrap()
}

/// Standard output as text.
pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Standard error as text.
pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// Both streams, standard output first.
pub fn both(output: &Output) -> String {
    stdout(output) + &stderr(output)
}

/// JSON object on standard output.
pub fn object(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", stderr(output)))
}

/// Arguments followed by changes to the scene.
pub fn changed<'a>(arguments: &[&'a str], changes: &[&'a str]) -> Vec<&'a str> {
    let flags = changes.iter().flat_map(|change| ["--set", change]);
    arguments.iter().copied().chain(flags).collect()
}

/// Writes a recording of walking: 12 s at 200 Hz, both feet, equal strides.
pub fn walk(path: &Path) {
    wobbling_walk(path, 0.0);
}

/// Writes a recording of walking in which the force of the strides is multiplied by `1 ± wobble` in turn.
pub fn wobbling_walk(path: &Path, wobble: f64) {
    let foot = |t: f64| {
        let x = t.rem_euclid(1.1) / 0.68;
        let a = std::f64::consts::PI * x;
        let odd = (t / 1.1) as usize % 2 == 1;
        if x < 1.0 {
            (1.0 + if odd { wobble } else { -wobble }) * 700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
        } else {
            0.0
        }
    };
    let mut text = "time,left fz,right fz\n".to_string();
    for i in 0..2400 {
        let t = f64::from(i) / 200.0;
        let _ = writeln!(text, "{t:.3},{:.2},{:.2}", foot(t + 0.2), foot(t + 0.75));
    }
    fs::write(path, text).unwrap();
}
