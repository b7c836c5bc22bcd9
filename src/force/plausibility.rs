//! Plausibility: whether mean force and mass can be of one walker.

use std::ops::Range;

use super::curve::ForceCurve;
use super::feet::Feet;
use super::note::{Note, WeightShare};
use super::quantity::{kilograms, newtons};
use crate::units::G;

/// A mean force further than this from the weight is no rounding of insoles or of a scale.
const TOLERANCE: f64 = 0.1;
/// Masses of people who walk over plates, kg.
const MASS_KG: Range<f64> = 10.0..250.0;

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
