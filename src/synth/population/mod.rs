//! One cam for many walkers.
//!
//! Mass M_w and speed ω_w of the machine are adjusted for each walker w with the target force F_w. The force error M_w (ω_w² a + g) − F_w
//! is therefore linear in the law. Minimising the mean of the squared errors is equivalent to the design for one mean curve. Minimising the
//! worst error, or the mean of the worst tenth, is equivalent to the design for another mean curve. The weights of this curve are computed
//! by a search ([`weights`]).
//!
//! Families, limits, certificates and checks are the same as in a design for a single walker (theory §8).

pub mod alone;
mod easing;
pub mod errors;
mod limits;
pub mod phase;
pub mod report;
pub mod weights;

use crate::cam::{Check, Criterion};
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::Extreme;
use crate::problem::{Problem, Walkers};
use crate::scene::{Family, LawSpec, Minimise, Robust};
use crate::synth::attempt::{Attempt, attempt};
use crate::synth::design::Design;
use crate::synth::families::{self, SolvedLaw};
use crate::synth::finish::{Reports, finished};
use crate::synth::phase::best as at_best_phase;
use crate::synth::qp::{Certificate, PROVED};
use crate::synth::report::limited::Easing;
use crate::synth::report::proof::Doubt;
use crate::synth::report::solver::Tier;
use crate::synth::search::Search;
use crate::synth::sizing::checked_cam::CheckedCam;
use errors::{Aim, Nodes};
use weights::Weights;

/// Maximum number of designs in the search for weights, for given phases.
const ROUNDS: usize = 80;
/// Maximum number of designs with successively tightened load limits.
const LOAD_ROUNDS: usize = 12;
const LOAD_ROOM: f64 = 1e-6;
/// Maximum number of alternating optimisations of law and phases.
const PHASE_ROUNDS: usize = 30;
const PHASE_SETTLED: f64 = 1e-7;
/// Relative tolerance of the check of the required accuracy.
const SLACK: f64 = 1e-9;

/// Design for the walkers of a problem.
///
/// # Errors
///
/// A setting of the scene does not support several walkers. The errors of a design for a single walker also apply.
pub fn designed(problem: &Problem, search: &Search, walkers: &Walkers) -> Result<Design> {
    refuse_unknown(problem, walkers)?;
    let phase = at_best_phase(&problem.of_mean(), search)?.phase;
    let problem = &problem.at_phase(phase);
    let walkers = problem.walkers.as_deref().unwrap_or(walkers);
    let mut loads = 1.0;
    for round in 0.. {
        let limited = limits::for_all(&problem.of_mean(), walkers, loads);
        let found = PopulationLaw::at_best_phases(&limited, search, walkers)?;
        let checked = limits::checked(problem, walkers, &found.attempt.law)?;
        if let Some(part) = limits::less_loaded(&checked.checks).filter(|_| round < LOAD_ROUNDS)
            && found.attempt.refusal.is_none()
        {
            loads *= part * (1.0 - LOAD_ROOM);
            continue;
        }
        return found.judged(problem, search, walkers, checked, loads);
    }
    unreachable!("the last round returns")
}

/// Whether the force errors of several walkers are part of the verdict.
pub fn is_judged(problem: &Problem) -> bool {
    problem.serves_several() && problem.accuracy.is_some()
}

/// Problem for the mean curve of the walkers with the limits of all walkers. The error of the mean curve is not checked.
pub fn of_mean(problem: &Problem) -> Problem {
    match problem.walkers.as_deref() {
        None => problem.clone(),
        Some(walkers) => limits::for_all(&problem.of_mean(), walkers, 1.0),
    }
}

