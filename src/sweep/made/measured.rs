//! Law, force, acceleration and lift-off of a manufactured cam, from the measured deviations of its profile.
//!
//! To first order and at the same cam angle, a deviation δ along the normal of the profile moves the follower by ε = δ/l. For a translating
//! follower, l is the cosine of the pressure angle. For an arm, l is the lever arm of the normal about the pivot.
//!
//! The displacement ε(θ) is fitted by a Fourier series, whose number of harmonics is selected by Schwarz's criterion. The residual of the
//! fit consists of measurement noise and roughness. It is excluded, because the derivatives would amplify it.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};

use super::over_time::{OverTime, POINTS, angle};
use crate::cam::{Cam, Inspection};
use crate::dynamics::rigid::liftoff_speed;
use crate::dynamics::rigid::touch::held;
use crate::law::{Law, Wave};
use crate::synth::Design;

/// Maximum number of harmonics in the fit.
const MOST_WAVES: usize = 60;
/// Minimum number of measured points for each harmonic of the fit.
const POINTS_PER_WAVE: usize = 4;
/// Residual of the fit, m, below which it counts as a rounding error.
const ROUNDING: f64 = 1e-10;

/// Force and motion of a follower in its machine. The extremes of force and acceleration are exact for the continuous law. Force errors are
/// computed at 4096 cam angles.
///
/// ```
/// use gaitcam::sweep::MadeCam;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// // A cam without deviations behaves like the design.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let points: Vec<[f64; 2]> = design.cam.profile(360).iter().map(|p| [p.x, p.y]).collect();
/// let made = MadeCam::of(&design, &design.cam.inspect(&points, 0.0)?).unwrap();
/// assert!((made.made.max_n / made.designed.max_n - 1.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Behaviour {
    /// RMS force error, N; `None` without a target force.
    pub rms_error_n: Option<f64>,
    /// Maximum force error, N; `None` without a target force.
    pub max_error_n: Option<f64>,
    /// Minimum contact force over the turn, N.
    pub min_n: f64,
    /// Maximum contact force over the turn, N.
    pub max_n: f64,
    /// Maximum magnitude of the acceleration at the mean speed, m/s² (rad/s² for an arm).
    pub acceleration: f64,
    /// Minimum speed of the cam at which the follower lifts off, rad/s. `None` if it does not lift off at any speed. Also `None` for form
    /// closure, a moving floor or a drive without force.
    pub liftoff_speed: Option<f64>,
}

/// Behaviour of a cam as manufactured, and as designed for comparison.
///
/// ```
/// use gaitcam::sweep::MadeCam;
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// let points: Vec<[f64; 2]> = design.cam.profile(360).iter().map(|p| [p.x, p.y]).collect();
/// let made = MadeCam::of(&design, &design.cam.inspect(&points, 0.0)?).unwrap();
/// assert!((made.law.stroke() - design.cam.law.stroke()).abs() < 1e-8);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MadeCam {
    /// Law of motion of the cam as manufactured.
    pub law: Law,
    /// Number of harmonics in the difference between the law as manufactured and the law as designed.
    pub waves: usize,
    /// RMS residual of the fit of the measured points, m (rad for an arm).
    pub left: f64,
    /// Behaviour of the cam as manufactured.
    pub made: Behaviour,
    /// Behaviour of the cam as designed.
    pub designed: Behaviour,
}

impl MadeCam {
    /// Determines the cam as manufactured from the inspected points that are not outliers. `None` if the law is not closed, if it does not
    /// extend from 0 to 2π, or if a part of the profile was not measured.
    pub fn of(design: &Design, inspection: &Inspection) -> Option<MadeCam> {
        let (start, length) = design.cam.law.extent();
        if inspection.unmeasured.is_some()
            || !design.cam.law.is_closed()
            || (length - TAU).abs() > 1e-9
            || start != 0.0
        {
            return None;
        }
        let moves: Vec<(f64, f64)> = inspection
            .kept()
            .map(|d| (d.theta, d.normal / lever(&design.cam, d.theta)))
            .collect();
        let series = Series::fitted(&moves);
        let law = series.added_to(&design.cam.law);
        let pressing = series.added_to(design.pressing());
        Some(MadeCam {
            made: behaviour(design, &pressing, &law),
            designed: behaviour(design, design.pressing(), &design.cam.law),
            law,
            waves: series.terms.len(),
            left: series.left,
        })
    }
}

