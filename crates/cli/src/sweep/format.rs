//! File formats of sweep tables.

use std::fs::File;
use std::io::{BufRead, BufReader, Write, copy};
use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use gaitcam::error::{Error, Placed, Result};
use gaitcam::sweep::Records;
use gaitcam_app::read::cannot_be_read;
#[cfg(feature = "parquet")]
use gaitcam_output::parquet;

/// File format of a sweep table and of its blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet, which requires the feature `parquet`.
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Format {
    /// Format of the blocks when several processes share a sweep.
    #[cfg(feature = "parquet")]
    pub const SHARED: Format = Format::Parquet;
    /// Format of the blocks when several processes share a sweep.
    #[cfg(not(feature = "parquet"))]
    pub const SHARED: Format = Format::Csv;

    /// Format that corresponds to the ending of a path.
    pub fn of(path: &Path) -> Result<Format> {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("csv") => Ok(Format::Csv),
            #[cfg(feature = "parquet")]
            Some("parquet") => Ok(Format::Parquet),
            #[cfg(not(feature = "parquet"))]
            Some("parquet") => Err(CliError::NoParquet.at_argument("--out")),
            _ => {
                let file = path.display().to_string();
                Err(CliError::TableEnding { file }.at_argument("--out"))
            }
        }
    }

    /// File ending of the format.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Csv => "csv",
            #[cfg(feature = "parquet")]
            Format::Parquet => "parquet",
        }
    }

    /// Rows as lines of CSV text. The text is empty for other formats.
    pub fn lines(self, records: &Records) -> String {
        match self {
            Format::Csv => records.csv_rows(),
            #[cfg(feature = "parquet")]
            Format::Parquet => String::new(),
        }
    }

    /// Content of a block file, which is a complete table of the given rows. In CSV, the rows are taken from `lines`, the result of
    /// [`Format::lines`]. In Parquet, `metadata` is stored in the file.
    pub fn block(
        self,
        records: &Records,
        lines: &str,
        metadata: &[(String, String)],
    ) -> Result<Vec<u8>> {
        match self {
            Format::Csv => {
                // CSV cannot store metadata. The file `_plan.json` in the folder of blocks contains them.
                let _ = metadata;
                Ok((records.csv_header() + lines).into_bytes())
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => parquet::file(records, metadata),
        }
    }

    /// Writes the rows of all blocks to one table.
    pub fn join(self, blocks: &[PathBuf], table: File) -> Result<File> {
        match self {
            Format::Csv => join_csv(blocks, table),
            #[cfg(feature = "parquet")]
            Format::Parquet => parquet::join(blocks, table),
        }
    }
}

/// Writes the header once, and then the lines of every block.
fn join_csv(blocks: &[PathBuf], mut table: File) -> Result<File> {
    for (i, path) in blocks.iter().enumerate() {
        let fault = |e: std::io::Error| cannot_be_read(path, &e);
        let mut block = BufReader::new(File::open(path).map_err(fault)?);
        let mut header = Vec::new();
        block.read_until(b'\n', &mut header).map_err(fault)?;
        let first = if i == 0 { &header[..] } else { &[] };
        let written = table
            .write_all(first)
            .and_then(|()| copy(&mut block, &mut table));
        written.map_err(|e| -> Error {
            let fault = e.to_string();
            CliError::AllRowsSafe { fault }.in_file(path)
        })?;
    }
    Ok(table)
}
