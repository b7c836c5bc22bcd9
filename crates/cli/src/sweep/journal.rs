//! The journal beside the table: finished rows in checked chunks, each on the disk before the next.
//!
//! The journal is locked while a process works on it. It is removed when the table stands, after a
//! description of the sweep was put beside the table.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::result_folder::is_still_there;
use gaitcam::error::{Error, Place, Result};
use gaitcam::sweep::{Results, differences, journal as format};
use gaitcam_output::folder::write_whole;

/// An open and locked journal.
pub struct Journal {
    file: File,
    path: PathBuf,
    /// Where the first chunk stands.
    start: u64,
    /// Where the next chunk goes.
    end: u64,
    rows: u64,
    repaired: Option<String>,
}

/// What there is to do.
pub enum Opened {
    /// The table already holds this very sweep.
    Finished,
    /// Work, possibly none of it left.
    Journal(Journal),
}

/// FILE.parquet and FILE.partial, FILE.sweep.json stand side by side.
pub fn beside(table: &Path, ending: &str) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

impl Journal {
    /// Opens the journal of a table, new or (with `resume`) as it was left.
    ///
    /// Refuses when another process works on it, when it holds another sweep, and when it holds rows but
    /// nobody said to go on. A chunk cut short by a crash is taken off.
    pub fn open(table: &Path, sweep: &Value, resume: bool) -> Result<Opened> {
        let path = beside(table, ".partial");
        if resume
            && !path.exists()
            && let Some(done) = finished(table)
        {
            agree(table, &done, sweep)?;
            return Ok(Opened::Finished);
        }
        let fault = |e: std::io::Error| Error::file(&path, format!("cannot be opened ({e})"));
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path)
            .map_err(fault)?;
        let busy = || {
            Error::file(table, "another gaitcam is writing this table")
                .help("wait for it, or choose another --out")
        };
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(busy()),
            Err(TryLockError::Error(e)) => return Err(fault(e)),
        }
        if !is_still_there(&file, &path) {
            return Err(busy());
        }
        let mut journal = Journal {
            file,
            path,
            start: 0,
            end: 0,
            rows: 0,
            repaired: None,
        };
        match journal.read_head()? {
            None => journal.begin(sweep)?,
            Some(before) => {
                journal.scan()?;
                if !resume && journal.rows > 0 {
                    return Err(Error::file(
                        &journal.path,
                        format!("holds {} rows of a sweep that was stopped", journal.rows),
                    )
                    .help("go on with --resume, or remove it to start anew"));
                }
                if journal.rows > 0 {
                    agree(&journal.path, &before, sweep)?;
                } else {
                    journal.begin(sweep)?;
                }
            }
        }
        Ok(Opened::Journal(journal))
    }

    /// Rows that are safe.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// What had to be mended.
    pub fn repaired(&self) -> Option<&str> {
        self.repaired.as_deref()
    }

    fn fault(&self, what: &str, e: &std::io::Error) -> Error {
        Error::file(&self.path, format!("{what} ({e})"))
    }

    /// The description, or `None` when the file is new or was cut short in its head.
    fn read_head(&mut self) -> Result<Option<Value>> {
        let mut start = Vec::new();
        let mut text = Vec::new();
        let read = (&self.file)
            .take(format::HEAD as u64)
            .read_to_end(&mut start);
        read.map_err(|e| self.fault("cannot be read", &e))?;
        let length = format::description_length(&start)
            .map_err(|e| e.placed(Place::File(self.path.clone())))?;
        let Some(length) = length else {
            return Ok(None);
        };
        let read = (&self.file).take(length).read_to_end(&mut text);
        read.map_err(|e| self.fault("cannot be read", &e))?;
        self.start = format::HEAD as u64 + length;
        self.end = self.start;
        Ok(format::description(&start, &text))
    }

    fn begin(&mut self, sweep: &Value) -> Result<()> {
        let head = format::head(sweep);
        let written = self
            .file
            .set_len(0)
            .and_then(|()| self.file.rewind())
            .and_then(|()| self.file.write_all(&head))
            .and_then(|()| self.file.sync_data());
        written.map_err(|e| self.fault("cannot be written", &e))?;
        (self.start, self.end) = (head.len() as u64, head.len() as u64);
        Ok(())
    }

    /// Walks the chunks by their heads. Only the last can be unfinished: each was on the disk before the
    /// next began.
    fn scan(&mut self) -> Result<()> {
        let size = self
            .file
            .metadata()
            .map_err(|e| self.fault("cannot be read", &e))?
            .len();
        let mut last: Option<(u64, format::ChunkHead)> = None;
        while let Some(head) = self.head_at(self.end) {
            let next = self.end + format::CHUNK_HEAD as u64 + head.length;
            if head.first != self.rows || head.rows == 0 || next > size {
                break;
            }
            last = Some((self.end, head));
            self.end = next;
            self.rows += u64::from(head.rows);
        }
        if let Some((at, head)) = last
            && self.payload_at(at, &head).is_none()
        {
            self.end = at;
            self.rows = head.first;
        }
        if self.end < size {
            self.repaired = Some(format!(
                "the last {} bytes of {} were cut short by a crash and are computed again",
                size - self.end,
                self.path.display()
            ));
            self.file
                .set_len(self.end)
                .map_err(|e| self.fault("cannot be repaired", &e))?;
        }
        Ok(())
    }

    fn head_at(&mut self, at: u64) -> Option<format::ChunkHead> {
        let mut head = [0; format::CHUNK_HEAD];
        self.file.seek(SeekFrom::Start(at)).ok()?;
        self.file.read_exact(&mut head).ok()?;
        format::chunk_head(&head)
    }

    /// A chunk's payload if it is the one that was written.
    fn payload_at(&mut self, at: u64, head: &format::ChunkHead) -> Option<Vec<u8>> {
        let mut payload = vec![0; usize::try_from(head.length).ok()?];
        self.file
            .seek(SeekFrom::Start(at + format::CHUNK_HEAD as u64))
            .ok()?;
        self.file.read_exact(&mut payload).ok()?;
        head.holds(&payload).then_some(payload)
    }

    /// Adds the rows that come next and puts them on the disk. After a failure (a full disk) the journal
    /// ends where it ended before.
    pub fn append(&mut self, results: &Results) -> Result<()> {
        let chunk = format::chunk(self.rows, results.len() as u32, &results.to_bytes());
        let written = self
            .file
            .seek(SeekFrom::Start(self.end))
            .and_then(|_| self.file.write_all(&chunk))
            .and_then(|()| self.file.sync_data());
        if let Err(e) = written {
            let _ = self.file.set_len(self.end);
            return Err(self.fault("cannot be written", &e).help(format!(
                "{} rows are safe in it: make room and go on with --resume",
                self.rows
            )));
        }
        self.end += chunk.len() as u64;
        self.rows += results.len() as u64;
        Ok(())
    }

    /// Goes through all rows in order: `each` gets the first row's number, how many rows there are, and the
    /// rows, or `None` where the disk has damaged them since.
    pub fn replay(
        &mut self,
        mut each: impl FnMut(u64, usize, Option<Results>) -> Result<()>,
    ) -> Result<()> {
        let mut at = self.start;
        while at < self.end {
            let Some(head) = self.head_at(at) else {
                return Err(Error::file(&self.path, "was changed while it was read"));
            };
            let results = self
                .payload_at(at, &head)
                .and_then(|p| Results::from_bytes(&p).ok())
                .filter(|r| r.len() == head.rows as usize);
            each(head.first, head.rows as usize, results)?;
            at += format::CHUNK_HEAD as u64 + head.length;
        }
        Ok(())
    }

    /// Says beside the table what it is, and removes the journal.
    pub fn finish(self, table: &Path, sweep: &Value) -> Result<()> {
        let text = serde_json::to_string_pretty(sweep).unwrap_or_default();
        write_whole(&beside(table, ".sweep.json"), text.as_bytes())?;
        std::fs::remove_file(&self.path).map_err(|e| self.fault("cannot be removed", &e))
    }
}

/// The sweep that a table holds, where both the table and its description stand.
fn finished(table: &Path) -> Option<Value> {
    if !table.exists() {
        return None;
    }
    let bytes = std::fs::read(beside(table, ".sweep.json")).ok()?;
    serde_json::from_slice(&bytes).ok()
}

fn agree(path: &Path, before: &Value, now: &Value) -> Result<()> {
    let lines = differences(before, now);
    if lines.is_empty() {
        return Ok(());
    }
    Err(
        Error::file(path, format!("is another sweep: {}", lines.join("; ")))
            .help("repeat the sweep as it was, or choose another --out"),
    )
}
