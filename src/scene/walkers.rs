//! Reading the walkers of a scene from the content of their files.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::Path;

use super::Gait;
use crate::error::{Error, FileError, Placed, Result, nearest};
use crate::force::{self, ForceCurve, Walker, WalkerFault, WalkerRow, walker_faults};
use crate::wording::InLanguages;

/// Maximum number of names in a message.
const LISTED: usize = 12;

/// File name extensions of tables of walkers, in lower case.
const TABLES: [&str; 3] = ["csv", "tsv", "txt"];

/// Reads a population file by file. Errors of files are collected and reported at the end.
pub(super) struct PopulationReader<'a> {
    gait: &'a Gait,
    walkers: Vec<Walker>,
    /// Errors of the files and rows that could not be read as a cycle.
    unreadable: Vec<Error>,
    /// Names of all files and rows read so far. Excluded names are compared with them.
    names: RefCell<BTreeSet<String>>,
}

impl<'a> PopulationReader<'a> {
    /// Creates a reader for a population that has no walkers yet.
    pub fn new(gait: &'a Gait) -> Self {
        PopulationReader {
            gait,
            walkers: Vec::new(),
            unreadable: Vec::new(),
            names: RefCell::default(),
        }
    }

    /// Whether the scene excludes a file from the population.
    pub fn leaves_out(&self, path: &Path) -> bool {
        let names = [file_name(path), path.display().to_string(), stem(path)];
        self.is_named(&names)
    }

    /// Whether the scene excludes a row of a table, by the name of the walker or by file and line.
    fn leaves_row_out(&self, path: &Path, row: &WalkerRow) -> bool {
        let place = format!("{}:{}", file_name(path), row.line);
        self.is_named(&[row.name.clone(), place])
    }

    /// Whether the scene excludes a file or row by one of its names. The names are added to the list of existing names.
    fn is_named(&self, names: &[String]) -> bool {
        self.names.borrow_mut().extend(names.iter().cloned());
        names.iter().any(|name| self.gait.leave_out.contains(name))
    }

    /// Rejects excluded names that no file and no walker has.
    fn check_names(&self) -> Result<()> {
        let names = self.names.borrow();
        let unknown = |name: &&String| !names.contains(*name);
        let Some(name) = self.gait.leave_out.iter().find(unknown) else {
            return Ok(());
        };
        let known = names
            .iter()
            .filter(|n| !n.contains(std::path::is_separator) && !n.contains(':'));
        let fault = FileError::NoSuchWalker {
            name: name.clone(),
            nearest: nearest(name, known.clone().map(String::as_str)).map(str::to_string),
            known: known.take(LISTED).cloned().collect::<Vec<_>>().join(", "),
        };
        Err(fault.at_key("gait.leave_out"))
    }

    /// Adds the cycle of a recording, or all rows of a table of walkers. `metadata` returns the table of subjects. Errors are collected for the
    /// report at the end.
    pub fn take(&mut self, path: &Path, bytes: &[u8], metadata: impl FnOnce() -> Option<Vec<u8>>) {
        if self.leaves_out(path) {
            return;
        }
        if !is_table_of_walkers(path, bytes) {
            match cycle(self.gait, path, bytes, metadata) {
                Ok(walker) => self.walkers.push(walker),
                Err(why) => self.refuse(path, why),
            }
            return;
        }
        match force::population_rows(path, bytes) {
            Ok(rows) => rows.into_iter().for_each(|row| self.take_row(path, row)),
            Err(why) => self.refuse(path, why),
        }
    }

    fn take_row(&mut self, path: &Path, row: WalkerRow) {
        if self.leaves_row_out(path, &row) {
            return;
        }
        match row.walker {
            Ok(walker) => self.walkers.push(walker),
            Err(why) => self.unreadable.push(why),
        }
    }

    /// Collects the error of a file that cannot be read.
    pub fn refuse(&mut self, path: &Path, why: Error) {
        if !self.leaves_out(path) {
            self.unreadable.push(why.in_file(path));
        }
    }

