//! Motions whose numbers are in a file: `motion = "table lift.csv"`.
//!
//! The library does not read files. Before the scene is read, the caller replaces the file name by the rows of the file. A motion from a file is
//! therefore equivalent to a motion whose numbers are in the scene.

use std::path::{Path, PathBuf};

use toml::{Table, Value};

use crate::error::{Error, FileError, Placed, ReadError, Result, SceneError};
use crate::force::{Cell, NumberTable};
use crate::law::Rise;
use crate::scene::keys::short;
use crate::units::{Dimension, parse};

/// Path of a file as shown in messages, and content of the file.
type Content = (PathBuf, Vec<u8>);

/// Maximum size of a motion file, bytes (64 MiB).
pub const LARGEST_MOTION: u64 = 64 << 20;
/// Maximum number of rows of a motion.
const MOST_ROWS: usize = 10_000;
/// Maximum relative difference between the angle or lift of a segment and the value from its file.
const AGREEMENT: f64 = 1e-6;

/// Accepted names of the column with the cam angle.
const ANGLE: [&str; 4] = ["angle", "theta", "ángulo", "angulo"];
const TRAVEL: [&str; 3] = ["length", "travel", "recorrido"];
const LIFT: [&str; 5] = ["lift", "s", "elevación", "elevacion", "desplazamiento"];

/// Names of the files for motions and for the curve of the motor, as written in a scene.
///
/// ```
/// let scene: toml::Table = "[[law.segment]]\nmotion = \"table lift.csv\"".parse()?;
/// assert_eq!(gaitcam::scene::motion_files(&scene), [std::path::PathBuf::from("lift.csv")]);
/// # Ok::<(), toml::de::Error>(())
/// ```
pub fn motion_files(scene: &Table) -> Vec<PathBuf> {
    let named = |segment: &Value| {
        let motion = segment.get("motion")?.as_str()?;
        Rise::named_file(motion).map(PathBuf::from)
    };
    let curve = curve_file(scene).map(PathBuf::from);
    let motions = segments(scene).iter().filter_map(named);
    motions.chain(curve).collect()
}

/// Name of the file with the torque curve of the motor. `None` if the text of the key is a list of numbers.
fn curve_file(scene: &Table) -> Option<&str> {
    let curve = scene.get("machine")?.get("motor")?.get("curve")?.as_str()?;
    let first = curve.split_whitespace().next()?;
    first.parse::<f64>().is_err().then_some(curve)
}

/// Reads the table of a file. If the file contains no table, the error shows the start of the file.
fn find_table<'a>(path: &Path, bytes: &'a [u8], purpose: &str) -> Result<NumberTable<'a>> {
    NumberTable::find(path, bytes).map_err(|error| match error.fault() {
        Some(ReadError::NoTable { start }) => {
            let (start, purpose) = (start.clone(), purpose.to_string());
            FileError::NoTable { start, purpose }.in_file(path)
        }
        _ => error,
    })
}

/// Reads the file of the torque curve of the motor. Its speeds and torques replace the file name in `machine.motor.curve`.
fn put_curve(scene: &mut Table, read: &mut dyn FnMut(&Path) -> Result<Content>) -> Result<()> {
    let Some(file) = curve_file(scene).map(str::to_string) else {
        return Ok(());
    };
    let key = "machine.motor.curve";
    let (path, bytes) = read(Path::new(&file)).map_err(|e| e.at_key(key))?;
    let table = find_table(&path, &bytes, "motor")?;
    let column = |name: &str| {
        let place = table.names().iter().position(|n| n.trim() == name);
        place.ok_or_else(|| {
            let columns = table.names().join(", ");
            let column = name.to_string();
            FileError::MotorColumn { column, columns }.at_line(&path, table.header_line())
        })
    };
    let columns = [column("speed_rad_per_s")?, column("torque_n_m")?];
    let (mut text, mut before) = (String::new(), None);
    for (line, row) in table.rows() {
        let mut numbers = [0.0; 2];
        for (number, place) in numbers.iter_mut().zip(columns) {
            let cell = row.get(place);
            let fault = || {
                let typed = cell.map_or(String::new(), |c| c.text.clone());
                let column = table.names()[place].trim().to_string();
                FileError::MotionValue { column, typed }.at_line(&path, line)
            };
            *number = cell.and_then(|c| c.number).ok_or_else(fault)?;
        }
        let [speed, torque] = numbers;
        if before.is_some_and(|[w, t]: [f64; 2]| speed <= w || torque >= t) {
            return Err(SceneError::MotorCurve.at_line(&path, line));
        }
        before = Some(numbers);
        text.push_str(&format!("{speed} {torque} "));
    }
    let motor = scene.get_mut("machine").and_then(|m| m.get_mut("motor"));
    if let Some(motor) = motor.and_then(Value::as_table_mut) {
        motor.insert(
            "curve".to_string(),
            Value::String(text.trim_end().to_string()),
        );
    }
    Ok(())
}

