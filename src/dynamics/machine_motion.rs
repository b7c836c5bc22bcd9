//! Steady motion of a machine and its cam: motion of the motor-driven shaft and of the floor. The speed changes the force over time, and the force
//! moves the floor. The acceleration of the floor changes the force and the shaft torque. Both motions are computed alternately until they agree
//! (theory §10).

use std::f64::consts::TAU;

use super::fixed_point::{Round, settled};
use super::floor::{Floor, Term, harmonics};
use super::rigid::touch::FollowerContact;
use super::shaft::{Cubic, Load, Motion, Node, force, periodic};
use crate::cam::{Cam, Follower};
use crate::drive::{Drive, Motor};
use crate::error::{DynamicsError, Placed, Result};
use crate::law::Svaj;
use crate::poly::samples;

/// Number of equal parts of the period for the force on the floor and the motion of the floor.
const SAMPLES: usize = 720;
const FINE: usize = 4 * SAMPLES;
/// Change of M z″ (mass times acceleration of the floor) in one iteration, relative to the force at rest. Below this value, the motions of
/// shaft and floor count as consistent.
const SAME: f64 = 1e-9;
const UNSETTLED: f64 = 1e-6;

/// Drive, motor, floor and follower of a machine, with the force of a walker.
#[derive(Clone)]
pub struct Carrier<'a> {
    /// Drive of the machine: relation of lift and force.
    pub drive: Drive,
    /// Motor of the shaft; `None` for constant speed.
    pub motor: Option<&'a Motor>,
    /// Floor below the mass; `None` for a rigid floor.
    pub floor: Option<&'a Floor>,
    /// Harmonics of the force of one of the other walkers over the period, N.
    pub walker: Vec<Term>,
    /// Follower of the cam.
    pub follower: Follower,
    /// Coefficient of sliding friction of the follower.
    pub friction: f64,
    /// Number of equal parts of the turn at whose ends integration steps of the shaft motion end. Further steps end at the breaks of the law.
    pub steps: usize,
}

/// Steady motion of shaft and floor.
#[derive(Debug, Clone)]
pub struct MachineMotion {
    /// Motion of the shaft over one turn.
    pub shaft: Motion,
    /// Harmonics of the acceleration of the floor over the period, m/s²; empty for a rigid floor.
    pub floor: Vec<Term>,
    /// Acceleration of the floor at equal parts of the period, m/s².
    at_parts: Vec<f64>,
}

impl MachineMotion {
    /// Motion of a shaft on a floor with the given harmonics of acceleration.
    pub fn new(shaft: Motion, floor: Vec<Term>) -> MachineMotion {
        let at_parts = match floor.is_empty() {
            true => Vec::new(),
            false => samples(&floor, 0, FINE),
        };
        MachineMotion {
            shaft,
            floor,
            at_parts,
        }
    }

    /// Acceleration of the floor, m/s², at a cam angle measured from the first cam angle, rad.
    pub fn floor_at(&self, angle: f64) -> f64 {
        match self.at_parts.is_empty() {
            true => 0.0,
            false => Cubic(&self.at_parts).at(self.shaft.phase(angle)[0] / TAU).0,
        }
    }
}

/// Drive, motor, floor and friction of a machine.
#[derive(Clone, Copy)]
pub struct Parts<'a> {
    /// Relation of lift and force, and mean speed.
    pub drive: Drive,
    /// Motor of the shaft; `None` for constant speed.
    pub motor: Option<&'a Motor>,
    /// Floor below the mass; `None` for a rigid floor.
    pub floor: Option<&'a Floor>,
    /// Coefficient of sliding friction of the follower.
    pub friction: f64,
}

impl<'a> Carrier<'a> {
    /// Creates the machine of a cam. With a floor, `walker` returns the force of one walker at equal parts of the period, N. Without a
    /// floor, it is not called.
    ///
    /// # Errors
    ///
    /// A motor with a cam whose law is not one turn, or invalid motor data.
    pub fn new(
        cam: &Cam,
        parts: Parts<'a>,
        walker: impl FnOnce() -> Vec<f64>,
        steps: usize,
    ) -> Result<Self> {
        if let Some(motor) = parts.motor {
            if !cam.law.is_closed() || cam.law.extent() != (0.0, TAU) {
                return Err(DynamicsError::MotorTurns.into());
            }
            if parts.drive.speed == 0.0 || !parts.drive.speed.is_finite() || !motor.is_sound() {
                return Err(DynamicsError::Motor.into());
            }
        }
        let forces = parts.floor.map(|_| walker()).unwrap_or_default();
        let walker = match forces.is_empty() {
            true => Vec::new(),
            false => harmonics(&forces),
        };
        Ok(Carrier {
            drive: parts.drive,
            motor: parts.motor,
            floor: parts.floor,
            walker,
            follower: cam.follower,
            friction: parts.friction,
            steps,
        })
    }
}

