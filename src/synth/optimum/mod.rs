//! From a convex program to the best law under all limits: the angle at which the law touches its base circle, then the
//! limits that are not convex, by a sequence of convex programs.

pub mod easing;
mod refusal;
pub mod scp;
#[cfg(test)]
mod tests;
mod touching;

pub use refusal::{Refusal, Sought};

use super::limits::{self, ENLARGED, NonconvexLimits};
use super::qp::{
    self, Certificate, Demand, Equality, Failure, Limit, OFFSET, PEAK, PROVED, Program, Quadratic,
    RADIUS, RISE, Solution, Stop,
};
use super::search::Search;
use super::sizing;
use crate::criterion::Criterion;
use crate::law::Law;
use crate::problem::{Problem, Size};
use crate::scene::Minimise;
use crate::synth::report::method::{Ended, Method};
use crate::synth::report::proof::{self, Doubt};
use crate::synth::report::solver::{SolverReport, Step, Tier};

/// Tangents of the limit on residual vibration, per dwell; five are usual.
const MOST_TANGENTS: usize = 40;
/// Relative rounding of a lower bound of the force error.
const BOUND_ROUNDING: f64 = 1e-6;

/// The convex program of a problem over the functions of a family, with what its solution needs beside it.
#[derive(Clone)]
pub struct Formulation {
    /// Demands, objective and convex limits.
    pub program: Program,
    /// Half the mean square of the force error.
    pub force: Quadratic,
    /// α: the square part of the objective is at least ½ α mean(s″²); `None` where it has none.
    pub stiffness: Option<f64>,
    /// s ≥ 0, where the law has to stay above its base circle.
    pub above_base_circle: Option<Limit>,
    /// Spans, or half waves of the highest harmonic: contacts nearer than half of one are one contact.
    pub pieces: usize,
}

impl Formulation {
    /// Whether a law with these coefficients breaks a limit, its lowest point standing on the base circle where nothing
    /// else fixes the level.
    pub fn is_broken_by(&self, coefficients: &[f64]) -> bool {
        let program = &self.program;
        if program.limits.is_empty() && program.rms.is_empty() {
            return false;
        }
        let mut x = coefficients.to_vec();
        if program.constant_is_free() {
            x[0] -= Law::of(&program.basis, &x).extremes(0).0.value;
        }
        let misses = program.rms.iter().any(|limit| limit.excess(&x) > 0.0);
        misses || !program.broken(&x, &program.windows(&x)).is_empty()
    }
}

/// The best law found for a formulation.
pub struct Optimum {
    /// The formulation, at the touching angle.
    pub formulation: Formulation,
    /// The solution of its program, or the last one of the sequence.
    pub solution: Solution,
    /// The touching angle, where there was one to choose.
    at: Option<f64>,
    /// No touching angle gives an objective below this; `None` where none was to choose or nothing is proved.
    bound: Option<f64>,
    /// The sequence of convex programs, where one was needed.
    sequence: Option<Sequence>,
    /// Limits that are not convex and that no law was found to keep.
    pub left_out: bool,
}

/// How a sequence of convex programs went.
struct Sequence {
    steps: Vec<Step>,
    ended: Ended,
    /// Lower bound of the objective from the convex limits.
    least: Option<f64>,
}

/// The optimum under the convex limits alone.
///
/// # Errors
/// The program without solution.
pub fn convex(formulation: Formulation) -> Result<Optimum, Box<Refusal>> {
    let solved = touching::at_best_angle(formulation.program, formulation.stiffness)?;
    Ok(Optimum {
        formulation: Formulation {
            program: solved.program,
            ..formulation
        },
        solution: solved.solution,
        at: solved.at,
        bound: solved.bound,
        sequence: None,
        left_out: false,
    })
}

/// The optimum under the convex limits, without vibration in dwells, and under the limits on the loads.
///
/// # Errors
/// No law keeps the limits, or none that reaches the accuracy where only such a law is of use.
pub fn solve(
    problem: &Problem,
    search: &Search,
    formulation: Formulation,
) -> Result<Optimum, Box<Refusal>> {
    let mut optimum = convex(formulation)?;
    if search.only_passing && misses_accuracy(problem, &optimum) {
        return Err(Refusal::of(
            optimum.formulation.program,
            Failure::Infeasible,
        ));
    }
    without_vibration(problem, &mut optimum);
    match with_loads(problem, search, &mut optimum) {
        None => Ok(optimum),
        Some(limits) => {
            let failure = if search.halt.is_asked() {
                Stop::OutOfTime.into()
            } else {
                Failure::Infeasible
            };
            let refusal = Refusal {
                nonconvex: Some(limits),
                ..*Refusal::of(optimum.formulation.program, failure)
            };
            Err(Box::new(refusal))
        }
    }
}

