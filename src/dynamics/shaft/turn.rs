//! Load over one turn of a shaft with varying speed, for Newton's method ([`super::steady`]) and for a start from rest.
//!
//! The energy E = ω²/2 obeys (J + τ m v) E′ = T_motor(ω) − T_friction − τ (F₀ + k s + c ω v + 2 m a E). Here J is the inertia, and τ is the
//! shaft torque per unit of contact force (v without friction). The numerical method is collocation of sixth order in E over the cam angle
//! (theory §10).

use std::f64::consts::TAU;

use crate::drive::{Drive, Motor};
use crate::law::Svaj;

/// Number of steps of a start from rest.
const SMALL_STEPS: usize = 2048;
/// Maximum number of Newton iterations per step of a start from rest; three are usual.
const ROUNDS: usize = 60;
const SAME: f64 = 1e-9;
/// Distance from the end of a step, as a fraction of the step. Quantities that may jump at this end are evaluated at this distance inside
/// the step.
const INSIDE: f64 = 1e-12;
/// Number of stages of a step.
pub const STAGES: usize = 3;
pub const PLACES: [f64; STAGES] = {
    let r = ROOT / 10.0;
    [0.5 - r, 0.5, 0.5 + r]
};
/// Positions of the stages and ends of a step, as fractions of the step.
const ALL_PLACES: [f64; 5] = [0.0, PLACES[0], PLACES[1], PLACES[2], 1.0];
pub const WEIGHTS: [f64; STAGES] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
/// Value of √15 for the three Gauss points of a step.
const ROOT: f64 = 3.872_983_346_207_417;

/// Coefficient matrix of the stages: integrals of the Lagrange polynomials (Hairer, Nørsett and Wanner 1993, II.7).
pub const INNER: [[f64; STAGES]; STAGES] = {
    let r = ROOT;
    [
        [5.0 / 36.0, 2.0 / 9.0 - r / 15.0, 5.0 / 36.0 - r / 30.0],
        [5.0 / 36.0 + r / 24.0, 2.0 / 9.0, 5.0 / 36.0 - r / 24.0],
        [5.0 / 36.0 + r / 30.0, 2.0 / 9.0 + r / 15.0, 5.0 / 36.0],
    ]
};

/// Coefficients of the load on the shaft at one cam angle.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    /// Torque per unit of positive and of negative contact force, m.
    arms: [f64; 2],
    /// Static force F₀ + k s, N.
    rest: f64,
    /// Coefficient c v of the speed ω in the contact force, N·s/rad.
    damping: f64,
    /// Coefficient 2 m a of the energy E in the contact force, kg·m/rad².
    bend: f64,
    /// Coefficient m v of E′ in the contact force, kg·m/rad.
    pub mass: f64,
}

impl Node {
    /// Coefficients of the load for the follower motion `at`. `arms`: torque per unit of positive and of negative contact force, m.
    /// `floor`: acceleration of the floor, m/s².
    pub fn new(drive: &Drive, at: Svaj, arms: [f64; 2], floor: f64) -> Node {
        Node {
            arms,
            rest: drive.rest_force + drive.spring_rate * at.s + drive.mass * floor,
            damping: drive.damping * at.v,
            bend: 2.0 * drive.mass * at.a,
            mass: drive.mass * at.v,
        }
    }

    /// Contact force, N, for the energy ω²/2 and for the derivative of this energy with respect to the angle.
    pub fn force(&self, energy: f64, rate: f64) -> f64 {
        let speed = (2.0 * energy).max(0.0).sqrt();
        self.rest + self.damping * speed + self.bend * energy + self.mass * rate
    }

    /// Derivative of the contact force with respect to ω²/2 at a shaft speed, rad/s.
    pub fn by_energy(&self, speed: f64) -> f64 {
        self.damping / speed + self.bend
    }

