//! Output of a simulation: `simulation.json`, `dynamics.csv` and the table for the console.

use crate::csv::{self, Columns};
use crate::words::{self, Words};
use gaitcam::cam::Measures;
use gaitcam::dynamics::contact::Impact;
use gaitcam::dynamics::{Difference, FloorMotion, Outcome, Pressure, Row, Shaft};
use gaitcam::wording::Language;
use serde_json::{Value, json};
use std::fmt::Write;

/// Names of the columns of `dynamics.csv`, in order.
const COLUMNS: [&str; 12] = [
    "theta_rad",
    "contact_force_n",
    "torque_nm",
    "power_w",
    "lift_m",
    "gap_m",
    "normal_force_n",
    "sliding_m_per_s",
    "entraining_m_per_s",
    "side_thrust_n",
    "time_s",
    "speed_rad_per_s",
];

fn values(outcome: &Outcome, row: &Row) -> [f64; COLUMNS.len()] {
    [
        row.theta,
        row.contact_force / outcome.lever,
        row.torque,
        row.power,
        row.lift,
        row.gap,
        row.normal_force,
        row.sliding,
        row.entraining,
        row.side_thrust,
        row.time,
        row.speed,
    ]
}

/// Content of `simulation.json`, which `gaitcam simulate --json` also prints.
pub fn json(outcome: &Outcome) -> Value {
    let notes = outcome.notes.iter().map(|note| note.sentence(Language::En));
    let notes: Vec<String> = notes.collect();
    let impacts: Vec<Value> = outcome.impacts.iter().map(impact_json).collect();
    let mut out = json!({
        "model": outcome.model.name(),
        "why": outcome.why.sentence(Language::En),
        "contact_lost": outcome.contact_lost,
        "lost_fraction": outcome.lost_fraction,
        "force": {
            "min": outcome.force.min / outcome.lever,
            "max": outcome.force.max / outcome.lever,
            "rms_error_n": outcome.force.rms_error.map(|e| e / outcome.lever),
        },
        "torque": outcome.torque,
        "liftoff_speed_rad_per_s": outcome.liftoff_speed,
        "settle_cycles": outcome.settle_cycles,
        "details": {
            "period_turns": outcome.period_turns,
            "impacts": impacts,
            "hertz": outcome.hertz.map(pressure_json),
            "next": outcome.next.as_ref().map(|d| difference_json(d, outcome.lever)),
            "profile_mismatch_m": outcome.profile_mismatch,
            "law_mismatch_m": outcome.law_mismatch,
            "notes": notes,
        },
    });
    if let Some(shaft) = outcome.shaft {
        out["shaft"] = json!(shaft);
        out["force_time"] = json!(outcome.force_time);
    }
    if let Some(floor) = outcome.floor {
        out["floor"] = json!(floor);
    }
    out
}

/// Columns of `dynamics.csv` (written by [`crate::csv::text`]) and of `dynamics.xlsx` (written by [`crate::xlsx::table`]).
pub fn columns(outcome: &Outcome) -> Columns {
    let rows = outcome.rows.iter().map(|row| values(outcome, row));
    csv::columns(csv::named(COLUMNS, outcome.swings), rows)
}

/// Results of a simulation as rows of name and value.
pub fn rows(outcome: &Outcome, measures: Measures, language: Language) -> Vec<(String, String)> {
    let words = &words::words(language);
    let mut lines = vec![
        ("simulation-model", words.name(outcome.model.name())),
        ("simulation-why", outcome.why.sentence(language)),
        ("simulation-contact", contact(outcome, words)),
    ];
    lines.extend(loads(outcome, measures, words));
    lines.extend(outcome.shaft.iter().flat_map(|s| shaft(s, words)));
    let floor = outcome.floor.map(|f| floor(&f, language));
    lines.extend(floor.map(|text| ("simulation-floor", text)));
    lines.extend(motion(outcome, measures, words));
    if let Some(next) = &outcome.next {
        lines.push(("simulation-next-model", change(next, outcome.lever, words)));
    }
    for note in &outcome.notes {
        lines.push(("simulation-note", note.sentence(language)));
    }
    let lines = lines.into_iter();
    lines
        .map(|(label, value)| (words.text(label), value))
        .collect()
}

/// Results of a simulation as a text table, in the units of the follower.
pub fn table(outcome: &Outcome, measures: Measures, language: Language) -> String {
    let lines = rows(outcome, measures, language);
    let width = lines.iter().map(|l| l.0.chars().count()).max().unwrap_or(0);
    lines.iter().fold(String::new(), |mut out, (name, value)| {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{name:width$}  {value}");
        out
    })
}

