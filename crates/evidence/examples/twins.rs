//! Writes reports/twins.md: `cargo run --release -p gaitcam-evidence --example twins` (about ten processor minutes).

use std::path::Path;

use gaitcam_evidence::twins::Class;
use gaitcam_evidence::twins::report::{CUTS, INTERVALS, errors, parameters, write};
use rayon::prelude::*;

fn main() -> Result<(), gaitcam::error::Error> {
    let cut: Result<Vec<_>, _> = CUTS.into_par_iter().map(errors).collect();
    let classes = [Class::Model, Class::TwoHarmonics, Class::Whole];
    let all = classes.map(|class| (0..INTERVALS).map(move |i| (class, i)));
    let all: Vec<(Class, u64)> = all.into_iter().flatten().collect();
    let found = all
        .into_par_iter()
        .map(|(class, i)| Ok((class, parameters(class, i)?)));
    let found: Result<Vec<_>, gaitcam::error::Error> = found.collect();
    write(Path::new("reports"), &cut?, &found?)
}
