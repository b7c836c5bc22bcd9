//! Readers that convert the bytes of a file to a [`Recording`].
//!
//! The kind of file is recognised by its bytes, not by its name. Counts in a file may be wrong, so memory is reserved only for data that
//! the file can contain.

mod arrays;
mod baseline;
mod c3d;
mod columns;
mod critical_points;
mod cross_talk;
mod cycle_file;
mod cycle_samples;
mod keys;
mod mat;
mod number;
mod text;
mod timebase;
mod vertical;
mod vocabulary;

use std::path::Path;

use crate::curve::ForceCurve;
use crate::error::{FileKind, Placed, ReadError, Result};
use crate::quantity::{hertz, kilograms};
use crate::recording::{ReadOptions, Recording};

pub use arrays::of_arrays;
pub use text::{Cell, NumberTable, PlateFile, joined_plates, metadata_name, plate_of};

/// Reads a recording of vertical force.
///
/// `path` is used only in messages.
///
/// # Errors
///
/// The file has no vertical force; the time decreases; the samples have no time base. The error contains file and line (or byte).
pub fn read(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Recording> {
    check(options)?;
    if bytes.is_empty() {
        return Err(ReadError::Empty.in_file(path));
    }
    if mat::is_level_5(bytes) {
        return mat::read(path, bytes, options);
    }
    match foreign(bytes) {
        None | Some(FileKind::Binary) if c3d::is_c3d(bytes) => c3d::read(path, bytes, options),
        Some(kind) => Err(ReadError::Foreign { kind }.in_file(path)),
        None => {
            let mut plates = text::parts(bytes).into_iter();
            let first = plates.next().unwrap_or_default();
            let mut recording = text::read(path, first, options)?;
            for other in plates {
                recording.add_plates(text::read(path, other, options)?);
            }
            Ok(recording)
        }
    }
}

/// Kind of a file that is neither text nor C3D.
fn foreign(bytes: &[u8]) -> Option<FileKind> {
    let known: [(&[u8], FileKind); 12] = [
        (b"PK\x03\x04", FileKind::Zip),
        (b"\xD0\xCF\x11\xE0", FileKind::OldOffice),
        (b"MATLAB ", FileKind::Matlab),
        (b"\x89HDF", FileKind::Hdf5),
        (b"PAR1", FileKind::Parquet),
        (b"\x1F\x8B", FileKind::Gzip),
        (b"%PDF", FileKind::Pdf),
        (b"<?xml", FileKind::Xml),
        (b"\x93NUMPY", FileKind::Numpy),
        (b"\x89PNG", FileKind::Picture),
        (b"\xFF\xD8\xFF", FileKind::Picture),
        (b"GIF8", FileKind::Picture),
    ];
    let start = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if let Some((_, kind)) = known.iter().find(|(mark, _)| start.starts_with(mark)) {
        return Some(*kind);
    }
    // UTF-16 has its byte-order mark. Other text contains hardly any control characters, but binary numbers contain many.
    let wide = bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF");
    let head = &bytes[..bytes.len().min(4096)];
    let control = |b: &&u8| **b < 9 || (14..32).contains(*b);
    let controls = head.iter().filter(control).count();
    (!wide && 20 * controls > head.len()).then_some(FileKind::Binary)
}

pub use cycle_file::is_marked as is_marked_cycle;

/// Reads a text marked as one cycle, or any text or MAT file if a period or a span is given; `None` for other files.
///
/// # Errors
///
/// A line is not a number; there are too few samples; a period or a span is given for a C3D file.
pub fn marked_cycle(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Option<ForceCurve>> {
    check(options)?;
    if c3d::is_c3d(bytes) {
        let asked = options.period_s.is_some() || options.span_rad.is_some();
        let refused = || ReadError::CycleInC3d.in_file(path);
        return if asked { Err(refused()) } else { Ok(None) };
    }
    cycle_file::read(path, bytes, options)
}

fn check(options: &ReadOptions) -> Result<()> {
    let is_bad = |x: &f64| !(x.is_finite() && *x > 0.0);
    if let Some(rate) = options.rate_hz.filter(is_bad) {
        return Err(ReadError::RateNotPositive { rate: hertz(rate) }.into());
    }
    match options.mass_kg.filter(is_bad).map(kilograms) {
        Some(mass) => Err(ReadError::MassNotPositive { mass }.into()),
        None => Ok(()),
    }
}