fn contact(outcome: &Outcome, words: &Words) -> String {
    if !outcome.contact_lost {
        return words.text("simulation-contact-kept");
    }
    let percent = words.number(100.0 * outcome.lost_fraction);
    words.fill("simulation-contact-lost", &[("percent", &percent)])
}

/// Text with the acceleration of the floor and its comfort class.
pub fn floor(floor: &FloorMotion, language: Language) -> String {
    let words = words::words(language);
    let [peak, rms] = [
        floor.acceleration_peak_m_per_s2,
        floor.acceleration_rms_m_per_s2,
    ]
    .map(|x| words.number(x));
    let values = [
        ("peak", &*peak),
        ("rms", &*rms),
        ("class", floor.comfort.hivoss()),
        ("setra", floor.comfort.setra()),
    ];
    words.fill("simulation-floor-values", &values)
}

/// Rows of the result table on the shaft: speed, motor, start, and minimum inertia.
pub(crate) fn shaft(shaft: &Shaft, words: &Words) -> Vec<(&'static str, String)> {
    let speed = [
        ("least", &*words.number(shaft.min)),
        ("most", &*words.number(shaft.max)),
        ("ripple", &*words.number(100.0 * shaft.ripple)),
    ];
    let most_power = shaft.motor_torque_max_n_m * shaft.max;
    let motor = [
        ("noload", &*words.number(shaft.no_load_speed)),
        ("rms", &*words.number(shaft.motor_torque_rms_n_m)),
        ("most", &*words.number(shaft.motor_torque_max_n_m)),
        (
            "power",
            &*words.number_beside(shaft.motor_power_mean_w, most_power),
        ),
    ];
    let start = match shaft.stops_at_rad {
        None => words.text("simulation-starts"),
        Some(at) => {
            let degrees = words.number(at.to_degrees());
            words.fill("simulation-stops", &[("degrees", &degrees)])
        }
    };
    let least = match shaft.least_inertia_kg_m2 {
        0.0 => words.text("simulation-any-inertia"),
        j => words.fill("simulation-least-inertia", &[("inertia", &words.number(j))]),
    };
    vec![
        (
            "simulation-speed",
            words.fill("simulation-speed-values", &speed),
        ),
        (
            "simulation-motor",
            words.fill("simulation-motor-values", &motor),
        ),
        ("simulation-start", format!("{start}; {least}")),
    ]
}

/// Rows of the result table on force, force error, bearing loads, torque and contact pressure.
fn loads(outcome: &Outcome, measures: Measures, words: &Words) -> Vec<(&'static str, String)> {
    let force = measures.force().name;
    let [low, high] = [outcome.force.min, outcome.force.max];
    // A minimum of zero contains a rounding error of the maximum.
    let low = if low.abs() <= 1e-9 * high.abs() {
        0.0
    } else {
        low
    };
    let [low, high] = [low, high].map(|f| words.number(f));
    let mut lines = vec![("simulation-force", format!("{low} … {high} {force}"))];
    if let Some(error) = outcome.force.rms_error {
        let error = format!("{} {force} RMS", words.number(error));
        lines.push(("simulation-error", error));
    }
    let loads = outcome.loads;
    let bearings = [
        ("normal", &*words.number(loads.normal_force)),
        ("side", &*words.number(loads.side_thrust)),
    ];
    let bearings = words.fill("simulation-bearings-values", &bearings);
    lines.push(("simulation-bearings", bearings));
    let t = &outcome.torque;
    let (label, unit) = match measures {
        Measures::Straight => ("simulation-push", "N"),
        Measures::Translating | Measures::Oscillating => ("simulation-torque", "N·m"),
    };
    let torque = [
        ("least", &*words.number(t.min)),
        ("most", &*format!("{} {unit}", words.number(t.max))),
        ("mean", &*words.number_beside(t.mean, t.rms)),
        ("rms", &*words.number(t.rms)),
    ];
    lines.push((label, words.fill("simulation-torque-values", &torque)));
    if let Some(p) = &outcome.hertz
        && p.contact.pressure > 0.0
    {
        let c = &p.contact;
        let pressure = [
            ("pressure", &*(words.number(1e-6 * c.pressure) + " MPa")),
            ("at", &*measures.place(p.theta, words.language())),
            ("width", &*words.length(c.half_width)),
            ("depth", &*words.length(c.shear_depth)),
        ];
        let text = words.fill("simulation-pressure-values", &pressure);
        lines.push(("simulation-pressure", text));
    }
    lines
}

