//! Kinds of tables.

use std::path::Path;

use crate::console::error::CliError;
#[cfg(feature = "parquet")]
use gaitcam::error::FileError;
use gaitcam::error::{Placed, Result};
#[cfg(feature = "parquet")]
use gaitcam::sweep::Plan;

/// Kind of table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated text.
    Csv,
    /// Apache Parquet.
    Parquet,
}

impl Format {
    /// From the ending of the file's name.
    pub fn of(path: &Path) -> Result<Format> {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("csv") => Ok(Format::Csv),
            Some("parquet") if cfg!(feature = "parquet") => Ok(Format::Parquet),
            Some("parquet") => Err(CliError::NoParquet.at_argument("--out")),
            _ => {
                let file = path.display().to_string();
                Err(CliError::TableEnding { file }.at_argument("--out"))
            }
        }
    }
}

/// Writes the rows of a complete CSV table as Parquet.
#[cfg(feature = "parquet")]
pub fn to_parquet(plan: &Plan, csv: &Path, parquet: &Path) -> Result<()> {
    use gaitcam::sweep::{Records, Results, Row};
    use gaitcam_output::parquet::{GROUP_ROWS, Writer, record_batch, schema};

    let fault = |e: std::io::Error| {
        let fault = e.to_string();
        CliError::CannotWrite { fault }.in_file(parquet)
    };
    let unreadable = |e: csv::Error| {
        let fault = e.to_string();
        FileError::CannotRead { fault }.in_file(csv)
    };
    let names = plan.scene_names();
    let keys = plan.keys();
    let rows = |first: u64, results: &Results| {
        let batch = plan.batch(first, results.len());
        Records::of(first, &keys, &batch, results, names.as_deref()).with_times(results)
    };
    let schema = schema(&rows(0, &Results::with_capacity(0)), &[]);
    let file = std::fs::File::create(parquet).map_err(fault)?;
    let mut writer = Writer::new(file, &schema)?;
    let mut reader = csv::Reader::from_path(csv).map_err(unreadable)?;
    let mut records = reader.records().peekable();
    let mut first = 0;
    while records.peek().is_some() {
        let mut results = Results::with_capacity(GROUP_ROWS);
        for record in records.by_ref().take(GROUP_ROWS) {
            let record = record.map_err(unreadable)?;
            results.push(Row::of_fields(&record.iter().collect::<Vec<_>>()));
        }
        writer.write(&record_batch(&schema, &rows(first, &results))?)?;
        first += results.len() as u64;
    }
    writer.close()?.sync_all().map_err(fault)
}
