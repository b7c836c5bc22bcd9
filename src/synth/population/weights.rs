//! Search for weights of the walkers, such that the cam for the weighted mean curve is the optimum of the objective.
//!
//! For weights λ, the sum Σ λ_w e_w² is the mean square distance from one curve, (Σ λ γ y)/(Σ λ γ²), except for a factor and a constant.
//! The factors γ, targets y and errors e are defined in the module `errors`. The minimum of this sum, reduced by its duality gap, is a
//! lower bound of the worst error. It is also a lower bound of the mean of the worst tenth, if no weight exceeds the share of the walker in
//! this tenth.
//!
//! The next weights are the multipliers of the same problem over the convex hull of the previous laws. All laws of the hull satisfy the convex
//! limits (theory §8).

use splineqp::{Square, least_worst};

use super::errors::{Aim, dot, measure, norm};
use crate::scene::Robust;
use crate::synth::qp::PROVED;

/// Fraction of the force of a law. If the part that is orthogonal to the other forces is smaller, the force counts as linearly dependent.
const DEPENDENT: f64 = 1e-9;

/// State of the search for weights.
pub struct Weights<'a> {
    robust: Robust,
    shares: &'a [f64],
    aims: &'a [Aim],
    /// Forces of the laws that have been computed, at the nodes.
    laws: Vec<Vec<f64>>,
    /// Weights of the laws in the best combination.
    pub best: Vec<f64>,
    /// Objective of the best combination, which is an upper bound of the optimum.
    pub upper: f64,
    /// Lower bound of the objective over all laws of the family.
    pub lower: f64,
    /// Weighted sum of the mean square errors of the combination from which the last weights were computed.
    hull: f64,
    /// Whether the last law is not better than the combination from which its weights were computed. The next weights would then equal the
    /// last ones.
    is_settled: bool,
}

impl<'a> Weights<'a> {
    pub fn new(robust: Robust, shares: &'a [f64], aims: &'a [Aim]) -> Self {
        Weights {
            robust,
            shares,
            aims,
            laws: Vec::new(),
            best: Vec::new(),
            upper: f64::INFINITY,
            lower: 0.0,
            hull: f64::INFINITY,
            is_settled: false,
        }
    }

    /// Adds the force of a law designed for given weights. `gap` is an upper bound, N², of the difference between half the mean square force
    /// error of this design problem and its minimum.
    pub fn take(&mut self, weights: &[f64], force: Vec<f64>, gap: f64) {
        let squares = self.squares(&force);
        let both = weights.iter().zip(self.aims);
        let curvature: f64 = both.map(|(w, aim)| w * aim.scale * aim.scale).sum();
        let own = dot(weights, &squares);
        self.lower = self.lower.max(own - 2.0 * curvature * gap);
        self.is_settled = own >= (1.0 - PROVED) * self.hull;
        self.laws.push(force);
        let mut parts = vec![0.0; self.laws.len()];
        parts[self.laws.len() - 1] = 1.0;
        self.keep(parts, &squares);
    }

    fn squares(&self, force: &[f64]) -> Vec<f64> {
        self.aims.iter().map(|aim| aim.square(force)).collect()
    }

    fn keep(&mut self, parts: Vec<f64>, squares: &[f64]) {
        let value = measure(self.robust, squares, self.shares);
        if value < self.upper {
            (self.upper, self.best) = (value, parts);
        }
    }

    /// Force of the weighted sum of the laws with the weights `parts`.
    pub fn force(&self, parts: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.laws[0].len()];
        for (part, law) in parts.iter().zip(&self.laws) {
            out.iter_mut()
                .zip(law)
                .for_each(|(sum, f)| *sum += part * f);
        }
        out
    }

    /// Whether the best combination is proved to be optimal within a relative gap of 1e-6.
    pub fn is_proved(&self) -> bool {
        self.upper - self.lower <= PROVED * self.upper
    }

    /// Maximum weight of each walker; `None` if the weights are not limited.
    fn caps(&self) -> Option<Vec<f64>> {
        match self.robust {
            Robust::Tail(part) => Some(self.shares.iter().map(|p| p / (1.0 - part)).collect()),
            Robust::Mean | Robust::Worst => None,
        }
    }

    /// Weights of the walkers for the next law. They are the multipliers of the problem over the convex hull of the previous laws. `None` if
    /// this problem gives no weights, or if the last law is not an improvement and `combines` is false.
    ///
    /// If `combines` is true, weighted sums of the laws satisfy the limits, and the best sum is also kept. If it is false, optimality cannot
    /// be proved.
    pub fn next(&mut self, combines: bool) -> Option<Vec<f64>> {
        if self.is_settled && !combines {
            return None;
        }
        let centre = self.force(&self.best);
        let axes = axes(&self.laws, &centre);
        let largest = self.aims.iter().fold(0.0_f64, |m, aim| m.max(aim.scale));
        let root = self.upper.sqrt();
        let unit = largest / root;
        let place = |force: &Vec<f64>| -> Vec<f64> {
            let off = less(force, &centre);
            axes.iter().map(|axis| unit * dot(axis, &off)).collect()
        };
        let points: Vec<Vec<f64>> = self.laws.iter().map(place).collect();
        let square = |aim: &Aim| {
            let pairs = aim.towards.iter().zip(&centre);
            let off: Vec<f64> = pairs.map(|(y, f)| y - aim.scale * f).collect();
            Square {
                scale: aim.scale / largest,
                towards: axes.iter().map(|axis| dot(axis, &off) / root).collect(),
                constant: (norm(&off) + aim.left) / self.upper,
            }
        };
        let squares: Vec<Square> = self.aims.iter().map(square).collect();
        let found = least_worst(&points, &squares, self.caps().as_deref())?;
        let squares = self.squares(&self.force(&found.parts));
        self.hull = dot(&found.weights, &squares);
        if combines {
            self.keep(found.parts, &squares);
        }
        Some(found.weights)
    }
}

pub fn less(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Orthonormal basis of the differences between the laws and a centre.
pub fn axes(laws: &[Vec<f64>], centre: &[f64]) -> Vec<Vec<f64>> {
    let mut out: Vec<Vec<f64>> = Vec::new();
    for law in laws {
        let mut rest = less(law, centre);
        let size = norm(&rest).sqrt();
        // The orthogonalisation is repeated, because rounding errors leave a part that is not orthogonal.
        for _ in 0..2 {
            for axis in &out {
                let part = dot(axis, &rest);
                rest.iter_mut().zip(axis).for_each(|(r, a)| *r -= part * a);
            }
        }
        let left = norm(&rest).sqrt();
        if left > DEPENDENT * size && left > 0.0 {
            out.push(rest.iter().map(|r| r / left).collect());
        }
    }
    out
}
