//! Faults of a scene.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Faults of a scene file. Text fields quote the user.
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
    /// An unknown key, with the nearest known one.
    NoSuchKey {
        nearest: Option<String>,
        known: String,
    },
    /// A key that does not apply to this kind of follower.
    NotOfFollower { follower: &'static str },
    /// A key that does not apply to this kind of drive.
    NotOfDrive { drive: &'static str },
    /// A mass for an arm, which needs a moment of inertia.
    MassOfArm,
    /// A value instead of a table.
    NotTable { typed: String, section: String },
    /// Text that is not a hardness with its scale.
    NotHardness { typed: String },
    /// Text that is not a measure of the errors of several walkers.
    NotRobust { typed: String },
    /// Text that is not a range of step frequencies.
    NotFrequencies { typed: String },
    /// A value instead of a list of tables.
    NotList { typed: String, list: String },
    /// A value instead of a text.
    NotText { typed: String },
    /// A value that is neither a text nor a list of texts.
    NotTexts { typed: String },
    /// A value that is neither true nor false.
    NotFlag { typed: String },
    /// A value that is not a whole number in the range.
    NotCount {
        typed: String,
        low: usize,
        high: usize,
    },
    /// A number of spans that is too large for a certified optimum in reasonable time.
    NotSpans {
        typed: String,
        low: usize,
        high: usize,
    },
    /// A value that is not a number with its unit.
    NotQuantity { typed: String, example: String },
    /// An unknown word, with the nearest known one.
    UnknownWord {
        word: String,
        nearest: Option<String>,
        known: String,
    },
    /// A number that must be positive.
    NotPositive { typed: String, example: String },
    /// A number that must not be negative.
    Negative { typed: String, example: String },
    /// A number outside its range.
    Outside {
        typed: String,
        low: Quantity,
        high: Quantity,
    },
    /// A pressure angle of 90° or more.
    NotAcute { typed: String },
    /// A key that the follower needs.
    NeededByFollower {
        follower: &'static str,
        example: String,
    },
    /// A key that the drive needs.
    NeededByDrive {
        drive: &'static str,
        example: String,
    },
    /// A key that every entry of a list needs.
    NeededInEntry { example: String },
    /// A change without an equals sign.
    NoAssignment { typed: String },
    /// A missing entry of a list.
    NoEntry {
        list: String,
        number: String,
        given: usize,
    },
    /// A list without the number of an entry.
    ListWithoutNumber { list: String, given: usize },
    /// A path that leads through a value.
    ValueNotTable { part: String },
    /// Both a recording and a model.
    FileAndModel,
    /// A text that is not a load factor with its phase.
    NotHarmonic { typed: String },
    /// A text of `machine.learned_force` that is not a force with its phase.
    NotLearnedForce { typed: String },
    /// More harmonics of `machine.learned_force` than are supported.
    LearnedForces { given: usize, most: usize },
    /// Load factors that are all zero, or too many of them.
    Harmonics { given: usize, most: usize },
    /// Neither a recording nor a model.
    NoForceNamed,
    /// An empty range of weighted phases.
    NoPhases { from: Quantity, to: Quantity },
    /// Every phase has weight zero.
    NothingWeighed,
    /// The weighted objective `law.weigh`, which was removed.
    WeighRemoved,
    /// A force objective without a force.
    NoForceToFollow,
    /// A weight on the size of a cam whose size is given.
    SizeNotFree,
    /// A spline's degree outside its range.
    SplineDegree { typed: String },
    /// The minimised derivative does not exist for laws of this degree.
    DegreeBelowObjective { degree: usize, order: usize },
    /// A condition that only splines support.
    OnlySplines { family: &'static str },
    /// A programme without segments.
    ProgramWithoutSegments,
    /// A polynomial without points.
    PolynomialWithoutPoints,
    /// No requirement on the law.
    NothingAsked,
    /// An automatic speed without a cycle.
    NoSpeed,
    /// An automatic mass without a force.
    NoMass,
    /// A radius given twice.
    BaseAndPrime,
    /// A radius in addition to a breadth, which determines it.
    RadiusAndBreadth,
    /// A breadth without a programme.
    BreadthWithoutProgram,
    /// A roller as large as the prime circle.
    RollerFillsPrime { roller: String, base: Quantity },
    /// A base circle inside the bore.
    BaseInBore {
        base: String,
        bore: String,
        least: Quantity,
    },
    /// A keyway without a bore.
    KeywayWithoutBore,
    /// A bore for which the standard has no keyway.
    NoKeywayForBore { bore: String },
    /// A width that is not in the standard.
    NoKeywayOfWidth { width: String, widths: String },
    /// A keyway as wide as its bore.
    KeywayTooWide { width: String, bore: String },
    /// An offset as large as the prime radius.
    OffsetReachesPrime { offset: String, prime: String },
    /// A target force for a follower whose lift is not over one turn.
    ForceNeedsTurn { follower: &'static str },
    /// A law over a length that is not a programme.
    LengthNeedsProgram,
    /// A law over several turns that is not a programme.
    TurnsNeedProgram,
    /// An arm under a cam on a moving axis.
    ArmOnMovingAxis,
    /// A conjugate pair with no closure, or with two.
    PairNotClosed,
    /// The stiffness of the follower given twice.
    FrequencyAndStiffness,
    /// A motor has not exactly one torque line.
    MotorLine,
    /// A no-load speed without the stall torque that makes a line of it.
    NoLoadWithoutStall,
    /// The torque of a motor does not fall with its speed.
    MotorCurve,
    /// A motor without the inertia of its shaft.
    MotorWithoutInertia,
    /// A mode of the floor lacks a number.
    FloorLacks { example: String },
    /// One mode of the floor and a list of modes.
    FloorTwice,
    /// Not as many phases as walkers.
    WalkerPhases { count: usize },
    /// Not as many weights as walkers.
    WalkerWeights { count: usize },
    /// A moving floor with a motor or a flexible follower.
    FloorAlone,
    /// A moving floor without a shaker that follows a force.
    FloorNeedsShaker,
    /// A limit on vibration without data of the follower's vibration.
    ResidualWithoutFrequency,
    /// A minimum force that is not below the maximum.
    ForceRange { low: String, high: String },
    /// A polydyne cam of a rigid follower.
    PolydyneWithoutStiffness,
    /// A polydyne cam of a family without four continuous derivatives.
    PolydyneFamily { family: &'static str },
    /// A polydyne cam of too low a degree.
    PolydyneDegree,
    /// A polydyne cam that does not rotate.
    PolydyneOnSlide,
    /// A polydyne cam of constant breadth.
    PolydyneBreadth,
    /// A change of a key without effect.
    NoEffect {
        key: String,
        why: &'static str,
        family: &'static str,
        follower: &'static str,
        drive: &'static str,
    },
    /// An unknown built-in scene, with a similar name.
    NoSuchScene {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
}
