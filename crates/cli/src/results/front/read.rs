//! Reads the table of a sweep row by row.

use std::borrow::Cow;
use std::fs::File;
use std::path::Path;

use crate::console::error::CliError;
use crate::input;
use gaitcam::error::{Placed, Result};
use gaitcam::sweep::NUMBERS;
use gaitcam::sweep::table::cell_text;
use gaitcam_app::blocks;
use gaitcam_app::read::open;

/// Names and indices of the columns of a table.
#[derive(Debug, Clone, Default)]
pub struct Columns {
    /// Names of all columns.
    pub names: Vec<String>,
    /// Indices of the columns of the varied keys.
    pub inputs: Vec<usize>,
    /// Index of the column `outcome`.
    pub outcome: usize,
    /// Index of the column `verdict`.
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

/// Row of a table in a CSV or Parquet file.
pub enum Row<'a> {
    /// Row of a CSV file.
    Csv(&'a csv::StringRecord),
    /// Row of a Parquet file.
    #[cfg(feature = "parquet")]
    Parquet(&'a gaitcam_output::parquet::RecordBatch, usize),
}

impl Row<'_> {
    /// Number in a column of the row. A missing number is NaN.
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

    /// Text in a column of the row, as a new string.
    pub fn word(&self, column: usize) -> String {
        self.text(column).into_owned()
    }

    pub fn text(&self, column: usize) -> Cow<'_, str> {
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

/// Calls `each` for every row of the table. The table is read once. For a folder, all its block files are read in order.
pub fn each_row(path: &Path, mut each: impl FnMut(&Columns, Row) -> Result<()>) -> Result<Columns> {
    if path.is_dir() {
        let mut columns = None;
        for (_, block) in blocks::complete_files(path)? {
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
