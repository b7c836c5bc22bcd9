//! The mean cycle of a recording, on phase, with its step-to-step spread.
//!
//! Where the plates (or insoles) cover whole strides, both feet are summed and the strides averaged.
//! Elsewhere a stride is built from single stances: the mean left and the mean right one, half a stride apart.

mod average;
mod overlay;
mod stride;
mod stride_time;
mod total;

use std::f64::consts::SQRT_2;
use std::path::Path;

use average::{Mean, mean_stance, place};
use stride::{Stride, alternate, sample_stride, whole_strides};
use stride_time::{has_rows, stride_time};
use total::total_stride;

use super::curve::{ForceCurve, SAMPLES};
use super::feet::Feet;
use super::plausibility::{doubt, mean_of_weight};
use super::read::{one_cycle, read};
use super::recording::{Foot, ReadOptions, Recording};
use super::stance::{Stance, Stances, Why, same_foot, stances};
use crate::error::{Error, Place, Result};
use crate::units::G;

pub use overlay::{Overlay, overlay};

/// A stride whose duration is further than this from the middle one is not averaged.
const ODD_STRIDE: f64 = 0.25;

/// One mean cycle of a recording and how it was come by.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// The mean cycle; its period is a stride, its spread the standard deviation from step to step.
    pub curve: ForceCurve,
    /// Cycles that were averaged: whole strides, or stances where the stride was built from them.
    pub averaged: usize,
    /// How the cycle was come by, in words.
    pub how: String,
    /// Coefficient of repeatability, N: two cycles of this walker differ by less in 95 of 100 cases
    /// (1.96 √2 times the standard deviation, root mean square over the phases). `None` for one cycle.
    pub repeatability_n: Option<f64>,
    /// Mass, kg: given, or the mean force over the stride divided by g.
    pub mass_kg: f64,
    /// Where the mass is from: "user", "file", "mean force over the stride".
    pub mass_from: String,
    /// Mean force over the cycle as a part of the weight that the feet of the cycle carry: 1 for a walker
    /// whose mass is right.
    pub mean_of_weight: f64,
    /// Whether mean force and mass can be of one walker.
    pub mass_fits: bool,
    /// What a person should doubt.
    pub notes: Vec<String>,
}

impl Cycle {
    /// Holds the mean force against the weight, and says what the mass rests on.
    fn weighed(mut self, recording: &Recording, feet: Feet) -> Self {
        self.mean_of_weight = mean_of_weight(&self.curve, feet).unwrap_or(1.0);
        let doubt = doubt(&self.curve, feet);
        self.mass_fits = doubt.is_none();
        self.notes.extend(doubt);
        let words = [&recording.format].into_iter().chain(&recording.notes);
        if recording.mass_kg.is_none() && words.into_iter().any(|w| w.contains("insole")) {
            self.notes.push(format!(
                "the mass of {:.1} kg is the mean of the insoles' totals, which are seldom calibrated: \
                 give --mass to hold it against the walker's",
                self.mass_kg
            ));
        }
        self
    }
}

/// Averages the stances of a recording into one cycle.
///
/// `feet`: both feet summed, one foot (all stances taken alike), or one side. Fails, with the
/// reasons, where there is no whole stance, or none of the wanted side.
pub fn cycle(recording: &Recording, stances: &Stances, feet: Feet) -> Result<Cycle> {
    if stances.used.is_empty() {
        if feet == Feet::Both
            && let Some(t) = total_stride(recording, stances)
        {
            let how = format!(
                "{} stride{} of both feet on one plate, from a rise through the mean force",
                t.strides,
                plural(t.strides)
            );
            let cycle = finish(recording, t.period_s, t.force_n, t.spread_n, t.strides, how)?;
            return Ok(cycle.weighed(recording, feet));
        }
        return Err(no_stance(recording, stances, feet));
    }
    let cycle = match feet {
        Feet::Both => {
            let strides = whole_strides(stances);
            if strides.is_empty() {
                built(recording, stances)
            } else {
                averaged(recording, &strides)
            }
        }
        Feet::One => one_foot(recording, stances, None),
        Feet::Left => one_foot(recording, stances, Some(Foot::Left)),
        Feet::Right => one_foot(recording, stances, Some(Foot::Right)),
    };
    cycle.map(|c| c.weighed(recording, feet))
}