/// Replaces every file name of a motion in a scene by the rows of the file. If a segment has no angle or lift, the values of the file are used.
///
/// The header of the table names a column `angle` (`length` for a translating cam) and a column `lift`. Each name contains the unit of the column
/// (`angle_deg`, `lift [mm]`). `read` returns the path for messages and the content of a file.
///
/// # Errors
/// Errors of `read`; invalid columns, units and rows, each with its line; an angle or a lift of a segment that differs from its file.
///
/// ```
/// use gaitcam::scene;
///
/// let text = "[drive]\nkind = \"fixed-axis\"\nspeed = \"60 rpm\"\n[cam]\nbase_radius = \"20 mm\"\n[law]\nfamily = \"program\"\n[[law.segment]]\nmotion = \"table up.csv\"\n\
///             [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-5 mm\"\nangle = \"270 deg\"";
/// let rows = b"angle_deg,lift_mm\n0,0\n30,1\n60,4\n90,5\n";
/// let whole = scene::with_motions(&text.parse()?, &mut |path| Ok((path.to_path_buf(), rows.to_vec())))?;
/// let scene = scene::read(&whole)?;
/// assert!((scene.law.segments[0].lift - 0.005).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn with_motions(
    scene: &Table,
    read: &mut dyn FnMut(&Path) -> Result<Content>,
) -> Result<Table> {
    let mut scene = scene.clone();
    put_curve(&mut scene, read)?;
    let law = scene.get_mut("law").and_then(|law| law.get_mut("segment"));
    let Some(list) = law.and_then(Value::as_array_mut) else {
        return Ok(scene);
    };
    for (i, segment) in list.iter_mut().enumerate() {
        let Some(segment) = segment.as_table_mut() else {
            continue;
        };
        let motion = segment.get("motion").and_then(Value::as_str);
        let Some(file) = motion.and_then(Rise::named_file) else {
            continue;
        };
        let key = format!("law.segment.{}", i + 1);
        let (path, bytes) =
            read(Path::new(file)).map_err(|e| e.at_key(&format!("{key}.motion")))?;
        if bytes.len() as u64 > LARGEST_MOTION {
            let mib = LARGEST_MOTION >> 20;
            return Err(FileError::TooLarge { mib }.in_file(&path));
        }
        let rows = Rows::read(&path, &bytes)?;
        rows.put(segment, &key, &path)?;
        let motion = rows.written();
        // Reports an error in the rows as an error in the file.
        Rise::from_name(&motion).map_err(|e| e.in_file(&path))?;
        segment.insert("motion".to_string(), Value::String(motion));
    }
    Ok(scene)
}

