//! Motor-driven shaft: speed over the turn, and the no-load speed that gives the mean speed.
//!
//! The unknown is E = ω²/2 as a function of the cam angle, which obeys a first-order differential equation ([`turn`]). The periodic
//! solution is computed together with the no-load speed ([`steady`], theory §10).

mod in_time;
mod steady;
mod turn;

pub use in_time::{Cubic, InTime, error_in_time};
pub use turn::{Load, Node};

use std::f64::consts::TAU;

use serde::Serialize;

use crate::drive::{Drive, Motor, TorqueLine};
use crate::error::{DynamicsError, Result};
use crate::law::Svaj;
use crate::units::{Dimension, Quantity};
pub use steady::forecast;
use steady::{Stall, Steady};

/// Ratio of a suggested no-load speed or inertia to its minimum.
const MARGIN: f64 = 1.02;
/// Work, relative to J Ω² (inertia J and mean speed Ω), below which it counts as a rounding error.
const ROUNDING: f64 = 1e-9;

/// Steady motion of the motor-driven shaft: speeds, torques and required inertia.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::drive::{Drive, Motor, TorqueLine};
/// use gaitcam::dynamics::{Model, Run, simulate};
/// use gaitcam::law::Law;
///
/// // An eccentric of e = 10 mm lifts M = 10 kg. The range of the potential energy M g e sin θ is 2 M g e, and so is the range of ω²J/2.
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
    /// Minimum speed of the shaft, rad/s.
    #[serde(rename = "min_rad_per_s")]
    pub min: f64,
    /// Maximum speed of the shaft, rad/s.
    #[serde(rename = "max_rad_per_s")]
    pub max: f64,
    /// Difference of maximum and minimum speed, relative to the mean.
    pub ripple: f64,
    /// No-load speed of the motor at the camshaft for which the shaft has the mean speed, rad/s.
    #[serde(rename = "no_load_speed_rad_per_s")]
    pub no_load_speed: f64,
    /// Moment of inertia referred to the camshaft, kg·m².
    #[serde(rename = "inertia_kg_m2")]
    pub inertia: f64,
    /// Root mean square over time of the torque of the motor shaft, N·m.
    pub motor_torque_rms_n_m: f64,
    /// Maximum absolute torque of the motor shaft, N·m.
    pub motor_torque_max_n_m: f64,
    /// Mean power of the motor, W.
    pub motor_power_mean_w: f64,
    /// Angle that the shaft turns from rest at the minimum lift until it stops, rad; `None` if it does not stop.
    pub stops_at_rad: Option<f64>,
    /// Minimum inertia, kg·m², with an accuracy of 1 %, for which the shaft does not stop at the mean speed; 0 if any inertia is sufficient.
    pub least_inertia_kg_m2: f64,
    /// Work of the motor over a turn minus the work of friction and load. It is relative to the larger of the alternating work of the load
    /// and the work of the motor. The value is a measure of the numerical error.
    pub energy_balance: f64,
}

/// Motion of the shaft over one turn.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Speed ω of the shaft at equal angles, rad/s; empty before a call of [`Motion::at_rows`].
    pub speed: Vec<f64>,
    /// Angular acceleration d(ω²/2)/dθ at the same angles, rad/s².
    pub acceleration: Vec<f64>,
    /// Time since the first angle at the same angles, s.
    pub time: Vec<f64>,
    mean: f64,
    /// Load of the motor and its periodic solution; `None` for constant speed.
    turn: Option<(Load, Steady)>,
    pieces: Vec<Piece>,
}

/// One span of the elapsed fraction of the period, rad (2π for one period), as a polynomial of the cam angle. Angles are measured from the
/// first angle, rad.
#[derive(Debug, Clone)]
struct Piece {
    from: f64,
    factors: [f64; 6],
}

/// Elapsed fraction of the period, rad (2π for one period), at an angle measured from the first angle, rad, with its derivatives with
/// respect to the angle. The second derivative may jump.
struct Mark {
    angle: f64,
    phase: f64,
    rate: f64,
    /// Second derivative before and after the angle.
    bend: [f64; 2],
}

impl Piece {
    /// Quintic Hermite interpolation of the elapsed fraction between two angles.
    fn between(from: &Mark, to: &Mark) -> Piece {
        let h = to.angle - from.angle;
        let (square, rise) = (h * h, to.phase - from.phase);
        let ([d, f], [e, g]) = (
            [from.rate, to.rate].map(|r| r * h),
            [from.bend[1], to.bend[0]].map(|b| b * square),
        );
        Piece {
            from: from.angle,
            factors: [
                from.phase,
                from.rate,
                0.5 * from.bend[1],
                (10.0 * rise - 6.0 * d - 4.0 * f - 0.5 * (3.0 * e - g)) / (square * h),
                (-15.0 * rise + 8.0 * d + 7.0 * f + 0.5 * (3.0 * e - 2.0 * g)) / (square * square),
                (6.0 * rise - 3.0 * (d + f) - 0.5 * (e - g)) / (square * square * h),
            ],
        }
    }
}

