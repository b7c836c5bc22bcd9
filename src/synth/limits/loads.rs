//! Load limits that are not convex in the law: torque, torque rate and power of the shaft, and the Hertz pressure under a roller. Each
//! limit has the form h(s, v, a, j, D, e) ≥ 0 (symbols as in `slack`), with the partial derivatives of h. F is the contact force.

use std::f64::consts::PI;
use std::sync::Arc;

use super::finished::Finished;
use super::hertz_pressure::{self, Pressure};
use super::slack::{ProfileSize, Slack};
use crate::cam::{Check, LimitKind};
use crate::drive::Drive;
use crate::law::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly};
use crate::problem::{OnShaft, Problem, product};

/// Relative violation below which a limit counts as satisfied.
const SLACK: f64 = 1e-6;

/// Nonconvex load limits of a problem. A field is `None` if the scene has no such limit.
#[derive(Debug, Clone)]
pub struct Loads {
    /// Drive, which relates lift and force.
    pub drive: Drive,
    /// Force, N, that a varying speed or a floor adds; `None` for a rigid machine at constant speed.
    pub on_shaft: Option<Arc<OnShaft>>,
    /// Maximum torque |F v|, N·m, with the contact force F and the derivative v of the lift with respect to the cam angle.
    pub torque: Option<f64>,
    /// Maximum |F v| that corresponds to the limit on the power at the mean speed, N·m.
    pub power: Option<f64>,
    /// Maximum |d(F v)/dθ|, N·m/rad.
    pub torque_rate: Option<f64>,
    /// Limit on the Hertz pressure between roller and cam.
    pub pressure: Option<Pressure>,
}

impl Loads {
    /// Nonconvex load limits of a problem; `None` if there are none. The pressure limit is included if the follower is a translating roller
    /// (`under_roller`).
    pub fn of(problem: &Problem, under_roller: bool) -> Option<Loads> {
        let limits = &problem.limits;
        let roller = Some(problem.cam.roller_radius).filter(|r| under_roller && *r > 0.0);
        let loads = Loads {
            drive: problem.drive,
            on_shaft: problem.on_shaft.clone(),
            torque: limits[LimitKind::Torque],
            // The power divided by the mean speed is the limit on the torque at constant speed (theory §10).
            power: limits[LimitKind::Power].map(|power| power / problem.drive.speed),
            torque_rate: limits[LimitKind::TorqueRate],
            pressure: roller
                .zip(limits[LimitKind::HertzPressure])
                .map(|(roller, most)| Pressure {
                    spread: PI * problem.cam.thickness / problem.cam.contact_modulus(),
                    roller,
                    most,
                }),
        };
        (!loads.named().is_empty()).then_some(loads)
    }

    /// Clearances h of all limits at a point of the law. A limit is satisfied if h ≥ 0.
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
        let pressure = self.pressure.as_ref();
        out.extend(pressure.map(|p| p.slack(&self.drive, at, force, size)));
    }

    /// Upper limits on |F v| at an angle, N·m, from the limits on torque and power. At constant speed only the smaller limit is returned.
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

    /// Kinds and values of the limits that are present.
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

    /// The limits, with the value of one limit replaced. The value `None` removes this limit.
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

    /// Clearance h = T − (±F v) of a limit T on the torque.
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

    /// Clearance h = R − (±(F′ v + F a)) of a limit R on the torque rate.
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
}

/// Checks of torque, torque rate, Hertz pressure and power of the finished cam.
pub fn checks(design: &Finished) -> Vec<Check> {
    let limits = &design.problem.limits;
    let torque = || torque_curve(design.problem.force_curve(design.pressing), &design.cam.law);
    let mut out = Vec::new();
    let mut check = |kind: LimitKind, worst: &dyn Fn() -> Extreme| {
        let limit = limits[kind];
        out.extend(limit.map(|limit| Check::of(kind, worst(), limit, SLACK)));
    };
    check(LimitKind::Torque, &|| largest(&torque()));
    check(LimitKind::TorqueRate, &|| largest(&torque().derivative()));
    check(LimitKind::HertzPressure, &|| hertz_pressure::worst(design));
    check(LimitKind::Power, &|| {
        largest(&power_curve(design.problem, torque()))
    });
    out
}

/// Shaft torque F·v without friction, N·m, as a function of the angle, from the contact force and the law of the cam.
pub fn torque_curve(force: PiecewisePoly, law: &Law) -> PiecewisePoly {
    product(&law.combination([0.0, 1.0, 0.0, 0.0], 0.0), &force)
}

/// Shaft power as a function of the angle, W, from a shaft torque, N·m, at the actual shaft speed.
pub fn power_curve(problem: &Problem, torque: PiecewisePoly) -> PiecewisePoly {
    match (problem.on_shaft.as_ref()).and_then(|shaft| shaft.extra.speed.as_ref()) {
        Some(speed) => product(&torque, speed),
        None => PiecewisePoly::combine(&[(problem.drive.speed, &torque)], 0.0),
    }
}

/// Maximum absolute value of a curve with its position, computed from the roots of the derivative.
pub fn largest(curve: &PiecewisePoly) -> Extreme {
    Extreme::largest(curve.extremes())
}