impl Optimum {
    /// The law.
    pub fn law(&self) -> Law {
        Law::of(&self.formulation.program.basis, &self.solution.x)
    }

    /// RMS force error of the law, N.
    pub fn force_error(&self) -> f64 {
        self.formulation.force.root(&self.solution.x)
    }

    /// The report of a method with its certificate.
    pub fn proved(&self, report: SolverReport) -> SolverReport {
        let (certificate, doubt) = self.evidence();
        let doubt = doubt.or_else(|| proof::doubt(&certificate));
        SolverReport {
            certified: doubt.is_none(),
            doubt,
            certificate: Some(certificate),
            ..report
        }
    }

    /// The certificate of the law, and what else keeps it from being a proof.
    fn evidence(&self) -> (Certificate, Option<Doubt>) {
        let Some(sequence) = &self.sequence else {
            let (certificate, doubt) = self.of_convex();
            let left_out = self.left_out.then_some(Doubt::LeftOut);
            return (certificate, doubt.or(left_out));
        };
        let program = &self.formulation.program;
        let mut evidence = qp::certificate(program, &self.solution);
        let merit = program.merit(&self.solution);
        evidence.bounded_by(sequence.least.map(|least| merit - least));
        // Where the limits that are not convex cost nothing, no law that keeps the others is better.
        let is_global = evidence.global_gap.is_some_and(|gap| gap <= PROVED);
        (evidence, (!is_global).then_some(Doubt::Local))
    }

    /// The same of the convex program alone, over all touching angles.
    fn of_convex(&self) -> (Certificate, Option<Doubt>) {
        let program = &self.formulation.program;
        let mut evidence = qp::certificate(program, &self.solution);
        match (self.bound, self.at) {
            (Some(bound), _) => evidence.widen(program.merit(&self.solution) - bound),
            (None, Some(_)) => {
                // The multipliers speak of laws that touch at this angle.
                evidence.bounded_by(None);
                return (evidence, Some(Doubt::TouchingAngle));
            }
            (None, None) => (),
        }
        (evidence, None)
    }

    /// A lower bound of the objective over all laws that keep the convex limits, where one is known.
    fn least(&self) -> Option<f64> {
        let (evidence, doubt) = self.of_convex();
        let value = self.formulation.program.merit(&self.solution);
        doubt.is_none().then_some(value - evidence.duality_gap)
    }

    /// Which tier answered, how, and what is proved.
    pub fn report(&self) -> SolverReport {
        let solution = &self.solution;
        let violation = solution.violation;
        let (tier, method) = match &self.sequence {
            Some(Sequence { steps, ended, .. }) => {
                let method = Method::Sequence {
                    programs: steps.len() + 1,
                    ended: *ended,
                    violation,
                };
                (Tier::Scp, method)
            }
            None if !solution.used_rows => (Tier::Equality, Method::NoLimitActive),
            None => {
                let rounds = solution.rounds;
                let cone = !self.formulation.program.cones.is_empty();
                let tier = if cone { Tier::Socp } else { Tier::Qp };
                (tier, Method::Exchange { rounds, violation })
            }
        };
        let iterations = match tier {
            Tier::Equality => 0,
            _ => solution.iterations,
        };
        let steps = self.sequence.as_ref().map(|s| s.steps.clone());
        self.proved(SolverReport {
            steps: steps.unwrap_or_default(),
            ..SolverReport::of(tier, method, iterations)
        })
    }

    /// Takes the last law of a sequence in place of the convex optimum.
    fn ended_by(&mut self, program: Program, (refined, steps, ended): Refined) {
        let least = self.least();
        self.sequence = Some(Sequence {
            steps,
            ended,
            least,
        });
        self.formulation.program = program;
        self.solution = refined;
    }
}

