//! Every public type of the library has an example in its documentation.
//!
//! Public types are reachable from `lib.rs` by `pub mod` and `pub use`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Module: its file, and the folder of its submodules.
#[derive(Debug, Clone)]
struct Module {
    file: PathBuf,
    folder: PathBuf,
    /// Source folder of the crate.
    root: PathBuf,
}

impl Module {
    fn library() -> Module {
        Module::root_of(Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
    }

    fn root_of(root: PathBuf) -> Module {
        Module {
            file: root.join("lib.rs"),
            folder: root.clone(),
            root,
        }
    }

    /// Root module of a crate of the workspace.
    fn of_crate(name: &str) -> Option<Module> {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates");
        let root = crates.join(name.trim_start_matches("gaitcam_")).join("src");
        root.exists().then(|| Module::root_of(root))
    }

    /// Submodule of this name.
    fn inner(&self, name: &str) -> Option<Module> {
        let folder = self.folder.join(name);
        let files = [folder.with_extension("rs"), folder.join("mod.rs")];
        let file = files.into_iter().find(|file| file.exists())?;
        let root = self.root.clone();
        Some(Module { file, folder, root })
    }

    fn text(&self) -> String {
        fs::read_to_string(&self.file).unwrap()
    }

    /// Statements of the module itself, each with the attributes and documentation before it.
    fn statements(&self) -> Vec<(String, String)> {
        let text = self.text();
        let mut out = Vec::new();
        let (mut before, mut lines) = (String::new(), text.lines());
        while let Some(line) = lines.next() {
            if line.starts_with("///") || line.starts_with("#[") {
                before += line;
                before += "\n";
                continue;
            }
            if line.starts_with("pub") {
                let mut whole = line.to_string();
                while whole.contains(" use ") && !whole.ends_with(';') {
                    whole += lines.next().unwrap_or(";").trim();
                }
                out.push((std::mem::take(&mut before), whole));
            } else if line.is_empty() || line.starts_with('}') {
                before.clear();
            }
        }
        out
    }

    /// File that defines the type of this name, and whether its documentation contains an example.
    fn type_named(&self, name: &str) -> Option<(PathBuf, bool)> {
        for (before, statement) in self.statements() {
            if type_name(&statement) == Some(name) {
                return Some((self.file.clone(), before.contains("```")));
            }
        }
        let uses = self.statements();
        let uses = uses.iter().flat_map(|(_, statement)| used(statement));
        // A path of one name is that of a crate from outside.
        let named = |path: &str, shown: &str| shown == name && path.contains("::");
        let mut uses = uses.filter(|(path, shown)| named(path, shown));
        uses.next().and_then(|(path, _)| {
            let (module, original) = self.followed(&path)?;
            module.type_named(&original)
        })
    }

    /// Module at the end of a path, and the last name of the path.
    fn followed(&self, path: &str) -> Option<(Module, String)> {
        let mut parts: Vec<&str> = path.split("::").collect();
        let last = parts.pop()?.to_string();
        let mut at = self.clone();
        for part in parts {
            at = match part {
                "crate" => Module::root_of(at.root),
                _ => at.inner(part).or_else(|| Module::of_crate(part))?,
            };
        }
        Some((at, last))
    }

    /// Adds every public type to `out`.
    fn collect(&self, out: &mut BTreeMap<(PathBuf, String), bool>) {
        for (before, statement) in self.statements() {
            let hidden = before.contains("cfg(doctest)");
            if hidden || statement.starts_with("pub(") {
                continue;
            }
            if let Some(name) = type_name(&statement) {
                out.insert(
                    (self.file.clone(), name.to_string()),
                    before.contains("```"),
                );
            } else if let Some(name) = statement.strip_prefix("pub mod ") {
                let inner = self.inner(name.trim_end_matches(';'));
                inner.unwrap_or_else(|| panic!("{statement}")).collect(out);
            }
            // Types of another library have examples of their own.
            let own = |path: &str| !path.starts_with("nalgebra::");
            for (path, _) in used(&statement).into_iter().filter(|(path, _)| own(path)) {
                let (module, name) = self
                    .followed(&path)
                    .unwrap_or_else(|| panic!("{statement}: {path}"));
                if name == "self" {
                    module.collect(out);
                } else if let Some(inner) = module.inner(&name) {
                    // A module and a function may share a name: only the module holds types.
                    if !module.text().contains(&format!("pub fn {name}(")) {
                        inner.collect(out);
                    }
                } else if let Some((file, example)) = module.type_named(&name) {
                    out.insert((file, name), example);
                }
            }
        }
    }
}

/// Name of the type that a statement defines.
fn type_name(statement: &str) -> Option<&str> {
    let rest = statement.strip_prefix("pub ")?;
    let kinds = ["struct ", "enum ", "trait ", "type "];
    let name = kinds.iter().find_map(|kind| rest.strip_prefix(kind))?;
    name.split(|c: char| !c.is_alphanumeric() && c != '_')
        .next()
}

/// Paths that a `use` imports, each with the name it gets.
fn used(statement: &str) -> Vec<(String, String)> {
    let Some((_, tree)) = statement.split_once(" use ") else {
        return Vec::new();
    };
    let tree = tree.trim_end_matches(';');
    let (prefix, names) = match tree.split_once('{') {
        Some((prefix, names)) => (prefix, names.trim_end_matches('}')),
        None => tree
            .rfind("::")
            .map_or(("", tree), |at| tree.split_at(at + 2)),
    };
    let names = names.split(',').map(str::trim).filter(|n| !n.is_empty());
    names
        .map(|name| {
            let (name, shown) = name.split_once(" as ").unwrap_or((name, name));
            (format!("{prefix}{name}"), shown.to_string())
        })
        .collect()
}

#[test]
fn every_public_type_shows_how_one_gets_it() {
    let mut types = BTreeMap::new();
    Module::library().collect(&mut types);
    assert!(types.len() > 200, "only {} types were found", types.len());
    let without: Vec<String> = types
        .iter()
        .filter(|(_, example)| !**example)
        .map(|((file, name), _)| format!("{}: {name}", file.display()))
        .collect();
    assert!(
        without.is_empty(),
        "{} of {} public types have no example:\n{}",
        without.len(),
        types.len(),
        without.join("\n")
    );
    println!("{} public types, each with an example", types.len());
}