/// Rejects settings that do not support several walkers.
fn refuse_unknown(problem: &Problem, walkers: &Walkers) -> Result<()> {
    let law = &problem.law;
    let families = [Family::Auto, Family::Spline, Family::Harmonic];
    let is_robust = walkers.robust != Robust::Mean;
    let unknown = [
        ("gait.band", problem.band.is_some()),
        ("gait.weight", problem.is_weighed()),
        ("law.polydyne", law.polydyne),
        ("machine.motor", problem.machine.motor().is_some()),
        ("machine.floor", problem.machine.floor().is_some()),
        ("law.family", is_robust && !families.contains(&law.family)),
        (
            "law.minimise",
            is_robust && problem.objective() != Minimise::ForceError,
        ),
    ];
    match unknown.into_iter().find(|u| u.1 && walkers.each.len() > 1) {
        Some((key @ ("machine.motor" | "machine.floor"), _)) => {
            Err(SynthError::MachineOfPopulation.at_key(key))
        }
        Some((key, _)) => Err(SynthError::NotOfPopulation.at_key(key)),
        None => Ok(()),
    }
}

/// Law for the walkers, with the errors and bounds for its certificate.
struct PopulationLaw {
    attempt: Attempt,
    squares: Vec<f64>,
    upper: f64,
    lower: f64,
    rounds: usize,
    /// Delay of each cycle relative to the phase of the design, rad.
    phases: Vec<f64>,
}

impl PopulationLaw {
    /// Law for the walkers. If the phases are adjustable, law and phases are optimised alternately.
    fn at_best_phases(
        limited: &Problem,
        search: &Search,
        walkers: &Walkers,
    ) -> Result<PopulationLaw> {
        let mut phases = vec![0.0; walkers.each.len()];
        let mut found = PopulationLaw::of_best_size(limited, search, walkers)?;
        let limited = &found.held(limited);
        let is_free = walkers.adjust.phase && walkers.each.len() > 1;
        let turns = if is_free { PHASE_ROUNDS } else { 0 };
        for _ in 0..turns {
            if found.attempt.refusal.is_some() || search.halt.is_asked() {
                break;
            }
            let force = phase::of_law(&limited.drive, &found.attempt.law.law);
            phases = walkers
                .each
                .iter()
                .map(|w| phase::best(&force, w))
                .collect();
            let mut next = PopulationLaw::of(limited, search, &walkers.at_phases(&phases))?;
            next.rounds += found.rounds;
            next.phases.clone_from(&phases);
            let gain = found.upper - next.upper;
            let is_better = gain > 0.0;
            let is_last = gain <= PHASE_SETTLED * found.upper;
            if is_better {
                found = next;
            }
            if is_last {
                break;
            }
        }
        Ok(found)
    }

    /// Law for the walkers. An automatic number of spans or harmonics is first chosen for the mean curve. If the objective is not the mean
    /// error, the number is then increased while the objective decreases sufficiently.
    fn of_best_size(
        limited: &Problem,
        search: &Search,
        walkers: &Walkers,
    ) -> Result<PopulationLaw> {
        let mut best = PopulationLaw::of(limited, search, walkers)?;
        let is_open = limited.law.spans.is_none() && limited.law.harmonics.is_none();
        if !is_open || walkers.robust == Robust::Mean {
            return Ok(best);
        }
        let mut law = best.held(limited).law.clone();
        while best.attempt.refusal.is_none() && !search.halt.is_asked() {
            let sizes = [&mut law.spans, &mut law.harmonics];
            let Some(size) = sizes.into_iter().flatten().next() else {
                break;
            };
            *size = families::larger(*size);
            let is_telling = *size >= families::TELLING;
            let next = PopulationLaw::of(&limited.with_law(law.clone()), search, walkers)?;
            let gains = next.upper.sqrt() < (1.0 - families::WORTHWHILE) * best.upper.sqrt();
            if next.attempt.refusal.is_some() || is_telling && !gains {
                break;
            }
            if gains {
                best = next;
            }
        }
        Ok(best)
    }

    /// The problem with the family of this law and its number of spans or harmonics fixed.
    fn held(&self, limited: &Problem) -> Problem {
        let law = &self.attempt.law;
        match law.family {
            Family::Spline | Family::Harmonic => held(limited, law),
            _ => limited.clone(),
        }
    }

