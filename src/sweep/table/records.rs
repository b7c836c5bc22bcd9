//! A table of a sweep in memory, stored by columns.

use std::collections::HashMap;

use super::results::{NUMBERS, Row, TIME, WORDS};
use super::unit_of;
use crate::sweep::plan::batch::{Batch, Column};
use crate::sweep::plan::key::Key;

/// Values in one column of a table.
///
/// ```
/// use gaitcam::sweep::{Field, FieldValues};
///
/// let field = Field::rows(10, 3);
/// assert_eq!(field.values, FieldValues::Rows(vec![10, 11, 12]));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Row numbers in the plan, counted from 0.
    Rows(Vec<u64>),
    /// Numbers in SI units; NaN if missing.
    Numbers(Vec<f64>),
    /// Words. Each distinct word is stored once.
    Words(Words),
}

/// Words of a column, stored as indices in a list of distinct words.
///
/// ```
/// use gaitcam::sweep::Words;
///
/// let words = Words::of(["spline", "harmonic", "spline"].into_iter());
/// assert_eq!((words.names.len(), words.at(2)), (2, Some("spline")));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Words {
    /// Index in `names` of the word of each row; −1 if the row has no word.
    pub codes: Vec<i32>,
    /// The distinct words of the column.
    pub names: Vec<String>,
}

/// A column of a table, with its name.
///
/// ```
/// use gaitcam::sweep::Field;
///
/// let stroke = Field::numbers("stroke_m", vec![0.04, 0.05]);
/// assert_eq!((stroke.values.len(), stroke.unit()), (2, "m"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Name of the column, whose suffix denotes the unit.
    pub name: String,
    /// Values of the column.
    pub values: Values,
}

/// A table of a sweep, stored by columns.
///
/// ```
/// use gaitcam::sweep::{Field, Records};
///
/// let part = |first| Records { fields: vec![Field::rows(first, 2)] };
/// assert_eq!(Records::joined(vec![part(0), part(2)]), Records { fields: vec![Field::rows(0, 4)] });
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Records {
    /// Columns of the table. All columns have the same length.
    pub fields: Vec<Field>,
}

impl Values {
    /// Number of rows in the column.
    pub fn len(&self) -> usize {
        match self {
            Values::Rows(x) => x.len(),
            Values::Numbers(x) => x.len(),
            Values::Words(w) => w.codes.len(),
        }
    }

    /// Whether the column has no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Words {
    /// Creates a column of words from the word of each row. An empty word counts as missing.
    pub fn of<'a>(words: impl Iterator<Item = &'a str>) -> Words {
        let mut out = Words::default();
        let mut known: HashMap<&str, i32> = HashMap::new();
        let mut before: (&str, i32) = ("", -1);
        for word in words {
            // Adjacent rows usually have the same word, and often share its text in memory.
            if word.is_empty() {
                out.codes.push(-1);
                continue;
            }
            if !std::ptr::eq(word, before.0) && word != before.0 {
                let next = out.names.len() as i32;
                let code = *known.entry(word).or_insert(next);
                if code == next {
                    out.names.push(word.to_string());
                }
                before = (word, code);
            }
            out.codes.push(before.1);
        }
        out
    }

    /// Word in a row; `None` if it is missing.
    pub fn at(&self, row: usize) -> Option<&str> {
        let code = usize::try_from(self.codes[row]).ok()?;
        self.names.get(code).map(String::as_str)
    }
}

impl Field {
    /// Creates a column of numbers in SI units.
    pub fn numbers(name: &str, values: Vec<f64>) -> Field {
        Field {
            name: name.to_string(),
            values: Values::Numbers(values),
        }
    }

    /// Creates a column of words. An empty word counts as missing.
    pub fn words<'a>(name: &str, words: impl Iterator<Item = &'a str>) -> Field {
        Field {
            name: name.to_string(),
            values: Values::Words(Words::of(words)),
        }
    }

    /// Creates the column `row` with `count` consecutive row numbers, starting at `first`.
    pub fn rows(first: u64, count: usize) -> Field {
        Field {
            name: "row".to_string(),
            values: Values::Rows((first..first + count as u64).collect()),
        }
    }

    /// SI unit of the numbers; empty for words, whole numbers and ratios.
    pub fn unit(&self) -> &'static str {
        match self.values {
            Values::Numbers(_) => unit_of(&self.name),
            Values::Rows(_) | Values::Words(_) => "",
        }
    }
}