    /// Torque of the load, N·m, for the energy ω²/2 and for the derivative of this energy with respect to the angle.
    pub fn torque(&self, energy: f64, rate: f64) -> f64 {
        let force = self.force(energy, rate);
        self.arms[usize::from(force < 0.0)] * force
    }

    /// Derivative E′ of the energy, and the derivatives of E′ with respect to E and to the no-load speed.
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

/// Step of the cam angle, with the load at its stages and its ends. The load at the ends is evaluated inside the step.
#[derive(Debug, Clone)]
pub struct Step {
    pub from: f64,
    pub width: f64,
    pub ends: [Node; 2],
    pub nodes: [Node; STAGES],
}

impl Step {
    /// Load coefficients at the positions [`ALL_PLACES`] of the step.
    fn all(&self) -> [Node; 5] {
        let [p, q, r] = self.nodes;
        [self.ends[0], p, q, r, self.ends[1]]
    }

    /// Derivatives with respect to the angle, at the stages, of the polynomial through the values at all nodes.
    pub fn slopes(&self, value: impl Fn(&Node) -> f64) -> [f64; STAGES] {
        let values = self.all().map(|node| value(&node));
        std::array::from_fn(|stage| {
            let at = stage + 1;
            let apart = |i: usize, k: usize| ALL_PLACES[i] - ALL_PLACES[k];
            let others = |i: usize| (0..5).filter(move |k| *k != i && *k != at);
            // Lagrange polynomials through the differences from the value at the stage, because a constant has no slope.
            let term = |i: usize| {
                let by_others: f64 = others(i).map(|k| apart(at, k) / apart(i, k)).product();
                by_others * (values[i] - values[at]) / apart(i, at)
            };
            let sum: f64 = (0..5).filter(|i| *i != at).map(term).sum();
            sum / self.width
        })
    }
}

/// Load of a law over one turn.
#[derive(Debug, Clone)]
pub struct Load {
    pub steps: Vec<Step>,
}

impl Load {
    /// Load over a turn from the angle `start`, rad, of length `length`, rad. The steps end at `equal` equally spaced angles and at
    /// `breaks`. `at` is the load at an angle, smooth within each step.
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

    /// Mean torque over the turn at a constant speed, N·m. The second value is the work of the deviation from this mean up to the end of
    /// each step, J.
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

