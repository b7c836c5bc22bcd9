//! Folder of a sweep that is computed in blocks, with one file per block of rows. A file of a block is either complete or absent.
//!
//! `_plan.json` identifies the sweep. The file name of a block contains its range of rows, such as `rows-000000131072-000000262144.parquet`. A sweep
//! that a single process computes into one table also uses blocks until the table is complete. The names of these files also contain a checksum, such
//! as `rows-000000000008-000000000072.1c291ca3.csv`.
//!
//! A block is written under a temporary name and then renamed. Therefore any number of processes on any number of machines can share the folder.
//! After an interruption, only the missing blocks are computed.

use std::collections::{HashMap, HashSet};
use std::ffi::OsStr;
use std::fs;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::folder::{put_whole, write_whole};
use gaitcam::error::{FileError, Placed, Result, WriteError};
use gaitcam::sweep::{Sweep, agree};
use gaitcam_output::Language;
use serde_json::{Value, json};

use crate::lock::is_plain;
use crate::read::{cannot_be_read, read_bytes};
use crate::scene::not_json;

/// File that describes the sweep of the folder. Programs that read Parquet folders ignore it, because its name begins with an underscore.
pub const PLAN: &str = "_plan.json";
/// Default number of rows per block.
pub const BLOCK_ROWS: u64 = 131_072;
/// Prefix of the names of block files.
const NAME: &str = "rows-";

/// Folder for the blocks of one sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    folder: PathBuf,
    ending: &'static str,
}

impl Blocks {
    /// Opens or creates the folder of the sweep that `plan` describes. The names of its block files end with `ending`.
    ///
    /// # Errors
    ///
    /// The folder is not writable, contains another sweep, or contains blocks but no plan. For another sweep, the error lists all
    /// differences, in `language`.
    pub fn open(
        folder: &Path,
        plan: &Value,
        ending: &'static str,
        language: Language,
    ) -> Result<Blocks> {
        let place = folder.join(PLAN);
        if place.exists() {
            let begun: Value =
                serde_json::from_slice(&read_bytes(&place)?).map_err(|e| not_json(&place, &e))?;
            agree(folder, &begun, plan, language)?;
        } else {
            begin(folder, &place, plan)?;
        }
        let folder = folder.to_path_buf();
        Ok(Blocks { folder, ending })
    }

    /// Path of the file for a block of rows.
    pub fn path(&self, rows: &Range<u64>) -> PathBuf {
        let name = format!("{NAME}{:012}-{:012}.{}", rows.start, rows.end, self.ending);
        self.folder.join(name)
    }

    /// Writes a complete block to the folder.
    ///
    /// # Errors
    ///
    /// A file cannot be written.
    pub fn put(&self, rows: &Range<u64>, bytes: &[u8]) -> Result<()> {
        put_whole(&self.path(rows), bytes)
    }

    /// Writes a complete block to the folder, under a name that contains the checksum (CRC-32) of its bytes.
    ///
    /// # Errors
    ///
    /// A file cannot be written.
    pub fn put_with_checksum(&self, rows: &Range<u64>, bytes: &[u8]) -> Result<()> {
        let ending = format!("{}.{}", checksum(bytes), self.ending);
        put_whole(&self.path(rows).with_extension(ending), bytes)
    }

    /// Removes incomplete files of processes that were killed.
    pub fn remove_abandoned(&self) {
        for entry in fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            let (name, path) = (entry.file_name(), entry.path());
            let name = name.to_string_lossy();
            if name.starts_with(".rows-") && name.ends_with(".partial") && is_plain(&path) {
                let _ = fs::remove_file(path);
            }
        }
    }

    /// Row ranges of the existing blocks, in increasing order.
    ///
    /// # Errors
    ///
    /// The folder cannot be read.
    pub fn present(&self) -> Result<Vec<Range<u64>>> {
        Ok(files(&self.folder)?.into_iter().map(|f| f.0).collect())
    }
}

/// Blocks of a sweep that several processes compute. All blocks except the last have the same number of rows.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedBlocks {
    /// Folder with the blocks of the sweep.
    pub blocks: Blocks,
    rows: u64,
    block_rows: u64,
}

impl SharedBlocks {
    /// Opens or creates the folder of a sweep that is divided into blocks of `block_rows` rows. The names of its block files end with `ending`.
    ///
    /// # Errors
    ///
    /// The errors of [`Blocks::open`].
    pub fn open(
        folder: &Path,
        sweep: &Sweep,
        block_rows: u64,
        ending: &'static str,
        language: Language,
    ) -> Result<SharedBlocks> {
        let rows = sweep.rows()?;
        let mut plan = sweep.description();
        plan["block_rows"] = json!(block_rows);
        plan["rows"] = json!(rows);
        Ok(SharedBlocks {
            blocks: Blocks::open(folder, &plan, ending, language)?,
            rows,
            block_rows: block_rows.max(1),
        })
    }

