//! Refinement of a solution and of its certificate up to rounding errors, by Newton's method for the active points. An active point
//! (`contact` in the code) is a point at which a limit equals its bound.
//!
//! An interior-point method approximates an active point by two rows, one on either side. The multipliers of these rows, and therefore the
//! certificate, are inaccurate even if the law is accurate. In the refinement, each active point is one row at the exact local maximum. A
//! step solves
//!
//! ```text
//! (H + Σ λ/(−c″) a′a′ᵀ + ε) d + Eᵀν + Aᵀλ = −(Hx + g)      E d = e − E x      A d − δ (λ − λ₀) = b − A x
//! ```
//!
//! for the step d of the law x and the further variables together. Here ν and λ are the new multipliers of the equalities E x = e and of
//! the active rows A x ≤ b, and λ₀ are the previous ones. The rows of A are aᵀ, a′ is the derivative of a with respect to the angle, and c″
//! is the second derivative of the limit's left side. The active points may not determine the active rows. For example, the law equals its
//! bound on a whole range, or there are more active points than unknowns. A step is then a quadratic program with all rows near their
//! bounds, and rows at violated points are added. The proximal terms ε and δ fix the directions that the objective and the active points do
//! not determine. They do not change the result.
//!
//! | file | used |
//! |---|---|
//! | `band` | in the active-set method, for the coefficients only; cost linear in the number of spans |
//! | `step` | during and after the exchange: one step that includes the further variables |
//! | `sparse` | linear system of that step |

use crate::Names;
mod band;
mod cone;
mod sparse;
mod step;

pub use band::on_band;

use step::Local;

use crate::band::ArrowMatrix;
use crate::basis::{Basis, apply, row_unit};
use crate::certificate::certificate;
use crate::poly::{Peak, PiecewisePoly};
use crate::program::{Limit, PEAK, Program, Row, Solution, Variable};
use crate::solve::active_set::dual;

struct Contacts<'a, N: Names> {
    program: &'a Program<N>,
    /// Second derivatives of the shapes of the bounds.
    bends: Vec<PiecewisePoly>,
    /// Further variables that are used in the program.
    free: Vec<Variable>,
    degree: usize,
}

/// Method for choosing the rows of a step.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// All active points as equalities. Rows with negative multipliers are removed.
    Equalities,
    /// Quadratic program with rows at all points near their bounds.
    Program,
}

/// Whether a program is refined. The steps of a sequence of programs have a larger tolerance and are not refined.
pub fn is_wanted<N: Names>(program: &Program<N>) -> bool {
    program.settings.tolerance <= program.settings.refinement.finest_tolerance
}

/// The refined solution, if the certificate is not sufficient and the refinement improves it. Otherwise the solution is returned unchanged.
pub fn refined<N: Names>(program: &Program<N>, solution: Solution<N>) -> Solution<N> {
    if !solution.used_rows || !is_wanted(program) {
        return solution;
    }
    let before = openness(program, &solution);
    if before <= 1.0 {
        return solution;
    }
    let closer = if program.cones.is_empty() {
        on_contacts(program, &solution)
    } else {
        cone::on_cones(program, &solution)
    };
    match closer {
        Some(closer) if openness(program, &closer) < before => closer,
        _ => solution,
    }
}

/// Whether a solution satisfies its limits to the tolerance of the program, or to the rounding errors of its rows.
pub fn keeps_limits<N: Names>(program: &Program<N>, solution: &Solution<N>) -> bool {
    let tolerance = program.settings.tolerance;
    solution.violation <= tolerance || solution.violation <= rounding(program, solution)
}

/// Maximum ratio of gap, stationarity and violation to their refinement thresholds. It is at most 1 if no refinement is necessary.
pub fn openness<N: Names>(program: &Program<N>, solution: &Solution<N>) -> f64 {
    let settings = &program.settings.refinement;
    let proof = certificate(program, solution);
    (proof.relative_gap / settings.gap)
        .max(proof.stationarity / settings.stationarity)
        .max(proof.violation / program.settings.tolerance.max(rounding(program, solution)))
}

/// Maximum rounding error of the active rows, relative to the scale of their limits. Violations cannot be smaller.
fn rounding<N: Names>(program: &Program<N>, solution: &Solution<N>) -> f64 {
    let of_row = |row: &Row<N>| {
        let of_limit = |i: usize| {
            let limit = &program.limits[i];
            limit.size(limit.room(&solution.extra))
        };
        let size = row.limit.map_or(row.scale, of_limit);
        (size > 0.0).then(|| dual::rounding(&row.entries, &solution.x) / size)
    };
    (solution.active.iter().filter_map(of_row)).fold(0.0, f64::max)
}

