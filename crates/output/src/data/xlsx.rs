//! The workbook: CAM-DAS's own table (Serrano Muñoz 2010, "Exportar-Excel"), cell for cell, and the summary.

use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, Worksheet, XlsxError};
use serde_json::Value;

use super::json;
use crate::Timing;
use crate::pose::lift_unit;
use crate::pose::oscillates;
use crate::words::{self, Words};
use gaitcam::cam::{Measures, ProfilePoint};
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::wording::Language;

const MM: f64 = 1000.0;
/// Row of the headings (row 10 of the sheet) and of the first angle.
const HEADINGS: u32 = 9;
const FIRST: u32 = 10;

/// Workbook of two sheets: `cam`, with a row per degree in the columns CAM-DAS exports, and `summary`.
///
/// Lengths in mm, angles in degrees, v a j by time at the cam's speed. Fails only if the workbook cannot
/// be put together.
pub fn workbook(synthesis: &Design, time: Timing, language: Language) -> Result<Vec<u8>> {
    build(synthesis, time, &words::words(language)).map_err(|e| {
        let fault = e.to_string();
        WriteError::NotPutTogether { fault }.into()
    })
}

fn build(
    synthesis: &Design,
    time: Timing,
    words: &Words,
) -> std::result::Result<Vec<u8>, XlsxError> {
    let mut book = Workbook::new();
    // A fixed date: the same design gives the same bytes.
    let epoch = ExcelDateTime::from_ymd(2000, 1, 1)?;
    book.set_properties(
        &DocProperties::new()
            .set_title(&synthesis.name)
            .set_creation_datetime(&epoch),
    );
    cam_sheet(book.add_worksheet(), synthesis, words)?;
    let sheet = book.add_worksheet();
    sheet.set_name("summary")?;
    sheet.set_column_width(0, 34)?;
    sheet.set_column_width(1, 24)?;
    let mut row = 0;
    list(sheet, &mut row, "", &json::summary(synthesis, time))?;
    book.save_to_buffer()
}

fn cam_sheet(
    sheet: &mut Worksheet,
    synthesis: &Design,
    words: &Words,
) -> std::result::Result<(), XlsxError> {
    let cam = &synthesis.cam;
    let follower = &cam.follower;
    let bold = Format::new().set_bold();
    let heading = Format::new().set_bold().set_text_wrap();
    sheet.set_name("cam")?;
    sheet.set_freeze_panes(FIRST, 1)?;
    let name = words.name(follower.name());
    let title = words.fill("sheet-title", &[("follower", &name)]);
    sheet.write_with_format(0, 0, title, &bold)?;
    sheet.write_with_format(1, 0, &synthesis.name, &bold)?;
    let verdict = words.name(synthesis.verdict.name());
    let reason = synthesis.reason(words.language());
    sheet.write(2, 0, format!("{verdict}: {reason}"))?;
    let measures = follower.measures();
    let speed = measures
        .speed()
        .after(&format!("{:.6}", synthesis.drive.speed));
    let lengths = [
        ("sheet-base-radius", follower.base_radius()),
        ("sheet-prime-radius", follower.prime_radius()),
        ("sheet-roller-radius", follower.roller_radius()),
        ("sheet-offset", follower.offset()),
    ];
    for (row, (key, length)) in (3..).zip(lengths) {
        let value = words.decimal(format!("{:.6} mm", MM * length));
        sheet.write(row, 0, words.fill(key, &[("value", &value)]))?;
    }
    let speed = words.decimal(speed);
    sheet.write(7, 0, words.fill("sheet-speed", &[("value", &speed)]))?;
    let columns = columns(synthesis, words);
    for column in &columns {
        sheet.write_with_format(HEADINGS, column.at, &column.name, &heading)?;
    }
    let (start, length) = cam.law.extent();
    // A row for every degree, or every millimetre of travel.
    let step = measures.angle().factor;
    let last = (step * length + 1e-9).floor() as u32;
    for i in 0..=last {
        let theta = start + f64::from(i) / step;
        let row = Row {
            point: cam.point(theta),
            motion: cam.law.svaj(theta),
        };
        for column in &columns {
            let value = if column.at == 0 {
                step * start + f64::from(i)
            } else {
                (column.value)(synthesis, &row)
            };
            // Excel has no infinity: the radius of a flat spot is left empty.
            if value.is_finite() {
                sheet.write(FIRST + i, column.at, value)?;
            }
        }
    }
    Ok(())
}

struct Row {
    point: ProfilePoint,
    motion: gaitcam::law::Svaj,
}

