//! Synthesis: from a wanted force to a law, a cam and its proof.
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
//! is convex. The ladder solves it with the least that is enough; a rung is climbed only when the one below
//! breaks a limit or cannot say what is asked. Below, T is the turn, W = (k, cω, mω²) the force's weights.
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
//! of its size. From 250 spans on the coefficients of s, v, a and j are unknowns of their own, tied by
//! c′ᵢ = fᵢ (cᵢ − cᵢ₋₁), and Clarabel takes the active set's place: cost linear in the spans, digits kept.
//!
//! **SOCP.** Prime radius R, height D and offset e join x (theory §6):
//!
//! ```text
//! v − e ≤ tan φ₁ (s + D),   −(v − e) ≤ tan φ₂ (s + D),   R ≥ ‖(D, e)‖
//! ```
//!
//! with R minimised, bounded or weighed, (e/e₁)² + R/R₁ + (j/j₁)²; under a flat face R + s + a ≥ ρ instead. Clarabel, on exchanged rows.
//!
//! **SCP.** What is not convex: h(s, v, a, j, D, e) ≥ 0 for a roller's curvature, for curvature and pressure angle
//! of followers on an arm, for the shaft's torque F v and its rate F′v + F a, and for the pressure between a
//! roller and its cam. Linearised at its low points, solved, the step halved until the true h holds all
//! around; every iterate is feasible and every step improves the objective.
//!
//! **Polydyne.** Under a follower that gives, the law sought is that of its end y; the cam's is
//! s = y + x with x + (c₁ω/k₁) x′ = F(y)/k₁. Limits of the end move until the cam's own are reached.
//!
//! **Certificate.** The multipliers λ of the active rows prove a lower bound; objective less bound is
//! Σ λ(b − aᵀx) + xᵀr with r the Lagrangian's gradient. λ times 1 % of a limit is what easing it would buy.
//!
//! **Conflict.** Without a solution, limits are dropped one by one to a smallest set that fights; for each of
//! them the program with its bound minimised gives the least relaxation. `relaxed` designs the whole cam with
//! each value and moves it until every check passes.

mod answer;
mod conflict;
mod demand;
mod design;
mod double_harmonic;
mod easing;
mod family;
mod fight;
mod harmonic;
mod knob;
pub mod lab;
mod limits;
mod loads;
mod machine;
mod nonconvex;
mod phase;
mod polydyne;
mod polynomial;
pub mod qp;
mod relax;
mod sequence;
mod spline;
mod trade;
mod verify;

pub use answer::{
    Binding, Easing, End, ForceReport, Infeasible, Relaxation, SolverReport, Step, Synthesis, Tier,
};
pub use conflict::in_units;
pub use qp::Certificate;
pub use relax::relaxed;
pub use trade::{Against, Trade, trade};

use crate::cam::{Cam, Check};
use crate::error::{Error, Place, Result};
use crate::force::{ForceCurve, doubt};
use crate::law::{Extent, Law, Segment, constant_breadth, program};
use crate::scene::{Family, Minimise, Scene, Source};
use demand::Demand;

/// A law with how it was found, before it has a cam.
#[derive(Clone)]
struct Found {
    law: Law,
    family: Family,
    degree: usize,
    coefficients: Vec<f64>,
    binding: Vec<Binding>,
    easing: Vec<Easing>,
    solver: SolverReport,
    infeasible: Option<Infeasible>,
}

/// Designs the cam that a scene asks for. `target` is one cycle of wanted force, where the scene has one.
///
/// The answer is complete even when a check fails or the limits leave nothing; then `infeasible` or the
/// verdict says so, and the design shown is the best one without the limits that fight. Fails only on
/// faults of the input.
pub fn synthesise(scene: &Scene, target: Option<&ForceCurve>) -> Result<Synthesis> {
    answer(scene, target, true)
}

