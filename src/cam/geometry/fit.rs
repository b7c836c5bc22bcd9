//! Checks that a follower with given dimensions can execute its law.

#[cfg(test)]
mod tests;

use super::Geometry;
use crate::cam::{Cam, Follower};
use crate::error::{ArmFault, CamError, CamInputError, CamLength, Result};
use crate::units::Quantity;
use std::f64::consts::{FRAC_PI_2, PI};

impl Cam {
    /// Rejects dimensions with which the follower cannot execute the law. Examples are lengths that are not positive, an offset beyond the
    /// prime circle, an arm that does not reach the prime circle, a swing beyond the dead centres, and a pivot inside the cam.
    ///
    /// Undercut and steep pressure angles are not errors of the input. The verdict of a synthesis reports them.
    ///
    /// # Errors
    ///
    /// A length or an angle is invalid. The error contains the invalid value.
    pub fn check(&self) -> Result<()> {
        self.check_beside()?;
        match self.follower.pivot() {
            Some([x, _]) => self.check_pivot(x.abs()),
            None => Ok(()),
        }
    }

    /// Checks as [`Cam::check`] does, but permits a pivot within the outline of the cam, because the arm is in another plane. CAM-DAS also
    /// permits this.
    ///
    /// # Errors
    ///
    /// The errors of [`Cam::check`].
    pub fn check_beside(&self) -> Result<()> {
        check_lengths(&self.follower)?;
        let (low, high) = Follower::lift_range(&self.law);
        let Some([pivot, _]) = self.follower.pivot() else {
            if self.follower.is_unrolled() {
                return Ok(());
            }
            self.check_offset()?;
            return self.check_above_centre(low);
        };
        let c = pivot.abs();
        if let Some(arm) = self.follower.arm() {
            self.check_reach(c, arm.length)?;
            return self.check_swing(low, high, 0.0, PI);
        }
        let (offset, base) = (self.follower.face_offset(), self.follower.base_radius());
        let least = (base - offset).abs();
        if least >= c {
            return Err(CamError::FaceReach {
                offset: Quantity::length(offset),
                base: Quantity::length(base),
                pivot: Quantity::length(c),
                least: Quantity::length(least),
            }
            .into());
        }
        self.check_swing(low, high, -FRAC_PI_2, FRAC_PI_2)?;
        self.check_arm_speed(pivot.signum())
    }

    fn check_offset(&self) -> Result<()> {
        let (e, rp) = (self.follower.offset(), self.follower.prime_radius());
        if e.abs() < rp {
            return Ok(());
        }
        Err(CamError::Offset {
            offset: Quantity::length(e),
            prime: Quantity::length(rp),
        }
        .into())
    }

    /// Checks that the follower stays above the cam centre.
    fn check_above_centre(&self, low: f64) -> Result<()> {
        let (rise, e) = (self.follower.start_height(), self.follower.offset());
        if rise + low > 0.0 {
            return Ok(());
        }
        Err(CamError::BelowCentre {
            lift: self.follower.lift_quantity(low),
            height: Quantity::length(rise),
            least: Quantity::length((low * low + e * e).sqrt()),
        }
        .into())
    }

    fn check_reach(&self, c: f64, arm: f64) -> Result<()> {
        let rp = self.follower.prime_radius();
        if (c - arm).abs() < rp && rp < c + arm {
            return Ok(());
        }
        let fault = if arm <= c - rp {
            ArmFault::Short
        } else if arm >= c + rp {
            ArmFault::Long
        } else {
            ArmFault::Apart
        };
        Err(CamError::ArmReach {
            arm: Quantity::length(arm),
            fault,
            prime: Quantity::length(rp),
            pivot: Quantity::length(c),
            least: Quantity::length((c - rp).abs()),
            most: Quantity::length(c + rp),
        }
        .into())
    }

    fn check_swing(&self, low: f64, high: f64, least: f64, most: f64) -> Result<()> {
        let start = self.follower.start_angle().unwrap_or(f64::NAN);
        if start + low > least && start + high < most {
            return Ok(());
        }
        Err(CamError::Swing {
            from: Quantity::angle(start + low),
            to: Quantity::angle(start + high),
            dead: [Quantity::angle(least), Quantity::angle(most)],
            start: Quantity::angle(start),
            rise: Quantity::angle(most - start),
            fall: Quantity::angle(start - least),
        }
        .into())
    }

    /// Checks that the face rotates relative to the cam without reversal. The condition is 1 + σξ′ > 0. Here σ is the sign of the pivot's x
    /// coordinate, and ξ′ = dξ/dθ.
    fn check_arm_speed(&self, side: f64) -> Result<()> {
        let (slow, fast) = self.law.extremes(1);
        let worst = if side > 0.0 { slow } else { fast };
        if 1.0 + side * worst.value > 0.0 {
            return Ok(());
        }
        Err(CamError::FaceSpeed {
            at: Quantity::angle(worst.at),
            speed: worst.value,
        }
        .into())
    }

    fn check_pivot(&self, c: f64) -> Result<()> {
        let geometry = Geometry::new(&self.follower);
        let (_, largest) = self.law.extremes_by(|at| {
            let [x, y] = geometry.contact(at).point;
            x * x + y * y
        });
        let reach = largest.value.sqrt();
        if c > reach {
            return Ok(());
        }
        Err(CamError::PivotInside {
            pivot: Quantity::length(c),
            reach: Quantity::length(reach),
            at: Quantity::angle(largest.at),
        }
        .into())
    }
}

fn check_lengths(follower: &Follower) -> Result<()> {
    let faulty = |length: CamLength, x: f64| CamInputError::NotPositive {
        length,
        value: Quantity::length(x),
    };
    let positive = |length: CamLength, x: f64| {
        if x.is_finite() && x > 0.0 {
            Ok(())
        } else {
            Err(faulty(length, x))
        }
    };
    let finite = |length: CamLength, x: f64| match x.is_finite() {
        true => Ok(()),
        false => Err(CamInputError::NotFinite { length }),
    };
    let radius = follower.roller_radius();
    if follower.kind().is_mushroom() {
        positive(CamLength::ArcRadius, radius)?;
    } else if !(radius.is_finite() && radius >= 0.0) {
        return Err(faulty(CamLength::RollerRadius, radius).into());
    }
    finite(CamLength::Offset, follower.offset())?;
    if let Some([x, _]) = follower.pivot() {
        positive(CamLength::PivotDistance, x.abs())?;
    }
    if let Some(arm) = follower.arm() {
        positive(CamLength::Arm, arm.length)?;
    }
    finite(CamLength::FaceOffset, follower.face_offset())?;
    match *follower {
        Follower::TranslatingCam { base_height, .. } => {
            return Ok(positive(CamLength::BaseHeight, base_height)?);
        }
        Follower::Barrel { radius, .. } => return Ok(positive(CamLength::BarrelRadius, radius)?),
        _ => {}
    }
    positive(CamLength::PrimeRadius, follower.prime_radius())?;
    if follower.base_radius() > 0.0 {
        return Ok(());
    }
    Err(CamError::RollerFillsCam {
        radius: Quantity::length(radius),
        prime: Quantity::length(follower.prime_radius()),
    }
    .into())
}
