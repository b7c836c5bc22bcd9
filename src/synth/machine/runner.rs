//! Simulations of a law in its machine: speed and force error over time.

use std::f64::consts::TAU;

use crate::cam::{Cam, LimitKind};
use crate::drive::Motor;
use crate::dynamics::machine_motion::{Carrier, MachineMotion, Parts};
use crate::dynamics::shaft::{Load, Motion, error_in_time, force, forecast, periodic};
use crate::dynamics::{Floor, InTime};
use crate::error::{Placed, Result};
use crate::force::ForceCurve;
use crate::law::{Law, Svaj};
use crate::problem::Problem;
use crate::scene::Minimise;
use crate::synth::report::shaft::Forecast;

/// Number of equally spaced cam angles at which speed and force are evaluated.
pub const ROWS: usize = 240;
/// Number of equally spaced cam angles at which the force of one walker on the floor is evaluated.
const WALKER: usize = 720;
/// Number of equal parts of the turn at whose ends integration steps of the shaft motion end. Further steps end at the breaks of the law.
const STEPS: usize = 32;
/// Maximum number of iterations that determine only the speed, before the first design.
const SPEED_ROUNDS: usize = 12;
const SAME_SPEED: f64 = 3e-3;
/// Fraction of the permitted force error below which an estimated change of the force is neglected.
const NEGLECTED: f64 = 0.2;
const NEGLECTED_OF_MEAN: f64 = 1e-3;
/// Maximum ratio of a trial inertia to the given inertia in the search for a sufficient inertia.
const LARGEST_FACTOR: f64 = 1e6;
const INERTIA_PART: f64 = 1e-4;

/// Simulation of the laws of a design in the machine of the design.
#[derive(Clone)]
pub struct Runner<'a> {
    /// Drive, motor and floor of the machine.
    pub carrier: Carrier<'a>,
    /// Target force, N, at equally spaced times of the period.
    target: Option<Vec<f64>>,
    /// Learned force of the machine, N, at equally spaced angles.
    learned: Vec<f64>,
}

impl<'a> Runner<'a> {
    /// Creates the simulation of the machine of a problem. The target force is given over the period.
    pub fn new(
        problem: &Problem,
        cam: &Cam,
        target: Option<&'a ForceCurve>,
        motor: Option<&'a Motor>,
        floor: Option<&'a Floor>,
    ) -> Result<Self> {
        let at = |count: usize, curve: &ForceCurve| -> Vec<f64> {
            (0..count)
                .map(|i| curve.at(TAU * i as f64 / count as f64))
                .collect()
        };
        let parts = Parts {
            drive: problem.drive,
            motor,
            floor,
            friction: problem.machine.friction,
        };
        let walker = || target.map_or_else(Vec::new, |curve| at(WALKER, curve));
        let carrier = Carrier::new(cam, parts, walker, STEPS);
        Ok(Runner {
            carrier: carrier.map_err(|e| e.at_key("machine.motor"))?,
            target: target.map(|curve| at(ROWS, curve)),
            learned: (0..ROWS).map(|i| problem.learned_force(angle(i))).collect(),
        })
    }

