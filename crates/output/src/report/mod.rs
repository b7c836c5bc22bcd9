//! `report.html`: the design on one page. The page needs no network connection and can be printed on A4.

mod animation;
mod figures;
pub mod laws;
mod motion;
pub mod parts;
mod run;
pub mod sweep;
mod tables;
mod workshop;

pub use tables::ActiveLimit;

use std::fmt::Write;

use crate::Timing;
use crate::facts::{self, error_percent, label};
use crate::words::{self, Words};
use gaitcam::cam::{Measures, Verdict};
use gaitcam::dynamics::Outcome;
use gaitcam::scene::ErrorMeasure;
use gaitcam::synth::{Conflicting, Design, Figure, Figures, in_units};
use gaitcam::wording::{Language, walker};
use gaitcam_base::text::escaped;

const STYLE: &str = include_str!("page.css");
/// Script module that computes the positions of the moving parts of the animation. The report and the studio use this module.
pub const MOTION_SCRIPT: &str = include_str!("motion.js");
const SCRIPT: &str = include_str!("page.js");

/// Report of a design: verdict, force, law, animated cam, checks, numbers, solution. For an infeasible design, the report contains the
/// conflict and the suggested changes, without figures.
pub fn html(synthesis: &Design, time: Timing, language: Language) -> String {
    page(synthesis, time, None, language)
}

/// Simulation that is shown in a report.
#[derive(Debug, Clone, Copy)]
pub struct Running<'a> {
    /// Results of the simulation.
    pub outcome: &'a Outcome,
    /// Angle by which a second, equal cam is behind the first cam on the shaft, rad; `None` without a second cam.
    pub second_cam: Option<f64>,
}

/// Report of a design with the results of a simulation. The animation shows the simulated motion.
pub fn html_of_run(
    synthesis: &Design,
    time: Timing,
    running: &Running,
    language: Language,
) -> String {
    page(synthesis, time, Some(running), language)
}

fn page(synthesis: &Design, time: Timing, running: Option<&Running>, language: Language) -> String {
    let words = words::words(language);
    let mut out = String::with_capacity(1 << 18);
    let title = words.fill("report-title", &[("name", &synthesis.problem.name)]);
    head(&mut out, &title, &words);
    headline(&mut out, synthesis, &words);
    if synthesis.infeasible.is_some() {
        conflict(&mut out, synthesis, &words);
    } else {
        cards(&mut out, &cards_of(synthesis, &words));
        match running {
            Some(running) => run::section(&mut out, synthesis, running, &words),
            None => {
                out.push_str("<div class=\"turning\">\n");
                heading(&mut out, &words.text("report-animation"));
                animation::stage(&mut out, synthesis, None, &words);
                out.push_str("</div>\n");
            }
        }
        figures::section(&mut out, synthesis, &words);
    }
    tables::checks(&mut out, synthesis, &words);
    if synthesis.infeasible.is_none() {
        tables::active(&mut out, synthesis, &words);
        tables::numbers(&mut out, synthesis, &words);
        workshop::section(&mut out, synthesis, &words);
    }
    tables::solution(&mut out, synthesis, time, &words);
    let footer = match synthesis.cam.follower.measures() {
        Measures::Straight => "report-footer-straight",
        _ => "report-footer",
    };
    let footer = words::with_length_unit(&words, footer);
    // Writing to a String cannot fail, here and below.
    let _ = writeln!(out, "</main>\n<footer>{}</footer>", escaped(&footer));
    if synthesis.infeasible.is_none() {
        let _ = write!(
            out,
            "<script type=\"module\">\n{MOTION_SCRIPT}\n{SCRIPT}</script>\n"
        );
    }
    out.push_str("</body>\n</html>\n");
    out
}

/// Writes the head of the page and opens its body.
fn head(out: &mut String, title: &str, words: &Words) {
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n",
        words.tag(),
        escaped(title)
    );
}

fn heading(out: &mut String, text: &str) {
    let _ = writeln!(out, "<h2>{}</h2>", escaped(text));
}

fn paragraph(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p>{}</p>", escaped(text));
}

/// Writes the coloured mark of the verdict, the name, the verdict and its reason.
fn headline(out: &mut String, synthesis: &Design, words: &Words) {
    let (light, verdict) = match (&synthesis.infeasible, synthesis.verdict) {
        (Some(_), _) => ("bad", "report-infeasible"),
        (None, Verdict::Acceptable) => ("good", "report-acceptable"),
        (None, Verdict::NotForHighSpeed) => ("fair", "report-not-for-high-speed"),
        (None, Verdict::Unacceptable) => ("bad", "report-unacceptable"),
    };
    let reason = match &synthesis.infeasible {
        Some(answer) => answer.sentence(words.language()),
        None => synthesis.reason(words.language()),
    };
    let _ = writeln!(
        out,
        "<header><div class=\"light {light}\"></div><div><h1>{}</h1>\n\
         <p><span class=\"verdict {light}\">{}.</span> {}</p></div></header>\n<main>",
        escaped(&synthesis.problem.name),
        escaped(&words.text(verdict)),
        escaped(&reason)
    );
}

