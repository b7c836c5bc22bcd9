//! Errors of walkers with cams that were designed for other walkers.

use serde::Serialize;

use crate::error::{Error, Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::problem::Problem;
use crate::scene::Scene;
use crate::synth::population::errors::{Aim, Nodes};
use crate::synth::population::{phase, report::report};
use crate::synth::report::walkers::WalkerError;
use crate::synth::{Design, OfPopulation};

/// The cam assigned to a cycle, and the errors of the cycle.
///
/// ```
/// use gaitcam::synth::Search;
/// use gaitcam::{cover, scene};
///
/// // One cam is assigned to a slow and a fast walker. For each walker, the squares of the components add up to the square of the error.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.6 Hz:2.1 Hz:2")?;
/// let walkers = scene.model_force()?.unwrap();
/// let covers = cover::covers(&scene, &walkers, 1, &Search::default())?;
/// for served in &covers[0].each {
///     let sum: f64 = served.parts_percent.iter().map(|part| part * part).sum();
///     assert!((sum.sqrt() - served.error.rms_error_percent).abs() < 1e-6);
/// }
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Assigned {
    /// Index of the cam, from 0.
    pub cam: usize,
    /// Errors of the cycle with this cam.
    pub error: WalkerError,
    /// Components of the error in percent of the mean force: mean force, amplitude and shape. The sum of their squares is the square of the error.
    pub parts_percent: [f64; 3],
}

/// Assigns each cycle of a force to the best of several cams. The machine is adjusted as the scene specifies.
///
/// # Errors
///
/// Errors of the input. The force contains only one cycle.
pub fn served_by(scene: &Scene, cams: &[Design], force: &ForceCurve) -> Result<Vec<Assigned>> {
    let mut best: Vec<Assigned> = Vec::new();
    let problem = Problem::resolve(scene, Some(force))?;
    for (cam, design) in cams.iter().enumerate() {
        let own = Under::of(&problem, design)?.assigned(cam);
        if cam == 0 {
            best = own;
            continue;
        }
        for (best, own) in best.iter_mut().zip(own) {
            // For one walker, the smaller error in newtons is also the smaller error in percent.
            if own.error.rms_error_n < best.error.rms_error_n {
                *best = own;
            }
        }
    }
    Ok(best)
}

/// Errors of cycles with a cam that may be designed for other walkers.
pub struct Under {
    /// Mean square error of each cycle.
    pub squares: Vec<f64>,
    report: OfPopulation,
    /// Components of the error of each cycle, as mean squares.
    parts: Vec<[f64; 3]>,
}

impl Under {
    /// Errors of the walkers of a problem with the cam of a design.
    ///
    /// # Errors
    ///
    /// The force of the problem contains only one cycle.
    pub fn of(problem: &Problem, design: &Design) -> Result<Under> {
        let problem = problem.at_phase(design.problem.phase);
        let walkers = problem.walkers.as_deref().ok_or_else(one_walker)?;
        let law = &design.cam.law;
        let mut phases = vec![0.0; walkers.each.len()];
        let mut turned = None;
        if walkers.adjust.phase {
            let force = phase::of_law(&problem.drive, law);
            phases = walkers
                .each
                .iter()
                .map(|w| phase::best(&force, w))
                .collect();
            turned = Some(walkers.at_phases(&phases));
        }
        let nodes = Nodes::of(law);
        let force = nodes.force(&problem.drive, law);
        let each = &turned.as_ref().unwrap_or(walkers).each;
        let aims: Vec<Aim> = each.iter().map(|w| nodes.aim(w)).collect();
        let squares: Vec<f64> = aims.iter().map(|aim| aim.square(&force)).collect();
        let parts = aims.iter().map(|aim| nodes.parts(aim, &force)).collect();
        phases.iter_mut().for_each(|p| *p += design.problem.phase);
        let report = report(walkers, &squares, &phases);
        Ok(Under {
            squares,
            report,
            parts,
        })
    }

    /// Errors of the cycles with this cam, as assignments to the cam with index `cam`.
    pub fn assigned(self, cam: usize) -> Vec<Assigned> {
        let both = self.report.each.into_iter().zip(self.parts);
        let own = both.map(|(error, parts)| {
            let whole: f64 = parts.iter().sum();
            let percent = error.rms_error_percent / whole.sqrt().max(f64::MIN_POSITIVE);
            let parts_percent = parts.map(|x| percent * x.sqrt());
            Assigned {
                cam,
                error,
                parts_percent,
            }
        });
        own.collect()
    }
}

pub fn one_walker() -> Error {
    SynthError::OneWalker.at_key("gait.file")
}
