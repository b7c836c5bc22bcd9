//! `[machine]`: properties of the machine in addition to its drive.

use std::f64::consts::TAU;

use super::floor::{FloorSpec, WalkersSpec};
use super::harmonic::Harmonic;
use crate::drive::{Drive, Motor, TorqueLine};
use crate::dynamics::Train;
use crate::error::{Placed, SceneError};

/// Maximum number of pole pairs for the default synchronous speed.
const POLE_PAIRS: u32 = 4;
/// Default damping ratio of a follower train, typical of lubricated steel parts.
const DAMPING_RATIO: f64 = 0.05;

/// Properties of the machine in addition to its drive.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::scene::MachineSpec;
///
/// // k = m (2πf)²
/// let machine = MachineSpec { natural_frequency: Some(50.0), ..MachineSpec::default() };
/// let train = machine.train(&Drive::moving_axis(2.0, 9.81, 10.0))?.unwrap();
/// let omega = std::f64::consts::TAU * 50.0;
/// assert!((train.stiffness / (2.0 * omega * omega) - 1.0).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MachineSpec {
    /// First natural frequency of the follower train, Hz; `None` if it is rigid or its stiffness is given.
    pub natural_frequency: Option<f64>,
    /// Stiffness of the follower train, N/m (N·m/rad for an arm), as an alternative to the natural frequency.
    pub stiffness: Option<f64>,
    /// Damping ratio of the follower train, relative to critical damping.
    pub damping_ratio: f64,
    /// Coefficient of sliding friction in the contact of cam and follower.
    pub friction: f64,
    /// Coefficient of restitution when the follower lands on the cam, 0 to 1.
    pub restitution: f64,
    /// Phase of a second, equal cam on the same shaft, rad; `None` without a second cam.
    pub second_cam: Option<f64>,
    /// Motor of the shaft. Without torque data, the speed of the shaft is constant.
    pub motor: MotorSpec,
    /// Moment of inertia of all rotating parts except the rotor of the motor, referred to the camshaft, kg·m².
    pub inertia: Option<f64>,
    /// Friction torque in the bearings of the shaft, N·m.
    pub friction_torque: f64,
    /// Force of the machine in addition to the force of the drive, learned from a log: mean and harmonics 1, 2, … of the cam angle, N.
    pub learned_force: Vec<Harmonic>,
    /// Mode of the structure under the feet, if there is only one.
    pub floor: FloorSpec,
    /// Modes of the structure under the feet, if there are several.
    pub modes: Vec<FloorSpec>,
    /// Walkers on the structure, including the shaker.
    pub walkers: WalkersSpec,
}

/// `[machine.motor]`: torque as a function of speed.
///
/// ```
/// use gaitcam::scene::{MachineSpec, MotorSpec};
///
/// // Stall torque 2 N·m, no-load speed 100 rad/s, gear ratio 8. The slope at the camshaft is 8²·2/100 = 1.28 N·m·s/rad.
/// let motor = MotorSpec { stall_torque: Some(2.0), no_load_speed: Some(100.0), gear: 8.0, ..MotorSpec::default() };
/// let machine = MachineSpec { motor, inertia: Some(0.5), ..MachineSpec::default() };
/// let motor = machine.motor().unwrap();
/// assert!((motor.torque(10.0, 12.5)[0] - 1.28 * 2.5).abs() < 1e-12);
/// assert_eq!(motor.nominal, Some(12.5));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MotorSpec {
    /// Decrease of the torque per increase of the speed, referred to the camshaft, N·m·s/rad.
    pub slope: Option<f64>,
    /// Torque of the motor at standstill, N·m.
    pub stall_torque: Option<f64>,
    /// No-load speed of the motor, rad/s; `None`: the speed for which the shaft has the prescribed mean speed.
    pub no_load_speed: Option<f64>,
    /// Torque of an induction motor at its rated speed, N·m.
    pub rated_torque: Option<f64>,
    /// Rated speed of an induction motor, rad/s.
    pub rated_speed: Option<f64>,
    /// Synchronous speed of an induction motor, rad/s; `None`: the lowest synchronous speed above the rated speed, for 50 Hz or 60 Hz.
    pub synchronous_speed: Option<f64>,
    /// Moment of inertia of the rotor, at the motor, kg·m².
    pub inertia: f64,
    /// Torque curve of the motor, as a list of numbers in which speeds, rad/s, and torques, N·m, alternate.
    pub curve: Option<String>,
    /// Gear ratio: turns of the motor per turn of the cam.
    pub gear: f64,
    /// Efficiency of the gear, 0 to 1.
    pub efficiency: f64,
}

