//! Outcome for a scene: a design, or the reason why there is no cam.

use super::{Design, Search, design};
use crate::error::{Error, Result};
use crate::force::ForceCurve;
use crate::problem::Problem;
use crate::scene::Scene;

/// Outcome for a scene: a design, or the reason why there is no cam.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::{Outcome, Search, answer};
///
/// let arm = scene::built_in("camdas_02_oscillating_roller")?.scene()?;
/// assert!(matches!(answer(&arm, None, &Search::default())?, Outcome::Built(_)));
/// // The arm would swing beyond the line through pivot and cam centre.
/// let impossible = arm.with("law.segment.1.lift", "170 deg")?.with("law.segment.3.lift", "-170 deg")?;
/// assert!(matches!(answer(&impossible, None, &Search::default())?, Outcome::NoCam(_)));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub enum Outcome {
    /// A design. Its verdict states whether the design satisfies the limits. If the limits are infeasible, it is the best design without them.
    Built(Box<Design>),
    /// There is no cam. The error contains the reason.
    NoCam(Error),
}

/// Designs the cam of a scene. `force` is one cycle of the target force, if the scene has one.
///
/// # Errors
///
/// Errors of the input.
pub fn answer(scene: &Scene, force: Option<&ForceCurve>, search: &Search) -> Result<Outcome> {
    let problem = Problem::resolve(scene, force);
    Outcome::of(problem.and_then(|problem| design(&problem, search)))
}

impl Outcome {
    /// Converts the result of a synthesis to an outcome. An error that means that no cam satisfies the scene becomes `NoCam`.
    ///
    /// # Errors
    ///
    /// Errors of the input.
    pub fn of(design: Result<Design>) -> Result<Outcome> {
        match design {
            Ok(design) => Ok(Outcome::Built(Box::new(design))),
            Err(why) if why.is_answer() => Ok(Outcome::NoCam(why)),
            Err(fault) => Err(fault),
        }
    }

    /// Returns the design.
    ///
    /// # Errors
    ///
    /// There is no cam. The error contains the reason.
    pub fn built(self) -> Result<Design> {
        match self {
            Outcome::Built(design) => Ok(*design),
            Outcome::NoCam(why) => Err(why),
        }
    }

    /// Adds suggested changes to the design if it fails a check.
    #[must_use]
    pub fn relaxed_with(self, search: &Search) -> Outcome {
        match self {
            Outcome::Built(design) => Outcome::Built(Box::new(design.relaxed_with(search))),
            no_cam => no_cam,
        }
    }
}
