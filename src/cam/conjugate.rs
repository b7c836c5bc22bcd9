//! Conjugate cams: two cams on one shaft that enclose a double follower from both sides.
//!
//! In its own frame the second cam has the lift s₂ = s_max − s. Its follower points in the opposite direction, so the cam is rotated by
//! half a turn on the shaft. Offset and pivot change sign.

use super::{Cam, Follower, ProfilePoint, SizeLimits, smallest_for};
use serde_json::json;

use crate::error::{CamError, CamInputError, Result};
use crate::units::Quantity;
use serde::Serialize;

/// Dimension that determines the second cam of a pair.
///
/// ```
/// use gaitcam::cam::{Cam, Closure, Conjugate, Follower};
/// use gaitcam::law::Law;
///
/// // For faces 70 mm apart, a first base radius of 20 mm and a stroke of 20 mm, the second base radius is 30 mm.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// let pair = Conjugate::new(&cam, Closure::Distance(0.07), None)?;
/// assert!((pair.second.follower.base_radius() - 0.03).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Closure {
    /// Distance between the two faces, or between the two roller centres along the line of motion, m (translating followers).
    Distance(f64),
    /// Angle β between the two arms, rad (oscillating followers).
    Angle(f64),
    /// Base radius of the second cam, m.
    SecondBaseRadius(f64),
}

/// A pair of conjugate cams.
///
/// ```
/// use gaitcam::cam::{Cam, Closure, Conjugate, Follower};
/// use gaitcam::law::Law;
///
/// // Both faces stay 70 mm apart over the whole turn.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?;
/// let pair = Conjugate::new(&cam, Closure::SecondBaseRadius(0.03), None)?;
/// assert!((pair.total - 0.07).abs() < 1e-12);
/// assert!((pair.sum(1.0) - pair.total).abs() < 1e-12);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Conjugate {
    /// The cam that drives the rise.
    pub first: Cam,
    /// The cam that drives the fall, in its own frame. On the shaft, this cam is rotated by half a turn.
    pub second: Cam,
    /// Constant dimension between the two followers: distance, m, or angle between the arms, rad.
    pub total: f64,
}

impl Conjugate {
    /// Computes the second cam for the cam `first`. `second_roller` is the radius of the second roller, m; `None` for an equal roller.
    ///
    /// # Errors
    ///
    /// The first or the second cam is invalid, or `closure` does not match the kind of follower. If no second cam exists for a distance or
    /// an angle, the error contains the minimum feasible value, if a feasible value exists.
    pub fn new(first: &Cam, closure: Closure, second_roller: Option<f64>) -> Result<Conjugate> {
        Conjugate::closed(first, closure, second_roller, Cam::check)
    }

    /// Computes the pair as [`Conjugate::new`] does, but with the arms in planes other than those of the cams. The pivots of the arms may
    /// therefore lie within the profiles.
    ///
    /// # Errors
    ///
    /// The errors of [`Conjugate::new`].
    pub fn beside(first: &Cam, closure: Closure, second_roller: Option<f64>) -> Result<Conjugate> {
        Conjugate::closed(first, closure, second_roller, Cam::check_beside)
    }

    fn closed(
        first: &Cam,
        closure: Closure,
        second_roller: Option<f64>,
        check: fn(&Cam) -> Result<()>,
    ) -> Result<Conjugate> {
        check(first)?;
        let radius = second_roller.unwrap_or_else(|| first.follower.roller_radius());
        let (_, top) = Follower::lift_range(&first.law);
        let law = first.law.scaled(-1.0).raised(top);
        let mut second = Cam {
            law,
            follower: opposite(&first.follower, radius)?,
        };
        // Position of the first follower at maximum lift. The distance or angle of the closure is measured from this position.
        let reach = first.follower.start_place() + top;
        match closure {
            Closure::SecondBaseRadius(base) => {
                second.follower = second.follower.with_base_radius(base);
            }
            Closure::Distance(_) if first.follower.is_oscillating() => {
                return Err(CamInputError::ArmsByDistance.into());
            }
            Closure::Angle(_) if !first.follower.is_oscillating() => {
                return Err(CamInputError::SlidesByAngle.into());
            }
            Closure::Distance(total) | Closure::Angle(total) => {
                let start = total - reach;
                second.follower = second
                    .follower
                    .with_start_place(start)
                    .ok_or_else(|| no_conjugate(&second, reach, total))?;
            }
        }
        check(&second).map_err(|e| {
            let because = match (e.fault::<CamError>(), e.fault::<CamInputError>()) {
                (Some(fault), _) => json!(fault),
                (None, Some(fault)) => json!(fault),
                (None, None) => return e,
            };
            CamError::SecondCam { because }.into()
        })?;
        let total = reach + second.follower.start_place();
        Ok(Conjugate {
            first: first.clone(),
            second,
            total,
        })
    }

    /// Distance between the two faces or roller centres along the line of motion, m, or angle between the two arms, rad. It does not depend
    /// on θ.
    pub fn sum(&self, theta: f64) -> f64 {
        let (first, second) = (&self.first, &self.second);
        first.follower.start_place()
            + first.law.svaj(theta).s
            + second.follower.start_place()
            + second.law.svaj(theta).s
    }

    /// Profile of the second cam in the frame of the shaft.
    pub fn second_profile(&self, n: usize) -> Vec<ProfilePoint> {
        let own = self.second.profile(n).into_iter();
        own.map(half_turned).collect()
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

/// Follower of the second cam before its size is determined. It is on the opposite side of the shaft and has a roller of its own radius.
fn opposite(first: &Follower, radius: f64) -> Result<Follower> {
    let mut second = *first;
    match &mut second {
        Follower::FlatTranslating { .. } => {}
        Follower::RollerTranslating {
            offset,
            roller_radius,
            ..
        }
        | Follower::MushroomTranslating {
            offset,
            arc_radius: roller_radius,
            ..
        } => {
            *offset = -*offset;
            *roller_radius = radius;
        }
        Follower::RollerOscillating {
            pivot_distance,
            roller_radius,
            ..
        }
        | Follower::MushroomOscillating {
            pivot_distance,
            arc_radius: roller_radius,
            ..
        } => {
            *pivot_distance = -*pivot_distance;
            *roller_radius = radius;
        }
        Follower::FlatOscillating { pivot_distance, .. } => *pivot_distance = -*pivot_distance,
        Follower::TranslatingCam { .. } | Follower::Barrel { .. } => {
            return Err(CamInputError::NoConjugateOf {
                follower: first.kind().name(),
            }
            .into());
        }
    }
    Ok(second)
}

fn no_conjugate(second: &Cam, reach: f64, total: f64) -> CamError {
    let quantity = |x: f64| second.follower.lift_quantity(x);
    let base = smallest_for(second, &SizeLimits::no_undercut()).ok();
    let least = base.map(|b| reach + second.follower.with_base_radius(b).start_place());
    CamError::NoConjugate {
        total: quantity(total),
        reach: quantity(reach),
        least: least.map(quantity),
        base: base.map(Quantity::length),
    }
}
