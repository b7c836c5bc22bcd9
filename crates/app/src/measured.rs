//! Points measured on a coordinate measuring machine, read from a table with units in the column names.

use std::path::Path;

use gaitcam::error::{FileError, Placed, Result};

use crate::read::{not_csv, read_bytes};

/// Accepted column names, each with its quantity and its conversion factor to SI units.
const COLUMNS: [(&str, Kind, f64); 11] = [
    ("x_mm", Kind::X, 1e-3),
    ("y_mm", Kind::Y, 1e-3),
    ("x_m", Kind::X, 1.0),
    ("y_m", Kind::Y, 1.0),
    ("angle_deg", Kind::Angle, std::f64::consts::PI / 180.0),
    ("angle_rad", Kind::Angle, 1.0),
    ("radius_mm", Kind::Radius, 1e-3),
    ("radius_m", Kind::Radius, 1.0),
    ("x_in", Kind::X, 0.0254),
    ("y_in", Kind::Y, 0.0254),
    ("radius_in", Kind::Radius, 0.0254),
];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    X,
    Y,
    Angle,
    Radius,
}

/// Index of a column, and its conversion factor to SI units.
type Column = (usize, f64);

/// Columns with the coordinates of a point: Cartesian or polar.
enum Coordinates {
    Cartesian([Column; 2]),
    Polar([Column; 2]),
}

/// Measured points, m, each with its line in the file.
pub struct Points {
    /// Measured coordinates x and y in the frame of the file, m.
    pub xy: Vec<[f64; 2]>,
    /// Line of each point in the file, counted from 1.
    pub lines: Vec<usize>,
}

/// Reads points from a table with the columns `x_mm,y_mm` or `angle_deg,radius_mm`. The units m, in and rad are also accepted. Separators are
/// commas, semicolons or tabs. Other columns are ignored.
///
/// # Errors
///
/// The file cannot be read, columns are missing, or a cell is not a finite number. For such a cell, the error contains its line.
pub fn read(path: &Path) -> Result<Points> {
    let bytes = read_bytes(path)?;
    let head = bytes.split(|b| *b == b'\n').next().unwrap_or_default();
    let separator = [b';', b'\t', b',']
        .into_iter()
        .find(|s| head.contains(s))
        .unwrap_or(b',');
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(separator)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(bytes.as_slice());
    let broken = not_csv(path);
    let names: Vec<String> = reader
        .headers()
        .map_err(&broken)?
        .iter()
        .map(|name| name.trim_start_matches('\u{feff}').to_lowercase())
        .collect();
    let coordinates = coordinates(&names).ok_or_else(|| {
        let found = names.join(", ");
        FileError::MeasuredColumns { found }.at_line(path, 1)
    })?;
    let mut out = Points {
        xy: Vec::new(),
        lines: Vec::new(),
    };
    for record in reader.records() {
        let record = record.map_err(&broken)?;
        let line = record.position().map_or(1, |p| p.line() as usize);
        let number = |(column, factor): Column| {
            let field = record.get(column).unwrap_or_default();
            let value = field.parse::<f64>().ok().filter(|x| x.is_finite());
            value.map(|x| factor * x).ok_or_else(|| {
                let typed = field.chars().take(40).collect();
                FileError::MeasuredField { typed }.at_line(path, line)
            })
        };
        let point = match coordinates {
            Coordinates::Cartesian([x, y]) => [number(x)?, number(y)?],
            Coordinates::Polar([angle, radius]) => {
                let (sin, cos) = libm::sincos(number(angle)?);
                let r = number(radius)?;
                [r * cos, r * sin]
            }
        };
        out.xy.push(point);
        out.lines.push(line);
    }
    Ok(out)
}

fn coordinates(names: &[String]) -> Option<Coordinates> {
    let column = |kind: Kind| {
        COLUMNS.iter().filter(|c| c.1 == kind).find_map(|c| {
            let place = names.iter().position(|name| name == c.0)?;
            Some((place, c.2))
        })
    };
    let pair = |a, b| Some([column(a)?, column(b)?]);
    let cartesian = pair(Kind::X, Kind::Y).map(Coordinates::Cartesian);
    cartesian.or_else(|| pair(Kind::Angle, Kind::Radius).map(Coordinates::Polar))
}
