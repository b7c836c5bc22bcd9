//! The convex program of a spline: demands, what is minimised, convex limits.

use std::f64::consts::TAU;

use super::demands::{dwell_demands, implied_by_limits, point_demands, spline_basis};
use crate::drive::Drive;
use crate::error::{Placed, Result, SynthError};
use crate::poly::gauss_legendre;
use crate::problem::{Problem, Size, Target};
use crate::scene::{Minimise, Weigh};
use crate::synth::limits;
use crate::synth::qp::{Basis, PEAK, Program, Quadratic};
use crate::synth::search::Search;

/// Weight of the jerk term against the force term, both made dimensionless: it settles what the force
/// leaves open (phases of zero weight) and is far below any accuracy.
const JERK_TERM: f64 = 1e-12;
/// Exact demands on one law: their dense system costs the cube of their number.
const MOST_DEMANDS: usize = 2000;
/// Jerk, in typical lifts per rad³, whose mean square weighs as much as one typical lift of radius when
/// size is minimised: large enough to leave the size alone, small enough to keep the law smooth.
const SIZE_JERK: f64 = 1e3;
/// Objectives over more spans than this are not kept: they take much memory, and more time to solve than to make.
const MOST_KEPT_SPANS: usize = 128;

/// Quadrature nodes on half a wave of the highest harmonic.
const HARMONIC_NODES: usize = 8;
/// Edges of a weight nearer to a break than this stand there, rad.
const SAME_ANGLE: f64 = 1e-12;

/// What an objective depends on beside force and demands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObjectiveKey {
    spans: usize,
    degree: usize,
    minimise: Minimise,
    phase: f64,
    drive: Drive,
}

/// What is minimised, over its functions.
#[derive(Debug, Clone)]
pub struct Objective {
    basis: Basis,
    whole: Quadratic,
    /// The force distance alone.
    force: Quadratic,
}

/// The program without limits, and the force distance alone.
pub fn unlimited(problem: &Problem, search: &Search, spans: usize) -> Result<(Program, Quadratic)> {
    let Objective {
        basis,
        whole,
        force,
    } = cached_objective(problem, search, spans)?;
    let mut equalities = point_demands(problem, &basis)?;
    equalities.extend(implied_by_limits(problem, &basis));
    equalities.extend(dwell_demands(&problem.law.dwells, &basis));
    if equalities.len() > MOST_DEMANDS {
        let (given, most) = (equalities.len(), MOST_DEMANDS);
        return Err(SynthError::ManyDemands { given, most }.at_key("law"));
    }
    let mut program = Program::new(basis, whole, equalities, problem.length);
    program.halt = search.halt.clone();
    Ok((program, force))
}

/// The program with every limit that is convex, and the force distance alone.
pub fn limited(problem: &Problem, search: &Search, spans: usize) -> Result<(Program, Quadratic)> {
    let (mut program, force) = unlimited(problem, search, spans)?;
    let mut rows = limits::rows(problem);
    if problem.law.monotone {
        rows.extend(limits::monotone(problem));
    }
    if let Minimise::Peak(order) = problem.objective() {
        rows.extend(limits::peak(problem, order));
        program.cost[PEAK] = 1.0;
    }
    rows.extend(limits::about_the_target(problem, &mut program));
    program.limits = rows;
    if problem.size() == Size::Sought {
        limits::with_size(problem, &mut program);
    }
    Ok((program, force))
}

/// The objective; of few spans from the cache.
fn cached_objective(problem: &Problem, search: &Search, spans: usize) -> Result<Objective> {
    if spans > MOST_KEPT_SPANS {
        return objective(problem, spans);
    }
    let key = ObjectiveKey {
        spans,
        degree: problem.degree(),
        minimise: problem.objective(),
        phase: problem.phase,
        drive: problem.drive,
    };
    (search.cache.objectives).try_get(key, |_| objective(problem, spans))
}

