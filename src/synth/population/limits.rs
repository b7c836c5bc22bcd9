//! Limits for every walker. They are combined into one set for the reference machine, and are checked for the machine of each walker.

use crate::cam::Check;
use crate::criterion::{DependsOn, Direction, LimitKind};
use crate::error::Result;
use crate::problem::{Problem, Served, Walkers};
use crate::synth::families::SolvedLaw;
use crate::synth::sizing::checked_cam::{CheckedCam, checked_cam};

/// The problem for the reference machine. Its limits on motion and force are tightened, so that the machine of every walker satisfies the limits
/// of the scene. `loads` is the fraction of the load limits that the reference machine may use.
pub fn for_all(problem: &Problem, walkers: &Walkers, loads: f64) -> Problem {
    let (drive, mut limits) = (problem.drive, problem.limits.clone());
    let fastest = walkers
        .each
        .iter()
        .fold(0.0_f64, |m, w| m.max(w.drive.speed));
    // Bound of the force in the reference machine for which the force in the machine of every walker satisfies its bound.
    let reached = |bound: f64, direction: Direction| {
        let of = |w: &Served| direction.sign() * (bound - w.drive.rest_force) / w.factor;
        let nearest = walkers.each.iter().map(of).fold(f64::INFINITY, f64::min);
        drive.rest_force + direction.sign() * nearest
    };
    for &kind in LimitKind::ALL {
        let facts = kind.facts();
        let for_all = |bound: f64| match facts.depends_on {
            DependsOn::Cam | DependsOn::Vibration => bound,
            DependsOn::Motion(order) => (drive.speed / fastest).powi(order as i32) * bound,
            DependsOn::Force => reached(bound, facts.direction),
            DependsOn::Load => loads * bound,
        };
        limits[kind] = limits[kind].map(for_all);
    }
    problem.with_limits(limits)
}

/// The law with the largest cam that any walker requires. Each limit is checked for the machine of the walker for which it is most
/// critical.
pub fn checked(problem: &Problem, walkers: &Walkers, solved: &SolvedLaw) -> Result<CheckedCam> {
    let extremes = extremes(problem, walkers).into_iter();
    let machines: Vec<Problem> = extremes.map(|w| problem.with_drive(w.drive)).collect();
    let alone = |own| checked_cam(own, &solved.law, solved.circle, None);
    let mut largest = alone(problem)?;
    for own in machines.iter().map(alone) {
        let own = own?;
        let radius = |checked: &CheckedCam| checked.cam.follower.prime_radius();
        if radius(&own) > radius(&largest) {
            largest = own;
        }
    }
    let mut out = largest.at(problem)?;
    for own in &machines {
        let of_walker = largest.at(own)?;
        for (worst, check) in out.checks.iter_mut().zip(of_walker.checks) {
            if worst.name == check.name && check.excess() > worst.excess() {
                *worst = check;
            }
        }
    }
    Ok(out)
}

/// Load limits. The ratio of a load for two walkers varies with the cam angle.
pub fn loads() -> impl Iterator<Item = LimitKind> {
    let is_load = |kind: &LimitKind| kind.facts().depends_on == DependsOn::Load;
    LimitKind::ALL.iter().copied().filter(is_load)
}

/// Fraction to which the load limits have to be reduced after failed checks; `None` if no check of a load limit failed.
pub fn less_loaded(checks: &[Check]) -> Option<f64> {
    let failing = checks.iter().filter(|c| !c.pass);
    let of_loads = failing.filter(|c| loads().any(|kind| c.name == kind));
    let parts = of_loads.map(|c| (c.limit / c.worst).abs());
    parts.reduce(f64::min)
}

/// Walkers that include the most critical walker for every limited quantity.
///
/// Force, torque and torque rate are linear in the force at rest R and in the factor β of the walker. Power is linear in ωR and ωβ, with
/// the shaft speed ω of the walker. Pressure increases with the force, and motion with ω. Each quantity is thus linear in a pair of values
/// for each walker, or increases with such a linear quantity. The maximum over all walkers is therefore reached at a corner of the convex
/// hull of these pairs. For vibration in a dwell, all walkers are returned.
fn extremes<'w>(problem: &Problem, walkers: &'w Walkers) -> Vec<&'w Served> {
    let each = &walkers.each;
    let vibrates = |kind: &LimitKind| kind.facts().depends_on == DependsOn::Vibration;
    let mut limited = LimitKind::ALL
        .iter()
        .filter(|kind| problem.limits[**kind].is_some());
    if limited.any(vibrates) {
        return each.iter().collect();
    }
    let of = |pair: fn(&Served) -> [f64; 2]| corners(&each.iter().map(pair).collect::<Vec<_>>());
    let mut places = of(|w| [w.drive.rest_force, w.factor]);
    places.extend(of(|w| {
        [w.drive.rest_force, w.factor].map(|x| x * w.drive.speed)
    }));
    places.extend(of(|w| [w.drive.speed, 0.0]));
    places.sort_unstable();
    places.dedup();
    places.into_iter().map(|i| &each[i]).collect()
}

/// Indices of the corners of the convex hull of points, by Andrew's method (1979): a lower and an upper chain from left to right.
fn corners(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let key = |i: &usize| points[*i];
    order.sort_by(|i, j| {
        let [[a, b], [c, d]] = [key(i), key(j)];
        a.total_cmp(&c).then(b.total_cmp(&d))
    });
    let mut out = Vec::new();
    for sign in [1.0, -1.0] {
        let mut chain: Vec<usize> = Vec::new();
        for &next in &order {
            while let [.., a, b] = chain[..] {
                let [a, b, c] = [points[a], points[b], points[next]];
                let turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                if sign * turn > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(next);
        }
        out.extend(chain);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_hold_the_largest_of_every_linear_function() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(u32::MAX >> 1)
        };
        for count in [1, 2, 3, 50] {
            let mut points: Vec<[f64; 2]> = (0..count).map(|_| [random(), random()]).collect();
            // Points alike and points on a line.
            points.push(points[0]);
            points.push(points[0].map(|x| 2.0 * x));
            let corners = corners(&points);
            for step in 0..720 {
                let (sin, cos) = f64::from(step).to_radians().sin_cos();
                let along = |p: &[f64; 2]| cos * p[0] + sin * p[1];
                let most = points.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
                let own = corners.iter().map(|i| along(&points[*i]));
                let own = own.fold(f64::NEG_INFINITY, f64::max);
                assert!((most - own).abs() < 1e-12, "{count}: {most} {own}");
            }
        }
    }
}
