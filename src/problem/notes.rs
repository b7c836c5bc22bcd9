//! Notes on the scene and the problem, before the design.

use std::f64::consts::TAU;

use super::Problem;
use super::note::Note;
use crate::drive::DriveKind;
use crate::scene::LimitKind;
use crate::units::{Dimension, Quantity};

/// Relative difference between the mean force and the weight M·g of the moved mass M below which they count as equal.
const CLOSURE: f64 = 1e-6;
/// Ratio of the force to its mean below which the mass on a moving axis counts as in free fall.
const FREE_FALL: f64 = 0.02;
/// Ratio of two accelerations below which there is no note on a rounded table. It is the acceleration due to the rounding, divided by the
/// maximum acceleration.
const OF_ROUNDING: f64 = 0.1;
/// Relative difference between the durations of a turn and of the force cycle below which they count as equal.
const SAME_PERIOD: f64 = 1e-3;

impl Problem {
    /// Notes on the scene, disabled checks, cycle duration, rounded tables, force balance of a moving axis and optimal phase.
    pub fn notes(&self) -> Vec<Note> {
        let mut out = self.remarks.clone();
        let has_default =
            |key: &&str| *key != "limits.hertz_pressure" || self.cam.allowable_pressure().is_some();
        let off = self.limits.unjudged.keys().into_iter();
        let off = off.filter(has_default);
        out.extend(off.map(|key| Note::NotJudged { key }));
        let weights = &self.machine.walkers.weights;
        if let Some(first) = weights.first().filter(|_| self.machine.has_floor()) {
            out.push(Note::FirstWalker {
                weight: first.split(',').next().unwrap_or("").trim().to_string(),
                key: "machine.walkers.weights",
            });
        }
        out.extend(self.stretched());
        out.extend(self.rounded_tables());
        if self.drive.kind == DriveKind::MovingAxis {
            out.extend(self.closure());
        }
        if self.phase_is_free {
            out.push(Note::Phase {
                phase: Quantity::angle(self.phase),
            });
        }
        out
    }

    fn rounded_tables(&self) -> impl Iterator<Item = Note> + '_ {
        let segments = self.law.segments.iter().enumerate();
        segments.filter_map(|(i, segment)| {
            let most = segment.motion.factors().ok()?.ca;
            let rounded = segment.motion.rounded_acceleration();
            // A dwell has neither rounding nor acceleration.
            (rounded > OF_ROUNDING * most).then(|| Note::RoundedTable {
                segment: i + 1,
                share: Quantity::share((rounded / most).min(1.0)),
            })
        })
    }

    fn stretched(&self) -> Option<Note> {
        let (turn, cycle) = (
            TAU / self.drive.speed,
            self.target.as_ref()?.curve().period_s,
        );
        ((turn / cycle - 1.0).abs() > SAME_PERIOD).then(|| Note::Stretched {
            turn: Quantity::time(turn),
            cycle: Quantity::time(cycle),
        })
    }

    /// Notes on the force balance of a moving axis (theory §1): mean force and weight M·g, free fall, maximum stroke.
    fn closure(&self) -> Vec<Note> {
        // With a varying shaft speed, the force that the speed variation adds has been subtracted from the target. Such a target is not
        // used here.
        let Some(target) = self.target.as_ref().filter(|_| self.on_shaft.is_none()) else {
            return Vec::new();
        };
        let curve = target.curve();
        let (mass, speed) = (self.drive.mass, self.drive.speed);
        let (weight, mean) = (self.drive.rest_force, curve.mean_n());
        let mut notes = Vec::new();
        if (mean - weight).abs() > CLOSURE * weight.abs() {
            notes.push(Note::MeanForce {
                mean: Quantity::force(mean),
                weight: Quantity::force(weight),
                error: Quantity::force((mean - weight).abs()),
            });
        }
        if target.range_n()[0] < FREE_FALL * mean {
            let falling = curve.force_n.iter().filter(|f| **f < FREE_FALL * mean);
            let share = falling.count() as f64 / curve.force_n.len() as f64;
            let seconds = share * TAU / speed;
            notes.push(Note::FreeFall {
                share: Quantity::share(share),
                duration: Quantity::time(seconds),
                lift: Quantity::length(weight / mass * seconds * seconds / 8.0),
            });
        }
        let hardest = target.farthest_from(mean) / mass;
        let period = TAU / speed;
        let largest_stroke = hardest * period * period / 16.0;
        notes.push(Note::LargestStroke {
            acceleration: Quantity::new(hardest, Dimension::Acceleration),
            stroke: Quantity::length(largest_stroke),
            idle: self.limits[LimitKind::Stroke].is_some_and(|h| h > largest_stroke),
        });
        notes
    }
}
