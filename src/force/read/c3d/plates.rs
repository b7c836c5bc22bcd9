//! Force plates of a C3D file: which channels make the vertical force of each.

use std::path::Path;

use super::parameters::Parameters;
use super::storage::Analog;
use crate::error::{Error, Result};
use crate::force::read::columns::{Axis, Role, role};
use crate::force::read::raw::RawForce;
use crate::force::recording::{ForceUnit, ReadOptions};

/// Channels of a plate and their weights in its vertical force.
type Weights = Vec<(usize, f64)>;

/// Most plates that are read; laboratories have up to a dozen.
const MOST_PLATES: usize = 64;

/// Raw vertical force of every plate; without plates, of every channel whose label says force.
pub(super) fn forces(
    path: &Path,
    analog: &Analog,
    parameters: &Parameters,
    options: &ReadOptions,
    notes: &mut Vec<String>,
) -> Result<Vec<RawForce>> {
    let labels = parameters.strings("ANALOG", "LABELS");
    let units = parameters.strings("ANALOG", "UNITS");
    let unit = |i: usize| units.get(i).and_then(|u| u.parse::<ForceUnit>().ok());
    let used = parameters
        .number("FORCE_PLATFORM", "USED")
        .unwrap_or(0.0)
        .max(0.0) as usize;
    let column = |name: String, axis: Axis, weights: &Weights| {
        let mut values = vec![0.0; analog.samples];
        for &(channel, weight) in weights {
            analog.add(channel, weight, &mut values);
        }
        let label = weights.first().and_then(|w| unit(w.0));
        let side = match role(&name) {
            Role::Force { foot, .. } => foot,
            _ => None,
        };
        RawForce {
            name,
            axis,
            foot: side,
            unit: label,
            values,
        }
    };
    if !options.force.is_empty() {
        return options
            .force
            .iter()
            .map(|wanted| {
                let number = wanted
                    .parse::<usize>()
                    .ok()
                    .filter(|n| (1..=analog.channels).contains(n));
                let i = labels
                    .iter()
                    .position(|l| l.eq_ignore_ascii_case(wanted))
                    .or(number.map(|n| n - 1));
                let i = i.filter(|i| *i < analog.channels).ok_or_else(|| {
                    Error::file(path, format!("no analog channel \"{wanted}\""))
                        .help(format!("the channels are {}", labels.join(", ")))
                })?;
                Ok(column(wanted.clone(), Axis::Vertical, &vec![(i, 1.0)]))
            })
            .collect();
    }
    let mut raw = Vec::new();
    // Channels of a plate that nobody here can read are no forces because their names look like it.
    let mut unknown = false;
    // Every plate needs channels of its own, so their number is bounded by the file.
    for plate in 0..used.min(MOST_PLATES).min(analog.channels) {
        match weights(plate, analog, parameters) {
            Ok(weights) => raw.push(column(
                plate_name(plate, &weights, &labels),
                Axis::Vertical,
                &weights,
            )),
            Err(why) => {
                unknown |= why.starts_with("TYPE");
                notes.push(format!("plate {} is left out: {why}", plate + 1));
            }
        }
    }
    tilted(parameters, used, notes);
    if raw.is_empty() && !unknown {
        for (i, label) in labels
            .iter()
            .enumerate()
            .take(analog.channels.min(3 * MOST_PLATES))
        {
            if let Role::Force { axis, .. } = role(label) {
                raw.push(column(label.clone(), axis, &vec![(i, 1.0)]));
            }
        }
        if !raw.is_empty() {
            notes.push(
                "no force plate is described; analog channels are taken by their labels"
                    .to_string(),
            );
        }
    }
    if raw.is_empty() {
        let why = notes
            .last()
            .filter(|n| n.contains("left out"))
            .map_or(String::new(), |n| format!(" ({n})"));
        return Err(Error::file(
            path,
            format!("no force plate and no analog channel of force{why}"),
        )
        .help(format!(
            "the analog channels are {}",
            labels
                .iter()
                .take(40)
                .map(String::as_str)
                .collect::<Vec<_>>()
                .join(", ")
        )));
    }
    Ok(raw)
}

fn plate_name(plate: usize, weights: &Weights, labels: &[String]) -> String {
    let label = weights
        .first()
        .and_then(|w| labels.get(w.0))
        .filter(|l| !l.is_empty());
    match (weights.len(), label) {
        (1, Some(label)) => format!("plate {} {label}", plate + 1),
        _ => format!("plate {}", plate + 1),
    }
}

