//! Convex program of a problem for splines or harmonics, with equalities, objective and convex limits.

use std::f64::consts::TAU;

use super::demands::{dwell_demands, implied_by_limits, point_demands};
use crate::error::{Placed, Result, SynthError};
use crate::law::Law;
use crate::poly::{SplineSpace, gauss_legendre};
use crate::problem::{Problem, Target};
use crate::scene::{Dwell, Minimise};
use crate::synth::limits;
use crate::synth::optimum::Formulation;
use crate::synth::qp::{self, Basis, MeanSquare, Program, Quadratic};
use crate::synth::search::Search;
use crate::units::Quantity;

/// Weight of the jerk term relative to the force term, dimensionless. The jerk term determines the law at phases with zero weight. Its effect on
/// the force is far below any required accuracy.
const JERK_TERM: f64 = 1e-12;
/// Maximum number of equality constraints of a law. The cost of solving their dense system is cubic in this number.
const MOST_DEMANDS: usize = 2000;
/// Minimum number of quadrature nodes per half wave of the highest harmonic.
const HARMONIC_NODES: usize = 8;
/// Number of quadrature nodes per span for the response of a floor.
const FLOOR_NODES: usize = 16;
/// Distance, rad, below which the edge of a weighted range and a break between spans coincide.
const SAME_ANGLE: f64 = 1e-12;

/// Program of a spline law without limits, and its force-error objective as a separate term.
pub fn unlimited(problem: &Problem, search: &Search, spans: usize) -> Result<(Program, Quadratic)> {
    let (basis, whole, force) = problem.objective_over(spans, || objective(problem, spans))?;
    let mut equalities = point_demands(problem, &basis)?;
    equalities.extend(implied_by_limits(problem, search, &basis));
    equalities.extend(dwell_demands(&problem.law.dwells, &basis));
    if equalities.len() > MOST_DEMANDS {
        let (given, most) = (equalities.len(), MOST_DEMANDS);
        return Err(SynthError::ManyDemands { given, most }.at_key("law"));
    }
    let mut program = Program::new(basis, whole, equalities, problem.length());
    qp::sizes::declare(&mut program);
    program.halt = search.halt.clone();
    Ok((program, force))
}

/// Program of a spline law with all convex limits.
pub fn of_spline(problem: &Problem, search: &Search, spans: usize) -> Result<Formulation> {
    let stiffness = stiffness(problem);
    let (mut program, force) = unlimited(problem, search, spans)?;
    limits::constrain(problem, search, &mut program, mean_square);
    Ok(Formulation {
        program,
        force,
        stiffness,
        above_base_circle: (!search.below_base_circle).then(|| limits::above_base_circle(problem)),
        pieces: spans,
    })
}

/// Program that fits the force with a given number of harmonics under all convex limits. `unlimited` is the law without limits. If neither
/// the drive nor a condition fixes the level of the lift, the law touches its base circle where `unlimited` has its minimum.
pub fn of_harmonics(
    problem: &Problem,
    search: &Search,
    count: usize,
    unlimited: &Law,
) -> Formulation {
    let stiffness = stiffness(problem);
    let basis = Basis::Harmonic { count };
    let force = through_floor(problem, &basis, force_distance(problem, &basis));
    let mut program = Program::new(basis, force.clone(), Vec::new(), problem.length());
    qp::sizes::declare(&mut program);
    program.halt = search.halt.clone();
    limits::constrain(problem, search, &mut program, mean_square);
    if !problem.level_is_known() {
        program.count_from(unlimited.extremes(0).0.at);
    }
    Formulation {
        program,
        force,
        stiffness,
        above_base_circle: (!search.below_base_circle).then(|| limits::above_base_circle(problem)),
        pieces: 2 * count,
    }
}

/// Convexity α of the objective: its quadratic part is at least ½ α mean(s″²), where s is the lift. `None` if no such α > 0 is known.
fn stiffness(problem: &Problem) -> Option<f64> {
    let inertia = problem.drive.weights()[2];
    let at_once = problem.through_floor().map_or(1.0, |floor| floor.at_once);
    let force = problem.least_weight() * inertia * inertia * at_once;
    let alpha = match problem.objective() {
        Minimise::ForceError => force,
        Minimise::Energy(order) if order >= 2 => 1.0,
        Minimise::Energy(_) | Minimise::Peak(_) | Minimise::PeakForceError | Minimise::Size => 0.0,
    };
    (alpha > 0.0).then_some(alpha)
}

