//! Whether a mean force and a mass belong to one walker.

use std::ops::Range;

use super::curve::ForceCurve;
use super::feet::Feet;
use crate::units::G;

/// A mean force further than this from the weight is no rounding of insoles or of a scale.
const DOUBTED: f64 = 0.1;
/// Masses of people who walk over plates, kg.
const MASS_KG: Range<f64> = 10.0..250.0;

/// Mean force of a cycle as a part of the weight that its feet carry over a stride: 1 for a walker whose
/// mass is right. `None` where no mass is known.
pub fn mean_of_weight(curve: &ForceCurve, feet: Feet) -> Option<f64> {
    // One foot carries half of the body over a stride.
    let share = if feet == Feet::Both { 1.0 } else { 0.5 };
    Some(curve.mean_n() / (share * curve.mass_kg? * G))
}

/// Why mean force and mass cannot be of one walker, in words; `None` where they can.
pub fn doubt(curve: &ForceCurve, feet: Feet) -> Option<String> {
    let part = mean_of_weight(curve, feet)?;
    let mass = curve.mass_kg?;
    if (part - 1.0).abs() > DOUBTED {
        let of = if feet == Feet::Both {
            "the"
        } else {
            "half the"
        };
        return Some(format!(
            "the mean force over a stride is {part:.3} times {of} weight of {mass:.1} kg, where a walker's is 1: \
             the mass, the unit of the force or its calibration is wrong, or a foot is missing"
        ));
    }
    (!MASS_KG.contains(&mass)).then(|| {
        format!(
            "a mean force of {:.1} N over a stride is a walker of {mass:.1} kg: the unit of the force or its \
             calibration is wrong, or a foot is missing",
            curve.mean_n()
        )
    })
}
