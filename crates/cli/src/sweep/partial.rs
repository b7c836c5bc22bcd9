//! The table while it is being written.
//!
//! `FILE.partial` holds the complete rows so far, as CSV; each wave of rows is on the disk before the next.
//! `FILE.partial.json` says which sweep it is, and becomes `FILE.sweep.json` when the table is complete. A
//! process locks the partial table while it works on it. A row that a crash cut short is removed and
//! computed again.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use crate::{console::language, console::words};
use gaitcam::cam::Verdict;
use gaitcam::error::{Error, Placed, Result};
use gaitcam::sweep::{Outcome, Results};
use gaitcam_files::read::cannot_be_read;
use gaitcam_files::result_folder::is_still_there;
use gaitcam_output::folder::write_whole;
use serde_json::{Value, json};

/// Turns the finished table into another format: from, to.
type Convert<'a> = &'a dyn Fn(&Path, &Path) -> Result<()>;

/// An open and locked partial table.
pub struct PartialTable {
    file: File,
    /// Where it lies.
    path: PathBuf,
    /// Where the finished table will lie.
    table: PathBuf,
    /// Bytes of complete rows.
    end: u64,
    counts: Counts,
    repaired: Option<String>,
}

/// What there is to do.
pub enum Opened {
    /// The table already holds this very sweep.
    Finished,
    /// Work, possibly none of it left.
    Partial(PartialTable),
}

/// What rows hold.
#[derive(Debug, Clone, Default)]
pub struct Counts {
    /// All rows.
    pub rows: u64,
    /// Cams designed.
    pub built: u64,
    /// Those on which every check passes.
    pub acceptable: u64,
    /// Those that are not for high speed.
    pub low_speed: u64,
    /// Limits leave none.
    pub infeasible: u64,
    /// Scenes at fault.
    pub errors: u64,
    /// The first of them: its row and what is wrong.
    pub first_error: Option<(u64, String)>,
}

impl Counts {
    /// Counts of computed rows; `first` is the number of the first one.
    pub fn of(first: u64, results: &Results) -> Counts {
        let mut out = Counts::default();
        let (outcomes, verdicts, errors) = (results.words(0), results.words(1), results.words(5));
        for row in 0..results.len() {
            out.count(first, outcomes[row], verdicts[row], errors[row]);
        }
        out
    }

    fn count(&mut self, first: u64, outcome: &str, verdict: &str, error: &str) {
        if outcome == Outcome::Built.name() {
            self.built += 1;
            self.acceptable += u64::from(verdict == Verdict::Acceptable.name());
            self.low_speed += u64::from(verdict == Verdict::NotForHighSpeed.name());
        } else if outcome == Outcome::Infeasible.name() {
            self.infeasible += 1;
        } else {
            self.errors += 1;
            let row = first + self.rows;
            self.first_error
                .get_or_insert_with(|| (row, error.to_string()));
        }
        self.rows += 1;
    }

    /// Adds the counts of the rows that follow.
    pub fn add(&mut self, next: Counts) {
        self.rows += next.rows;
        self.built += next.built;
        self.acceptable += next.acceptable;
        self.low_speed += next.low_speed;
        self.infeasible += next.infeasible;
        self.errors += next.errors;
        self.first_error = self.first_error.take().or(next.first_error);
    }
}

/// FILE.csv and FILE.csv.partial, FILE.csv.sweep.json lie side by side.
pub fn beside(table: &Path, ending: &str) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

