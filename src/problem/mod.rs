//! A scene settled once against its force: every number that the solvers, the checks and the searches work
//! with, and every fact that follows from them.
//!
//! Nothing after [`Problem::settle`] looks at the [`Scene`] again. A search that changes a limit changes the
//! problem; what follows from the limits is a method here, so that it follows from the changed ones too.

mod changed;
mod machine;
mod memo;
mod notes;
mod target;

pub(crate) use machine::drive_of;
pub(crate) use memo::SpanKey;
use memo::TargetKey;
pub use memo::{Memo, Shared};
pub use notes::Note;
pub use target::Target;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::cam::FollowerKind;
use crate::drive::{Drive, DriveKind};
use crate::dynamics::Train;
use crate::error::{Result, SynthError};
use crate::force::{ForceCurve, OpenQuestion, implausible, spread_rms_n};
use crate::halt::Halt;
use crate::law::Rise;
use crate::scene::{
    Band, CamSpec, DriveSpec, Family, ForceScale, Gait, LawSpec, Limits, MachineSpec, Minimise,
    Phase, PhaseWeight, Scene, Source,
};
use crate::units::G;
use target::{band_about, weight_at};

/// Pressure angle that sizes a cam when none is limited: 30°, the usual rule.
pub const USUAL_PRESSURE_ANGLE: f64 = PI / 6.0;
/// RMS force error, part of the mean force, that is small enough where the scene asks for none.
pub(crate) const USUAL_ACCURACY: f64 = 0.005;
/// A mean force that differs from the weight by a smaller part is the same: masses are written with four
/// digits.
const SAME_MEAN: f64 = 1e-3;
/// Degree of splines, and two more for the first terms of a polydyne follower's damping.
const USUAL_DEGREE: usize = 5;
const DAMPED_DEGREE: usize = 7;

/// The whole problem with every number settled.
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
    pub open_doubts: Vec<OpenQuestion>,
    /// What is already found for this force and law.
    pub memo: Memo,
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

