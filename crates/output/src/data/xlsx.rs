//! Workbook with the summary and with the table of the program CAM-DAS (Serrano Muñoz 2010, "Exportar-Excel"). Each quantity is in the
//! same cell as in CAM-DAS.

use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, Worksheet, XlsxError};
use serde_json::Value;

use super::csv::Columns;
use super::json;
use crate::Timing;
use crate::words::{self, Words};
use gaitcam::cam::{Measures, ProfilePoint};
use gaitcam::error::{Result, WriteError};
use gaitcam::synth::Design;
use gaitcam::wording::Language;

const MM: f64 = 1000.0;
/// Index of the row with the headings of the CAM-DAS table, counted from 0.
const HEADINGS: u32 = 9;
const FIRST: u32 = 10;

/// Workbook with two sheets: `cam`, with one row per degree in the columns of CAM-DAS, and `summary`.
///
/// Lengths are in mm and angles in degrees. The columns for velocity, acceleration and jerk are time derivatives at the speed of the cam.
/// The function fails only if the workbook cannot be assembled.
pub fn workbook(synthesis: &Design, time: Timing, language: Language) -> Result<Vec<u8>> {
    build(synthesis, time, &words::words(language)).map_err(not_built)
}

/// Workbook with one sheet of the given name, which contains the columns and their names.
///
/// # Errors
///
/// The workbook cannot be assembled.
pub fn table(name: &str, columns: &Columns) -> Result<Vec<u8>> {
    let built = || {
        let mut book = book(name)?;
        let sheet = book.add_worksheet();
        sheet.set_name(name)?;
        sheet.set_freeze_panes(1, 1)?;
        for (column, (heading, values)) in (0..).zip(columns) {
            sheet.write(0, column, *heading)?;
            sheet.set_column_width(column, heading.len() as f64 + 2.0)?;
            for (row, value) in (1..).zip(values).filter(|cell| cell.1.is_finite()) {
                sheet.write(row, column, *value)?;
            }
        }
        book.save_to_buffer()
    };
    built().map_err(not_built)
}

/// Workbook with the points of a plane curve. The first cell contains the unit, the second row the headings x, y, z, and each further row
/// one point.
///
/// # Errors
/// The workbook cannot be assembled.
pub fn points(unit: &str, points: &[[f64; 2]]) -> Result<Vec<u8>> {
    let built = || {
        let mut book = book("points")?;
        let sheet = book.add_worksheet();
        sheet.write(0, 0, unit)?;
        for (column, heading) in (0..).zip(["x", "y", "z"]) {
            sheet.write(1, column, heading)?;
        }
        for (row, [x, y]) in (2..).zip(points) {
            for (column, value) in (0..).zip([*x, *y, 0.0]) {
                sheet.write(row, column, value)?;
            }
        }
        book.save_to_buffer()
    };
    built().map_err(not_built)
}

fn not_built(fault: XlsxError) -> gaitcam::error::Error {
    let fault = fault.to_string();
    WriteError::NotPutTogether { fault }.into()
}

/// Empty workbook. Its creation date is fixed, so that equal results give equal files.
fn book(title: &str) -> std::result::Result<Workbook, XlsxError> {
    // The library assembles each sheet on a separate thread and panics if the system allows no thread.
    #[cfg(not(target_family = "wasm"))]
    std::thread::Builder::new()
        .spawn(|| ())
        .map_err(XlsxError::IoError)?;
    let mut book = Workbook::new();
    let epoch = ExcelDateTime::from_ymd(2000, 1, 1)?;
    let properties = DocProperties::new().set_title(title);
    book.set_properties(&properties.set_creation_datetime(&epoch));
    Ok(book)
}

fn build(
    synthesis: &Design,
    time: Timing,
    words: &Words,
) -> std::result::Result<Vec<u8>, XlsxError> {
    let mut book = book(&synthesis.problem.name)?;
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
    sheet.set_name("cam")?;
    sheet.set_freeze_panes(FIRST, 1)?;
    head(sheet, synthesis, words)?;
    let law = &synthesis.cam.law;
    let measures = synthesis.cam.follower.measures();
    let across = match measures {
        Measures::Straight => "sheet-travel",
        Measures::Translating | Measures::Oscillating => "sheet-angle",
    };
    let heading = Format::new().set_bold().set_text_wrap();
    sheet.write_with_format(HEADINGS, 0, words.text(across), &heading)?;
    let lift = measures.lift(0);
    let columns = columns(synthesis);
    for (letter, key, _) in columns.clone() {
        let name = words.fill(key, &[("unit", lift.name)]);
        sheet.write_with_format(HEADINGS, at(letter), name, &heading)?;
    }
    let (start, length) = law.extent();
    // The table has one row per degree, or per millimetre of travel.
    let step = measures.angle().factor;
    let last = (step * length + 1e-9).floor() as u32;
    for i in 0..=last {
        let theta = start + f64::from(i) / step;
        let row = Row {
            point: synthesis.cam.point(theta),
            motion: law.svaj(theta),
            lift: lift.factor,
        };
        sheet.write(FIRST + i, 0, step * start + f64::from(i))?;
        for (letter, _, value) in columns.clone() {
            let value = value(synthesis, &row);
            // Excel has no infinite numbers. The cell of the radius at a flat point is left empty.
            if value.is_finite() {
                sheet.write(FIRST + i, at(letter), value)?;
            }
        }
    }
    Ok(())
}