/// Basis, objective of the problem, and the force-error objective as a separate term.
fn objective(problem: &Problem, spans: usize) -> Result<(Basis, Quadratic, Quadratic)> {
    let degree = problem.spline_degree;
    let corners = if problem.law.polydyne { degree - 1 } else { 2 };
    let basis = spline_basis(degree, spans, &problem.law.dwells, corners)?;
    let mut force = force_distance(problem, &basis);
    let mut whole = match problem.objective() {
        Minimise::ForceError => {
            force = through_floor(problem, &basis, force);
            force.clone()
        }
        _ => Quadratic::zero(&basis),
    };
    match problem.objective() {
        Minimise::Energy(order) => whole.add_energy(&basis, order, 1.0),
        Minimise::Peak(_) | Minimise::PeakForceError => {}
        Minimise::Size => {
            let length = problem.length() * problem.lever();
            whole.add_energy(&basis, 3, qp::smoothing(length, problem.length()));
        }
        Minimise::ForceError => {
            let scale = whole.hessian.largest_diagonal();
            let mut jerk = Quadratic::zero(&basis);
            jerk.add_energy(&basis, 3, 1.0);
            let own = jerk.hessian.largest_diagonal();
            if own > 0.0 {
                whole.add(&jerk, JERK_TERM * scale / own);
            }
        }
    }
    if problem.objective() != Minimise::ForceError {
        whole = through_floor(problem, &basis, whole);
    }
    Ok((basis, whole, force))
}

/// Objective with the added effect of the floor response. On a rigid floor, the objective is unchanged.
fn through_floor(problem: &Problem, basis: &Basis, whole: Quadratic) -> Quadratic {
    let Some(through) = problem.through_floor() else {
        return whole;
    };
    let mut out = match through.minimised {
        Minimise::ForceError => whole.times(through.at_once),
        _ => whole,
    };
    let (weights, rule) = (problem.drive.weights(), gauss_legendre(FLOOR_NODES));
    for (piece, ends) in basis.breaks().windows(2).enumerate() {
        let width = ends[1] - ends[0];
        for &(u, part) in &rule {
            let factor = part * width / TAU * through.slope_at(ends[0] + u * width);
            for (i, entry) in basis.row_on(piece, u, &weights) {
                out.gradient[i] += factor * entry;
            }
        }
    }
    out.constant += through.constant;
    out
}

/// Periodic splines over the turn with `spans` spans outside the dwells. At the ends of the dwells, the splines have `smooth` continuous
/// derivatives.
fn spline_basis(degree: usize, spans: usize, dwells: &[Dwell], smooth: usize) -> Result<Basis> {
    if dwells.is_empty() {
        let space = SplineSpace::periodic_uniform(degree, spans, TAU);
        return Ok(Basis::Spline {
            space,
            closed: true,
        });
    }
    let rests = rests(dwells)?;
    let mut corners: Vec<f64> = rests
        .iter()
        .flat_map(|r| [r.0, r.1])
        .filter(|x| *x > 0.0 && *x < TAU)
        .collect();
    corners.sort_by(f64::total_cmp);
    corners.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    let ends: Vec<f64> = std::iter::once(0.0)
        .chain(corners.iter().copied())
        .chain([TAU])
        .collect();
    let resting = |mid: f64| rests.iter().any(|r| mid > r.0 && mid < r.1);
    let moving: f64 = ends
        .windows(2)
        .filter(|w| !resting(0.5 * (w[0] + w[1])))
        .map(|w| w[1] - w[0])
        .sum();
    let mut breaks = vec![0.0];
    let mut multiplicity = Vec::new();
    // Only the breaks between a dwell and a motion have a reduced smoothness. At all other breaks, the splines are C^(degree − 1).
    let corner = degree.saturating_sub(smooth).max(1);
    for w in ends.windows(2) {
        let rests_here = resting(0.5 * (w[0] + w[1]));
        let parts = if rests_here {
            1
        } else {
            ((spans as f64 * (w[1] - w[0]) / moving).round() as usize).max(1)
        };
        let is_corner = w[0] > 0.0 || (resting(0.5 * (w[0] + w[1])) != resting(TAU - 1e-9));
        multiplicity.push(if is_corner { corner } else { 1 });
        for p in 1..=parts {
            let x = if p == parts {
                w[1]
            } else {
                w[0] + (w[1] - w[0]) * p as f64 / parts as f64
            };
            breaks.push(x);
            if p < parts {
                multiplicity.push(1);
            }
        }
    }
    let space = SplineSpace::periodic(degree, &breaks, &multiplicity);
    Ok(Basis::Spline {
        space,
        closed: true,
    })
}

