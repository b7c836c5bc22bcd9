//! The summary of a design on the console: verdict, reasons, numbers; at most 25 lines.

use gaitcam::cam::{Check, Criterion, Hardness, Measures};
use gaitcam::scene::{ErrorMeasure, Robust};
use gaitcam::synth::{Design, SolverReport, in_units, sentences};
use gaitcam_output::{ActiveLimit, Timing, simulation};
use serde_json::{Value, json};

use crate::console::language;
use crate::console::words::{self, fixed, power};

/// Largest number of lines of one kind; the rest is counted here and listed in summary.json.
const CHECKS: usize = 5;
const FAILED_CHECKS: usize = 4;
/// Harmonics whose load factor is printed.
const LOAD_FACTORS: usize = 4;
const ACTIVE_LIMITS: usize = 3;
const SENSITIVITIES: usize = 2;
const NOTES: usize = 3;

/// The summary for people.
pub fn text(design: &Design, time: Timing) -> String {
    let language = language::current();
    let mut out = vec![
        format!(
            "{}: {}",
            design.problem.name,
            words::name(design.verdict.name())
        ),
        format!("  {}", sentences(&design.reasons, language)),
    ];
    out.extend(failed_checks(design));
    out.extend(force(design));
    out.push(law(design));
    out.push(drive(design));
    out.push(cam(design));
    out.extend(machine(design));
    out.extend(shaft(design));
    out.extend(population(design));
    out.extend(floor(design));
    out.extend(passed_checks(design));
    out.extend(active_limits(design));
    out.extend(sensitivities(design));
    let notes: Vec<String> = (design.notes.iter())
        .map(|n| row("note", &n.sentence(language)))
        .collect();
    out.extend(at_most(NOTES, notes, "more-notes"));
    out.extend(solver(design, time));
    out.join("\n")
}

/// Labels of the rows, without `label-`.
const LABELS: [&str; 16] = [
    "failed", "ok", "force", "law", "drive", "cam", "machine", "shaft", "floor", "walkers",
    "active", "relaxing", "note", "solved", "optimum", "sequence",
];

/// A row under its label; a label that is empty continues the row before.
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

/// A sentence with its arguments in a row.
pub fn filled(label: &str, key: &str, arguments: Value) -> String {
    row(label, &words::fill(key, &arguments))
}

/// The first `most` lines, and how many more there are.
fn at_most(most: usize, mut lines: Vec<String>, what: &str) -> Vec<String> {
    if lines.len() > most {
        let left = lines.len() - (most - 1);
        lines.truncate(most - 1);
        lines.push(filled("", what, json!({"count": left})));
    }
    lines
}

fn check_line(mark: &str, check: &Check, measures: Measures) -> String {
    let value = |x: f64| in_units(measures, check.name, x, language::current());
    let message = match check.name {
        // The limit is a rounding tolerance.
        Criterion::Interference | Criterion::SecondInterference if check.pass => "synth-check-none",
        // Of the whole turn, not of a place.
        Criterion::RmsError => "synth-check-overall",
        _ => "synth-check",
    };
    filled(
        mark,
        message,
        json!({"name": words::name(check.name.name()), "value": value(check.worst), "limit": value(check.limit),
                "at": words::decimal(measures.place(check.at, 2))}),
    )
}

fn failed_checks(design: &Design) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let failed = design.checks.iter().filter(|c| !c.pass);
    let lines = failed.map(|c| check_line("failed", c, measures)).collect();
    at_most(FAILED_CHECKS, lines, "more-failed")
}

fn passed_checks(design: &Design) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let passed = design.checks.iter().filter(|c| c.pass);
    let lines: Vec<String> = passed.map(|c| check_line("ok", c, measures)).collect();
    let failed = (design.checks.len() - lines.len()).min(FAILED_CHECKS);
    at_most(CHECKS - failed, lines, "more-passed")
}

