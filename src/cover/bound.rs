//! Lower bounds of the force error of a set of k cams.
//!
//! For each walker, p is the force of the individual cam and o² its mean square error. The force p is the point of a convex set that is nearest to
//! the target of the walker. The force ψ of every shared cam is in this set, so its mean square error for the walker is e² ≥ o² + γ² ‖ψ − p‖². The
//! factor γ of the walker converts newtons to the measure of the error. The walkers are therefore treated as points, and the shared cams as centres.
//!
//! Of k + 1 walkers, at least two share a cam, which bounds the maximum error. The mean square error is bounded by the spread of the points minus the
//! k − 1 largest eigenvalues of their scatter matrix (Ding and He, 2004; theory §8).

use nalgebra::DMatrix;

use crate::synth::population::alone::Point;
use crate::synth::population::errors::{dot, in_tail, norm};
use crate::synth::population::weights::{axes, less};

/// Maximum number of walkers from which the search for a set of distant walkers is started.
const BEGINNINGS: usize = 32;
/// Number of bisection steps for the error of two walkers that share a cam.
const STEPS: usize = 60;
/// Number of Frank–Wolfe steps for the weights of the worst walkers.
const STEPS_OF_WEIGHTS: usize = 200;

impl Point {
    fn distance(&self, other: &Point) -> f64 {
        let off = self.at.iter().zip(&other.at).map(|(a, b)| (a - b).powi(2));
        (off.sum::<f64>().sqrt() - self.slack - other.slack).max(0.0)
    }

    /// Lower bound for two walkers that share a cam. It bounds the larger of their two mean square errors.
    fn shared(&self, other: &Point) -> f64 {
        let distance = self.distance(other);
        let error = |p: &Point, x: f64| p.least + (p.scale * x).powi(2);
        // Between the forces of the two individual cams, the error of one walker increases and the error of the other walker decreases.
        let (mut near, mut far) = (0.0, distance);
        for _ in 0..STEPS {
            let middle = 0.5 * (near + far);
            if error(self, middle) < error(other, distance - middle) {
                near = middle;
            } else {
                far = middle;
            }
        }
        error(self, near).max(other.least)
    }
}

/// Lower bound of the maximum mean square error of all walkers with k cams.
pub fn worst(points: &[Point], cams: usize) -> f64 {
    let alone = points.iter().fold(0.0_f64, |m, p| m.max(p.least));
    if cams >= points.len() {
        return alone;
    }
    let step = points.len().div_ceil(BEGINNINGS);
    let of_set = |first: usize| {
        let from = |i: usize| -> Vec<f64> { points.iter().map(|p| points[i].shared(p)).collect() };
        let mut nearest = from(first);
        nearest[first] = f64::NEG_INFINITY;
        let mut least = f64::INFINITY;
        for _ in 0..cams {
            let next = (0..points.len()).max_by(|i, j| nearest[*i].total_cmp(&nearest[*j]));
            let next = next.unwrap_or(first);
            least = least.min(nearest[next]);
            let both = nearest.iter_mut().zip(from(next));
            both.for_each(|(n, other)| *n = n.min(other));
            nearest[next] = f64::NEG_INFINITY;
        }
        least
    };
    (0..points.len())
        .step_by(step)
        .map(of_set)
        .fold(alone, f64::max)
}

/// Replaces each point by its coordinates in an orthonormal basis of the affine hull of all points. Distances between points are unchanged.
/// The number of coordinates decreases from the number of nodes to the dimension of the hull. For laws, this dimension is at most the
/// number of basis functions.
pub fn compressed(points: Vec<Point>) -> Vec<Point> {
    let Some(first) = points.first().map(|p| p.at.clone()) else {
        return points;
    };
    let all: Vec<Vec<f64>> = points.iter().map(|p| p.at.clone()).collect();
    let axes = axes(&all, &first);
    let place = |at: &[f64]| {
        axes.iter()
            .map(|axis| dot(axis, &less(at, &first)))
            .collect()
    };
    let each = points.into_iter().map(|p| Point {
        at: place(&p.at),
        ..p
    });
    each.collect()
}

