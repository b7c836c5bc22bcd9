//! One law on one cam for one problem, or why its limits leave none.
//!
//! For a rigid machine at constant speed and one force this is the whole design. A machine whose motion depends on the cam, a
//! compliant follower and a population attempt the problems that they derive from their own.

use std::sync::Arc;

use super::families::{self, SolvedLaw};
use super::infeasible;
use super::optimum::{NoLaw, Refusal};
use super::report::proof::Doubt;
use super::search::Search;
use super::sizing::checked_cam::{CheckedCam, checked_cam};
use crate::error::{Placed, Result};
use crate::problem::Problem;
use crate::scene::Minimise;

/// A law on its cam.
#[derive(Clone)]
pub struct Attempt {
    /// The best law under the limits, or without them where they leave none; its lowest point stands on the base circle where
    /// nothing else fixes the level.
    pub law: SolvedLaw,
    /// Its cam, with force and checks.
    pub cam: CheckedCam,
    /// Why the limits leave no law.
    pub refusal: Option<Arc<Refusal>>,
}

/// The law under the limits of a problem on the given or the smallest cam; where the limits leave none, the best law without
/// them and the refusal.
///
/// # Errors
/// Faults of the input; demands that no law meets even without limits.
pub fn attempt(problem: &Problem, search: &Search) -> Result<Attempt> {
    let refusal = match under_limits(problem, search) {
        Ok(attempt) => return Ok(attempt),
        Err(NoLaw::Fault(fault)) => return Err(fault),
        Err(NoLaw::Refused(refusal)) => refusal,
    };
    // The law first: what is shown matters more than why, and the time may end before both are found.
    match without_limits(problem, search, &refusal) {
        Ok(attempt) => Ok(Attempt {
            refusal: Some(Arc::from(refusal)),
            ..attempt
        }),
        Err(NoLaw::Fault(fault)) => Err(fault),
        Err(NoLaw::Refused(_)) => {
            let why = infeasible::explain(problem, &refusal);
            Err(why.no_law().at_key(why.key_of_demands()))
        }
    }
}

/// The law under the limits of a problem on the given or the smallest cam.
pub fn under_limits(problem: &Problem, search: &Search) -> std::result::Result<Attempt, NoLaw> {
    on_cam(problem, families::law(problem, search)?)
}

/// A law on the given or the smallest cam of a problem.
fn on_cam(problem: &Problem, law: SolvedLaw) -> std::result::Result<Attempt, NoLaw> {
    let cam = checked_cam(problem, &law.law, law.circle, None)?;
    Ok(Attempt::of(law, cam))
}

impl Attempt {
    /// A law with its cam; the law is raised as far as the cam asks.
    pub fn of(mut law: SolvedLaw, cam: CheckedCam) -> Attempt {
        law.functions.raise(&mut law.coefficients, cam.raised);
        law.law = cam.pressing().clone();
        Attempt {
            law,
            cam,
            refusal: None,
        }
    }
}

/// The best law without the accuracy where the other limits have one, without any limit, or without the base circle
/// either. Where the accuracy is a limit and the objective no force, the best is that of the least force error.
fn without_limits(
    problem: &Problem,
    search: &Search,
    refusal: &Refusal,
) -> std::result::Result<Attempt, NoLaw> {
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
    let law = families::law(&bare, &timely).or_else(|no_law| match no_law {
        NoLaw::Refused(_) => {
            bare.above_base_circle = false;
            families::law(&bare, &endless)
        }
        fault => Err(fault),
    })?;
    let mut best = on_cam(problem, law)?;
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
