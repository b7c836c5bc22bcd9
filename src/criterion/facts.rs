//! Types for the properties of a limit: direction, dependence on speed and walker, diagram, severity.

/// Side of the bound on which values are permitted.
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
    /// The value must not exceed the bound. A larger bound is less strict.
    AtMost,
    /// The value must not fall below the bound. A smaller bound is less strict.
    AtLeast,
}

impl Direction {
    /// +1 if a larger bound is less strict, −1 if a smaller bound is less strict.
    pub const fn sign(self) -> f64 {
        match self {
            Direction::AtMost => 1.0,
            Direction::AtLeast => -1.0,
        }
    }

    /// Amount by which a value violates a bound, in the unit of the value; negative or zero if the bound is satisfied.
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

/// Dependence of a limited quantity on shaft speed and walker. It determines how the limit is applied with a varying shaft speed or several
/// walkers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DependsOn {
    /// The quantity depends on the cam only, not on speed or walker.
    Cam,
    /// The quantity is the nth time derivative of the lift, where n is the value of this variant. It is proportional to the nth power of
    /// the speed.
    Motion(usize),
    /// The contact force. It is linear in the force at rest and in the factor β of the walker (theory §8).
    Force,
    /// The quantity depends on both the force and the cam. The ratio of its values for two walkers varies with the cam angle.
    Load,
    /// The vibration of a compliant follower at constant speed. It is checked for every walker.
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
    /// Contact force between cam and follower.
    Force,
    /// Lift of the follower.
    Lift,
    /// First derivative of the lift with respect to time.
    Velocity,
    /// Second derivative of the lift with respect to time.
    Acceleration,
    /// Third derivative of the lift with respect to time.
    Jerk,
    /// Radius of curvature of the profile.
    Radius,
    /// Pressure angle, with its sign.
    PressureAngle,
    /// Position of the contact on a flat face.
    Contact,
    /// Torque of the shaft without friction.
    Torque,
    /// Power of the shaft, positive for driving and negative for braking.
    Power,
    /// Speed of the shaft, which varies over the turn if a motor drives the shaft.
    Speed,
}

impl Diagram {
    /// Name of the diagram in data files.
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

/// Lines that represent a bound in a diagram.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lines {
    /// A line at the bound.
    AtBound,
    /// Lines at the bound and at its negative.
    BothSides,
    /// A line at the negative of the bound.
    AtNegative,
    /// A line above the minimum of the curve, at the distance of the bound.
    AboveLowest,
}

impl Lines {
    /// Ordinates of the lines that represent a bound in a diagram. `lowest` is the minimum of the curve.
    pub fn heights(self, bound: f64, lowest: f64) -> Vec<f64> {
        match self {
            Lines::AtBound => vec![bound],
            Lines::BothSides => vec![bound, -bound],
            Lines::AtNegative => vec![-bound],
            Lines::AboveLowest => vec![lowest + bound],
        }
    }

    /// Ordinate from which the bound is measured: zero, or the minimum of the curve. `None` if the line is at the bound itself.
    pub fn origin(self, lowest: f64) -> Option<f64> {
        match self {
            Lines::AtBound => None,
            Lines::BothSides | Lines::AtNegative => Some(0.0),
            Lines::AboveLowest => Some(lowest),
        }
    }
}

/// Severity of a failed check. The reasons for a verdict are in this order, the most severe first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The profile cannot be manufactured.
    Profile,
    /// The follower interferes with the cam away from the contact.
    Interference,
    /// The follower lifts off the cam.
    Contact,
    /// The follower may jam in its guide.
    PressureAngle,
    /// The force error exceeds its limit.
    ForceError,
    /// A limit of the scene is violated.
    Limit,
}

/// Properties of one limit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LimitFacts {
    /// Side of the bound on which values are permitted.
    pub direction: Direction,
    /// Dependence of the quantity on speed and walker.
    pub depends_on: DependsOn,
    /// Applies to polydyne cams: whether changing this limit for the follower's end can bring the value of the cam to its bound.
    pub moves_with_end: bool,
    /// Diagram that shows the quantity, and the lines that represent its bound; `None` without a diagram.
    pub diagram: Option<(Diagram, Lines)>,
    /// Severity of a failed check of the limit.
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
