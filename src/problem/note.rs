//! Notes on problem and design besides the verdict: data, whose sentences stand in
//! `wording/en/synth.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::error::SceneError;
use crate::force::{self, ForceCurve, implausible};
use crate::scene::Scene;
use crate::units::Quantity;
use crate::wording::{self, Language};

/// A note on a problem or its design.
///
/// ```
/// use gaitcam::Problem;
/// use gaitcam::problem::Note;
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
    /// Rounded rows of a segment's table can be a large part of its acceleration.
    RoundedTable { segment: usize, share: Quantity },
    /// The caller ended the search.
    OutOfTime,
    /// The smallest base circle has no radius.
    NoBaseCircle,
    /// The wall between the bore and the base circle is thinner than that of a usual hub.
    ThinWall { wall: Quantity, usual: Quantity },
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
