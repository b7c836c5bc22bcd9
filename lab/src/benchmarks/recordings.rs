//! Reading of recordings of walking.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use gaitcam::force::{Feet, ReadOptions, cycle, read, stances};

use super::table::Report;
use crate::timing::times;

/// Recording of walking with `rows` rows at 1 kHz: time, left and right force.
fn walk(rows: usize) -> Vec<u8> {
    let foot = |i: usize, lead: usize| {
        let x = ((i + lead) % 1100) as f64 / 680.0;
        let a = PI * x;
        if x < 1.0 {
            700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
        } else {
            0.0
        }
    };
    let mut text = String::from("time,fz_left,fz_right\n");
    for i in 0..rows {
        let (left, right) = (foot(i, 100), foot(i, 650));
        let _ = writeln!(text, "{}.{:03},{left:.3},{right:.3}", i / 1000, i % 1000);
    }
    text.into_bytes()
}

pub(crate) fn recordings(report: &mut Report) {
    let [minutes, hour] = [360_000, 3_600_000].map(|rows| {
        let bytes = walk(rows);
        times(|| {
            let r = read(Path::new("walk.csv"), &bytes, &ReadOptions::default()).expect("a walk");
            cycle(&r, &stances(&r), Feet::Both).expect("a cycle")
        })
    });
    report.time("force", "one hour at 1 kHz read and averaged", 2.0, hour);
    report.at_most(
        "force",
        "fastest time of one hour over six minutes (linear: 10)",
        12.0,
        hour.fastest / minutes.fastest,
    );
}
