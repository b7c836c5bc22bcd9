//! A law whose force on a floor that moves is the wanted one.
//!
//! F = M (g + d″ + z″), and z″ follows from the wanted force by one linear answer per harmonic ([`Floor`]): with it the target of
//! d″ is another target, as on a shaft whose speed varies ([`crate::problem`]). What the law leaves of the target moves the floor
//! too: rounds of designs look for the z″ that the law designed for it makes, so that the limits hold for the true force
//! (theory §10).

use std::f64::consts::TAU;

use serde::Serialize;

use super::fixed_point::{Round, settled};
use crate::dynamics::floor::harmonics;
use crate::dynamics::{Floor, FloorMotion};
use crate::error::Result;
use crate::law::Law;
use crate::poly::samples;
use crate::problem::{Extra, Problem, piecewise};
use crate::synth::design::{Design, Infeasible};
use crate::synth::sizing::checked_cam::checked_cam;
use crate::synth::{Search, SizedLaw, at_best_phase, finished, solved};

/// Equal angles of force and acceleration.
const SAMPLES: usize = 720;
/// Difference of M z″ between what a law is designed for and what it makes, part of the mean force, that is none.
const SETTLED: f64 = 1e-6;
/// Step frequencies of the resonance curve, Hz: first, step, and how many.
const CURVE: (f64, f64, usize) = (1.0, 0.01, 201);
/// Harmonics of the force whose resonances it shows, and its points about each, half widths of the peak from its top.
const MOST_RESONANT: u32 = 10;
const FLANKS: [f64; 9] = [-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0];

/// The design on its floor.
///
/// ```
/// use gaitcam::scene;
///
/// // Ten tonnes in resonance with the steps: the walker of 700 N shakes them into the third class of comfort.
/// let mut table = scene::built_in("footbridge")?.scene()?.to_table();
/// for change in ["mass=10000 kg", "frequency=1.85 Hz", "damping=0.01"] {
///     scene::set(&mut table, &format!("machine.floor.{change}"))?;
/// }
/// let design = scene::read(&table)?.design()?;
/// let floor = design.floor.as_ref().unwrap();
/// // F₁/(2ζm) = 700 · 0.333/(2 · 0.01 · 10⁴) m/s²
/// assert!((floor.motion.acceleration_peak_m_per_s2 - 1.1655).abs() < 0.05);
/// assert_eq!(floor.motion.comfort, "CL3");
/// assert!(design.force.rms_error_percent_of_mean < 0.5);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OnFloor {
    /// The steady motion under the shaker and all walkers.
    pub motion: FloorMotion,
    /// The same under the wanted force at other step frequencies.
    #[serde(skip)]
    pub resonance: Vec<AtFrequency>,
}

/// A point of the resonance curve.
///
/// ```
/// use gaitcam::dynamics::FloorMotion;
/// use gaitcam::synth::AtFrequency;
///
/// let at = AtFrequency { step_frequency: 1.85, motion: FloorMotion::of(&[(2.6, 0.0)]) };
/// assert_eq!(at.motion.comfort_setra, "unacceptable");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtFrequency {
    /// Step frequency, Hz.
    pub step_frequency: f64,
    /// The steady motion there.
    pub motion: FloorMotion,
}

/// The design for a floor that moves.
///
/// # Errors
/// An undamped mode in resonance; as on a stiff floor.
pub fn designed(problem: &Problem, search: &Search, floor: Floor) -> Result<Design> {
    let problem = at_best_phase(problem, search)?;
    let wanted = problem.target.as_ref().map(|t| sampled(|x| t.curve.at(x)));
    let on = Ground {
        wanted: harmonics(&wanted.unwrap_or_else(|| vec![0.0; SAMPLES])),
        floor,
        problem,
    };
    let allowed = SETTLED * on.problem.target_mean();
    let start = on.inertia(&on.floor.of_walkers(0, &on.wanted))?;
    let last = settled(start, allowed, |given| on.round(search, given))?;
    let (sized, infeasible, acceleration) = last.design;
    let mut design = on.judged(search, &last.state, sized, infeasible)?;
    let motion = FloorMotion::of(&acceleration);
    let resonance = on.resonance(&design);
    design.floor = Some(OnFloor { motion, resonance });
    Ok(design)
}

