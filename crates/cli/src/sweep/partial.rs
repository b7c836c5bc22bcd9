//! Unfinished table of a sweep: blocks of rows in the folder `FILE.partial`.
//!
//! Each block is a complete table and is written before the next block is computed. The final table is assembled from the blocks, and
//! `FILE.sweep.json` describes its sweep. A process locks the folder while it writes the blocks.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::counts::Counts;
use super::format::Format;
use crate::console::error::CliError;
use crate::console::{language, words};
use gaitcam::error::{Error, Placed, Result};
use gaitcam::sweep::Records;
use gaitcam_app::blocks::{self, Blocks, PLAN};
use gaitcam_app::folder::write_whole;
use gaitcam_app::{Lock, inputs};
use serde_json::{Value, json};

/// Name of the lock file in the folder.
const LOCK: &str = ".lock";

/// An unfinished table of a sweep. This process has locked its folder.
pub struct PartialTable {
    blocks: Blocks,
    folder: PathBuf,
    /// Path of the finished table.
    table: PathBuf,
    format: Format,
    counts: Counts,
    /// Message about the first damaged block, if there is one.
    damaged: Option<String>,
    _lock: Lock,
}

/// Key of the table's checksum in the description of the finished sweep.
const CHECKSUM: &str = "table_crc32";

/// Path of the table with an ending appended, such as FILE.csv.partial or FILE.csv.sweep.json.
pub fn with_ending(table: &Path, ending: &str) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

impl PartialTable {
    /// Opens the unfinished table of a sweep: a new one, or with `resume` an existing one. `None` if the table is already complete.
    ///
    /// # Errors
    ///
    /// Another process uses the table, the table belongs to another sweep, or it contains rows and `resume` is not set. The table then
    /// remains unchanged.
    pub fn open(
        table: &Path,
        format: Format,
        sweep: &Value,
        resume: bool,
    ) -> Result<Option<PartialTable>> {
        let description = with_ending(table, ".sweep.json");
        for place in [table, &description] {
            inputs::check(place)?;
        }
        let folder = with_ending(table, ".partial");
        if resume
            && !folder.join(PLAN).exists()
            && table.exists()
            && let Some(mut finished) = described(&description)
        {
            let written = finished[CHECKSUM].take();
            if let Some(finished) = finished.as_object_mut() {
                finished.remove(CHECKSUM);
            }
            gaitcam::sweep::agree(table, &finished, sweep, language::current())?;
            if written != json!(blocks::checksum_of(table)?) {
                return Err(CliError::TableChanged.in_file(table));
            }
            return Ok(None);
        }
        if folder.symlink_metadata().is_ok_and(|about| !about.is_dir()) {
            return Err(CliError::NotPartial.in_file(&folder));
        }
        let lock = locked(&folder)?;
        let rows = blocks::files(&folder)?.last().map_or(0, |f| f.0.end);
        if rows == 0 {
            let _ = fs::remove_file(folder.join(PLAN));
        } else if !resume {
            return Err(CliError::PartialRows { rows }.in_file(&folder));
        }
        let mut partial = PartialTable {
            blocks: Blocks::open(&folder, sweep, format.ending(), language::current())?,
            folder,
            table: table.to_path_buf(),
            format,
            counts: Counts::default(),
            damaged: None,
            _lock: lock,
        };
        partial.count_blocks()?;
        Ok(Some(partial))
    }

    /// Counts the rows of the blocks. The first damaged block and all later blocks are removed.
    fn count_blocks(&mut self) -> Result<()> {
        for (rows, path) in blocks::files(&self.folder)? {
            if rows.start == self.counts.rows && blocks::is_whole(&path) {
                let counts = Counts::of_block(&path, rows.start);
                if counts.rows == rows.end - rows.start {
                    self.counts.add(counts);
                    continue;
                }
            }
            let file = json!({"file": path.display().to_string()});
            self.damaged
                .get_or_insert_with(|| words::fill("sweep-damaged", &file));
            fs::remove_file(&path).map_err(|e| {
                let fault = e.to_string();
                CliError::CannotRepair { fault }.in_file(&path)
            })?;
        }
        Ok(())
    }

    /// Counts of the rows that are already complete.
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// Message about the first damaged block; `None` if no block was damaged.
    pub fn damaged(&self) -> Option<&str> {
        self.damaged.as_deref()
    }

    /// Counts the next rows and writes `bytes`, the content of their block, to the disk.
    pub fn append(&mut self, records: &Records, bytes: &[u8]) -> Result<()> {
        let start = self.counts.rows;
        let rows = start..start + records.len() as u64;
        self.blocks.put_with_checksum(&rows, bytes).map_err(|e| {
            let fault = e.sentence(language::current());
            CliError::RowsSafe { fault, rows: start }.in_file(&self.folder)
        })?;
        self.counts.add(Counts::of(records));
        Ok(())
    }

    /// Assembles the complete table at its final path and removes the blocks.
    pub fn finish(self, sweep: &Value) -> Result<Counts> {
        inputs::check(&self.table)?;
        let describe = |joined: &Path| {
            let mut sweep = sweep.clone();
            sweep[CHECKSUM] = json!(blocks::checksum_of(joined)?);
            let text = serde_json::to_string_pretty(&sweep).unwrap_or_default();
            write_whole(&with_ending(&self.table, ".sweep.json"), text.as_bytes())
        };
        let fault = |e: std::io::Error| -> Error {
            let fault = e.to_string();
            CliError::AllRowsSafe { fault }.in_file(&self.table)
        };
        let paths: Vec<PathBuf> = blocks::files(&self.folder)?
            .into_iter()
            .map(|f| f.1)
            .collect();
        let joined = with_ending(&self.table, &format!(".{}.partial", std::process::id()));
        let _ = fs::remove_file(&joined);
        let placed = File::create_new(&joined)
            .map_err(fault)
            .and_then(|file| self.format.join(&paths, file))
            .and_then(|file| file.sync_all().map_err(fault))
            .and_then(|()| describe(&joined))
            .and_then(|()| fs::rename(&joined, &self.table).map_err(fault));
        if placed.is_err() {
            let _ = fs::remove_file(&joined);
        }
        placed?;
        // The renamed file is permanent only after its folder is synced.
        let parent = self.table.parent().filter(|p| !p.as_os_str().is_empty());
        if let Ok(parent) = File::open(parent.unwrap_or(Path::new("."))) {
            let _ = parent.sync_all();
        }
        for path in paths.iter().chain([&self.folder.join(PLAN)]) {
            fs::remove_file(path).map_err(fault)?;
        }
        self.blocks.remove_abandoned();
        drop(self._lock);
        // The folder remains if it contains files of other programs.
        let _ = fs::remove_dir(self.folder);
        Ok(self.counts)
    }
}

/// Creates the folder if necessary, and locks it.
fn locked(folder: &Path) -> Result<Lock> {
    fs::create_dir_all(folder).map_err(|e| {
        let fault = e.to_string();
        CliError::CannotOpen { fault }.in_file(folder)
    })?;
    Lock::wait(folder, LOCK, Duration::ZERO)
}

/// Description of a sweep in a file; `None` if the file cannot be read.
fn described(path: &Path) -> Option<Value> {
    serde_json::from_slice(&fs::read(path).ok()?).ok()
}