/// Weights of the channels in the force normal to a plate, by the plate's TYPE.
///
/// 1 and 2: the third channel. 3: four vertical sensors. 4 (six channels) and 5 (eight): the third row of the
/// calibration matrix. 6 (twelve) and 7 (eight): the vertical sensors of the four corners, which are the rows of
/// the matrix that add up; where the file gives no matrix, the channels are forces already.
fn weights(
    plate: usize,
    analog: &Analog,
    parameters: &Parameters,
) -> std::result::Result<Weights, String> {
    let kind = parameters
        .numbers("FORCE_PLATFORM", "TYPE")
        .get(plate)
        .copied()
        .unwrap_or(2.0) as i64;
    let numbers = parameters.numbers("FORCE_PLATFORM", "CHANNEL");
    let stride = first_dimension(parameters, "CHANNEL").unwrap_or(6);
    let channel = |k: usize| -> std::result::Result<usize, String> {
        let n = (k < stride)
            .then(|| numbers.get(plate * stride + k))
            .flatten();
        let n = n.filter(|n| **n >= 1.0 && **n <= analog.channels as f64);
        n.map(|n| *n as usize - 1)
            .ok_or_else(|| format!("its channel {} is not in the file", k + 1))
    };
    let plain = |ks: &[usize]| ks.iter().map(|&k| Ok((channel(k)?, 1.0))).collect();
    let calibrated = |columns: usize, rows: &[usize]| {
        let sums = matrix_sums(plate, columns, rows, parameters)?;
        let pairs = sums.into_iter().enumerate();
        Some(pairs.map(|(k, w)| Ok((channel(k)?, w))).collect())
    };
    let no_matrix = || Err("its calibration matrix is missing".to_string());
    match kind {
        1 | 2 => plain(&[2]),
        3 => plain(&[4, 5, 6, 7]),
        4 => calibrated(6, &[2]).unwrap_or_else(no_matrix),
        5 => calibrated(8, &[2]).unwrap_or_else(no_matrix),
        6 => calibrated(12, &[2, 5, 8, 11]).unwrap_or_else(|| plain(&[2, 5, 8, 11])),
        7 => calibrated(8, &[4, 5, 6, 7]).unwrap_or_else(|| plain(&[4, 5, 6, 7])),
        other => Err(format!(
            "TYPE {other} is not known here, only 1 to 7 are; name its force channel with --force"
        )),
    }
}

fn first_dimension(parameters: &Parameters, name: &str) -> Option<usize> {
    parameters.dims("FORCE_PLATFORM", name).first().copied()
}

/// For each of `columns` channels the sum of some rows of a plate's calibration matrix; `None` where the file
/// has no such matrix (or only zeros).
fn matrix_sums(
    plate: usize,
    columns: usize,
    rows: &[usize],
    parameters: &Parameters,
) -> Option<Vec<f64>> {
    let matrix = parameters.numbers("FORCE_PLATFORM", "CAL_MATRIX");
    let dims = parameters.dims("FORCE_PLATFORM", "CAL_MATRIX");
    let high = dims.first().copied().unwrap_or(6);
    let across = dims.get(1).copied().unwrap_or(columns);
    if across < columns || rows.iter().any(|r| *r >= high) {
        return None;
    }
    let entry = |row: usize, k: usize| {
        let x = matrix.get(plate * high * across + k * high + row);
        x.copied().filter(|x| x.is_finite())
    };
    let sums: Option<Vec<f64>> = (0..columns)
        .map(|k| rows.iter().map(|&r| entry(r, k)).sum())
        .collect();
    sums.filter(|s| s.iter().any(|w| *w != 0.0))
}

/// Notes plates whose normal points another way than that of the first, by their corners.
fn tilted(parameters: &Parameters, used: usize, notes: &mut Vec<String>) {
    let corners = parameters.numbers("FORCE_PLATFORM", "CORNERS");
    let normals: Vec<Option<[f64; 3]>> = corners.chunks_exact(12).take(used).map(normal).collect();
    let Some(Some(first)) = normals.first() else {
        return;
    };
    for (i, n) in normals.iter().enumerate().skip(1) {
        if let Some(n) = n {
            let cosine: f64 = n.iter().zip(first).map(|(a, b)| a * b).sum();
            if cosine.abs() < 0.9 {
                notes.push(format!("plate {} does not lie level with plate 1; its force is not vertical if plate 1's is", i + 1));
            }
        }
    }
}

/// Unit normal of a plate from its four corners; `None` where they span nothing.
fn normal(c: &[f64]) -> Option<[f64; 3]> {
    let d = |a: usize, b: usize| {
        [
            c[3 * a] - c[3 * b],
            c[3 * a + 1] - c[3 * b + 1],
            c[3 * a + 2] - c[3 * b + 2],
        ]
    };
    let (u, v) = (d(0, 2), d(1, 3));
    let n = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length.is_finite() && length > 0.0).then(|| n.map(|x| x / length))
}
