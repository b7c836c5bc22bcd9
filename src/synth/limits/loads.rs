//! Shaft torque, its rate and its power, and the pressure between cam and follower.
//!
//! Pressure under a flat face is linear in law and size: a row from the start. Torque, its rate and the
//! pressure under a roller are not convex: h(s, v, a, j, D, e) ≥ 0 with its derivatives.

use std::f64::consts::PI;
use std::sync::Arc;

use super::finished::Finished;
use super::hertz_pressure::Press;
use super::slack::{ProfileSize, Slack};
use crate::cam::{Check, FollowerKind, LimitKind};
use crate::drive::Drive;
use crate::dynamics::hertz::{STEEL, flat_face_limit, modulus};
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};
use crate::problem::{OnShaft, Problem, product};
use crate::synth::qp::{Limit, Meaning, RADIUS, structural};

/// A cam is not made larger for a pressure of whose square the roller alone makes more than this part.
const WORTH_GROWING: f64 = 0.95;
/// A limit counts as kept within this part of it.
const SLACK: f64 = 1e-6;

/// Steel on steel under a flat face of given base radius.
pub fn row(problem: &Problem) -> Option<Limit> {
    pressed(problem, problem.base_radius()?)
}

/// F ≤ π L p²/E*·(Rb + s + a): linear in law and radius together.
pub fn row_with_size(problem: &Problem) -> Option<Limit> {
    let mut limit = pressed(problem, 0.0)?;
    limit.extra[RADIUS] = limit.weights[2] - problem.drive.weights()[2];
    Some(limit)
}

/// The pressure limit under a flat face on a base circle, which counts among the variables where it is 0.
fn pressed(problem: &Problem, base_radius: f64) -> Option<Limit> {
    let (cam, pressure) = (&problem.cam, problem.limits[LimitKind::HertzPressure]?);
    if cam.follower != FollowerKind::FlatTranslating {
        return None;
    }
    let steel = modulus(STEEL, STEEL);
    let ([s, v, a, j], bound) =
        flat_face_limit(&problem.drive, base_radius, cam.thickness, steel, pressure);
    let scale = bound.abs().max(problem.drive.rest_force.abs());
    let weights = [s, v, a, j, 0.0];
    let limit = structural(LimitKind::HertzPressure, weights, bound, scale);
    Some(Meaning::Sized.of(limit))
}

/// What is not convex in the loads of a problem; `None` = no limit.
#[derive(Debug, Clone)]
pub struct Loads {
    /// Lift to force.
    pub drive: Drive,
    /// What a varying speed or a floor adds to it.
    pub on_shaft: Option<Arc<OnShaft>>,
    /// Largest |F v|, N·m.
    pub torque: Option<f64>,
    /// Largest |F v| that a limit on the power leaves at the mean speed, N·m.
    pub power: Option<f64>,
    /// Largest |d(F v)/dθ|, N·m/rad.
    pub torque_rate: Option<f64>,
    /// Pressure under a roller.
    pub pressure: Option<Pressure>,
}

/// Line pressure between a roller and its cam.
#[derive(Debug, Clone, Copy)]
pub struct Pressure {
    /// π L/E*, so that p² is the normal force times the sum of curvatures over this, m²/N.
    pub spread: f64,
    /// Radius of the roller, m.
    pub roller: f64,
    /// Largest pressure, Pa.
    pub most: f64,
}

impl Loads {
    /// The loads that are limited and not convex; the pressure is one where the size `under_roller` is known.
    pub fn of(problem: &Problem, under_roller: bool) -> Option<Loads> {
        let limits = &problem.limits;
        let roller = Some(problem.cam.roller_radius).filter(|r| under_roller && *r > 0.0);
        let loads = Loads {
            drive: problem.drive,
            on_shaft: problem.on_shaft.clone(),
            torque: limits[LimitKind::Torque],
            // At constant speed P/ω (theory §10).
            power: limits[LimitKind::Power].map(|power| power / problem.drive.speed),
            torque_rate: limits[LimitKind::TorqueRate],
            pressure: roller
                .zip(limits[LimitKind::HertzPressure])
                .map(|(roller, most)| Pressure {
                    spread: PI * problem.cam.thickness / modulus(STEEL, STEEL),
                    roller,
                    most,
                }),
        };
        (!loads.named().is_empty()).then_some(loads)
    }

