//! Reasons for the verdict on a design, and suggested changes; the messages are in `wording/en/synth.ftl`.

use serde::Serialize;
use strum::VariantNames;

use super::named::dimension;
use crate::cam::{Criterion, Measures};
use crate::force::Note;
use crate::synth::qp::{Demand, Stop};
use crate::units::Quantity;
use crate::wording::{self, Language};

/// One reason for a verdict.
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
#[allow(missing_docs)] // fields are named as in the sentences
pub enum Reason {
    /// Every check passes and lift, velocity and acceleration are continuous.
    AllHold,
    /// The search was stopped early.
    OutOfTime,
    /// The mean of the target differs from the weight of the moved mass.
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
    /// The lift has a jump.
    LiftJumps { at: Quantity },
    /// The velocity has a jump.
    VelocityJumps { at: Quantity },
    /// The acceleration has a jump, and so has the force.
    AccelerationJumps { at: Quantity },
    /// The follower would need a pull to stay on the cam.
    LiftsOff {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// The follower of a prescribed law would need a pull, which no limit can change.
    LiftsOffAsPrescribed {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// The follower would need a pull although a spring, a preload or a mass is present.
    ContactLost { at: Quantity, pull: Quantity },
    /// The follower loses contact in the run of the emitted cam.
    ContactLostInRun { share: Quantity },
    /// The profile has a cusp.
    Cusp { at: Quantity },
    /// The profile cuts itself.
    Undercut { at: Quantity, radius: Quantity },
    /// The profile is sharper than allowed.
    TooSharp {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// The second cam of a pair is sharper than allowed.
    SecondTooSharp {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// The minimum base radius that removes the undercut.
    BaseRadiusWorks { radius: Quantity },
    /// General remedy for the profile.
    EnlargeBaseCircle,
    /// General remedy for the profile of a translating cam.
    LengthenTravel,
    /// The follower interferes with another part of the cam.
    Interference { at: Quantity, depth: Quantity },
    /// A wall of a groove is sharper than allowed.
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
    /// The force error of a spring whose preload is above the target.
    PreloadAboveTarget {
        error: Quantity,
        allowed: Quantity,
        preload: Quantity,
        least: Quantity,
    },
    /// The pressure angle is larger than allowed.
    PressureAngle {
        at: Quantity,
        angle: Quantity,
        allowed: Quantity,
    },
    /// The pressure angle is larger than usual, where nothing limits it.
    LargePressureAngle {
        at: Quantity,
        angle: Quantity,
        usual: Quantity,
    },
    /// The force error exceeds the required accuracy.
    ForceError { error: Quantity, allowed: Quantity },
    /// The force error in the run of the emitted cam exceeds the required accuracy.
    ForceErrorInRun { error: Quantity, allowed: Quantity },
    /// The law falls below its base circle.
    BelowBaseCircle { at: Quantity, depth: Quantity },
    /// The prime radius is larger than allowed.
    PrimeRadius { needed: Quantity, allowed: Quantity },
    /// The force leaves its band.
    OutsideBand { at: Quantity, excess: Quantity },
    /// Another limit is violated.
    LimitBroken {
        limit: Criterion,
        at: Quantity,
        value: Quantity,
        allowed: Quantity,
    },
    /// A limit on a derivative that is infinite, since the one below it jumps.
    LimitUnbounded { limit: Criterion, at: Quantity },
    /// Conditions that contradict each other as equations.
    DemandsContradict { demands: Vec<Demand> },
    /// Conditions that are infeasible on or above the base circle.
    DemandsInfeasible { demands: Vec<Demand> },
    /// One limit that is infeasible with the conditions.
    LimitInfeasible { limit: Criterion },
    /// A minimum contact force, although the drive has neither a spring nor a force at rest.
    NothingPresses,
    /// Limits that are infeasible together.
    LimitsInfeasible { limits: Vec<Criterion> },
    /// Limits for which no common law was found; some are nonconvex, so this does not prove infeasibility.
    NoLawFound { limits: Vec<Criterion> },
    /// The solver stopped, so that nothing is proved.
    SolverStopped { stop: Stop },
    /// One limit whose change suffices.
    Relaxation { changes: Vec<Change> },
    /// Several limits of which one change suffices.
    Relaxations { changes: Vec<Change> },
    /// No change of a single limit suffices.
    NoRelaxation,
    /// Changes of which one suffices, all of them by more than a factor of ten.
    FarRelaxations { changes: Vec<Change> },
    /// Values that suffice together, where no change of a single limit suffices.
    AllTogether { changes: Vec<Change> },
    /// Values that suffice together, if some limits are infeasible alone.
    FarTogether { changes: Vec<Change> },
    /// Limits of which each is infeasible alone, with the values at which it is feasible; with these values the other limits still fail.
    OutOfReach { changes: Vec<Change> },
    /// The design fails without any limit too; the failed checks follow.
    NotTheLimits,
}

/// A sufficient change of one limit.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)]
pub enum Change {
    /// Key as typed, present value and sufficient value.
    Change {
        key: &'static str,
        limit: Criterion,
        from: Quantity,
        to: Quantity,
    },
}

impl Reason {
    /// Message of the reason.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "reason", self)
    }

    /// Code of the reason: `reason-` and the variant in kebab-case.
    pub fn code(&self) -> String {
        wording::code("reason", self)
    }
}

/// Several reasons as one text.
pub fn sentences<'a>(reasons: impl IntoIterator<Item = &'a Reason>, language: Language) -> String {
    let all: Vec<String> = reasons.into_iter().map(|r| r.sentence(language)).collect();
    all.join(" ")
}

/// A position on the law: an angle, or a length of travel.
pub fn place(measures: Measures, at: f64) -> Quantity {
    match measures {
        Measures::Straight => Quantity::length(at),
        Measures::Translating | Measures::Oscillating => Quantity::angle(at),
    }
}

/// A limit's value with its unit, on a cam of these measures.
pub fn quantity(measures: Measures, limit: Criterion, value: f64) -> Quantity {
    Quantity::new(value, dimension(measures, limit))
}
