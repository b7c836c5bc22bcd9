//! Solution method of a law, and reasons against simpler families. The messages are in `wording/en/solver.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::cam::Criterion;
use crate::units::Quantity;
use crate::wording::{self, Language};

/// Method by which the law of a design was computed.
///
/// ```
/// use gaitcam::synth::Method;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // The load model of Young has four harmonics, so the law has at most four harmonics.
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
    /// Segments of a given programme, without an optimisation.
    Programme,
    /// Interpolation: the number of conditions equals the number of coefficients, so the law is the solution of one linear system.
    Interpolation,
    /// Closed form for each harmonic. `rest` is the RMS force of the omitted harmonics.
    Spectral { harmonics: usize, rest: Quantity },
    /// Harmonics under limits, computed by the exchange method (rows are added where limits are violated).
    Harmonics {
        harmonics: usize,
        rounds: usize,
        violation: f64,
    },
    /// Search for the angles of rise and fall of a double harmonic.
    Search {
        rise: Quantity,
        from: Quantity,
        fall: Quantity,
        steps: usize,
        error: Quantity,
    },
    /// Least squares, because no limit is active.
    NoLimitActive,
    /// Exchange method: rows are added at the points of maximum violation until no limit is violated.
    Exchange { rounds: usize, violation: f64 },
    /// Sequence of convex programs, for limits that are not convex.
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
/// // A torque limit requires a sequence of convex programs, and the report contains the reason for its end. Without a sequence, there is
/// // no reason.
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
    /// The solver found no solution of the program that is linearised about the last law.
    NoSolution,
    /// No fraction of the last step improves the objective.
    NoImprovement,
    /// The improvement per step is too small.
    SmallGain,
}

/// Reason why harmonics in closed form were not used.
///
/// ```
/// use gaitcam::scene::{Family, Gait, LawSpec};
/// use gaitcam::synth::PassedOver;
/// use gaitcam::{LimitKind, Scene};
/// use gaitcam::scene::Limits;
/// use gaitcam::synth::synthesise;
///
/// // The harmonics that reach the accuracy exceed the stroke limit, so a spline is used instead.
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
    /// The harmonics do not reach the required accuracy of the force.
    Accuracy {
        family: &'static str,
        excess: Quantity,
    },
    /// The cam of the harmonics fails a check.
    Check {
        family: &'static str,
        check: Criterion,
        value: Quantity,
        limit: Quantity,
    },
    /// The closed form is not possible. `fault` is the reason.
    Fault { family: &'static str, fault: String },
}

impl Method {
    /// Clause of a message that describes the method.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "method", self)
    }
}

impl Ended {
    /// Clause of a message that describes why the sequence ended.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "ended", self)
    }
}

impl PassedOver {
    /// Clause of a message that describes why harmonics were not used.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "passed-over", self)
    }
}
