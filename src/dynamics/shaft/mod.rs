//! The shaft as its motor turns it: speed over the turn, the supply that gives the mean speed, and what is left of it.
//!
//! In E = ω²/2 the motion is a first-order equation over the cam angle ([`turn`]); a falling motor line makes its map from
//! turn to turn a contraction, whose fixed point Newton's method finds together with the no-load speed that gives the mean
//! speed (theory §10).

mod in_time;
mod turn;

pub use in_time::{InTime, error_in_time};
pub use turn::{Load, Node};

use std::f64::consts::TAU;

use serde::Serialize;

use crate::drive::{Drive, Motor, TorqueLine};
use crate::error::{DynamicsError, Result};
use crate::law::Svaj;
use crate::units::{Dimension, Quantity};
use turn::Turn;

/// Newton iterations of the periodic turn at most; five are usual.
const ROUNDS: usize = 60;
/// Relative change of energy and no-load speed at which they are found.
const SAME: f64 = 1e-10;
/// A no-load speed or inertia that is proposed has this much more than is needed.
const MARGIN: f64 = 1.01;
/// Steps of a turn where only its existence is asked.
const COARSE: usize = 96;
/// Inertias are searched over this range, to this part.
const LEAST_INERTIA: f64 = 1e-4;
const INERTIA_PART: f64 = 0.01;

/// The steady motion of the shaft.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::{Drive, Motor, TorqueLine};
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // An eccentric of e = 10 mm lifts 10 kg: the energy M g e sin θ swings by 2 M g e, and so does ω²J/2.
/// let cam = Cam::new(Law::harmonic(0.01, &[(0.0, 0.01)]), Follower::FlatTranslating { base_radius: 0.02 })?;
/// let mut run = Run::new(cam, Drive::moving_axis(10.0, 9.81, 3.0), 720);
/// run.machine.motor = Some(Motor { line: TorqueLine::Slope(0.01), nominal: None, inertia: 100.0, friction: 0.0, gear: 1.0, efficiency: 1.0 });
/// let shaft = simulate(&run, Model::Rigid)?.shaft.unwrap();
/// assert!((shaft.ripple / (2.0 * 10.0 * 9.81 * 0.01 / (100.0 * 9.0)) - 1.0).abs() < 1e-3);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Shaft {
    /// Mean speed over time, rad/s.
    #[serde(rename = "mean_rad_per_s")]
    pub mean: f64,
    /// Lowest speed, rad/s.
    #[serde(rename = "min_rad_per_s")]
    pub min: f64,
    /// Highest speed, rad/s.
    #[serde(rename = "max_rad_per_s")]
    pub max: f64,
    /// Highest less lowest speed, part of the mean.
    pub ripple: f64,
    /// No-load speed of the motor, at the camshaft, that gives the mean speed, rad/s.
    #[serde(rename = "no_load_speed_rad_per_s")]
    pub no_load_speed: f64,
    /// Moment of inertia at the camshaft, kg·m².
    #[serde(rename = "inertia_kg_m2")]
    pub inertia: f64,
    /// Root mean square over time of the motor's own torque, N·m.
    pub motor_torque_rms_n_m: f64,
    /// Its largest absolute value, N·m.
    pub motor_torque_max_n_m: f64,
    /// Mean power that the motor gives, W.
    pub motor_power_mean_w: f64,
    /// Angle from the lowest lift at which the shaft stops when it starts there from rest, rad; `None`: it passes.
    pub stops_at_rad: Option<f64>,
    /// Smallest inertia, kg·m², to 1 %, with which the shaft keeps turning at the mean speed; 0: with any.
    pub least_inertia_kg_m2: f64,
    /// Work of the motor less friction and load, part of the work that swings in a turn.
    pub energy_balance: f64,
}

/// Speed and time over the turn at equal angles.
#[derive(Debug, Clone)]
pub struct Motion {
    /// ω, rad/s.
    pub speed: Vec<f64>,
    /// d(ω²/2)/dθ, the angular acceleration, rad/s².
    pub acceleration: Vec<f64>,
    /// Time since the first angle, s.
    pub time: Vec<f64>,
    mean: f64,
    steady: Steady,
}

impl Motion {
    /// Contact force at the rows, N: F₀ + k s + c ω v + m (ω² a + ω ω′ v).
    pub fn forces(&self, drive: &Drive, nodes: &[Svaj]) -> Vec<f64> {
        let motion = self.speed.iter().zip(&self.acceleration);
        let force = |(at, (w, rate)): (&Svaj, (&f64, &f64))| {
            let still = drive.rest_force + drive.spring_rate * at.s + drive.damping * w * at.v;
            still + drive.mass * (w * w * at.a + rate * at.v)
        };
        nodes.iter().zip(motion).map(force).collect()
    }
}

impl Motion {
    /// Highest less lowest speed, part of the mean.
    pub fn ripple(&self) -> f64 {
        let [min, max] = self.steady.turn.range.map(|e| (2.0 * e).sqrt());
        (max - min) / self.mean
    }

