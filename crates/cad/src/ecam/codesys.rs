//! Program text for CODESYS SoftMotion. It defines an `MC_CAM_REF` over an array of `SMC_CAMXYVA`, and contains the block that couples the axes.
//!
//! Source: online help of SM3_Basic (`MC_CAM_REF`, `SMC_CAM_TYPE`, `MC_CamTableSelect`, `MC_CamIn`).

use std::fmt::Write;

use super::literal::{assigned, literal};
use super::replay::Curve;
use super::table::{Node, Table};

pub fn write(table: &Table) -> String {
    let rows: Vec<String> = table.nodes().map(row).collect();
    let (first, last) = (
        &table.segments[0][0],
        &table.segments[table.segments.len() - 1][1],
    );
    let mut out = format!("(* {} *)\n", table.head());
    out += &table.axes();
    let _ = write!(
        out,
        "VAR_GLOBAL\n  gaitcam_points : ARRAY[0..{}] OF SMC_CAMXYVA := [\n    {}\n  ];\n",
        rows.len() - 1,
        rows.join(",\n    ")
    );
    let _ = write!(
        out,
        "  gaitcam_cam : MC_CAM_REF := (byType := SMC_CAM_TYPE.XYVA, nElements := {}, xStart := {}, xEnd := {});\nEND_VAR\n\n",
        rows.len(),
        literal(first.x),
        literal(last.x)
    );
    let periodic = table.periodic();
    out + "FUNCTION_BLOCK gaitcam_follow\nVAR_IN_OUT\n  Master : AXIS_REF_SM3;\n  Slave : AXIS_REF_SM3;\nEND_VAR\n"
        + "VAR_INPUT\n  Execute : BOOL;\nEND_VAR\nVAR\n  Select : MC_CamTableSelect;\n  CamIn : MC_CamIn;\nEND_VAR\n"
        + "gaitcam_cam.pce := ADR(gaitcam_points);\n"
        + &format!(
            "Select(Master := Master, Slave := Slave, CamTable := gaitcam_cam, Execute := Execute, Periodic := {periodic}, \
             MasterAbsolute := TRUE, SlaveAbsolute := TRUE);\n"
        )
        + "CamIn(Master := Master, Slave := Slave, Execute := Select.Done, StartMode := MC_StartMode.absolute, \
           CamTableID := Select.CamTableID);\nEND_FUNCTION_BLOCK\n"
}

fn row(node: Node) -> String {
    let [x, y, v, a] = [node.x, node.y, node.v, node.a].map(literal);
    format!("(dX := {x}, dY := {y}, dV := {v}, dA := {a})")
}

pub fn read(text: &str) -> Option<Curve> {
    let nodes = assigned(text, ["dX", "dY", "dV", "dA"])?;
    Some(Curve::through(&nodes))
}
