//! What was found in a recording: a table for people, JSON for programs, csv of the mean cycle.

use std::fmt::Write as _;

use serde::Serialize;
use serde_json::{Value, json};

use super::curve::ForceCurve;
use super::cycle::Cycle;
use super::interpretation::{Interpretation, coded};
use super::note::Note;
use super::recording::{Channel, Foot, Recording};
use super::stance::{Point, Stance, Stances};
use crate::units::G;
use crate::wording::{Catalogue, Language, catalogue};

/// Stances and rejected contacts that the table lists before it sums up the rest.
const LISTED: usize = 30;

/// Labels of the table: messages of the area `gait`.
pub const LABELS: &[&str] = &[
    "format",
    "kind",
    "kind-unknown",
    "rate",
    "mass",
    "mass-unknown",
    "note",
    "channel",
    "channel-columns",
    "stance-columns",
    "rejected",
    "more",
    "no-cycle",
    "cycle",
    "period",
    "mean",
    "warning",
    "spread",
    "repeatability",
    "samples",
    "doubt",
    "doubts",
    "one-cycle",
];

/// A table that a person can check at a glance. `cycle` may be an error's text where there is none.
pub fn table(
    understood: &Interpretation,
    recording: &Recording,
    stances: &Stances,
    cycle: Result<&Cycle, &str>,
    language: Language,
) -> String {
    let words = catalogue(language);
    let mut out = String::new();
    // Writing to a String does not fail.
    let _ = write_head(&mut out, words, understood, recording)
        .and_then(|()| write_channels(&mut out, words, recording, stances))
        .and_then(|()| write_stances(&mut out, words, recording, stances))
        .and_then(|()| write_rejected(&mut out, words, understood))
        .and_then(|()| write_cycle(&mut out, words, cycle))
        .and_then(|()| write_doubts(&mut out, words, understood));
    out
}

/// A label of the table, padded to the width of all of them.
fn label(words: &Catalogue, key: &str) -> String {
    format!("{:<9}", words.text(&format!("gait-{key}")))
}

fn write_head(
    out: &mut String,
    words: &Catalogue,
    understood: &Interpretation,
    r: &Recording,
) -> std::fmt::Result {
    let format = words.sentence("format", &r.format);
    writeln!(out, "{} {format}", label(words, "format"))?;
    let kind = understood
        .kind
        .map_or(words.text("gait-kind-unknown"), |k| {
            words.sentence("kind", &k)
        });
    writeln!(out, "{} {kind}", label(words, "kind"))?;
    let clock = words.sentence("clock", &r.clock);
    let rate = label(words, "rate");
    writeln!(
        out,
        "{rate} {:.2} Hz ({clock}), {:.3} s",
        r.rate_hz, r.duration_s
    )?;
    let mass = understood.mass;
    let mass = mass.map_or(words.text("gait-mass-unknown"), |(kg, from)| {
        format!("{kg:.1} kg ({})", words.sentence("mass-from", &from))
    });
    writeln!(out, "{} {mass}", label(words, "mass"))?;
    for note in &r.notes {
        writeln!(
            out,
            "{} {}",
            label(words, "note"),
            words.sentence("note", note)
        )?;
    }
    writeln!(out)
}

fn write_channels(
    out: &mut String,
    words: &Catalogue,
    r: &Recording,
    stances: &Stances,
) -> std::fmt::Result {
    let widest = r.channels.iter().map(|c| c.name.chars().count()).max();
    let wide = widest.unwrap_or(0).clamp(7, 40);
    let name = words.text("gait-channel");
    writeln!(out, "{name:<wide$}  {}", words.text("gait-channel-columns"))?;
    for (i, c) in r.channels.iter().enumerate() {
        let used = stances.used.iter().filter(|s| s.channel == i).count();
        let rejected = stances.rejected.iter().filter(|s| s.channel == i).count();
        let name: String = c.name.chars().take(40).collect();
        let foot = c.foot.map_or("-", Foot::name);
        match &c.idle {
            Some(why) => {
                let why = words.sentence("channel", why);
                writeln!(out, "{name:<wide$}  {foot:<5}  {why}")?;
            }
            None => writeln!(
                out,
                "{name:<wide$}  {foot:<5}  {:>10.1}  {used:>7}  {rejected:>8}",
                c.baseline_n
            )?,
        }
    }
    Ok(())
}

