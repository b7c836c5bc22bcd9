//! `report.html`: the design on one page that opens without a network, and prints on A4.

mod animation;
mod motion;
mod run;
pub mod sweep;
mod tables;

use std::fmt::Write;

use crate::Timing;
use crate::escape::escaped;
use crate::figures::cam::cam_in;
use crate::figures::curvature::geometry_in;
use crate::figures::force::{force_frame, force_in};
use crate::figures::law::svaj_in;
use crate::number::{number, range};
use crate::plot::axes::Frame;
use crate::plot::layout::Layout;
use crate::plot::picture::Picture;
use gaitcam::cam::{Follower, Measures, Verdict};
use gaitcam::dynamics::Outcome;
use gaitcam::synth::Synthesis;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The report of a design: verdict, force, law, cam in motion, checks, numbers, how it was solved.
///
/// An infeasible answer gets the conflict and the changes that would resolve it, and no pictures of a cam
/// that does not do what was asked.
pub fn html(synthesis: &Synthesis, time: Timing) -> String {
    page(synthesis, time, None)
}

/// What is shown of a run.
#[derive(Debug, Clone, Copy)]
pub struct Running<'a> {
    /// What the run found.
    pub outcome: &'a Outcome,
    /// Angle by which a second, equal cam follows on the shaft, rad.
    pub second_cam: Option<f64>,
}

/// The report of a design that was run: the cam moves as it did in the run.
pub fn html_of_run(synthesis: &Synthesis, time: Timing, running: &Running) -> String {
    page(synthesis, time, Some(running))
}

fn page(synthesis: &Synthesis, time: Timing, running: Option<&Running>) -> String {
    let mut out = String::with_capacity(1 << 18);
    let name = escaped(&synthesis.name);
    // Writing to a String cannot fail, here and below.
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{name}: cam report</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n"
    );
    headline(&mut out, synthesis);
    if synthesis.infeasible.is_some() {
        conflict(&mut out, synthesis);
    } else {
        cards(&mut out, synthesis);
        match running {
            Some(running) => run::section(&mut out, synthesis, running),
            None => {
                out.push_str("<div class=\"turning\">\n<h2>The cam at work</h2>\n");
                animation::stage(&mut out, synthesis, None);
                out.push_str("</div>\n");
            }
        }
        figures(&mut out, synthesis);
    }
    tables::checks(&mut out, synthesis);
    if synthesis.infeasible.is_none() {
        tables::binding(&mut out, synthesis);
        tables::numbers(&mut out, synthesis);
    }
    tables::solution(&mut out, synthesis, time);
    out.push_str("<footer>Lengths in millimetres, angles in degrees, ");
    out.push_str(match synthesis.cam.follower.measures() {
        Measures::Straight => "the travel counted from the start of the cam's pass.",
        _ => "θ counted counter-clockwise from the start of the cycle.",
    });
    out.push_str(" Extremes are those of the continuous law, not of samples.</footer>\n");
    if synthesis.infeasible.is_none() {
        let _ = write!(out, "<script>\n{SCRIPT}</script>\n");
    }
    out.push_str("</body>\n</html>\n");
    out
}

/// Traffic light, name, verdict and its reason.
fn headline(out: &mut String, synthesis: &Synthesis) {
    let (light, verdict) = match (&synthesis.infeasible, synthesis.verdict) {
        (Some(_), _) => ("bad", "No such cam"),
        (None, Verdict::Acceptable) => ("good", "Acceptable"),
        (None, Verdict::NotForHighSpeed) => ("fair", "Not for high speed"),
        (None, Verdict::Unacceptable) => ("bad", "Unacceptable"),
    };
    let reason = match &synthesis.infeasible {
        Some(answer) => answer.words(),
        None => synthesis.reason(),
    };
    let _ = writeln!(
        out,
        "<header><div class=\"light {light}\"></div><div><h1>{}</h1>\n\
         <p><span class=\"verdict {light}\">{verdict}.</span> {}</p></div></header>",
        escaped(&synthesis.name),
        escaped(&reason)
    );
}

/// The limits that cannot hold together and what would resolve it.
fn conflict(out: &mut String, synthesis: &Synthesis) {
    let Some(answer) = &synthesis.infeasible else {
        return;
    };
    out.push_str("<div class=\"alert\">\n<h3>These limits cannot hold together</h3>\n<ul>\n");
    for limit in &answer.conflict {
        let _ = writeln!(out, "<li>{}</li>", escaped(&tables::spoken(limit)));
    }
    out.push_str("</ul>\n");
    let measures = synthesis.cam.follower.measures();
    let helps = answer.relaxations.iter().any(|r| r.to.is_some());
    out.push_str(if helps {
        "<h3>Any one of these changes is enough</h3>\n<ul>\n"
    } else {
        "<h3>No change of a single limit is enough</h3>\n<ul>\n"
    });
    for r in &answer.relaxations {
        let name = escaped(&tables::spoken(&r.limit));
        let from = tables::shown(measures, &r.limit, r.from);
        let _ = match r.to {
            Some(to) => {
                let to = tables::shown(measures, &r.limit, to);
                writeln!(out, "<li>{name}: from {from} to <strong>{to}</strong></li>")
            }
            None => writeln!(
                out,
                "<li class=\"note\">{name}, now {from}: no value of it alone helps</li>"
            ),
        };
    }
    out.push_str("</ul>\n");
    out.push_str("</div>\n");
}

