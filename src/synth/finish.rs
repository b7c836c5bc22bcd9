//! Completion of a design: verdict and notes for a law with its cam, and the reports on machine and population.

use std::sync::Arc;

use super::attempt::Attempt;
use super::design::Design;
use super::families::notes_on_size;
use super::report::end::End;
use super::report::limited::Relaxation;
use super::report::reason::Reason;
use super::report::shaft::OnShaft;
use super::report::walkers::OfPopulation;
use super::search::Search;
use super::{infeasible, sizing, verdict};
use crate::cam::{Check, LimitKind, Verdict};
use crate::dynamics::FloorMotion;
use crate::problem::{Note, Problem};

/// Reports for a compliant follower, a motor, a moving floor or a population, added to a design.
#[derive(Default)]
pub struct Reports {
    pub end: Option<End>,
    pub shaft: Option<OnShaft>,
    pub floor: Option<FloorMotion>,
    pub population: Option<OfPopulation>,
    pub notes: Vec<Note>,
    pub relaxations: Vec<Relaxation>,
}

/// Completes a design. It contains the law with its cam, the verdict, infeasible limits, notes and reports.
pub fn finished(problem: &Problem, search: &Search, attempt: Attempt, reports: Reports) -> Design {
    let Attempt { law, cam, refusal } = attempt;
    let too_large = |c: &Check| c.name == LimitKind::PrimeRadius && !c.pass;
    let out_of_time = search.halt.was_heard();
    let infeasible = match refusal {
        // If the search was stopped early, infeasibility is not proved. The design then reports the stopped search instead.
        Some(refusal) if out_of_time && !refusal.is_found() => None,
        Some(refusal) => Some(infeasible::explain(problem, &refusal)),
        None if cam.checks.iter().any(too_large) => infeasible::bore_against_size(problem),
        None => None,
    };
    let (mut verdict, mut reasons) = verdict::verdict(problem, &cam.cam, &cam.checks, &cam.force);
    if let Some(infeasible) = &infeasible {
        verdict = Verdict::Unacceptable;
        reasons.retain(|r| matches!(r, Reason::MeanForce { .. }));
        reasons.extend(infeasible.reasons.iter().cloned());
    } else if out_of_time {
        verdict = Verdict::Unacceptable;
        reasons.retain(|r| *r != Reason::AllHold);
        reasons.insert(0, Reason::OutOfTime);
    }
    let mut notes = problem.notes();
    if out_of_time && infeasible.is_some() {
        notes.push(Note::OutOfTime);
    }
    // If the mean force is unattainable, no number of spans helps.
    if matches!(reasons.first(), Some(Reason::MeanForce { .. })) {
        notes.retain(|n| !matches!(n, Note::MeanForce { .. }));
    } else {
        notes.extend(notes_on_size(problem, law.family, law.spans));
    }
    notes.extend(sizing::notes(problem, &cam.cam, cam.pressing()));
    let end = reports.end.as_ref();
    notes.extend(end.map_or_else(Vec::new, |e| e.notes(problem.drive.speed)));
    notes.extend(reports.notes);
    Design {
        problem: Arc::new(problem.clone()),
        shaft: reports.shaft,
        floor: reports.floor,
        population: reports.population,
        family: law.family,
        functions: law.functions,
        coefficients: law.coefficients,
        degree: law.degree,
        cam: cam.cam,
        end: reports.end,
        conjugate: cam.conjugate,
        groove: cam.groove,
        force: cam.force,
        infeasible,
        relaxations: reports.relaxations,
        together: Vec::new(),
        verdict,
        reasons,
        checks: cam.checks,
        binding: law.binding,
        easing: law.easing,
        solver: law.solver,
        out_of_time,
        notes,
    }
}
