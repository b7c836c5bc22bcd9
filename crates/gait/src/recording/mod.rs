//! A recording: channels of vertical force with a common, uniform time base.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

mod feet;
mod format;
mod heels;
mod kind;
mod note;
mod question;
mod unit;

pub use feet::{Feet, Foot};
pub use format::{DecimalMark, Format, Processor, SeparatorName, Storage};
pub use heels::Heels;
pub use kind::{Kind, OpenQuestion};
pub use note::{
    Axis, ClockSource, CycleSource, MassSource, Note, PeriodSource, UnitSource, WeightShare,
};
pub use unit::ForceUnit;

/// Options of the user for reading a recording. They have priority over the content of the file.
///
/// ```
/// use gaitcam_gait::{ForceUnit, ReadOptions, read};
///
/// let text = "t,a,b\n0.0,0.70,1\n0.1,0.72,1\n0.2,0.71,1\n0.3,0.70,1\n";
/// let options = ReadOptions {
///     force: vec!["a".to_string()],
///     unit: Some(ForceUnit::Kilonewton),
///     ..ReadOptions::default()
/// };
/// let recording = read("a.csv".as_ref(), text.as_bytes(), &options)?;
/// assert_eq!((recording.channels.len(), recording.unit), (1, ForceUnit::Kilonewton));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ReadOptions {
    /// Name (or number, counted from 1) of the time column.
    pub time: Option<String>,
    /// Names (or numbers, counted from 1) of the vertical force columns.
    pub force: Vec<String>,
    /// Unit of the force columns.
    pub unit: Option<ForceUnit>,
    /// Sampling rate, 1/s; required if the file does not contain it.
    pub rate_hz: Option<f64>,
    /// Mass of the walker, kg.
    pub mass_kg: Option<f64>,
    /// Kind of movement in the recording. If `None`, it is recognised from the forces.
    pub kind: Option<Kind>,
    /// Duration of the cycle, s, if the file contains exactly one cycle.
    pub period_s: Option<f64>,
    /// Cam angle, rad, that the force in the file spans. The force is zero in the rest of the turn.
    pub span_rad: Option<f64>,
    /// Root mean square noise of the readings, N. If `None`, it is estimated from unloaded samples.
    pub noise_n: Option<f64>,
    /// Content of the table of subjects that belongs to a table of stances (see [`metadata_name`](super::metadata_name)).
    pub metadata: Option<Vec<u8>>,
}

/// Foot strike that is marked in the file.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // A text contains no marked strikes; a C3D file may contain some.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// assert!(recording.strikes.iter().all(|strike| strike.at_s >= 0.0) && recording.strikes.is_empty());
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Strike {
    /// Time from the first sample, s.
    pub at_s: f64,
    /// Foot that strikes the ground.
    pub foot: Foot,
}

/// Stance in a table with one stance per row, as a range of samples in its channel.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // A recording over time has no rows of stances. Only a table of stances has them.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// assert!(!recording.has_rows() && recording.channels[0].rows.is_empty());
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Index of the first sample.
    pub from: usize,
    /// Index of the last sample plus 1.
    pub to: usize,
    /// Mass of the subject, kg, if known.
    pub mass_kg: Option<f64>,
}

/// Vertical force on one plate, insole, belt or foot, N.
///
/// ```
/// use gaitcam_gait::{Foot, ReadOptions, read};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let left = &recording.channels[0];
/// assert_eq!((left.foot, left.force_n.len()), (Some(Foot::Left), 1050));
/// // The noise of the simulated plates is 2 N.
/// assert!((left.noise_n - 2.0).abs() < 0.3);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Channel {
    /// Name of the channel in the file.
    pub name: String,
    /// Foot of the channel, if the file specifies it.
    pub foot: Option<Foot>,
    /// Upward force on the body, N. The unloaded baseline is subtracted, and all values are finite.
    pub force_n: Vec<f64>,
    /// Unloaded reading that was subtracted, N, with the same sign as `force_n`.
    pub baseline_n: f64,
    /// Standard deviation of the unloaded reading, N.
    pub noise_n: f64,
    /// Ranges of missing samples (first, one past the last). The samples in these ranges were interpolated linearly.
    pub missing: Vec<(usize, usize)>,
    /// Reason for the exclusion of the channel; `None` if it is included.
    pub idle: Option<Idle>,
    /// Stances of a table with one stance per row; empty for other recordings.
    pub rows: Vec<Row>,
}