/// Optimum near a nearly feasible solution, with a sufficient certificate; `None` if no method finds it.
pub fn on_contacts<N: Names>(program: &Program<N>, start: &Solution<N>) -> Option<Solution<N>> {
    let contacts = Contacts::small(program)?;
    [Way::Equalities, Way::Program]
        .into_iter()
        .find_map(|way| contacts.searched(start, way))
}

impl<'a, N: Names> Contacts<'a, N> {
    /// Creates the refinement. `None` if the program is too large for a dense step, or has a cone.
    fn small(program: &'a Program<N>) -> Option<Self> {
        let unknowns = program.basis.columns() + program.equalities.len();
        let too_large = 2 * unknowns > program.settings.refinement.largest;
        if !program.cones.is_empty() || too_large {
            return None;
        }
        Some(Contacts::new(program))
    }

    fn new(program: &'a Program<N>) -> Self {
        let degree = match &program.basis {
            Basis::Spline { space, .. } => space.degree(),
            Basis::Harmonic { .. } => usize::MAX,
        };
        Contacts {
            program,
            bends: (program.shapes.iter())
                .map(|s| s.derivative().derivative())
                .collect(),
            free: program.free_variables(),
            degree,
        }
    }

    /// The initial solution with its active points as rows.
    fn start(&self, start: &Solution<N>) -> Solution<N> {
        let push = |r: &Row<N>| r.multiplier * row_unit(&r.entries, self.program.length);
        let largest = start.active.iter().map(push).fold(0.0, f64::max);
        let weakest = self.program.settings.refinement.weakest;
        let mut current = start.clone();
        (current.active).retain(|r| push(r) > weakest * largest);
        let peaks = self.peaks_near(&current);
        current.active = self.gathered(&current, &peaks);
        current
    }

    fn searched(&self, start: &Solution<N>, way: Way) -> Option<Solution<N>> {
        let program = self.program;
        let settings = &program.settings.refinement;
        let mut current = self.start(start);
        let most = settings.divergence * start.violation.max(settings.from);
        let mut best: Option<(f64, Solution<N>)> = None;
        let (mut since, mut solves) = (0, settings.solves);
        for _ in 0..settings.steps {
            if program.halt.is_asked() {
                break;
            }
            let next = match way {
                Way::Equalities => self.held_step(&current, &mut solves),
                Way::Program => self.program_step(&current),
            };
            let Some(mut next) = next.filter(|n| n.violation <= most) else {
                break;
            };
            // A row that is moved to its contact changes the gradient. Near the contact, the original row may have the better certificate.
            let gathered = Solution {
                active: self.gathered(&next, &self.peaks_near(&next)),
                ..next.clone()
            };
            since += 1;
            if next.violation <= program.settings.tolerance {
                for candidate in [&gathered, &next] {
                    let proof = certificate(program, candidate);
                    let doubt = proof.relative_gap.max(proof.stationarity);
                    if best.as_ref().is_none_or(|b| doubt < 0.5 * b.0) {
                        best = Some((doubt, candidate.clone()));
                        since = 0;
                    }
                }
                if best.as_ref().is_some_and(|b| b.0 <= settings.clean) {
                    break;
                }
            }
            if since > settings.patience {
                break;
            }
            next = gathered;
            if way == Way::Equalities {
                self.add_broken(&mut next);
            }
            current = next;
        }
        best.filter(|b| b.0 <= settings.proved).map(|b| b.1)
    }

    /// Whether the left side of a limit is constant on every piece, so that the limit is active on whole pieces.
    fn is_flat(&self, limit: &Limit<N>) -> bool {
        let order = limit.weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
        order >= self.degree && limit.shape.is_none()
    }

