//! Contact with lift-off: flight, impact and rest, computed event by event.
//!
//! In contact, the motion of the mass is the lift of the profile. Contact ends where the force becomes negative. The flight has a closed
//! form and ends at the first zero of the gap. Bounds of the curvature ensure that no contact occurs within a step of the search. Even a
//! grazing contact is therefore not missed. A decaying sequence of bounces ends in contact.

mod events;
pub(crate) mod flight;
pub(crate) mod impact;
pub(crate) mod two_cams;

pub use events::run;
pub(crate) use flight::Flight;

use impact::Pulse;
use std::f64::consts::TAU;

/// Phase of the motion between two events.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::contact::{self, Limits, Phase};
/// use gaitcam::dynamics::Surface;
/// use gaitcam::law::Law;
///
/// // A harmonic lift of amplitude 10 mm, 30 % faster than its lift-off speed √(g/10 mm).
/// let drive = Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt());
/// let surface = Surface::new(Law::harmonic(0.01, &[(0.0, 0.01)]), &drive);
/// let run = contact::run(&[surface], &drive, 0.0, &Limits::default());
/// let flies = run.stretches.iter().any(|s| matches!(s.phase, Phase::Flight(_)));
/// assert!(flies);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase {
    /// The mass is in contact with a profile.
    Contact {
        /// Index of the profile in contact.
        surface: usize,
    },
    /// The follower is in free flight.
    Flight(Flight),
    /// Loss of contact in a machine without inertia. The contact force would be negative during this phase.
    Parted {
        /// Index of the profile that the mass left.
        surface: usize,
    },
}

/// A phase with its first and last angle, rad. The angles increase over several turns.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::contact::{self, Limits};
/// use gaitcam::dynamics::Surface;
/// use gaitcam::law::Law;
///
/// // A harmonic lift of amplitude 10 mm, 30 % faster than its lift-off speed √(g/10 mm).
/// let drive = Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt());
/// let surface = Surface::new(Law::harmonic(0.01, &[(0.0, 0.01)]), &drive);
/// let run = contact::run(&[surface], &drive, 0.0, &Limits::default());
/// assert!(run.stretches.windows(2).all(|pair| pair[0].to == pair[1].from));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Contact, flight or loss of contact.
    pub phase: Phase,
    /// First angle of the phase, rad.
    pub from: f64,
    /// Last angle of the phase, rad.
    pub to: f64,
}

/// Landing of the mass on a profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // Above the lift-off speed, the follower leaves the cam and lands.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt()), 720);
/// let impacts = simulate(&run, Model::Contact)?.impacts;
/// assert!(!impacts.is_empty());
/// assert!(impacts.iter().all(|i| i.speed > 0.0 && i.since <= i.at && i.height >= 0.0));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Angle of the landing, rad. The angles increase over several turns.
    pub at: f64,
    /// Index of the profile on which the mass lands.
    pub surface: usize,
    /// Approach speed of the surfaces, m/s.
    pub speed: f64,
    /// Angle at which the flight began, rad. For a change of profile without flight, it is the angle of the landing.
    pub since: f64,
    /// Maximum gap of the flight, m.
    pub height: f64,
    /// Rebound and impulse of the impact.
    pub pulse: Pulse,
}

/// Result of an event-driven contact simulation. The mass starts in contact.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::contact::{self, Limits};
/// use gaitcam::dynamics::Surface;
/// use gaitcam::law::Law;
///
/// // A harmonic lift of amplitude 10 mm, 30 % faster than its lift-off speed √(g/10 mm).
/// let drive = Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt());
/// let surface = Surface::new(Law::harmonic(0.01, &[(0.0, 0.01)]), &drive);
/// let run = contact::run(&[surface], &drive, 0.0, &Limits::default());
/// assert!(run.lost_fraction() > 0.0 && run.lost_fraction() < 1.0);
/// assert!(run.steady_impacts().next().is_some());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ContactRun {
    /// Phases in order of time.
    pub stretches: Vec<Stretch>,
    /// Landings in order of time.
    pub impacts: Vec<Impact>,
    /// First angle of the run, rad.
    pub start: f64,
    /// Number of turns before the motion becomes periodic; `None` if it does not become periodic within the permitted number of turns.
    pub settle: Option<usize>,
    /// Number of turns in one period of the motion; 1 (the last turn) if the motion is not periodic.
    pub period: usize,
    /// Number of simulated turns.
    pub turns: usize,
    /// Whether the mass never returned to the profile.
    pub escaped: bool,
}

/// Limits at which a contact simulation stops.
///
/// ```
/// use gaitcam::dynamics::Machine;
/// use gaitcam::dynamics::contact::Limits;
///
/// let limits = Limits { turns: 50, ..Limits::default() };
/// let machine = Machine { limits, ..Machine::default() };
/// assert_eq!(machine.limits.turns, 50);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Maximum number of turns of the simulation.
    pub turns: usize,
    /// Maximum number of impacts in the simulation.
    pub impacts: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            turns: 60,
            impacts: 20_000,
        }
    }
}

impl ContactRun {
    /// First and last angle of one period of the motion, or of the last simulated turn.
    pub fn window(&self) -> (f64, f64) {
        let to = self.start + TAU * self.turns as f64;
        (to - TAU * self.period as f64, to)
    }

    /// Fraction of the period without contact.
    pub fn lost_fraction(&self) -> f64 {
        let (from, to) = self.window();
        let lost: f64 = self
            .stretches
            .iter()
            .filter(|s| !matches!(s.phase, Phase::Contact { .. }))
            .map(|s| (s.to.min(to) - s.from.max(from)).max(0.0))
            .sum();
        // An empty sum is −0.0. Adding 0.0 removes the sign from reports.
        (0.0 + lost) / (to - from)
    }

    /// Impacts within one period of the motion.
    pub fn steady_impacts(&self) -> impl Iterator<Item = &Impact> {
        let (from, to) = self.window();
        self.impacts
            .iter()
            .filter(move |i| i.at >= from && i.at < to)
    }
}
