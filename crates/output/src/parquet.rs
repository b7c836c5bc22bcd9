//! Arrow record batches in and out of the kernel, and rows as Parquet.

use std::collections::HashMap;
use std::io::Write;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, Float64Array, StringArray, UInt64Array};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::ChunkReader;
use parquet::schema::types::ColumnPath;

use gaitcam::error::{Error, Place, Result, SweepError};
use gaitcam::sweep::{Batch, Column, Kernel, Key, NUMBERS, Results, TIME, WORDS, table::unit_of};

pub use arrow_array::RecordBatch;

/// Rows of a row group.
pub const GROUP_ROWS: usize = 131_072;

fn numbers_field(name: &str) -> Field {
    let unit = unit_of(name);
    let field = Field::new(name, DataType::Float64, true);
    if unit.is_empty() {
        return field;
    }
    field.with_metadata(HashMap::from([("unit".to_string(), unit.to_string())]))
}

fn words_field(name: &str) -> Field {
    Field::new(name, DataType::Utf8, true)
}

fn result_fields() -> Vec<Field> {
    let mut out: Vec<Field> = NUMBERS.iter().map(|n| numbers_field(n)).collect();
    out.extend(WORDS.iter().map(|w| words_field(w)));
    out.push(numbers_field(TIME));
    out
}

/// Names, types and units of all columns of a table.
pub fn schema(keys: &[Key], several_scenes: bool) -> SchemaRef {
    let mut fields = vec![Field::new("row", DataType::UInt64, false)];
    if several_scenes {
        fields.push(words_field("scene"));
    }
    for key in keys {
        fields.push(if key.is_number() {
            numbers_field(&key.column())
        } else {
            words_field(&key.column())
        });
    }
    fields.extend(result_fields());
    Arc::new(Schema::new(fields))
}

fn numbers(values: &[f64]) -> ArrayRef {
    if values.iter().any(|x| x.is_nan()) {
        let some = values.iter().map(|x| (!x.is_nan()).then_some(*x));
        return Arc::new(Float64Array::from_iter(some));
    }
    Arc::new(Float64Array::from_iter_values(values.iter().copied()))
}

fn words<'a>(values: impl Iterator<Item = &'a str>) -> ArrayRef {
    let some = values.map(|w| (!w.is_empty()).then_some(w));
    Arc::new(StringArray::from_iter(some))
}

fn result_columns(results: &Results) -> Vec<ArrayRef> {
    let mut out: Vec<ArrayRef> = (0..NUMBERS.len())
        .map(|c| numbers(results.numbers(c)))
        .collect();
    out.extend((0..WORDS.len()).map(|c| words(results.words(c).into_iter())));
    out.push(numbers(results.times()));
    out
}

fn at_column(column: &str, fault: SweepError) -> Error {
    Error::from(fault).at(Place::Key(column.to_string()))
}

fn arrow_fault(e: arrow_schema::ArrowError) -> Error {
    let fault = e.to_string();
    SweepError::Arrow { fault }.into()
}

fn parquet_fault(e: parquet::errors::ParquetError) -> Error {
    let fault = e.to_string();
    SweepError::Parquet { fault }.into()
}

/// The rows `first …` as a record batch of the table.
///
/// # Errors
/// Columns that do not fit the schema.
pub fn record_batch(
    schema: &SchemaRef,
    first: u64,
    batch: &Batch,
    results: &Results,
    scenes: Option<&[String]>,
) -> Result<RecordBatch> {
    let rows = first..first + results.len() as u64;
    let mut columns: Vec<ArrayRef> = vec![Arc::new(UInt64Array::from_iter_values(rows))];
    if let Some(names) = scenes {
        let name = |s: &u32| names.get(*s as usize).map_or("", String::as_str);
        columns.push(words(batch.scene.iter().map(name)));
    }
    for column in &batch.columns {
        columns.push(match column {
            Column::Numbers(x) => numbers(x),
            Column::Words(w) => words(w.iter().map(|w| &**w)),
        });
    }
    columns.extend(result_columns(results));
    RecordBatch::try_new(schema.clone(), columns).map_err(arrow_fault)
}

