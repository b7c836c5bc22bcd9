//! The speed of the camshaft over time: as a recorded walk has its steps, and the force of a cam that follows it.

use std::f64::consts::TAU;

use super::mode::{Misfit, RepeatedForce};
use super::spline::Periodic;
use crate::drive::{Drive, Motor};
use crate::dynamics::recover::{Cycle, recover_cam};
use crate::dynamics::rigid::touch::{FollowerContact, held};
use crate::dynamics::run::Run;
use crate::dynamics::shaft::force;
use crate::error::{DynamicsError, Result};
use crate::force::Walk;
use crate::law::{Law, Svaj};
use crate::units::{Dimension, Quantity};

/// Smoothing relative to the cube of a step time that leaves a speed practically constant, and that which changes nothing.
const SMOOTHEST: f64 = 1e9;
const LEAST: f64 = 1e-6;
/// Number of halvings of the smoothing on its logarithmic scale.
const HALVINGS: usize = 24;
/// Minimum and maximum number of steps of the shaft between two rows, and its steps per time constant of the motor.
const SUBSTEPS: [f64; 2] = [2.0, 256.0];
const PER_TIME_CONSTANT: f64 = 4.0;
/// Relative difference of the motor's torque from the required one above which it cannot follow.
const SAME_TORQUE: f64 = 1e-6;

/// The speed of the camshaft over time, linear between its rows.
///
/// ```
/// use gaitcam::dynamics::SpeedProgramme;
///
/// let even = SpeedProgramme::new(vec![0.0, 1.0, 2.0], vec![3.0, 3.0, 3.0])?;
/// assert_eq!(even.angles(0.5), [0.5, 3.5, 6.5]);
/// assert!(SpeedProgramme::new(vec![0.0, 1.0, 1.0], vec![3.0, 3.0, 3.0]).is_err());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedProgramme {
    /// Times, s, increasing.
    pub time_s: Vec<f64>,
    /// Speed at these times, rad/s; the last one belongs to the end of the programme.
    pub speed: Vec<f64>,
}

/// A cam that follows a programme, at the times of its rows.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{ProgrammeRun, Run, SpeedProgramme};
/// use gaitcam::law::Law;
///
/// // An eccentric of 10 mm under 10 kg at constant speed: M (g − e ω² sin θ).
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// let even = SpeedProgramme::new(vec![0.0, 0.5, 1.0], vec![5.0; 3])?;
/// let found = ProgrammeRun::new(&run, &even, 0.0)?;
/// assert!((found.force_n[1] - (98.1 - 2.5 * 2.5_f64.sin())).abs() < 1e-3);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ProgrammeRun {
    /// Times, s.
    pub time_s: Vec<f64>,
    /// Cam angle, rad, which counts the turns.
    pub angle: Vec<f64>,
    /// Speed of the camshaft, rad/s.
    pub speed: Vec<f64>,
    /// Angular acceleration, rad/s².
    pub acceleration: Vec<f64>,
    /// Contact force, N; for an arm, divided by its lever.
    pub force_n: Vec<f64>,
    /// Torque at the camshaft, N·m: of the motor if there is one, otherwise of the load.
    pub torque: Vec<f64>,
    /// Whether the follower leaves the cam.
    pub contact_lost: bool,
}

impl SpeedProgramme {
    /// A programme of at least three rows.
    ///
    /// # Errors
    /// Fewer rows, times that do not increase, or speeds that are not positive.
    pub fn new(time_s: Vec<f64>, speed: Vec<f64>) -> Result<SpeedProgramme> {
        let rows = time_s.len().min(speed.len());
        if rows < 3 {
            return Err(DynamicsError::FewProgrammeRows { rows }.into());
        }
        let finite = |row: &usize| time_s[*row].is_finite() && speed[*row].is_finite();
        let later = |row: usize| row == 0 || time_s[row] > time_s[row - 1];
        let sound = |row: &usize| finite(row) && later(*row) && speed[*row] > 0.0;
        if let Some(row) = (0..rows).find(|row| !sound(row)) {
            return Err(DynamicsError::ProgrammeRow { row: row + 1 }.into());
        }
        Ok(SpeedProgramme { time_s, speed })
    }

    /// Cam angle at the rows, rad, from its first value on.
    pub fn angles(&self, start: f64) -> Vec<f64> {
        let mut angle = start;
        let steps = self.time_s.windows(2).zip(self.speed.windows(2));
        let next = steps.map(|(t, w)| {
            angle += 0.5 * (t[1] - t[0]) * (w[0] + w[1]);
            angle
        });
        std::iter::once(start).chain(next).collect()
    }

    /// Acceleration at the rows, rad/s²: the mean of both sides.
    fn accelerations(&self) -> Vec<f64> {
        let steps = self.time_s.windows(2).zip(self.speed.windows(2));
        let slopes: Vec<f64> = steps.map(|(t, w)| (w[1] - w[0]) / (t[1] - t[0])).collect();
        let last = slopes.len() - 1;
        (0..=last + 1)
            .map(|i| 0.5 * (slopes[i.max(1) - 1] + slopes[i.min(last)]))
            .collect()
    }

