//! Tables of a sweep as Parquet files.

use std::collections::HashMap;
use std::fs::File;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type};
use arrow_array::{Array, ArrayRef, DictionaryArray, Float64Array, StringArray, UInt64Array};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::ChunkReader;
use parquet::schema::types::ColumnPath;

use gaitcam::error::{Error, FileError, Placed, Result, SweepError};
use gaitcam::sweep::{self, FieldValues, NUMBERS, Records, TIME, Words};

pub use arrow_array::RecordBatch;

/// Maximum number of rows in a row group. A [`Writer`] keeps one row group in memory.
pub const GROUP_ROWS: usize = 131_072;

fn field(column: &sweep::Field) -> Field {
    let dictionary = || DataType::Dictionary(DataType::Int32.into(), DataType::Utf8.into());
    let (kind, nullable) = match column.values {
        FieldValues::Rows(_) => (DataType::UInt64, false),
        FieldValues::Numbers(_) => (DataType::Float64, true),
        FieldValues::Words(_) => (dictionary(), true),
    };
    let field = Field::new(&column.name, kind, nullable);
    match column.unit() {
        "" => field,
        unit => field.with_metadata(HashMap::from([("unit".to_string(), unit.to_string())])),
    }
}

/// Schema of a table: names, types and units of the columns, and metadata of the whole table.
pub fn schema(records: &Records, metadata: &[(String, String)]) -> SchemaRef {
    let fields: Vec<Field> = records.fields.iter().map(field).collect();
    let metadata: HashMap<String, String> = metadata.iter().cloned().collect();
    Arc::new(Schema::new(fields).with_metadata(metadata))
}

fn numbers(values: &[f64]) -> ArrayRef {
    if values.iter().any(|x| x.is_nan()) {
        let some = values.iter().map(|x| (!x.is_nan()).then_some(*x));
        return Arc::new(Float64Array::from_iter(some));
    }
    Arc::new(Float64Array::from_iter_values(values.iter().copied()))
}

fn words(words: &Words) -> ArrayRef {
    let codes = words.codes.iter().map(|&c| (c >= 0).then_some(c));
    let names = StringArray::from_iter_values(&words.names);
    let keys = arrow_array::PrimitiveArray::<Int32Type>::from_iter(codes);
    Arc::new(DictionaryArray::new(keys, Arc::new(names)))
}

fn arrow_fault(e: arrow_schema::ArrowError) -> Error {
    let fault = e.to_string();
    SweepError::Arrow { fault }.into()
}

fn parquet_fault(e: parquet::errors::ParquetError) -> Error {
    let fault = e.to_string();
    SweepError::Parquet { fault }.into()
}

/// Rows as a record batch with the given schema.
///
/// # Errors
///
/// The columns do not fit the schema.
pub fn record_batch(schema: &SchemaRef, records: &Records) -> Result<RecordBatch> {
    let columns = records.fields.iter().map(|field| match &field.values {
        FieldValues::Rows(x) => Arc::new(UInt64Array::from_iter_values(x.iter().copied())),
        FieldValues::Numbers(x) => numbers(x),
        FieldValues::Words(w) => words(w),
    });
    RecordBatch::try_new(schema.clone(), columns.collect()).map_err(arrow_fault)
}

/// Content of a Parquet file with the given rows.
///
/// # Errors
///
/// The columns have different lengths.
pub fn file(records: &Records, metadata: &[(String, String)]) -> Result<Vec<u8>> {
    let schema = schema(records, metadata);
    let mut writer = Writer::new(Vec::new(), &schema)?;
    writer.write(&record_batch(&schema, records)?)?;
    writer.close()
}

/// Writes rows to a Parquet file step by step. Only one row group is in memory.
pub struct Writer<W: Write + Send> {
    inner: ArrowWriter<W>,
}

impl<W: Write + Send> Writer<W> {
    /// Starts a file with the columns of `schema`.
    ///
    /// # Errors
    ///
    /// The sink cannot write the header.
    pub fn new(sink: W, schema: &SchemaRef) -> Result<Self> {
        let mut properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_max_row_group_row_count(Some(GROUP_ROWS));
        // Results rarely repeat, so a dictionary would not save space. Parameters repeat.
        for name in NUMBERS.iter().chain([&TIME]) {
            properties = properties.set_column_dictionary_enabled(ColumnPath::from(*name), false);
        }
        let inner = ArrowWriter::try_new(sink, schema.clone(), Some(properties.build()));
        Ok(Writer {
            inner: inner.map_err(parquet_fault)?,
        })
    }

