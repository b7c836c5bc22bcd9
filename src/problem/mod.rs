//! The problem of a design: a scene in which all numbers are resolved for its force. Solvers, checks and searches use these numbers and the
//! properties that follow from them.
//!
//! A problem is complete and immutable. After [`Problem::resolve`], the [`Scene`] is not used again. [`Problem::with`] and
//! [`Problem::at_phase`] create a new problem for another limit, size or phase.

mod accuracy;
mod changed;
mod fits;
mod force_cycle;
mod machine;
mod mean_force;
mod note;
mod notes;
mod on_shaft;
mod size;
mod target;
#[cfg(test)]
mod tests;
mod walkers;

pub(crate) use force_cycle::{ForceCycle, Shape};
use mean_force::MeanForce;
pub use note::Note;
pub(crate) use on_shaft::{Extra, OnShaft, ThroughFloor};
pub(crate) use on_shaft::{product, sum};
pub(crate) use size::Size;
pub(crate) use size::USUAL_PRESSURE_ANGLE;
pub(crate) use size::hub_radius;
pub use target::Target;
pub(crate) use target::piecewise;
use target::{Unturned, typical_lift};
pub use walkers::Served;
pub(crate) use walkers::Walkers;

use std::sync::{Arc, OnceLock};

use crate::criterion::LimitKind;
use crate::drive::{Drive, DriveKind};
use crate::dynamics::Train;
use crate::error::{Placed, Result, SynthError};
use crate::force::{self, ForceCurve, OpenQuestion};
use crate::law::Rise;
use crate::scene::{
    CamSpec, Family, Gait, LawSpec, Limits, MachineSpec, Minimise, Phase, PhaseWeight, Scene,
    Source,
};
use crate::units::G;

/// Default degree of spline laws. For a polydyne cam with damping, the default is higher by two, because the cam depends on the first three
/// derivatives of the force.
const USUAL_DEGREE: usize = 5;
const DAMPED_DEGREE: usize = 7;

/// A design problem, in which all numbers are resolved.
///
/// ```
/// use gaitcam::{Problem, scene};
///
/// // The weight of the mass equals the weight of the walker, so M = 700 N/g.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// assert!((problem.drive.mass - 700.0 / 9.81).abs() < 1e-9);
/// assert!((problem.drive.speed - std::f64::consts::TAU * 1.85).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Problem {
    /// Name of the scene.
    pub name: String,
    /// Drive of the machine, which relates lift and force.
    pub drive: Drive,
    /// Family, size and conditions of the law.
    pub law: LawSpec,
    /// Kind of follower, dimensions and material of the cam.
    pub cam: CamSpec,
    /// Limits that the law and the cam must satisfy, in SI units.
    pub limits: Limits,
    /// Permitted RMS force error, relative to the mean force.
    pub accuracy: Option<f64>,
    /// Degree of the spline, for laws of the spline family.
    pub spline_degree: usize,
    /// One turn of the target force, scaled to the mass if the scene requires this; `None` for a classical programme.
    pub target: Option<Target>,
    /// Minimum and maximum of the permitted force, N, over the turn; `None` without a band.
    pub band: Option<[ForceCurve; 2]>,
    /// Phase of the force cycle at the cam angle 0, rad.
    pub phase: f64,
    /// Whether the design selects the phase.
    pub phase_is_free: bool,
    /// Cached result of [`Problem::length`].
    length: OnceLock<f64>,
    /// Machine parameters that are not part of the drive, such as compliance, floor and shaft inertia.
    pub machine: MachineSpec,
    /// Open questions about the recording that the scene does not accept. Each question has the notes that cause it.
    pub open_questions: Vec<(OpenQuestion, Vec<force::Note>)>,
    /// Weight of the walker to whom the target belongs, N, multiplied by the scaling factor of the target. `None` without a force.
    pub weight_n: Option<f64>,
    /// Number of steps of the walker per turn of the cam; `None` if the source of the force does not contain it.
    pub steps_per_turn: Option<usize>,
    /// Walkers whose mean is the target; `None` for a single cycle.
    pub walkers: Option<Arc<Walkers>>,
    /// Changes of the problem due to a varying shaft speed or a moving floor; `None` at constant speed and on a rigid floor.
    pub on_shaft: Option<Arc<OnShaft>>,
    weights: Vec<PhaseWeight>,
    /// Target and band at phase 0.
    unturned: Option<Arc<Unturned>>,
    /// Mean, duration and spread of the target force; `None` for a classical programme.
    force: Option<MeanForce>,
    /// Notes on scene and recording.
    remarks: Vec<Note>,
}