/// Lower bound of the weighted mean square error of k cams. `shares` are the weights of the cycles.
pub fn mean(points: &[Point], shares: &[f64], cams: usize) -> f64 {
    spread(points, shares, cams).0
}

/// Lower bound for k cams if only the worst walkers count. It bounds their mean square error. `part` is the fraction of the walkers that
/// are not among the worst. `shares` are the weights of all cycles. `start` contains the initial weights of the worst cycles.
///
/// Each admissible set of weights gives a lower bound, which is concave in the weights. Frank–Wolfe steps (1956) increase the weights of the cycles
/// that are farthest from the best affine subspace.
pub fn tail(points: &[Point], part: f64, shares: &[f64], cams: usize, start: &[f64]) -> f64 {
    let mut weights = start.to_vec();
    let mut best = mean(points, shares, cams);
    for step in 0..STEPS_OF_WEIGHTS {
        let (bound, errors) = spread(points, &weights, cams);
        best = best.max(bound);
        let worst = in_tail(part, &errors, shares);
        let length = 2.0 / (step + 3) as f64;
        let both = weights.iter_mut().zip(worst);
        both.for_each(|(w, next)| *w += length * (next - *w));
    }
    best
}

/// Lower bound of the weighted mean square error of k cams, and the mean square error of each point for the best affine subspace. The
/// subspace has k − 1 dimensions. The error of a point includes its squared distance from the subspace.
fn spread(points: &[Point], shares: &[f64], cams: usize) -> (f64, Vec<f64>) {
    let weights: Vec<f64> = points
        .iter()
        .zip(shares)
        .map(|(p, s)| s * p.scale * p.scale)
        .collect();
    let whole: f64 = weights.iter().sum();
    let places = points.first().map_or(0, |p| p.at.len());
    if places == 0 {
        // All points coincide.
        let errors: Vec<f64> = points.iter().map(|p| p.least).collect();
        return (dot(&errors, shares), errors);
    }
    let mut centre = vec![0.0; places];
    for (point, weight) in points.iter().zip(&weights) {
        let each = centre.iter_mut().zip(&point.at);
        each.for_each(|(c, x)| *c += weight / whole * x);
    }
    let off = DMatrix::from_fn(points.len(), places, |i, j| points[i].at[j] - centre[j]);
    let rows = DMatrix::from_fn(points.len(), places, |i, j| weights[i].sqrt() * off[(i, j)]);
    let axes = rows.tr_mul(&rows).symmetric_eigen();
    let mut order: Vec<usize> = (0..places).collect();
    order.sort_by(|a, b| axes.eigenvalues[*b].total_cmp(&axes.eigenvalues[*a]));
    let rest = order.get(cams - 1..).unwrap_or_default();
    let left: f64 = rest.iter().map(|i| axes.eigenvalues[*i].max(0.0)).sum();
    let slacks: Vec<f64> = (points.iter().zip(&weights))
        .map(|(p, w)| w.sqrt() * p.slack)
        .collect();
    let apart = (left.sqrt() - norm(&slacks).sqrt()).max(0.0);
    let alone = points.iter().zip(shares).map(|(p, s)| s * p.least);
    let own = &off * &axes.eigenvectors;
    let error = |i: usize| {
        let square: f64 = rest.iter().map(|j| own[(i, *j)].powi(2)).sum();
        points[i].least + points[i].scale.powi(2) * square
    };
    let errors = (0..points.len()).map(error).collect();
    (alone.sum::<f64>() + apart * apart, errors)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_a_line(places: &[f64]) -> Vec<Point> {
        let point = |x: &f64| Point {
            at: vec![*x, 0.0],
            slack: 0.0,
            scale: 1.0,
            least: 0.25,
        };
        places.iter().map(point).collect()
    }

    /// Two pairs of points and one distant point: the centres of the best three cams are the middles of the pairs and the distant point.
    #[test]
    fn bounds_of_points_on_a_line_are_those_of_the_best_centres() {
        let points = on_a_line(&[0.0, 2.0, 20.0, 22.0, 90.0]);
        assert!((worst(&points, 3) - 1.25).abs() < 1e-12);
        assert!((worst(&points, 5) - 0.25).abs() < 1e-12);
        let shares = [0.2; 5];
        // One cam: the variance about the mean.
        let mean_place = 134.0 / 5.0;
        let variance = [0.0, 2.0, 20.0, 22.0, 90.0].map(|x: f64| 0.2 * (x - mean_place).powi(2));
        assert!((mean(&points, &shares, 1) - 0.25 - variance.iter().sum::<f64>()).abs() < 1e-9);
        // Three cams leave at least what one direction has left, here nothing, and at most 4 · 0.2.
        let three = mean(&points, &shares, 3);
        assert!((0.25..=0.25 + 0.8).contains(&three), "{three}");
    }

    /// Compares the bounds with all assignments of seven walkers to two cams.
    #[test]
    fn no_assignment_is_below_the_bounds() {
        let mut seed = 12_345_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(u32::MAX >> 1)
        };
        for _ in 0..20 {
            let mut point = |_| Point {
                at: vec![random(), random(), 0.2 * random()],
                slack: 0.0,
                scale: 0.5 + random(),
                least: 0.01 * random(),
            };
            let points: Vec<Point> = (0..7).map(&mut point).collect();
            let shares = [1.0 / 7.0; 7];
            let mut best = f64::INFINITY;
            for code in 0..128_u32 {
                let group = |c: u32| -> f64 {
                    let own = |i: &usize| (code >> i) & 1 == c;
                    let own: Vec<usize> = (0..7).filter(own).collect();
                    let weight = |i: &usize| shares[*i] * points[*i].scale.powi(2);
                    let whole: f64 = own.iter().map(weight).sum();
                    let centre = |j: usize| {
                        own.iter()
                            .map(|i| weight(i) * points[*i].at[j])
                            .sum::<f64>()
                            / whole
                    };
                    let error = |i: &usize| {
                        let off = (0..3).map(|j| (points[*i].at[j] - centre(j)).powi(2));
                        shares[*i] * points[*i].least + weight(i) * off.sum::<f64>()
                    };
                    own.iter().map(error).sum()
                };
                best = best.min(group(0) + group(1));
            }
            let bound = mean(&points, &shares, 2);
            assert!(bound <= best * (1.0 + 1e-12), "{bound} {best}");
            assert!(bound > 0.2 * best, "{bound} {best}");
        }
    }

    /// Points in the plane and one cam: a fine grid gives the best centre for the worst third of the points.
    #[test]
    fn the_bound_of_a_worst_part_is_that_of_its_worst_weights() {
        let mut seed = 99_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(u32::MAX >> 1)
        };
        for _ in 0..5 {
            let mut point = |_| Point {
                at: vec![random(), random()],
                slack: 0.0,
                scale: 0.5 + random(),
                least: 0.01 * random(),
            };
            let points: Vec<Point> = (0..9).map(&mut point).collect();
            let shares = [1.0 / 9.0; 9];
            let of_cam = |x: f64, y: f64| {
                let error = |p: &Point| {
                    p.least + p.scale.powi(2) * ((p.at[0] - x).powi(2) + (p.at[1] - y).powi(2))
                };
                let errors: Vec<f64> = points.iter().map(error).collect();
                dot(&in_tail(2.0 / 3.0, &errors, &shares), &errors)
            };
            let places = || (0..=400).map(|i| 0.0025 * f64::from(i));
            let best = places()
                .flat_map(|x| places().map(move |y| (x, y)))
                .map(|(x, y)| of_cam(x, y))
                .fold(f64::INFINITY, f64::min);
            let bound = tail(&points, 2.0 / 3.0, &shares, 1, &shares);
            assert!(bound <= best && bound > 0.998 * best, "{bound} {best}");
            assert!(bound > mean(&points, &shares, 1));
        }
    }
}
