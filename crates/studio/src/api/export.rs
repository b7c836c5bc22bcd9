//! Files of a design, each made when it is asked for: those that `synth` writes, and those for the workshop.

use crate::fault::StudioError;
use crate::http::{Response, Status};
use crate::studio::{Kept, Studio};
use crate::words;
use gaitcam::cam::Wall;
use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam::units::{Dimension, parse};
use gaitcam_cad::{self as cad, cutter, dxf, gcode, solid};
use gaitcam_output::{self as output, files};

/// Rows of the tables, as `synth` writes them.
const ROWS: usize = 1440;
/// Vertices of a solid's profile and of the polylines beside the arcs.
const VERTICES: usize = 720;
/// Largest distance of the fitted arcs from the profile, m.
const ARCS: f64 = 1e-6;
/// Triangles of a groove's wall along and through it.
const WALL: (usize, usize) = (720, 8);

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
    match contents(&kept, name, tool) {
        Some(Ok(bytes)) => Response::new(kind(name), bytes).saved_as(name),
        Some(Err(error)) => Response {
            status: Status::BadRequest,
            ..Response::json(&super::fault_json(&error))
        },
        None => Response::refusal(Status::NotFound),
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
fn contents(kept: &Kept, name: &str, tool: Option<&str>) -> Option<Result<Vec<u8>>> {
    let design = &kept.design;
    let language = words::current();
    let text = |text: String| Some(Ok(text.into_bytes()));
    match name {
        "scene.toml" => return text(toml::to_string(&kept.whole).unwrap_or_default()),
        "report.html" => return text(output::report::html(design, kept.time, language)),
        "summary.json" => {
            let mut summary = output::json::summary(design, kept.time);
            summary["scene"] = serde_json::to_value(&kept.whole).unwrap_or_default();
            return text(serde_json::to_string_pretty(&summary).unwrap_or_default());
        }
        _ if files::of(design).all(|file| file.name != name) => return None,
        _ => {}
    }
    match name {
        "law.csv" => text(output::csv::law(design, ROWS)),
        "profile.csv" => text(output::csv::profile(design, ROWS)),
        "second_profile.csv" => {
            let second = design.conjugate.as_ref()?.second_profile(ROWS);
            text(output::csv::points(&second))
        }
        "profile.dxf" => Some(Ok(dxf::profile(design, ROWS, dxf::Content::All))),
        "profile.svg" => text(cad::svg::profile(design, ROWS)),
        "svaj.svg" => text(output::plots::svaj(design, language).svg()),
        "svaj.png" => Some(Ok(output::plots::svaj(design, language).png())),
        "force.svg" => text(output::plots::force(design, language).svg()),
        "force.png" => Some(Ok(output::plots::force(design, language).png())),
        "cam.svg" => text(output::plots::cam(design, language).svg()),
        "cam.png" => Some(Ok(output::plots::cam(design, language).png())),
        _ => workshop(kept, name, tool),
    }
}

fn workshop(kept: &Kept, name: &str, tool: Option<&str>) -> Option<Result<Vec<u8>>> {
    let design = &kept.design;
    let plate = solid::Plate {
        thickness: design.thickness,
        bore: design.bore,
        points: VERTICES,
    };
    match name {
        "profile.xlsx" => Some(output::xlsx::workbook(design, kept.time, words::current())),
        "groove_upper.stl" => wall(design, Wall::Upper),
        "groove_lower.stl" => wall(design, Wall::Lower),
        "drawing.pdf" => Some(Ok(drawing(kept))),
        "cutter.csv" | "cutter.nc" | "cutter_second.nc" => Some(cut(design, name, tool)),
        "profile.stl" => Some(solid::stl(design, plate)),
        "profile.3mf" => Some(solid::threemf(design, plate)),
        "cam.step" => Some(cad::step::solid(design)),
        "profile_arcs.dxf" => {
            let options = dxf::Options {
                points: VERTICES,
                version: dxf::Version::R2000,
                bore: design.bore,
                content: dxf::Content::All,
            };
            Some(Ok(dxf::arcs(design, ARCS, options)?.bytes))
        }
        _ => None,
    }
}

fn wall(design: &Design, wall: Wall) -> Option<Result<Vec<u8>>> {
    let mesh = solid::wall(design.groove.as_ref()?, wall, WALL.0, WALL.1);
    Some(solid::binary_stl(&mesh))
}

/// The drawing, its revision that of the scene.
fn drawing(kept: &Kept) -> Vec<u8> {
    let scene = toml::to_string(&kept.whole).unwrap_or_default();
    let usual = cad::drawing::Title::default();
    let title = cad::drawing::Title {
        revision: Some(cad::drawing::revision(&scene)),
        accuracy: kept.scene.rms.unwrap_or(usual.accuracy),
        ..usual
    };
    cad::drawing::pdf(&kept.design, &title, words::current())
}

/// The path of a cutter, or the program for it.
fn cut(design: &Design, name: &str, tool: Option<&str>) -> Result<Vec<u8>> {
    let radius = match tool {
        Some(tool) => parse(tool, Dimension::Length)?,
        None => files::usual_cutter(design),
    };
    if radius <= 0.0 {
        let fault = tool.unwrap_or_default().to_string();
        return Err(Error::from(StudioError::BadRequest { fault }));
    }
    if name == "cutter.csv" {
        let path = cutter::path(design, radius, ROWS)?;
        return Ok(cutter::csv(&path).into_bytes());
    }
    let programs = gcode::milling(design, radius)?;
    let own = programs.into_iter().find(|program| program.file == name);
    Ok(own.map_or(Vec::new(), |program| program.text.into_bytes()))
}
