//! A scene: the whole problem as a user writes it down, validated key by key.

mod cam;
mod drive;
mod gait;
mod ignored;
mod law;
mod limits;
mod load;
mod table;

pub use load::{read, read_keys, set};

use std::path::PathBuf;

use crate::cam::{Closure, FollowerKind, Measures};
use crate::drive::{Drive, DriveKind};
use crate::dynamics::Train;
use crate::error::{Place, Result};
use crate::force::Feet;
use crate::law::Rise;

/// The whole problem. Values left `None` are `"auto"` or absent, as each field says.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Name of the scene and of its output folder.
    pub name: String,
    /// The force that is wanted; `None` for a classical programme.
    pub gait: Option<Gait>,
    /// How lift becomes force.
    pub drive: DriveSpec,
    /// What the law may be.
    pub law: LawSpec,
    /// The cam and its follower.
    pub cam: CamSpec,
    /// What must not be exceeded.
    pub limits: Limits,
    /// What is known of the machine beyond its drive.
    pub machine: MachineSpec,
    /// Asked RMS force error as part of the mean force.
    pub rms: Option<f64>,
}

/// Where the wanted force comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A recording or a written cycle.
    File {
        /// Path as written; relative to the scene's folder first, then to the working directory.
        path: PathBuf,
        /// Name of the time column.
        time: Option<String>,
        /// Names of the force columns.
        force: Vec<String>,
        /// Unit of the force columns, as written.
        unit: Option<String>,
        /// Samples per second.
        rate_hz: Option<f64>,
        /// Mass of the walker, kg.
        mass_kg: Option<f64>,
    },
    /// A published load model.
    Model {
        /// Its name in the catalogue.
        name: String,
        /// Steps per second.
        step_frequency_hz: Option<f64>,
        /// Weight of the walker, N.
        body_weight_n: f64,
    },
}

/// The force that is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Gait {
    /// Where it comes from.
    pub source: Source,
    /// Whose feet count.
    pub feet: Feet,
    /// Scale the target so that its mean is M·g.
    pub to_mass: bool,
    /// Stay inside a band about the target instead of near to it.
    pub band: Option<Band>,
    /// Ranges of the cycle whose force error counts more or less than once.
    pub weights: Vec<PhaseWeight>,
    /// Where in the cycle the cam's turn begins.
    pub phase: Phase,
}

/// Half the width of a band about the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Band {
    /// One standard deviation from step to step.
    Spread,
    /// So many N all around.
    Width(f64),
}

/// A range of the cycle with its weight in the mean square force error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhaseWeight {
    /// First phase of the cycle, rad.
    pub from: f64,
    /// Last phase, rad; below `from` the range runs over the cycle's end.
    pub to: f64,
    /// Weight; 1 is what all else has.
    pub weight: f64,
}

/// Phase of the force cycle at cam angle 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase {
    /// rad.
    At(f64),
    /// The one with the least force error.
    Free,
}

/// How lift becomes force.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveSpec {
    /// The machine.
    pub kind: DriveKind,
    /// Moved mass, kg (an arm's moment of inertia, kg·m²); `None` = mean force / g.
    pub mass: Option<f64>,
    /// Cam speed, rad/s; `None` = one turn per cycle.
    pub speed: Option<f64>,
    /// Gravity, m/s².
    pub gravity: f64,
    /// Hydraulic: pressure per displaced volume, Pa/m³.
    pub pressure_per_volume: f64,
    /// Hydraulic: radius of the piston, m.
    pub piston_radius: f64,
    /// Fixed axis: N/m (an arm: N·m/rad).
    pub spring_rate: f64,
    /// Fixed axis: N on the base circle (an arm: N·m).
    pub preload: f64,
    /// Fixed axis: N·s/m.
    pub damping: f64,
}

/// Family of laws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The simplest of the others that meets accuracy and limits.
    Auto,
    /// Harmonics in closed form where accuracy and limits hold with them, a spline otherwise: what a scene
    /// gets that names no family and asks for nothing that only one family has.
    Ladder,
    /// Splines.
    Spline,
    /// One polynomial through given points, dwell elsewhere.
    Polynomial,
    /// A sum of harmonics.
    Harmonic,
    /// Rise–fall–dwell of double harmonics with searched angles and lifts.
    DoubleHarmonic,
    /// Segments of catalogue laws.
    Program,
}

impl Family {
    /// Every family with the name users write.
    pub const NAMES: [(&'static str, Family); 7] = [
        ("auto", Family::Auto),
        ("ladder", Family::Ladder),
        ("spline", Family::Spline),
        ("polynomial", Family::Polynomial),
        ("harmonic", Family::Harmonic),
        ("double-harmonic", Family::DoubleHarmonic),
        ("program", Family::Program),
    ];

    /// The name users write.
    pub fn name(self) -> &'static str {
        Family::NAMES
            .iter()
            .find(|n| n.1 == self)
            .map_or("", |n| n.0)
    }
}

