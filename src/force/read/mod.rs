//! Readers: bytes of a file in, [`Recording`] out.
//!
//! The kind of file is told from its bytes, never from its name. Nothing here trusts a count in a file:
//! memory is reserved for what the bytes present can hold.

mod baseline;
mod c3d;
mod columns;
mod cycle_file;
mod keys;
mod number;
mod raw;
mod text;
mod timebase;
mod vertical;
mod vocabulary;

use std::path::Path;

use super::curve::ForceCurve;
use super::recording::{ReadOptions, Recording};
use crate::error::{Error, Result};

pub use text::metadata_name;

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
        return c3d::read(path, bytes, options);
    }
    match foreign(bytes) {
        Some(kind) => Err(
            Error::file(path, format!("this is {kind}, which is not read here"))
                .help("export the trial as C3D or as text (csv, txt, mot)"),
        ),
        None => text::read(path, bytes, options),
    }
}

/// What a file is that is neither text nor C3D, in words.
fn foreign(bytes: &[u8]) -> Option<&'static str> {
    let known: [(&[u8], &str); 9] = [
        (b"PK\x03\x04", "an Excel workbook or another zipped file"),
        (b"\xD0\xCF\x11\xE0", "an old Excel or Word file"),
        (b"MATLAB 5.0", "a MATLAB file"),
        (b"\x89HDF", "an HDF5 or new MATLAB file"),
        (b"PAR1", "a Parquet file"),
        (b"\x1F\x8B", "a gzipped file"),
        (b"%PDF", "a PDF"),
        (b"<?xml", "an XML file"),
        (b"\x93NUMPY", "a NumPy file"),
    ];
    let start = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if let Some((_, kind)) = known.iter().find(|(mark, _)| start.starts_with(mark)) {
        return Some(kind);
    }
    // UTF-16 has its byte-order mark; other text holds hardly any control characters, binary numbers many.
    let wide = bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF");
    let head = &bytes[..bytes.len().min(4096)];
    let control = |b: &&u8| **b < 9 || (14..32).contains(*b);
    let controls = head.iter().filter(control).count();
    (!wide && 20 * controls > head.len()).then_some("a binary file of unknown kind")
}

/// A text that is one cycle as it stands, as [`csv`](crate::force::csv) writes it; `None` for any other file.
pub fn one_cycle(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Option<ForceCurve>> {
    check(options)?;
    if c3d::is_c3d(bytes) {
        return Ok(None);
    }
    cycle_file::read(path, bytes, options)
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