    /// Active rows, each moved to the nearest local maximum. Rows at the same maximum become one row.
    fn gathered(&self, solution: &Solution<N>, peaks: &[(usize, Peak)]) -> Vec<Row<N>> {
        let program = self.program;
        let mut out: Vec<Row<N>> = Vec::new();
        for row in &solution.active {
            let width = program.width(row.peak.piece);
            let away = |p: &Peak| (p.at - row.peak.at).abs();
            let limit = row.limit.filter(|&l| !self.is_flat(&program.limits[l]));
            let nearest = limit.and_then(|limit| {
                let mine = peaks.iter().filter(|p| p.0 == limit && away(&p.1) < width);
                mine.min_by(|a, b| away(&a.1).total_cmp(&away(&b.1)))
            });
            let moved = nearest.map_or_else(
                || row.clone(),
                |&(limit, peak)| Row {
                    multiplier: row.multiplier,
                    ..program.row(limit, peak)
                },
            );
            match out.iter_mut().find(|r| self.is_same(r, &moved)) {
                Some(twin) => twin.multiplier += moved.multiplier,
                None => out.push(moved),
            }
        }
        out
    }

    fn is_same(&self, a: &Row<N>, b: &Row<N>) -> bool {
        let Some(limit) = a.limit.filter(|_| a.limit == b.limit) else {
            return false;
        };
        let apart = (a.peak.at - b.peak.at).abs();
        let same = self.program.settings.refinement.same;
        apart < same * self.program.width(a.peak.piece)
            || a.peak.piece == b.peak.piece && self.is_flat(&self.program.limits[limit])
    }

    /// Negative second derivative −c″ at an active point inside its piece, where c is the left side of the limit minus its shape. `None` at
    /// the ends of a piece, if c is nearly constant, and if the limit contains the fourth derivative.
    fn sharpness(&self, x: &[f64], row: &Row<N>) -> Option<f64> {
        let limit = row.limit.map(|i| &self.program.limits[i])?;
        let w = limit.weights;
        let inside = row.peak.u > 0.0 && row.peak.u < 1.0 && w[4] == 0.0;
        let twice = [0.0, 0.0, w[0], w[1], w[2], w[3]];
        let own = || {
            let entries = self
                .program
                .basis
                .row_on(row.peak.piece, row.peak.u, &twice);
            let bend = limit.shape.map_or(0.0, |i| self.bends[i].eval(row.peak.at));
            bend - apply(&entries, x)
        };
        let width = self.program.width(row.peak.piece);
        let flat = self.program.settings.refinement.flat * limit.size(limit.bound);
        inside
            .then(own)
            .filter(|falls| falls * width * width > flat)
    }

    /// Hessian H + Σ λ/(−c″) a′a′ᵀ over the active rows.
    fn with_curvature(&self, mut hessian: ArrowMatrix, at: &Solution<N>) -> ArrowMatrix {
        for row in at.active.iter().filter(|r| r.multiplier > 0.0) {
            let Some(falls) = self.sharpness(&at.x, row) else {
                continue;
            };
            let w = row.weights;
            let once = [0.0, w[0], w[1], w[2], w[3]];
            let basis = &self.program.basis;
            let slope = basis.row_on(row.peak.piece, row.peak.u, &once);
            for (p, &(i, a)) in slope.iter().enumerate() {
                for &(j, b) in &slope[..=p] {
                    hessian.add(i, j, row.multiplier / falls * a * b);
                }
            }
        }
        hessian
    }

    /// Scale of a distance from a bound. For a limit with the minimised peak, it is at most the peak.
    fn size(&self, limit: &Limit<N>, at: &Solution<N>) -> f64 {
        let room = limit.room(&at.extra);
        if limit.is_peak() && at.extra[PEAK] != 0.0 {
            at.extra[PEAK].abs().min(limit.size(room))
        } else {
            limit.size(room)
        }
    }

    /// Maximum relative excess over all limits, including permanent rows and limits on further variables alone.
    fn violation(&self, at: &Solution<N>) -> f64 {
        let program = self.program;
        let over =
            |row: &Row<N>| -row.slack(&at.x, &at.extra) / row_unit(&row.entries, program.length);
        let of_rows = program.fixed.iter().map(over);
        let alone = program.limits.iter().filter(|l| l.is_on_variables_alone());
        let of_sizes = alone.map(|limit| {
            let room = limit.room(&at.extra);
            -room / limit.size(room)
        });
        let known = program.violation(&at.x, &at.extra);
        of_rows.chain(of_sizes).fold(known, f64::max)
    }

    /// Local maxima of the left sides of limits near their bounds.
    fn peaks_near(&self, at: &Solution<N>) -> Vec<(usize, Peak)> {
        let below = self.program.settings.refinement.below;
        self.peaks_above(at, |size| -below * size)
    }

