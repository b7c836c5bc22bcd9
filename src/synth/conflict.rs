//! Why there is no law: the smallest set of limits that fight, and the least relaxation of each.

use super::answer::{Infeasible, Relaxation};
use super::design::outside_bore;
use super::qp::Quadratic;
use super::qp::{Failure, Limit, PEAK, Program};
use crate::cam::Measures;
use crate::scene::Scene;

/// Explains a program without solution.
pub fn explain(program: &Program, failure: &Failure, measures: Measures) -> Infeasible {
    match failure {
        Failure::Equalities(names) => Infeasible {
            conflict: names.clone(),
            relaxations: Vec::new(),
            words: format!(
                "The demands contradict each other: {} cannot hold beside the others.",
                names.join(", ")
            ),
        },
        Failure::Solver(word) => Infeasible {
            conflict: Vec::new(),
            relaxations: Vec::new(),
            words: format!(
                "The solver stopped without an answer ({word}); the limits are close to leaving nothing."
            ),
        },
        Failure::Infeasible => limits_in_conflict(program, measures),
    }
}

/// Deletion filter over the limits' names, then one elastic solve for each that is left.
fn limits_in_conflict(program: &Program, measures: Measures) -> Infeasible {
    let mut names: Vec<&'static str> = Vec::new();
    for limit in &program.limits {
        if !names.contains(&limit.name) {
            names.push(limit.name);
        }
    }
    let feasible = |kept: &[&'static str]| {
        let mut trial = program.clone();
        trial.limits.retain(|l| kept.contains(&l.name));
        trial.solve().is_ok()
    };
    let mut kept = names.clone();
    for name in &names {
        let without: Vec<&'static str> = kept.iter().copied().filter(|n| n != name).collect();
        if !feasible(&without) {
            kept = without;
        }
    }
    let relaxations: Vec<Relaxation> = kept
        .iter()
        .filter_map(|name| relax(program, name))
        .collect();
    told(&kept, relaxations, measures)
}

/// Limits that fight, in words.
pub fn told(kept: &[&'static str], relaxations: Vec<Relaxation>, measures: Measures) -> Infeasible {
    let conflict: Vec<String> = kept.iter().map(|n| (*n).to_string()).collect();
    let words = format!("{} {}", sentence(&conflict), cured(&relaxations, measures));
    Infeasible {
        conflict,
        relaxations,
        words,
    }
}

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

/// A bore around which no cam fits under the limit on the prime radius, where the scene leaves the size open.
pub fn bore_against_size(scene: &Scene) -> Option<Infeasible> {
    let (bore, limit) = (scene.cam.bore?, scene.limits.prime_radius?);
    let roller = if scene.cam.follower.is_flat() {
        0.0
    } else {
        scene.cam.roller_radius
    };
    let least = outside_bore(scene) + roller;
    let given = scene.cam.base_radius.is_some() || scene.cam.prime_radius.is_some();
    if given || least <= limit {
        return None;
    }
    let smaller = bore - 2.0 * (least - limit);
    let relaxations = vec![
        Relaxation {
            limit: "bore".to_string(),
            from: bore,
            to: (smaller > 0.0).then_some(smaller),
        },
        Relaxation {
            limit: "prime_radius".to_string(),
            from: limit,
            to: Some(least),
        },
    ];
    Some(told(
        &["bore", "prime_radius"],
        relaxations,
        scene.cam.measures(),
    ))
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

/// The smallest bound of one limit that lets the others hold: the same program with that bound minimised.
/// `None` for what is no number of the scene.
fn relax(program: &Program, name: &str) -> Option<Relaxation> {
    let mut elastic = program.clone();
    let nothing = Quadratic::zero(&elastic.basis);
    elastic.hessian = nothing.hessian;
    elastic.gradient = nothing.gradient;
    elastic.lifted = nothing.lifted;
    elastic.limits.retain(|l| !l.is_peak());
    elastic.cost = [0.0; super::qp::EXTRAS];
    elastic.cost[PEAK] = 1.0;
    let is_number = |l: &Limit| l.name == name && l.meaning.value(l.bound).is_some();
    let first = *elastic.limits.iter().find(|l| is_number(l))?;
    let from = first.meaning.value(first.bound)?;
    for limit in elastic.limits.iter_mut().filter(|l| is_number(l)) {
        *limit = limit.minimised();
    }
    let to = elastic
        .solve()
        .ok()
        .and_then(|s| first.meaning.value(s.extra[PEAK]));
    let limit = first.meaning.key(first.name).to_string();
    Some(Relaxation { limit, from, to })
}
