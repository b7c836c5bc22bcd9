//! Duration of searches: progress line and time limit.

use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use clap::Args;
use cpu_time::{ProcessTime, ThreadTime};
use gaitcam::error::{Placed, Result};
use gaitcam::halt::Halt;
use gaitcam::synth::{self, Outcome, Search};
use gaitcam_app::{Input, PATIENCE};
use serde_json::json;

use crate::console::error::CliError;
use crate::console::progress::{self, Watch};
use crate::console::words;
use crate::refused;

/// Default limits of processor time, s: `DESIGN_S` for one design, `ROW_S` for one row of a sweep.
const DESIGN_S: f64 = 60.0;
const ROW_S: f64 = 5.0;
/// Time between the time limit and the forced end of a program that still waits for an input. During this time, an error about a folder
/// locked by another process can be reported first.
const GRACE: Duration = Duration::from_millis(300);
/// Maximum time limit, s. A longer limit is reduced to this value.
const LONGEST_S: f64 = 1e9;

/// Arguments that limit the duration of searches.
#[derive(Args, Debug, Default, Clone, Copy)]
pub struct TimeLimit {
    /// End the search after this processor time and keep the best result (default 60 s, in sweeps 5 s per design)
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub time_limit: Option<f64>,
}

fn seconds(typed: &str) -> std::result::Result<f64, String> {
    let number = typed.strip_suffix('s').unwrap_or(typed).trim();
    match number.parse::<f64>() {
        Ok(limit) if limit > 0.0 => Ok(limit),
        _ => Err(words::text("time-limit-seconds")),
    }
}

impl TimeLimit {
    /// Stop condition of one design. Its time limit begins now.
    pub fn of_design(self) -> Halt {
        after(self.time_limit.unwrap_or(DESIGN_S))
    }

    /// Stop condition of one row of a sweep. It counts the processor time of the thread that calls this function.
    pub fn of_row(self) -> Halt {
        let limit = duration(self.time_limit.unwrap_or(ROW_S));
        let begun = ThreadTime::now().as_duration();
        Halt::when(move || ThreadTime::now().as_duration() - begun >= limit)
    }

    /// Maximum waiting time while another process writes to the same folder.
    pub fn patience(self) -> Duration {
        self.time_limit.map_or(PATIENCE, duration)
    }

    /// Ends the program if the returned value is not dropped within the time limit plus a short delay. Reading an input, such as a pipe,
    /// may otherwise never end. `None` without a time limit given by the user.
    pub fn of_input(self, json: bool) -> Option<Watch> {
        let limit = self.time_limit?;
        Some(Watch::new(move |waits| {
            let late = duration(limit) + GRACE;
            if waits.recv_timeout(late) == Err(RecvTimeoutError::Timeout) {
                let limit = limit.to_string();
                let error = CliError::InputTime { limit }.at_argument("--time-limit");
                std::process::exit(i32::from(refused(&error, json)));
            }
        }))
    }

    /// Shows a progress line with the elapsed time until the returned value is dropped.
    pub fn shown(self) -> Option<Watch> {
        let limit = self.time_limit.unwrap_or(DESIGN_S);
        let text = words::fill("synth-searching", &json!({"limit": limit}));
        progress::shown(move |elapsed| format!("{text} {elapsed:.0} s"))
    }
}

/// Result of designing a scene within the default time limit.
pub fn answer(input: &Input) -> Result<Outcome> {
    synth::answer(&input.scene, input.target()?.as_ref(), &search())
}

/// Search settings with the default time limit, for a design that is not the main result.
pub fn search() -> Search {
    Search::until(after(DESIGN_S))
}

/// Stop condition that becomes true when the process has used `seconds` of additional processor time. Other programs on the computer do
/// not influence this time.
fn after(seconds: f64) -> Halt {
    let (begun, limit) = (ProcessTime::now(), duration(seconds));
    Halt::when(move || begun.elapsed() >= limit)
}

fn duration(seconds: f64) -> Duration {
    Duration::from_secs_f64(seconds.min(LONGEST_S))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;
    use std::time::Instant;

    #[test]
    fn a_limit_counts_the_time_of_the_processor_and_not_of_the_clock() {
        let limit = TimeLimit {
            time_limit: Some(0.1),
        };
        // Other tests run in the same process at the same time. Only the processor time of the thread is independent of them.
        let row = limit.of_row();
        std::thread::sleep(Duration::from_millis(300));
        assert!(!row.is_asked());
        let (begun, design) = (Instant::now(), limit.of_design());
        let worked = ThreadTime::now();
        while worked.elapsed() < Duration::from_millis(120) {
            black_box((0..1000).fold(0.0, |sum, i| sum + f64::from(i).sqrt()));
        }
        assert!(row.is_asked() && design.is_asked());
        assert!(begun.elapsed() >= Duration::from_millis(100));
    }
}
