//! Equality constraints on a spline that result from the points and dwells of the law.

use std::f64::consts::TAU;

use crate::error::{Placed, Result, SynthError};
use crate::poly::Span;
use crate::problem::Problem;
use crate::scene::{Dwell, LimitKind};
use crate::synth::qp::{Basis, Demand, Entries, Equality, Given};
use crate::synth::search::Search;
use crate::units::Quantity;

/// Equality constraints for lift, velocity, acceleration, jerk and force at the points of the law.
pub fn point_demands(problem: &Problem, basis: &Basis) -> Result<Vec<Equality>> {
    let mut out = Vec::new();
    let w = problem.drive.weights();
    for (i, p) in problem.law.points.iter().enumerate() {
        let key = format!("law.point[{}]", i + 1);
        if !(-1e-9..=TAU + 1e-9).contains(&p.angle) {
            return Err(SynthError::PointOutside {
                at: Quantity::angle(p.angle),
            }
            .at_key(&key));
        }
        let mut push = |given: Given, weights: &[f64], value: f64| {
            out.push(Equality {
                name: named(i, p.angle, given),
                entries: basis.row(p.angle, weights),
                value,
            });
        };
        for (order, (given, value)) in [
            (Given::Lift, p.lift),
            (Given::Velocity, p.velocity),
            (Given::Acceleration, p.acceleration),
            (Given::Jerk, p.jerk),
        ]
        .into_iter()
        .enumerate()
        {
            if let Some(value) = value {
                let mut weights = [0.0; 4];
                weights[order] = 1.0;
                push(given, &weights, value);
            }
        }
        if let Some(force) = p.force {
            push(Given::Force, &w, force - problem.drive.rest_force);
        }
    }
    Ok(out)
}

/// Distance from the boundary of the permitted range, relative to the stroke, below which a lift is on the boundary.
const TOUCHES: f64 = 1e-12;

/// Equality constraints that limits and prescribed lifts imply together. At a prescribed lift that equals a bound, the velocity is zero. If
/// the acceleration is prescribed as zero, the jerk is zero too. Without these equalities, the exchange method would add limit rows at
/// angles ever closer to the point, on both sides.
pub fn implied_by_limits(problem: &Problem, search: &Search, basis: &Basis) -> Vec<Equality> {
    let law = &problem.law;
    let dwelt = law.dwells.iter().filter_map(|d| d.lift);
    let lifts = || (law.points.iter().filter_map(|p| p.lift)).chain(dwelt.clone());
    let (least, most) = lifts().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), lift| {
        (a.min(lift), b.max(lift))
    });
    let near = TOUCHES * (most - least).abs();
    let filled =
        (problem.limits[LimitKind::Stroke]).is_some_and(|h| (most - least - h).abs() <= near);
    let touches = |lift: f64| {
        let base = !search.below_base_circle && lift.abs() <= near;
        base || filled && (lift - least <= near || most - lift <= near)
    };
    let mut out = Vec::new();
    for (i, p) in law.points.iter().enumerate() {
        if !p.lift.is_some_and(touches) {
            continue;
        }
        let level = |a: f64| a.abs() <= near;
        let flat = p.acceleration.is_some_and(level) && p.jerk.is_none();
        let orders = [
            p.velocity.is_none().then_some(1),
            (flat && is_smooth(basis, p.angle)).then_some(3),
        ];
        out.extend(orders.into_iter().flatten().map(|order| {
            let mut weights = [0.0; 4];
            weights[order] = 1.0;
            Equality {
                name: named(i, p.angle, Given::Lift),
                entries: basis.row(p.angle, &weights),
                value: 0.0,
            }
        }));
    }
    out
}

/// Whether the jerk is continuous at an angle, rad, for every law that the basis represents.
fn is_smooth(basis: &Basis, angle: f64) -> bool {
    let Basis::Spline { space, .. } = basis else {
        return true;
    };
    let starts = || space.spans().iter().map(|s| s.start);
    let at_break = starts().any(|x| (x - angle).abs() < 1e-9);
    // If every break has multiplicity 1, the number of basis functions equals the number of spans.
    let plain = space.dimension() == space.spans().len();
    !at_break || plain && space.degree() > 3
}

/// Name of an equality constraint on a quantity at a point of the law. `index` counts from 0.
fn named(index: usize, angle: f64, given: Given) -> Demand {
    Demand::AtPoint {
        point: index + 1,
        at: Quantity::angle(angle),
        given,
    }
}

/// Equality constraints that make all coefficients of the spans in a dwell equal to the given lift. Without a given lift, they make the
/// coefficients equal to each other.
pub fn dwell_demands(dwells: &[Dwell], basis: &Basis) -> Vec<Equality> {
    let Basis::Spline { space, .. } = basis else {
        return Vec::new();
    };
    let middle = |span: &Span| span.start + 0.5 * span.width;
    let mut out: Vec<Equality> = Vec::new();
    for (d, dwell) in dwells.iter().enumerate() {
        let name = Demand::InDwell { dwell: d + 1 };
        // The list starts at the first span of the dwell. Adjacent entries are therefore adjacent spans, even across the angle 0.
        let mut spans: Vec<usize> = (0..space.spans().len()).collect();
        spans.rotate_left(
            space
                .spans()
                .iter()
                .filter(|s| middle(s) < dwell.from)
                .count(),
        );
        let mut resting: Vec<usize> = Vec::new();
        for i in spans {
            let mid = middle(&space.spans()[i]);
            let inside = if dwell.from < dwell.to {
                mid > dwell.from && mid < dwell.to
            } else {
                mid > dwell.from || mid < dwell.to
            };
            if inside {
                for k in 0..=space.degree() {
                    let index = space.index(i, k);
                    if !resting.contains(&index) {
                        resting.push(index);
                    }
                }
            }
        }
        let rows: Vec<(Entries, f64)> = match dwell.lift {
            Some(lift) => resting.iter().map(|&i| (vec![(i, 1.0)], lift)).collect(),
            None => resting
                .windows(2)
                .map(|w| (vec![(w[0], 1.0), (w[1], -1.0)], 0.0))
                .collect(),
        };
        out.extend(rows.into_iter().map(|(entries, value)| Equality {
            name,
            entries,
            value,
        }));
    }
    out
}