fn objective(problem: &Problem, spans: usize) -> Result<Objective> {
    let degree = problem.degree();
    let corners = if problem.law.polydyne { degree - 1 } else { 2 };
    let basis = spline_basis(degree, spans, &problem.law.dwells, corners)?;
    let force = force_distance(problem, &basis);
    let mut whole = match problem.objective() {
        Minimise::ForceError => force.clone(),
        Minimise::Weighed(weigh) => weighed(problem, &basis, &force, weigh),
        _ => Quadratic::zero(&basis),
    };
    match problem.objective() {
        Minimise::Energy(order) => whole.add_energy(&basis, order, 1.0),
        Minimise::Peak(_) | Minimise::PeakForceError | Minimise::Weighed(_) => {}
        Minimise::Size => {
            // ½ μ mean(j²) with μ such that a jerk of SIZE_JERK lengths costs as much as one length of radius.
            let unit = SIZE_JERK * problem.length;
            let length = problem.length * problem.lever();
            whole.add_energy(&basis, 3, length / (unit * unit));
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
    Ok(Objective {
        basis,
        whole,
        force,
    })
}

/// The quadratic part of (e/e₁)² + R/R₁ + (j/j₁)²; `force` holds ½e².
fn weighed(problem: &Problem, basis: &Basis, force: &Quadratic, weigh: Weigh) -> Quadratic {
    let mean = problem.target_mean();
    let mut sum = Quadratic::zero(basis);
    if let Some(part) = weigh.force_error {
        sum = force.times(2.0 / (part * mean).powi(2));
    }
    if let Some(one) = weigh.jerk {
        let by_angle = one / problem.drive.speed.powi(3);
        sum.add_energy(basis, 3, 2.0 / (by_angle * by_angle));
    } else {
        // What force and size leave open, as where size alone is minimised.
        let unit = SIZE_JERK * problem.length;
        let radius = weigh.prime_radius.unwrap_or(problem.length);
        sum.add_energy(basis, 3, problem.length / radius / (unit * unit));
    }
    sum
}

/// ½ mean((F − F*)²) over the turn, weighed by phase where the problem says so; 0 where no force is wanted.
pub fn force_distance(problem: &Problem, basis: &Basis) -> Quadratic {
    let mut force = Quadratic::zero(basis);
    let Some(target) = &problem.target else {
        return force;
    };
    if problem.is_weighed() {
        return weighed_distance(problem, basis, target);
    }
    let (w, rest) = (problem.drive.weights(), problem.drive.rest_force);
    match basis {
        // Against polynomials the target is its nearest polynomial on every span.
        Basis::Spline { space, .. } => {
            let degree = space.degree();
            let nearest = target.nearest(&basis.breaks(), degree);
            let mut pieces = nearest.chunks_exact(degree + 1);
            force.add_distance(
                basis,
                &w,
                degree + 1,
                |_, _, _, out| {
                    for (out, f) in out.iter_mut().zip(pieces.next().unwrap_or_default()) {
                        *out = f - rest;
                    }
                },
                None,
            );
            force.constant = 0.5 * target.mean_square_from(rest);
        }
        Basis::Harmonic { .. } => {
            let nodes = harmonic_nodes(basis, target);
            force.add_distance(
                basis,
                &w,
                nodes,
                |start, width, places, out| {
                    target.cells().on((start, width), places, out);
                    out.iter_mut().for_each(|f| *f -= rest);
                },
                None,
            );
        }
    }
    force
}

/// Nodes on every piece between whose ends harmonics and the cells of a force are smooth.
fn harmonic_nodes(basis: &Basis, target: &Target) -> usize {
    let pieces = basis.breaks().len() - 1;
    HARMONIC_NODES.max(target.curve.force_n.len().div_ceil(pieces))
}

/// The same weighed by phase: a quadrature of its own on every range over which law and weight are smooth (theory §9).
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

/// Weighed mean square of the distance of the target from a force, N²: four nodes on every cell are exact.
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

/// Breaks from 0 to 2π with edges among them; an edge at a break to rounding is that break.
fn merged(breaks: &[f64], edges: &[f64]) -> Vec<f64> {
    let apart = |x: &f64| breaks.iter().all(|b| (b - x).abs() > SAME_ANGLE);
    let mut out: Vec<f64> = (breaks.iter().copied())
        .chain(edges.iter().copied().filter(apart))
        .collect();
    out.sort_by(f64::total_cmp);
    out
}
