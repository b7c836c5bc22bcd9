//! Reading of complete input files with a limited size.

use std::fs::{self, File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::Path;

use gaitcam::error::{Error, FileError, Placed, Result};
use gaitcam::scene::LARGEST_MOTION;

use crate::inputs;

/// Maximum size of a scene file and of text on standard input, bytes.
const LARGEST_SCENE: u64 = 64 << 20;
/// Maximum size of other inputs that are read into memory, bytes.
const LARGEST_FILE: u64 = 64 << 30;
/// Maximum number of bytes that are read from standard input, a pipe or a device.
const LARGEST_STREAM: u64 = 512 << 20;

/// Content of a whole file, such as a recording, a table or a summary.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>> {
    read_at_most(path, LARGEST_FILE)
}

/// Content of a whole motion file. Its size is limited to `LARGEST_MOTION`.
pub fn read_motion(path: &Path) -> Result<Vec<u8>> {
    read_at_most(path, LARGEST_MOTION)
}

/// Text of a whole file with a scene or a list of values.
pub fn read_text(path: &Path) -> Result<String> {
    let bytes = read_at_most(path, LARGEST_SCENE)?;
    String::from_utf8(bytes)
        .map_err(|e| FileError::NotUtf8.at_byte(path, e.utf8_error().valid_up_to()))
}

/// Text of a scene from standard input.
pub fn read_standard_input() -> Result<String> {
    let place = Path::new("standard input");
    let bytes = limited(std::io::stdin().lock(), place, LARGEST_SCENE)?;
    String::from_utf8(bytes)
        .map_err(|e| FileError::NotUtf8.at_byte(place, e.utf8_error().valid_up_to()))
}

/// Opens a regular file for reading in parts.
///
/// # Errors
///
/// The file cannot be opened, the path is a folder, or the path is a pipe or a device, which may never end.
pub fn open(path: &Path) -> Result<File> {
    checked(path)?;
    File::open(path).map_err(|e| cannot_be_read(path, &e))
}

fn checked(path: &Path) -> Result<Metadata> {
    let about = fs::metadata(path).map_err(|e| cannot_be_read(path, &e))?;
    if about.is_dir() {
        return Err(FileError::Folder.in_file(path));
    }
    if !about.is_file() && !is_open_already(path) {
        return Err(FileError::Device.in_file(path));
    }
    inputs::note(path);
    Ok(about)
}

/// Content of a whole file of at most `most` bytes.
///
/// # Errors
///
/// The errors of [`open`], or the file has more than `most` bytes.
pub fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>> {
    let about = checked(path)?;
    let most = match about.is_file() {
        true => most,
        false => most.min(LARGEST_STREAM),
    };
    if about.len() > most {
        return Err(too_large(path, most));
    }
    limited(open(path)?, path, most)
}

fn limited(reader: impl Read, path: &Path, most: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader
        .take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| cannot_be_read(path, &e))?;
    if bytes.len() as u64 > most {
        return Err(too_large(path, most));
    }
    Ok(bytes)
}

/// Whether a path refers to standard input, or to a file that the shell has opened.
fn is_open_already(path: &Path) -> bool {
    path == Path::new("/dev/stdin")
        || path.starts_with("/dev/fd")
        || path.starts_with("/proc/self/fd")
}

fn too_large(path: &Path, most: u64) -> Error {
    FileError::TooLarge { mib: most >> 20 }.in_file(path)
}

/// Short name of a system error for messages, or the text of the operating system for errors without a short name.
pub fn fault(e: &std::io::Error) -> String {
    let known = match e.kind() {
        ErrorKind::NotFound => "missing",
        ErrorKind::PermissionDenied => "denied",
        ErrorKind::ReadOnlyFilesystem => "read-only",
        ErrorKind::StorageFull => "full",
        _ => return e.to_string(),
    };
    known.to_string()
}

/// Error for a file that cannot be read, with the cause from the operating system.
pub fn cannot_be_read(path: &Path, e: &std::io::Error) -> Error {
    let fault = fault(e);
    FileError::CannotRead { fault }.in_file(path)
}

/// Converts an error of the CSV reader to an error with the file and its line.
pub fn not_csv(path: &Path) -> impl Fn(csv::Error) -> Error {
    move |e| {
        let line = e.position().map_or(1, |p| p.line() as usize);
        let fault = e.to_string();
        FileError::NotCsv { fault }.at_line(path, line)
    }
}
