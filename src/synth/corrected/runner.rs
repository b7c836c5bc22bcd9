//! Runs of a law on its shaft: speed, force error over time, and what another inertia or motor would make of them.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::cam::{Follower, LimitKind};
use crate::drive::{Drive, Motor};
use crate::dynamics::InTime;
use crate::dynamics::rigid::touch::{rubs, touch};
use crate::dynamics::shaft::{Load, Motion, Node, error_in_time, force, periodic};
use crate::error::{DynamicsError, Placed, Result};
use crate::law::{Law, Svaj};
use crate::problem::{Note, Problem};
use crate::scene::Minimise;
use crate::synth::design::Design;
use crate::synth::qp::TOLERANCE;
use crate::units::{Dimension, Quantity};

/// Equal angles at which speed and force are given.
pub const ROWS: usize = 240;
/// Steps of the motion between the breaks of the law.
const STEPS: usize = 48;
/// Rounds of the speed alone, before the first design, and the relative change of speed at which they end.
const SPEED_ROUNDS: usize = 12;
const SAME_SPEED: f64 = 1e-5;
/// Part of the accuracy, without one of the mean force, below which a forecast change of the force is neglected.
const NEGLECTED: f64 = 0.2;
const NEGLECTED_OF_MEAN: f64 = 1e-3;
/// Part by which inertia, torque line and friction may differ from what is given.
const DEVIATION: f64 = 0.1;
/// An inertia that meets the accuracy is sought up to this factor, to this part.
const LARGEST_FACTOR: f64 = 1e6;
const INERTIA_PART: f64 = 1e-4;

/// Ripple and change of the force by a varying speed, estimated from inertia and the energy that swings.
///
/// ```
/// use gaitcam::{scene, synthesise};
///
/// // A wheel of 500 kg m²: the speed hardly ripples, and the law is that for constant speed.
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
    /// Highest less lowest speed, part of the mean.
    pub ripple: f64,
    /// RMS change of the force, percent of its mean.
    pub force_change_percent_of_mean: f64,
    /// What is neglected, percent of the mean.
    pub neglected_percent_of_mean: f64,
    /// Whether a constant speed is enough.
    pub is_negligible: bool,
}

/// Force error of the cam on another machine.
///
/// ```
/// use gaitcam::synth::Sensitivity;
///
/// // It does not turn with 10 % less of the inertia.
/// let wheel = Sensitivity { key: "machine.inertia", percent: [None, Some(0.4)] };
/// assert_eq!(serde_json::to_value(&wheel).unwrap()["percent"][1], 0.4);
/// ```
#[derive(Debug, Clone, Serialize)]
pub struct Sensitivity {
    /// Key of what differs.
    pub key: &'static str,
    /// Force error with 10 % less and 10 % more, percent of the mean.
    pub percent: [Option<f64>; 2],
}

/// Runs laws of a design on its shaft.
pub struct Runner<'a> {
    pub follower: Follower,
    pub motor: &'a Motor,
    pub drive: Drive,
    pub target: Option<Vec<f64>>,
    pub friction: f64,
}

impl<'a> Runner<'a> {
    pub fn new(design: &Design, motor: &'a Motor) -> Result<Self> {
        let drive = design.drive;
        let law = &design.cam.law;
        if !law.is_closed() || law.extent() != (0.0, TAU) || drive.speed <= 0.0 {
            return Err(DynamicsError::MotorTurns.at_key("machine.motor"));
        }
        // That of a finished design is by the cam angle.
        let on_shaft = design
            .shaft
            .as_ref()
            .and_then(|shaft| shaft.target.as_ref());
        let target = on_shaft.or(design.problem.target.as_ref().map(|t| &*t.curve));
        let target = target.map(|curve| (0..ROWS).map(|i| curve.at(angle(i))).collect());
        Ok(Runner {
            follower: design.cam.follower,
            friction: design.problem.machine.friction,
            motor,
            drive,
            target,
        })
    }

