//! Response of the floor as part of the program of a law: the effect of a change of the law through the floor, with a certificate that includes it.
//!
//! The force on the moving floor is linear in the law: F = T P + const, where T contains the gains Gₙ = 1/(1 − M Hₙ) of the harmonics. With the
//! derivative π of the Lagrangian with respect to the force, the derivative with respect to the law is P*T*π. In a program with a fixed floor motion
//! it is P*π. The difference h = (T − G∞)*π is added to the objective. A law that is the optimum of its program then satisfies the optimality
//! conditions of the coupled program, which is convex (theory §10).

use std::f64::consts::TAU;

use crate::dynamics::Floor;
use crate::dynamics::floor::{Term, harmonics, times};
use crate::dynamics::machine_motion::MachineMotion;
use crate::law::Law;
use crate::poly::samples;
use crate::problem::{Problem, ThroughFloor};
use crate::scene::Minimise;
use crate::synth::attempt::Attempt;
use crate::synth::families::SolvedLaw;
use crate::synth::qp::Certificate;

/// Number of equal angles of π and h.
const ANGLES: usize = 2880;
/// Number of harmonics of h, whose gains decrease with the square of their order.
const COUNT: usize = 240;

/// Gains of the floor, with the units of the state.
pub struct FloorResponse {
    minimised: Minimise,
    /// Gₙ − G∞ for the harmonics from the first on.
    gains: Vec<[f64; 2]>,
    at_once: f64,
    /// Minimum |Gₙ| over the harmonics; 0 at the resonance of an undamped mode.
    least: f64,
    /// Unit of h, in units of the objective per N.
    unit: f64,
    /// Unit of the objective.
    objective: f64,
}

impl FloorResponse {
    /// Number of values of a state.
    pub const VALUES: usize = 2 * COUNT + 1;

    /// Response of a floor to the laws of a problem. `first` is one of these laws.
    pub fn of(problem: &Problem, floor: &Floor, first: &SolvedLaw) -> FloorResponse {
        let drive = &problem.drive;
        let at_once = floor.felt_at_once(drive.mass);
        let felt = floor.felt(drive.mass, drive.speed, COUNT);
        let sizes = felt.iter().map(|[re, im]| libm::hypot(*re, *im));
        let least = sizes.fold(at_once, f64::min);
        let mean = problem.target_mean();
        let size = |c: &Certificate| c.size;
        let objective = match problem.objective() {
            Minimise::ForceError => mean * mean,
            _ => first.solver.certificate.as_ref().map_or(1.0, size),
        };
        FloorResponse {
            minimised: problem.objective(),
            gains: felt.iter().map(|[re, im]| [re - at_once, *im]).collect(),
            at_once,
            least,
            unit: objective / mean,
            objective,
        }
    }

    /// State of a law for the fixed-point iteration on a moving floor: harmonics of h, and the constant of the program's objective. Zero if the
    /// limits are infeasible.
    pub fn state(&self, problem: &Problem, attempt: &Attempt, motion: &MachineMotion) -> Vec<f64> {
        if attempt.refusal.is_some() {
            return vec![0.0; FloorResponse::VALUES];
        }
        let (law, price) = (&attempt.law.law, &attempt.law.price);
        let target = problem.target_at_cam();
        let error = |x: f64| {
            let own = problem.drive.force(law.svaj(x)) + problem.learned_force(x);
            own + problem.drive.mass * motion.floor_at(x) - target.map_or(0.0, |t| t.at(x))
        };
        let mut square = 0.0;
        let of = |i: usize| {
            let x = TAU * i as f64 / ANGLES as f64;
            let (error, weight) = (error(x), problem.weight(x));
            square += 0.5 * weight * error * error / ANGLES as f64;
            (price.of_objective * weight + price.of_accuracy) * error
        };
        let mut terms = harmonics(&(0..ANGLES).map(of).collect::<Vec<_>>());
        terms.truncate(COUNT);
        for (n, term) in (1..).zip(&mut terms) {
            for (at, multiplier) in &price.of_limits {
                let (sine, cosine) = libm::sincos(n as f64 * at);
                term.0 += 2.0 * multiplier * cosine;
                term.1 += 2.0 * multiplier * sine;
            }
        }
        let slope: Vec<Term> = (terms.iter().zip(&self.gains))
            .map(|(term, [re, im])| times(*term, [*re, -im]))
            .collect();
        let along = mean_product(law, &samples(&slope, 0, ANGLES), problem);
        let constant = (1.0 - self.at_once) * price.of_objective * square - along;
        let parts = slope
            .iter()
            .flat_map(|(a, b)| [a / self.unit, b / self.unit]);
        parts.chain([constant / self.objective]).collect()
    }

    /// Change of the objective for a state.
    pub fn through(&self, state: &[f64]) -> ThroughFloor {
        let (slope, constant) = state.split_at(2 * COUNT);
        let pairs = slope.chunks_exact(2);
        ThroughFloor {
            minimised: self.minimised,
            at_once: self.at_once,
            slope: pairs
                .map(|p| (self.unit * p[0], self.unit * p[1]))
                .collect(),
            constant: self.objective * constant[0],
        }
    }

    /// Gap of the coupled program at a law whose state differs from the assumed one by at most `off`, in units of the objective; `None` without a
    /// proof.
    ///
    /// At the coupled optimum the force error is at most that of the law, so the rigid forces differ by at most twice this error divided by the
    /// minimum |Gₙ|. The difference of h and that of the force act on this distance. The curvature of the coupled objective is at least min |Gₙ|²/G∞
    /// times that of the program.
    pub fn gap(&self, problem: &Problem, attempt: &Attempt, off: f64) -> Option<f64> {
        let price = &attempt.law.price;
        let own = attempt.law.solver.certificate.as_ref()?.duality_gap;
        let of_error = price.of_objective + price.of_accuracy;
        if of_error == 0.0 && price.of_limits.is_empty() && price.is_whole {
            return Some(own);
        }
        let error = match problem.objective() {
            Minimise::ForceError => attempt.cam.force.rms_error_n,
            _ => problem.limited_error()?,
        };
        let apart = 2.0 * error / self.least;
        let curvature = match problem.objective() {
            Minimise::ForceError => (self.at_once / self.least.powi(2)).max(1.0),
            _ => 1.0,
        };
        let force = problem.target_mean() * off;
        let slope = self.unit * off * (COUNT as f64).sqrt() + of_error * force;
        let of_limits = price.of_limits.iter().map(|(_, m)| m.abs()).sum::<f64>() * force;
        let is_bounded = price.is_whole && self.least > 0.0;
        is_bounded.then_some(curvature * own + apart * slope + of_limits)
    }
}

/// Mean over the turn of a function at equal angles times the part of the force that depends on the law.
fn mean_product(law: &Law, values: &[f64], problem: &Problem) -> f64 {
    let step = TAU / values.len() as f64;
    let own = |i: usize| problem.drive.force(law.svaj(step * i as f64)) - problem.drive.rest_force;
    let sum: f64 = (values.iter().enumerate()).map(|(i, h)| h * own(i)).sum();
    sum / values.len() as f64
}
