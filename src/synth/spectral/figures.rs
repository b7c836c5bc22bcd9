//! The figures of a spectral design in closed form.

use std::sync::Arc;

use super::machine::Load;
use super::{Fit, HarmonicTarget, LawRanges, Terms};
use crate::cam::FollowerKind;
use crate::drive::{Drive, DriveKind};
use crate::problem::{USUAL_ACCURACY, drive_of, outside_bore};
use crate::scene::{Family, ForceScale, LimitKind, Minimise, Scene};
use crate::synth::limits::GEOMETRY;
use crate::synth::{Figures, ForceReport, MachineReport};

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
pub struct Motion {
    /// Ranges of the curve.
    pub unit: LawRanges,
    /// Its harmonics.
    pub terms: Terms,
    /// The factor.
    pub factor: f64,
    /// The constant.
    pub level: f64,
    /// The force's harmonics and s + a of the curve on a grid.
    pub grid: Arc<Vec<(f64, f64)>>,
}

impl Motion {
    /// Smallest and largest value of a derivative of the law, without the constant.
    pub fn range(&self, order: usize) -> (f64, f64) {
        let (low, high) = self.unit.svaj[order];
        (self.factor * low, self.factor * high)
    }
}

/// The figures of a scene for which [`suits`] holds; `scale` times the target is the wanted force before any
/// scaling to the mass. `None` when a limit is violated or the scene is at fault: then the synthesis itself
/// has to answer.
pub fn figures(scene: &Scene, target: &HarmonicTarget, scale: f64) -> Option<Figures> {
    let gait = scene.gait.as_ref()?;
    let (drive, scale) = settled(scene, target, scale, gait.scale)?;
    let mean = scale * target.mean;
    if !(mean > 0.0 && drive.speed > 0.0) {
        return None;
    }
    let count = match scene.law.harmonics {
        Some(count) if count <= target.most() => count,
        Some(_) => return None,
        None => target.count(scene.rms.unwrap_or(USUAL_ACCURACY) * target.mean.abs())?,
    };
    let fit = target.fit(count)?;
    let motion = motion(&drive, fit, scale, mean)?;
    let mean_force = drive.rest_force + drive.spring_rate * motion.level;
    kept(scene, &drive, fit, &motion, scale, mean, mean_force)
}

/// Drive and scale of the force with every number settled.
fn settled(
    scene: &Scene,
    target: &HarmonicTarget,
    scale: f64,
    how: ForceScale,
) -> Option<(Drive, f64)> {
    let mean = scale * target.mean;
    let drive = drive_of(&scene.drive, Some((mean, target.period_s))).ok()?;
    let on_mass = drive.kind == DriveKind::MovingAxis;
    if on_mass && mean <= 0.0 {
        return None;
    }
    let scale = match how {
        ForceScale::ToMass if on_mass => scale * (drive.rest_force / mean),
        ForceScale::Alternating => return None,
        ForceScale::None | ForceScale::ToMass => scale,
    };
    Some((drive, scale))
}

/// A gain below this part of the largest term that makes it up leaves the answer to the synthesis.
const RESONANCE: f64 = 1e-8;

/// Pure inertia and pure spring share a curve between rows; any other drive has its own.
fn motion(drive: &Drive, fit: &Fit, scale: f64, mean: f64) -> Option<Motion> {
    let [k, c, m, _] = drive.weights();
    let (unit, terms, factor, grid) = if c == 0.0 && k == 0.0 && m > 0.0 {
        let terms = fit.inertia_terms();
        let grid = fit.inertia_grid(&terms);
        (*fit.inertia(), terms, scale / m, grid)
    } else if c == 0.0 && m == 0.0 && k > 0.0 {
        let terms = fit.harmonics().to_vec();
        let grid = fit.spring_grid(&terms);
        (*fit.spring(), terms, scale / k, grid)
    } else {
        let clear = (1..=fit.count()).all(|n| {
            let (re, im) = drive.gain(n);
            let largest = k.abs().max(m * (n * n) as f64).max(im.abs());
            re.hypot(im) > RESONANCE * largest
        });
        if !clear {
            return None;
        }
        let terms = fit.divided(|n| drive.gain(n));
        let grid = Arc::new(fit.grid(&terms));
        (fit.ranges(&terms), terms, scale, grid)
    };
    let level = if k == 0.0 {
        // Nothing fixes the lift: the lowest point stands on the base circle.
        -factor * unit.svaj[0].0
    } else {
        (mean - drive.rest_force) / k
    };
    Some(Motion {
        unit,
        terms,
        factor,
        level,
        grid,
    })
}