/// Rows of the result table on lift-off speed, initial turns and impacts.
fn motion(outcome: &Outcome, measures: Measures, words: &Words) -> Vec<(&'static str, String)> {
    let liftoff = match outcome.liftoff_speed {
        Some(w) => Some(measures.speed_words(w, words.language())),
        None if outcome.floor.is_some() => None,
        None => Some(words.text("simulation-never")),
    };
    let settles = match outcome.settle_cycles {
        Some(turns) => {
            let (turns, period) = (turns.to_string(), outcome.period_turns.to_string());
            words.fill(
                "simulation-settled",
                &[("turns", &turns), ("period", &period)],
            )
        }
        None => words.text("simulation-unsettled"),
    };
    let mut lines: Vec<_> = (liftoff
        .map(|text| ("simulation-lift-off", text))
        .into_iter())
    .collect();
    lines.push(("simulation-settles", settles));
    let bounce = outcome.impacts.iter().fold(0.0_f64, |m, i| m.max(i.height));
    let fastest = outcome
        .impacts
        .iter()
        .max_by(|a, b| a.speed.total_cmp(&b.speed));
    if let Some(hit) = fastest {
        let (lift, speed) = (measures.lift(0), measures.by_time(1));
        let bounce = lift.shown(bounce, words.language());
        let impacts = [
            ("count", &*outcome.impacts.len().to_string()),
            ("speed", &*speed.shown(hit.speed, words.language())),
            ("at", &*measures.place(hit.at, words.language())),
            ("bounce", &*bounce),
        ];
        lines.push((
            "simulation-impacts",
            words.fill("simulation-impact-values", &impacts),
        ));
    }
    lines
}

/// Difference between the results of two models below which it counts as a rounding error. The difference is in N, or in N·m for an arm.
/// For lost contact, it is a fraction of the cycle.
const LEAST_CHANGE: f64 = 5e-4;

fn impact_json(hit: &Impact) -> Value {
    json!({
        "at_rad": hit.at,
        "left_at_rad": hit.since,
        "cam": hit.surface,
        "speed_m_per_s": hit.speed,
        "rebound_m_per_s": hit.pulse.rebound,
        "height_m": hit.height,
        "impulse_n_s": hit.pulse.impulse,
    })
}

fn pressure_json(p: Pressure) -> Value {
    json!({
        "at_rad": p.theta,
        "pressure_pa": p.contact.pressure,
        "half_width_m": p.contact.half_width,
        "shear_depth_m": p.contact.shear_depth,
        "shear_pa": p.contact.shear,
    })
}

fn difference_json(next: &Difference, lever: f64) -> Value {
    json!({
        "model": next.model.name(),
        "force_min_change_n": next.force_min / lever,
        "force_max_change_n": next.force_max / lever,
        "rms_error_change_n": next.rms_error.map(|e| e / lever),
        "lost_fraction_change": next.lost_fraction,
        "failed": next.failed.as_ref().map(ToString::to_string),
    })
}

/// Text that describes how the results change with the next finer model. Forces are in N. For an arm, moments are divided by `lever`, the
/// length of the lever, m.
pub(crate) fn change(next: &Difference, lever: f64, words: &Words) -> String {
    let model = &*words.name(next.model.name());
    if let Some(fault) = &next.failed {
        let fault = fault.sentence(words.language());
        return words.fill(
            "simulation-next-failed",
            &[("model", model), ("fault", &fault)],
        );
    }
    let [least, most] = [next.force_min / lever, next.force_max / lever];
    let error = next.rms_error.map(|e| e / lever);
    let same = least.abs().max(most.abs()) < LEAST_CHANGE
        && error.is_none_or(|e| e.abs() < LEAST_CHANGE)
        && next.lost_fraction.abs() < LEAST_CHANGE;
    if same {
        return words.fill("simulation-next-same", &[("model", model)]);
    }
    let signed = |x: f64| {
        let x = if x.abs() < LEAST_CHANGE { 0.0 } else { x };
        let sign = if x > 0.0 { "+" } else { "" };
        format!("{sign}{}", words.number(x))
    };
    let error = error.map_or(String::new(), |e| {
        words.fill("simulation-next-rms", &[("rms", &signed(e))])
    });
    let values = [
        ("model", model),
        ("least", &*signed(least)),
        ("most", &*signed(most)),
        ("error", &*error),
        ("lost", &*signed(100.0 * next.lost_fraction)),
    ];
    words.fill("simulation-next-changes", &values)
}
