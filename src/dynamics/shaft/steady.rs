//! Periodic motion of a motor-driven shaft over one turn. The unknowns are the energies at all stages and the no-load speed. Newton's
//! method computes them. After linearisation about the previous energies, the energy at the end of each step is α + β E₀ + γ δω₀. Here E₀
//! is the energy at the start of the turn and δω₀ the change of the no-load speed. Two conditions determine E₀ and δω₀: the motion is
//! periodic, and the turn takes the period of the mean speed. Each iteration evaluates the load once per stage (theory §10).

use std::f64::consts::TAU;

use super::turn::{INNER, Inverse, Load, PLACES, STAGES, WEIGHTS};
use crate::drive::Motor;

/// Maximum number of iterations. Five are usual, or two if the initial guess is a similar motion.
const SWEEPS: usize = 30;
/// Relative change of the energies below which the iteration stops. Convergence is quadratic.
const SAME: f64 = 1e-6;
/// Minimum ratio of an energy to its previous value in one iteration.
const LEAST_PART: f64 = 0.3;
/// Number of steps of a turn for initial guesses and for minimum inertias.
const COARSE: usize = 48;
/// Initial factor between consecutive inertias of the continuation.
const FACTOR: f64 = 100.0;
const LEAST_FACTOR: f64 = 1.01;
const RANGE: f64 = 1e4;
/// Exponent of the decay of a disturbance over one step. A step with a larger exponent does not resolve the decay.
const UNRESOLVED: f64 = 5.0;
/// Minimum energy, relative to the energy at the mean speed. It corresponds to a hundredth of the mean speed. At lower energies, motor and
/// load are in an unstable equilibrium.
const LEAST_ENERGY: f64 = 1e-4;
/// Speed ripple for which the first inertia of the continuation is chosen. The speed is then nearly constant.
const EVEN: f64 = 0.1;

/// Periodic motion of a motor-driven shaft over one turn.
#[derive(Debug, Clone)]
pub struct Steady {
    /// Energy ω²/2 at the stages of the steps, rad²/s².
    stages: Vec<[f64; STAGES]>,
    /// No-load speed of the motor, referred to the camshaft, rad/s.
    pub no_load: f64,
    /// Energy ω²/2 at the start of every step, and at the end of the turn, rad²/s².
    pub energy: Vec<f64>,
    /// Time at the start of every step, and at the end of the turn, s.
    pub time: Vec<f64>,
    /// Work of the motor torque at the camshaft over a turn, J.
    pub motor_work: f64,
    /// Integral of the squared motor torque over time, (N·m)²·s.
    pub motor_square: f64,
    /// Work of the load torque over a turn, J.
    pub load_work: f64,
    /// Minimum and maximum energy ω²/2, rad²/s².
    pub range: [f64; 2],
}

/// Reasons why a shaft stops.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stall {
    /// The inertia is below the minimum inertia. The field is this minimum, kg·m².
    Below(f64),
    /// The shaft stops for any inertia.
    Anyway,
}

impl Steady {
    /// Computes the periodic motion of a motor and its load at a given mean speed, rad/s. `near` is an optional initial guess.
    pub fn find(
        load: &Load,
        motor: &Motor,
        speed: f64,
        near: Option<&Steady>,
    ) -> Result<Steady, Stall> {
        let coarse = load.every(COARSE);
        if near.is_none() && load.steps.len() > coarse.steps.len() {
            let first = Steady::find(&coarse, motor, speed, None)?;
            return Steady::find(load, motor, speed, Some(&first));
        }
        let start = near.map(|n| (n.at_stages_of(load), n.no_load));
        let from = |(stages, no_load)| newton(load, motor, speed, stages, no_load);
        if let Some(turn) = start
            .and_then(from)
            .or_else(|| from(even(load, motor, speed)))
        {
            return Ok(turn);
        }
        let scale = coarse.swing(speed) / (EVEN * speed * speed);
        let large = scale.max(FACTOR * motor.inertia);
        let wheel = with_inertia(motor, large);
        let (stages, no_load) = even(&coarse, &wheel, speed);
        let first = newton(&coarse, &wheel, speed, stages, no_load).ok_or(Stall::Anyway)?;
        let (least, turn) = smaller(&coarse, motor, speed, (large, first), motor.inertia);
        if least > motor.inertia {
            return Err(Stall::Below(least));
        }
        let stages = turn.at_stages_of(load);
        newton(load, motor, speed, stages, turn.no_load).ok_or(Stall::Below(least * LEAST_FACTOR))
    }

