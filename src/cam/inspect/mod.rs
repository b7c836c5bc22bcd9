//! Inspection of a manufactured cam: deviations of measured points from the profile.
//!
//! The machine knows neither the cam's centre nor its zero angle. The best fit is the rigid motion (a turn and
//! a shift) with the least sum of squared normal distances to the exact profile, found by Gauss and Newton's
//! method: the distance of a point changes by n·J(q − b) per turn and by n per shift, n being the normal at its
//! foot. The sum has other minima, so the search starts from many angles.
//!
//! Points far outside the scatter of the others are outliers: they are listed and left out of the fit. Points of the
//! mirror image are refused, and a part of the profile without points is reported.
//!
//! A rotation or translation of the whole cam is not a deviation: an eccentric bore is detected only if the centre of
//! the bore is measured as well.

mod coverage;
mod pose;

use nalgebra::{Matrix3, Vector3};

use super::{Cam, ProfilePoint};
use crate::error::{CamInputError, Result};
use crate::units::Quantity;
use pose::{Pose, middle, wrapped};

/// Fewest points: three unknowns and a shape to tell.
pub const FEWEST: usize = 12;
/// Angles from which the search starts.
const STARTS: usize = 72;
/// Points and profile samples of the search, and its rounds.
const COARSE_POINTS: usize = 90;
const COARSE_PROFILE: usize = 360;
const COARSE_ROUNDS: usize = 12;
/// Samples among which the foot of a point is looked for, and rounds of the fit on exact feet.
const PROFILE: usize = 2880;
const ROUNDS: usize = 40;
/// Relative step at which the fit has converged.
const CONVERGED: f64 = 1e-14;
/// Fits closer to each other than this, rad, are the same.
const SAME: f64 = 0.02;
/// Minima of the search that are refined.
const REFINED: usize = 12;
/// Fits within this factor, or this length in m, of the best are equally good.
const ALIKE: (f64, f64) = (1.02, 1e-9);
/// Largest deviation, relative to the difference of radii, of points that belong to this cam.
const OTHER: f64 = 0.1;
/// Smallest eigenvalue of the normal equations as a share of the largest, below which it is rounding: a circle.
const ROUNDING: f64 = 1e-13;
/// Standard error of the turn, rad, above which the points do not show it.
const UNSURE: f64 = 0.1;

/// Outliers: deviations from the median above this many standard deviations, the latter from the median absolute
/// deviation, and above this part of the largest radius.
const OUTLIER: (f64, f64) = (10.0, 1e-6);
/// Standard deviation of a normal distribution by its median absolute deviation.
const NORMAL: f64 = 1.4826;
/// Largest share of outliers; more of them are the shape of the cam.
const FEW: f64 = 0.05;
/// Rounds in which outliers are looked for and left out.
const OUTLIER_ROUNDS: usize = 3;
/// Points that fit the mirror image this many times as well, and not the cam to this part of its largest radius, are
/// those of the mirror image.
const MIRRORED: (f64, f64) = (10.0, 1e-5);

/// One measured point against the profile.
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
    /// Its place in the list of measured points, from 0.
    pub row: usize,
    /// Cam angle at which its foot on the profile touches the follower, rad.
    pub theta: f64,
    /// Distance from the profile along the normal, m: positive where there is too much material.
    pub normal: f64,
    /// Far outside the scatter of the other points, and left out of the fit.
    pub is_outlier: bool,
}

/// Result of an inspection.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // The cam itself, turned by 30° in the measuring machine.
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
    /// Angle by which the cam lies turned counter-clockwise in the measuring frame, rad in (−π, π].
    pub turn: f64,
    /// The cam's centre in the measuring frame, m.
    pub centre: [f64; 2],
    /// The points in the order of their cam angles.
    pub deviations: Vec<Deviation>,
    /// Other rotations with an equally good fit, rad, for cams with rotational symmetry.
    pub alike: Vec<f64>,
    /// Cam angles, rad, from and to which the profile was not measured; `None` where the points are all around.
    pub unmeasured: Option<[f64; 2]>,
}

