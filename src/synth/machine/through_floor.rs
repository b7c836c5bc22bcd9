//! Response of the floor as part of the program of a law. A change of the law changes the motion of the floor, and thereby the force. The
//! program and its certificate include this effect.
//!
//! The force on the moving floor is linear in the law: F = T P + const, where P maps the law to the force on a rigid floor. T contains the
//! gains Gₙ = 1/(1 − M Hₙ) of the harmonics. M is the moved mass, and Hₙ the floor acceleration per unit force at harmonic n. For high
//! orders, Gₙ tends to G∞.
//!
//! Let π be the derivative of the Lagrangian with respect to the force, and let * denote the adjoint operator. The derivative with respect
//! to the law is P*T*π on the moving floor, but P*π in a program with a fixed floor motion. The difference h = (T − G∞)*π is therefore
//! added to the objective. A law that is the optimum of its own program then satisfies the optimality conditions of the coupled program,
//! which is convex (theory §10).

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

/// Number of equally spaced angles at which π and h are evaluated.
const ANGLES: usize = 2880;
/// Number of harmonics of h. Their gains Gₙ − G∞ are inversely proportional to the square of the order, for high orders.
const COUNT: usize = 240;

/// Gains of the floor, and the units of the values in a state.
pub struct FloorResponse {
    minimised: Minimise,
    /// Gains Gₙ − G∞ of the harmonics n = 1, 2, … as real and imaginary part.
    gains: Vec<[f64; 2]>,
    at_once: f64,
    /// Minimum |Gₙ| over the harmonics; 0 at the resonance of an undamped mode.
    least: f64,
    /// Unit of h, in units of the objective per N.
    unit: f64,
    /// Scale of the objective, by which the constant in a state is divided.
    objective: f64,
}

impl FloorResponse {
    /// Number of values of a state.
    pub const VALUES: usize = 2 * COUNT + 1;

    /// Gains of a floor for a problem. If the objective is not the force error, the certificate of `first`, a first solved law of the
    /// problem, determines the unit of the objective.
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

    /// State of a law for the fixed-point iteration on a moving floor: the harmonics of h, and the constant that is added to the objective. All
    /// values are zero if the limits are infeasible.
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

    /// Change of the objective that a state contains.
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

    /// Upper bound of the gap of the coupled program at a law, in the units of the objective. The state of the law differs from the assumed
    /// state by at most `off`. `None` if no bound can be proved.
    ///
    /// At the coupled optimum, the force error is at most the force error of this law. The forces of the two laws on a rigid floor therefore
    /// differ by at most twice the force error of the law, divided by the minimum |Gₙ|. The bound includes the errors of h and of the force,
    /// multiplied by this difference. The curvature of the coupled objective is at least min |Gₙ|²/G∞ times the curvature of the objective of
    /// the program.
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

/// Mean over the turn of the product of two functions: `values` at equally spaced angles, and the part of the force that depends on the law.
fn mean_product(law: &Law, values: &[f64], problem: &Problem) -> f64 {
    let step = TAU / values.len() as f64;
    let own = |i: usize| problem.drive.force(law.svaj(step * i as f64)) - problem.drive.rest_force;
    let sum: f64 = (values.iter().enumerate()).map(|(i, h)| h * own(i)).sum();
    sum / values.len() as f64
}