fn write_stances(
    out: &mut String,
    words: &Catalogue,
    r: &Recording,
    stances: &Stances,
) -> std::fmt::Result {
    if stances.used.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{}", words.text("gait-stance-columns"))?;
    for s in stances.used.iter().take(LISTED) {
        writeln!(
            out,
            "{:<5} {:>8.3} {:>8.3}  {}  {}  {}",
            s.foot.map_or("-", Foot::name),
            r.start_s + s.start_s,
            r.start_s + s.end_s,
            // A single peak late in the stance is the push-off.
            point(s.first_peak()),
            point(s.valley),
            point(s.second_peak())
        )?;
    }
    more(out, words, stances.used.len())
}

fn write_rejected(
    out: &mut String,
    words: &Catalogue,
    understood: &Interpretation,
) -> std::fmt::Result {
    let rejected = understood
        .contacts
        .iter()
        .filter_map(|c| Some((c, c.rejected?)));
    let all: Vec<_> = rejected.collect();
    if all.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{}", words.text("gait-rejected"))?;
    for (c, reason) in all.iter().take(LISTED) {
        let column = understood.columns.get(c.column);
        let name = column.map_or("", |c| c.name.as_str());
        let reason = words.sentence("contact", reason);
        writeln!(out, "{:>8.3} {:>8.3}  {name}: {reason}", c.from_s, c.to_s)?;
    }
    more(out, words, all.len())
}

/// What is open, and how it is closed.
fn write_doubts(
    out: &mut String,
    words: &Catalogue,
    understood: &Interpretation,
) -> std::fmt::Result {
    let doubts = understood.doubts();
    if doubts.is_empty() {
        return Ok(());
    }
    let said: Vec<String> = doubts.iter().map(|d| words.sentence("open", d)).collect();
    let names: Vec<&str> = doubts.iter().map(|d| d.name()).collect();
    let doubts = Label::Doubts {
        list: said.join(", "),
        names: names.join(", "),
    };
    let text = words.sentence("gait", &doubts);
    writeln!(out, "{} {text}", label(words, "doubt"))
}

/// Lines of the table that carry data.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
enum Label {
    More { count: usize },
    Doubts { list: String, names: String },
}

fn point(p: Option<Point>) -> String {
    p.map_or(format!("{:>6}  {:>5}", "-", "-"), |p| {
        format!("{:>6.0}  {:>5.1}", p.force_n, 100.0 * p.at)
    })
}

fn more(out: &mut String, words: &Catalogue, all: usize) -> std::fmt::Result {
    if all > LISTED {
        let count = all - LISTED;
        writeln!(out, "{}", words.sentence("gait", &Label::More { count }))?;
    }
    Ok(())
}

fn write_cycle(
    out: &mut String,
    words: &Catalogue,
    cycle: Result<&Cycle, &str>,
) -> std::fmt::Result {
    writeln!(out)?;
    let c = match cycle {
        Ok(c) => c,
        Err(why) => return writeln!(out, "{}: {why}", words.text("gait-no-cycle")),
    };
    let weight = c.mass_kg * G;
    let mean = c.curve.mean_n();
    let how = words.sentence("cycle", &c.source);
    writeln!(out, "{} {how}", label(words, "cycle"))?;
    writeln!(out, "{} {:.4} s", label(words, "period"), c.curve.period_s)?;
    let label_mean = label(words, "mean");
    writeln!(out, "{label_mean} {mean:.1} N ({:.3} BW)", mean / weight)?;
    for note in &c.notes {
        let warning = words.sentence("note", note);
        writeln!(out, "{} {warning}", label(words, "warning"))?;
    }
    if let (Some(spread), Some(repeat)) = (spread_rms_n(&c.curve), c.repeatability_n) {
        let percent = 100.0 * spread / weight;
        let spread_label = label(words, "spread");
        writeln!(out, "{spread_label} {spread:.1} N ({percent:.1} % BW)")?;
        writeln!(out, "{} {repeat:.1} N", label(words, "repeatability"))?;
    }
    Ok(())
}

/// Root mean square over the cycle of the step-to-step standard deviation, N.
pub fn spread_rms_n(curve: &ForceCurve) -> Option<f64> {
    let s = curve.spread_n.as_ref()?;
    Some((s.iter().map(|x| x * x).sum::<f64>() / s.len().max(1) as f64).sqrt())
}

