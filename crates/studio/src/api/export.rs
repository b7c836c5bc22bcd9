//! Files of a design, each made when it is asked for: those that `synth` writes, and those for the workshop.

use crate::fault::StudioError;
use crate::http::{Response, Status};
use crate::state::{Kept, Studio};
use crate::words;
use gaitcam::error::{Error, Result};
use gaitcam::units::{Dimension, parse};
use gaitcam_files::files::{self, Source};
use gaitcam_files::{Contents, Remark, design, scene};

/// One file of a design: `DESIGN/law.csv`.
pub fn file(studio: &Studio, path: &str, tool: Option<&str>) -> Response {
    let Some((id, name)) = path.split_once('/') else {
        return Response::refusal(Status::NotFound);
    };
    let Some(kept) = studio.kept(id) else {
        let forgotten = super::fault_json(&StudioError::Forgotten.into());
        return Response {
            status: Status::NotFound,
            ..Response::json(&forgotten)
        };
    };
    match bytes(&kept, name, tool) {
        Ok(Some(bytes)) => Response::new(kind(name), bytes).saved_as(name),
        Ok(None) => Response::refusal(Status::NotFound),
        Err(error) => Response {
            status: Status::BadRequest,
            ..Response::json(&super::fault_json(&error))
        },
    }
}

/// Media type by the ending.
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

/// The bytes of a file; `None` for names that this design has no file of.
fn bytes(kept: &Kept, name: &str, tool: Option<&str>) -> Result<Option<Vec<u8>>> {
    match name {
        "scene.toml" => return Ok(toml::to_string(&kept.whole).ok().map(String::into_bytes)),
        "summary.json" => {
            let summary = design::summary(&kept.design, &kept.whole, kept.time);
            return Ok(serde_json::to_vec_pretty(&summary).ok());
        }
        _ => {}
    }
    let Some(file) = files::of(&kept.design).find(|file| file.name == name) else {
        return Ok(None);
    };
    let contents = Contents {
        tool: tool.map(radius).transpose()?,
        title: scene::title(&kept.scene, &kept.whole),
        language: words::current(),
        ..Contents::default()
    };
    let (bytes, remarks) = file.make(&Source::new(&kept.design, kept.time, &contents))?;
    let fault = remarks.into_iter().find_map(Remark::into_fault);
    match (bytes, fault) {
        (None, Some(fault)) => Err(fault),
        (bytes, _) => Ok(bytes),
    }
}

/// The radius of a cutter as typed, m.
fn radius(tool: &str) -> Result<f64> {
    let radius = parse(tool, Dimension::Length)?;
    if radius <= 0.0 {
        let fault = tool.to_string();
        return Err(Error::from(StudioError::BadRequest { fault }));
    }
    Ok(radius)
}
