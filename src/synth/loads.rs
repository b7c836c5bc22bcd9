//! Limits on what shaft and contact bear, as h(s, v, a, j, D, e) ≥ 0 with its derivatives: torque, its rate,
//! and the pressure under a roller.

use super::nonconvex::{Size, Slack};
use crate::drive::Drive;
use crate::law::Svaj;

/// What is not convex in the loads of a scene; `None` = no limit.
#[derive(Debug, Clone, Copy)]
pub struct Loads {
    /// Lift to force.
    pub drive: Drive,
    /// Largest |F v|, N·m.
    pub torque: Option<f64>,
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
    /// Every limit at a place of the law; h ≥ 0 where it holds.
    pub fn slacks(&self, at: Svaj, size: Size, out: &mut Vec<Slack>) {
        for side in [1.0, -1.0] {
            out.extend(self.torque.map(|most| self.torque_slack(at, most, side)));
            out.extend(self.torque_rate.map(|most| self.rate_slack(at, most, side)));
        }
        out.extend(self.pressure.map(|p| self.pressure_slack(at, size, p)));
    }

    /// The limits there are, with their values.
    pub fn named(&self) -> Vec<(&'static str, f64)> {
        [
            ("torque", self.torque),
            ("torque_rate", self.torque_rate),
            ("hertz_pressure", self.pressure.map(|p| p.most)),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
    }

    /// The same with one limit at another value, or left out.
    pub fn with(&self, name: &str, value: Option<f64>) -> Loads {
        let mut out = *self;
        match name {
            "torque" => out.torque = value,
            "torque_rate" => out.torque_rate = value,
            _ => {
                out.pressure = out
                    .pressure
                    .and_then(|p| value.map(|most| Pressure { most, ..p }));
            }
        }
        out
    }

    /// T − (±F v).
    fn torque_slack(&self, at: Svaj, most: f64, side: f64) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        let force = self.drive.force(at);
        Slack {
            h: most - side * force * at.v,
            w: most,
            largest: most,
            by_lift: -side * k * at.v,
            by_velocity: -side * (force + c * at.v),
            by_acceleration: -side * m * at.v,
            ..Slack::none("torque")
        }
    }

    /// R − (±(F′ v + F a)).
    fn rate_slack(&self, at: Svaj, most: f64, side: f64) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        let force = self.drive.force(at);
        let rate = k * at.v + c * at.a + m * at.j;
        Slack {
            h: most - side * (rate * at.v + force * at.a),
            w: most,
            largest: most,
            by_lift: -side * k * at.a,
            by_velocity: -side * (k * at.v + rate + c * at.a),
            by_acceleration: -side * (c * at.v + force + m * at.a),
            by_jerk: -side * m * at.v,
            ..Slack::none("torque_rate")
        }
    }

    /// q R_f X (w^{3/2} − R_f K) − F w², q = p² π L/E*: with X = D + s, Y = v − e, w = X² + Y² and
    /// K = w + vY − aX the normal force is F √w/X and the sum of curvatures w^{3/2}/(R_f (w^{3/2} − R_f K))
    /// (theory §6, §10).
    fn pressure_slack(&self, at: Svaj, size: Size, p: Pressure) -> Slack {
        let [k, c, m, _] = self.drive.weights();
        let force = self.drive.force(at);
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
            ..Slack::none("hertz_pressure")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::Follower;
    use crate::dynamics::hertz::{STEEL, line, modulus};
    use crate::dynamics::touch::touch;
    use std::f64::consts::PI;

    const THICK: f64 = 0.01;

    fn loads() -> Loads {
        Loads {
            drive: Drive {
                spring_rate: 4000.0,
                damping: 30.0,
                rest_force: 200.0,
                ..Drive::moving_axis(3.0, 9.81, 20.0)
            },
            torque: Some(5.0),
            torque_rate: Some(9.0),
            pressure: Some(Pressure {
                spread: PI * THICK / modulus(STEEL, STEEL),
                roller: 0.01,
                most: 5e8,
            }),
        }
    }

    const SIZE: Size = Size {
        rise: 0.04,
        offset: 0.007,
        rho: 0.012,
    };

    fn place(i: u32) -> Svaj {
        let x = f64::from(i);
        Svaj {
            s: 0.01 * (1.0 + (1.3 * x).sin()),
            v: 0.01 * (0.7 * x).cos(),
            a: 0.01 * (0.3 * x + 1.0).sin(),
            j: 0.02 * (0.9 * x).cos(),
        }
    }

    fn slacks(at: Svaj, size: Size) -> Vec<Slack> {
        let mut out = Vec::new();
        loads().slacks(at, size, &mut out);
        out
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let d = 1e-7;
        for i in 0..30 {
            let at = place(i);
            for (k, own) in slacks(at, SIZE).into_iter().enumerate() {
                let h = |at: Svaj, size: Size| slacks(at, size)[k].h;
                let moved = |f: &dyn Fn(f64) -> f64| (f(d) - f(-d)) / (2.0 * d);
                let found = [
                    moved(&|x| h(Svaj { s: at.s + x, ..at }, SIZE)),
                    moved(&|x| h(Svaj { v: at.v + x, ..at }, SIZE)),
                    moved(&|x| h(Svaj { a: at.a + x, ..at }, SIZE)),
                    moved(&|x| h(Svaj { j: at.j + x, ..at }, SIZE)),
                    moved(&|x| {
                        h(
                            at,
                            Size {
                                rise: SIZE.rise + x,
                                ..SIZE
                            },
                        )
                    }),
                    moved(&|x| {
                        h(
                            at,
                            Size {
                                offset: SIZE.offset + x,
                                ..SIZE
                            },
                        )
                    }),
                ];
                let stated = [
                    own.by_lift,
                    own.by_velocity,
                    own.by_acceleration,
                    own.by_jerk,
                    own.by_rise,
                    own.by_offset,
                ];
                let size = stated.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
                for (f, s) in found.iter().zip(stated) {
                    assert!(
                        (f - s).abs() < 1e-6 * size,
                        "{} {found:?} {stated:?}",
                        own.name
                    );
                }
            }
        }
    }

    /// h has the sign of the limit less the pressure that the contact itself is known to have.
    #[test]
    fn the_pressure_is_the_contact_s_own() {
        let follower = Follower::RollerTranslating {
            prime_radius: SIZE.rise.hypot(SIZE.offset),
            offset: SIZE.offset,
            roller_radius: 0.01,
        };
        for i in 0..30 {
            let at = place(i);
            let force = loads().drive.force(at);
            let here = touch(&follower, 20.0, 0.0, at, force);
            let steel = modulus(STEEL, STEEL);
            let pressure = line(here.normal, THICK, here.curvature, steel).pressure;
            let at_limit = loads().with("hertz_pressure", Some(pressure));
            let mut out = Vec::new();
            at_limit.slacks(at, SIZE, &mut out);
            let slack = out.last().unwrap();
            assert!(
                slack.h.abs() < 1e-12 * slack.w,
                "{i}: {} {}",
                slack.h,
                slack.w
            );
        }
    }
}