fn segments(scene: &Table) -> &[Value] {
    let list = scene.get("law").and_then(|law| law.get("segment"));
    list.and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// A column of a motion file, with its conversion factor to SI units.
struct Column {
    place: usize,
    /// Name of the column in the header.
    name: String,
    dimension: Dimension,
    factor: f64,
}

impl Column {
    /// First column whose name is in `names`, or `None`. Its unit must have one of the `dimensions`.
    fn find(
        path: &Path,
        table: &NumberTable,
        names: &[&str],
        dimensions: &[Dimension],
    ) -> Result<Option<Column>> {
        let found = (0..table.names().len()).find_map(|place| {
            let (name, unit) = table.name_and_unit(place);
            names.contains(&name.as_str()).then_some((place, unit))
        });
        let Some((place, unit)) = found else {
            return Ok(None);
        };
        let name = table.names()[place].trim().to_string();
        let factor =
            |d: &Dimension| Some((*d, parse(&format!("1 {}", unit.as_deref()?), *d).ok()?));
        let Some((dimension, factor)) = dimensions.iter().find_map(factor) else {
            let wanted = dimensions.iter().map(|d| d.si()).collect::<Vec<_>>();
            let (column, example) = (name, format!("{}_{}", names[0], wanted[0]));
            let fault = FileError::MotionUnit { column, example };
            return Err(fault.at_line(path, table.header_line()));
        };
        Ok(Some(Column {
            place,
            name,
            dimension,
            factor,
        }))
    }

    /// Number in this column of a row, without conversion of units. A missing cell and a cell without a number are errors.
    fn number(&self, path: &Path, line: usize, row: &[Cell]) -> Result<f64> {
        let cell = row.get(self.place);
        let fault = || {
            let typed = cell.map_or(String::new(), |c| c.text.clone());
            let column = self.name.clone();
            FileError::MotionValue { column, typed }.at_line(path, line)
        };
        cell.and_then(|c| c.number).ok_or_else(fault)
    }
}

/// Numbers of a motion as written in the file, in the units of the columns. Their last decimal shows how they are rounded.
struct Rows {
    angle: (Column, Vec<f64>),
    lift: (Column, Vec<f64>),
}

impl Rows {
    fn read(path: &Path, bytes: &[u8]) -> Result<Rows> {
        let table = find_table(path, bytes, "table")?;
        let missing = |column: &str, example: &str| {
            let fault = FileError::MotionColumn {
                column: column.to_string(),
                example: example.to_string(),
                columns: table.names().join(", "),
            };
            fault.at_line(path, table.header_line())
        };
        let lift = Column::find(path, &table, &LIFT, &[Dimension::Length, Dimension::Angle])?
            .ok_or_else(|| missing("lift", "lift_mm"))?;
        let turned = Column::find(path, &table, &ANGLE, &[Dimension::Angle])?;
        let angle = match turned {
            Some(angle) => angle,
            None => Column::find(path, &table, &TRAVEL, &[Dimension::Length])?
                .ok_or_else(|| missing("angle", "angle_deg"))?,
        };
        let (mut angles, mut lifts): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (line, row) in table.rows() {
            if lifts.len() == MOST_ROWS {
                return Err(FileError::MotionManyRows { most: MOST_ROWS }.at_line(path, line));
            }
            let x = angle.number(path, line, &row)?;
            if angles.last().is_some_and(|&before| x <= before) {
                let fault = FileError::MotionOrder {
                    column: angle.name.clone(),
                    x,
                    before: angles[angles.len() - 1],
                };
                return Err(fault.at_line(path, line));
            }
            angles.push(x);
            lifts.push(lift.number(path, line, &row)?);
        }
        Ok(Rows {
            angle: (angle, angles),
            lift: (lift, lifts),
        })
    }

    /// Text of the motion for the scene.
    fn written(&self) -> String {
        let rows = self.angle.1.iter().zip(&self.lift.1);
        rows.fold("table".to_string(), |text, (x, s)| {
            format!("{text} {x} {s}")
        })
    }

    /// Sets the angle (or length) and the lift of a segment from the file. Values that the segment already contains are compared with the file.
    fn put(&self, segment: &mut Table, key: &str, path: &Path) -> Result<()> {
        for ((column, values), name) in [(&self.angle, None), (&self.lift, Some("lift"))] {
            let name = name.unwrap_or(match column.dimension {
                Dimension::Length => "length",
                _ => "angle",
            });
            if let [first, .., last] = values[..] {
                agree(
                    segment,
                    key,
                    name,
                    column,
                    (last - first) * column.factor,
                    path,
                )?;
            }
        }
        Ok(())
    }
}

/// Sets one value of a segment from the file. If the segment already contains the value, it must agree with the file.
fn agree(
    segment: &mut Table,
    key: &str,
    name: &str,
    column: &Column,
    value: f64,
    path: &Path,
) -> Result<()> {
    let unit = column.dimension.si();
    let Some(given) = segment.get(name) else {
        segment.insert(name.to_string(), Value::String(format!("{value} {unit}")));
        return Ok(());
    };
    let key = format!("{key}.{name}");
    let typed = match given {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let stated = parse(&typed, column.dimension).map_err(|e: Error| e.at_key(&key))?;
    if (stated - value).abs() <= AGREEMENT * value.abs() {
        return Ok(());
    }
    let fault = FileError::MotionDiffers {
        column: column.name.clone(),
        covered: short(value / column.factor),
        key,
        typed,
    };
    Err(fault.in_file(path))
}
