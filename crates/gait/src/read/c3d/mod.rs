//! C3D files: force plates of a motion-capture recording.
//!
//! Damaged files are common, so every offset and count is checked against the length of the file before it is used. Only the channels of
//! the plates are read. Format: the C3D user guide (c3d.org), with 512-byte blocks of header, parameters and data.

mod markers;
mod parameters;
mod plates;
mod storage;
mod words;

use std::path::Path;

use parameters::Parameters;
use storage::Analog;

use super::columns::{foot, words};
use super::keys;
use super::timebase::TimeBase;
use super::vertical::{self, Facts};
use crate::error::{Placed, ReadError, Result};
use crate::recording::{ClockSource, Heels, Processor, ReadOptions, Recording, Strike};

/// Size of one block, bytes.
const BLOCK: usize = 512;

/// Whether the bytes start like a C3D file, with the block number of the parameters and the key 0x50.
pub(super) fn is_c3d(bytes: &[u8]) -> bool {
    matches!(bytes, [block, 0x50, ..] if *block > 0) && bytes.len() >= BLOCK
}

/// Reads the force plates of a C3D file.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let start = (usize::from(bytes.first().copied().unwrap_or(1)) - 1) * BLOCK;
    let words_of = Processor::of(bytes, start).ok_or_else(|| {
        let code = bytes.get(start + 3).copied().unwrap_or(0);
        ReadError::Processor { code }.at_byte(path, start + 3)
    })?;
    let parameters = Parameters::read(bytes, start, words_of);
    let mut notes = Vec::new();
    let analog = Analog::read(path, bytes, words_of, &parameters, &mut notes)?;
    let raw = plates::forces(path, &analog, &parameters, options, &mut notes)?;
    let heels = markers::heels(&analog, &parameters);
    let base = match options.rate_hz {
        Some(rate) => TimeBase::even(rate, ClockSource::User),
        None => {
            let start_s = analog.first_frame.saturating_sub(1) as f64 / analog.frame_hz;
            TimeBase::even(analog.rate_hz, ClockSource::Header).starting_at(start_s)
        }
    };
    let frame_hz = base.rate_hz / analog.per_frame as f64;
    let facts = Facts {
        format: analog.format(),
        insole: false,
        samples: analog.samples,
        mass_kg: mass(&parameters),
        zero: zero_range(&parameters, &analog),
        notes,
    };
    let mut recording =
        vertical::recording(raw, base, facts, options).map_err(|e| e.in_file(path))?;
    recording.strikes = strikes(&parameters, &analog);
    recording.heels = heels.map(|[left, right]| Heels {
        rate_hz: frame_hz,
        left,
        right,
    });
    Ok(recording)
}

/// Range of samples (first, one past the last) that the parameter FORCE_PLATFORM:ZERO marks as unloaded.
fn zero_range(parameters: &Parameters, analog: &Analog) -> Option<(usize, usize)> {
    let zero = parameters.numbers("FORCE_PLATFORM", "ZERO");
    let [from, to] = zero.get(..2)? else {
        return None;
    };
    if !(*from >= 1.0 && to >= from) {
        return None;
    }
    let at = |frame: f64| {
        (frame as usize)
            .saturating_mul(analog.per_frame)
            .min(analog.samples)
    };
    Some((at(from - 1.0), at(*to)))
}

/// Mass of the walker, kg, from a parameter named mass or weight in any group.
fn mass(parameters: &Parameters) -> Option<f64> {
    let says = |name: &str| {
        let n = name.to_lowercase().replace([' ', '_'], "");
        ["bodymass", "mass", "subjectmass", "bodyweight", "weight"].contains(&n.as_str())
    };
    parameters.named(says).find_map(|(name, values)| {
        let x = values.first().copied()?;
        keys::mass(name, "", x)
    })
}

/// Foot strikes with their side, from the EVENT group. Times in the file are counted from frame 1.
fn strikes(parameters: &Parameters, analog: &Analog) -> Vec<Strike> {
    let times = parameters.numbers("EVENT", "TIMES");
    let labels = parameters.strings("EVENT", "LABELS");
    let contexts = parameters.strings("EVENT", "CONTEXTS");
    let begin = (analog.first_frame.saturating_sub(1)) as f64 / analog.frame_hz;
    let mut found = Vec::new();
    for (i, pair) in times.chunks_exact(2).enumerate() {
        let label = labels.get(i).map_or("", String::as_str).to_lowercase();
        let context = contexts.get(i).map_or("", String::as_str);
        let says = ["strike", "contact", "heel on", "rhs", "lhs", "touch"];
        let is_strike = says.iter().any(|w| label.contains(w));
        let side = foot(&words(context)).or_else(|| foot(&words(&label)));
        let at_s = 60.0 * pair[0] + pair[1] - begin;
        if let (true, Some(foot), true) = (is_strike, side, at_s.is_finite()) {
            found.push(Strike { at_s, foot });
        }
    }
    found.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    found
}
