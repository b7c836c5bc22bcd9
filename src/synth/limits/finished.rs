//! Input of the checks of all limits, and their tolerances.

use crate::cam::{BarrelGroove, Cam};
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::qp::TOLERANCE;
use crate::synth::report::force::ForceReport;

/// Relative rounding of a limit in the program: twice its tolerance.
pub const SLACK: f64 = 2.0 * TOLERANCE;
/// Relative tolerance of a size found by bisection or as a root, because of rounding errors.
pub const GEOMETRY: f64 = 1e-8;

/// A finished design for the checks of its limits.
pub struct Finished<'a> {
    /// Problem of the design.
    pub problem: &'a Problem,
    /// Cam to check.
    pub cam: &'a Cam,
    /// Second cam of a conjugate pair, if any.
    pub second: Option<&'a Cam>,
    /// Groove of a barrel.
    pub groove: Option<&'a BarrelGroove>,
    /// Law that determines the force: that of the cam, or that of the end of a polydyne follower.
    pub pressing: &'a Law,
    /// Force of the cam compared with the target.
    pub force: &'a ForceReport,
}
