//! Characteristic values (figures) of a design in closed form, for many problems with the same target force (theory §1). A complete synthesis
//! is not necessary. The closed form applies to a rigid machine at constant speed.
//!
//! If the drive is a pure inertia, the law is a fixed curve multiplied by a factor. All extremes of lift, velocity, acceleration, jerk,
//! force and flat-face curvature are scaled extremes of this curve. Tests compare these figures with the figures of the complete design,
//! with the relative tolerance 1e-9.

use std::f64::consts::PI;

use crate::cam::FollowerKind;
use crate::drive::Drive;
use crate::dynamics::rigid::liftoff_speed;
use crate::problem::{Problem, Shape, hub_radius};
use crate::scene::{Family, LimitKind};
use crate::synth::design::figures::{FIGURES, Figures};
use crate::synth::design::machine::MachineReport;
use crate::synth::limits::GEOMETRY;
use crate::synth::report::force::ForceReport;

/// Relative difference between mean force and mean target below which both count as equal.
const SAME: f64 = 1e-13;
/// Fraction of the mean force below which a permitted force error is within rounding errors. The closed form is then not used.
const ROUNDING: f64 = 1e-5;

/// Figures of the design in closed form, for harmonics under a translating flat face. `None` for other problems, and if a limit may be
/// violated. In these cases, the complete synthesis is necessary.
pub fn figures(problem: &Problem) -> Option<Figures> {
    let is_closed = problem.is_plain()
        && problem.law.family == Family::Harmonic
        && problem.cam.follower == FollowerKind::FlatTranslating
        && problem.cam.conjugate.is_none()
        && problem.band.is_none()
        && !problem.has_demands();
    let target = problem.target.as_ref().filter(|_| is_closed)?;
    let (scale, cycle) = target.multiple()?;
    let (drive, mean) = (&problem.drive, problem.target_mean());
    let wanted = problem.asked_error();
    if !(mean > 0.0 && drive.speed > 0.0 && wanted > ROUNDING * mean) {
        return None;
    }
    let count = match problem.law.harmonics {
        Some(count) => Some(count).filter(|count| *count <= target.most_harmonics())?,
        None => target.fewest_harmonics(wanted),
    };
    let [k, c, m, _] = drive.weights();
    let own;
    let (shape, factor) = if k == 0.0 && c == 0.0 && m > 0.0 {
        (cycle.series().inertia(count)?, scale / m)
    } else {
        own = cycle.series().shape(count, drive)?;
        (&own, scale)
    };
    let svaj = shape.svaj.map(|range| range.map(|x| factor * x));
    // If nothing determines the level of the lift, the minimum lift is on the base circle.
    let level = if k == 0.0 {
        -svaj[0][0]
    } else {
        (mean - drive.rest_force) / k
    };
    let motion = Motion {
        shape,
        scale,
        factor,
        level,
        svaj,
    };
    let closes = (drive.rest_force + k * level - mean).abs() <= SAME * mean;
    let stands = svaj[0][0] + level >= 0.0;
    let figures =
        (closes && stands).then(|| motion.figures(problem, cycle.error_of_harmonics(count)))?;
    passes(problem, &figures).then_some(figures)
}

/// A law as the product of a shape and a factor, plus a constant level.
struct Motion<'a> {
    shape: &'a Shape,
    /// Factor by which the common force series is multiplied to obtain the target force of the problem.
    scale: f64,
    factor: f64,
    level: f64,
    /// Minimum and maximum of the lift without its constant level, m, and of its first three derivatives with respect to the cam angle.
    svaj: [[f64; 2]; 4],
}

