//! What was found in a recording: a table for people, JSON for programs, csv of the mean cycle.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::curve::ForceCurve;
use super::cycle::Cycle;
use super::recording::{Foot, Recording};
use super::stance::{Point, Stances};
use crate::units::G;

/// Stances and rejected contacts that the table lists before it sums up the rest.
const LISTED: usize = 30;

/// A table that a person can check at a glance. `cycle` may be an error's text where there is none.
pub fn table(recording: &Recording, stances: &Stances, cycle: Result<&Cycle, &str>) -> String {
    let mut out = String::new();
    // Writing to a String does not fail.
    let _ = write_table(&mut out, recording, stances, cycle);
    out
}

fn write_table(
    out: &mut String,
    r: &Recording,
    stances: &Stances,
    cycle: Result<&Cycle, &str>,
) -> std::fmt::Result {
    writeln!(out, "format    {}", r.format)?;
    writeln!(out, "rate      {:.2} Hz, {:.3} s", r.rate_hz, r.duration_s)?;
    let mass = match (r.mass_kg, cycle) {
        (Some(m), _) => format!("{m:.1} kg ({})", r.mass_from),
        (None, Ok(c)) => format!("{:.1} kg ({})", c.mass_kg, c.mass_from),
        (None, Err(_)) => "not known".to_string(),
    };
    writeln!(out, "mass      {mass}")?;
    for note in &r.notes {
        writeln!(out, "note      {note}")?;
    }
    writeln!(out)?;
    let wide = r
        .channels
        .iter()
        .map(|c| c.name.chars().count())
        .max()
        .unwrap_or(0)
        .clamp(7, 40);
    writeln!(
        out,
        "{:<wide$}  foot   baseline N  stances  rejected",
        "channel"
    )?;
    for (i, c) in r.channels.iter().enumerate() {
        let used = stances.used.iter().filter(|s| s.channel == i).count();
        let rejected = stances.rejected.iter().filter(|s| s.channel == i).count();
        let name: String = c.name.chars().take(40).collect();
        let foot = c.foot.map_or("-", Foot::name);
        match &c.idle {
            Some(why) => writeln!(out, "{name:<wide$}  {foot:<5}  {why}")?,
            None => writeln!(
                out,
                "{name:<wide$}  {foot:<5}  {:>10.1}  {used:>7}  {rejected:>8}",
                c.baseline_n
            )?,
        }
    }
    if !stances.used.is_empty() {
        writeln!(
            out,
            "\nfoot   start s    end s   P1 N     @ %   V N     @ %   P2 N     @ %"
        )?;
        for s in stances.used.iter().take(LISTED) {
            writeln!(
                out,
                "{:<5} {:>8.3} {:>8.3}  {}  {}  {}",
                s.foot.map_or("-", Foot::name),
                s.start_s,
                s.end_s,
                point(Some(s.p1)),
                point(s.valley),
                point(s.p2)
            )?;
        }
        more(out, stances.used.len(), "stances")?;
    }
    if !stances.rejected.is_empty() {
        writeln!(out, "\nrejected")?;
        for x in stances.rejected.iter().take(LISTED) {
            let name = r.channels.get(x.channel).map_or("", |c| c.name.as_str());
            writeln!(
                out,
                "{:>8.3} {:>8.3}  {name}: {}",
                x.from_s,
                x.to_s,
                x.why.words()
            )?;
        }
        more(out, stances.rejected.len(), "contacts")?;
    }
    writeln!(out)?;
    match cycle {
        Err(why) => writeln!(out, "no mean cycle: {why}"),
        Ok(c) => write_cycle(out, c),
    }
}

fn point(p: Option<Point>) -> String {
    p.map_or(format!("{:>6}  {:>5}", "-", "-"), |p| {
        format!("{:>6.0}  {:>5.1}", p.force_n, 100.0 * p.at)
    })
}

fn more(out: &mut String, all: usize, what: &str) -> std::fmt::Result {
    if all > LISTED {
        writeln!(out, "… and {} more {what}", all - LISTED)?;
    }
    Ok(())
}

fn write_cycle(out: &mut String, c: &Cycle) -> std::fmt::Result {
    let weight = c.mass_kg * G;
    writeln!(out, "cycle     {}", c.how)?;
    writeln!(out, "period    {:.4} s", c.curve.period_s)?;
    writeln!(
        out,
        "mean      {:.1} N ({:.3} BW)",
        c.curve.mean_n(),
        c.curve.mean_n() / weight
    )?;
    for note in &c.notes {
        writeln!(out, "doubt     {note}")?;
    }
    if let (Some(spread), Some(repeat)) = (spread_rms_n(&c.curve), c.repeatability_n) {
        writeln!(
            out,
            "spread    {spread:.1} N step to step ({:.1} % BW)",
            100.0 * spread / weight
        )?;
        writeln!(
            out,
            "repeats   within {repeat:.1} N (coefficient of repeatability)"
        )?;
    }
    Ok(())
}

/// Root mean square over the cycle of the step-to-step standard deviation, N.
pub fn spread_rms_n(curve: &ForceCurve) -> Option<f64> {
    let s = curve.spread_n.as_ref()?;
    Some((s.iter().map(|x| x * x).sum::<f64>() / s.len().max(1) as f64).sqrt())
}

