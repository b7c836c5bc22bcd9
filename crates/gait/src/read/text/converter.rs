//! Converter counts of Motion Analysis (`.anc`): names, rates and ranges above the rows, no calibration.
//!
//! The header gives the rate as `PreciseRate`; names of channels are in a line `Name`, their rates and ranges in
//! the next two. Muscles may be called like forces (`L GRF`: the left gastrocnemius), so that only numbered plates
//! count.

use super::choose::{Plan, plan};
use super::header::Table;
use super::layout::{Lines, TextFile, text};
use crate::error::{Placed, ReadError, Result};
use crate::quantity::kilograms;
use crate::read::vertical::RawForce;
use crate::recording::{Axis, Note};
use crate::statistics::{ends, ranked, sample};
use crate::units::G;

/// Most lines of the header.
const HEAD: usize = 40;
/// Usual highest force of a stance, body weights: it places the contact threshold before the mean is known.
const USUAL_PEAK: f64 = 1.1;

/// The table of a file of converter counts with its rate; `None` for any other text.
pub(super) fn table(bytes: &[u8]) -> Option<(Table, Option<f64>)> {
    let mut rate = None;
    let mut names: Option<Vec<String>> = None;
    let mut lines = Lines::new(bytes).take(HEAD);
    let (_, first) = lines.next()?;
    if !text(first).starts_with("File_Type") {
        return None;
    }
    for (at, line) in lines {
        let line = text(line);
        let fields: Vec<&str> = line.split_whitespace().collect();
        if let Some(place) = fields.iter().position(|f| *f == "PreciseRate:") {
            rate = fields.get(place + 1).and_then(|r| r.parse().ok());
        }
        match fields.first() {
            Some(&"Name") => {
                let all = line.split('\t').skip(1).map(|n| n.trim().to_string());
                let time = std::iter::once("time".to_string());
                names = Some(time.chain(all).collect());
            }
            Some(&("Rate" | "Range")) | None => (),
            Some(word) if word.parse::<f64>().is_ok() => {
                let names = names?;
                let table = Table {
                    start: at,
                    width: names.len(),
                    units: Vec::new(),
                    head: Vec::new(),
                    names,
                };
                return Some((table, rate));
            }
            Some(_) => (),
        }
    }
    None
}

/// The channels of numbered plates, or those that the user names.
pub(super) fn plates(file: &TextFile, table: &Table) -> Result<Option<Plan>> {
    let Some(mut plan) = plan(file, table)? else {
        return Ok(None);
    };
    if file.options.force.is_empty() {
        plan.force.retain(|(i, axis, _)| {
            let numbered = table.names[*i].contains(|c: char| c.is_ascii_digit());
            numbered && *axis != Axis::Vertical
        });
    }
    Ok((!plan.force.is_empty()).then_some(plan))
}

/// Brings counts to about newtons by the mass of the walker; the mean cycle is brought to it exactly.
///
/// # Errors
///
/// Where neither mass nor unit is given.
pub(super) fn scale(file: &TextFile, forces: &mut [RawForce]) -> Result<Option<Note>> {
    if file.options.unit.is_some() {
        return Ok(None);
    }
    let mass =
        (file.options.mass_kg).ok_or_else(|| ReadError::CountsWithoutMass.in_file(file.path))?;
    // The vertical components are the ones that reach furthest.
    let reach = |f: &RawForce| {
        let values = sample(&f.values, usize::MAX);
        let (low, high) = ends(&values).unwrap_or_default();
        let middle = values.len() / 2;
        let rest = ranked(values, middle).unwrap_or(0.0);
        (high - rest).max(rest - low)
    };
    let top = forces.iter().map(reach).fold(0.0, f64::max);
    if top > 0.0 {
        let factor = USUAL_PEAK * mass * G / top;
        for x in forces.iter_mut().flat_map(|f| &mut f.values) {
            *x *= factor;
        }
    }
    let mass = kilograms(mass);
    Ok(Some(Note::CountsScaled { mass }))
}
