//! `gaitcam keys` lists all keys of a scene file. `gaitcam scenes` lists the built-in scenes.

use clap::Args;
use gaitcam::error::Result;
use gaitcam::scene::keys::schema;
use gaitcam::scene::keys::{self, KEYS};
use gaitcam::scene::{SCENES, built_in};
use gaitcam::wording::{Language, key_doc, scene_doc};
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::terminal::{print, print_json};
use crate::console::words;

/// Arguments of `gaitcam keys`.
#[derive(Args, Debug)]
pub struct KeysArgs {
    /// Only keys that contain this text
    pattern: Option<String>,
    /// Print JSON
    #[arg(long, group = "form")]
    pub json: bool,
    /// Print a JSON Schema of the scene file, for editors
    #[arg(long, group = "form")]
    pub schema: bool,
    /// Print the reference page, Markdown
    #[arg(long, group = "form")]
    markdown: bool,
}

/// Arguments of `gaitcam scenes`.
#[derive(Args, Debug)]
pub struct ScenesArgs {
    /// Print this scene as TOML
    name: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Prints the keys of the scene file as a table, JSON, JSON Schema or Markdown page.
pub fn keys(args: &KeysArgs) -> Result<u8> {
    let matches = |path: &str| args.pattern.as_deref().is_none_or(|p| path.contains(p));
    if args.schema {
        print_json(&schema(language::current()));
        return Ok(BUILT);
    }
    if args.markdown {
        print(keys::markdown().trim_end());
        return Ok(BUILT);
    }
    if args.json {
        let all = keys::json();
        let list = all.as_array().cloned().unwrap_or_default();
        let mine = list
            .into_iter()
            .filter(|row| matches(row["key"].as_str().unwrap_or("")));
        print_json(&Value::Array(mine.collect()));
        return Ok(BUILT);
    }
    let mut any = false;
    for key in KEYS.iter().filter(|k| matches(k.path)) {
        any = true;
        let default = match key.default {
            "" => String::new(),
            text => format!(", {}", words::fill("keys-default", &json!({"text": text}))),
        };
        print(&format!(
            "{}  {}{default}",
            key.path,
            keys::takes(key, language::current())
        ));
        print(&format!("    {}", key_doc(language::current(), key.path)));
    }
    if !any {
        let pattern = args.pattern.as_deref().unwrap_or("");
        let pattern = pattern.to_string();
        return Err(CliError::NoKeyContains { pattern }.into());
    }
    Ok(BUILT)
}

/// Prints the list of built-in scenes, or one built-in scene.
pub fn scenes(args: &ScenesArgs) -> Result<u8> {
    let all = match args.name.as_deref() {
        Some(name) => vec![*built_in(name)?],
        None => SCENES.to_vec(),
    };
    match (&args.name, args.json) {
        (Some(_), false) => all.iter().for_each(|s| print(s.toml.trim_end())),
        (_, true) => {
            let list = all.iter().map(|s| {
                json!({
                    "name": s.name,
                    "doc": {"en": scene_doc(Language::En, s.name), "es": scene_doc(Language::Es, s.name)},
                    "toml": s.toml,
                })
            });
            print_json(&list.collect());
        }
        (None, false) => {
            for s in all {
                print(&format!(
                    "{:30} {}",
                    s.name,
                    scene_doc(language::current(), s.name)
                ));
            }
        }
    }
    Ok(BUILT)
}
