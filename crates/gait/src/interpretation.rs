//! Interpretation of a recording: what was recognised, assumed and excluded, and which questions are open.

use serde::Serialize;
use serde_json::{Value, json};
use strum::IntoStaticStr;

use crate::recording::{
    ClockSource, CycleSource, Feet, Foot, ForceUnit, Format, Idle, Kind, MassSource, Note,
    OpenQuestion, PeriodSource, UnitSource,
};
use crate::stance::{Point, RejectReason};

/// Interpretation of a recording: file, movement, columns, stride duration, detected stances, assumptions and open questions.
///
/// ```
/// use gaitcam_gait::{Feet, Kind, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let understood = curve.recording.unwrap();
/// assert_eq!(understood.kind, Some(Kind::Walking));
/// assert_eq!(understood.columns.len(), 2);
/// assert!(understood.doubts().is_empty());
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Interpretation {
    /// Name of the file with the recording.
    pub file: String,
    /// Format of the file.
    pub format: Format,
    /// Kind of recorded movement; `None` if unknown.
    pub kind: Option<Kind>,
    /// Whether the user stated the kind of movement.
    pub kind_given: bool,
    /// Time base: rate, duration and source.
    pub clock: Clock,
    /// Unit of the force columns.
    pub unit: ForceUnit,
    /// Source of the unit: the user, the file, or the magnitude of the readings.
    pub unit_from: UnitSource,
    /// Columns (plates, insoles, belts) of vertical force.
    pub columns: Vec<Column>,
    /// Feet to which the force of the cycle belongs.
    pub feet: Feet,
    /// All contacts, used or rejected, in order of time.
    pub contacts: Vec<Contact>,
    /// All whole strides of both feet, used or rejected, in order of time.
    pub strides: Vec<RecordedStride>,
    /// Duration of a cycle, its source and its variation.
    pub period: Option<Period>,
    /// Mass, kg, and its source.
    pub mass: Option<(f64, MassSource)>,
    /// Interval, kg, that contains the mass in 95 of 100 recordings, if the mass was computed.
    pub mass_interval_kg: Option<(f64, f64)>,
    /// Method by which the cycle was computed.
    pub cycle: Option<CycleSource>,
    /// Notes on assumptions, exclusions and doubtful data.
    pub warnings: Vec<Note>,
    /// Single stances for a figure, with the mean of each foot.
    pub overlay: Option<Overlay>,
}

/// Time base of the samples.
///
/// ```
/// use gaitcam_gait::{ClockSource, Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let clock = &curve.recording.unwrap().clock;
/// // A column of seconds in steps of 10 ms.
/// assert_eq!(clock.from, ClockSource::Times);
/// assert!((clock.rate_hz - 100.0).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Rate of the samples, 1/s.
    pub rate_hz: f64,
    /// Time of the first sample, as in the file, s.
    pub start_s: f64,
    /// Time from the first sample to the last one, s.
    pub duration_s: f64,
    /// How the sampling rate was obtained: from the user, the time column or the header, or by an assumption.
    pub from: ClockSource,
}

/// Column of vertical force in the recording.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The unloaded readings of the plates in this generated recording are +4 N and −6 N.
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let baselines: Vec<f64> = curve.recording.unwrap().columns.iter().map(|c| c.baseline_n).collect();
/// assert!((baselines[0] - 4.0).abs() < 0.5 && (baselines[1] + 6.0).abs() < 0.5);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name of the column in the file.
    pub name: String,
    /// Foot of the column, if the file specifies it.
    pub foot: Option<Foot>,
    /// Unloaded reading that was subtracted, N.
    pub baseline_n: f64,
    /// Standard deviation of the unloaded reading, N.
    pub noise_n: f64,
    /// Reason for the exclusion of the column; `None` if it is included.
    pub idle: Option<Idle>,
    /// Minimum and maximum force, N, in time intervals of equal duration over the whole recording. A figure of the recording is drawn from
    /// them.
    pub envelope_n: Vec<[f64; 2]>,
}