/// Reason for excluding a channel.
///
/// ```
/// use gaitcam_gait::{Idle, ReadOptions, read};
///
/// // An unloaded plate.
/// let text = "time (s),Left Fz (N),Right Fz (N)\n0,0,700\n0.1,0,1\n0.2,0,720\n0.3,0,2\n0.4,0,700\n";
/// let recording = read("a.csv".as_ref(), text.as_bytes(), &ReadOptions::default())?;
/// assert_eq!(recording.channels[0].idle, Some(Idle::NeverLoaded));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Idle {
    /// The readings are nearly constant, close to zero.
    NeverLoaded,
    /// The readings are nearly constant and not close to zero, or most have the same large value.
    Constant {
        /// Level of the constant readings.
        level: Quantity,
    },
    /// More than half of the samples are missing.
    MostlyEmpty {
        /// Number of missing samples.
        missing: usize,
        /// Total number of samples.
        samples: usize,
    },
    /// The channel has no samples.
    Empty,
}

/// A recording with a uniform time base.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // Two plates, 10.5 s at 100 Hz: the last of 1050 samples is at 10.49 s.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// assert_eq!(recording.channels.len(), 2);
/// assert!((recording.duration_s - 10.49).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Format of the file.
    pub format: Format,
    /// Whether the forces are those of pressure insoles.
    pub insole: bool,
    /// Sampling rate of all channels, 1/s.
    pub rate_hz: f64,
    /// Time of the first sample, as in the file, s.
    pub start_s: f64,
    /// Duration from the first sample to the last one, s.
    pub duration_s: f64,
    /// How the sampling rate was obtained: from the user, the time column or the header, or by an assumption.
    pub clock: ClockSource,
    /// Unit of the force columns.
    pub unit: ForceUnit,
    /// Source of the unit: the user, the file, or the magnitude of the readings.
    pub unit_from: UnitSource,
    /// Kind of movement, if stated by the user.
    pub kind: Option<Kind>,
    /// Mass of the walker, kg, if given by the file or the user.
    pub mass_kg: Option<f64>,
    /// Source of the mass: the user, the file, or the table of subjects.
    pub mass_from: Option<MassSource>,
    /// Channels of vertical force, in the order of the file.
    pub channels: Vec<Channel>,
    /// Foot strikes marked in the file, in order of time.
    pub strikes: Vec<Strike>,
    /// Paths of both heel markers, if the file contains both.
    pub heels: Option<Heels>,
    /// Spans without samples: start and end, s.
    pub gaps_s: Vec<(f64, f64)>,
    /// Notes on assumptions, exclusions and doubtful data.
    pub notes: Vec<Note>,
}

impl Recording {
    /// Adds the plates of another file of the same trial, which must have been read with the same options. The recording ends where the
    /// shorter file ends.
    pub fn add_plates(&mut self, other: Recording) {
        let low = |n: &Note| matches!(n, Note::LowForce { .. });
        let is_low = |notes: &[Note]| notes.iter().any(low);
        // The force of an unloaded plate does not determine the unit.
        let loaded = !(is_low(&self.notes) && is_low(&other.notes));
        let new = other.notes.into_iter().filter(|n| !self.notes.contains(n));
        let new: Vec<Note> = new.collect();
        self.notes.extend(new);
        self.notes.retain(|n| !(loaded && low(n)));
        self.mass_kg = self.mass_kg.or(other.mass_kg);
        self.mass_from = self.mass_from.or(other.mass_from);
        self.channels.extend(other.channels);
        let lengths = self.channels.iter().map(|c| c.force_n.len());
        let count = lengths.min().unwrap_or(0);
        for channel in &mut self.channels {
            channel.force_n.truncate(count);
            channel.missing.retain(|gap| gap.1 <= count);
        }
        self.duration_s = count.saturating_sub(1) as f64 / self.rate_hz;
    }

    /// Whether the user stated that the recording is of running.
    pub fn runs(&self) -> bool {
        self.kind == Some(Kind::Running)
    }

    /// Channels with a load, with their indices.
    pub(crate) fn live(&self) -> impl Iterator<Item = (usize, &Channel)> {
        let all = self.channels.iter().enumerate();
        all.filter(|(_, channel)| channel.idle.is_none())
    }

    /// Whether the recording is a table with one stance per row.
    pub fn has_rows(&self) -> bool {
        self.channels.iter().any(|c| !c.rows.is_empty())
    }
}