impl Default for MotorSpec {
    fn default() -> MotorSpec {
        MotorSpec {
            slope: None,
            stall_torque: None,
            no_load_speed: None,
            rated_torque: None,
            rated_speed: None,
            synchronous_speed: None,
            inertia: 0.0,
            curve: None,
            gear: 1.0,
            efficiency: 1.0,
        }
    }
}

impl MotorSpec {
    /// Whether torque data of the motor are given.
    pub fn is_given(&self) -> bool {
        self.slope.is_some()
            || self.stall_torque.is_some()
            || self.rated_torque.is_some()
            || self.curve.is_some()
    }

    /// Torque at standstill, N·m, and no-load speed, rad/s, of a linear torque line, at the motor. They are given, or follow from the nameplate of an
    /// induction motor, whose torque is zero at the synchronous speed.
    fn straight(&self) -> Option<(f64, Option<f64>)> {
        if let Some(stall) = self.stall_torque {
            return Some((stall, self.no_load_speed));
        }
        let (torque, rated) = (self.rated_torque?, self.rated_speed?);
        let synchronous = self.synchronous()?;
        Some((
            torque * synchronous / (synchronous - rated),
            Some(synchronous),
        ))
    }

    /// Synchronous speed, rad/s. If it is not given, it is the lowest synchronous speed above the rated speed, for 2, 4, 6 or 8 poles at 50
    /// Hz or 60 Hz.
    fn synchronous(&self) -> Option<f64> {
        let rated = self.rated_speed?;
        let per_pair = [50.0, 60.0].map(|frequency| TAU * frequency);
        let all = (1..=POLE_PAIRS).flat_map(|pairs| per_pair.map(|w| w / f64::from(pairs)));
        let next = || all.clone().filter(|w| *w > rated).reduce(f64::min);
        self.synchronous_speed.or_else(next)
    }

    /// Moment of inertia of the rotor, referred to the camshaft, kg·m².
    pub fn rotor_at_cam(&self) -> f64 {
        self.inertia * self.gear * self.gear
    }

    /// Rows of the torque curve: speed, rad/s, and torque, N·m. `None` unless there are at least two rows with increasing speed and decreasing
    /// torque.
    pub fn rows(&self) -> Option<Vec<[f64; 2]>> {
        let numbers = self.curve.as_ref()?.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().ok()?;
        let rows: Vec<[f64; 2]> = numbers.chunks(2).map(|r| [r[0], r[r.len() - 1]]).collect();
        let falls = |r: &[[f64; 2]]| r[1][0] > r[0][0] && r[1][1] < r[0][1];
        let sound = numbers.len().is_multiple_of(2) && rows.len() > 1 && rows.windows(2).all(falls);
        sound.then_some(rows)
    }

    /// Torque as a function of speed, referred to the camshaft, and the no-load speed of the camshaft, rad/s, if the data determine it.
    fn line(&self) -> Option<(TorqueLine, Option<f64>)> {
        let (n, factor) = (self.gear, self.gear * self.efficiency);
        if let Some(slope) = self.slope {
            return Some((TorqueLine::Slope(slope), None));
        }
        if let Some((stall, no_load)) = self.straight() {
            let at_cam = factor * stall;
            return Some(match no_load.map(|w| w / n) {
                Some(nominal) => (TorqueLine::Slope(at_cam / nominal), Some(nominal)),
                None => (TorqueLine::Stall(at_cam), None),
            });
        }
        let rows = self.rows()?.into_iter().map(|[w, t]| [w / n, factor * t]);
        let line = TorqueLine::Curve(rows.collect());
        let nominal = line.no_load_speed();
        Some((line, nominal))
    }
}

