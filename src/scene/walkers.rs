//! The walkers whom a scene names, from the content of their files.

use std::path::Path;

use super::Gait;
use crate::error::{Error, FileError, Placed, Result};
use crate::force::{self, ForceCurve, Walker, WalkerFault, WalkerRow, walker_faults};
use crate::wording::InLanguages;

/// Endings of tables.
const TABLES: [&str; 3] = ["csv", "tsv", "txt"];

/// Reads a population file by file; what cannot be taken is named at the end.
pub(super) struct PopulationReader<'a> {
    gait: &'a Gait,
    walkers: Vec<Walker>,
    /// Why files hold no cycle.
    unreadable: Vec<Error>,
}

impl<'a> PopulationReader<'a> {
    /// A population without walkers.
    pub fn new(gait: &'a Gait) -> Self {
        PopulationReader {
            gait,
            walkers: Vec::new(),
            unreadable: Vec::new(),
        }
    }

    /// Whether the scene leaves a file out.
    pub fn leaves_out(&self, path: &Path) -> bool {
        let names = [file_name(path), path.display().to_string()];
        names.iter().any(|name| self.gait.leave_out.contains(name))
    }

    /// Whether the scene leaves a row of a table out: by the walker's name, or by file and line.
    fn leaves_row_out(&self, path: &Path, row: &WalkerRow) -> bool {
        let place = format!("{}:{}", file_name(path), row.line);
        let names = [&row.name, &place];
        names.iter().any(|name| self.gait.leave_out.contains(name))
    }

    /// Takes the cycle of a recording, or every row of a table; `metadata` gives the table of subjects beside it. Files and rows
    /// without a cycle are kept for the list of those that cannot be taken.
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

    /// Notes that a file cannot be read.
    pub fn refuse(&mut self, path: &Path, why: Error) {
        if !self.leaves_out(path) {
            self.unreadable.push(why.in_file(path));
        }
    }

    /// The mean of the walkers.
    ///
    /// # Errors
    /// Those who cannot be taken, by the reason; placed at `first` where no other file is at fault.
    pub fn mean(self, first: &Path) -> Result<ForceCurve> {
        let walkers = self.gait.walkers(self.walkers, &self.unreadable);
        let mean = walkers.and_then(ForceCurve::of_walkers);
        mean.map_err(|e| e.in_file(first))
    }
}

/// Whether a file is a table of walkers, by its ending and its header.
pub(super) fn is_table_of_walkers(path: &Path, bytes: &[u8]) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    TABLES.contains(&ending.to_lowercase().as_str()) && force::is_population(bytes)
}

/// The walker of a recording.
fn cycle(
    gait: &Gait,
    path: &Path,
    bytes: &[u8],
    metadata: impl FnOnce() -> Option<Vec<u8>>,
) -> Result<Walker> {
    let options = gait.read_options(metadata())?;
    let curve = force::force_curve(path, bytes, &options, gait.feet)?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Walker::new(&name, curve))
}

impl Gait {
    /// The walkers of a population that the scene does not leave out, if all can be taken; `unreadable` says why
    /// files have no cycle.
    ///
    /// # Errors
    /// Those who cannot be taken, by the reason.
    pub fn walkers(&self, mut all: Vec<Walker>, unreadable: &[Error]) -> Result<Vec<Walker>> {
        all.retain(|w| !self.leave_out.contains(&w.name));
        let mut names: [Vec<String>; 5] = Default::default();
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
        }
        .into())
    }
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}
