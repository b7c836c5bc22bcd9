//! Properties of each limit in the table of limits.

/// Side of the bound on which a value is allowed.
///
/// ```
/// use gaitcam::criterion::{Direction, LimitKind};
///
/// assert_eq!(LimitKind::Curvature.facts().direction, Direction::AtLeast);
/// assert_eq!(Direction::AtLeast.excess(4.0, 5.0), 1.0);
/// assert!(Direction::AtMost.keeps(4.0, 5.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// The value must not exceed the bound; a larger bound permits more.
    AtMost,
    /// The value must not fall below the bound; a smaller bound permits more.
    AtLeast,
}

impl Direction {
    /// Sign of the change of a bound that permits more.
    pub const fn sign(self) -> f64 {
        match self {
            Direction::AtMost => 1.0,
            Direction::AtLeast => -1.0,
        }
    }

    /// Distance of a value beyond a bound; negative if it satisfies the bound.
    pub fn excess(self, value: f64, bound: f64) -> f64 {
        self.sign() * (value - bound)
    }

    /// Whether a value satisfies a bound.
    pub fn keeps(self, value: f64, bound: f64) -> bool {
        match self {
            Direction::AtMost => value <= bound,
            Direction::AtLeast => value >= bound,
        }
    }
}

/// Dependence of a limited quantity on speed and walker, which determines the treatment of a varying shaft speed and of several walkers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DependsOn {
    /// The cam alone: speed and walker do not change it.
    Cam,
    /// A time derivative of the lift of this order, proportional to this power of the speed.
    Motion(usize),
    /// The contact force, linear in the force at rest and in the walker's factor.
    Force,
    /// Force and cam together; no factor relates the machines of two walkers.
    Load,
    /// Vibration of a compliant follower at constant speed, checked for every walker.
    Vibration,
}

impl DependsOn {
    /// Whether a varying shaft speed changes the quantity.
    pub fn varies_with_speed(self) -> bool {
        match self {
            DependsOn::Motion(_) | DependsOn::Force | DependsOn::Load => true,
            DependsOn::Cam | DependsOn::Vibration => false,
        }
    }
}

/// Diagrams over the cam angle.
///
/// ```
/// use gaitcam::criterion::Diagram;
///
/// assert_eq!(Diagram::PressureAngle.name(), "pressure-angle");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Diagram {
    /// Diagram of the contact force.
    Force,
    /// Diagram of the lift.
    Lift,
    /// Diagram of the velocity in time.
    Velocity,
    /// Diagram of the acceleration in time.
    Acceleration,
    /// Diagram of the jerk in time.
    Jerk,
    /// Diagram of the radius of curvature.
    Radius,
    /// Diagram of the pressure angle.
    PressureAngle,
    /// Position of the contact on a flat face.
    Contact,
    /// Diagram of the shaft torque.
    Torque,
    /// Diagram of the shaft power.
    Power,
    /// Diagram of the shaft speed.
    Speed,
}

impl Diagram {
    /// Name of the diagram in data.
    pub const fn name(self) -> &'static str {
        match self {
            Diagram::Force => "force",
            Diagram::Lift => "s",
            Diagram::Velocity => "v",
            Diagram::Acceleration => "a",
            Diagram::Jerk => "j",
            Diagram::Radius => "radius",
            Diagram::PressureAngle => "pressure-angle",
            Diagram::Contact => "contact",
            Diagram::Torque => "torque",
            Diagram::Power => "power",
            Diagram::Speed => "speed",
        }
    }
}

/// Lines of a bound in a diagram.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lines {
    /// A line at the bound.
    AtBound,
    /// Lines at the bound and at its negative.
    BothSides,
    /// A line at the negative of the bound.
    AtNegative,
    /// A line at this height above the lowest point of the curve.
    AboveLowest,
}

impl Lines {
    /// Heights of the lines of a bound on a curve with this lowest value.
    pub fn heights(self, bound: f64, lowest: f64) -> Vec<f64> {
        match self {
            Lines::AtBound => vec![bound],
            Lines::BothSides => vec![bound, -bound],
            Lines::AtNegative => vec![-bound],
            Lines::AboveLowest => vec![lowest + bound],
        }
    }

    /// Height from which the bound is measured up or down to its line; `None` if the line itself is the bound.
    pub fn origin(self, lowest: f64) -> Option<f64> {
        match self {
            Lines::AtBound => None,
            Lines::BothSides | Lines::AtNegative => Some(0.0),
            Lines::AboveLowest => Some(lowest),
        }
    }
}

/// Rank of a failed check among the reasons of a verdict, the most serious first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The profile cannot be manufactured.
    Profile,
    /// The follower interferes with another part of the cam.
    Interference,
    /// The follower leaves the cam.
    Contact,
    /// The follower may jam in its guide.
    PressureAngle,
    /// The force is not the required one.
    ForceError,
    /// A limit of the scene is violated.
    Limit,
}

/// Properties of one limit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LimitFacts {
    /// Side of the bound on which the value is allowed.
    pub direction: Direction,
    /// Dependence of the value on speed and walker.
    pub depends_on: DependsOn,
    /// Whether changing the bound on the end of a compliant follower brings the cam nearer to its own bound.
    pub moves_with_end: bool,
    /// Diagram that shows the value, and the lines of its bound.
    pub diagram: Option<(Diagram, Lines)>,
    /// Rank of its failed check.
    pub severity: Severity,
}

impl LimitFacts {
    pub(super) const fn row(
        direction: Direction,
        depends_on: DependsOn,
        moves_with_end: bool,
        diagram: Option<(Diagram, Lines)>,
        severity: Severity,
    ) -> LimitFacts {
        LimitFacts {
            direction,
            depends_on,
            moves_with_end,
            diagram,
            severity,
        }
    }
}