impl PartialTable {
    /// Opens the partial table of a sweep, new or (with `resume`) as it was left.
    ///
    /// Refuses when another process works on it, when it holds another sweep, and when it holds rows but
    /// nobody said to go on; then it is left as it is.
    pub fn open(table: &Path, header: &str, sweep: &Value, resume: bool) -> Result<Opened> {
        let path = beside(table, ".partial");
        if resume
            && !path.exists()
            && table.exists()
            && let Some(done) = described(&beside(table, ".sweep.json"))
        {
            gaitcam::sweep::agree(table, &done, sweep, language::current())?;
            // Left by a process that ended between its last two steps.
            let _ = std::fs::remove_file(beside(table, ".partial.json"));
            return Ok(Opened::Finished);
        }
        let mut partial = PartialTable {
            file: locked(&path, table)?,
            path,
            table: table.to_path_buf(),
            end: 0,
            counts: Counts::default(),
            repaired: None,
        };
        partial.scan(header)?;
        if partial.counts.rows == 0 {
            partial.begin(header, sweep)?;
            return Ok(Opened::Partial(partial));
        }
        if !resume {
            let rows = partial.counts.rows;
            return Err(CliError::PartialRows { rows }.in_file(&partial.path));
        }
        let before = described(&beside(table, ".partial.json"))
            .or_else(|| described(&beside(table, ".sweep.json")))
            .ok_or_else(|| partial.foreign())?;
        gaitcam::sweep::agree(&partial.path, &before, sweep, language::current())?;
        partial.cut()?;
        Ok(Opened::Partial(partial))
    }

    /// What its rows hold.
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// What had to be repaired.
    pub fn repaired(&self) -> Option<&str> {
        self.repaired.as_deref()
    }

    fn unreadable(&self, e: &std::io::Error) -> Error {
        cannot_be_read(&self.path, e)
    }

    fn foreign(&self) -> Error {
        CliError::NotPartial.in_file(&self.path)
    }

    /// Counts the complete rows. Fails on a file that does not begin like a table.
    fn scan(&mut self, header: &str) -> Result<()> {
        let size = self.size()?;
        let mut start = vec![0; header.len().min(size as usize)];
        let read = self
            .file
            .rewind()
            .and_then(|()| self.file.read_exact(&mut start));
        read.map_err(|e| self.unreadable(&e))?;
        let common = start.iter().zip(header.as_bytes());
        let begins_so = common.take_while(|(a, b)| a == b).count();
        // The column of row numbers comes first in every table; a shorter file was cut in its header.
        if begins_so < "row,".len().min(start.len()) {
            return Err(self.foreign());
        }
        let ends_a_line = self.last_byte(size)? == Some(b'\n');
        self.file.rewind().map_err(|e| self.unreadable(&e))?;
        let mut reader = csv::Reader::from_reader(BufReader::new(&self.file));
        let Ok(names) = reader.headers().cloned() else {
            return Ok(());
        };
        let column = |name: &str| names.iter().position(|n| n == name);
        let known = [column("outcome"), column("verdict"), column("error")];
        let mut counts = Counts::default();
        let mut end = reader.position().byte();
        let mut record = csv::StringRecord::new();
        // Fields of another number, a row out of turn, and zeros where a block was never written end it.
        while let Ok(true) = reader.read_record(&mut record) {
            let at = reader.position().byte();
            let in_turn = record.get(0) == Some(counts.rows.to_string().as_str());
            let whole = !record.as_slice().contains('\0') && (at < size || ends_a_line);
            if !in_turn || !whole {
                break;
            }
            let [outcome, verdict, error] =
                known.map(|c| c.and_then(|c| record.get(c)).unwrap_or(""));
            counts.count(0, outcome, verdict, error);
            end = at;
        }
        (self.counts, self.end) = (counts, end);
        Ok(())
    }

    fn size(&self) -> Result<u64> {
        let metadata = self.file.metadata();
        Ok(metadata.map_err(|e| self.unreadable(&e))?.len())
    }

    fn last_byte(&mut self, size: u64) -> Result<Option<u8>> {
        if size == 0 {
            return Ok(None);
        }
        let mut byte = [0];
        let read = self
            .file
            .seek(SeekFrom::Start(size - 1))
            .and_then(|_| self.file.read_exact(&mut byte));
        read.map_err(|e| self.unreadable(&e))?;
        Ok(Some(byte[0]))
    }

