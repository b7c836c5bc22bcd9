//! Table with a line for each measurement and its limit, and the page with this table.

use super::tested::TESTED;
use crate::markdown::{duration, table};
use crate::timing::Times;

/// One line of the table.
pub(crate) struct Line {
    pub(crate) area: &'static str,
    pub(crate) what: &'static str,
    /// Limit of the measured value; empty without a limit.
    pub(crate) limit: String,
    /// Median of the runs.
    pub(crate) measured: String,
    /// Fastest run, which other processes disturbed least; empty for ratios.
    pub(crate) fastest: String,
    /// Whether the median or ratio is within the limit.
    pub(crate) met: bool,
    /// Whether the fastest run is within the limit.
    pub(crate) met_once: bool,
}

/// Table of the measurements.
#[derive(Default)]
pub(crate) struct Report(pub(crate) Vec<Line>);

impl Report {
    /// Adds a time of at most `limit` seconds.
    pub(crate) fn time(
        &mut self,
        area: &'static str,
        what: &'static str,
        limit: f64,
        found: Times,
    ) {
        self.0.push(Line {
            area,
            what,
            limit: format!("≤ {}", duration(limit)),
            measured: duration(found.median),
            fastest: duration(found.fastest),
            met: found.median <= limit,
            met_once: found.fastest <= limit,
        });
    }

    /// Adds a rate of at least `limit` per second.
    pub(crate) fn rate(
        &mut self,
        area: &'static str,
        what: &'static str,
        limit: f64,
        things: u64,
        found: Times,
    ) {
        let [median, fastest] = [found.median, found.fastest].map(|s| things as f64 / s);
        self.0.push(Line {
            area,
            what,
            limit: format!("≥ {limit:.0}/s"),
            measured: format!("{median:.0}/s"),
            fastest: format!("{fastest:.0}/s"),
            met: median >= limit,
            met_once: fastest >= limit,
        });
    }

    /// Adds a ratio of at least `limit`.
    pub(crate) fn at_least(
        &mut self,
        area: &'static str,
        what: &'static str,
        limit: f64,
        found: f64,
    ) {
        self.ratio(area, what, format!("≥ {limit}"), found, found >= limit);
    }

    /// Adds a ratio of at most `limit`.
    pub(crate) fn at_most(
        &mut self,
        area: &'static str,
        what: &'static str,
        limit: f64,
        found: f64,
    ) {
        self.ratio(area, what, format!("≤ {limit}"), found, found <= limit);
    }

    /// Adds a result without a limit.
    pub(crate) fn stated(&mut self, area: &'static str, what: &'static str, found: String) {
        self.0.push(Line {
            area,
            what,
            limit: String::new(),
            measured: found,
            fastest: String::new(),
            met: true,
            met_once: true,
        });
    }

    fn ratio(
        &mut self,
        area: &'static str,
        what: &'static str,
        limit: String,
        found: f64,
        met: bool,
    ) {
        self.0.push(Line {
            area,
            what,
            limit,
            measured: format!("{found:.2}"),
            fastest: String::new(),
            met,
            met_once: false,
        });
    }
}

/// Reasons for results outside their limits: start of the line, and the reason.
const REASONS: &[(&str, &str)] = &[
    (
        "DAQP's time over the kernel's",
        "DAQP is a dual active set too: with the matrices at hand both do the same steps",
    ),
    (
        "charts whose default lies on",
        "from force to law: a given number of harmonics is faster than the choice of this number (a1), \
         and given spans are faster than the search for spans (a2)",
    ),
];

fn reason(what: &str) -> Option<&'static str> {
    let row = REASONS.iter().find(|(begins, _)| what.starts_with(begins));
    row.map(|(_, reason)| *reason)
}

/// Lines outside their limits without a reason.
pub(crate) fn unexplained(lines: &[Line]) -> Vec<&'static str> {
    let outside = lines.iter().filter(|l| !l.met && !l.met_once);
    let what = outside.map(|l| l.what);
    what.filter(|what| reason(what).is_none()).collect()
}

/// Page with the table and the tested accuracies.
pub(crate) fn markdown(lines: &[Line]) -> String {
    let mut out = String::from(
        "# Benchmarks\n\nWritten by `cargo run --release -p gaitcam-lab -- benchmarks`: wall-clock medians after a warm-up, and the fastest run, because other programs also ran on the machine (release build). Times of peers and whole processes are processor times of the last run of lab/peers/speed/run.py.\n\n",
    );
    let row = |l: &Line| {
        let mark = match (l.met, l.met_once) {
            _ if l.limit.is_empty() => String::new(),
            (true, _) => "yes".to_string(),
            (false, true) => "yes, if undisturbed".to_string(),
            (false, false) => format!("**no**: {}", reason(l.what).unwrap_or("not explained")),
        };
        let [area, what] = [l.area, l.what].map(String::from);
        let [limit, measured, fastest] = [&l.limit, &l.measured, &l.fastest].map(Clone::clone);
        vec![area, what, limit, measured, fastest, mark]
    };
    let head = ["area", "what", "limit", "median", "fastest", "within limit"];
    out.push_str(&table(&head, lines.iter().map(row)));
    out.push_str("\nA test checks each of these accuracies:\n\n");
    let tested = TESTED.map(|(area, number, by)| [area, number, by].map(String::from).to_vec());
    out + &table(&["area", "number", "held by"], tested)
}