fn force(design: &Design) -> Vec<String> {
    if design.target().is_none() {
        return Vec::new();
    }
    let f = design.force.newtons(&design.problem.drive);
    let factors = load_factors(design);
    let mut rows = vec![
        filled(
            "force",
            "synth-force-error",
            json!({"rms": fixed(f.rms_error_n, 2), "percent": fixed(f.rms_error_percent_of_mean, 3),
                    "most": fixed(f.max_error_n, 2)}),
        ),
        filled(
            "",
            "synth-force-range",
            json!({"low": fixed(f.min_n, 2), "high": fixed(f.max_n, 2),
                    "mean": fixed(f.mean_n, 2)}),
        ),
    ];
    rows.extend(factors);
    rows
}

/// Dynamic load factors of the first harmonics of the step frequency; summary.json has all six.
fn load_factors(design: &Design) -> Option<String> {
    let all: Vec<String> = (design.load_factors().iter())
        .filter(|f| f.of_step.fract() == 0.0)
        .take(LOAD_FACTORS)
        .map(|f| fixed(f.achieved, 3))
        .collect();
    let list = all.join("  ");
    (!all.is_empty()).then(|| filled("", "synth-load-factors", json!({"list": list})))
}

fn law(design: &Design) -> String {
    let lift = design.cam.follower.measures().lift(0);
    let decimals = if lift.name == "°" { 4 } else { 3 };
    let stroke = fixed(lift.factor * design.cam.law.stroke(), decimals);
    let pieces = design.cam.law.poly().pieces();
    // One piece, and a law without a degree, say nothing of pieces.
    let pieces = if design.degree == 0 || pieces == 1 {
        0
    } else {
        pieces
    };
    filled(
        "law",
        "synth-law",
        json!({"family": words::name(design.family.name()), "degree": design.degree, "pieces": pieces,
                "stroke": lift.after(&stroke)}),
    )
}

fn drive(design: &Design) -> String {
    let measures = design.cam.follower.measures();
    let mass = match design.problem.drive.mass {
        0.0 => String::new(),
        mass => format!("{} {}, ", fixed(mass, 4), measures.mass().name),
    };
    let speed = words::decimal(measures.speed_words(design.problem.drive.speed, 4));
    row(
        "drive",
        &format!(
            "{}, {mass}{speed}",
            words::name(design.problem.drive.kind.name())
        ),
    )
}

fn cam(design: &Design) -> String {
    let mm = |x: f64| fixed(1e3 * x, 3);
    let follower = &design.cam.follower;
    let offset = match follower.offset() {
        0.0 => String::new(),
        offset => words::fill("synth-offset", &json!({"offset": mm(offset)})),
    };
    filled(
        "cam",
        "synth-cam",
        json!({"follower": words::name(follower.name()), "base": mm(follower.base_radius()),
                "prime": mm(follower.prime_radius()), "convex": mm(design.cam.curvature().convex.value), "offset": offset}),
    )
}

/// Torque, power, lift-off and pressure, where they are defined.
fn machine(design: &Design) -> Option<String> {
    let m = design.machine();
    let measures = design.cam.follower.measures();
    let torque = m.torque_max_n_m.zip(m.torque_rms_n_m);
    let parts = [
        torque.map(|(most, rms)| {
            words::fill(
                "synth-torque-values",
                &json!({"most": fixed(most, 4), "rms": fixed(rms, 4)}),
            )
        }),
        m.power_max_w
            .map(|most| words::fill("synth-power-value", &json!({"most": fixed(most, 3)}))),
        m.liftoff_speed_rad_per_s.map(|w| {
            words::fill(
                "synth-lift-off",
                &json!({"speed": words::decimal(measures.speed_words(w, 4))}),
            )
        }),
        m.hertz_pressure_max_pa
            .filter(|p| p.is_finite())
            .map(|p| hertz(p, design.problem.cam.making().hardness)),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| row("machine", &parts.join(", ")))
}