    /// Minimum inertia, kg·m², with an accuracy of 1 %, for which this shaft does not stop; 0 if any inertia is sufficient.
    pub fn least_inertia(&self, load: &Load, motor: &Motor, speed: f64) -> f64 {
        let goal = motor.inertia / RANGE;
        let coarse = load.every(COARSE);
        let start = newton(
            &coarse,
            motor,
            speed,
            self.at_stages_of(&coarse),
            self.no_load,
        );
        let Some(start) = start else {
            return motor.inertia;
        };
        let (least, _) = smaller(&coarse, motor, speed, (motor.inertia, start), goal);
        if least > goal { least } else { 0.0 }
    }

    /// Derivative E′ of the energy at the start (0) or the end (1) of a step, evaluated inside the step. If the time constant of the motor
    /// is a small fraction of the step, the energy at the ends oscillates. In this case, E′ is extrapolated from the stages.
    pub fn rate_at_end(&self, load: &Load, motor: &Motor, step: usize, end: usize) -> f64 {
        let (own, energy) = (&load.steps[step], self.energy[step + end]);
        let [rate, by_energy, _] = own.ends[end].rate(motor, self.no_load, energy);
        if (own.width * by_energy).abs() < UNRESOLVED {
            return rate;
        }
        let rates: [f64; STAGES] = std::array::from_fn(|k| {
            own.nodes[k].rate(motor, self.no_load, self.stages[step][k])[0]
        });
        // Lagrange's polynomial through the stages.
        let factor = |k: usize| {
            let others = (0..STAGES).filter(|i| *i != k);
            let terms = others.map(|i| (end as f64 - PLACES[i]) / (PLACES[k] - PLACES[i]));
            terms.product::<f64>()
        };
        (0..STAGES).map(|k| factor(k) * rates[k]).sum()
    }

    /// Energies at the stages of `load`, as an initial guess. The steps of `load` may differ from the steps of this motion.
    fn at_stages_of(&self, load: &Load) -> Vec<[f64; STAGES]> {
        let (own, other) = (self.stages.len(), load.steps.len());
        if own == other {
            return self.stages.clone();
        }
        // Treats all steps as equal, which is accurate enough for an initial guess.
        let at = |i: usize, k: usize| {
            let x = (i as f64 + PLACES[k]) * own as f64 / other as f64;
            let j = (x as usize).min(own - 1);
            self.energy[j] + (x - j as f64) * (self.energy[j + 1] - self.energy[j])
        };
        let stages = |i: usize| std::array::from_fn(|k| at(i, k));
        (0..other).map(stages).collect()
    }
}

pub fn with_inertia(motor: &Motor, inertia: f64) -> Motor {
    Motor {
        inertia,
        ..motor.clone()
    }
}

/// Initial guess with constant speed: energies at the stages, rad²/s², and no-load speed, rad/s.
fn even(load: &Load, motor: &Motor, speed: f64) -> (Vec<[f64; STAGES]>, f64) {
    let mean = load.at_constant_speed(speed).0;
    let no_load = motor.no_load_for(speed, mean + motor.friction);
    (
        vec![[0.5 * speed * speed; STAGES]; load.steps.len()],
        no_load,
    )
}

