//! What the checks of every limit look at, and how exactly they hold.

use crate::cam::{BarrelGroove, Cam};
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::qp::TOLERANCE;
use crate::synth::report::force::ForceReport;

/// Relative rounding of a limit that the program holds: twice its own tolerance.
pub const SLACK: f64 = 2.0 * TOLERANCE;
/// A sized quantity (prime circle by bisection or root) may miss its limit by this part: rounding of the
/// geometry, not of the law.
pub const GEOMETRY: f64 = 1e-8;

/// A finished design, as its limits are checked.
pub struct Finished<'a> {
    /// What was asked.
    pub problem: &'a Problem,
    /// The cam.
    pub cam: &'a Cam,
    /// The second cam of a conjugate pair.
    pub second: Option<&'a Cam>,
    /// The groove of a barrel.
    pub groove: Option<&'a BarrelGroove>,
    /// The law that makes the force: the cam's own, or that of a polydyne follower's end.
    pub pressing: &'a Law,
    /// Achieved force against the target.
    pub force: &'a ForceReport,
}