    /// Part of the period, rad, at an angle since the first, rad, with its derivatives by the angle.
    pub fn phase(&self, angle: f64) -> [f64; 3] {
        let n = self.speed.len();
        let h = TAU / n as f64;
        let x = angle / h;
        let (turns, place) = (x.div_euclid(n as f64), x.rem_euclid(n as f64));
        let i = (place as usize).min(n - 1);
        let u = place - i as f64;
        let at = |k: usize| {
            let (w, rate) = (self.speed[k % n], self.acceleration[k % n]);
            let from = if k == n {
                TAU
            } else {
                self.mean * self.time[k]
            };
            [
                from,
                h * self.mean / w,
                -h * h * self.mean * rate / (w * w * w),
            ]
        };
        // Hermite's quintic.
        let ([y, d, e], [z, f, g]) = (at(i), at(i + 1));
        let rise = z - y;
        let c = [
            10.0 * rise - 6.0 * d - 4.0 * f - 0.5 * (3.0 * e - g),
            -15.0 * rise + 8.0 * d + 7.0 * f + 0.5 * (3.0 * e - 2.0 * g),
            6.0 * rise - 3.0 * (d + f) - 0.5 * (e - g),
        ];
        let value = y + u * (d + u * (0.5 * e + u * (c[0] + u * (c[1] + u * c[2]))));
        let slope = d + u * (e + u * (3.0 * c[0] + u * (4.0 * c[1] + u * 5.0 * c[2])));
        let bend = e + u * (6.0 * c[0] + u * (12.0 * c[1] + u * 20.0 * c[2]));
        [TAU * turns + value, slope / h, bend / (h * h)]
    }

    /// Refuses a motor whose supply does not reach the no-load speed of this motion; `load` is what it carries.
    ///
    /// # Errors
    /// The motor's no-load speed is too low for the mean speed.
    pub fn check_supply(&self, load: &Load, motor: &Motor) -> Result<()> {
        let enough = |most: &f64| *most >= self.steady.no_load * (1.0 - 1e-9);
        let Some(nominal) = motor.nominal.filter(|most| !enough(most)) else {
            return Ok(());
        };
        // Another no-load speed of the same stall torque is another slope.
        let needed = match motor.line {
            TorqueLine::Slope(slope) => Motor {
                line: TorqueLine::Stall(slope * nominal),
                ..motor.clone()
            },
            TorqueLine::Stall(_) | TorqueLine::Curve(_) => motor.clone(),
        };
        let needed = Steady::find(load, &needed, self.mean).map(|s| s.no_load);
        let needed = MARGIN * needed.unwrap_or(self.steady.no_load);
        let [nominal, needed, speed] = [motor.gear * nominal, motor.gear * needed, self.mean]
            .map(|w| Quantity::new(w, Dimension::AngularSpeed));
        let fault = DynamicsError::NoLoadSpeed {
            nominal,
            needed,
            speed,
        };
        Err(fault.into())
    }

    /// What is reported of it; `lowest` is the angle of the lowest lift.
    pub fn report(&self, load: &Load, motor: &Motor, lowest: f64) -> Shaft {
        self.steady.report(load, motor, self.mean, lowest)
    }
}

/// The periodic motion of a load under a motor at a mean speed, rad/s; `nodes` are the loads at its equal angles, and `near`
/// is a motion not far from it, where one is known.
///
/// # Errors
/// The shaft stops.
pub fn periodic(
    load: &Load,
    nodes: &[Node],
    motor: &Motor,
    mean: f64,
    near: Option<&Motion>,
) -> Result<Motion> {
    let start = near.map(|m| [m.steady.turn.energy[0], m.steady.no_load]);
    let near = start.and_then(|start| Steady::near(load, motor, mean, start));
    let Some(steady) = near.or_else(|| Steady::find(load, motor, mean)) else {
        return Err(stalls(&load.every(COARSE), motor, mean).into());
    };
    let (energy, time) = load.at_rows(&steady.turn);
    let rate = |(node, e): (&Node, &f64)| node.rate(motor, steady.no_load, *e)[0];
    Ok(Motion {
        acceleration: nodes.iter().zip(&energy).map(rate).collect(),
        speed: energy.iter().map(|e| (2.0 * e).sqrt()).collect(),
        time,
        mean,
        steady,
    })
}

/// The message for a shaft that stops, with an inertia that would do.
fn stalls(load: &Load, motor: &Motor, speed: f64) -> DynamicsError {
    let doing = (1..=40)
        .map(|k| motor.inertia.max(1e-6) * f64::from(k).exp2())
        .find(|j| Steady::find(load, &with_inertia(motor, *j), speed).is_some());
    let inertia = |j: f64| Quantity::new(j, Dimension::Inertia);
    match doing {
        None => DynamicsError::StallsAnyway,
        Some(high) => {
            let least = between(load, motor, speed, [0.5 * high, high]);
            DynamicsError::Stalls {
                inertia: inertia(motor.inertia),
                needed: inertia(least * MARGIN),
            }
        }
    }
}

