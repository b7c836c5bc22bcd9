//! The spline family: least squares in force space under demands and limits.

use super::spline_program::{limited, unlimited};
use super::spline_spans::Forecast;
use super::touching::{self, Optimum};
use super::{NoLaw, Refusal, SolvedLaw, report, solved};
use crate::drive::Drive;
use crate::law::Law;
use crate::problem::{Note, Problem, Size};
use crate::scene::{Family, Minimise};
use crate::synth::design::method::{Ended, Method};
use crate::synth::design::proof::{Doubt, PROVED};
use crate::synth::design::{SolverReport, Step, Tier};
use crate::synth::limits::{ENLARGED, NonconvexLimits};
use crate::synth::qp::{
    Certificate, Failure, OFFSET, Program, Quadratic, RADIUS, RISE, Solution, Stop,
};
use crate::synth::search::Search;
use crate::synth::{limits, qp, scp, sizing};
use crate::units::Quantity;

/// Spans tried before "auto" gives up.
const MOST_AUTO_SPANS: usize = 400;
/// Spans for laws that follow no force.
const SPANS_WITHOUT_FORCE: usize = 48;
/// Spans tried first inside a band.
const FEWEST_IN_BAND: usize = 8;
/// … and last.
const MOST_IN_BAND: usize = 120;
/// A limit that is broken may want more spans; they grow by this factor while the error still falls.
const GROWTH: f64 = 1.5;
/// … by at least this part.
const WORTHWHILE: f64 = 0.02;
/// Below this number of spans the error is not monotone in it where limits are active, and there may be no law at all.
const TELLING: usize = 12;

/// Tangents of the limit on residual vibration, per dwell; five are usual.
const MOST_TANGENTS: usize = 40;

/// Relative rounding of a lower bound of the force error.
const BOUND_ROUNDING: f64 = 1e-6;

/// What the search for the number of spans depends on beside force and demands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanKey {
    /// Force error asked for, N RMS.
    wanted: f64,
    /// Phase of the force cycle at cam angle 0, rad.
    phase: f64,
    /// The machine.
    drive: Drive,
    /// Degree of the splines.
    degree: usize,
}

/// A law of the family, as solved.
struct Fitted {
    /// The optimum of what is convex, or what the sequence made of it.
    optimum: Optimum,
    /// Half the mean square of the force error.
    force: Quadratic,
    /// Lower bound of the objective from the convex limits, where a sequence followed.
    least: f64,
    /// … proved for every touching angle.
    least_is_proved: bool,
    /// The sequence of convex programs, where one was needed, and why it ended.
    sequence: Option<(Vec<Step>, Ended)>,
    /// Limits that are not convex and that no law was found to keep.
    left_out: bool,
    spans: usize,
}

/// The problem's spline with how it was found.
pub fn law(problem: &Problem, search: &Search) -> Result<SolvedLaw, NoLaw> {
    let mut fitted = fit(problem, search)?;
    with_profile(problem, &mut fitted);
    let evidence = evidence(&fitted);
    let report = solver_report(&mut fitted);
    let law = solved(
        problem,
        &fitted.optimum,
        problem.objective(),
        fitted.spans,
        report,
        evidence,
    );
    Ok(SolvedLaw {
        degree: problem.degree(),
        ..law
    })
}

/// How near to the optimum the law is, and what is in doubt of that.
fn evidence(fitted: &Fitted) -> (Certificate, Option<Doubt>) {
    let Optimum {
        program, solution, ..
    } = &fitted.optimum;
    if fitted.sequence.is_none() {
        let (certificate, doubt) = fitted.optimum.evidence();
        return (
            certificate,
            doubt.or(fitted.left_out.then_some(Doubt::LeftOut)),
        );
    }
    let mut evidence = qp::certificate(program, solution);
    evidence.bounded_by(program.merit(solution) - fitted.least);
    // Where the limits that are not convex cost nothing, no law that keeps the others is better.
    let global = fitted.least_is_proved && evidence.global_gap <= PROVED;
    (evidence, (!global).then_some(Doubt::Local))
}

/// The fit with the problem's own number of spans, or with the fewest that reach the accuracy.
fn fit(problem: &Problem, search: &Search) -> Result<Fitted, NoLaw> {
    if let Some(spans) = problem.law.spans {
        return solve(problem, search, spans);
    }
    if problem.band.is_some() {
        return fewest_in_band(problem, search);
    }
    let of_force = [Minimise::ForceError, Minimise::PeakForceError];
    if problem.target.is_none() || !of_force.contains(&problem.objective()) {
        return solve(problem, search, SPANS_WITHOUT_FORCE);
    }
    let wanted = problem.wanted_error();
    let key = SpanKey {
        wanted,
        phase: problem.phase,
        drive: problem.drive,
        degree: problem.degree(),
    };
    let fewest = |_: &SpanKey| fewest_without_limits(problem, search, wanted);
    let spans = search.cache.spans.try_get(key, fewest)?;
    while_worthwhile(problem, search, spans, wanted)
}

