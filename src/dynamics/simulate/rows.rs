//! Rows of a simulation, for all models: forces at equal angles, with torque and pressure.

use super::prepared::Prepared;
use crate::cam::Measures;
use crate::dynamics::outcome::{Force, Loads, Model, Outcome, Row, Torque};
use crate::dynamics::reason::ModelReason;
use crate::dynamics::rigid;
use crate::dynamics::rigid::touch::Touch;
use crate::dynamics::run::Run;
use crate::dynamics::shaft::{InTime, error_in_time};
use crate::law::Svaj;
use crate::units::{Dimension, Quantity};

impl Prepared {
    /// Converts a contact force, N, or the moment on an arm, N·m, to a quantity with its unit.
    pub fn load(&self, value: f64) -> Quantity {
        let dimension = match self.measures {
            Measures::Oscillating => Dimension::Torque,
            _ => Dimension::Force,
        };
        Quantity::new(value, dimension)
    }

    /// Speed of the shaft at a row, rad/s, in the direction of rotation.
    pub fn speed(&self, row: usize) -> f64 {
        (self.shaft.as_ref()).map_or(self.drive.speed, |shaft| shaft.speed[row])
    }

    /// Difference between the force and the target over time; `None` without a target or for constant speed.
    pub fn force_time(&self, forces: &[f64]) -> Option<InTime> {
        let (target, shaft) = (self.target.as_ref()?, self.shaft.as_ref()?);
        let period = self.cycle.length / self.drive.speed;
        Some(error_in_time(
            forces,
            &shaft.speed,
            &shaft.time,
            period,
            target,
        ))
    }

    pub fn rms_error(&self, forces: &[f64]) -> Option<f64> {
        let target = self.target.as_ref()?;
        let sum: f64 = forces
            .iter()
            .enumerate()
            .map(|(i, f)| (f - target[i % target.len()]).powi(2))
            .sum();
        Some((sum / forces.len() as f64).sqrt())
    }

    /// Rows at equal angles over whole turns, from the forces and from the heights above the lift of the profile at these angles.
    pub fn rows(&self, input: &Run, forces: &[f64], heights: &[f64]) -> Vec<Row> {
        let n = self.nodes.len();
        let total = forces.len();
        let sign = if self.reversed { -1.0 } else { 1.0 };
        let first = if self.reversed {
            -(self.start + self.cycle.length)
        } else {
            self.start
        };
        let mut rows = vec![Row::default(); total];
        for i in 0..total {
            let at = self.nodes[i % n];
            let speed = self.speed(i % n);
            let angle = self.start + self.step * i as f64;
            let touch = self.touch(input, speed, angle, at, forces[i]);
            let torque = self.torque(input, forces[i], at);
            let place = self.place(i, total);
            let time = match &self.shaft {
                Some(shaft) => shaft.time[i % n],
                None => self.step * i as f64 / speed,
            };
            rows[place] = Row {
                theta: first + self.step * place as f64,
                time: if !time.is_finite() { 0.0 } else { time },
                speed: sign * speed,
                contact_force: forces[i],
                torque: sign * torque,
                power: torque * speed,
                lift: at.s + heights[i],
                gap: if forces[i] == 0.0 {
                    heights[i].max(0.0)
                } else {
                    0.0
                },
                normal_force: touch.normal,
                sliding: sign * touch.sliding,
                entraining: sign * touch.entraining,
                side_thrust: touch.side_thrust,
            };
        }
        rows
    }

    /// Index of the row that belongs to a sample. Samples are in the order of rotation, rows in the order of increasing cam angle.
    pub fn place(&self, sample: usize, rows: usize) -> usize {
        if self.reversed {
            (rows - sample) % rows
        } else {
            sample
        }
    }

    /// Contact that transmits the force. In a conjugate pair, a negative force loads the second cam.
    pub fn touch(&self, input: &Run, speed: f64, angle: f64, at: Svaj, force: f64) -> Touch {
        let friction = input.machine.friction;
        match (&input.machine.conjugate, &self.second) {
            (Some(cam), Some(law)) if force < 0.0 => {
                self.seen(&cam.follower, speed, friction, law.svaj(angle), -force)
            }
            _ => self.seen(&self.bearing, speed, friction, at, force),
        }
    }

    pub fn signed(&self, t: Torque) -> Torque {
        if !self.reversed {
            return t;
        }
        Torque {
            min: -t.max,
            max: -t.min,
            mean: -t.mean,
            rms: t.rms,
        }
    }

    pub fn sampled_torque(&self, input: &Run, forces: &[f64]) -> Torque {
        let values = self.torques(input, forces);
        let count = values.len() as f64;
        Torque {
            min: values.iter().copied().fold(f64::INFINITY, f64::min),
            max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            mean: values.iter().sum::<f64>() / count,
            rms: (values.iter().map(|t| t * t).sum::<f64>() / count).sqrt(),
        }
    }

    pub fn liftoff(&self) -> Option<f64> {
        if self.held {
            return None;
        }
        rigid::liftoff_speed(&self.lift, &self.drive)
    }

    pub fn outcome(&self, model: Model) -> Outcome {
        Outcome {
            model,
            swings: self.measures == Measures::Oscillating,
            lever: self.drive.lever,
            why: ModelReason::AskedFor,
            contact_lost: false,
            lost_fraction: 0.0,
            force: Force::default(),
            torque: Torque::default(),
            liftoff_speed: self.liftoff(),
            settle_cycles: Some(0),
            period_turns: 1,
            shaft: self.shaft_report,
            floor: None,
            force_time: None,
            impacts: Vec::new(),
            loads: Loads::default(),
            hertz: None,
            next: None,
            profile_mismatch: self.mismatch,
            law_mismatch: self.law_mismatch,
            notes: self.notes.clone(),
            rows: Vec::new(),
        }
    }
}
