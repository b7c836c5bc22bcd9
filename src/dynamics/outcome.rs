//! Results of the simulation of a cam.

use serde::Serialize;

use super::contact::Impact;
use super::floor::FloorMotion;
use super::reason::{ModelReason, RunNote};
use super::rigid::hertz::LineContact;
use super::shaft::{InTime, Shaft};
use crate::error::Error;

/// Models with which a cam can be simulated.
///
/// ```
/// use gaitcam::dynamics::Model;
///
/// assert_eq!(Model::parse("contact"), Some(Model::Contact));
/// assert_eq!(Model::Flexible.name(), "flexible");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::IntoStaticStr, strum::EnumString)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Model {
    /// Automatic selection of the simplest sufficient model.
    Auto,
    /// Rigid bodies that stay in contact.
    Rigid,
    /// A compliant follower in steady vibration.
    Flexible,
    /// Rigid bodies with loss of contact and impacts.
    Contact,
}

impl Model {
    /// Name of the model in commands and files, such as `rigid`.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The model with this name; `None` for an unknown name.
    pub fn parse(word: &str) -> Option<Self> {
        word.parse().ok()
    }
}

/// Row of `dynamics.csv`: motion, forces and torque at one cam angle.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // The power of the shaft is its torque times its speed, and the follower stays in contact.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let outcome = simulate(&Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720), Model::Rigid)?;
/// for row in &outcome.rows {
///     assert!((row.power - 3.0 * row.torque).abs() < 1e-9);
///     assert_eq!(row.gap, 0.0);
/// }
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row {
    /// Cam angle, rad. The rows cover all turns of one period of the motion.
    pub theta: f64,
    /// Time since the first row, s; 0 for a shaft at standstill.
    pub time: f64,
    /// Speed of the shaft, rad/s.
    pub speed: f64,
    /// Contact force along the motion of the follower, N; 0 in flight.
    pub contact_force: f64,
    /// Torque of the shaft in the direction of increasing θ, N·m.
    pub torque: f64,
    /// Power of the shaft, W: torque times speed.
    pub power: f64,
    /// Height of the moved mass above its position on the base circle, m.
    pub lift: f64,
    /// Gap between mass and cam, m; 0 in contact.
    pub gap: f64,
    /// Force normal to the surfaces, N; for a barrel at the floor of the groove, where it is maximum.
    pub normal_force: f64,
    /// Sliding speed of the cam relative to the follower, m/s.
    pub sliding: f64,
    /// Mean speed of both surfaces relative to the contact point, m/s.
    pub entraining: f64,
    /// Lateral force on the guides, N.
    pub side_thrust: f64,
}

/// Extremes of the contact force, and RMS error of the force, N.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // The extremes are M (g ± ω²e), with the mass M and the eccentricity e.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let force = simulate(&Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720), Model::Rigid)?.force;
/// assert!((force.min - 97.2).abs() < 1e-4 && (force.max - 99.0).abs() < 1e-4);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Force {
    /// Minimum force over one period of the motion, N.
    pub min: f64,
    /// Maximum force over one period of the motion without impacts, N.
    pub max: f64,
    /// RMS difference between force and target, N, if the run has a target.
    pub rms_error: Option<f64>,
}

/// Extremes, mean and root mean square of the shaft torque, N·m.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // Without friction the mean torque is zero.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let torque = simulate(&Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720), Model::Rigid)?.torque;
/// assert!(torque.mean.abs() < 1e-9 && torque.max > 0.9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Torque {
    /// Minimum torque over one period of the motion, N·m.
    pub min: f64,
    /// Maximum torque over one period of the motion, N·m.
    pub max: f64,
    /// Mean torque over one period of the motion, with impacts, N·m.
    pub mean: f64,
    /// Root mean square torque, without impacts, N·m.
    pub rms: f64,
}

/// Differences between the selected model and the next finer one.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::flexible::Train;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // With a stiff follower, the next finer model gives nearly the same force.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let drive = Drive::moving_axis(10.0, 9.81, 3.0);
/// let mut run = Run::new(cam, drive, 720);
/// run.machine.train = Some(Train::from_frequency(&drive, 200.0, 0.05)?);
/// let next = simulate(&run, Model::Auto)?.next.unwrap();
/// assert_eq!(next.model, Model::Flexible);
/// assert!(next.force_max.abs() < 1e-3);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Difference {
    /// Model that is compared with the selected one.
    pub model: Model,
    /// Change of the minimum force relative to the selected model, N.
    pub force_min: f64,
    /// Change of the maximum force relative to the selected model, N.
    pub force_max: f64,
    /// Change of the RMS force error relative to the selected model, N; `None` without a target.
    pub rms_error: Option<f64>,
    /// Change of the fraction of the cycle without contact, relative to the selected model.
    pub lost_fraction: f64,
    /// Error that prevented the simulation with the finer model, if any.
    pub failed: Option<Error>,
}