    /// Every limit at a place of the law; h ≥ 0 where it holds.
    pub fn slacks(&self, at: Svaj, theta: f64, size: ProfileSize, out: &mut Vec<Slack>) {
        let shaft = self.on_shaft.as_ref();
        let [extra, extra_rate] = shaft.map_or([0.0; 2], |shaft| {
            [&shaft.extra.force, &shaft.force_rate].map(|curve| curve.eval(theta))
        });
        let force = self.drive.force(at) + extra;
        for side in [1.0, -1.0] {
            for (name, most) in self.on_torque(theta).into_iter().flatten() {
                out.push(self.torque_slack(name, at, force, most, side));
            }
            let rate = self.torque_rate;
            out.extend(rate.map(|most| self.rate_slack(at, [force, extra_rate], most, side)));
        }
        out.extend(
            self.pressure
                .map(|p| self.pressure_slack(at, force, size, p)),
        );
    }

    /// The limits on the torque; at constant speed the lesser, from which the other one follows.
    fn on_torque(&self, theta: f64) -> [Option<(LimitKind, f64)>; 2] {
        let speed = (self.on_shaft.as_ref()).and_then(|shaft| shaft.extra.speed.as_ref());
        let torque = self.torque.map(|most| (LimitKind::Torque, most));
        let power = self.power.map(|most| (LimitKind::Power, most));
        match (torque, power, speed) {
            (_, Some((name, most)), Some(speed)) => {
                let part = self.drive.speed / speed.eval(theta);
                [torque, Some((name, most * part))]
            }
            (Some(torque), Some(power), None) => {
                [Some(if power.1 < torque.1 { power } else { torque }), None]
            }
            (torque, power, _) => [torque, power],
        }
    }

    /// The limits there are, with their values.
    pub fn named(&self) -> Vec<(LimitKind, f64)> {
        [
            (LimitKind::Torque, self.torque),
            (LimitKind::Power, self.power),
            (LimitKind::TorqueRate, self.torque_rate),
            (LimitKind::HertzPressure, self.pressure.map(|p| p.most)),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
    }

    /// The same with one limit at another value, or left out.
    pub fn with(&self, name: LimitKind, value: Option<f64>) -> Loads {
        let mut out = self.clone();
        match name {
            LimitKind::Torque => out.torque = value,
            LimitKind::Power => out.power = value,
            LimitKind::TorqueRate => out.torque_rate = value,
            _ => {
                out.pressure = out
                    .pressure
                    .and_then(|p| value.map(|most| Pressure { most, ..p }));
            }
        }
        out
    }

    /// T − (±F v).
    fn torque_slack(&self, name: LimitKind, at: Svaj, force: f64, most: f64, side: f64) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        Slack {
            h: most - side * force * at.v,
            w: most,
            largest: most,
            by_lift: -side * k * at.v,
            by_velocity: -side * (force + c * at.v),
            by_acceleration: -side * m * at.v,
            ..Slack::none(name)
        }
    }

    /// R − (±(F′ v + F a)).
    fn rate_slack(&self, at: Svaj, [force, extra]: [f64; 2], most: f64, side: f64) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        let rate = k * at.v + c * at.a + m * at.j + extra;
        Slack {
            h: most - side * (rate * at.v + force * at.a),
            w: most,
            largest: most,
            by_lift: -side * k * at.a,
            by_velocity: -side * (k * at.v + rate + c * at.a),
            by_acceleration: -side * (c * at.v + force + m * at.a),
            by_jerk: -side * m * at.v,
            ..Slack::none(LimitKind::TorqueRate)
        }
    }

    /// q R_f X (w^{3/2} − R_f K) − F w², q = p² π L/E*: with X = D + s, Y = v − e, w = X² + Y² and
    /// K = w + vY − aX the normal force is F √w/X and the sum of curvatures w^{3/2}/(R_f (w^{3/2} − R_f K))
    /// (theory §6, §10).
    fn pressure_slack(&self, at: Svaj, force: f64, size: ProfileSize, p: Pressure) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        let (x, y) = (size.rise + at.s, at.v - size.offset);
        let w = x * x + y * y;
        let root = w.sqrt();
        let bend = w + at.v * y - at.a * x;
        let gap = w * root - p.roller * bend;
        let q = p.most * p.most * p.spread * p.roller;
        // By X, Y, v and a of the geometry alone.
        let by_x =
            q * (gap + x * (3.0 * root * x - p.roller * (2.0 * x - at.a))) - force * 4.0 * w * x;
        let by_y = q * x * (3.0 * root * y - p.roller * (2.0 * y + at.v)) - force * 4.0 * w * y;
        let by_v = -q * x * p.roller * y;
        let by_a = q * x * p.roller * x;
        // h in units of q X w^{3/2}, a number that a size of the cam does not change much.
        let unit = q * size.rise.max(size.rho) * w * root;
        Slack {
            h: q * x * gap - force * w * w,
            w: unit,
            largest: unit,
            by_lift: by_x - k * w * w,
            by_rise: by_x,
            by_velocity: by_y + by_v - c * w * w,
            by_acceleration: by_a - m * w * w,
            by_offset: -by_y,
            ..Slack::none(LimitKind::HertzPressure)
        }
    }
}