/// What the law is chosen for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Minimise {
    /// Mean square distance of the force to the target.
    ForceError,
    /// Mean square of the derivative of this order (2 acceleration, 3 jerk, 4 snap).
    Energy(usize),
    /// Largest absolute value of the derivative of this order.
    Peak(usize),
    /// Largest absolute distance of the force to the target.
    PeakForceError,
    /// The base circle of a flat-faced cam, the prime circle of a roller cam: law and size as one program.
    Size,
    /// Force error, size and jerk against each other (`law.weigh`).
    Weighed(Weigh),
}

/// What counts as one in a weighed objective (e/e₁)² + R/R₁ + (j/j₁)², e and j root mean squares, R the prime
/// radius; what is left out does not count.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weigh {
    /// e₁, part of the mean force.
    pub force_error: Option<f64>,
    /// R₁, m.
    pub prime_radius: Option<f64>,
    /// j₁, m/s³.
    pub jerk: Option<f64>,
}

impl Minimise {
    /// Every objective with the name users write.
    pub const NAMES: [(&'static str, Minimise); 9] = [
        ("force-error", Minimise::ForceError),
        ("peak-force-error", Minimise::PeakForceError),
        ("acceleration", Minimise::Energy(2)),
        ("jerk", Minimise::Energy(3)),
        ("snap", Minimise::Energy(4)),
        ("peak-acceleration", Minimise::Peak(2)),
        ("peak-jerk", Minimise::Peak(3)),
        ("peak-snap", Minimise::Peak(4)),
        ("size", Minimise::Size),
    ];
}

/// An exact demand on the law at one cam angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawPoint {
    /// Cam angle, rad.
    pub angle: f64,
    /// Lift, m (or rad).
    pub lift: Option<f64>,
    /// Force, N, in place of a lift, where the drive turns one into the other.
    pub force: Option<f64>,
    /// Velocity, m/rad.
    pub velocity: Option<f64>,
    /// Acceleration, m/rad².
    pub acceleration: Option<f64>,
    /// Jerk, m/rad³.
    pub jerk: Option<f64>,
}

/// A range of cam angles at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dwell {
    /// First angle, rad.
    pub from: f64,
    /// Last angle, rad.
    pub to: f64,
    /// Lift, m; `None` = whatever suits.
    pub lift: Option<f64>,
}

/// One segment of a programme.
#[derive(Debug, Clone, PartialEq)]
pub struct SegmentSpec {
    /// The motion; [`Rise::Dwell`] for rest.
    pub motion: Rise,
    /// Change of lift, m (or rad), negative for a fall.
    pub lift: f64,
    /// Angle, rad.
    pub angle: f64,
}

/// What is known of the machine beyond its drive: `gaitcam simulate` runs with it.
#[derive(Debug, Clone, PartialEq)]
pub struct MachineSpec {
    /// First natural frequency of the follower train, Hz.
    pub natural_frequency: Option<f64>,
    /// Stiffness of the follower train, N/m (an arm: N·m/rad), in place of the frequency.
    pub stiffness: Option<f64>,
    /// Its damping ratio.
    pub damping_ratio: f64,
    /// Coefficient of friction where cam and follower rub.
    pub friction: f64,
    /// Coefficient of restitution of a landing, 0 … 1.
    pub restitution: f64,
    /// Angle by which a second, equal cam follows on the same shaft, rad.
    pub second_cam: Option<f64>,
}

impl MachineSpec {
    /// What gives between cam and mass, where it is known. Fails on a natural frequency without a mass.
    pub fn train(&self, drive: &Drive) -> Result<Option<Train>> {
        if let Some(hz) = self.natural_frequency {
            return Train::from_frequency(drive, hz, self.damping_ratio)
                .map(Some)
                .map_err(|e| e.at(Place::Key("machine.natural_frequency".to_string())));
        }
        Ok(self.stiffness.map(|stiffness| Train {
            stiffness,
            damping: 2.0 * self.damping_ratio * (stiffness * drive.mass).sqrt(),
        }))
    }
}