impl Motion<'_> {
    /// Figures for the cam of the problem. `error` contains the RMS error and the maximum error of the common force series, before
    /// multiplication by `scale`.
    fn figures(&self, problem: &Problem, error: [f64; 2]) -> Figures {
        let (drive, mean, scale) = (&problem.drive, problem.target_mean(), self.scale);
        let [rms_error_n, max_error_n] = error.map(|error| scale * error);
        let [least, most] = self.shape.force_range.map(|force| mean + scale * force);
        let bent = self.level + self.factor * self.shape.least_bent;
        let [[bottom, top], [slowest, fastest], ..] = self.svaj;
        let (base, smallest_convex_radius) = size(problem, bent, top + self.level);
        Figures {
            force: ForceReport {
                rms_error_n,
                max_error_n,
                rms_error_percent_of_mean: 100.0 * rms_error_n / mean,
                target_mean_n: mean,
                mean_n: mean,
                min_n: least,
                max_n: most,
            },
            mass: drive.mass,
            speed: drive.speed,
            stroke: top - bottom,
            peaks: [1, 2, 3].map(|order| {
                let [low, high] = self.svaj[order];
                high.max(-low) * drive.speed.powi(order as i32)
            }),
            base_radius: base,
            prime_radius: base,
            radii: Some([bottom, top].map(|lift| base + self.level + lift)),
            offset: 0.0,
            smallest_convex_radius,
            largest_pressure_angle: 0.0,
            face_width: Some(fastest - slowest),
            machine: self.machine(problem, base),
            shaft_ripple: None,
            floor: None,
            worst_walker_percent: None,
        }
    }

    fn machine(&self, problem: &Problem, base_radius: f64) -> MachineReport {
        let (drive, mean) = (&problem.drive, problem.target_mean());
        let unit = self.scale * self.factor;
        let radius = [base_radius + self.level, self.factor];
        let quotient = self.shape.highest_quotient([mean, self.scale], radius);
        let pressure = problem.cam.contact_modulus() / (PI * problem.cam.thickness) * quotient;
        MachineReport {
            liftoff_speed_rad_per_s: self.liftoff(drive),
            hertz_pressure_max_pa: Some(pressure.max(0.0).sqrt()),
            ..MachineReport::of_torque(
                self.shape.torque_range.map(|torque| unit * torque),
                self.shape.torque_mean_and_rms.map(|torque| unit * torque),
                drive.speed,
            )
        }
    }

    /// Lift-off speed, rad/s; `None` if the follower does not lift off. Without spring and damping, F = M(g + ω²a) is zero for ω² = g/(−a).
    fn liftoff(&self, drive: &Drive) -> Option<f64> {
        if drive.spring_rate != 0.0 || drive.damping != 0.0 {
            let law = self.shape.law.scaled(self.factor).raised(self.level);
            return liftoff_speed(&law, drive);
        }
        let pull = -drive.mass * self.svaj[2][0];
        (pull > 0.0).then(|| (drive.rest_force / pull).sqrt())
    }
}

/// Base radius and minimum radius of curvature, m. `bent` is the minimum of s + a, where a is the second derivative of the lift s with
/// respect to the angle. `highest` is the maximum lift. If no base radius is given, it is the minimum that the limits on curvature and bore
/// permit.
fn size(problem: &Problem, bent: f64, highest: f64) -> (f64, f64) {
    let wanted = problem.limits[LimitKind::Curvature].unwrap_or(0.0);
    if let Some([base, _]) = problem.cam.given_radii() {
        return (base, base + bent);
    }
    let base =
        (wanted - bent)
            .max(0.0)
            .max(hub_radius(&problem.cam, &problem.limits, Some(highest)));
    (base, (base + bent).max(wanted))
}

/// Whether the figures satisfy all limits, including default bounds. The result is `false` if there is a limit without a figure.
fn passes(problem: &Problem, figures: &Figures) -> bool {
    let (limits, force) = (&problem.limits, &figures.force);
    let keeps = |kind: LimitKind| {
        let Some(limit) = limits[kind] else {
            return true;
        };
        if kind == LimitKind::Diameter {
            return figures.radii.is_some_and(|[_, most]| 2.0 * most <= limit);
        }
        let (of_figure, limit) = match kind {
            LimitKind::PressureAngleRise | LimitKind::PressureAngleFall => {
                (LimitKind::PressureAngle, limit)
            }
            // The power limit also applies to recuperated power.
            LimitKind::Power => (LimitKind::Torque, limit / problem.drive.speed),
            other => (other, limit),
        };
        let mut own = FIGURES.iter().filter(|f| f.limit == Some(of_figure));
        own.next().is_some_and(|f| f.keeps(figures, limit))
    };
    let presses = limits[LimitKind::ForceMin].is_some()
        || (problem.usual_force_min()).is_none_or(|least| force.min_n >= least);
    let is_round = limits[LimitKind::Curvature].is_some_and(|rho| rho > 0.0)
        || figures.smallest_convex_radius > GEOMETRY * figures.base_radius;
    let hole = problem.cam.hole();
    LimitKind::ALL.iter().all(|kind| keeps(*kind))
        && presses
        && is_round
        && hole.is_none_or(|hole| figures.base_radius >= hole.reach())
        && (problem.largest_error()).is_none_or(|most| force.rms_error_n <= most)
}
