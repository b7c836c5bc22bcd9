//! Terms that a varying speed, a floor and a learned force add to force, velocity, acceleration and jerk of a law. The values of these terms
//! form the state vector of the design iteration.

use std::f64::consts::{PI, TAU};

use nalgebra::SMatrix;

use crate::cam::LimitKind;
use crate::dynamics::machine_motion::MachineMotion;
use crate::dynamics::shaft::force;
use crate::law::{Law, Svaj};
use crate::poly::{PiecewisePoly, bernstein};
use crate::problem::{Extra, Problem};

/// Number of equal parts into which the turn is divided, in addition to the breaks of the law. This number applies if the layout is exact
/// (see [`Layout::new`]).
const PARTS: usize = 48;
const FEW: usize = 24;
const DEGREE: usize = 5;
const NODES: usize = DEGREE + 1;
/// Minimum distance of an equally spaced break from a break of the law, relative to the length of an equal part.
const SHORTEST: f64 = 0.3;
/// Number of equally spaced cam angles at which the state vector contains the time, as a phase of the period, rad.
const ANGLES: usize = 240;

/// Layout of the state vector. It contains the added force at the nodes, the added time derivatives that are limited, the speed, and the
/// positions in the period at equally spaced angles. Each value is divided by a unit, so that its magnitude is about 1.
pub struct Layout {
    breaks: Vec<f64>,
    /// Matrix that converts values at the nodes to Bernstein coefficients.
    coefficients: SMatrix<f64, NODES, NODES>,
    /// Limits on velocity, acceleration and jerk if the speed varies; `None` for a derivative without a limit.
    limits: [Option<f64>; 3],
    /// Whether the shaft speed varies over the turn.
    varies: bool,
}

impl Layout {
    /// Layout for a law. If `varies` is true, the shaft speed varies. If `is_exact` is true, the parts of the turn begin at the breaks of the
    /// law.
    pub fn new(problem: &Problem, law: &Law, varies: bool, is_exact: bool) -> Layout {
        let mut limits = [None; 3];
        for (kind, order) in LimitKind::by_time() {
            limits[order - 1] = problem.limits[kind].filter(|_| varies);
        }
        let (own, count) = match is_exact {
            true => (law.breaks(), PARTS),
            false => (&[0.0, TAU][..], FEW),
        };
        let equal = TAU / count as f64;
        let far = |x: &f64| own.iter().all(|b| (b - x).abs() > SHORTEST * equal);
        let between = (0..count).map(|i| equal * i as f64).filter(far);
        let mut breaks: Vec<f64> = own.iter().copied().chain(between).collect();
        breaks.sort_by(f64::total_cmp);
        let values = SMatrix::<f64, NODES, NODES>::from_fn(|i, k| {
            let u = node(i);
            let part = u.powi(k as i32) * (1.0 - u).powi((DEGREE - k) as i32);
            bernstein::binomial(DEGREE, k) * part
        });
        Layout {
            breaks,
            // The nodes are distinct, so the matrix has an inverse.
            coefficients: values.try_inverse().unwrap_or_else(SMatrix::identity),
            limits,
            varies,
        }
    }

    fn nodes(&self) -> impl Iterator<Item = f64> {
        let part = |ends: &[f64]| {
            let (from, width) = (ends[0], ends[1] - ends[0]);
            (0..NODES).map(move |k| from + node(k) * width)
        };
        self.breaks.windows(2).flat_map(part)
    }

    /// State for a law and a motion of the machine. `law` returns the motion of the follower at an angle, rad.
    pub fn state(
        &self,
        problem: &Problem,
        motion: &MachineMotion,
        law: &dyn Fn(f64) -> Svaj,
    ) -> Vec<f64> {
        let shaft = &motion.shaft;
        let (drive, mean) = (&problem.drive, problem.target_mean());
        let count = NODES * (self.breaks.len() - 1);
        let mut parts: [Vec<f64>; 5] = std::array::from_fn(|_| Vec::with_capacity(count));
        for x in self.nodes() {
            let at = law(x);
            let beyond = drive.mass * motion.floor_at(x) + problem.learned_force(x);
            if !self.varies {
                parts[0].push(beyond / mean);
                continue;
            }
            let [w, rate, slope] = shaft.speed_at(x);
            let added = force(drive, at, w, rate) - drive.force(at) + beyond;
            parts[0].push(added / mean);
            // d/dt = w d/dθ, and w w′ is the angular acceleration.
            let timed = [
                w * at.v,
                w * w * at.a + rate * at.v,
                w * (w * w * at.j + 3.0 * rate * at.a + slope * at.v),
            ];
            let even = [at.v, at.a, at.j];
            for (k, limit) in self.limits.iter().enumerate() {
                let still = drive.speed.powi(k as i32 + 1) * even[k];
                parts[k + 1].extend(limit.map(|limit| (timed[k] - still) / limit));
            }
            parts[4].push(w / drive.speed);
        }
        let angles = (0..ANGLES).map(|i| TAU * i as f64 / ANGLES as f64);
        let phases = angles.map(|x| shaft.phase(x)[0]);
        parts.concat().into_iter().chain(phases).collect()
    }