fn behaviour(design: &Design, pressing: &Law, cut: &Law) -> Behaviour {
    let (drive, problem) = (&design.problem.drive, &design.problem);
    let (low, high) = problem.force_extremes(pressing);
    let (least, most) = pressing.extremes(2);
    let error = |target: &crate::force::ForceCurve| {
        let off = |i: usize| {
            let theta = angle(i);
            drive.force(pressing.svaj(theta)) + problem.extra_force(theta) - target.at(theta)
        };
        let off: Vec<f64> = (0..POINTS).map(off).collect();
        let largest = off.iter().fold(0.0, |most: f64, off| most.max(off.abs()));
        (OverTime::of(design, target).error(|i| off[i]), largest)
    };
    let error = design.target().map(error);
    let made = Cam {
        law: cut.clone(),
        follower: design.cam.follower,
    };
    let second = design.conjugate.as_ref().map(|pair| &pair.second);
    let free = !design.is_idle() && design.floor.is_none() && !held(&made, second);
    Behaviour {
        rms_error_n: error.map(|e| e.0),
        max_error_n: error.map(|e| e.1),
        min_n: low.value,
        max_n: high.value,
        acceleration: drive.speed * drive.speed * most.value.max(-least.value),
        liftoff_speed: free.then(|| liftoff_speed(pressing, drive)).flatten(),
    }
}

/// Ratio of a displacement of the profile along its normal to the displacement of the follower. It is the cosine of the pressure angle. For
/// an arm, it is the lever arm of the normal about the pivot, m.
fn lever(cam: &Cam, theta: f64) -> f64 {
    let point = cam.point(theta);
    let normal = cam.normal(&point);
    let (sin, cos) = libm::sincos(theta);
    match cam.follower.pivot() {
        None => normal[0] * sin + normal[1] * cos,
        Some([c, _]) => {
            let arm = [point.x - c * cos, point.y + c * sin];
            // With a pivot on +x, a clockwise rotation lifts the follower. With a pivot on −x, a counter-clockwise rotation lifts it.
            -c.signum() * (normal[1] * arm[0] - normal[0] * arm[1])
        }
    }
}

/// A Fourier series over the cam angle, with its mean and its harmonics.
struct Series {
    mean: f64,
    /// Amplitudes (cosine, sine) of the harmonics 1, 2, … of the turn.
    terms: Vec<(f64, f64)>,
    /// RMS residual of the fit, m (rad for an arm).
    left: f64,
}

impl Series {
    /// Least-squares fit of values at increasing angles, rad. The number of harmonics minimises n ln(mean square residual) + (number of
    /// coefficients) ln n, where n is the number of values. Half the shortest wavelength is at least the maximum gap between angles.
    fn fitted(values: &[(f64, f64)]) -> Series {
        let n = values.len();
        let most = MOST_WAVES
            .min(n.saturating_sub(1) / POINTS_PER_WAVE)
            .min((PI / widest_gap(values)) as usize);
        let columns = DMatrix::from_fn(n, 2 * most + 1, |i, k| column(k, values[i].0));
        let qr = columns.qr();
        // Components of the values along the orthogonalised columns. Each component reduces the sum of squares by the square of the
        // component.
        let mut shares = DVector::from_iterator(n, values.iter().map(|v| v.1));
        let mut square = shares.norm_squared();
        qr.q_tr_mul(&mut shares);
        let mut best = (f64::INFINITY, 0, 0.0);
        for k in 0..=2 * most {
            square = (square - shares[k] * shares[k]).max(0.0);
            if k % 2 == 0 {
                let mean = (square / n as f64).max(ROUNDING * ROUNDING);
                let score = n as f64 * libm::log(mean) + (k + 1) as f64 * libm::log(n as f64);
                if score < best.0 {
                    best = (score, k + 1, square);
                }
            }
        }
        let (_, kept, left) = best;
        let triangle = qr.r().view((0, 0), (kept, kept)).into_owned();
        let solution = triangle.solve_upper_triangular(&shares.rows(0, kept).into_owned());
        let coefficients: Vec<f64> = solution.iter().flat_map(|c| c.iter().copied()).collect();
        let waves = coefficients.get(1..).unwrap_or_default();
        Series {
            mean: coefficients.first().copied().unwrap_or(0.0),
            terms: waves.chunks_exact(2).map(|c| (c[0], c[1])).collect(),
            left: (left / n as f64).sqrt(),
        }
    }

    /// Sum of a law and the series, as a law.
    fn added_to(&self, law: &Law) -> Law {
        let raised = law.raised(self.mean);
        let waves: Vec<Vec<Wave>> = (0..raised.poly().pieces())
            .map(|i| {
                let start = raised.breaks()[i];
                let own = raised.waves(i).iter().copied();
                let added = self.terms.iter().enumerate().map(|(k, &(cos, sin))| {
                    let rate = (k + 1) as f64;
                    Wave { rate, cos, sin }.from(start)
                });
                own.chain(added).collect()
            })
            .collect();
        Law::with_waves(raised.poly().clone(), waves, true)
    }
}

fn widest_gap(values: &[(f64, f64)]) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return TAU;
    };
    let seam = first.0 + TAU - last.0;
    values
        .windows(2)
        .map(|w| w[1].0 - w[0].0)
        .fold(seam, f64::max)
}

/// Value at θ of the k-th of the basis functions 1, cos θ, sin θ, cos 2θ, …
fn column(k: usize, theta: f64) -> f64 {
    let wave = k.div_ceil(2) as f64;
    match k % 2 {
        1 => libm::cos(wave * theta),
        _ if k == 0 => 1.0,
        _ => libm::sin(wave * theta),
    }
}
