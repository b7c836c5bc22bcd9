//! MAT files of MATLAB: numeric arrays and structs that contain a force, and a time or a sampling rate.
//!
//! A vector is one column. A matrix has one column (or row) for each series. The series are named by a list of labels in the same struct,
//! as components of a vector, or by numbers. The table consists of all series that are as long as the longest force series.

mod elements;

use std::path::Path;

use elements::{Array, Content, arrays};

use super::columns::{Role, role, words};
use super::keys;
use super::text::{
    Columns, Delimiters, ForceColumn, Position, Samples, Separator, Table, TextFile, choose,
    columns_by_numbers,
};
use super::vertical::RawForce;
use crate::error::{Place, Placed, ReadError, Result};
use crate::recording::{Format, ReadOptions, Recording};

pub(super) use elements::is_level_5;

/// Minimum number of samples of a series.
const FEWEST: usize = 10;
const MOST_SERIES: usize = 400;
/// Names of the components, for a matrix of three or six series.
const COMPONENTS: [&str; 6] = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"];

/// One series of samples.
struct Series<'a> {
    /// Names of the structs and of the array, joined by points. In a matrix, the name of the series follows.
    name: String,
    array: &'a Array,
    /// Whether the name of the series in a matrix is only a number.
    is_numbered: bool,
    values: Vec<f64>,
}

/// Selected columns of a MAT file with their names and samples. The scalars of the file are stored as header lines.
pub(super) struct Mat {
    pub table: Table,
    pub samples: Samples,
    head: Vec<String>,
}

/// Reads a MAT file of level 5.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let Mat {
        table,
        samples,
        head,
    } = table(path, bytes, options)?;
    let keys = keys::read(&head, false);
    let format = Format::Export {
        program: "MATLAB (.mat)",
    };
    let recording = samples.recording(&without_text(path, options), &table, &keys, format);
    recording.map_err(|fault| fault.placed(Place::File(path.to_path_buf())))
}

/// Selects the columns of a MAT file of level 5.
///
/// # Errors
///
/// The file is truncated; no array of numbers can be a force; a column named by the user does not exist.
pub(super) fn table(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Mat> {
    let arrays = arrays(bytes);
    if let Some((array, announced, found)) = arrays.iter().find_map(Array::lacking) {
        let fault = ReadError::MatCut {
            array,
            announced,
            found,
        };
        return Err(fault.in_file(path));
    }
    let without_force = || {
        let names = arrays.iter().map(|a| a.path.join(".")).take(40);
        let arrays = names.collect();
        ReadError::MatWithoutForce { arrays }.in_file(path)
    };
    let mut series: Vec<Series> = arrays.iter().flat_map(|a| series(a, &arrays)).collect();
    let length = length(&series, options).ok_or_else(without_force)?;
    series.retain(|s| s.values.len() == length);
    let table = Table {
        start: Position::START,
        width: series.len(),
        names: series.iter().map(|s| s.name.clone()).collect(),
        units: Vec::new(),
        head: Vec::new(),
    };
    let numbered = match options.force.is_empty() {
        true => by_numbers(&series),
        false => None,
    };
    // A MAT file has no lines, so the location of an error is the whole file.
    let chosen = choose(&without_text(path, options), &table)
        .map_err(|fault| fault.placed(Place::File(path.to_path_buf())))?;
    let columns = numbered.or(chosen).ok_or_else(without_force)?;
    let of_force = columns.force.first().map(|f| series[f.place].array.owner());
    let head = head(&arrays, of_force.unwrap_or_default());
    let samples = samples(series, &table, columns);
    Ok(Mat {
        table,
        samples,
        head,
    })
}

/// An empty text file with the options of the user, for the functions that select the columns of a text by name.
fn without_text<'a>(path: &'a Path, options: &'a ReadOptions) -> TextFile<'a> {
    let separator = Separator::Byte(b',');
    let delimiters = Delimiters {
        separator,
        comma: false,
    };
    TextFile {
        path,
        bytes: &[],
        delimiters,
        options,
    }
}

/// Length of the longest series whose name denotes a force or that the user selected. If there is no such series, the length of the longest
/// of all series.
fn length(series: &[Series], options: &ReadOptions) -> Option<usize> {
    let is_force = |s: &&Series| match &options.force[..] {
        [] => matches!(role(&s.name), Role::Force { .. }),
        stated => stated.contains(&s.name),
    };
    let length = |s: &Series| s.values.len();
    let of_force = series.iter().filter(is_force).map(length).max();
    of_force.or_else(|| series.iter().map(length).max())
}

/// Series of an array. A vector is one series. The shorter dimension of a matrix is its number of series.
fn series<'a>(array: &'a Array, all: &[Array]) -> Vec<Series<'a>> {
    let Content::Numbers { rows, values, .. } = &array.content else {
        return Vec::new();
    };
    let name = array.path.join(".");
    if *rows == 0 || values.len() % rows != 0 {
        return Vec::new();
    }
    let columns = values.len() / rows;
    let (count, length) = (columns.min(*rows), columns.max(*rows));
    if length < FEWEST || count > MOST_SERIES {
        return Vec::new();
    }
    let of = |k: usize| -> Vec<f64> {
        match columns <= *rows {
            true => values[k * rows..(k + 1) * rows].to_vec(),
            false => values.iter().skip(k).step_by(*rows).copied().collect(),
        }
    };
    let labels = labels(array, all, count);
    let is_force = words(&name)
        .iter()
        .any(|w| w.contains("force") || w.contains("grf"));
    let has_components = is_force && (count == 3 || count == 6);
    let one = |k: usize| Series {
        name: match &labels {
            _ if count == 1 => name.clone(),
            Some(labels) => labels[k].clone(),
            None if has_components => format!("{name} {}", COMPONENTS[k]),
            None => format!("{name} {}", k + 1),
        },
        array,
        is_numbered: count > 1 && labels.is_none() && !has_components,
        values: of(k),
    };
    (0..count).map(one).collect()
}