/// Fewest spans that reach an accuracy without limits: the cheaper lower bound, because spans that miss it
/// without limits miss it with them.
fn fewest_without_limits(
    problem: &Problem,
    search: &Search,
    wanted: f64,
) -> crate::error::Result<usize> {
    let forecast = Forecast::of(problem);
    let mut spans = 3;
    while spans < MOST_AUTO_SPANS {
        if forecast.as_ref().is_some_and(|f| f.misses(spans, wanted)) {
            spans += 1 + spans / 40;
            continue;
        }
        let (program, force) = unlimited(problem, search, spans)?;
        match qp::solve_equalities(&program) {
            Ok(u) if rms(&force, &u.x) <= wanted => break,
            _ => spans += 1 + spans / 40,
        }
    }
    Ok(spans)
}

/// Limits that bind may want more spans: more are tried while the error falls for them.
fn while_worthwhile(
    problem: &Problem,
    search: &Search,
    mut spans: usize,
    wanted: f64,
) -> Result<Fitted, NoLaw> {
    let mut best: Option<(f64, Fitted)> = None;
    loop {
        let fitted = match (solve(problem, search, spans), best.take()) {
            (Err(NoLaw::Refused(_)), Some((_, earlier))) => return Ok(earlier),
            (Err(NoLaw::Refused(_)), None) if spans < TELLING && !search.halt.is_asked() => {
                spans = (2 * spans).max(TELLING);
                continue;
            }
            (outcome, earlier) => {
                best = earlier;
                outcome?
            }
        };
        let error = rms(&fitted.force, &fitted.optimum.solution.x);
        let reached = error <= wanted;
        let hopeless = spans >= TELLING
            && (best.as_ref()).is_some_and(|(e, _)| error > e * (1.0 - WORTHWHILE));
        let better = match best {
            Some(earlier) if earlier.0 <= error => earlier,
            _ => (error, fitted),
        };
        if reached || hopeless || spans >= MOST_AUTO_SPANS || search.halt.is_asked() {
            return Ok(better.1);
        }
        best = Some(better);
        spans = ((spans as f64 * GROWTH) as usize).min(MOST_AUTO_SPANS);
    }
}

/// Inside a band the fewest spans that have a law there; with none, the answer of the most.
fn fewest_in_band(problem: &Problem, search: &Search) -> Result<Fitted, NoLaw> {
    let mut spans = FEWEST_IN_BAND;
    loop {
        match solve(problem, search, spans) {
            Err(NoLaw::Refused(_)) if spans < MOST_IN_BAND && !search.halt.is_asked() => {
                spans = ((spans as f64 * GROWTH) as usize).min(MOST_IN_BAND);
            }
            outcome => return outcome,
        }
    }
}

/// Solves the convex program; adds the limits on the loads by SCP where its solution violates them.
fn solve(problem: &Problem, search: &Search, spans: usize) -> Result<Fitted, NoLaw> {
    let (program, force) = limited(problem, search, spans)?;
    let optimum = touching::solve(problem, program)?;
    if search.only_passing && misses_accuracy(problem, &optimum) {
        return Err(Refusal::of(optimum.program, Failure::Infeasible).into());
    }
    let mut fitted = Fitted {
        optimum,
        force,
        least: f64::NEG_INFINITY,
        least_is_proved: false,
        sequence: None,
        left_out: false,
        spans,
    };
    without_vibration(problem, &mut fitted);
    match with_loads(problem, &mut fitted) {
        None => Ok(fitted),
        Some(limits) => {
            let failure = if search.halt.is_asked() {
                Stop::OutOfTime.into()
            } else {
                Failure::Infeasible
            };
            let refusal = Refusal {
                nonconvex: Some(limits),
                ..*Refusal::of(fitted.optimum.program, failure)
            };
            Err(NoLaw::Refused(Box::new(refusal)))
        }
    }
}

/// Whether the multipliers prove that no law which keeps the convex limits reaches the accuracy (theory §8): then a
/// sequence of convex programs is of no use. With an open number of spans more of them may reach it.
fn misses_accuracy(problem: &Problem, optimum: &Optimum) -> bool {
    let is_objective = problem.law.spans.is_some()
        && problem.objective() == Minimise::ForceError
        && !problem.is_weighed();
    let allowed = problem.allowed_error().filter(|_| is_objective);
    allowed
        .is_some_and(|most| (2.0 * optimum.least()).max(0.0).sqrt() > (1.0 + BOUND_ROUNDING) * most)
}

/// Tangents of the limit on residual vibration, one after the other, until the law keeps it.
fn without_vibration(problem: &Problem, fitted: &mut Fitted) {
    let Some(vibrations) = limits::Vibrations::of(problem, &fitted.optimum.program.basis) else {
        return;
    };
    for _ in 0..MOST_TANGENTS {
        let tangents = vibrations.tangents(&fitted.optimum.solution.x);
        if tangents.is_empty() {
            return;
        }
        let mut program = fitted.optimum.program.clone();
        program.fixed.extend(tangents);
        // Without a solution the check reports the residual vibration.
        let Ok(quieter) = touching::solve(problem, program) else {
            return;
        };
        fitted.optimum = quieter;
    }
}