/// What is said of the size of the cam. A flat face has no roller: its base and prime circles are one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Size {
    /// The size is fixed, and the law has to fit it.
    Given {
        /// Radius of the base circle, m.
        base: f64,
        /// Radius of the prime circle, m.
        prime: f64,
    },
    /// Size and law are found as one program: the size is minimised or limited.
    Sought,
    /// The smallest size that the finished law allows.
    AfterLaw,
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
            open_doubts: open_doubts(gait, force.as_ref()),
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
        let (drive, target) = self.memo.settled(key, || {
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

    /// What is said of the size of the cam.
    pub fn size(&self) -> Size {
        let (cam, roller) = (&self.cam, self.cam.roller_radius);
        match (cam.base_radius, cam.prime_radius) {
            (Some(base), prime) => Size::Given {
                base,
                prime: prime.unwrap_or(base + roller),
            },
            (None, Some(prime)) => Size::Given {
                base: prime - roller,
                prime,
            },
            (None, None) if self.size_is_wanted() => Size::Sought,
            (None, None) => Size::AfterLaw,
        }
    }

    /// Radius of the prime circle, m, where it is given.
    pub fn prime_radius(&self) -> Option<f64> {
        match self.size() {
            Size::Given { prime, .. } => Some(prime),
            Size::Sought | Size::AfterLaw => None,
        }
    }

    /// Radius of the base circle, m, where it is given.
    pub fn base_radius(&self) -> Option<f64> {
        match self.size() {
            Size::Given { base, .. } => Some(base),
            Size::Sought | Size::AfterLaw => None,
        }
    }

    /// Whether an objective or a limit prices the size; only sliding followers with a straight line of
    /// action have it in the program.
    fn size_is_wanted(&self) -> bool {
        let sized = [
            FollowerKind::FlatTranslating,
            FollowerKind::RollerTranslating,
            FollowerKind::KnifeTranslating,
        ];
        match self.objective() {
            Minimise::Size => true,
            Minimise::Weighed(weigh) if weigh.prime_radius.is_some() => true,
            _ => self.limits.prime_radius.is_some() && sized.contains(&self.cam.follower),
        }
    }

    /// Smallest base radius that the bore leaves, m.
    pub fn outside_bore(&self) -> f64 {
        outside_bore(&self.cam)
    }

    /// Pressure angles on rise and fall that size a cam: a side that is not limited beside one that is may
    /// have any, and where neither is, the usual rule holds on both.
    pub fn sizing_pressure_angles(&self) -> [f64; 2] {
        let sides = [
            self.limits.pressure_angle_rise,
            self.limits.pressure_angle_fall,
        ];
        let other = if sides == [None, None] {
            USUAL_PRESSURE_ANGLE
        } else {
            FRAC_PI_2
        };
        sides.map(|side| side.unwrap_or(other))
    }

    /// Force error, N RMS, at which an automatic size of the law is large enough; 0 where no force is
    /// wanted.
    pub fn wanted_error(&self) -> f64 {
        let mean = self.target_mean();
        match self.accuracy {
            Some(rms) => rms * mean,
            None => self.noise().max(USUAL_ACCURACY * mean),
        }
    }

    /// The same, whatever the recording's spread.
    pub fn asked_error(&self) -> f64 {
        self.accuracy.unwrap_or(USUAL_ACCURACY) * self.target_mean()
    }

    /// Force error, N RMS, above which a design misses its force: the accuracy asked for, otherwise 0.5 % of
    /// the mean or the step-to-step spread of the recording, whichever is larger; `None` where no force is
    /// wanted, a band stands for the accuracy, or the scene has it not judged.
    pub fn allowed_error(&self) -> Option<f64> {
        let target = self.target.as_ref()?;
        if self.limits.unjudged.accuracy || self.band.is_some() {
            return None;
        }
        let mean = self.target_mean();
        Some(match self.accuracy {
            Some(rms) => rms * mean,
            None => spread_rms_n(&target.curve)
                .unwrap_or(0.0)
                .max(USUAL_ACCURACY * mean),
        })
    }

    /// How far the mean of the wanted force is from the weight that a moving axis carries, N: over a turn no
    /// cam changes the mean (theory §1). Differences below the rounding of a mass are none.
    pub fn mean_force_gap(&self) -> Option<f64> {
        let gap = self.target_mean() - self.drive.rest_force;
        let judged = self.drive.kind == DriveKind::MovingAxis && self.allowed_error().is_some();
        (judged && gap.abs() > SAME_MEAN * self.target_mean()).then_some(gap)
    }

    /// Smallest contact force that is judged where the scene gives none, N: 0 where only force closes the
    /// contact, on a moving axis or by whatever presses on a fixed one.
    pub fn usual_force_min(&self) -> Option<f64> {
        let form_closed = self.cam.conjugate.is_some()
            || self.cam.breadth.is_some()
            || self.cam.follower == FollowerKind::Barrel;
        let pressed = match self.drive.kind {
            DriveKind::MovingAxis => true,
            DriveKind::FixedAxis => !self.drive.is_idle() && !form_closed,
            DriveKind::Hydraulic => false,
        };
        (pressed && !self.limits.unjudged.contact_force).then_some(0.0)
    }

    /// Where the spread of the recording, not an accuracy, decides the size of the law: that error, N.
    pub fn error_at_noise(&self) -> Option<f64> {
        let noise = self.noise();
        (self.accuracy.is_none() && noise > USUAL_ACCURACY * self.target_mean()).then_some(noise)
    }

    /// |mean| of the wanted force, N; 0 where none is wanted.
    pub fn target_mean(&self) -> f64 {
        self.target.as_ref().map_or(0.0, |t| t.mean_n().abs())
    }

    /// Error below which a fit would follow the noise: a fifth of the step-to-step spread, N.
    ///
    /// Such an error adds 2 % to the walker's own variation (1 + 0.2² under the root).
    fn noise(&self) -> f64 {
        let spread = self.target.as_ref().and_then(|t| spread_rms_n(&t.curve));
        0.2 * spread.unwrap_or(0.0)
    }

    /// Whether parts of the cycle count more or less than once.
    pub fn is_weighed(&self) -> bool {
        !self.weights.is_empty()
    }

    /// Weight of the force error at a cam angle.
    pub fn weight(&self, theta: f64) -> f64 {
        weight_at(&self.weights, theta + self.phase)
    }

    /// The lowest weight of any part of the cycle.
    pub fn least_weight(&self) -> f64 {
        (self.weights.iter()).fold(1.0, |least, w| least.min(w.weight))
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
            let largest = target
                .curve
                .force_n
                .iter()
                .fold(0.0_f64, |x, f| x.max((f - self.drive.rest_force).abs()));
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

/// What is open about a recording and was not accepted by the scene.
pub(crate) fn open_doubts(gait: Option<&Gait>, force: Option<&ForceCurve>) -> Vec<OpenQuestion> {
    let recording = force.and_then(|f| f.recording.as_ref());
    let (Some(gait), Some(recording)) = (gait, recording) else {
        return Vec::new();
    };
    let mut open = recording.doubts();
    open.retain(|d| !gait.accept.contains(d));
    open
}

/// Smallest base radius that the hole for the shaft leaves, m.
pub(crate) fn outside_bore(cam: &CamSpec) -> f64 {
    cam.hole().map_or(0.0, |hole| hole.least_base_radius())
}
