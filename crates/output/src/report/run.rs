//! The run of the emitted cam on the page: what was run and why, the cam in motion, force, torque and gap.

use std::fmt::Write;

use plotters::style::Color;

use super::{Running, animation};
use crate::escape::escaped;
use crate::figures::force::force_frame;
use crate::number::{number, range};
use crate::plot::axes::{Frame, Panel, padded, ticks};
use crate::plot::layout::{Layout, key, strips};
use crate::plot::palette::{BLUE, ORANGE, PURPLE, QUIET, RED};
use crate::plot::picture::Picture;
use crate::pose::target_at;
use gaitcam::cam::Measures;
use gaitcam::dynamics::outcome::{Model, Outcome};
use gaitcam::synth::Synthesis;

/// Landings listed; a bounce that dies out has dozens.
const LISTED: usize = 12;

/// The section of a run.
pub fn section(out: &mut String, synthesis: &Synthesis, running: &Running) {
    let outcome = running.outcome;
    let _ = write!(
        out,
        "<h2>The run</h2>\n<p>The emitted profile, run with the <strong>{}</strong> model: {}.</p>\n",
        outcome.model.name(),
        escaped(&outcome.why)
    );
    cards(out, synthesis, outcome);
    out.push_str("<div class=\"turning\">\n");
    animation::stage(out, synthesis, Some(running));
    out.push_str("</div>\n");
    let lost = outcome.contact_lost;
    let layout = Layout::figure(if lost { 620 } else { 500 });
    let frame = force_frame(layout);
    let data = format!(
        " data-left=\"{}\" data-right=\"{}\" data-top=\"{}\" data-bottom=\"{}\" data-turns=\"{}\"",
        frame.left, frame.right, frame.top, frame.bottom, outcome.period_turns
    );
    let picture = diagrams(synthesis, outcome, layout);
    let _ = writeln!(
        out,
        "<figure>{}</figure>",
        picture.svg_for_page(
            "run",
            "Force, torque and gap of the run over the cam angle",
            &data
        )
    );
    impacts(out, synthesis.cam.follower.measures(), outcome);
    remarks(out, outcome);
}

fn cards(out: &mut String, synthesis: &Synthesis, outcome: &Outcome) {
    let measures = synthesis.cam.follower.measures();
    let moment = measures == Measures::Oscillating;
    let unit = measures.force().name;
    let [push, torque] = if measures == Measures::Straight {
        ["Push on the cam", "N"]
    } else {
        ["Shaft torque", "N·m"]
    };
    let speed = |w: f64| measures.speed().after(&number(w, 5));
    let contact = if outcome.contact_lost {
        (
            "lost".to_string(),
            format!(
                "{} % of the motion",
                number(100.0 * outcome.lost_fraction, 3)
            ),
        )
    } else {
        ("kept".to_string(), "all the way round".to_string())
    };
    let error = outcome.force.rms_error.map_or(String::new(), |e| {
        format!("{} {unit} RMS off the target", number(e, 3))
    });
    let t = outcome.torque;
    let liftoff = match outcome.liftoff_speed {
        Some(w) => (
            speed(w),
            format!("runs at {}", speed(synthesis.drive.speed)),
        ),
        None => ("at no speed".to_string(), String::new()),
    };
    let settles = match outcome.settle_cycles {
        Some(0) => ("at once".to_string(), String::new()),
        Some(n) => (format!("after {n} turns"), repeats(outcome.period_turns)),
        None => ("does not".to_string(), "within the turns run".to_string()),
    };
    let all = [
        ("Contact", contact.0, contact.1),
        (
            if moment {
                "Moment on the arm"
            } else {
                "Contact force"
            },
            format!(
                "{}\u{a0}{unit}",
                range(outcome.force.min, outcome.force.max, 4)
            ),
            error,
        ),
        (
            push,
            format!("{}\u{a0}{torque}", range(t.min, t.max, 3)),
            format!("RMS {}", number(t.rms, 3)),
        ),
        ("First lifts off", liftoff.0, liftoff.1),
        ("Settles", settles.0, settles.1),
    ];
    out.push_str("<dl class=\"cards\">\n");
    for (name, value, more) in all {
        let _ = writeln!(
            out,
            "<div><dt>{name}</dt><dd>{value}<small>{more}</small></dd></div>"
        );
    }
    out.push_str("</dl>\n");
}

fn repeats(turns: usize) -> String {
    if turns == 1 {
        "then every turn alike".to_string()
    } else {
        format!("then every {turns} turns alike")
    }
}

