//! Cams of constant breadth between parallel faces, of constant diameter between rollers.

use super::fit::mm;
use super::{Cam, Follower};
use crate::error::{Error, Result};
use crate::law::{Segment, constant_breadth};

/// The cam between two parallel flat faces `breadth` apart (m), from the law of its first half turn:
/// base radius (breadth − lift)/2. Both faces touch all the time.
pub fn constant_breadth_cam(half: &[Segment], breadth: f64) -> Result<Cam> {
    let law = constant_breadth(half)?;
    let lift: f64 = half.iter().map(|s| s.lift).sum();
    if !breadth.is_finite() || breadth <= lift {
        return Err(Error::new(format!(
            "a breadth of {} cannot hold a lift of {}",
            mm(breadth),
            mm(lift)
        ))
        .help(format!(
            "the breadth is twice the base radius plus the lift: more than {}",
            mm(lift)
        )));
    }
    let base_radius = 0.5 * (breadth - lift);
    Cam::new(law, Follower::FlatTranslating { base_radius })
}

/// The cam between two rollers whose centres stand `distance` apart (m) on a line through the cam's
/// centre, from the law of its first half turn: prime radius (distance − lift)/2.
pub fn constant_diameter_cam(half: &[Segment], distance: f64, roller_radius: f64) -> Result<Cam> {
    let law = constant_breadth(half)?;
    let lift: f64 = half.iter().map(|s| s.lift).sum();
    let prime_radius = 0.5 * (distance - lift);
    if !prime_radius.is_finite() || prime_radius <= roller_radius {
        return Err(Error::new(format!(
            "rollers of radius {} with centres {} apart leave no cam for a lift of {}",
            mm(roller_radius),
            mm(distance),
            mm(lift)
        ))
        .help(format!(
            "the distance is twice the prime radius plus the lift: more than {}",
            mm(lift + 2.0 * roller_radius)
        )));
    }
    Cam::new(
        law,
        Follower::RollerTranslating {
            prime_radius,
            offset: 0.0,
            roller_radius,
        },
    )
}
