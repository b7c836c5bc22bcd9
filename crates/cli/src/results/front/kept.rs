//! Sample of the rows of a table, from which its pictures are drawn.

use super::read::{Columns, Row};
use crate::console::language;
use crate::console::words;
use gaitcam::scene::keys::{self, KEYS};
use gaitcam::sweep::{Key, Objective};
use gaitcam::wording::limit_label;
use gaitcam_output::sweep_plots::Quantity;

/// Maximum number of rows in the sample.
const KEPT_ROWS: usize = 60_000;

/// Values of one varied key in the sample.
#[derive(Debug, Clone, Default)]
pub struct Input {
    /// Index of the key's column in the table.
    pub column: usize,
    name: String,
    values: Vec<f64>,
    words: Vec<String>,
    is_number: bool,
}

/// Label of the axis for the column of a key: the name of the key in the language of the output, with its unit. Without such a name, the
/// label is the column name.
fn axis(column: &str) -> String {
    let typed = Key::of_column(column);
    let own = words::column(column);
    let is_limit = |k: &&keys::Key| k.path == typed.name() && k.limit.is_some();
    let name = match KEYS.iter().find(is_limit) {
        Some(limit) => in_lower_case(&limit_label(language::current(), limit.path)),
        None => words::name(typed.name()),
    };
    match own.rsplit_once(", ") {
        Some((_, unit)) if name != typed.name() => format!("{name}, {unit}"),
        _ => own,
    }
}

/// Label of a limit with a small first letter, like the other labels of axes. "Hertz pressure" begins with the name of a person.
fn in_lower_case(label: &str) -> String {
    if label.starts_with("Hertz") {
        return label.to_string();
    }
    let mut letters = label.chars();
    let first = letters.next().into_iter().flat_map(char::to_lowercase);
    first.chain(letters).collect()
}

impl Input {
    /// Whether the key has more than one value in the sample.
    pub fn varies(&self) -> bool {
        self.values.windows(2).any(|w| w[0] != w[1])
    }

    /// Values of the key in the sample, with the label of the axis.
    pub fn quantity(&self) -> Quantity {
        Quantity {
            label: axis(&self.name),
            values: self.values.clone(),
            words: self.words.clone(),
        }
    }

    /// Position of a cell on the axis: the number in the cell, or the index of the word in the cell. An unknown word gives NaN.
    pub fn place(&self, cell: &str) -> f64 {
        if self.is_number {
            return cell.parse().unwrap_or(f64::NAN);
        }
        self.words
            .iter()
            .position(|w| w == cell)
            .map_or(f64::NAN, |i| i as f64)
    }

    fn push(&mut self, row: &Row) {
        if self.is_number {
            self.values.push(row.number(self.column));
            return;
        }
        let word = row.text(self.column);
        let at = self
            .words
            .iter()
            .position(|w| *w == word)
            .unwrap_or_else(|| {
                self.words.push(word.into_owned());
                self.words.len() - 1
            });
        self.values.push(at as f64);
    }
}

/// Sample of the rows of a table. It contains every k-th candidate, where k increases with the number of candidates. A candidate is a row
/// whose design may be on the front.
#[derive(Debug, Clone, Default)]
pub struct FrontSample {
    /// Number of rows read so far.
    pub seen: u64,
    /// Number of candidates, in the sample or not.
    pub candidates: u64,
    /// Row numbers of the sample.
    pub rows: Vec<u64>,
    /// Varied keys of the sweep, each with its values in the sample.
    pub inputs: Vec<Input>,
    /// Values of the objectives: one list per objective, with one value per row of the sample.
    pub goals: Vec<Vec<f64>>,
    stride: u64,
}

impl FrontSample {
    /// Counts the next row of the table. `good` is true if the row is a candidate. Every k-th candidate is added to the sample.
    pub fn take(&mut self, columns: &Columns, objectives: &[Objective], row: &Row, good: bool) {
        if self.seen == 0 {
            self.stride = 1;
            self.goals = vec![Vec::new(); objectives.len()];
            let input = |&column: &usize| Input {
                column,
                name: columns.names[column].clone(),
                is_number: Key::of_column(&columns.names[column]).is_number()
                    || row.number(column).is_finite(),
                ..Input::default()
            };
            self.inputs = columns.inputs.iter().map(input).collect();
        }
        self.seen += 1;
        if !good {
            return;
        }
        self.candidates += 1;
        if !(self.candidates - 1).is_multiple_of(self.stride) {
            return;
        }
        self.rows.push(row.number(0) as u64);
        for input in &mut self.inputs {
            input.push(row);
        }
        for (values, objective) in self.goals.iter_mut().zip(objectives) {
            values.push(row.number(objective.column));
        }
        if self.rows.len() >= KEPT_ROWS {
            self.thin_out();
        }
    }

    /// Removes every second row from the sample.
    fn thin_out(&mut self) {
        self.stride *= 2;
        let mut i = 0;
        self.rows.retain(|_| {
            i += 1;
            i % 2 == 1
        });
        let lists = self
            .inputs
            .iter_mut()
            .map(|i| &mut i.values)
            .chain(&mut self.goals);
        for list in lists {
            *list = list.iter().copied().step_by(2).collect();
        }
    }
}
