//! Simulated machine whose parameters are hidden from `identify`. It is integrated in time by a separate method (Runge-Kutta of order 4 with equal
//! steps) and shares only the law of the cam with the library.
//!
//! ```text
//! m ẍ = N − m g − k x − F₀ − f(ẋ)                        the moved mass
//! N   = k_c (s(θ) + e − x + z) + c_c d/dt(…), N ≥ 0      contact, compliant or rigid (x = s + e)
//! J ω̇ = T₀ − d (ω − ω̄) + T_c sin(pθ) − N v(θ)            the shaft
//! m_f (z̈ + 2ζω ž + ω² z) = −N                            the floor
//! f(u) = c u + (f_C + f_S e^{−|u|/u_S}) tanh(u/u₀)       friction of the guide
//! ```

use std::f64::consts::TAU;
use std::fmt::Write;

use gaitcam::drive::{Drive, DriveKind};
use gaitcam::law::Law;

/// Time step, s, and number of turns before the log begins.
const STEP: f64 = 1e-4;
const SETTLING: usize = 16;
/// Speed over which friction reverses, and over which the play changes sides, m/s.
const REVERSAL: f64 = 2e-3;
const PLAY_REVERSAL: f64 = 0.05;
/// Number of equal parts of the turn at which the true force is known.
pub const PARTS: usize = 360;

/// Random numbers from a seed (SplitMix64; Steele, Lea and Flood 2014).
pub struct Dice(pub u64);

impl Dice {
    /// Number between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Number from the standard normal distribution (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let (a, b) = (self.unit(), self.unit());
        (-2.0 * (1.0 - a).ln()).sqrt() * (TAU * b).cos()
    }
}

/// Sensors and sampling of a log.
#[derive(Debug, Clone, Copy)]
pub struct Sensors {
    /// Sampling rate, 1/s.
    pub rate: f64,
    /// Number of cycles in the log.
    pub cycles: usize,
    /// Standard deviation of the noise of a sample, N.
    pub noise: f64,
    /// Reading of the load cell without force, N.
    pub bias: f64,
    /// Time constant of the load cell's lag, s.
    pub lag: f64,
    /// Pure delay of the load cell, s.
    pub delay: f64,
    /// Whether the log has the cam angle.
    pub has_angle: bool,
    /// Whether the log has the speed.
    pub has_speed: bool,
}

/// Machine with lengths in m, forces in N, times in s.
#[derive(Debug, Clone)]
pub struct Twin {
    /// Drive with its true parameters.
    pub drive: Drive,
    /// Stiffness and damping of the contact; `None`: rigid.
    pub contact: Option<[f64; 2]>,
    /// Guide friction: viscous, Coulomb, Stribeck excess and its speed.
    pub guide: [f64; 4],
    /// Inertia, slope of the motor line, cogging torque and its number of periods per turn; `None`: constant speed.
    pub motor: Option<[f64; 4]>,
    /// Half the play of the guide, as lift.
    pub play: f64,
    /// Floor: mass, natural frequency in rad/s, damping ratio.
    pub floor: Option<[f64; 3]>,
    /// Forces that repeat with the cam angle: harmonic, amplitude, phase.
    pub extra: Vec<(f64, f64, f64)>,
    /// Load cell and log of the machine.
    pub sensors: Sensors,
}

/// Result of a run of a test machine.
pub struct RunOfTwin {
    /// Log of the run as CSV.
    pub log: String,
    /// True force of the last turn at equal parts of its time, N.
    pub force: Vec<f64>,
}

/// State: angle, speed, position, velocity, floor position, floor velocity, reading of the load cell.
type State = [f64; 7];

impl Twin {
    /// Runs the machine with a law.
    pub fn run(&self, law: &Law, dice: &mut Dice) -> RunOfTwin {
        let (period, sensors) = (TAU / self.drive.speed, &self.sensors);
        let mean_torque = self.mean_torque(law);
        let at = law.svaj(0.0);
        let floor = self
            .floor
            .map_or(0.0, |[mass, w, _]| -self.drive.rest_force / (mass * w * w));
        let (w, v) = (self.drive.speed, at.v * self.drive.speed);
        let mut y: State = [0.0, w, at.s + floor, v, floor, 0.0, 0.0];
        y[6] = self.force(law, &y, mean_torque).0;
        let every = 1.0 / sensors.rate;
        let begin = (SETTLING as f64 + dice.unit()) * period;
        let end = begin + sensors.cycles as f64 * period;
        let mut columns = String::from("time_s,force_n");
        columns += if sensors.has_angle { ",theta_rad" } else { "" };
        columns += if sensors.has_speed {
            ",speed_rad_per_s\n"
        } else {
            "\n"
        };
        let (mut next, mut turns) = (begin, Vec::new());
        // True force of the last turns, with its times.
        let kept = end - 3.0 * period;
        for step in 0..(end / STEP) as usize {
            let t = step as f64 * STEP;
            let after = self.step(law, &y, mean_torque);
            while next < t + STEP && next < end {
                let u = (next - t) / STEP;
                let mix = |i: usize| y[i] + u * (after[i] - y[i]);
                let reading = mix(6) + sensors.bias + sensors.noise * dice.normal();
                let time = next - begin + sensors.delay;
                let _ = write!(columns, "{time:.6},{reading:.4}");
                // The cam angle belongs to the time of the row. The reading of the load cell is delayed.
                let theta = mix(0) + sensors.delay * mix(1);
                if sensors.has_angle {
                    let _ = write!(columns, ",{:.6}", theta.rem_euclid(TAU));
                }
                if sensors.has_speed {
                    let _ = write!(columns, ",{:.6}", mix(1));
                }
                columns.push('\n');
                next += every;
            }
            if t > kept {
                turns.push((t, y[0], self.force(law, &y, mean_torque).0));
            }
            y = after;
        }
        RunOfTwin {
            log: columns,
            force: last_turn(&turns),
        }
    }

