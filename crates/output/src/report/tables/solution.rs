//! Section of the report on the solution: solver, certificate, notes.

use std::fmt::Write;

use super::note;
use crate::Timing;
use crate::report::{capital, heading, paragraph};
use crate::words::Words;
use gaitcam::synth::{Design, Tier};
use gaitcam_base::text::escaped;

/// Writes the solver, the computing time, the certificate and the notes of a design.
pub fn solution(out: &mut String, synthesis: &Design, time: Timing, words: &Words) {
    let solver = &synthesis.solver;
    let how = match solver.tier {
        Tier::Spectral => "report-spectral",
        Tier::Equality => "report-equality",
        Tier::Qp => "report-qp",
        Tier::Socp => "report-socp",
        Tier::Scp => "report-scp",
    };
    let built = synthesis.infeasible.is_none();
    let head = match built {
        true => "report-solution",
        false => "report-attempt",
    };
    heading(out, &words.text(head));
    let spent = format!("{} ms", words.number(1000.0 * time.solve_s));
    let arguments = [
        ("how", &*words.text(how)),
        ("time", &spent),
        ("iterations", &solver.iterations.to_string()),
    ];
    let mut text = words.fill("report-solved", &arguments);
    text += &sentence(&solver.status(words.language()));
    if built {
        text.push(' ');
        text += &words.text("report-verified");
        text.push(' ');
        text += &match solver.doubt {
            Some(doubt) => {
                let why = doubt.sentence(words.language());
                words.fill("report-uncertified", &[("why", why.as_str())])
            }
            None if solver.certificate.is_some() => words.text("report-certified"),
            None => String::new(),
        };
    }
    paragraph(out, &text);
    if let Some(c) = &solver.certificate {
        let [gap, stationarity, violation] =
            [c.relative_gap, c.stationarity, c.violation].map(|x| match x {
                0.0 => "0".to_string(),
                x => words.decimal(format!("{x:.1e}")),
            });
        let arguments = [
            ("gap", gap.as_str()),
            ("stationarity", &stationarity),
            ("violation", &violation),
        ];
        note(out, &words.fill("report-certificate", &arguments));
    }
    if !synthesis.notes.is_empty() {
        let head = escaped(&words.text("report-remarks"));
        let _ = write!(out, "<h3>{head}</h3>\n<ul>\n");
        for remark in synthesis.remarks(words.language()) {
            let _ = writeln!(out, "<li>{}</li>", escaped(&remark));
        }
        out.push_str("</ul>\n");
    }
}

/// A solver status as a sentence with a capital letter and a full stop; empty if the status is empty.
fn sentence(status: &str) -> String {
    match status.trim().trim_end_matches('.') {
        "" => String::new(),
        status => format!(" {}.", capital(status)),
    }
}
