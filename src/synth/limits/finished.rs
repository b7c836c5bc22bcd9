//! Input of the checks of every limit, and their tolerances.

use crate::cam::{BarrelGroove, Cam};
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::qp::TOLERANCE;
use crate::synth::report::force::ForceReport;

/// Relative rounding of a limit in the program: twice its tolerance.
pub const SLACK: f64 = 2.0 * TOLERANCE;
/// Relative tolerance of a size found by bisection or as a root, because of rounding.
pub const GEOMETRY: f64 = 1e-8;

/// A finished design for the checks of its limits.
pub struct Finished<'a> {
    /// Problem of the design.
    pub problem: &'a Problem,
    /// The cam to check.
    pub cam: &'a Cam,
    /// The second cam of a conjugate pair, if any.
    pub second: Option<&'a Cam>,
    /// The groove of a barrel.
    pub groove: Option<&'a BarrelGroove>,
    /// The law that determines the force: the cam's own, or that of a polydyne follower's end.
    pub pressing: &'a Law,
    /// Achieved force against the target.
    pub force: &'a ForceReport,
}