/// Names of the series of a matrix. They are a list of texts in the same struct, with one text per series; `None` without such a list.
fn labels(array: &Array, all: &[Array], count: usize) -> Option<Vec<String>> {
    let list = |other: &Array| match &other.content {
        Content::Texts(texts) if count > 1 && texts.len() == count => Some(texts.clone()),
        _ => None,
    };
    let beside = all.iter().filter(|other| other.owner() == array.owner());
    beside.filter_map(list).next()
}

/// Scalars of the file as header lines `name = value`. The scalars of the struct that contains the force are the first.
fn head(arrays: &[Array], owner: &[String]) -> Vec<String> {
    let shared = |a: &&Array| {
        let pairs = a.owner().iter().zip(owner);
        pairs.take_while(|(a, b)| a == b).count()
    };
    let mut scalars: Vec<(&Array, f64)> = arrays.iter().filter_map(scalar).collect();
    scalars.sort_by_key(|(array, _)| std::cmp::Reverse(shared(array)));
    // The elements of a cell array have numbers as names. The name of the variable that contains them is used instead.
    let is_name = |part: &&String| part.parse::<usize>().is_err();
    let line = |(array, x): (&Array, f64)| {
        let name = array.path.iter().rev().find(is_name);
        format!("{} = {x}", name.map_or("", String::as_str))
    };
    scalars.into_iter().map(line).collect()
}

fn scalar(array: &Array) -> Option<(&Array, f64)> {
    match &array.content {
        Content::Numbers { values, .. } => match values[..] {
            [x] => Some((array, x)),
            _ => None,
        },
        Content::Texts(_) => None,
    }
}

/// Time and force columns of a matrix without names, possibly with a separate vector of times, determined from the numbers.
fn by_numbers(series: &[Series]) -> Option<Columns> {
    let time = series.iter().position(|s| role(&s.name) == Role::Time);
    let data = || series.iter().enumerate().filter(|(i, _)| Some(*i) != time);
    let first = data().next()?.1.array;
    let is_one = data().all(|(_, s)| s.is_numbered && std::ptr::eq(s.array, first));
    let values: Vec<Vec<f64>> = series.iter().map(|s| s.values.clone()).collect();
    is_one.then(|| columns_by_numbers(&values, time))?
}

/// Samples of the selected columns.
fn samples(used: Vec<Series>, table: &Table, columns: Columns) -> Samples {
    let mut values: Vec<Vec<f64>> = used.into_iter().map(|s| s.values).collect();
    let force = |f: &ForceColumn| RawForce {
        name: table.names[f.place].clone(),
        axis: f.axis,
        foot: f.foot,
        unit: table.force_unit(f.place),
        values: std::mem::take(&mut values[f.place]),
    };
    let forces = columns.force.iter().map(force).collect();
    Samples {
        times: columns.time.map(|t| std::mem::take(&mut values[t])),
        time_unit: columns.time.and_then(|t| table.time_unit(t)),
        counts: columns.counts,
        phase: (columns.phase_of_stance.and(columns.time)).map(|t| table.names[t].clone()),
        forces,
        insole: columns.insole,
        skipped: Vec::new(),
        notes: columns.notes,
    }
}
