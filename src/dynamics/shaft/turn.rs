//! One turn of a shaft whose speed varies: collocation of sixth order in E = ω²/2 over the cam angle.
//!
//! (J + τ m v) E′ = T_motor(ω) − T_friction − τ (F₀ + k s + c ω v + 2 m a E), with ω = √(2E) and τ the torque of the shaft
//! per unit of contact force (v without friction). Time is ∫ dθ/ω. The stages of a step are found by Newton's method, and
//! their derivatives by the first energy and by the no-load speed go with them (theory §10).

use nalgebra::{Matrix3, Vector3};

use crate::drive::{Drive, Motor};
use crate::law::{Law, Svaj};
use crate::poly::gauss_legendre;

/// Newton iterations of a step at most; three are usual.
const ROUNDS: usize = 30;
/// Change of a stage, as part of the energy, at which its iteration ends.
const SAME: f64 = 1e-11;
/// Stages of a step.
const STAGES: usize = 3;

/// Weights of the stages in the stages: the integrals of Lagrange's polynomials (Hairer, Nørsett and Wanner 1993, II.7).
const INNER: [[f64; STAGES]; STAGES] = {
    let r = 3.872_983_346_207_417; // √15
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
    mass: f64,
}

impl Node {
    /// The load of a motion under a drive with these arms.
    pub fn new(drive: &Drive, at: Svaj, arms: [f64; 2]) -> Node {
        Node {
            arms,
            rest: drive.rest_force + drive.spring_rate * at.s,
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

/// A step of the angle with the loads at its stages.
#[derive(Debug, Clone)]
struct Step {
    from: f64,
    width: f64,
    nodes: [Node; STAGES],
}

/// The load of a law over one turn.
#[derive(Debug, Clone)]
pub struct Load {
    steps: Vec<Step>,
    /// Steps that begin at the equal angles.
    rows: Vec<usize>,
}

impl Load {
    /// Steps between equal angles and the breaks of the law; `arms` gives the torque per unit of force.
    pub fn new(law: &Law, drive: &Drive, equal: usize, arms: &dyn Fn(Svaj) -> [f64; 2]) -> Load {
        Load::of(law.extent(), law.breaks(), equal, &|theta| {
            let at = law.svaj(theta);
            Node::new(drive, at, arms(at))
        })
    }

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
        let places = gauss_legendre(STAGES);
        let step = |ends: &[f64]| {
            let (from, width) = (ends[0], ends[1] - ends[0]);
            let nodes = [0, 1, 2].map(|k| at(from + places[k].0 * width));
            Step { from, width, nodes }
        };
        let steps: Vec<Step> = marks.windows(2).map(step).collect();
        let row = |i: usize| {
            let angle = start + length * i as f64 / equal as f64;
            steps.partition_point(|s| s.from < angle - least)
        };
        let rows = (0..equal).map(row).collect();
        Load { steps, rows }
    }

    /// Mean over the turn of the torque at a constant speed, N·m, and the range of its integral about it, J.
    pub fn at_constant_speed(&self, speed: f64) -> (f64, f64) {
        let energy = 0.5 * speed * speed;
        let rule = gauss_legendre(STAGES);
        let (mut work, mut angle) = (0.0, 0.0);
        let mut marks = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            for (node, (_, weight)) in step.nodes.iter().zip(&rule) {
                let force = node.force(energy, 0.0);
                let arm = node.arms[usize::from(force < 0.0)];
                work += weight * step.width * arm * force;
            }
            angle += step.width;
            marks.push((work, angle));
        }
        let mean = work / angle;
        let swings = marks.iter().map(|(work, angle)| work - mean * angle);
        let (low, high) = swings.fold((0.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        (mean, high - low)
    }

    /// One turn from an energy; the angle at which the shaft stops where it does.
    pub fn turn(&self, motor: &Motor, no_load: f64, first: f64) -> Result<Turn, f64> {
        let mut turn = Turn {
            energy: Vec::with_capacity(self.steps.len() + 1),
            time: Vec::with_capacity(self.steps.len() + 1),
            by_first: [1.0, 0.0],
            by_supply: [0.0, 0.0],
            motor_work: 0.0,
            motor_square: 0.0,
            load_work: 0.0,
            range: [first, first],
            motor_peak: 0.0,
        };
        turn.energy.push(first);
        turn.time.push(0.0);
        let mut rate = 0.0;
        for step in &self.steps {
            rate = turn.advance(step, motor, no_load, rate).ok_or(step.from)?;
        }
        Ok(turn)
    }

    /// Energy, rad²/s², and time, s, of a turn at the equal angles.
    pub fn at_rows(&self, turn: &Turn) -> (Vec<f64>, Vec<f64>) {
        let of = |values: &[f64]| self.rows.iter().map(|&i| values[i]).collect();
        (of(&turn.energy), of(&turn.time))
    }

    /// Number of its steps.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// The same load with its steps joined to about this many.
    pub fn every(&self, count: usize) -> Load {
        let at_once = (self.steps.len() / count).max(1);
        let join = |steps: &[Step]| Step {
            from: steps[0].from,
            width: steps.iter().map(|s| s.width).sum(),
            nodes: [0.1127, 0.5, 0.8873].map(|u| steps[(u * steps.len() as f64) as usize].nodes[1]),
        };
        Load {
            steps: self.steps.chunks(at_once).map(join).collect(),
            rows: Vec::new(),
        }
    }

    /// The same turn begun at the step nearest to an angle.
    pub fn begun_at(&self, angle: f64) -> Load {
        let first = self
            .steps
            .partition_point(|s| s.from + 0.5 * s.width < angle);
        let mut steps = self.steps.clone();
        let count = steps.len().max(1);
        steps.rotate_left(first % count);
        Load {
            steps,
            rows: Vec::new(),
        }
    }
}

/// A turn of the shaft.
#[derive(Debug, Clone)]
pub struct Turn {
    /// ω²/2 at the ends of the steps, rad²/s².
    pub energy: Vec<f64>,
    /// Time there, s.
    pub time: Vec<f64>,
    /// Derivatives of the last energy and the last time by the first energy.
    pub by_first: [f64; 2],
    /// The same by the no-load speed.
    pub by_supply: [f64; 2],
    /// ∮ of the motor's torque at the camshaft, J.
    pub motor_work: f64,
    /// ∫ of its square over time, (N·m)²·s.
    pub motor_square: f64,
    /// ∮ of the load's torque, J.
    pub load_work: f64,
    /// Smallest and largest energy at ends and stages.
    pub range: [f64; 2],
    /// Largest absolute torque of the motor at the camshaft, N·m.
    pub motor_peak: f64,
}

impl Turn {
    /// One step; the rate at its last stage, or nothing where the shaft stops.
    fn advance(&mut self, step: &Step, motor: &Motor, no_load: f64, before: f64) -> Option<f64> {
        let first = *self.energy.last()?;
        let h = step.width;
        let mut stages = [0.1127, 0.5, 0.8873].map(|part| first + part * h * before);
        if first == 0.0 {
            // From rest the shaft moves if the motor starts it.
            let start = step.nodes[0].rate(motor, no_load, 0.0)[0];
            stages = [0.1, 0.5, 0.9].map(|part| part * h * start);
        }
        let mut rates = [[0.0; 3]; STAGES];
        for round in 0..=ROUNDS {
            if stages.iter().any(|e| e.is_nan() || *e <= 0.0) || round == ROUNDS {
                return None;
            }
            for (k, rate) in rates.iter_mut().enumerate() {
                *rate = step.nodes[k].rate(motor, no_load, stages[k]);
            }
            let residual = |i: usize| {
                let sum: f64 = (0..STAGES).map(|k| INNER[i][k] * rates[k][0]).sum();
                first + h * sum - stages[i]
            };
            let change = inverse(h, &rates) * Vector3::new(residual(0), residual(1), residual(2));
            let mut largest = 0.0_f64;
            for (stage, d) in stages.iter_mut().zip(change.iter()) {
                largest = largest.max(d.abs() / *stage);
                *stage += d.max(-0.9 * *stage);
            }
            if largest < SAME {
                break;
            }
        }
        self.close(step, motor, no_load, &stages, &rates);
        (*self.energy.last()? > 0.0).then_some(rates[STAGES - 1][0])
    }

    /// The end of a step from its stages.
    fn close(
        &mut self,
        step: &Step,
        motor: &Motor,
        no_load: f64,
        stages: &[f64; 3],
        rates: &[[f64; 3]; 3],
    ) {
        let (h, rule) = (step.width, gauss_weights());
        let inverse = inverse(h, rates);
        let by_first = inverse * Vector3::repeat(self.by_first[0]);
        let inner = |i: usize| (0..STAGES).map(|k| INNER[i][k] * rates[k][2]).sum::<f64>();
        let by_supply = inverse * Vector3::from_fn(|i, _| self.by_supply[0] + h * inner(i));
        let (mut energy, mut time) = (
            self.energy[self.energy.len() - 1],
            self.time[self.time.len() - 1],
        );
        for k in 0..STAGES {
            let (w, speed) = (h * rule[k], (2.0 * stages[k]).sqrt());
            energy += w * rates[k][0];
            time += w / speed;
            let slowing = -w / (speed * speed * speed);
            self.by_first[0] += w * rates[k][1] * by_first[k];
            self.by_first[1] += slowing * by_first[k];
            self.by_supply[0] += w * (rates[k][1] * by_supply[k] + rates[k][2]);
            self.by_supply[1] += slowing * by_supply[k];
            let torque = motor.torque(speed, no_load)[0];
            self.motor_work += w * torque;
            self.motor_square += w * torque * torque / speed;
            self.motor_peak = self.motor_peak.max(torque.abs());
            let force = step.nodes[k].force(stages[k], rates[k][0]);
            self.load_work += w * step.nodes[k].arms[usize::from(force < 0.0)] * force;
            self.range = [self.range[0].min(stages[k]), self.range[1].max(stages[k])];
        }
        self.range = [self.range[0].min(energy), self.range[1].max(energy)];
        self.energy.push(energy);
        self.time.push(time);
    }
}

/// Weights of the stages.
const fn gauss_weights() -> [f64; STAGES] {
    [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0]
}

/// (I − h A D)⁻¹, D the derivatives of the rates by the energy, by cofactors; the unit matrix where there is none.
fn inverse(h: f64, rates: &[[f64; 3]; STAGES]) -> Matrix3<f64> {
    let unit = |i: usize, k: usize| f64::from(u8::from(i == k));
    let matrix = Matrix3::from_fn(|i, k| unit(i, k) - h * INNER[i][k] * rates[k][1]);
    matrix.try_inverse().unwrap_or_else(Matrix3::identity)
}
