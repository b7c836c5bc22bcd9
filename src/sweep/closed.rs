//! A row of the spectral tier in closed form, from a shape that is already taken apart.

use std::f64::consts::TAU;

use super::results::{NUMBERS, Outcome, Row};
use super::spectral::{Fit, Shape, Unit};
use crate::cam::{FollowerKind, Verdict};
use crate::drive::{Drive, DriveKind};
use crate::scene::{Family, Minimise, Scene};
use crate::synth::Tier;

/// Room around a bore, m, when the base circle follows from it: the synthesis's own.
const WALL: f64 = 1e-3;
/// Asked RMS force error where a scene says nothing, as part of the mean force: the synthesis's own.
const USUAL_RMS: f64 = 0.005;

/// Whether the law of this scene can be had without solving; what remains to be seen is whether it keeps
/// the limits.
pub fn suits(scene: &Scene) -> bool {
    let law = &scene.law;
    law.family == Family::Harmonic
        && scene.cam.follower == FollowerKind::FlatTranslating
        && scene.gait.is_some()
        && matches!(law.minimise, None | Some(Minimise::ForceError))
        && law.points.is_empty()
        && law.dwells.is_empty()
        && law.segments.is_empty()
        && !law.monotone
        && !law.polydyne
}

/// The law as a factor times a curve plus a constant.
struct Motion {
    unit: Unit,
    factor: f64,
    level: f64,
}

impl Motion {
    fn range(&self, order: usize) -> (f64, f64) {
        let (low, high) = self.unit.ranges[order];
        (self.factor * low, self.factor * high)
    }
}

/// The row of a scene for which [`suits`] holds; `scale` times the shape is the wanted force before any
/// scaling to the mass. `None` when a limit is broken or the scene is at fault: then the synthesis itself
/// has to answer.
pub fn row(scene: &Scene, shape: &Shape, scale: f64) -> Option<Row> {
    let gait = scene.gait.as_ref()?;
    let (drive, scale) = settled(scene, shape, scale, gait.to_mass)?;
    let mean = scale * shape.mean;
    if !(mean > 0.0 && drive.speed > 0.0) {
        return None;
    }
    let count = match scene.law.harmonics {
        Some(count) if count <= shape.most() => count,
        Some(_) => return None,
        None => shape.count(scene.rms.unwrap_or(USUAL_RMS) * shape.mean.abs())?,
    };
    let fit = shape.fit(count)?;
    let motion = motion(&drive, fit, scale, mean)?;
    let mean_force = drive.rest_force + drive.spring_rate * motion.level;
    fill(scene, &drive, fit, &motion, scale, mean, mean_force)
}

/// Drive and scale of the force with every number settled.
fn settled(scene: &Scene, shape: &Shape, scale: f64, to_mass: bool) -> Option<(Drive, f64)> {
    let spec = &scene.drive;
    let mean = scale * shape.mean;
    let speed = spec.speed.unwrap_or(TAU / shape.period_s);
    Some(match spec.kind {
        DriveKind::MovingAxis => {
            if mean <= 0.0 {
                return None;
            }
            let mass = spec.mass.unwrap_or(mean / spec.gravity);
            let scale = if to_mass {
                scale * (mass * spec.gravity / mean)
            } else {
                scale
            };
            (Drive::moving_axis(mass, spec.gravity, speed), scale)
        }
        DriveKind::FixedAxis => (
            Drive {
                kind: DriveKind::FixedAxis,
                rest_force: spec.preload,
                spring_rate: spec.spring_rate,
                damping: spec.damping,
                mass: spec.mass.unwrap_or(0.0),
                speed,
            },
            scale,
        ),
        DriveKind::Hydraulic => (
            Drive::hydraulic(spec.pressure_per_volume, spec.piston_radius, speed),
            scale,
        ),
    })
}

/// A gain below this part of the largest term that makes it up leaves the answer to the synthesis.
const RESONANCE: f64 = 1e-8;