impl Motion {
    /// A motion with constant speed, rad/s.
    pub fn even(mean: f64) -> Motion {
        let piece = Piece {
            from: 0.0,
            factors: [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        };
        Motion::new(mean, None, vec![piece])
    }

    fn new(mean: f64, turn: Option<(Load, Steady)>, pieces: Vec<Piece>) -> Motion {
        Motion {
            speed: Vec::new(),
            acceleration: Vec::new(),
            time: Vec::new(),
            mean,
            turn,
            pieces,
        }
    }

    /// The motion with speed, acceleration and time at `count` equal angles.
    #[must_use]
    pub fn at_rows(mut self, count: usize) -> Motion {
        for i in 0..count {
            let phase = self.phase(TAU * i as f64 / count as f64);
            let [speed, acceleration, _] = self.speed_of(phase);
            self.speed.push(speed);
            self.acceleration.push(acceleration);
            self.time.push(phase[0] / self.mean);
        }
        self
    }

    /// Angles between which the motion is smooth, rad, measured from the first angle, from 0 to one turn.
    pub fn breaks(&self) -> impl Iterator<Item = f64> {
        self.pieces.iter().map(|p| p.from).chain([TAU])
    }

    /// Difference of maximum and minimum speed, relative to the mean.
    pub fn ripple(&self) -> f64 {
        let range = self.turn.as_ref().map(|(_, steady)| steady.range);
        range.map_or(0.0, |[min, max]| {
            ((2.0 * max).sqrt() - (2.0 * min).sqrt()) / self.mean
        })
    }

    /// Elapsed fraction of the period, rad (2π for one period), at an angle measured from the first angle, rad, with its first three
    /// derivatives.
    pub fn phase(&self, angle: f64) -> [f64; 4] {
        let turns = (angle / TAU).floor();
        let angle = angle - TAU * turns;
        let i = self.pieces.partition_point(|p| p.from <= angle);
        let piece = &self.pieces[i.max(1) - 1];
        let (x, [a, b, c, d, e, f]) = (angle - piece.from, piece.factors);
        [
            TAU * turns + a + x * (b + x * (c + x * (d + x * (e + x * f)))),
            b + x * (2.0 * c + x * (3.0 * d + x * (4.0 * e + x * 5.0 * f))),
            2.0 * c + x * (6.0 * d + x * (12.0 * e + x * 20.0 * f)),
            6.0 * d + x * (24.0 * e + x * 60.0 * f),
        ]
    }

    /// Cam angle, rad, measured from the first angle, at an elapsed fraction of the period, rad (2π for one period).
    pub fn angle(&self, phase: f64) -> f64 {
        let (turns, phase) = (phase.div_euclid(TAU), phase.rem_euclid(TAU));
        let i = self.pieces.partition_point(|p| p.factors[0] <= phase);
        let i = i.max(1);
        let from = &self.pieces[i - 1];
        let next = self
            .pieces
            .get(i)
            .map_or((TAU, TAU), |p| (p.from, p.factors[0]));
        let part = (phase - from.factors[0]) / (next.1 - from.factors[0]);
        let mut angle = from.from + part * (next.0 - from.from);
        for _ in 0..3 {
            let at = self.phase(angle);
            angle -= (at[0] - phase) / at[1];
        }
        TAU * turns + angle
    }

    /// Speed, rad/s, and its time derivative, rad/s², at an angle measured from the first angle, rad. The third value is the derivative of
    /// the second with respect to the angle.
    pub fn speed_at(&self, angle: f64) -> [f64; 3] {
        self.speed_of(self.phase(angle))
    }

    fn speed_of(&self, [_, rate, bend, third]: [f64; 4]) -> [f64; 3] {
        let w = self.mean / rate;
        let cube = w * w * w / self.mean;
        let acceleration = -bend * cube;
        let slope = acceleration / w;
        [
            w,
            acceleration,
            -third * cube - 3.0 * bend * w * w / self.mean * slope,
        ]
    }

    /// Rejects a motor whose supply does not reach the no-load speed of this motion.
    ///
    /// # Errors
    ///
    /// The no-load speed of the motor is too low for the mean speed.
    pub fn check_supply(&self, motor: &Motor) -> Result<()> {
        let Some((load, steady)) = &self.turn else {
            return Ok(());
        };
        let enough = |most: &f64| *most >= steady.no_load * (1.0 - 1e-9);
        let Some(nominal) = motor.nominal.filter(|most| !enough(most)) else {
            return Ok(());
        };
        // For the same stall torque, another no-load speed gives another slope.
        let needed = match motor.line {
            TorqueLine::Slope(slope) => Motor {
                line: TorqueLine::Stall(slope * nominal),
                ..motor.clone()
            },
            TorqueLine::Stall(_) | TorqueLine::Curve(_) => motor.clone(),
        };
        let needed = Steady::find(load, &needed, self.mean, None).map(|s| s.no_load);
        let needed = MARGIN * needed.unwrap_or(steady.no_load);
        let [nominal, needed, speed] = [motor.gear * nominal, motor.gear * needed, self.mean]
            .map(|w| Quantity::new(w, Dimension::AngularSpeed));
        let fault = DynamicsError::NoLoadSpeed {
            nominal,
            needed,
            speed,
        };
        Err(fault.into())
    }

    /// Characteristic values of the motion; `None` for constant speed. `lowest` is the cam angle of the minimum lift, rad.
    pub fn report(&self, motor: &Motor, lowest: f64) -> Option<Shaft> {
        let (load, turn) = self.turn.as_ref()?;
        let [min, max] = turn.range.map(|e| (2.0 * e).sqrt());
        let period = TAU / self.mean;
        let balance = turn.motor_work - motor.friction * TAU - turn.load_work;
        let swing = load.swing(self.mean);
        let stops = load.stop_from_rest(motor, turn.no_load, lowest);
        // The torque decreases with the speed, so its extremes are at the extreme speeds.
        let torques = [min, max].map(|w| motor.torque(w, turn.no_load)[0].abs());
        // Without a load, both works are rounding errors.
        let least = ROUNDING * motor.inertia * self.mean * self.mean;
        Some(Shaft {
            mean: self.mean,
            min,
            max,
            ripple: self.ripple(),
            no_load_speed: turn.no_load,
            inertia: motor.inertia,
            motor_torque_rms_n_m: motor.own_torque((turn.motor_square / period).sqrt()),
            motor_torque_max_n_m: motor.own_torque(torques[0].max(torques[1])),
            motor_power_mean_w: turn.motor_work / motor.efficiency / period,
            stops_at_rad: stops.map(|at| (at - lowest).rem_euclid(TAU)),
            least_inertia_kg_m2: turn.least_inertia(load, motor, self.mean),
            energy_balance: balance
                / swing
                    .max(turn.motor_work.abs())
                    .max(least)
                    .max(f64::MIN_POSITIVE),
        })
    }
}

/// Contact force, N, at a speed of the shaft, rad/s, and its angular acceleration, rad/s².
pub fn force(drive: &Drive, at: Svaj, speed: f64, acceleration: f64) -> f64 {
    let still = drive.rest_force + drive.spring_rate * at.s + drive.damping * speed * at.v;
    still + drive.mass * (speed * speed * at.a + acceleration * at.v)
}

/// Periodic motion of a motor and its load at a given mean speed, rad/s. `near` is an optional initial guess.
///
/// # Errors
///
/// The shaft stops.
pub fn periodic(load: Load, motor: &Motor, mean: f64, near: Option<&Motion>) -> Result<Motion> {
    let near = near.and_then(|m| m.turn.as_ref());
    let steady = match Steady::find(&load, motor, mean, near.map(|turn| &turn.1)) {
        Ok(steady) => steady,
        Err(stall) => return Err(stalls(motor, stall).into()),
    };
    let start = load.steps[0].from;
    let mark = |i: usize, before: usize, after: usize, angle: f64| {
        let energy = steady.energy[i];
        let rate = mean / (2.0 * energy).sqrt();
        let bend = |step: usize, end: usize| {
            let acceleration = steady.rate_at_end(&load, motor, step, end);
            -acceleration * rate.powi(3) / (mean * mean)
        };
        Mark {
            angle,
            phase: mean * steady.time[i],
            rate,
            bend: [bend(before, 1), bend(after, 0)],
        }
    };
    let count = load.steps.len();
    let first = |i: usize| mark(i, (i + count - 1) % count, i, load.steps[i].from - start);
    let mut marks: Vec<Mark> = (0..count).map(first).collect();
    marks.push(mark(count, count - 1, 0, TAU));
    let pieces = marks
        .windows(2)
        .map(|ends| Piece::between(&ends[0], &ends[1]));
    let pieces = pieces.collect();
    Ok(Motion::new(mean, Some((load, steady)), pieces))
}

/// Error for a shaft that stops. It contains a sufficient inertia, if one exists.
fn stalls(motor: &Motor, stall: Stall) -> DynamicsError {
    let inertia = |j: f64| Quantity::new(j, Dimension::Inertia);
    match stall {
        Stall::Anyway => DynamicsError::StallsAnyway,
        Stall::Below(least) => DynamicsError::Stalls {
            inertia: inertia(motor.inertia),
            needed: inertia(least * MARGIN),
        },
    }
}
