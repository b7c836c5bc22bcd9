//! `[law]`: family, resolution and exact conditions of the law.

use super::{ErrorMeasure, Gait, Robust};
use crate::law::Rise;

/// Family of functions to which the law belongs.
///
/// ```
/// use gaitcam::scene::Family;
/// use gaitcam::{Scene, scene};
///
/// assert_eq!(Family::DoubleHarmonic.name(), "double-harmonic");
/// // The key `law.family` selects the family.
/// let read: Scene = scene::built_in("footbridge")?.scene()?.with("law.family", "harmonic")?;
/// assert_eq!(read.law.family, Family::Harmonic);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    Default,
    serde::Serialize,
    strum::IntoStaticStr,
    strum::VariantArray,
)]
#[non_exhaustive]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Family {
    /// Harmonics in closed form if they satisfy accuracy and limits, otherwise a spline. This is the default if the scene contains no key that only
    /// one family uses.
    Auto,
    /// A spline: polynomial spans that join with continuous derivatives.
    #[default]
    Spline,
    /// One polynomial through given points, with constant lift outside them.
    Polynomial,
    /// A sum of harmonics and a mean.
    Harmonic,
    /// Rise–fall–dwell with double harmonics. The angles and lifts are variables of the design.
    DoubleHarmonic,
    /// A programme: a sequence of segments with motions of the catalogue.
    Program,
}

impl Family {
    /// All families of laws.
    pub const ALL: &'static [Family] = <Family as strum::VariantArray>::VARIANTS;

    /// Name of the family in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Shaft speed for which a law is designed.
///
/// ```
/// use gaitcam::scene::{LawSpec, ShaftSpeed};
///
/// assert_eq!(LawSpec::default().shaft, ShaftSpeed::Motor);
/// assert_eq!(ShaftSpeed::Constant.name(), "constant");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum ShaftSpeed {
    /// The varying speed of a shaft that the motor drives, if the scene has a motor.
    #[default]
    Motor,
    /// The constant mean speed, even if the scene has a motor.
    Constant,
}

impl ShaftSpeed {
    /// All values, for keys and help texts.
    pub const ALL: &'static [ShaftSpeed] = <ShaftSpeed as strum::VariantArray>::VARIANTS;

    /// Name of the value in a scene file.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Quantity that the design of the law minimises.
///
/// ```
/// use gaitcam::scene::{DriveSpec, LawPoint, LawSpec, Minimise};
/// use gaitcam::Scene;
/// use gaitcam::synth::synthesise;
///
/// // Rise of 10 mm and return with the minimum mean square acceleration.
/// let law = LawSpec {
///     minimise: Some(Minimise::Energy(2)),
///     points: vec![LawPoint::at(0.0, 0.0), LawPoint::at(std::f64::consts::PI, 0.01)],
///     ..LawSpec::default()
/// };
/// let drive = DriveSpec { speed: Some(6.0), ..DriveSpec::moving_axis(1.0) };
/// let design = synthesise(&Scene { law, drive, ..Scene::default() }, None)?;
/// assert!((design.cam.law.svaj(std::f64::consts::PI).s - 0.01).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Minimise {
    /// Mean square difference between force and target force.
    ForceError,
    /// Mean square of the derivative of the lift of this order (2 acceleration, 3 jerk, 4 snap).
    Energy(usize),
    /// Maximum magnitude of the derivative of the lift of this order.
    Peak(usize),
    /// Maximum absolute difference between force and target force.
    PeakForceError,
    /// Size of the cam: radius of the base circle for a flat face, of the prime circle for a roller. Law and size are variables of one program.
    Size,
}

impl Minimise {
    /// All objectives, each with its name in a scene file.
    pub const NAMES: [(&'static str, Minimise); 9] = [
        ("force-error", Minimise::ForceError),
        ("peak-force-error", Minimise::PeakForceError),
        ("acceleration", Minimise::Energy(2)),
        ("jerk", Minimise::Energy(3)),
        ("snap", Minimise::Energy(4)),
        ("peak-acceleration", Minimise::Peak(2)),
        ("peak-jerk", Minimise::Peak(3)),
        ("peak-snap", Minimise::Peak(4)),
        ("size", Minimise::Size),
    ];
}

/// Exact conditions on the law at one cam angle.
///
/// ```
/// use gaitcam::scene::LawPoint;
///
/// let rest = LawPoint { velocity: Some(0.0), ..LawPoint::at(1.0, 0.02) };
/// assert_eq!((rest.angle, rest.lift, rest.velocity), (1.0, Some(0.02), Some(0.0)));
/// assert_eq!(rest.force, None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LawPoint {
    /// Cam angle of the condition, rad.
    pub angle: f64,
    /// Prescribed lift, m (rad for an arm).
    pub lift: Option<f64>,
    /// Prescribed force, N, in place of a lift. The drive must relate lift and force.
    pub force: Option<f64>,
    /// Prescribed velocity ds/dθ, m/rad (rad/rad for an arm).
    pub velocity: Option<f64>,
    /// Prescribed acceleration d²s/dθ², m/rad² (rad/rad² for an arm).
    pub acceleration: Option<f64>,
    /// Prescribed jerk d³s/dθ³, m/rad³ (rad/rad³ for an arm).
    pub jerk: Option<f64>,
}

impl LawPoint {
    /// Condition that prescribes only the lift, m (or rad), at a cam angle, rad.
    #[must_use]
    pub fn at(angle: f64, lift: f64) -> LawPoint {
        LawPoint {
            angle,
            lift: Some(lift),
            ..LawPoint::default()
        }
    }
}

