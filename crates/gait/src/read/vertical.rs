//! Conversion of raw force columns to channels of upward force: component, unit and sign.

use super::baseline;
use super::columns::{says_vertical, words};
use super::cross_talk;
use super::timebase::TimeBase;
use crate::error::{ReadError, Result};
use crate::quantity::newtons;
use crate::recording::{
    Axis, Channel, Foot, ForceUnit, Format, MassSource, Note, ReadOptions, Recording, UnitSource,
};
use crate::statistics::{ends, sample};

/// Maximum plausible ground reaction force of a walker, N.
const HARDEST_N: f64 = 8000.0;
/// Minimum plausible peak of the force of a walker, N.
const SOFTEST_N: f64 = 60.0;

/// Maximum relative root mean square difference between a channel and its copy.
const COPY: f64 = 0.003;
const FILTERED: f64 = 0.05;

/// A raw force column, with the component, foot and unit that its name denotes.
#[derive(Debug)]
pub(super) struct RawForce {
    pub name: String,
    pub axis: Axis,
    pub foot: Option<Foot>,
    pub unit: Option<ForceUnit>,
    pub values: Vec<f64>,
}

/// Data of a file in addition to its force columns.
pub(super) struct Facts {
    pub format: Format,
    /// Whether the forces are those of pressure insoles.
    pub insole: bool,
    pub samples: usize,
    /// Mass of the walker that the file gives, kg.
    pub mass_kg: Option<f64>,
    /// Samples that the file marks as unloaded (first, one past the last).
    pub zero: Option<(usize, usize)>,
    pub notes: Vec<Note>,
}

/// Converts raw columns with their time base to a recording.
pub(super) fn recording(
    mut raw: Vec<RawForce>,
    base: TimeBase,
    facts: Facts,
    options: &ReadOptions,
) -> Result<Recording> {
    let mut notes = facts.notes;
    let stated = options.mass_kg.map(|m| (m, MassSource::User));
    let mass = stated.or(facts.mass_kg.map(|m| (m, MassSource::File)));
    let mass_kg = mass.map(|m| m.0);
    keep_vertical(&mut raw, &mut notes);
    let (unit, unit_from) = unit(&raw, options, &mut notes);
    let factor = unit
        .newtons(mass_kg)
        .ok_or(ReadError::MassMissing { unit: unit.name() })?;
    if base.is_uneven() {
        notes.push(Note::UnevenSamples);
    }
    let opensim_pair = is_opensim_pair(&raw);
    let mut channels = Vec::with_capacity(raw.len());
    for column in raw {
        let mut values = base.resampled(column.values);
        if factor != 1.0 {
            for x in &mut values {
                *x *= factor;
            }
        }
        let mut channel =
            baseline::channel(column.name, values, base.rate_hz, facts.zero, &mut notes);
        channel.foot = column.foot;
        channels.push(channel);
    }
    leave_copies(&mut channels, &mut notes);
    if !facts.insole {
        cross_talk::remove(&mut channels, base.rate_hz, &mut notes);
    }
    if options.mass_kg.is_some() {
        notes.retain(|note| !matches!(note, Note::UnloadedDiffers { .. }));
    }
    if opensim_pair {
        for c in &mut channels {
            let left = c.name.starts_with("1_");
            c.foot = Some(if left { Foot::Left } else { Foot::Right });
        }
        notes.push(Note::FeetGuessed);
    }
    let count = channels.first().map_or(facts.samples, |c| c.force_n.len());
    Ok(Recording {
        format: facts.format,
        insole: facts.insole,
        rate_hz: base.rate_hz,
        start_s: base.start_s,
        clock: base.source,
        unit,
        unit_from,
        kind: options.kind,
        duration_s: count.saturating_sub(1) as f64 / base.rate_hz,
        mass_kg,
        mass_from: mass.map(|m| m.1),
        channels,
        strikes: Vec::new(),
        heels: None,
        gaps_s: base.gaps_s,
        notes,
    })
}

/// Excludes channels that repeat an earlier channel: copies, or the same readings after filtering.
fn leave_copies(channels: &mut Vec<Channel>, notes: &mut Vec<Note>) {
    let mut kept: Vec<Channel> = Vec::with_capacity(channels.len());
    for channel in channels.drain(..) {
        match kept.iter().find(|original| is_copy(&channel, original)) {
            Some(original) => notes.push(Note::ColumnRepeats {
                column: channel.name,
                original: original.name.clone(),
            }),
            None => kept.push(channel),
        }
    }
    *channels = kept;
}

fn is_copy(channel: &Channel, original: &Channel) -> bool {
    let feet = [channel, original].map(|c| c.foot);
    let two_feet = feet[0].is_some() && feet[1].is_some() && feet[0] != feet[1];
    if two_feet || channel.idle.is_some() || original.idle.is_some() {
        return false;
    }
    let [a, b] = [channel, original].map(|c| sample(&c.force_n, 8192));
    let differences = a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    let all = b.iter().map(|x| x * x).sum::<f64>();
    let [name, other] = [channel, original].map(|c| words(&c.name));
    let holds = |a: &[String], b: &[String]| b.iter().all(|word| a.contains(word));
    let is_named_so = holds(&name, &other) || holds(&other, &name);
    let least = if is_named_so { FILTERED } else { COPY };
    a.len() == b.len() && differences < least * least * all
}

