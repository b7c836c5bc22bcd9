//! Result of a design, as plain data for output files and sweeps.

pub mod edge;
mod emitted;
pub mod figures;
mod in_run;
pub mod load_factors;
pub mod machine;
pub mod resonance;
mod strides;
pub mod walker;

use std::f64::consts::TAU;
use std::sync::Arc;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::cam::{BarrelGroove, Cam, Check, Conjugate, Verdict};
use crate::drive::Drive;
use crate::dynamics::hertz::line;
use crate::dynamics::{FloorMotion, touch};
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::{Extreme, PiecewisePoly};
use crate::problem::{Note, Problem};
use crate::scene::Family;
use crate::synth::report::end::End;
use crate::synth::report::force::ForceReport;
use crate::synth::report::limited::{Binding, Easing, Infeasible, Relaxation};
use crate::synth::report::parameters::Functions;
use crate::synth::report::reason::{Reason, sentences};
use crate::synth::report::shaft::OnShaft;
use crate::synth::report::solver::SolverReport;
use crate::synth::report::walkers::OfPopulation;
use crate::wording::Language;

/// A finished design of a cam.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::cam::Verdict;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert_eq!(design.verdict, Verdict::Acceptable);
/// assert!(design.checks.iter().all(|check| check.pass));
/// // The serialised design contains the law, the dimensions of the cam, and the verdict with its reasons.
/// let data = serde_json::to_value(&design).unwrap();
/// assert_eq!(data["verdict"], "acceptable");
/// assert_eq!(data["problem"]["drive"]["mass"], 700.0 / 9.81);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Design {
    /// Design problem that was solved. Serialised data contain only its name, drive and phase.
    #[serde(serialize_with = "in_short")]
    pub problem: Arc<Problem>,
    /// Family of the law, such as splines or harmonics.
    pub family: Family,
    /// Basis functions to which the coefficients belong.
    pub functions: Functions,
    /// Coefficients of the law, m. For a polydyne cam, they belong to the law of the follower's end.
    pub coefficients: Vec<f64>,
    /// Degree of the polynomials of the law for display; 0 for laws without polynomials, such as the double harmonic.
    pub degree: usize,
    /// The cam with its law.
    pub cam: Cam,
    /// End of the compliant follower for which a polydyne cam is designed; `None` for other cams.
    pub end: Option<End>,
    /// Cam and second cam of a conjugate pair; `None` without a pair.
    pub conjugate: Option<Conjugate>,
    /// Groove of a barrel cam with both walls; `None` for other cams.
    pub groove: Option<BarrelGroove>,
    /// Comparison of the achieved force with the target force.
    pub force: ForceReport,
    /// Reason why the limits are infeasible; `None` for a feasible design.
    pub infeasible: Option<Infeasible>,
    /// Changes of one limit each. Each change alone is sufficient for the complete design to pass. `relaxed` computes the changes for a
    /// design that fails.
    pub relaxations: Vec<Relaxation>,
    /// A common relative change of several limits for which the design passes. It is given if no single change is sufficient, or if only a
    /// larger permitted force error is sufficient.
    pub together: Vec<Relaxation>,
    /// Verdict on the cam.
    pub verdict: Verdict,
    /// Reasons for the verdict, the main one first.
    pub reasons: Vec<Reason>,
    /// Checks of all limits and of general requirements.
    pub checks: Vec<Check>,
    /// Active limits, with their multipliers.
    pub binding: Vec<Binding>,
    /// Gain from relaxing each active limit by 1 %, in descending order.
    pub easing: Vec<Easing>,
    /// Solution method and certificate.
    pub solver: SolverReport,
    /// Whether the search was stopped early. The design is then the best design found until then.
    pub out_of_time: bool,
    /// Notes in addition to the verdict.
    pub notes: Vec<Note>,
    /// Report on the motor-driven shaft; `None` for constant speed.
    pub shaft: Option<OnShaft>,
    /// Steady motion of the floor with the shaker and all walkers; `None` for a rigid floor.
    pub floor: Option<FloorMotion>,
    /// Force errors for several walkers; `None` for a single cycle.
    pub population: Option<OfPopulation>,
}

fn in_short<S: Serializer>(problem: &Problem, to: S) -> Result<S::Ok, S::Error> {
    let mut out = to.serialize_struct("Problem", 3)?;
    out.serialize_field("name", &problem.name)?;
    out.serialize_field("drive", &problem.drive)?;
    out.serialize_field("phase", &problem.phase)?;
    out.end()
}

impl Design {
    /// Messages of the reasons for the verdict in the given language, joined to one text.
    pub fn reason(&self, language: Language) -> String {
        sentences(&self.reasons, language)
    }

    /// Messages of the notes in the given language.
    pub fn remarks(&self, language: Language) -> Vec<String> {
        let said = |note: &Note| note.sentence(language);
        self.notes.iter().map(said).collect()
    }

    /// Target force as a function of the cam angle, with sample i of n at θ = 2π·i/n. `None` for a design without a target force.
    pub fn target(&self) -> Option<&ForceCurve> {
        self.problem.target_at_cam()
    }

