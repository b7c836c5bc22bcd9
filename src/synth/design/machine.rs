//! Loads of a design on its machine: torque, power, lift-off speed and contact pressure.

use serde::Serialize;

use super::Design;
use crate::cam::Measures;
use crate::dynamics::rigid::{liftoff_speed, touch::held};
use crate::synth::limits::{Press, power_curve, torque_curve};

/// Fraction of the maximum power below which the mean power is a rounding error. Springs and masses return their energy within a turn.
const GIVEN_BACK: f64 = 1e-12;

/// Torque, power, lift-off speed and contact pressure of a rigid machine without friction, exact for the continuous law.
///
/// A value is `None` if it is not defined: without a load, without lift-off, for an undercut cam (pressure), or for a translating cam (torque).
/// On a moving floor, lift-off speed and pressure are `None`.
///
/// ```
/// use gaitcam::law::Rise;
/// use gaitcam::scene::{CamSpec, DriveSpec, LawSpec, SegmentSpec};
/// use gaitcam::Scene;
/// use gaitcam::synth::synthesise;
///
/// // An eccentric of e = 10 mm lifts off at ω = √(g/e).
/// let half = std::f64::consts::PI;
/// let law = LawSpec::program(vec![
///     SegmentSpec::new(Rise::SimpleHarmonic, 0.02, half),
///     SegmentSpec::new(Rise::SimpleHarmonic, -0.02, half),
/// ]);
/// let scene = Scene {
///     drive: DriveSpec { speed: Some(10.0), ..DriveSpec::moving_axis(3.0) },
///     law,
///     cam: CamSpec { base_radius: Some(0.02), ..CamSpec::default() },
///     ..Scene::default()
/// };
/// let machine = synthesise(&scene, None)?.machine();
/// assert!((machine.liftoff_speed_rad_per_s.unwrap() / (9.81_f64 / 0.01).sqrt() - 1.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MachineReport {
    /// Maximum absolute torque of the shaft, N·m.
    pub torque_max_n_m: Option<f64>,
    /// Root mean square of the torque, N·m.
    pub torque_rms_n_m: Option<f64>,
    /// Maximum absolute power of the shaft, W, for driving or braking.
    pub power_max_w: Option<f64>,
    /// Mean power of the shaft, W, which damping dissipates.
    pub power_mean_w: Option<f64>,
    /// Minimum speed of the shaft at which the follower lifts off, rad/s.
    pub liftoff_speed_rad_per_s: Option<f64>,
    /// Maximum Hertz pressure of the line contact, Pa, for the thickness of the cam and the materials of cam and follower; infinite for a
    /// knife edge.
    pub hertz_pressure_max_pa: Option<f64>,
}

/// Mean power, W. It is set to 0 if it is within the rounding errors of the maximum absolute power.
fn mean_power(mean: f64, extremes: [f64; 2]) -> f64 {
    let scale = extremes[0].abs().max(extremes[1].abs());
    if mean.abs() <= GIVEN_BACK * scale {
        0.0
    } else {
        mean
    }
}

impl MachineReport {
    /// Power and torque at a shaft speed, rad/s. They are computed from minimum, maximum, mean and root mean square of the torque, N·m.
    pub(in crate::synth) fn of_torque(
        [low, high]: [f64; 2],
        [mean, rms]: [f64; 2],
        speed: f64,
    ) -> MachineReport {
        let powers = [low * speed, high * speed];
        MachineReport {
            torque_max_n_m: Some(high.max(-low)),
            torque_rms_n_m: Some(rms),
            power_max_w: Some(powers[1].max(-powers[0])),
            power_mean_w: Some(mean_power(speed * mean, powers)),
            ..MachineReport::default()
        }
    }
}

impl Design {
    /// Torque, power, lift-off speed and contact pressure that the design requires of its machine.
    pub fn machine(&self) -> MachineReport {
        if self.is_idle() {
            return MachineReport::default();
        }
        let turns = self.cam.follower.measures() != Measures::Straight;
        let torque = torque_curve(self.force_curve(), &self.cam.law);
        let length = self.cam.law.extent().1;
        let (low, high) = torque.extremes();
        let rms = (torque.integral_of_square() / length).sqrt();
        let mut report = MachineReport::of_torque(
            [low.value, high.value],
            [torque.integral() / length, rms],
            self.problem.drive.speed,
        );
        let (low, high) = power_curve(&self.problem, torque).extremes();
        report.power_max_w = Some(high.value.max(-low.value));
        if turns {
            report.liftoff_speed_rad_per_s = self.liftoff();
        } else {
            (report.torque_max_n_m, report.torque_rms_n_m) = (None, None);
        }
        report.hertz_pressure_max_pa = self.pressure();
        report
    }

    /// Minimum speed, rad/s, at which a follower without form closure lifts off.
    fn liftoff(&self) -> Option<f64> {
        let second = self.conjugate.as_ref().map(|pair| &pair.second);
        if self.problem.on_shaft.is_some() || held(&self.cam, second) {
            return None;
        }
        liftoff_speed(self.pressing(), &self.problem.drive)
    }

    /// Maximum Hertz pressure over all contacts of the cam, Pa.
    fn pressure(&self) -> Option<f64> {
        let press = Press::of(&self.problem, self.pressing());
        let second = self.conjugate.as_ref().map(|pair| &pair.second);
        let worst = press.worst(&self.cam, second, self.groove.as_ref())?;
        Some(worst.value)
    }
}