/// Tangents of the limit on residual vibration, one after the other, until the law keeps it.
fn without_vibration(problem: &Problem, optimum: &mut Optimum) {
    let basis = &optimum.formulation.program.basis;
    let Some(vibrations) = limits::Vibrations::of(problem, basis) else {
        return;
    };
    for _ in 0..MOST_TANGENTS {
        let tangents = vibrations.tangents(&optimum.solution.x);
        if tangents.is_empty() {
            return;
        }
        let mut formulation = optimum.formulation.clone();
        formulation.program.fixed.extend(tangents);
        // Without a solution the check reports the residual vibration.
        let Ok(quieter) = convex(formulation) else {
            return;
        };
        *optimum = quieter;
    }
}

/// Whether the multipliers prove that no law which keeps the convex limits reaches the accuracy (theory §8): then a
/// sequence of convex programs is of no use. With an open number of spans more of them may reach it.
fn misses_accuracy(problem: &Problem, optimum: &Optimum) -> bool {
    let is_objective = problem.law.spans.is_some()
        && problem.objective() == Minimise::ForceError
        && !problem.is_weighed();
    let allowed = problem.allowed_error().filter(|_| is_objective);
    (allowed.zip(optimum.least()))
        .is_some_and(|(most, least)| (2.0 * least).max(0.0).sqrt() > (1.0 + BOUND_ROUNDING) * most)
}

/// Where the law breaks a limit on the loads, the sequence that keeps them; the limits where there is none.
fn with_loads(
    problem: &Problem,
    search: &Search,
    optimum: &mut Optimum,
) -> Option<NonconvexLimits> {
    let limits = NonconvexLimits::of(problem)?;
    limits.loads.as_ref()?;
    let (program, solution) = at_level(problem, optimum, &limits, &optimum.solution);
    let here = scp::AtSize::new(limits.clone(), &program).of(&solution);
    if limits::loaded(&Law::of(&program.basis, &solution.x), &here) >= 0.0 {
        return None;
    }
    (!in_sequence(problem, search, optimum, limits.clone())).then_some(limits)
}

/// Goes on with the sequence that keeps limits that are not convex, from the optimum without them or else from the smallest cam
/// without them; false where neither leads to a start.
fn in_sequence(
    problem: &Problem,
    search: &Search,
    optimum: &mut Optimum,
    limits: NonconvexLimits,
) -> bool {
    let (program, solution) = at_level(problem, optimum, &limits, &optimum.solution);
    if let Some(found) = sequence_from(problem, search, optimum, &limits, &program, &solution) {
        // The convex optimum itself, at a size of the same cost.
        let (refined, steps, _) = &found;
        let as_it_was = steps.is_empty() && refined.x == solution.x;
        if !as_it_was || program.merit(refined) > program.merit(&solution) {
            optimum.ended_by(program, found);
        }
        return true;
    }
    if limits.profile.is_none() || problem.size() != Size::Sought {
        return false;
    }
    let program = &optimum.formulation.program;
    let smallest = scp::of_least_size(program, &optimum.solution.extra);
    let Ok(mut smallest) = touching::at_best_angle(smallest, None) else {
        return false;
    };
    let least = &mut smallest.solution;
    least.extra[PEAK] = program.own_peak(&least.x, &least.extra);
    let (program, solution) = at_level(problem, optimum, &limits, &smallest.solution);
    let found = sequence_from(problem, search, optimum, &limits, &program, &solution);
    let is_found = found.is_some();
    if let Some(found) = found {
        optimum.ended_by(program, found);
    }
    is_found
}

/// The last law of a sequence, its steps and why no more were taken.
type Refined = (Solution, Vec<Step>, Ended);

/// The sequence from a program of known level and its solution; `None` where it has no start.
fn sequence_from(
    problem: &Problem,
    search: &Search,
    optimum: &Optimum,
    limits: &NonconvexLimits,
    program: &Program,
    solution: &Solution,
) -> Option<Refined> {
    let mut starts = starts(problem, program, solution);
    if problem.objective() == Minimise::PeakForceError {
        let force = &optimum.formulation.force;
        // Before the others: where no start holds, the last one is shrunk or tightened, and this one has its size already.
        starts.splice(0..0, nearest_to_force(problem, program, force, limits));
    }
    // A law that keeps every limit passes; only its force error may be left to reach.
    let passes = |s: &Solution| {
        let error = || limits::force_report(problem, &Law::of(&program.basis, &s.x)).rms_error_n;
        search.only_passing && problem.allowed_error().is_none_or(|most| error() <= most)
    };
    scp::refine(program, &starts, limits.clone(), passes)
}

