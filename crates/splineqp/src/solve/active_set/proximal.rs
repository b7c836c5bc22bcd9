//! Minimax objectives: proximal steps, each of which is a strictly convex program for the dual active-set method.
//!
//! The objective is c·t with the peak t, so H is zero. The law is not determined at angles at which its value is below the peak. The
//! program of a step about a centre (s̄, t̄) is
//!
//! ```text
//! minimise  c·t + (εc/2T) mean (w·(s − s̄))² + (c/2T) (t − t̄)²      subject to the present rows
//! ```
//!
//! Here T is the peak of the initial law, w are the weights of the quantity whose peak is minimised, and ε is the proximal weight. The
//! matrix of this program has a banded factor. The solution is the next centre, and the points of maximum violation of its law become
//! further rows (theory §9). The multipliers of a step are scaled so that the gradient with respect to t is zero. The remaining gradient is
//! then εM(x − x̄) with the coefficients x, x̄ of s, s̄ and a constant matrix M. As ε decreases from step to step, the lower bound from the
//! multipliers approaches the peak, even if the law is not determined.

use super::dual::{Dual, Plane};
use crate::Names;
use crate::band::{ArrowFactor, ArrowMatrix};
use crate::basis::{Basis, Entries, apply};
use crate::certificate::certificate;
use crate::equality;
use crate::objective::Quadratic;
use crate::poly::Peak;
use crate::program::{Failure, Limit, PEAK, Program, Row, Solution, Values, Variable};

/// Law with the minimum peak; `None` if the steps end before the optimum.
///
/// # Errors
///
/// The other limits are infeasible.
pub fn solve<N: Names>(program: &Program<N>) -> Result<Option<Solution<N>>, Failure<N>> {
    let start = start(program)?;
    Ok(start.and_then(|start| Search::new(program, start).run()))
}

/// Whether the method applies to a program. The program must have splines, no cones, and a peak with a positive cost.
pub fn suits<N: Names>(program: &Program<N>) -> bool {
    let splines = matches!(program.basis, Basis::Spline { .. });
    splines && program.cones.is_empty() && program.cost[PEAK] > 0.0
}

/// First centre of the search, and the metric of its steps.
struct Start<N: Names> {
    centre: Vec<f64>,
    /// Active rows of the first centre.
    contacts: Vec<Row<N>>,
    /// Matrix of the mean of (w·s)². Multiples of the equalities make it positive definite in the directions that they fix.
    square: ArrowMatrix,
    /// Further variables of the program, which are unknowns of the steps.
    free: Vec<Variable>,
    /// Peak T of the initial law.
    peak: f64,
}

/// Initial law, with the minimum mean square of the quantity whose peak is minimised. If its peak is practically zero, the law with the
/// minimum mean square subject to the other limits is used instead.
///
/// # Errors
///
/// The other limits are infeasible.
fn start<N: Names>(program: &Program<N>) -> Result<Option<Start<N>>, Failure<N>> {
    let Some(limit) = program.limits.iter().find(|l| l.is_peak()) else {
        return Ok(None);
    };
    let basis = &program.basis;
    let Basis::Spline { space, .. } = basis else {
        return Ok(None);
    };
    let mut square = Quadratic::zero(basis);
    let wanted = |start: f64, width: f64, rule: &[(f64, f64)], out: &mut [f64]| {
        for (out, (u, _)) in out.iter_mut().zip(rule) {
            let shape = limit.shape.map(|i| &program.shapes[i]);
            *out = shape.map_or(0.0, |s| s.eval(start + u * width));
        }
    };
    square.add_distance(basis, &limit.weights, space.degree() + 1, wanted, None);
    let mut least = program.clone();
    least.hessian.clone_from(&square.hessian);
    least.gradient = square.gradient;
    let Ok(unlimited) = equality::solve(&least) else {
        return Ok(None);
    };
    let (mut centre, mut contacts) = (unlimited.x, Vec::new());
    let own_peak = |x: &[f64]| program.own_peak(x, &Values::NONE);
    if own_peak(&centre) <= program.settings.certificate.least_objective * limit.scale {
        least.cost[PEAK] = 0.0;
        least.seeds.clear();
        let peaks = least.limits.iter_mut().filter(|l| l.is_peak());
        peaks.for_each(|l| *l = l.idle());
        match least.solved() {
            Ok(limited) => (centre, contacts) = (limited.x, limited.active),
            Err(Failure::Infeasible) => return Err(Failure::Infeasible),
            Err(_) => return Ok(None),
        }
    }
    let peak = own_peak(&centre);
    if !(peak > 0.0 && peak.is_finite()) {
        return Ok(None);
    }
    let free = program.free_variables();
    let mut windows = program.windows(&centre);
    windows[PEAK] = peak;
    centre.extend(free.iter().map(|&k| windows[k]));
    let mut square = unlimited.hessian;
    if let Some((at, _)) = unlimited.pin {
        // With a small weight on the fixed coefficient, rows that depend on the level would be nearly dependent on each other.
        square.add(at, at, (peak / program.length).powi(2));
    }
    Ok(Some(Start {
        centre,
        contacts,
        square,
        free,
        peak,
    }))
}