/// Forecast of the speed range, relative to the mean speed, and of the RMS change of the force over time, relative to the mean force. Both
/// are linearised in the change of speed, as after the first Newton step from the constant speed `speed`, rad/s. The RMS change is
/// minimised over the phase.
pub fn forecast(load: &Load, motor: &Motor, speed: f64) -> (f64, f64) {
    let (stages, no_load) = even(load, motor, speed);
    let mut lines = vec![[[0.0; STAGES]; 3]; stages.len()];
    let level = 0.5 * speed * speed;
    let found = sweep(load, motor, speed, &stages, no_load, &mut lines);
    let (first, supply) = found.unwrap_or((f64::NAN, f64::NAN));
    let (mut low, mut high, mut sum) = (0.0_f64, 0.0_f64, 0.0);
    // Sums of squares and products of the change and of the slope of the force.
    let (mut square, mut product, mut steepness) = (0.0, 0.0, 0.0);
    // Lead of the shaft over a shaft with constant speed, rad.
    let mut ahead = 0.0;
    for (step, line) in load.steps.iter().zip(&lines) {
        let changes: [f64; STAGES] =
            std::array::from_fn(|k| line[0][k] + line[1][k] * first + line[2][k] * supply - level);
        let slopes = step.slopes(|node| node.force(level, 0.0));
        let along = |weights: &[f64; STAGES]| -> f64 {
            let sum: f64 = weights.iter().zip(&changes).map(|(w, c)| w * c).sum();
            step.width * sum / (2.0 * level)
        };
        for (k, node) in step.nodes.iter().enumerate() {
            let change = changes[k];
            let [rate, by_energy, by_supply] = node.rate(motor, no_load, level);
            let rate = rate + by_energy * change + by_supply * supply;
            let at_angle = node.by_energy(speed) * change + node.mass * rate;
            let in_time = at_angle + slopes[k] * (ahead + along(&INNER[k]));
            let w = step.width * WEIGHTS[k];
            square += w * in_time * in_time;
            product += w * in_time * slopes[k];
            steepness += w * slopes[k] * slopes[k];
            sum += w * node.force(level, 0.0);
            (low, high) = (low.min(change), high.max(change));
        }
        ahead += along(&WEIGHTS);
    }
    if steepness > 0.0 {
        square = (square - product * product / steepness).max(0.0);
    }
    let rms = (TAU * square).sqrt() / sum.abs();
    (0.5 * (high - low) / level, rms)
}

/// Extremes of the energy within a step, computed from the derivatives at its stages.
fn extremes(start: f64, width: f64, rates: [f64; STAGES]) -> impl Iterator<Item = f64> {
    // E′ = a + b x + c x² with x measured from the middle of the step, as a fraction of the step.
    let side = PLACES[2] - PLACES[1];
    let [a, b, c] = [
        rates[1],
        (rates[2] - rates[0]) / (2.0 * side),
        (rates[2] - 2.0 * rates[1] + rates[0]) / (2.0 * side * side),
    ];
    let q = -0.5 * (b + b.signum() * (b * b - 4.0 * a * c).sqrt());
    let inside = [q / c, a / q].into_iter().filter(|x| x.abs() <= 0.5);
    inside.map(move |x| {
        let quadratic = 0.5 * b * (x * x - 0.25);
        start + width * (a * (x + 0.5) + quadratic + c / 3.0 * (x.powi(3) + 0.125))
    })
}

/// Decreases the inertia from a feasible value towards `goal`. Each motion is the initial guess for the next, smaller inertia. Returns the
/// smallest inertia for which a motion was computed, and this motion.
fn smaller(
    load: &Load,
    motor: &Motor,
    speed: f64,
    (mut inertia, mut turn): (f64, Steady),
    goal: f64,
) -> (f64, Steady) {
    let mut factor = FACTOR;
    while inertia > goal && factor > LEAST_FACTOR {
        let next = (inertia / factor).max(goal);
        let wheel = with_inertia(motor, next);
        match newton(load, &wheel, speed, turn.stages.clone(), turn.no_load) {
            Some(found) => (inertia, turn) = (next, found),
            None => factor = factor.sqrt(),
        }
    }
    (inertia, turn)
}

/// Newton's method from given energies at the stages and a given no-load speed; `None` if it does not converge.
fn newton(
    load: &Load,
    motor: &Motor,
    speed: f64,
    mut stages: Vec<[f64; STAGES]>,
    mut no_load: f64,
) -> Option<Steady> {
    let mut lines = vec![[[0.0; STAGES]; 3]; stages.len()];
    for _ in 0..SWEEPS {
        let (first, supply) = sweep(load, motor, speed, &stages, no_load, &mut lines)?;
        let next = |line: &[[f64; STAGES]; 3], k: usize| {
            line[0][k] + line[1][k] * first + line[2][k] * supply
        };
        let (mut change, mut part) = (0.0_f64, 1.0_f64);
        for (stage, line) in stages.iter().zip(&lines) {
            for (k, own) in stage.iter().enumerate() {
                let d = next(line, k) - own;
                change = change.max(d.abs() / own);
                if d < (LEAST_PART - 1.0) * own {
                    part = part.min((LEAST_PART - 1.0) * own / d);
                }
            }
        }
        if !change.is_finite() {
            return None;
        }
        part = part.min(0.5 * no_load / supply.abs());
        for (stage, line) in stages.iter_mut().zip(&lines) {
            for (k, own) in stage.iter_mut().enumerate() {
                *own += part * (next(line, k) - *own);
            }
        }
        no_load += part * supply;
        if change < SAME {
            return evaluated(load, motor, stages, no_load, first);
        }
    }
    None
}

