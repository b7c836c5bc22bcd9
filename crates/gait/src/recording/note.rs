//! Notes on a recording: assumptions, exclusions, and implausible values.

use std::fmt;

use serde::Serialize;
use strum::{IntoStaticStr, VariantNames};

use super::feet::Foot;
use super::kind::OpenQuestion;
use super::unit::ForceUnit;
use crate::units::Quantity;
use crate::wording::{Language, sentence};

/// Component of the force in the axes of a file.
///
/// ```
/// use gaitcam_gait::{Axis, Note};
///
/// let note = Note::VerticalGuessed { vertical: Axis::Z, other: Axis::Y };
/// assert_eq!(serde_json::to_value(&note).unwrap()["vertical-guessed"]["vertical"], "z");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// First component of the force on a plate.
    X,
    /// Second component of the force on a plate.
    Y,
    /// Third component of the force on a plate.
    Z,
    /// Component that is named vertical, or the only component in the file.
    Vertical,
}

/// Note on an assumption, an exclusion or an implausible value in a recording or its mean cycle.
///
/// ```
/// use gaitcam_gait::{Note, OpenQuestion};
/// use gaitcam_gait::units::Quantity;
///
/// // A stride time that was assumed leaves a question on the time base open until the user answers it.
/// let note = Note::StrideAssumed { period: Quantity::time(1.1), duty: Quantity::share(0.62) };
/// assert_eq!((note.code(), note.doubt()), ("stride-assumed", Some(OpenQuestion::Clock)));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, IntoStaticStr, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum Note {
    /// The number of rows announced in the header differs from the number in the file.
    RowsDiffer { announced: usize, found: usize },
    /// The number of frames announced in the header is larger than the number in the file.
    FramesMissing { announced: usize, found: usize },
    /// The given period differs from the duration that follows from the times in the file.
    ClockDiffers { clock: Quantity, period: Quantity },
    /// Lines that are not rows of numbers were skipped.
    LinesSkipped { first_line: usize },
    /// Two columns without names are sums of sensors. They were interpreted as the left and the right insole.
    InsoleColumns { left: usize, right: usize },
    /// The file has columns of insoles and of plates. The columns of the plates were used.
    InsoleBesidePlate {
        plate: Vec<String>,
        insole: Vec<String>,
    },
    /// Each row of the table is one stance.
    StancePerRow { rows: usize },
    /// The table of subjects contains the masses of only some stances.
    MassesMissing { known: usize, rows: usize },
    /// The durations of the stances are unknown, because all have the same number of samples. A typical duration was assumed.
    DurationsLost { samples: usize, assumed: Quantity },
    /// A table of stances has no sampling rate. A rate was assumed for which the stances have a typical duration.
    RateGuessed { rate: Quantity, stance: Quantity },
    /// The sampling rate given by the user replaces the time column.
    RateOverridesTimes { rate: Quantity, column: Quantity },
    /// The time column has no unit. Its steps were interpreted as milliseconds, microseconds or nanoseconds.
    TimeUnitGuessed { step: f64, unit: &'static str },
    /// Single samples are missing.
    SamplesMissing { count: usize, first: Quantity },
    /// The header and the time column have different sampling rates. The rate of the time column is used.
    RatesDiffer { header: Quantity, column: Quantity },
    /// The samples were not at uniform times and were resampled.
    UnevenSamples,
    /// The unit of force was determined from the magnitude of the readings.
    UnitGuessed { peak: f64, unit: ForceUnit },
    /// The unit in the file is implausible for the magnitude of the readings.
    UnitLabelRejected {
        label: ForceUnit,
        peak: f64,
        unit: ForceUnit,
    },
    /// No force in the recording is large enough for a step.
    LowForce { peak: Quantity },
    /// The readings of a column are clipped at a level below the peaks of the force.
    Clipped { column: String, level: Quantity },
    /// Samples of a column are missing between its contacts. The plate was assumed to be unloaded there.
    MissingIsUnloaded { column: String },
    /// A column repeats another column and was excluded.
    ColumnRepeats { column: String, original: String },
    /// Single samples that differ strongly from the samples before and after them were removed.
    SpikesRemoved {
        column: String,
        count: usize,
        first: Quantity,
    },
    /// Readings of a loaded column are zero for some hundredths of a second, because samples were lost.
    DropOuts {
        column: String,
        count: usize,
        first: Quantity,
    },
    /// The stances of a recording fill only a span of the turn.
    StanceFillsSpan {
        /// Number of stances in the mean stance that fills the span.
        stances: usize,
        /// Start of the first of these stances, as in the file.
        from: Quantity,
        /// End of the first of these stances, as in the file.
        to: Quantity,
    },
    /// A share of the force on another plate was subtracted, because it is cross-talk.
    CrossTalkRemoved {
        /// Name of the column that contained the cross-talk.
        column: String,
        /// Name of the column of the other plate.
        of: String,
        /// Subtracted share of the force on the other plate.
        share: Quantity,
    },
    /// The unloaded reading during the walk differs from the reading at both ends of the recording.
    UnloadedDiffers {
        column: String,
        level: Quantity,
        at_ends: Quantity,
    },
    /// The unloaded reading of a column drifts. The drift was subtracted.
    DriftRemoved { column: String, rise: Quantity },
    /// The stride durations vary, so the walk is not steady or has more than one speed.
    StrideVaries { period: Quantity, spread: Quantity },
    /// The stride time was determined from a single step or stride.
    StrideFromOne {
        period: Quantity,
        error: Quantity,
        stroke: Quantity,
    },
    /// Two components have similar magnitudes. The larger component was interpreted as vertical.
    VerticalGuessed { vertical: Axis, other: Axis },
    /// `ground_force` was interpreted as the right foot and `1_ground_force` as the left foot, as in the examples of OpenSim.
    FeetGuessed,
    /// The file contains no usable force plate, so channels were selected by their labels.
    NoPlates,
    /// A plate was excluded, because its TYPE is not in the range 1 to 7.
    PlateTypeUnknown { plate: usize, kind: i64 },
    /// A plate was excluded, because one of its channels is missing in the file.
    PlateChannelMissing { plate: usize, channel: usize },
    /// A plate was excluded, because its type requires a calibration matrix and the file has none.
    PlateMatrixMissing { plate: usize },
    /// A plate is tilted relative to the first plate.
    PlateTilted { plate: usize },
    /// The mass was computed from the mean force of insoles, which are often not calibrated.
    InsoleMass { mass: Quantity },
    /// The stances of one foot were used for both feet.
    OneFootForBoth { stances: usize },
    /// The stride time cannot be determined from the recording. A typical duty factor was assumed.
    StrideAssumed { period: Quantity, duty: Quantity },
    /// The stride time is outside the plausible range for the movement.
    StrideImplausible {
        period: Quantity,
        low: Quantity,
        high: Quantity,
    },
    /// The duty factor is outside the plausible range for the movement.
    DutyImplausible {
        duty: Quantity,
        low: Quantity,
        high: Quantity,
    },
    /// The peak force, in body weights, is outside the plausible range for the movement.
    PeakImplausible { ratio: f64, low: f64, high: f64 },
    /// The mean force over the cycle differs from the weight.
    MeanForceNotWeight {
        ratio: f64,
        mass: Quantity,
        share: WeightShare,
    },
    /// The mass is outside the range of human masses, or implausible for the stride time.
    MassImplausible { mean: Quantity, mass: Quantity },
    /// The unit of force was assumed, and with this unit the mass is implausible for an adult.
    UnitUnconfirmed { unit: ForceUnit, mass: Quantity },
    /// The time column increases by one from row to row and has no unit. It may contain milliseconds or sample numbers.
    CountOrMilliseconds { stride: Quantity },
    /// The contacts do not agree with the requested kind of movement.
    KindDiffers {
        typed: &'static str,
        movement: &'static str,
    },
    /// The speed changes. The mean includes only stances whose durations are in a common range.
    SpeedChanges {
        used: usize,
        stances: usize,
        low: Quantity,
        high: Quantity,
    },
    /// The file contains the mean cycle of a recording about which a question is open.
    LeftOpen { question: OpenQuestion },
    /// Less than two thirds of the stances of a steady walk are similar. The contacts may be partial contacts, or contacts of both feet.
    FewAlike { used: usize, stances: usize },
    /// The difference between stances, or between the impulses of the two feet, is larger than expected if each foot is completely on one
    /// plate.
    StancesDiffer { share: Quantity, most: Quantity },
    /// The mean cycle was computed from a column that contains the total of both feet.
    TotalColumn,
    /// Feet cross from one plate to another, so the forces of all plates were added.
    PlatesSummed { plates: usize },
    /// The readings are converter counts. They were scaled to newtons with the mass of the walker.
    CountsScaled { mass: Quantity },
    /// Recordings of walkers with different masses were averaged in body weights.
    SeveralMasses {
        low: Quantity,
        high: Quantity,
        mean: Quantity,
    },
}

