//! A scene settled once against its force: every number that the solvers, the checks and the searches work
//! with, and every fact that follows from them.
//!
//! Nothing after [`Problem::settle`] looks at the [`Scene`] again. A search that changes a limit changes the
//! problem; what follows from the limits is a method here, so that it follows from the changed ones too.

mod accuracy;
mod changed;
mod machine;
mod memo;
mod notes;
mod size;
mod target;

pub(crate) use accuracy::USUAL_ACCURACY;
pub(crate) use machine::drive_of;
pub(crate) use memo::Memo;
pub use memo::Shared;
pub(crate) use memo::SpanKey;
use memo::{Settled, TargetKey};
pub use notes::Note;
pub(crate) use size::outside_bore;
pub use size::{Size, USUAL_PRESSURE_ANGLE};
pub use target::Target;

use std::f64::consts::TAU;

use crate::drive::{Drive, DriveKind};
use crate::dynamics::Train;
use crate::error::{Placed, Result, SynthError};
use crate::force::{self, ForceCurve, OpenQuestion, implausible};
use crate::halt::Halt;
use crate::law::Rise;
use crate::scene::{
    Band, CamSpec, DriveSpec, Family, ForceScale, Gait, LawSpec, Limits, MachineSpec, Minimise,
    Phase, PhaseWeight, Scene, Source,
};
use crate::units::G;
use target::band_about;

/// Degree of splines, and two more for the first terms of a polydyne follower's damping.
const USUAL_DEGREE: usize = 5;
const DAMPED_DEGREE: usize = 7;

/// The whole problem with every number settled.
///
/// ```
/// use gaitcam::{Problem, scene};
///
/// // The mass is settled so that it weighs as much as the walker: M = 700 N/g.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::settle(&scene, scene.model_force()?.as_ref())?;
/// assert!((problem.drive.mass - 700.0 / 9.81).abs() < 1e-9);
/// assert!((problem.drive.speed - std::f64::consts::TAU * 1.85).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Problem {
    /// Name of the scene.
    pub name: String,
    /// The machine that turns lift into force.
    pub drive: Drive,
    /// One turn of wanted force, scaled to the mass where the scene says so; `None` for a classical
    /// programme.
    pub target: Option<Target>,
    /// Lowest and highest force of the band in which the force has to stay.
    pub band: Option<[ForceCurve; 2]>,
    /// Phase of the force cycle at cam angle 0, rad.
    pub phase: f64,
    /// The phase is to be found.
    pub phase_is_free: bool,
    /// Typical lift, m: the unit in which solvers work.
    pub length: f64,
    /// Family, size and demands of the law.
    pub law: LawSpec,
    /// Follower and lengths.
    pub cam: CamSpec,
    /// Limits in force.
    pub limits: Limits,
    /// What is known of the machine beyond its drive.
    pub machine: MachineSpec,
    /// RMS force error asked for, part of the mean force.
    pub accuracy: Option<f64>,
    /// The law has to stay above the base circle; dropped only to show what demands ask that cannot.
    pub above_base_circle: bool,
    /// What is open about the recording and was not accepted.
    pub open_questions: Vec<(OpenQuestion, Vec<force::Note>)>,
    /// What is already found for this force and law.
    pub(crate) memo: Memo,
    /// When searches are to end.
    pub halt: Halt,
    /// Only a design that passes is of use: what cannot reach the accuracy need not be finished.
    pub only_passing: bool,
    weights: Vec<PhaseWeight>,
    given: Given,
}

/// What was written about force and drive, kept for another phase.
#[derive(Debug, Clone)]
struct Given {
    force: Option<ForceCurve>,
    band: Option<Band>,
    scale: ForceScale,
    /// Weight of the walker before it is scaled, N.
    weight_n: Option<f64>,
    drive: DriveSpec,
    remarks: Vec<Note>,
}

/// Weight of a force's walker, N; of another machine's force its mean.
fn weight(gait: &Gait, force: &ForceCurve) -> f64 {
    let mean = force.mean_n();
    match (&gait.source, gait.period) {
        (Source::Model(_), _) => gait.model_weight(),
        (Source::File(_), Some(_)) => mean,
        (Source::File(_), None) => {
            let known = force.mass_kg.map(|m| m * G);
            known.unwrap_or(mean / gait.feet.share())
        }
    }
}

