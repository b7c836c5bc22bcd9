//! Refinement of a program whose size is the cone R ≥ √(D² + e²), D the rise and e the offset of a roller's centre.

use super::on_contacts;
use crate::Names;
use crate::basis::Entries;
use crate::poly::Peak;
use crate::program::{OFFSET, Program, RADIUS, RISE, Row, Solution};

/// The optimum of a program with a cone near a solution, by tangents R ≥ (D, e)·(D₀, e₀)/R₀, which all sizes of the cone keep:
/// each is taken where the sizes of the last optimum lie, and R is at last what the cone asks for. `None` at its tip.
pub fn on_cone<N: Names>(program: &Program<N>, start: &Solution<N>) -> Option<Solution<N>> {
    let settings = &program.settings.refinement;
    let name = program.limits.iter().find(|l| l.extra[RADIUS] != 0.0)?.name;
    let mut flat = program.clone();
    flat.cone = false;
    let mut current = start.clone();
    let mut multiplier = program.cost[RADIUS];
    for _ in 0..settings.steps {
        let least = current.extra[RISE].hypot(current.extra[OFFSET]);
        if least <= 0.0 {
            return None;
        }
        let is_tangent = |r: &Row<N>| r.limit.is_none() && r.entries.is_empty();
        let is_last = (least - current.extra[RADIUS]).abs() <= settings.resolved * least;
        if is_last && current.active.iter().any(is_tangent) {
            current.active.retain(|r| !is_tangent(r));
            current.extra[RADIUS] = current.extra[RADIUS].max(least);
            current.violation = program.violation(&current.x, &current.extra);
            return Some(current);
        }
        let mut tangent = Row {
            multiplier,
            ..Row::of_no_limit(name, Peak::default(), Entries::new(), 0.0)
        };
        tangent.extra[RADIUS] = -1.0;
        for k in [RISE, OFFSET] {
            tangent.extra[k] = current.extra[k] / least;
        }
        current.active.retain(|r| !is_tangent(r));
        current.active.push(tangent.clone());
        flat.fixed.push(tangent);
        current = on_contacts(&flat, &current)?;
        let tangents = current.active.iter().filter(|r| is_tangent(r));
        multiplier = tangents.map(|r| r.multiplier).sum();
    }
    None
}