/// Weight of the walker, N. For a load model, it is the given body weight. For a file, it is the weight of the mass that belongs to the
/// force. If this mass is unknown or the scene gives a period, it is the mean force. If only one foot is recorded, the mean force is
/// divided by the share of this foot.
fn weight(gait: &Gait, force: Option<&ForceCurve>, mean: f64) -> f64 {
    match (&gait.source, gait.period) {
        (Source::Model(_) | Source::Harmonics(_), _) => gait.model_weight(),
        (Source::File(_), Some(_)) => mean,
        (Source::File(_), None) => {
            let known = force.and_then(|f| f.mass_kg).map(|m| m * G);
            let walks = force.is_some_and(|f| f.recording.is_some());
            known.unwrap_or(if walks {
                mean / gait.feet.share()
            } else {
                mean
            })
        }
    }
}

/// Limits of a scene. If the scene does not limit the contact pressure and does not switch this check off, the allowable pressure from
/// hardness or material is the limit. This requires a drive with a force.
fn limits(scene: &Scene, drive: &Drive) -> Limits {
    let mut limits = scene.limits.clone();
    if !limits.unjudged.contact_pressure && !drive.is_idle() {
        let given = limits[LimitKind::HertzPressure];
        limits[LimitKind::HertzPressure] = given.or_else(|| scene.cam.allowable_pressure());
    }
    limits
}

/// Number of steps in a cycle of force. It is two for the strides of a recording or of one foot in a load model, and one for other models.
/// For a file with one cycle, it is the number in the file; `None` if the file does not contain it.
fn steps_per_turn(gait: &Gait, force: Option<&ForceCurve>) -> Option<usize> {
    match &gait.source {
        Source::Model(name) => {
            let of_one_foot = |m: &&force::ModelInfo| m.name == name && m.single_foot;
            let is_stride =
                force::catalogue().iter().any(|m| of_one_foot(&m)) && gait.feet.share() < 1.0;
            Some(if is_stride { 2 } else { 1 })
        }
        Source::Harmonics(_) => Some(1),
        Source::File(_) => {
            let force = force?;
            force.recording.as_ref().map_or(force.steps, |_| Some(2))
        }
    }
}

impl Problem {
    /// Resolves speed, mass, target and band of a scene. If the phase is free, the problem has the phase 0.
    ///
    /// # Errors
    ///
    /// The scene requires a force, but none is given. The mean force is not positive on a moving axis. The force of the drive does not
    /// depend on the lift. The band requires a spread, but the force has no spread.
    pub fn resolve(scene: &Scene, force: Option<&ForceCurve>) -> Result<Problem> {
        let cycle = force.map(|force| Arc::new(ForceCycle::new(force.clone())));
        let problem = Problem::of_multiple(scene, cycle.as_ref().map(|cycle| (cycle, 1.0)))?;
        Ok(Problem {
            remarks: note::remarks(scene, force),
            ..problem
        })
    }

