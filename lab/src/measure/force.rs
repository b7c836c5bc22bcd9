//! Charts (a): law from a force.

use std::hint::black_box;

use nalgebra::{DMatrix, DVector};

use super::{Watch, footbridge, force_error, reference, rms_error};
use crate::chart::{Chart, Row};
use crate::tiers::{Task, first_rung, spectral};
use gaitcam::cam::{Cam, Follower, ProfilePoint};
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::problem::Problem;
use gaitcam::scene::built_in;
use gaitcam::synth::{Search, design};

const ERROR: &str = "RMS force error on 4001 angles, part of the mean force";

/// Accuracy of the default scene relative to the mean force.
const DEFAULT_ACCURACY: f64 = 0.005;

/// Step-to-step variation, below which accuracy has no measurable effect (theory §11).
fn levels() -> Vec<(f64, String)> {
    vec![
        (0.03, "step-to-step spread of a walker, 3 %".to_string()),
        (DEFAULT_ACCURACY, "default accuracy, 0.5 %".to_string()),
    ]
}

/// Chart for a force without corners: both feet on a footbridge, moving axis.
pub fn smooth(watch: &Watch) -> Result<Chart> {
    let (target, drive) = footbridge()?;
    let mut rows = Vec::new();
    splines(watch, &target, drive, &mut rows)?;
    harmonics(watch, &target, drive, &mut rows, &[1, 2, 3, 4, 5, 10, 40])?;
    for degree in [6, 8, 12, 16, 20] {
        let ((law, _), timing) = watch.time(|| {
            let fit = reference::periodic_polynomial(&target, &drive, degree);
            black_box(fit.0.as_ref().map(values));
            fit
        });
        let error = match &law {
            Some(force) => rms_error(force, &target),
            None => f64::NAN,
        };
        rows.push(timing.row(
            "one polynomial, least squares",
            format!("degree {degree}"),
            error,
        ));
    }
    fitted_double_harmonic(watch, &target, drive, &mut rows)?;
    Ok(Chart {
        file: "speed_accuracy_a1".to_string(),
        title: "(a1) Force to law, smooth force".to_string(),
        task: "Young's load of both feet at 1.85 Hz, 1024 samples, moving axis; laws without limits. Times include all steps from the samples to a profile of 1440 points (for the textbook methods: 1440 values).".to_string(),
        error: ERROR.to_string(),
        levels: levels(),
        advice: "Use the default. Without a given family it is harmonics in closed form, with the number that reaches the accuracy; this is the fastest and most accurate method. If harmonics violate limits, dwells or points, a spline is used, which can adapt locally.".to_string(),
        rows,
        ..Chart::default()
    })
}

/// Chart for a force with a heel strike and a swing phase: one foot, hydraulic (lift proportional to force).
pub fn heel(watch: &Watch) -> Result<Chart> {
    let target = with_heel_transient(model("iso-22675", None, 824.0, Feet::One)?);
    let drive = Drive::hydraulic(
        30.0 * 6894.757 / 1.6387e-5,
        0.01905,
        std::f64::consts::TAU / target.period_s,
    );
    let mut rows = Vec::new();
    splines(watch, &target, drive, &mut rows)?;
    harmonics(
        watch,
        &target,
        drive,
        &mut rows,
        &[4, 8, 16, 32, 64, 128, 256],
    )?;
    textbook(watch, &target, &mut rows)?;
    fitted_double_harmonic(watch, &target, drive, &mut rows)?;
    Ok(Chart {
        file: "speed_accuracy_a2".to_string(),
        title: "(a2) Force to law, heel strike and swing".to_string(),
        task: "One foot of the ISO 22675 load, 824 N, with a heel transient of 30 %, 1024 samples a stride, lift proportional to force; laws without limits. Times include all steps from the samples to a profile of 1440 points (for the textbook methods: 1440 values). Polynomials cover only the stance.".to_string(),
        error: ERROR.to_string(),
        levels: levels(),
        advice: "Use the default. Harmonics in closed form, with the number that reaches the accuracy, are smooth in every derivative. A spline with a known number of spans takes as little as half the time, but only its lowest derivatives are smooth. With an active limit, use a quartic spline of 64 spans, or a quintic spline if the jerk must be smooth. One polynomial through critical points overshoots.".to_string(),
        rows,
        ..Chart::default()
    })
}

fn splines(watch: &Watch, target: &ForceCurve, drive: Drive, rows: &mut Vec<Row>) -> Result<()> {
    let spans: &[usize] = if watch.quick {
        &[4, 8, 16, 64, 256]
    } else {
        &[4, 8, 16, 24, 32, 48, 64, 96, 128, 256, 512]
    };
    for degree in 3..=7 {
        for &spans in spans {
            let task = Task {
                target,
                drive,
                degree,
                spans,
                bounds: &[],
            };
            let (answer, timing) = watch.time(|| task.free().map(with_profile));
            let error = force_error(&drive, &answer?.0, target);
            let method = format!("spline of degree {degree}");
            rows.push(timing.row(&method, format!("{spans} spans"), error));
        }
    }
    Ok(())
}

fn harmonics(
    watch: &Watch,
    target: &ForceCurve,
    drive: Drive,
    rows: &mut Vec<Row>,
    counts: &[usize],
) -> Result<()> {
    for &count in counts {
        let (law, timing) = watch.time(|| spectral(target, drive, count).map(with_profile));
        let error = force_error(&drive, &law?.0, target);
        rows.push(timing.row("harmonics", format!("{count}"), error));
    }
    // The default method also selects the number of harmonics, and its time includes this selection.
    let allowed = DEFAULT_ACCURACY * target.mean_n().abs();
    let (law, timing) = watch.time(|| first_rung(target, drive, allowed).map(with_profile));
    let law = law?.0;
    let size = format!("{}, chosen", law.waves(0).len());
    let row = timing.row("harmonics", size, force_error(&drive, &law, target));
    rows.push(row.by_default());
    Ok(())
}