    /// Mean force of all walkers that were read. The result contains the population.
    ///
    /// # Errors
    ///
    /// Walkers with errors, grouped by the reason. An error without a file is reported for the file `first`.
    pub fn mean(self, first: &Path) -> Result<ForceCurve> {
        self.check_names()?;
        let walkers = self.gait.walkers(self.walkers, &self.unreadable);
        let mean = walkers.and_then(ForceCurve::of_walkers);
        mean.map_err(|e| e.in_file(first))
    }
}

/// Whether a file is a table of walkers. This is determined by its extension and its header.
pub(super) fn is_table_of_walkers(path: &Path, bytes: &[u8]) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    TABLES.contains(&ending.to_lowercase().as_str()) && force::is_population(bytes)
}

/// Reads one recording as one walker, with the name of the file without its extension.
fn cycle(
    gait: &Gait,
    path: &Path,
    bytes: &[u8],
    metadata: impl FnOnce() -> Option<Vec<u8>>,
) -> Result<Walker> {
    let options = gait.read_options(metadata())?;
    let curve = force::force_curve(path, bytes, &options, gait.feet)?;
    Ok(Walker::new(&stem(path), curve))
}

impl Gait {
    /// Walkers of a population that the scene does not exclude, if all of them are valid. `unreadable` contains the errors of files and rows without
    /// a cycle.
    ///
    /// # Errors
    ///
    /// Walkers with errors, grouped by the reason.
    pub fn walkers(&self, mut all: Vec<Walker>, unreadable: &[Error]) -> Result<Vec<Walker>> {
        all.retain(|w| !self.leave_out.contains(&w.name));
        let mut names: [Vec<String>; 6] = Default::default();
        for walker in &all {
            let open = self.open_questions(&walker.curve);
            if !open.is_empty() {
                names[5].push(format!("{} ({})", walker.name, open.join(", ")));
            }
        }
        for (walker, fault) in all.iter().zip(walker_faults(&all)) {
            let name = walker.name.clone();
            let (kind, shown) = match fault {
                None => continue,
                Some(WalkerFault::MeanNotWeight { percent }) => {
                    (0, format!("{name} ({percent:.0} %)"))
                }
                Some(WalkerFault::NoMeanForce) => (0, name),
                Some(WalkerFault::OtherUnit) => (1, name),
                Some(WalkerFault::OtherFeet) => (2, name),
                Some(WalkerFault::OtherKind) => (3, name),
                Some(WalkerFault::OtherCycle) => (4, name),
            };
            names[kind].push(shown);
        }
        let count = unreadable.len() + names.iter().map(Vec::len).sum::<usize>();
        if count == 0 {
            return Ok(all);
        }
        let text = |list: &[String]| (!list.is_empty()).then(|| list.join(", "));
        let reasons = || {
            InLanguages::of(|language| {
                let of = |e: &Error| format!("{}{}", e.place.before(language), e.what(language));
                unreadable.iter().map(of).collect::<Vec<_>>().join("; ")
            })
        };
        Err(FileError::Walkers {
            count,
            unreadable: (!unreadable.is_empty()).then(reasons),
            weight: text(&names[0]),
            unit: text(&names[1]),
            feet: text(&names[2]),
            kind: text(&names[3]),
            cycle: text(&names[4]),
            open: text(&names[5]),
        }
        .into())
    }
}

impl Gait {
    /// Names of the open questions about the recording of a cycle. Questions that the scene accepts are omitted.
    pub fn open_questions(&self, curve: &ForceCurve) -> Vec<&'static str> {
        let recording = curve.recording.as_ref();
        let notes = recording.map_or(&curve.notes[..], |r| &r.warnings);
        let open = force::Note::doubts(notes).into_iter();
        open.filter(|question| !self.accept.contains(question))
            .map(|question| question.name())
            .collect()
    }
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// Name of a file without its extension. For a recording, it is also the name of the walker.
fn stem(path: &Path) -> String {
    let name = path.file_stem().unwrap_or_default();
    name.to_string_lossy().into_owned()
}