    /// Minimum and maximum force of the band that replaces the target; `None` without a band.
    pub fn band(&self) -> Option<&[ForceCurve; 2]> {
        self.problem.band_in_time()
    }

    /// The design with the same cam in a machine with another drive.
    #[must_use]
    pub fn on_drive(self, drive: Drive) -> Design {
        let problem = self.problem.with_drive(drive);
        self.of_problem(problem)
    }

    /// The design with the same cam in a machine with another drive and another target over time.
    #[must_use]
    pub fn moved_to(self, drive: Drive, target: Option<ForceCurve>) -> Design {
        let problem = self.problem.against(drive, target);
        self.of_problem(problem)
    }

    /// The design with the same cam in another problem. The force report is computed for this problem.
    fn of_problem(self, problem: Problem) -> Design {
        Design {
            force: ForceReport::of(&problem, self.pressing()),
            problem: Arc::new(problem),
            ..self
        }
    }

    /// Whether the drive produces no force, because no mass, spring, damping or preload is given.
    pub fn is_idle(&self) -> bool {
        self.problem.drive.is_idle()
    }

    /// Contact force as a function of the cam angle, N, at the actual shaft speed.
    pub fn force_curve(&self) -> PiecewisePoly {
        let law = self.pressing();
        match &self.problem.on_shaft {
            None => self.problem.drive.force_curve(law),
            Some(_) => self.problem.force_curve(law),
        }
    }

    /// Contact force at the cam angle `theta`, rad, in N, at the actual shaft speed.
    pub fn force_at(&self, theta: f64) -> f64 {
        self.problem.drive.force(self.pressing().svaj(theta)) + self.problem.extra_force(theta)
    }

    /// Hertz pressure of the contact, Pa, at the cam angle `theta`, rad, for the materials of cam and follower. NaN without a contact force and
    /// for a knife edge.
    pub fn contact_pressure_at(&self, theta: f64) -> f64 {
        let (follower, cam, force) = (&self.cam.follower, &self.problem.cam, self.force_at(theta));
        let is_sharp = !follower.is_flat() && follower.roller_radius() == 0.0;
        if self.is_idle() || is_sharp || force <= 0.0 {
            return f64::NAN;
        }
        let speed = self.problem.drive.speed.abs();
        let contact = touch(follower, speed, 0.0, self.cam.law.svaj(theta), force);
        let modulus = cam.contact_modulus();
        line(contact.normal, cam.thickness, contact.curvature, modulus).pressure
    }

    /// Speed of the shaft, rad/s, and time since cam angle 0, s, at the cam angle `theta` of the first turn, rad.
    pub fn speed_and_time(&self, theta: f64) -> (f64, f64) {
        let Some(shaft) = &self.shaft else {
            let speed = self.problem.drive.speed;
            return (speed, theta / speed);
        };
        let n = shaft.speed.len();
        let x = theta / TAU * n as f64;
        let (i, u) = (x as usize, x - x.floor());
        let mix = |values: &[f64], wrap: f64| {
            let [a, b] = [i, i + 1].map(|k| values[k % n] + if k >= n { wrap } else { 0.0 });
            a + u * (b - a)
        };
        let period = TAU / self.problem.drive.speed.abs();
        (mix(&shaft.speed, 0.0), mix(&shaft.time, period))
    }

    /// Cam angle, rad, at a time that is given as a phase of the period, rad (2π for one period). Cam angle and phase are zero at the same
    /// time. The conversion uses the shaft speed for which the force is computed.
    fn angle_at(&self, phase: f64) -> f64 {
        let shaft = self.shaft.as_ref();
        let Some(shaft) = shaft.filter(|_| self.problem.on_shaft.is_some()) else {
            return phase;
        };
        let period = TAU / self.problem.drive.speed.abs();
        let time = phase / TAU * period;
        let i = shaft.time.partition_point(|t| *t <= time).max(1);
        let from = shaft.time[i - 1];
        let to = shaft.time.get(i).copied().unwrap_or(period);
        TAU * ((i - 1) as f64 + (time - from) / (to - from)) / shaft.time.len() as f64
    }

    /// Target force, N, over one period in time. The period begins at cam angle 0.
    pub fn target_in_time(&self) -> Option<&ForceCurve> {
        self.problem.target_in_time()
    }

    /// Extremes of the pressure angle, rad, first the minimum and then the maximum. For a barrel they are taken at the floor of the groove,
    /// where the angle is largest.
    pub fn pressure_angle_extremes(&self) -> (Extreme, Extreme) {
        match &self.groove {
            Some(groove) => groove.pressure_angle_extremes(groove.depth().0),
            None => self.cam.pressure_angle_extremes(),
        }
    }

    /// Law that determines the force. For a polydyne cam it is the law of the follower's end, otherwise the law of the cam.
    pub fn pressing(&self) -> &Law {
        self.end.as_ref().map_or(&self.cam.law, |end| &end.law)
    }
}
