//! Two equal cams on one shaft over a plate, the second some angle ahead (Campillo de Blas 2017: half a turn): the
//! shaft rides on the higher one.

use super::{Cam, Follower};
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::law::Law;
use std::f64::consts::PI;

/// Which cam rests on the plate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Carrier {
    /// The first.
    First,
    /// The second.
    Second,
    /// Both, within rounding.
    Both,
}

/// The load passes from one cam to the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Handover {
    /// Angle of the shaft, rad.
    pub at: f64,
    /// Who carries from there on; [`Carrier::Both`] while both dwell at one height.
    pub to: Carrier,
    /// Jump of the shaft's velocity ds/dθ, m/rad: a blow of M·ω·jump. Never negative.
    pub velocity_jump: f64,
    /// Jump of the acceleration, m/rad².
    pub acceleration_jump: f64,
}

/// Two cams on one shaft over a plate.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// Law of the first cam.
    first: Law,
    /// Law of the second cam as the shaft turns.
    second: Law,
    /// Base radius of both, m.
    base_radius: f64,
    /// Height law of the shaft.
    height: Law,
    /// Differences of height below this are rounding, m.
    slack: f64,
    handovers: Vec<Handover>,
}

/// Heights closer than this share of the stroke are equal: rounding of a law and its turned copy.
const TOUCH: f64 = 1e-12;

impl Pair {
    /// A flat-faced cam (the plate is the face) and its copy, half a turn ahead.
    pub fn new(cam: &Cam) -> Result<Pair> {
        Pair::with_phase(cam, PI)
    }

    /// A flat-faced cam and its copy, `phase` rad ahead.
    pub fn with_phase(cam: &Cam, phase: f64) -> Result<Pair> {
        cam.check()?;
        let Follower::FlatTranslating { base_radius } = cam.follower else {
            return Err(Error::new(format!(
                "two cams over a plate need flat translating followers, not {}",
                cam.follower.name()
            ))
            .help("the plate is the flat face"));
        };
        if !cam.law.is_closed() {
            return Err(Error::new(
                "a pair of cams needs a law that closes over the turn",
            ));
        }
        let first = cam.law.clone();
        let second = first.ahead(phase);
        let (height, changes) = Law::higher_of(&first, &second);
        let mut pair = Pair {
            slack: TOUCH * first.stroke(),
            first,
            second,
            base_radius,
            height,
            handovers: Vec::new(),
        };
        if changes.len() > 1 {
            pair.handovers = changes.iter().map(|c| pair.handover(c.0, c.1)).collect();
        }
        Ok(pair)
    }

    fn handover(&self, at: f64, lead: bool) -> Handover {
        let (one, two) = (self.first.svaj(at), self.second.svaj(at));
        let (from, to) = if lead { (two, one) } else { (one, two) };
        let soon = at + 1e-6;
        let carrier = match self.carrier(soon) {
            Carrier::Both => Carrier::Both,
            _ if lead => Carrier::First,
            _ => Carrier::Second,
        };
        Handover {
            at,
            to: carrier,
            velocity_jump: to.v - from.v,
            acceleration_jump: to.a - from.a,
        }
    }

    /// Law of the shaft's height: the higher of both cams at every θ, with jumps of velocity where the
    /// load passes on.
    pub fn height(&self) -> &Law {
        &self.height
    }

    /// Height of the shaft over the plate, m.
    pub fn shaft_height(&self, theta: f64) -> f64 {
        self.base_radius + self.height.svaj(theta).s
    }

    /// Who carries at `theta`.
    pub fn carrier(&self, theta: f64) -> Carrier {
        let difference = self.first.svaj(theta).s - self.second.svaj(theta).s;
        if difference.abs() <= self.slack {
            Carrier::Both
        } else if difference > 0.0 {
            Carrier::First
        } else {
            Carrier::Second
        }
    }

    /// Gap under the cam that does not carry, m; 0 while both touch.
    pub fn gap(&self, theta: f64) -> f64 {
        (self.first.svaj(theta).s - self.second.svaj(theta).s).abs()
    }

    /// Every passing of the load, in order; empty when one cam carries all the time.
    pub fn handovers(&self) -> &[Handover] {
        &self.handovers
    }

    /// Force on the plate, N: the carrier's F₀ + … + mω²a (theory §1), between handovers.
    pub fn force(&self, drive: &Drive, theta: f64) -> f64 {
        drive.force(self.height.svaj(theta))
    }

    /// Impulse of a handover on the plate, N·s: the shaft block of mass m gains m·ω·Δv at once.
    pub fn blow(drive: &Drive, handover: &Handover) -> f64 {
        drive.mass * drive.speed * handover.velocity_jump
    }

    /// Force of each cam on its own plate when both carry a block of their own (two feet): first, second
    /// and their sum, N.
    pub fn separate_forces(&self, drive: &Drive, theta: f64) -> [f64; 3] {
        let one = drive.force(self.first.svaj(theta));
        let two = drive.force(self.second.svaj(theta));
        [one, two, one + two]
    }
}