/// Fraction of the weight that the feet of a cycle carry on average over a stride.
///
/// ```
/// use gaitcam_gait::{Feet, WeightShare};
///
/// // One foot carries half of the weight over a stride.
/// assert_eq!(Feet::Left.share(), 0.5);
/// assert_eq!(serde_json::to_value(WeightShare::Half).unwrap(), "half");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WeightShare {
    /// Both feet together carry the whole weight.
    Whole,
    /// One foot carries half of the weight on average.
    Half,
}

/// How the sampling rate of a recording was obtained.
///
/// ```
/// use gaitcam_gait::{ClockSource, ReadOptions, read};
///
/// // The file contains no sampling rate, so the rate of the user is necessary.
/// let text = "Fz (N)\n700\n701\n702\n703\n704\n";
/// let options = ReadOptions { rate_hz: Some(50.0), ..ReadOptions::default() };
/// let recording = read("a.csv".as_ref(), text.as_bytes(), &options)?;
/// assert_eq!((recording.clock, recording.rate_hz), (ClockSource::User, 50.0));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum ClockSource {
    /// The sampling rate was given by the user.
    User,
    /// The sampling rate follows from a time column in seconds, or in a unit that is in the file.
    Times,
    /// The sampling rate follows from a time column whose unit was assumed.
    GuessedTimes,
    /// The sampling rate was read from the file.
    Header,
    /// The sampling rate was assumed, so that stances have a typical duration.
    GuessedRate,
}