impl Records {
    /// Table of consecutive rows of a sweep over `keys`, starting with the row `first`. It contains no computing times and therefore
    /// depends only on the plan. `scenes` contains the names of the base scenes; `None` if there is only one.
    pub fn of(
        first: u64,
        keys: &[Key],
        batch: &Batch,
        results: &[Row],
        scenes: Option<&[String]>,
    ) -> Records {
        let mut fields = vec![Field::rows(first, results.len())];
        if let Some(names) = scenes {
            let name = |s: &u32| names.get(*s as usize).map_or("", String::as_str);
            fields.push(Field::words("scene", batch.scene.iter().map(name)));
        }
        for (key, column) in keys.iter().zip(&batch.columns) {
            fields.push(match column {
                Column::Numbers(x) => Field::numbers(&key.column(), x.clone()),
                Column::Words(w) => Field::words(&key.column(), w.iter().map(|w| &**w)),
            });
        }
        for (i, name) in NUMBERS.iter().enumerate() {
            fields.push(Field::numbers(
                name,
                results.iter().map(|row| row.numbers[i]).collect(),
            ));
        }
        for (i, name) in WORDS.iter().enumerate() {
            fields.push(Field::words(name, results.iter().map(|row| row.words()[i])));
        }
        Records { fields }
    }

    /// The table with an additional column for the computing times, s.
    #[must_use]
    pub fn with_times(mut self, results: &[Row]) -> Records {
        let times = results.iter().map(|row| row.time_s).collect();
        self.fields.push(Field::numbers(TIME, times));
        self
    }

    /// Joins tables with the same columns, in the given order.
    pub fn joined(parts: Vec<Records>) -> Records {
        let mut out = Records::default();
        for part in parts {
            out.append(part);
        }
        out
    }

    fn column(&self, name: &str) -> Option<&Values> {
        let field = self.fields.iter().find(|f| f.name == name)?;
        Some(&field.values)
    }

    /// Numbers in the column `name`; `None` if no column of numbers has this name.
    pub fn numbers(&self, name: &str) -> Option<&[f64]> {
        match self.column(name)? {
            Values::Numbers(x) => Some(x),
            Values::Rows(_) | Values::Words(_) => None,
        }
    }

    /// Words in the column `name`; `None` if no column of words has this name.
    pub fn words(&self, name: &str) -> Option<&Words> {
        match self.column(name)? {
            Values::Words(words) => Some(words),
            Values::Rows(_) | Values::Numbers(_) => None,
        }
    }

    /// Number of the first row of the table in the plan; `None` for an empty table.
    pub fn first_row(&self) -> Option<u64> {
        match self.column("row")? {
            Values::Rows(rows) => rows.first().copied(),
            Values::Numbers(_) | Values::Words(_) => None,
        }
    }

    /// Number of rows in the table.
    pub fn len(&self) -> usize {
        self.fields.first().map_or(0, |f| f.values.len())
    }

    /// Whether the table has no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Appends the rows of a table that has the same columns.
    pub fn append(&mut self, next: Records) {
        if self.fields.is_empty() {
            *self = next;
            return;
        }
        for (field, next) in self.fields.iter_mut().zip(next.fields) {
            match (&mut field.values, next.values) {
                (Values::Rows(x), Values::Rows(y)) => x.extend(y),
                (Values::Numbers(x), Values::Numbers(y)) => x.extend(y),
                (Values::Words(x), Values::Words(y)) => x.append(&y),
                (Values::Rows(_) | Values::Numbers(_) | Values::Words(_), _) => {}
            }
        }
    }
}

impl Words {
    fn append(&mut self, next: &Words) {
        let mut known: HashMap<String, i32> = (self.names.iter().cloned()).zip(0..).collect();
        let places = next.names.iter().map(|name| {
            *known.entry(name.clone()).or_insert_with(|| {
                self.names.push(name.clone());
                self.names.len() as i32 - 1
            })
        });
        let places: Vec<i32> = places.collect();
        let moved = |&c: &i32| usize::try_from(c).map_or(-1, |c| places[c]);
        self.codes.extend(next.codes.iter().map(moved));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_named_once_and_stay_what_they_were_when_rows_are_added() {
        let words = |list: &[&str]| Words::of(list.iter().copied());
        let first = ["a", "a", "", "b", "a"];
        let second = ["", "b", "c", "a"];
        let mut all = words(&first);
        assert_eq!(all.names, ["a", "b"]);
        all.append(&words(&second));
        let said: Vec<&str> = (0..9).map(|i| all.at(i).unwrap_or("")).collect();
        assert_eq!(said, [&first[..], &second[..]].concat());
        assert_eq!(all.names, ["a", "b", "c"]);
    }
}
