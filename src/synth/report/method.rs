//! Method of a law, and reasons against simpler families. The messages are in `wording/en/solver.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::cam::Criterion;
use crate::units::Quantity;
use crate::wording::{self, Language};

/// Method by which a law was computed.
///
/// ```
/// use gaitcam::synth::Method;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // Young's load has four harmonics, and so has the law.
/// let scene = scene::built_in("footbridge")?.scene()?.with("law.family", "harmonic")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert!(matches!(design.solver.method, Method::Spectral { harmonics, .. } if harmonics <= 4));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum Method {
    /// A given programme, without a solution step.
    Programme,
    /// Interpolation: the number of conditions equals the number of coefficients, so the law is the solution of one linear system.
    Interpolation,
    /// Harmonics inverted one by one, with the RMS force of the omitted harmonics.
    Spectral { harmonics: usize, rest: Quantity },
    /// Harmonics with limits, by exchange iterations.
    Harmonics {
        harmonics: usize,
        rounds: usize,
        violation: f64,
    },
    /// A search for the angles of rise and fall.
    Search {
        rise: Quantity,
        from: Quantity,
        fall: Quantity,
        steps: usize,
        error: Quantity,
    },
    /// Least squares without active limits.
    NoLimitActive,
    /// Exchange method: rows are added at the extrema until no limit is exceeded.
    Exchange { rounds: usize, violation: f64 },
    /// A sequence of convex programs.
    Sequence {
        programs: usize,
        ended: Ended,
        violation: f64,
    },
}

/// Reason why a sequence of convex programs ended.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // Why the sequence of programs under a limit of torque ended; designs without one have no such end.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let force = scene.model_force()?;
/// assert!(synthesise(&scene, force.as_ref())?.solver.ended().is_none());
/// let held = synthesise(&scene.with("limits.torque", "12 N m")?, force.as_ref())?;
/// assert!(held.solver.ended().is_some());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Ended {
    /// The caller stopped the search.
    OutOfTime,
    /// The maximum number of steps was reached.
    MostSteps,
    /// The linearised program has no solution except the last law.
    NoSolution,
    /// No fraction of the last step improves the objective.
    NoImprovement,
    /// The improvement per step is too small.
    SmallGain,
}

/// Reason why the harmonics in closed form were not used.
///
/// ```
/// use gaitcam::scene::{Family, Gait, LawSpec};
/// use gaitcam::synth::PassedOver;
/// use gaitcam::{LimitKind, Scene};
/// use gaitcam::scene::Limits;
/// use gaitcam::synth::synthesise;
///
/// // Harmonics that reach the accuracy need more stroke than is allowed: a spline takes over.
/// let scene = Scene {
///     gait: Some(Gait { step_frequency: Some(1.85), ..Gait::model("young") }),
///     law: LawSpec::of(Family::Auto),
///     limits: Limits::default().with(LimitKind::Stroke, 0.045),
///     rms: Some(0.005),
///     ..Scene::default()
/// };
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert_eq!(design.family, Family::Spline);
/// assert!(matches!(design.solver.passed_over, Some(PassedOver::Check { .. } | PassedOver::Accuracy { .. })));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)]
pub enum PassedOver {
    /// The harmonics do not reach the accuracy of the force.
    Accuracy {
        family: &'static str,
        excess: Quantity,
    },
    /// The cam of the harmonics violates a limit.
    Check {
        family: &'static str,
        check: Criterion,
        value: Quantity,
        limit: Quantity,
    },
    /// The closed form does not apply to the problem.
    Fault { family: &'static str, fault: String },
}

impl Method {
    /// Clause that describes the method.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "method", self)
    }
}

impl Ended {
    /// Clause that describes the reason.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "ended", self)
    }
}

impl PassedOver {
    /// Clause that describes the reason.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "passed-over", self)
    }
}