    /// Force of the cam, acceleration of the mass and of the shaft, velocity of the mass.
    fn force(&self, law: &Law, y: &State, mean_torque: f64) -> (f64, f64, f64, f64) {
        let (d, at) = (&self.drive, law.svaj(y[0]));
        let extra: f64 = self
            .extra
            .iter()
            .map(|(n, a, p)| a * (n * y[0] + p).sin())
            .sum();
        let friction = |u: f64| {
            let [c, coulomb, more, over] = self.guide;
            let side = match self.contact {
                Some(_) => (u / REVERSAL).tanh(),
                None => u.signum(),
            };
            c * u + (coulomb + more * (-u.abs() / over).exp()) * side
        };
        let gravity = if d.kind == DriveKind::MovingAxis {
            d.rest_force
        } else {
            0.0
        };
        let preload = if d.kind == DriveKind::MovingAxis {
            0.0
        } else {
            d.rest_force
        };
        let load = |x: f64, u: f64| {
            gravity + preload + d.spring_rate * x + d.damping * u + friction(u) + extra
        };
        let turn = |force: f64| match self.motor {
            None => 0.0,
            Some([inertia, slope, cogging, number]) => {
                let torque = mean_torque - slope * (y[1] - d.speed);
                (torque + cogging * (number * y[0]).sin() - force * at.v) / inertia
            }
        };
        match self.contact {
            Some([k, c]) => {
                let u = y[1] * at.v;
                let side = (u / PLAY_REVERSAL).tanh();
                let slope = (1.0 - side * side) * y[1] * y[1] * at.a / PLAY_REVERSAL;
                let gap = at.s + self.play * side - y[2] + y[4];
                let rate = u + self.play * slope - y[3] + y[5];
                let force = (k * gap + c * rate).max(0.0);
                let relative = y[3] - y[5];
                (
                    force,
                    (force - load(y[2] - y[4], relative)) / d.mass,
                    turn(force),
                    y[3],
                )
            }
            None => {
                // The force depends on the acceleration of the shaft, and this on the force. Both equations are linear.
                let u = y[1] * at.v;
                let still = load(at.s, u) + d.mass * y[1] * y[1] * at.a;
                let inertia = self.motor.map_or(f64::INFINITY, |m| m[0]);
                let alpha = turn(still) / (1.0 + d.mass * at.v * at.v / inertia);
                let force = still + d.mass * alpha * at.v;
                (force, 0.0, alpha, 0.0)
            }
        }
    }

    fn rate(&self, law: &Law, y: &State, mean_torque: f64) -> State {
        let (force, acceleration, alpha, velocity) = self.force(law, y, mean_torque);
        let floor = self.floor.map_or(0.0, |[mass, w, ratio]| {
            -force / mass - 2.0 * ratio * w * y[5] - w * w * y[4]
        });
        let lag = self.sensors.lag;
        let reading = if lag > 0.0 { (force - y[6]) / lag } else { 0.0 };
        [y[1], alpha, velocity, acceleration, y[5], floor, reading]
    }

    fn step(&self, law: &Law, y: &State, mean_torque: f64) -> State {
        let rate = |y: &State| self.rate(law, y, mean_torque);
        let ahead = |by: f64, k: &State| -> State { std::array::from_fn(|i| y[i] + by * k[i]) };
        let a = rate(y);
        let b = rate(&ahead(0.5 * STEP, &a));
        let c = rate(&ahead(0.5 * STEP, &b));
        let d = rate(&ahead(STEP, &c));
        let mut out: State =
            std::array::from_fn(|i| y[i] + STEP / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        if self.sensors.lag == 0.0 {
            out[6] = self.force(law, &out, mean_torque).0;
        }
        out
    }

    /// Mean torque of the friction.
    fn mean_torque(&self, law: &Law) -> f64 {
        let parts = (0..PARTS).map(|i| {
            let at = law.svaj(TAU * i as f64 / PARTS as f64);
            let u = self.drive.speed * at.v;
            let [c, coulomb, ..] = self.guide;
            ((c + self.drive.damping) * u + coulomb * u.signum()) * at.v
        });
        parts.sum::<f64>() / PARTS as f64
    }
}

/// Force at equal parts of the time of the last complete turn.
fn last_turn(samples: &[(f64, f64, f64)]) -> Vec<f64> {
    let last = samples.last().map_or(0.0, |s| s.1);
    let to = (last / TAU).floor() * TAU;
    let time_at = |angle: f64| {
        let i = samples.partition_point(|s| s.1 < angle).max(1);
        let (a, b) = (samples[i - 1], samples[i]);
        a.0 + (angle - a.1) / (b.1 - a.1) * (b.0 - a.0)
    };
    let (from, until) = (time_at(to - TAU), time_at(to));
    let force_at = |part: usize| {
        let t = from + (until - from) * part as f64 / PARTS as f64;
        let i = samples.partition_point(|s| s.0 < t).max(1);
        let (a, b) = (samples[i - 1], samples[i]);
        a.2 + (t - a.0) / (b.0 - a.0) * (b.2 - a.2)
    };
    (0..PARTS).map(force_at).collect()
}