/// Torque, its rate, the pressure and the power of the finished cam against the limits.
pub fn checks(design: &Finished) -> Vec<Check> {
    let limits = &design.problem.limits;
    let torque = || torque_curve(design.problem.force_curve(design.pressing), &design.cam.law);
    let mut out = Vec::new();
    let mut check = |kind: LimitKind, worst: Extreme, limit: f64| {
        out.push(Check::of(kind, worst, limit, SLACK));
    };
    if let Some(limit) = limits[LimitKind::Torque] {
        check(LimitKind::Torque, largest(&torque()), limit);
    }
    if let Some(limit) = limits[LimitKind::TorqueRate] {
        check(
            LimitKind::TorqueRate,
            largest(&torque().derivative()),
            limit,
        );
    }
    if let Some(limit) = limits[LimitKind::HertzPressure] {
        let press = Press::of(design.problem, design.pressing);
        let worst = press.worst(design.cam, design.second, design.groove);
        // An undercut profile is cut away where the pressure would be highest.
        let endless = || design.cam.curvature().convex.map(|_| f64::INFINITY);
        let worst = worst.unwrap_or_else(endless);
        check(LimitKind::HertzPressure, worst, limit);
    }
    if let Some(limit) = limits[LimitKind::Power] {
        let worst = largest(&power_curve(design.problem, torque()));
        check(LimitKind::Power, worst, limit);
    }
    out
}

/// Shaft torque F·v without friction, N·m, of a force over the turn and the law of the cam.
pub fn torque_curve(force: PiecewisePoly, law: &Law) -> PiecewisePoly {
    product(&law.combination([0.0, 1.0, 0.0, 0.0], 0.0), &force)
}

/// Power of a shaft torque over the turn, W, at the speed that the shaft has.
pub fn power_curve(problem: &Problem, torque: PiecewisePoly) -> PiecewisePoly {
    match (problem.on_shaft.as_ref()).and_then(|shaft| shaft.extra.speed.as_ref()) {
        Some(speed) => product(&torque, speed),
        None => PiecewisePoly::combine(&[(problem.drive.speed, &torque)], 0.0),
    }
}

/// Largest absolute value, by roots.
pub fn largest(curve: &PiecewisePoly) -> Extreme {
    Extreme::largest(curve.extremes())
}

/// Smallest base radius under a flat face on which the pressure limit holds: the largest of F E*/(π L p²) − s − a.
pub fn smallest_base_radius(problem: &Problem, law: &Law, pressing: &Law) -> f64 {
    let Some(limit) = pressed(problem, 0.0) else {
        return 0.0;
    };
    let per_radius = problem.drive.weights()[2] - limit.weights[2];
    let force = problem.force_curve(pressing);
    let bend = law.combination([1.0, 0.0, 1.0, 0.0], 0.0);
    let bend = bend.cut_at(force.breaks());
    let force = force.cut_at(bend.breaks());
    PiecewisePoly::combine(&[(1.0 / per_radius, &force), (-1.0, &bend)], 0.0)
        .extremes()
        .1
        .value
}

/// The pressure limit, where a roller cam that is large enough keeps it: the roller itself is curved, and
/// that presses on any cam.
pub fn bearable_on_some_size(problem: &Problem, pressing: &Law) -> Option<f64> {
    let (most, roller) = (
        problem.limits[LimitKind::HertzPressure]?,
        problem.cam.roller_radius,
    );
    let force = problem.force_extremes(pressing).1.value;
    let least = force * modulus(STEEL, STEEL) / (PI * problem.cam.thickness * roller);
    (roller > 0.0 && least < WORTH_GROWING * most * most).then_some(most)
}