/// The same; without `explain` a scene that leaves no law is an error that does not say why.
fn answer(scene: &Scene, target: Option<&ForceCurve>, explain: bool) -> Result<Synthesis> {
    let (scene, free_phase) = &phase::settle(scene, target)?;
    let mut demand = Demand::settle(scene, target)?;
    demand.explain = explain;
    if let Some(phase) = free_phase {
        demand.remarks.push(format!(
            "The cam's turn begins at {:.3}° of the force cycle: the phase with the least error.",
            phase.to_degrees()
        ));
    }
    let (mut found, cam, end) = designed(scene, &demand)?;
    let pressing = end.as_ref().map_or(&cam.law, |end| &end.law);
    let force = verify::law_force(&demand, pressing);
    let conjugate = design::conjugate(scene, &cam)?;
    let groove = design::groove(scene, &cam)?;
    let mut checks = verify::checks(scene, &demand, &cam, pressing, &force);
    checks.extend(machine::checks(scene, &demand, &cam, pressing));
    checks.extend(verify::second_cam(scene, conjugate.as_ref()));
    checks.extend(verify::groove(scene, groove.as_ref()));
    let too_large = |c: &Check| c.name == "prime_radius" && !c.pass;
    if found.infeasible.is_none() && checks.iter().any(too_large) {
        found.infeasible = conflict::bore_against_size(scene);
    }
    let (mut verdict, mut reason) = verify::verdict(scene, &demand, &cam, &checks, &force);
    if let Some(infeasible) = &found.infeasible {
        verdict = crate::cam::Verdict::Unacceptable;
        reason = infeasible.words.clone();
    }
    let mut remarks = scene.ignored();
    if let (Some(gait), Some(target)) = (&scene.gait, target)
        && matches!(gait.source, Source::File { .. })
    {
        remarks.extend(doubt(target, gait.feet));
    }
    remarks.extend(demand.remarks.iter().cloned());
    remarks.extend(spline::stopped_at_noise(scene, &demand, found.family));
    remarks.extend(design::chosen_size(scene, &cam));
    let splines = if found.family == Family::Spline {
        found.degree
    } else {
        usize::MAX
    };
    remarks.extend(end.as_ref().map(|e| e.remark(demand.drive.speed, splines)));
    Ok(Synthesis {
        name: scene.name.clone(),
        phase: demand.phase,
        band: demand.band(scene).ok().flatten(),
        target: demand.target,
        drive: demand.drive,
        family: found.family.name().to_string(),
        coefficients: found.coefficients,
        degree: found.degree,
        cam,
        end,
        conjugate,
        groove,
        bore: scene.cam.bore,
        thickness: scene.cam.thickness,
        force,
        infeasible: found.infeasible,
        relaxations: Vec::new(),
        together: Vec::new(),
        verdict,
        reason,
        checks,
        binding: found.binding,
        easing: found.easing,
        solver: found.solver,
        remarks,
    })
}

/// The law with its cam, and with the follower's end where the cam is cut for one that gives.
fn designed(scene: &Scene, demand: &Demand) -> Result<(Found, Cam, Option<End>)> {
    if scene.law.polydyne
        && let Some(train) = scene.machine.train(&demand.drive)?
    {
        let (found, cam, end) = polydyne::design(scene, demand, &train)?;
        return Ok((found, cam, Some(end)));
    }
    let found = find_law(scene, demand)?;
    let law = on_base_circle(scene, demand, found.law.clone());
    let cam = design::cam(scene, demand, law.clone(), &law)?;
    Ok((found, cam, None))
}

/// Where nothing fixes the lift, the lowest point of the law stands on the base circle.
fn on_base_circle(scene: &Scene, demand: &Demand, law: Law) -> Law {
    if spline::level_is_known(scene, demand) {
        return law;
    }
    let lowest = law.extremes(0).0.value;
    law.raised(-lowest)
}

fn find_law(scene: &Scene, demand: &Demand) -> Result<Found> {
    match scene.law.family {
        Family::Spline => from_spline(scene, demand),
        Family::Auto => family::simplest(scene, demand),
        Family::Ladder => family::ladder(scene, demand),
        Family::Polynomial => {
            let p = polynomial::through_points(scene, demand)?;
            Ok(Found {
                law: p.law,
                family: Family::Polynomial,
                degree: p.degree,
                coefficients: p.monomials,
                binding: Vec::new(),
                easing: Vec::new(),
                solver: report(
                    Tier::Equality,
                    "as many conditions as coefficients: one linear system",
                    0,
                    true,
                ),
                infeasible: None,
            })
        }
        Family::Harmonic => from_harmonics(scene, demand),
        Family::Program => from_program(scene),
        Family::DoubleHarmonic => from_double_harmonic(scene, demand),
    }
}

/// Brings limits that are not convex into the law, where the size is among the variables or given and the
/// law without them would break one. Returns the steps taken and why no more were.
fn beyond_convex(
    scene: &Scene,
    demand: &Demand,
    fitted: &mut spline::Fitted,
) -> Option<(Vec<Step>, &'static str)> {
    if fitted.sequence.is_some() {
        return fitted.sequence.take();
    }
    let beyond = limits::beyond_convex(scene, demand).filter(|b| b.follower.is_some())?;
    let (solution, steps, ended) = sequence::refine(&fitted.program, &fitted.solution, beyond)?;
    if steps.is_empty() && solution.x == fitted.solution.x {
        return None;
    }
    fitted.solution = solution;
    Some((steps, ended))
}