/// Maximum bearing loads without impacts. At constant speed, they are exact extremes for the rigid model and for permanent contact.
/// Otherwise they are the extremes over the rows.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // The maximum M (g + ω²e) lies between two of the 90 rows. M is the mass and e the eccentricity.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.006, 0.008)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let loads = simulate(&Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 90), Model::Rigid)?.loads;
/// assert!((loads.normal_force - 99.0).abs() < 1e-4 && loads.side_thrust == 0.0);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Loads {
    /// Maximum force normal to the surfaces, N.
    pub normal_force: f64,
    /// Maximum lateral force on the guides, N.
    pub side_thrust: f64,
}

/// Maximum line pressure, with its position.
///
/// ```
/// use gaitcam::dynamics::hertz::STEEL;
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Face, Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // An eccentric has constant curvature, so the pressure is maximum at the maximum force, which occurs at the minimum lift.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let mut run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// run.machine.face = Some(Face { length: 0.012, cam: STEEL, follower: STEEL });
/// let highest = simulate(&run, Model::Rigid)?.hertz.unwrap();
/// assert!((highest.theta - 1.5 * std::f64::consts::PI).abs() < 0.01);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressure {
    /// Cam angle of the maximum pressure, rad.
    pub theta: f64,
    /// Line contact of cam and follower at this angle.
    pub contact: LineContact,
}

/// Result of the simulation of a cam.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // The minimum force M (g − ω²e) is zero at ω = √(g/e), with the mass M and the eccentricity e.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let outcome = simulate(&Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720), Model::Auto)?;
/// assert!(!outcome.contact_lost);
/// assert!((outcome.liftoff_speed.unwrap() / (9.81_f64 / 0.01).sqrt() - 1.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Simulated model; never `Auto`.
    pub model: Model,
    /// Whether the follower oscillates. Lifts and gaps are then angles, and forces are moments about the pivot, N·m.
    pub swings: bool,
    /// Distance from the pivot, m, by which a moment is divided to obtain a force; 1 without an arm.
    pub lever: f64,
    /// Reason for which this model was used.
    pub why: ModelReason,
    /// Whether the follower loses contact, or permanent contact would need a negative force; false if it is constrained from both sides.
    pub contact_lost: bool,
    /// Fraction of the period without contact.
    pub lost_fraction: f64,
    /// Extremes of the contact force, and RMS error of the force, N.
    pub force: Force,
    /// Maximum normal force and maximum lateral force, N.
    pub loads: Loads,
    /// Extremes, mean and root mean square of the shaft torque, N·m.
    pub torque: Torque,
    /// Lowest speed at which the follower lifts off, rad/s; `None` if it never lifts off.
    pub liftoff_speed: Option<f64>,
    /// Number of turns before the motion becomes periodic; `None` if it does not.
    pub settle_cycles: Option<usize>,
    /// Number of cam turns in one period of the motion.
    pub period_turns: usize,
    /// Motion of the motor-driven shaft; `None` for constant speed.
    pub shaft: Option<Shaft>,
    /// Motion of the floor; `None` for a rigid floor.
    pub floor: Option<FloorMotion>,
    /// Difference between force and target over time; `None` without a target or for constant speed.
    pub force_time: Option<InTime>,
    /// Landings of the whole run, including the initial turns.
    pub impacts: Vec<Impact>,
    /// Maximum line pressure without impacts, if the materials are given. It is an exact extreme or the maximum over the rows, like `loads`.
    pub hertz: Option<Pressure>,
    /// Differences from the next finer model, if the model was selected automatically.
    pub next: Option<Difference>,
    /// Maximum distance between the points of the output profile and the simulated curve, m.
    pub profile_mismatch: f64,
    /// Maximum difference between the lift at the points of the output profile and the lift of the law, m.
    pub law_mismatch: f64,
    /// Notes on the run for the user.
    pub notes: Vec<RunNote>,
    /// Rows of one period of the motion, at equal angles.
    pub rows: Vec<Row>,
}
