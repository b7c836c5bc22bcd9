//! Summary of a design for the console: verdict, reasons and main values, at most 25 lines.

use gaitcam::cam::Check;
use gaitcam::criterion::Criterion;
use gaitcam::drive::DriveKind;
use gaitcam::synth::{Design, SolverReport, in_units, sentences};
use gaitcam::wording::range;
use gaitcam_output::facts::{self, Group};
use gaitcam_output::report::parts::shown;
use gaitcam_output::{ActiveLimit, Timing};
use serde_json::{Value, json};

use super::reports::{floor, population, shaft};
use crate::console::language;
use crate::console::words::{self, fixed, number, power};

/// Maximum numbers of console lines for each kind of information. Omitted lines are only counted. The file summary.json contains all data.
const CHECKS: usize = 5;
const FAILED_CHECKS: usize = 4;
/// Number of harmonics for which the load factor is printed.
const LOAD_FACTORS: usize = 4;
const ACTIVE_LIMITS: usize = 3;
const SENSITIVITIES: usize = 2;
const NOTES: usize = 3;

/// Summary as text. If `verbose` is set, it includes the solver and its certificate.
pub fn text(design: &Design, time: Timing, verbose: bool) -> String {
    let language = language::current();
    let headline = match design.out_of_time && design.infeasible.is_none() {
        true => "out-of-time",
        false => design.verdict.name(),
    };
    let mut out = vec![
        format!("{}: {}", design.problem.name, words::name(headline)),
        format!("  {}", sentences(&design.reasons, language)),
    ];
    out.extend(failed_checks(design));
    out.extend(force(design));
    let line = |group: Group| Some(row(group.name(), &facts::line(design, group, language)?));
    out.extend(Group::ALL.into_iter().filter_map(line));
    out.extend(shaft(design));
    out.extend(population(design));
    out.extend(floor(design));
    let resonance = facts::resonance(design, language);
    out.extend(resonance.map(|text| row("resonance", &text)));
    out.extend(passed_checks(design));
    out.extend(active_limits(design));
    out.extend(sensitivities(design));
    let notes: Vec<String> = (design.notes.iter())
        .map(|n| row("note", &n.sentence(language)))
        .collect();
    out.extend(at_most(NOTES, notes, "more-notes"));
    if verbose {
        out.extend(solver(design, time));
    }
    out.extend(proof(design));
    out.join("\n")
}

/// Message keys of the row labels, without the prefix `label-`.
const LABELS: [&str; 17] = [
    "failed",
    "ok",
    "force",
    "law",
    "drive",
    "cam",
    "machine",
    "shaft",
    "floor",
    "walkers",
    "resonance",
    "active",
    "relaxing",
    "note",
    "solved",
    "optimum",
    "sequence",
];

/// Row of the summary: a label and a text. A row with an empty label continues the previous row.
pub fn row(label: &str, text: &str) -> String {
    let shown = |name: &str| words::text(&format!("label-{name}"));
    let longest = LABELS.iter().map(|l| shown(l).chars().count()).max();
    let width = longest.unwrap_or(0) + 1;
    let label = if label.is_empty() {
        String::new()
    } else {
        shown(label)
    };
    format!("  {label:<width$} {text}")
}

/// Row of the summary: a label and the message `key`, in which `arguments` replace the placeholders.
pub fn filled(label: &str, key: &str, arguments: Value) -> String {
    row(label, &words::fill(key, &arguments))
}

/// Shortens a list of lines to at most `most` lines. If lines are omitted, the last line states their number with the message `what`.
fn at_most(most: usize, mut lines: Vec<String>, what: &str) -> Vec<String> {
    if lines.len() > most {
        let left = lines.len() - (most - 1);
        lines.truncate(most - 1);
        lines.push(filled("", what, json!({"count": left})));
    }
    lines
}

fn check_line(mark: &str, check: &Check, design: &Design) -> String {
    let value = |x: f64| shown(design, check.name, x, language::current());
    let measures = design.cam.follower.measures();
    let message = match check.name {
        // The limit of an interference check is only a rounding tolerance and is not printed.
        Criterion::Interference | Criterion::SecondInterference if check.pass => "synth-check-none",
        // The RMS force error applies to the whole turn and has no position.
        Criterion::RmsError => "synth-check-overall",
        _ => "synth-check",
    };
    filled(
        mark,
        message,
        json!({"name": words::name(check.name.name()), "value": value(check.worst), "limit": value(check.limit),
                "at": measures.place(check.at, language::current())}),
    )
}

