//! The whole recording: force in every column over time. Below, each column has a row (lane) with its contacts.

use std::collections::BTreeMap;

use plotters::style::{Color, RGBAColor};
use plotters_backend::text_anchor::{HPos, VPos};

use super::{Curve, colour, foot_name};
use crate::plot::axes::padded;
use crate::plot::layout::{Figure, columns};
use crate::plot::palette::{GREEN, INK, PURPLE, QUIET, RED};
use crate::plot::sheet::{Drawn, Frame, Lettering, line, rectangle, stroke};
use crate::plot::text::text_width;
use crate::words::Words;
use gaitcam::force::{Column, Interpretation, RejectReason};
use gaitcam::wording::sentence;

/// Maximum number of columns that are drawn. Laboratories have up to about twelve force plates, of which few are used.
const LANES: usize = 8;
/// Height of a lane, em.
const LANE: f64 = 1.35;
/// Colours of columns whose foot is unknown.
const PLATES: [RGBAColor; 4] = [GREEN, PURPLE, QUIET, INK];

/// Height of the lanes and of the list of reasons, points.
pub(super) fn height(understood: &Interpretation, e: f64, words: &Words) -> f64 {
    let lanes = loaded(understood).len() as f64;
    (LANE * lanes + 1.6 * reasons(understood, words).len() as f64 + 0.8) * e
}

/// Indices of the columns that are drawn: the columns with contacts or, if no column has contacts, the loaded columns.
fn loaded(understood: &Interpretation) -> Vec<usize> {
    let columns = understood.columns.iter().enumerate();
    let live = columns.filter(|(_, c)| c.idle.is_none()).map(|(i, _)| i);
    let touched = |i: &usize| understood.contacts.iter().any(|c| c.column == *i);
    let some: Vec<usize> = live.clone().filter(touched).take(LANES).collect();
    if some.is_empty() {
        live.take(LANES).collect()
    } else {
        some
    }
}

/// Reasons for rejection, each with its text and the number of contacts.
fn reasons(understood: &Interpretation, words: &Words) -> Vec<(RejectReason, String)> {
    let mut counts: BTreeMap<RejectReason, usize> = BTreeMap::new();
    let rejected = understood.contacts.iter().filter_map(|c| c.rejected);
    for reason in rejected {
        *counts.entry(reason).or_default() += 1;
    }
    let counted = |(reason, count): (RejectReason, usize)| {
        let words = sentence(words.language(), "contact", &reason);
        (reason, format!("{words} ({count})"))
    };
    counts.into_iter().map(counted).collect()
}

pub(super) fn draw(f: &Figure, frame: Frame, understood: &Interpretation, words: &Words) -> Drawn {
    let clock = understood.clock;
    let x = [clock.start_s, clock.start_s + clock.duration_s];
    let shown = loaded(understood);
    let all = shown
        .iter()
        .flat_map(|&i| &understood.columns[i].envelope_n);
    let y = padded(all.flatten().copied().chain([0.0]), 0.06);
    let panel = f.panel(frame, x, columns(x, false), y)?;
    for (k, &i) in shown.iter().enumerate() {
        let column = &understood.columns[i];
        panel.curve(&trace(column, x), own_colour(column, k), 1.3)?;
    }
    panel.quantity(&words.text("figure-force"))?;
    panel.across(&words.text("figure-time"))?;
    let named = |(k, &i): (usize, &usize)| {
        let column = &understood.columns[i];
        (own_colour(column, k), shortened(column, words))
    };
    let names: Vec<(RGBAColor, String)> = shown.iter().enumerate().map(named).collect();
    let entries = names.iter().take(4).map(|(c, n)| (*c, 2.6, n.as_str()));
    let entries: Vec<_> = entries.collect();
    f.key([frame.left, frame.top - 1.1 * f.e], f.e, &entries)?;
    draw_lanes(f, frame, understood, &shown, words)
}

fn own_colour(column: &Column, k: usize) -> RGBAColor {
    match column.foot {
        Some(_) => colour(column.foot),
        None => PLATES[k % PLATES.len()],
    }
}

/// Name of a column with its foot, shortened if it is long.
fn shortened(column: &Column, words: &Words) -> String {
    let name: String = column.name.chars().take(24).collect();
    match column.foot {
        Some(_) => format!("{name} ({})", foot_name(column.foot, words)),
        None => name,
    }
}

