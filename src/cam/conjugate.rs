//! Conjugate cams: two cams on one shaft that hold a double follower from both sides.
//!
//! The second cam does in its own frame what the first one does, with the lift s₂ = s_max − s; its
//! follower points the other way, so on the shaft it stands turned by half a turn. An offset changes its
//! side, and so does a pivot (its sign).

use super::fit::mm;
use super::{Cam, Follower, ProfilePoint, SizeLimits, smallest_for};
use crate::error::{Error, Result};

/// What closes the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Closure {
    /// Distance of both faces, or of both roller centres along the line of motion, m (translating).
    Distance(f64),
    /// Angle β between both arms, rad (oscillating).
    Angle(f64),
    /// Base radius of the second cam, m.
    SecondBaseRadius(f64),
}

/// A pair of conjugate cams.
#[derive(Debug, Clone, PartialEq)]
pub struct Conjugate {
    /// The cam that drives the rise.
    pub first: Cam,
    /// The cam that drives the fall, in its own frame: on the shaft it stands turned by half a turn.
    pub second: Cam,
    /// What both followers keep constant: distance, m, or angle between the arms, rad.
    pub total: f64,
}

impl Conjugate {
    /// The conjugate of `first`; its roller may differ (`None`: equal). Fails when no such cam exists and
    /// says from where on one does.
    pub fn new(first: &Cam, closure: Closure, second_roller: Option<f64>) -> Result<Conjugate> {
        first.check()?;
        let radius = second_roller.unwrap_or_else(|| first.follower.roller_radius());
        let (_, top) = Follower::lift_range(&first.law);
        let law = first.law.scaled(-1.0).raised(top);
        let mut second = Cam {
            law,
            follower: opposite(&first.follower, radius)?,
        };
        // Place of the first follower at its top, from which the closure measures.
        let reach = place(&first.follower) + top;
        match closure {
            Closure::SecondBaseRadius(base) => {
                second.follower = second.follower.with_base_radius(base);
            }
            Closure::Distance(_) if first.follower.is_oscillating() => {
                return Err(Error::new("arms are not closed by a distance")
                    .help("give the angle between the arms or the second base radius"));
            }
            Closure::Angle(_) if !first.follower.is_oscillating() => {
                return Err(Error::new("translating followers are not closed by an angle").help(
                    "give the distance between faces or roller centres, or the second base radius",
                ));
            }
            Closure::Distance(total) | Closure::Angle(total) => {
                let start = total - reach;
                second.follower = placed(&second.follower, start).ok_or_else(|| {
                    no_conjugate(&second, reach, total, first.follower.is_oscillating())
                })?;
            }
        }
        if let Err(fault) = second.check() {
            return Err(Error::new(format!(
                "the conjugate cam does not exist: {}",
                fault.what()
            ))
            .help(fault.cure().unwrap_or_default()));
        }
        let total = reach + place(&second.follower);
        Ok(Conjugate {
            first: first.clone(),
            second,
            total,
        })
    }

    /// Distance of both faces or roller centres along the line of motion, or angle between both arms: the
    /// same at every θ.
    pub fn sum(&self, theta: f64) -> f64 {
        let (first, second) = (&self.first, &self.second);
        place(&first.follower)
            + first.law.svaj(theta).s
            + place(&second.follower)
            + second.law.svaj(theta).s
    }

    /// The second cam's contact at `theta`, in the frame of the shaft, where the first one's is
    /// `first.point(theta)`.
    pub fn second_point(&self, theta: f64) -> ProfilePoint {
        half_turned(self.second.point(theta))
    }

    /// The second cam's profile in the frame of the shaft.
    pub fn second_profile(&self, n: usize) -> Vec<ProfilePoint> {
        self.second
            .profile(n)
            .into_iter()
            .map(half_turned)
            .collect()
    }
}

fn half_turned(p: ProfilePoint) -> ProfilePoint {
    ProfilePoint {
        x: -p.x,
        y: -p.y,
        pitch_x: -p.pitch_x,
        pitch_y: -p.pitch_y,
        ..p
    }
}

/// Where the follower stands at s = 0: height of face or centre over the cam's centre, or angle of the arm.
fn place(follower: &Follower) -> f64 {
    match follower.start_angle() {
        Some(angle) => angle,
        None => {
            let (rp, e) = (follower.prime_radius(), follower.offset());
            (rp * rp - e * e).sqrt()
        }
    }
}

/// The follower whose place at s = 0 is `start`; `None` when none has it.
fn placed(follower: &Follower, start: f64) -> Option<Follower> {
    let radius = follower.roller_radius();
    let base = match *follower {
        Follower::RollerOscillating {
            pivot_distance: c,
            arm,
            ..
        }
        | Follower::MushroomOscillating {
            pivot_distance: c,
            arm,
            ..
        } => (arm * arm + c * c - 2.0 * arm * c.abs() * start.cos()).sqrt() - radius,
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            ..
        } => face_offset + pivot_distance.abs() * start.sin(),
        _ => start.hypot(follower.offset()) - radius,
    };
    let reaches = start > 0.0 || matches!(follower, Follower::FlatOscillating { .. });
    (reaches && base > 0.0).then(|| follower.with_base_radius(base))
}

/// The second member's follower before its size is known: other side, other roller.
fn opposite(first: &Follower, radius: f64) -> Result<Follower> {
    Ok(match *first {
        Follower::FlatTranslating { .. } => *first,
        Follower::RollerTranslating {
            prime_radius,
            offset,
            ..
        } => Follower::RollerTranslating {
            prime_radius,
            offset: -offset,
            roller_radius: radius,
        },
        Follower::MushroomTranslating {
            prime_radius,
            offset,
            ..
        } => Follower::MushroomTranslating {
            prime_radius,
            offset: -offset,
            arc_radius: radius,
        },
        Follower::RollerOscillating {
            pivot_distance,
            arm,
            prime_radius,
            ..
        } => Follower::RollerOscillating {
            pivot_distance: -pivot_distance,
            arm,
            prime_radius,
            roller_radius: radius,
        },
        Follower::MushroomOscillating {
            pivot_distance,
            arm,
            prime_radius,
            ..
        } => Follower::MushroomOscillating {
            pivot_distance: -pivot_distance,
            arm,
            prime_radius,
            arc_radius: radius,
        },
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            base_radius,
        } => Follower::FlatOscillating {
            pivot_distance: -pivot_distance,
            face_offset,
            base_radius,
        },
        Follower::TranslatingCam { .. } | Follower::Barrel { .. } => {
            return Err(
                Error::new(format!("a {} has no conjugate cam", first.name()))
                    .help("its groove holds the follower from both sides already"),
            );
        }
    })
}

fn no_conjugate(second: &Cam, reach: f64, total: f64, angular: bool) -> Error {
    let words = |x: f64| {
        if angular {
            format!("{:.4}°", x.to_degrees())
        } else {
            mm(x)
        }
    };
    let error = Error::new(format!(
        "no conjugate cam fits {}: the first follower alone reaches {}",
        words(total),
        words(reach)
    ));
    match smallest_for(second, &SizeLimits::no_undercut()) {
        Ok(base) => {
            let least = reach + place(&second.follower.with_base_radius(base));
            error.help(format!(
                "from {} on (second base radius {}) one exists without undercut",
                words(least),
                mm(base)
            ))
        }
        Err(_) => error.help(format!("it must exceed {} by far", words(reach))),
    }
}