/// The same for programs; `cycle` is null where there is none.
pub fn json(recording: &Recording, stances: &Stances, cycle: Option<&Cycle>) -> Value {
    let r = recording;
    let foot = |f: Option<Foot>| f.map(Foot::name);
    let at = |p: Option<Point>| p.map(|p| p.at);
    let force = |p: Option<Point>| p.map(|p| p.force_n);
    let mut rejected: Vec<Vec<Value>> = vec![Vec::new(); r.channels.len()];
    let mut used = vec![0usize; r.channels.len()];
    for x in &stances.rejected {
        if let Some(list) = rejected.get_mut(x.channel) {
            list.push(json!({"from_s": x.from_s, "to_s": x.to_s, "why": x.why.words()}));
        }
    }
    for s in &stances.used {
        if let Some(n) = used.get_mut(s.channel) {
            *n += 1;
        }
    }
    let channels: Vec<Value> = r
        .channels
        .iter()
        .zip(rejected)
        .zip(used)
        .map(|((c, rejected), stances)| {
            json!({"name": c.name, "foot": foot(c.foot), "baseline_n": c.baseline_n, "idle": c.idle, "stances": stances, "rejected": rejected})
        })
        .collect();
    let rows: Vec<Value> = stances
        .used
        .iter()
        .map(|s| {
            json!({
                "foot": foot(s.foot), "channel": s.channel, "start_s": s.start_s, "end_s": s.end_s,
                "p1_n": s.p1.force_n, "p1_at": s.p1.at, "valley_n": force(s.valley), "valley_at": at(s.valley),
                "p2_n": force(s.p2), "p2_at": at(s.p2),
            })
        })
        .collect();
    let mean = cycle.map(|c| {
        json!({
            "period_s": c.curve.period_s, "mean_n": c.curve.mean_n(), "averaged": c.averaged, "how": c.how,
            "spread_rms_n": spread_rms_n(&c.curve), "repeatability_n": c.repeatability_n,
            "mean_of_weight": c.mean_of_weight, "mass_fits": c.mass_fits,
        })
    });
    let notes: Vec<&String> = r
        .notes
        .iter()
        .chain(cycle.iter().flat_map(|c| &c.notes))
        .collect();
    let (mass, from) = match (r.mass_kg, cycle) {
        (None, Some(c)) => (Some(c.mass_kg), c.mass_from.as_str()),
        (m, _) => (m, r.mass_from.as_str()),
    };
    json!({
        "format": r.format, "rate_hz": r.rate_hz, "duration_s": r.duration_s, "mass_kg": mass, "mass_from": from,
        "notes": notes, "channels": channels, "stances": rows, "cycle": mean,
    })
}

/// What a file that is one cycle holds, for people.
pub fn cycle_table(curve: &ForceCurve) -> String {
    let mut lines = vec![
        "format    one cycle of force, as it stands (no stances are looked for)".to_string(),
        format!(
            "period    {:.4} s in {} samples",
            curve.period_s,
            curve.force_n.len()
        ),
    ];
    let mean = curve.mean_n();
    lines.push(match curve.mass_kg {
        Some(m) => format!(
            "mean      {mean:.1} N ({:.3} BW of {m:.1} kg)",
            mean / (m * G)
        ),
        None => format!("mean      {mean:.1} N"),
    });
    if let Some(spread) = spread_rms_n(curve) {
        lines.push(format!("spread    {spread:.1} N step to step"));
    }
    lines.join("\n")
}

/// The same for programs, in the shape of [`json()`].
pub fn cycle_json(curve: &ForceCurve) -> Value {
    json!({
        "format": "one cycle", "rate_hz": curve.force_n.len() as f64 / curve.period_s,
        "duration_s": curve.period_s, "mass_kg": curve.mass_kg, "mass_from": "file",
        "notes": [], "channels": [], "stances": [],
        "cycle": {
            "period_s": curve.period_s, "mean_n": curve.mean_n(), "averaged": 1,
            "how": "the cycle as the file gives it", "spread_rms_n": spread_rms_n(curve),
            "repeatability_n": null,
            "mean_of_weight": curve.mass_kg.map(|m| curve.mean_n() / (m * G)),
        },
    })
}

/// One cycle as csv that reads back as the same cycle.
///
/// `comments` become comment lines; a line end inside one starts another comment line.
pub fn csv(curve: &ForceCurve, comments: &[&str]) -> String {
    let n = curve.force_n.len();
    let mut out = String::with_capacity(48 * n);
    let _ = write_csv(&mut out, curve, comments);
    out
}

fn write_csv(out: &mut String, curve: &ForceCurve, comments: &[&str]) -> std::fmt::Result {
    writeln!(out, "# cycle, period_s = {}", curve.period_s)?;
    if let Some(m) = curve.mass_kg {
        writeln!(out, "# mass_kg = {m}")?;
    }
    for line in comments.iter().flat_map(|c| c.lines()) {
        writeln!(out, "# {line}")?;
    }
    let step = curve.period_s / curve.force_n.len() as f64;
    match &curve.spread_n {
        Some(spread) => {
            writeln!(out, "time_s,force_n,spread_n")?;
            for (i, (f, s)) in curve.force_n.iter().zip(spread).enumerate() {
                writeln!(out, "{},{f},{s}", i as f64 * step)?;
            }
        }
        None => {
            writeln!(out, "time_s,force_n")?;
            for (i, f) in curve.force_n.iter().enumerate() {
                writeln!(out, "{},{f}", i as f64 * step)?;
            }
        }
    }
    Ok(())
}
