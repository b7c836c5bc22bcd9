//! Layering: every module imports only from those below it.

use std::fs;
use std::path::Path;

/// Lowest floor first: a module may use those before it. The law stands before the drive, because a force
/// is computed from a law. The first two are of the crate `gaitcam-base`.
const FLOORS: [&str; 15] = [
    "halt",
    "units",
    "criterion",
    "wording",
    "error",
    "poly",
    "force",
    "law",
    "drive",
    "cam",
    "dynamics",
    "scene",
    "problem",
    "synth",
    "sweep",
];

fn floor(module: &str) -> usize {
    FLOORS
        .iter()
        .position(|f| *f == module)
        .unwrap_or_else(|| panic!("module {module} has no floor"))
}

fn sources(dir: &Path, out: &mut Vec<(String, String)>, module: &str) {
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_string();
        if path.is_dir() {
            let inner = if module.is_empty() {
                name
            } else {
                module.to_string()
            };
            sources(&path, out, &inner);
        } else if path.extension().is_some_and(|e| e == "rs")
            && !matches!(name.as_str(), "lib" | "main")
        {
            let module = if module.is_empty() {
                name
            } else {
                module.to_string()
            };
            out.push((module, fs::read_to_string(&path).unwrap()));
        }
    }
}

#[test]
fn imports_point_downwards_only() {
    let mut files = Vec::new();
    sources(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut files,
        "",
    );
    assert!(files.len() > 20, "the sources were not found");
    for (module, text) in &files {
        // Doc comments may point anywhere.
        for line in text.lines().map(str::trim).filter(|l| !l.starts_with("//")) {
            for part in line.split("crate::").skip(1) {
                let used: String = part
                    .chars()
                    .take_while(|c| c.is_alphanumeric() || *c == '_')
                    .collect();
                assert!(
                    used == *module || floor(&used) < floor(module),
                    "{module} looks up to {used}: {line}"
                );
            }
        }
    }
}

#[test]
fn numerics_neither_read_nor_write_nor_look_at_the_clock() {
    let mut files = Vec::new();
    sources(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut files,
        "",
    );
    for (module, text) in &files {
        // Examples in the documentation are programs of users, who may.
        let code = text.split("#[cfg(test)]").next().unwrap_or("");
        let code: String = (code.lines())
            .filter(|line| !line.trim_start().starts_with("//"))
            .collect();
        for word in [
            "std::fs",
            "println!",
            "Instant::now",
            "SystemTime",
            "std::env",
        ] {
            assert!(!code.contains(word), "{module} uses {word}");
        }
    }
}