    /// Row ranges of all blocks in increasing order, including the blocks without a file.
    fn all(&self) -> impl Iterator<Item = Range<u64>> {
        let starts = (0..self.rows).step_by(self.block_rows as usize);
        starts.map(|start| start..(start + self.block_rows).min(self.rows))
    }

    /// Row ranges of the blocks for which no file exists. The contents of existing files are not checked.
    ///
    /// # Errors
    ///
    /// The folder cannot be read.
    pub fn missing(&self) -> Result<Vec<Range<u64>>> {
        let present: HashSet<Range<u64>> = self.blocks.present()?.into_iter().collect();
        Ok(self.all().filter(|rows| !present.contains(rows)).collect())
    }

    /// Row ranges of the missing and incomplete blocks of one share. The blocks are divided into `parts` equal shares, and `part` is the
    /// number of the share. Consecutive blocks belong to different shares. Shares are numbered from 1. Share 0 is the same as share
    /// `parts`.
    ///
    /// # Errors
    ///
    /// The errors of [`SharedBlocks::missing`].
    pub fn missing_of(&self, part: u64, parts: u64) -> Result<Vec<Range<u64>>> {
        let present: HashMap<Range<u64>, PathBuf> =
            files(&self.blocks.folder)?.into_iter().collect();
        let is_own = |rows: &Range<u64>| (rows.start / self.block_rows + 1) % parts == part % parts;
        let is_there = |rows: &Range<u64>| present.get(rows).is_some_and(|p| is_complete(p, rows));
        Ok(self
            .all()
            .filter(|rows| is_own(rows) && !is_there(rows))
            .collect())
    }
}

fn begin(folder: &Path, place: &Path, plan: &Value) -> Result<()> {
    fs::create_dir_all(folder).map_err(|e| {
        let fault = crate::read::fault(&e);
        WriteError::FolderRefuses { fault }.in_file(folder)
    })?;
    if let [(_, first), ..] = &files(folder)?[..] {
        let file = first.file_name().unwrap_or_default().to_string_lossy();
        let file = file.into_owned();
        return Err(FileError::NotSweepFolder { file }.in_file(folder));
    }
    let text = serde_json::to_string_pretty(plan).unwrap_or_default();
    write_whole(place, text.as_bytes())
}

/// Row ranges and paths of the blocks in a folder, in the order of the rows. Entries that are not regular files are ignored.
///
/// # Errors
///
/// The folder cannot be read.
pub fn files(folder: &Path) -> Result<Vec<(Range<u64>, PathBuf)>> {
    let fault = |e: std::io::Error| cannot_be_read(folder, &e);
    let mut out = Vec::new();
    for entry in fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        match path.file_name().and_then(OsStr::to_str).and_then(rows_of) {
            Some(rows) if is_plain(&path) => out.push((rows, path)),
            _ => {}
        }
    }
    out.sort_by_key(|(rows, _)| (rows.start, rows.end));
    Ok(out)
}

/// Complete blocks in a folder, with their row ranges, in the order of the rows.
///
/// # Errors
///
/// The folder cannot be read.
pub fn complete_files(folder: &Path) -> Result<Vec<(Range<u64>, PathBuf)>> {
    let mut out = files(folder)?;
    out.retain(|(rows, path)| is_complete(path, rows));
    Ok(out)
}

/// The last four bytes of a file, which are the end mark of a complete Parquet file.
fn tail(path: &Path) -> std::io::Result<[u8; 4]> {
    let (mut file, mut bytes) = (fs::File::open(path)?, [0; 4]);
    file.seek(SeekFrom::End(-4))?;
    file.read_exact(&mut bytes)?;
    Ok(bytes)
}

/// Whether a block contains all rows in its name. A CSV file must have a line for each row. A Parquet file must have its end mark.
fn is_complete(path: &Path, rows: &Range<u64>) -> bool {
    if path.extension().is_some_and(|ending| ending == "parquet") {
        return tail(path).is_ok_and(|bytes| &bytes == b"PAR1");
    }
    fs::read(path).is_ok_and(|bytes| {
        let lines = bytes.iter().filter(|b| **b == b'\n').count() as u64;
        bytes.ends_with(b"\n") && lines == rows.end - rows.start + 1
    })
}

/// Ranges of rows for which the folder contains no complete block. The rows after the last block are included only if the folder has a
/// plan.
///
/// # Errors
///
/// The folder cannot be read.
pub fn missing_rows(folder: &Path) -> Result<Vec<Range<u64>>> {
    let plan = read_bytes(&folder.join(PLAN)).unwrap_or_default();
    let plan: Value = serde_json::from_slice(&plan).unwrap_or_default();
    let (mut out, mut next) = (Vec::new(), 0);
    let end = plan["rows"].as_u64().map(|rows| rows..rows);
    for rows in complete_files(folder)?.into_iter().map(|f| f.0).chain(end) {
        if rows.start > next {
            out.push(next..rows.start);
        }
        next = next.max(rows.end);
    }
    Ok(out)
}