struct Search<'a, N: Names> {
    program: &'a Program<N>,
    start: Start<N>,
    rows: Vec<Row<N>>,
    /// Entries of the rows, for the coefficients and the further variables.
    entries: Vec<Entries>,
    /// Indices of the active rows, with their multipliers.
    active: Vec<(usize, f64)>,
    nearness: f64,
    steps: usize,
}

impl<'a, N: Names> Search<'a, N> {
    fn new(program: &'a Program<N>, mut start: Start<N>) -> Self {
        let contacts = std::mem::take(&mut start.contacts);
        let mut search = Search {
            program,
            start,
            rows: Vec::new(),
            entries: Vec::new(),
            active: Vec::new(),
            nearness: program.settings.proximal.nearness,
            steps: 0,
        };
        let mut first: Vec<Row<N>> = program.fixed.clone();
        first.extend(program.seeds.iter().cloned());
        first.extend(contacts.into_iter().filter(|row| row.limit.is_some()));
        program.seed_rows(&mut first);
        first.into_iter().for_each(|row| search.push(row));
        search
    }

    /// Cholesky factor of the system matrix of a step; `None` if it is not positive definite.
    fn factor(&self) -> Option<ArrowFactor> {
        let Start {
            square, free, peak, ..
        } = &self.start;
        let n = square.dimension();
        let (band, border) = self.program.basis.pattern();
        let mut matrix = ArrowMatrix::zero(n + free.len(), band, border + free.len());
        let unit = self.program.cost[PEAK] / peak;
        for (i, j, value) in square.lower_entries() {
            matrix.add(i, j, self.nearness * unit * value);
        }
        for (c, &k) in free.iter().enumerate() {
            let weight = if k == PEAK {
                unit
            } else {
                self.nearness * unit * (peak / self.program.typical(k)).powi(2)
            };
            matrix.add(n + c, n + c, weight);
        }
        matrix.factor()
    }

    fn push(&mut self, row: Row<N>) {
        let n = self.program.basis.columns();
        let mut entries = row.entries.clone();
        let beside = (n..).zip(self.start.free.iter().map(|&k| row.extra[k]));
        entries.extend(beside.filter(|e| e.1 != 0.0));
        let coincident = self.program.settings.active_set.coincident;
        let twin = |r: &Row<N>| row.limit.is_some() && r.coincides(&row, coincident);
        match self.rows.iter().position(twin) {
            Some(at) => (self.rows[at], self.entries[at]) = (row, entries),
            None => {
                self.rows.push(row);
                self.entries.push(entries);
            }
        }
    }

    fn run(mut self) -> Option<Solution<N>> {
        let settings = &self.program.settings;
        let own = &settings.proximal;
        let mut best: Option<(f64, Solution<N>)> = None;
        let (mut since, mut reached) = (0, (f64::INFINITY, f64::INFINITY));
        for round in 1..=own.rounds {
            if self.program.halt.is_asked() {
                break;
            }
            let Some(at) = self.step() else {
                // In a step with a small weight, nearly dependent rows can cause the loss of all digits. A larger weight restores the
                // accuracy.
                if self.nearness >= own.nearness {
                    break;
                }
                self.nearness = own.nearness.min(own.heavier * self.nearness);
                self.active.clear();
                continue;
            };
            let (solution, promised, broken) = self.solution(&at, round);
            let (peak, violation) = (solution.extra[PEAK], solution.violation);
            let proof = certificate(self.program, &solution);
            let open = (proof.relative_gap / settings.refinement.gap)
                .max(proof.stationarity / settings.refinement.stationarity)
                .max(violation / settings.tolerance);
            since += 1;
            if best.as_ref().is_none_or(|b| open < 0.9 * b.0) {
                best = Some((open, solution));
                since = 0;
            }
            if open <= 1.0 || since > own.patience {
                break;
            }
            // If the multipliers already prove the minimum peak with the present rows, only further rows are necessary. The weight is then
            // not reduced.
            let above = (peak - promised) * self.program.cost[PEAK] / proof.size;
            let proved = proof.stationarity <= settings.refinement.stationarity
                && proof.relative_gap - above <= own.proved * settings.refinement.gap;
            // Among laws that satisfy the other limits, the law with the smaller peak is better.
            let falls =
                violation <= own.compared && reached.0 - peak >= own.kept * (reached.0 - promised);
            let lawful = reached.1 > settings.tolerance && violation < 0.5 * reached.1;
            if (falls || broken.is_empty()) && !proved {
                self.nearness = (own.fall * self.nearness).max(own.least_nearness);
            }
            if (falls || lawful || broken.is_empty()) && !proved {
                self.start.centre = at;
                reached = (peak, violation);
            }
            for (limit, place) in broken {
                let row = self.program.row(limit, place);
                self.push(row);
            }
        }
        let halted = self.program.halt.is_asked();
        match best {
            Some((open, solution)) if open < own.accepted => Some(solution),
            Some((_, solution)) if halted && solution.violation < own.compared => Some(solution),
            _ => None,
        }
    }