    /// Duration, s.
    pub fn duration_s(&self) -> f64 {
        self.time_s[self.time_s.len() - 1] - self.time_s[0]
    }
}

/// What a programme has to keep.
///
/// ```
/// use gaitcam::dynamics::Bounds;
///
/// let free = Bounds { acceleration: f64::INFINITY, force_min: 0.0 };
/// assert!(free.acceleration > 10.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Largest angular acceleration, rad/s².
    pub acceleration: f64,
    /// Smallest contact force, N.
    pub force_min: f64,
}

/// A programme for a recorded walk.
///
/// ```
/// use gaitcam::dynamics::{Bounds, Followed};
/// use gaitcam::force::{Feet, ReadOptions, force_curve};
/// use gaitcam::scene;
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/data/recordings/made_walk.csv"));
/// let force = force_curve("walk.csv".as_ref(), bytes, &ReadOptions::default(), Feet::Both)?;
/// let scene = scene::parse("gait.file = \"walk.csv\"")?;
/// let design = scene.design_for(&force)?;
/// let walk = design.walk().unwrap();
/// let run = design.emitted(&scene.machine, design.problem.drive)?;
/// let bounds = Bounds { acceleration: 50.0, force_min: 0.0 };
/// let found = Followed::new(&run, &walk, 2, 0.0, walk.middle(), bounds)?;
/// // The nine strides have the recorded step times, and nearly the recorded response.
/// assert!(found.step_error_s < 1e-9 && found.misfits[1].misfit < 0.05);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// The programme: the speed of the shaft, or with a motor its no-load speed.
    pub programme: SpeedProgramme,
    /// The cam that follows the programme.
    pub run: ProgrammeRun,
    /// The recorded force at the rows, N.
    pub recorded_n: Vec<f64>,
    /// Differences of the response from that to the recorded force.
    pub misfits: [Misfit; 3],
    /// Largest deviation of a step of the programme from the recorded one, s.
    pub step_error_s: f64,
    /// Root mean square of the difference of the forces, N.
    pub rms_error_n: f64,
}

/// Cam angles of the heel strikes of a walk, rad, increasing; a turn is a stride of two steps, or one step. The heel strike that begins the cycle of the
/// force is at the angle `first`, that of the other foot at the fraction `middle` of a stride.
fn strike_angles(walk: &Walk, steps_per_turn: usize, first: f64, middle: f64) -> Vec<f64> {
    let angle = |i: usize| match steps_per_turn {
        1 => TAU * i as f64,
        _ => TAU * ((i / 2) as f64 + if i % 2 == 1 { middle } else { 0.0 }),
    };
    (0..walk.steps_s.len()).map(|i| first + angle(i)).collect()
}

impl SpeedProgramme {
    /// Times of the rows of a walk: those of its force, and its end.
    fn times(walk: &Walk) -> Vec<f64> {
        let count = walk.samples();
        let at = |i: usize| walk.duration_s * i as f64 / count as f64;
        (0..=count).map(at).collect()
    }

    /// The programme that passes a cam angle at each heel strike, smoothed, with the angle of its first row.
    fn of(walk: &Walk, angles: &[f64], turns: f64, lambda: f64) -> (SpeedProgramme, f64, Periodic) {
        let mean = TAU * turns / walk.duration_s;
        let off = angles.iter().zip(&walk.steps_s);
        let off: Vec<f64> = off.map(|(angle, t)| angle - mean * t).collect();
        let spline = Periodic::smoothed(&walk.steps_s, &off, walk.duration_s, lambda);
        let time_s = SpeedProgramme::times(walk);
        let speed = time_s.iter().map(|t| mean + spline.at(*t)[1]).collect();
        (SpeedProgramme { time_s, speed }, spline.at(0.0)[0], spline)
    }
}