/// Contact of a foot with a plate or insole.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, RejectReason, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The right foot is on the ground when the recording begins.
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let first = curve.recording.unwrap().contacts[0].clone();
/// assert_eq!((first.from_s, first.rejected), (0.0, Some(RejectReason::CutAtStart)));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Index of the column in `columns`.
    pub column: usize,
    /// Foot of the contact, if known.
    pub foot: Option<Foot>,
    /// Start of the contact, as in the file, s.
    pub from_s: f64,
    /// End of the contact, as in the file, s.
    pub to_s: f64,
    /// Loading peak, valley and push-off peak of a whole stance; `None` for a missing point.
    pub landmarks: [Option<Point>; 3],
    /// Integral of the force over a whole stance, N s.
    pub impulse_ns: Option<f64>,
    /// Reason why the contact was rejected; `None` if it is used.
    pub rejected: Option<RejectReason>,
}

/// Whole recorded stride, from one heel strike to the next heel strike of the same foot.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, StrideReject, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // Strides that begin with the other foot share samples with the averaged strides.
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let strides = curve.recording.unwrap().strides.clone();
/// let used = strides.iter().filter(|s| s.rejected.is_none()).count();
/// let other = strides.iter().filter(|s| s.rejected == Some(StrideReject::OtherFoot)).count();
/// assert_eq!((strides.len(), used, other), (18, 9, 9));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedStride {
    /// Foot that begins and ends the stride, if known.
    pub foot: Option<Foot>,
    /// First heel strike of the stride, as in the file, s.
    pub from_s: f64,
    /// Next heel strike of the same foot, as in the file, s.
    pub to_s: f64,
    /// Loading peak, valley and push-off peak of the first stance; `None` for a missing point.
    pub landmarks: [Option<Point>; 3],
    /// Integral of the force of both feet over the stride, N s.
    pub impulse_ns: f64,
    /// Reason why the stride is excluded from the mean cycle; `None` if it is included.
    pub rejected: Option<StrideReject>,
}

/// Reason why a whole stride is not averaged.
///
/// ```
/// use gaitcam_gait::StrideReject;
///
/// assert_eq!(<&str>::from(StrideReject::OddDuration), "odd-duration");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum StrideReject {
    /// The duration of the stride differs from the median by a quarter or more.
    OddDuration,
    /// The averaged strides begin with the other foot, and they share samples with this stride.
    OtherFoot,
    /// The mean cycle is built from single stances, not from whole strides.
    StancesAveraged,
}

/// Duration of a cycle (stride) of the recorded walk.
///
/// ```
/// use gaitcam_gait::{Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let period = curve.recording.unwrap().period.clone().unwrap();
/// assert!((period.seconds - 2.0 / 1.9).abs() < 0.002);
/// // The generated strides differ only by the noise of the plates.
/// assert!(period.spread_s.unwrap() < 0.005);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Period {
    /// Duration of one cycle, s.
    pub seconds: f64,
    /// Source of the duration, such as heel strikes or a typical duty factor.
    pub from: PeriodSource,
    /// Standard deviation of the durations of single strides, s, if there are several strides.
    pub spread_s: Option<f64>,
}

/// Single stances and mean stances over the phase of the stance. Sample `i` of `n` is at the fraction i/(n − 1) of the stance.
///
/// ```
/// use gaitcam_gait::{ReadOptions, overlay, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let shown = overlay(&recording, &stances(&recording), 6).unwrap();
/// assert!(shown.stances.len() <= 6);
/// // One mean for each foot.
/// assert_eq!(shown.means.len(), 2);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Single stances in the figure: foot and force, N, of each.
    pub stances: Vec<(Option<Foot>, Vec<f64>)>,
    /// Mean stance of each foot, left foot first; a single mean if the feet are unnamed.
    pub means: Vec<MeanStanceCurve>,
}

