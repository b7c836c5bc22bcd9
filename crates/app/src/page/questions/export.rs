//! Files of a design that the page requests: the files that `synth` writes, and the files for manufacturing.

use serde::Deserialize;

use crate::files::{self, Source};
use crate::page::answer::{Answer, Body};
use crate::page::fault::StudioError;
use crate::page::kept::CachedDesign;
use crate::page::questions::design::made;
use crate::page::sources::Files;
use crate::page::{table, words};
#[cfg(feature = "cad")]
use crate::workshop::title;
use crate::{Contents, Remark, Workshop, design};
use gaitcam::error::{Error, Result};
use gaitcam::units::{Dimension, parse};

/// Request for a file of a design.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// TOML text of the scene.
    pub scene: String,
    /// Name of the file, as in the list of exports.
    pub name: String,
    /// Radius of the cutter, as typed by the user with its unit.
    #[serde(default)]
    pub tool: Option<String>,
}

/// Response with the requested file, or with the reason why it cannot be made.
pub fn file(files: &Files, asked: &Export) -> Answer {
    let made = table(&asked.scene).and_then(|table| made(files, table));
    let tool = asked.tool.as_deref();
    match made.and_then(|made| bytes(&made, &asked.name, tool)) {
        Ok(bytes) => Answer {
            understood: true,
            body: Body::File {
                name: asked.name.clone(),
                kind: kind(&asked.name),
                bytes,
            },
        },
        Err(error) => Answer::of::<()>(Err(error)),
    }
}

/// Media type for the extension of a file name.
fn kind(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("csv") => "text/csv; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("html") => "text/html; charset=utf-8",
        Some("json") => "application/json",
        Some("toml") => "application/toml",
        _ => "application/octet-stream",
    }
}

/// Content of a file of the design. `tool` is the radius of the cutter as typed by the user.
fn bytes(kept: &CachedDesign, name: &str, tool: Option<&str>) -> Result<Vec<u8>> {
    match name {
        "scene.toml" => {
            return Ok(toml::to_string(&kept.whole)
                .unwrap_or_default()
                .into_bytes());
        }
        "summary.json" => {
            let summary = design::summary(&kept.design, &kept.whole, kept.time);
            return Ok(serde_json::to_vec_pretty(&summary).unwrap_or_default());
        }
        _ => {}
    }
    let none = || {
        let name = name.to_string();
        Error::from(StudioError::NoFile { name })
    };
    let file = files::of(&kept.design).find(|file| file.name == name);
    let file = file.ok_or_else(none)?;
    let contents = Contents {
        language: words::current(),
        workshop: workshop(kept, tool)?,
        ..Contents::default()
    };
    let (bytes, remarks) = file.make(&Source::new(&kept.design, kept.time, &contents))?;
    let fault = remarks.into_iter().find_map(Remark::into_fault);
    bytes.ok_or_else(|| fault.unwrap_or_else(none))
}

/// Options of the files for manufacturing.
#[cfg(feature = "cad")]
fn workshop(kept: &CachedDesign, tool: Option<&str>) -> Result<Workshop> {
    Ok(Workshop {
        tool: tool.map(radius).transpose()?,
        title: title(&kept.scene, &kept.whole),
        ..Workshop::default()
    })
}

/// Options of the files for manufacturing. The module without CAD does not make these files, so only the radius of the cutter is checked.
#[cfg(not(feature = "cad"))]
fn workshop(_: &CachedDesign, tool: Option<&str>) -> Result<Workshop> {
    tool.map(radius).transpose()?;
    Ok(Workshop::default())
}

/// Radius of the cutter in m, parsed from the text of the user.
fn radius(tool: &str) -> Result<f64> {
    let radius = parse(tool, Dimension::Length)?;
    if radius <= 0.0 {
        let fault = tool.to_string();
        return Err(Error::from(StudioError::BadRequest { fault }));
    }
    Ok(radius)
}
