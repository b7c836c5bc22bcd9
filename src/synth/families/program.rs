//! Programme family: segments of catalogue laws in the order of the scene.

use super::solved::SolvedLaw;
use crate::error::{Placed, Result};
use crate::law::{Extent, Law, Segment, constant_breadth, program};
use crate::problem::Problem;
use crate::scene::Family;
use crate::synth::optimum::ForcePrice;
use crate::synth::report::method::Method;
use crate::synth::report::parameters::Functions;
use crate::synth::report::solver::{SolverReport, Tier};

/// Law that consists of the segments of a problem.
///
/// # Errors
///
/// The sum of the segment angles (or lengths) differs from the extent of the cam.
pub fn program_law(problem: &Problem) -> Result<SolvedLaw> {
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
    let is_polynomial = (0..law.breaks().len() - 1).all(|i| law.waves(i).is_empty());
    let solver = SolverReport::of(Tier::Equality, Method::Programme, 0);
    Ok(SolvedLaw {
        family: Family::Program,
        spans: 0,
        // Harmonic segments have no degree.
        degree: if is_polynomial {
            law.poly().degree()
        } else {
            0
        },
        functions: Functions::Segments,
        coefficients: segments.iter().map(|s| s.lift).collect(),
        circle: None,
        law,
        binding: Vec::new(),
        easing: Vec::new(),
        solver,
        price: ForcePrice::unlimited(problem),
    })
}

/// Law of the segments over the extent of the cam: one or several turns, a length, or the half turn of a constant-breadth cam.
fn assembled(problem: &Problem, segments: &[Segment]) -> Result<Law> {
    let cam = &problem.cam;
    let total: f64 = segments.iter().map(|s| s.angle).sum();
    let half = std::f64::consts::PI;
    if !cam.is_straight() && cam.breadth.is_some() && total < 1.5 * half {
        return constant_breadth(segments);
    }
    let extent = if cam.is_straight() {
        Extent::Length(cam.travel.unwrap_or(total))
    } else {
        Extent::Turns(cam.turns)
    };
    program(segments, extent)
}
