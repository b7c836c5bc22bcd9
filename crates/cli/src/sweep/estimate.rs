//! `gaitcam sweep --estimate`: estimates the time of a sweep from the times of some of its rows.

use std::time::Instant;

use serde_json::json;

use super::{SweepArgs, arguments, work};
use crate::console::exit_code::{BUILT, INTERRUPTED};
use crate::console::progress::duration;
use crate::console::terminal::{print, print_json};
use crate::console::words;
use gaitcam::error::Result;

/// Number of equidistant positions in the sweep at which rows are computed.
const PLACES: u64 = 10;
/// Initial number of rows at each position.
const ROWS: u64 = 10;
/// Minimum duration of the measurement, s. If it is shorter, the measurement is repeated with more rows.
const LEAST_S: f64 = 0.25;
/// Factor by which the number of rows increases when the measurement is repeated.
const GROWTH: u64 = 4;

/// Computes some rows on one thread and prints the rate and the estimated time of the sweep. No file is written.
pub fn run(args: &SweepArgs) -> Result<u8> {
    let (sweep, _) = arguments::sweep(args)?;
    let rows = sweep.rows()?;
    let halts = || args.time.of_row();
    let runner = sweep.runner(&halts, None)?;
    let stop = work::stop_on_ctrl_c();
    let stopped = || stop.load(std::sync::atomic::Ordering::Relaxed);
    let mut each = ROWS;
    let (computed, seconds) = loop {
        let begun = Instant::now();
        let mut computed = 0;
        for (first, end) in places(rows, each) {
            computed += runner.run(first..end, 1, &stopped).len() as u64;
        }
        if stopped() {
            return Ok(INTERRUPTED);
        }
        let seconds = begun.elapsed().as_secs_f64();
        if seconds > LEAST_S || computed == rows {
            break (computed, seconds);
        }
        each *= GROWTH;
    };
    let (rate, threads) = (computed as f64 / seconds.max(1e-9), work::jobs(args.jobs));
    let core_s = rows as f64 / rate;
    let all_s = core_s / threads as f64;
    if args.json {
        print_json(
            &json!({"rows": rows, "computed": computed, "rows_per_core_s": rate, "jobs": threads,
            "estimate_s": all_s, "core_hours": core_s / 3600.0}),
        );
        return Ok(BUILT);
    }
    let estimate = json!({"rows": rows.to_string(), "computed": computed.to_string(), "rate": words::number(rate),
        "threads": threads, "time": duration(all_s), "core": words::number(core_s / 3600.0)});
    print(&words::fill("sweep-estimate", &estimate));
    Ok(BUILT)
}

/// Ranges (first row, end) of `each` consecutive rows that begin at equidistant rows. If the ranges would overlap, the result is one range
/// with all rows.
fn places(rows: u64, each: u64) -> Vec<(u64, u64)> {
    if rows <= PLACES * each {
        return vec![(0, rows)];
    }
    let step = (rows - each) / (PLACES - 1);
    (0..PLACES).map(|k| (k * step, k * step + each)).collect()
}

#[cfg(test)]
mod tests {
    use super::places;

    #[test]
    fn the_places_are_apart_and_reach_from_the_first_row_to_the_last() {
        for (rows, each) in [(101, 10), (1000, 10), (1003, 40), (1_000_000_000, 160)] {
            let places = places(rows, each);
            assert_eq!((places.len(), places[0].0), (10, 0));
            assert!(
                places.windows(2).all(|pair| pair[0].1 <= pair[1].0),
                "{rows}"
            );
            let end = places[9].1;
            assert!(end <= rows && rows - end < 10, "{rows}: {end}");
        }
        assert_eq!(places(100, 10), [(0, 100)]);
    }
}