/// Maximum length of the name of a lane, characters.
const LANE_NAME: usize = 9;

/// Name of a lane: the foot of the column. If the foot is unknown, the name consists of the first words of the column name, as many as
/// fit.
fn lane_name(column: &Column, words: &Words) -> String {
    if column.foot.is_some() {
        return foot_name(column.foot, words);
    }
    let mut name = String::new();
    for word in column.name.split_whitespace() {
        let longer = format!("{name} {word}");
        if longer.trim().chars().count() > LANE_NAME {
            break;
        }
        name = longer.trim().to_string();
    }
    if name.is_empty() {
        let start: String = column.name.chars().take(LANE_NAME - 1).collect();
        name = format!("{start}…");
    }
    name
}

/// Curve of a column through the minimum and maximum force of each time interval.
fn trace(column: &Column, x: [f64; 2]) -> Curve {
    let n = column.envelope_n.len().max(1) as f64;
    let mut curve = Curve::with_capacity(2 * column.envelope_n.len());
    for (i, [low, high]) in column.envelope_n.iter().enumerate() {
        let at = |part: f64| x[0] + (x[1] - x[0]) * (i as f64 + part) / n;
        // In intervals with increasing force the line starts at the minimum, otherwise at the maximum.
        let rising = column.envelope_n.get(i + 1).is_none_or(|n| n[1] > *high);
        let ends = if rising { [*low, *high] } else { [*high, *low] };
        curve.extend([(at(0.25), ends[0]), (at(0.75), ends[1])]);
    }
    curve
}

/// Draws the lanes with a bar for each contact, and the list of reasons. The bar of a used contact is filled in the colour of its foot.
/// The bar of a rejected contact has a red outline and the number of the reason.
fn draw_lanes(
    f: &Figure,
    frame: Frame,
    understood: &Interpretation,
    shown: &[usize],
    words: &Words,
) -> Drawn {
    let e = f.e;
    let clock = understood.clock;
    let reasons = reasons(understood, words);
    let across = |t: f64| {
        let part = (t - clock.start_s) / clock.duration_s.max(1e-9);
        frame.left + part.clamp(0.0, 1.0) * (frame.right - frame.left)
    };
    let top = frame.bottom + 4.2 * e;
    for (k, &i) in shown.iter().enumerate() {
        let middle = top + (k as f64 + 0.5) * LANE * e;
        let ends = [[frame.left, middle], [frame.right, middle]];
        line(f.canvas, &ends, stroke(QUIET.mix(0.3), 1.0))?;
        let name = lane_name(&understood.columns[i], words);
        let side = Lettering::new(0.8 * e, QUIET).anchored(HPos::Right, VPos::Center);
        f.write(&name, [frame.left - 0.6 * e, middle], side)?;
        for c in understood.contacts.iter().filter(|c| c.column == i) {
            let (from, to) = (across(c.from_s), across(c.to_s).max(across(c.from_s) + 2.0));
            let half = 0.45 * e;
            let corners = [[from, middle - half], [to, middle + half]];
            let Some(reason) = c.rejected else {
                let fill = match c.foot.or(understood.columns[i].foot) {
                    None => own_colour(&understood.columns[i], k),
                    foot => colour(foot),
                };
                rectangle(f.canvas, corners, fill.filled())?;
                continue;
            };
            rectangle(f.canvas, corners, RED.mix(0.22).filled())?;
            rectangle(f.canvas, corners, stroke(RED, 1.2))?;
            let number = reasons.iter().position(|r| r.0 == reason);
            let number = number.map_or_else(String::new, |n| (n + 1).to_string());
            if to - from > 1.2 * e * text_width(&number) {
                let small = Lettering::new(0.78 * e, INK).anchored(HPos::Center, VPos::Center);
                f.write(&number, [0.5 * (from + to), middle], small)?;
            }
        }
    }
    let mut y = top + (shown.len() as f64 * LANE + 1.0) * e;
    for (number, (_, reason_text)) in reasons.iter().enumerate() {
        let text = format!("{}  {reason_text}", number + 1);
        let plain = Lettering::new(0.9 * e, QUIET).anchored(HPos::Left, VPos::Center);
        f.write(&text, [frame.left, y], plain)?;
        y += 1.6 * e;
    }
    Ok(())
}