/// Writes the conflicting limits and the suggested changes.
fn conflict(out: &mut String, synthesis: &Design, words: &Words) {
    let Some(answer) = &synthesis.infeasible else {
        return;
    };
    let _ = write!(
        out,
        "<div class=\"alert\">\n<h2>{}</h2>\n<ul>\n",
        escaped(&words.text("report-conflict"))
    );
    for member in &answer.conflict {
        let member = match member {
            Conflicting::Limit(limit) => words.name(limit.name()),
            Conflicting::Demand(_) => member.sentence(words.language()),
        };
        let _ = writeln!(out, "<li>{}</li>", escaped(&member));
    }
    let measures = synthesis.cam.follower.measures();
    let helps = answer.relaxations.iter().any(|r| r.to.is_some());
    let head = words.text(if helps {
        "report-relaxations"
    } else {
        "report-no-relaxation"
    });
    let _ = write!(out, "</ul>\n<h2>{}</h2>\n<ul>\n", escaped(&head));
    for r in &answer.relaxations {
        let name = words.name(r.limit.name());
        let exact = |x: f64| in_units(measures, r.limit, x, words.language());
        let from = exact(r.from);
        let _ = match r.to {
            Some(to) => {
                let to = exact(to);
                let change = words.fill("report-relaxation", &[("from", &from)]);
                let (name, change) = (escaped(&name), escaped(&change));
                writeln!(out, "<li>{name}: {change} <strong>{to}</strong></li>")
            }
            None => {
                let arguments = [("limit", name.as_str()), ("from", &from)];
                let text = words.fill("report-not-alone", &arguments);
                writeln!(out, "<li class=\"note\">{}</li>", escaped(&text))
            }
        };
    }
    out.push_str("</ul>\n</div>\n");
}

/// Key figure of a report: name, value with unit, remark.
pub type Card = (String, String, String);

/// Copy of `text` with a capital first letter.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

fn cards(out: &mut String, all: &[Card]) {
    out.push_str("<dl class=\"cards\">\n");
    for (name, value, more) in all {
        let [name, value, more] = [name, value, more].map(|t| escaped(t));
        let _ = writeln!(
            out,
            "<div><dt>{name}</dt><dd>{value}<small>{more}</small></dd></div>"
        );
    }
    out.push_str("</dl>\n");
}

fn cards_of(synthesis: &Design, words: &Words) -> Vec<Card> {
    let cam = &synthesis.cam;
    let measures = cam.follower.measures();
    let language = words.language();
    let mut all = force_cards(synthesis, words);
    let figures = Figures::of(synthesis);
    let shown = |column: &str| -> (String, String) {
        let text = |f: &Figure| f.text(f.value(&figures), measures, language);
        let text = Figure::of_column(column).map_or(String::new(), text);
        (label(synthesis, column, words), text)
    };
    let mut put = |column: &str, more: String| {
        let (name, value) = shown(column);
        all.push((capital(&name), value, more));
    };
    put("stroke_m", String::new());
    let has_prime = cam.follower.roller_radius() > 0.0 && !cam.follower.is_unrolled();
    let prime = has_prime.then(|| shown("prime_radius_m"));
    let prime = prime.map_or(String::new(), |(name, value)| format!("{name} {value}"));
    put("base_radius_m", prime);
    let place = measures.place(cam.curvature().convex.at, language);
    put("rho_min_m", words.fill("report-at", &[("place", &place)]));
    let speed = synthesis.problem.drive.speed;
    let own = measures.speed().shown(speed, language);
    let (value, more) = match measures {
        Measures::Straight => (own, String::new()),
        _ => {
            let rpm = words.number(speed * 30.0 / std::f64::consts::PI);
            (format!("{rpm} rpm"), own)
        }
    };
    let name = capital(&label(synthesis, "speed_rad_per_s", words));
    all.push((name, value, more));
    all
}

/// Force error, % of the mean force, below which the error is a rounding error.
const EXACT: f64 = 1e-4;

fn force_cards(synthesis: &Design, words: &Words) -> Vec<Card> {
    let force = &synthesis.force;
    let measures = synthesis.cam.follower.measures();
    let unit = measures.force().name;
    let mut cards = Vec::new();
    let population = synthesis.population.as_ref().filter(|p| p.cycles > 1);
    if let Some(all) = population {
        let measure = synthesis.problem.law.error;
        let [mean, worst] = match measure {
            ErrorMeasure::Relative => {
                [all.mean_percent, all.worst_percent].map(|x| format!("{}\u{a0}%", words.number(x)))
            }
            ErrorMeasure::Absolute => {
                [all.mean_n, all.worst_n].map(|x| format!("{}\u{a0}{unit}", words.number(x)))
            }
        };
        let worst_walker = walker(words.language(), &all.worst_walker);
        let who = [("walker", worst_walker.as_str()), ("mean", &mean)];
        cards.push((
            words.text("report-force-error-worst"),
            worst,
            words.fill("report-worst-walker", &who),
        ));
    } else if synthesis.target().is_some() {
        let column = "force_rms_error_n";
        let name = capital(&label(synthesis, column, words));
        let (value, more) = if force.rms_error_percent_of_mean < EXACT {
            (words.text("report-exact"), String::new())
        } else {
            let percent = error_percent(synthesis, words.language());
            let value = facts::force(synthesis, column, force.rms_error_n, words.language());
            (
                value,
                words.fill("report-of-mean", &[("percent", &percent)]),
            )
        };
        cards.push((name, value, more));
    }
    if !synthesis.is_idle() {
        let name = match measures {
            Measures::Oscillating => "report-moment",
            _ => "report-force",
        };
        let mean = format!("{}\u{a0}{unit}", words.number(force.mean_n));
        cards.push((
            words.text(name),
            format!("{}\u{a0}{unit}", words.range(force.min_n, force.max_n)),
            words.fill("report-mean", &[("value", &mean)]),
        ));
    }
    cards
}