    /// Maximum fluctuation of energy of the load at a constant speed, J: maximum minus minimum of the integral of (torque − mean torque)
    /// over the angle.
    pub fn swing(&self, speed: f64) -> f64 {
        let works = self.at_constant_speed(speed).1.into_iter();
        let (low, high) = works.fold((0.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    }

    /// The load with adjacent steps merged, so that about `count` steps remain.
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

    /// Angle at which the shaft stops, rad, in the first turn after a start from rest at `angle`. `None` if the shaft completes the turn.
    /// The method is of second order and L-stable, suitable for small inertia and a stiff motor (Alexander 1977).
    pub fn stop_from_rest(&self, motor: &Motor, no_load: f64, angle: f64) -> Option<f64> {
        let h = TAU / SMALL_STEPS as f64;
        let part = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
        let mut energy = 0.0;
        for x in (0..SMALL_STEPS).map(|i| angle + h * i as f64) {
            let inner = self.at(x + part * h);
            let end = self.at(x + h);
            let middle = implicit(&inner, motor, no_load, energy, part * h);
            let next = middle.and_then(|middle| {
                let gained = (1.0 - part) / part * (middle - energy);
                implicit(&end, motor, no_load, energy + gained, part * h)
            });
            let Some(next) = next else {
                let rate = self.at(x).rate(motor, no_load, energy)[0];
                return Some(
                    x + if rate < 0.0 {
                        (-energy / rate).min(h)
                    } else {
                        0.0
                    },
                );
            };
            energy = next;
        }
        None
    }

    /// Load at an angle, interpolated by the polynomial of the step.
    fn at(&self, angle: f64) -> Node {
        let first = self.steps[0].from;
        let angle = first + (angle - first).rem_euclid(TAU);
        let i = self.steps.partition_point(|s| s.from <= angle);
        let step = &self.steps[i.max(1) - 1];
        let u = (angle - step.from) / step.width;
        let factors: [f64; 5] = std::array::from_fn(|k| {
            let others = (0..5).filter(|i| *i != k);
            let terms = others.map(|i| (u - ALL_PLACES[i]) / (ALL_PLACES[k] - ALL_PLACES[i]));
            terms.product()
        });
        let nodes = step.all();
        let sum = |of: &dyn Fn(&Node) -> f64| -> f64 {
            factors.iter().zip(&nodes).map(|(f, n)| f * of(n)).sum()
        };
        Node {
            arms: [sum(&|n| n.arms[0]), sum(&|n| n.arms[1])],
            rest: sum(&|n| n.rest),
            damping: sum(&|n| n.damping),
            bend: sum(&|n| n.bend),
            mass: sum(&|n| n.mass),
        }
    }
}

/// Positive solution E of the implicit equation E = `base` + `width` E′(E) of a step; `None` if the shaft stops.
fn implicit(node: &Node, motor: &Motor, no_load: f64, base: f64, width: f64) -> Option<f64> {
    let excess = |energy: f64| {
        let [rate, slope, _] = node.rate(motor, no_load, energy);
        [energy - base - width * rate, 1.0 - width * slope]
    };
    if excess(0.0)[0] >= 0.0 {
        return None;
    }
    let mut range = [0.0, base.abs().max(f64::MIN_POSITIVE)];
    while excess(range[1])[0] < 0.0 {
        range = [range[1], 4.0 * range[1]];
        if !range[1].is_finite() {
            return None;
        }
    }
    let mut energy = range[1];
    for _ in 0..ROUNDS {
        let [off, slope] = excess(energy);
        range[usize::from(off >= 0.0)] = energy;
        let next = energy - off / slope;
        let is_inside = next > range[0] && next < range[1];
        let next = if is_inside {
            next
        } else {
            0.5 * (range[0] + range[1])
        };
        if (next - energy).abs() <= SAME * next {
            return Some(next);
        }
        energy = next;
    }
    Some(energy)
}

/// Matrix (I − h A D)⁻¹ with the unit matrix I, the step width h and the stage coefficients A (`INNER`). D contains the derivatives of E′
/// with respect to the energy.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::TorqueLine;

    /// A constant torque T acts against a spring: J ω²/2 = T x − k s²/2, with the angle x measured from the minimum lift.
    #[test]
    fn a_start_from_rest_stops_where_the_work_of_the_motor_is_used_up() {
        let (torque, rate, height) = (6.0, 2e5, 0.02);
        let drive = Drive::fixed_axis(0.0, rate, 5.0);
        let motor = Motor {
            line: TorqueLine::Stall(torque),
            nominal: None,
            inertia: 0.01,
            friction: 0.0,
            gear: 1.0,
            efficiency: 1.0,
        };
        let lowest = 2.1;
        let lift = |x: f64| 0.5 * height * (1.0 - (x - lowest).cos());
        let node = |x: f64| {
            let at = Svaj {
                s: lift(x),
                v: 0.5 * height * (x - lowest).sin(),
                a: 0.5 * height * (x - lowest).cos(),
                j: 0.0,
            };
            Node::new(&drive, at, [at.v; 2], 0.0)
        };
        let load = Load::of((0.0, TAU), &[0.0, TAU], 32, &node);
        let stop = load.stop_from_rest(&motor, 1e12, lowest).unwrap() - lowest;
        let left = |x: f64| torque * x - 0.5 * rate * lift(lowest + x).powi(2);
        let (mut low, mut high) = (0.5, 3.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if left(middle) > 0.0 {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        assert!(low > 1.0 && low < 2.9);
        assert!((stop - low).abs() < 1e-3, "{stop} {low}");
    }
}
