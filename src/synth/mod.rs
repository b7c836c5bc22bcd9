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
//! with R minimised, bounded or weighed, (e/e₁)² + R/R₁ + (j/j₁)²; under a flat face R + s + a ≥ ρ instead. Clarabel, on
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

mod design;
mod families;
mod infeasible;
mod limits;
mod machine;
mod optimum;
mod pareto;
mod phase;
pub(crate) mod population;
mod qp;
mod relaxation;
mod report;
mod search;
mod sizing;
pub(crate) mod spectral;
mod verdict;

pub use design::Design;
pub use design::edge::{Edge, EdgePoint};
pub use design::figures::{FIGURES, Figure, Figures};
pub use design::load_factors::LoadFactor;
pub use design::machine::MachineReport;
pub use design::resonance::AtFrequency;
pub use infeasible::reasons::in_units;
pub use machine::sensitivity::Sensitivity;
pub use pareto::{Trade, trade, traded};
pub use qp::{Certificate, Demand, Given, Stop};
pub use report::end::End;
pub use report::force::ForceReport;
pub use report::limited::{Binding, Conflicting, Easing, Infeasible, Minimised, Relaxation};
pub use report::method::{Ended, Method, PassedOver};
pub use report::named::unit;
pub use report::parameters::Functions;
pub use report::proof::Doubt;
pub use report::reason::{Change, Reason, sentences};
pub use report::shaft::{Forecast, OnShaft};
pub use report::solver::{SolverReport, Step, Tier};
pub use report::walkers::{OfPopulation, WalkerError};
pub use search::Search;
pub use spectral::{Spectral, invert};

use std::sync::Arc;

use crate::cam::{Check, LimitKind, Verdict};
use crate::error::{Placed, Result};
use crate::force::ForceCurve;
use crate::problem::{Note, Problem};
use crate::scene::{Minimise, Scene};
use families::SolvedLaw;
use optimum::{NoLaw, Refusal};
use sizing::checked_cam::{CheckedCam, checked_cam};

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
    /// # Errors
    /// Faults of the scene, and a force that its drive cannot give.
    pub fn design_for(&self, force: &ForceCurve) -> Result<Design> {
        synthesise(self, Some(force))
    }
}

/// The design of a problem, complete even where no law keeps its limits.
///
/// # Errors
/// Faults of the input.
pub fn design(problem: &Problem, search: &Search) -> Result<Design> {
    if let Some(walkers) = problem.walkers.clone() {
        return population::designed(problem, search, &walkers);
    }
    machine::on_machine::designed(problem, search)
}

