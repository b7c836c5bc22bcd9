//! Interpretation of a recording, for reports and figures.

use super::stride::recorded_strides;
use super::{Cycle, overlay};
use crate::interpretation::{Clock, Column, Contact, Interpretation};
use crate::recording::{Channel, CycleSource, Feet, Recording};
use crate::stance::{Footfall, RejectReason, Stance, Stances, footfalls};
use crate::statistics::ends;

/// Number of time intervals of a channel in a figure. For each interval, the minimum and maximum force are drawn.
const PIECES: usize = 700;
/// Maximum number of single stances in a figure. The means are computed from all stances.
const DRAWN: usize = 60;

impl Interpretation {
    /// Interpretation of a recording. `cycle` is `None` if the recording was rejected.
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
            strides: match cycle {
                Some(cycle) => cycle.strides.clone(),
                None => recorded_strides(r, stances, false),
            },
            period: cycle.map(|c| c.period),
            mass: given.or(cycle.map(|c| (c.mass_kg, c.mass_from))),
            mass_interval_kg: cycle.and_then(|c| c.mass_interval_kg),
            cycle: cycle.map(|c| c.source),
            warnings: match cycle {
                Some(c) => notes.chain(&c.notes).cloned().collect(),
                None => notes.chain(&stances.notes).cloned().collect(),
            },
            overlay: overlay(r, stances, DRAWN),
        }
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

/// Minimum and maximum force, N, in intervals of equal duration, so that every peak is visible.
fn envelope(force: &[f64], pieces: usize) -> Vec<[f64; 2]> {
    let length = force.len().div_ceil(pieces).max(1);
    let pieces = force.chunks(length).filter_map(ends);
    pieces.map(|(low, high)| [low, high]).collect()
}

/// Contacts in order of time, with times as in the file.
fn contacts(r: &Recording, stances: &Stances, cycle: Option<&Cycle>) -> Vec<Contact> {
    // Whole strides also contain outliers, which a mean of single stances excludes.
    let whole = averages_strides(cycle);
    let contact = |f: &Footfall| {
        let stance = stances.at(f);
        Contact {
            column: f.channel,
            foot: f.foot,
            from_s: r.start_s + f.start_s,
            to_s: r.start_s + f.end_s,
            landmarks: stance.map_or([None; 3], Stance::landmarks),
            impulse_ns: stance.map(|s| s.impulse_ns),
            rejected: f
                .rejected
                .or((f.unlike && !whole).then_some(RejectReason::Unlike)),
        }
    };
    footfalls(r, stances).iter().map(contact).collect()
}

/// Whether a cycle is the mean of whole strides.
fn averages_strides(cycle: Option<&Cycle>) -> bool {
    let source = cycle.map(|c| c.source);
    matches!(source, Some(CycleSource::WholeStrides { .. }))
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