    /// Solution of a step about the centre. `None` if rows contradict each other, if the maximum number of steps is reached, or if the
    /// caller stops the search.
    fn step(&mut self) -> Option<Vec<f64>> {
        let factor = self.factor()?;
        let (program, centre) = (self.program, &self.start.centre);
        // The unknowns are measured from the centre, so that the size of the law causes no loss of digits.
        let mut pull: Vec<f64> = program.gradient.iter().map(|g| -g).collect();
        pull.extend(self.start.free.iter().map(|&k| -program.cost[k]));
        let away = |entries: &Entries, bound: f64| bound - apply(entries, centre);
        let planes: Vec<Plane> = (self.entries.iter().zip(&self.rows))
            .map(|(entries, row)| Plane {
                entries,
                bound: away(entries, row.bound),
                unit: (row.limit).map_or(row.scale.max(row.bound.abs()), |l| {
                    self.size(&program.limits[l])
                }),
            })
            .collect();
        let settings = &program.settings.active_set;
        let most_steps = settings.steps_per_unknown * pull.len();
        let zero = vec![0.0; pull.len()];
        let mut dual = Dual::new(&factor, pull, zero, settings.dependent, most_steps);
        for e in &program.equalities {
            dual.hold(None, &e.entries, away(&e.entries, e.value), 0.0);
        }
        for &(i, multiplier) in &self.active {
            dual.hold(Some(i), planes[i].entries, planes[i].bound, multiplier);
        }
        dual.retreat();
        dual.settle(&planes, settings.resolved, usize::MAX, &program.halt)
            .ok()?;
        self.steps += dual.steps;
        self.active = dual.multipliers().filter(|m| m.1 > 0.0).collect();
        Some(centre.iter().zip(dual.x).map(|(c, d)| c + d).collect())
    }

    /// Scale of an excess over a limit. For a limit with the peak, it is the peak of the initial law.
    fn size(&self, limit: &Limit<N>) -> f64 {
        if limit.is_peak() {
            return self.start.peak;
        }
        limit.scale
    }

    /// Solution with the law of a step and its actual peak. Also returns the peak of the rows alone, and the points at which the law
    /// violates limits.
    fn solution(&self, at: &[f64], round: usize) -> (Solution<N>, f64, Vec<(usize, Peak)>) {
        let program = self.program;
        let x = at[..program.basis.columns()].to_vec();
        let mut extra = Values::NONE;
        for (&k, value) in self.start.free.iter().zip(&at[x.len()..]) {
            extra[k] = *value;
        }
        let part = 0.1 * program.settings.tolerance;
        let mut broken = Vec::new();
        let level = |l: &Limit<N>| program.room(l, &x, &extra) + part * self.size(l);
        program.each_peak_above(&x, level, |index, peak| broken.push((index, peak)));
        // Equalities that depend on others are not among the planes.
        let consistent = program.settings.equality.consistent;
        let missed = (program
            .equalities
            .iter()
            .map(|e| e.missed(&x, program.length)))
        .filter(|part| *part > consistent)
        .fold(0.0, f64::max);
        let promised = extra[PEAK];
        extra[PEAK] = program.own_peak(&x, &extra);
        // The multipliers are scaled so that the multipliers of the rows with the peak balance the cost of the peak.
        let of_peak = |(i, m): &(usize, f64)| -m * self.rows[*i].extra[PEAK];
        let sum: f64 = self.active.iter().map(of_peak).sum();
        let scale = if sum > 0.0 {
            program.cost[PEAK] / sum
        } else {
            1.0
        };
        let active = self.active.iter().map(|&(i, multiplier)| Row {
            multiplier: scale * multiplier,
            ..self.rows[i].clone()
        });
        let solution = Solution {
            active: active.collect(),
            violation: missed.max(program.worst(&broken, &x, &extra)),
            x,
            extra,
            used_rows: true,
            iterations: self.steps,
            rounds: round,
        };
        (solution, promised, broken)
    }
}
