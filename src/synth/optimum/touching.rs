//! Touching angle: angle at which a law touches its base circle, if nothing else fixes the level of the lift.
//!
//! On a moving axis the force does not depend on the level of the law. The level is chosen so that the minimum of the law is on the base
//! circle. Limits on curvature, pressure angle and contact pressure measure the lift from the base circle. For a touching angle φ, these
//! limits are Σ wₖ s⁽ᵏ⁾(θ) − w₀ s(φ) ≤ bound with w₀ ≤ 0. Each φ gives a convex program with the optimum f(φ). If the law of this program is
//! lower than s(φ) at another angle, the lift above its true minimum is larger, so the limits hold with a margin. The optimum is therefore
//! the minimum of f(φ) over the turn.
//!
//! A solution at the angle c with multipliers λ bounds the optimum at *every* other angle: with ν = −Σ λ w₀, the Lagrangian changes by ν
//! (s(φ) − s(c)). Let s_c be the law at the angle c. Then
//!
//! ```text
//! f(φ) ≥ f(c) + ν (s_c(φ) − s_c(c)) − ½ ν² Q(φ − c)
//! Q(t) = 4/α Σ (1 − cos nt)/n⁴ = 4/α (π²t²/12 − π|t|³/12 + t⁴/48)
//! ```
//!
//! where α mean(s″²) is at most the quadratic part of the objective. Q bounds the squared norm of the functional s(φ) − s(c) in the dual norm
//! of the objective. At c, the bound has the value and the slope of f. Branch and bound over φ therefore needs only a few programs for a
//! lower bound of f over the whole turn with a relative gap of 1e-6.

use std::f64::consts::{PI, TAU};

use super::refusal::Refusal;
use super::solved::{Formulation, Optimum};
use crate::criterion::Criterion;
use crate::law::Law;
use crate::synth::qp::{self, Failure, Program, Row, Solution};

/// Relative gap of the objective up to which the minimum over all angles is proved.
const GAP: f64 = 4e-7;
/// Maximum number of programs solved for the proof.
const MOST_PROGRAMS: usize = 48;
/// Maximum number of steps in which the touching angle is moved towards the minimum of its law.
const MOST_DESCENTS: usize = 8;
/// Step of the touching angle below which the descent ends, rad.
const SETTLED: f64 = 1e-7;
/// Maximum secant step, as a multiple of the distance to the minimum of the law.
const FARTHEST: f64 = 20.0;
/// Number of parts of the turn at the start of branch and bound.
const PARTS: usize = 16;
/// Width of a part below which branch and bound does not divide it, rad.
const NARROWEST: f64 = TAU / 65536.0;
/// Number of trial angles if the first program is infeasible.
const TRIED: usize = 12;

/// Optimum with the convex limits only, at the best touching angle. A program whose limits do not depend on the level is solved directly.
///
/// # Errors
///
/// The program has no solution.
pub fn at_best_angle(formulation: Formulation) -> Result<Optimum, Box<Refusal>> {
    let program = &formulation.program;
    let (program, solution, at, bound) = if program.limits.iter().any(|l| l.from_reference) {
        let (best, bound) = searched(program, formulation.stiffness)?;
        let mut program = program.clone();
        program.count_from(best.at);
        (program, best.solution, Some(best.at), bound)
    } else {
        match program.solve() {
            Ok(solution) => (formulation.program, solution, None, None),
            Err(failure) => return Err(Refusal::of(formulation.program, failure)),
        }
    };
    Ok(Optimum {
        formulation: Formulation {
            program,
            ..formulation
        },
        solution,
        at,
        bound,
        sequence: None,
        left_out: false,
    })
}

/// Solution at the best touching angle, and a lower bound of the objective over all angles. `stiffness` is the convexity α (see the comment
/// at the beginning of this file), if the objective has a quadratic part.
fn searched(
    program: &Program,
    stiffness: Option<f64>,
) -> Result<(Node, Option<f64>), Box<Refusal>> {
    // The minimum of the law without limits is a good initial guess. If the force error is limited, the law is near the law with the
    // minimum force error.
    let least = program.of_least_rms(Criterion::Accuracy);
    let first = match qp::solve_equalities(least.as_ref().unwrap_or(program)) {
        Ok(unlimited) => Law::of(&program.basis, &unlimited.x).extremes(0).0.at,
        Err(_) => 0.0,
    };
    let mut search = Search {
        program: program.clone(),
        nodes: Vec::new(),
        programs: 0,
    };
    search.begin(first)?;
    let bound = match stiffness {
        Some(alpha) => search.proved(alpha),
        None => {
            search.beside();
            None
        }
    };
    Ok((search.finished(), bound))
}