impl MachineSpec {
    /// Checks that a motor has exactly one decreasing torque line, and that the inertia of its shaft is given.
    ///
    /// # Errors
    ///
    /// The motor data are inconsistent. The error contains the key that must be changed.
    pub(in crate::scene) fn check_motor(&self) -> Result<(), (&'static str, SceneError)> {
        let motor = &self.motor;
        let lines = [
            motor.slope.is_some(),
            motor.stall_torque.is_some(),
            motor.rated_torque.is_some(),
            motor.curve.is_some(),
        ];
        let lines = lines.iter().filter(|given| **given).count();
        let of_plate = [motor.rated_speed, motor.synchronous_speed];
        let is_half = match motor.rated_torque {
            None => of_plate.iter().any(Option::is_some),
            Some(_) => motor.rated_speed.is_none(),
        };
        let too_fast = motor.rated_torque.and(motor.rated_speed).filter(|rated| {
            motor
                .synchronous()
                .is_none_or(|synchronous| synchronous <= *rated)
        });
        let fault = if is_half {
            ("machine.motor.rated_torque", SceneError::HalfNameplate)
        } else if too_fast.is_some() {
            (
                "machine.motor.synchronous_speed",
                SceneError::NotSynchronous,
            )
        } else if motor.no_load_speed.is_some() && motor.stall_torque.is_none() {
            (
                "machine.motor.no_load_speed",
                SceneError::NoLoadWithoutStall,
            )
        } else if lines > 1 {
            ("machine.motor.slope", SceneError::MotorLine)
        } else if motor.curve.is_some() && motor.rows().is_none() {
            ("machine.motor.curve", SceneError::MotorCurve)
        } else if lines > 0 && self.inertia.is_none() && motor.inertia == 0.0 {
            ("machine.inertia", SceneError::MotorWithoutInertia)
        } else {
            return Ok(());
        };
        Err(fault)
    }

    /// Moment of inertia of all rotating parts, referred to the camshaft, kg·m²: the given inertia plus the rotor of the motor. `None` if neither is
    /// given.
    fn total_inertia(&self) -> Option<f64> {
        let rotor = self.motor.rotor_at_cam();
        let alone = (rotor > 0.0).then_some(rotor);
        self.inertia.map(|own| own + rotor).or(alone)
    }

    /// The motor with flywheel and friction, referred to the camshaft; `None` if the shaft speed is constant.
    pub fn motor(&self) -> Option<Motor> {
        let spec = &self.motor;
        let (line, nominal) = spec.line()?;
        Some(Motor {
            line,
            nominal,
            inertia: self.total_inertia()?,
            friction: self.friction_torque,
            gear: spec.gear,
            efficiency: spec.efficiency,
        })
    }

    /// Whether the machine has a constant shaft speed, a rigid floor and no learned force.
    pub fn is_plain(&self) -> bool {
        !self.motor.is_given() && !self.has_floor() && self.learned_force.is_empty()
    }

    /// Learned force at a cam angle, rad; result in N.
    pub fn learned_at(&self, theta: f64) -> f64 {
        let each = (0..).zip(&self.learned_force);
        each.map(|(n, h)| match n {
            0 => h.factor,
            n => h.factor * libm::sin(f64::from(n) * theta + h.phase),
        })
        .sum()
    }

    /// Stiffness and damping of the follower train between cam and mass; `None` for a rigid follower.
    ///
    /// # Errors
    /// A natural frequency is given without a mass.
    pub fn train(&self, drive: &Drive) -> crate::error::Result<Option<Train>> {
        if let Some(hz) = self.natural_frequency {
            return Train::from_frequency(drive, hz, self.damping_ratio)
                .map(Some)
                .map_err(|e| e.at_key("machine.natural_frequency"));
        }
        Ok(self.stiffness.map(|stiffness| Train {
            stiffness,
            damping: 2.0 * self.damping_ratio * (stiffness * drive.mass).sqrt(),
        }))
    }
}

impl Default for MachineSpec {
    fn default() -> MachineSpec {
        MachineSpec {
            natural_frequency: None,
            stiffness: None,
            damping_ratio: DAMPING_RATIO,
            friction: 0.0,
            restitution: 0.0,
            second_cam: None,
            motor: MotorSpec::default(),
            inertia: None,
            friction_torque: 0.0,
            learned_force: Vec::new(),
            floor: FloorSpec::default(),
            modes: Vec::new(),
            walkers: WalkersSpec::default(),
        }
    }
}
