//! Lists the files of the page for `assets.rs`.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

fn main() {
    let page = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap()).join("page");
    let mut list = String::new();
    for folder in ["", "charts", "core", "dialogs", "engine", "panels"] {
        println!("cargo::rerun-if-changed={}", page.join(folder).display());
        let entries = fs::read_dir(page.join(folder)).unwrap();
        let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files {
            let name = file.strip_prefix(&page).unwrap().to_str().unwrap();
            let name = name.replace('\\', "/");
            let kind = match name.rsplit_once('.').unwrap_or_default().1 {
                "js" => "SCRIPT",
                "css" => "STYLE",
                _ => continue,
            };
            writeln!(list, "(\"{name}\", {kind}, include_str!({file:?})),").unwrap();
        }
    }
    let out = Path::new(&env::var("OUT_DIR").unwrap()).join("page.rs");
    fs::write(out, format!("&[{list}]")).unwrap();
}
