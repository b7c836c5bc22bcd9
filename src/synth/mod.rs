//! Cam design: computes a law, its certificate of optimality, and the cam from a target force.
//!
//! The law s(θ) is a linear combination of basis functions, s = Σ xᵢBᵢ. The force F = F₀ + k s + cω v + mω² a is linear in the law. F₀ is
//! the force at rest, k the spring rate, c the damping, m the mass and ω the shaft speed. The derivatives of the lift s with respect to the
//! cam angle are v and a. F* is the target force. Limits on lift, velocity, acceleration, jerk, force and flat-face curvature are linear in
//! the law too. The problem
//!
//! ```text
//! minimise   mean over the turn of (F(θ) − F*(θ))²      (or the energy or peak of a derivative)
//! such that  demands at points and dwells                 (equalities)
//!            Σ wₖ s⁽ᵏ⁾(θ) ≤ bound for every θ             (limits)
//! ```
//!
//! is therefore convex. It is solved by the first of the following methods that is sufficient. The next method is used only if a limit is
//! violated, or if the method cannot express a limit. Below, T is the turn, and W = (k, cω, mω²) are the weights of the force.
//!
//! **Spectral.** For harmonics n = 1 … N without active limits, the least-squares problem is diagonal. Its solution requires one division per
//! harmonic: ŝₙ = F̂ₙ / (k − mω²n² + i cωn).
//!
//! **Equality.** The law consists of B-splines of degree p on N spans with the coefficients x. Without limits, the problem is
//!
//! ```text
//! minimise  ½ xᵀHx + gᵀx      H = (1/T) ∫ φφᵀ,  g = −(1/T) ∫ φ (F* − F₀),  φ = W·(B, B′, B″)
//! such that E x = e           demands at points, dwells
//! ```
//!
//! H is banded with a border, because the law is periodic. One Cholesky factorisation is sufficient, with a cost that is linear in N. If
//! the force does not determine the mean lift (moving axis), one coefficient is fixed. The minimum of the lift is placed on the base circle
//! afterwards.
//!
//! **QP.** Limits a(θ)ᵀx ≤ b(θ) for every θ are added: acceleration, jerk, stroke, force, flat-face curvature, or a band about the target.
//! The method starts from the optimum without limits. The points of maximum violation, computed as roots in Bernstein form, become rows of a
//! dual active-set method. When all active points are known, Newton's method moves these points to the angles at which a(θ)ᵀx touches b(θ)
//! with equal slope. The method ends when no limit is exceeded at any angle by more than 4·10⁻¹⁰ of its scale. The interior-point solver
//! Clarabel replaces the active-set method if there are many rows or if it does not converge.
//!
//! **SOCP.** Prime radius R, height D and offset e are further variables (theory §6):
//!
//! ```text
//! v − e ≤ tan φ₁ (s + D),   −(v − e) ≤ tan φ₂ (s + D),   R ≥ ‖(D, e)‖
//! ```
//!
//! where R is minimised or bounded. For a flat face, the limit is R + s + a ≥ ρ instead. The solver Clarabel solves the program, and rows are
//! added and removed as for the QP.
//!
//! **SCP.** Some limits h(s, v, a, j, D, e) ≥ 0 are not convex. Limits of the profile restrict the curvature of a roller cam, or curvature
//! and pressure angle of followers on an arm. Load limits restrict the shaft torque F v, its rate F′v + F a, and the pressure between a
//! roller and its cam. The limits are linearised at the minima of h, and the convex program is solved. The step is halved until h ≥ 0 over
//! the whole turn. Every iterate is feasible, and every step improves the objective.
//!
//! **Polydyne.** For a compliant follower, the law y of its end is optimised. The law of the cam is s = y + x, where the deflection x
//! follows from x + (c₁ω/k₁) x′ = F(y)/k₁. The stiffness of the follower is k₁, and its damping is c₁. The limits for the end are changed
//! until the cam reaches its limits.
//!
//! **Accuracy.** If the objective is not the force error, √(mean (F − F*)²) ≤ e is a further convex limit. Half the square of the left side
//! is added to the objective. Its weight is chosen such that the limit is active. If a peak is minimised, the program minimises the force
//! error under a limit on the peak. The limit on the peak is changed until the force error is e.
//!
//! **Certificate.** The multipliers λ of the active rows prove a lower bound. The gap between objective and bound is Σ λ(b − aᵀx) + xᵀr, with
//! the gradient r of the Lagrangian. The product of λ and 1 % of a limit is the gain from relaxing this limit by 1 %.
//!
//! **Infeasible.** If there is no solution, a deletion filter finds an irreducible infeasible set of limits. For each limit of the set,
//! minimising its bound gives a first relaxed value. `relaxed` designs the complete cam with this value, and changes the value until every check
//! passes.

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
pub use design::walker::{AtResonance, OfWalker};
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

/// Designs the cam for a scene. `force` is one cycle of the target force, if the scene has one.
///
/// The result is complete even if a check fails. Its verdict states the failed check. If the limits are infeasible, `infeasible` contains the
/// reason, and the design is the best design without the limits.
///
/// # Errors
///
/// Errors of the input. No cam exists, for example because no law satisfies the conditions.
pub fn synthesise(scene: &Scene, force: Option<&ForceCurve>) -> Result<Design> {
    design(&Problem::resolve(scene, force)?, &Search::default())
}

impl Scene {
    /// Designs the cam for a scene whose force is a load model, or without a force.
    ///
    /// # Errors
    ///
    /// Errors of the scene. The scene refers to a force file, which requires [`Scene::design_for`].
    pub fn design(&self) -> Result<Design> {
        synthesise(self, self.model_force()?.as_ref())
    }

    /// Designs the cam for a scene and one cycle of force, such as the mean cycle of a recording.
    ///
    /// ```
    /// use gaitcam::Scene;
    /// use gaitcam::scene::Gait;
    ///
    /// // The force is used with and without a `gait` section in the scene.
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
    /// Errors of the scene. The drive cannot produce the force.
    pub fn design_for(&self, force: &ForceCurve) -> Result<Design> {
        synthesise(self, Some(force))
    }
}
