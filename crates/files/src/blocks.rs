//! A folder that holds a sweep in blocks: one file per range of rows, each whole or not there.
//!
//! `_plan.json` says which sweep it is. A block is named by its rows, `rows-000000131072-000000262144.parquet`; whoever
//! writes one writes it beside and renames it, so that any number of processes on any number of machines may share
//! the folder, and a second start does only what is missing.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use gaitcam::error::{FileError, Placed, Result, WriteError};
use gaitcam::sweep::{Study, agree};
use gaitcam_output::Language;
use gaitcam_output::folder::{put_whole, write_whole};
use serde_json::{Value, json};

use crate::read::read_bytes;
use crate::scene::not_json;

/// What sweep the folder holds.
///
/// Readers of folders of Parquet pass over names that begin with an underscore or a dot.
pub const PLAN: &str = "_plan.json";
/// Rows of a block where nobody says how many.
pub const BLOCK_ROWS: u64 = 131_072;
/// Name and ending of a block.
const NAME: &str = "rows-";
const ENDING: &str = ".parquet";

/// The folder of a sweep that is computed in blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    folder: PathBuf,
    rows: u64,
    block_rows: u64,
}

impl Blocks {
    /// The folder of a sweep, begun now or earlier.
    ///
    /// # Errors
    /// A folder that cannot be written, that holds another sweep (with every difference, in `language`), or blocks
    /// without the plan that they belong to.
    pub fn open(
        folder: &Path,
        study: &Study,
        block_rows: u64,
        language: Language,
    ) -> Result<Blocks> {
        let rows = study.rows()?;
        let mut plan = study.description();
        plan["block_rows"] = json!(block_rows);
        let place = folder.join(PLAN);
        if place.exists() {
            let begun: Value =
                serde_json::from_slice(&read_bytes(&place)?).map_err(|e| not_json(&place, &e))?;
            agree(folder, &begun, &plan, language)?;
        } else {
            begin(folder, &place, &plan)?;
        }
        Ok(Blocks {
            folder: folder.to_path_buf(),
            rows,
            block_rows: block_rows.max(1),
        })
    }

    /// Every block, by its rows.
    pub fn all(&self) -> impl Iterator<Item = Range<u64>> + '_ {
        (0..self.rows.div_ceil(self.block_rows)).map(|k| self.block(k))
    }

    fn block(&self, k: u64) -> Range<u64> {
        let start = k * self.block_rows;
        start..(start + self.block_rows).min(self.rows)
    }

    /// Blocks that are not there yet.
    ///
    /// # Errors
    /// A folder that cannot be read.
    pub fn missing(&self) -> Result<Vec<Range<u64>>> {
        let there: BTreeSet<PathBuf> = files(&self.folder)?.into_iter().collect();
        let lacks = |rows: &Range<u64>| !there.contains(&self.path(rows));
        Ok(self.all().filter(lacks).collect())
    }

    /// Where a block lies.
    pub fn path(&self, rows: &Range<u64>) -> PathBuf {
        let name = format!("{NAME}{:012}-{:012}{ENDING}", rows.start, rows.end);
        self.folder.join(name)
    }

    /// Puts a block into its place, whole.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn put(&self, rows: &Range<u64>, bytes: &[u8]) -> Result<()> {
        put_whole(&self.path(rows), bytes)
    }

    /// The blocks of one of `parts` equal shares, counted from 1, that are not there yet.
    ///
    /// # Errors
    /// As [`Blocks::missing`].
    pub fn missing_of(&self, part: u64, parts: u64) -> Result<Vec<Range<u64>>> {
        let mut out = self.missing()?;
        out.retain(|rows| (rows.start / self.block_rows) % parts == part - 1);
        Ok(out)
    }
}

fn begin(folder: &Path, place: &Path, plan: &Value) -> Result<()> {
    fs::create_dir_all(folder).map_err(|e| {
        let fault = e.to_string();
        WriteError::FolderRefuses { fault }.in_file(folder)
    })?;
    if let [first, ..] = &files(folder)?[..] {
        let file = first.file_name().unwrap_or_default().to_string_lossy();
        let file = file.into_owned();
        return Err(FileError::NotSweepFolder { file }.in_file(folder));
    }
    let text = serde_json::to_string_pretty(plan).unwrap_or_default();
    write_whole(place, text.as_bytes())
}

/// The blocks in a folder, in the order of their rows.
///
/// # Errors
/// A folder that cannot be read.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let fault = |e: std::io::Error| {
        let fault = e.to_string();
        FileError::CannotRead { fault }.in_file(folder)
    };
    let mut out = Vec::new();
    for entry in fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        if path
            .file_name()
            .and_then(OsStr::to_str)
            .is_some_and(is_block)
        {
            out.push(path);
        }
    }
    // Numbers beyond twelve digits are longer: by length first.
    out.sort_by_key(|p| (p.as_os_str().len(), p.clone()));
    Ok(out)
}

fn is_block(name: &str) -> bool {
    let inner = name.strip_prefix(NAME).and_then(|n| n.strip_suffix(ENDING));
    let ends = inner.and_then(|n| n.split_once('-'));
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    ends.is_some_and(|(a, b)| digits(a) && digits(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::scene;
    use gaitcam::sweep::{Axis, NamedScene, Plan, Sampling, Subject};

    fn study(vary: &str) -> Study {
        let plan = Plan {
            scenes: vec![NamedScene {
                name: "footbridge".to_string(),
                table: scene::DEFAULT.parse().unwrap(),
            }],
            list: None,
            axes: vec![Axis::parse(vary, false).unwrap()],
            sampling: Sampling::Grid,
        };
        let none = |_: usize, path: &Path| Err(FileError::Folder.in_file(path));
        Study::new(Subject::Designs(plan), none).unwrap()
    }

    #[test]
    fn blocks_cover_every_row_once_and_only_missing_ones_are_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let study = study("limits.stroke=40 mm:60 mm:10");
        let open = || Blocks::open(folder.path(), &study, 4, Language::En).unwrap();
        let blocks = open();
        assert_eq!(blocks.missing().unwrap(), [0..4, 4..8, 8..10]);
        fs::write(blocks.path(&(4..8)), b"").unwrap();
        fs::write(folder.path().join(".rows-1-2.parquet.7.partial"), b"").unwrap();
        assert_eq!(open().missing().unwrap(), [0..4, 8..10]);
        assert_eq!(open().missing_of(1, 2).unwrap(), [0..4, 8..10]);
        assert!(open().missing_of(2, 2).unwrap().is_empty());
    }

    #[test]
    fn another_sweep_is_refused_with_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        let open = |vary: &str, rows| {
            Blocks::open(folder.path(), &study(vary), rows, Language::En).map(|_| ())
        };
        open("limits.stroke=40 mm:60 mm:10", 4).unwrap();
        let fault = open("limits.stroke=40 mm:50 mm:10", 4).unwrap_err();
        assert!(fault.to_string().contains("limits.stroke"), "{fault}");
        let fault = open("limits.stroke=40 mm:60 mm:10", 5).unwrap_err();
        assert!(fault.to_string().contains("block_rows"), "{fault}");
        let other = tempfile::tempdir().unwrap();
        fs::write(other.path().join("rows-0-4.parquet"), b"").unwrap();
        let fault = Blocks::open(
            other.path(),
            &study("limits.stroke=1 mm:2 mm:3"),
            4,
            Language::En,
        );
        assert_eq!(fault.unwrap_err().code(), "file-not-sweep-folder");
    }
}