/// Active rows as a user reads them: rows of one limit within half a piece are one contact.
fn gathered(program: &qp::Program, solution: &qp::Solution, pieces: usize) -> Vec<Binding> {
    let mut out: Vec<Binding> = Vec::new();
    let mut rows: Vec<&qp::Row> = solution.active.iter().collect();
    rows.sort_by(|a, b| {
        (a.limit, a.name, a.peak.at)
            .partial_cmp(&(b.limit, b.name, b.peak.at))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let near = std::f64::consts::PI / pieces as f64;
    for row in rows {
        let limit = row.limit.map(|i| &program.limits[i]);
        let name = row.name;
        let multiplier = row.multiplier / limit.map_or(1.0, |l| l.meaning.slope(l.bound));
        match out.last_mut() {
            Some(last) if last.limit == name && (row.peak.at - last.at).abs() < near => {
                let both = last.multiplier + multiplier;
                last.at = (last.at * last.multiplier + row.peak.at * multiplier) / both;
                last.multiplier = both;
            }
            _ => out.push(Binding {
                limit: name.to_string(),
                multiplier,
                at: row.peak.at,
            }),
        }
    }
    out
}

fn from_program(scene: &Scene) -> Result<Found> {
    let segments: Vec<Segment> = scene
        .law
        .segments
        .iter()
        .map(|s| Segment {
            motion: s.motion.clone(),
            lift: s.lift,
            angle: s.angle,
        })
        .collect();
    let law =
        assembled(scene, &segments).map_err(|e| e.at(Place::Key("law.segment".to_string())))?;
    Ok(Found {
        degree: law.poly().degree(),
        coefficients: segments.iter().map(|s| s.lift).collect(),
        law,
        family: Family::Program,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: report(
            Tier::Equality,
            "the programme is given: nothing to solve",
            0,
            true,
        ),
        infeasible: None,
    })
}

/// The programme over what its cam covers: a turn, several, a length, or the half that a breadth mirrors.
fn assembled(scene: &Scene, segments: &[Segment]) -> Result<Law> {
    let cam = &scene.cam;
    let total: f64 = segments.iter().map(|s| s.angle).sum();
    let half = std::f64::consts::PI;
    if cam.is_straight() {
        return program(segments, Extent::Length(cam.travel.unwrap_or(total)));
    }
    if cam.breadth.is_some() && total < 1.5 * half {
        return constant_breadth(segments);
    }
    program(segments, Extent::Turns(cam.turns))
}

fn report(tier: Tier, status: &str, iterations: usize, certified: bool) -> SolverReport {
    SolverReport {
        tier,
        status: status.to_string(),
        iterations,
        certified,
        certificate: None,
        steps: Vec::new(),
        ended: "",
    }
}

/// The force's harmonics inverted, without a look at the limits, and what lies in the rest, N RMS: `count`
/// of them, or the fewest that leave no more than `wanted`.
fn inverted(demand: &Demand, count: Option<usize>, wanted: f64) -> Result<(Found, f64)> {
    let spectral = harmonic::invert(demand, count, wanted)?;
    let status = format!(
        "{} harmonics inverted one by one; {:.4} N RMS lie in the rest",
        spectral.count, spectral.left_over
    );
    let found = Found {
        family: Family::Harmonic,
        degree: 0,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: report(Tier::Spectral, &status, 0, true),
        law: spectral.law(),
        coefficients: spectral.x,
        infeasible: None,
    };
    Ok((found, spectral.left_over))
}

fn from_harmonics(scene: &Scene, demand: &Demand) -> Result<Found> {
    let mean = demand.target.as_ref().map_or(0.0, |t| t.mean_n().abs());
    let wanted = scene.rms.unwrap_or(0.005) * mean;
    let (mut found, _) = inverted(demand, scene.law.harmonics, wanted)?;
    let count = found.law.waves(0).len();
    // When every limit holds the spectral inverse is already the optimum (theory §1).
    let program = spline::harmonic_program(scene, demand, count, &found.law);
    if program.limits.is_empty() || !breaks_a_limit(&program, &found) {
        return Ok(found);
    }
    match program.solve() {
        Ok(solution) => {
            found.law = program.basis.law(&solution.x);
            found.binding = gathered(&program, &solution, 2 * count);
            let status = format!(
                "{count} harmonics, {} rounds of exchange; limits hold to {:.1e}",
                solution.rounds, solution.violation
            );
            let certified = solution.violation <= qp::TOLERANCE * 1.000_001;
            found.solver = report(Tier::Qp, &status, solution.iterations, certified);
            found.solver.certificate = Some(qp::certificate(&program, &solution));
            found.easing = easing::easings(&program, &solution, Minimise::ForceError);
            found.coefficients = solution.x;
        }
        Err(_) if !demand.explain => return Err(Error::key("law", "no law keeps the limits")),
        Err(failure) => {
            found.infeasible = Some(conflict::explain(&program, &failure, scene.cam.measures()))
        }
    }
    Ok(found)
}

/// Whether the spectral law breaks a limit, its lowest point standing on the base circle.
fn breaks_a_limit(program: &qp::Program, found: &Found) -> bool {
    let mut x = found.coefficients.clone();
    if program.constant_is_free() {
        x[0] -= found.law.extremes(0).0.value;
    }
    !program.broken(&x, &program.windows(&x)).is_empty()
}

fn from_double_harmonic(scene: &Scene, demand: &Demand) -> Result<Found> {
    let hump = double_harmonic::fit(demand, scene.limits.stroke)?;
    let [phase, rise, fall] = hump.angles.map(f64::to_degrees);
    let status = format!(
        "rise of {rise:.2}° from {phase:.2}°, fall of {fall:.2}°, found by {} steps of search; misses the force by {:.4} N RMS",
        hump.evaluations, hump.rms
    );
    Ok(Found {
        law: hump.law,
        family: Family::DoubleHarmonic,
        degree: 0,
        coefficients: vec![hump.lift, hump.angles[0], hump.angles[1], hump.angles[2]],
        binding: Vec::new(),
        easing: Vec::new(),
        solver: report(Tier::Equality, &status, hump.evaluations, true),
        infeasible: None,
    })
}

/// The best law without the limits: what is shown where they leave none.
fn unlimited(scene: &Scene, demand: &Demand, why: &Infeasible) -> Result<Box<spline::Fitted>> {
    let mut without = Scene {
        limits: crate::scene::Limits::default(),
        ..scene.clone()
    };
    if let Some(gait) = &mut without.gait {
        gait.band = None;
    }
    match spline::fit(&without, demand)? {
        spline::Outcome::Law(fitted) => Ok(fitted),
        _ => Err(Error::key("law", why.words.clone())),
    }
}

fn from_spline(scene: &Scene, demand: &Demand) -> Result<Found> {
    let (mut fitted, infeasible) = match spline::fit(scene, demand)? {
        spline::Outcome::Law(fitted) => (fitted, None),
        spline::Outcome::None(program, failure) => {
            if !demand.explain {
                return Err(Error::key("law", "no law keeps the limits"));
            }
            let why = conflict::explain(&program, &failure, scene.cam.measures());
            (unlimited(scene, demand, &why)?, Some(why))
        }
        spline::Outcome::Fight(_) if !demand.explain => {
            return Err(Error::key("law", "no law keeps the limits"));
        }
        spline::Outcome::Fight(why) => (unlimited(scene, demand, &why)?, Some(*why)),
    };
    let sequence = if infeasible.is_none() {
        beyond_convex(scene, demand, &mut fitted)
    } else {
        None
    };
    let solution = &fitted.solution;
    let binding = gathered(&fitted.program, &fitted.solution, fitted.spans);
    let certified = solution.violation <= qp::TOLERANCE * 1.000_001;
    let holds = format!("limits hold to {:.1e}", solution.violation);
    let mut solver = match sequence {
        Some((steps, ended)) => {
            let status = format!(
                "{} convex programs in sequence for what is not convex, ended because {ended}; {holds}",
                steps.len() + 1
            );
            SolverReport {
                steps,
                ended,
                ..report(Tier::Scp, &status, solution.iterations, certified)
            }
        }
        None if solution.used_rows => {
            let tier = if fitted.program.cone {
                Tier::Socp
            } else {
                Tier::Qp
            };
            let rounds = match solution.rounds {
                1 => "one round".to_string(),
                n => format!("{n} rounds"),
            };
            let status = format!("{rounds} of exchange; {holds}");
            report(tier, &status, solution.iterations, certified)
        }
        None => report(
            Tier::Equality,
            "no limit is broken without being asked",
            0,
            certified,
        ),
    };
    let minimised = spline::objective(scene);
    let easing = if infeasible.is_none() {
        solver.certificate = Some(qp::certificate(&fitted.program, solution));
        let mut easing = easing::easings(&fitted.program, solution, minimised);
        if scene.gait.as_ref().is_some_and(|g| !g.weights.is_empty()) {
            for e in easing.iter_mut().filter(|e| e.objective == "rms_error_n") {
                e.objective = "weighted_rms_error_n".to_string();
            }
        }
        easing
    } else {
        Vec::new()
    };
    Ok(Found {
        law: fitted.law(),
        easing,
        family: Family::Spline,
        degree: fitted.degree,
        coefficients: solution.x.clone(),
        binding,
        solver,
        infeasible,
    })
}