impl Problem {
    /// Settles speed, mass, target and band. A phase that is free begins its cycle at 0 here.
    ///
    /// # Errors
    /// The scene wants a force and none is given; the mean force is not positive on a moving axis; the drive
    /// relates no lift to force; the band asks for a spread that the force does not have.
    pub fn settle(scene: &Scene, force: Option<&ForceCurve>) -> Result<Problem> {
        Problem::settle_with(scene, force, &Shared::default())
    }

    /// The same, with what problems of the same force and law have found.
    ///
    /// # Errors
    /// As [`Problem::settle`].
    pub fn settle_with(
        scene: &Scene,
        force: Option<&ForceCurve>,
        shared: &Shared,
    ) -> Result<Problem> {
        let gait = scene.gait.as_ref();
        let force = match (gait, force) {
            (Some(_), None) => return Err(SynthError::ForceNotRead.at_key("gait")),
            (None, _) => None,
            (Some(_), Some(curve)) => Some(curve.clone()),
        };
        let phase = match gait.map(|g| g.phase) {
            Some(Phase::At(phase)) => phase,
            _ => 0.0,
        };
        let notes = scene.notes();
        let mut remarks: Vec<Note> = notes.into_iter().map(|note| Note::Scene { note }).collect();
        if let (Some(gait), Some(force)) = (gait, &force)
            && gait.is_recording()
        {
            let doubts = implausible(force, gait.feet).into_iter();
            let doubts = doubts.chain(force.warnings().cloned());
            remarks.extend(doubts.map(|note| Note::Recording { note }));
        }
        let weight_n = gait.zip(force.as_ref()).map(|(g, f)| weight(g, f));
        Problem {
            name: scene.name.clone(),
            drive: Drive::moving_axis(0.0, 0.0, 0.0),
            target: None,
            band: None,
            phase,
            phase_is_free: force.is_some() && gait.is_some_and(|g| g.phase == Phase::Free),
            length: 0.0,
            law: scene.law.clone(),
            cam: scene.cam.clone(),
            limits: scene.limits.clone(),
            machine: scene.machine.clone(),
            accuracy: scene.rms,
            above_base_circle: true,
            open_questions: open_questions(gait, force.as_ref()),
            memo: shared.memo.clone(),
            halt: shared.halt.clone(),
            only_passing: false,
            weights: gait.map_or_else(Vec::new, |g| g.weights.clone()),
            given: Given {
                force,
                band: gait.and_then(|g| g.band),
                scale: gait.map_or(ForceScale::None, |g| g.scale),
                weight_n,
                drive: scene.drive.clone(),
                remarks,
            },
        }
        .at_phase(phase)
    }

    /// The same with the cam's turn beginning at another phase of the force cycle.
    ///
    /// # Errors
    /// As [`Problem::settle`].
    pub fn at_phase(mut self, phase: f64) -> Result<Problem> {
        let key = TargetKey {
            drive: self.given.drive.clone(),
            phase,
        };
        let (drive, target) = self.memo.found::<_, Settled, _>(key, || {
            let force = match &self.given.force {
                Some(curve) if phase != 0.0 => Some(curve.begun_at(phase)),
                other => other.clone(),
            };
            let (drive, force) = machine::settled(&self.given.drive, self.given.scale, force)?;
            Ok::<_, crate::error::Error>((drive, force.map(Target::new)))
        })?;
        if target.is_some() && drive.weights() == [0.0; 4] {
            return Err(SynthError::NoLiftChangesForce.at_key("drive"));
        }
        self.band = match (self.given.band, &target) {
            (Some(band), Some(target)) => Some(band_about(&target.curve, band)?),
            _ => None,
        };
        self.drive = drive;
        self.phase = phase;
        self.target = target;
        self.length = self.typical_lift();
        Ok(self)
    }

