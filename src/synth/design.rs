//! What a synthesis answers: plain data that emitters and sweeps read.

use serde::{Serialize, Serializer};

use super::method::{Ended, Method, PassedOver};
use super::parameters::Functions;
use super::proof::Doubt;
use super::qp::{Certificate, Demand};
use super::reason::{Reason, sentences};
use crate::cam::{BarrelGroove, Bore, Cam, Check, Conjugate, Criterion, Measures, Unit, Verdict};
use crate::drive::Drive;
use crate::dynamics::flexible::polydyne::Miss;
use crate::error::SynthError;
use crate::force::ForceCurve;
use crate::law::Law;
use crate::poly::Extreme;
use crate::problem::Note;
use crate::units::{Dimension, Quantity};
use crate::wording::{self, Language};

/// Everything known about a finished design.
#[derive(Debug, Clone)]
pub struct Design {
    /// The scene's name.
    pub name: String,
    /// The force that was wanted, in step with the cam: θ = 2π·i/n. `None` for classical programmes.
    pub target: Option<ForceCurve>,
    /// Weight that load factors are parts of, N: the walker's, as the scene scales it; `None` without a force.
    pub weight_n: Option<f64>,
    /// Lowest and highest force of the band that was asked for in place of the curve.
    pub band: Option<[ForceCurve; 2]>,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    /// How lift becomes force, with every number settled.
    pub drive: Drive,
    /// Family of the law as users name it: `spline`, `polynomial`, `program` …
    pub family: String,
    /// The functions that the law's coefficients belong to.
    pub functions: Functions,
    /// Coefficients of the law (of a polydyne cam: of the follower's end), m.
    pub coefficients: Vec<f64>,
    /// Degree of the law's polynomials as users name it (the double harmonic and its kin: 0).
    pub degree: usize,
    /// The cam with its law.
    pub cam: Cam,
    /// The end of the flexible follower that the cam is cut for.
    pub end: Option<End>,
    /// The pair with its second cam, where the scene asks for one.
    pub conjugate: Option<Conjugate>,
    /// The groove of a barrel cam with both walls.
    pub groove: Option<BarrelGroove>,
    /// The hole for the shaft.
    pub bore: Option<Bore>,
    /// Whether θ = 0 is engraved on the solid.
    pub mark: bool,
    /// Thickness of the plate, m.
    pub thickness: f64,
    /// Distance of the force from the target.
    pub force: ForceReport,
    /// `None` when built; otherwise why no such cam exists.
    pub infeasible: Option<Infeasible>,
    /// Changes of one limit each that let the whole design pass; filled by `relaxed` for one that does not.
    pub relaxations: Vec<Relaxation>,
    /// Where no single change is enough: all of them by one share, which is.
    pub together: Vec<Relaxation>,
    /// The class of the cam.
    pub verdict: Verdict,
    /// Why, the main reason first.
    pub reasons: Vec<Reason>,
    /// Every limit held against the design.
    pub checks: Vec<Check>,
    /// Limits that shape the law, with what they cost.
    pub binding: Vec<Binding>,
    /// What easing each of them by 1 % would buy, the dearest first.
    pub easing: Vec<Easing>,
    /// How it was solved.
    pub solver: SolverReport,
    /// A search was ended from outside: this is the best it had.
    pub out_of_time: bool,
    /// What to know beside the verdict.
    pub notes: Vec<Note>,
}

/// What the end of a flexible follower does, where the cam is cut for it (`law.polydyne`).
#[derive(Debug, Clone)]
pub struct End {
    /// Law of the end; the cam's own differs from it by the follower's give.
    pub law: Law,
    /// Stiffness of the follower train, N/m (an arm: N·m/rad).
    pub stiffness: f64,
    /// Its damping, N·s/m.
    pub damping: f64,
    /// How far the end of the flexible follower stays from its law when this cam is run; `None` where
    /// nothing is steady.
    pub miss: Option<Miss>,
    /// The same for a cam cut to the law itself.
    pub plain_miss: Option<Miss>,
}

impl Infeasible {
    /// The names of what conflicts, as in `summary.json`.
    pub fn names(&self) -> Vec<String> {
        self.conflict.iter().map(|c| c.name()).collect()
    }

    /// Conflict and cure as sentences.
    pub fn sentence(&self, language: Language) -> String {
        sentences(&self.reasons, language)
    }