impl Inspection {
    /// The points that are not outliers.
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

    /// The points farthest inside and outside the profile, without outliers.
    pub fn extremes(&self) -> Option<[Deviation; 2]> {
        let order = |a: &&Deviation, b: &&Deviation| a.normal.total_cmp(&b.normal);
        let least = self.kept().min_by(order)?;
        let most = self.kept().max_by(order)?;
        Some([*least, *most])
    }
}

/// A point in the cam's frame with the profile's normal at its foot and its distance along that.
#[derive(Debug, Clone, Copy)]
struct Foot {
    q: [f64; 2],
    theta: f64,
    normal: [f64; 2],
    distance: f64,
}

/// A profile point with its outward normal.
#[derive(Debug, Clone, Copy)]
struct Sample {
    theta: f64,
    p: [f64; 2],
    normal: [f64; 2],
}

impl Cam {
    /// Fits measured points (m, any order, any frame) to the profile; with `ball` > 0 they are centres of a
    /// probing ball of that radius, m.
    ///
    /// # Errors
    /// On fewer than 12 points, on coordinates that are not finite, on points that fit nowhere (those of
    /// another cam) or those of the mirror image, on a cam that is a circle within the scatter of the points, whose
    /// zero angle cannot be found, and on a cam that does not turn.
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
            // Steps towards the points of another cam may lead ever farther away; laid on its middle they are near.
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

    fn samples(&self, n: usize) -> Vec<Sample> {
        let sample = |p: &ProfilePoint| Sample {
            theta: p.theta,
            p: [p.x, p.y],
            normal: self.normal(p),
        };
        self.profile(n).iter().map(sample).collect()
    }

    /// The minima that the search finds, best first: from every start the distances to the tangents at the
    /// nearest samples are made small.
    fn starts(&self, points: &[[f64; 2]], ball: f64) -> Vec<Pose> {
        let samples = self.samples(COARSE_PROFILE);
        let every = points.len().div_ceil(COARSE_POINTS);
        let few: Vec<[f64; 2]> = points.iter().copied().step_by(every).collect();
        let outline: Vec<[f64; 2]> = samples.iter().map(|s| s.p).collect();
        let (pivot, place) = (middle(points), middle(&outline));
        let (_, size) = radii(&samples);
        let longest = longest(&samples);
        let mut fits: Vec<(f64, Pose)> = Vec::new();
        for k in 0..STARTS {
            let start = Pose {
                angle: std::f64::consts::TAU * k as f64 / STARTS as f64,
                pivot,
                place,
            };
            let foot = |q| tangent_distance(&samples[nearest(&samples, longest, q)], q, ball);
            let (pose, feet) = fitted(start, &few, size, (COARSE_ROUNDS, 0.0), foot);
            fits.push((rms(&feet), pose));
        }
        fits.retain(|f| f.0.is_finite());
        fits.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut distinct: Vec<Pose> = Vec::new();
        for (_, pose) in fits {
            let same = |p: &Pose| wrapped(p.angle - pose.angle).abs() < SAME;
            if !distinct.iter().any(same) {
                distinct.push(pose);
            }
        }
        distinct.truncate(REFINED);
        distinct
    }
}

/// Smallest and largest distance of a profile from the cam's centre, m.
fn radii(samples: &[Sample]) -> (f64, f64) {
    let radii = samples.iter().map(|s| s.p[0].hypot(s.p[1]));
    radii.fold((f64::INFINITY, 0.0), |(l, h), r| (l.min(r), h.max(r)))
}

/// The profile itself, with samples to begin from.
struct Exact<'a> {
    cam: &'a Cam,
    ball: f64,
    samples: Vec<Sample>,
    longest: f64,
}

/// A pose with the feet of all points and the root mean square of the distances of those that are kept, m.
struct Fit {
    rms: f64,
    pose: Pose,
    feet: Vec<Foot>,
}

