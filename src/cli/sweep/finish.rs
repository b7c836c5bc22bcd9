//! From the journal to the table.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::journal::{Journal, beside};
use super::work::progress;
use crate::error::{Error, Result};
use crate::sweep::{Kernel, Outcome, Plan, Results, table};

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
        for row in 0..results.len() {
            self.rows += 1;
            match results.outcome(row) {
                Outcome::Built => {
                    self.built += 1;
                    self.acceptable += u64::from(verdicts[row] == "acceptable");
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
    let written = File::create(&beside).map_err(fault).and_then(|file| {
        let mut sink = Sink::new(plan, pool, file, format, fault)?;
        journal.replay(|first, rows, results| {
            let results = results.unwrap_or_else(|| kernel.run(&plan.batch(first, rows)));
            counts.add(first, &results);
            sink.rows(first, results)?;
            bar.inc(rows as u64);
            Ok(())
        })?;
        sink.close()
    });
    bar.finish_and_clear();
    let placed = written.and_then(|()| place(&beside, out).map_err(fault));
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

/// Where rows go.
struct Sink<'a, F: Fn(std::io::Error) -> Error> {
    plan: &'a Plan,
    pool: &'a rayon::ThreadPool,
    names: Option<Vec<String>>,
    file: BufWriter<File>,
    fault: F,
}

impl<'a, F: Fn(std::io::Error) -> Error> Sink<'a, F> {
    fn new(
        plan: &'a Plan,
        pool: &'a rayon::ThreadPool,
        file: File,
        _format: Format,
        fault: F,
    ) -> Result<Self> {
        let names: Vec<String> = plan.scenes.iter().map(|s| s.name.clone()).collect();
        let names = (names.len() > 1).then_some(names);
        let mut file = BufWriter::with_capacity(1 << 20, file);
        let header = table::csv_header(&plan.keys(), names.is_some());
        file.write_all(header.as_bytes()).map_err(&fault)?;
        Ok(Sink {
            plan,
            pool,
            names,
            file,
            fault,
        })
    }

    fn rows(&mut self, first: u64, results: Results) -> Result<()> {
        let blocks = results.len().div_ceil(TEXT_ROWS);
        let texts: Vec<String> = self.pool.install(|| {
            (0..blocks)
                .into_par_iter()
                .map(|b| {
                    let (from, to) = (b * TEXT_ROWS, ((b + 1) * TEXT_ROWS).min(results.len()));
                    let start = first + from as u64;
                    let batch = self.plan.batch(start, to - from);
                    table::csv_rows(
                        start,
                        &batch,
                        &results.part(from, to),
                        self.names.as_deref(),
                    )
                })
                .collect()
        });
        for text in texts {
            self.file.write_all(text.as_bytes()).map_err(&self.fault)?;
        }
        Ok(())
    }

    fn close(mut self) -> Result<()> {
        let synced = self
            .file
            .flush()
            .and_then(|()| self.file.get_ref().sync_all());
        synced.map_err(&self.fault)
    }
}
