//! The programme family: segments of catalogue laws, joined as written.

use super::{NoLaw, SolvedLaw, report};
use crate::error::{Placed, Result};
use crate::law::{Extent, Law, Segment, constant_breadth, program};
use crate::problem::Problem;
use crate::scene::Family;
use crate::synth::design::Tier;
use crate::synth::design::method::Method;
use crate::synth::design::parameters::Functions;
use crate::synth::search::Search;

/// The law of the problem's segments.
///
/// # Errors
/// Segments that do not cover what the cam covers.
pub fn law(problem: &Problem, _: &Search) -> std::result::Result<SolvedLaw, NoLaw> {
    let segments: Vec<Segment> = problem
        .law
        .segments
        .iter()
        .map(|s| Segment {
            motion: s.motion.clone(),
            lift: s.lift,
            angle: s.angle,
        })
        .collect();
    let law = assembled(problem, &segments).map_err(|e| e.at_key("law.segment"))?;
    let lifts = segments.iter().map(|s| s.lift).collect();
    let solver = report(Tier::Equality, Method::Programme, 0);
    Ok(SolvedLaw {
        degree: degree(&law),
        ..SolvedLaw::unlimited(law, Family::Program, (Functions::Segments, lifts), solver)
    })
}

/// Degree of the law's polynomials; harmonic segments have none.
fn degree(law: &Law) -> usize {
    let waves = (0..law.breaks().len() - 1).any(|i| !law.waves(i).is_empty());
    if waves { 0 } else { law.poly().degree() }
}

/// The programme over what its cam covers: a turn, several, a length, or the half that a breadth mirrors.
fn assembled(problem: &Problem, segments: &[Segment]) -> Result<Law> {
    let cam = &problem.cam;
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