/// A touching angle with the solution of its program.
struct Node {
    at: f64,
    solution: Solution,
    law: Law,
    /// Value of the objective, including its constant.
    value: f64,
    /// Lower bound of the objective from the multipliers at this angle.
    dual: f64,
    /// Factor ν: sum of the multipliers, weighted with −w₀.
    multiplier: f64,
    /// Lift s_c(c) of the law at its touching angle, m.
    level: f64,
    /// Local minima of the law, sorted by angle: angle, rad, and lift, m.
    lows: Vec<(f64, f64)>,
}

impl Node {
    /// Lower bound of f over the angles from `a` to `b`, from the solution at this angle.
    fn least(&self, a: f64, b: f64, alpha: f64) -> f64 {
        let ends = self.law.svaj(a).s.min(self.law.svaj(b).s);
        let inside = self.lows.iter().filter(|low| low.0 > a && low.0 < b);
        let lowest = inside.fold(ends, |least, low| least.min(low.1));
        let apart = |x: f64| apart(x, self.at);
        let opposite = (self.at + PI).rem_euclid(TAU);
        let farthest = if opposite > a && opposite < b {
            PI
        } else {
            apart(a).max(apart(b))
        };
        let length = distance(farthest) / alpha;
        self.dual + self.multiplier * (lowest - self.level)
            - 0.5 * self.multiplier * self.multiplier * length
    }
}

