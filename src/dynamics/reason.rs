//! Why a model was chosen, and notes on a run, as data; their sentences are in `wording/en/dynamics.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;
use crate::wording::{self, Language};

/// Reason for the choice of a model, with its numbers.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, ModelReason, Run, simulate};
/// use gaitcam::law::Law;
///
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// assert_eq!(simulate(&run, Model::Rigid)?.why, ModelReason::AskedFor);
/// assert!(matches!(simulate(&run, Model::Auto)?.why, ModelReason::NothingVibrates { .. }));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum ModelReason {
    /// The caller named the model.
    AskedFor,
    /// The rigid force comes near zero.
    LowForce {
        force: Quantity,
        part: Quantity,
        mean: Quantity,
        liftoff: LiftoffMargin,
    },
    /// The speed comes near lift-off.
    NearLiftoff { liftoff: LiftoffMargin },
    /// Only the contact model has the impacts between two cams.
    TwoCams,
    /// The follower is rigid.
    NothingVibrates { margin: ForceMargin },
    /// The vibrating follower would leave the cam.
    VibrationLosesContact {
        vibration: Vibration,
        force: Quantity,
    },
    /// Vibration changes the force by more than is allowed.
    Vibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
    /// Vibration changes the force by less than is allowed.
    HardlyVibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
}

impl ModelReason {
    /// The reason as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "model", self)
    }
}

/// How far the speed is from lift-off.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{LiftoffMargin, Model, ModelReason, Run, simulate};
/// use gaitcam::law::Law;
///
/// // M (g − ω²e) = 0: an eccentric of e = 10 mm lifts off at √(g/e). At 0.99 of that the contact model is asked.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let liftoff = (9.81_f64 / 0.01).sqrt();
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 0.99 * liftoff), 720);
/// let outcome = simulate(&run, Model::Auto)?;
/// let (ModelReason::LowForce { liftoff: margin, .. } | ModelReason::NearLiftoff { liftoff: margin }) = outcome.why else {
///     panic!("{:?}", outcome.why)
/// };
/// assert!(matches!(margin, LiftoffMargin::LiftoffAt { liftoff: at, .. } if (at.value / liftoff - 1.0).abs() < 1e-6));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum LiftoffMargin {
    HeldFromBothSides,
    NoLiftoff { speed: Quantity },
    MovingFloor { speed: Quantity },
    LiftoffAt { speed: Quantity, liftoff: Quantity },
}

/// How far the rigid force is from zero.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{ForceMargin, Model, ModelReason, Run, simulate};
/// use gaitcam::law::Law;
///
/// // F = M (g + ω²a), a = −10 mm sin θ: the smallest is M (g − ω²e).
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// let ModelReason::NothingVibrates { margin } = simulate(&run, Model::Auto)?.why else { panic!() };
/// let ForceMargin::SmallestForce { force, .. } = margin else { panic!("{margin:?}") };
/// assert!((force.value - 10.0 * (9.81 - 9.0 * 0.01)).abs() < 1e-4);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum ForceMargin {
    /// The drive has neither mass nor spring nor preload.
    NoForce,
    /// A pure inertia force has no mean to relate the margin to.
    InertiaOnly {
        low: Quantity,
        high: Quantity,
        liftoff: LiftoffMargin,
    },
    SmallestForce {
        force: Quantity,
        part: Quantity,
        liftoff: LiftoffMargin,
    },
}

/// Effect of the follower's vibration on the force.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, ModelReason, Run, Train, Vibration, simulate};
/// use gaitcam::law::Law;
///
/// // A follower of 20 Hz on a shaft of 3 rad/s: the natural frequency is 20·2π/3 times the speed.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let drive = Drive::moving_axis(10.0, 9.81, 3.0);
/// let mut run = Run::new(cam, drive, 720);
/// run.machine.train = Some(Train::from_frequency(&drive, 20.0, 0.05)?);
/// let (ModelReason::HardlyVibrates { vibration, .. } | ModelReason::Vibrates { vibration, .. }) =
///     simulate(&run, Model::Auto)?.why
/// else {
///     panic!()
/// };
/// let Vibration::Harmonics { ratio, .. } = vibration else { panic!("{vibration:?}") };
/// assert!((ratio - 20.0 * std::f64::consts::TAU / 3.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum Vibration {
    /// Springs in series without mass: no vibration, but part of the lift deflects the train.
    NoMass,
    Harmonics {
        frequency: Quantity,
        ratio: f64,
        part: Quantity,
    },
}

/// A note on a run.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, RunNote, simulate};
/// use gaitcam::law::Law;
///
/// // Above lift-off a rigid follower that stays in contact would have to pull.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 1.1 * (9.81_f64 / 0.01).sqrt()), 720);
/// assert!(simulate(&run, Model::Rigid)?.notes.contains(&RunNote::RigidPulls));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum RunNote {
    SecondCamBears {
        part: Quantity,
        force: Quantity,
    },
    OtherWallBears {
        part: Quantity,
        force: Quantity,
    },
    RigidPulls,
    RigidWithoutImpacts,
    FlexiblePulls,
    Escapes,
    NotPeriodic {
        turns: usize,
        impacts: usize,
    },
    Swings,
    PairDistance {
        deviation: f64,
    },
    /// The motor changes the force by less than is allowed: constant speed is enough.
    SteadyShaft {
        ripple: Quantity,
        change: Quantity,
        allowed: Quantity,
    },
    /// The speed varies.
    ShaftVaries {
        ripple: Quantity,
        change: Quantity,
        found: Quantity,
    },
    /// The compliant follower is run at the mean speed.
    FlexibleAtMeanSpeed,
}

impl RunNote {
    /// The note as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "run", self)
    }
}
