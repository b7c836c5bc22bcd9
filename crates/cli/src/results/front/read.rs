//! A sweep's table, row by row, and the part of it that pictures need.

use std::borrow::Cow;
use std::fs::File;
use std::path::Path;

use crate::console::error::CliError;
use crate::console::words;
use crate::input;
use gaitcam::error::{Placed, Result};
use gaitcam::sweep::table::cell_text;
use gaitcam::sweep::{Key, NUMBERS, Objective};
use gaitcam_app::blocks;
use gaitcam_app::read::open;
use gaitcam_output::sweep_plots::Quantity;

/// Where the columns of a table are.
#[derive(Debug, Clone, Default)]
pub struct Columns {
    /// All names.
    pub names: Vec<String>,
    /// Columns of varied keys.
    pub inputs: Vec<usize>,
    /// `outcome`.
    pub outcome: usize,
    /// `verdict`.
    pub verdict: usize,
}

impl Columns {
    fn of(path: &Path, names: Vec<String>) -> Result<Columns> {
        let find = |name: &str| {
            names.iter().position(|n| n == name).ok_or_else(|| {
                let column = name.to_string();
                CliError::NotSweepTable { column }.in_file(path)
            })
        };
        let first = find(NUMBERS[0])?;
        find("row")?;
        Ok(Columns {
            outcome: find("outcome")?,
            verdict: find("verdict")?,
            inputs: (1..first).filter(|&c| names[c] != "scene").collect(),
            names,
        })
    }
}

/// A row of either kind of table.
pub enum Row<'a> {
    /// Of a CSV file.
    Csv(&'a csv::StringRecord),
    /// Of a Parquet file.
    #[cfg(feature = "parquet")]
    Parquet(&'a gaitcam_output::parquet::RecordBatch, usize),
}

impl Row<'_> {
    /// A number; NaN where there is none.
    pub fn number(&self, column: usize) -> f64 {
        match self {
            Row::Csv(record) => record
                .get(column)
                .and_then(|c| c.parse().ok())
                .unwrap_or(f64::NAN),
            #[cfg(feature = "parquet")]
            Row::Parquet(batch, row) => {
                gaitcam_output::parquet::number_at(batch.column(column), *row)
            }
        }
    }

    /// The cell as text.
    pub fn word(&self, column: usize) -> String {
        self.text(column).into_owned()
    }

    fn text(&self, column: usize) -> Cow<'_, str> {
        match self {
            Row::Csv(record) => Cow::Borrowed(cell_text(record.get(column).unwrap_or(""))),
            #[cfg(feature = "parquet")]
            Row::Parquet(batch, row) => {
                use gaitcam_output::parquet::{number_at, word_at};
                let column = batch.column(column);
                let number = number_at(column, *row);
                if number.is_nan() {
                    Cow::Borrowed(word_at(column, *row))
                } else {
                    Cow::Owned(number.to_string())
                }
            }
        }
    }
}

/// Reads the table once, whatever its size; of a folder every block of rows in it.
pub fn each_row(path: &Path, mut each: impl FnMut(&Columns, Row) -> Result<()>) -> Result<Columns> {
    if path.is_dir() {
        let mut columns = None;
        for (_, block) in blocks::files(path)? {
            columns = Some(each_row_of(&block, &mut each)?);
        }
        return columns.ok_or_else(|| CliError::NoBlocks.in_file(path));
    }
    each_row_of(path, &mut each)
}

fn each_row_of(path: &Path, each: &mut impl FnMut(&Columns, Row) -> Result<()>) -> Result<Columns> {
    let file = open(path)?;
    if path
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("parquet"))
    {
        return parquet_rows(path, file, each);
    }
    let mut reader = csv::Reader::from_reader(std::io::BufReader::with_capacity(1 << 20, file));
    let fault = input::not_csv(path);
    let names = reader.headers().map_err(&fault)?.iter().map(str::to_string);
    let columns = Columns::of(path, names.collect())?;
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(&fault)? {
        each(&columns, Row::Csv(&record))?;
    }
    Ok(columns)
}

#[cfg(feature = "parquet")]
fn parquet_rows(
    path: &Path,
    file: File,
    mut each: impl FnMut(&Columns, Row) -> Result<()>,
) -> Result<Columns> {
    let mut columns: Option<Columns> = None;
    gaitcam_output::parquet::read(file, |batch| {
        if columns.is_none() {
            let schema = batch.schema();
            let names = schema.fields().iter().map(|f| f.name().clone());
            columns = Some(Columns::of(path, names.collect())?);
        }
        let Some(columns) = &columns else {
            return Ok(());
        };
        (0..batch.num_rows()).try_for_each(|row| each(columns, Row::Parquet(batch, row)))
    })
    .map_err(|e| e.at(gaitcam::error::Place::File(path.to_path_buf())))?;
    columns.ok_or_else(|| CliError::EmptyTable.in_file(path))
}

#[cfg(not(feature = "parquet"))]
fn parquet_rows(
    path: &Path,
    _: File,
    _: impl FnMut(&Columns, Row) -> Result<()>,
) -> Result<Columns> {
    Err(CliError::NoParquet.in_file(path))
}

/// Rows kept for pictures, at most.
const KEPT_ROWS: usize = 60_000;

/// Values of one varied key in the rows kept.
#[derive(Debug, Clone, Default)]
pub struct Input {
    /// Its column.
    pub column: usize,
    name: String,
    values: Vec<f64>,
    words: Vec<String>,
    is_number: bool,
}

impl Input {
    /// Whether it takes more than one value.
    pub fn varies(&self) -> bool {
        self.values.windows(2).any(|w| w[0] != w[1])
    }

    /// The values for a picture.
    pub fn quantity(&self) -> Quantity {
        Quantity {
            label: words::column(&self.name),
            values: self.values.clone(),
            words: self.words.clone(),
        }
    }

    /// Position of a cell on the axis: its number, or the index of its word.
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

/// Every k-th candidate, k growing with the table.
#[derive(Debug, Clone, Default)]
pub struct Kept {
    /// Rows of the table.
    pub seen: u64,
    /// Those that count.
    pub candidates: u64,
    /// Numbers of the rows kept.
    pub rows: Vec<u64>,
    /// Varied keys.
    pub inputs: Vec<Input>,
    /// Objectives of the rows kept.
    pub goals: Vec<Vec<f64>>,
    stride: u64,
}

impl Kept {
    /// Looks at a row.
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

    /// Leaves out every second row.
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
