//! Suggestion of a further run that identifies the remaining parameters, by Fisher information.
//!
//! Of two runs with the columns J₁, J₂ and components of variance σ² the covariance of the parameters is
//! σ² (J₁ᵀJ₁ + J₂ᵀJ₂)⁻¹. The scale of the load cell is one parameter more: its column is the whole force.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::cycles::derivative;
use super::fit::t95;
use super::fitted::Fitted;
use super::model::{Clock, Effect, Machine};
use super::parameter::{Parameter, WIDEST};
use crate::scene::Scene;
use crate::synth::Design;

/// Candidate speeds relative to that of the log, and added masses relative to the moved one.
const SPEEDS: [f64; 2] = [0.8, 1.25];
const MASS: f64 = 0.2;

/// Change of the further run.
///
/// ```
/// use gaitcam::identify::Change;
///
/// assert_eq!(serde_json::to_value(Change::AddedMass { kg: 7.0 }).unwrap()["added-mass"]["kg"], 7.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// A run at another speed.
    Speed {
        /// The other speed, rad/s.
        rad_per_s: f64,
    },
    /// A run with a weighed mass added to the moved one.
    AddedMass {
        /// The added mass, kg.
        kg: f64,
    },
}

/// A further run of the same cam.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NextRun {
    /// Difference from the run of the log.
    pub change: Change,
    /// Parameters that both runs together identify.
    pub identifies: Vec<&'static str>,
}

/// The candidate run that identifies most parameters, or `None` if none identifies more than the log.
pub(super) fn next_run(
    design: &Design,
    scene: &Scene,
    fitted: &Fitted,
    parameters: &[Parameter],
) -> Option<NextRun> {
    let open: Vec<&Parameter> = parameters.iter().filter(|p| !p.identifiable).collect();
    let own = jacobian(design, scene, fitted, &fitted.clock, 0.0);
    let noise = fitted
        .fit
        .measured
        .variance()
        .iter()
        .fold(0.0_f64, |m, v| m.max(*v));
    let variance = noise + fitted.fit.component;
    let mass = design.problem.drive.mass;
    let faster = SPEEDS.map(|by| {
        (
            Change::Speed {
                rad_per_s: by * fitted.cycles.speed,
            },
            by,
            0.0,
        )
    });
    let heavier = (Change::AddedMass { kg: MASS * mass }, 1.0, MASS * mass);
    let is_carried = mass > 0.0 && !design.cam.follower.is_oscillating();
    let candidates = faster.into_iter().chain(is_carried.then_some(heavier));
    let runs = candidates.map(|(change, by, added)| {
        let clock = fitted.clock.faster(by);
        let other = jacobian(design, scene, fitted, &clock, added);
        let information = own.tr_mul(&own) + other.tr_mul(&other);
        let identifies = narrowed(fitted, &information, variance, &open);
        NextRun { change, identifies }
    });
    runs.max_by_key(|run| run.identifies.len())
        .filter(|run| !run.identifies.is_empty())
}

/// Columns of the terms, the delay and the scale in a run.
fn jacobian(
    design: &Design,
    scene: &Scene,
    fitted: &Fitted,
    clock: &Clock,
    added: f64,
) -> DMatrix<f64> {
    let machine = Machine::new(design, scene, clock);
    let count = fitted.cycles.force.mean.len();
    let column = |effect| clock.harmonics(&machine.effect(effect), count);
    let mut columns: Vec<Vec<f64>> = fitted.terms.iter().map(|t| column(t.effect)).collect();
    let mut force = vec![0.0; count];
    let mut add = |factor: f64, column: &[f64]| {
        force
            .iter_mut()
            .zip(column)
            .for_each(|(f, c)| *f += factor * c);
    };
    for ((term, values), found) in fitted.terms.iter().zip(&columns).zip(&fitted.fit.each) {
        if term.key != "log.bias" {
            add(found.value, values);
        }
    }
    if added > 0.0 {
        add(added, &column(Effect::Weight));
    }
    let mean = clock.speed.iter().sum::<f64>() / clock.speed.len() as f64;
    columns.push(derivative(&force).iter().map(|x| -mean * x).collect());
    columns.push(force);
    DMatrix::from_fn(count, columns.len(), |i, j| columns[j][i])
}

/// Open parameters whose intervals become sufficiently narrow.
fn narrowed(
    fitted: &Fitted,
    information: &DMatrix<f64>,
    variance: f64,
    open: &[&Parameter],
) -> Vec<&'static str> {
    let scale = DVector::from_iterator(
        information.ncols(),
        information
            .diagonal()
            .iter()
            .map(|x| 1.0 / x.sqrt().max(f64::MIN_POSITIVE)),
    );
    let scaled = DMatrix::from_diagonal(&scale) * information * DMatrix::from_diagonal(&scale);
    let Some(inverse) = scaled.cholesky().map(|c| c.inverse()) else {
        return Vec::new();
    };
    let names = fitted
        .terms
        .iter()
        .map(|t| t.key)
        .chain(["log.delay", "log.scale"]);
    let narrow = names.enumerate().filter_map(|(j, key)| {
        let parameter = open.iter().find(|p| p.key == key)?;
        let half = t95(fitted.cycles.force.each.len() - 1)
            * (variance * inverse[(j, j)]).sqrt()
            * scale[j];
        let is_narrow = 2.0 * half <= WIDEST * parameter.value.abs();
        (is_narrow && half.is_finite()).then_some(parameter.key)
    });
    narrow.collect()
}
