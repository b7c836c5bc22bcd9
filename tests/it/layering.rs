//! Layering: every module imports only from those below it.

use std::fs;
use std::path::Path;

/// Lowest floor first: a module may use those before it. The law stands before the drive, because a force
/// is computed from a law. The first two are of the crate `gaitcam-base`.
const FLOORS: [&str; 17] = [
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
    "cover",
    "identify",
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

/// The code of a file without comments (examples in the documentation are programs of users) and without the items that
/// are compiled for tests only: from the attribute to the line that closes the item.
fn without_tests(text: &str) -> String {
    let mut out = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim() == "#[cfg(test)]" {
            let depth = indent(line);
            let is_last = |l: &&str| indent(l) == depth && l.ends_with(['}', ';']);
            let _ = lines.by_ref().find(is_last);
        } else if !line.trim_start().starts_with("//") {
            out.push_str(line);
            out.push('\n');
        }
    }
    out
}

/// Columns before the first word of a line.
fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

#[test]
fn items_after_a_test_module_are_read() {
    let text = "fn a() {}\n#[cfg(test)]\nmod tests {\n    fn b() {\n        c();\n    }\n}\nfn d() {}\n#[cfg(test)]\nmod e;\nfn f() {}\n";
    assert_eq!(without_tests(text), "fn a() {}\nfn d() {}\nfn f() {}\n");
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
        let code = without_tests(text);
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
