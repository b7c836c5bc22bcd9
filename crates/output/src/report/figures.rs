//! Diagrams of the report, with text descriptions for readers who cannot see them.

use std::fmt::Write;

use super::{heading, paragraph, tables};
use crate::facts::{self, force as force_text, label};
use crate::figures::cam::cam_in;
use crate::figures::curvature::geometry_in;
use crate::figures::force::{force_frame, force_in};
use crate::figures::law::svaj_in;
use crate::figures::recording::{figure_layout, recording_in};
use crate::figures::resonance::resonance_in;
use crate::plot::layout::Layout;
use crate::plot::picture::Picture;
use crate::plot::sheet::Frame;
use crate::words::Words;
use gaitcam::cam::Measures;
use gaitcam::synth::Design;
use gaitcam::wording::{Language, fixed};
use gaitcam_base::text::escaped;

/// Writes the sections of the report that contain diagrams.
pub fn section(out: &mut String, synthesis: &Design, words: &Words) {
    force(out, synthesis, words);
    recording(out, synthesis, words);
    resonance(out, synthesis, words);
    let taller = Layout::figure(660);
    heading(out, &words.text("report-law-section"));
    let alt = law_words(synthesis, words);
    let picture = svaj_in(synthesis, taller, words);
    figure(out, "svaj", Some(taller.frame()), &alt, &picture, words);
    heading(out, &words.text("report-cam-section"));
    let picture = cam_in(synthesis, Layout::figure(540), words);
    let alt = cam_words(synthesis, words);
    figure(out, "cam", None, &alt, &picture, words);
    heading(out, &words.text("report-curvature-section"));
    let low = Layout::figure(430);
    let sharpest = synthesis.cam.curvature().convex;
    let place = synthesis
        .cam
        .follower
        .measures()
        .place(sharpest.at, words.language());
    let radius = words.length(sharpest.value);
    let arguments = [("radius", &*radius), ("place", &place)];
    let alt = words.fill("report-alt-curvature", &arguments);
    let picture = geometry_in(synthesis, low, words);
    figure(out, "geometry", Some(low.frame()), &alt, &picture, words);
}

/// Writes a figure that can be scrolled horizontally on a narrow page. If `frame` is given, the script marks the current cam angle in the
/// figure.
pub fn figure(
    out: &mut String,
    id: &str,
    frame: Option<Frame>,
    alt: &str,
    picture: &Picture,
    words: &Words,
) {
    let data = frame.map_or(String::new(), |f| {
        format!(
            " data-left=\"{}\" data-right=\"{}\" data-top=\"{}\" data-bottom=\"{}\"",
            f.left, f.right, f.top, f.bottom
        )
    });
    framed(out, &picture.svg_for_page(id, alt, &data), words);
}

/// Writes a figure that can be scrolled horizontally, from an SVG element.
pub fn framed(out: &mut String, drawing: &str, words: &Words) {
    let _ = writeln!(
        out,
        "<figure><figcaption class=\"cue\">{}</figcaption><div class=\"wide\" tabindex=\"0\">{drawing}</div></figure>",
        escaped(&words.text("report-scroll"))
    );
}

fn force(out: &mut String, synthesis: &Design, words: &Words) {
    let swings = synthesis.cam.follower.measures() == Measures::Oscillating;
    let (head, idle) = match swings {
        true => ("report-moment-section", "report-idle-moment"),
        false => ("report-force-section", "report-idle-force"),
    };
    heading(out, &words.text(head));
    comparison(out, synthesis, words);
    if synthesis.is_idle() {
        paragraph(out, &words.text(idle));
    }
    let tall = Layout::figure(500);
    let picture = force_in(synthesis, tall, words);
    let alt = force_words(synthesis, words);
    figure(out, "force", Some(force_frame(tall)), &alt, &picture, words);
}

/// Writes the figure of the recording from which the target was computed, with all contacts.
fn recording(out: &mut String, synthesis: &Design, words: &Words) {
    let target = synthesis.target();
    let Some(understood) = target.and_then(|t| t.recording.as_ref()) else {
        return;
    };
    heading(out, &words.text("report-recording-section"));
    let (used, rejected) = understood.counts();
    let arguments = [
        ("file", understood.file.as_str()),
        ("used", &used.to_string()),
        ("rejected", &rejected.to_string()),
    ];
    let alt = words.fill("report-alt-recording", &arguments);
    let picture = recording_in(understood, None, figure_layout(understood, words), words);
    figure(out, "recording", None, &alt, &picture, words);
}

