//! The spectral inverse: ŝₙ = F̂ₙ/(k + i c n ω − m n²ω²), harmonic by harmonic (theory §1).

use super::spline::base_circle_at;
use super::spline_program::force_distance;
use super::{Found, NoLaw, Stuck, gathered, report};
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::amplitudes;
use crate::problem::{Problem, Size};
use crate::scene::{Family, Minimise};
use crate::synth::design::Tier;
use crate::synth::method::Method;
use crate::synth::qp::{Basis, Program, TOLERANCE};
use crate::synth::{easing, limits, qp};
use crate::units::Quantity;

/// Most harmonics that "auto" takes.
const MOST_AUTO: usize = 60;
/// A gain below this part of the largest term that makes it up is a resonance: the force there cannot be
/// had from any finite lift.
const RESONANCE: f64 = 1e-9;

/// A harmonic law and what is known of its fit.
pub struct Spectral {
    /// Mean, then cosine and sine amplitudes of lift, m.
    pub x: Vec<f64>,
    /// Number of harmonics.
    pub count: usize,
    /// RMS force left in the harmonics that are not used, N.
    pub left_over: f64,
}

impl Spectral {
    /// The law; its mean is that of the drive, or zero where the drive leaves it open.
    pub fn law(&self) -> Law {
        let terms: Vec<(f64, f64)> = (0..self.count)
            .map(|n| (self.x[2 * n + 1], self.x[2 * n + 2]))
            .collect();
        Law::harmonic(self.x[0], &terms)
    }
}

/// The best law of `count` harmonics, or of the fewest whose remainder is at most `wanted` newtons RMS.
///
/// Fails when the target has too few samples for the harmonics asked, and when the drive is in resonance
/// with a harmonic that the force contains.
pub fn invert(
    target: &ForceCurve,
    drive: &Drive,
    count: Option<usize>,
    wanted: f64,
) -> Result<Spectral> {
    let n = target.force_n.len();
    let most = (n - 1) / 2;
    if count.is_some_and(|c| c > most) {
        return Err(Error::key(
            "law.harmonics",
            format!("{n} samples hold no more than {most} harmonics"),
        ));
    }
    let spectrum = amplitudes(&target.force_n);
    let power = |k: usize| 0.5 * (spectrum[k].0.powi(2) + spectrum[k].1.powi(2));
    // From the highest down, so that small remainders keep their digits.
    let mut left = 0.0;
    let mut fewest = most;
    let stop = count.unwrap_or(1);
    while fewest > stop && (count.is_some() || left + power(fewest) <= wanted * wanted) {
        left += power(fewest);
        fewest -= 1;
    }
    if count.is_none() && fewest > MOST_AUTO {
        left += (MOST_AUTO + 1..=fewest).map(power).sum::<f64>();
        fewest = MOST_AUTO;
    }
    let (count, left_over) = (fewest, left.sqrt());
    let mut x = Vec::with_capacity(2 * count + 1);
    let k0 = drive.spring_rate;
    x.push(if k0 != 0.0 {
        (spectrum[0].0 - drive.rest_force) / k0
    } else {
        0.0
    });
    for (h, &(a, b)) in spectrum.iter().enumerate().take(count + 1).skip(1) {
        let (re, im) = drive.gain(h);
        let square = re * re + im * im;
        let nw = h as f64 * drive.speed;
        let largest = drive
            .spring_rate
            .abs()
            .max(drive.mass * nw * nw)
            .max(im.abs());
        if square.sqrt() <= RESONANCE * largest {
            if a.hypot(b) <= RESONANCE * target.mean_n().abs() {
                x.extend([0.0, 0.0]);
                continue;
            }
            return Err(Error::key(
                "drive",
                format!("harmonic {h} of the force meets the drive's resonance: spring and inertia cancel and nothing is left to press with"),
            )
            .help("add damping, or change mass, spring rate or speed"));
        }
        // F = a cos + b sin = Re((a − ib) e^{ihθ}); dividing by re + i·im.
        x.push((a * re - b * im) / square);
        x.push((b * re + a * im) / square);
    }
    Ok(Spectral {
        x,
        count,
        left_over,
    })
}

