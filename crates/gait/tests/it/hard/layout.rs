//! Texts in the layouts of laboratory programs, with given rate, time column, noise and offsets.

use std::fmt::Write as _;

use super::dice::Dice;

/// Properties of a plate and its recorder that change the channels before they are written.
#[derive(Debug, Clone, Copy)]
pub struct Plate {
    pub rate_hz: f64,
    pub noise_n: f64,
    pub offset_n: f64,
    /// Increase of the unloaded reading over the whole recording, N.
    pub drift_n: f64,
    /// −1 if a load is written as a negative number.
    pub sign: f64,
    /// Level below which the recorder sets readings to zero, N.
    pub cut_n: f64,
}

impl Plate {
    pub fn of(dice: &mut Dice) -> Self {
        Plate {
            rate_hz: dice.of(&[100.0, 120.0, 150.0, 200.0, 240.0, 300.0]),
            noise_n: dice.of(&[0.0, 0.5, 1.0, 2.0]),
            offset_n: dice.of(&[0.0, 0.0, -14.0, 20.0, 60.0, -90.0]),
            drift_n: dice.of(&[0.0, 0.0, 2.0, -4.0]),
            sign: dice.of(&[1.0, 1.0, -1.0]),
            cut_n: 0.0,
        }
    }

    /// A recorder with a threshold: exact zeros below it.
    pub fn thresholded(dice: &mut Dice) -> Self {
        Plate {
            noise_n: 0.0,
            offset_n: 0.0,
            drift_n: 0.0,
            cut_n: dice.of(&[0.0, 10.0]),
            sign: 1.0,
            ..Plate::of(dice)
        }
    }

    /// Samples of a force over `seconds`, as this plate records them.
    pub fn samples(&self, dice: &mut Dice, seconds: f64, force: impl Fn(f64) -> f64) -> Vec<f64> {
        let n = (seconds * self.rate_hz) as usize;
        (0..n)
            .map(|i| {
                let f = force(i as f64 / self.rate_hz);
                let f = if f < self.cut_n { 0.0 } else { f };
                let drift = self.drift_n * i as f64 / n as f64;
                let noise = if self.noise_n > 0.0 {
                    self.noise_n * dice.normal()
                } else {
                    0.0
                };
                self.sign * (f + self.offset_n + drift + noise)
            })
            .collect()
    }
}

/// Named columns with a common sampling rate.
#[derive(Debug, Clone)]
pub struct Table {
    pub rate_hz: f64,
    pub names: Vec<String>,
    pub columns: Vec<Vec<f64>>,
}

/// Content of the time column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clock {
    /// Seconds from some time on, with a number of decimals.
    Seconds { from: f64, decimals: usize },
    /// Milliseconds; `named` states whether the column name contains the unit.
    Milliseconds { named: bool },
    /// Counts 1, 2, 3 … with the name `Time`.
    Counts,
}

impl Table {
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    fn time(&self, i: usize, clock: Clock) -> String {
        let t = i as f64 / self.rate_hz;
        match clock {
            Clock::Seconds { from, decimals } => format!("{:.decimals$}", from + t),
            Clock::Milliseconds { .. } => format!("{:.4}", 1e3 * t),
            Clock::Counts => (i + 1).to_string(),
        }
    }