/// Source of the unit of force of a recording.
///
/// ```
/// use gaitcam_gait::{ReadOptions, UnitSource, read};
///
/// let text = "time (s),Fz (N)\n0.0,700\n0.1,701\n0.2,702\n0.3,703\n";
/// let recording = read("a.csv".as_ref(), text.as_bytes(), &ReadOptions::default())?;
/// assert_eq!(recording.unit_from, UnitSource::File);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum UnitSource {
    /// The unit was given by the user.
    User,
    /// The unit is in the file.
    File,
    /// The unit was determined from the magnitude of the readings.
    Guessed,
}

/// Source of the mass of a walker.
///
/// ```
/// use gaitcam_gait::{Feet, MassSource, ReadOptions, cycle, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The mean force over a stride is the weight: 700 N in this generated recording.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// assert_eq!(mean.mass_from, MassSource::MeanForce);
/// assert!((mean.mass_kg / (700.0 / 9.81) - 1.0).abs() < 0.01);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum MassSource {
    /// The mass was given by the user.
    User,
    /// The mass is in the file.
    File,
    /// The mass is the mean mass of the subjects in the table of subjects.
    Subjects,
    /// The mass is the mean force over the stride divided by g.
    MeanForce,
}

/// Source of the duration of a stride.
///
/// ```
/// use gaitcam_gait::{Feet, PeriodSource, ReadOptions, cycle, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // Steps of 1.9 Hz: a stride of 2/1.9 s.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// assert_eq!(mean.period.from, PeriodSource::HeelStrikes);
/// assert!((mean.curve.period_s - 2.0 / 1.9).abs() < 0.002);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum PeriodSource {
    /// Consecutive heel strikes of one foot.
    HeelStrikes,
    /// Consecutive heel strikes of one foot that are marked in the file.
    MarkedStrikes,
    /// The heel markers of a motion-capture recording.
    HeelMarkers,
    /// Twice the mean time from a heel strike to the heel strike of the other foot.
    DoubledSteps,
    /// A known mass M. The duration T satisfies the condition that the impulse of both feet equals M g T.
    Impulse,
    /// A typical duty factor, if the stride time cannot be measured.
    UsualDuty,
    /// Moments at which the total force of both feet rises through its mean.
    TotalForce,
}

impl PeriodSource {
    /// Code of the source, as used in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Method by which the mean cycle was computed.
///
/// ```
/// use gaitcam_gait::{CycleSource, Feet, ReadOptions, cycle, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The mean is computed from nine whole strides of 1.05 s in a recording of 10.5 s.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let mean = cycle(&recording, &stances(&recording), Feet::Both)?;
/// assert!(matches!(mean.source, CycleSource::WholeStrides { strides: 9, .. }));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // numbers of strides or stances
pub enum CycleSource {
    /// Whole strides of both feet, between heel strikes of one foot.
    WholeStrides { strides: usize, from: Option<Foot> },
    /// Single stances of the right and the left foot, placed half a stride apart.
    RightAndLeft {
        right: usize,
        left: usize,
        period: PeriodSource,
    },
    /// Single stances of two unnamed feet, placed half a stride apart.
    TwoFeet {
        one: usize,
        other: usize,
        period: PeriodSource,
    },
    /// Single stances of one or unknown feet, used for both feet.
    AnyFoot {
        stances: usize,
        period: PeriodSource,
    },
    /// Stances of one foot, with zero force in the swing phase.
    OneFoot {
        stances: usize,
        period: PeriodSource,
    },
    /// Strides of the total force of both feet in one column.
    TotalForce { strides: usize },
}

impl Note {
    /// Code of the note, as used in JSON and in tables.
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&sentence(Language::En, "note", self))
    }
}

impl fmt::Display for CycleSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&sentence(Language::En, "cycle", self))
    }
}