    /// Local maxima whose excess over the bound is above `excess`, which is a function of the scale.
    fn peaks_above(&self, at: &Solution<N>, excess: impl Fn(f64) -> f64) -> Vec<(usize, Peak)> {
        let mut peaks = Vec::new();
        let level =
            |l: &Limit<N>| self.program.room(l, &at.x, &at.extra) + excess(self.size(l, at));
        self.program
            .each_peak_above(&at.x, level, |index, peak| peaks.push((index, peak)));
        peaks
    }

    /// Rows of a step: active rows, other local maxima near their bounds, permanent rows, and limits on further variables alone.
    fn candidates(&self, from: &Solution<N>) -> Vec<Row<N>> {
        let program = self.program;
        let mut rows = from.active.clone();
        for (index, peak) in self.peaks_near(from) {
            let row = program.row(index, peak);
            if !rows.iter().any(|r| self.is_same(r, &row)) {
                rows.push(row);
            }
        }
        for row in &program.fixed {
            let known = |r: &Row<N>| {
                let same = r.peak == row.peak && r.extra == row.extra;
                r.limit.is_none() && same && r.name == row.name
            };
            if !rows.iter().any(known) {
                rows.push(row.clone());
            }
        }
        // A limit on further variables alone is one row. No point of the law gives this row, so it is added here.
        for (index, limit) in program.limits.iter().enumerate() {
            if limit.is_on_variables_alone() && !rows.iter().any(|r| r.limit == Some(index)) {
                rows.push(program.row(index, Peak::default()));
            }
        }
        rows
    }

    /// Adds rows at the points at which the law violates limits.
    fn add_broken(&self, solution: &mut Solution<N>) {
        for (limit, peak) in self.program.broken(&solution.x, &solution.extra) {
            let row = self.program.row(limit, peak);
            if !solution.active.iter().any(|r| self.is_same(r, &row)) {
                solution.active.push(row);
            }
        }
    }

    /// Step with all active rows as equalities. Rows with negative multipliers are removed, the most negative first.
    fn held_step(&self, from: &Solution<N>, solves: &mut usize) -> Option<Solution<N>> {
        // A vertex has at most as many active points as unknowns. Many more active points result from an interior point or from a failed
        // step.
        let unknowns = self.program.basis.columns() + self.program.equalities.len();
        if from.active.len() > 2 * unknowns {
            return None;
        }
        let local = Local::new(self, from);
        let mut rows = from.active.clone();
        loop {
            *solves = solves.checked_sub(1)?;
            let mut next = local.held(&rows)?;
            let push = |r: &Row<N>| r.multiplier * row_unit(&r.entries, self.program.length);
            let pushes = || next.active.iter().map(push);
            let largest = pushes().fold(0.0, |m: f64, p| m.max(p.abs()));
            let negative = self.program.settings.refinement.negative_multiplier;
            let pulls = || pushes().enumerate().filter(|p| p.1 < -negative * largest);
            // About one system is solved for each removed row.
            if pulls().count() > *solves {
                return None;
            }
            match pulls().min_by(|a, b| a.1.total_cmp(&b.1)) {
                Some((row, _)) => drop(rows.remove(row)),
                None => {
                    next.active.retain(|r| r.multiplier > 0.0);
                    next.violation = self.violation(&next);
                    return Some(next);
                }
            }
        }
    }

    /// Step as a quadratic program about a solution, with rows at all points near their bounds. Rows are added at points that the step
    /// violates.
    fn program_step(&self, from: &Solution<N>) -> Option<Solution<N>> {
        let program = self.program;
        let local = Local::new(self, from);
        let mut rows = self.candidates(from);
        let settings = &program.settings.refinement;
        if rows.len() > settings.rows_per_unknown * program.basis.columns() {
            return None;
        }
        let mut last = None;
        for _ in 0..settings.joins {
            let mut next = local.solved(&rows)?;
            let count = rows.len();
            for (limit, peak) in self.peaks_above(&next, |size| settings.resolved * size) {
                let row = program.row(limit, peak);
                let width = program.width(peak.piece);
                let kinked = program.limits[limit].shape.is_some();
                let near = |r: &Row<N>| {
                    let apart = (r.peak.at - peak.at).abs();
                    r.limit == Some(limit) && !kinked && apart < settings.apart * width
                };
                if !rows.iter().any(|r| near(r) || self.is_same(r, &row)) {
                    rows.push(row);
                }
            }
            next.extra[PEAK] = program.own_peak(&next.x, &next.extra);
            next.violation = self.violation(&next);
            last = Some(next);
            if rows.len() == count {
                break;
            }
        }
        last
    }
}
