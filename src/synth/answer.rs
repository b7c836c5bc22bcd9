//! What a synthesis answers: plain data that emitters and sweeps read.

use crate::cam::{BarrelGroove, Cam, Check, Conjugate, Verdict};
use crate::drive::Drive;
use crate::gait::ForceCurve;

/// Everything known about a finished design.
#[derive(Debug, Clone)]
pub struct Synthesis {
    /// The scene's name.
    pub name: String,
    /// The force that was wanted, in step with the cam: θ = 2π·i/n. `None` for classical programmes.
    pub target: Option<ForceCurve>,
    /// How lift becomes force, with every number settled.
    pub drive: Drive,
    /// Family of the law as users name it: `spline`, `polynomial`, `program` …
    pub family: String,
    /// Parameters of the law as `summary.json` lists them: monomial coefficients in θ/β for a
    /// polynomial, spline coefficients for a spline; m.
    pub coefficients: Vec<f64>,
    /// Degree of the law's polynomials as users name it (the double harmonic and its kin: 0).
    pub degree: usize,
    /// The cam with its law.
    pub cam: Cam,
    /// The pair with its second cam, where the scene asks for one.
    pub conjugate: Option<Conjugate>,
    /// The groove of a barrel cam with both walls.
    pub groove: Option<BarrelGroove>,
    /// Diameter of the bore, m.
    pub bore: Option<f64>,
    /// Thickness of the plate, m.
    pub thickness: f64,
    /// Distance of the force from the target.
    pub force: ForceReport,
    /// `None` when built; otherwise why no such cam exists.
    pub infeasible: Option<Infeasible>,
    /// The class of the cam.
    pub verdict: Verdict,
    /// One sentence on the verdict, for a student.
    pub reason: String,
    /// Every limit held against the design.
    pub checks: Vec<Check>,
    /// Limits that shape the law, with what they cost.
    pub binding: Vec<Binding>,
    /// How it was solved.
    pub solver: SolverReport,
    /// Remarks on the problem found before and during solving, in words.
    pub remarks: Vec<String>,
}

/// Force of the cam against the target, N; all values belong to the continuous law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// Name of the limit.
    pub limit: String,
    /// Multiplier: gain of the objective per unit of the limit (SI).
    pub multiplier: f64,
    /// Where it binds, rad.
    pub at: f64,
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
    /// The solver's last word, or why this rung was enough.
    pub status: String,
    /// Iterations over all solves.
    pub iterations: usize,
    /// Every limit was confirmed on the continuous law.
    pub certified: bool,
}

/// Why no such cam exists.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// Names of limits that cannot hold together.
    pub conflict: Vec<String>,
    /// For each of them: the smallest change that makes the rest possible.
    pub relaxations: Vec<Relaxation>,
    /// The whole in one sentence.
    pub words: String,
}

/// The smallest change of one limit that lets the others hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Relaxation {
    /// Name of the limit.
    pub limit: String,
    /// Its present value, SI.
    pub from: f64,
    /// The value that works, SI; `None` when no value of this limit alone helps.
    pub to: Option<f64>,
}