/// Reads one cycle of force from any file that [`read`](super::read) takes.
///
/// A text whose comment says `# cycle` or `# critical points` is one cycle as it stands, whatever `feet` says;
/// in every other file stances are found and averaged into a stride.
pub fn force_curve(
    path: &Path,
    bytes: &[u8],
    options: &ReadOptions,
    feet: Feet,
) -> Result<ForceCurve> {
    if let Some(curve) = one_cycle(path, bytes, options)? {
        return Ok(curve);
    }
    let recording = read(path, bytes, options)?;
    let mean = cycle(&recording, &stances(&recording), feet)
        .map_err(|e| e.at(Place::File(path.to_path_buf())))?;
    let file = path
        .file_name()
        .and_then(|n| n.to_str())
        .unwrap_or("recording");
    let mut curve = mean.curve;
    curve.name = format!("{file}, {}", mean.how);
    Ok(curve)
}

fn no_stance(recording: &Recording, stances: &Stances, feet: Feet) -> Error {
    let error = Error::new(format!(
        "no whole walking stance in {:.2} s of recording",
        recording.duration_s
    ));
    let all =
        |why: Why| !stances.rejected.is_empty() && stances.rejected.iter().all(|r| r.why == why);
    if all(Why::Running) {
        return error
            .help("every contact is one short hump: this is running, and walking is needed");
    }
    if feet != Feet::Both && total_stride(recording, stances).is_some() {
        return error.help(
            "the column is the total of both feet, loaded throughout: ask for feet = \"both\" (--feet both)",
        );
    }
    if let Some(r) = stances.rejected.first() {
        let mut reasons: Vec<&str> = stances.rejected.iter().map(|r| r.why.words()).collect();
        reasons.sort_unstable();
        reasons.dedup();
        return error.help(format!(
            "{} contact{} found, the first from {:.2} to {:.2} s; {}{}",
            stances.rejected.len(),
            if stances.rejected.len() == 1 {
                " was"
            } else {
                "s were"
            },
            r.from_s,
            r.to_s,
            reasons.join("; "),
            recording
                .notes
                .iter()
                .find(|n| n.contains("announces"))
                .map_or(String::new(), |n| format!("; {n}"))
        ));
    }
    let idle: Vec<String> = recording
        .channels
        .iter()
        .filter_map(|c| Some(format!("{} {}", c.name, c.idle.as_ref()?)))
        .collect();
    if idle.is_empty() {
        error.help("no channel rises above 20 N")
    } else {
        error.help(idle.join(", "))
    }
}

/// Mean of whole strides that begin with the same foot.
fn averaged(recording: &Recording, strides: &[Stride]) -> Result<Cycle> {
    let mut durations: Vec<f64> = strides.iter().map(|s| s.end_s - s.start_s).collect();
    durations.sort_by(f64::total_cmp);
    let usual = durations[durations.len() / 2];
    let usual_length = |s: &&Stride| ((s.end_s - s.start_s) / usual - 1.0).abs() < ODD_STRIDE;
    // Strides from left to left and from right to right share their samples; one kind is averaged.
    let count = |foot: Option<Foot>| {
        strides
            .iter()
            .filter(usual_length)
            .filter(|s| s.foot == foot)
            .count()
    };
    let best = [Some(Foot::Right), Some(Foot::Left), None]
        .into_iter()
        .max_by_key(|f| count(*f))
        .unwrap_or(None);
    let mut kept: Vec<&Stride> = strides
        .iter()
        .filter(usual_length)
        .filter(|s| s.foot == best)
        .collect();
    if best.is_none() {
        // Sides unknown: neighbours in the list alternate, every other one starts with the same foot.
        kept = alternate(&kept);
    }
    let mut mean = Mean::new();
    let mut period = 0.0;
    let mut row = vec![0.0; SAMPLES];
    for stride in &kept {
        sample_stride(recording, stride, &mut row);
        mean.add(&row);
        period += stride.end_s - stride.start_s;
    }
    let n = kept.len();
    period /= n as f64;
    let (force, spread) = mean.finish();
    let with = best.map_or("", |f| match f {
        Foot::Left => ", from left heel strike",
        Foot::Right => ", from right heel strike",
    });
    let how = format!("{n} whole stride{} of both feet{with}", plural(n));
    finish(recording, period, force, spread, n, how)
}

