//! Conflicts and relaxations as sentences.

use crate::cam::Measures;
use crate::synth::design::Relaxation;

/// Which limits cannot hold together.
pub fn sentence(conflict: &[String]) -> String {
    let list: Vec<String> = conflict.iter().map(|n| spoken(n)).collect();
    match list.len() {
        0 => "The demands alone leave no law.".to_string(),
        1 => format!("No law that meets the demands keeps the {} limit.", list[0]),
        _ => format!("No law keeps these limits together: {}.", list.join(", ")),
    }
}

/// What would help.
pub fn cured(relaxations: &[Relaxation], measures: Measures) -> String {
    let advice: Vec<String> = relaxations
        .iter()
        .filter_map(|r| {
            Some(format!(
                "{} {} instead of {}",
                spoken(&r.limit),
                short(&in_units(measures, &r.limit, r.to?)),
                short(&in_units(measures, &r.limit, r.from))
            ))
        })
        .collect();
    match advice.len() {
        0 => "No single one of them can be relaxed far enough.".to_string(),
        1 => format!("Smallest relaxation: {}.", advice[0]),
        _ => format!("Smallest relaxation, any one of: {}.", advice.join("; ")),
    }
}

/// A value without the zeros that end it.
fn short(value: &str) -> String {
    match value.split_once(' ') {
        Some((number, unit)) if number.contains('.') && !number.contains('e') => {
            let number = number.trim_end_matches('0').trim_end_matches('.');
            format!("{number} {unit}")
        }
        _ => value.to_string(),
    }
}

fn spoken(name: &str) -> String {
    name.replace('_', " ")
}

/// A limit's value in the units people use for it on a cam of these measures.
pub fn in_units(measures: Measures, limit: &str, value: f64) -> String {
    let unit = measures.limit(limit);
    let value = unit.factor * value;
    if value.is_infinite() {
        return "∞".to_string();
    }
    // Six places hide what is smaller.
    unit.after(&if unit.name == "°" {
        format!("{value:.4}")
    } else if value != 0.0 && value.abs() < 1e-4 {
        format!("{value:.4e}")
    } else {
        format!("{value:.6}")
    })
}