/// Solves the linearised problem for the energy at the start of the turn and the change of the no-load speed. `lines` receives the energies
/// at the stages as affine functions of these two unknowns.
fn sweep(
    load: &Load,
    motor: &Motor,
    speed: f64,
    stages: &[[f64; STAGES]],
    no_load: f64,
    lines: &mut [[[f64; STAGES]; 3]],
) -> Option<(f64, f64)> {
    let mut energy = [0.0, 1.0, 0.0];
    let mut time = [0.0; 3];
    for ((step, own), line) in load.steps.iter().zip(stages).zip(lines) {
        let h = step.width;
        let rates: [[f64; 3]; STAGES] =
            std::array::from_fn(|k| step.nodes[k].rate(motor, no_load, own[k]));
        let inverse = Inverse::of(h, &rates);
        let sum = |i: usize, of: &dyn Fn(usize) -> f64| {
            h * (INNER[i][0] * of(0) + INNER[i][1] * of(1) + INNER[i][2] * of(2))
        };
        let still = |k: usize| rates[k][0] - rates[k][1] * own[k];
        *line = [
            inverse.times(std::array::from_fn(|i| energy[0] + sum(i, &still))),
            inverse.times([energy[1]; 3]),
            inverse.times(std::array::from_fn(|i| {
                energy[2] + sum(i, &|k| rates[k][2])
            })),
        ];
        for k in 0..STAGES {
            let w = h * WEIGHTS[k];
            let v = (2.0 * own[k]).sqrt();
            let slowing = w / (v * v * v);
            energy[0] += w * (still(k) + rates[k][1] * line[0][k]);
            energy[1] += w * rates[k][1] * line[1][k];
            energy[2] += w * (rates[k][1] * line[2][k] + rates[k][2]);
            time[0] += w / v - slowing * (line[0][k] - own[k]);
            time[1] -= slowing * line[1][k];
            time[2] -= slowing * line[2][k];
        }
    }
    let ([a, b], [c, d]) = ([energy[1] - 1.0, energy[2]], [time[1], time[2]]);
    let (e, f) = (-energy[0], TAU / speed - time[0]);
    let determinant = a * d - b * c;
    let found = ((e * d - b * f) / determinant, (a * f - e * c) / determinant);
    (found.0.is_finite() && found.1.is_finite()).then_some(found)
}

/// Computes all values of the motion that has the given energies at its stages.
fn evaluated(
    load: &Load,
    motor: &Motor,
    stages: Vec<[f64; STAGES]>,
    no_load: f64,
    first: f64,
) -> Option<Steady> {
    let mut out = Steady {
        energy: Vec::with_capacity(stages.len() + 1),
        time: Vec::with_capacity(stages.len() + 1),
        stages: Vec::new(),
        no_load,
        motor_work: 0.0,
        motor_square: 0.0,
        load_work: 0.0,
        range: [first, first],
    };
    let (mut energy, mut time) = (first, 0.0);
    for (step, own) in load.steps.iter().zip(&stages) {
        out.energy.push(energy);
        out.time.push(time);
        let rates: [f64; STAGES] =
            std::array::from_fn(|k| step.nodes[k].rate(motor, no_load, own[k])[0]);
        for extreme in extremes(energy, step.width, rates).filter(|e| *e > 0.0) {
            out.range = [out.range[0].min(extreme), out.range[1].max(extreme)];
        }
        for (k, rate) in rates.into_iter().enumerate() {
            let (w, speed) = (step.width * WEIGHTS[k], (2.0 * own[k]).sqrt());
            energy += w * rate;
            time += w / speed;
            let torque = motor.torque(speed, no_load)[0];
            out.motor_work += w * torque;
            out.motor_square += w * torque * torque / speed;
            out.load_work += w * step.nodes[k].torque(own[k], rate);
            out.range = [out.range[0].min(own[k]), out.range[1].max(own[k])];
        }
        out.range = [out.range[0].min(energy), out.range[1].max(energy)];
    }
    out.energy.push(energy);
    out.time.push(time);
    out.stages = stages;
    let mean = 0.5 * (TAU / time).powi(2);
    (out.range[0] > LEAST_ENERGY * mean).then_some(out)
}
