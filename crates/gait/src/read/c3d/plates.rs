//! Force plates of a C3D file, and the channels of the vertical force of each plate.

use std::path::Path;

use super::parameters::Parameters;
use super::storage::Analog;
use crate::error::{Placed, ReadError, Result};
use crate::read::columns::{Role, role};
use crate::read::vertical::RawForce;
use crate::recording::{Axis, Note, ReadOptions};

/// Channels of a plate with their factors. The vertical force is the sum of the products of channel and factor.
type Weights = Vec<(usize, f64)>;

/// Maximum number of plates that are read. Laboratories have up to a dozen.
const MOST_PLATES: usize = 64;

/// Raw vertical forces: of the channels named by the user, otherwise of every plate. Without plates, the channels whose labels denote a
/// force are used.
pub(super) fn forces(
    path: &Path,
    analog: &Analog,
    parameters: &Parameters,
    options: &ReadOptions,
    notes: &mut Vec<Note>,
) -> Result<Vec<RawForce>> {
    let channels = Channels::of(analog, parameters);
    if !options.force.is_empty() {
        return options
            .force
            .iter()
            .map(|name| channels.named(path, name))
            .collect();
    }
    let used = parameters
        .number("FORCE_PLATFORM", "USED")
        .unwrap_or(0.0)
        .max(0.0) as usize;
    let mut raw = Vec::new();
    let (mut unknown, mut uncalibrated) = (None, None);
    // Every plate requires channels of its own, so the number of channels limits the number of plates.
    for plate in 0..used.min(MOST_PLATES).min(analog.channels) {
        match weights(plate, analog, parameters) {
            Ok(weights) => raw.push(channels.column(
                plate_name(plate, &weights, &channels.labels),
                Axis::Vertical,
                &weights,
            )),
            Err(note) => {
                match note {
                    Note::PlateTypeUnknown { plate, kind } => unknown = Some((plate, kind)),
                    Note::PlateMatrixMissing { plate } => uncalibrated = Some(plate),
                    _ => (),
                }
                notes.push(note);
            }
        }
    }
    tilted(parameters, used, notes);
    // If a plate has an unsupported type, the labels do not show which of its channels are forces.
    if raw.is_empty() && unknown.is_none() {
        raw = channels.labelled_force();
        // Without the required matrix, channels of a plate are forces only if their unit is a unit of force.
        raw.retain(|force| uncalibrated.is_none() || force.unit.is_some());
        if !raw.is_empty() {
            notes.push(Note::NoPlates);
        }
    }
    if !raw.is_empty() {
        return Ok(raw);
    }
    let channels = channels.list(40);
    Err(match (unknown, uncalibrated) {
        (Some((plate, kind)), _) => ReadError::PlateTypeUnknown {
            plate,
            kind,
            channels,
        },
        (None, Some(plate)) => ReadError::PlateUncalibrated { plate, channels },
        (None, None) => ReadError::NoPlate { channels },
    }
    .in_file(path))
}

/// Analog channels of a file with their labels, scales and units.
struct Channels<'a> {
    analog: &'a Analog<'a>,
    labels: Vec<String>,
    units: Vec<String>,
}

impl<'a> Channels<'a> {
    fn of(analog: &'a Analog, parameters: &Parameters) -> Self {
        Channels {
            analog,
            labels: parameters.all_strings("ANALOG", "LABELS"),
            units: parameters.all_strings("ANALOG", "UNITS"),
        }
    }

    /// Weighted sum of channels as one raw force column.
    fn column(&self, name: String, axis: Axis, weights: &Weights) -> RawForce {
        let mut values = vec![0.0; self.analog.samples];
        for &(channel, weight) in weights {
            self.analog.add(channel, weight, &mut values);
        }
        let first = weights.first().and_then(|w| self.units.get(w.0));
        let foot = match role(&name) {
            Role::Force { foot, .. } => foot,
            _ => None,
        };
        RawForce {
            name,
            axis,
            foot,
            unit: first.and_then(|u| u.parse().ok()),
            values,
        }
    }

    /// The channel with a given label, or with a given number counted from 1.
    fn named(&self, path: &Path, name: &str) -> Result<RawForce> {
        let mut labels = self.labels.iter();
        let place = labels
            .position(|l| l.eq_ignore_ascii_case(name))
            .or_else(|| name.parse::<usize>().ok()?.checked_sub(1))
            .filter(|i| *i < self.analog.channels);
        let place = place.ok_or_else(|| {
            ReadError::NoChannel {
                channel: name.to_string(),
                channels: self.list(usize::MAX),
            }
            .in_file(path)
        })?;
        Ok(self.column(name.to_string(), Axis::Vertical, &vec![(place, 1.0)]))
    }

    /// All channels whose labels denote a force.
    fn labelled_force(&self) -> Vec<RawForce> {
        let most = self.analog.channels.min(3 * MOST_PLATES);
        let labels = self.labels.iter().enumerate().take(most);
        labels
            .filter_map(|(i, label)| match role(label) {
                Role::Force { axis, .. } => Some(self.column(label.clone(), axis, &vec![(i, 1.0)])),
                _ => None,
            })
            .collect()
    }

