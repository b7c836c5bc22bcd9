//! Whether a follower can do what its law asks: what no cam could mend is refused here.

use super::geometry::Geometry;
use super::{Cam, Follower};
use crate::error::{Error, Result};
use std::f64::consts::{FRAC_PI_2, PI};

impl Cam {
    /// Refuses lengths that fix no cam: not positive, an offset beyond the prime circle, an arm that does
    /// not reach, a swing beyond the dead centres, a pivot inside the cam.
    ///
    /// Undercut and steep pressure angles are no faults of the input but of the cam:
    /// [`judge`](super::judge) sees to them.
    pub fn check(&self) -> Result<()> {
        self.check_beside()?;
        match self.follower {
            Follower::RollerOscillating { pivot_distance, .. }
            | Follower::MushroomOscillating { pivot_distance, .. }
            | Follower::FlatOscillating { pivot_distance, .. } => {
                self.check_pivot(pivot_distance.abs())
            }
            _ => Ok(()),
        }
    }

    /// As [`Cam::check`], but the pivot may lie within the cam's outline: the arm runs in another plane
    /// (CAM-DAS allows that).
    pub fn check_beside(&self) -> Result<()> {
        check_lengths(&self.follower)?;
        let (low, high) = Follower::lift_range(&self.law);
        match self.follower {
            Follower::FlatTranslating { .. } => self.check_above_centre(low),
            Follower::RollerTranslating { .. } | Follower::MushroomTranslating { .. } => {
                self.check_offset()?;
                self.check_above_centre(low)
            }
            Follower::RollerOscillating {
                pivot_distance,
                arm,
                ..
            }
            | Follower::MushroomOscillating {
                pivot_distance,
                arm,
                ..
            } => {
                self.check_reach(pivot_distance.abs(), arm)?;
                self.check_swing(low, high, 0.0, PI)
            }
            Follower::FlatOscillating {
                pivot_distance,
                face_offset,
                base_radius,
            } => {
                let c = pivot_distance.abs();
                if (base_radius - face_offset).abs() >= c {
                    return Err(Error::new(format!(
                        "the face of offset {} cannot lie on a base circle of {} with its pivot at {}",
                        mm(face_offset),
                        mm(base_radius),
                        mm(c)
                    ))
                    .help(format!(
                        "the pivot distance must exceed {}",
                        mm((base_radius - face_offset).abs())
                    )));
                }
                self.check_swing(low, high, -FRAC_PI_2, FRAC_PI_2)?;
                self.check_arm_speed(pivot_distance.signum())
            }
            Follower::TranslatingCam { .. } | Follower::Barrel { .. } => Ok(()),
        }
    }

    fn check_offset(&self) -> Result<()> {
        let (e, rp) = (self.follower.offset(), self.follower.prime_radius());
        if e.abs() < rp {
            return Ok(());
        }
        Err(Error::new(format!(
            "the offset of {} is not smaller than the prime radius of {}",
            mm(e),
            mm(rp)
        ))
        .help(format!(
            "the follower would miss the prime circle: keep the offset below {} or raise the prime radius",
            mm(rp)
        )))
    }

    /// A follower that sinks to the cam's centre turns the cam inside out.
    fn check_above_centre(&self, low: f64) -> Result<()> {
        let (rise, e) = (self.follower.start_height(), self.follower.offset());
        if rise + low > 0.0 {
            return Ok(());
        }
        Err(Error::new(format!(
            "the law falls to {}, below the cam's centre, which lies {} under the follower's start",
            self.follower.lift_words(low),
            mm(rise)
        ))
        .help(format!(
            "the prime radius must exceed {}",
            mm((low * low + e * e).sqrt())
        )))
    }

    fn check_reach(&self, c: f64, arm: f64) -> Result<()> {
        let rp = self.follower.prime_radius();
        if (c - arm).abs() < rp && rp < c + arm {
            return Ok(());
        }
        let what = if arm <= c - rp {
            "is too short to reach"
        } else if arm >= c + rp {
            "is too long to touch"
        } else {
            "cannot lie on"
        };
        Err(Error::new(format!(
            "the arm of {} {what} the prime circle of {} from a pivot at {}",
            mm(arm),
            mm(rp),
            mm(c)
        ))
        .help(format!(
            "its length must lie between {} and {}",
            mm((c - rp).abs()),
            mm(c + rp)
        )))
    }

