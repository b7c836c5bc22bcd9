//! Program text for Logix: a `CAM` array, and its `MCCP` instruction with start and end slopes.
//!
//! Source: Rockwell, MOTION-RM002 (`CAM` data type, `MCCP`).

use std::fmt::Write;

use super::literal::{assigned, literal};
use super::replay::Curve;
use super::table::Table;

pub fn write(table: &Table) -> String {
    let count = table.segments.len() + 1;
    let (first, last) = (
        &table.segments[0][0],
        &table.segments[table.segments.len() - 1][1],
    );
    let mut out = format!("(* {} *)\n", table.head());
    let _ = writeln!(
        out,
        "(* Tags: gaitcam_cam CAM[{count}], gaitcam_profile CAM_PROFILE[{count}], gaitcam_mccp MOTION_INSTRUCTION *)"
    );
    for (i, node) in table.nodes().enumerate() {
        let [x, y] = [node.x, node.y].map(literal);
        let _ = writeln!(
            out,
            "gaitcam_cam[{i}].Master := {x}; gaitcam_cam[{i}].Slave := {y}; gaitcam_cam[{i}].SegmentType := 1;"
        );
    }
    let [start, end] = [first.v, last.v].map(literal);
    let _ = writeln!(out, "(* StartSlope := {start}; EndSlope := {end}; *)");
    let _ = writeln!(
        out,
        "MCCP(gaitcam_mccp, gaitcam_cam[0], {count}, {start}, {end}, gaitcam_profile[0]);"
    );
    out
}

pub fn read(text: &str) -> Option<Curve> {
    let points = assigned(text, ["].Master", "].Slave"])?;
    let slopes = assigned(text, ["StartSlope", "EndSlope"])?;
    Some(Curve::Points {
        points,
        slopes: Some(*slopes.first()?),
    })
}