fn failed_checks(design: &Design) -> Vec<String> {
    let failed = design.checks.iter().filter(|c| !c.pass);
    let lines = failed.map(|c| check_line("failed", c, design)).collect();
    at_most(FAILED_CHECKS, lines, "more-failed")
}

fn passed_checks(design: &Design) -> Vec<String> {
    let passed = design.checks.iter().filter(|c| c.pass);
    let lines: Vec<String> = passed.map(|c| check_line("ok", c, design)).collect();
    let failed = (design.checks.len() - lines.len()).min(FAILED_CHECKS);
    at_most(CHECKS - failed, lines, "more-passed")
}

fn force(design: &Design) -> Vec<String> {
    if design.target().is_none() {
        return Vec::new();
    }
    let f = &design.force;
    let text = |column: &str, value: f64| facts::force(design, column, value, language::current());
    let unit = design.cam.follower.measures().force();
    let range = range(language::current(), f.min_n, f.max_n);
    let mut rows = vec![
        filled(
            "force",
            "synth-force-error",
            json!({"rms": text("force_rms_error_n", f.rms_error_n),
                    "percent": facts::error_percent(design, language::current()),
                    "most": text("force_max_error_n", f.max_error_n)}),
        ),
        filled(
            "",
            "synth-force-range",
            json!({"range": unit.after(&range), "mean": text("force_mean_n", f.mean_n)}),
        ),
    ];
    if design.problem.drive.kind == DriveKind::MovingAxis {
        rows.extend(load_factors(design));
    }
    rows
}

/// Line with the dynamic load factors at the first four harmonics of the step frequency; `None` without load factors. summary.json
/// contains six harmonics.
fn load_factors(design: &Design) -> Option<String> {
    let all: Vec<String> = (design.load_factors().iter())
        .filter(|f| f.of_step.fract() == 0.0)
        .take(LOAD_FACTORS)
        .map(|f| fixed(f.achieved, 3))
        .collect();
    let list = all.join("  ");
    (!all.is_empty()).then(|| filled("", "synth-load-factors", json!({"list": list})))
}

/// Lines for the active limits, sorted by the absolute value of the multiplier in descending order.
fn active_limits(design: &Design) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let mut limits = ActiveLimit::all(design);
    limits.sort_by(|a, b| b.multiplier.abs().total_cmp(&a.multiplier.abs()));
    let lines = limits.iter().map(|a| {
        let at = measures.place(a.at, language::current());
        let limit = words::name(a.limit.name());
        filled(
            "active",
            "synth-active",
            json!({"limit": limit, "points": a.points, "at": at}),
        )
    });
    at_most(ACTIVE_LIMITS, lines.collect(), "more-active")
}

fn sensitivities(design: &Design) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let lines = design.easing.iter().map(|easing| {
        let (name, unit, factor) = easing.in_words(measures, language::current());
        filled("relaxing", "synth-relaxing", json!({"limit": words::name(easing.limit.name()), "to": in_units(measures, easing.limit, easing.to, language::current()),
                    "name": name, "unit": unit, "after": number(factor * easing.after),
                    "before": number(factor * easing.before)}))
    });
    at_most(SENSITIVITIES, lines.collect(), "more-relaxing")
}

/// Method of the solver. If a simpler law family was rejected, the text also states the reason.
fn status(solver: &SolverReport) -> String {
    let language = language::current();
    let missed = solver.passed_over.iter().map(|p| p.sentence(language));
    let all = std::iter::once(solver.method.sentence(language)).chain(missed);
    all.collect::<Vec<_>>().join("; ")
}

fn solver(design: &Design, time: Timing) -> Vec<String> {
    let solver = &design.solver;
    let mut out = vec![filled(
        "solved",
        "synth-solved",
        json!({"tier": words::name(solver.tier.name()), "solve": fixed(1e3 * time.solve_s, 3),
                "total": fixed(1e3 * time.total_s, 0), "status": status(solver)}),
    )];
    if let Some(c) = &solver.certificate {
        out.push(filled(
            "",
            "synth-optimum",
            json!({"gap": power(c.relative_gap, 1), "kkt": power(c.stationarity, 1),
                    "violation": power(c.violation, 1)}),
        ));
    }
    out
}

/// Sentence on whether the law is proved to be optimal; `None` if no law is optimised.
fn proof(design: &Design) -> Option<String> {
    let solver = &design.solver;
    solver.certificate.as_ref()?;
    if solver.certified {
        return Some(filled(
            "optimum",
            "synth-certified",
            json!({"family": design.family.name()}),
        ));
    }
    let why = solver.doubt?.sentence(language::current());
    Some(filled(
        "optimum",
        "synth-uncertified",
        json!({ "why": why }),
    ))
}
