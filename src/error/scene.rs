//! Errors in a scene.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Errors in a scene file. Fields named `typed` contain the text that the user typed.
///
/// ```
/// use gaitcam::error::SceneError;
/// use gaitcam::scene;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let error = scene.with("limits.strok", "40 mm").unwrap_err();
/// let Some(SceneError::NoSuchKey { nearest, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(nearest.as_deref(), Some("stroke"));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum SceneError {
    /// The text is not TOML.
    NotToml { line: usize, fault: String },
    /// The name is not valid for an output folder.
    OutputName { typed: String },
    /// A key is unknown. The error contains the most similar key and all known keys.
    NoSuchKey {
        nearest: Option<String>,
        known: String,
    },
    /// A key does not apply to this kind of follower.
    NotOfFollower { follower: &'static str },
    /// A key does not apply to this kind of drive.
    NotOfDrive { drive: &'static str },
    /// An arm has a mass instead of a moment of inertia.
    MassOfArm,
    /// A key that requires a table has a single value.
    NotTable { typed: String, section: String },
    /// The text is not a hardness with its scale.
    NotHardness { typed: String },
    /// The text is not a measure of the errors of several walkers.
    NotRobust { typed: String },
    /// The text is not a range of step frequencies.
    NotFrequencies { typed: String },
    /// A key that requires a list of tables has another value.
    NotList { typed: String, list: String },
    /// A key that requires a text has another value.
    NotText { typed: String },
    /// The value is neither a text nor a list of texts.
    NotTexts { typed: String },
    /// The value is neither true nor false.
    NotFlag { typed: String },
    /// The value is not a whole number in the range.
    NotCount {
        typed: String,
        low: usize,
        high: usize,
    },
    /// The number of spans is too large for a certified optimum in reasonable time.
    NotSpans {
        typed: String,
        low: usize,
        high: usize,
    },
    /// The value is not a number with its unit.
    NotQuantity { typed: String, example: String },
    /// A word is unknown. The error contains the most similar word and all known words.
    UnknownWord {
        word: String,
        nearest: Option<String>,
        known: String,
    },
    /// The number is not positive.
    NotPositive { typed: String, example: String },
    /// The number is negative.
    Negative { typed: String, example: String },
    /// The number is outside its range.
    Outside {
        typed: String,
        low: Quantity,
        high: Quantity,
    },
    /// The pressure angle is 90° or more.
    NotAcute { typed: String },
    /// A key that the follower requires is missing.
    NeededByFollower {
        follower: &'static str,
        example: String,
    },
    /// A key that the drive requires is missing.
    NeededByDrive {
        drive: &'static str,
        example: String,
    },
    /// A key that every entry of a list requires is missing.
    NeededInEntry { example: String },
    /// A change (`--set`) has no equals sign.
    NoAssignment { typed: String },
    /// An entry of a list does not exist.
    NoEntry {
        list: String,
        number: String,
        given: usize,
    },
    /// A path to an entry of a list lacks the number of the entry.
    ListWithoutNumber { list: String, given: usize },
    /// A path continues below a value that is not a table.
    ValueNotTable { part: String },
    /// Both a recording and a model are given.
    FileAndModel,
    /// The text is not a load factor with its phase.
    NotHarmonic { typed: String },
    /// The text of `machine.learned_force` is not a force with its phase.
    NotLearnedForce { typed: String },
    /// There are more harmonics of `machine.learned_force` than supported.
    LearnedForces { given: usize, most: usize },
    /// All load factors are zero, or there are too many of them.
    Harmonics { given: usize, most: usize },
    /// Neither a recording nor a model is given.
    NoForceNamed,
    /// The range of a phase weight is empty or lies outside the cycle.
    NoPhases { from: Quantity, to: Quantity },
    /// Every phase has weight zero.
    NothingWeighed,
    /// The scene uses the weighted objective `law.weigh`, which is no longer supported.
    WeighRemoved,
    /// The objective refers to a force, but the scene has no force.
    NoForceToFollow,
    /// The objective is the size of the cam, but the size of this kind of cam is not optimised together with the law.
    SizeNotFree,
    /// The degree of a spline is outside its range.
    SplineDegree { typed: String },
    /// The minimised derivative is zero between the knots for laws of this degree.
    DegreeBelowObjective { degree: usize, order: usize },
    /// A key is given that only splines support.
    OnlySplines { family: &'static str },
    /// A programme has no segments.
    ProgramWithoutSegments,
    /// A polynomial law has fewer than two points.
    PolynomialWithoutPoints,
    /// The scene gives no target force, no points and no segments for the law.
    NothingAsked,
    /// The speed is automatic, but the scene has no force cycle.
    NoSpeed,
    /// The mass is automatic, but the scene has no force.
    NoMass,
    /// Both base radius and prime radius are given.
    BaseAndPrime,
    /// A radius is given together with a breadth, although the breadth determines the radius.
    RadiusAndBreadth,
    /// A breadth is given without a programme.
    BreadthWithoutProgram,
    /// The radius of the roller is not smaller than the prime radius.
    RollerFillsPrime { roller: String, base: Quantity },
    /// The base circle is inside the bore.
    BaseInBore {
        base: String,
        bore: String,
        least: Quantity,
    },
    /// A keyway is given without a bore.
    KeywayWithoutBore,
    /// The standard has no keyway for this bore.
    NoKeywayForBore { bore: String },
    /// The standard has no keyway of this width.
    NoKeywayOfWidth { width: String, widths: String },
    /// The keyway is not narrower than its bore.
    KeywayTooWide { width: String, bore: String },
    /// The offset is not smaller than the prime radius.
    OffsetReachesPrime { offset: String, prime: String },
    /// A target force is given for a follower whose law is not over one turn.
    ForceNeedsTurn { follower: &'static str },
    /// A law over a length of travel is not given as a programme, which is required.
    LengthNeedsProgram,
    /// The law extends over several turns, but is not given as a programme.
    TurnsNeedProgram,
    /// A follower on an arm is combined with a cam on a moving axis.
    ArmOnMovingAxis,
    /// A conjugate pair has no dimension that locates the second cam, or two such dimensions.
    PairNotClosed,
    /// Both natural frequency and stiffness of the follower are given.
    FrequencyAndStiffness,
    /// A motor has no torque line, or more than one.
    MotorLine,
    /// A no-load speed is given without the stall torque that completes the torque line.
    NoLoadWithoutStall,
    /// A unit is given for points in the Fusion format, which always uses centimetres.
    PointsOfFusion,
    /// A nameplate lacks the rated torque or the rated speed.
    HalfNameplate,
    /// The synchronous speed is not above the rated speed.
    NotSynchronous,
    /// The torque of a motor does not decrease with its speed.
    MotorCurve,
    /// A motor is given without the inertia of its shaft.
    MotorWithoutInertia,
    /// A mode of the floor lacks its mass, frequency or damping ratio.
    FloorLacks { example: String },
    /// Both a single mode of the floor and a list of modes are given.
    FloorTwice,
    /// The number of phases differs from the number of walkers.
    WalkerPhases { count: usize },
    /// The number of weights differs from the number of walkers.
    WalkerWeights { count: usize },
    /// A moving floor is combined with a motor or a flexible follower, which is not supported.
    FloorAlone,
    /// A moving floor requires a shaker with a target force.
    FloorNeedsShaker,
    /// A limit on vibration is given without data on the vibration of the follower.
    ResidualWithoutFrequency,
    /// The minimum force is not below the maximum force.
    ForceRange { low: String, high: String },
    /// A polydyne cam is requested for a rigid follower.
    PolydyneWithoutStiffness,
    /// A polydyne cam is requested with a family that lacks four continuous derivatives.
    PolydyneFamily { family: &'static str },
    /// The spline degree is too low for a polydyne cam.
    PolydyneDegree,
    /// A polydyne cam is requested for a cam that does not rotate.
    PolydyneOnSlide,
    /// A polydyne cam is combined with constant breadth.
    PolydyneBreadth,
    /// A key that the user changed has no effect in this scene.
    NoEffect {
        key: String,
        why: &'static str,
        family: &'static str,
        follower: &'static str,
        drive: &'static str,
    },
    /// The name of a built-in scene is unknown. The error contains the most similar name and all known names.
    NoSuchScene {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
}