/// Angle ranges of the dwells, rad, within [0, 2π]. A dwell that contains the angle 0 is split there.
fn rests(dwells: &[Dwell]) -> Result<Vec<(f64, f64)>> {
    let mut out = Vec::new();
    for (i, d) in dwells.iter().enumerate() {
        let key = format!("law.dwell[{}]", i + 1);
        let inside = |x: f64| (-1e-9..=TAU + 1e-9).contains(&x);
        if !inside(d.from) || !inside(d.to) || d.from == d.to {
            return Err(SynthError::NoRange {
                start: Quantity::angle(d.from),
                end: Quantity::angle(d.to),
            }
            .at_key(&key));
        }
        let (from, to) = (d.from.clamp(0.0, TAU), d.to.clamp(0.0, TAU));
        if from < to {
            out.push((from, to));
        } else {
            out.push((from, TAU));
            out.push((0.0, to));
        }
    }
    let mut sorted = out.clone();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    if sorted.windows(2).any(|w| w[0].1 > w[1].0 + 1e-12) {
        return Err(SynthError::DwellsOverlap.at_key("law.dwell"));
    }
    if (sorted.iter().map(|r| r.1 - r.0).sum::<f64>() - TAU).abs() < 1e-9 {
        return Err(SynthError::DwellsFillTurn.at_key("law.dwell"));
    }
    out.retain(|r| r.1 > r.0);
    Ok(out)
}

/// Force-error objective ½ mean((F − F*)²) over the turn, with the weights of the problem. F is the force of the law and F* the target
/// force. The objective is 0 without a target force.
fn force_distance(problem: &Problem, basis: &Basis) -> Quadratic {
    match &problem.target {
        Some(target) if problem.is_weighed() => weighed_distance(problem, basis, target),
        _ => plain_distance(problem, basis),
    }
}

/// Force-error objective without weights.
fn plain_distance(problem: &Problem, basis: &Basis) -> Quadratic {
    let mut force = Quadratic::zero(basis);
    if let Some((target, wanted)) = wanted(problem, basis) {
        let w = problem.drive.weights();
        force.add_distance(basis, &w, wanted.nodes, wanted.filling(), None);
        if wanted.is_nearest {
            force.constant = 0.5 * target.mean_square_from(problem.drive.rest_force);
        }
    }
    force
}

/// Force error as a root mean square, for a limit or an objective.
fn mean_square(problem: &Problem, basis: &Basis) -> MeanSquare {
    let Some((target, wanted)) = wanted(problem, basis) else {
        return MeanSquare::distance(basis, &[0.0], 1, |_, _, _, out| out.fill(0.0));
    };
    let w = problem.drive.weights();
    let sum = MeanSquare::distance(basis, &w, wanted.nodes, wanted.filling());
    if wanted.is_nearest {
        sum.with_mean_square(target.mean_square_from(problem.drive.rest_force))
    } else {
        sum
    }
}

/// Required values of the law-dependent part of the force at the quadrature nodes of every span, N. They are the target force minus the
/// force at rest.
struct RequiredForce {
    nodes: usize,
    values: Vec<f64>,
    /// Whether the values come from the least-squares polynomials on the spans instead of the target itself.
    is_nearest: bool,
}

impl RequiredForce {
    /// Function that writes the values of the next span at each call.
    fn filling(&self) -> impl FnMut(f64, f64, &[(f64, f64)], &mut [f64]) {
        let mut pieces = self.values.chunks_exact(self.nodes);
        move |_, _, _, out| out.copy_from_slice(pieces.next().unwrap_or_default())
    }
}

