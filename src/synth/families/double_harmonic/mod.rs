//! Double-harmonic family: one rise, one fall and a dwell (Campillo de Blas 2017), with the best approximation of the force.
//!
//! For given angles the force is linear in the lift of the rise and in the level of the dwell. These two values follow from two linear
//! equations, so the search varies only the start and the angles of rise and fall. The search uses a grid over the whole turn, then the
//! Nelder–Mead method from the best grid points. The last digits of a sine differ between platforms. The number of steps is therefore fixed and
//! the resulting angles are rounded, so that a scene gives the same law on every platform.

mod projection;

use std::f64::consts::TAU;

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;
use argmin_math::{ArgminAdd, ArgminMul, ArgminSub};

use super::harmonic::no_force;
use super::solved::SolvedLaw;
use crate::error::{NoDesignError, Placed, Result, SynthError};
use crate::law::{Extent, Law, Rise, Segment, assemble};
use crate::problem::Problem;
use crate::scene::{Family, LimitKind};
use crate::synth::optimum::ForcePrice;
use crate::synth::report::method::Method;
use crate::synth::report::parameters::Functions;
use crate::synth::report::proof::Doubt;
use crate::synth::report::solver::{SolverReport, Tier};
use crate::units::Quantity;
use projection::Projection;

/// Minimum angle of rise and fall, rad. A smaller angle would cause an impact.
const SHORTEST: f64 = 0.2;
/// Number of grid points from which a Nelder–Mead search starts.
const STARTS: usize = 6;
/// Number of iterations of each first search. They are sufficient to compare the candidates.
const ROUGH: u64 = 25;
/// Number of candidates for which the search is continued. Two are needed, because the search finds a law without a dwell in two forms:
/// beginning with the rise, or with the fall.
const FINALISTS: usize = 2;
/// Number of iterations of each continued search.
const ITERATIONS: u64 = 60;
/// Number of parts of a turn to which the angles are rounded. One part is 6 µrad. This is more than the rounding errors of the search and less
/// than the accuracy of manufacturing.
const PARTS: f64 = 1_048_576.0;
/// Relative difference of mean square errors below which two laws are equal. The law that begins with its rise is then preferred to the law
/// that begins with its fall. Without a dwell, these two laws are identical.
const TIE: f64 = 1e-9;
/// Size of the simplex at the start of a search, rad. It is about one step of the grid.
const SIMPLEX: f64 = 0.065;
/// Size of the simplex at the start of a continued search, rad.
const FINE_SIMPLEX: f64 = 0.01;
/// Total number of iterations of all first and continued searches.
const STEPS: usize = STARTS * ROUGH as usize + FINALISTS * ITERATIONS as usize;

/// Double-harmonic law of a problem, with a report on the search. The stroke of the law is within its limit.
///
/// # Errors
///
/// No double harmonic is better than a constant force, or the search fails.
pub fn double_harmonic_law(problem: &Problem) -> Result<SolvedLaw> {
    let target = problem.target.as_ref().ok_or_else(no_force)?;
    let stroke = problem.limits[LimitKind::Stroke];
    let force = Projection::new(target.cells(), &problem.drive, stroke);
    let angles = best(&force)?;
    let nearest = force.nearest(angles);
    if nearest.lift == 0.0 {
        return Err(SynthError::DoubleHarmonicUseless.at_key("law.family"));
    }
    let [start, rise, fall] = angles;
    let mut law = shape(angles)?.scaled(nearest.lift).raised(nearest.level);
    let mut level = nearest.level;
    if problem.drive.spring_rate == 0.0 {
        level = -law.extremes(0).0.value;
        law = law.raised(level);
    }
    let method = Method::Search {
        rise: Quantity::angle(rise),
        from: Quantity::angle(start),
        fall: Quantity::angle(fall),
        steps: STEPS,
        error: Quantity::force(nearest.square.sqrt()),
    };
    Ok(SolvedLaw {
        law,
        family: Family::DoubleHarmonic,
        degree: 0,
        spans: 0,
        functions: Functions::DoubleHarmonic,
        coefficients: vec![level, nearest.lift, start, rise, fall],
        circle: None,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: SolverReport {
            certified: false,
            doubt: Some(Doubt::Local),
            ..SolverReport::of(Tier::Equality, method, STEPS)
        },
        price: ForcePrice::unlimited(problem),
    })
}

/// Start of the rise, angle of the rise and angle of the fall, rad, with the arithmetic operations that the Nelder–Mead method requires.
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

impl CostFunction for &Projection {
    type Param = Angles;
    type Output = f64;

    /// Mean square force error, N², at the best lift and level for these angles.
    fn cost(&self, p: &Self::Param) -> std::result::Result<f64, argmin::core::Error> {
        Ok(self.nearest(admissible(p.0)).square)
    }
}

