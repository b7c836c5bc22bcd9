//! A cam and its rigid follower under a speed programme, prescribed or commanded to a motor.

use std::f64::consts::TAU;

use super::mode::{Misfit, RepeatedForce};
use super::speed::SpeedProgramme;
use crate::drive::{Drive, Motor};
use crate::dynamics::recover::{Cycle, recover_cam};
use crate::dynamics::rigid::touch::{FollowerContact, held};
use crate::dynamics::run::Run;
use crate::dynamics::shaft::force;
use crate::error::{DynamicsError, Result};
use crate::law::{Law, Svaj};
use crate::units::{Dimension, Quantity};

/// Minimum and maximum number of integration steps between two rows. Within this range, `PER_TIME_CONSTANT` sets the number.
const SUBSTEPS: [f64; 2] = [2.0, 256.0];
const PER_TIME_CONSTANT: f64 = 4.0;
/// Relative difference between the available and the required torque of the motor above which the motor cannot follow the programme.
const SAME_TORQUE: f64 = 1e-6;

/// Motion, force and torque of a cam that follows a speed programme, at the times of the rows of the programme.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{ProgrammeRun, Run, SpeedProgramme};
/// use gaitcam::law::Law;
///
/// // An eccentric of e = 10 mm lifts M = 10 kg at constant speed. The force is M (g − e ω² sin θ).
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// let even = SpeedProgramme::new(vec![0.0, 0.5, 1.0], vec![5.0; 3])?;
/// let found = ProgrammeRun::new(&run, &even, 0.0)?;
/// assert!((found.force_n[1] - (98.1 - 2.5 * 2.5_f64.sin())).abs() < 1e-3);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ProgrammeRun {
    /// Times of the rows of the programme, s.
    pub time_s: Vec<f64>,
    /// Cam angle, rad, which increases over all turns.
    pub angle: Vec<f64>,
    /// Speed of the camshaft, rad/s.
    pub speed: Vec<f64>,
    /// Angular acceleration of the camshaft, rad/s².
    pub acceleration: Vec<f64>,
    /// Velocity of the follower, m/s; for an arm, rad/s.
    pub follower_velocity: Vec<f64>,
    /// Acceleration of the follower, m/s²; for an arm, rad/s².
    pub follower_acceleration: Vec<f64>,
    /// Contact force, N; for an arm, divided by its lever.
    pub force_n: Vec<f64>,
    /// Torque at the camshaft, N·m: torque of the motor if there is one, otherwise torque of the load.
    pub torque: Vec<f64>,
    /// Whether the contact force is negative at a row, so that the follower leaves the cam.
    pub contact_lost: bool,
}

impl ProgrammeRun {
    /// Simulates a cam that follows a speed programme. The lift is recovered from the output profile. `start` is the cam angle at the first
    /// row of the programme, rad. With a motor, the programme is the commanded no-load speed. Without a motor, it is the speed of the
    /// shaft. The model is rigid.
    ///
    /// # Errors
    /// The cam is not closed, no smooth lift can be recovered from the output profile, or the shaft of the motor stops.
    pub fn new(run: &Run, programme: &SpeedProgramme, start: f64) -> Result<ProgrammeRun> {
        let follower = Follower::new(run)?;
        match follower.motor {
            None => Ok(follower.prescribed(programme, start)),
            Some(motor) => follower.commanded(motor, programme, start),
        }
    }

    /// Differences between the responses of a structural mode to the force of the cam and to a recorded force, for every damping ratio. The
    /// recorded force, N, is given at the rows. The rows contain the given number of strides. The last row repeats the first.
    pub fn misfits(&self, walk_n: &[f64], strides: usize) -> [Misfit; 3] {
        let last = self.time_s.len() - 1;
        let duration = self.time_s[last] - self.time_s[0];
        let of = |force: &[f64]| RepeatedForce::new(&force[..last], duration, strides);
        of(walk_n).misfits(&of(&self.force_n))
    }