fn sampled(f: impl Fn(f64) -> f64) -> Vec<f64> {
    let angles = (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
    angles.map(f).collect()
}

/// A problem on its floor, with the harmonics of the wanted force, N.
struct Ground {
    problem: Problem,
    floor: Floor,
    wanted: Vec<(f64, f64)>,
}

/// A law, why none keeps the limits, and the acceleration of the floor under it, m/s².
type OnGround = (SizedLaw, Option<Infeasible>, Vec<(f64, f64)>);

impl Ground {
    /// M z″ under a force, N.
    fn inertia(&self, force: &[(f64, f64)]) -> Result<Vec<f64>> {
        let drive = &self.problem.drive;
        let acceleration = self.floor.acceleration(drive.speed, force)?;
        Ok(self.weighed(&acceleration))
    }

    fn weighed(&self, acceleration: &[(f64, f64)]) -> Vec<f64> {
        let each = samples(acceleration, 0, SAMPLES).into_iter();
        each.map(|a| self.problem.drive.mass * a).collect()
    }

    /// The problem with a motion of the floor given, as M z″ over the turn, N.
    fn moving(&self, inertia: &[f64]) -> Problem {
        let Some(target) = &self.problem.target else {
            return self.problem.clone();
        };
        let force = piecewise(&target.curve.with_forces(inertia.to_vec()));
        self.problem
            .on_shaft(&sampled(|x| x), Extra::of_force(force))
    }

    /// The acceleration of the floor under a law.
    fn under(&self, law: &Law) -> Result<Vec<(f64, f64)>> {
        let drive = &self.problem.drive;
        let still = harmonics(&sampled(|x| drive.force(law.svaj(x))));
        let others = self.floor.of_walkers(1, &self.wanted);
        let own = self
            .floor
            .pressed(drive.mass, drive.speed, &still, &others)?;
        let all = own.iter().zip(&others).map(|(a, b)| (a.0 + b.0, a.1 + b.1));
        self.floor
            .acceleration(drive.speed, &all.collect::<Vec<_>>())
    }

    /// The law for a motion of the floor, and the motion that it makes.
    fn round(&self, search: &Search, given: &[f64]) -> Result<Round<OnGround>> {
        // What is kept belongs to the target of the round before.
        let fresh = Search {
            cache: Default::default(),
            ..search.clone()
        };
        let (sized, infeasible) = solved(&self.moving(given), &fresh)?;
        let acceleration = self.under(&sized.law.law)?;
        Ok(Round {
            made: self.weighed(&acceleration),
            has_law: infeasible.is_none(),
            design: (sized, infeasible, acceleration),
        })
    }

    /// The design of a law over a motion of the floor.
    fn judged(
        &self,
        search: &Search,
        inertia: &[f64],
        sized: SizedLaw,
        infeasible: Option<Infeasible>,
    ) -> Result<Design> {
        let judged = self.moving(inertia);
        let checked = checked_cam(&judged, search, &sized.law.law, None)?;
        let mut design = finished(&judged, search, SizedLaw { checked, ..sized }, infeasible)?;
        design.target = self.problem.target.as_ref().map(|t| (*t.curve).clone());
        design.band = self.problem.band.clone();
        Ok(design)
    }

    /// The motion under the wanted force over the step frequency, at equal steps and at the resonances; without the points at
    /// which an undamped mode has none.
    fn resonance(&self, design: &Design) -> Vec<AtFrequency> {
        let steps = design
            .load_factors()
            .first()
            .map_or(1.0, |f| 1.0 / f.of_step);
        let (first, step, count) = CURVE;
        let last = first + step * (count - 1) as f64;
        let mut at: Vec<f64> = (0..count).map(|i| first + step * i as f64).collect();
        for mode in &self.floor.modes {
            for harmonic in 1..=MOST_RESONANT {
                let peak = steps * mode.frequency / f64::from(harmonic);
                let flanks = FLANKS.map(|widths| peak * (1.0 + widths * mode.damping));
                at.extend(flanks.into_iter().filter(|f| (first..=last).contains(f)));
            }
        }
        at.sort_by(f64::total_cmp);
        at.dedup();
        let all = self.floor.of_walkers(0, &self.wanted);
        let point = |step_frequency: f64| {
            let speed = TAU * step_frequency / steps;
            let answer = self.floor.acceleration(speed, &all).ok()?;
            let motion = FloorMotion::of(&answer);
            Some(AtFrequency {
                step_frequency,
                motion,
            })
        };
        at.into_iter().filter_map(point).collect()
    }
}