/// Prescribed dwell: a range of cam angles with constant lift.
///
/// ```
/// use gaitcam::scene::{DriveSpec, Dwell, LawPoint, LawSpec, Minimise};
/// use gaitcam::Scene;
/// use gaitcam::synth::synthesise;
///
/// // Dwell on the base circle over the last quarter of the turn.
/// let (from, to) = (1.5 * std::f64::consts::PI, std::f64::consts::TAU);
/// let law = LawSpec {
///     minimise: Some(Minimise::Energy(3)),
///     points: vec![LawPoint::at(2.0, 0.01)],
///     dwells: vec![Dwell { from, to, lift: Some(0.0) }],
///     ..LawSpec::default()
/// };
/// let drive = DriveSpec { speed: Some(6.0), ..DriveSpec::moving_axis(1.0) };
/// let design = synthesise(&Scene { law, drive, ..Scene::default() }, None)?;
/// assert!(design.cam.law.svaj(5.5).s.abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dwell {
    /// Cam angle at the start of the dwell, rad.
    pub from: f64,
    /// Cam angle at the end of the dwell, rad.
    pub to: f64,
    /// Lift in the dwell, m (rad for an arm); `None`: determined by the design.
    pub lift: Option<f64>,
}

/// Segment of a programme, as given in a scene.
///
/// ```
/// use gaitcam::law::Rise;
/// use gaitcam::scene::SegmentSpec;
///
/// let rise = SegmentSpec::new(Rise::Cycloidal, 0.02, 2.0);
/// assert_eq!((rise.lift, rise.angle), (0.02, 2.0));
/// assert_eq!(SegmentSpec::dwell(1.0).motion, Rise::Dwell);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SegmentSpec {
    /// Motion in the segment; [`Rise::Dwell`] for a dwell.
    pub motion: Rise,
    /// Change of lift, m (rad for an arm); negative for a fall.
    pub lift: f64,
    /// Length of the segment: cam angle, rad, or travel, m, for a translating cam.
    pub angle: f64,
}

impl SegmentSpec {
    /// Creates a segment from a motion, a lift (negative for a fall) and a length.
    #[must_use]
    pub fn new(motion: Rise, lift: f64, angle: f64) -> SegmentSpec {
        SegmentSpec {
            motion,
            lift,
            angle,
        }
    }

    /// Creates a dwell of the given length.
    #[must_use]
    pub fn dwell(angle: f64) -> SegmentSpec {
        SegmentSpec::new(Rise::Dwell, 0.0, angle)
    }
}

/// Specification of the law: family, resolution and exact conditions.
///
/// ```
/// use gaitcam::law::Rise;
/// use gaitcam::scene::{Family, LawSpec, SegmentSpec};
///
/// let half = std::f64::consts::PI;
/// let law = LawSpec::program(vec![
///     SegmentSpec::new(Rise::Cycloidal, 0.02, half),
///     SegmentSpec::new(Rise::Cycloidal, -0.02, half),
/// ]);
/// assert_eq!((law.family, law.segments.len()), (Family::Program, 2));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LawSpec {
    /// Family of functions to which the law belongs.
    pub family: Family,
    /// Degree of the spline (`None`: 5, or 7 for a polydyne cam with damping), or of the polynomial (`None`: determined by the points).
    pub degree: Option<usize>,
    /// Number of spans of the spline; `None`: the minimum number that reaches the accuracy.
    pub spans: Option<usize>,
    /// Number of harmonics; `None`: the minimum number that reaches the accuracy.
    pub harmonics: Option<usize>,
    /// Objective of the law; `None`: the force error if there is a target force and no band, otherwise the jerk.
    pub minimise: Option<Minimise>,
    /// Objective over the force errors of several walkers.
    pub robust: Robust,
    /// Measure of the force errors of several walkers.
    pub error: ErrorMeasure,
    /// Whether the law must be monotone between adjacent points.
    pub monotone: bool,
    /// Whether the law prescribes the motion of the mass at the end of a compliant follower (polydyne cam). The lift of the cam then
    /// differs from it.
    pub polydyne: bool,
    /// Shaft speed for which the law is designed.
    pub shaft: ShaftSpeed,
    /// Exact conditions on the law at single cam angles.
    pub points: Vec<LawPoint>,
    /// Prescribed dwells of the law: ranges of cam angles with constant lift.
    pub dwells: Vec<Dwell>,
    /// Segments of a programme, from the start of the law; empty for other families.
    pub segments: Vec<SegmentSpec>,
}

impl LawSpec {
    /// Specification of a family of laws, with default values.
    #[must_use]
    pub fn of(family: Family) -> LawSpec {
        LawSpec {
            family,
            ..LawSpec::default()
        }
    }

    /// Specification of a programme of segments.
    #[must_use]
    pub fn program(segments: Vec<SegmentSpec>) -> LawSpec {
        LawSpec {
            segments,
            ..LawSpec::of(Family::Program)
        }
    }

    /// Default family of the scene. It is a spline if the scene has no target force or contains a key that only splines use. Otherwise it is a sum of
    /// harmonics if their number is given, and the automatic family if not.
    pub fn usual_family(&self, gait: Option<&Gait>) -> Family {
        let follows_a_plain_force = gait.is_some_and(|g| g.band.is_none() && g.weights.is_empty());
        let of_splines = self.degree.is_some()
            || self.spans.is_some()
            || self.monotone
            || self.polydyne
            || matches!(self.minimise, Some(m) if m != Minimise::ForceError)
            || !(self.points.is_empty() && self.dwells.is_empty() && self.segments.is_empty());
        match (follows_a_plain_force && !of_splines, self.harmonics) {
            (true, None) => Family::Auto,
            (true, Some(_)) => Family::Harmonic,
            (false, _) => Family::Spline,
        }
    }
}
