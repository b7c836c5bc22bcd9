//! A search that may take long: a progress line after half a second, a time limit.

use std::sync::mpsc::RecvTimeoutError;
use std::time::{Duration, Instant};

use clap::Args;
use gaitcam::error::{Placed, Result};
use gaitcam::halt::Halt;
use gaitcam::synth::{self, Outcome, Search};
use gaitcam_app::{Input, PATIENCE};
use serde_json::json;

use crate::console::error::CliError;
use crate::console::progress::{self, Watch};
use crate::console::words;
use crate::refused;

/// Time limit of one design, and of one row of a sweep, s.
const DESIGN_S: f64 = 60.0;
const ROW_S: f64 = 5.0;
/// What holds up the input has this long to say so itself.
const GRACE: Duration = Duration::from_millis(300);
/// Time limits above this are treated as this, s.
const LONGEST_S: f64 = 1e9;

/// How long searches may take.
#[derive(Args, Debug, Default, Clone, Copy)]
pub struct TimeLimit {
    /// End the search after this time and keep the best result (default 60 s, in sweeps 5 s per design)
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
    /// The end of the searches of one design that begins now.
    pub fn of_design(self) -> Halt {
        after(self.time_limit.unwrap_or(DESIGN_S))
    }

    /// The same for one row of a sweep.
    pub fn of_row(self) -> Halt {
        after(self.time_limit.unwrap_or(ROW_S))
    }

    /// How long to wait for another process that writes into the same folder.
    pub fn patience(self) -> Duration {
        self.time_limit.map_or(PATIENCE, duration)
    }

    /// Ends the program where what is returned is not dropped within a limit that was given: an input may never end.
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

    /// Shows that a design is being searched for, until what is returned is dropped.
    pub fn shown(self) -> Option<Watch> {
        let limit = self.time_limit.unwrap_or(DESIGN_S);
        let text = words::fill("synth-searching", &json!({"limit": limit}));
        progress::shown(move |elapsed| format!("{text} {elapsed:.0} s"))
    }
}

/// The answer to a scene within the usual time.
pub fn answer(input: &Input) -> Result<Outcome> {
    synth::answer(&input.scene, input.target()?.as_ref(), &search())
}

/// The search for a design on the way to another answer.
pub fn search() -> Search {
    Search::until(after(DESIGN_S))
}

fn after(seconds: f64) -> Halt {
    let end = Instant::now() + duration(seconds);
    Halt::when(move || Instant::now() >= end)
}

fn duration(seconds: f64) -> Duration {
    Duration::from_secs_f64(seconds.min(LONGEST_S))
}
