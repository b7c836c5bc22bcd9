//! Writes the text that `gaitcam --version` prints beside the version: the commit and the solver of this build.

use std::fs::read_to_string;
use std::process::Command;

fn main() {
    let commit = git().or_else(packaged).unwrap_or_default();
    let commit = commit.get(..10).map(|c| format!("{c}, "));
    let solver = solver().unwrap_or_default();
    println!(
        "cargo::rustc-env=GAITCAM_BUILD={}Clarabel {solver}",
        commit.unwrap_or_default()
    );
}

/// Commit of a checkout; `None` outside of one. Cargo runs this script again when the commit changes.
fn git() -> Option<String> {
    let ask = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_string())
    };
    let log = ask(&["rev-parse", "--git-path", "logs/HEAD"])?;
    println!("cargo::rerun-if-changed={log}");
    ask(&["rev-parse", "HEAD"])
}

/// Commit stated in a packaged crate.
fn packaged() -> Option<String> {
    let text = read_to_string(".cargo_vcs_info.json").ok()?;
    Some(text.split('"').find(|word| word.len() == 40)?.to_string())
}

/// Version of Clarabel in the lock file of the workspace or of the package.
fn solver() -> Option<String> {
    let lock = read_to_string("../../Cargo.lock").or_else(|_| read_to_string("Cargo.lock"));
    let lock = lock.ok()?;
    let (_, after) = lock.split_once("name = \"clarabel\"\nversion = \"")?;
    println!("cargo::rerun-if-changed=../../Cargo.lock");
    Some(after.split('"').next()?.to_string())
}
