//! Notes on a problem and its design, in addition to the verdict. The messages are in `wording/en/synth.ftl`.

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
/// // For a closed law, the stroke h satisfies 16 h/T² ≤ max |a|, with the duration T of a turn (theory §1).
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
#[allow(missing_docs)] // the fields are named in the messages
pub enum Note {
    /// A note on a key of the scene.
    Scene { note: SceneError },
    /// A note on the recording of the force.
    Recording { note: force::Note },
    /// One turn and the force cycle have different durations, so the cycle is stretched to the turn.
    Stretched { turn: Quantity, cycle: Quantity },
    /// The mean of the target force differs from the weight of the moved mass.
    MeanForce {
        mean: Quantity,
        weight: Quantity,
        error: Quantity,
    },
    /// The target force is nearly zero in a part of the turn, so the mass must be in free fall there.
    FreeFall {
        share: Quantity,
        duration: Quantity,
        lift: Quantity,
    },
    /// Maximum stroke that is possible with the maximum acceleration of the target force.
    LargestStroke {
        acceleration: Quantity,
        stroke: Quantity,
        /// Whether the limit on the stroke is above this maximum, so that it has no effect.
        idle: bool,
    },
    /// The scene switches off the check of a default bound.
    NotJudged { key: &'static str },
    /// The scene gives weights of the walkers on the floor. The first weight belongs to the shaker.
    FirstWalker { weight: String, key: &'static str },
    /// The design selected the phase with the minimum force error.
    Phase { phase: Quantity },
    /// The number of spans or harmonics is limited, because a larger number would fit the noise of the recording.
    Noise { size: &'static str, error: Quantity },
    /// The automatic accuracy includes the sensor noise of the recording.
    SensorNoise {
        size: &'static str,
        noise: Quantity,
        error: Quantity,
    },
    /// The accuracy requires a large number of spans.
    ManySpans { spans: usize, error: Quantity },
    /// The band or another limit requires a large number of spans.
    ManySpansInBand { spans: usize },
    /// The tabulated lifts of a segment are rounded. This rounding can cause a large part of the acceleration of the segment.
    RoundedTable { segment: usize, share: Quantity },
    /// The search ended at its time limit or was stopped by the caller.
    OutOfTime,
    /// The minimum base circle has radius zero.
    NoBaseCircle,
    /// The wall between the bore and the base circle is thinner than the wall of a typical hub.
    ThinWall { wall: Quantity, usual: Quantity },
    /// The roller is larger than its cam.
    LargeRoller { roller: Quantity, cam: Quantity },
    /// The base circle is too small for a shaft that withstands the torque.
    ThinShaft {
        /// Diameter of the base circle of the cam.
        circle: Quantity,
        /// Minimum diameter of a shaft for the torque.
        shaft: Quantity,
        torque: Quantity,
    },
    /// The bore is much larger than the minimum diameter of a shaft for the torque.
    LargeBore {
        bore: Quantity,
        shaft: Quantity,
        torque: Quantity,
    },
    /// The cam does not reach the accuracy, because the speed of the motor varies. A larger inertia of the shaft would be sufficient.
    InertiaForAccuracy {
        error: Quantity,
        allowed: Quantity,
        inertia: Quantity,
    },
    /// The default limit of the pressure angle determines the size.
    UsualPressureAngle { angle: Quantity },
    /// The cam is designed for a compliant follower, as a polydyne cam.
    Polydyne {
        speed: Quantity,
        stiffness: Quantity,
    },
    /// RMS force error in the simulation with the compliant follower. `own` belongs to this cam, `plain` to a cam without polydyne
    /// correction.
    PolydyneMiss { own: Quantity, plain: Quantity },
}

impl Note {
    /// Message of the note.
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
        let doubts = doubts.chain(force.notes.iter().cloned());
        let doubts = doubts.chain(force.warnings().cloned());
        out.extend(doubts.map(|note| Note::Recording { note }));
    }
    out
}