    pub fn arms(&self, at: Svaj) -> [f64; 2] {
        let mu = self.friction;
        match mu > 0.0 && rubs(&self.follower) {
            false => [at.v; 2],
            true => [1.0, -1.0].map(|f| f * touch(&self.follower, 1.0, mu, at, f).torque),
        }
    }

    /// The load of a motion over the turn.
    pub fn load(&self, breaks: &[f64], at: &dyn Fn(f64) -> Svaj) -> Load {
        Load::of((0.0, TAU), breaks, STEPS, &|x| {
            let at = at(x);
            Node::new(&self.drive, at, self.arms(at))
        })
    }

    pub fn load_of_law(&self, law: &Law) -> Load {
        self.load(law.breaks(), &|x| law.svaj(x))
    }

    /// The motion of the shaft under a law.
    pub fn of_law(&self, law: &Law, near: Option<&Motion>) -> Result<Motion> {
        self.run(&self.load_of_law(law), near)
    }

    pub fn run(&self, load: &Load, near: Option<&Motion>) -> Result<Motion> {
        let run = periodic(load, self.motor, self.drive.speed, near);
        run.map_err(|e| e.at_key("machine.motor"))
    }

    /// The motion of the shaft under the motion in time that a law makes at constant speed.
    pub fn in_time(&self, law: &Law, first: Motion) -> Result<Motion> {
        let mut clock = first;
        for _ in 0..SPEED_ROUNDS {
            let load = self.load(&[], &|x| retimed(law, &clock, x));
            let next = self.run(&load, Some(&clock))?;
            let change =
                |i: usize| (next.speed_at(angle(i))[0] - clock.speed_at(angle(i))[0]).abs();
            let change = (0..ROWS).step_by(4).map(change).fold(0.0, f64::max);
            clock = next;
            if change < SAME_SPEED * self.drive.speed {
                break;
            }
        }
        Ok(clock)
    }

    /// Speed at the equal angles, rad/s.
    pub fn speed(&self, clock: &Motion) -> Vec<f64> {
        (0..ROWS).map(|i| clock.speed_at(angle(i))[0]).collect()
    }

    /// Time at the equal angles, s.
    pub fn time(&self, clock: &Motion) -> Vec<f64> {
        let phase = |i: usize| clock.phase(angle(i))[0];
        (0..ROWS).map(|i| phase(i) / self.drive.speed).collect()
    }

    /// Force error over time of a law under its clock.
    pub fn error(&self, law: &Law, clock: &Motion) -> Option<InTime> {
        let target = self.target.as_ref()?;
        let at = |i: usize| {
            let [speed, acceleration, _] = clock.speed_at(angle(i));
            force(&self.drive, law.svaj(angle(i)), speed, acceleration)
        };
        let forces: Vec<f64> = (0..ROWS).map(at).collect();
        let period = TAU / self.drive.speed;
        let (speed, time) = (self.speed(clock), self.time(clock));
        Some(error_in_time(&forces, &speed, &time, period, target))
    }

    /// What inertia and energy of the load say of a law for constant speed.
    pub fn forecast(&self, problem: &Problem, law: &Law) -> Forecast {
        let load = self.load_of_law(law);
        let (ripple, change) = load.forecast(self.motor.inertia, self.drive.speed);
        let allowed = problem.allowed_error().zip(self.target.as_ref());
        let neglected = allowed.map_or(NEGLECTED_OF_MEAN, |(most, _)| {
            NEGLECTED * most / problem.target_mean()
        });
        Forecast {
            ripple,
            force_change_percent_of_mean: 100.0 * change,
            neglected_percent_of_mean: 100.0 * neglected,
            is_negligible: change <= neglected && !depends_on_speed(problem),
        }
    }

