//! Suggestion of a further run that identifies the remaining parameters, by Fisher information.
//!
//! For runs with the columns J₁, J₂ …, the covariance of the parameters is σ² (J₁ᵀJ₁ + J₂ᵀJ₂ + …)⁻¹. Here σ² is the variance of a component of the
//! noise and of the repeatable residual.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::cycles::derivative;
use super::fit::t95;
use super::fitted::Fitted;
use super::model::{Clock, Machine};
use super::parameter::{Parameter, WIDEST};
use crate::scene::Scene;
use crate::synth::Design;

/// Candidate speeds, relative to the speed of the first log. Of several speeds that identify the same number of parameters, the first is selected.
const SPEEDS: [f64; 8] = [0.9, 1.1, 0.8, 1.2, 0.7, 1.4, 0.6, 1.7];
/// Maximum predicted width of an interval, as a fraction of the maximum width for identified parameters. The margin is necessary because the residual
/// of the further run is unknown.
const SAFE: f64 = 0.7;

/// A further run of the same cam at another speed.
///
/// ```
/// use gaitcam::identify::NextRun;
///
/// let run = NextRun { speed_rad_per_s: 16.3, relative_speed: 1.4, identifies: vec!["drive.mass", "drive.spring_rate"] };
/// assert_eq!(serde_json::to_value(&run).unwrap()["relative_speed"], 1.4);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NextRun {
    /// Speed of the cam, rad/s.
    pub speed_rad_per_s: f64,
    /// Speed of the cam, relative to the first log.
    pub relative_speed: f64,
    /// Keys of the parameters that the existing logs and the further run identify together, but not the existing logs alone.
    pub identifies: Vec<&'static str>,
}

/// Candidate run that identifies the largest number of further parameters; `None` if no candidate identifies a further one.
pub(super) fn next_run(
    design: &Design,
    scene: &Scene,
    fitted: &Fitted,
    parameters: &[Parameter],
) -> Option<NextRun> {
    let open: Vec<&Parameter> = parameters.iter().filter(|p| !p.identifiable).collect();
    let groups = fitted.shifts.len();
    // The phase of a further log without an angle is an additional unknown.
    let count = groups + usize::from(!fitted.runs[0].cycles.by_angle);
    let of_run = |place: usize, clock: &Clock| {
        let rates = |g: usize| fitted.shifts.get(g).map_or(0.0, |s| s.rates[place]);
        jacobian(design, scene, fitted, clock, (place, count, &rates))
    };
    let own = (0..fitted.runs.len()).map(|i| of_run(i, &fitted.runs[i].clock).0);
    let own = own.fold(None, |sum: Option<DMatrix<f64>>, j| {
        let square = j.tr_mul(&j);
        Some(sum.map_or(square.clone(), |s| s + square))
    })?;
    let first = &fitted.runs[0];
    let pressed = of_run(0, &first.clock).1 > 0.0;
    let mut best: Option<NextRun> = None;
    for by in SPEEDS {
        let clock = first.clock.faster(by);
        let rate = |g: usize| match first.cycles.by_angle {
            true => by * fitted.shifts[g].rates[0],
            false => f64::from(u8::from(g == groups)),
        };
        let (other, least) = jacobian(design, scene, fitted, &clock, (0, count, &rate));
        // The follower of a force-closed cam would lift off.
        if pressed && least <= 0.0 {
            continue;
        }
        let information = &own + other.tr_mul(&other);
        let identifies = narrowed(fitted, &information, &open);
        if identifies.len() > best.as_ref().map_or(0, |b| b.identifies.len()) {
            best = Some(NextRun {
                speed_rad_per_s: by * first.cycles.speed,
                relative_speed: by,
                identifies,
            });
        }
    }
    best
}

/// Jacobian of a run, and the minimum force of the run, N. The columns belong to the parameters and to `count` unknown phase shifts. `rate`
/// gives the phase delay per unit of a shift, rad. The rows are the harmonics of the mean cycle, as many as for the log `place`.
fn jacobian(
    design: &Design,
    scene: &Scene,
    fitted: &Fitted,
    clock: &Clock,
    (place, count, rate): (usize, usize, &dyn Fn(usize) -> f64),
) -> (DMatrix<f64>, f64) {
    let machine = Machine::new(design, scene, clock);
    let length = fitted.runs[place].cycles.force.mean.len();
    let effects = fitted.terms.iter().map(|t| machine.effect(t.effect));
    let effects: Vec<Vec<f64>> = effects.collect();
    let mut force = vec![0.0; effects[0].len()];
    for ((term, values), found) in fitted.terms.iter().zip(&effects).zip(&fitted.fit.each) {
        if term.key != "log.bias" {
            let sum = force.iter_mut().zip(values);
            sum.for_each(|(f, x)| *f += found.value * x);
        }
    }
    let least = force.iter().fold(f64::INFINITY, |m, f| m.min(*f));
    let slope = derivative(&clock.harmonics(&force, length));
    let phases = (0..count).map(|g| slope.iter().map(|x| -rate(g) * x).collect());
    let terms = effects.iter().map(|e| clock.harmonics(e, length));
    let columns: Vec<Vec<f64>> = terms.chain(phases).collect();
    let matrix = DMatrix::from_fn(length, columns.len(), |i, j| columns[j][i]);
    (matrix, least)
}

/// Keys of the unidentified parameters whose predicted intervals are sufficiently narrow.
fn narrowed(fitted: &Fitted, information: &DMatrix<f64>, open: &[&Parameter]) -> Vec<&'static str> {
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
    let cycles = fitted.fit.measured.iter().map(|m| m.each.len() - 1).sum();
    let variances = fitted.fit.measured.iter().flat_map(|m| m.variance());
    let noise = t95(cycles) * variances.fold(0.0_f64, f64::max).sqrt();
    // A further run is assumed to have as many residual harmonics as each log, on average.
    let runs = fitted.runs.len();
    let harmonics = fitted.fit.harmonics * (runs + 1) / runs;
    let doubt = t95(harmonics) * fitted.fit.component.sqrt();
    let terms = fitted.terms.iter().map(|t| t.key).zip(&fitted.fit.each);
    let delay = fitted.has_delay().then(|| &fitted.fit.shifts[0]);
    let all = terms.chain(delay.map(|d| ("log.delay", d)));
    let narrow = all.enumerate().filter_map(|(j, (key, found))| {
        let is_open = open.iter().any(|p| p.key == key);
        let half = libm::hypot(noise, doubt) * inverse[(j, j)].sqrt() * scale[j];
        let is_narrow = 2.0 * half <= SAFE * WIDEST * found.value.abs();
        (is_open && is_narrow && half.is_finite()).then_some(key)
    });
    narrow.collect()
}