    fn list(&self, most: usize) -> String {
        let shown: Vec<&str> = self.labels.iter().take(most).map(String::as_str).collect();
        shown.join(", ")
    }
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

/// Factors of the channels in the sum that gives the force normal to a plate, by the TYPE of the plate.
///
/// - Types 1 and 2: the third channel.
/// - Type 3: the sum of the four vertical sensors.
/// - Types 4 (six channels) and 5 (eight channels): the third row of the calibration matrix.
/// - Types 6 (twelve channels) and 7 (eight channels): the sum of the matrix rows of the vertical sensors in the four corners.
///
/// Types 4 and 5 require a matrix. For types 6 and 7 without a matrix in the file, the channels are already forces.
fn weights(
    plate: usize,
    analog: &Analog,
    parameters: &Parameters,
) -> std::result::Result<Weights, Note> {
    let kind = parameters
        .numbers("FORCE_PLATFORM", "TYPE")
        .get(plate)
        .copied()
        .unwrap_or(2.0) as i64;
    let numbers = parameters.numbers("FORCE_PLATFORM", "CHANNEL");
    let stride = *parameters
        .dims("FORCE_PLATFORM", "CHANNEL")
        .first()
        .unwrap_or(&6);
    let number = plate + 1;
    let channel = |k: usize| -> std::result::Result<usize, Note> {
        let n = (k < stride)
            .then(|| numbers.get(plate * stride + k))
            .flatten();
        let n = n.filter(|n| **n >= 1.0 && **n <= analog.channels as f64);
        n.map(|n| *n as usize - 1).ok_or(Note::PlateChannelMissing {
            plate: number,
            channel: k + 1,
        })
    };
    let plain = |ks: &[usize]| ks.iter().map(|&k| Ok((channel(k)?, 1.0))).collect();
    let calibrated = |columns: usize, rows: &[usize]| {
        let sums = matrix_sums(plate, columns, rows, parameters)?;
        let pairs = sums.into_iter().enumerate();
        Some(pairs.map(|(k, w)| Ok((channel(k)?, w))).collect())
    };
    let no_matrix = || Err(Note::PlateMatrixMissing { plate: number });
    match kind {
        1 | 2 => plain(&[2]),
        3 => plain(&[4, 5, 6, 7]),
        4 => calibrated(6, &[2]).unwrap_or_else(no_matrix),
        5 => calibrated(8, &[2]).unwrap_or_else(no_matrix),
        6 => calibrated(12, &[2, 5, 8, 11]).unwrap_or_else(|| plain(&[2, 5, 8, 11])),
        7 => calibrated(8, &[4, 5, 6, 7]).unwrap_or_else(|| plain(&[4, 5, 6, 7])),
        _ => Err(Note::PlateTypeUnknown {
            plate: number,
            kind,
        }),
    }
}

/// Sum of the given rows of the calibration matrix of a plate, one value for each of `columns` channels. `None` if the file has no such
/// matrix, or if all sums are zero.
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

/// Adds a note for each plate whose normal direction, computed from its corners, differs from the direction of the first plate.
fn tilted(parameters: &Parameters, used: usize, notes: &mut Vec<Note>) {
    let corners = parameters.numbers("FORCE_PLATFORM", "CORNERS");
    let normals: Vec<Option<[f64; 3]>> = corners.chunks_exact(12).take(used).map(normal).collect();
    let Some(Some(first)) = normals.first() else {
        return;
    };
    for (i, n) in normals.iter().enumerate() {
        let cosine = |n: &[f64; 3]| (0..3).map(|k| n[k] * first[k]).sum::<f64>();
        if n.as_ref().is_some_and(|n| cosine(n).abs() < 0.9) {
            notes.push(Note::PlateTilted { plate: i + 1 });
        }
    }
}

/// Unit normal of a plate from its four corners, as the cross product of its diagonals; `None` if the corners are degenerate.
fn normal(corners: &[f64]) -> Option<[f64; 3]> {
    let diagonal = |a: usize, b: usize| [0, 1, 2].map(|k| corners[3 * a + k] - corners[3 * b + k]);
    let (u, v) = (diagonal(0, 2), diagonal(1, 3));
    let n = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| u[j] * v[k] - u[k] * v[j]);
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length.is_finite() && length > 0.0).then(|| n.map(|x| x / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_of_a_plate_is_that_of_its_corners_wherever_it_stands() {
        // Corners counted round, 400 × 600, seen from the tip of the normal.
        let corners = |u: [f64; 3], v: [f64; 3]| -> Vec<f64> {
            let signs = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
            let at =
                signs.map(|(a, b)| [0, 1, 2].map(|k| 700.0 + 200.0 * a * u[k] + 300.0 * b * v[k]));
            at.concat()
        };
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let slant = [0.6, 0.0, 0.8];
        for (u, v, expected) in [
            (x, y, z),
            (y, z, x),
            (z, x, y),
            (slant, y, [-0.8, 0.0, 0.6]),
        ] {
            let found = normal(&corners(u, v)).unwrap();
            let off = (0..3).map(|k| (found[k] - expected[k]).abs());
            assert!(off.fold(0.0, f64::max) < 1e-12, "{found:?} {expected:?}");
        }
        assert_eq!(normal(&corners(x, x)), None);
    }
}
