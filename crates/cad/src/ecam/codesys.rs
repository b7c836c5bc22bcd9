//! CODESYS SoftMotion: an `MC_CAM_REF` with an array of `SMC_CAMXYVA` (online help of SM3_Basic: `MC_CAM_REF`, `SMC_CAM_TYPE`).

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
    out += "(* Once: gaitcam_cam.pce := ADR(gaitcam_points); then MC_CamTableSelect and MC_CamIn, slave absolute. *)\n";
    let _ = write!(
        out,
        "VAR_GLOBAL\n  gaitcam_points : ARRAY[0..{}] OF SMC_CAMXYVA := [\n    {}\n  ];\n",
        rows.len() - 1,
        rows.join(",\n    ")
    );
    let _ = write!(
        out,
        "  gaitcam_cam : MC_CAM_REF := (byType := SMC_CAM_TYPE.XYVA, nElements := {}, xStart := {}, xEnd := {});\nEND_VAR\n",
        rows.len(),
        literal(first.x),
        literal(last.x)
    );
    out
}

fn row(node: Node) -> String {
    let [x, y, v, a] = [node.x, node.y, node.v, node.a].map(literal);
    format!("(dX := {x}, dY := {y}, dV := {v}, dA := {a})")
}

pub fn read(text: &str) -> Option<Curve> {
    let nodes = assigned(text, ["dX", "dY", "dV", "dA"])?;
    Some(Curve::through(&nodes))
}
