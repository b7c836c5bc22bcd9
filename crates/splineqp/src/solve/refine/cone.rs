//! Refinement of a program with second-order cones, by tangents of the cones.

use super::on_contacts;
use crate::Names;
use crate::basis::Entries;
use crate::poly::Peak;
use crate::program::{Cone, Program, Row, Solution};

/// Optimum of a program with cones near a solution. Each cone is replaced by its tangents head ≥ tail·tail₀/‖tail₀‖, which all points of
/// the cone satisfy. Each tangent is computed at the previous optimum. The iteration ends when the head equals the norm. `None` if the norm
/// is zero (tip of the cone), or if the iteration fails.
pub fn on_cones<N: Names>(program: &Program<N>, start: &Solution<N>) -> Option<Solution<N>> {
    let settings = &program.settings.refinement;
    let mut flat = program.clone();
    flat.cones.clear();
    let mut current = start.clone();
    let costs = program.cones.iter().map(|c| program.cost[c.head]);
    let mut multipliers: Vec<f64> = costs.collect();
    for _ in 0..settings.steps {
        let norm = |cone: &Cone<N>| cone.norm(&current.extra);
        if program.cones.iter().any(|c| norm(c) <= 0.0) {
            return None;
        }
        let is_met = |c: &Cone<N>| {
            (norm(c) - current.extra[c.head]).abs() <= settings.resolved * norm(c)
                && current.active.iter().any(|r| is_tangent(c, r))
        };
        if program.cones.iter().all(is_met) {
            current
                .active
                .retain(|r| !program.cones.iter().any(|c| is_tangent(c, r)));
            for cone in &program.cones {
                let least = cone.norm(&current.extra);
                current.extra[cone.head] = current.extra[cone.head].max(least);
            }
            current.violation = program.violation(&current.x, &current.extra);
            return Some(current);
        }
        for (cone, &multiplier) in program.cones.iter().zip(&multipliers) {
            let tangent = tangent(cone, &current, multiplier);
            current.active.retain(|r| !is_tangent(cone, r));
            current.active.push(tangent.clone());
            flat.fixed.push(tangent);
        }
        current = on_contacts(&flat, &current)?;
        for (cone, multiplier) in program.cones.iter().zip(&mut multipliers) {
            let tangents = current.active.iter().filter(|r| is_tangent(cone, r));
            *multiplier = tangents.map(|r| r.multiplier).sum();
        }
    }
    None
}

fn is_tangent<N: Names>(cone: &Cone<N>, row: &Row<N>) -> bool {
    row.limit.is_none() && row.entries.is_empty() && row.name == cone.name
}

/// Tangent of a cone at a solution, as a row with the given multiplier.
fn tangent<N: Names>(cone: &Cone<N>, at: &Solution<N>, multiplier: f64) -> Row<N> {
    let mut tangent = Row {
        multiplier,
        ..Row::of_no_limit(cone.name, Peak::default(), Entries::new(), 0.0)
    };
    tangent.extra[cone.head] = -1.0;
    for &k in &cone.tail {
        tangent.extra[k] = at.extra[k] / cone.norm(&at.extra);
    }
    tangent
}
