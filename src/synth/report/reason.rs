//! Why a design has its verdict, and what would help: data, whose sentences stand in `wording/en/synth.ftl`.

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
    /// The search was ended before it was complete.
    OutOfTime,
    /// The mean of the target is not the weight of the moved mass.
    MeanForce {
        mean: Quantity,
        weight: Quantity,
        error: Quantity,
    },
    /// What the recording is of is open.
    RecordingKind {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// How long a stride of the recording lasts is open.
    RecordingClock {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// How large the forces of the recording are is open.
    RecordingMass {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The readings of the recording are clipped.
    RecordingClipped {
        because: Vec<Note>,
        keys: Vec<&'static str>,
    },
    /// The lift jumps.
    LiftJumps { at: Quantity },
    /// The velocity jumps.
    VelocityJumps { at: Quantity },
    /// The acceleration jumps, and the force with it.
    AccelerationJumps { at: Quantity },
    /// Only a pull would keep the follower on the cam.
    LiftsOff {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// The same of a law that is prescribed: no limit shapes it.
    LiftsOffAsPrescribed {
        at: Quantity,
        pull: Quantity,
        speed: Quantity,
    },
    /// The same where a spring, a preload or a mass presses.
    ContactLost { at: Quantity, pull: Quantity },
    /// The emitted cam was run, and the follower leaves it.
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
    /// The smallest base radius that mends the profile.
    BaseRadiusWorks { radius: Quantity },
    /// What mends the profile in general.
    EnlargeBaseCircle,
    /// The same for a translating cam.
    LengthenTravel,
    /// The follower reaches into another part of the cam.
    Interference { at: Quantity, depth: Quantity },
    /// A wall of a groove is sharper than allowed.
    SharpWall {
        at: Quantity,
        radius: Quantity,
        allowed: Quantity,
    },
    /// The roller is larger than the hollow it runs in.
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
    /// The force is farther from the target than asked.
    ForceError { error: Quantity, allowed: Quantity },
    /// The same in a run of the emitted cam.
    ForceErrorInRun { error: Quantity, allowed: Quantity },
    /// The law dips below its base circle.
    BelowBaseCircle { at: Quantity, depth: Quantity },
    /// The prime radius is larger than allowed.
    PrimeRadius { needed: Quantity, allowed: Quantity },
    /// The force leaves its band.
    OutsideBand { at: Quantity, excess: Quantity },
    /// Any other limit is broken.
    LimitBroken {
        limit: Criterion,
        at: Quantity,
        value: Quantity,
        allowed: Quantity,
    },
    /// A limit on a derivative that is infinite, since the one below it jumps.
    LimitUnbounded { limit: Criterion, at: Quantity },
    /// Demands that contradict each other as equations.
    DemandsContradict { demands: Vec<Demand> },
    /// Demands that no law on or above the base circle meets together.
    DemandsInfeasible { demands: Vec<Demand> },
    /// One limit that no law keeps together with the demands.
    LimitInfeasible { limit: Criterion },
    /// Limits that no law keeps together.
    LimitsInfeasible { limits: Vec<Criterion> },
    /// Limits for which no common law was found; some are nonconvex, so this is no proof.
    NoLawFound { limits: Vec<Criterion> },
    /// The solver stopped, which proves nothing.
    SolverStopped { stop: Stop },
    /// One limit whose change is enough.
    Relaxation { changes: Vec<Change> },
    /// Several limits of which one change is enough.
    Relaxations { changes: Vec<Change> },
    /// No change of a single limit is enough.
    NoRelaxation,
    /// Changes of which one is enough, all of them by more than ten times.
    FarRelaxations { changes: Vec<Change> },
    /// Only all limits together help, by this share.
    AllTogether { share: Quantity },
    /// Values that are enough together, where limits cannot hold even alone.
    FarTogether { changes: Vec<Change> },
    /// Limits that cannot hold even alone, with what they would need, where the other limits do not hold beside that.
    OutOfReach { changes: Vec<Change> },
    /// The design fails without any limit too; what it fails by follows.
    NotTheLimits,
}

/// The change of one limit that is enough.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)]
pub enum Change {
    /// Its key as it is typed, its value and the one that works.
    Change {
        key: &'static str,
        limit: Criterion,
        from: Quantity,
        to: Quantity,
    },
}

impl Reason {
    /// The reason as a sentence.
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

/// A place of the law: an angle, or a length of travel.
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
