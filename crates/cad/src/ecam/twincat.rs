//! Program text for TwinCAT: an array of `MC_MotionFunctionPoint`, and the block that couples the axes.
//!
//! Source: Beckhoff Information System, TF5050 (`MC_MotionFunctionPoint`, `MC_MotionFunctionType`, `MC_CAM_REF`, `MC_CamTableSelect`, `MC_CamIn`).

use std::fmt::Write;

use super::literal::{assigned, literal};
use super::replay::Curve;
use super::table::Table;

pub fn write(table: &Table) -> String {
    let count = table.segments.len() + 1;
    let mut out = format!("(* {} *)\n", table.head());
    out += &table.axes();
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
    let periodic = table.periodic();
    out += "  ];\n";
    let _ = write!(
        out,
        "  gaitcam_cam : MC_CAM_REF := (TableType := MC_TABLETYPE_MOTIONFUNCTION, NoOfRows := {count}, NoOfColumns := 1);\nEND_VAR\n\n"
    );
    out += "FUNCTION_BLOCK gaitcam_follow\nVAR_IN_OUT\n  Master : AXIS_REF;\n  Slave : AXIS_REF;\nEND_VAR\n";
    out += "VAR_INPUT\n  Execute : BOOL;\nEND_VAR\nVAR\n  Select : MC_CamTableSelect;\n  CamIn : MC_CamIn;\nEND_VAR\n";
    out += "gaitcam_cam.pArray := ADR(gaitcam_points);\ngaitcam_cam.ArraySize := SIZEOF(gaitcam_points);\n";
    let _ = writeln!(
        out,
        "Select(Master := Master, Slave := Slave, CamTable := gaitcam_cam, Execute := Execute, Periodic := {periodic}, \
         MasterAbsolute := TRUE, SlaveAbsolute := TRUE, CamTableID := 1);"
    );
    out + "CamIn(Master := Master, Slave := Slave, CamTable := gaitcam_cam, Execute := Select.Done, MasterScaling := 1.0, \
           SlaveScaling := 1.0, StartMode := MC_STARTMODE_ABSOLUTE, CamTableID := 1);\nEND_FUNCTION_BLOCK\n"
}

pub fn read(text: &str) -> Option<Curve> {
    let nodes = assigned(text, ["MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc"])?;
    Some(Curve::through(&nodes))
}