impl Exact<'_> {
    /// The minima of the distances of the points that are kept, best first; of equal ones first that whose centre is
    /// nearest to the frame's origin: most cams are measured about their shaft.
    fn fits(&self, points: &[[f64; 2]], kept: &[bool]) -> Vec<Fit> {
        let (_, high) = radii(&self.samples);
        let used = chosen(points, kept);
        let mut fits = Vec::new();
        for pose in self.cam.starts(&used, self.ball) {
            let (pose, feet) = fitted(pose, &used, high, (ROUNDS, CONVERGED), |q| self.foot(q));
            let rms = rms(&feet);
            let feet = points.iter().map(|m| self.foot(pose.seen(*m))).collect();
            fits.push(Fit { rms, pose, feet });
        }
        fits.sort_by(|a, b| a.rms.total_cmp(&b.rms));
        if let Some(least) = fits.first().map(|f| f.rms) {
            let equal = fits.partition_point(|f| f.rms <= least + ALIKE.1);
            let far = |pose: &Pose| pose.centre()[0].hypot(pose.centre()[1]);
            fits[..equal].sort_by(|a, b| far(&a.pose).total_cmp(&far(&b.pose)));
        }
        fits
    }

    /// The foot of a point: where the profile's tangent is square to the way from the profile to it.
    fn foot(&self, q: [f64; 2]) -> Foot {
        let n = self.samples.len();
        let near = nearest(&self.samples, self.longest, q);
        let step = std::f64::consts::TAU / n as f64;
        let here = self.samples[near].theta;
        let along = |s: &Sample| {
            let [x, y] = [q[0] - s.p[0], q[1] - s.p[1]];
            // The tangent in the sense of growing θ is the outward normal turned to the right.
            x * s.normal[1] - y * s.normal[0]
        };
        let at = |theta: f64| {
            let p = self.cam.point(theta);
            Sample {
                theta,
                p: [p.x, p.y],
                normal: self.cam.normal(&p),
            }
        };
        let theta = root(here - step, here + step, |theta| along(&at(theta)));
        let foot = at(theta.unwrap_or(here));
        Foot {
            theta: foot.theta.rem_euclid(std::f64::consts::TAU),
            ..tangent_distance(&foot, q, self.ball)
        }
    }
}

/// Root of a function that falls from above zero at `low` to below zero at `high`, by false position with the
/// older end's value halved (Illinois); `None` where the signs are not so.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut above, mut below) = (f(low), f(high));
    if above < 0.0 || below > 0.0 {
        return None;
    }
    let mut side = 0;
    let mut x = 0.5 * (low + high);
    for _ in 0..60 {
        let next = (low * below - high * above) / (below - above);
        if !next.is_finite() || (next - x).abs() < 1e-16 {
            break;
        }
        x = next;
        let value = f(x);
        if value == 0.0 {
            break;
        }
        if value > 0.0 {
            (low, above) = (x, value);
            if side == 1 {
                below *= 0.5;
            }
            side = 1;
        } else {
            (high, below) = (x, value);
            if side == -1 {
                above *= 0.5;
            }
            side = -1;
        }
    }
    Some(x)
}

/// The sample nearest to a point. Along the profile the distance changes by at most `longest` per sample, so that far
/// from the point samples are passed over; without that an inspection of 1440 points takes three times as long.
fn nearest(samples: &[Sample], longest: f64, q: [f64; 2]) -> usize {
    let distance = |i: usize| {
        let [x, y] = [q[0] - samples[i].p[0], q[1] - samples[i].p[1]];
        (x * x + y * y).sqrt()
    };
    let mut best = (0, f64::INFINITY);
    for step in [32, 1] {
        let mut i = 0;
        while i < samples.len() {
            let away = distance(i);
            if away < best.1 {
                best = (i, away);
            }
            i = i.saturating_add(step.max(((away - best.1) / longest) as usize));
        }
    }
    best.0
}

/// Longest distance between neighbouring samples, m; a little more for rounding.
fn longest(samples: &[Sample]) -> f64 {
    let between = |s: &[Sample]| (s[1].p[0] - s[0].p[0]).hypot(s[1].p[1] - s[0].p[1]);
    1.000_001
        * samples
            .windows(2)
            .map(between)
            .fold(f64::MIN_POSITIVE, f64::max)
}