    fn of(limited: &Problem, search: &Search, walkers: &Walkers) -> Result<PopulationLaw> {
        let shares: Vec<f64> = walkers.each.iter().map(|w| w.share).collect();
        let first = attempt(&weighed(limited, walkers, &shares), search)?;
        let nodes = Nodes::of(&first.law.law);
        let aims: Vec<Aim> = walkers.each.iter().map(|w| nodes.aim(w)).collect();
        let mut weights = Weights::new(walkers.robust, &shares, &aims);
        let mut laws = vec![first.law.clone()];
        weights.take(
            &shares,
            nodes.force(&limited.drive, &laws[0].law),
            gap(&laws[0]),
        );
        let fixed = held(limited, &laws[0]);
        let is_searched = first.refusal.is_none() && walkers.robust != Robust::Mean;
        while is_searched && !weights.is_proved() && laws.len() < ROUNDS && !search.halt.is_asked()
        {
            let combines = laws.iter().all(|law| law.solver.tier != Tier::Scp);
            let Some(next) = weights.next(combines) else {
                break;
            };
            if weights.is_proved() {
                break;
            }
            let Ok(law) = families::law(&weighed(&fixed, walkers, &next), search)? else {
                break;
            };
            weights.take(&next, nodes.force(&limited.drive, &law.law), gap(&law));
            laws.push(law);
        }
        let squares = |force: &[f64]| aims.iter().map(|aim| aim.square(force)).collect();
        Ok(PopulationLaw {
            squares: squares(&weights.force(&weights.best)),
            upper: weights.upper,
            lower: weights.lower,
            rounds: laws.len(),
            phases: vec![0.0; walkers.each.len()],
            attempt: Attempt {
                law: combined(&weights.best, laws),
                ..first
            },
        })
    }

    /// Completes the design with this law. The verdict includes the errors of all walkers.
    fn judged(
        self,
        problem: &Problem,
        search: &Search,
        walkers: &Walkers,
        checked: CheckedCam,
        loads: f64,
    ) -> Result<Design> {
        let is_tightened = loads < 1.0;
        let mut attempt = Attempt {
            refusal: self.attempt.refusal,
            ..Attempt::of(self.attempt.law, checked)
        };
        let phases: Vec<f64> = self.phases.iter().map(|p| problem.phase + p).collect();
        let mut report = report::report(walkers, &self.squares, &phases);
        report.rounds = self.rounds;
        report.gap = ((self.upper - self.lower) / self.upper.max(f64::MIN_POSITIVE)).max(0.0);
        let is_free = walkers.adjust.phase && walkers.each.len() > 1;
        report.bound_percent = is_free.then(|| 100.0 * phase::bound(walkers).max(0.0).sqrt());
        if walkers.each.len() > 1 {
            let own = |e: &Easing| easing::of_all(e, problem, walkers, self.upper, loads);
            attempt.law.easing = attempt.law.easing.iter().filter_map(own).collect();
            attempt.cam.checks.extend(accuracy(problem, self.upper));
            let solver = &mut attempt.law.solver;
            if let Some(proof) = &mut solver.certificate {
                proof.relative_gap = proof.relative_gap.max(report.gap);
                proof.global_gap = proof.global_gap.map(|gap| gap.max(report.gap));
            }
            if report.gap > PROVED || is_tightened || is_free {
                solver.certified = false;
                let why = if is_tightened || is_free {
                    Doubt::Local
                } else {
                    Doubt::Gap
                };
                solver.doubt = solver.doubt.or(Some(why));
            }
        }
        let reports = Reports {
            population: Some(report),
            ..Reports::default()
        };
        Ok(finished(problem, search, attempt, reports))
    }
}

