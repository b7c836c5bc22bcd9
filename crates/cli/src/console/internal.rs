//! Internal errors. A panic on any thread leads to an error message, exit code 1 and a file for a bug report.

use std::fs::File;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::path::PathBuf;
use std::process::id;
use std::sync::{Mutex, PoisonError};

use gaitcam::error::Result;
use serde_json::json;
use toml::Table;

use crate::console::exit_code::INTERNAL_ERROR;
use crate::console::terminal::{print_json, report};
use crate::console::words;

/// Last scene that was read. It is written into a bug report.
static SCENE: Mutex<Option<Table>> = Mutex::new(None);
/// Message and source location of the first panic.
static PANIC: Mutex<Option<String>> = Mutex::new(None);

/// Stores a scene for a possible bug report.
pub fn keep(scene: &Table) {
    *SCENE.lock().unwrap_or_else(PoisonError::into_inner) = Some(scene.clone());
}

/// Runs a command and reports a panic, if one occurs. The backtrace is not printed, because it does not help the user.
pub fn caught(
    json: bool,
    work: impl FnOnce() -> Result<u8>,
) -> std::result::Result<Result<u8>, u8> {
    set_hook(Box::new(|panic| {
        let mut first = PANIC.lock().unwrap_or_else(PoisonError::into_inner);
        first.get_or_insert_with(|| panic.to_string());
    }));
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| {
        let file = written().map(|path| path.display().to_string());
        let sentence = words::fill("run-internal-error", &json!({"file": file}));
        if json {
            print_json(&json!({"error": {"code": "internal-error", "message": sentence}}));
        }
        report(sentence);
        INTERNAL_ERROR
    })
}

/// Writes a file for a bug report: the command and the error as comments, then the scene. Returns the path of the file.
fn written() -> Option<PathBuf> {
    let panic = PANIC.lock().unwrap_or_else(PoisonError::into_inner).take();
    let scene = SCENE.lock().unwrap_or_else(PoisonError::into_inner).take();
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let about = format!(
        "gaitcam {} on {}\narguments: {arguments:?}\n{}",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        panic.unwrap_or_default()
    );
    let about: String = about.lines().map(|line| format!("# {line}\n")).collect();
    let scene = toml::to_string(&scene.unwrap_or_default()).unwrap_or_default();
    let name = |number: u32| format!("gaitcam-error-{}-{number}.toml", id());
    let places = (1..100).map(|number| std::env::temp_dir().join(name(number)));
    let (mut file, path) = places
        .filter_map(|path| Some((File::create_new(&path).ok()?, path)))
        .next()?;
    file.write_all((about + &scene).as_bytes()).ok()?;
    Some(path)
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::*;

    #[test]
    fn a_panic_on_any_thread_is_a_code_and_a_file_with_the_scene() {
        let on_this = || panic!("on this thread");
        let in_a_scope = || {
            std::thread::scope(|scope| {
                scope.spawn(|| panic!("in a scope"));
            });
            Ok(0)
        };
        let in_a_pool = || {
            (0..100)
                .into_par_iter()
                .for_each(|i| assert_ne!(i, 40, "in a pool"));
            Ok(0)
        };
        let all: [(&str, &dyn Fn() -> Result<u8>); 3] = [
            ("on this thread", &on_this),
            ("in a scope", &in_a_scope),
            ("in a pool", &in_a_pool),
        ];
        for (said, work) in all {
            keep(&gaitcam::scene::DEFAULT.parse().unwrap());
            let ended = caught(false, work);
            let _ = std::panic::take_hook();
            assert!(matches!(ended, Err(INTERNAL_ERROR)));
            let own = format!("gaitcam-error-{}-", id());
            let files = std::fs::read_dir(std::env::temp_dir()).unwrap().flatten();
            let found: Vec<PathBuf> = files
                .filter(|f| f.file_name().to_string_lossy().starts_with(&own))
                .map(|f| f.path())
                .collect();
            let [file] = &found[..] else {
                panic!("{found:?}");
            };
            let text = std::fs::read_to_string(file).unwrap();
            std::fs::remove_file(file).unwrap();
            assert!(
                text.starts_with("# gaitcam ") && text.contains(said),
                "{text}"
            );
            let scene = gaitcam::scene::parse(&text).unwrap();
            assert_eq!(
                scene,
                gaitcam::scene::parse(gaitcam::scene::DEFAULT).unwrap()
            );
        }
    }
}
