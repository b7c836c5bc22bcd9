//! A contour drawn by hand as a smooth cam.

use super::smoothing::fewest_harmonics;
use gaitcam::cam::{Follower, ProfilePoint};
use gaitcam::dynamics::recover;
use gaitcam::error::Result;
use gaitcam::law::Law;
use std::f64::consts::TAU;

/// Angles at which the support function of the outline is taken.
const ANGLES: usize = 1440;

/// A smoothed outline.
#[derive(Debug, Clone)]
pub struct Outline {
    /// The lift it gives a flat face.
    pub law: Law,
    /// Harmonics kept.
    pub harmonics: usize,
}

/// The lift over a base circle that a closed outline drawn by hand gives a flat face.
///
/// A polyline is not a cam: it hops from facet to facet (theory §10). Its support function is smoothed to
/// the fewest harmonics that stay within `tolerance`, m, of it; no more than half as many as there are
/// points.
///
/// # Errors
/// When there is no such curve, or when it is not convex.
pub fn recover_outline(outline: &[[f64; 2]], base_radius: f64, tolerance: f64) -> Result<Outline> {
    if outline.len() < 8 || outline.iter().flatten().any(|x| !x.is_finite()) {
        return Err(crate::fault("an outline needs at least 8 finite points"));
    }
    let angle = |i: usize| TAU * i as f64 / ANGLES as f64;
    let heights: Vec<f64> = (0..ANGLES)
        .map(|i| {
            let (sin, cos) = angle(i).sin_cos();
            let reach = |p: &[f64; 2]| sin * p[0] + cos * p[1];
            outline.iter().map(reach).fold(f64::NEG_INFINITY, f64::max) - base_radius
        })
        .collect();
    let most = (outline.len() / 2).min(ANGLES / 4);
    let refused = || {
        crate::fault(format!(
            "the outline of {} points is no smooth convex cam within {tolerance:e} m",
            outline.len()
        ))
    };
    let smooth = fewest_harmonics(&heights, tolerance, most).ok_or_else(refused)?;
    let (heights, slopes) = smooth.sample(ANGLES);
    let points: Vec<ProfilePoint> = heights
        .iter()
        .zip(&slopes)
        .enumerate()
        .map(|(i, (height, slope))| {
            let (sin, cos) = angle(i).sin_cos();
            let stand = base_radius + height;
            ProfilePoint {
                theta: angle(i),
                x: cos * slope + sin * stand,
                y: cos * stand - sin * slope,
                ..ProfilePoint::default()
            }
        })
        .collect();
    let face = Follower::FlatTranslating { base_radius };
    let emitted = recover(&face, &points).map_err(|_| refused())?;
    Ok(Outline {
        law: emitted.law,
        harmonics: smooth.terms.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::thesis;

    #[test]
    fn a_polyline_by_hand_is_smoothed_within_its_tolerance_or_refused() {
        // Forty points on a cam of theory §3, rounded to a tenth of a millimetre as by a mouse.
        let cam = thesis::double_harmonic();
        let outline: Vec<[f64; 2]> = cam
            .profile(40)
            .iter()
            .map(|p| [(p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4])
            .collect();
        let smooth = recover_outline(&outline, 0.03, 2e-4).unwrap();
        assert!(smooth.harmonics <= 20);
        for i in 0..360 {
            let t = f64::from(i).to_radians();
            assert!((smooth.law.svaj(t).s - cam.law.svaj(t).s).abs() < 4e-4);
        }
        let message = recover_outline(&outline, 0.03, 1e-7)
            .unwrap_err()
            .to_string();
        assert!(message.contains("no smooth convex cam"), "{message}");
    }
}