/// Force with target and rigid force behind it, torque, and the gap where there is one.
fn diagrams(synthesis: &Synthesis, outcome: &Outcome, layout: Layout) -> Picture {
    Picture::drawn(layout.size.0, layout.size.1, |canvas| {
        let law = &synthesis.cam.law;
        let (start, length) = law.extent();
        let turns = outcome.period_turns;
        let e = layout.letters;
        let total = outcome.rows.len();
        let span = length * turns as f64;
        let measures = synthesis.cam.follower.measures();
        let across = measures.angle().factor;
        let straight = measures == Measures::Straight;
        let panel = |frame: Frame, y: [f64; 2]| {
            let x = [across * start, across * (start + span)];
            if straight {
                Panel::over(canvas, frame, x, ticks(x[0], x[1], 8.0), y, e)
            } else {
                Panel::new(canvas, frame, x, y, e)
            }
        };
        let angle = |i: usize| start + span * i as f64 / total as f64;
        let curve = |f: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
            (0..=total)
                .map(|i| (across * angle(i), f(i % total)))
                .collect()
        };
        let rows = &outcome.rows;
        let force = curve(&|i| rows[i].contact_force);
        let torque = curve(&|i| rows[i].torque);
        let lift = measures.lift(0);
        let gap = curve(&|i| lift.factor * rows[i].gap);
        let within = |i: usize| start + (angle(i) - start) % length;
        let rigid = (outcome.model != Model::Rigid)
            .then(|| curve(&|i| synthesis.drive.force(law.svaj(within(i)))));
        let wanted = synthesis
            .target
            .as_ref()
            .map(|t| curve(&|i| target_at(t, law, within(i))));
        let frame: Frame = force_frame(layout);
        let shares: &[f64] = if outcome.contact_lost {
            &[1.9, 1.0, 0.8]
        } else {
            &[1.9, 1.0]
        };
        let frames = strips(frame, shares, 0.9 * e);
        let values = force
            .iter()
            .chain(rigid.iter().flatten())
            .chain(wanted.iter().flatten())
            .map(|p| p.1);
        let forces = panel(frames[0], padded(values.chain([0.0]), 0.08))?;
        let mut entries = Vec::new();
        if let Some(wanted) = &wanted {
            forces.curve(wanted, ORANGE.mix(0.55), 8.0)?;
            entries.push((ORANGE.mix(0.55), 8.0, "wanted"));
        }
        if let Some(rigid) = &rigid {
            forces.curve(rigid, QUIET, 1.4)?;
            entries.push((QUIET, 1.4, "rigid"));
        }
        forces.curve(&force, BLUE, 2.2)?;
        entries.push((BLUE, 2.2, "as run"));
        let pressing = format!("{}, {}", measures.force_words(), measures.force().name);
        forces.quantity(&pressing, 5.7 * e)?;
        let y = padded(torque.iter().map(|p| p.1).chain([0.0]), 0.12);
        let torques = panel(frames[1], y)?;
        torques.curve(&torque, PURPLE, 2.0)?;
        torques.quantity(if straight { "push, N" } else { "torque, N·m" }, 5.7 * e)?;
        if outcome.contact_lost {
            let top = padded(gap.iter().map(|p| p.1).chain([0.0]), 0.12)[1];
            let gaps = panel(frames[2], [0.0, top])?;
            gaps.curve(&gap, RED, 2.0)?;
            gaps.quantity(&format!("gap, {}", lift.name), 5.7 * e)?;
            gaps.across(measures.angle_words())?;
        } else {
            torques.across(measures.angle_words())?;
        }
        key(canvas, [frame.left, frame.top - 1.1 * e], e, &entries)
    })
}

fn impacts(out: &mut String, measures: Measures, outcome: &Outcome) {
    if outcome.impacts.is_empty() {
        return;
    }
    let _ = write!(
        out,
        "<h3>Landings</h3>\n<div class=\"scroll\"><table><tr><th class=\"n\">Leaves at</th><th class=\"n\">Lands at</th>\
         <th class=\"n\">Speed</th><th class=\"n\">Gap</th><th class=\"n\">Impulse</th></tr>\n"
    );
    let lift = measures.lift(0);
    for hit in outcome.impacts.iter().take(LISTED) {
        let _ = writeln!(
            out,
            "<tr><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
             <td class=\"n\">{}</td><td class=\"n\">{} {}·s</td></tr>",
            measures.place(hit.since, 1),
            measures.place(hit.at, 1),
            measures.by_time(1).after(&number(hit.speed, 4)),
            lift.after(&number(lift.factor * hit.height, 4)),
            number(hit.pulse.impulse, 4),
            measures.force().name
        );
    }
    out.push_str("</table></div>\n");
    let more = outcome.impacts.len().saturating_sub(LISTED);
    if more > 0 {
        let _ = writeln!(
            out,
            "<p class=\"note\">{more} more in simulation.json; angles are counted on over the turns.</p>"
        );
    }
}

fn remarks(out: &mut String, outcome: &Outcome) {
    let next = outcome.next.as_ref().map(|n| {
        let words = gaitcam::dynamics::report::difference_words(n);
        format!("The next model up, {words}.")
    });
    if outcome.notes.is_empty() && next.is_none() {
        return;
    }
    out.push_str("<ul>\n");
    for note in outcome.notes.iter().chain(&next) {
        let _ = writeln!(out, "<li>{}</li>", escaped(note));
    }
    out.push_str("</ul>\n");
}
