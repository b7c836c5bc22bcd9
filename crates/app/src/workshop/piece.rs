//! Files for CAD and the workshop.

use gaitcam::cam::Wall;
use gaitcam::synth::Design;

/// A file for CAD or the workshop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece {
    /// Outline as a DXF file.
    Dxf,
    /// Outline as an SVG file.
    Svg,
    /// Drawing as a PDF file.
    Sheet,
    /// Plate as an STL mesh.
    Stl,
    /// Plate as a 3MF mesh.
    ThreeMf,
    /// Wall of a groove as STL.
    Wall(Wall),
    /// Solid as a STEP file.
    Step,
    /// Workbook with tables of law and profile.
    Workbook,
    /// Path of a cutter's centre.
    Cutter,
    /// Program for the milling cutter, for the first or the second cam.
    Program(usize),
    /// Program for wire cutting.
    Wire,
    /// Electronic cam, by the index of its dialect.
    Ecam(usize),
}

/// Default radius of the cutter for a path, m: for a barrel the radius of its roller, otherwise 3 mm.
pub fn usual_cutter(design: &Design) -> f64 {
    let roller = design.groove.as_ref().map(|groove| groove.roller_radius());
    roller.unwrap_or(0.003)
}
