//! Runs the program of the page on Rust in a crate that depends on `gaitcam` only.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

const PAGE: &str = include_str!("../../docs/guide/rust.md");

/// First code block of a kind.
fn block(kind: &str) -> &'static str {
    let text = PAGE.split_once(&format!("```{kind}\n")).expect("a block").1;
    text.split_once("```").expect("its end").0
}

/// Newest library in the folder, which this test was built with.
fn library(folder: &Path) -> PathBuf {
    let entries = std::fs::read_dir(folder)
        .unwrap()
        .flatten()
        .map(|e| e.path());
    let is_library = |p: &PathBuf| {
        let name = p.file_name().unwrap_or_default().to_string_lossy();
        let hash = name
            .strip_prefix("libgaitcam-")
            .and_then(|n| n.strip_suffix(".rlib"));
        hash.is_some_and(|h| h.bytes().all(|b| b.is_ascii_hexdigit()))
    };
    let modified = |p: &PathBuf| {
        p.metadata()
            .and_then(|m| m.modified())
            .unwrap_or(SystemTime::UNIX_EPOCH)
    };
    entries
        .filter(is_library)
        .max_by_key(modified)
        .expect("the library")
}

#[test]
fn the_program_of_the_page_needs_no_other_crate() {
    let manifest: toml::Table = block("toml").parse().unwrap();
    let dependencies = manifest["dependencies"].as_table().unwrap();
    assert_eq!(dependencies.keys().collect::<Vec<_>>(), ["gaitcam"]);

    let test = std::env::current_exe().unwrap();
    let libraries = test.parent().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (source, program) = (folder.path().join("main.rs"), folder.path().join("main"));
    std::fs::write(&source, block("rust")).unwrap();
    // What cargo does for such a crate: `gaitcam` by its name, what it depends on only through it.
    let built = Command::new(std::env::var("RUSTC").unwrap_or("rustc".to_string()))
        .args(["--edition", "2024", "-o"])
        .arg(&program)
        .arg(&source)
        .arg("--extern")
        .arg(format!("gaitcam={}", library(libraries).display()))
        .arg("-L")
        .arg(format!("dependency={}", libraries.display()))
        .output()
        .unwrap();
    assert!(
        built.status.success(),
        "{}",
        String::from_utf8_lossy(&built.stderr)
    );
    let run = Command::new(&program).output().unwrap();
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(
        run.status.success() && printed.starts_with("stroke 4"),
        "{printed}"
    );
    assert_eq!(printed.lines().count(), 362);
}
