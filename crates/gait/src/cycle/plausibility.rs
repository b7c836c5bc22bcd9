//! Plausibility of a mean cycle: ranges of walking and running, and comparison of mean force and mass.

use std::ops::Range;

use crate::curve::ForceCurve;
use crate::quantity::{kilograms, newtons, seconds, share, short};
use crate::recording::{Feet, Kind, Note, WeightShare};
use crate::units::G;

/// Maximum relative difference between mean force and weight that a calibration error can cause.
const TOLERANCE: f64 = 0.1;
/// Plausible range of the mass of a person on force plates, kg.
const MASS_KG: Range<f64> = 10.0..250.0;
/// Range of masses of adults, kg. A mass in this range confirms an assumed unit of force.
pub(super) const ADULT_KG: Range<f64> = 30.0..160.0;
/// Mass below which a walker counts as a child, kg.
const CHILD_KG: f64 = 30.0;
/// Maximum stride time of a small child, s, and maximum mass of a small child, kg. A smaller mass with a longer stride time is implausible.
const SMALL_CHILD: (f64, f64) = (1.15, 22.0);

/// Plausible and typical ranges of the gait parameters of a movement.
pub(super) struct Ranges {
    /// Range of stride durations, s.
    pub stride_s: Range<f64>,
    /// Range of the duty factor: fraction of a stride in which a foot is on the ground.
    pub duty: Range<f64>,
    /// Range of the maximum force of a stance, in body weights.
    pub peak_bw: Range<f64>,
    /// Typical duty factor of the movement.
    pub usual_duty: f64,
    /// Typical range of the ratio of stride duration to stance duration.
    pub stride_of_stance: Range<f64>,
    /// Typical range of the ratio of step duration to stance duration.
    pub step_of_stance: Range<f64>,
}

/// Ranges of walking (wider for children) or of running. If `slow`, the user stated that the movement is walking, so longer strides are
/// plausible.
pub(super) fn ranges(kind: Kind, mass_kg: f64, slow: bool) -> Ranges {
    if kind == Kind::Running {
        return Ranges {
            stride_s: 0.35..1.1,
            duty: 0.12..0.5,
            peak_bw: 1.3..5.0,
            usual_duty: 0.36,
            stride_of_stance: 1.7..7.0,
            step_of_stance: 0.9..3.5,
        };
    }
    let child = mass_kg < CHILD_KG;
    let slowest = if slow { 6.0 } else { 2.2 };
    Ranges {
        stride_s: if child { 0.5 } else { 0.7 }..slowest,
        duty: 0.52..0.75,
        peak_bw: 0.85..if child { 2.0 } else { 1.7 },
        usual_duty: 0.62,
        stride_of_stance: 1.0..2.5,
        // Feet that land at the same time, as in jumping or standing, do not make alternating steps. The lower limit excludes them.
        step_of_stance: 0.4..1.2,
    }
}

/// Mean force of a cycle divided by the weight that its feet carry; 1 for a correct mass, `None` without a mass.
pub fn mean_of_weight(curve: &ForceCurve, feet: Feet) -> Option<f64> {
    Some(curve.mean_n() / (feet.share() * curve.mass_kg? * G))
}

/// Reason why mean force and mass are inconsistent with a single walker; `None` if they are consistent.
pub fn implausible(curve: &ForceCurve, feet: Feet) -> Option<Note> {
    let ratio = mean_of_weight(curve, feet)?;
    let mass_kg = curve.mass_kg?;
    let mass = kilograms(mass_kg);
    if (ratio - 1.0).abs() > TOLERANCE {
        let share = match feet {
            Feet::Both | Feet::Total => WeightShare::Whole,
            Feet::One | Feet::Left | Feet::Right => WeightShare::Half,
        };
        let ratio = short(ratio);
        return Some(Note::MeanForceNotWeight { ratio, mass, share });
    }
    let mean = newtons(curve.mean_n());
    let small = mass_kg < SMALL_CHILD.1 && curve.period_s > SMALL_CHILD.0;
    (small || !MASS_KG.contains(&mass_kg)).then_some(Note::MassImplausible { mean, mass })
}

/// Notes on a stride time, duty factor or peak force outside the ranges of the movement.
///
/// `stance_s` is the mean duration of a stance, s. `peak_n` is the mean of the maximum forces of the stances, N.
pub(super) fn out_of_range(
    ranges: &Ranges,
    period_s: f64,
    mass_kg: f64,
    stance_s: Option<f64>,
    peak_n: Option<f64>,
) -> Vec<Note> {
    let mut notes = Vec::new();
    let percent = |r: &Range<f64>| [share(r.start), share(r.end)];
    if !ranges.stride_s.contains(&period_s) {
        notes.push(Note::StrideImplausible {
            period: seconds(period_s),
            low: seconds(ranges.stride_s.start),
            high: seconds(ranges.stride_s.end),
        });
    }
    let duty = stance_s.map(|s| s / period_s);
    if let Some(duty) = duty.filter(|d| !ranges.duty.contains(d)) {
        let duty = share(duty);
        let [low, high] = percent(&ranges.duty);
        notes.push(Note::DutyImplausible { duty, low, high });
    }
    let ratio = peak_n.map(|p| p / (mass_kg * G));
    if let Some(ratio) = ratio.filter(|r| !ranges.peak_bw.contains(r)) {
        let (ratio, low, high) = (short(ratio), ranges.peak_bw.start, ranges.peak_bw.end);
        notes.push(Note::PeakImplausible { ratio, low, high });
    }
    notes
}