/// A stride of both feet built from single stances half a stride apart.
fn built(recording: &Recording, stances: &Stances) -> Result<Cycle> {
    let all: Vec<&Stance> = stances.used.iter().collect();
    let (left, right) = by_side(&all, has_rows(recording));
    let sides = !left.is_empty() && !right.is_empty();
    let (first, second) = if sides {
        (
            mean_stance(recording, &right),
            mean_stance(recording, &left),
        )
    } else {
        (mean_stance(recording, &all), mean_stance(recording, &all))
    };
    let (period, from) = stride_time(
        recording,
        stances,
        first.impulse_ns + second.impulse_ns,
        &first,
    );
    let (mut force, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&first, period, 0.0, &mut force, &mut variance);
    place(&second, period, 0.5, &mut force, &mut variance);
    let n = all.len();
    let known = first.spread.is_some() && second.spread.is_some();
    let spread = known.then(|| variance.iter().map(|v| v.sqrt()).collect());
    let named = all.iter().any(|s| s.foot.is_some());
    let which = match (sides, named) {
        (true, true) => format!("{} right and {} left", first.count, second.count),
        (true, false) => format!(
            "{} of one foot and {} of the other",
            first.count, second.count
        ),
        _ => n.to_string(),
    };
    let how = format!(
        "built from {which} single stance{}, half a stride apart; stride time from {from}",
        plural(n)
    );
    finish(recording, period, force, spread, n, how)
}

/// Stances of the left and of the right foot; where no side is known, of the one and of the other.
///
/// Without sides the feet are told apart by turns, as far as the stances follow each other; the `rows` of a
/// table of stances do not.
fn by_side<'a>(stances: &[&'a Stance], rows: bool) -> (Vec<&'a Stance>, Vec<&'a Stance>) {
    let of = |foot| {
        stances
            .iter()
            .copied()
            .filter(|s| s.foot == Some(foot))
            .collect()
    };
    if stances.iter().any(|s| s.foot.is_some()) {
        return (of(Foot::Left), of(Foot::Right));
    }
    let mut sides = (Vec::new(), Vec::new());
    if rows {
        return sides;
    }
    let mut first = true;
    for (i, s) in stances.iter().enumerate() {
        let same = i
            .checked_sub(1)
            .map_or(Some(true), |j| same_foot(stances[j], s));
        match same {
            Some(same) => first = first == same,
            None => return (Vec::new(), Vec::new()),
        }
        if first { &mut sides.1 } else { &mut sides.0 }.push(*s);
    }
    sides
}

/// One foot over a stride, zero in swing.
fn one_foot(recording: &Recording, stances: &Stances, foot: Option<Foot>) -> Result<Cycle> {
    let wanted: Vec<&Stance> = stances
        .used
        .iter()
        .filter(|s| foot.is_none() || s.foot == foot)
        .collect();
    if wanted.is_empty() {
        let side = foot.map_or("", Foot::name);
        let known = stances.used.iter().any(|s| s.foot.is_some());
        return Err(
            Error::new(format!("no whole stance of the {side} foot")).help(if known {
                "the stances are of the other foot"
            } else {
                "the file does not say which foot is which; use feet = \"one\" or \"both\""
            }),
        );
    }
    let mean = mean_stance(recording, &wanted);
    let (period, from) = stride_time(recording, stances, 2.0 * mean.impulse_ns, &mean);
    let (mut force, mut variance) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    place(&mean, period, 0.0, &mut force, &mut variance);
    let spread = mean
        .spread
        .is_some()
        .then(|| variance.iter().map(|v| v.sqrt()).collect());
    let n = wanted.len();
    let how = format!(
        "{n} stance{} of one foot; stride time from {from}",
        plural(n)
    );
    let mut cycle = finish(recording, period, force, spread, n, how)?;
    if recording.mass_kg.is_none() {
        // One foot carries half of the body over a stride.
        cycle.mass_kg *= 2.0;
        cycle.curve.mass_kg = Some(cycle.mass_kg);
    }
    Ok(cycle)
}

fn finish(
    recording: &Recording,
    period: f64,
    force: Vec<f64>,
    spread: Option<Vec<f64>>,
    averaged: usize,
    how: String,
) -> Result<Cycle> {
    let mut curve = ForceCurve::from_samples(&how, period, force)?;
    let repeatability_n = spread.as_ref().map(|s: &Vec<f64>| {
        let square = s.iter().map(|x| x * x).sum::<f64>() / s.len() as f64;
        1.96 * SQRT_2 * square.sqrt()
    });
    let (mass_kg, mass_from) = match recording.mass_kg {
        Some(m) => (m, recording.mass_from.clone()),
        None => (curve.mean_n() / G, "mean force over the stride".to_string()),
    };
    curve.spread_n = spread;
    curve.mass_kg = Some(mass_kg);
    Ok(Cycle {
        curve,
        averaged,
        how,
        repeatability_n,
        mass_kg,
        mass_from,
        mean_of_weight: 1.0,
        mass_fits: true,
        notes: Vec::new(),
    })
}

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}