/// Weighted sum of laws, with the certificate of the law that has the largest weight.
fn combined(parts: &[f64], laws: Vec<SolvedLaw>) -> SolvedLaw {
    let bearing: Vec<(f64, &SolvedLaw)> = parts
        .iter()
        .copied()
        .zip(&laws)
        .filter(|p| p.0 > 0.0)
        .collect();
    let main = bearing.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let mut out = main.map_or(&laws[0], |m| m.1).clone();
    if bearing.len() < 2 {
        return out;
    }
    let each = 0..out.coefficients.len();
    let sum = |i: usize| {
        bearing
            .iter()
            .map(|(part, law)| part * law.coefficients[i])
            .sum()
    };
    (out.coefficients, out.circle) = (each.map(sum).collect(), None);
    let terms: Vec<(f64, &Law)> = bearing
        .iter()
        .map(|(part, law)| (*part, &law.law))
        .collect();
    let harmonic = || {
        let pairs = out.coefficients[1..].chunks_exact(2).map(|c| (c[0], c[1]));
        Law::harmonic(out.coefficients[0], &pairs.collect::<Vec<_>>())
    };
    out.law = Law::mixed(&terms).unwrap_or_else(harmonic);
    out
}

/// Check of the required accuracy for the objective over all walkers; `None` without a required accuracy.
fn accuracy(problem: &Problem, square: f64) -> Option<Check> {
    let asked = problem.accuracy? * problem.target_mean();
    let value = square.sqrt() * problem.target_mean();
    let worst = Extreme { at: 0.0, value };
    Some(Check::of(Criterion::RmsError, worst, asked, SLACK))
}

/// The problem with the family of a law and its number of spans or harmonics fixed, so that all laws have the same basis.
fn held(problem: &Problem, law: &SolvedLaw) -> Problem {
    let mut spec = problem.law.clone();
    hold(&mut spec, law.family, &law.law, law.coefficients.len());
    problem.with_law(spec)
}

/// Fixes family and number of spans or harmonics in a law specification.
pub fn hold(spec: &mut LawSpec, family: Family, law: &Law, coefficients: usize) {
    spec.family = family;
    match family {
        // Each dwell is an additional span, which `spans` does not count.
        Family::Spline => spec.spans = Some(law.breaks().len() - 1 - spec.dwells.len()),
        _ => spec.harmonics = Some(coefficients / 2),
    }
}

/// Upper bound of the difference between half the mean square force error of a law and its minimum, N²; infinite if unknown.
fn gap(law: &SolvedLaw) -> f64 {
    let of = |c: &Certificate| {
        (c.global_gap).map_or(f64::INFINITY, |gap| c.duality_gap.max(gap * c.size))
    };
    law.solver.certificate.as_ref().map_or(0.0, of)
}

/// Problem with one target curve. Its mean square error is the weighted sum of the errors of the walkers, except for a factor and a constant.
fn weighed(problem: &Problem, walkers: &Walkers, weights: &[f64]) -> Problem {
    let Some(target) = &problem.target else {
        return problem.clone();
    };
    let samples = walkers.each[0].target.force_n.len();
    let (mut force, mut slopes) = (vec![0.0; samples], vec![0.0; samples + 1]);
    let mut whole = 0.0;
    for (walker, weight) in walkers.each.iter().zip(weights).filter(|w| *w.1 > 0.0) {
        let part = weight * walker.factor / (walker.unit * walker.unit);
        whole += part * walker.factor;
        let rest = walker.drive.rest_force;
        let own = force.iter_mut().zip(&walker.target.force_n);
        own.for_each(|(sum, f)| *sum += part * (f - rest));
        let own = slopes.iter_mut().zip(walker.target.slopes());
        own.for_each(|(sum, s)| *sum += part * s);
    }
    let rest = problem.drive.rest_force;
    force.iter_mut().for_each(|f| *f = rest + *f / whole);
    slopes.iter_mut().for_each(|s| *s /= whole);
    let curve = ForceCurve {
        population: None,
        spread_n: None,
        ..target.curve().with_forces(force)
    };
    problem.for_target(curve, slopes)
}