    /// The same as the fault of a scene for which there is nothing to show.
    pub(super) fn no_law(&self) -> SynthError {
        let reason = serde_json::to_value(self.reasons.first()).unwrap_or_default();
        SynthError::NoLaw { reason }
    }
}

impl Design {
    /// The reasons for the verdict as sentences.
    pub fn reason(&self, language: Language) -> String {
        sentences(&self.reasons, language)
    }

    /// The notes as sentences.
    pub fn remarks(&self, language: Language) -> Vec<String> {
        let said = |note: &Note| note.sentence(language);
        self.notes.iter().map(said).collect()
    }

    /// What a run of the emitted cam adds to the verdict: the follower is off the cam for this share of the
    /// motion.
    pub fn loses_contact(&mut self, share: f64) {
        let known = |r: &Reason| {
            matches!(
                r,
                Reason::ContactLost { .. }
                    | Reason::LiftsOff { .. }
                    | Reason::LiftsOffAsPrescribed { .. }
            )
        };
        if !self.reasons.iter().any(known) {
            let share = Quantity::share(share);
            self.reasons.retain(|r| *r != Reason::AllHold);
            self.reasons.insert(0, Reason::ContactLostInRun { share });
        }
        self.verdict = Verdict::Unacceptable;
    }

    /// Whether the drive presses with nothing: no mass, spring, damping or preload is given.
    pub fn is_idle(&self) -> bool {
        self.drive.is_idle()
    }

    /// Smallest and largest pressure angle, rad; of a barrel at the floor of its groove, where the roller
    /// is pushed most aslant.
    pub fn pressure_angle_extremes(&self) -> (Extreme, Extreme) {
        match &self.groove {
            Some(groove) => groove.pressure_angle_extremes(groove.depth().0),
            None => self.cam.pressure_angle_extremes(),
        }
    }

    /// The law that makes the force: a polydyne cam's end, the cam's own otherwise.
    pub fn pressing(&self) -> &Law {
        self.end.as_ref().map_or(&self.cam.law, |end| &end.law)
    }
}

/// Force of the cam against the target, N; all values belong to the continuous law.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ForceReport {
    /// Root mean square over the cycle.
    pub rms_error_n: f64,
    /// Largest absolute difference.
    pub max_error_n: f64,
    /// RMS error as percent of the mean target.
    pub rms_error_percent_of_mean: f64,
    /// Mean of the target.
    pub target_mean_n: f64,
    /// Mean of the cam's force.
    pub mean_n: f64,
    /// Smallest force.
    pub min_n: f64,
    /// Largest force.
    pub max_n: f64,
}

/// A limit that holds with equality and pushes on the law.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Binding {
    /// The limit.
    pub limit: Criterion,
    /// Multiplier: gain of the objective per unit of the limit (SI).
    pub multiplier: f64,
    /// Where it binds, rad.
    #[serde(rename = "at_rad")]
    pub at: f64,
}

/// What easing one limit by 1 % would buy, to first order.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Easing {
    /// The limit, or the scene's own number where that is another.
    pub limit: Criterion,
    /// Its value, SI.
    pub from: f64,
    /// The value eased, SI.
    pub to: f64,
    /// What is minimised.
    pub objective: Minimised,
    /// Its value.
    pub before: f64,
    /// Its value with the limit eased.
    pub after: f64,
}

/// The quantity that a scene minimises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Minimised {
    /// RMS force error, N.
    RmsError,
    /// The same with phases weighed.
    WeightedRmsError,
    /// Largest force error, N.
    MaxError,
    /// Base or prime radius, m.
    Radius,
    /// RMS of a derivative by cam angle, m/radᵏ.
    RmsDerivative(usize),
    /// Largest value of a derivative by cam angle, m/radᵏ.
    PeakDerivative(usize),
    /// Force error, radius and jerk weighed against each other.
    Weighed,
}

impl Minimised {
    /// Its name in `summary.json`.
    pub fn name(self) -> String {
        match self {
            Minimised::RmsError => "rms_error_n".to_string(),
            Minimised::WeightedRmsError => "weighted_rms_error_n".to_string(),
            Minimised::MaxError => "max_error_n".to_string(),
            Minimised::Radius => "radius_m".to_string(),
            Minimised::RmsDerivative(order) => format!("rms_derivative_{order}"),
            Minimised::PeakDerivative(order) => format!("peak_derivative_{order}"),
            Minimised::Weighed => "weighed".to_string(),
        }
    }
}