/// Start of the rise and angles of rise and fall of the best approximation, rad.
fn best(force: &Projection) -> Result<[f64; 3]> {
    let mut found = Vec::new();
    for start in force.starts(SHORTEST, STARTS) {
        found.extend(searched(force, start, SIMPLEX, ROUGH)?);
    }
    let cost = |angles: &[f64; 3]| force.nearest(admissible(*angles)).square;
    found.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let mut best: Option<(f64, [f64; 3])> = None;
    for start in found.into_iter().take(FINALISTS) {
        let Some(angles) = searched(force, start, FINE_SIMPLEX, ITERATIONS)? else {
            continue;
        };
        let angles = rounded(angles);
        let nearest = force.nearest(angles);
        let handicap = if nearest.lift < 0.0 { 1.0 + TIE } else { 1.0 };
        let cost = nearest.square * handicap;
        if best.is_none_or(|b| cost < b.0) {
            best = Some((cost, angles));
        }
    }
    let (_, angles) = best.ok_or(NoDesignError::NoDoubleHarmonic)?;
    Ok(angles)
}

/// Best angles of a search that begins at `start`, rad; `None` if the search evaluates no angles.
fn searched(
    force: &Projection,
    start: [f64; 3],
    size: f64,
    iterations: u64,
) -> Result<Option<[f64; 3]>> {
    let failed = |e: argmin::core::Error| SynthError::SearchFailed {
        fault: e.to_string(),
    };
    let mut simplex = vec![Angles(start); 4];
    for (i, corner) in simplex[1..].iter_mut().enumerate() {
        corner.0[i] += size;
    }
    let solver = NelderMead::new(simplex);
    let solver = solver.with_sd_tolerance(0.0).map_err(failed)?;
    let search = Executor::new(force, solver);
    let search = search.configure(|state| state.max_iters(iterations));
    let done = search.run().map_err(failed)?;
    Ok(done.state().get_best_param().map(|p| p.0))
}

/// Rounds angles to whole parts of a turn, within the permitted range.
fn rounded(angles: [f64; 3]) -> [f64; 3] {
    let part = |angle: f64| (angle / TAU * PARTS).round() / PARTS * TAU;
    admissible(admissible(angles).map(part))
}

/// Clamps angles, rad, to the permitted range: minimum rise and fall, and a sum of at most one turn.
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

