//! Inspection of a manufactured cam: deviations of measured points from the profile.
//!
//! The centre and the zero angle of the cam are unknown in the measuring frame. The best fit is the rigid motion (rotation and shift) with
//! the minimum sum of squared normal distances to the exact profile. It is computed by the Gauss–Newton method. The distance of a point q
//! in the cam's frame changes by n·J(q − b) per rotation and by n per shift. Here n is the normal at the foot point, b the centre of the
//! rotation, and J the rotation by 90°. The sum has other local minima, so the search starts from many angles.
//!
//! Points far outside the scatter of the other points are outliers. They are listed and excluded from the fit. Points of the mirror image
//! are rejected. A part of the profile without points is reported.
//!
//! A rotation or translation of the whole cam is not a deviation. An eccentric bore is therefore detected only if the centre of the bore is
//! measured as well.

mod coverage;
mod fit;
mod outliers;
mod pose;

use super::Cam;
use crate::error::{CamInputError, Result};
use crate::units::Quantity;
use fit::{ALIKE, Exact, Fit, Foot, SAME, chosen, is_determined, longest, radii, rms};
use outliers::without_outliers;
use pose::{Pose, middle, wrapped};

/// Minimum number of measured points. The fit has three unknowns, and further points determine the shape.
pub const FEWEST: usize = 12;
/// Number of profile samples. The sample nearest to a measured point is the initial value of its foot point.
const PROFILE: usize = 2880;
/// Maximum residual of the fit if the points belong to this cam, relative to the difference of the profile's maximum and minimum radius.
const OTHER: f64 = 0.1;
/// Maximum number of iterations that detect and exclude outliers.
const OUTLIER_ROUNDS: usize = 3;
/// Thresholds above which the points count as points of the mirror image. The first is the ratio of the residuals for the cam and for its
/// mirror image. The second is the residual for the cam, relative to its maximum radius.
const MIRRORED: (f64, f64) = (10.0, 1e-5);

/// Deviation of a measured point from the profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // A cam that is 0.01 mm too large all around, measured at every 10°.
/// let law = Law::harmonic(0.01, &[(0.006, 0.004), (0.001, -0.002)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.04 })?;
/// let larger = Cam::new(cam.law.clone(), Follower::FlatTranslating { base_radius: 0.04001 })?;
/// let measured: Vec<[f64; 2]> = larger.profile(36).iter().map(|p| [p.x, p.y]).collect();
/// for deviation in cam.inspect(&measured, 0.0)?.deviations {
///     assert!((deviation.normal - 1e-5).abs() < 1e-7);
/// }
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Index of the point in the list of measured points, from 0.
    pub row: usize,
    /// Cam angle at which the foot point on the profile touches the follower, rad.
    pub theta: f64,
    /// Distance from the profile along the normal, m; positive for excess material.
    pub normal: f64,
    /// Whether the point is far outside the scatter of the other points and therefore excluded from the fit.
    pub is_outlier: bool,
}

/// Rigid motion that fits the measured points best, and the deviations of the points from the profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // Points of the exact profile, with the cam rotated by 30° in the measuring machine.
/// let law = Law::harmonic(0.01, &[(0.006, 0.004), (0.001, -0.002)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.04 })?;
/// let (sin, cos) = (std::f64::consts::PI / 6.0).sin_cos();
/// let turned = cam.profile(36).iter().map(|p| [cos * p.x - sin * p.y, sin * p.x + cos * p.y]).collect::<Vec<_>>();
/// let found = cam.inspect(&turned, 0.0)?;
/// assert!((found.turn - std::f64::consts::PI / 6.0).abs() < 1e-6);
/// assert!(found.rms() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// Rotation of the cam in the measuring frame, counter-clockwise, rad in (−π, π].
    pub turn: f64,
    /// Position of the cam's centre in the measuring frame, m.
    pub centre: [f64; 2],
    /// Deviations in the order of the cam angles.
    pub deviations: Vec<Deviation>,
    /// Other rotations with an equally good fit, rad; for cams with rotational symmetry.
    pub alike: Vec<f64>,
    /// Cam angles, rad, between which the profile was not measured; `None` if the points cover the whole profile.
    pub unmeasured: Option<[f64; 2]>,
}

impl Inspection {
    /// Deviations of the points that are not outliers.
    pub fn kept(&self) -> impl Iterator<Item = &Deviation> {
        self.deviations.iter().filter(|d| !d.is_outlier)
    }

    /// Root mean square of the deviations without outliers, m.
    pub fn rms(&self) -> f64 {
        let (sum, count) = self.kept().fold((0.0, 0.0), |(sum, count), d| {
            (sum + d.normal * d.normal, count + 1.0)
        });
        (sum / f64::max(count, 1.0)).sqrt()
    }

