//! The double-harmonic family: one rise, one fall and a rest (Campillo de Blas 2017), placed for the force.
//!
//! For given angles of rise and fall and a given start the law is h·shape(θ), and the best lift h is the
//! solution of one linear equation. Only the three angles are searched, by Nelder–Mead from several fixed
//! starts, so that the same scene always gives the same law.

use std::f64::consts::{PI, TAU};

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;
use argmin_math::{ArgminAdd, ArgminMul, ArgminSub};

use super::harmonic::no_force;
use super::solved::SolvedLaw;
use crate::drive::Drive;
use crate::error::{NoDesignError, Placed, Result, SynthError};
use crate::law::{Extent, Law, Rise, Segment, assemble};
use crate::poly::gauss_legendre;
use crate::problem::Problem;
use crate::scene::{Family, LimitKind};
use crate::synth::report::method::Method;
use crate::synth::report::parameters::Functions;
use crate::synth::report::proof::Doubt;
use crate::synth::report::solver::{SolverReport, Tier};
use crate::units::Quantity;

/// Rise and fall last at least this long, rad: shorter ones are blows.
const SHORTEST: f64 = 0.2;
/// Iterations of each search.
const ITERATIONS: u64 = 150;
/// Nodes at which the force is compared.
const NODES: usize = 256;

/// The problem's double harmonic with how it was found, its lift no larger than the stroke allowed.
///
/// # Errors
/// Where the search finds no lift that changes the force.
pub fn double_harmonic_law(problem: &Problem) -> Result<SolvedLaw> {
    let target = problem.target.as_ref().ok_or_else(no_force)?;
    let rest = problem.drive.rest_force;
    let nodes: Vec<(f64, f64, f64)> = gauss_legendre(NODES)
        .into_iter()
        .map(|(u, w)| (TAU * u, w, target.cells().at(TAU * u) - rest))
        .collect();
    let search = Search {
        drive: &problem.drive,
        nodes: &nodes,
        stroke: problem.limits[LimitKind::Stroke],
    };
    let (square, angles, steps) = search.best()?;
    let shape = shape(angles)?;
    let lift = search.lift(&shape);
    if lift == 0.0 {
        return Err(SynthError::DoubleHarmonicUseless.at_key("law.family"));
    }
    let mut law = shape.scaled(lift);
    if problem.drive.spring_rate == 0.0 {
        law = law.raised(-law.extremes(0).0.value);
    }
    let [from, rise, fall] = angles.map(Quantity::angle);
    let method = Method::Search {
        rise,
        from,
        fall,
        steps,
        error: Quantity::force(square.sqrt()),
    };
    let [start, rise, fall] = angles;
    Ok(SolvedLaw {
        law,
        family: Family::DoubleHarmonic,
        degree: 0,
        spans: 0,
        functions: Functions::DoubleHarmonic,
        coefficients: vec![lift, start, rise, fall],
        circle: None,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: SolverReport {
            certified: false,
            doubt: Some(Doubt::Local),
            ..SolverReport::of(Tier::Equality, method, steps)
        },
    })
}

/// Phase, rise and fall, rad, with the arithmetic that Nelder and Mead's method asks for.
#[derive(Clone, Copy)]
struct Angles([f64; 3]);

impl ArgminAdd<Angles, Angles> for Angles {
    fn add(&self, other: &Angles) -> Angles {
        Angles([0, 1, 2].map(|i| self.0[i] + other.0[i]))
    }
}

impl ArgminSub<Angles, Angles> for Angles {
    fn sub(&self, other: &Angles) -> Angles {
        Angles([0, 1, 2].map(|i| self.0[i] - other.0[i]))
    }
}

impl ArgminMul<f64, Angles> for Angles {
    fn mul(&self, factor: &f64) -> Angles {
        Angles(self.0.map(|x| x * factor))
    }
}

#[derive(Clone, Copy)]
struct Search<'a> {
    drive: &'a Drive,
    nodes: &'a [(f64, f64, f64)],
    stroke: Option<f64>,
}

