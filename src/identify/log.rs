//! A log of a running machine: force, and recorded angle, speed and torque.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use crate::error::{Error, Fault, LogError, Placed, Result};
use crate::force::NumberTable;

/// Columns of a log, in the order of [`Log::columns`].
const NAMES: [&str; 5] = [
    "time_s",
    "theta_rad",
    "force_n",
    "speed_rad_per_s",
    "torque_n_m",
];
/// Minimum number of rows of a log.
const LEAST_ROWS: usize = 32;
/// Maximum magnitude of a number of a log, SI: 30 years, 1 GN.
const LARGEST: f64 = 1e9;
/// Fraction of the samples at exactly the largest or smallest force above which the force is clipped.
const CLIPPED: f64 = 0.02;

/// A log of a running machine.
///
/// ```
/// use gaitcam::identify::Log;
///
/// let rows: String = (0..99).map(|i| format!("{},{}\n", 0.01 * f64::from(i), (0.3 * f64::from(i)).sin())).collect();
/// let log = Log::read("log.csv".as_ref(), format!("time_s,force_n\n{rows}").as_bytes())?;
/// assert_eq!(log.force.len(), 99);
/// // A number that is missing is refused with its line.
/// let error = Log::read("log.csv".as_ref(), b"time_s,force_n\n0,1\n0.1,nan\n").unwrap_err();
/// assert!(error.to_string().contains("line 3"));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Time of the samples, s; increasing.
    pub time: Option<Vec<f64>>,
    /// Cam angle, rad; not wrapped, not decreasing.
    pub theta: Option<Vec<f64>>,
    /// Force of the load cell, N.
    pub force: Vec<f64>,
    /// Speed of the cam, rad/s.
    pub speed: Option<Vec<f64>>,
    /// Torque at the camshaft, N·m.
    pub torque: Option<Vec<f64>>,
    path: PathBuf,
}

impl Log {
    /// Reads a delimited text with the columns `time_s` or `theta_rad` (or both), `force_n`, and optionally `speed_rad_per_s` and `torque_n_m`;
    /// others are ignored. `path` is used in messages.
    ///
    /// # Errors
    /// A missing column; a cell that is not a number; times or angles that do not increase; too few rows; a force that is clipped.
    pub fn read(path: &Path, bytes: &[u8]) -> Result<Log> {
        let table = NumberTable::find(path, bytes)?;
        let places = NAMES.map(|name| {
            let is = |n: &String| n.trim().eq_ignore_ascii_case(name);
            table.names().iter().position(is)
        });
        if places[2].is_none() || (places[0].is_none() && places[1].is_none()) {
            let columns = table.names().join(", ");
            return Err(LogError::NoColumn { columns }.at_line(path, table.header_line()));
        }
        let mut columns: [Vec<f64>; 5] = Default::default();
        let mut turns = 0.0;
        for (line, row) in table.rows() {
            for (which, place) in places.iter().enumerate() {
                let Some(place) = place else { continue };
                let cell = row.get(*place);
                let number = cell.and_then(|c| c.number);
                let Some(mut x) = number.filter(|x| x.abs() <= LARGEST) else {
                    let typed = cell.map_or(String::new(), |c| c.text.clone());
                    let column = NAMES[which].to_string();
                    return Err(LogError::Value { column, typed }.at_line(path, line));
                };
                let before = columns[which].last().copied();
                if let Some(before) = before.filter(|_| which < 2) {
                    if which == 1 {
                        // An encoder may begin anew after each turn.
                        turns += if x + turns < before - PI { TAU } else { 0.0 };
                        x += turns;
                    }
                    if x < before || (x == before && (which == 0 || places[0].is_none())) {
                        let (column, value) = (NAMES[which].to_string(), x);
                        let fault = LogError::Order {
                            column,
                            value,
                            before,
                        };
                        return Err(fault.at_line(path, line));
                    }
                }
                columns[which].push(x);
            }
        }
        let [time, theta, force, speed, torque] = columns;
        let known = |column: Vec<f64>| (!column.is_empty()).then_some(column);
        let log = Log {
            time: known(time),
            theta: known(theta),
            force,
            speed: known(speed),
            torque: known(torque),
            path: path.to_path_buf(),
        };
        let rows = log.force.len();
        if rows < LEAST_ROWS {
            let least = LEAST_ROWS;
            return Err(log.refused(LogError::FewRows { rows, least }));
        }
        log.check_clipping()?;
        Ok(log)
    }

    /// A fault of the log as a whole.
    pub(super) fn refused(&self, fault: impl Fault) -> Error {
        fault.in_file(&self.path)
    }

    /// Rejects a force that stays at its largest or smallest value.
    fn check_clipping(&self) -> Result<()> {
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        let range = (self.force.iter()).fold(ends, |[l, h], f| [l.min(*f), h.max(*f)]);
        if range[0] == range[1] {
            return Err(self.refused(LogError::NoForce { force: range[0] }));
        }
        for end in range {
            let at = self.force.iter().filter(|f| **f == end).count();
            let share = at as f64 / self.force.len() as f64;
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
