//! Counts of the rows of a sweep by outcome and verdict.

use std::path::Path;

use crate::results::front::read::each_row;
use gaitcam::cam::Verdict;
use gaitcam::sweep::{Outcome, Records};

/// Numbers of rows of a sweep by outcome and verdict.
#[derive(Debug, Clone, Default)]
pub struct Counts {
    /// Number of counted rows.
    pub rows: u64,
    /// Number of rows with a designed cam.
    pub built: u64,
    /// Number of cams with the verdict "acceptable".
    pub acceptable: u64,
    /// Number of cams with the verdict "not for high speed".
    pub low_speed: u64,
    /// Number of rows with infeasible limits.
    pub infeasible: u64,
    /// Number of rows with an invalid scene.
    pub errors: u64,
    /// Number of the first row with an invalid scene, and its error message.
    pub first_error: Option<(u64, String)>,
}

impl Counts {
    /// Counts the rows of `records` by outcome and verdict.
    pub fn of(records: &Records) -> Counts {
        let columns = ["outcome", "verdict", "error"].map(|name| records.words(name));
        let first = records.first_row().unwrap_or(0);
        let mut out = Counts::default();
        for row in 0..records.len() {
            let [outcome, verdict, error] =
                columns.map(|c| c.and_then(|c| c.at(row)).unwrap_or(""));
            out.count(first, outcome, verdict, error);
        }
        out
    }

    /// Counts of the rows in a block file. `first` is the number of its first row. If the block is truncated, the number of counted rows is
    /// too small.
    pub fn of_block(path: &Path, first: u64) -> Counts {
        let mut out = Counts::default();
        // The rows before the fault are counted. The caller compares their number with the expected number of rows.
        let _ = each_row(path, |columns, row| {
            let error = columns.names.iter().position(|n| n == "error");
            let error = error.map_or(String::new(), |c| row.word(c));
            let (outcome, verdict) = (row.word(columns.outcome), row.word(columns.verdict));
            out.count(first, &outcome, &verdict, &error);
            Ok(())
        });
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

    /// Adds the counts of the next rows of the table.
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