    /// Resolves the problem for a multiple of a force that several problems share. The result is that of [`Problem::resolve`] without the
    /// notes on scene and recording. In a sweep of closed-form designs, these notes would need a third of the computing time of a row, and
    /// the table does not contain them.
    pub(crate) fn of_multiple(
        scene: &Scene,
        force: Option<(&Arc<ForceCycle>, f64)>,
    ) -> Result<Problem> {
        let with_gait;
        let scene = match (&scene.gait, force) {
            (Some(_), None) => return Err(SynthError::ForceNotRead.at_key("gait")),
            (None, Some(_)) => {
                let gait = Some(Gait::given());
                with_gait = Scene {
                    gait,
                    ..scene.clone()
                };
                &with_gait
            }
            (None, None) | (Some(_), Some(_)) => scene,
        };
        let gait = scene.gait.as_ref();
        let mean = force.map(|(cycle, times)| cycle.mean.times(times));
        // A load model provides only its force, without notes or questions.
        let given = force.and_then(|(cycle, _)| cycle.given());
        let curve = given.map(|curve| &**curve);
        let (drive, scaling) = machine::of_force(scene, mean)?;
        let mean = mean.map(|mean| scaling.of_mean(mean));
        let walkers = Walkers::of(scene, curve, &drive, mean)?.map(Arc::new);
        let weight_n = gait.zip(force).map(|(gait, (cycle, times))| {
            scaling.factor * weight(gait, curve, times * cycle.mean.mean_n)
        });
        let band = gait.and_then(|g| g.band);
        let band = band.map(|band| band.at_lever(drive.lever));
        let target = force.map(|(cycle, times)| Target::of(cycle.clone(), scaling.after(times)));
        let unturned = target.map(|target| Unturned::new(target, band));
        let unturned = unturned.transpose()?;
        let phase = gait.map_or(Phase::At(0.0), |g| g.phase);
        let at = match phase {
            Phase::At(angle) => angle,
            Phase::Free => 0.0,
        };
        let (target, band) = (unturned.as_ref()).map_or((None, None), |c| c.at_phase(at));
        let has_speed = scene.drive.speed.is_some() && scene.drive.kind != DriveKind::MovingAxis;
        let damped = scene.law.polydyne && scene.machine.damping_ratio > 0.0;
        let limits = limits(scene, &drive);
        Ok(Problem {
            name: scene.name.clone(),
            length: OnceLock::new(),
            spline_degree: scene.law.degree.unwrap_or(if damped {
                DAMPED_DEGREE
            } else {
                USUAL_DEGREE
            }),
            law: law_at_lever(&scene.law, drive.lever),
            drive,
            cam: scene.cam.clone(),
            limits,
            accuracy: scene.rms,
            target,
            band,
            phase: at,
            phase_is_free: unturned.is_some() && phase == Phase::Free,
            machine: scene.machine.clone(),
            open_questions: open_questions(gait, curve, has_speed),
            weight_n,
            steps_per_turn: gait.and_then(|gait| steps_per_turn(gait, curve)),
            walkers: walkers.map(|all| match at {
                0.0 => all,
                at => Arc::new(all.begun_at(at)),
            }),
            on_shaft: None,
            weights: gait.map_or_else(Vec::new, |g| g.weights.clone()),
            unturned: unturned.map(Arc::new),
            force: mean,
            remarks: Vec::new(),
        })
    }

    /// Copy of the problem in which the turn of the cam starts at the phase `phase` of the force cycle, rad.
    #[must_use]
    pub fn at_phase(&self, phase: f64) -> Problem {
        let at = |unturned: &Arc<Unturned>| unturned.at_phase(phase);
        let (target, band) = self.unturned.as_ref().map_or((None, None), at);
        let mut out = self.clone();
        (out.phase, out.target, out.band) = (phase, target, band);
        out.length = OnceLock::new();
        let turned = |all: &Arc<Walkers>| Arc::new(all.begun_at(phase - self.phase));
        out.walkers = self.walkers.as_ref().map(turned);
        out
    }

    /// Typical lift, m. The solvers use it as unit of length; closed-form laws do not need it. It is computed only when it is needed,
    /// because the computation requires the samples of the force.
    pub fn length(&self) -> f64 {
        let typical = || typical_lift(&self.drive, self.target.as_ref(), &self.law);
        *self.length.get_or_init(typical)
    }

