//! Kinds of files for CAD and manufacturing.

use gaitcam::cam::Wall;
use gaitcam::synth::Design;

/// Kind of file for CAD or manufacturing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece {
    /// Outline of the cam as a DXF file.
    Dxf,
    /// Outline of the cam as an SVG file.
    Svg,
    /// Workshop drawing as a PDF file.
    Sheet,
    /// Cam as a plate, as an STL mesh.
    Stl,
    /// Cam as a plate, as a 3MF mesh.
    ThreeMf,
    /// One wall of a barrel's groove, as an STL mesh.
    Wall(Wall),
    /// Cam as an exact solid, as a STEP file.
    Step,
    /// Workbook with the tables of law and profile.
    Workbook,
    /// Path of the centre of a milling cutter.
    Cutter,
    /// Program for milling the first cam (0) or the second cam (1).
    Program(usize),
    /// G-code program for wire cutting.
    Wire,
    /// Electronic cam, with the index of its dialect in `Dialect::ALL`.
    Ecam(usize),
}

/// Default radius of the cutter, m: for a barrel the radius of its roller, otherwise 3 mm.
pub fn usual_cutter(design: &Design) -> f64 {
    let roller = design.groove.as_ref().map(|groove| groove.roller_radius());
    roller.unwrap_or(0.003)
}
