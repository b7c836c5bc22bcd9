//! Solids as STL and 3MF: the cam as a plate with its bore, or the walls of a barrel's groove.

mod plate;
mod stl;
mod threemf;
mod wall;

use gaitcam::error::Result;
use gaitcam::synth::Design;

pub use plate::{Plate, plate};
pub use stl::file as binary_stl;
pub use wall::wall;

/// Triangle mesh, mm. The vertices of a triangle are counter-clockwise when seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Coordinates x, y, z of the vertices, mm.
    pub vertices: Vec<[f64; 3]>,
    /// Indices of the three vertices of each triangle.
    pub triangles: Vec<[usize; 3]>,
}

/// The plate as binary STL, mm.
///
/// # Errors
///
/// The errors of [`plate`].
pub fn stl(design: &Design, form: Plate) -> Result<Vec<u8>> {
    stl::file(&plate(design, form)?)
}

/// The plate as 3MF, mm.
///
/// # Errors
///
/// The errors of [`plate`].
pub fn threemf(design: &Design, form: Plate) -> Result<Vec<u8>> {
    threemf::package(&plate(design, form)?, &design.problem.name)
}