    /// Root mean square difference between the force of the cam and a recorded force at the rows, N.
    pub fn rms_error(&self, walk_n: &[f64]) -> f64 {
        let off = self.force_n.iter().zip(walk_n).skip(1);
        let square: f64 = off.map(|(a, b)| (a - b).powi(2)).sum();
        (square / (self.force_n.len() - 1) as f64).sqrt()
    }
}

/// Rigid follower on an output profile, with its drive and motor.
pub(super) struct Follower<'a> {
    law: Law,
    drive: Drive,
    contact: FollowerContact,
    friction: f64,
    motor: Option<&'a Motor>,
    held: bool,
}

impl<'a> Follower<'a> {
    pub(super) fn new(run: &'a Run) -> Result<Follower<'a>> {
        let cycle = Cycle::of(&run.cam.law);
        if !cycle.closed || cycle.length != TAU {
            return Err(DynamicsError::ProgrammeTurns.into());
        }
        let drive = Drive {
            speed: run.drive.speed.abs(),
            ..run.drive
        };
        Ok(Follower {
            law: recover_cam(&run.cam, &run.profile, cycle)?.law,
            drive,
            contact: FollowerContact::of(&run.cam.follower),
            friction: run.machine.friction,
            motor: run.machine.motor.as_ref(),
            held: held(&run.cam, run.machine.conjugate.as_ref()),
        })
    }

    fn motion(&self, angle: f64) -> Svaj {
        self.law.svaj(angle.rem_euclid(TAU))
    }

    /// Simulates a run in which the speed of the shaft is exactly that of the programme.
    pub(super) fn prescribed(&self, programme: &SpeedProgramme, start: f64) -> ProgrammeRun {
        let inertia = self.motor.map_or(0.0, |m| m.inertia);
        let friction = self.motor.map_or(0.0, |m| m.friction);
        let (angle, acceleration) = (programme.angles(start), programme.accelerations());
        let rows = angle.iter().zip(&programme.speed).zip(&acceleration);
        let (force_n, torque): (Vec<f64>, Vec<f64>) = rows
            .map(|((angle, speed), acceleration)| {
                let at = self.motion(*angle);
                let force = force(&self.drive, at, *speed, *acceleration);
                let load = self.contact.torque(self.friction, at, force);
                (force, load + friction + inertia * acceleration)
            })
            .unzip();
        self.run(
            programme,
            angle,
            programme.speed.clone(),
            acceleration,
            force_n,
            torque,
        )
    }

    fn run(
        &self,
        programme: &SpeedProgramme,
        angle: Vec<f64>,
        speed: Vec<f64>,
        acceleration: Vec<f64>,
        force: Vec<f64>,
        torque: Vec<f64>,
    ) -> ProgrammeRun {
        let rows = angle.iter().zip(&speed).zip(&acceleration);
        let (follower_velocity, follower_acceleration) = rows
            .map(|((angle, speed), acceleration)| {
                let at = self.motion(*angle);
                (at.v * speed, at.a * speed * speed + at.v * acceleration)
            })
            .unzip();
        ProgrammeRun {
            time_s: programme.time_s.clone(),
            follower_velocity,
            follower_acceleration,
            angle,
            speed,
            acceleration,
            contact_lost: !self.held && force.iter().any(|f| *f < 0.0),
            force_n: force.iter().map(|f| self.drive.newtons(*f)).collect(),
            torque,
        }
    }

    /// No-load speed of the motor at the rows of a prescribed run, rad/s. At this speed, the torque of the motor equals the torque of the
    /// run. Without a motor, the result is the speed of the run.
    ///
    /// # Errors
    /// The motor does not reach the torque or the no-load speed.
    pub(super) fn command(&self, run: &ProgrammeRun) -> Result<Vec<f64>> {
        let Some(motor) = self.motor else {
            return Ok(run.speed.clone());
        };
        let rows = run.speed.iter().zip(&run.torque).zip(&run.time_s);
        rows.map(|((speed, torque), at)| {
            let command = motor.no_load_for(*speed, *torque);
            let gives = (motor.torque(*speed, command)[0] - torque).abs()
                <= SAME_TORQUE * torque.abs().max(1e-3);
            match gives && command > 0.0 && motor.nominal.is_none_or(|most| command <= most) {
                true => Ok(command),
                false => Err(DynamicsError::ProgrammeMotor {
                    torque: Quantity::new(*torque, Dimension::Torque),
                    speed: Quantity::new(*speed, Dimension::AngularSpeed),
                    at: Quantity::new(*at, Dimension::Time),
                }
                .into()),
            }
        })
        .collect()
    }

    /// Angular acceleration, rad/s², contact force, N, and torque of the motor, N·m, at a cam angle, a speed and a commanded no-load speed,
    /// rad/s.
    fn under(&self, motor: &Motor, angle: f64, speed: f64, command: f64) -> [f64; 3] {
        let at = self.motion(angle);
        let torque = motor.torque(speed, command)[0];
        let still = force(&self.drive, at, speed, 0.0);
        let of = |sign: f64| {
            let arm = sign * self.contact.torque(self.friction, at, sign);
            let inertia = motor.inertia + arm * self.drive.mass * at.v;
            (torque - motor.friction - arm * still) / inertia
        };
        let mut acceleration = of(1.0);
        if still + self.drive.mass * acceleration * at.v < 0.0 {
            acceleration = of(-1.0);
        }
        [
            acceleration,
            still + self.drive.mass * acceleration * at.v,
            torque,
        ]
    }

    /// Simulates the run of a motor with the programme as its commanded no-load speed, by the classical Runge–Kutta method. The programme
    /// is simulated twice in succession, and the second run is returned.
    ///
    /// # Errors
    /// The shaft stops.
    fn commanded(
        &self,
        motor: &Motor,
        programme: &SpeedProgramme,
        start: f64,
    ) -> Result<ProgrammeRun> {
        let mut speed = programme.speed[0];
        let mut rows = Vec::new();
        for _ in 0..2 {
            rows.clear();
            let mut angle = start;
            let steps = programme.time_s.windows(2).zip(programme.speed.windows(2));
            rows.push((
                angle,
                speed,
                self.under(motor, angle, speed, programme.speed[0]),
            ));
            for (time, command) in steps {
                let width = time[1] - time[0];
                let slope = -motor.torque(speed, command[0])[1];
                let count = (PER_TIME_CONSTANT * width * slope / motor.inertia).ceil();
                let count = count.clamp(SUBSTEPS[0], SUBSTEPS[1]);
                let h = width / count;
                for k in 0..count as usize {
                    let at = |part: f64| {
                        let part = (k as f64 + part) / count;
                        command[0] + part * (command[1] - command[0])
                    };
                    let rate = |angle: f64, speed: f64, part: f64| {
                        self.under(motor, angle, speed, at(part))[0]
                    };
                    let a = rate(angle, speed, 0.0);
                    let b = rate(angle + 0.5 * h * speed, speed + 0.5 * h * a, 0.5);
                    let w = speed + 0.5 * h * a;
                    let c = rate(angle + 0.5 * h * w, speed + 0.5 * h * b, 0.5);
                    let x = speed + 0.5 * h * b;
                    let d = rate(angle + h * x, speed + h * c, 1.0);
                    angle += h * (speed + h * (a + b + c) / 6.0);
                    speed += h * (a + 2.0 * b + 2.0 * c + d) / 6.0;
                }
                if !(speed > 0.0 && speed.is_finite()) {
                    let at = Quantity::new(time[1], Dimension::Time);
                    return Err(DynamicsError::ProgrammeStops { at }.into());
                }
                rows.push((angle, speed, self.under(motor, angle, speed, command[1])));
            }
        }
        let of = |k: usize| rows.iter().map(|row| row.2[k]).collect::<Vec<f64>>();
        let angle = rows.iter().map(|row| row.0).collect();
        let speed = rows.iter().map(|row| row.1).collect();
        Ok(self.run(programme, angle, speed, of(0), of(1), of(2)))
    }
}