/// Where the law breaks a limit on the loads, the sequence that keeps them; the limits where there is none.
fn with_loads(problem: &Problem, fitted: &mut Fitted) -> Option<NonconvexLimits> {
    let limits = NonconvexLimits::of(problem)?;
    limits.loads?;
    let (program, solution) = at_level(problem, fitted, &limits);
    let here = scp::AtSize::new(limits, &program).of(&solution);
    if limits::loaded(&Law::of(&program.basis, &solution.x), &here) >= 0.0 {
        return None;
    }
    (!in_sequence(problem, fitted, limits)).then_some(limits)
}

/// Goes on with the sequence that keeps limits that are not convex; false where that has no start.
fn in_sequence(problem: &Problem, fitted: &mut Fitted, limits: NonconvexLimits) -> bool {
    let (program, solution) = at_level(problem, fitted, &limits);
    let mut starts = Vec::new();
    // At the least radius of an arm the linearisation is singular.
    if problem.reach_of_arm().is_none() || problem.size() != Size::Sought {
        starts.push(solution.clone());
    }
    starts.extend(at_own_size(problem, &program, &solution));
    let Some((refined, steps, ended)) = scp::refine(&program, &starts, limits) else {
        return false;
    };
    // The convex optimum itself, at a size of the same cost.
    let as_it_was = steps.is_empty() && refined.x == solution.x;
    if as_it_was && program.merit(&refined) <= program.merit(&solution) {
        return true;
    }
    fitted.least = fitted.optimum.least();
    fitted.least_is_proved = fitted.optimum.evidence().1.is_none();
    fitted.optimum = Optimum::known(program, refined);
    fitted.sequence = Some((steps, ended));
    true
}

/// The law as the sequence counts its lift: on its base circle, where the limits see the level.
fn at_level(problem: &Problem, fitted: &Fitted, limits: &NonconvexLimits) -> (Program, Solution) {
    let optimum = &fitted.optimum;
    if limits.profile.is_none() && problem.drive.weights()[0] == 0.0 {
        return (optimum.program.clone(), optimum.solution.clone());
    }
    optimum.pinned(problem)
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

/// Adds the nonconvex limits of the profile by SCP.
fn with_profile(problem: &Problem, fitted: &mut Fitted) {
    if fitted.sequence.is_some() {
        return;
    }
    if let Some(limits) = NonconvexLimits::of(problem).filter(|l| l.profile.is_some()) {
        fitted.left_out = !in_sequence(problem, fitted, limits);
    }
}

/// Which tier answered, and how.
fn solver_report(fitted: &mut Fitted) -> SolverReport {
    let sequence = fitted.sequence.take();
    let solution = &fitted.optimum.solution;
    let violation = solution.violation;
    if let Some((steps, ended)) = sequence {
        let method = Method::Sequence {
            programs: steps.len() + 1,
            ended,
            violation,
        };
        return SolverReport {
            steps,
            ..report(Tier::Scp, method, solution.iterations)
        };
    }
    if !solution.used_rows {
        return report(Tier::Equality, Method::NoLimitActive, 0);
    }
    let tier = if fitted.optimum.program.cone {
        Tier::Socp
    } else {
        Tier::Qp
    };
    let method = Method::Exchange {
        rounds: solution.rounds,
        violation,
    };
    report(tier, method, solution.iterations)
}

/// Where the spread, not the accuracy, ended the choice of spans (or harmonics, on the ladder).
pub fn stopped_at_noise(problem: &Problem, family: Family) -> Option<Note> {
    let auto = match problem.law.family {
        Family::Spline => problem.law.spans.is_none(),
        asked => asked == Family::Ladder,
    };
    let size = if family == Family::Spline {
        "spans"
    } else {
        "harmonics"
    };
    let noise = problem
        .error_at_noise()
        .filter(|_| auto && problem.objective() == Minimise::ForceError)?;
    Some(Note::Noise {
        size,
        error: Quantity::force(noise),
    })
}

fn rms(force: &Quadratic, x: &[f64]) -> f64 {
    (2.0 * force.value(x)).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::LimitKind;
    use crate::scene::built_in;

    /// A stroke of 20 mm leaves an error above the usual accuracy, which a search for passing designs sees from the
    /// lower bound; with room for the stroke it has a law.
    #[test]
    fn a_search_for_passing_designs_refuses_an_accuracy_that_no_law_reaches() {
        let scene = built_in("footbridge").unwrap().scene().unwrap();
        let with = [
            ("law.family", "spline"),
            ("law.spans", "24"),
            ("limits.stroke", "20 mm"),
        ];
        let scene = (with.iter()).fold(scene, |s, (key, value)| s.with(key, value).unwrap());
        let force = scene.model_force().unwrap();
        let problem = Problem::resolve(&scene, force.as_ref()).unwrap();
        let search = Search::default();
        assert!(law(&problem, &search).is_ok());
        let search = search.for_passing_designs();
        assert!(law(&problem, &search).is_err());
        let wide = problem.with(LimitKind::Stroke.into(), 1.0);
        assert!(law(&wide, &search).is_ok());
    }
}