fn tangent_distance(s: &Sample, q: [f64; 2], ball: f64) -> Foot {
    let away = (q[0] - s.p[0]) * s.normal[0] + (q[1] - s.p[1]) * s.normal[1];
    Foot {
        q,
        theta: s.theta,
        normal: s.normal,
        distance: away - ball,
    }
}

/// The normal equations of the linearised distances, the turn measured by the cam's size.
fn normal_equations(feet: &[Foot], pose: &Pose, size: f64) -> (Matrix3<f64>, Vector3<f64>) {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for foot in feet {
        let [x, y] = [foot.q[0] - pose.place[0], foot.q[1] - pose.place[1]];
        let [nx, ny] = foot.normal;
        let row = Vector3::new((ny * x - nx * y) / size, nx, ny);
        matrix += row * row.transpose();
        right -= foot.distance * row;
    }
    (matrix, right)
}

/// The fit that begins at a pose, each point with the foot that `foot` finds: at most so many rounds, and no more
/// once a step is smaller than a part of `size`.
fn fitted(
    mut pose: Pose,
    points: &[[f64; 2]],
    size: f64,
    (rounds, converged): (usize, f64),
    foot: impl Fn([f64; 2]) -> Foot,
) -> (Pose, Vec<Foot>) {
    let feet_of =
        |pose: &Pose| -> Vec<Foot> { points.iter().map(|m| foot(pose.seen(*m))).collect() };
    let mut feet = feet_of(&pose);
    for _ in 0..rounds {
        let Some(step) = step(&feet, &pose, size) else {
            break;
        };
        pose = pose.moved(step);
        feet = feet_of(&pose);
        let moved = step[0].abs() * size + step[1].abs() + step[2].abs();
        if moved < converged * size {
            break;
        }
    }
    (pose, feet)
}

/// The step of Gauss and Newton: turn, rad, and shift, m.
fn step(feet: &[Foot], pose: &Pose, size: f64) -> Option<[f64; 3]> {
    let (matrix, right) = normal_equations(feet, pose, size);
    let solution = matrix.cholesky()?.solve(&right);
    let step = [solution[0] / size, solution[1], solution[2]];
    step.iter().all(|x| x.is_finite()).then_some(step)
}

/// Whether the points determine the rotation of the cam: their scatter about the profile, carried through the normal
/// equations, leaves the turn small error.
fn is_determined(feet: &[Foot], pose: &Pose, size: f64) -> bool {
    let (matrix, _) = normal_equations(feet, pose, size);
    let shares = matrix.symmetric_eigenvalues();
    shares.min() > ROUNDING * shares.max() && rms(feet) < UNSURE * size * shares.min().sqrt()
}

fn rms(feet: &[Foot]) -> f64 {
    let squares = feet.iter().map(|f| f.distance * f.distance);
    (squares.sum::<f64>() / feet.len() as f64).sqrt()
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

fn chosen<T: Copy>(all: &[T], kept: &[bool]) -> Vec<T> {
    let is_kept = |(one, kept): (&T, &bool)| kept.then_some(*one);
    all.iter().zip(kept).filter_map(is_kept).collect()
}

/// Which points are no outliers; `None` where too many are far from the others.
fn without_outliers(feet: &[Foot], size: f64) -> Option<Vec<bool>> {
    let middle_of = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied()
    };
    let middle = middle_of(feet.iter().map(|f| f.distance).collect())?;
    let off = |f: &Foot| (f.distance - middle).abs();
    let scatter = NORMAL * middle_of(feet.iter().map(off).collect())?;
    let most = (OUTLIER.0 * scatter).max(OUTLIER.1 * size);
    let kept: Vec<bool> = feet.iter().map(|f| off(f) <= most).collect();
    let outliers = kept.iter().filter(|kept| !**kept).count();
    (outliers as f64 <= FEW * feet.len() as f64).then_some(kept)
}