    /// Adds a batch of rows.
    ///
    /// # Errors
    /// The sink cannot write the rows.
    pub fn write(&mut self, batch: &RecordBatch) -> Result<()> {
        self.inner.write(batch).map_err(parquet_fault)
    }

    /// Finishes the file and returns the sink.
    ///
    /// # Errors
    /// The sink cannot write the footer.
    pub fn close(self) -> Result<W> {
        self.inner.into_inner().map_err(parquet_fault)
    }
}

/// Joins the rows of several files with equal columns in one file.
///
/// # Errors
///
/// There are no rows, a file cannot be read, or the sink cannot write the rows.
pub fn join<W: Write + Send>(files: &[PathBuf], sink: W) -> Result<W> {
    let mut sink = Some(sink);
    let mut writer = None;
    for path in files {
        let fault = |e: std::io::Error| {
            let fault = e.to_string();
            FileError::CannotRead { fault }.in_file(path)
        };
        read(File::open(path).map_err(fault)?, |batch| {
            if let Some(sink) = sink.take() {
                writer = Some(Writer::new(sink, &batch.schema())?);
            }
            writer.iter_mut().try_for_each(|w| w.write(batch))
        })?;
    }
    let empty = || gaitcam::error::Error::from(SweepError::NoRows);
    writer.ok_or_else(empty)?.close()
}

/// Reads a table batch by batch and calls `each` with every batch, which contains all columns.
///
/// # Errors
///
/// The file is not a valid Parquet file, or `each` returns an error.
pub fn read<R: ChunkReader + 'static>(
    file: R,
    mut each: impl FnMut(&RecordBatch) -> Result<()>,
) -> Result<()> {
    let reader = ParquetRecordBatchReaderBuilder::try_new(file)
        .and_then(|b| b.with_batch_size(8192).build())
        .map_err(parquet_fault)?;
    for batch in reader {
        each(&batch.map_err(arrow_fault)?)?;
    }
    Ok(())
}

/// Number in a row of a column; NaN if it is missing.
pub fn number_at(column: &ArrayRef, row: usize) -> f64 {
    if column.is_null(row) {
        return f64::NAN;
    }
    if let Some(x) = column.as_primitive_opt::<Float64Type>() {
        return x.value(row);
    }
    column
        .as_primitive_opt::<arrow_array::types::UInt64Type>()
        .map_or(f64::NAN, |x| x.value(row) as f64)
}

/// Text in a row of a column; empty if it is missing.
pub fn word_at(column: &ArrayRef, row: usize) -> &str {
    if let Some(words) = column.as_dictionary_opt::<Int32Type>() {
        return words.key(row).map_or("", |k| word_at(words.values(), k));
    }
    match column.as_string_opt::<i32>() {
        Some(w) if !column.is_null(row) => w.value(row),
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_from_a_file_as_they_went_with_units_and_metadata() {
        let records = Records {
            fields: vec![
                sweep::Field::rows(7, 3),
                sweep::Field::numbers("stroke_m", vec![0.1, f64::NAN, f64::INFINITY]),
                sweep::Field::words("verdict", ["acceptable", "", "acceptable"].into_iter()),
            ],
        };
        let metadata = [("plan".to_string(), "x".to_string())];
        let bytes = file(&records, &metadata).unwrap();
        let mut seen = Vec::new();
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(&bytes).unwrap();
        read(file, |batch| {
            let schema = batch.schema();
            assert_eq!(schema.metadata()["plan"], "x");
            assert_eq!(schema.field(1).metadata()["unit"], "m");
            for row in 0..batch.num_rows() {
                let number = |c: usize| number_at(batch.column(c), row).to_bits();
                let word = word_at(batch.column(2), row).to_string();
                seen.push((number(0), number(1), word));
            }
            Ok(())
        })
        .unwrap();
        let row = |n: f64, x: f64, w: &str| (n.to_bits(), x.to_bits(), w.to_string());
        let expected = [
            row(7.0, 0.1, "acceptable"),
            row(8.0, f64::NAN, ""),
            row(9.0, f64::INFINITY, "acceptable"),
        ];
        assert_eq!(seen, expected);
    }
}
