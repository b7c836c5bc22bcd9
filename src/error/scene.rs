//! What may be wrong with a scene.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// What is wrong with a scene file. Texts in fields are as the user typed them.
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
    /// The text is no TOML.
    NotToml { line: usize, fault: String },
    /// The name cannot be that of an output folder.
    OutputName { typed: String },
    /// An unknown key, and the one that may be meant.
    NoSuchKey {
        nearest: Option<String>,
        known: String,
    },
    /// A key that this kind of follower does not have.
    NotOfFollower { follower: &'static str },
    /// A key that this kind of drive does not have.
    NotOfDrive { drive: &'static str },
    /// An arm has a moment of inertia instead.
    MassOfArm,
    /// A value where a table should be.
    NotTable { typed: String, section: String },
    /// No hardness with its scale.
    NotHardness { typed: String },
    /// A length of the hub without its diameter.
    HubWithoutDiameter,
    /// A hub that does not surround the hole for the shaft.
    HubInBore { hub: String, hole: Quantity },
    /// Something else where a list of tables should be.
    NotList { typed: String, list: String },
    /// No text.
    NotText { typed: String },
    /// Neither a text nor a list of texts.
    NotTexts { typed: String },
    /// Neither true nor false.
    NotFlag { typed: String },
    /// No whole number in the range.
    NotCount {
        typed: String,
        low: usize,
        high: usize,
    },
    /// No number of spans whose optimum is certified in reasonable time.
    NotSpans {
        typed: String,
        low: usize,
        high: usize,
    },
    /// No number with its unit.
    NotQuantity { typed: String, example: String },
    /// A word that names nothing, and the one that may be meant.
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
    /// An entry of a list that is not there.
    NoEntry {
        list: String,
        number: String,
        given: usize,
    },
    /// A list where one entry should be named.
    ListWithoutNumber { list: String, given: usize },
    /// A path that leads through a value.
    ValueNotTable { part: String },
    /// Both a recording and a model.
    FileAndModel,
    /// Neither a recording nor a model.
    NoForceNamed,
    /// A range of weighted phases that is none.
    NoPhases { from: Quantity, to: Quantity },
    /// No phase of the cycle counts.
    NothingWeighed,
    /// Weights of the objective without a weight.
    EmptyWeigh,
    /// An objective given twice.
    MinimiseAndWeigh,
    /// An objective about a force that is not there.
    NoForceToFollow,
    /// A weight of the size of a cam whose size is given.
    SizeNotFree,
    /// A spline's degree outside its range.
    SplineDegree { typed: String },
    /// A demand that only splines take.
    OnlySplines { family: &'static str },
    /// A programme without segments.
    ProgramWithoutSegments,
    /// A polynomial without points.
    PolynomialWithoutPoints,
    /// Nothing is asked of the law.
    NothingAsked,
    /// An automatic speed without a cycle.
    NoSpeed,
    /// An automatic mass without a force.
    NoMass,
    /// A radius given twice.
    BaseAndPrime,
    /// A radius beside a breadth, from which it follows.
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
    /// A width that the standard does not have.
    NoKeywayOfWidth { width: String, widths: String },
    /// A keyway as wide as its bore.
    KeywayTooWide { width: String, bore: String },
    /// An offset as large as the prime radius.
    OffsetReachesPrime { offset: String, prime: String },
    /// A wanted force on a follower whose lift is no length over one turn.
    ForceNeedsTranslation { follower: &'static str },
    /// A law over a length that is no programme.
    LengthNeedsProgram,
    /// A law over several turns that is no programme.
    TurnsNeedProgram,
    /// An arm on another drive than the fixed axis.
    ArmNeedsFixedAxis,
    /// A conjugate pair that nothing closes, or two things.
    PairNotClosed,
    /// The stiffness of the follower given twice.
    FrequencyAndStiffness,
    /// A limit on vibration of a follower that is not known to vibrate.
    ResidualWithoutFrequency,
    /// A least force that is not below the largest.
    ForceRange { low: String, high: String },
    /// A polydyne cam of a rigid follower.
    PolydyneWithoutStiffness,
    /// A polydyne cam of a family without four continuous derivatives.
    PolydyneFamily { family: &'static str },
    /// A polydyne cam of too low a degree.
    PolydyneDegree,
    /// A polydyne cam that does not turn.
    PolydyneOnSlide,
    /// A polydyne cam of constant breadth.
    PolydyneBreadth,
    /// A key that changes nothing, where only it was to change.
    NoEffect {
        key: String,
        why: &'static str,
        family: &'static str,
        follower: &'static str,
        drive: &'static str,
    },
    /// A built-in scene that is not there, and the one that may be meant.
    NoSuchScene {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
}