fn kept(
    scene: &Scene,
    drive: &Drive,
    fit: &Fit,
    motion: &Motion,
    scale: f64,
    mean: f64,
    mean_force: f64,
) -> Option<Figures> {
    let (bottom, top) = motion.range(0);
    let (lowest, stroke) = (bottom + motion.level, top - bottom);
    if lowest < 0.0 {
        return None;
    }
    let force = force(fit, scale, mean, mean_force);
    if !is_judged_well(scene, drive, &force) {
        return None;
    }
    let peaks = [1, 2, 3].map(|order| {
        let (low, high) = motion.range(order);
        high.max(-low) * drive.speed.powi(order as i32)
    });
    let (slowest, fastest) = motion.range(1);
    let bend = motion.level + motion.factor * motion.unit.bend;
    let wanted = scene.limits[LimitKind::Curvature].unwrap_or(0.0);
    let given = scene.cam.base_radius.or(scene.cam.prime_radius);
    let base = given.unwrap_or_else(|| (wanted - bend).max(0.0).max(outside_bore(&scene.cam)));
    let mut figures = Figures {
        force,
        mass: drive.mass,
        speed: drive.speed,
        stroke,
        peaks,
        base_radius: base,
        prime_radius: base,
        offset: 0.0,
        smallest_convex_radius: base + bend,
        largest_pressure_angle: 0.0,
        face_width: Some(fastest - slowest),
        machine: MachineReport::default(),
    };
    // A base circle made for the curvature meets it to rounding.
    let rounding = if given.is_none() { 1e-12 * base } else { 0.0 };
    if !keeps_limits(scene, &figures, lowest + stroke, wanted - rounding) {
        return None;
    }
    let load = Load {
        drive,
        fit,
        motion,
        scale,
        mean,
        mean_force,
        base_radius: base,
        thickness: scene.cam.thickness,
    };
    figures.machine = load.report();
    Some(figures)
}

/// Force against target: exact for the sum of the harmonics and what interpolation adds.
fn force(fit: &Fit, scale: f64, mean: f64, mean_force: f64) -> ForceReport {
    let shift = mean_force - mean;
    let square =
        shift * shift + 2.0 * shift * scale * fit.error_mean + scale * scale * fit.error_square;
    let rms = square.max(0.0).sqrt();
    ForceReport {
        rms_error_n: rms,
        max_error_n: (shift + scale * fit.error.1).max(-shift - scale * fit.error.0),
        rms_error_percent_of_mean: 100.0 * rms / mean,
        target_mean_n: mean,
        mean_n: mean_force,
        min_n: mean_force + scale * fit.force.0,
        max_n: mean_force + scale * fit.force.1,
    }
}

/// The limits that are looked at here. A pressure angle under a flat face is none.
const HERE: [LimitKind; 12] = [
    LimitKind::Stroke,
    LimitKind::Velocity,
    LimitKind::Acceleration,
    LimitKind::Jerk,
    LimitKind::ForceMin,
    LimitKind::ForceMax,
    LimitKind::Curvature,
    LimitKind::PressureAngle,
    LimitKind::PressureAngleRise,
    LimitKind::PressureAngleFall,
    LimitKind::PrimeRadius,
    LimitKind::FaceWidth,
];
/// A mean force nearer to the weight, as a part of it, is the weight.
const CLOSED: f64 = 1e-6;

/// Whether force, contact and mean are what the verdict asks for where no limit says otherwise; what is left
/// in doubt here the synthesis judges.
fn is_judged_well(scene: &Scene, drive: &Drive, force: &ForceReport) -> bool {
    let pressed = drive.kind != DriveKind::Hydraulic && scene.limits[LimitKind::ForceMin].is_none();
    let allowed = scene.rms.unwrap_or(USUAL_ACCURACY) * force.target_mean_n;
    let gap = (force.mean_n - force.target_mean_n).abs();
    (!pressed || force.min_n >= 0.0)
        && force.rms_error_n <= allowed
        && (drive.kind != DriveKind::MovingAxis || gap <= CLOSED * force.target_mean_n)
}

/// Whether every limit holds; limits of the running machine are the solver's business. The solver counts a
/// stroke limit from the base circle, so `highest` is the largest lift above it.
fn keeps_limits(scene: &Scene, figures: &Figures, highest: f64, least_radius: f64) -> bool {
    let limits = &scene.limits;
    let within = |value: f64, limit: Option<f64>| limit.is_none_or(|l| value <= l);
    let mut others = LimitKind::ALL.iter().filter(|kind| !HERE.contains(kind));
    let machine = others.any(|&kind| limits[kind].is_some());
    let force = &figures.force;
    !machine
        && within(highest, limits[LimitKind::Stroke])
        && within(figures.peaks[0], limits[LimitKind::Velocity])
        && within(figures.peaks[1], limits[LimitKind::Acceleration])
        && within(figures.peaks[2], limits[LimitKind::Jerk])
        && within(force.max_n, limits[LimitKind::ForceMax])
        && limits[LimitKind::ForceMin].is_none_or(|l| force.min_n >= l)
        && within(
            figures.face_width.unwrap_or(0.0),
            limits[LimitKind::FaceWidth],
        )
        && within(figures.base_radius, limits[LimitKind::PrimeRadius])
        && figures.smallest_convex_radius >= least_radius
        && (limits[LimitKind::Curvature].is_some_and(|rho| rho > 0.0)
            || figures.smallest_convex_radius > GEOMETRY * figures.base_radius)
        && figures.base_radius >= scene.cam.hole().map_or(0.0, |hole| hole.reach())
        && within(
            force.rms_error_n,
            scene.rms.map(|r| r * force.target_mean_n),
        )
}