/// Checksum (CRC-32) of a file.
///
/// # Errors
///
/// The file cannot be read.
pub fn checksum_of(path: &Path) -> Result<String> {
    let (mut sum, mut part) = (crc32fast::Hasher::new(), vec![0; 1 << 20]);
    let fault = |e: std::io::Error| cannot_be_read(path, &e);
    let mut file = fs::File::open(path).map_err(fault)?;
    loop {
        match file.read(&mut part).map_err(fault)? {
            0 => return Ok(format!("{:08x}", sum.finalize())),
            length => sum.update(&part[..length]),
        }
    }
}

fn checksum(bytes: &[u8]) -> String {
    format!("{:08x}", crc32fast::hash(bytes))
}

/// Whether the content of a block agrees with the checksum in its file name.
pub fn is_whole(block: &Path) -> bool {
    let named = block
        .file_stem()
        .and_then(|name| Path::new(name).extension());
    fs::read(block).is_ok_and(|bytes| named == Some(OsStr::new(&checksum(&bytes))))
}

/// Range of rows in a file name; `None` if the file is not a block.
fn rows_of(name: &str) -> Option<Range<u64>> {
    let (rows, ending) = name.strip_prefix(NAME)?.split_once('.')?;
    let (start, end) = rows.split_once('-')?;
    let number = |text: &str| {
        let is_number = text.bytes().all(|b| b.is_ascii_digit());
        text.parse::<u64>().ok().filter(|_| is_number)
    };
    let rows = number(start)?..number(end)?;
    let (_, ending) = ending.split_once('.').unwrap_or(("", ending));
    matches!(ending, "csv" | "parquet").then_some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::scene;

    fn sweep(vary: &str) -> Sweep {
        Sweep::over(&scene::parse(scene::DEFAULT).unwrap(), &[vary]).unwrap()
    }

    #[test]
    fn blocks_cover_every_row_once_and_only_missing_ones_are_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let sweep = sweep("limits.stroke=40 mm:60 mm:10");
        let open = || SharedBlocks::open(folder.path(), &sweep, 4, "csv", Language::En).unwrap();
        let first = open();
        assert_eq!(first.missing().unwrap(), [0..4, 4..8, 8..10]);
        let block = first.blocks.path(&(4..8));
        fs::write(&block, "row\n4\n5\n6\n").unwrap();
        assert_eq!(open().missing_of(0, 1).unwrap(), [0..4, 4..8, 8..10]);
        let missing = missing_rows(folder.path()).unwrap();
        assert_eq!((missing.len(), missing[0].clone()), (1, 0..10));
        fs::write(&block, "row\n4\n5\n6\n7").unwrap();
        assert_eq!(open().missing_of(0, 1).unwrap(), [0..4, 4..8, 8..10]);
        fs::write(&block, "row\n4\n5\n6\n7\n").unwrap();
        fs::write(folder.path().join(".rows-1-2.parquet.7.partial"), b"").unwrap();
        assert_eq!(open().missing().unwrap(), [0..4, 8..10]);
        assert_eq!(open().missing_of(1, 2).unwrap(), [0..4, 8..10]);
        assert!(open().missing_of(2, 2).unwrap().is_empty());
        // Counted from 0: the shares together contain all missing blocks, and share 0 is the last share.
        assert!(open().missing_of(0, 2).unwrap().is_empty());
        let of_three = [0, 1, 2].map(|part| open().missing_of(part, 3).unwrap());
        assert_eq!(of_three.concat(), [8..10, 0..4]);
    }

    #[test]
    fn another_sweep_is_refused_with_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        let open = |vary: &str, rows| {
            SharedBlocks::open(folder.path(), &sweep(vary), rows, "csv", Language::En).map(|_| ())
        };
        open("limits.stroke=40 mm:60 mm:10", 4).unwrap();
        let fault = open("limits.stroke=40 mm:50 mm:10", 4).unwrap_err();
        assert!(fault.to_string().contains("limits.stroke"), "{fault}");
        let fault = open("limits.stroke=40 mm:60 mm:10", 5).unwrap_err();
        assert!(fault.to_string().contains("block_rows"), "{fault}");
        let other = tempfile::tempdir().unwrap();
        fs::write(other.path().join("rows-0-4.parquet"), b"").unwrap();
        let fault = SharedBlocks::open(
            other.path(),
            &sweep("limits.stroke=1 mm:2 mm:3"),
            4,
            "parquet",
            Language::En,
        );
        assert_eq!(fault.unwrap_err().code(), "file-not-sweep-folder");
    }
}
