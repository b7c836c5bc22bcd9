//! The columns of a table that are read, before time and unit are decided.

use super::choose::{Plan, unit_label};
use super::header::Table;
use super::table::Numbers;
use super::times::time_unit;
use crate::read::vertical::RawForce;
use crate::recording::{Axis, Foot, Note};

/// Raw columns with their time.
#[derive(Debug)]
pub(super) struct Raw {
    /// Times as written, where there is a time column.
    pub times: Option<Vec<f64>>,
    /// Seconds per unit of the times, if the column gives it.
    pub time_unit: Option<f64>,
    /// Whether times count samples.
    pub counts: bool,
    pub forces: Vec<RawForce>,
    pub samples: usize,
    pub skipped: Vec<usize>,
    /// What was guessed in the choice of columns.
    pub notes: Vec<Note>,
}

impl Raw {
    /// The columns of a plan; `place` tells where a column of the table stands among those that were read.
    pub fn of(table: &Table, plan: Plan, read: Numbers, place: impl Fn(usize) -> usize) -> Raw {
        let mut columns = read.columns;
        let samples = columns.first().map_or(0, Vec::len);
        let mut take = |i: usize| std::mem::take(&mut columns[place(i)]);
        let times = plan.time.map(&mut take);
        let numbered = |i: usize| format!("column {}", i + 1);
        let name = |i: usize| table.names.get(i).map(|n| n.trim().to_string());
        let force = |(i, axis, foot): (usize, Axis, Option<Foot>)| RawForce {
            name: name(i).unwrap_or_else(|| numbered(i)),
            axis,
            foot,
            unit: unit_label(table, i),
            values: take(i),
        };
        Raw {
            times,
            time_unit: plan.time.and_then(|t| time_unit(table, t)),
            counts: plan.counts,
            forces: plan.force.into_iter().map(force).collect(),
            samples,
            skipped: read.skipped,
            notes: Vec::new(),
        }
    }
}
