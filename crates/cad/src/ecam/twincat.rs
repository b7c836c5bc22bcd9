//! TwinCAT: an array of `MC_MotionFunctionPoint` (Beckhoff Information System, TF5050: `MC_MotionFunctionPoint`, `MC_MotionFunctionType`) for
//! `MC_CamTableSelect` with `MC_TABLETYPE_MOTIONFUNCTION`.

use std::fmt::Write;

use super::literal::{assigned, literal};
use super::replay::Curve;
use super::table::Table;

pub fn write(table: &Table) -> String {
    let count = table.segments.len() + 1;
    let mut out = format!("(* {} *)\n", table.head());
    let _ = writeln!(
        out,
        "VAR_GLOBAL\n  gaitcam_points : ARRAY[1..{count}] OF MC_MotionFunctionPoint := ["
    );
    for (i, node) in table.nodes().enumerate() {
        let [x, y, v, a] = [node.x, node.y, node.v, node.a].map(literal);
        let end = if i + 1 < count { "," } else { "" };
        let _ = writeln!(
            out,
            "    (PointIndex := {}, FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM, PointType := MOTIONPOINTTYPE_MOTION, \
             RelIndexNextPoint := 1, MasterPos := {x}, SlavePos := {y}, SlaveVelo := {v}, SlaveAcc := {a}){end}",
            i + 1
        );
    }
    out + "  ];\nEND_VAR\n"
}

pub fn read(text: &str) -> Option<Curve> {
    let nodes = assigned(text, ["MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc"])?;
    Some(Curve::through(&nodes))
}