/// A design that keeps every limit, not the best of them: soon enough to follow a hand. `None` where none is found.
///
/// ```
/// use gaitcam::synth::{Search, passing};
/// use gaitcam::{Problem, scene};
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let at = |stroke| -> gaitcam::error::Result<_> {
///     let scene = scene.with("limits.stroke", stroke)?;
///     passing(&Problem::resolve(&scene, scene.model_force()?.as_ref())?, &Search::default())
/// };
/// assert!(at("60 mm")?.is_some());
/// assert!(at("1 mm")?.is_none());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
/// Faults of the input.
pub fn passing(problem: &Problem, search: &Search) -> Result<Option<Design>> {
    let search = &search.for_passing_designs();
    let is_plain = problem.machine.motor().is_none() && problem.machine.floor().is_none();
    let found = if is_plain {
        passing_design(problem, search)
    } else {
        design(problem, search).map_err(NoLaw::Fault)
    };
    match found {
        Ok(design) => Ok(Some(design).filter(|d| d.verdict != Verdict::Unacceptable)),
        Err(NoLaw::Refused(_)) => Ok(None),
        Err(NoLaw::Fault(fault)) => Err(fault),
    }
}

/// The problem at its phase, the best one where that is free.
fn at_best_phase(problem: &Problem, search: &Search) -> Result<Problem> {
    sizing::check_arm(problem)?;
    let at = phase::resolve(problem, |at| least_error(at, search))?;
    Ok(at.into_owned())
}

/// The law on its cam, or the best one without limits and why those leave none.
fn solved(problem: &Problem, search: &Search) -> Result<(SizedLaw, Option<Infeasible>)> {
    let (sized, refusal) = best(problem, search)?;
    Ok((sized, refusal.map(|r| infeasible::explain(problem, &r))))
}

/// The law, or the best one without limits, raised onto the base circle, and what refuses one with them.
fn best_law(problem: &Problem, search: &Search) -> Result<(SolvedLaw, Option<Box<Refusal>>)> {
    match families::law(problem, search) {
        Ok(law) => Ok((law, None)),
        Err(NoLaw::Fault(fault)) => Err(fault),
        Err(NoLaw::Refused(refusal)) => {
            let (sized, refusal) = refused(problem, search, refusal)?;
            let law = sized.checked.cam.law;
            Ok((SolvedLaw { law, ..sized.law }, refusal))
        }
    }
}

/// The law on its cam, or the best one without limits and what refuses one with them.
fn best(problem: &Problem, search: &Search) -> Result<(SizedLaw, Option<Box<Refusal>>)> {
    match sized(problem, problem, search) {
        Ok(sized) => Ok((sized, None)),
        Err(NoLaw::Fault(fault)) => Err(fault),
        Err(NoLaw::Refused(refusal)) => refused(problem, search, refusal),
    }
}

/// The best law where limits leave none, with what refuses one.
fn refused(
    problem: &Problem,
    search: &Search,
    refusal: Box<Refusal>,
) -> Result<(SizedLaw, Option<Box<Refusal>>)> {
    // The law first: what is shown matters more than why, and the time may end before both are found.
    match without_limits(problem, search, &refusal) {
        Ok(sized) => Ok((sized, Some(refusal))),
        Err(NoLaw::Fault(fault)) => Err(fault),
        Err(NoLaw::Refused(_)) => {
            let why = infeasible::explain(problem, &refusal);
            Err(why.no_law().at_key(why.key_of_demands()))
        }
    }
}

/// The design of a problem that has one; why there is none is not looked for.
fn passing_design(problem: &Problem, search: &Search) -> std::result::Result<Design, NoLaw> {
    if population::is_judged(problem) {
        return Ok(design(problem, search)?);
    }
    let problem = &population::of_mean(problem);
    let problem = phase::resolve(problem, |at| least_error(at, search))?;
    let sized = sized(&problem, &problem, search)?;
    Ok(finished(&problem, search, sized, None)?)
}

/// The least RMS force error of a law under the limits of a problem, N; `None` where they leave no law.
fn least_error(mut problem: Problem, search: &Search) -> Result<Option<f64>> {
    if problem.limited_error().is_some() && !problem.is_weighed() {
        problem.law.minimise = Some(Minimise::ForceError);
    }
    let problem = &problem;
    match families::law(problem, search) {
        Ok(found) => {
            let force = limits::force_report(problem, &found.law);
            Ok(Some(force.rms_error_n))
        }
        Err(NoLaw::Refused(_)) => Ok(None),
        Err(NoLaw::Fault(fault)) => Err(fault),
    }
}

/// A law with how it was found, on its cam.
#[derive(Clone)]
struct SizedLaw {
    law: SolvedLaw,
    checked: CheckedCam,
    /// The follower's end, where the cam is cut for a compliant follower.
    end: Option<End>,
}

/// The law under the limits of `limited`, on the smallest or the given cam of the problem: the same problem, or
/// that without the limits where they leave no law.
fn sized(
    problem: &Problem,
    limited: &Problem,
    search: &Search,
) -> std::result::Result<SizedLaw, NoLaw> {
    if problem.law.polydyne
        && let Some(train) = problem.train()?
    {
        return machine::polydyne::design(problem, limited, search, &train);
    }
    Ok(on_cam(problem, families::law(limited, search)?)?)
}

/// A law on the smallest or the given cam of the problem.
fn on_cam(problem: &Problem, mut law: SolvedLaw) -> Result<SizedLaw> {
    let checked = checked_cam(problem, &law.law, law.circle, None)?;
    law.functions.raise(&mut law.coefficients, checked.raised);
    Ok(SizedLaw {
        law,
        checked,
        end: None,
    })
}

/// The best law without the accuracy where the other limits have one, without any limit, or without the base circle
/// either: what is shown where they leave none. Where the accuracy is a limit and the objective no force, the best is that of the
/// least force error.
fn without_limits(
    problem: &Problem,
    search: &Search,
    refusal: &Refusal,
) -> std::result::Result<SizedLaw, NoLaw> {
    let endless = Search::default();
    // Such laws are quickly found: where the time is over already, they get all that they take.
    let timely = if search.halt.is_asked() {
        endless.clone()
    } else {
        Search::until(search.halt.clone())
    };
    let of_accuracy = refusal.is_of_accuracy();
    let mut bare = if of_accuracy {
        problem.without_accuracy()
    } else {
        problem.without_limits()
    };
    bare.law.family = refusal.family();
    if problem.limited_error().is_some() && problem.objective() != Minimise::PeakForceError {
        bare.law.minimise = Some(Minimise::ForceError);
    }
    let mut best = sized(problem, &bare, &timely).or_else(|no_law| match no_law {
        NoLaw::Refused(_) => {
            bare.above_base_circle = false;
            sized(problem, &bare, &endless)
        }
        fault => Err(fault),
    })?;
    // The optimum under the limits that misses the accuracy keeps its proof, as where the force error is minimised.
    if !of_accuracy {
        // Nothing is proved of a law that breaks the limits.
        best.law.easing.clear();
        best.law.solver.certificate = None;
        best.law.solver.certified = false;
        best.law.solver.doubt = Some(Doubt::Limits);
    }
    Ok(best)
}

/// The law on its cam with its verdict and its notes.
fn finished(
    problem: &Problem,
    search: &Search,
    sized: SizedLaw,
    infeasible: Option<Infeasible>,
) -> Result<Design> {
    let SizedLaw { law, checked, end } = sized;
    let infeasible = infeasible.or_else(|| {
        let fails = |c: &&Check| c.name == LimitKind::PrimeRadius && !c.pass;
        let too_large = checked.checks.iter().find(fails);
        too_large.and_then(|_| infeasible::bore_against_size(problem))
    });
    let (mut verdict, mut reasons) =
        verdict::verdict(problem, &checked.cam, &checked.checks, &checked.force);
    if let Some(infeasible) = &infeasible {
        verdict = Verdict::Unacceptable;
        reasons.retain(|r| matches!(r, Reason::MeanForce { .. }));
        reasons.extend(infeasible.reasons.iter().cloned());
    }
    let mut notes = notes(problem, search, &law, &checked, end.as_ref());
    if matches!(reasons.first(), Some(Reason::MeanForce { .. })) {
        notes.retain(|n| !matches!(n, Note::MeanForce { .. }));
    }
    Ok(Design {
        name: problem.name.clone(),
        shaft: None,
        floor: None,
        population: None,
        phase: problem.phase,
        weight_n: problem.weight_n,
        band: problem.band.clone(),
        target: problem.target.as_ref().map(|t| (*t.curve).clone()),
        drive: problem.drive,
        family: law.family.name().to_string(),
        functions: law.functions,
        coefficients: law.coefficients,
        degree: law.degree,
        cam: checked.cam,
        end,
        conjugate: checked.conjugate,
        groove: checked.groove,
        bore: problem.cam.hole(),
        mark: problem.cam.mark,
        thickness: problem.cam.thickness,
        making: problem.cam.making(),
        force: checked.force,
        infeasible,
        relaxations: Vec::new(),
        together: Vec::new(),
        verdict,
        reasons,
        checks: checked.checks,
        binding: law.binding,
        easing: law.easing,
        solver: law.solver,
        out_of_time: search.halt.is_asked(),
        notes,
        problem: Arc::new(problem.clone()),
    })
}

/// What a user should know of problem, law and size.
fn notes(
    problem: &Problem,
    search: &Search,
    found: &SolvedLaw,
    checked: &CheckedCam,
    end: Option<&End>,
) -> Vec<Note> {
    let mut out = problem.notes();
    if search.halt.is_asked() {
        out.push(Note::OutOfTime);
    }
    out.extend(families::stopped_at_noise(problem, found.family));
    let cams = (
        &checked.cam,
        checked.conjugate.as_ref().map(|pair| &pair.second),
    );
    out.extend(sizing::notes(problem, cams, checked.pressing()));
    out.extend(end.map_or_else(Vec::new, |e| e.notes(problem.drive.speed)));
    out
}