    fn check_swing(&self, low: f64, high: f64, least: f64, most: f64) -> Result<()> {
        let start = self.follower.start_angle().unwrap_or(f64::NAN);
        if start + low > least && start + high < most {
            return Ok(());
        }
        Err(Error::new(format!(
            "the arm swings from {:.4}° to {:.4}°, beyond its dead centres at {:.0}° and {:.0}°",
            (start + low).to_degrees(),
            (start + high).to_degrees(),
            least.to_degrees(),
            most.to_degrees()
        ))
        .help(format!(
            "from its start at {:.4}° it may rise by less than {:.4}° and fall by less than {:.4}°",
            start.to_degrees(),
            (most - start).to_degrees(),
            (start - least).to_degrees()
        )))
    }

    /// The face must turn against the cam: 1 + σξ′ > 0.
    fn check_arm_speed(&self, side: f64) -> Result<()> {
        let (slow, fast) = self.law.extremes(1);
        let worst = if side > 0.0 { slow } else { fast };
        if 1.0 + side * worst.value > 0.0 {
            return Ok(());
        }
        Err(Error::new(format!(
            "at {:.3}° the arm swings with the cam at {:.4} rad/rad, as fast as the cam turns or faster",
            worst.at.to_degrees(),
            worst.value
        ))
        .help("a flat face then has no contact point: spread this motion over a larger angle"))
    }

    fn check_pivot(&self, c: f64) -> Result<()> {
        let geometry = Geometry::new(&self.follower);
        let largest = self
            .extremes_of(|at| {
                let [x, y] = geometry.contact(at).point;
                x * x + y * y
            })
            .1;
        let reach = largest.value.sqrt();
        if c > reach {
            return Ok(());
        }
        Err(Error::new(format!(
            "the pivot at {} lies inside the cam, whose profile reaches {} at {:.3}°",
            mm(c),
            mm(reach),
            largest.at.to_degrees()
        ))
        .help(format!("put the pivot farther out than {}", mm(reach))))
    }
}

fn check_lengths(follower: &Follower) -> Result<()> {
    let positive = |name: &str, x: f64| {
        if x.is_finite() && x > 0.0 {
            Ok(())
        } else {
            Err(Error::new(format!("the {name} is {}", mm(x))).help("it must be more than 0"))
        }
    };
    let radius = follower.roller_radius();
    let rolling = |name: &str| {
        if radius.is_finite() && radius >= 0.0 {
            Ok(())
        } else {
            Err(Error::new(format!("the {name} is {}", mm(radius)))
                .help("it must be more than 0 (0: a knife edge)"))
        }
    };
    match *follower {
        Follower::MushroomTranslating { arc_radius, .. }
        | Follower::MushroomOscillating { arc_radius, .. } => positive("arc radius", arc_radius)?,
        _ => rolling("roller radius")?,
    }
    if !follower.offset().is_finite() {
        return Err(Error::new("the offset is not a finite number"));
    }
    match *follower {
        Follower::RollerOscillating {
            pivot_distance,
            arm,
            ..
        }
        | Follower::MushroomOscillating {
            pivot_distance,
            arm,
            ..
        } => {
            positive("pivot distance", pivot_distance.abs())?;
            positive("arm", arm)?;
        }
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            ..
        } => {
            positive("pivot distance", pivot_distance.abs())?;
            if !face_offset.is_finite() {
                return Err(Error::new("the face offset is not a finite number"));
            }
        }
        Follower::TranslatingCam { base_height, .. } => {
            return positive("base height", base_height);
        }
        Follower::Barrel { radius, .. } => return positive("radius of the barrel", radius),
        _ => {}
    }
    positive("prime radius", follower.prime_radius())?;
    if follower.base_radius() > 0.0 {
        return Ok(());
    }
    Err(Error::new(format!(
        "the roller (or arc) of {} leaves nothing of a prime circle of {}",
        mm(radius),
        mm(follower.prime_radius())
    ))
    .help(
        "the prime radius is the base radius plus that of the roller; it must exceed the roller's",
    ))
}

/// A length for messages.
pub(super) fn mm(x: f64) -> String {
    format!("{:.4} mm", 1e3 * x)
}
