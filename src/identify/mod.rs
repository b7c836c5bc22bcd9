//! Identification of the parameters of a running machine from its logs, and design of the next cam.
//!
//! The law s(θ) is known. For a steady cycle, the model is therefore linear in all unknowns except the phase shift:
//!
//! ```text
//! y(φ + ψ) = b + F₀ + m (ω² a + α v) + k s + c ω v + f_C sign v − (k F + c ω F′ + m ω² F″)/k₁ + r(φ) + noise
//! ```
//!
//! Here y is the measured force, φ the cam angle, ψ the phase shift and b the zero offset of the load cell. F₀, m, k and c are the preload,
//! mass, stiffness and damping of the drive. α is the angular acceleration of the cam, f_C the Coulomb friction, k₁ the stiffness of the
//! follower train, F the force of the drive, and r the repeatable residual (theory §10).
//!
//! The harmonics of the mean cycle are fitted, with non-negative parameters where this is physical. A confidence interval has two sources.
//! The first is the noise of the mean cycle, from the scatter over the cycles. The second is the repeatable residual r, which is treated as
//! random in its few harmonics. If r resembles the effect of a delay or a damping, the intervals of these parameters are therefore wider.
//!
//! Several logs share the parameters and a delay. A log at a second speed separates mass and stiffness. A parameter is not identified if its interval
//! contains 0 or is wider than half its value (theory §10).
//!
//! The next cam corrects every repeatable force error, whether or not its cause is identified. [`recut`] adds the repeatable difference between log
//! and design to the machine (`machine.learned_force`) and designs the cam again within all limits.

mod cycles;
mod fit;
mod fitted;
mod least_squares;
mod log;
mod log_text;
mod model;
mod motor;
mod next_run;
mod parameter;
mod period;
mod recut;
mod run;
mod same_machine;

pub use log::{Log, LogColumns};
pub use log_text::LogOptions;
pub use next_run::NextRun;
pub use parameter::Parameter;
pub use recut::{Recut, recut};

use serde::Serialize;

use crate::error::Result;
use crate::scene::Scene;
use crate::synth::Design;
use fitted::Fitted;
use model::Effect;

/// Result of an identification: parameters, residuals, and a suggested further run.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::identify::{Log, LogColumns, identify};
/// use gaitcam::synth::synthesise;
///
/// // The footbridge shaker of 73 kg instead of 71.4 kg, with a cell that reads 5 N too much and scatters by 2 N.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let speed = design.problem.drive.speed;
/// let time: Vec<f64> = (0..4000).map(|i| 0.002 * f64::from(i)).collect();
/// let theta: Vec<f64> = time.iter().map(|t| speed * t).collect();
/// let force = (0..).zip(&theta).map(|(i, x)| {
///     let a = design.cam.law.svaj(*x).a * speed.powi(2);
///     73.0 * (9.81 + a) + 5.0 + f64::from(i * 7919 % 101) / 25.0 - 2.0
/// });
/// let columns = LogColumns { force: force.collect(), time: Some(time), theta: Some(theta), ..LogColumns::default() };
/// let found = identify(&design, &scene, &[Log::new("log 1".as_ref(), columns)?])?;
/// let mass = found.parameters.iter().find(|p| p.key == "drive.mass").unwrap();
/// assert!(mass.identifiable && (mass.value - 73.0).abs() < 0.2);
/// // A cell that reads 2 % too much and a machine that is 2 % heavier look alike.
/// assert!(found.parameters.iter().any(|p| p.key == "log.scale" && !p.identifiable));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct Identified {
    /// Parameters of the machine with their 95 % confidence intervals.
    pub parameters: Vec<Parameter>,
    /// Root mean square deviation of the samples from the mean cycles, N.
    pub noise_rms_n: f64,
    /// Root mean square of the repeatable residual, N.
    pub repeatable_rms_n: f64,
    /// Mean speed of the cam in the first log, rad/s.
    pub speed_rad_per_s: f64,
    /// Number of whole cycles of all logs.
    pub cycles: usize,
    /// Whether every log contains the cam angle. Without the angle, the phase of a log is fitted.
    pub has_angle: bool,
    /// Speed, residuals and mean cycles of each log, in the given order.
    pub logs: Vec<LogFit>,
    /// A further run that is predicted to identify more parameters; `None` if no candidate speed identifies more.
    pub next_run: Option<NextRun>,
}