impl Carrier<'_> {
    /// Torque of the shaft per unit of positive and of negative contact force, m.
    pub fn arms(&self, at: Svaj) -> [f64; 2] {
        let contact = FollowerContact::of(&self.follower);
        [1.0, -1.0].map(|force| force * contact.torque(self.friction, at, force))
    }

    /// Load of the shaft over a turn from the cam angle `start`, rad. `at` is the motion of the follower at a cam angle. It is smooth
    /// between `breaks`. `floor` is the acceleration of the floor, m/s², at an angle measured from `start`, rad.
    pub fn load(
        &self,
        start: f64,
        breaks: &[f64],
        at: &dyn Fn(f64) -> Svaj,
        floor: &dyn Fn(f64) -> f64,
    ) -> Load {
        Load::of((start, TAU), breaks, self.steps, &|angle| {
            let at = at(angle);
            Node::new(&self.drive, at, self.arms(at), floor(angle - start))
        })
    }

    /// Steady motion of shaft and floor under the load of the cam. `at` is the motion of the follower at a cam angle. `near` is an optional
    /// initial guess.
    ///
    /// # Errors
    ///
    /// The shaft stops; an undamped mode is at resonance; the motions of shaft and floor do not agree.
    pub fn motion(
        &self,
        start: f64,
        breaks: &[f64],
        at: &dyn Fn(f64) -> Svaj,
        near: Option<&MachineMotion>,
    ) -> Result<MachineMotion> {
        let on = |floor: &dyn Fn(f64) -> f64| -> Result<Motion> {
            let Some(motor) = self.motor else {
                return Ok(Motion::even(self.drive.speed));
            };
            let load = self.load(start, breaks, at, floor);
            periodic(load, motor, self.drive.speed, near.map(|m| &m.shaft))
        };
        let Some(floor) = self.floor else {
            return Ok(MachineMotion::new(on(&|_| 0.0)?, Vec::new()));
        };
        let under = |shaft: Motion| -> Result<MachineMotion> {
            let terms = self.on_floor(floor, &shaft, &|angle| at(start + angle))?;
            Ok(MachineMotion::new(shaft, terms))
        };
        if self.motor.is_none() {
            return under(on(&|_| 0.0)?);
        }
        let unit = self.drive.rest_force;
        let angle = |i: usize| TAU * i as f64 / SAMPLES as f64;
        let state = |motion: &MachineMotion| -> Vec<f64> {
            let part = |i| self.drive.mass * motion.floor_at(angle(i)) / unit;
            (0..SAMPLES).map(part).collect()
        };
        let first = near.map_or_else(|| vec![0.0; SAMPLES], state);
        let found = settled(first, SAME, |given| {
            let cubic = Cubic(given);
            let floor = |angle: f64| cubic.at(angle / TAU).0 * unit / self.drive.mass;
            let motion = under(on(&floor)?)?;
            Ok(Round {
                made: state(&motion),
                has_law: true,
                design: motion,
            })
        })?;
        if found.difference > UNSETTLED {
            return Err(DynamicsError::FloorAndShaft.at_key("machine.floor"));
        }
        Ok(found.design)
    }

    /// Harmonics of the acceleration of the floor, m/s², for a motion of the shaft and the motion `at` of the follower at a cam angle.
    fn on_floor(
        &self,
        floor: &Floor,
        shaft: &Motion,
        at: &dyn Fn(f64) -> Svaj,
    ) -> Result<Vec<Term>> {
        let still = |i: usize| {
            let angle = shaft.angle(TAU * i as f64 / SAMPLES as f64);
            let [speed, acceleration, _] = shaft.speed_at(angle);
            force(&self.drive, at(angle), speed, acceleration)
        };
        let still = harmonics(&(0..SAMPLES).map(still).collect::<Vec<_>>());
        let mut others = floor.of_walkers(1, &self.walker);
        others.resize(still.len(), (0.0, 0.0));
        let (mass, speed) = (self.drive.mass, self.drive.speed);
        let own = floor.pressed(mass, speed, &still, &others)?;
        let all = own.iter().zip(&others).map(|(a, b)| (a.0 + b.0, a.1 + b.1));
        floor.acceleration(speed, &all.collect::<Vec<_>>())
    }
}