/// Answers a record batch of scene parameters with a record batch of results, row for row.
///
/// The batch needs one column per key of the kernel, by the name that [`Key::column`] gives: Float64 in SI
/// for quantities, Utf8 for words. An optional Float64 column `scene` counts base scenes from 0. Pure: no
/// file is touched but what the kernel's own targets read.
///
/// # Errors
/// Fails on a missing column or another type.
pub fn answer(kernel: &Kernel, parameters: &RecordBatch) -> Result<RecordBatch> {
    let rows = parameters.num_rows();
    let mut batch = Batch {
        scene: vec![0; rows],
        columns: Vec::new(),
    };
    if let Some(column) = parameters.column_by_name("scene") {
        let scenes = column
            .as_primitive_opt::<Float64Type>()
            .ok_or_else(|| at_column("scene", SweepError::ColumnType { wanted: "Float64" }))?;
        batch.scene = scenes.values().iter().map(|s| *s as u32).collect();
    }
    for key in kernel.keys() {
        let name = key.column();
        let column = parameters
            .column_by_name(&name)
            .ok_or_else(|| at_column(&name, SweepError::ColumnMissing))?;
        batch.columns.push(if key.is_number() {
            let values = column
                .as_primitive_opt::<Float64Type>()
                .ok_or_else(|| at_column(&name, SweepError::ColumnType { wanted: "Float64" }))?;
            Column::Numbers(values.iter().map(|x| x.unwrap_or(f64::NAN)).collect())
        } else {
            let values = column
                .as_string_opt::<i32>()
                .ok_or_else(|| at_column(&name, SweepError::ColumnType { wanted: "Utf8" }))?;
            Column::Words(values.iter().map(|w| Arc::from(w.unwrap_or(""))).collect())
        });
    }
    let schema = Arc::new(Schema::new(result_fields()));
    RecordBatch::try_new(schema, result_columns(&kernel.run(&batch))).map_err(arrow_fault)
}

/// Writes rows as they come; holds one row group at a time.
pub struct Writer<W: Write + Send> {
    inner: ArrowWriter<W>,
}

impl<W: Write + Send> Writer<W> {
    /// Begins a file for the columns of `schema`.
    ///
    /// # Errors
    /// The sink refuses the header.
    pub fn new(sink: W, schema: &SchemaRef) -> Result<Self> {
        let mut properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_max_row_group_row_count(Some(GROUP_ROWS));
        // Measured numbers hardly ever repeat: a dictionary of them is lost work. Parameters do.
        for name in NUMBERS.iter().chain([&TIME]) {
            properties = properties.set_column_dictionary_enabled(ColumnPath::from(*name), false);
        }
        let inner = ArrowWriter::try_new(sink, schema.clone(), Some(properties.build()));
        Ok(Writer {
            inner: inner.map_err(parquet_fault)?,
        })
    }

    /// Adds rows.
    ///
    /// # Errors
    /// The sink refuses the rows.
    pub fn write(&mut self, batch: &RecordBatch) -> Result<()> {
        self.inner.write(batch).map_err(parquet_fault)
    }

    /// Ends the file and gives the sink back.
    ///
    /// # Errors
    /// The sink refuses the footer.
    pub fn close(self) -> Result<W> {
        self.inner.into_inner().map_err(parquet_fault)
    }
}

/// Reads a table's columns by their names, batch by batch, everything as text or numbers: `each` gets the
/// columns in the order asked. A column that is missing is an error.
///
/// # Errors
/// A file that is no Parquet file, or lacks a column.
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

/// A number of a record batch; NaN where there is none.
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

/// A word of a record batch; empty where there is none.
pub fn word_at(column: &ArrayRef, row: usize) -> &str {
    match column.as_string_opt::<i32>() {
        Some(w) if !column.is_null(row) => w.value(row),
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gaitcam::error::SynthError;
    use gaitcam::halt::Halt;
    use gaitcam::scene::{self, Scene};
    use gaitcam::sweep::{Axis, NamedScene, Plan, Sampling};

    #[test]
    fn a_record_batch_of_parameters_gives_the_rows_of_the_plain_kernel() {
        let plan = Plan {
            scenes: vec![NamedScene {
                name: "x".to_string(),
                table: scene::DEFAULT.parse().unwrap(),
            }],
            list: None,
            axes: [
                "law.family=harmonic,program",
                "limits.curvature=1 mm:5 mm:3",
            ]
            .map(|t| Axis::parse(t, false).unwrap())
            .to_vec(),
            sampling: Sampling::Grid,
        };
        let none = |_: usize, _: &Scene| Err(SynthError::NoTarget.into());
        let kernel = Kernel::new(&plan.scenes, plan.keys(), &none, &|| 0.0, &Halt::never);
        let batch = plan.batch(0, 6);
        let results = kernel.run(&batch);
        let full = schema(&plan.keys(), false);
        assert_eq!(full.field(2).metadata()["unit"], "m");
        let table = record_batch(&full, 0, &batch, &results, None).unwrap();
        let parameters = table.project(&[1, 2]).unwrap();
        let answers = answer(&kernel, &parameters).unwrap();
        let again: Vec<ArrayRef> = table.columns()[3..].to_vec();
        assert_eq!(answers.columns(), again);
        let mut writer = Writer::new(tempfile::tempfile().unwrap(), &full).unwrap();
        writer.write(&table).unwrap();
        let file = writer.close().unwrap();
        let mut rows = 0;
        read(file, |b| {
            assert_eq!(b.columns(), table.columns());
            rows += b.num_rows();
            Ok(())
        })
        .unwrap();
        assert_eq!(rows, 6);
    }
}
