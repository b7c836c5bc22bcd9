//! Input of a simulation: cam, output profile, drive and machine data.

use super::contact::Limits;
use super::flexible::Train;
use super::floor::Floor;
use super::rigid::hertz::Material;
use crate::cam::{Cam, ProfilePoint};
use crate::drive::{Drive, Motor};

/// Machine data in addition to the drive. The default is a rigid machine without friction, with plastic impacts and one cam.
///
/// ```
/// use gaitcam::dynamics::Machine;
///
/// // A rigid machine without friction, with plastic landings and one cam.
/// let machine = Machine::default();
/// assert_eq!((machine.friction, machine.restitution), (0.0, 0.0));
/// assert!(machine.train.is_none() && machine.second_cam.is_none());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Machine {
    /// Elastic train between cam and mass; `None` for a rigid follower.
    pub train: Option<Train>,
    /// Coefficient of sliding friction between cam and follower; not used for rollers, which do not slide.
    pub friction: f64,
    /// Coefficient of restitution of landings, 0 (plastic) … 1 (elastic).
    pub restitution: f64,
    /// Phase of a second, equal cam on the same shaft, rad.
    pub second_cam: Option<f64>,
    /// Second cam of a conjugate pair, in its own frame. It transmits the negative forces.
    pub conjugate: Option<Cam>,
    /// Line contact, used to compute the contact pressure.
    pub face: Option<Face>,
    /// Radius of the floor of a barrel's groove, m, where the normal force on the roller is maximum. If it is `None`, the contact is
    /// computed at the radius of the follower.
    pub groove_floor: Option<f64>,
    /// Motor of the shaft; `None` for constant speed.
    pub motor: Option<Motor>,
    /// Floor below the mass; `None` for a rigid floor.
    pub floor: Option<Floor>,
    /// Force correction determined from measurements, in addition to the force of the drive, N, at the angles of the profile; empty without
    /// a correction. The rigid model adds it to the contact force.
    pub learned: Vec<f64>,
    /// Limits at which a contact simulation stops if its motion does not become periodic.
    pub limits: Limits,
}

/// Length and materials of the line contact between cam and follower.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::hertz::{STEEL, line, modulus};
/// use gaitcam::dynamics::{Face, Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // A disc of radius 30 mm under a flat face with 100 N. The result is Hertz's pressure of a contact line of 12 mm.
/// let cam = Cam::new(Law::harmonic(0.0, &[]), Follower::FlatTranslating { base_radius: 0.03 })?;
/// let drive = Drive { rest_force: 100.0, ..Drive::fixed_axis(0.5, 1000.0, 10.0) };
/// let mut run = Run::new(cam, drive, 720);
/// run.machine.face = Some(Face { length: 0.012, cam: STEEL, follower: STEEL });
/// let found = simulate(&run, Model::Rigid)?.hertz.unwrap();
/// let known = line(100.0, 0.012, 1.0 / 0.03, modulus(STEEL, STEEL));
/// assert!((found.contact.pressure / known.pressure - 1.0).abs() < 1e-6);
/// assert!((found.contact.half_width / known.half_width - 1.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// Length of the contact line, m: the thickness of the cam.
    pub length: f64,
    /// Elastic constants of the cam's material.
    pub cam: Material,
    /// Elastic constants of the follower's material.
    pub follower: Material,
}

/// Input of the simulation of a cam.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::dynamics::{Machine, Model, Run, simulate};
/// use gaitcam::drive::Drive;
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// let pi = std::f64::consts::PI;
/// let swing = |lift| Segment { motion: Rise::Cycloidal, lift, angle: pi };
/// let law = program(&[swing(0.01), swing(-0.01)], Extent::TURN)?;
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.05 })?;
/// let run = Run {
///     profile: cam.profile(720),
///     target: None,
///     cam,
///     drive: Drive::moving_axis(10.0, 9.81, 1.0),
///     machine: Machine::default(),
/// };
/// let outcome = simulate(&run, Model::Rigid)?;
/// // Maximum force M (g + 2π h ω²/β²), with the maximum acceleration of a cycloidal rise h over the angle β.
/// let most = 10.0 * (9.81 + 2.0 * 0.01 / pi);
/// assert!((outcome.force.max - most).abs() < 1e-4 * most);
/// assert!(!outcome.contact_lost);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Cam from which the output profile was computed. The follower of this cam and the breakpoints of its law are used. The deviation of
    /// the profile points from this cam is reported.
    pub cam: Cam,
    /// Drive of the machine; a negative speed turns the cam clockwise.
    pub drive: Drive,
    /// Output profile at equal steps of θ over the cycle of the law, usually one turn.
    pub profile: Vec<ProfilePoint>,
    /// Target force at equal steps of one cycle from θ = 0, N.
    pub target: Option<Vec<f64>>,
    /// Machine data in addition to the drive.
    pub machine: Machine,
}

impl Run {
    /// Input for a cam with an output profile of `points` equal steps, for a rigid machine without a target force.
    pub fn new(cam: Cam, drive: Drive, points: usize) -> Run {
        Run {
            profile: cam.profile(points),
            cam,
            drive,
            target: None,
            machine: Machine::default(),
        }
    }
}
