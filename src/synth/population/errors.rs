//! Force errors of several walkers for a law, as squared distances. The mean square error of walker w is the mean of (γ_w ψ − y_w)². Here ψ
//! is the force of the law in the reference machine minus the force at rest, and y_w is the scaled target of the walker. The unit of a walker
//! is the force, N, to which the errors of the walker are related.

use std::f64::consts::TAU;

use crate::drive::Drive;
use crate::law::Law;
use crate::poly::{Cells, gauss_legendre};
use crate::problem::Served;
use crate::scene::Robust;

/// Number of equal ranges of the turn for the quadrature of laws that are not polynomials.
const RANGES: usize = 256;
const NODES: usize = 5;
/// Maximum degree of the least-squares polynomials that replace a target.
const HIGHEST: usize = 9;

/// Quadrature nodes over the turn for comparing forces. Integrals of products of two laws with the same basis are exact.
pub struct Nodes {
    /// Cam angles of the nodes, rad.
    at: Vec<f64>,
    /// Square roots of the quadrature weights. The sum of their squares is 1.
    roots: Vec<f64>,
    breaks: Vec<f64>,
    /// Degree of the polynomials between the breaks; `None` for harmonics.
    degree: Option<usize>,
}

/// Scaled target of one walker at the nodes.
pub struct Aim {
    /// Factor γ = β/unit of the walker, 1/N. The factor β relates the force in the machine of the walker to that in the reference machine.
    pub scale: f64,
    /// Target (F − R)/unit at the nodes, multiplied by the square roots of the weights.
    pub towards: Vec<f64>,
    /// Mean square of the part of the target that no law of the basis reproduces.
    pub left: f64,
}

impl Nodes {
    /// Quadrature nodes for all laws with the basis of `law`.
    pub fn of(law: &Law) -> Nodes {
        let pieces = law.breaks().len() - 1;
        let is_polynomial = (0..pieces).all(|i| law.waves(i).is_empty());
        let degree = law.poly().degree().max(1);
        let degree = (is_polynomial && degree <= HIGHEST).then_some(degree);
        let breaks = match degree {
            Some(_) => law.breaks().to_vec(),
            None => (0..=RANGES)
                .map(|i| TAU * i as f64 / RANGES as f64)
                .collect(),
        };
        let rule = gauss_legendre(degree.map_or(NODES, |d| d + 1));
        let (mut at, mut roots) = (Vec::new(), Vec::new());
        for ends in breaks.windows(2) {
            for &(u, weight) in &rule {
                at.push(ends[0] + u * (ends[1] - ends[0]));
                roots.push((weight * (ends[1] - ends[0]) / TAU).sqrt());
            }
        }
        Nodes {
            at,
            roots,
            breaks,
            degree,
        }
    }

    /// Force of a law minus the force at rest, N, at the nodes and multiplied by the square roots of the weights.
    pub fn force(&self, drive: &Drive, law: &Law) -> Vec<f64> {
        let rest = drive.rest_force;
        let at = self.at.iter().zip(&self.roots);
        at.map(|(x, root)| root * (drive.force(law.svaj(*x)) - rest))
            .collect()
    }

    /// Scaled target of a walker at the nodes.
    pub fn aim(&self, walker: &Served) -> Aim {
        let mut ends = walker.target.force_n.clone();
        ends.push(ends[0]);
        let cells = Cells::new(ends, walker.target.slopes(), TAU);
        let values = match self.degree {
            Some(degree) => cells.nearest(&self.breaks, degree),
            None => self.at.iter().map(|x| cells.at(*x)).collect(),
        };
        let (rest, unit) = (walker.drive.rest_force, walker.unit);
        let both = values.iter().zip(&self.roots);
        let towards: Vec<f64> = both.map(|(f, root)| root * (f - rest) / unit).collect();
        let square = cells.mean_square_from(rest) / (unit * unit);
        let left = self.degree.map_or(0.0, |_| square - norm(&towards));
        Aim {
            scale: walker.factor / unit,
            towards,
            left: left.max(0.0),
        }
    }
}

impl Aim {
    /// Mean square error of the walker for the force of a law, in the square of the walker's unit.
    pub fn square(&self, force: &[f64]) -> f64 {
        let both = force.iter().zip(&self.towards);
        both.map(|(f, y)| (self.scale * f - y).powi(2)).sum::<f64>() + self.left
    }
}

impl Nodes {
    /// Mean square error of a walker for the force of a law, as the sum of three components: mean force, amplitude and shape.
    pub fn parts(&self, aim: &Aim, force: &[f64]) -> [f64; 3] {
        let centred = |mut values: Vec<f64>| {
            let mean = dot(&values, &self.roots);
            let each = values.iter_mut().zip(&self.roots);
            each.for_each(|(x, root)| *x -= mean * root);
            (mean, values)
        };
        let both = force.iter().zip(&aim.towards);
        let (mean, off) = centred(both.map(|(f, y)| y - aim.scale * f).collect());
        let (_, varying) = centred(force.to_vec());
        let size = dot(&off, &varying).powi(2) / norm(&varying).max(f64::MIN_POSITIVE);
        [mean * mean, size, (norm(&off) - size).max(0.0) + aim.left]
    }
}

pub fn norm(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Objective over the walkers, as a mean square: mean, maximum, or mean of the largest mean square errors. `shares` are the weights of the
/// walkers.
pub fn measure(robust: Robust, squares: &[f64], shares: &[f64]) -> f64 {
    match robust {
        Robust::Mean => dot(squares, shares),
        Robust::Worst => squares.iter().fold(0.0, |m, q| m.max(*q)),
        Robust::Tail(part) => tail(part, squares, shares),
    }
}

/// Mean of the largest values, whose shares sum to 1 − `part`.
pub fn tail(part: f64, values: &[f64], shares: &[f64]) -> f64 {
    dot(&in_tail(part, values, shares), values)
}

/// Weight of each value in the mean of the largest values. The shares of these values sum to 1 − `part`.
pub fn in_tail(part: f64, values: &[f64], shares: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let (mut left, mut out) = (1.0 - part, vec![0.0; values.len()]);
    for i in order {
        let taken = shares[i].min(left);
        out[i] = taken / (1.0 - part);
        left -= taken;
        if left <= 0.0 {
            break;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tail_is_the_mean_of_the_largest_with_a_part_of_the_last_one() {
        let (values, shares) = ([1.0, 5.0, 3.0, 2.0], [0.25; 4]);
        assert!((tail(0.75, &values, &shares) - 5.0).abs() < 1e-15);
        assert!((tail(0.5, &values, &shares) - 4.0).abs() < 1e-15);
        assert!((tail(0.6, &values, &shares) - (0.25 * 5.0 + 0.15 * 3.0) / 0.4).abs() < 1e-15);
        assert!((tail(0.0, &values, &shares) - 2.75).abs() < 1e-15);
    }
}
