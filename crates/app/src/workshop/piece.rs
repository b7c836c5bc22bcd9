//! Files for CAD and the workshop.

use gaitcam::cam::Wall;
use gaitcam::synth::Design;

/// A file for CAD or the workshop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece {
    /// Outline as DXF.
    Dxf,
    /// Outline as SVG.
    Svg,
    /// Drawing as PDF.
    Sheet,
    /// The plate as STL.
    Stl,
    /// The plate as 3MF.
    ThreeMf,
    /// A wall of a groove as STL.
    Wall(Wall),
    /// Solid as STEP.
    Step,
    /// Workbook.
    Workbook,
    /// Path of a cutter.
    Cutter,
    /// Program for that cutter, of the first or the second cam.
    Program(usize),
    /// Program for a wire.
    Wire,
    /// Electronic cam, by the place of its dialect in their list.
    Ecam(usize),
}

/// Radius of the cutter that a path is made for unless the user gives another, m: that of a barrel's roller, otherwise
/// 3 mm.
pub fn usual_cutter(design: &Design) -> f64 {
    let roller = design.groove.as_ref().map(|groove| groove.roller_radius());
    roller.unwrap_or(0.003)
}