impl Search<'_> {
    /// Mean square distance of the force, N², of the best hump; its start, rise and fall, rad; evaluations.
    fn best(self) -> Result<(f64, [f64; 3], usize)> {
        let failed = |e: argmin::core::Error| SynthError::SearchFailed {
            fault: e.to_string(),
        };
        let mut best: Option<(f64, [f64; 3])> = None;
        let mut evaluations = 0;
        // Starts: four phases, a short and a long hump.
        for start in 0..4 {
            for angle in [0.75 * PI, 0.95 * PI] {
                let phase = start as f64 * 0.5 * PI;
                let simplex = [
                    [phase, angle, angle],
                    [phase + 0.4, angle, angle],
                    [phase, angle - 0.4, angle],
                    [phase, angle, angle - 0.4],
                ];
                let solver = NelderMead::new(simplex.map(Angles).to_vec());
                let solver = solver.with_sd_tolerance(1e-12).map_err(failed)?;
                let search = Executor::new(self, solver);
                let search = search.configure(|state| state.max_iters(ITERATIONS));
                let done = search.run().map_err(failed)?;
                evaluations += done.state().get_iter() as usize;
                let cost = done.state().get_best_cost();
                if let Some(p) = done.state().get_best_param()
                    && best.is_none_or(|b| cost < b.0)
                {
                    best = Some((cost, p.0));
                }
            }
        }
        let (cost, raw) = best.ok_or(NoDesignError::NoDoubleHarmonic)?;
        Ok((cost, admissible(raw), evaluations))
    }

    /// The lift that brings h·(force of the unit shape) nearest to the target.
    fn lift(&self, shape: &Law) -> f64 {
        let (mut product, mut square) = (0.0, 0.0);
        for (f, w, wanted) in self.forces(shape) {
            product += w * f * wanted;
            square += w * f * f;
        }
        let lift = if square > 0.0 { product / square } else { 0.0 };
        self.stroke.map_or(lift, |most| lift.clamp(-most, most))
    }

    fn forces<'s>(&'s self, shape: &'s Law) -> impl Iterator<Item = (f64, f64, f64)> + 's {
        let w = self.drive.weights();
        self.nodes.iter().map(move |&(theta, weight, wanted)| {
            let at = shape.svaj(theta);
            (w[0] * at.s + w[1] * at.v + w[2] * at.a, weight, wanted)
        })
    }
}

impl CostFunction for Search<'_> {
    type Param = Angles;
    type Output = f64;

    /// Mean square distance of the force at the best lift.
    fn cost(&self, p: &Self::Param) -> std::result::Result<f64, argmin::core::Error> {
        let shape = shape(admissible(p.0))?;
        let lift = self.lift(&shape);
        Ok(self
            .forces(&shape)
            .map(|(f, w, wanted)| w * (lift * f - wanted).powi(2))
            .sum())
    }
}

/// Angles brought into range: rise and fall no shorter than allowed and together no longer than a turn.
fn admissible([phase, rise, fall]: [f64; 3]) -> [f64; 3] {
    let (mut rise, mut fall) = (rise.max(SHORTEST), fall.max(SHORTEST));
    let both = rise + fall;
    if both > TAU {
        let scale = TAU / both;
        rise = (rise * scale).max(SHORTEST);
        fall = TAU - rise;
    }
    [phase.rem_euclid(TAU), rise, fall]
}

/// Unit rise, fall and rest, the rise starting at the phase.
fn shape([phase, rise, fall]: [f64; 3]) -> Result<Law> {
    let segment = |motion: Rise, lift: f64, angle: f64| Segment {
        motion,
        lift,
        angle,
    };
    let mut segments = vec![
        segment(Rise::DoubleHarmonic, 1.0, rise),
        segment(Rise::DoubleHarmonic, -1.0, fall),
    ];
    let rest = TAU - rise - fall;
    if rest > 1e-9 {
        segments.push(segment(Rise::Dwell, 0.0, rest));
    }
    Ok(assemble(&segments, Extent::TURN)?.ahead(-phase))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::force::ForceCurve;
    use crate::scene::built_in;

    #[test]
    fn a_force_made_by_a_double_harmonic_is_found_again() {
        // Rise 120° from 50°, fall 150°, lift 12 mm, on the machine of the footbridge: the search must come back to it.
        let angles = [50.0, 120.0, 150.0].map(f64::to_radians);
        let truth = shape(angles).unwrap().scaled(0.012);
        let scene = built_in("footbridge").unwrap().scene().unwrap();
        let scene = scene.with("law.family", "double-harmonic").unwrap();
        let force = scene.model_force().unwrap();
        let drive = Problem::resolve(&scene, force.as_ref()).unwrap().drive;
        let samples = (0..512)
            .map(|i| drive.force(truth.svaj(TAU * f64::from(i) / 512.0)))
            .collect();
        let period = TAU / drive.speed;
        let curve = ForceCurve::from_samples("double harmonic", period, samples).unwrap();
        let problem = Problem::resolve(&scene, Some(&curve)).unwrap();
        let solved = double_harmonic_law(&problem).unwrap();
        let [lift, found @ ..] = &solved.coefficients[..] else {
            panic!("{:?}", solved.coefficients);
        };
        assert!((lift - 0.012).abs() < 2e-4, "{lift}");
        for (found, angle) in found.iter().zip(angles) {
            assert!(
                (found - angle).abs() < 1.5_f64.to_radians(),
                "{found} {angle}"
            );
        }
    }
}
