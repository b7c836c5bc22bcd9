//! Files of the page, which are included in the program.

use crate::http::Response;
use gaitcam::wording::Language;
use gaitcam_output::report::MOTION_SCRIPT;

const PAGE: &str = include_str!("../page/index.html");
const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";

/// Name, media type and content of each file of the page. The build script lists the files.
const FILES: &[(&str, &str, &str)] = include!(concat!(env!("OUT_DIR"), "/page.rs"));
/// File of the page that is also part of the report.
const MOTION: &str = "core/motion.js";

/// Response with the main HTML file of the page. `base` is the URL prefix of its other files. If `language` is `None`, the page uses the language
/// of the browser.
pub fn page(base: &str, language: Option<Language>) -> Response {
    let page = fresh("index.html").unwrap_or_else(|| PAGE.to_string());
    let page = page
        .replace("{base}", base)
        .replace("{engine}", "native")
        .replace("{language}", language.map_or("", Language::tag));
    Response::new(HTML, page)
}

/// Response with one of the page's files; `None` for an unknown name.
pub fn file(name: &str) -> Option<Response> {
    if name == MOTION {
        return Some(Response::new(SCRIPT, MOTION_SCRIPT));
    }
    let found = FILES.iter().find(|f| f.0 == name)?;
    let text = fresh(name).unwrap_or_else(|| found.2.to_string());
    Some(Response::new(found.1, text))
}

/// Content of the file in the source tree, so that a development build shows changes after a reload. `None` in other builds, or if the file cannot
/// be read.
fn fresh(name: &str) -> Option<String> {
    if !cfg!(debug_assertions) {
        return None;
    }
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/page");
    std::fs::read_to_string(std::path::Path::new(page).join(name)).ok()
}
