//! Readers: bytes of a file in, [`Recording`] out.
//!
//! The kind of file is told from its bytes, never from its name. Nothing here trusts a count in a file:
//! memory is reserved for what the bytes present can hold.

mod c3d;
mod columns;
mod cycle_file;
mod header;
mod headerless;
mod keys;
mod layout;
mod number;
mod rows;
mod table;
mod text;
mod timebase;
mod times;
mod vertical;

use std::path::Path;

use super::curve::ForceCurve;
use super::cycle::cycle;
use super::models::Feet;
use super::recording::{ReadOptions, Recording};
use super::stance::stances;
use crate::error::{Error, Place, Result};

pub use rows::metadata_name;

/// Reads a recording of vertical force.
///
/// `path` serves messages only. Fails with file and line (or byte) where the file holds no vertical force,
/// time goes backwards, or its numbers cannot be placed in time.
pub fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    check(options)?;
    if bytes.is_empty() {
        return Err(
            Error::file(path, "the file is empty").help("give a recording of vertical force")
        );
    }
    if c3d::is_c3d(bytes) {
        c3d::read(path, bytes, options)
    } else {
        text::read(path, bytes, options)
    }
}

/// Reads one cycle of force from any file that [`read`] takes.
///
/// A text whose comment says `# cycle` or `# critical points` is one cycle as it stands, whatever `feet` says;
/// in every other file stances are found and averaged into a stride.
pub fn force_curve(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<ForceCurve> {
    check(options)?;
    if !c3d::is_c3d(bytes)
        && let Some(curve) = cycle_file::read(path, bytes, options)?
    {
        return Ok(curve);
    }
    let recording = read(path, bytes, options)?;
    let mean = cycle(&recording, &stances(&recording), feet)
        .map_err(|e| e.at(Place::File(path.to_path_buf())))?;
    let file = path
        .file_name()
        .and_then(|n| n.to_str())
        .unwrap_or("recording");
    let mut curve = mean.curve;
    curve.name = format!("{file}, {}", mean.how);
    Ok(curve)
}

fn check(options: &ReadOptions) -> Result<()> {
    let positive = |flag: &str, x: Option<f64>, example: &str| match x {
        Some(x) if !(x.is_finite() && x > 0.0) => {
            Err(Error::argument(flag, format!("{x} is not positive"))
                .help(format!("give for example {example}")))
        }
        _ => Ok(()),
    };
    positive("--rate", options.rate_hz, "\"1000 Hz\"")?;
    positive("--mass", options.mass_kg, "\"70 kg\"")
}
