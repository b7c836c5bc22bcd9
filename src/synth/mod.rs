//! Design: from a target force to a law, its certificate and its cam.
//!
//! One law s(θ) is sought in a linear family, s = Σ xᵢBᵢ. The force F₀ + k s + cω v + mω² a is linear in
//! it, and so is every limit on lift, speed, acceleration, jerk, force and flat-face curvature. Hence
//!
//! ```text
//! minimise   mean over the turn of (F(θ) − F*(θ))²      (or the energy or peak of a derivative)
//! such that  demands at points and dwells                 (equalities)
//!            Σ wₖ s⁽ᵏ⁾(θ) ≤ bound for every θ             (limits)
//! ```
//!
//! is convex. It is solved by the simplest method that is sufficient; the next one is used only when a limit is
//! violated or cannot be expressed. Below, T is the turn, W = (k, cω, mω²) the force's weights.
//!
//! **Spectral.** With harmonics n = 1 … N as the family and no limit broken, the least squares fall apart:
//! ŝₙ = F̂ₙ / (k − mω²n² + i cωn), one division each.
//!
//! **Equality.** B-splines of degree p on N spans, coefficients x:
//!
//! ```text
//! minimise  ½ xᵀHx + gᵀx      H = (1/T) ∫ φφᵀ,  g = −(1/T) ∫ φ (F* − F₀),  φ = W·(B, B′, B″)
//! such that E x = e           demands at points, dwells
//! ```
//!
//! H is banded with a border (the turn closes); one Cholesky factor, cost linear in N. Where nothing fixes the
//! level (moving axis) one coefficient is pinned and the lowest point put on the base circle afterwards.
//!
//! **QP.** The same with a(θ)ᵀx ≤ b(θ) for every θ: acceleration, jerk, stroke, force, flat-face curvature, a band
//! about the target. From the optimum without limits the exact worst points of the law (roots in Bernstein
//! form) enter as rows of a dual active-set method; once all contacts are known Newton's method moves them
//! to where a(θ)ᵀx touches b(θ) with equal slope. Ends when no limit is exceeded on the continuum by 4·10⁻¹⁰
//! of its size. Where rows are many, or the active set does not end, Clarabel takes its place.
//!
//! **SOCP.** Prime radius R, height D and offset e join x (theory §6):
//!
//! ```text
//! v − e ≤ tan φ₁ (s + D),   −(v − e) ≤ tan φ₂ (s + D),   R ≥ ‖(D, e)‖
//! ```
//!
//! with R minimised or bounded; under a flat face R + s + a ≥ ρ instead. Clarabel, on
//! exchanged rows.
//!
//! **SCP.** What is not convex: h(s, v, a, j, D, e) ≥ 0 for a roller's curvature, for curvature and pressure angle
//! of followers on an arm, for the shaft's torque F v and its rate F′v + F a, and for the pressure between a
//! roller and its cam. Linearised at its low points, solved, the step halved until the true h holds all
//! around; every iterate is feasible and every step improves the objective.
//!
//! **Polydyne.** Under a follower that gives, the law sought is that of its end y; the cam's is
//! s = y + x with x + (c₁ω/k₁) x′ = F(y)/k₁. Limits of the end move until the cam's own are reached.
//!
//! **Accuracy.** Where something else than the force error is minimised, √(mean (F − F*)²) ≤ e is one more convex limit: its
//! half square is added to the objective with the weight at which it holds with equality. Where a peak is minimised, the force
//! error is, under the peak at which it is e.
//!
//! **Certificate.** The multipliers λ of the active rows prove a lower bound; objective less bound is
//! Σ λ(b − aᵀx) + xᵀr with r the Lagrangian's gradient. λ times 1 % of a limit is what easing it would buy.
//!
//! **Infeasible.** Without a solution a deletion filter leaves an irreducible infeasible set of limits; for each of
//! them the program with its bound minimised is a first relaxation. `relaxed` designs the whole cam with
//! each value and moves it until every check passes.

mod attempt;
pub(crate) mod closed_form;
mod design;
mod families;
mod finish;
mod infeasible;
mod limits;
mod machine;
mod optimum;
mod outcome;
mod pareto;
mod phase;
pub(crate) mod population;
pub(crate) mod qp;
mod relaxation;
pub(crate) mod report;
#[cfg(test)]
mod samples;
mod search;
mod sizing;
mod synthesis;
mod verdict;

pub use design::Design;
pub use design::edge::{Edge, EdgePoint};
pub use design::figures::{FIGURES, Figure, Figures};
pub use design::resonance::AtFrequency;
pub use families::inverse::invert;
pub use infeasible::reasons::in_units;
pub use outcome::{Outcome, answer};
pub use pareto::{Trade, trade, traded};
pub use report::end::End;
pub use report::force::ForceReport;
pub use report::limited::{Binding, Conflicting, Infeasible, Relaxation};
pub use report::method::{Method, PassedOver};
pub use report::named::unit;
pub use report::parameters::Functions;
pub use report::proof::Doubt;
pub use report::reason::{Reason, sentences};
pub use report::shaft::OnShaft;
pub use report::solver::{SolverReport, Tier};
pub(crate) use report::walkers::OfPopulation;
pub use search::Search;
pub use synthesis::{design, passing};

use crate::error::Result;
use crate::force::ForceCurve;
use crate::problem::Problem;
use crate::scene::Scene;

/// Designs the cam that a scene asks for. `force` is one cycle of the target force, where the scene has one.
///
/// The answer is complete even when a check fails or the limits leave nothing; then `infeasible` or the
/// verdict says so, and the design shown is the best one without the limits.
///
/// # Errors
/// Faults of the input.
pub fn synthesise(scene: &Scene, force: Option<&ForceCurve>) -> Result<Design> {
    design(&Problem::resolve(scene, force)?, &Search::default())
}

impl Scene {
    /// The design of a scene that names its own force, or none.
    ///
    /// # Errors
    /// Faults of the scene, and a force that has to be read from a file: [`Scene::design_for`] takes it.
    pub fn design(&self) -> Result<Design> {
        synthesise(self, self.model_force()?.as_ref())
    }

    /// The design of a scene for one cycle of force, such as a recording's mean cycle.
    ///
    /// ```
    /// use gaitcam::Scene;
    /// use gaitcam::scene::Gait;
    ///
    /// // The force is used whether the scene has a section for it or not.
    /// let young = Gait { step_frequency: Some(1.85), ..Gait::model("young") };
    /// let force = young.model_force()?.unwrap();
    /// let with = Scene { gait: Some(Gait::given()), ..Scene::default() };
    /// let without = Scene::default().design_for(&force)?.cam.law.stroke();
    /// assert_eq!(without, with.design_for(&force)?.cam.law.stroke());
    /// assert!(without > 0.0);
    /// # Ok::<(), gaitcam::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Faults of the scene, and a force that its drive cannot give.
    pub fn design_for(&self, force: &ForceCurve) -> Result<Design> {
        synthesise(self, Some(force))
    }
}
