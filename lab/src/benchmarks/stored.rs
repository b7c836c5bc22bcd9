//! Results of other programs, read from reports/speed_accuracy.md.

use std::path::Path;

use super::table::{Line, Report};
use crate::timing::Times;

/// Adds the last results of `gaitcam-lab chart` and lab/peers/speed/run.py.
pub(crate) fn charts(report: &mut Report, reports: &Path) {
    let page = std::fs::read_to_string(reports.join("speed_accuracy.md")).unwrap_or_default();
    let on = page.matches("The default lies on the front.").count();
    let off = page
        .matches("The default does not lie on the front")
        .count();
    report.0.push(Line {
        area: "evidence",
        what: "charts whose default lies on the Pareto front (last `gaitcam-lab chart`)",
        limit: format!("{} of {}", on + off, on + off),
        measured: format!("{on} of {}", on + off),
        fastest: String::new(),
        met: off == 0 && on > 0,
        met_once: false,
    });
    let peers = page.split("\n## Peers\n").nth(1).unwrap_or_default();
    for line in peers.lines().filter(|l| l.starts_with("| ")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        against(report, &cells);
        process(report, &cells);
    }
}

/// Adds a row of the table of peers: the time of the kernel for the same input, and the time for a user.
fn against(report: &mut Report, cells: &[&str]) {
    let (kernel, more) = match cells.get(2) {
        Some(peer) if peer.starts_with("cvxpy") => (
            "cvxpy's time over the kernel's, jerk limit on 32 given spans",
            "cvxpy's time over that of the public call: cam, checks and proof included",
        ),
        Some(peer) if peer.starts_with("scipy") => (
            "scipy's time over the kernel's, least squares on 32 given spans",
            "scipy's time over that of the public call: spans sought, cam, checks and proof included",
        ),
        Some(peer) if peer.starts_with("DAQP 0") => (
            "DAQP's time over the kernel's, acceleration and jerk at 95 %, matrices at hand (DAQP: 224 rows of two sides)",
            "DAQP's time over the kernel's with its matrices assembled from the force",
        ),
        Some(peer) if peer.starts_with("mechanism") => (
            "time of `mechanism` over the kernel's, double-dwell roller cam of 3600 points",
            "",
        ),
        _ => return,
    };
    let number = |k: usize| cells.get(k).and_then(|c| c.parse::<f64>().ok());
    if let (Some(ratio), Some(limit)) = (number(7), number(10)) {
        report.at_least("peers", kernel, limit, ratio);
    }
    if let Some(ratio) = number(9) {
        report.stated("peers", more, format!("{ratio:.1}"));
    }
}

/// Adds a row of the table of whole processes.
fn process(report: &mut Report, cells: &[&str]) {
    let (what, limit) = match cells.get(1) {
        Some(&"gaitcam synth, all files") => ("whole process, all files", 0.030),
        Some(&"gaitcam synth --no-png") => ("whole process, --no-png", 0.015),
        Some(&"gaitcam synth --json, no files") => ("whole process, --json without files", 0.004),
        _ => return,
    };
    let time = cells.get(2).and_then(|c| c.strip_suffix(" ms"));
    if let Some(milliseconds) = time.and_then(|t| t.parse::<f64>().ok()) {
        let found = Times::known(1e-3 * milliseconds);
        report.time("main job", what, limit, found);
    }
}
