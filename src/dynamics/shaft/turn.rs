//! The load of a shaft whose speed varies, over one turn: what Newton's method ([`super::steady`]) and a start from rest need.
//!
//! (J + τ m v) E′ = T_motor(ω) − T_friction − τ (F₀ + k s + c ω v + 2 m a E), with ω = √(2E) and τ the torque of the shaft
//! per unit of contact force (v without friction), by collocation of sixth order in E = ω²/2 over the cam angle (theory §10).

use crate::drive::{Drive, Motor};
use crate::law::Svaj;

/// Newton iterations of a step at most; three are usual.
const ROUNDS: usize = 30;
/// Change of a stage, as part of the energy, at which its iteration ends.
const SAME: f64 = 1e-9;
/// Part of a step before its end: a law may jump there.
const INSIDE: f64 = 1e-12;
/// Stages of a step, their places and weights.
pub const STAGES: usize = 3;
pub const PLACES: [f64; STAGES] = {
    let r = ROOT / 10.0;
    [0.5 - r, 0.5, 0.5 + r]
};
pub const WEIGHTS: [f64; STAGES] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
/// √15
const ROOT: f64 = 3.872_983_346_207_417;

/// Weights of the stages in the stages: the integrals of Lagrange's polynomials (Hairer, Nørsett and Wanner 1993, II.7).
pub const INNER: [[f64; STAGES]; STAGES] = {
    let r = ROOT;
    [
        [5.0 / 36.0, 2.0 / 9.0 - r / 15.0, 5.0 / 36.0 - r / 30.0],
        [5.0 / 36.0 + r / 24.0, 2.0 / 9.0, 5.0 / 36.0 - r / 24.0],
        [5.0 / 36.0 + r / 30.0, 2.0 / 9.0 + r / 15.0, 5.0 / 36.0],
    ]
};

/// The load on the shaft at one angle.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    /// Torque per unit of force where the follower is pressed, and where it is pulled, m.
    arms: [f64; 2],
    /// F₀ + k s, N.
    rest: f64,
    /// c v, N·s/rad.
    damping: f64,
    /// 2 m a, kg·m/rad².
    bend: f64,
    /// m v, kg·m/rad.
    pub mass: f64,
}

impl Node {
    /// The load of a motion under a drive with these arms, and an acceleration of the floor, m/s².
    pub fn new(drive: &Drive, at: Svaj, arms: [f64; 2], floor: f64) -> Node {
        Node {
            arms,
            rest: drive.rest_force + drive.spring_rate * at.s + drive.mass * floor,
            damping: drive.damping * at.v,
            bend: 2.0 * drive.mass * at.a,
            mass: drive.mass * at.v,
        }
    }

    /// Contact force, N, for ω²/2 and its derivative by the angle.
    pub fn force(&self, energy: f64, rate: f64) -> f64 {
        let speed = (2.0 * energy).max(0.0).sqrt();
        self.rest + self.damping * speed + self.bend * energy + self.mass * rate
    }

    /// Derivative of the contact force by ω²/2 at a speed, rad/s.
    pub fn by_energy(&self, speed: f64) -> f64 {
        self.damping / speed + self.bend
    }

    /// Torque of the load, N·m.
    pub fn torque(&self, energy: f64, rate: f64) -> f64 {
        let force = self.force(energy, rate);
        self.arms[usize::from(force < 0.0)] * force
    }

    /// E′, and its derivatives by E and by the no-load speed.
    pub fn rate(&self, motor: &Motor, no_load: f64, energy: f64) -> [f64; 3] {
        let speed = (2.0 * energy).max(f64::MIN_POSITIVE).sqrt();
        let [torque, by_speed, by_supply] = motor.torque(speed, no_load);
        let of = |arm: f64| {
            let inertia = motor.inertia + arm * self.mass;
            let still = self.rest + self.damping * speed + self.bend * energy;
            let rate = (torque - motor.friction - arm * still) / inertia;
            let slope = (by_speed - arm * self.damping) / speed - arm * self.bend;
            [rate, slope / inertia, by_supply / inertia]
        };
        let pressed = of(self.arms[0]);
        if self.arms[0] != self.arms[1] && self.force(energy, pressed[0]) < 0.0 {
            return of(self.arms[1]);
        }
        pressed
    }
}

/// A step of the angle with the loads at its ends, seen from inside, and at its stages.
#[derive(Debug, Clone)]
pub struct Step {
    pub from: f64,
    pub width: f64,
    pub ends: [Node; 2],
    pub nodes: [Node; STAGES],
}

/// The load of a law over one turn.
#[derive(Debug, Clone)]
pub struct Load {
    pub steps: Vec<Step>,
}

impl Load {
    /// The load `at` every angle of a turn from `start` over `length`, smooth between equal angles and breaks.
    pub fn of(
        (start, length): (f64, f64),
        breaks: &[f64],
        equal: usize,
        at: &dyn Fn(f64) -> Node,
    ) -> Load {
        let mut marks: Vec<f64> = (0..=equal)
            .map(|i| start + length * i as f64 / equal as f64)
            .chain(breaks.iter().copied())
            .collect();
        marks.sort_by(f64::total_cmp);
        let least = 1e-9 * length;
        marks.dedup_by(|b, a| *b - *a < least);
        let step = |ends: &[f64]| {
            let (from, width) = (ends[0], ends[1] - ends[0]);
            Step {
                from,
                width,
                ends: [from, from + (1.0 - INSIDE) * width].map(at),
                nodes: PLACES.map(|u| at(from + u * width)),
            }
        };
        let steps: Vec<Step> = marks.windows(2).map(step).collect();
        Load { steps }
    }