    /// Deviations of the two points farthest inside and farthest outside the profile, without outliers; `None` without points.
    pub fn extremes(&self) -> Option<[Deviation; 2]> {
        let order = |a: &&Deviation, b: &&Deviation| a.normal.total_cmp(&b.normal);
        let least = self.kept().min_by(order)?;
        let most = self.kept().max_by(order)?;
        Some([*least, *most])
    }
}

impl Cam {
    /// Fits measured points (m, in any order and frame) to the profile. If `ball` is positive, the points are centres of a probing ball of
    /// this radius, m.
    ///
    /// # Errors
    ///
    /// There are fewer than 12 points, or a coordinate is not finite. The points belong to another cam or to the mirror image. The cam is
    /// circular within the scatter of the points, or it does not rotate.
    pub fn inspect(&self, points: &[[f64; 2]], ball: f64) -> Result<Inspection> {
        self.refuse_unfit(points)?;
        let samples = self.samples(PROFILE);
        let exact = Exact {
            cam: self,
            ball,
            longest: longest(&samples),
            samples,
        };
        let (low, high) = radii(&exact.samples);
        let mut kept = vec![true; points.len()];
        let mut fits = exact.fits(points, &kept);
        for _ in 0..OUTLIER_ROUNDS {
            let Some(fewer) = fits
                .first()
                .and_then(|fit| without_outliers(&fit.feet, high))
            else {
                break;
            };
            if fewer == kept {
                break;
            }
            kept = fewer;
            fits = exact.fits(points, &kept);
        }
        let Some(best) = fits.first() else {
            return Err(CamInputError::MeasuredCircle.into());
        };
        if best.rms > MIRRORED.1 * high {
            let mirrored: Vec<[f64; 2]> = points.iter().map(|[x, y]| [-x, *y]).collect();
            let mirrored = exact.fits(&mirrored, &kept);
            let fits = |other: &&Fit| {
                other.rms * MIRRORED.0 < best.rms && other.rms <= OTHER * (high - low)
            };
            if let Some(other) = mirrored.first().filter(fits) {
                return Err(CamInputError::MeasuredMirror {
                    distance: Quantity::length(best.rms),
                    mirrored: Quantity::length(other.rms),
                }
                .into());
            }
        }
        if best.rms > OTHER * (high - low) {
            // For points of another cam, the fit may diverge. The error then contains the residual with coinciding centres, which is
            // finite.
            let outline: Vec<[f64; 2]> = exact.samples.iter().map(|s| s.p).collect();
            let (angle, pivot, place) = (0.0, middle(points), middle(&outline));
            let laid = Pose {
                angle,
                pivot,
                place,
            };
            let feet = points.iter().map(|m| exact.foot(laid.seen(*m)));
            let laid = rms(&feet.collect::<Vec<Foot>>());
            return Err(CamInputError::MeasuredOther {
                distance: Quantity::length(best.rms.min(laid)),
                low: Quantity::length(low),
                high: Quantity::length(high),
            }
            .into());
        }
        if !is_determined(&chosen(&best.feet, &kept), &best.pose, high) {
            return Err(CamInputError::MeasuredCircle.into());
        }
        let mut turns = vec![wrapped(-best.pose.angle)];
        for other in &fits[1..] {
            let turn = wrapped(-other.pose.angle);
            let listed = turns.iter().any(|t| wrapped(t - turn).abs() < SAME);
            if other.rms <= ALIKE.0 * best.rms + ALIKE.1 && !listed {
                turns.push(turn);
            }
        }
        let deviations = deviations(&best.feet, &kept);
        let outline: Vec<[f64; 2]> = exact.samples.iter().map(|s| s.p).collect();
        let of_kept = deviations.iter().filter(|d| !d.is_outlier);
        let angles: Vec<f64> = of_kept.map(|d| d.theta).collect();
        Ok(Inspection {
            turn: turns[0],
            centre: best.pose.centre(),
            unmeasured: coverage::unmeasured(&outline, &angles),
            deviations,
            alike: turns[1..].to_vec(),
        })
    }

    fn refuse_unfit(&self, points: &[[f64; 2]]) -> Result<()> {
        if self.follower.is_unrolled() {
            let follower = self.follower.name();
            return Err(CamInputError::MeasuredUnrolled { follower }.into());
        }
        if let Some(row) = points.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            return Err(CamInputError::MeasuredNotFinite { row: row + 1 }.into());
        }
        if points.len() < FEWEST {
            let (points, least) = (points.len(), FEWEST);
            return Err(CamInputError::MeasuredFew { points, least }.into());
        }
        Ok(())
    }
}

fn deviations(feet: &[Foot], kept: &[bool]) -> Vec<Deviation> {
    let deviation = |(row, (f, kept)): (usize, (&Foot, &bool))| Deviation {
        row,
        theta: f.theta,
        normal: f.distance,
        is_outlier: !kept,
    };
    let feet = feet.iter().zip(kept).enumerate();
    let mut out: Vec<Deviation> = feet.map(deviation).collect();
    out.sort_by(|a, b| a.theta.total_cmp(&b.theta));
    out
}