/// Pure inertia and pure spring share a curve between rows; any other drive has its own.
fn motion(drive: &Drive, fit: &Fit, scale: f64, mean: f64) -> Option<Motion> {
    let [k, c, m, _] = drive.weights();
    let (unit, factor) = if c == 0.0 && k == 0.0 && m > 0.0 {
        (*fit.inertia(), scale / m)
    } else if c == 0.0 && m == 0.0 && k > 0.0 {
        (*fit.spring(), scale / k)
    } else {
        let clear = (1..=fit.count()).all(|n| {
            let (re, im) = drive.gain(n);
            let largest = k.abs().max(m * (n * n) as f64).max(im.abs());
            re.hypot(im) > RESONANCE * largest
        });
        if !clear {
            return None;
        }
        (fit.law(scale, |n| drive.gain(n)), 1.0)
    };
    let level = if k == 0.0 {
        // Nothing fixes the lift: the lowest point stands on the base circle.
        -factor * unit.ranges[0].0
    } else {
        (mean - drive.rest_force) / k
    };
    Some(Motion {
        unit,
        factor,
        level,
    })
}

fn fill(
    scene: &Scene,
    drive: &Drive,
    fit: &Fit,
    motion: &Motion,
    scale: f64,
    mean: f64,
    mean_force: f64,
) -> Option<Row> {
    let (bottom, top) = motion.range(0);
    let (lowest, stroke) = (bottom + motion.level, top - bottom);
    if lowest < 0.0 {
        return None;
    }
    let shift = mean_force - mean;
    let square =
        shift * shift + 2.0 * shift * scale * fit.error_mean + scale * scale * fit.error_square;
    let rms = square.max(0.0).sqrt();
    let largest = (shift + scale * fit.error.1).max(-shift - scale * fit.error.0);
    let force = (
        mean_force + scale * fit.force.0,
        mean_force + scale * fit.force.1,
    );
    let peaks = [1, 2, 3].map(|order| {
        let (low, high) = motion.range(order);
        high.max(-low) * drive.speed.powi(order as i32)
    });
    let (slowest, fastest) = motion.range(1);
    let face = fastest - slowest;
    let bend = motion.level + motion.factor * motion.unit.bend;
    let wanted = scene.limits.curvature.unwrap_or(0.0);
    let bore = scene.cam.bore.unwrap_or(0.0);
    let base = scene
        .cam
        .base_radius
        .or(scene.cam.prime_radius)
        .unwrap_or_else(|| {
            let outside = if bore > 0.0 { 0.5 * bore + WALL } else { 0.0 };
            (wanted - bend).max(0.0).max(outside)
        });
    let rho = base + bend;
    let limits = &scene.limits;
    let sized = scene.cam.base_radius.is_none() && scene.cam.prime_radius.is_none();
    let within = |value: f64, limit: Option<f64>| limit.is_none_or(|l| value <= l);
    // The solver counts a stroke limit from the base circle, the check from the lowest point.
    // Limits of the running machine are the solver's business.
    let machine = limits.torque.is_some()
        || limits.torque_rate.is_some()
        || limits.hertz_pressure.is_some()
        || limits.residual.is_some();
    let kept = !machine
        && within(lowest + stroke, limits.stroke)
        && within(peaks[0], limits.velocity)
        && within(peaks[1], limits.acceleration)
        && within(peaks[2], limits.jerk)
        && within(force.1, limits.force_max)
        && limits.force_min.is_none_or(|l| force.0 >= l)
        && within(face, limits.face_width)
        && within(base, limits.prime_radius)
        // A base circle made for the curvature meets it to rounding.
        && rho >= wanted - if sized { 1e-12 * base } else { 0.0 }
        && base >= 0.5 * bore
        && scene.rms.is_none_or(|r| rms <= r * mean);
    if !kept {
        return None;
    }
    let mut numbers = [f64::NAN; NUMBERS.len()];
    numbers.copy_from_slice(&[
        rms,
        100.0 * rms / mean,
        largest,
        mean,
        mean_force,
        force.0,
        force.1,
        drive.mass,
        drive.speed,
        stroke,
        peaks[0],
        peaks[1],
        peaks[2],
        base,
        base,
        0.0,
        rho,
        0.0,
        face,
    ]);
    Some(Row {
        numbers,
        outcome: Outcome::Built,
        verdict: Some(Verdict::Acceptable),
        tier: Some(Tier::Spectral),
        binding: String::new(),
        failed: String::new(),
        error: String::new(),
        time_s: 0.0,
    })
}
