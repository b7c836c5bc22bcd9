//! From the journal to the table.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::journal::{Journal, beside};
use super::work::progress;
use gaitcam::error::{Error, Result};
use gaitcam::sweep::{Kernel, Outcome, Plan, Results, table};

/// Rows that one thread turns into text at a time.
const TEXT_ROWS: usize = 4096;

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
            Some("parquet") => Err(Error::argument(
                "--out",
                "this gaitcam was built without Parquet (the feature \"parquet\")",
            )
            .help("write a .csv, or build with --features parquet")),
            _ => Err(Error::argument(
                "--out",
                format!("{} is neither .csv nor .parquet", path.display()),
            )
            .help("give the table one of these endings")),
        }
    }
}

/// What the table holds.
#[derive(Debug, Clone, Default)]
pub struct Counts {
    /// All rows.
    pub rows: u64,
    /// Cams designed.
    pub built: u64,
    /// Those on which every check passes.
    pub acceptable: u64,
    /// Limits leave none.
    pub infeasible: u64,
    /// Scenes at fault.
    pub errors: u64,
    /// The first of them.
    pub first_error: Option<(u64, String)>,
}

impl Counts {
    fn add(&mut self, first: u64, results: &Results) {
        let verdicts = results.words(1);
        for (row, verdict) in verdicts.into_iter().enumerate() {
            self.rows += 1;
            match results.outcome(row) {
                Outcome::Built => {
                    self.built += 1;
                    self.acceptable += u64::from(verdict == "acceptable");
                }
                Outcome::Infeasible => self.infeasible += 1,
                Outcome::Error => {
                    self.errors += 1;
                    if self.first_error.is_none() {
                        let what = results.words(5)[row].to_string();
                        self.first_error = Some((first + row as u64, what));
                    }
                }
            }
        }
    }
}

/// Writes the table beside its place and renames it into it.
pub fn table(
    plan: &Plan,
    kernel: &Kernel,
    pool: &rayon::ThreadPool,
    journal: &mut Journal,
    out: &Path,
    format: Format,
) -> Result<Counts> {
    let beside = beside(out, &format!(".{}.partial", std::process::id()));
    let fault = |e: std::io::Error| {
        Error::file(out, format!("cannot be written ({e})"))
            .help("all rows are safe in the journal: make room and go on with --resume")
    };
    let bar = progress("table", plan.rows() as u64, 0);
    let mut counts = Counts::default();
    let written = File::create(&beside).map_err(&fault).and_then(|file| {
        let mut sink = Sink::new(plan, pool, file, format, &fault)?;
        journal.replay(|first, rows, results| {
            let results = results.unwrap_or_else(|| kernel.run(&plan.batch(first, rows)));
            counts.add(first, &results);
            sink.rows(first, &results)?;
            bar.inc(rows as u64);
            Ok(())
        })?;
        sink.close()
    });
    bar.finish_and_clear();
    let placed = written.and_then(|()| place(&beside, out).map_err(&fault));
    if placed.is_err() {
        let _ = std::fs::remove_file(&beside);
    }
    placed.map(|()| counts)
}

fn place(beside: &PathBuf, out: &Path) -> std::io::Result<()> {
    std::fs::rename(beside, out)?;
    // The name is safe once its folder is.
    let folder = out.parent().filter(|p| !p.as_os_str().is_empty());
    match File::open(folder.unwrap_or(Path::new("."))) {
        Ok(folder) => folder.sync_all().or(Ok(())),
        Err(_) => Ok(()),
    }
}

/// A file that is being written, by kind.
enum Sheet {
    Csv(BufWriter<File>),
    #[cfg(feature = "parquet")]
    Parquet(
        Box<gaitcam::sweep::parquet::Writer<File>>,
        arrow_schema::SchemaRef,
    ),
}

/// Where rows go.
struct Sink<'a> {
    plan: &'a Plan,
    pool: &'a rayon::ThreadPool,
    names: Option<Vec<String>>,
    sheet: Sheet,
    fault: &'a dyn Fn(std::io::Error) -> Error,
}

impl<'a> Sink<'a> {
    fn new(
        plan: &'a Plan,
        pool: &'a rayon::ThreadPool,
        file: File,
        format: Format,
        fault: &'a dyn Fn(std::io::Error) -> Error,
    ) -> Result<Self> {
        let names: Vec<String> = plan.scenes.iter().map(|s| s.name.clone()).collect();
        let names = (names.len() > 1).then_some(names);
        let sheet = match format {
            Format::Csv => {
                let mut file = BufWriter::with_capacity(1 << 20, file);
                let header = table::csv_header(&plan.keys(), names.is_some());
                file.write_all(header.as_bytes()).map_err(fault)?;
                Sheet::Csv(file)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => {
                let schema = gaitcam::sweep::parquet::schema(&plan.keys(), names.is_some());
                Sheet::Parquet(
                    Box::new(gaitcam::sweep::parquet::Writer::new(file, &schema)?),
                    schema,
                )
            }
            #[cfg(not(feature = "parquet"))]
            Format::Parquet => return Err(Error::argument("--out", "built without Parquet")),
        };
        Ok(Sink {
            plan,
            pool,
            names,
            sheet,
            fault,
        })
    }

    fn rows(&mut self, first: u64, results: &Results) -> Result<()> {
        match &mut self.sheet {
            Sheet::Csv(file) => {
                let texts = texts(self.plan, self.pool, self.names.as_deref(), first, results);
                for text in texts {
                    file.write_all(text.as_bytes()).map_err(self.fault)?;
                }
                Ok(())
            }
            #[cfg(feature = "parquet")]
            Sheet::Parquet(writer, schema) => {
                let batch = self.plan.batch(first, results.len());
                let names = self.names.as_deref();
                writer.write(&gaitcam::sweep::parquet::record_batch(
                    schema, first, &batch, results, names,
                )?)
            }
        }
    }

    fn close(self) -> Result<()> {
        let synced = match self.sheet {
            Sheet::Csv(mut file) => file.flush().and_then(|()| file.get_ref().sync_all()),
            #[cfg(feature = "parquet")]
            Sheet::Parquet(writer, _) => writer.close()?.sync_all(),
        };
        synced.map_err(self.fault)
    }
}

/// Rows as lines, made by all threads, in order.
fn texts(
    plan: &Plan,
    pool: &rayon::ThreadPool,
    names: Option<&[String]>,
    first: u64,
    results: &Results,
) -> Vec<String> {
    let blocks = results.len().div_ceil(TEXT_ROWS);
    pool.install(|| {
        (0..blocks)
            .into_par_iter()
            .map(|b| {
                let (from, to) = (b * TEXT_ROWS, ((b + 1) * TEXT_ROWS).min(results.len()));
                let start = first + from as u64;
                let batch = plan.batch(start, to - from);
                table::csv_rows(start, &batch, &results.part(from, to), names)
            })
            .collect()
    })
}