/// The figures one looks for first.
fn cards(out: &mut String, synthesis: &Synthesis) {
    let cam = &synthesis.cam;
    let force = &synthesis.force;
    let measures = cam.follower.measures();
    let pressing = measures.force().name;
    let mut all = Vec::new();
    if synthesis.target.is_some() {
        let percent = number(force.rms_error_percent_of_mean, 3);
        let rms = format!("{} N", number(force.rms_error_n, 3));
        all.push(("Force error, RMS", rms, format!("{percent} % of the mean")));
    }
    if !synthesis.is_idle() {
        let name = match measures {
            Measures::Oscillating => "Moment",
            _ => "Force",
        };
        let range = range(force.min_n, force.max_n, 4);
        all.push((
            name,
            format!("{range}\u{a0}{pressing}"),
            format!("mean {} {pressing}", number(force.mean_n, 4)),
        ));
    }
    let lift = measures.lift(0);
    let stroke = lift.after(&number(lift.factor * cam.law.stroke(), 4));
    all.push(("Stroke", stroke, String::new()));
    let mm = |x: f64| format!("{} mm", number(1000.0 * x, 4));
    let roller = cam.follower.roller_radius();
    let prime = if roller > 0.0 && !cam.follower.is_unrolled() {
        format!("prime circle R {}", mm(cam.follower.prime_radius()))
    } else {
        String::new()
    };
    let base = match cam.follower {
        Follower::TranslatingCam { .. } => ("Base height", ""),
        Follower::Barrel { .. } => ("Barrel", "R "),
        _ => ("Base circle", "R "),
    };
    let radius = mm(cam.follower.base_radius());
    all.push((base.0, format!("{}{radius}", base.1), prime));
    let sharpest = cam.curvature().convex;
    let at = format!("at {}", measures.place(sharpest.at, 1));
    all.push(("Smallest radius", mm(sharpest.value), at));
    let speed = synthesis.drive.speed;
    let own = measures.speed().after(&number(speed, 4));
    all.push(match measures {
        Measures::Straight => ("Speed", own, String::new()),
        _ => {
            let rpm = format!("{} rpm", number(speed * 30.0 / std::f64::consts::PI, 4));
            ("Speed", rpm, own)
        }
    });
    out.push_str("<dl class=\"cards\">\n");
    for (name, value, more) in all {
        let _ = writeln!(
            out,
            "<div><dt>{name}</dt><dd>{value}<small>{more}</small></dd></div>"
        );
    }
    out.push_str("</dl>\n");
}

/// The diagrams.
fn figures(out: &mut String, synthesis: &Synthesis) {
    out.push_str(match synthesis.cam.follower.measures() {
        Measures::Oscillating => "<h2>Moment on the arm</h2>\n",
        _ => "<h2>Force</h2>\n",
    });
    comparison(out, synthesis);
    if synthesis.is_idle() {
        out.push_str(
            "<p>The scene gives the drive no mass, spring or preload, so nothing presses. \
             Drawn is what one unit of moved mass would press with.</p>\n",
        );
    }
    let tall = Layout::figure(500);
    figure(
        out,
        force_frame(tall),
        "force",
        "Wanted and achieved force over the cam angle",
        &force_in(synthesis, tall),
    );
    out.push_str("<h2>Law of motion</h2>\n");
    let taller = Layout::figure(660);
    figure(
        out,
        taller.frame(),
        "svaj",
        "Lift, velocity, acceleration and jerk over the cam angle",
        &svaj_in(synthesis, taller),
    );
    out.push_str("<h2>The cam</h2>\n");
    let cam = Layout::figure(540);
    let drawing = cam_in(synthesis, cam).svg_for_page("cam", "The cam with its follower", "");
    let _ = writeln!(out, "<figure>{drawing}</figure>");
    out.push_str("<h2>Curvature and contact</h2>\n");
    let low = Layout::figure(430);
    figure(
        out,
        low.frame(),
        "geometry",
        "Radius of curvature and contact over the cam angle",
        &geometry_in(synthesis, low),
    );
}

fn figure(out: &mut String, frame: Frame, id: &str, title: &str, picture: &Picture) {
    let data = format!(
        " data-left=\"{}\" data-right=\"{}\" data-top=\"{}\" data-bottom=\"{}\"",
        frame.left, frame.right, frame.top, frame.bottom
    );
    let _ = writeln!(
        out,
        "<figure>{}</figure>",
        picture.svg_for_page(id, title, &data)
    );
}

/// The synthesis error in words, beside the walker's own variation where that is known.
fn comparison(out: &mut String, synthesis: &Synthesis) {
    let Some(target) = &synthesis.target else {
        return;
    };
    let force = &synthesis.force;
    let _ = write!(
        out,
        "<p>Wanted: {}. The cam misses it by {} N RMS and {} N at most.",
        escaped(&target.name),
        number(force.rms_error_n, 3),
        number(force.max_error_n, 3)
    );
    if let Some(spread) = target.spread_n.as_ref().filter(|s| !s.is_empty()) {
        let squares: f64 = spread.iter().map(|x| x * x).sum();
        let spread = (squares / spread.len() as f64).sqrt();
        let _ = write!(
            out,
            " From step to step the walker’s own force varies by {} N (RMS of the standard deviation)",
            number(spread, 3)
        );
        if force.rms_error_n > 0.0 && spread > force.rms_error_n {
            let ratio = number(spread / force.rms_error_n, 2);
            let _ = write!(out, ", {ratio} times the error of the cam");
        }
        out.push('.');
    }
    out.push_str("</p>\n");
}