/// Law with a unit rise, a fall and a dwell. The rise begins at the first of the angles, rad.
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
    use crate::drive::Drive;
    use crate::force::{Feet, ForceCurve, model};
    use crate::scene::built_in;

    /// Problem for one of two machines. On the footbridge the force depends on the acceleration, and in the heel tester on the lift.
    fn problem(machine: &str, force: impl Fn(&Drive, f64) -> f64) -> Problem {
        let scene = built_in(machine).unwrap().scene().unwrap();
        let scene = scene.with("law.family", "double-harmonic").unwrap();
        let scene = scene.with("accuracy.rms", "100 %").unwrap();
        let given = scene.model_force().unwrap();
        let given =
            given.unwrap_or_else(|| ForceCurve::from_samples("one", 0.5, vec![1.0; 64]).unwrap());
        let drive = Problem::resolve(&scene, Some(&given)).unwrap().drive;
        let samples = (0..512)
            .map(|i| force(&drive, TAU * f64::from(i) / 512.0))
            .collect();
        let curve = ForceCurve::from_samples("made", TAU / drive.speed, samples).unwrap();
        Problem::resolve(&scene, Some(&curve)).unwrap()
    }

    #[test]
    fn a_force_made_by_a_double_harmonic_is_found_again() {
        // Rise 120° from 50°, fall 150°, lift 12 mm: the search must come back to it.
        let angles = [50.0, 120.0, 150.0].map(f64::to_radians);
        let truth = shape(angles).unwrap().scaled(0.012);
        let problem = problem("footbridge", |drive, theta| drive.force(truth.svaj(theta)));
        let solved = double_harmonic_law(&problem).unwrap();
        let [_, lift, found @ ..] = &solved.coefficients[..] else {
            panic!("{:?}", solved.coefficients);
        };
        assert!((lift - 0.012).abs() < 1e-4, "{lift}");
        for (found, angle) in found.iter().zip(angles) {
            assert!(
                (found - angle).abs() < 0.5_f64.to_radians(),
                "{found} {angle}"
            );
        }
    }

    #[test]
    fn the_last_digits_of_a_force_do_not_change_the_angles() {
        // The best law for the default force has no rest, so that its rise and its fall can change places.
        let young = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
        let solved = |noise: f64| {
            let noisy = |theta: f64| young.at(theta) * (1.0 + noise * (1e4 * theta).sin());
            double_harmonic_law(&problem("footbridge", |_, theta| noisy(theta))).unwrap()
        };
        let one = solved(0.0);
        assert_eq!(one.coefficients[2..], [0.75 * TAU, 0.5 * TAU, 0.5 * TAU]);
        for noise in [1e-15, -2e-15, 4e-15, 1e-14] {
            let other = solved(noise);
            assert_eq!(other.coefficients[2..], one.coefficients[2..]);
            let lift = other.coefficients[1] / one.coefficients[1];
            assert!((lift - 1.0).abs() < 1e-12, "{lift}");
        }
    }

    /// Mean square difference between the force of a law and given forces at equally spaced angles. Without a spring, the lift follows from the
    /// normal equation. With a spring, the best of many levels is used, with the law above its base circle.
    fn distance(problem: &Problem, wanted: &[f64], shape: &Law, ahead: usize) -> f64 {
        let w = problem.drive.weights();
        let n = wanted.len();
        let own: Vec<f64> = (0..n)
            .map(|i| {
                let at = shape.svaj(TAU * ((i + n - ahead) % n) as f64 / n as f64);
                w[0] * at.s + w[1] * at.v + w[2] * at.a
            })
            .collect();
        let square: f64 = own.iter().map(|f| f * f).sum();
        let at = |level: f64| {
            let left: Vec<f64> = wanted.iter().map(|t| t - w[0] * level).collect();
            let product: f64 = own.iter().zip(&left).map(|(f, t)| f * t).sum();
            // Without a spring the lowest point is moved to the base circle later.
            let least = if w[0] == 0.0 {
                f64::NEG_INFINITY
            } else {
                -level
            };
            let lift = (product / square).max(least);
            let apart = own.iter().zip(&left).map(|(f, t)| (lift * f - t).powi(2));
            apart.sum::<f64>() / n as f64
        };
        if w[0] == 0.0 {
            return at(0.0);
        }
        let most = wanted.iter().fold(0.0, |most: f64, t| most.max(t.abs())) / w[0];
        (0..=40)
            .map(|i| at(most * f64::from(i) / 40.0))
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn no_double_harmonic_of_a_grid_is_nearer_to_the_force() {
        // The third force is nothing for half the turn, as a heel in the air: there the law rests on its base circle.
        let cases = [
            ("footbridge", 700.0, 3),
            ("heel_tester_fitted", 700.0, 4),
            ("heel_tester_fitted", 0.0, 3),
            ("footbridge", 700.0, 5),
        ];
        for (case, (machine, mean, highest)) in (0_u32..).zip(cases) {
            let wave = |theta: f64, n: u32| (f64::from(n) * theta + f64::from(case * n * n)).sin();
            let problem = problem(machine, |_, theta| {
                let swing = 300.0 * wave(theta, 1) - 170.0 * wave(theta, 2);
                let force = mean + swing + 60.0 * wave(theta, highest);
                if mean == 0.0 { force.max(0.0) } else { force }
            });
            let solved = double_harmonic_law(&problem).unwrap();
            assert!(solved.law.extremes(0).0.value > -1e-9, "{case}");
            let n = 120;
            let target = problem.target.as_ref().unwrap();
            let wanted: Vec<f64> = (0..n)
                .map(|i| target.cells().at(TAU * i as f64 / n as f64) - problem.drive.rest_force)
                .collect();
            let [level, lift, start, rise, fall] = solved.coefficients[..] else {
                panic!("{:?}", solved.coefficients);
            };
            let apart = (0..n).map(|i| {
                let theta = TAU * i as f64 / n as f64;
                let at = solved.law.svaj(theta);
                (problem.drive.force(at) - problem.drive.rest_force - wanted[i]).powi(2)
            });
            let ours = apart.sum::<f64>() / n as f64;
            let parts = shape([start, rise, fall])
                .unwrap()
                .scaled(lift)
                .raised(level);
            assert!((parts.svaj(1.0).s - solved.law.svaj(1.0).s).abs() < 1e-12);
            let step = TAU / 24.0;
            for rise in 1..=23 {
                for fall in 1..=24 - rise {
                    let other =
                        shape([0.0, f64::from(rise) * step, f64::from(fall) * step]).unwrap();
                    for ahead in (0..n).step_by(5) {
                        // Samples beside the two jumps of the acceleration miss the mean by one part in n each.
                        let theirs = distance(&problem, &wanted, &other, ahead);
                        assert!(
                            theirs > 0.98 * ours,
                            "{case}: {rise} {fall} {ahead}: {theirs} < {ours}"
                        );
                    }
                }
            }
        }
    }
}
