//! `gaitcam init MACHINE`: writes a scene template in which a comment explains each key.
//!
//! There is one TOML file per machine. A line `#- key = value` contains an optional key, which is written as a comment. `gaitcam keys`
//! prints the same explanations.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use gaitcam::error::{Placed, Result};
use gaitcam::scene::keys::{self, KEYS, Key};
use gaitcam::wording::{Language, key_doc};
use gaitcam_app::folder::write_whole;
use serde_json::json;

use crate::console::error::CliError;
use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::terminal::print;
use crate::console::words;

const EXAMPLES: &str = "Examples:
  gaitcam init
  gaitcam init shaker
  gaitcam init walk --out my_walk.toml";

/// Maximum length of a comment line, characters.
const WIDTH: usize = 100;
/// Prefix that marks a template line with an optional key.
const OFFERED: &str = "#- ";

/// Arguments of `gaitcam init`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct InitArgs {
    /// Machine; if omitted, the machines are listed
    machine: Option<Machine>,
    /// File to write, or - for standard output (default MACHINE.toml)
    #[arg(long, value_name = "FILE", requires = "machine")]
    out: Option<PathBuf>,
}

/// Machines for which a template exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Machine {
    Shaker,
    Walk,
    HeelTester,
    SpringBench,
    Programme,
}

impl Machine {
    fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |v| v.get_name().to_string())
    }

    fn template(self) -> &'static str {
        match self {
            Machine::Shaker => include_str!("shaker.toml"),
            Machine::Walk => include_str!("walk.toml"),
            Machine::HeelTester => include_str!("heel-tester.toml"),
            Machine::SpringBench => include_str!("spring-bench.toml"),
            Machine::Programme => include_str!("programme.toml"),
        }
    }

    /// Description of the machine in one sentence.
    fn doc(self) -> String {
        words::text(&format!("init-{}", self.name()))
    }
}

/// Writes the template of a machine. An existing file is never replaced.
pub fn run(args: &InitArgs) -> Result<u8> {
    let Some(machine) = args.machine else {
        for machine in Machine::value_variants() {
            print(&format!("{:14} {}", machine.name(), machine.doc()));
        }
        return Ok(BUILT);
    };
    let file = match &args.out {
        Some(out) => out.clone(),
        None => PathBuf::from(format!("{}.toml", machine.name())),
    };
    let heading = machine.doc();
    let text = scene(&heading, machine.template(), &file, language::current());
    if file == Path::new("-") {
        print(text.trim_end());
        return Ok(BUILT);
    }
    if file.exists() {
        return Err(CliError::FileIsThere.in_file(&file));
    }
    write_whole(&file, text.as_bytes())?;
    print(&words::fill(
        "init-written",
        &json!({"file": file.display().to_string()}),
    ));
    Ok(BUILT)
}

/// Scene file made from a template, with the explanation of each key above its line.
fn scene(heading: &str, template: &str, file: &Path, language: Language) -> String {
    let shown = if file == Path::new("-") {
        Path::new("scene.toml")
    } else {
        file
    };
    let how = words::fill("init-how", &json!({"file": shown.display().to_string()}));
    let mut out = wrapped(heading, "# ") + &wrapped(&how, "# ") + "\n";
    let mut section = String::new();
    let mut explained: Vec<&str> = Vec::new();
    for line in template.lines() {
        if line.starts_with('[') {
            section = line.trim_matches(['[', ']']).to_string();
        }
        let row = row_of(&section, line);
        // A key is explained only once, for example not again in the second segment of a programme.
        if let Some(row) = row.filter(|r| !explained.contains(&r.path)) {
            explained.push(row.path);
            let text = format!(
                "{} ({})",
                key_doc(language, row.path),
                keys::takes(row, language)
            );
            out += &wrapped(&text, "# ");
        }
        out += &line.replacen(OFFERED, "# ", 1);
        out += "\n";
    }
    out
}

/// Row of the key table for the key in a line of the template; `None` for other lines.
fn row_of(section: &str, line: &str) -> Option<&'static Key> {
    let (key, _) = line.trim_start_matches(OFFERED).split_once(" = ")?;
    let path = if section.is_empty() {
        key.to_string()
    } else {
        format!("{section}.{key}")
    };
    let numbered = format!("{section}.N.{key}");
    KEYS.iter().find(|k| k.path == path || k.path == numbered)
}

/// Text wrapped into comment lines that begin with `before`.
fn wrapped(text: &str, before: &str) -> String {
    let mut out = String::new();
    let mut line = before.to_string();
    for word in text.split_whitespace() {
        if line.len() > before.len() && line.chars().count() + word.chars().count() > WIDTH {
            out += line.trim_end();
            out.push('\n');
            line = before.to_string();
        }
        line += word;
        line.push(' ');
    }
    out + line.trim_end() + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_is_read_with_what_it_offers_and_each_key_is_explained() {
        for machine in Machine::value_variants() {
            for language in [Language::En, Language::Es] {
                let text = scene(
                    &machine.doc(),
                    machine.template(),
                    Path::new("a.toml"),
                    language,
                );
                let offered: String = text
                    .lines()
                    .map(|l| match l.strip_prefix("# ") {
                        Some(key)
                            if key.split_once(" = ").is_some_and(|(k, _)| !k.contains(' ')) =>
                        {
                            key
                        }
                        _ => l,
                    })
                    .flat_map(|l| [l, "\n"])
                    .collect();
                for text in [&text, &offered] {
                    let table: toml::Table = text.parse().unwrap();
                    gaitcam::scene::read(&table).unwrap();
                }
                let said: String = text
                    .lines()
                    .flat_map(|l| [l.trim_start_matches("# "), " "])
                    .collect();
                let mut section = "";
                for line in machine.template().lines() {
                    if line.starts_with('[') {
                        section = line.trim_matches(['[', ']']);
                    }
                    if line.contains(" = ") {
                        let row = row_of(section, line).expect(line);
                        assert!(said.contains(&key_doc(language, row.path)), "{line}");
                    }
                }
            }
        }
    }
}
