//! Stances and contacts of a recording.

use serde::Serialize;
use strum::{IntoStaticStr, VariantNames};

use crate::recording::{Foot, Kind, Note};

/// Point of the force in a stance: a peak or a valley.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // A walking stance has a loading peak in its first half and a push-off peak in its second half.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let stance = &stances(&recording).used[0];
/// let (loading, push_off) = (stance.first_peak().unwrap(), stance.second_peak().unwrap());
/// assert!(loading.at < 0.5 && push_off.at > 0.5);
/// assert!(loading.force_n > stance.valley.unwrap().force_n);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Force at the point, N.
    pub force_n: f64,
    /// Time of the point since heel strike, as a fraction of the stance, 0 to 1.
    pub at: f64,
}

/// Fraction of the stance after which a single peak counts as the push-off peak.
const LATE: f64 = 0.6;

/// Whole stance of one foot.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The generated stances last 1/(0.76·1.9) s.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// for stance in stances(&recording).used {
///     assert!((stance.duration_s() - 1.0 / (0.76 * 1.9)).abs() < 0.01);
/// }
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Stance {
    /// Index of the channel of the recording.
    pub channel: usize,
    /// Foot of the stance, if the file specifies or implies it.
    pub foot: Option<Foot>,
    /// Time of the heel strike, s from the first sample.
    pub start_s: f64,
    /// Time of the toe-off, s from the first sample.
    pub end_s: f64,
    /// Loading peak. In a stance with only one peak, it is this peak.
    pub p1: Point,
    /// Valley at mid-stance, if the stance has two peaks.
    pub valley: Option<Point>,
    /// Push-off peak, if the stance has two peaks.
    pub p2: Option<Point>,
    /// Integral of the force over the stance, N s.
    pub impulse_ns: f64,
    /// Mass of the walker, kg, if it is given for each stance (tables of stances).
    pub mass_kg: Option<f64>,
    /// Whether duration, loading peak or impulse is an outlier of the channel. The stance is then used only in the sum of both feet.
    pub unlike: bool,
}

impl Stance {
    /// Time from heel strike to toe-off, s.
    pub fn duration_s(&self) -> f64 {
        self.end_s - self.start_s
    }

    /// Loading peak; `None` if the stance has only a later peak.
    pub fn first_peak(&self) -> Option<Point> {
        (self.valley.is_some() || self.p1.at < LATE).then_some(self.p1)
    }

    /// Push-off peak, which may be the only peak of the stance.
    pub fn second_peak(&self) -> Option<Point> {
        self.p2
            .or((self.valley.is_none() && self.p1.at >= LATE).then_some(self.p1))
    }

    /// Loading peak, valley and push-off peak; `None` for a missing point.
    pub fn landmarks(&self) -> [Option<Point>; 3] {
        [self.first_peak(), self.valley, self.second_peak()]
    }

    /// Maximum force of the stance, N.
    pub fn peak_n(&self) -> f64 {
        self.p2
            .map_or(self.p1.force_n, |p| p.force_n.max(self.p1.force_n))
    }
}

/// Reason why a contact is not used.
///
/// ```
/// use gaitcam_gait::{ReadOptions, RejectReason, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let reasons: Vec<RejectReason> = stances(&recording).rejected.iter().map(|r| r.reason).collect();
/// assert_eq!(reasons, [RejectReason::CutAtStart, RejectReason::CutAtEnd]);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[derive(IntoStaticStr, VariantNames)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum RejectReason {
    /// The recording starts during the contact.
    CutAtStart,
    /// The recording ends during the contact.
    CutAtEnd,
    /// The contact is incomplete and too short for a stance.
    EdgeFragment,
    /// The plate was loaded from the first sample to the last.
    NeverUnloaded,
    /// Samples are missing during the contact.
    MissingSamples,
    /// The contact is too short for a step.
    TooShort,
    /// The contact belongs to running, which was not requested.
    Running,
    /// The contact belongs to jumping: it is a take-off or landing of both feet.
    Jumping,
    /// The contact is cross-talk from the force of a foot on another plate.
    CrossTalk,
    /// The stance is whole, but its speed differs from that of most stances.
    OtherSpeed,
    /// The contact is too long for a step, or the movement is not walking, running or jumping.
    Standing,
    /// The contact is longer than other contacts, because the other foot stepped onto the same plate.
    CrossOver,
    /// The duration, loading peak or impulse is an outlier among the contacts of the channel.
    Unlike,
    /// The foot was on two plates at the same time.
    TwoPlates,
    /// Only a part of the foot was on the plate.
    PartialContact,
}

/// Contact that is not used, with the reason.
///
/// ```
/// use gaitcam_gait::{ReadOptions, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// // The recording ends during the last contact.
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let cut = stances(&recording).rejected.last().unwrap().clone();
/// assert!((cut.to_s - recording.duration_s).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rejected {
    /// Index of the channel of the recording.
    pub channel: usize,
    /// Start of the contact, s from the first sample.
    pub from_s: f64,
    /// End of the contact, s from the first sample.
    pub to_s: f64,
    /// Reason for the rejection.
    pub reason: RejectReason,
}

/// Contacts of a recording, each used or rejected, in order of time.
///
/// ```
/// use gaitcam_gait::{Kind, ReadOptions, read, stances};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// let found = stances(&recording);
/// assert_eq!((found.used.len(), found.rejected.len()), (19, 2));
/// assert_eq!(found.recognised, Some(Kind::Walking));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Stances {
    /// Whole stances, in order of time.
    pub used: Vec<Stance>,
    /// Contacts that are not whole stances, with the reason.
    pub rejected: Vec<Rejected>,
    /// Movement recognised from the contacts.
    pub recognised: Option<Kind>,
    /// Kind of movement that is averaged: the requested kind, otherwise the recognised kind.
    pub kind: Option<Kind>,
    /// Notes that result from the comparison of stances.
    pub notes: Vec<Note>,
}