    /// Positions in the period, rad, at equally spaced angles, and the added terms that a state contains.
    pub fn extra(&self, problem: &Problem, state: &[f64]) -> (Vec<f64>, Extra) {
        let mut left = state;
        let count = NODES * (self.breaks.len() - 1);
        let mut next = |unit: f64| {
            let (own, rest) = left.split_at(count);
            left = rest;
            self.curve(own, unit)
        };
        let force = next(problem.target_mean());
        let timed = self.limits.map(|limit| limit.map(&mut next));
        let speed = self.varies.then(|| next(problem.drive.speed));
        let extra = Extra {
            force,
            timed,
            speed,
            through_floor: None,
        };
        (left.to_vec(), extra)
    }

    fn curve(&self, values: &[f64], unit: f64) -> PiecewisePoly {
        let mut coefficients = Vec::with_capacity(values.len());
        for piece in values.chunks_exact(NODES) {
            for row in self.coefficients.row_iter() {
                let sum: f64 = row.iter().zip(piece).map(|(a, b)| a * b).sum();
                coefficients.push(unit * sum);
            }
        }
        PiecewisePoly::new(self.breaks.clone(), DEGREE, coefficients)
    }
}

/// Chebyshev node `k` between 0 and 1. These nodes are inside a part, because the added terms may jump at its ends.
fn node(k: usize) -> f64 {
    0.5 * (1.0 - libm::cos(PI * (k as f64 + 0.5) / NODES as f64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::shaft::Motion;
    use crate::synth::samples::{FLAT, amplitude, one_wave};

    const LIMITS: &str = "velocity = \"1 m/s\"\nacceleration = \"10 m/s^2\"\njerk = \"300 m/s^3\"";

    /// State for a harmonic law on a shaft with a constant speed that differs from the speed of the drive.
    fn added(part: f64) -> (Problem, Law, Extra, Vec<f64>) {
        let problem = one_wave(FLAT, LIMITS);
        let a = amplitude(&problem);
        let law = Law::harmonic(a, &[(-a, 0.0)]);
        let layout = Layout::new(&problem, &law, true, true);
        let shaft = Motion::even(part * problem.drive.speed);
        let motion = MachineMotion::new(shaft, Vec::new());
        let state = layout.state(&problem, &motion, &|x| law.svaj(x));
        let (phases, extra) = layout.extra(&problem, &state);
        (problem, law, extra, phases)
    }

    /// With d/dt = w d/dθ, velocity, acceleration and jerk are proportional to w, w² and w³. The force is linear in the acceleration.
    #[test]
    fn another_speed_adds_its_powers() {
        let part = 1.2;
        let (problem, law, extra, phases) = added(part);
        let (drive, w) = (&problem.drive, problem.drive.speed);
        let speed = extra.speed.as_ref().unwrap();
        for x in [0.3, 1.0, 2.6, 5.9] {
            let at = law.svaj(x);
            let force = drive.mass * at.a * w * w * (part * part - 1.0);
            assert!((extra.force.eval(x) - force).abs() < 1e-7 * problem.target_mean());
            for (k, even) in [at.v, at.a, at.j].into_iter().enumerate() {
                let order = k as i32 + 1;
                let timed = extra.timed[k].as_ref().unwrap().eval(x);
                let truth = even * w.powi(order) * (part.powi(order) - 1.0);
                assert!((timed - truth).abs() < 1e-7 * w.powi(order) * even.abs().max(0.01));
            }
            assert!((speed.eval(x) - part * w).abs() < 1e-12 * w);
        }
        // Even turning takes equal times for equal angles.
        let apart = |i: usize| (phases[i] - TAU * i as f64 / ANGLES as f64).abs();
        assert!((0..ANGLES).all(|i| apart(i) < 1e-12));
    }

    #[test]
    fn the_speed_of_the_drive_adds_nothing() {
        let (problem, _, extra, _) = added(1.0);
        let (low, high) = extra.force.extremes();
        let mean = problem.target_mean();
        assert!(low.value.abs().max(high.value.abs()) < 1e-12 * mean);
        assert!(
            extra
                .timed
                .iter()
                .flatten()
                .all(|t| t.extremes().1.value.abs() < 1e-12)
        );
    }

    #[test]
    fn curves_of_the_degree_of_a_part_are_kept() {
        let problem = one_wave(FLAT, "");
        let law = Law::harmonic(0.0, &[(0.01, 0.0)]);
        let layout = Layout::new(&problem, &law, false, false);
        let quintic = |x: f64| 1.0 + x - 0.2 * x.powi(3) + 0.01 * x.powi(5);
        let values: Vec<f64> = layout.nodes().map(quintic).collect();
        let curve = layout.curve(&values, 2.0);
        for x in [0.0, 0.77, 3.1, 6.2] {
            assert!((curve.eval(x) - 2.0 * quintic(x)).abs() < 1e-10 * quintic(x).abs());
        }
    }
}
