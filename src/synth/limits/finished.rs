//! Finished design as the input of the checks of all limits, and the tolerances of these checks.

use crate::cam::{BarrelGroove, Cam};
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::qp::TOLERANCE;
use crate::synth::report::force::ForceReport;

/// Relative tolerance of the check of a limit that the program enforces: twice the tolerance of the program.
pub const SLACK: f64 = 2.0 * TOLERANCE;
/// Relative tolerance for the rounding errors of a size that was computed by bisection or as a root.
pub const GEOMETRY: f64 = 1e-8;

/// A finished design whose limits are checked.
pub struct Finished<'a> {
    /// Problem of the design.
    pub problem: &'a Problem,
    /// Cam whose limits are checked.
    pub cam: &'a Cam,
    /// Second cam of a conjugate pair, if any.
    pub second: Option<&'a Cam>,
    /// Groove of a barrel cam; `None` for other cams.
    pub groove: Option<&'a BarrelGroove>,
    /// Law that determines the force: the law of the cam, or for a polydyne cam the law of the follower's end.
    pub pressing: &'a Law,
    /// Force of the cam compared with the target.
    pub force: &'a ForceReport,
}
