//! How a recording was understood: one record of everything that was recognised, guessed, left out or is in doubt.

use serde::Serialize;
use serde_json::{Value, json};

use super::cycle::{Cycle, MeanStanceCurve, Overlay, Period, overlay};
use super::feet::Feet;
use super::format::Format;
use super::kind::{Kind, OpenQuestion};
use super::note::{ClockSource, CycleSource, MassSource, Note, UnitSource};
use super::recording::{Channel, Foot, ForceUnit, Idle, Recording};
use super::stance::{RejectReason, Stances};

/// Points of a channel that are kept for its picture: lowest and highest force of so many pieces.
const PIECES: usize = 700;
/// Single stances that are kept for a picture; the means are of all.
const DRAWN: usize = 60;

/// How a recording was understood.
///
/// ```
/// use gaitcam::force::{Feet, Kind, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let understood = curve.recording.unwrap();
/// assert_eq!(understood.kind, Some(Kind::Walking));
/// assert_eq!(understood.columns.len(), 2);
/// assert!(understood.doubts().is_empty());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Interpretation {
    /// Name of the file.
    pub file: String,
    /// Kind of file.
    pub format: Format,
    /// What was recorded; `None` where nothing shows it.
    pub kind: Option<Kind>,
    /// Whether the user said so.
    pub kind_given: bool,
    /// Rate, span and source of the time of a sample.
    pub clock: Clock,
    /// Unit of the force columns.
    pub unit: ForceUnit,
    /// Where it is from.
    pub unit_from: UnitSource,
    /// Columns (plates, insoles, belts) of vertical force.
    pub columns: Vec<Column>,
    /// Feet of the cycle.
    pub feet: Feet,
    /// Every contact, used or rejected, in order of time.
    pub contacts: Vec<Contact>,
    /// Duration of a cycle, what it was taken from and how far single strides differ.
    pub period: Option<Period>,
    /// Mass, kg, and where it is from.
    pub mass: Option<(f64, MassSource)>,
    /// How the cycle was computed.
    pub cycle: Option<CycleSource>,
    /// What was guessed, left out or does not look right.
    pub warnings: Vec<Note>,
    /// The stances over each other with the mean of each foot.
    pub overlay: Option<Overlay>,
}

/// The time of a sample.
///
/// ```
/// use gaitcam::force::{ClockSource, Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let clock = &curve.recording.unwrap().clock;
/// // A column of seconds in steps of 10 ms.
/// assert_eq!(clock.from, ClockSource::Times);
/// assert!((clock.rate_hz - 100.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Samples per second.
    pub rate_hz: f64,
    /// Time of the first sample on the file's own clock, s.
    pub start_s: f64,
    /// Time from the first sample to the last, s.
    pub duration_s: f64,
    /// What it was taken from.
    pub from: ClockSource,
}

/// One column of vertical force.
///
/// ```
/// use gaitcam::force::{Feet, ReadOptions, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// // The plates of this made recording read +4 N and −6 N when nobody stands on them.
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let baselines: Vec<f64> = curve.recording.unwrap().columns.iter().map(|c| c.baseline_n).collect();
/// assert!((baselines[0] - 4.0).abs() < 0.5 && (baselines[1] + 6.0).abs() < 0.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name in the file.
    pub name: String,
    /// The foot, where the file says it.
    pub foot: Option<Foot>,
    /// Unloaded reading that was removed, N.
    pub baseline_n: f64,
    /// Standard deviation of the unloaded reading, N.
    pub noise_n: f64,
    /// Why it takes no part, if so.
    pub idle: Option<Idle>,
    /// Lowest and highest force in pieces of equal duration over the whole recording, N; for a picture.
    pub envelope_n: Vec<[f64; 2]>,
}

/// One contact.
///
/// ```
/// use gaitcam::force::{Feet, ReadOptions, RejectReason, force_curve};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// // The recording begins while the right foot stands.
/// let curve = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let first = curve.recording.unwrap().contacts[0].clone();
/// assert_eq!((first.from_s, first.rejected), (0.0, Some(RejectReason::CutAtStart)));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Its column.
    pub column: usize,
    /// The foot, where it is known.
    pub foot: Option<Foot>,
    /// Start on the file's own clock, s.
    pub from_s: f64,
    /// End, s.
    pub to_s: f64,
    /// Why it is not used; `None` where it is.
    pub rejected: Option<RejectReason>,
}