impl Serialize for Minimised {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

/// A member of an irreducible infeasible set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Conflicting {
    /// A limit.
    Limit(Criterion),
    /// A demand on the law.
    Demand(Demand),
}

impl Conflicting {
    /// Its name in `summary.json`.
    pub fn name(self) -> String {
        match self {
            Conflicting::Limit(limit) => limit.name().to_string(),
            Conflicting::Demand(demand) => demand.name(),
        }
    }

    /// What it is called in text.
    pub fn sentence(self, language: Language) -> String {
        match self {
            Conflicting::Limit(limit) => wording::catalogue(language).name(limit.name()),
            Conflicting::Demand(demand) => wording::sentence(language, "demand", &demand),
        }
    }
}

impl Easing {
    /// The objective as people call it, the unit to show it in, and SI's factor to that unit.
    pub fn in_words(&self, measures: Measures, language: Language) -> (String, &'static str, f64) {
        let unit = match self.objective {
            Minimised::RmsError | Minimised::WeightedRmsError | Minimised::MaxError => {
                measures.force()
            }
            Minimised::Radius => Unit::of(Dimension::Length),
            Minimised::RmsDerivative(order) | Minimised::PeakDerivative(order) => {
                measures.lift(order)
            }
            Minimised::Weighed => Unit::of(Dimension::Ratio),
        };
        let name = wording::catalogue(language).name(&self.objective.name());
        (name, unit.name, unit.factor)
    }
}

/// One convex program of a sequence, as it was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Prime radius after the step, m.
    pub prime_radius: f64,
    /// Objective after the step.
    pub merit: f64,
    /// Smallest distance to undercut or the sharpest curvature allowed, without unit; not below zero.
    pub clearance: f64,
    /// Part of the step that was taken.
    pub taken: f64,
}

/// Which rung of the ladder answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// Closed form, harmonic by harmonic.
    Spectral,
    /// Least squares with equalities: one factorisation.
    Equality,
    /// Convex quadratic program.
    Qp,
    /// Second-order cone program.
    Socp,
    /// Sequence of convex programs.
    Scp,
}

impl Tier {
    /// The word of `summary.json`.
    pub fn name(self) -> &'static str {
        match self {
            Tier::Spectral => "spectral",
            Tier::Equality => "equality",
            Tier::Qp => "qp",
            Tier::Socp => "socp",
            Tier::Scp => "scp",
        }
    }
}

/// How the design was found.
#[derive(Debug, Clone, PartialEq)]
pub struct SolverReport {
    /// The rung that answered.
    pub tier: Tier,
    /// How that rung found the law.
    pub method: Method,
    /// Simpler families that were tried first, and what they missed.
    pub passed_over: Vec<PassedOver>,
    /// Iterations over all solves.
    pub iterations: usize,
    /// Limits hold on the continuous law, and no law of the family is better by more than 1e-6 of the objective.
    pub certified: bool,
    /// Why it is not certified.
    pub doubt: Option<Doubt>,
    /// How near to the optimum the law is proved to be; `None` where nothing was minimised.
    pub certificate: Option<Certificate>,
    /// The sequence of convex programs, where one was needed.
    pub steps: Vec<Step>,
}

impl SolverReport {
    /// How the law was found and what simpler families missed.
    pub fn status(&self, language: Language) -> String {
        let missed = self.passed_over.iter().map(|p| p.sentence(language));
        let all: Vec<String> = std::iter::once(self.method.sentence(language))
            .chain(missed)
            .collect();
        all.join("; ")
    }

    /// Why the sequence of convex programs ended; `None` without one.
    pub fn ended(&self) -> Option<Ended> {
        match self.method {
            Method::Sequence { ended, .. } => Some(ended),
            _ => None,
        }
    }
}

/// Why no such cam exists.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// Limits or demands that cannot hold together.
    pub conflict: Vec<Conflicting>,
    /// For each of them: the smallest change that makes the rest possible.
    pub relaxations: Vec<Relaxation>,
    /// The same as reasons, with what would help.
    pub reasons: Vec<Reason>,
}

/// The smallest change of one limit that lets the others hold.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Relaxation {
    /// The limit.
    pub limit: Criterion,
    /// Its key, as typed after `--set`.
    pub key: &'static str,
    /// Its present value, SI.
    pub from: f64,
    /// The value that works, SI; `None` when no value of this limit alone helps.
    pub to: Option<f64>,
}
