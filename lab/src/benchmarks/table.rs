//! Table with a line for each requirement, and the page with this table.

use super::tested::TESTED;
use crate::markdown::{duration, table};
use crate::timing::Times;

/// One line of the table.
pub(crate) struct Line {
    pub(crate) area: &'static str,
    pub(crate) what: &'static str,
    pub(crate) asked: String,
    /// Median of the runs.
    pub(crate) measured: String,
    /// Fastest run, which other processes disturbed least; empty for ratios.
    pub(crate) fastest: String,
    pub(crate) met: bool,
    /// Whether the fastest run meets the requirement.
    pub(crate) met_once: bool,
}

/// Table of the requirements.
#[derive(Default)]
pub(crate) struct Report(pub(crate) Vec<Line>);

impl Report {
    /// Adds a time of at most `asked` seconds.
    pub(crate) fn time(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: f64,
        found: Times,
    ) {
        self.0.push(Line {
            area,
            what,
            asked: format!("≤ {}", duration(asked)),
            measured: duration(found.median),
            fastest: duration(found.fastest),
            met: found.median <= asked,
            met_once: found.fastest <= asked,
        });
    }

    /// Adds a rate of at least `asked` per second.
    pub(crate) fn rate(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: f64,
        things: u64,
        found: Times,
    ) {
        let [median, fastest] = [found.median, found.fastest].map(|s| things as f64 / s);
        self.0.push(Line {
            area,
            what,
            asked: format!("≥ {asked:.0}/s"),
            measured: format!("{median:.0}/s"),
            fastest: format!("{fastest:.0}/s"),
            met: median >= asked,
            met_once: fastest >= asked,
        });
    }

    /// Adds a ratio of at least `asked`.
    pub(crate) fn at_least(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: f64,
        found: f64,
    ) {
        self.ratio(area, what, format!("≥ {asked}"), found, found >= asked);
    }

    /// Adds a ratio of at most `asked`.
    pub(crate) fn at_most(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: f64,
        found: f64,
    ) {
        self.ratio(area, what, format!("≤ {asked}"), found, found <= asked);
    }

    /// Adds a result without a requirement.
    pub(crate) fn stated(&mut self, area: &'static str, what: &'static str, found: String) {
        self.0.push(Line {
            area,
            what,
            asked: String::new(),
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
        asked: String,
        found: f64,
        met: bool,
    ) {
        self.0.push(Line {
            area,
            what,
            asked,
            measured: format!("{found:.2}"),
            fastest: String::new(),
            met,
            met_once: false,
        });
    }
}

/// Reasons for missed requirements: start of the line, and the reason.
const REASONS: &[(&str, &str)] = &[
    (
        "DAQP's time over the kernel's",
        "DAQP is a dual active set too: with the matrices at hand both do the same steps",
    ),
    (
        "charts whose default lies on",
        "of force to law: choosing the number of harmonics costs more than being told it (a1), \
         and a spline is quicker to those who know its spans (a2)",
    ),
];

fn reason(what: &str) -> Option<&'static str> {
    let row = REASONS.iter().find(|(begins, _)| what.starts_with(begins));
    row.map(|(_, reason)| *reason)
}

/// Lines of missed requirements without a reason.
pub(crate) fn unexplained(lines: &[Line]) -> Vec<&'static str> {
    let missed = lines.iter().filter(|l| !l.met && !l.met_once);
    let what = missed.map(|l| l.what);
    what.filter(|what| reason(what).is_none()).collect()
}

/// Page with the table and the requirements of accuracy.
pub(crate) fn markdown(lines: &[Line]) -> String {
    let mut out = String::from(
        "# Benchmarks\n\nWritten by `cargo run --release -p gaitcam-lab -- benchmarks`: wall-clock medians after a warm-up, and the fastest run, because other programs also ran on the machine (release build). Times of peers and whole processes are processor times of the last run of lab/peers/speed/run.py.\n\n",
    );
    let row = |l: &Line| {
        let mark = match (l.met, l.met_once) {
            _ if l.asked.is_empty() => String::new(),
            (true, _) => "met".to_string(),
            (false, true) => "met when undisturbed".to_string(),
            (false, false) => format!("**missed**: {}", reason(l.what).unwrap_or("not explained")),
        };
        let [area, what] = [l.area, l.what].map(String::from);
        let [asked, measured, fastest] = [&l.asked, &l.measured, &l.fastest].map(Clone::clone);
        vec![area, what, asked, measured, fastest, mark]
    };
    let head = ["area", "what", "asked", "median", "fastest", ""];
    out.push_str(&table(&head, lines.iter().map(row)));
    out.push_str("\nA test checks each of these accuracies:\n\n");
    let tested = TESTED.map(|(area, number, by)| [area, number, by].map(String::from).to_vec());
    out + &table(&["area", "number", "held by"], tested)
}
