//! Motion of the motor-driven shaft, and its effect on the force.

use serde::Serialize;

use crate::dynamics::{InTime, Shaft};

/// Report on a motor-driven shaft.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // With an inertia of 0.5 kg·m² and a motor whose torque decreases by 10 N·m per rad/s, the speed ripple is 25 %.
/// let mut table = scene::built_in("footbridge")?.scene()?.to_table();
/// scene::set(&mut table, "machine.motor.slope=10 N m s/rad")?;
/// scene::set(&mut table, "machine.inertia=0.5 kg m^2")?;
/// let scene = scene::read(&table)?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let on_shaft = design.shaft.as_ref().unwrap();
/// assert!((on_shaft.shaft.ripple - 0.25).abs() < 0.01);
/// assert!(on_shaft.force_time.unwrap().rms_error_percent_of_mean < 0.5);
/// assert!(on_shaft.at_constant_speed.unwrap().rms_error_percent_of_mean > 6.0);
/// // With an inertia that differs by ±10 %, the force error of the same cam is below 1 % of the weight.
/// let [less, more] = design.sensitivity()[0].percent;
/// assert!(less.unwrap() < 1.0 && more.unwrap() < 1.0);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct OnShaft {
    /// Steady motion of the shaft over one period.
    pub shaft: Shaft,
    /// Force error over time, with the varying speed of the shaft; `None` without a target.
    pub force_time: Option<InTime>,
    /// Force error over time if the law designed for constant speed runs on the shaft with this motor; `None` without a target.
    pub at_constant_speed: Option<InTime>,
    /// Number of iterations of design and simulation, in addition to the design for constant speed.
    pub rounds: usize,
    /// Ratio of the last two changes between iterations; `None` if there are fewer than two changes.
    pub contraction: Option<f64>,
    /// Estimate of ripple and force change from inertia and energy of the load.
    pub forecast: Forecast,
    /// Shaft speed, rad/s, at equally spaced cam angles.
    #[serde(skip)]
    pub speed: Vec<f64>,
    /// Time since cam angle 0, s, at equally spaced cam angles.
    #[serde(skip)]
    pub time: Vec<f64>,
}

/// Estimate of the speed ripple and of the force change that it causes, from inertia and alternating energy.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // With an inertia of 500 kg·m², the speed ripple is negligible, and the law for constant speed is used.
/// let mut table = scene::built_in("footbridge")?.scene()?.to_table();
/// scene::set(&mut table, "machine.motor.slope=10 N m s/rad")?;
/// scene::set(&mut table, "machine.inertia=500 kg m^2")?;
/// let scene = scene::read(&table)?;
/// let on_shaft = synthesise(&scene, scene.model_force()?.as_ref())?.shaft.unwrap();
/// assert!(on_shaft.forecast.is_negligible && on_shaft.rounds == 0);
/// assert!((on_shaft.forecast.ripple / on_shaft.shaft.ripple - 1.0).abs() < 0.02);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Forecast {
    /// Speed ripple: difference of maximum and minimum speed, relative to the mean.
    pub ripple: f64,
    /// RMS change of the force, in percent of its mean.
    pub force_change_percent_of_mean: f64,
    /// Force change up to which constant speed is accurate enough, in percent of the mean.
    pub neglected_percent_of_mean: f64,
    /// Whether constant speed is accurate enough for the design.
    pub is_negligible: bool,
}