/// The same for programs; `cycle` is null where there is none.
///
/// `warnings` holds a code and its data for every note; `notes` the same as sentences. Times of contacts are those
/// of the file's own clock.
pub fn json(
    understood: &Interpretation,
    recording: &Recording,
    stances: &Stances,
    cycle: Option<&Cycle>,
) -> Value {
    let r = recording;
    let channels = r.channels.iter().enumerate();
    let channels: Vec<Value> = channels.map(|(i, c)| channel(i, c, r, stances)).collect();
    let rows: Vec<Value> = stances.used.iter().map(|s| stance(s, r)).collect();
    let mean = cycle.map(|c| {
        json!({
            "period_s": c.curve.period_s, "period_from": c.period_from,
            "mean_n": c.curve.mean_n(), "averaged": c.averaged,
            "how": c.source.to_string(), "source": coded(&c.source),
            "spread_rms_n": spread_rms_n(&c.curve), "repeatability_n": c.repeatability_n,
            "mean_of_weight": c.mean_of_weight, "mass_fits": c.mass_fits,
        })
    });
    let notes: Vec<String> = understood.warnings.iter().map(Note::to_string).collect();
    let mut out = understood.json();
    let more = json!({
        "format": r.format.to_string(), "rate_hz": r.rate_hz, "duration_s": r.duration_s,
        "notes": notes, "channels": channels, "stances": rows, "cycle": mean,
    });
    if let (Value::Object(out), Value::Object(more)) = (&mut out, more) {
        out.extend(more);
    }
    out
}

fn channel(index: usize, c: &Channel, r: &Recording, stances: &Stances) -> Value {
    let used = stances.used.iter().filter(|s| s.channel == index).count();
    let rejected = stances.rejected.iter().filter(|x| x.channel == index);
    let rejected: Vec<Value> = rejected
        .map(|x| json!({"from_s": r.start_s + x.from_s, "to_s": r.start_s + x.to_s, "reason": x.reason}))
        .collect();
    json!({
        "name": c.name, "foot": c.foot, "baseline_n": c.baseline_n,
        "idle": c.idle.as_ref().map(coded), "stances": used, "rejected": rejected,
    })
}

fn stance(s: &Stance, r: &Recording) -> Value {
    let at = |p: Option<Point>| p.map(|p| p.at);
    let force = |p: Option<Point>| p.map(|p| p.force_n);
    json!({
        "foot": s.foot, "channel": s.channel, "start_s": r.start_s + s.start_s,
        "end_s": r.start_s + s.end_s, "p1_n": force(s.first_peak()), "p1_at": at(s.first_peak()),
        "valley_n": force(s.valley), "valley_at": at(s.valley),
        "p2_n": force(s.second_peak()), "p2_at": at(s.second_peak()),
    })
}

/// What a file that is one cycle holds, for people.
pub fn cycle_table(curve: &ForceCurve, language: Language) -> String {
    let words = catalogue(language);
    let mut lines = vec![
        format!(
            "{} {}",
            label(words, "format"),
            words.text("gait-one-cycle")
        ),
        format!("{} {:.4} s", label(words, "period"), curve.period_s),
        format!("{} {}", label(words, "samples"), curve.force_n.len()),
    ];
    let (mean, mean_label) = (curve.mean_n(), label(words, "mean"));
    lines.push(match curve.mass_kg {
        Some(m) => {
            let ratio = mean / (m * G);
            format!("{mean_label} {mean:.1} N ({ratio:.3} BW, {m:.1} kg)")
        }
        None => format!("{mean_label} {mean:.1} N"),
    });
    if let Some(spread) = spread_rms_n(curve) {
        lines.push(format!("{} {spread:.1} N", label(words, "spread")));
    }
    lines.join("\n")
}

/// The same for programs, in the shape of [`json()`].
pub fn cycle_json(curve: &ForceCurve) -> Value {
    json!({
        "format": "one cycle", "rate_hz": curve.force_n.len() as f64 / curve.period_s,
        "duration_s": curve.period_s, "mass_kg": curve.mass_kg, "mass_from": "file",
        "kind": null, "period_s": curve.period_s, "period_from": "file", "contacts": [], "doubts": [],
        "notes": [], "warnings": [], "channels": [], "stances": [],
        "cycle": {
            "period_s": curve.period_s, "period_from": "file", "mean_n": curve.mean_n(), "averaged": 1,
            "source": {"code": "as-given", "data": {}}, "spread_rms_n": spread_rms_n(curve),
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
    let times = (0..).map(|i| f64::from(i) * step);
    match &curve.spread_n {
        Some(spread) => {
            writeln!(out, "time_s,force_n,spread_n")?;
            for ((t, f), s) in times.zip(&curve.force_n).zip(spread) {
                writeln!(out, "{t},{f},{s}")?;
            }
        }
        None => {
            writeln!(out, "time_s,force_n")?;
            for (t, f) in times.zip(&curve.force_n) {
                writeln!(out, "{t},{f}")?;
            }
        }
    }
    Ok(())
}