    /// Force error over time of a law with another motor or wheel, percent of the mean.
    pub fn error_with(&self, load: &Load, law: &Law, motor: &Motor) -> Option<f64> {
        let clock = periodic(load, motor, self.drive.speed, None).ok()?;
        Some(self.error(law, &clock)?.rms_error_percent_of_mean)
    }

    /// The smallest inertia with which a law meets the accuracy over time, where its own does not.
    pub fn inertia_note(&self, problem: &Problem, law: &Law, own: Option<InTime>) -> Option<Note> {
        let allowed = 100.0 * problem.allowed_error()? / problem.target_mean();
        let error = own?.rms_error_percent_of_mean;
        if error <= allowed * (1.0 + TOLERANCE) {
            return None;
        }
        let load = self.load_of_law(law);
        let meets = |inertia: f64| {
            let wheel = Motor {
                inertia,
                ..self.motor.clone()
            };
            let error = self.error_with(&load, law, &wheel);
            error.is_some_and(|error| error <= allowed)
        };
        let own = self.motor.inertia;
        let mut range = [own, own];
        while !meets(range[1]) {
            range = [range[1], 2.0 * range[1]];
            if range[1] > LARGEST_FACTOR * own {
                return None;
            }
        }
        while range[1] > (1.0 + INERTIA_PART) * range[0] {
            let middle = (range[0] * range[1]).sqrt();
            range[usize::from(meets(middle))] = middle;
        }
        let inertia = Quantity::new(range[1], Dimension::Inertia);
        let [error, allowed] = [error, allowed].map(|percent| Quantity::share(0.01 * percent));
        Some(Note::InertiaForAccuracy {
            error,
            allowed,
            inertia,
        })
    }

    /// Force error of a law where the machine differs.
    pub fn sensitivity(&self, law: &Law) -> Vec<Sensitivity> {
        let load = self.load_of_law(law);
        let both = |key, changed: &dyn Fn(f64) -> Motor| Sensitivity {
            key,
            percent: [1.0 - DEVIATION, 1.0 + DEVIATION]
                .map(|part| self.error_with(&load, law, &changed(part))),
        };
        let free = Motor {
            nominal: None,
            ..self.motor.clone()
        };
        let inertia = |part: f64| Motor {
            inertia: part * free.inertia,
            ..free.clone()
        };
        let line = |part: f64| free.with_torque(part);
        let friction = |part: f64| Motor {
            friction: part * free.friction,
            ..free.clone()
        };
        let mut out = vec![
            both("machine.inertia", &inertia),
            both("machine.motor", &line),
        ];
        if free.friction > 0.0 {
            out.push(both("machine.friction_torque", &friction));
        }
        out
    }
}

/// Equal angles, rad.
pub fn angle(i: usize) -> f64 {
    TAU * i as f64 / ROWS as f64
}

/// The law that makes under a clock the motion in time that `law` makes at constant speed: s(φ(x)).
pub fn retimed(law: &Law, clock: &Motion, x: f64) -> Svaj {
    let [phase, rate, bend, third] = clock.phase(x);
    let at = law.svaj(phase);
    Svaj {
        s: at.s,
        v: at.v * rate,
        a: at.a * rate * rate + at.v * bend,
        j: at.j * rate.powi(3) + 3.0 * at.a * rate * bend + at.v * third,
    }
}

/// Whether what the speed adds is in a limit or in the objective, and not in the target alone.
pub fn depends_on_speed(problem: &Problem) -> bool {
    use LimitKind::{
        Acceleration, ForceMax, ForceMin, HertzPressure, Jerk, Power, Torque, TorqueRate, Velocity,
    };
    let kinds = [
        ForceMin,
        ForceMax,
        Velocity,
        Acceleration,
        Jerk,
        Torque,
        Power,
        TorqueRate,
        HertzPressure,
    ];
    let is_limited = kinds.into_iter().any(|kind| problem.limits[kind].is_some());
    is_limited || problem.band.is_some() || problem.objective() != Minimise::ForceError
}