/// Target and its values for a basis; `None` without a target force. For splines, the least-squares polynomial on each span replaces the target.
fn wanted<'a>(problem: &'a Problem, basis: &Basis) -> Option<(&'a Target, RequiredForce)> {
    let target = problem.target.as_ref()?;
    let breaks = basis.breaks();
    let (nodes, mut values, is_nearest) = match basis {
        Basis::Spline { space, .. } => {
            let degree = space.degree();
            (degree + 1, target.nearest(&breaks, degree), true)
        }
        Basis::Harmonic { .. } => {
            let rule = gauss_legendre(harmonic_nodes(basis, target));
            let nodes = rule.len();
            let mut values = vec![0.0; nodes * (breaks.len() - 1)];
            for (ends, out) in breaks.windows(2).zip(values.chunks_exact_mut(nodes)) {
                target.cells().on((ends[0], ends[1] - ends[0]), &rule, out);
            }
            (nodes, values, false)
        }
    };
    (values.iter_mut()).for_each(|f| *f -= problem.drive.rest_force);
    let wanted = RequiredForce {
        nodes,
        values,
        is_nearest,
    };
    Some((target, wanted))
}

/// Number of quadrature nodes per span, sufficient for the harmonics and for the samples of the target.
fn harmonic_nodes(basis: &Basis, target: &Target) -> usize {
    let pieces = basis.breaks().len() - 1;
    HARMONIC_NODES.max(target.samples().div_ceil(pieces))
}

/// Weighted force-error objective, by quadrature on every range over which law and weight are smooth (theory §9).
fn weighed_distance(problem: &Problem, basis: &Basis, target: &Target) -> Quadratic {
    let mut force = Quadratic::zero(basis);
    let (w, rest) = (problem.drive.weights(), problem.drive.rest_force);
    let own = basis.breaks();
    let breaks = merged(&own, &problem.weight_edges());
    let (nodes, nearest) = match basis {
        Basis::Spline { space, .. } => {
            let nodes = space.degree() + 1;
            (nodes, Some(target.nearest(&breaks, space.degree())))
        }
        Basis::Harmonic { .. } => (harmonic_nodes(basis, target), None),
    };
    let rule = gauss_legendre(nodes);
    let mut values = vec![0.0; nodes];
    for (range, ends) in breaks.windows(2).enumerate() {
        let (start, width) = (ends[0], ends[1] - ends[0]);
        let middle = start + 0.5 * width;
        let piece = own.partition_point(|b| *b <= middle) - 1;
        let along = |u: f64| (start + u * width - own[piece]) / (own[piece + 1] - own[piece]);
        match &nearest {
            Some(all) => values.copy_from_slice(&all[range * nodes..(range + 1) * nodes]),
            None => target.cells().on((start, width), &rule, &mut values),
        }
        let weight = problem.weight(middle) * width / TAU;
        for (&(u, part), value) in rule.iter().zip(&values) {
            let row = basis.row_on(piece, along(u), &w);
            force.add_row(&row, part * weight, value - rest);
        }
    }
    force.constant = 0.5 * weighed_square(problem, target, rest);
    force
}

/// Weighted mean square difference between the target and a constant force, N². Four quadrature nodes per cell of the target are exact.
fn weighed_square(problem: &Problem, target: &Target, rest: f64) -> f64 {
    let count = target.cells().count();
    let cells: Vec<f64> = (0..=count).map(|i| TAU * i as f64 / count as f64).collect();
    let rule = gauss_legendre(4);
    let mut values = [0.0; 4];
    let breaks = merged(&cells, &problem.weight_edges());
    let of = |ends: &[f64]| {
        let (start, width) = (ends[0], ends[1] - ends[0]);
        target.cells().on((start, width), &rule, &mut values);
        let square = rule
            .iter()
            .zip(&values)
            .map(|((_, w), f)| w * (f - rest).powi(2));
        problem.weight(start + 0.5 * width) * width / TAU * square.sum::<f64>()
    };
    breaks.windows(2).map(of).sum()
}

/// Sorted breaks from 0 to 2π with additional edges, rad. Edges that coincide with a break are omitted.
fn merged(breaks: &[f64], edges: &[f64]) -> Vec<f64> {
    let apart = |x: &f64| breaks.iter().all(|b| (b - x).abs() > SAME_ANGLE);
    let mut out: Vec<f64> = (breaks.iter().copied())
        .chain(edges.iter().copied().filter(apart))
        .collect();
    out.sort_by(f64::total_cmp);
    out
}