/// Mean stance of one foot.
///
/// ```
/// use gaitcam_gait::{Foot, ReadOptions, overlay, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let left = overlay(&recording, &stances(&recording), 6).unwrap().means[0].clone();
/// assert_eq!((left.foot, left.count), (Some(Foot::Left), 10));
/// assert!((left.duration_s - 1.0 / (0.76 * 1.9)).abs() < 0.005);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MeanStanceCurve {
    /// Foot of the mean stance, if known.
    pub foot: Option<Foot>,
    /// Number of stances in the mean.
    pub count: usize,
    /// Mean duration of the stances, s.
    pub duration_s: f64,
    /// Mean force at equal steps of the stance, N.
    pub mean_n: Vec<f64>,
    /// Standard deviation from stance to stance, N, for two or more stances.
    pub spread_n: Option<Vec<f64>>,
    /// Loading peak, valley and push-off peak. Each is the mean over the stances in which it exists; `None` if at least half of the stances
    /// lack it.
    pub landmarks: [Option<Point>; 3],
}

impl Interpretation {
    /// Open questions about kind of movement, time base or mass, without repetition.
    pub fn doubts(&self) -> Vec<OpenQuestion> {
        Note::doubts(&self.warnings)
    }

    /// Warnings from which the given question follows.
    pub fn opened_by(&self, question: OpenQuestion) -> Vec<Note> {
        Note::opening(&self.warnings, question)
    }

    /// Codes of the warnings in order of their first occurrence, each once.
    pub fn codes(&self) -> Vec<&'static str> {
        let mut all: Vec<&str> = Vec::new();
        for code in self.warnings.iter().map(Note::code) {
            if !all.contains(&code) {
                all.push(code);
            }
        }
        all
    }

    /// Number of used contacts, and number of rejected contacts.
    pub fn counts(&self) -> (usize, usize) {
        let used = self.contacts.iter().filter(|c| c.rejected.is_none());
        let used = used.count();
        (used, self.contacts.len() - used)
    }

    /// Mean stances for a figure, left foot first; empty without an overlay.
    pub fn means(&self) -> &[MeanStanceCurve] {
        self.overlay.as_ref().map_or(&[], |o| &o.means)
    }

    /// The interpretation as a JSON object.
    pub fn json(&self) -> Value {
        let contacts: Vec<Value> = self.contacts.iter().map(|c| self.contact(c)).collect();
        json!({
            "file": self.file, "kind": self.kind, "kind_given": self.kind_given,
            "clock": {"rate_hz": self.clock.rate_hz, "start_s": self.clock.start_s,
                "duration_s": self.clock.duration_s, "from": self.clock.from},
            "unit": self.unit, "unit_from": self.unit_from,
            "period_s": self.period.map(|p| p.seconds), "period_from": self.period.map(|p| p.from),
            "period_spread_s": self.period.and_then(|p| p.spread_s),
            "mass_kg": self.mass.map(|m| m.0), "mass_from": self.mass.map(|m| m.1),
            "mass_low_kg": self.mass_interval_kg.map(|m| m.0),
            "mass_high_kg": self.mass_interval_kg.map(|m| m.1),
            "contacts": contacts, "doubts": self.doubts(),
            "warnings": self.warnings.iter().map(coded).collect::<Vec<_>>(),
        })
    }

    fn contact(&self, c: &Contact) -> Value {
        let column = self.columns.get(c.column).map(|c| &c.name);
        json!({
            "column": column, "foot": c.foot, "from_s": c.from_s, "to_s": c.to_s,
            "used": c.rejected.is_none(), "reason": c.rejected,
        })
    }
}

/// Converts an enum value to a JSON object that contains its code and its data.
pub fn coded(value: &impl Serialize) -> Value {
    match serde_json::to_value(value) {
        Ok(Value::Object(map)) if map.len() == 1 => map
            .into_iter()
            .next()
            .map(|(code, data)| json!({"code": code, "data": data}))
            .unwrap_or_default(),
        Ok(code) => json!({"code": code, "data": {}}),
        Err(_) => Value::Null,
    }
}
