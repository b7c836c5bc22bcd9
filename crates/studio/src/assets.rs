//! The page's files, held in the binary.

use crate::http::Response;
use gaitcam::wording::Language;
use gaitcam_output::report::MOTION_SCRIPT;

const PAGE: &str = include_str!("../page/index.html");
const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";

macro_rules! files {
    ($($name:literal: $kind:expr),+ $(,)?) => {
        &[
            ("core/motion.js", SCRIPT, MOTION_SCRIPT),
            $(($name, $kind, include_str!(concat!("../page/", $name)))),+
        ]
    };
}

/// Name, media type and contents.
const FILES: &[(&str, &str, &str)] = files![
    "style.css": STYLE,
    "panels.css": STYLE,
    "app.js": SCRIPT,
    "core/autosave.js": SCRIPT,
    "core/blobs.js": SCRIPT,
    "core/clock.js": SCRIPT,
    "core/designs.js": SCRIPT,
    "core/dom.js": SCRIPT,
    "core/net.js": SCRIPT,
    "core/packing.js": SCRIPT,
    "core/status.js": SCRIPT,
    "core/typed.js": SCRIPT,
    "core/versions.js": SCRIPT,
    "core/view.js": SCRIPT,
    "core/words.js": SCRIPT,
    "core/zip.js": SCRIPT,
    "panels/chart.js": SCRIPT,
    "panels/charts.js": SCRIPT,
    "panels/compare.js": SCRIPT,
    "panels/exports.js": SCRIPT,
    "panels/files.js": SCRIPT,
    "panels/force.js": SCRIPT,
    "panels/form.js": SCRIPT,
    "panels/gallery.js": SCRIPT,
    "panels/hand.js": SCRIPT,
    "panels/handles.js": SCRIPT,
    "panels/history.js": SCRIPT,
    "panels/player.js": SCRIPT,
    "panels/programme.js": SCRIPT,
    "panels/stage.js": SCRIPT,
    "panels/text.js": SCRIPT,
    "panels/tools.js": SCRIPT,
    "panels/verdict.js": SCRIPT,
];

/// The page itself: its other files lie under `base`.
pub fn page(base: &str, language: Language) -> Response {
    let page = fresh("index.html").unwrap_or_else(|| PAGE.to_string());
    let page = page
        .replace("{base}", base)
        .replace("{language}", language.tag())
        .replace("{engine}", "native");
    Response::new(HTML, page)
}

/// One of its files.
pub fn file(name: &str) -> Option<Response> {
    let found = FILES.iter().find(|f| f.0 == name)?;
    let text = fresh(name).unwrap_or_else(|| found.2.to_string());
    Some(Response::new(found.1, text))
}

/// The file in the source tree: development builds show a changed page on reload.
fn fresh(name: &str) -> Option<String> {
    if !cfg!(debug_assertions) {
        return None;
    }
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/page");
    std::fs::read_to_string(std::path::Path::new(page).join(name)).ok()
}
