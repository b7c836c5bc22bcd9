//! Contact that can be lost: lift-off, flight, impact, rest, one event after the other.
//!
//! In contact the motion of the mass is the profile's lift; contact ends where the force turns negative. The flight has a closed form and ends at the
//! first zero of the gap, found by steps that curvature bounds prove to be free of contact. Nothing is sampled, so no grazing contact is missed. A
//! decaying sequence of bounces ends in contact.

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
    /// In contact with a profile.
    Contact {
        /// Index of the profile.
        surface: usize,
    },
    /// The follower is in free flight.
    Flight(Flight),
    /// Without contact in a machine without inertia, where the force would be negative.
    Parted {
        /// Index of the profile that it left.
        surface: usize,
    },
}

/// A phase with its angles, rad, counted over several turns.
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
    /// Kind of the phase.
    pub phase: Phase,
    /// First angle of the phase.
    pub from: f64,
    /// Last angle of the phase.
    pub to: f64,
}

/// One landing on a profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // Above lift-off the follower flies and lands.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 1.3 * (9.81_f64 / 0.01).sqrt()), 720);
/// let impacts = simulate(&run, Model::Contact)?.impacts;
/// assert!(!impacts.is_empty());
/// assert!(impacts.iter().all(|i| i.speed > 0.0 && i.since <= i.at && i.height >= 0.0));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Angle, rad, counted over several turns.
    pub at: f64,
    /// Index of the profile that is hit.
    pub surface: usize,
    /// Approach speed of the surfaces, m/s.
    pub speed: f64,
    /// Angle at which the flight began (equal to the landing for a handover without flight), rad.
    pub since: f64,
    /// Largest gap of that flight, m.
    pub height: f64,
    /// Rebound and impulse of the impact.
    pub pulse: Pulse,
}

/// A simulation that starts at rest on the profile.
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
    /// Number of turns before the motion repeats; `None` if it does not within the allowed turns.
    pub settle: Option<usize>,
    /// Number of turns of one repetition (the last turn if it does not repeat).
    pub period: usize,
    /// Number of simulated turns.
    pub turns: usize,
    /// Whether the mass never returned to the profile.
    pub escaped: bool,
}

/// Limits of the run.
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
    /// Maximum number of turns.
    pub turns: usize,
    /// Maximum number of impacts.
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
    /// First and last angle of the repetition (or of the last turn that was run).
    pub fn window(&self) -> (f64, f64) {
        let to = self.start + TAU * self.turns as f64;
        (to - TAU * self.period as f64, to)
    }

    /// Fraction of the repetition without contact.
    pub fn lost_fraction(&self) -> f64 {
        let (from, to) = self.window();
        let lost: f64 = self
            .stretches
            .iter()
            .filter(|s| !matches!(s.phase, Phase::Contact { .. }))
            .map(|s| (s.to.min(to) - s.from.max(from)).max(0.0))
            .sum();
        // An empty sum is −0.0, which no report should print.
        (0.0 + lost) / (to - from)
    }

    /// Impacts inside the repetition.
    pub fn steady_impacts(&self) -> impl Iterator<Item = &Impact> {
        let (from, to) = self.window();
        self.impacts
            .iter()
            .filter(move |i| i.at >= from && i.at < to)
    }
}