    /// Whether the problem has a single force and a simple machine: constant shaft speed, rigid floor, no learned force, and no polydyne
    /// cam.
    pub fn is_plain(&self) -> bool {
        let is_one = self.walkers.is_none() && self.on_shaft.is_none();
        is_one && self.machine.is_plain() && !self.law.polydyne
    }

    /// Quantity that the law minimises. The default is the force error if there is a target and no band, otherwise the jerk.
    pub fn objective(&self) -> Minimise {
        let default = if self.target.is_some() && self.band.is_none() {
            Minimise::ForceError
        } else {
            Minimise::Energy(3)
        };
        self.law.minimise.unwrap_or(default)
    }

    /// Whether the mean lift is determined by a spring, a condition on the lift, or a programme.
    pub fn level_is_known(&self) -> bool {
        self.drive.spring_rate != 0.0
            || self.law.points.iter().any(|p| p.lift.is_some())
            || self.law.dwells.iter().any(|d| d.lift.is_some())
            || self.law.family == Family::Program
    }

    /// Whether the scene prescribes points or dwells of the law.
    pub fn has_demands(&self) -> bool {
        !(self.law.points.is_empty() && self.law.dwells.is_empty())
    }

    /// Compliance between cam and mass; `None` for a rigid follower.
    ///
    /// # Errors
    ///
    /// A natural frequency is given without a mass.
    pub fn train(&self) -> Result<Option<Train>> {
        self.machine.train(&self.drive)
    }

    /// Dwells of the law as first and last cam angle, rad, in ascending order. They include prescribed dwells and the dwells of a
    /// programme.
    pub fn rests(&self) -> Vec<(f64, f64)> {
        let mut all: Vec<(f64, f64)> = self.law.dwells.iter().map(|d| (d.from, d.to)).collect();
        let mut at = 0.0;
        for segment in &self.law.segments {
            if segment.motion == Rise::Dwell {
                all.push((at, at + segment.angle));
            }
            at += segment.angle;
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    }

    /// Lift, m, at which the machine has a given force, N. `None` unless the force depends only on the lift. This is the case for a
    /// hydraulic drive and for a spring without mass and damping.
    pub fn lift_of_force(&self, force: f64) -> Option<f64> {
        let w = self.drive.weights();
        (w[0] != 0.0 && w[1] == 0.0 && w[2] == 0.0).then(|| (force - self.drive.rest_force) / w[0])
    }
}

/// Copy of the law of a scene. Conditions on the force are multiplied by the lever, m. For an arm, they are then conditions on the moment,
/// N·m.
fn law_at_lever(law: &LawSpec, lever: f64) -> LawSpec {
    let mut law = law.clone();
    for force in law.points.iter_mut().filter_map(|p| p.force.as_mut()) {
        *force *= lever;
    }
    law
}

/// Open questions about a recording that the scene does not accept, with the notes that cause them. `has_speed` is true if the scene
/// prescribes the speed of a drive other than a moving axis. The stride time is then not required.
fn open_questions(
    gait: Option<&Gait>,
    force: Option<&ForceCurve>,
    has_speed: bool,
) -> Vec<(OpenQuestion, Vec<force::Note>)> {
    let (Some(gait), Some(force)) = (gait, force) else {
        return Vec::new();
    };
    let recording = force.recording.as_ref();
    let notes = recording.map_or(&force.notes[..], |r| &r.warnings);
    let opened = |question: OpenQuestion| (question, force::Note::opening(notes, question));
    let is_assumed = |note: &force::Note| matches!(note, force::Note::StrideAssumed { .. });
    let open = force::Note::doubts(notes).into_iter().map(opened);
    open.filter(|(question, notes)| {
        // If the scene prescribes the speed, the stride time is not required.
        let is_settled =
            has_speed && *question == OpenQuestion::Clock && notes.iter().all(is_assumed);
        !is_settled && !gait.accept.contains(question)
    })
    .collect()
}
