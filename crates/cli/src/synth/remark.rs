//! Remarks on the manufacturing files, as sentences.

use serde_json::{Value, json};

use crate::{console::language, console::words, ecam};
use gaitcam::cam::Measures;
use gaitcam::error::Error;
use gaitcam_app::Remark;
use gaitcam_cad::cutter::Gouge;

/// Converts a remark to a sentence, in the units of the follower.
pub fn sentence(remark: &Remark, measures: Measures) -> String {
    match remark {
        Remark::NoSolid(fault) => words::fill("synth-no-solid", &arguments(fault)),
        Remark::NoStep(fault) => words::fill("synth-no-step", &arguments(fault)),
        Remark::Ecam(made) => ecam::sentence(made),
        Remark::NoEcam(fault) => words::fill("synth-no-ecam", &arguments(fault)),
        Remark::NoProgram(fault) => words::fill("synth-no-program", &arguments(fault)),
        Remark::Gouge(gouge) => self::gouge(gouge, measures),
    }
}

fn arguments(fault: &Error) -> Value {
    json!({"fault": fault.sentence(language::current())})
}

fn gouge(gouge: &Gouge, measures: Measures) -> String {
    let place = |at: f64| measures.place(at, language::current());
    match gouge {
        Gouge::Hollow { at, radius } => words::fill(
            "synth-gouge-hollow",
            &json!({"at": place(*at), "radius": words::length(*radius)}),
        ),
        Gouge::Elsewhere { at, damaged, depth } => words::fill(
            "synth-gouge-elsewhere",
            &json!({"at": place(*at), "damaged": place(*damaged), "depth": words::length(*depth)}),
        ),
        Gouge::Undercut { at } => words::fill("synth-gouge-undercut", &json!({"at": place(*at)})),
    }
}
