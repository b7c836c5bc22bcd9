//! Plausibility: whether mean force and mass can be of one walker.

use std::ops::Range;

use super::curve::ForceCurve;
use super::feet::Feet;
use super::note::{Note, WeightShare};
use super::quantity::{kilograms, newtons, seconds};
use crate::units::{G, Quantity};

/// A mean force further than this from the weight is no rounding of insoles or of a scale.
const TOLERANCE: f64 = 0.1;
/// Masses of people who walk over plates, kg.
const MASS_KG: Range<f64> = 10.0..250.0;

/// Durations of a stride in walking, s.
const STRIDE_S: Range<f64> = 0.7..2.2;
/// The same of children.
const CHILD_STRIDE_S: Range<f64> = 0.5..2.2;
/// Share of a stride that a foot stands in walking; in running it is less.
const DUTY: Range<f64> = 0.52..0.75;
/// Highest force of a stance in walking, body weights.
const PEAK_BW: Range<f64> = 0.85..1.7;
/// The same of children.
const CHILD_PEAK_BW: Range<f64> = 0.85..2.0;
/// Walkers lighter than this are children, kg.
const CHILD_KG: f64 = 30.0;

/// Mean force of a cycle over the weight that its feet carry: 1 for a walker whose mass is right.
///
/// `None` where no mass is known.
pub fn mean_of_weight(curve: &ForceCurve, feet: Feet) -> Option<f64> {
    let share = match feet {
        Feet::Both => 1.0,
        // One foot carries half of the body over a stride.
        Feet::One | Feet::Left | Feet::Right => 0.5,
    };
    Some(curve.mean_n() / (share * curve.mass_kg? * G))
}

/// Why mean force and mass cannot be of one walker; `None` where they can.
pub fn implausible(curve: &ForceCurve, feet: Feet) -> Option<Note> {
    let ratio = mean_of_weight(curve, feet)?;
    let mass_kg = curve.mass_kg?;
    let mass = kilograms(mass_kg);
    if (ratio - 1.0).abs() > TOLERANCE {
        let share = match feet {
            Feet::Both => WeightShare::Whole,
            Feet::One | Feet::Left | Feet::Right => WeightShare::Half,
        };
        return Some(Note::MeanForceNotWeight { ratio, mass, share });
    }
    let mean = newtons(curve.mean_n());
    (!MASS_KG.contains(&mass_kg)).then_some(Note::MassImplausible { mean, mass })
}

/// What no walker does: a stride, a share of stance or a highest force out of the range of walking.
///
/// `stance_s`: mean duration of a stance; `peak_n`: mean highest force of a stance, N.
pub(super) fn unlike_walking(
    period_s: f64,
    mass_kg: f64,
    stance_s: Option<f64>,
    peak_n: Option<f64>,
) -> Vec<Note> {
    let child = mass_kg < CHILD_KG;
    let (strides, peaks) = if child {
        (CHILD_STRIDE_S, CHILD_PEAK_BW)
    } else {
        (STRIDE_S, PEAK_BW)
    };
    let mut notes = Vec::new();
    if !strides.contains(&period_s) {
        let period = seconds(period_s);
        notes.push(Note::StrideImplausible { period });
    }
    let duty = stance_s.map(|s| s / period_s);
    if let Some(duty) = duty.filter(|d| !DUTY.contains(d)) {
        let duty = Quantity::share(duty);
        notes.push(Note::DutyImplausible { duty });
    }
    let ratio = peak_n.map(|p| p / (mass_kg * G));
    if let Some(ratio) = ratio.filter(|r| !peaks.contains(r)) {
        notes.push(Note::PeakImplausible { ratio });
    }
    notes
}
