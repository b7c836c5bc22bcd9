//! C3D files: force plates of a motion-capture recording.
//!
//! A reader of our own, because it must bear damaged files: every offset and count is checked against the
//! bytes present before it is used, and only the channels of the plates are read.
//! Format: the C3D user guide (c3d.org); layout as 512-byte blocks of header, parameters and data.

mod parameters;
mod plates;
mod storage;

use std::path::Path;

use parameters::Parameters;
use storage::{Analog, Words};

use super::columns::{foot, words};
use super::keys;
use super::vertical;
use crate::error::{Error, Place, Result};
use crate::force::recording::{ReadOptions, Recording, Strike};

/// Bytes of one block.
const BLOCK: usize = 512;

/// Whether bytes start like a C3D file: a small block number and the key 0x50.
pub(super) fn is_c3d(bytes: &[u8]) -> bool {
    matches!(bytes, [block, 0x50, ..] if *block > 0) && bytes.len() >= BLOCK
}

/// Reads the force plates of a C3D file.
pub(super) fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    let start = (usize::from(bytes.first().copied().unwrap_or(1)) - 1) * BLOCK;
    let words_of = Words::of(bytes, start).ok_or_else(|| {
        let code = bytes
            .get(start + 3)
            .map_or("nothing".to_string(), u8::to_string);
        Error::byte(path, start + 3, format!("processor type is {code}"))
            .help("a C3D file has 84 (Intel), 85 (DEC) or 86 (SGI) there")
    })?;
    let parameters = Parameters::read(bytes, start, words_of);
    let mut notes = Vec::new();
    let analog = Analog::read(path, bytes, words_of, &parameters, &mut notes)?;
    let raw = plates::forces(path, &analog, &parameters, options, &mut notes)?;
    let rate_hz = options.rate_hz.unwrap_or(analog.rate_hz);
    let in_file = mass(&parameters);
    let mass_kg = options.mass_kg.or(in_file);
    let base = super::timebase::TimeBase::even(rate_hz);
    let zero = zero_range(&parameters, &analog);
    let place = |e: Error| e.at(Place::File(path.to_path_buf()));
    let mut recording =
        vertical::recording(raw, base, analog.samples, mass_kg, options, zero, notes)
            .map_err(place)?;
    recording.format = format!("C3D, {}", analog.describe());
    recording.mass_from = match (options.mass_kg, in_file) {
        (Some(_), _) => "user".to_string(),
        (None, Some(_)) => "file".to_string(),
        (None, None) => String::new(),
    };
    recording.strikes = strikes(&parameters, &analog);
    Ok(recording)
}

/// Samples of the frames that FORCE_PLATFORM:ZERO names as unloaded.
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

/// Mass of the walker, kg: a parameter that is called mass or weight, in any group.
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

/// Foot strikes with their side, from the EVENT group; times in the file count from frame 1.
fn strikes(parameters: &Parameters, analog: &Analog) -> Vec<Strike> {
    let times = parameters.numbers("EVENT", "TIMES");
    let labels = parameters.strings("EVENT", "LABELS");
    let contexts = parameters.strings("EVENT", "CONTEXTS");
    let begin = (analog.first_frame.saturating_sub(1)) as f64 / analog.frame_hz;
    let mut found = Vec::new();
    for (i, pair) in times.chunks_exact(2).enumerate() {
        let label = labels.get(i).map_or("", String::as_str).to_lowercase();
        let context = contexts.get(i).map_or("", String::as_str);
        let is_strike = ["strike", "contact", "heel on", "rhs", "lhs", "touch"]
            .iter()
            .any(|w| label.contains(w));
        let side = foot(&words(context)).or_else(|| {
            foot(&words(&label)).or(match label.as_str() {
                "rhs" | "rfs" => Some(crate::force::Foot::Right),
                "lhs" | "lfs" => Some(crate::force::Foot::Left),
                _ => None,
            })
        });
        let at_s = 60.0 * pair[0] + pair[1] - begin;
        if let (true, Some(foot), true) = (is_strike, side, at_s.is_finite()) {
            found.push(Strike { at_s, foot });
        }
    }
    found.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    found
}