/// An angle, rad, reduced to [−π, π).
fn signed(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// Angle between two positions in the turn, rad, from 0 to π.
fn apart(a: f64, b: f64) -> f64 {
    signed(a - b).abs()
}

/// Best lower bound of f over the angles from `a` to `b`, from all given solutions.
fn bound(nodes: &[Node], a: f64, b: f64, alpha: f64) -> f64 {
    let each = nodes.iter().map(|n| n.least(a, b, alpha));
    each.fold(f64::NEG_INFINITY, f64::max)
}

/// Function α Q(t), where t is the angle between two positions, rad.
fn distance(t: f64) -> f64 {
    4.0 * t * t * (PI * PI / 12.0 - PI * t / 12.0 + t * t / 48.0)
}

struct Search {
    program: Program,
    nodes: Vec<Node>,
    programs: usize,
}

impl Search {
    /// Solves the first program, at the angle `first`. If the program has equalities or angle-dependent bounds, several touching angles are
    /// tried until one has a solution.
    fn begin(&mut self, first: f64) -> Result<(), Box<Refusal>> {
        let tied = !(self.program.equalities.is_empty() && self.program.shapes.is_empty());
        let angles = if tied { TRIED } else { 1 };
        let mut refused = None;
        for k in 0..angles {
            match self.visit(first + TAU * k as f64 / angles as f64) {
                Ok(node) => {
                    self.descend(node);
                    return Ok(());
                }
                Err(failure) => refused = refused.or(Some(failure)),
            }
        }
        if let Some(at) = self.at_least_rms(first)
            && let Ok(node) = self.visit(at)
        {
            self.descend(node);
            return Ok(());
        }
        let failure = refused.unwrap_or(Failure::Infeasible);
        Err(Refusal::of(self.touching(first), failure))
    }

    /// Touching angle of the law with the minimum root mean square under the other limits; `None` without a limit on a root mean square. If
    /// this limit is almost infeasible, the feasible angles are near the returned angle.
    fn at_least_rms(&self, first: f64) -> Option<f64> {
        let mut least = Search {
            program: self.program.of_least_rms(Criterion::Accuracy)?,
            nodes: Vec::new(),
            programs: 0,
        };
        least.begin(first).ok()?;
        Some(least.nodes[least.best()].at)
    }

    /// Program with the touching angle `at`, rad.
    fn touching(&self, at: f64) -> Program {
        let mut program = self.program.clone();
        program.count_from(at);
        program
    }

    /// Solves the program at the angle `at`, rad, with the active rows of the nearest solved angle as initial rows. Returns the index of the new
    /// solution.
    fn visit(&mut self, at: f64) -> Result<usize, Failure> {
        let at = at.rem_euclid(TAU);
        let mut program = self.touching(at);
        let apart = |n: &&Node| apart(n.at, at);
        if let Some(near) = (self.nodes.iter()).min_by(|a, b| apart(a).total_cmp(&apart(b))) {
            program.seeds = program.seeds_of(&near.solution.active);
        }
        self.programs += 1;
        let solution = program.solve()?;
        let node = node(&program, at, solution);
        self.nodes.push(node);
        Ok(self.nodes.len() - 1)
    }

    fn best(&self) -> usize {
        let by_value = |a: &usize, b: &usize| self.nodes[*a].value.total_cmp(&self.nodes[*b].value);
        (0..self.nodes.len()).min_by(by_value).unwrap_or(0)
    }

    /// Tries the angles at a distance of ¼ span before and after the best angle. For a symmetric target, a stationary angle of the
    /// objective can be a local maximum.
    fn beside(&mut self) {
        let at = self.nodes[self.best()].at;
        let part = 0.25 * self.program.width(0);
        for angle in [at - part, at + part] {
            if let Ok(node) = self.visit(angle) {
                self.descend(node);
            }
        }
    }

    /// Moves the touching angle towards the minimum of its law while this improves the objective. The first step is the distance to this
    /// minimum. The following steps are secant steps.
    fn descend(&mut self, mut node: usize) {
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_DESCENTS {
            let here = &self.nodes[node];
            let (at, value) = (here.at, here.value);
            let way = signed(here.law.extremes(0).0.at - at);
            if way.abs() < SETTLED || here.multiplier == 0.0 {
                return;
            }
            let secant = before.map(|(then, old)| -way * signed(at - then) / (way - old));
            let ahead = secant.filter(|step| step * way > 0.0 && step.abs() < FARTHEST * way.abs());
            before = Some((at, way));
            let Ok(next) = self.visit(at + ahead.unwrap_or(way)) else {
                return;
            };
            let gained = value - self.nodes[next].value;
            if gained > 0.1 * GAP * value.abs() {
                node = next;
            } else if ahead.is_none() || gained >= 0.0 {
                return;
            } else {
                before = None;
            }
        }
    }

    /// Lower bound of f over all angles of the turn, by branch and bound; `None` if no bound is found.
    fn proved(&mut self, alpha: f64) -> Option<f64> {
        let cut = |k: usize| TAU * k as f64 / PARTS as f64;
        let mut parts: Vec<(f64, f64, f64)> = (0..PARTS)
            .map(|k| (cut(k), cut(k + 1), f64::NEG_INFINITY))
            .collect();
        let mut seen = 0;
        loop {
            if seen < self.nodes.len() {
                for (a, b, least) in &mut parts {
                    *least = least.max(bound(&self.nodes[seen..], *a, *b, alpha));
                }
                seen = self.nodes.len();
            }
            let value = self.nodes[self.best()].value;
            let allowed = value - GAP * value.abs();
            let lowest = |a: &usize, b: &usize| parts[*a].2.total_cmp(&parts[*b].2);
            let worst = (0..parts.len()).min_by(lowest)?;
            let (a, b, least) = parts[worst];
            if least >= allowed {
                return Some(least.min(value));
            }
            if b - a < NARROWEST {
                return Some(least);
            }
            let middle = 0.5 * (a + b);
            let there = bound(&self.nodes, middle, middle, alpha);
            let more = self.programs < MOST_PROGRAMS && !self.program.halt.is_asked();
            if there < allowed && more && self.visit(middle).is_ok() {
                self.descend(self.best());
            }
            let part = |a: f64, b: f64| (a, b, bound(&self.nodes, a, b, alpha));
            parts[worst] = part(a, middle);
            parts.push(part(middle, b));
        }
    }

    /// Best solution, with the total number of iterations of all programs.
    fn finished(mut self) -> Node {
        let mut best = self.nodes.swap_remove(self.best());
        let others = self.nodes.iter().map(|n| n.solution.iterations);
        best.solution.iterations += others.sum::<usize>();
        best
    }
}

fn node(program: &Program, at: f64, solution: Solution) -> Node {
    let law = Law::of(&program.basis, &solution.x);
    let rows: &[Row] = &solution.active;
    let counted = rows.iter().filter(|row| !row.reference.is_empty());
    let multiplier = counted.map(|row| -row.multiplier * row.weights[0]).sum();
    let value = program.merit(&solution);
    let dual = value - qp::certificate(program, &solution).duality_gap;
    let rate = law.combination([0.0, 1.0, 0.0, 0.0], 0.0);
    let lows = rate.roots().into_iter().map(|x| (x, law.svaj(x).s));
    Node {
        at,
        value,
        dual,
        multiplier,
        level: law.svaj(at).s,
        lows: lows.collect(),
        law,
        solution,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_of_two_touching_angles_is_its_series() {
        for t in [0.0, 0.01, 0.5, 2.0, PI] {
            let term = |n: i32| (1.0 - (f64::from(n) * t).cos()) / f64::from(n).powi(4);
            let series: f64 = 4.0 * (1..2000).map(term).sum::<f64>();
            assert!((distance(t) - series).abs() < 1e-9, "{t}");
        }
    }

    #[test]
    fn angles_are_apart_by_the_shorter_way() {
        assert!((apart(0.1, TAU - 0.1) - 0.2).abs() < 1e-14);
        assert!((apart(1.0, 1.0 + PI) - PI).abs() < 1e-14);
    }
}