/// Writes the responses at resonance to the recorded walk and to the cam: sentence, picture and table.
fn resonance(out: &mut String, synthesis: &Design, words: &Words) {
    let Some((sentence, walker)) =
        facts::resonance(synthesis, words.language()).zip(synthesis.walker())
    else {
        return;
    };
    heading(out, &words.text("report-resonance-section"));
    paragraph(out, &sentence);
    let picture = resonance_in(synthesis, Layout::figure(430), words);
    figure(out, "resonance", None, &sentence, &picture, words);
    let (columns, rows) = facts::at_resonance(&walker, words.language());
    tables::open(out, &columns, 1);
    for [damping, cells @ ..] in &rows {
        tables::row(out, damping);
        tables::cells(out, cells);
    }
    tables::close(out);
    let (strides, frequency) = (
        walker.strides.to_string(),
        words.number(walker.step_frequency_hz),
    );
    let arguments = [("strides", &*strides), ("frequency", &frequency)];
    paragraph(out, &words.fill("report-resonance-note", &arguments));
}

fn force_words(synthesis: &Design, words: &Words) -> String {
    let force = &synthesis.force;
    let unit = synthesis.cam.follower.measures().force().name;
    let shown = |x: f64| format!("{} {unit}", words.number(x));
    let (low, high) = (shown(force.min_n), shown(force.max_n));
    let ends = [("low", low.as_str()), ("high", &high)];
    if synthesis.target().is_none() {
        return words.fill("report-alt-force-alone", &ends);
    }
    let rms = force_text(
        synthesis,
        "force_rms_error_n",
        force.rms_error_n,
        words.language(),
    );
    words.fill("report-alt-force", &[ends[0], ends[1], ("rms", &rms)])
}

fn law_words(synthesis: &Design, words: &Words) -> String {
    let law = &synthesis.cam.law;
    let measures = synthesis.cam.follower.measures();
    let lift = measures.lift(0);
    let stroke = lift.shown(law.stroke(), words.language());
    let unit = measures.lift(2);
    let (low, high) = law.extremes(2);
    let ends = words.range(unit.factor * low.value, unit.factor * high.value);
    let acceleration = unit.after(&ends);
    words.fill(
        "report-alt-law",
        &[("stroke", &stroke), ("acceleration", &acceleration)],
    )
}

fn cam_words(synthesis: &Design, words: &Words) -> String {
    let cam = &synthesis.cam;
    let name = label(synthesis, "base_radius_m", words);
    let base = format!("{name} {}", words.length(cam.follower.base_radius()));
    let radius = words.length(cam.curvature().convex.value);
    words.fill("report-alt-cam", &[("base", &base), ("radius", &radius)])
}

/// Writes the force error and, if known, the step-to-step variation of the recording.
fn comparison(out: &mut String, synthesis: &Design, words: &Words) {
    let Some(target) = synthesis.target() else {
        return;
    };
    let unit = synthesis.cam.follower.measures().force().name;
    let shown = |x: f64| format!("{} {unit}", words.number(x));
    let force = &synthesis.force;
    let error = |column: &str, value: f64| force_text(synthesis, column, value, words.language());
    let rms = error("force_rms_error_n", force.rms_error_n);
    let most = error("force_max_error_n", force.max_error_n);
    let name = name_in(&target.name, words.language());
    let arguments = [("name", name.as_str()), ("rms", &rms), ("most", &most)];
    let mut text = words.fill("report-target", &arguments);
    if let Some(spread) = target.spread_n.as_ref().filter(|s| !s.is_empty()) {
        let squares: f64 = spread.iter().map(|x| x * x).sum();
        let spread = (squares / spread.len() as f64).sqrt();
        let (amount, ratio) = (shown(spread), words.number(spread / force.rms_error_n));
        let arguments = [("spread", amount.as_str()), ("ratio", &ratio)];
        text.push(' ');
        text += &if force.rms_error_n > 0.0 && spread > force.rms_error_n {
            words.fill("report-variability-ratio", &arguments)
        } else {
            words.fill("report-variability", &arguments[..1])
        };
    }
    paragraph(out, &text);
}

/// Name of a force in which numbers have the decimal sign of the language. The names of load models contain numbers.
fn name_in(name: &str, language: Language) -> String {
    let in_language = |word: &str| {
        let plain = word.trim_end_matches(',');
        match (plain.parse(), plain.split_once('.')) {
            (Ok(value), Some((_, part))) => {
                fixed(language, value, part.len()) + &word[plain.len()..]
            }
            _ => word.to_string(),
        }
    };
    let words: Vec<String> = name.split(' ').map(in_language).collect();
    words.join(" ")
}
