//! Notes on problem and design besides the verdict: data, whose sentences stand in
//! `wording/en/synth.ftl`.

use std::f64::consts::TAU;

use serde::Serialize;
use strum::VariantNames;

use super::Problem;
use crate::drive::DriveKind;
use crate::error::SceneError;
use crate::force::{self, ForceCurve, implausible};
use crate::scene::{LimitKind, Scene};
use crate::units::{Dimension, Quantity};
use crate::wording::{self, Language};

/// Differences of the mean force from M·g below this part of it are not worth a note.
const CLOSURE: f64 = 1e-6;
/// A force below this part of the mean asks the moving axis for free fall.
const FREE_FALL: f64 = 0.02;
/// A turn that differs from the force cycle by less, as a part of it, is that cycle.
const SAME_PERIOD: f64 = 1e-3;

/// A note on a problem or its design.
///
/// ```
/// use gaitcam::problem::{Note, Problem};
/// use gaitcam::scene;
///
/// // With v closed over a turn the stroke is at most 16 h/T² ≤ max |a| (theory §1).
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let stroke = problem.notes().into_iter().find_map(|note| match note {
///     Note::LargestStroke { acceleration, stroke, .. } => Some((acceleration.value, stroke.value)),
///     _ => None,
/// });
/// let (acceleration, stroke) = stroke.unwrap();
/// assert!((stroke - acceleration / 1.85_f64.powi(2) / 16.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum Note {
    /// On the scene.
    Scene { note: SceneError },
    /// On the recording.
    Recording { note: force::Note },
    /// The force cycle is stretched to the turn.
    Stretched { turn: Quantity, cycle: Quantity },
    /// The mean of the target force is not the weight of the moved mass.
    MeanForce {
        mean: Quantity,
        weight: Quantity,
        error: Quantity,
    },
    /// The target force needs free fall.
    FreeFall {
        share: Quantity,
        duration: Quantity,
        lift: Quantity,
    },
    /// Bound on the stroke from the largest acceleration.
    LargestStroke {
        acceleration: Quantity,
        stroke: Quantity,
        /// The stroke is limited to more than that.
        idle: bool,
    },
    /// A bound of the verdict is switched off.
    NotJudged { key: &'static str },
    /// The phase that was chosen.
    Phase { phase: Quantity },
    /// The size of the law stops where it would follow noise.
    Noise { size: &'static str, error: Quantity },
    /// The caller ended the search.
    OutOfTime,
    /// The smallest base circle has no radius.
    NoBaseCircle,
    /// The wall between the bore and the base circle is thinner than that of a usual hub.
    ThinWall { wall: Quantity, usual: Quantity },
    /// No round hole that leaves walls balances a cam.
    NoBalanceHole { wall: Quantity },
    /// A roller larger than the cam that it rolls on.
    LargeRoller { roller: Quantity, cam: Quantity },
    /// No shaft that carries the torque fits into the base circle.
    ThinShaft {
        /// Diameter of the base circle.
        circle: Quantity,
        /// Diameter of the thinnest shaft.
        shaft: Quantity,
        torque: Quantity,
    },
    /// A hole much wider than the thinnest shaft that carries the torque.
    LargeBore {
        bore: Quantity,
        shaft: Quantity,
        torque: Quantity,
    },
    /// Under its motor the cam misses the accuracy, which a larger inertia would meet.
    InertiaForAccuracy {
        error: Quantity,
        allowed: Quantity,
        inertia: Quantity,
    },
    /// The size keeps the usual pressure angle.
    UsualPressureAngle { angle: Quantity },
    /// The cam is cut for a follower that gives.
    Polydyne {
        speed: Quantity,
        stiffness: Quantity,
    },
    /// How far the end of that follower stays from its law, and how far it would without.
    PolydyneMiss { own: Quantity, plain: Quantity },
}

impl Note {
    /// The note as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        match self {
            Note::Scene { note } => wording::sentence(language, "scene", note),
            Note::Recording { note } => wording::sentence(language, "note", note),
            own => wording::sentence(language, "design", own),
        }
    }
}

/// Notes on the scene and on its recording.
pub fn remarks(scene: &Scene, force: Option<&ForceCurve>) -> Vec<Note> {
    let of_scene = scene.notes().into_iter().map(|note| Note::Scene { note });
    let mut out: Vec<Note> = of_scene.collect();
    if let (Some(gait), Some(force)) = (&scene.gait, force)
        && gait.is_recording()
    {
        let doubts = implausible(force, gait.feet).into_iter();
        let doubts = doubts.chain(force.clock_note());
        let doubts = doubts.chain(force.warnings().cloned());
        out.extend(doubts.map(|note| Note::Recording { note }));
    }
    out
}

impl Problem {
    /// Notes on the scene, the speed, the closure of a moving axis and the phase that was chosen.
    pub fn notes(&self) -> Vec<Note> {
        let mut out = self.remarks.clone();
        let off = self.limits.unjudged.keys().into_iter();
        out.extend(off.map(|key| Note::NotJudged { key }));
        out.extend(self.stretched());
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

    fn stretched(&self) -> Option<Note> {
        let (turn, cycle) = (TAU / self.drive.speed, self.target.as_ref()?.curve.period_s);
        ((turn / cycle - 1.0).abs() > SAME_PERIOD).then(|| Note::Stretched {
            turn: Quantity::time(turn),
            cycle: Quantity::time(cycle),
        })
    }

    /// Closure of the moving axis (theory §1): mean(F) = M g, free fall, the least stroke.
    fn closure(&self) -> Vec<Note> {
        // On a shaft whose speed varies the target is what is left for the mean speed.
        let Some(target) = self.target.as_ref().filter(|_| self.on_shaft.is_none()) else {
            return Vec::new();
        };
        let curve = &target.curve;
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