fn with_inertia(motor: &Motor, inertia: f64) -> Motor {
    Motor {
        inertia,
        ..motor.clone()
    }
}

/// Smallest inertia that keeps turning between one that does not and one that does.
fn between(load: &Load, motor: &Motor, speed: f64, [mut low, mut high]: [f64; 2]) -> f64 {
    while high > low * (1.0 + INERTIA_PART) {
        let middle = (low * high).sqrt();
        match Steady::find(load, &with_inertia(motor, middle), speed) {
            Some(_) => high = middle,
            None => low = middle,
        }
    }
    high
}

/// A turn that repeats.
#[derive(Debug, Clone)]
struct Steady {
    turn: Turn,
    no_load: f64,
}

impl Steady {
    /// The turn that ends as it begins and takes the time of the mean speed.
    fn find(load: &Load, motor: &Motor, speed: f64) -> Option<Steady> {
        if load.steps() > 2 * COARSE
            && let Some(coarse) = Steady::find(&load.every(COARSE), motor, speed)
        {
            let start = [coarse.turn.energy[0], coarse.no_load];
            return Steady::near(load, motor, speed, start);
        }
        let (mean, swing) = load.at_constant_speed(speed);
        let mut no_load = motor.no_load_for(speed, mean + motor.friction);
        let mut first = 0.5 * speed * speed;
        let mut turn = load.turn(motor, no_load, first);
        // A small wheel needs more energy at the hardest place than the mean speed gives.
        for _ in 0..8 {
            if turn.is_ok() {
                break;
            }
            first += 0.25 * swing / motor.inertia;
            no_load *= 1.05;
            turn = load.turn(motor, no_load, first);
        }
        turn.ok()?;
        Steady::near(load, motor, speed, [first, no_load])
    }

    /// The same by Newton's method from an energy at the first angle and a no-load speed.
    fn near(load: &Load, motor: &Motor, speed: f64, start: [f64; 2]) -> Option<Steady> {
        let [mut first, mut no_load] = start;
        let mut turn = load.turn(motor, no_load, first).ok()?;
        for _ in 0..ROUNDS {
            let [end, time] = [&turn.energy, &turn.time].map(|v| v.last().copied().unwrap_or(0.0));
            let off = [end - first, time - TAU / speed];
            let [[a, c], [b, d]] = [[turn.by_first[0] - 1.0, turn.by_first[1]], turn.by_supply];
            let determinant = a * d - b * c;
            let step = [
                (off[1] * b - off[0] * d) / determinant,
                (off[0] * c - off[1] * a) / determinant,
            ];
            if step[0].abs() <= SAME * first && step[1].abs() <= SAME * no_load {
                return Some(Steady { turn, no_load });
            }
            if !step.iter().all(|x| x.is_finite()) {
                return None;
            }
            let mut part = (0.5 * first / step[0].abs())
                .min(0.5 * no_load / step[1].abs())
                .min(1.0);
            loop {
                let (e, p) = (first + part * step[0], no_load + part * step[1]);
                if let Ok(next) = load.turn(motor, p, e) {
                    (turn, first, no_load) = (next, e, p);
                    break;
                }
                part *= 0.5;
                if part < 1e-3 {
                    return None;
                }
            }
        }
        None
    }

    fn report(&self, load: &Load, motor: &Motor, speed: f64, lowest: f64) -> Shaft {
        let coarse = &load.every(COARSE);
        let turn = &self.turn;
        let [min, max] = turn.range.map(|e| (2.0 * e).sqrt());
        let period = TAU / speed;
        let wasted = motor.friction * TAU;
        let swing = load.at_constant_speed(speed).1;
        let balance = turn.motor_work - wasted - turn.load_work;
        let least = LEAST_INERTIA * motor.inertia;
        let runs = Steady::find(coarse, &with_inertia(motor, least), speed).is_some();
        let stops = load.begun_at(lowest).turn(motor, self.no_load, 0.0).err();
        Shaft {
            mean: speed,
            min,
            max,
            ripple: (max - min) / speed,
            no_load_speed: self.no_load,
            inertia: motor.inertia,
            motor_torque_rms_n_m: motor.own_torque((turn.motor_square / period).sqrt()),
            motor_torque_max_n_m: motor.own_torque(turn.motor_peak),
            motor_power_mean_w: turn.motor_work / motor.efficiency / period,
            stops_at_rad: stops.map(|at| (at - lowest).rem_euclid(TAU)),
            least_inertia_kg_m2: match runs {
                true => 0.0,
                false => between(coarse, motor, speed, [least, motor.inertia]),
            },
            energy_balance: balance / swing.max(turn.motor_work.abs()).max(f64::MIN_POSITIVE),
        }
    }
}
