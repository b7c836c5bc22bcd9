//! Laws from a force: the main function, each method by itself, and a scene with limits.

use std::f64::consts::{PI, TAU};
use std::hint::black_box;

use crate::tiers::{Bound, Task, spectral};
use gaitcam::cam::smallest_prime_circle;
use gaitcam::drive::Drive;
use gaitcam::force::ForceCurve;
use gaitcam::law::Extent;
use gaitcam::synth::synthesise;

use super::cases::{footbridge, scene_with, turn};
use super::table::Report;
use crate::timing::times;

pub(crate) fn main_job(report: &mut Report) {
    let (target, _) = footbridge();
    let scene = scene_with(&[]);
    let seconds = times(|| synthesise(&scene, Some(&target)).expect("a law"));
    report.time(
        "main job",
        "default scene, synthesis without files",
        2e-3,
        seconds,
    );
}

pub(crate) fn tiers(report: &mut Report) {
    let (curve, drive) = footbridge();
    spectral_tier(report, &curve, drive);
    equality_tier(report, &curve, drive);
    certified(report, &curve, drive);
    whole_scene(report, &curve);
    prime_circle(report);
}

fn spectral_tier(report: &mut Report, curve: &ForceCurve, drive: Drive) {
    let samples = (0..1000)
        .map(|i| curve.at(TAU * f64::from(i) / 1000.0))
        .collect();
    let thousand = ForceCurve::from_samples("1000", curve.period_s, samples).expect("a curve");
    let seconds = times(|| spectral(black_box(&thousand), drive, 20).expect("no resonance"));
    report.time(
        "synthesis",
        "spectral tier, 1000 samples, 20 harmonics",
        20e-6,
        seconds,
    );
}

/// Quintic spline of `spans` spans without limits.
fn quintic(target: &ForceCurve, drive: Drive, spans: usize) -> Task<'_> {
    Task {
        target,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    }
}

fn equality_tier(report: &mut Report, curve: &ForceCurve, drive: Drive) {
    let seconds = times(|| black_box(quintic(curve, drive, 32)).free().expect("a law"));
    report.time(
        "synthesis",
        "equality tier, quintic of 32 spans",
        20e-6,
        seconds,
    );
    let [short, long] =
        [1000, 10_000].map(|n| times(|| quintic(curve, drive, n).free().expect("a law")));
    report.at_most(
        "synthesis",
        "equality tier: fastest time of 10 000 spans over 1000 (linear: 10)",
        12.0,
        long.fastest / short.fastest,
    );
}

fn certified(report: &mut Report, curve: &ForceCurve, drive: Drive) {
    let task = quintic(curve, drive, 32);
    let free = task.free().expect("a law");
    let at = |percent: f64| {
        let bounds = [2, 3].map(|order| {
            let (low, high) = free.extremes(order);
            let most = 0.01 * percent * high.value.max(-low.value);
            Bound { order, most }
        });
        let held = Task {
            bounds: &bounds,
            ..task
        };
        times(|| black_box(&held).exchange().expect("feasible"))
    };
    report.time(
        "synthesis",
        "certified QP, 32 spans, acceleration and jerk at 95 % of the free law's",
        3e-4,
        at(95.0),
    );
    let [a, b, c, d] = [80.0, 60.0, 45.0, 30.0].map(at);
    report.time(
        "synthesis",
        "certified QP, 32 spans, the slowest of 80, 60, 45, 30 %",
        1e-3,
        a.or(b).or(c).or(d),
    );
}

fn whole_scene(report: &mut Report, curve: &ForceCurve) {
    let scene = scene_with(&[
        "limits.jerk=150 m/s^3",
        "limits.acceleration=5 m/s^2",
        "law.spans=32",
    ]);
    let seconds = times(|| synthesise(&scene, Some(curve)).expect("a law"));
    report.time(
        "synthesis",
        "whole scene of 32 spans with jerk, acceleration and curvature limits",
        1e-3,
        seconds,
    );
}

fn prime_circle(report: &mut Report) {
    let law = turn("3-4-5", 0.02, Extent::TURN, TAU);
    let seconds = times(|| smallest_prime_circle(black_box(&law), PI / 6.0, PI / 6.0, None));
    report.time(
        "synthesis",
        "closed-form prime circle, exact extrema of the law",
        10e-6,
        seconds,
    );
}