/// Speed of the shaft under its motor, the force error over time and what another machine makes of it.
fn shaft(design: &Design) -> Vec<String> {
    let Some(on_shaft) = &design.shaft else {
        return Vec::new();
    };
    let s = &on_shaft.shaft;
    let mut out = vec![filled(
        "shaft",
        "synth-shaft",
        json!({"low": fixed(s.min, 3), "high": fixed(s.max, 3), "ripple": fixed(100.0 * s.ripple, 2),
                "noload": fixed(s.no_load_speed, 4), "rms": fixed(s.motor_torque_rms_n_m, 3),
                "most": fixed(s.motor_torque_max_n_m, 3)}),
    )];
    if let Some((own, before)) = on_shaft.force_time.zip(on_shaft.at_constant_speed) {
        let percent = [own, before].map(|e| fixed(e.rms_error_percent_of_mean, 3));
        let contraction = on_shaft
            .contraction
            .map_or(json!(0), |c| json!(fixed(c, 4)));
        out.push(filled(
            "",
            "synth-shaft-error",
            json!({"own": percent[0], "before": percent[1], "rounds": on_shaft.rounds,
                    "contraction": contraction}),
        ));
    }
    let differs = design.sensitivity().into_iter().map(|s| {
        let percent = s
            .percent
            .map(|p| p.map_or("—".to_string(), |p| fixed(p, 2)));
        let [less, more] = percent;
        words::fill(
            "synth-shaft-differs",
            &json!({"key": s.key, "less": less, "more": more}),
        )
    });
    let differs: Vec<String> = differs.collect();
    if on_shaft.force_time.is_some() {
        out.push(filled(
            "",
            "synth-shaft-sensitivity",
            json!({"list": differs.join(", ")}),
        ));
    }
    out
}

/// Force errors of several walkers.
fn population(design: &Design) -> Option<String> {
    let p = design.population.as_ref()?;
    let (id, [mean, worst, cvar]) = match design.problem.law.error {
        ErrorMeasure::Relative => (
            "synth-walkers",
            [p.mean_percent, p.worst_percent, p.cvar_percent],
        ),
        ErrorMeasure::Absolute => ("synth-walkers-n", [p.mean_n, p.worst_n, p.cvar_n]),
    };
    let tail = match design.problem.law.robust {
        Robust::Tail(part) if part != 0.9 => fixed(100.0 * (1.0 - part), 0),
        Robust::Tail(_) | Robust::Mean | Robust::Worst => "tenth".to_string(),
    };
    Some(filled(
        "walkers",
        id,
        json!({"count": p.walkers, "mean": fixed(mean, 3), "worst": fixed(worst, 3), "who": p.worst_walker,
            "cvar": fixed(cvar, 3), "tail": tail}),
    ))
}

/// Acceleration of the floor under shaker and walkers, and its comfort.
fn floor(design: &Design) -> Option<String> {
    let motion = design.floor.as_ref()?;
    Some(row(
        "floor",
        &simulation::floor(motion, language::current()),
    ))
}

/// The Hertz pressure, and the permissible one where the hardness of the surface is given.
fn hertz(pressure: f64, hardness: Option<Hardness>) -> String {
    let mega = |p: f64| fixed(1e-6 * p, 1);
    match hardness {
        None => words::fill("synth-hertz", &json!({"pressure": mega(pressure)})),
        Some(hardness) => words::fill(
            "synth-hertz-of",
            &json!({
                "pressure": mega(pressure),
                "borne": mega(hardness.allowable_pressure()),
                "hardness": hardness.to_string(),
            }),
        ),
    }
}

/// One line per active limit, the largest multiplier first.
fn active_limits(design: &Design) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let mut limits = ActiveLimit::all(design);
    limits.sort_by(|a, b| b.multiplier.abs().total_cmp(&a.multiplier.abs()));
    let lines = limits.iter().map(|a| {
        let at = words::decimal(measures.place(a.at, 2));
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
                    "name": name, "unit": unit, "after": fixed(factor * easing.after, 5),
                    "before": fixed(factor * easing.before, 5)}))
    });
    at_most(SENSITIVITIES, lines.collect(), "more-relaxing")
}

/// The solver's method, and what the closed form missed.
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
            "optimum",
            "synth-optimum",
            json!({"gap": power(c.relative_gap, 1), "kkt": power(c.stationarity, 1),
                    "violation": power(c.violation, 1)}),
        ));
        if let Some(doubt) = solver.doubt {
            let why = doubt.sentence(language::current());
            out.push(filled("", "synth-uncertified", json!({ "why": why })));
        }
    }
    out
}
