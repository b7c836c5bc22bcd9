//! Log of a running machine: recorded force, angle, speed and torque.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use crate::error::{Error, Fault, LogError, Placed, Result};

/// Names of the columns of a log in SI units, in the order of [`LogColumns`].
pub(super) const NAMES: [&str; 5] = [
    "time_s",
    "theta_rad",
    "force_n",
    "speed_rad_per_s",
    "torque_n_m",
];
/// Minimum number of rows of a log.
const LEAST_ROWS: usize = 32;
/// Maximum magnitude of a number in a log, in SI units. Times up to 30 years and forces up to 1 GN are accepted.
pub(super) const LARGEST: f64 = 1e9;
/// The force counts as clipped if more than this fraction of the samples equals the maximum force, or equals the minimum force.
const CLIPPED: f64 = 0.02;

/// Samples of a log in SI units. The log contains time, angle or both. All columns have the same length.
///
/// ```
/// use gaitcam::identify::{Log, LogColumns};
///
/// let time: Vec<f64> = (0..99).map(|i| 0.01 * f64::from(i)).collect();
/// let force = time.iter().map(|t| 700.0 + 100.0 * (11.6 * t).sin()).collect();
/// let columns = LogColumns { time: Some(time), force, ..LogColumns::default() };
/// assert_eq!(Log::new("log 1".as_ref(), columns)?.columns().force.len(), 99);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LogColumns {
    /// Time of the samples, s; increasing.
    pub time: Option<Vec<f64>>,
    /// Cam angle, rad; increasing, or restarting after each turn.
    pub theta: Option<Vec<f64>>,
    /// Force of the load cell, N.
    pub force: Vec<f64>,
    /// Speed of the cam, rad/s.
    pub speed: Option<Vec<f64>>,
    /// Torque at the camshaft, N·m.
    pub torque: Option<Vec<f64>>,
}

impl LogColumns {
    fn all(&self) -> [Option<&Vec<f64>>; 5] {
        let LogColumns {
            time,
            theta,
            force,
            speed,
            torque,
        } = self;
        [
            time.as_ref(),
            theta.as_ref(),
            Some(force),
            speed.as_ref(),
            torque.as_ref(),
        ]
    }
}

/// Adds whole turns to angles that restart after each turn, so that the angles increase.
fn unwrap(theta: &mut [f64]) {
    let mut turns = 0.0;
    for row in 1..theta.len() {
        if theta[row] + turns < theta[row - 1] - PI {
            turns += TAU;
        }
        theta[row] += turns;
    }
}

/// A log of a running machine: finite numbers in columns of equal length, with increasing time and angle.
///
/// ```
/// use gaitcam::identify::{Log, LogOptions};
///
/// let rows: String = (0..99).map(|i| format!("{},{}\n", 0.01 * f64::from(i), (0.3 * f64::from(i)).sin())).collect();
/// let text = format!("time_s,force_n\n{rows}");
/// let log = Log::read("log.csv".as_ref(), text.as_bytes(), &LogOptions::default())?;
/// assert_eq!(log.columns().force.len(), 99);
/// // A number that is missing is refused with its line.
/// let error = Log::read("log.csv".as_ref(), b"time_s,force_n\n0,1\n0.1,nan\n", &LogOptions::default()).unwrap_err();
/// assert!(error.to_string().contains("line 3"));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Columns of the log. The angle does not restart and does not decrease.
    pub(super) columns: LogColumns,
    path: PathBuf,
}

impl Log {
    /// Creates a log from columns in SI units. `path`, the file or any name, is used in messages.
    ///
    /// # Errors
    ///
    /// - Neither time nor angle is given.
    /// - The columns have different lengths, or too few rows.
    /// - A number is not finite, or its magnitude is above 10⁹.
    /// - Times or angles do not increase.
    /// - The force is constant or clipped.
    pub fn new(path: &Path, columns: LogColumns) -> Result<Log> {
        Log::checked(path, columns, &[])
    }

    /// Creates a log from columns of a file. `lines` are the line numbers of the rows, used in messages; empty without a file.
    pub(super) fn checked(path: &Path, mut columns: LogColumns, lines: &[usize]) -> Result<Log> {
        let at = |row: usize, fault: LogError| match lines.get(row) {
            Some(line) => fault.at_line(path, *line),
            None => fault.in_file(path),
        };
        if columns.time.is_none() && columns.theta.is_none() {
            let columns = "force".to_string();
            return Err(LogError::NoColumn { columns }.in_file(path));
        }
        let rows = columns.force.len();
        for (values, name) in columns.all().into_iter().zip(NAMES) {
            let (Some(values), column) = (values, name.to_string()) else {
                continue;
            };
            if values.len() != rows {
                let count = values.len();
                let fault = LogError::Lengths {
                    column,
                    count,
                    rows,
                };
                return Err(fault.in_file(path));
            }
            let is_bad = |x: &f64| !(x.is_finite() && x.abs() <= LARGEST);
            if let Some(row) = values.iter().position(is_bad) {
                let typed = values[row].to_string();
                return Err(at(row, LogError::Value { column, typed }));
            }
        }
        if let Some(theta) = &mut columns.theta {
            unwrap(theta);
        }
        let has_time = columns.time.is_some();
        let in_order = columns.all().into_iter().zip(NAMES).take(2);
        let falls = in_order.filter_map(|(values, name)| {
            let is_time = name == NAMES[0];
            let falls = |w: &[f64]| w[1] < w[0] || (w[1] == w[0] && (is_time || !has_time));
            let row = values?.windows(2).position(falls)? + 1;
            Some((row, name, values?[row], values?[row - 1]))
        });
        if let Some((row, name, value, before)) = falls.min_by_key(|f| f.0) {
            let column = name.to_string();
            let fault = LogError::Order {
                column,
                value,
                before,
            };
            return Err(at(row, fault));
        }
        let path = path.to_path_buf();
        let log = Log { columns, path };
        if rows < LEAST_ROWS {
            let least = LEAST_ROWS;
            return Err(log.refused(LogError::FewRows { rows, least }));
        }
        if let Some([angle, .., last]) = log.columns.theta.as_deref()
            && angle == last
        {
            return Err(log.refused(LogError::NoMotion { angle: *angle }));
        }
        log.check_clipping()?;
        Ok(log)
    }

    /// Name of the log in messages: the file name without folders.
    pub fn name(&self) -> String {
        let name = self.path.file_name().unwrap_or(self.path.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// Samples of the log. The angle increases over all turns.
    pub fn columns(&self) -> &LogColumns {
        &self.columns
    }

    /// Error that refers to the log as a whole.
    pub(super) fn refused(&self, fault: impl Fault) -> Error {
        fault.in_file(&self.path)
    }

    /// Rejects a clipped force, which remains at its maximum or minimum.
    fn check_clipping(&self) -> Result<()> {
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        let range = (self.columns.force.iter()).fold(ends, |[l, h], f| [l.min(*f), h.max(*f)]);
        if range[0] == range[1] {
            return Err(self.refused(LogError::NoForce { force: range[0] }));
        }
        for end in range {
            let at = self.columns.force.iter().filter(|f| **f == end).count();
            let share = at as f64 / self.columns.force.len() as f64;
            if share > CLIPPED {
                let percent = 100.0 * share;
                return Err(self.refused(LogError::Clipped {
                    force: end,
                    percent,
                }));
            }
        }
        Ok(())
    }
}