/// What the law may be.
#[derive(Debug, Clone, PartialEq)]
pub struct LawSpec {
    /// Family.
    pub family: Family,
    /// Degree of spline pieces (`None` = 5) or of the polynomial (`None` = as many as the points fix).
    pub degree: Option<usize>,
    /// Number of spline spans; `None` = the fewest that reach the accuracy.
    pub spans: Option<usize>,
    /// Number of harmonics; `None` = the fewest that reach the accuracy.
    pub harmonics: Option<usize>,
    /// What the law is chosen for; `None` = the force where one is wanted, jerk otherwise.
    pub minimise: Option<Minimise>,
    /// Rise or fall steadily between neighbouring points.
    pub monotone: bool,
    /// The law is that of a flexible follower's end; the cam is cut so that the end follows it.
    pub polydyne: bool,
    /// Exact demands.
    pub points: Vec<LawPoint>,
    /// Rests.
    pub dwells: Vec<Dwell>,
    /// Programme.
    pub segments: Vec<SegmentSpec>,
}

/// The cam and its follower; lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub struct CamSpec {
    /// Kind of follower.
    pub follower: FollowerKind,
    /// Base radius; `None` = smallest that meets the limits.
    pub base_radius: Option<f64>,
    /// Prime radius; `None` = smallest that meets the limits.
    pub prime_radius: Option<f64>,
    /// Offset of the follower; `None` = the one that gives the smallest cam.
    pub offset: Option<f64>,
    /// Radius of the roller, or of a mushroom's arc.
    pub roller_radius: f64,
    /// Oscillating: distance from cam centre to pivot.
    pub pivot_distance: Option<f64>,
    /// Oscillating: length of the arm.
    pub arm: Option<f64>,
    /// Oscillating: the arm runs in another plane, so that its pivot may lie within the cam's outline.
    pub pivot_beside: bool,
    /// Oscillating flat face: distance of the face from the pivot.
    pub face_offset: f64,
    /// Diameter of the bore; the base circle stays outside it.
    pub bore: Option<f64>,
    /// Thickness of the plate, for solids.
    pub thickness: f64,
    /// Constant breadth: distance of both faces, or of both roller centres. The law then needs its first
    /// half turn only.
    pub breadth: Option<f64>,
    /// Translating cam: length of the travel; `None` = what the segments cover.
    pub travel: Option<f64>,
    /// Barrel: turns until the law repeats.
    pub turns: usize,
    /// Barrel: depth of the groove; `None` = the roller's diameter.
    pub depth: Option<f64>,
    /// Barrel: offset of each of two rollers from their stud; `None` = one roller.
    pub eccentricity: Option<f64>,
    /// The second cam of a conjugate pair.
    pub conjugate: Option<ConjugateSpec>,
}

/// The second cam of a conjugate pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConjugateSpec {
    /// What closes the pair.
    pub closure: Closure,
    /// Radius of the second roller; `None` = as the first.
    pub roller_radius: Option<f64>,
}

impl CamSpec {
    /// Whether the follower swings about a pivot, so that the law is in rad.
    pub fn is_oscillating(&self) -> bool {
        self.follower.is_oscillating()
    }

    /// What the law is measured in.
    pub fn measures(&self) -> Measures {
        self.follower.measures()
    }

    /// Whether the cam slides instead of turning, so that the law runs over metres of travel.
    pub fn is_straight(&self) -> bool {
        self.follower == FollowerKind::TranslatingCam
    }
}

/// What must not be exceeded; `None` = no limit. SI.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limits {
    /// Largest stroke, m (or rad).
    pub stroke: Option<f64>,
    /// Largest |ds/dt|, m/s.
    pub velocity: Option<f64>,
    /// Largest |d²s/dt²|, m/s².
    pub acceleration: Option<f64>,
    /// Largest |d³s/dt³|, m/s³.
    pub jerk: Option<f64>,
    /// Largest pressure angle on the positive side, rad.
    pub pressure_angle_rise: Option<f64>,
    /// Largest pressure angle on the negative side, rad.
    pub pressure_angle_fall: Option<f64>,
    /// Smallest convex radius of the finished cam, m.
    pub curvature: Option<f64>,
    /// Largest prime radius (base radius of a flat-faced cam), m, where the size is not fixed.
    pub prime_radius: Option<f64>,
    /// Smallest force, N.
    pub force_min: Option<f64>,
    /// Largest force, N.
    pub force_max: Option<f64>,
    /// Longest flat face, m.
    pub face_width: Option<f64>,
    /// Largest shaft torque without friction, N·m.
    pub torque: Option<f64>,
    /// Largest rate of that torque by the cam angle, N·m/rad.
    pub torque_rate: Option<f64>,
    /// Largest line pressure between cam and follower, steel on steel over the plate's thickness, Pa.
    pub hertz_pressure: Option<f64>,
    /// Largest amplitude with which the follower may ring on in a dwell, m.
    pub residual: Option<f64>,
}

/// The default scene: a walker of 700 N on a footbridge at 1.85 steps a second.
pub const DEFAULT: &str = include_str!("../../scenes/footbridge.toml");