    fn time_name(clock: Clock) -> &'static str {
        match clock {
            Clock::Seconds { .. } => "Time",
            Clock::Milliseconds { named: true } => "Time [ms]",
            Clock::Milliseconds { named: false } | Clock::Counts => "Time",
        }
    }

    /// Delimited text with one header row. If `comma`, with semicolons and decimal commas.
    pub fn delimited(&self, clock: Clock, comma: bool) -> String {
        let separator = if comma { ";" } else { "," };
        let mut out = Table::time_name(clock).to_string();
        for name in &self.names {
            let _ = write!(out, "{separator}{name}");
        }
        out.push('\n');
        for i in 0..self.rows() {
            let mut row = self.time(i, clock);
            for c in &self.columns {
                let _ = write!(row, "{separator}{:.3}", c[i]);
            }
            let row = if comma { row.replace('.', ",") } else { row };
            let _ = writeln!(out, "{row}");
        }
        out
    }

    /// OpenSim storage file with the old header (`datacolumns`, `datarows`) or the new one (`nRows`, `nColumns`). Each force has its two other
    /// components and its centre of pressure.
    pub fn open_sim(&self, old: bool) -> String {
        let (rows, columns) = (self.rows(), 1 + 6 * self.names.len());
        let last = rows as f64 / self.rate_hz;
        let mut out = if old {
            format!(
                "name walk.mot\ndatacolumns {columns}\ndatarows {rows}\nrange 0 {last}\nendheader\n\n"
            )
        } else {
            format!("walk\nversion=1\nnRows={rows}\nnColumns={columns}\ninDegrees=no\nendheader\n")
        };
        out.push_str("time");
        for name in &self.names {
            for part in ["vx", "vy", "vz", "px", "py", "pz"] {
                let _ = write!(out, "\t{name}_{part}");
            }
        }
        out.push('\n');
        for i in 0..rows {
            let _ = write!(out, "{:.6}", i as f64 / self.rate_hz);
            for c in &self.columns {
                let f = c[i];
                let _ = write!(
                    out,
                    "\t{:.3}\t{f:.3}\t{:.3}\t0.3\t0\t0.1",
                    0.1 * f,
                    0.05 * f
                );
            }
            out.push('\n');
        }
        out
    }

    /// Force file with key lines: samples without times, three components and a centre of pressure per plate.
    pub fn forces(&self) -> String {
        let mut out = format!(
            "[Force Data]\nNumberOfForcePlates={}\nSampleRate={:.6}\nNumberOfSamples={}\n#Sample",
            self.names.len(),
            self.rate_hz,
            self.rows()
        );
        for k in 1..=self.names.len() {
            let _ = write!(out, "\tFX{k}\tFY{k}\tFZ{k}\tX{k}\tY{k}\tZ{k}\tMZ{k}");
        }
        out.push('\n');
        for i in 0..self.rows() {
            let _ = write!(out, "{}", i + 1);
            for c in &self.columns {
                let f = c[i];
                let _ = write!(
                    out,
                    "\t{:.2}\t{f:.2}\t{:.2}\t100.00\t0.00\t50.00\t-0.00",
                    0.08 * f,
                    0.04 * f
                );
            }
            out.push('\n');
        }
        out
    }

    /// Rows with the time and with three forces and three moments of the first column, without a header.
    pub fn amti(&self) -> String {
        let mut out = String::new();
        for (i, f) in self.columns[0].iter().enumerate() {
            let t = i as f64 / self.rate_hz;
            let _ = writeln!(
                out,
                "{t:.5},{:.3},{:.3},{f:.3},{:.3},{:.3},{:.3}",
                0.05 * f,
                0.1 * f,
                0.02 * f,
                0.03 * f,
                0.001 * f
            );
        }
        out
    }

    /// Converter counts with lines of names, rates and ranges above, and with channels of muscles in addition to the plates.
    pub fn counts(&self) -> String {
        let mut out =
            "File_Type:\tAnalog R/C ASCII\tGeneration#:\t1\nBoard_Type:\tA\tPolarity:\tBipolar\n"
                .to_string();
        let _ = writeln!(
            out,
            "Trial_Name:\twalk\tTrial#:\t1\tDuration(Sec.):\t5\t#Channels:\t{}",
            3 * self.names.len() + 2
        );
        let _ = writeln!(out, "BitDepth:\t16\tPreciseRate:\t{:.6}", self.rate_hz);
        out.push_str("\n\nName");
        for k in 1..=self.names.len() {
            let _ = write!(out, "\tF{k}X\tF{k}Y\tF{k}Z");
        }
        out.push_str("\tL GRF\tR TA\nRate");
        let channels = 3 * self.names.len() + 2;
        for _ in 0..channels {
            let _ = write!(out, "\t{}", self.rate_hz as i64);
        }
        out.push_str("\nRange");
        for _ in 0..channels {
            out.push_str("\t10000");
        }
        out.push('\n');
        for i in 0..self.rows() {
            let _ = write!(out, "{:.6}", i as f64 / self.rate_hz);
            for c in &self.columns {
                let count = |f: f64| (f * 7.3).round() as i64;
                let f = c[i];
                let _ = write!(
                    out,
                    "\t{}\t{}\t{}",
                    count(0.05 * f),
                    count(0.1 * f),
                    count(f)
                );
            }
            let muscle = (1500.0 * (i as f64 * 1.7).sin()) as i64;
            let _ = writeln!(out, "\t{muscle}\t{}", muscle / 3);
        }
        out
    }
}