    /// The same machine without a motor, at constant speed.
    pub fn evenly(&self) -> Runner<'a> {
        let mut out = self.clone();
        out.carrier.motor = None;
        out
    }

    /// Load that a law causes on the shaft, for a rigid floor.
    pub fn load_of_law(&self, law: &Law) -> Load {
        let at = |x: f64| law.svaj(x);
        self.carrier.load(0.0, law.breaks(), &at, &|_| 0.0)
    }

    /// Motion of shaft and floor for a law. The computation starts from the motion `near`, if given.
    pub fn of_law(&self, law: &Law, near: Option<&MachineMotion>) -> Result<MachineMotion> {
        let at = |x: f64| law.svaj(x);
        let motion = self.carrier.motion(0.0, law.breaks(), &at, near);
        motion.map_err(|e| e.at_key("machine.motor"))
    }

    /// Motion of shaft and floor for the target force, if the follower has the same motion in time as with `law` at constant speed.
    pub fn in_time(&self, law: &Law, first: MachineMotion) -> Result<MachineMotion> {
        let drive = &self.carrier.drive;
        let floor = match self.carrier.floor {
            Some(floor) => {
                let all = floor.of_walkers(0, &self.carrier.walker);
                floor.acceleration(drive.speed, &all)?
            }
            None => Vec::new(),
        };
        let Some(motor) = self.carrier.motor else {
            return Ok(MachineMotion::new(Motion::even(drive.speed), floor));
        };
        let mut motion = MachineMotion::new(first.shaft, floor);
        for _ in 0..SPEED_ROUNDS {
            let clock = &motion.shaft;
            let at = |x: f64| retimed(law, clock, x);
            let load = self.carrier.load(0.0, &[], &at, &|x| motion.floor_at(x));
            let next = periodic(load, motor, drive.speed, Some(clock))?;
            let change =
                |i: usize| (next.speed_at(angle(i))[0] - clock.speed_at(angle(i))[0]).abs();
            let change = (0..ROWS).step_by(10).map(change).fold(0.0, f64::max);
            motion.shaft = next;
            if change < SAME_SPEED * drive.speed {
                break;
            }
        }
        Ok(motion)
    }

    /// Force error over time of a law in its machine motion; `None` without a target. `shaft` is the shaft motion at equally spaced angles.
    pub fn error(&self, law: &Law, motion: &MachineMotion, shaft: &Motion) -> Option<InTime> {
        let (target, drive) = (self.target.as_ref()?, &self.carrier.drive);
        let at = |i: usize| {
            let still = force(
                drive,
                law.svaj(angle(i)),
                shaft.speed[i],
                shaft.acceleration[i],
            );
            still + drive.mass * motion.floor_at(angle(i)) + self.learned[i]
        };
        let forces: Vec<f64> = (0..ROWS).map(at).collect();
        let period = TAU / drive.speed;
        Some(error_in_time(
            &forces,
            &shaft.speed,
            &shaft.time,
            period,
            target,
        ))
    }

    /// Estimate of speed ripple and force change, computed from the inertia, the motor and the energy of the load. `in_run` is the simulated
    /// force error of the law for constant speed. `None` without a motor.
    pub fn forecast(
        &self,
        problem: &Problem,
        law: &Law,
        in_run: Option<InTime>,
    ) -> Option<Forecast> {
        let motor = self.carrier.motor?;
        let load = self.load_of_law(law);
        let (ripple, change) = forecast(&load, motor, self.carrier.drive.speed);
        let allowed = problem.allowed_error().zip(self.target.as_ref());
        let neglected = allowed.map_or(NEGLECTED_OF_MEAN, |(most, _)| {
            NEGLECTED * most / problem.target_mean()
        });
        let misses = allowed
            .zip(in_run)
            .is_some_and(|((most, _), own)| own.rms_error_n > most);
        Some(Forecast {
            ripple,
            force_change_percent_of_mean: 100.0 * change,
            neglected_percent_of_mean: 100.0 * neglected,
            is_negligible: change <= neglected && !misses && !depends_on_speed(problem),
        })
    }

    /// RMS force error over time of a law with another motor or inertia, in percent of the mean; `None` without a steady motion or a target.
    pub fn error_with(&self, law: &Law, motor: &Motor) -> Option<f64> {
        let mut run: Runner = self.clone();
        run.carrier.motor = Some(motor);
        let motion = run.of_law(law, None).ok()?;
        let shaft = motion.shaft.clone().at_rows(ROWS);
        Some(run.error(law, &motion, &shaft)?.rms_error_percent_of_mean)
    }

    /// Minimum inertia, kg·m², for which the force error of a law over time is at most `allowed`, in percent of the mean force. `None` if
    /// no inertia is sufficient.
    pub fn inertia_for_accuracy(&self, law: &Law, allowed: f64) -> Option<f64> {
        let motor = self.carrier.motor?;
        let meets = |inertia: f64| {
            let wheel = Motor {
                inertia,
                ..motor.clone()
            };
            let error = self.error_with(law, &wheel);
            error.is_some_and(|error| error <= allowed)
        };
        let own = motor.inertia;
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
        Some(range[1])
    }
}

/// Equally spaced angle with index i, rad.
pub fn angle(i: usize) -> f64 {
    TAU * i as f64 / ROWS as f64
}

/// Motion s(φ(x)) of the follower at the angle `x` on a shaft with varying speed. In time, it equals the motion of `law` at constant speed.
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

/// Whether a limit or the objective, apart from the RMS force error, depends on the varying speed.
pub fn depends_on_speed(problem: &Problem) -> bool {
    let is_limited = LimitKind::ALL
        .iter()
        .any(|kind| problem.limits[*kind].is_some() && kind.facts().depends_on.varies_with_speed());
    is_limited || problem.band.is_some() || problem.objective() != Minimise::ForceError
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_over_the_angle_of_an_even_shaft_stays_the_same() {
        let law = Law::harmonic(0.01, &[(0.004, 0.001), (0.0, 0.002)]);
        let even = Motion::even(7.0);
        for x in [0.0, 0.4, 2.0, 6.2] {
            let (own, moved) = (law.svaj(x), retimed(&law, &even, x));
            for (a, b) in [
                (own.s, moved.s),
                (own.v, moved.v),
                (own.a, moved.a),
                (own.j, moved.j),
            ] {
                assert!((a - b).abs() < 1e-12, "{x}: {a} {b}");
            }
        }
    }
}
