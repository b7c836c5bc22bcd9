//! Contact that can be lost: lift-off, flight, impact, rest, one event after the other.
//!
//! While the mass rides on a profile its motion is the profile's lift; it leaves where the force turns
//! negative, flies in closed form, and meets a profile again at the first zero of the gap, found by steps
//! that the curvatures of flight and profile prove to be free of contact. Nothing is sampled, so no
//! grazing touch is missed. Bounces that shrink to nothing end in contact.

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
    /// Riding on a profile.
    Contact {
        /// Which profile of the shaft.
        surface: usize,
    },
    /// In the air.
    Flight(Flight),
    /// A machine without inertia, parted from the profile where the force would pull.
    Parted {
        /// The profile it left.
        surface: usize,
    },
}

/// A phase with its angles, turns counted on, rad.
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
    /// Kind of phase.
    pub phase: Phase,
    /// First angle.
    pub from: f64,
    /// Last angle.
    pub to: f64,
}

/// One landing.
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
    /// Angle, turns counted on, rad.
    pub at: f64,
    /// Profile that is struck.
    pub surface: usize,
    /// Speed at which the surfaces meet, m/s.
    pub speed: f64,
    /// Angle at which the flight began (its own angle for a handover without flight), rad.
    pub since: f64,
    /// Largest gap of that flight, m.
    pub height: f64,
    /// Rebound and impulse.
    pub pulse: Pulse,
}

/// A run from rest on the profile.
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
    /// Phases in order.
    pub stretches: Vec<Stretch>,
    /// Landings in order.
    pub impacts: Vec<Impact>,
    /// First angle, rad.
    pub start: f64,
    /// Turns before the motion repeats; `None` when it did not within the turns allowed.
    pub settle: Option<usize>,
    /// Turns of one repetition (the last turn when it does not repeat).
    pub period: usize,
    /// Turns that were run.
    pub turns: usize,
    /// The mass never came back to the profile.
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
    /// Turns at most.
    pub turns: usize,
    /// Impacts at most.
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

    /// Part of the repetition without contact.
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
