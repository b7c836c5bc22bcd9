//! Table of a recording: channels, stances, mean cycle, warnings.

use std::fmt::Write as _;

use serde::Serialize;

use super::WORDS;
use gaitcam::force::{Cycle, Foot, ForceCurve, Interpretation, Point, Recording, Stances};
use gaitcam::units::G;
use gaitcam::wording::{Language, Messages};

/// Most stances, and most rejected contacts, that the table lists.
const LISTED: usize = 30;

/// Table of a recording. `cycle` is the text of an error if there is no mean cycle.
pub fn table(
    understood: &Interpretation,
    recording: &Recording,
    stances: &Stances,
    cycle: Result<&Cycle, &str>,
    language: Language,
) -> String {
    let words = WORDS.of(language);
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
pub(super) fn label(words: &Messages, key: &str) -> String {
    format!("{:<9}", words.text(key))
}

fn write_head(
    out: &mut String,
    words: &Messages,
    understood: &Interpretation,
    r: &Recording,
) -> std::fmt::Result {
    let format = words.sentence("format", &r.format);
    writeln!(out, "{} {format}", label(words, "gait-format"))?;
    let kind = understood
        .kind
        .map_or(words.text("gait-kind-unknown"), |k| {
            words.sentence("kind", &k)
        });
    writeln!(out, "{} {kind}", label(words, "gait-kind"))?;
    let clock = words.sentence("clock", &r.clock);
    let rate = label(words, "gait-rate");
    writeln!(
        out,
        "{rate} {} Hz ({clock}), {} s",
        words.fixed(r.rate_hz, 2),
        words.fixed(r.duration_s, 3)
    )?;
    let mass = understood.mass;
    let mass = mass.map_or(words.text("gait-mass-unknown"), |(kg, from)| {
        format!(
            "{} kg ({})",
            words.fixed(kg, 1),
            words.sentence("mass-from", &from)
        )
    });
    writeln!(out, "{} {mass}", label(words, "gait-mass"))?;
    for note in &r.notes {
        writeln!(
            out,
            "{} {}",
            label(words, "gait-note"),
            words.sentence("note", note)
        )?;
    }
    writeln!(out)
}

fn write_channels(
    out: &mut String,
    words: &Messages,
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
        let foot = foot(words, c.foot);
        match &c.idle {
            Some(why) => {
                let why = words.sentence("channel", why);
                writeln!(out, "{name:<wide$}  {foot:<9}  {why}")?;
            }
            None => writeln!(
                out,
                "{name:<wide$}  {foot:<9}  {:>10}  {used:>7}  {rejected:>8}",
                words.fixed(c.baseline_n, 1)
            )?,
        }
    }
    Ok(())
}

fn write_stances(
    out: &mut String,
    words: &Messages,
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
            "{:<9} {:>8} {:>8}  {}  {}  {}",
            foot(words, s.foot),
            words.fixed(r.start_s + s.start_s, 3),
            words.fixed(r.start_s + s.end_s, 3),
            // A single peak late in the stance is the push-off.
            point(words, s.first_peak()),
            point(words, s.valley),
            point(words, s.second_peak())
        )?;
    }
    more(out, words, stances.used.len())
}

fn write_rejected(
    out: &mut String,
    words: &Messages,
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
        let [from, to] = [c.from_s, c.to_s].map(|t| words.fixed(t, 3));
        writeln!(out, "{from:>8} {to:>8}  {name}: {reason}")?;
    }
    more(out, words, all.len())
}

/// Open questions, and the keys that answer them.
fn write_doubts(
    out: &mut String,
    words: &Messages,
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
    writeln!(out, "{} {text}", label(words, "gait-doubt"))
}

/// Labels with data.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
enum Label {
    More { count: usize },
    Doubts { list: String, names: String },
}

fn point(words: &Messages, p: Option<Point>) -> String {
    p.map_or(format!("{:>6}  {:>5}", "-", "-"), |p| {
        let at = words.fixed(100.0 * p.at, 1);
        format!("{:>6.0}  {at:>5}", p.force_n)
    })
}

fn foot(words: &Messages, foot: Option<Foot>) -> String {
    foot.map_or("-".to_string(), |f| words.name(f.name()))
}

fn more(out: &mut String, words: &Messages, all: usize) -> std::fmt::Result {
    if all > LISTED {
        let count = all - LISTED;
        writeln!(out, "{}", words.sentence("gait", &Label::More { count }))?;
    }
    Ok(())
}

fn write_cycle(
    out: &mut String,
    words: &Messages,
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
    writeln!(out, "{} {how}", label(words, "gait-cycle"))?;
    write_period(out, words, c.curve.period_s, c.period_spread_s)?;
    let (newtons, share) = (words.fixed(mean, 1), words.fixed(mean / weight, 3));
    writeln!(
        out,
        "{} {newtons} N ({share} BW)",
        label(words, "gait-mean")
    )?;
    for note in &c.notes {
        let warning = words.sentence("note", note);
        writeln!(out, "{} {warning}", label(words, "gait-warning"))?;
    }
    write_spread(out, words, &c.curve, c.repeatability_n, weight)
}

/// Duration of a cycle, with its standard deviation over several cycles.
pub(super) fn write_period(
    out: &mut String,
    words: &Messages,
    period_s: f64,
    spread_s: Option<f64>,
) -> std::fmt::Result {
    let period = words.fixed(period_s, 4);
    let spread = spread_s.map_or_else(String::new, |s| format!(" ± {} s", words.fixed(s, 4)));
    writeln!(out, "{} {period} s{spread}", label(words, "gait-period"))
}

/// Step-to-step standard deviation and repeatability of several cycles.
pub(super) fn write_spread(
    out: &mut String,
    words: &Messages,
    curve: &ForceCurve,
    repeatability_n: Option<f64>,
    weight_n: f64,
) -> std::fmt::Result {
    let (Some(spread), Some(repeat)) = (curve.spread_rms_n(), repeatability_n) else {
        return Ok(());
    };
    let percent = words.fixed(100.0 * spread / weight_n, 1);
    let [spread, repeat] = [spread, repeat].map(|x| words.fixed(x, 1));
    writeln!(
        out,
        "{} {spread} N ({percent} % BW)",
        label(words, "gait-spread")
    )?;
    writeln!(out, "{} {repeat} N", label(words, "gait-repeatability"))
}

/// Table of a file that is one cycle.
pub fn cycle_table(curve: &ForceCurve, language: Language) -> String {
    let words = WORDS.of(language);
    let mut lines = vec![
        format!(
            "{} {}",
            label(words, "gait-format"),
            words.text("gait-one-cycle")
        ),
        format!(
            "{} {} s",
            label(words, "gait-period"),
            words.fixed(curve.period_s, 4)
        ),
        format!("{} {}", label(words, "gait-samples"), curve.force_n.len()),
    ];
    let (mean, mean_label) = (curve.mean_n(), label(words, "gait-mean"));
    lines.push(match curve.mass_kg {
        Some(m) => {
            let ratio = words.fixed(mean / (m * G), 3);
            let (mean, m) = (words.fixed(mean, 1), words.fixed(m, 1));
            format!("{mean_label} {mean} N ({ratio} BW, {m} kg)")
        }
        None => format!("{mean_label} {} N", words.fixed(mean, 1)),
    });
    if let Some(spread) = curve.spread_rms_n() {
        let spread = words.fixed(spread, 1);
        lines.push(format!("{} {spread} N", label(words, "gait-spread")));
    }
    lines.join("\n")
}