    /// Removes what follows the last complete row.
    fn cut(&mut self) -> Result<()> {
        let size = self.size()?;
        if self.end < size {
            let file = self.path.display().to_string();
            let lost = json!({"bytes": size - self.end, "file": file});
            self.repaired = Some(words::fill("sweep-repaired", &lost));
            self.file.set_len(self.end).map_err(|e| {
                let fault = e.to_string();
                CliError::CannotRepair { fault }.in_file(&self.path)
            })?;
        }
        Ok(())
    }

    /// The header alone, and the description beside it.
    fn begin(&mut self, header: &str, sweep: &Value) -> Result<()> {
        let text = serde_json::to_string_pretty(sweep).unwrap_or_default();
        write_whole(&beside(&self.path, ".json"), text.as_bytes())?;
        let written = self.file.set_len(0).and_then(|()| self.file.rewind());
        written.map_err(|e| {
            let fault = e.to_string();
            CliError::CannotWrite { fault }.in_file(&self.path)
        })?;
        self.end = 0;
        self.append(header, Counts::default())
    }

    /// Adds the rows that come next and puts them on the disk. After a failure (a full disk) the table ends
    /// where it ended before.
    pub fn append(&mut self, rows: &str, counts: Counts) -> Result<()> {
        let written = self
            .file
            .seek(SeekFrom::Start(self.end))
            .and_then(|_| self.file.write_all(rows.as_bytes()))
            .and_then(|()| self.file.sync_data());
        if let Err(e) = written {
            let _ = self.file.set_len(self.end);
            let (fault, rows) = (e.to_string(), self.counts.rows);
            return Err(CliError::RowsSafe { fault, rows }.in_file(&self.path));
        }
        self.end += rows.len() as u64;
        self.counts.add(counts);
        Ok(())
    }

    /// Puts the complete table in its place: as it is, or as `convert` writes it to the path it is given.
    pub fn finish(self, sweep: &Value, convert: Option<Convert>) -> Result<Counts> {
        let text = serde_json::to_string_pretty(sweep).unwrap_or_default();
        write_whole(&beside(&self.table, ".sweep.json"), text.as_bytes())?;
        let fault = |e: std::io::Error| {
            let fault = e.to_string();
            CliError::AllRowsSafe { fault }.in_file(&self.table)
        };
        match convert {
            None => std::fs::rename(&self.path, &self.table).map_err(fault)?,
            Some(convert) => {
                let converted = beside(&self.table, &format!(".{}.partial", std::process::id()));
                let placed = convert(&self.path, &converted)
                    .and_then(|()| std::fs::rename(&converted, &self.table).map_err(fault));
                if placed.is_err() {
                    let _ = std::fs::remove_file(&converted);
                }
                placed?;
                std::fs::remove_file(&self.path).map_err(fault)?;
            }
        }
        let _ = std::fs::remove_file(beside(&self.path, ".json"));
        // The name is safe once its folder is.
        let folder = self.table.parent().filter(|p| !p.as_os_str().is_empty());
        if let Ok(folder) = File::open(folder.unwrap_or(Path::new("."))) {
            let _ = folder.sync_all();
        }
        Ok(self.counts)
    }
}

/// The partial table, open and locked by this process alone.
fn locked(path: &Path, table: &Path) -> Result<File> {
    let fault = |e: std::io::Error| {
        let fault = e.to_string();
        CliError::CannotOpen { fault }.in_file(path)
    };
    let busy = || CliError::Busy.in_file(table);
    let file = OpenOptions::new()
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)
        .map_err(fault)?;
    match file.try_lock() {
        Ok(()) if is_still_there(&file, path) => Ok(file),
        Ok(()) | Err(TryLockError::WouldBlock) => Err(busy()),
        Err(TryLockError::Error(e)) => Err(fault(e)),
    }
}

/// A description of a sweep, where one lies.
fn described(path: &Path) -> Option<Value> {
    serde_json::from_slice(&std::fs::read(path).ok()?).ok()
}