/// Where a sequence may begin: at a solution of its program, and at the size that the law of that needs.
fn starts(problem: &Problem, program: &Program, solution: &Solution) -> Vec<Solution> {
    let mut out = Vec::new();
    // At the least radius of an arm the linearisation is singular.
    if problem.reach_of_arm().is_none() || problem.size() != Size::Sought {
        out.push(solution.clone());
    }
    out.extend(at_own_size(problem, program, solution));
    out
}

/// The law of the least mean square of the force error under the same limits, where the largest error is minimised: its programs
/// are the easier ones.
fn nearest_to_force(
    problem: &Problem,
    program: &Program,
    force: &Quadratic,
    limits: &NonconvexLimits,
) -> Option<Solution> {
    let mut near = program.clone().minimising(force.clone());
    near.rms.retain(|l| l.name != Criterion::Accuracy);
    let solution = near.solve().ok()?;
    let starts = starts(problem, &near, &solution);
    let (mut found, ..) = scp::refine(&near, &starts, limits.clone(), |_| false)?;
    found.active.clear();
    found.extra[PEAK] = program.own_peak(&found.x, &found.extra);
    Some(found)
}

/// The law as the sequence counts its lift: on its base circle, where neither drive nor demand says how high it stands and the
/// limits see that.
fn at_level(
    problem: &Problem,
    optimum: &Optimum,
    limits: &NonconvexLimits,
    solution: &Solution,
) -> (Program, Solution) {
    let (mut program, mut solution) = (optimum.formulation.program.clone(), solution.clone());
    if problem.level_is_known() || limits.profile.is_none() {
        return (program, solution);
    }
    // A limit that leaves the angle open lets the law be lower elsewhere, where all lifts only grow.
    let lowest = Law::of(&program.basis, &solution.x).extremes(0).0;
    solution.x = program.basis.raised(solution.x, -lowest.value);
    program.count_from(lowest.at);
    program.equalities.push(Equality {
        name: Demand::OnBaseCircle,
        entries: program.basis.row(lowest.at, &[1.0, 0.0, 0.0, 0.0]),
        value: 0.0,
    });
    let is_on_lift = |l: &Limit| l.name == Criterion::BaseCircle && !l.is_on_variables_alone();
    program.limits.retain(|l| !is_on_lift(l));
    program.limits.extend(optimum.formulation.above_base_circle);
    (program, solution)
}

/// Adds the nonconvex limits of the profile, by a sequence of convex programs.
pub fn with_profile(problem: &Problem, search: &Search, optimum: &mut Optimum) {
    if optimum.sequence.is_some() {
        return;
    }
    if let Some(limits) = NonconvexLimits::of(problem).filter(|l| l.profile.is_some()) {
        optimum.left_out = !in_sequence(problem, search, optimum, limits);
    }
}

/// A law of a size that is sought, with the size that it needs by itself: the program's own is the least that what is
/// convex allows, or any where nothing prices it. On an arm no larger than the arm reaches.
pub fn at_own_size(problem: &Problem, program: &Program, solution: &Solution) -> Option<Solution> {
    if problem.size() != Size::Sought {
        return None;
    }
    let mut out = solution.clone();
    let law = Law::of(&program.basis, &solution.x);
    let own = sizing::cam(problem, law.clone(), &law).ok();
    let prime = own.as_ref().map(|cam| cam.follower.prime_radius());
    if let Some([least, most]) = problem.reach_of_arm() {
        let most = (most * (1.0 - 4.0 * ENLARGED)).max(least);
        let prime = prime.map_or(most, |own| own * (1.0 + ENLARGED));
        out.extra[RADIUS] = prime.clamp(least, most);
    } else {
        let (prime, offset) = (prime?, own?.follower.offset());
        let rise = (prime * prime - offset * offset).max(0.0).sqrt();
        let sizes = [(RADIUS, prime), (RISE, rise), (OFFSET, offset)];
        let present = program.present();
        for (k, value) in sizes.into_iter().filter(|(k, _)| present[*k]) {
            out.extra[k] = value * if k == OFFSET { 1.0 } else { 1.0 + ENLARGED };
        }
    }
    Some(out)
}