struct Column {
    at: u16,
    name: String,
    value: fn(&Design, &Row) -> f64,
}

/// The columns of the kind of cam, with the letters CAM-DAS gives them.
fn columns(synthesis: &Design, words: &Words) -> Vec<Column> {
    let (_, unit) = lift_unit(synthesis);
    let mut out: Vec<Column> = Vec::new();
    let mut add = |letter: u8, name: String, value: fn(&Design, &Row) -> f64| {
        let at = u16::from(letter - b'A');
        out.push(Column { at, name, value });
    };
    let measures = synthesis.cam.follower.measures();
    let across = match measures {
        Measures::Straight => "sheet-travel",
        Measures::Translating | Measures::Oscillating => "sheet-angle",
    };
    add(b'A', words.text(across), |s, r| {
        s.cam.follower.measures().angle().factor * r.point.theta
    });
    add(b'B', words.fill("sheet-lift", &[("unit", unit)]), |s, r| {
        lift_unit(s).0 * r.motion.s
    });
    add(
        b'C',
        words.fill("sheet-velocity", &[("unit", unit)]),
        |s, r| lift_unit(s).0 * r.motion.v * s.drive.speed,
    );
    add(
        b'D',
        words.fill("sheet-acceleration", &[("unit", unit)]),
        |s, r| lift_unit(s).0 * r.motion.a * s.drive.speed.powi(2),
    );
    add(b'E', words.fill("sheet-jerk", &[("unit", unit)]), |s, r| {
        lift_unit(s).0 * r.motion.j * s.drive.speed.powi(3)
    });
    add(b'F', words.text("sheet-curvature"), |_, r| MM * r.point.rho);
    add(b'I', words.text("sheet-contour-radius"), |_, r| {
        MM * r.point.x.hypot(r.point.y)
    });
    add(b'J', words.text("sheet-contour-angle"), |_, r| {
        polar(r.point.x, r.point.y)
    });
    add(b'L', words.text("sheet-contour-x"), |_, r| MM * r.point.x);
    add(b'M', words.text("sheet-contour-y"), |_, r| MM * r.point.y);
    let flat = synthesis.cam.face_width().is_some();
    if flat && !oscillates(&synthesis.cam.follower) {
        add(b'G', words.text("sheet-contact-left"), |_, r| {
            (-MM * r.motion.v).max(0.0)
        });
        add(b'H', words.text("sheet-contact-right"), |_, r| {
            (MM * r.motion.v).max(0.0)
        });
    } else if !flat {
        add(b'G', words.text("sheet-pressure-angle"), |_, r| {
            r.point.pressure_angle.to_degrees()
        });
        add(b'O', words.text("sheet-pitch-radius"), |_, r| {
            MM * r.point.pitch_x.hypot(r.point.pitch_y)
        });
        add(b'P', words.text("sheet-pitch-angle"), |_, r| {
            polar(r.point.pitch_x, r.point.pitch_y)
        });
        add(b'R', words.text("sheet-pitch-x"), |_, r| {
            MM * r.point.pitch_x
        });
        add(b'S', words.text("sheet-pitch-y"), |_, r| {
            MM * r.point.pitch_y
        });
    }
    out
}

/// Angle from +x, degrees in [0, 360).
fn polar(x: f64, y: f64) -> f64 {
    let angle = y.atan2(x).to_degrees();
    if angle < 0.0 { angle + 360.0 } else { angle }
}

/// The summary as rows `key, value`, nested keys joined by dots and counted from 1 in lists.
fn list(
    sheet: &mut Worksheet,
    row: &mut u32,
    key: &str,
    value: &Value,
) -> std::result::Result<(), XlsxError> {
    let join = |name: &str| {
        if key.is_empty() {
            name.to_string()
        } else {
            format!("{key}.{name}")
        }
    };
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                list(sheet, row, &join(name), value)?;
            }
            return Ok(());
        }
        Value::Array(items) => {
            for (i, value) in items.iter().enumerate() {
                list(sheet, row, &join(&(i + 1).to_string()), value)?;
            }
            return Ok(());
        }
        Value::Null => {}
        Value::Bool(b) => {
            sheet.write(*row, 1, *b)?;
        }
        Value::Number(n) => {
            sheet.write(*row, 1, n.as_f64().unwrap_or(0.0))?;
        }
        Value::String(text) => {
            sheet.write(*row, 1, text)?;
        }
    }
    sheet.write(*row, 0, key)?;
    *row += 1;
    Ok(())
}
