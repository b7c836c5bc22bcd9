//! Identification of the parameters of a running machine from its log, and design of the next cam.
//!
//! The law s(θ) is known, so that of a steady cycle everything but a shift of the phase is linear:
//!
//! ```text
//! y(φ + ψ) = b + F₀ + m (ω² a + α v) + k s + c ω v + f_C sign v + r(φ) + noise
//! ```
//!
//! The mean cycle is fitted in harmonics, with parameters that cannot be negative. An interval has two sources: the noise of the mean cycle, from the
//! scatter over the cycles, and the repeatable residual r. r is treated as random in its few harmonics, so a residual that resembles a delay or a
//! damping widens their intervals. A parameter whose interval contains 0, or is wider than half its value, is not identified (theory §10).
//!
//! The next cam corrects every repeatable force error, identified or not: [`recut`] adds the repeatable difference from the design to the machine
//! (`machine.learned_force`) and designs again within all limits.

mod cycles;
mod fit;
mod fitted;
mod log;
mod model;
mod motor;
mod next_run;
mod parameter;
mod period;
mod recut;

pub use log::Log;
pub use next_run::Change;
pub(crate) use next_run::NextRun;
pub use parameter::Parameter;
pub use recut::{Recut, recut};

use serde::Serialize;

use crate::error::Result;
use crate::scene::Scene;
use crate::synth::Design;
use fit::Estimate;
use fitted::Fitted;
use model::Effect;

/// Result of an identification.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::identify::{Log, identify};
/// use gaitcam::synth::synthesise;
///
/// // The footbridge shaker of 73 kg instead of 71.4 kg, with a cell that reads 5 N too much and scatters by 2 N.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let mut text = String::from("theta_rad,time_s,force_n\n");
/// for i in 0..4000 {
///     let (time, scatter) = (0.002 * f64::from(i), f64::from(i * 7919 % 101) / 25.0 - 2.0);
///     let theta = design.problem.drive.speed * time;
///     let a = design.cam.law.svaj(theta).a * design.problem.drive.speed.powi(2);
///     text += &format!("{theta},{time},{}\n", 73.0 * (9.81 + a) + 5.0 + scatter);
/// }
/// let found = identify(&design, &scene, &Log::read("log.csv".as_ref(), text.as_bytes())?)?;
/// let mass = found.parameters.iter().find(|p| p.key == "drive.mass").unwrap();
/// assert!(mass.identifiable && (mass.value - 73.0).abs() < 0.2);
/// // A cell that reads 2 % too much and a machine that is 2 % heavier look alike.
/// assert!(found.parameters.iter().any(|p| p.key == "log.scale" && !p.identifiable));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct Identified {
    /// Parameters of the machine with their intervals.
    pub parameters: Vec<Parameter>,
    /// Root mean square of the samples about the mean cycle, N.
    pub noise_rms_n: f64,
    /// Root mean square of the repeatable residual, N.
    pub repeatable_rms_n: f64,
    /// Mean speed of the cam, rad/s.
    pub speed_rad_per_s: f64,
    /// Number of whole cycles of the log.
    pub cycles: usize,
    /// Whether the log has the cam angle; otherwise the phase gives the best fit.
    pub has_angle: bool,
    /// A run that would identify the remaining parameters.
    pub next_run: Option<NextRun>,
    /// Measured mean cycle and model at equal cam angles, N.
    #[serde(skip)]
    pub measured_n: Vec<f64>,
    /// Modelled mean cycle at equal cam angles, N.
    #[serde(skip)]
    pub modelled_n: Vec<f64>,
}

impl Identified {
    /// The scene with the identified values, otherwise unchanged.
    ///
    /// # Errors
    /// A value that the scene rejects.
    pub fn scene(&self, scene: &Scene) -> Result<Scene> {
        let mut out = scene.clone();
        for parameter in self.parameters.iter().filter(|p| p.identifiable) {
            let Some(key) = crate::scene::keys::find(parameter.key) else {
                continue;
            };
            let value = crate::scene::keys::Value::Number(parameter.value);
            key.set(&mut out, 0, value)?;
        }
        crate::scene::read(&out.to_table())
    }
}

/// The parameters of the machine of a design, `scene` as it is written, from a log.
///
/// # Errors
/// A log without a steady run of this machine, with the reason.
pub fn identify(design: &Design, scene: &Scene, log: &Log) -> Result<Identified> {
    Ok(identified(design, scene, &Fitted::of(design, scene, log)?))
}

fn identified(design: &Design, scene: &Scene, fitted: &Fitted) -> Identified {
    let Fitted {
        cycles, terms, fit, ..
    } = fitted;
    let lever = design.problem.drive.lever;
    let mut parameters: Vec<Parameter> = (terms.iter().zip(&fit.each))
        .map(|(t, found)| match t.effect {
            Effect::Compliance => Parameter::inverse(t.key, *found),
            _ => Parameter::of(t.key, *found, t.is_positive),
        })
        .collect();
    let delay = Estimate {
        value: fit.shift.value / cycles.speed,
        ends: fit.shift.ends.map(|x| x / cycles.speed),
    };
    parameters.push(match cycles.by_angle {
        true => Parameter::of("log.delay", delay, true),
        false => Parameter::unknown("log.delay", delay.value),
    });
    parameters.push(Parameter::unknown("log.scale", 1.0));
    parameters.extend(motor::parameters(design, fitted));
    let energy: f64 = fit.repeats.iter().sum();
    let modelled = fitted.modelled();
    let in_newtons = |harmonics: &[f64]| -> Vec<f64> {
        let values = fitted.clock.at_angles(harmonics);
        values
            .into_iter()
            .map(|f| design.problem.drive.newtons(f))
            .collect()
    };
    Identified {
        noise_rms_n: cycles.noise_rms / lever,
        repeatable_rms_n: (0.5 * energy).sqrt() / lever,
        speed_rad_per_s: cycles.speed,
        cycles: cycles.force.each.len(),
        has_angle: cycles.by_angle,
        next_run: next_run::next_run(design, scene, fitted, &parameters),
        measured_n: in_newtons(&fit.measured.mean),
        modelled_n: in_newtons(&modelled),
        parameters,
    }
}
