//! Text above the figure of a recording: kind of movement, stride time, mass, counts of contacts, warnings.

use plotters_backend::text_anchor::{HPos, VPos};

use crate::plot::layout::Figure;
use crate::plot::palette::{INK, QUIET, RED};
use crate::plot::sheet::{Drawn, Frame, Lettering};
use crate::plot::text::wrapped;
use crate::words::Words;
use gaitcam::force::{Interpretation, Note};
use gaitcam::wording::{catalogue, sentence};

/// Maximum number of warnings in the figure. The report and the JSON contain all of them.
const WARNINGS: usize = 3;
/// Maximum number of lines of one warning.
const LINES: usize = 2;

/// Writes the facts at the top of the frame. Returns the vertical position below the text.
pub(super) fn write_facts(
    f: &Figure,
    understood: &Interpretation,
    frame: Frame,
    words: &Words,
) -> Drawn<f64> {
    let e = f.e;
    let room = (frame.right - frame.left) / e;
    let mut y = frame.top;
    let text = |line: &str, colour, y: f64| {
        let lettering = Lettering::new(e, colour).anchored(HPos::Left, VPos::Top);
        f.write(line, [frame.left, y], lettering)
    };
    for line in shortened(facts(understood, words).iter().map(String::as_str), room, 3) {
        text(&line, INK, y)?;
        y += 1.5 * e;
    }
    for note in worst(understood) {
        let line = sentence(words.language(), "note", note);
        let colour = if note.doubt().is_some() { RED } else { QUIET };
        for line in shortened(line.split(' '), room, LINES) {
            text(&line, colour, y)?;
            y += 1.5 * e;
        }
    }
    let more = understood.warnings.len().saturating_sub(WARNINGS);
    if more > 0 {
        let line = words.fill("figure-more-notes", &[("count", &more.to_string())]);
        text(&line, QUIET, y)?;
        y += 1.5 * e;
    }
    Ok(y + 0.6 * e)
}

/// Notes that are displayed. Open questions are first. At most [`WARNINGS`] notes are returned.
fn worst(understood: &Interpretation) -> Vec<&Note> {
    let mut all: Vec<&Note> = understood.warnings.iter().collect();
    all.sort_by_key(|n| n.doubt().is_none());
    all.truncate(WARNINGS);
    all
}

/// Facts about a recording: kind of movement, stride time and mass with their sources, and numbers of used and rejected contacts.
fn facts(understood: &Interpretation, words: &Words) -> Vec<String> {
    let library = catalogue(words.language());
    let name = |typed: &str| library.name(typed);
    let mut parts = Vec::new();
    if let Some(kind) = understood.kind {
        parts.push(library.sentence("kind", &kind));
    }
    if let Some(period) = understood.period {
        let seconds = words.fixed(period.seconds, 3);
        let from = name(period.from.name());
        parts.push(match period.spread_s {
            Some(spread) => words.fill(
                "figure-stride-spread",
                &[
                    ("seconds", seconds.as_str()),
                    ("spread", &words.fixed(spread, 3)),
                    ("from", &from),
                ],
            ),
            None => words.fill("figure-stride", &[("seconds", &seconds), ("from", &from)]),
        });
    }
    if let Some((kg, from)) = understood.mass {
        let from = library.sentence("mass-from", &from);
        let mass = words.fixed(kg, 1);
        parts.push(words.fill("figure-mass", &[("mass", &mass), ("from", &from)]));
    }
    let (used, rejected) = understood.counts();
    parts.push(words.fill(
        "figure-contacts",
        &[
            ("used", &used.to_string()),
            ("rejected", &rejected.to_string()),
        ],
    ));
    let last = parts.len() - 1;
    for part in &mut parts[..last] {
        part.push_str(" ·");
    }
    parts
}

/// Lines of at most `room` em with the texts `parts`, which are not broken. If there are more than `most` lines, an ellipsis replaces the
/// further lines.
fn shortened<'a>(parts: impl Iterator<Item = &'a str>, room: f64, most: usize) -> Vec<String> {
    let mut lines = wrapped(parts, room);
    if lines.len() > most {
        lines.truncate(most);
        lines[most - 1].push_str(" …");
    }
    lines
}
