//! Layering: a module imports only from lower modules.

use std::fs;
use std::path::Path;

/// Modules from the lowest to the highest; a module may use the ones before it. The law precedes the drive, because a force is computed from a law.
/// The first two belong to the crate `gaitcam-base`.
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
        if text.contains(TEST) {
            continue;
        }
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

/// Start of a test outside any module. A file with such a test contains only tests.
const TEST: &str = "\n#[test]\n";

/// Parts of `src/synth` from the lowest to the highest. The attempt of one law is below the design, the machine and the population.
const PARTS_OF_SYNTH: [&str; 20] = [
    "search",
    "qp",
    "report",
    "limits",
    "sizing",
    "verdict",
    "optimum",
    "infeasible",
    "families",
    "phase",
    "attempt",
    "design",
    "closed_form",
    "finish",
    "machine",
    "population",
    "synthesis",
    "relaxation",
    "pareto",
    "outcome",
];

/// First names of all paths in a text that begin with `prefix`, including the names in braces.
fn named_after(text: &str, prefix: &str) -> Vec<String> {
    let first = |path: &str| -> String {
        let is_word = |c: &char| c.is_alphanumeric() || *c == '_';
        path.trim().chars().take_while(is_word).collect()
    };
    let after = text.split(prefix).skip(1);
    let names = after.flat_map(|rest| match rest.strip_prefix('{') {
        None => vec![first(rest)],
        Some(inside) => {
            let mut depth = 1;
            let ends = |c: char| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            };
            let inside = inside.split(ends).next().unwrap_or_default();
            let mut depth = 0;
            let apart = |c: char| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0 && c == ','
            };
            inside.split(apart).map(first).collect()
        }
    });
    names.collect()
}

/// Imports of a part of `src/synth` from parts that are not below it.
fn upwards(part: &str, text: &str, is_top: bool) -> Vec<String> {
    let rank = |name: &str| PARTS_OF_SYNTH.iter().position(|p| *p == name);
    let own = rank(part).unwrap_or_else(|| panic!("{part} has no place in synth"));
    let mut names = named_after(text, "crate::synth::");
    if is_top {
        names.extend(named_after(text, "super::"));
    }
    names.retain(|name| name != part && rank(name).is_some_and(|other| other > own));
    names
}

#[test]
fn inside_synth_imports_point_downwards_only() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/synth");
    let mut seen = 0;
    for entry in fs::read_dir(root).unwrap() {
        let path = entry.unwrap().path();
        let part = path.file_stem().unwrap().to_str().unwrap().to_string();
        if matches!(part.as_str(), "mod" | "samples") {
            continue;
        }
        let mut files = Vec::new();
        if path.is_dir() {
            sources(&path, &mut files, &part);
        } else {
            files.push((part.clone(), fs::read_to_string(&path).unwrap()));
        }
        // A part's own file `mod.rs` calls the parts beside it by `super`, too.
        let top = fs::read_to_string(path.join("mod.rs")).unwrap_or_default();
        for (_, text) in &files {
            if text.contains(TEST) {
                continue;
            }
            let is_top = !path.is_dir() || *text == top;
            let up = upwards(&part, &without_tests(text), is_top);
            assert!(up.is_empty(), "{part} looks up to {up:?}");
            seen += 1;
        }
    }
    assert!(seen > 70, "{seen}");
}

#[test]
fn an_import_upwards_is_seen() {
    let text = "use crate::synth::{\n    limits::{GEOMETRY, Press},\n    design::Design,\n};\nuse super::finish;";
    assert_eq!(upwards("families", text, true), ["design", "finish"]);
    assert_eq!(upwards("families", text, false), ["design"]);
    assert!(upwards("population", text, true).is_empty());
}

/// Code of a file without comments and without test items, from the `cfg(test)` attribute to the line that closes the item. Comments are left out
/// because examples in the documentation are programs of users.
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

/// Number of columns before the first word of a line.
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

/// Folders with the code for the messages of a crate, each with the English Fluent files of these messages; the lowest crate first.
const WORDED: [[&str; 2]; 7] = [
    ["crates/base/src/wording", "crates/base/src/wording/en"],
    ["crates/gait/src/wording", "crates/gait/src/wording/en"],
    ["src/wording", "src/wording/en"],
    ["crates/cad/src/words", "crates/cad/src/words"],
    ["crates/output/src/words", "crates/output/src/words"],
    ["crates/app/src/page/words", "crates/app/src/page/words"],
    ["crates/cli/src/console", "crates/cli/words/en"],
];

/// Fields of a quantity, which every crate shows, and a unit that is also a field name.
const OF_QUANTITY: [&str; 3] = ["ratio", "unit", "value"];

/// Texts of the files in a folder with this ending, concatenated; of Fluent files only the English ones.
fn texts(folder: &str, ending: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let paths = fs::read_dir(root)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let wanted = |path: &std::path::PathBuf| {
        let name = path.file_name().unwrap().to_str().unwrap();
        name.ends_with(ending) && !name.starts_with("es.") && !name.starts_with("tests")
    };
    let mut paths: Vec<_> = paths.filter(wanted).collect();
    paths.sort();
    paths
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect()
}

/// Names of the fields and areas of Fluent messages: `typed` and `scene` of `scene-no-key = { $typed }`.
fn fields_and_areas(fluent: &str) -> Vec<String> {
    let areas = fluent.lines().filter_map(|line| {
        let (key, _) = line.split_once(" =")?;
        let begins = key.starts_with(|c: char| c.is_ascii_lowercase());
        Some(key.split_once('-').filter(|_| begins)?.0.to_string())
    });
    named_after(fluent, "$").into_iter().chain(areas).collect()
}

/// Quoted words of code: `known` of `as_typed: &["known"]`.
fn quoted(code: &str) -> Vec<&str> {
    let is_word = |text: &&str| !text.is_empty() && text.chars().all(|c| c.is_ascii_lowercase());
    code.split('"').skip(1).step_by(2).filter(is_word).collect()
}

#[test]
fn no_crate_names_fields_or_areas_of_messages_of_a_crate_above() {
    let of = WORDED.map(|[_, fluent]| fields_and_areas(&texts(fluent, ".ftl")));
    let mut seen = 0;
    for (at, [code, _]) in WORDED.into_iter().enumerate() {
        let (below, above) = of.split_at(at + 1);
        let names = |fields: &[Vec<String>], word: &str| fields.iter().flatten().any(|f| f == word);
        for word in quoted(&without_tests(&texts(code, ".rs"))) {
            let is_own = names(below, word) || OF_QUANTITY.contains(&word);
            assert!(
                is_own || !names(above, word),
                "{code} names {word} of a crate above"
            );
            seen += usize::from(is_own);
        }
    }
    assert!(seen > 40, "{seen}");
}

#[test]
fn fields_areas_and_quoted_words_are_told_apart() {
    let fluent =
        "scene-no-key = { $typed } of { $kind ->\n    [a] one\n}\n    .help = see { $other-key }\n";
    assert_eq!(
        fields_and_areas(fluent),
        ["typed", "kind", "other", "scene"]
    );
    assert_eq!(
        quoted("a: &[\"known\", \"b c\", \"near\"]"),
        ["known", "near"]
    );
}
