//! Report on the solution method of a design.

use serde::Serialize;

use super::method::{Ended, Method, PassedOver};
use super::proof::Doubt;
use crate::synth::qp::Certificate;
use crate::wording::Language;

/// Accepted step of a sequence of convex programs.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // No step of a sequence of convex programs increases the objective.
/// let scene = scene::built_in("footbridge")?.scene()?.with("limits.torque", "12 N m")?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert!(!design.solver.steps.is_empty());
/// assert!(design.solver.steps.windows(2).all(|s| s[1].merit <= s[0].merit));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Step {
    /// Prime radius after the step, m.
    pub prime_radius: f64,
    /// Value of the objective after the step.
    pub merit: f64,
    /// Minimum clearance of the non-convex limits over the law after the step, relative to the scale of each limit.
    pub clearance: f64,
    /// Accepted fraction of the step, from 0 to 1.
    pub taken: f64,
}

/// Class of the solution method.
///
/// ```
/// use gaitcam::synth::Tier;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // Without active limits, harmonics are computed in closed form. An active limit requires a quadratic program.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let force = scene.model_force()?;
/// let harmonic = synthesise(&scene.with("law.family", "harmonic")?, force.as_ref())?;
/// assert_eq!(harmonic.solver.tier, Tier::Spectral);
/// let held = synthesise(&scene.with("limits.stroke", "40 mm")?, force.as_ref())?;
/// assert_eq!(held.solver.tier, Tier::Qp);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Tier {
    /// Closed form for each harmonic, without limits.
    Spectral,
    /// Least squares with equalities: one factorisation.
    Equality,
    /// Convex quadratic program (QP).
    Qp,
    /// Second-order cone program (SOCP).
    Socp,
    /// Sequence of convex programs (SCP).
    Scp,
}

impl Tier {
    /// Name of the class in `summary.json`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Report on the solution of a design.
///
/// ```
/// use gaitcam::wording::Language;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let solver = synthesise(&scene, scene.model_force()?.as_ref())?.solver;
/// assert!(solver.certified && solver.doubt.is_none());
/// assert!(!solver.status(Language::En).is_empty());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolverReport {
    /// Class of the solution method.
    pub tier: Tier,
    /// Details of the solution method, such as numbers of iterations.
    pub method: Method,
    /// Reason why harmonics in closed form were not used; `None` if they were not tried.
    pub passed_over: Option<PassedOver>,
    /// Total number of iterations of all programs.
    pub iterations: usize,
    /// Whether the law is proved optimal. The limits then hold for the continuous law, and no law of the family improves the objective by more
    /// than 1e-6 of its value.
    pub certified: bool,
    /// Reason why the law is not certified; `None` for a certified law.
    pub doubt: Option<Doubt>,
    /// Proved distance from the optimum; `None` if the law was not computed by minimising a quantity in a program.
    pub certificate: Option<Certificate>,
    /// Steps of the sequence of convex programs; empty without a sequence.
    pub steps: Vec<Step>,
}

impl SolverReport {
    /// Report on a method that computes the law without a numerical certificate.
    pub(crate) fn of(tier: Tier, method: Method, iterations: usize) -> SolverReport {
        SolverReport {
            tier,
            method,
            passed_over: None,
            iterations,
            certified: true,
            doubt: None,
            certificate: None,
            steps: Vec::new(),
        }
    }

    /// Message on the method, and on the reason why harmonics were not used.
    pub fn status(&self, language: Language) -> String {
        let missed = self.passed_over.iter().map(|p| p.sentence(language));
        let all: Vec<String> = std::iter::once(self.method.sentence(language))
            .chain(missed)
            .collect();
        all.join("; ")
    }

    /// Reason why the sequence of convex programs ended; `None` without a sequence.
    pub fn ended(&self) -> Option<Ended> {
        match self.method {
            Method::Sequence { ended, .. } => Some(ended),
            _ => None,
        }
    }
}
