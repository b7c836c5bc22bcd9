//! Sensitivity of the force error of a finished design to inertia and motor data.

use serde::Serialize;

use super::runner::Runner;
use crate::drive::Motor;
use crate::synth::design::Design;

/// Relative variation of inertia, torque line and friction.
const DEVIATION: f64 = 0.1;

/// Force errors of the cam in machines in which one value is decreased or increased.
#[derive(Debug, Clone, Serialize)]
pub struct Sensitivity {
    /// Key of the scene whose value is varied.
    pub key: &'static str,
    /// Force errors with the value decreased and increased by 10 %, in percent of the mean; `None` without a steady motion.
    pub percent: [Option<f64>; 2],
}

impl Design {
    /// Force errors over time, in percent of the mean, for machines in which one value differs by ±10 %. The supply of the motor is
    /// adjusted so that the mean speed remains the same. The list is empty at constant speed. Without a target, all errors are `None`.
    pub fn sensitivity(&self) -> Vec<Sensitivity> {
        let machine = &self.problem.machine;
        let (motor, floor) = (machine.motor(), machine.floor());
        let Some(motor) = motor.filter(|_| self.shaft.is_some()) else {
            return Vec::new();
        };
        let free = Motor {
            nominal: None,
            ..motor
        };
        let target = self.target_in_time();
        let run = Runner::new(
            &self.problem,
            &self.cam,
            target,
            Some(&free),
            floor.as_ref(),
        );
        let Ok(run) = run else {
            return Vec::new();
        };
        let both = |key, changed: &dyn Fn(f64) -> Motor| Sensitivity {
            key,
            percent: [1.0 - DEVIATION, 1.0 + DEVIATION]
                .map(|part| run.error_with(&self.cam.law, &changed(part))),
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