impl Followed {
    /// The speed with which a cam has the step times of a walk, as little smoothed as the bounds and the motor require. `steps_per_turn` is 1 or 2; the
    /// cycle of the cam's force begins at the cam angle `first`, and the other foot strikes at the fraction `middle` of it.
    ///
    /// # Errors
    /// A cam that breaks a bound even at constant speed, a motor that cannot follow; a cam or machine without a rigid run.
    pub fn new(
        run: &Run,
        walk: &Walk,
        steps_per_turn: usize,
        first: f64,
        middle: f64,
        bounds: Bounds,
    ) -> Result<Followed> {
        let follower = Follower::new(run)?;
        let angles = strike_angles(walk, steps_per_turn, first, middle);
        let turns = walk.steps_s.len() as f64 / steps_per_turn as f64;
        let unit = (0.5 * walk.duration_s / walk.strides() as f64).powi(3);
        let of = |lambda: f64| SpeedProgramme::of(walk, &angles, turns, lambda * unit);
        let keeps = |lambda: f64| -> Result<()> {
            let (programme, start, spline) = of(lambda);
            let slowest = programme
                .speed
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min);
            let run = follower.prescribed(&programme, start);
            let least = run.force_n.iter().copied().fold(f64::INFINITY, f64::min);
            if spline.most_bend() > bounds.acceleration || slowest <= 0.0 {
                let most = Quantity::new(bounds.acceleration, Dimension::AngularAcceleration);
                return Err(DynamicsError::ProgrammeAcceleration { most }.into());
            }
            if least < bounds.force_min {
                let [least, limit] = [least, bounds.force_min].map(Quantity::force);
                return Err(DynamicsError::ProgrammeContact { least, limit }.into());
            }
            follower.command(&run).map(drop)
        };
        let lambda = match keeps(0.0) {
            Ok(()) => 0.0,
            Err(_) => {
                keeps(SMOOTHEST)?;
                let (mut low, mut high) = (LEAST.ln(), SMOOTHEST.ln());
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    match keeps(middle.exp()) {
                        Ok(()) => high = middle,
                        Err(_) => low = middle,
                    }
                }
                high.exp()
            }
        };
        let (speed, start, spline) = of(lambda);
        let run = follower.prescribed(&speed, start);
        let mean = TAU * turns / walk.duration_s;
        let step_error = walk.steps_s.iter().zip(&angles).map(|(t, angle)| {
            let [off, rate, _] = spline.at(*t);
            ((mean * t + off - angle) / (mean + rate)).abs()
        });
        let step_error_s = step_error.fold(0.0, f64::max);
        let mut recorded_n = walk.force_n();
        recorded_n.push(recorded_n[0]);
        let programme = SpeedProgramme {
            speed: follower.command(&run)?,
            time_s: speed.time_s,
        };
        Ok(Followed {
            misfits: run.misfits(&recorded_n, walk.strides()),
            rms_error_n: run.rms_error(&recorded_n),
            programme,
            run,
            recorded_n,
            step_error_s,
        })
    }
}

impl ProgrammeRun {
    /// The run of the emitted cam that follows a programme, from a cam angle on; with a motor its speed is commanded, without one it is that of the
    /// shaft. The model is rigid.
    ///
    /// # Errors
    /// A cam that is not closed, an emitted profile without smooth lift, a motor whose shaft stops.
    pub fn new(run: &Run, programme: &SpeedProgramme, start: f64) -> Result<ProgrammeRun> {
        let follower = Follower::new(run)?;
        match follower.motor {
            None => Ok(follower.prescribed(programme, start)),
            Some(motor) => follower.commanded(motor, programme, start),
        }
    }

    /// Differences of the response from that to a force, N, at the rows, which contain so many strides; the last row repeats the first.
    pub fn misfits(&self, recorded_n: &[f64], strides: usize) -> [Misfit; 3] {
        let last = self.time_s.len() - 1;
        let duration = self.time_s[last] - self.time_s[0];
        let of = |force: &[f64]| RepeatedForce::new(&force[..last], duration, strides);
        of(recorded_n).misfits(&of(&self.force_n))
    }

    /// Root mean square of the difference from a force, N, at the rows.
    pub fn rms_error(&self, recorded_n: &[f64]) -> f64 {
        let off = self.force_n.iter().zip(recorded_n).skip(1);
        let square: f64 = off.map(|(a, b)| (a - b).powi(2)).sum();
        (square / (self.force_n.len() - 1) as f64).sqrt()
    }
}

/// The rigid follower of an emitted cam.
struct Follower<'a> {
    law: Law,
    drive: Drive,
    contact: FollowerContact,
    friction: f64,
    motor: Option<&'a Motor>,
    held: bool,
}

impl<'a> Follower<'a> {
    fn new(run: &'a Run) -> Result<Follower<'a>> {
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

    /// The run at a prescribed speed.
    fn prescribed(&self, programme: &SpeedProgramme, start: f64) -> ProgrammeRun {
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
        ProgrammeRun {
            time_s: programme.time_s.clone(),
            angle,
            speed,
            acceleration,
            contact_lost: !self.held && force.iter().any(|f| *f < 0.0),
            force_n: force.iter().map(|f| self.drive.newtons(*f)).collect(),
            torque,
        }
    }

    /// No-load speed of the motor at the rows of a prescribed run, rad/s, with which the motor gives its torque; its speed without a motor.
    ///
    /// # Errors
    /// A motor that does not reach the torque or the no-load speed.
    fn command(&self, run: &ProgrammeRun) -> Result<Vec<f64>> {
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

    /// Angular acceleration, rad/s², contact force, N, and torque of the motor, N·m, at an angle and a speed under a commanded speed.
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

    /// The run of a motor under a commanded speed: the second of two consecutive passes, by the classical Runge–Kutta method.
    ///
    /// # Errors
    /// A shaft that stops.
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