/// Result of an identification for one log.
///
/// ```
/// use gaitcam::identify::LogFit;
///
/// let fit = LogFit { name: "fast.csv".into(), speed_rad_per_s: 16.3, cycles: 40, noise_rms_n: 2.0, repeatable_rms_n: 1.0, ..LogFit::default() };
/// assert_eq!(serde_json::to_value(&fit).unwrap()["cycles"], 40);
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct LogFit {
    /// Name of the log in messages: the file name without folders.
    pub name: String,
    /// Mean speed of the cam, rad/s.
    pub speed_rad_per_s: f64,
    /// Number of whole cycles in the log.
    pub cycles: usize,
    /// Root mean square deviation of the samples from the mean cycle, N.
    pub noise_rms_n: f64,
    /// Root mean square of the repeatable residual, N.
    pub repeatable_rms_n: f64,
    /// Measured mean cycle of the force at equally spaced cam angles, N.
    #[serde(skip)]
    pub measured_n: Vec<f64>,
    /// Cycle of the modelled force with the fitted parameters, at equally spaced cam angles, N.
    #[serde(skip)]
    pub modelled_n: Vec<f64>,
}

impl Identified {
    /// The scene with the identified values of its keys. Other keys are unchanged.
    ///
    /// # Errors
    ///
    /// The scene rejects a value.
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

/// Identifies the parameters of a machine from one or several logs. `design` is the design of its cam, and `scene` the scene of the design as
/// written, with the nominal parameters.
///
/// # Errors
///
/// - A log does not contain steady running of this machine. The error contains the reason.
/// - The same log is given twice.
/// - No common set of parameters fits the logs.
pub fn identify(design: &Design, scene: &Scene, logs: &[Log]) -> Result<Identified> {
    Ok(identified(design, scene, &Fitted::of(design, scene, logs)?))
}

fn identified(design: &Design, scene: &Scene, fitted: &Fitted) -> Identified {
    let Fitted {
        runs, terms, fit, ..
    } = fitted;
    let mut parameters: Vec<Parameter> = (terms.iter().zip(&fit.each))
        .map(|(t, found)| match t.effect {
            Effect::Compliance => Parameter::inverse(t.key, *found),
            _ => Parameter::of(t.key, *found, t.is_positive),
        })
        .collect();
    parameters.push(match fitted.has_delay() {
        true => Parameter::of("log.delay", fit.shifts[0], true),
        false => Parameter::unknown("log.delay", fit.shifts[0].value / runs[0].cycles.speed),
    });
    parameters.push(Parameter::unknown("log.scale", 1.0));
    parameters.extend(motor::parameters(design, fitted));
    let logs: Vec<LogFit> = (0..runs.len())
        .map(|i| log_fit(design, fitted, i))
        .collect();
    let rms = |of: fn(&LogFit) -> f64| {
        let squares = logs.iter().map(|log| of(log).powi(2));
        (squares.sum::<f64>() / logs.len() as f64).sqrt()
    };
    Identified {
        noise_rms_n: rms(|log| log.noise_rms_n),
        repeatable_rms_n: rms(|log| log.repeatable_rms_n),
        speed_rad_per_s: runs[0].cycles.speed,
        cycles: logs.iter().map(|log| log.cycles).sum(),
        has_angle: runs.iter().all(|run| run.cycles.by_angle),
        next_run: next_run::next_run(design, scene, fitted, &parameters),
        logs,
        parameters,
    }
}

fn log_fit(design: &Design, fitted: &Fitted, place: usize) -> LogFit {
    let run = &fitted.runs[place];
    let lever = design.problem.drive.lever;
    let in_newtons = |harmonics: &[f64]| -> Vec<f64> {
        let values = run.clock.at_angles(harmonics);
        let newtons = |f| design.problem.drive.newtons(f);
        values.into_iter().map(newtons).collect()
    };
    LogFit {
        name: run.name.clone(),
        speed_rad_per_s: run.cycles.speed,
        cycles: run.cycles.force.each.len(),
        noise_rms_n: run.cycles.noise_rms / lever,
        repeatable_rms_n: (0.5 * fitted.fit.repeats[place]).sqrt() / lever,
        measured_n: in_newtons(&fitted.fit.measured[place].mean),
        modelled_n: in_newtons(&fitted.modelled(place)),
    }
}
