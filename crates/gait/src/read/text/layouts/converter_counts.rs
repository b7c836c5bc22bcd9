//! Converter counts of Motion Analysis (`.anc`). The header contains the names, rates and ranges of the channels, but no calibration.
//!
//! The header gives the sampling rate as `PreciseRate`. The names of the channels are in a line `Name`. Their rates and ranges are in the
//! next two lines. Names of muscles may resemble forces (`L GRF`: left gastrocnemius), so only numbered plates are read.

use crate::error::{Placed, ReadError, Result};
use crate::quantity::kilograms;
use crate::read::text::delimited::{Lines, TextFile, text};
use crate::read::text::header::Table;
use crate::read::text::samples::Samples;
use crate::read::vertical::RawForce;
use crate::recording::{Axis, ForceUnit, Note};
use crate::statistics::{ends, ranked, sample};
use crate::units::G;

/// Maximum number of lines in the header.
const HEAD: usize = 40;
/// Typical maximum force of a stance, in body weights. It scales the counts before the mean force is known, because the contact threshold
/// is in N.
const USUAL_PEAK: f64 = 1.1;

/// Table in a file of converter counts; `None` if the header contains no names.
pub(super) fn table(file: &TextFile) -> Option<Table> {
    let mut head = Vec::new();
    let mut names: Option<Vec<String>> = None;
    for (start, line) in Lines::new(file.bytes).take(HEAD) {
        let line = text(line);
        let mut fields = line.split_whitespace();
        match fields.clone().next() {
            Some("Name") => {
                let channels = line.split('\t').skip(1).map(|n| n.trim().to_string());
                let time = std::iter::once("time".to_string());
                names = Some(time.chain(channels).collect());
            }
            Some(word) if word.parse::<f64>().is_ok() => {
                let names = names?;
                return Some(Table {
                    start,
                    width: names.len(),
                    units: Vec::new(),
                    head,
                    names,
                });
            }
            // A line with several keys, one of which is the sampling rate.
            _ if fields.any(|f| f == "PreciseRate:") => {
                head.extend(fields.next().map(|rate| format!("rate = {rate}")));
            }
            _ => (),
        }
    }
    None
}

/// Keeps only the columns of numbered plates, unless the user named columns. The counts are scaled approximately to newtons with the mass
/// of the walker. The mean cycle is later scaled exactly.
///
/// # Errors
///
/// Neither mass nor unit is given.
pub(super) fn complete(file: &TextFile, _: &[String], samples: &mut Samples) -> Result<()> {
    let forces = &mut samples.forces;
    if file.options.force.is_empty() {
        let is_numbered = |name: &str| name.contains(|c: char| c.is_ascii_digit());
        forces.retain(|f| is_numbered(&f.name) && f.axis != Axis::Vertical);
    }
    // The vertical components have the largest range.
    let top = forces.iter().map(reach).fold(0.0, f64::max);
    if file.options.unit.is_none() && !forces.is_empty() {
        let mass = file.options.mass_kg;
        let mass = mass.ok_or_else(|| ReadError::CountsWithoutMass.in_file(file.path))?;
        let factor = if top > 0.0 {
            USUAL_PEAK * mass * G / top
        } else {
            1.0
        };
        for x in forces.iter_mut().flat_map(|f| &mut f.values) {
            *x *= factor;
        }
        let mass = kilograms(mass);
        samples.notes.push(Note::CountsScaled { mass });
    }
    for force in forces {
        force.unit = Some(ForceUnit::Newton);
    }
    Ok(())
}

/// Maximum deviation of the counts from their median.
fn reach(force: &RawForce) -> f64 {
    let values = sample(&force.values, usize::MAX);
    let (low, high) = ends(&values).unwrap_or_default();
    let middle = values.len() / 2;
    let rest = ranked(values, middle).unwrap_or(0.0);
    (high - rest).max(rest - low)
}
