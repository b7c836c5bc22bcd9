//! Section of the report on a simulation: model, motion, force, torque, gap and impacts.

use std::fmt::Write;

use super::{Card, Running, animation, cards, figures, heading, paragraph, tables};
use crate::figures::force::force_frame;
use crate::figures::run::run_in;
use crate::plot::layout::Layout;
use crate::simulation::change;
use crate::words::Words;
use gaitcam::cam::Measures;
use gaitcam::dynamics::Outcome;
use gaitcam::synth::Design;
use gaitcam_base::text::escaped;

/// Maximum number of listed impacts. A decaying sequence of bounces consists of dozens of impacts.
const LISTED: usize = 12;

/// Writes the section of the report on a simulation.
pub fn section(out: &mut String, synthesis: &Design, running: &Running, words: &Words) {
    let outcome = running.outcome;
    heading(out, &words.text("report-simulation"));
    let why = outcome.why.sentence(words.language());
    let arguments = [("model", outcome.model.name()), ("why", &why)];
    paragraph(out, &words.fill("report-simulated", &arguments));
    cards(out, &cards_of(synthesis, outcome, words));
    out.push_str("<div class=\"turning\">\n");
    animation::stage(out, synthesis, Some(running), words);
    out.push_str("</div>\n");
    let layout = Layout::figure(if outcome.contact_lost || outcome.shaft.is_some() {
        620
    } else {
        500
    });
    let frame = force_frame(layout);
    let mut data = format!(
        " data-left=\"{}\" data-right=\"{}\" data-top=\"{}\" data-bottom=\"{}\" data-turns=\"{}\"",
        frame.left, frame.right, frame.top, frame.bottom, outcome.period_turns
    );
    if outcome.shaft.is_some() {
        // The horizontal axis of these diagrams is time, so the current cam angle is not marked.
        data.clear();
    }
    let unit = synthesis.cam.follower.measures().force().name;
    let [low, high] =
        [outcome.force.min, outcome.force.max].map(|x| format!("{} {unit}", words.number(x)));
    let alt = words.fill("report-alt-simulation", &[("low", &low), ("high", &high)]);
    let picture = run_in(synthesis, outcome, layout, words);
    figures::framed(out, &picture.svg_for_page("run", &alt, &data), words);
    impacts(out, synthesis.cam.follower.measures(), outcome, words);
    remarks(out, outcome, words);
}

fn cards_of(synthesis: &Design, outcome: &Outcome, words: &Words) -> Vec<Card> {
    let measures = synthesis.cam.follower.measures();
    let unit = measures.force().name;
    let straight = measures == Measures::Straight;
    let text = |key: &str| words.text(key);
    let contact = if outcome.contact_lost {
        let percent = words.number(100.0 * outcome.lost_fraction);
        let share = words.fill("report-lost-share", &[("percent", &percent)]);
        (text("report-contact-lost"), share)
    } else {
        (text("report-contact-kept"), text("report-kept-share"))
    };
    let error = outcome.force.rms_error.map_or(String::new(), |e| {
        let rms = format!("{} {unit}", words.number(e));
        words.fill("report-error-of-target", &[("rms", &rms)])
    });
    let pressing = match measures {
        Measures::Oscillating => "report-moment-section",
        _ => "report-contact-force",
    };
    let force = words.range(outcome.force.min, outcome.force.max);
    let (push, push_unit) = if straight {
        ("report-cam-push", "N")
    } else {
        ("report-shaft-torque", "N·m")
    };
    let t = outcome.torque;
    let rms = words.number(t.rms);
    let (lift, lift_more) = liftoff(synthesis, outcome, words);
    let (steady, steady_more) = steady(outcome, words);
    vec![
        (text("report-contact"), contact.0, contact.1),
        (text(pressing), format!("{force}\u{a0}{unit}"), error),
        (
            text(push),
            format!("{}\u{a0}{push_unit}", words.range(t.min, t.max)),
            words.fill("report-rms", &[("value", &rms)]),
        ),
        (text("report-liftoff"), lift, lift_more),
        (text("report-steady"), steady, steady_more),
    ]
}

fn liftoff(synthesis: &Design, outcome: &Outcome, words: &Words) -> (String, String) {
    let measures = synthesis.cam.follower.measures();
    let speed = |w: f64| measures.speed().shown(w, words.language());
    match outcome.liftoff_speed {
        Some(w) => {
            let own = speed(synthesis.problem.drive.speed);
            (speed(w), words.fill("report-runs-at", &[("speed", &own)]))
        }
        None if outcome.floor.is_some() => ("–".to_string(), String::new()),
        None => (words.text("report-liftoff-none"), String::new()),
    }
}

fn steady(outcome: &Outcome, words: &Words) -> (String, String) {
    let turns = outcome.period_turns;
    let period = match turns {
        1 => words.text("report-period-one"),
        n => words.fill("report-period", &[("turns", &n.to_string())]),
    };
    match outcome.settle_cycles {
        Some(0) => (words.text("report-steady-first"), period),
        Some(n) => {
            let after = words.fill("report-steady-after", &[("turns", &n.to_string())]);
            (after, period)
        }
        None => (
            words.text("report-steady-not"),
            words.text("report-steady-within"),
        ),
    }
}

fn impacts(out: &mut String, measures: Measures, outcome: &Outcome, words: &Words) {
    if outcome.impacts.is_empty() {
        return;
    }
    let head = escaped(&words.text("report-impacts"));
    let _ = writeln!(out, "<h3>{head}</h3>");
    let columns = [
        "report-leaves",
        "report-lands",
        "report-impact-speed",
        "report-impact-gap",
        "report-impulse",
    ];
    tables::open(out, &columns.map(|key| words.text(key)), 0);
    let (lift, force) = (measures.lift(0), measures.force().name);
    for hit in outcome.impacts.iter().take(LISTED) {
        out.push_str("<tr>");
        let values = [
            measures.place(hit.since, words.language()),
            measures.place(hit.at, words.language()),
            measures.by_time(1).shown(hit.speed, words.language()),
            lift.shown(hit.height, words.language()),
            format!("{} {force}·s", words.number(hit.pulse.impulse)),
        ];
        tables::cells(out, &values);
    }
    tables::close(out);
    let more = outcome.impacts.len().saturating_sub(LISTED);
    if more > 0 {
        let text = words.fill("report-more-impacts", &[("count", &more.to_string())]);
        let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(&text));
    }
}

fn remarks(out: &mut String, outcome: &Outcome, words: &Words) {
    let next = outcome.next.as_ref().map(|n| {
        let difference = change(n, outcome.lever, words);
        words.fill("report-next-model", &[("difference", &difference)])
    });
    if outcome.notes.is_empty() && next.is_none() {
        return;
    }
    out.push_str("<ul>\n");
    let notes = outcome.notes.iter();
    let notes = notes.map(|note| note.sentence(words.language()));
    for note in notes.chain(next) {
        let _ = writeln!(out, "<li>{}</li>", escaped(&note));
    }
    out.push_str("</ul>\n");
}