/// Whether the columns have the names of OpenSim's examples: `ground_force` for the right foot, `1_ground_force` for the left foot.
fn is_opensim_pair(raw: &[RawForce]) -> bool {
    raw.len() == 2 && raw.iter().all(|r| r.foot.is_none()) && {
        let is = |name: &str| raw.iter().any(|r| r.name.to_lowercase().starts_with(name));
        is("ground_force_v") && is("1_ground_force_v")
    }
}

/// Keeps only the columns of one component: the component that is named vertical, otherwise the component with the largest load.
pub(super) fn keep_vertical(raw: &mut Vec<RawForce>, notes: &mut Vec<Note>) {
    // If plates have named components, a name without a component may be the name of a muscle (`L GRF`).
    if raw.iter().any(|r| r.axis != Axis::Vertical) {
        raw.retain(|r| r.axis != Axis::Vertical || says_vertical(&r.name));
    }
    let named = raw.iter().any(|r| r.axis == Axis::Vertical);
    let keep = if named {
        // In addition to its three components, a plate or foot may have a column without a component. Such a column remains only if its
        // name denotes a vertical or total force. The components are then excluded.
        Axis::Vertical
    } else {
        let present = |a: &Axis| raw.iter().any(|r| r.axis == *a);
        let axes = [Axis::X, Axis::Y, Axis::Z].into_iter().filter(present);
        let mut axes: Vec<(Axis, f64)> = axes.map(|a| (a, swing_of(raw, a))).collect();
        axes.sort_by(|a, b| b.1.total_cmp(&a.1));
        if let [best, second, ..] = axes[..]
            && second.1 > 0.6 * best.1
        {
            notes.push(Note::VerticalGuessed {
                vertical: best.0,
                other: second.0,
            });
        }
        axes.first().map_or(Axis::Vertical, |best| best.0)
    };
    raw.retain(|r| r.axis == keep);
}

/// Maximum deviation of one force component from its resting level, summed over all plates.
fn swing_of(raw: &[RawForce], axis: Axis) -> f64 {
    let columns = raw.iter().filter(|r| r.axis == axis);
    columns.map(|r| swing(&r.values)).sum()
}

/// Maximum deviation of the values from their resting level. The upper and the lower 1 % of the values are ignored as outliers.
fn swing(values: &[f64]) -> f64 {
    let mut thin = sample(values, 8192);
    let Some((low, high)) = ends(&thin) else {
        return 0.0;
    };
    // The resting level is zero. If all readings have the same sign, it is the reading nearest to zero.
    let rest = low.max(0.0) + high.min(0.0);
    let mut reach = |q: f64| {
        let rank = ((thin.len() - 1) as f64 * q) as usize;
        (*thin.select_nth_unstable_by(rank, f64::total_cmp).1 - rest).abs()
    };
    reach(0.99).max(reach(0.01))
}

/// Unit of the columns and its source. The unit given by the user has priority, then a plausible unit in the file, then the unit that fits
/// the magnitude of the readings.
fn unit(raw: &[RawForce], options: &ReadOptions, notes: &mut Vec<Note>) -> (ForceUnit, UnitSource) {
    if let Some(unit) = options.unit {
        return (unit, UnitSource::User);
    }
    let peak = raw.iter().map(|r| swing(&r.values)).fold(0.0, f64::max);
    let believable = |u: ForceUnit| {
        let newtons = peak
            * u.newtons(Some(options.mass_kg.unwrap_or(70.0)))
                .unwrap_or(1.0);
        (SOFTEST_N..=HARDEST_N).contains(&newtons)
    };
    let label = raw.iter().find_map(|r| r.unit);
    if let Some(unit) = label
        && (believable(unit) || peak == 0.0)
    {
        return (unit, UnitSource::File);
    }
    // The readings of an unloaded plate are also only a few newtons. They are interpreted as body weights only if the user gives a mass.
    if label == Some(ForceUnit::Newton) && options.mass_kg.is_none() {
        let peak = newtons(peak);
        notes.push(Note::LowForce { peak });
        return (ForceUnit::Newton, UnitSource::File);
    }
    let level = |r: &RawForce| r.values.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let small = raw.iter().all(|r| level(r) < 60.0);
    let unit = if small && !believable(ForceUnit::Newton) && (0.3..=6.0).contains(&peak) {
        ForceUnit::BodyWeight
    } else {
        ForceUnit::Newton
    };
    if let Some(label) = label.filter(|l| *l != unit) {
        notes.push(Note::UnitLabelRejected { label, peak, unit });
    } else if unit != ForceUnit::Newton {
        notes.push(Note::UnitGuessed { peak, unit });
    }
    (unit, UnitSource::Guessed)
}
