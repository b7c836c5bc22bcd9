//! A formulated program with its solution and certificate.

use crate::law::Law;
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::qp::{self, Certificate, Limit, PROVED, Program, Quadratic, Solution};
use crate::synth::report::method::{Ended, Method};
use crate::synth::report::proof::{self, Doubt};
use crate::synth::report::solver::{SolverReport, Step, Tier};

/// Relative margin for rounding errors. The required accuracy is proved infeasible only if the lower bound of the force error exceeds it by
/// more than this margin.
const BOUND_ROUNDING: f64 = 1e-6;

/// Result of a sequence of convex programs: final solution, steps, and reason for the end.
pub type Refined = (Solution, Vec<Step>, Ended);

/// Convex program of a problem, for the basis functions of one family, with additional data for its solution.
#[derive(Clone)]
pub struct Formulation {
    /// Equalities, objective and convex limits.
    pub program: Program,
    /// Half the mean square force error, N², as a function of the coefficients.
    pub force: Quadratic,
    /// Convexity α of the objective: its quadratic part is at least ½ α mean(s″²). `None` if no such α > 0 is known.
    pub stiffness: Option<f64>,
    /// Limit s ≥ 0; `None` if the law may be below its base circle.
    pub above_base_circle: Option<Limit>,
    /// Number of spans, or of half waves of the highest harmonic. Active rows of a limit within half a span count as one active point.
    pub pieces: usize,
}

impl Formulation {
    /// Whether the law with these coefficients violates a limit. The law is first placed on its base circle, unless the drive or a condition
    /// fixes the level of the lift.
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

/// Best law of a formulated program, with its touching angle and its bounds.
pub struct Optimum {
    /// The formulation with the best touching angle.
    pub formulation: Formulation,
    /// Solution of the program, or last solution of the sequence of convex programs.
    pub solution: Solution,
    /// Touching angle on the base circle, rad; `None` if no limit depends on it.
    pub at: Option<f64>,
    /// Lower bound of the objective over all touching angles; `None` if the angle is fixed or nothing is proved.
    pub bound: Option<f64>,
    /// Sequence of convex programs, if one was necessary.
    pub sequence: Option<Sequence>,
    /// Whether the law violates the non-convex limits, because no feasible law was found.
    pub left_out: bool,
}

/// Report on a sequence of convex programs.
pub struct Sequence {
    /// Steps that improved the objective, in order.
    steps: Vec<Step>,
    /// Reason why the sequence ended.
    ended: Ended,
    /// Lower bound of the objective over all laws within the convex limits.
    least: Option<f64>,
}

impl Optimum {
    /// Law with the coefficients of the solution.
    pub fn law(&self) -> Law {
        Law::of(&self.formulation.program.basis, &self.solution.x)
    }

    /// RMS force error of the law, N.
    pub fn force_error(&self) -> f64 {
        self.formulation.force.root(&self.solution.x)
    }

    /// Adds the certificate of the law to a report.
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

    /// Certificate of the law, and the reason if it does not prove that the law is optimal.
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
        // If the non-convex limits do not increase the objective, no law within the other limits is better.
        let is_global = evidence.global_gap.is_some_and(|gap| gap <= PROVED);
        (evidence, (!is_global).then_some(Doubt::Local))
    }

    /// Certificate of the convex program alone, over all touching angles.
    fn of_convex(&self) -> (Certificate, Option<Doubt>) {
        let program = &self.formulation.program;
        let mut evidence = qp::certificate(program, &self.solution);
        match (self.bound, self.at) {
            (Some(bound), _) => evidence.widen(program.merit(&self.solution) - bound),
            (None, Some(_)) => {
                // The multipliers are valid only for laws that touch at this angle.
                evidence.bounded_by(None);
                return (evidence, Some(Doubt::TouchingAngle));
            }
            (None, None) => (),
        }
        (evidence, None)
    }

    /// Lower bound of the objective over all laws within the convex limits; `None` if nothing is proved.
    fn least(&self) -> Option<f64> {
        let (evidence, doubt) = self.of_convex();
        let value = self.formulation.program.merit(&self.solution);
        doubt.is_none().then_some(value - evidence.duality_gap)
    }

    /// Whether the multipliers prove that no law within the convex limits reaches the accuracy (theory §8). A sequence of convex programs
    /// cannot change this. The result is `false` if the number of spans is automatic, since more spans may reach the accuracy. It is also
    /// `false` for a floor that responds to the law, because the objective then changes from iteration to iteration.
    pub fn misses_accuracy(&self, problem: &Problem) -> bool {
        let is_objective = problem.law.spans.is_some()
            && problem.objective() == Minimise::ForceError
            && !problem.is_weighed()
            && problem.through_floor().is_none();
        let allowed = problem.allowed_error().filter(|_| is_objective);
        (allowed.zip(self.least())).is_some_and(|(most, least)| {
            (2.0 * least).max(0.0).sqrt() > (1.0 + BOUND_ROUNDING) * most
        })
    }

    /// Report on the solution: method, iterations and certificate.
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

    /// Replaces the optimum of the convex program by the final law of a sequence of convex programs.
    pub fn ended_by(&mut self, program: Program, (refined, steps, ended): Refined) {
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