    /// Mean over the turn of the torque at a constant speed, N·m, and the integral of the rest of it up to the end of every
    /// step, J.
    pub fn at_constant_speed(&self, speed: f64) -> (f64, Vec<f64>) {
        let energy = 0.5 * speed * speed;
        let (mut work, mut angle) = (0.0, 0.0);
        let mut marks = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            for (node, weight) in step.nodes.iter().zip(WEIGHTS) {
                work += weight * step.width * node.torque(energy, 0.0);
            }
            angle += step.width;
            marks.push((work, angle));
        }
        let mean = work / angle;
        let swings = marks.iter().map(|(work, angle)| work - mean * angle);
        (mean, swings.collect())
    }

    /// The range of a shaft's energy at a constant speed, J.
    pub fn swing(&self, speed: f64) -> f64 {
        let works = self.at_constant_speed(speed).1.into_iter();
        let (low, high) = works.fold((0.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    }

    /// The same load with its steps joined to about this many.
    pub fn every(&self, count: usize) -> Load {
        let at_once = (self.steps.len() / count).max(1);
        if at_once == 1 {
            return self.clone();
        }
        let join = |steps: &[Step]| Step {
            from: steps[0].from,
            width: steps.iter().map(|s| s.width).sum(),
            ends: [steps[0].ends[0], steps[steps.len() - 1].ends[1]],
            nodes: PLACES.map(|u| steps[(u * steps.len() as f64) as usize].nodes[1]),
        };
        Load {
            steps: self.steps.chunks(at_once).map(join).collect(),
        }
    }

    /// The angle at which the shaft stops, rad, where it does not pass its first turn, from rest at the step nearest to
    /// `angle`.
    pub fn stop_from_rest(&self, motor: &Motor, no_load: f64, angle: f64) -> Option<f64> {
        let middle = |s: &Step| s.from + 0.5 * s.width;
        let begin = self.steps.partition_point(|s| middle(s) < angle) % self.steps.len().max(1);
        let turn = self.steps[begin..].iter().chain(&self.steps[..begin]);
        let (mut energy, mut rate) = (0.0, 0.0);
        for step in turn {
            let Some(next) = end_of(step, motor, no_load, energy, rate) else {
                return Some(step.from);
            };
            (energy, rate) = next;
        }
        None
    }
}

/// Energy at the end of a step and the rate at its last stage; nothing where the shaft stops in it.
fn end_of(
    step: &Step,
    motor: &Motor,
    no_load: f64,
    energy: f64,
    before: f64,
) -> Option<(f64, f64)> {
    let h = step.width;
    let mut stages = PLACES.map(|part| energy + part * h * before);
    if energy == 0.0 {
        // From rest the shaft moves if the motor starts it.
        let start = step.nodes[0].rate(motor, no_load, 0.0)[0];
        stages = PLACES.map(|part| part * h * start);
    }
    for _ in 0..ROUNDS {
        if stages.iter().any(|e| e.is_nan() || *e <= 0.0) {
            return None;
        }
        let rates: [[f64; 3]; STAGES] =
            std::array::from_fn(|k| step.nodes[k].rate(motor, no_load, stages[k]));
        let residual = std::array::from_fn(|i| {
            let sum: f64 = (0..STAGES).map(|k| INNER[i][k] * rates[k][0]).sum();
            energy + h * sum - stages[i]
        });
        let change = Inverse::of(h, &rates).times(residual);
        let mut largest = 0.0_f64;
        for (stage, d) in stages.iter_mut().zip(change) {
            largest = largest.max(d.abs() / *stage);
            *stage += d.max(-0.9 * *stage);
        }
        if largest < SAME {
            let gain: f64 = (0..STAGES).map(|k| WEIGHTS[k] * rates[k][0]).sum();
            let end = energy + h * gain;
            return (end > 0.0).then_some((end, rates[STAGES - 1][0]));
        }
    }
    None
}

/// (I − h A D)⁻¹, D the derivatives of the rates by the energy.
pub struct Inverse([[f64; STAGES]; STAGES]);

impl Inverse {
    pub fn of(h: f64, rates: &[[f64; 3]; STAGES]) -> Inverse {
        let unit = |i: usize, k: usize| f64::from(u8::from(i == k));
        let m: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|k| unit(i, k) - h * INNER[i][k] * rates[k][1])
        });
        // Cofactors, in cyclic order.
        let minor = |i: usize, k: usize| {
            let ([a, b], [c, d]) = ([(i + 1) % 3, (i + 2) % 3], [(k + 1) % 3, (k + 2) % 3]);
            m[a][c] * m[b][d] - m[a][d] * m[b][c]
        };
        let determinant = (0..3).map(|k| m[0][k] * minor(0, k)).sum::<f64>();
        Inverse(std::array::from_fn(|i| {
            std::array::from_fn(|k| minor(k, i) / determinant)
        }))
    }

    pub fn times(&self, x: [f64; STAGES]) -> [f64; STAGES] {
        self.0
            .map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
    }
}