    /// Weight of the walker that the target is of, N: scaled as the target is; `None` without a force.
    pub fn weight_n(&self) -> Option<f64> {
        let (weight, force) = self.given.weight_n.zip(self.given.force.as_ref())?;
        let scaled =
            self.drive.kind == DriveKind::MovingAxis && self.given.scale == ForceScale::ToMass;
        Some(if scaled {
            weight * self.drive.rest_force / force.mean_n()
        } else {
            weight
        })
    }

    /// The same with its force and demands, but without a limit and without a band, and with all the time it
    /// takes: such laws are quickly found.
    pub fn without_limits(&self) -> Problem {
        Problem {
            limits: Limits::default(),
            band: None,
            halt: Halt::never(),
            only_passing: false,
            ..self.clone()
        }
    }

    /// What the law is chosen for: the force where one is wanted and no band stands for it, jerk otherwise.
    pub fn objective(&self) -> Minimise {
        let default = if self.target.is_some() && self.band.is_none() {
            Minimise::ForceError
        } else {
            Minimise::Energy(3)
        };
        self.law.minimise.unwrap_or(default)
    }

    /// Whether the law's zero is fixed by the drive or by a demand.
    pub fn level_is_known(&self) -> bool {
        self.drive.spring_rate != 0.0
            || self.law.points.iter().any(|p| p.lift.is_some())
            || self.law.dwells.iter().any(|d| d.lift.is_some())
            || self.law.family == Family::Program
    }

    /// Whether points or dwells are asked of the law.
    pub fn has_demands(&self) -> bool {
        !(self.law.points.is_empty() && self.law.dwells.is_empty())
    }

    /// Degree of spline laws.
    pub fn degree(&self) -> usize {
        let damped = self.law.polydyne && self.machine.damping_ratio > 0.0;
        let usual = if damped { DAMPED_DEGREE } else { USUAL_DEGREE };
        self.law.degree.unwrap_or(usual)
    }

    /// What gives between cam and mass, where it is known.
    ///
    /// # Errors
    /// A natural frequency without a mass.
    pub fn train(&self) -> Result<Option<Train>> {
        self.machine.train(&self.drive)
    }

    /// Natural frequency over shaft speed, where it is known.
    pub fn frequency_ratio(&self) -> Option<f64> {
        self.machine
            .natural_frequency
            .map(|hz| TAU * hz / self.drive.speed)
    }

    /// The rests of the law in order: dwells asked for, or a programme's.
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

    /// The lift that belongs to a force where lift alone decides (hydraulic drive, light spring).
    pub fn lift_of_force(&self, force: f64) -> Option<f64> {
        let w = self.drive.weights();
        (w[0] != 0.0 && w[1] == 0.0 && w[2] == 0.0).then(|| (force - self.drive.rest_force) / w[0])
    }

    fn typical_lift(&self) -> f64 {
        let [k, c, m, _] = self.drive.weights();
        let from_force = self.target.as_ref().map_or(0.0, |target| {
            let largest = target.farthest_from(self.drive.rest_force);
            let gain = k + c + m;
            if gain > 0.0 { largest / gain } else { 0.0 }
        });
        let points = &self.law.points;
        let lifts = points
            .iter()
            .filter_map(|p| p.lift)
            .chain(self.law.dwells.iter().filter_map(|d| d.lift));
        let from_points = lifts.fold(0.0_f64, |x, l| x.max(l.abs()));
        let forces = points.iter().filter_map(|p| p.force);
        let from_forces = forces.fold(0.0_f64, |x, f| x.max(f.abs()));
        let from_forces = if k > 0.0 { from_forces / k } else { 0.0 };
        let typical = from_force.max(from_points).max(from_forces);
        if typical > 0.0 && typical.is_finite() {
            typical
        } else {
            1e-3
        }
    }
}

/// What is open about a recording and was not accepted by the scene, with what opens it.
pub(crate) fn open_questions(
    gait: Option<&Gait>,
    force: Option<&ForceCurve>,
) -> Vec<(OpenQuestion, Vec<force::Note>)> {
    let recording = force.and_then(|f| f.recording.as_ref());
    let (Some(gait), Some(recording)) = (gait, recording) else {
        return Vec::new();
    };
    let mut open = recording.doubts();
    open.retain(|d| !gait.accept.contains(d));
    open.into_iter()
        .map(|question| (question, recording.opened_by(question)))
        .collect()
}
