//! Reasons for the verdict on a design, and suggested changes. The messages are in `wording/en/synth.ftl`.

use serde::Serialize;
use strum::VariantNames;

use super::named::dimension;
use crate::cam::{Criterion, Measures};
use crate::force::Note;
use crate::synth::qp::{Demand, Stop};
use crate::units::Quantity;
use crate::wording::{self, Language};

/// Reason for the verdict on a design, or suggested change.
///
/// ```
/// use gaitcam::synth::Reason;
/// use gaitcam::wording::Language;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert_eq!(design.reasons, [Reason::AllHold]);
/// assert_eq!(design.reasons[0].code(), "reason-all-hold");
/// assert!(!design.reason(Language::Es).is_empty());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum Reason {
    /// Every check passes and lift, velocity and acceleration are continuous.
    AllHold,
    /// The search was stopped early.
    OutOfTime,
    /// The mean target force differs from the weight of the moved mass, which is the mean force of every law on a moving axis.
    MeanForce {
        mean: Quantity,
        weight: Quantity,
        error: Quantity,
    },
    /// The kind of the recorded movement is uncertain.
    RecordingKind {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The stride time of the recording is uncertain.
    RecordingClock {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The magnitude of the recorded forces is uncertain.
    RecordingMass {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The readings of the recording are clipped.
    RecordingClipped {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The lift is discontinuous at an angle.
    LiftJumps { at: Quantity },
    /// The derivative of the lift is discontinuous at an angle.
    VelocityJumps { at: Quantity },
    /// The second derivative of the lift is discontinuous at an angle, so the inertia force has a jump.
    AccelerationJumps { at: Quantity },
    /// A negative contact force would be necessary to keep the follower on the cam.
    LiftsOff {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// A negative contact force would be necessary for a prescribed law. Since the law is given, no limit can prevent this.
    LiftsOffAsPrescribed {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// A negative contact force would be necessary although there is a spring, a preload or a mass.
    ContactLost { at: Quantity, pull: Quantity },
    /// The follower loses contact in the simulation of the output profile.
    ContactLostInRun { share: Quantity },
    /// The profile has a cusp.
    Cusp { at: Quantity },
    /// The profile intersects itself.
    Undercut { at: Quantity, radius: Quantity },
    /// The convex radius of the profile is below the permitted minimum.
    TooSharp {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// The convex radius of the second cam is below the permitted minimum.
    SecondTooSharp {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// Suggestion: a base radius that is sufficient for the curvature limit.
    BaseRadiusWorks { radius: Quantity },
    /// Suggestion: a larger base circle or a smaller roller.
    EnlargeBaseCircle,
    /// Suggestion for a translating cam: a longer travel or a smaller roller.
    LengthenTravel,
    /// The follower interferes with the cam away from the contact.
    Interference { at: Quantity, depth: Quantity },
    /// The convex radius of a wall of a groove is below the permitted minimum.
    SharpWall {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// The roller is larger than the concave radius of the profile.
    RollerTooLarge {
        at: Quantity,
        roller: Quantity,
        hollow: Quantity,
    },
    /// The preload of a spring is above the minimum of the target, which causes a force error.
    PreloadAboveTarget {
        error: Quantity,
        allowed: Quantity,
        preload: Quantity,
        least: Quantity,
    },
    /// The pressure angle is larger than permitted.
    PressureAngle {
        at: Quantity,
        angle: Quantity,
        allowed: Quantity,
    },
    /// The pressure angle exceeds the usual maximum, on a side without a limit in the scene.
    LargePressureAngle {
        at: Quantity,
        angle: Quantity,
        usual: Quantity,
    },
    /// The force error exceeds the required accuracy.
    ForceError { error: Quantity, allowed: Quantity },
    /// The force error in the simulation of the output profile exceeds the required accuracy.
    ForceErrorInRun { error: Quantity, allowed: Quantity },
    /// The lift is below the base circle.
    BelowBaseCircle { at: Quantity, depth: Quantity },
    /// The prime radius is larger than permitted.
    PrimeRadius { needed: Quantity, allowed: Quantity },
    /// The force is outside its band.
    OutsideBand { at: Quantity, excess: Quantity },
    /// A limit is violated for which no other reason is defined.
    LimitBroken {
        limit: Criterion,
        at: Quantity,
        value: Quantity,
        allowed: Quantity,
    },
    /// A limited derivative is infinite, because the derivative of the next lower order has a jump.
    LimitUnbounded { limit: Criterion, at: Quantity },
    /// The contact pressure is infinite, because the radius of curvature of the profile is zero or negative at this position.
    PressureUnbounded { at: Quantity },
    /// The conditions contradict each other, even without limits.
    DemandsContradict { demands: Vec<Demand> },
    /// The conditions are infeasible for a law that is nowhere below the base circle.
    DemandsInfeasible { demands: Vec<Demand> },
    /// One limit is infeasible under the conditions, even without the other limits.
    LimitInfeasible { limit: Criterion },
    /// A minimum contact force is required, although the drive has neither a spring nor a force at rest.
    NothingPresses,
    /// The limits are infeasible together.
    LimitsInfeasible { limits: Vec<Criterion> },
    /// No law was found that satisfies these limits. Because some of the limits are non-convex, this does not prove infeasibility.
    NoLawFound { limits: Vec<Criterion> },
    /// The solver stopped early, so nothing is proved.
    SolverStopped { stop: Stop },
    /// A sufficient change of one limit.
    Relaxation { changes: Vec<Change> },
    /// Sufficient changes of several limits. One of the changes is sufficient.
    Relaxations { changes: Vec<Change> },
    /// No change of a single limit is sufficient.
    NoRelaxation,
    /// Changes of which one is sufficient. Each of them changes its value by more than a factor of ten.
    FarRelaxations { changes: Vec<Change> },
    /// Changes that are sufficient together. No change of a single limit is sufficient.
    AllTogether { changes: Vec<Change> },
    /// Changes that are sufficient together. Some of these limits are infeasible even without the other limits.
    FarTogether { changes: Vec<Change> },
    /// Limits that are infeasible even without the other limits, with the values at which each becomes feasible. These values together are not
    /// sufficient.
    OutOfReach { changes: Vec<Change> },
    /// The design fails even without the limits. The reasons that follow describe the failed checks.
    NotTheLimits,
}

/// Sufficient change of one limit.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)]
pub enum Change {
    /// Change of one limit: key as used with `--set`, present value and sufficient value.
    Change {
        key: &'static str,
        limit: Criterion,
        from: Quantity,
        to: Quantity,
    },
}

impl Reason {
    /// Message of the reason in the given language.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "reason", self)
    }

    /// Code of the reason: `reason-` and the variant in kebab-case.
    pub fn code(&self) -> String {
        wording::code("reason", self)
    }
}

/// Messages of several reasons, joined to one text.
pub fn sentences<'a>(reasons: impl IntoIterator<Item = &'a Reason>, language: Language) -> String {
    let all: Vec<String> = reasons.into_iter().map(|r| r.sentence(language)).collect();
    all.join(" ")
}

/// Position on the law: a cam angle, or for a translating cam a length of travel.
pub fn place(measures: Measures, at: f64) -> Quantity {
    match measures {
        Measures::Straight => Quantity::length(at),
        Measures::Translating | Measures::Oscillating => Quantity::angle(at),
    }
}

/// Value of a criterion with its physical dimension, for this kind of motion.
pub fn quantity(measures: Measures, limit: Criterion, value: f64) -> Quantity {
    Quantity::new(value, dimension(measures, limit))
}
