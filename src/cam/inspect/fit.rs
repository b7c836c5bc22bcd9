//! Rigid motions that fit measured points to the profile: local minima of the squared distances, from many initial angles.

use nalgebra::{Matrix3, Vector3};

use super::pose::{Pose, middle, wrapped};
use crate::cam::{Cam, ProfilePoint};

/// Difference of rotation, rad, below which two fits count as the same fit.
pub const SAME: f64 = 0.02;
/// Limit up to which the residual of another fit counts as equally good: a factor of the minimum residual, plus a length, m.
pub const ALIKE: (f64, f64) = (1.02, 1e-9);
/// Number of initial angles of the search.
const STARTS: usize = 72;
/// Approximate maximum number of measured points in the search.
const COARSE_POINTS: usize = 90;
/// Number of profile samples in the search.
const COARSE_PROFILE: usize = 360;
/// Maximum number of iterations from each initial angle.
const COARSE_ROUNDS: usize = 12;
/// Maximum number of iterations of the fit with exact foot points.
const ROUNDS: usize = 40;
/// Relative step at which the fit has converged.
const CONVERGED: f64 = 1e-14;
/// Number of minima of the search that are refined.
const REFINED: usize = 12;
/// Ratio of the minimum and maximum eigenvalues of the normal equations below which the cam counts as circular.
const ROUNDING: f64 = 1e-13;
/// Standard error of the rotation, rad, above which the points do not determine the rotation.
const UNSURE: f64 = 0.1;

/// A measured point `q` in the cam's frame. The other fields are the cam angle and the outward normal at its foot point, and its distance
/// from the profile along this normal, m.
#[derive(Debug, Clone, Copy)]
pub struct Foot {
    pub q: [f64; 2],
    pub theta: f64,
    pub normal: [f64; 2],
    pub distance: f64,
}

/// A sampled profile point with its outward normal and its cam angle.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub theta: f64,
    pub p: [f64; 2],
    pub normal: [f64; 2],
}

impl Cam {
    pub(super) fn samples(&self, n: usize) -> Vec<Sample> {
        let sample = |p: &ProfilePoint| Sample {
            theta: p.theta,
            p: [p.x, p.y],
            normal: self.normal(p),
        };
        self.profile(n).iter().map(sample).collect()
    }

    /// Initial poses for the fit, best first. They are the local minima of a coarse search. From each initial angle, this search minimises
    /// the distances to the tangents at the nearest samples.
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

/// Minimum and maximum distance of a profile from the cam's centre, m.
pub fn radii(samples: &[Sample]) -> (f64, f64) {
    let radii = samples.iter().map(|s| libm::hypot(s.p[0], s.p[1]));
    radii.fold((f64::INFINITY, 0.0), |(l, h), r| (l.min(r), h.max(r)))
}

/// Profile for the fit with exact distances. Its samples give the initial values of the foot points.
pub struct Exact<'a> {
    pub cam: &'a Cam,
    pub ball: f64,
    pub samples: Vec<Sample>,
    pub longest: f64,
}

/// A pose with the foot points of all measured points, and the root mean square of the distances of the kept points, m.
pub struct Fit {
    pub rms: f64,
    pub pose: Pose,
    pub feet: Vec<Foot>,
}

impl Exact<'_> {
    /// Fits for which the sum of squared distances of the kept points has a local minimum, in ascending order of the residual. Among equal
    /// fits, the first has its centre nearest to the origin of the measuring frame, because most cams are measured about their shaft.
    pub fn fits(&self, points: &[[f64; 2]], kept: &[bool]) -> Vec<Fit> {
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
            let far = |pose: &Pose| libm::hypot(pose.centre()[0], pose.centre()[1]);
            fits[..equal].sort_by(|a, b| far(&a.pose).total_cmp(&far(&b.pose)));
        }
        fits
    }

    /// Foot point of `q`: the profile point whose normal passes through `q`.
    pub fn foot(&self, q: [f64; 2]) -> Foot {
        let n = self.samples.len();
        let near = nearest(&self.samples, self.longest, q);
        let step = std::f64::consts::TAU / n as f64;
        let here = self.samples[near].theta;
        let along = |s: &Sample| {
            let [x, y] = [q[0] - s.p[0], q[1] - s.p[1]];
            // The tangent in the direction of increasing θ is the outward normal rotated clockwise by a quarter turn.
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

/// Root of a function that decreases from a positive value at `low` to a negative value at `high`. `None` if the function does not have
/// these signs. The method is false position with halved value of the older end (Illinois method).
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

/// Profile sample nearest to a point. The distance changes by at most `longest` from one sample to the next, so samples far from the point
/// are skipped. Skipping them makes inspections three times as fast.
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

/// Maximum distance between neighbouring samples, m, plus a margin for rounding.
pub fn longest(samples: &[Sample]) -> f64 {
    let between = |s: &[Sample]| libm::hypot(s[1].p[0] - s[0].p[0], s[1].p[1] - s[0].p[1]);
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

/// Normal equations of the linearised distances, with the rotation scaled by the size of the cam.
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

/// Fit that starts at a pose. `foot` computes the foot point of a point in the cam's frame. The iteration ends after a maximum number of
/// steps, or when a step is smaller than a fraction of `size`.
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

/// Step of the Gauss–Newton method: rotation, rad, and shift, m.
fn step(feet: &[Foot], pose: &Pose, size: f64) -> Option<[f64; 3]> {
    let (matrix, right) = normal_equations(feet, pose, size);
    let solution = matrix.cholesky()?.solve(&right);
    let step = [solution[0] / size, solution[1], solution[2]];
    step.iter().all(|x| x.is_finite()).then_some(step)
}

/// Whether the points determine the rotation of the cam. This requires a small standard error of the rotation, computed from the scatter of
/// the points about the profile. It also requires that the profile is not circular.
pub fn is_determined(feet: &[Foot], pose: &Pose, size: f64) -> bool {
    let (matrix, _) = normal_equations(feet, pose, size);
    let shares = matrix.symmetric_eigenvalues();
    shares.min() > ROUNDING * shares.max() && rms(feet) < UNSURE * size * shares.min().sqrt()
}

pub fn rms(feet: &[Foot]) -> f64 {
    let squares = feet.iter().map(|f| f.distance * f.distance);
    (squares.sum::<f64>() / feet.len() as f64).sqrt()
}

/// Items of the list `all` that are marked as kept in `kept`.
pub fn chosen<T: Copy>(all: &[T], kept: &[bool]) -> Vec<T> {
    let is_kept = |(one, kept): (&T, &bool)| kept.then_some(*one);
    all.iter().zip(kept).filter_map(is_kept).collect()
}