/// Writes the lines above the table: follower, name, verdict, main dimensions and speed.
fn head(
    sheet: &mut Worksheet,
    synthesis: &Design,
    words: &Words,
) -> std::result::Result<(), XlsxError> {
    let follower = &synthesis.cam.follower;
    let bold = Format::new().set_bold();
    let name = words.name(follower.name());
    let title = words.fill("sheet-title", &[("follower", &name)]);
    sheet.write_with_format(0, 0, title, &bold)?;
    sheet.write_with_format(1, 0, &synthesis.problem.name, &bold)?;
    let verdict = words.name(synthesis.verdict.name());
    let reason = synthesis.reason(words.language());
    sheet.write(2, 0, format!("{verdict}: {reason}"))?;
    let length = |x: f64| format!("{:.6} mm", MM * x);
    let speed = follower.measures().speed();
    let speed = speed.after(&format!("{:.6}", synthesis.problem.drive.speed));
    let lines = [
        ("sheet-base-radius", length(follower.base_radius())),
        ("sheet-prime-radius", length(follower.prime_radius())),
        ("sheet-roller-radius", length(follower.roller_radius())),
        ("sheet-offset", length(follower.offset())),
        ("sheet-speed", speed),
    ];
    let flat = |key: &str| follower.is_flat() && key == "sheet-roller-radius";
    for (row, (key, value)) in (3..).zip(lines) {
        if flat(key) {
            continue;
        }
        let value = words.decimal(value);
        sheet.write(row, 0, words.fill(key, &[("value", &value)]))?;
    }
    Ok(())
}

struct Row {
    point: ProfilePoint,
    motion: gaitcam::law::Svaj,
    /// Factor from SI to the displayed unit of lift.
    lift: f64,
}

/// A column of the workbook: its letter in CAM-DAS, the message key of its heading, and the function that computes its values.
type Column = (u8, &'static str, fn(&Design, &Row) -> f64);

/// Columns of the workbook for all kinds of cam.
const EVERY: [Column; 9] = [
    (b'B', "sheet-lift", |_, r| r.lift * r.motion.s),
    (b'C', "sheet-velocity", |s, r| {
        r.lift * r.motion.v * s.problem.drive.speed
    }),
    (b'D', "sheet-acceleration", |s, r| {
        r.lift * r.motion.a * s.problem.drive.speed.powi(2)
    }),
    (b'E', "sheet-jerk", |s, r| {
        r.lift * r.motion.j * s.problem.drive.speed.powi(3)
    }),
    (b'F', "sheet-curvature", |_, r| MM * r.point.rho),
    (b'I', "sheet-contour-radius", |_, r| {
        MM * libm::hypot(r.point.x, r.point.y)
    }),
    (b'J', "sheet-contour-angle", |_, r| {
        polar(r.point.x, r.point.y)
    }),
    (b'L', "sheet-contour-x", |_, r| MM * r.point.x),
    (b'M', "sheet-contour-y", |_, r| MM * r.point.y),
];

/// Additional columns for a translating flat face.
const FLAT: [Column; 2] = [
    (b'G', "sheet-contact-left", |_, r| {
        (-MM * r.motion.v).max(0.0)
    }),
    (b'H', "sheet-contact-right", |_, r| {
        (MM * r.motion.v).max(0.0)
    }),
];

/// Additional columns for a roller follower.
const ROLLER: [Column; 5] = [
    (b'G', "sheet-pressure-angle", |_, r| {
        r.point.pressure_angle.to_degrees()
    }),
    (b'O', "sheet-pitch-radius", |_, r| {
        MM * libm::hypot(r.point.pitch_x, r.point.pitch_y)
    }),
    (b'P', "sheet-pitch-angle", |_, r| {
        polar(r.point.pitch_x, r.point.pitch_y)
    }),
    (b'R', "sheet-pitch-x", |_, r| MM * r.point.pitch_x),
    (b'S', "sheet-pitch-y", |_, r| MM * r.point.pitch_y),
];

/// All columns for the kind of cam of a design.
fn columns(synthesis: &Design) -> impl Iterator<Item = Column> + Clone {
    let own: &[Column] = match synthesis.cam.face_width() {
        None => &ROLLER,
        Some(_) if synthesis.cam.follower.is_oscillating() => &[],
        Some(_) => &FLAT,
    };
    EVERY.iter().chain(own).copied()
}

/// Index of a column given by its letter.
fn at(letter: u8) -> u16 {
    u16::from(letter - b'A')
}

/// Angle from +x to the point (`x`, `y`), degrees in [0, 360).
fn polar(x: f64, y: f64) -> f64 {
    let angle = libm::atan2(y, x).to_degrees();
    if angle < 0.0 { angle + 360.0 } else { angle }
}

/// Writes the summary as rows with a key and a value. The keys of nested objects are joined by dots. Elements of lists are counted from 1.
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
