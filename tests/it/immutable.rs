//! A problem and a design are complete when they are constructed: no later code assigns to their fields.

use std::fs;
use std::path::Path;

use gaitcam_test_support::root;

/// Collects the sources of the product without tests, each with its path relative to the root.
fn sources(dir: &Path, out: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() && !matches!(name, "tests" | "target" | "test-support") {
            sources(&path, out);
        } else if name.ends_with(".rs") && !name.ends_with("tests.rs") {
            let text = fs::read_to_string(&path).unwrap();
            let product = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let place = path.strip_prefix(root()).unwrap().display().to_string();
            out.push((place, product.to_string()));
        }
    }
}

/// Rest of a text after the path of fields at its start.
fn after_path(text: &str) -> Option<&str> {
    let end = text.find(|c: char| !(c.is_ascii_alphanumeric() || "._".contains(c)))?;
    Some(text[end..].trim_start())
}

/// Whether a line assigns to a field of a variable or borrows it mutably.
fn changes(line: &str, variable: &str, kind: &str) -> bool {
    let assigns = line
        .match_indices(&format!("{variable}."))
        .filter_map(|(at, _)| after_path(&line[at..]))
        .any(|after| {
            let after = after.strip_prefix(['+', '-', '*', '/']).unwrap_or(after);
            after.starts_with("= ")
        });
    assigns
        || line.contains(&format!("&mut {kind}"))
        || line.contains(&format!("mut {variable} "))
        || line.contains(&format!("mut {variable}:"))
}

#[test]
fn nothing_assigns_to_a_field_of_a_problem_or_of_a_finished_design() {
    let mut files = Vec::new();
    for dir in ["src", "crates", "python/src"] {
        sources(&root().join(dir), &mut files);
    }
    assert!(files.len() > 400, "{}", files.len());
    for (place, text) in &files {
        for line in text.lines().map(str::trim) {
            if line.starts_with("//") {
                continue;
            }
            assert!(!changes(line, "design", "Design"), "{place}: {line}");
            let own = place.starts_with("src/problem/");
            assert!(
                own || !changes(line, "problem", "Problem"),
                "{place}: {line}"
            );
        }
    }
}

#[test]
fn an_assignment_is_seen() {
    for line in [
        "design.drive = drive;",
        "made.design.force.mean_n *= 2.0;",
        "fn put_on(design: &mut Design) {",
    ] {
        assert!(changes(line, "design", "Design"), "{line}");
    }
    assert!(!changes(
        "let drive = design.problem.drive;",
        "design",
        "Design"
    ));
    assert!(!changes("if design.degree == 5 {", "design", "Design"));
}