/// The force's harmonics inverted, without a look at the limits, and what lies in the rest, N RMS: `count`
/// of them, or the fewest that leave no more than `wanted`.
pub fn inverted(problem: &Problem, count: Option<usize>, wanted: f64) -> Result<(Found, f64)> {
    let target = problem.target.as_ref().ok_or_else(no_force)?;
    let spectral = invert(&target.curve, &problem.drive, count, wanted)?;
    let method = Method::Spectral {
        harmonics: spectral.count,
        rest: Quantity::force(spectral.left_over),
    };
    let found = Found {
        family: Family::Harmonic,
        degree: 0,
        binding: Vec::new(),
        easing: Vec::new(),
        solver: report(Tier::Spectral, method, 0, true),
        law: spectral.law(),
        coefficients: spectral.x,
    };
    Ok((found, spectral.left_over))
}

/// The harmonics that the problem asks for, inverted, or solved for with the limits where those are broken.
pub fn found(problem: &Problem) -> std::result::Result<Found, NoLaw> {
    let wanted = problem.asked_error();
    let (mut found, _) = inverted(problem, problem.law.harmonics, wanted)?;
    let count = found.law.waves(0).len();
    // When every limit holds the spectral inverse is already the optimum (theory §1).
    let program = harmonic_program(problem, count, &found.law);
    if program.limits.is_empty() || !breaks_a_limit(&program, &found) {
        return Ok(found);
    }
    let solution = match program.solve() {
        Ok(solution) => solution,
        Err(failure) => {
            return Err(NoLaw::Stuck(Box::new(Stuck {
                family: Family::Harmonic,
                program,
                failure,
                nonconvex: None,
            })));
        }
    };
    found.law = program.basis.law(&solution.x);
    found.binding = gathered(&program, &solution, 2 * count);
    let method = Method::Harmonics {
        harmonics: count,
        rounds: solution.rounds,
        violation: solution.violation,
    };
    let certified = solution.violation <= TOLERANCE * 1.000_001;
    found.solver = report(Tier::Qp, method, solution.iterations, certified);
    found.solver.certificate = Some(qp::certificate(&program, &solution));
    found.easing = easing::easings(&program, &solution, Minimise::ForceError);
    found.coefficients = solution.x;
    Ok(found)
}

/// Whether the spectral law breaks a limit, its lowest point standing on the base circle.
fn breaks_a_limit(program: &Program, found: &Found) -> bool {
    let mut x = found.coefficients.clone();
    if program.constant_is_free() {
        x[0] -= found.law.extremes(0).0.value;
    }
    !program.broken(&x, &program.windows(&x)).is_empty()
}

/// The force fit in a given number of harmonics with the scene's limits. `unlimited` is the law without
/// them: where nothing fixes the lift, its lowest angle is taken for the base circle's.
fn harmonic_program(problem: &Problem, count: usize, unlimited: &Law) -> Program {
    let basis = Basis::Harmonic { count };
    let force = force_distance(problem, &basis);
    let mut program = Program::new(basis, force, Vec::new(), problem.length);
    let level = problem.level_is_known();
    let on_the_cam = matches!(problem.size(), Size::Given { .. });
    program.limits = limits::rows(problem, level || on_the_cam);
    if !level && on_the_cam {
        let lowest = unlimited.extremes(0).0.at;
        program.equalities.push(base_circle_at(&program, lowest));
    }
    program
}

/// The refusal of families that follow a force where there is none.
pub fn no_force() -> Error {
    Error::key(
        "law.family",
        "this family follows a force, and none is given",
    )
    .help("add [gait], or use spline, polynomial or program")
}