/// Complete design with a rise, a fall and a dwell, whose angles, lift and level are fitted to the force.
fn fitted_double_harmonic(
    watch: &Watch,
    target: &ForceCurve,
    drive: Drive,
    rows: &mut Vec<Row>,
) -> Result<()> {
    let scene = built_in("footbridge_double_harmonic")?.scene()?;
    let problem = Problem::resolve(&scene, Some(target))?;
    let problem = problem.without_limits().with_drive(drive);
    let (law, timing) =
        watch.time(|| Result::Ok(with_profile(design(&problem, &Search::default())?.cam.law)));
    let error = force_error(&drive, &law?.0, target);
    rows.push(timing.row("double harmonic", "fitted", error));
    Ok(())
}

/// Adds the methods of textbooks, which use only the stance.
fn textbook(watch: &Watch, target: &ForceCurve, rows: &mut Vec<Row>) -> Result<()> {
    let stance = reference::Stance::of(target)
        .ok_or_else(|| crate::fault("the stance was not found in the reference curve"))?;
    let on_stance =
        |x: f64, force: &dyn Fn(f64) -> f64| if x < stance.end { force(x) } else { 0.0 };
    for extra in [0, 4, 8, 12, 20] {
        let conditions = stance.conditions(target, extra);
        let name = if extra == 0 {
            "paper's interpolation"
        } else {
            "higher interpolation"
        };
        let degree = conditions.len() - 1;
        let (poly, timing) = watch.time(|| {
            let poly = interpolate(&conditions, stance.end);
            black_box(poly.as_ref().map(|p| values(|x| p.eval(x.min(stance.end)))));
            poly
        });
        let error = poly.map_or(f64::NAN, |p| {
            rms_error(|x| on_stance(x, &|x| p.eval(x)), target)
        });
        rows.push(timing.row(name, format!("degree {degree}"), error));
    }
    for basis in reference::PolynomialBasis::ALL {
        for degree in [8, 16, 24, 40] {
            let (fit, timing) = watch.time(|| {
                let fit = basis.fit(target, stance.end, degree, 400);
                black_box(
                    fit.as_ref()
                        .map(|c| values(|x| basis.value(c, x / stance.end))),
                );
                fit
            });
            let error = fit.map_or(f64::NAN, |c| {
                rms_error(
                    |x| on_stance(x, &|x| basis.value(&c, x / stance.end)),
                    target,
                )
            });
            rows.push(timing.row(basis.name(), format!("degree {degree}"), error));
        }
    }
    let (scale, timing) = watch.time(|| {
        let scale = double_harmonic(target, stance.end);
        black_box(values(|x| scale * rise_and_fall(x, stance.end)));
        scale
    });
    let error = rms_error(|x| scale * rise_and_fall(x, stance.end), target);
    rows.push(timing.row("double harmonic", "1 amplitude", error));
    Ok(())
}

fn interpolate(conditions: &[Condition], end: f64) -> Option<gaitcam::poly::PiecewisePoly> {
    hermite_birkhoff(conditions, 0.0, end).ok()
}

/// Smooth standard load with a heel strike: a peak of 30 % of the maximum at 4 % of the stride, 1 % wide, which no single polynomial reproduces.
fn with_heel_transient(mut target: ForceCurve) -> ForceCurve {
    let n = target.force_n.len() as f64;
    let most = target.force_n.iter().fold(0.0_f64, |m, x| m.max(*x));
    for (i, f) in target.force_n.iter_mut().enumerate() {
        let x = i as f64 / n;
        let rises = 1.0 - (-(x / 0.01).powi(2)).exp();
        *f += 0.3 * most * rises * (-0.5 * ((x - 0.04) / 0.01).powi(2)).exp();
    }
    target
}

/// Number of profile points for every method.
const POINTS: usize = 1440;

/// Law with its profile for a flat face.
fn with_profile(law: Law) -> (Law, Vec<ProfilePoint>) {
    let follower = Follower::FlatTranslating { base_radius: 0.05 };
    let cam = Cam { law, follower };
    let points = cam.profile(POINTS);
    (cam.law, points)
}

/// Sum of a force at the angles of the profile points.
fn values(force: impl Fn(f64) -> f64) -> f64 {
    (0..POINTS)
        .map(|i| force(std::f64::consts::TAU * i as f64 / POINTS as f64))
        .sum()
}

/// Double harmonic of Campillo de Blas (2017) with unit lift: rise in half the stance, fall in the other half.
fn rise_and_fall(x: f64, end: f64) -> f64 {
    if x >= end {
        return 0.0;
    }
    let half = 0.5 * end;
    let p = std::f64::consts::PI * if x < half { x } else { end - x } / half;
    0.5 * ((1.0 - p.cos()) - 0.25 * (1.0 - (2.0 * p).cos()))
}

/// Amplitude with the minimum mean square error.
fn double_harmonic(target: &ForceCurve, end: f64) -> f64 {
    let n = target.force_n.len();
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    let shape = DVector::from_fn(n, |i, _| rise_and_fall(angle(i), end));
    let force = DMatrix::from_column_slice(n, 1, &target.force_n);
    shape.dot(&force.column(0)) / shape.norm_squared()
}