impl Interpretation {
    /// Gathers what was found in a recording; `cycle` is `None` where it was refused.
    pub fn of(
        file: &str,
        recording: &Recording,
        stances: &Stances,
        cycle: Option<&Cycle>,
        feet: Feet,
    ) -> Interpretation {
        let r = recording;
        let given = r.mass_kg.zip(r.mass_from);
        let notes = r.notes.iter();
        Interpretation {
            file: file.to_string(),
            format: r.format,
            kind: cycle.map(|c| c.kind).or(stances.recognised),
            kind_given: r.kind.is_some(),
            clock: Clock {
                rate_hz: r.rate_hz,
                start_s: r.start_s,
                duration_s: r.duration_s,
                from: r.clock,
            },
            unit: r.unit,
            unit_from: r.unit_from,
            columns: r.channels.iter().map(Column::of).collect(),
            feet,
            contacts: contacts(r, stances, cycle),
            period: cycle.map(|c| Period {
                seconds: c.curve.period_s,
                from: c.period_from,
                spread_s: c.period_spread_s,
            }),
            mass: given.or(cycle.map(|c| (c.mass_kg, c.mass_from))),
            cycle: cycle.map(|c| c.source),
            warnings: match cycle {
                Some(c) => notes.chain(&c.notes).cloned().collect(),
                None => notes.chain(&stances.notes).cloned().collect(),
            },
            overlay: overlay(r, stances, DRAWN),
        }
    }

    /// What is open about kind, clock or mass, each once.
    pub fn doubts(&self) -> Vec<OpenQuestion> {
        let mut all: Vec<OpenQuestion> = self.warnings.iter().filter_map(Note::doubt).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The warnings that open a question.
    pub fn opened_by(&self, question: OpenQuestion) -> Vec<Note> {
        let opens = |n: &&Note| n.doubt() == Some(question);
        self.warnings.iter().filter(opens).cloned().collect()
    }

    /// Codes of the warnings, each once, in the order in which they stand.
    pub fn codes(&self) -> Vec<&'static str> {
        let mut all: Vec<&str> = Vec::new();
        for code in self.warnings.iter().map(Note::code) {
            if !all.contains(&code) {
                all.push(code);
            }
        }
        all
    }

    /// Used contacts, and rejected ones.
    pub fn counts(&self) -> (usize, usize) {
        let used = self.contacts.iter().filter(|c| c.rejected.is_none());
        let used = used.count();
        (used, self.contacts.len() - used)
    }

    /// The mean stances of the picture, left first.
    pub fn means(&self) -> &[MeanStanceCurve] {
        self.overlay.as_ref().map_or(&[], |o| &o.means)
    }

    /// What programs want to know of it.
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

impl Column {
    fn of(channel: &Channel) -> Column {
        Column {
            name: channel.name.clone(),
            foot: channel.foot,
            baseline_n: channel.baseline_n,
            noise_n: channel.noise_n,
            idle: channel.idle,
            envelope_n: envelope(&channel.force_n, PIECES),
        }
    }
}

/// Lowest and highest value of pieces of equal length, so that no peak is lost.
fn envelope(force: &[f64], pieces: usize) -> Vec<[f64; 2]> {
    let length = force.len().div_ceil(pieces).max(1);
    let ends = |piece: &[f64]| {
        piece
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |e, x| {
                [
                    if *x < e[0] { *x } else { e[0] },
                    if *x > e[1] { *x } else { e[1] },
                ]
            })
    };
    force.chunks(length).map(ends).collect()
}

/// Contacts in order of time, on the file's own clock.
fn contacts(r: &Recording, stances: &Stances, cycle: Option<&Cycle>) -> Vec<Contact> {
    // The sum of both feet keeps stances that the mean of one foot leaves out.
    let whole = matches!(
        cycle.map(|c| c.source),
        Some(CycleSource::WholeStrides { .. })
    );
    let used = stances.used.iter().map(|s| Contact {
        column: s.channel,
        foot: s.foot,
        from_s: r.start_s + s.start_s,
        to_s: r.start_s + s.end_s,
        rejected: (s.unlike && !whole).then_some(RejectReason::Unlike),
    });
    let rejected = stances.rejected.iter().map(|x| Contact {
        column: x.channel,
        foot: r.channels.get(x.channel).and_then(|c| c.foot),
        from_s: r.start_s + x.from_s,
        to_s: r.start_s + x.to_s,
        rejected: Some(x.reason),
    });
    let mut all: Vec<Contact> = used.chain(rejected).collect();
    all.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    all
}

/// An enum as its code and its data.
pub(super) fn coded(value: &impl Serialize) -> Value {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_envelope_keeps_every_peak() {
        let mut force = vec![0.0; 10_000];
        force[7_777] = 900.0;
        force[123] = -5.0;
        let e = envelope(&force, 700);
        assert!(e.len() <= 700);
        assert_eq!(e.iter().map(|p| p[1]).fold(0.0, f64::max), 900.0);
        assert_eq!(e.iter().map(|p| p[0]).fold(0.0, f64::min), -5.0);
    }
}
