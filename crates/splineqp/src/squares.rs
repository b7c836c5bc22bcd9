//! Point of a convex hull that minimises the maximum of several squares, and the weights of the squares that prove this minimum.
//!
//! ```text
//! minimise   max qᵢ(v)   or   min over η of η + Σ capᵢ max(qᵢ(v) − η, 0)
//! such that  v in the convex hull of points,   qᵢ(v) = γᵢ² |v|² − 2γᵢ bᵢ·v + cᵢ
//! ```
//!
//! All squares contain the term |v|². With ρ ≥ |v|² as a variable, each square is a linear row, and the program needs a single second-order
//! cone. The multipliers of the rows are the weights.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, SolverStatus, SupportedConeT};

use nalgebra::{DMatrix, DVector};

use crate::solve::exchange::clarabel::{prepared, run};

/// Square of a distance, q(v) = γ² |v|² − 2γ b·v + c.
///
/// ```
/// use splineqp::Square;
///
/// // |2v − (3, 0)|²
/// let square = Square { scale: 2.0, towards: vec![3.0, 0.0], constant: 9.0 };
/// assert_eq!(square.at(&[1.0, 1.0]), 1.0 + 4.0);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Square {
    /// Factor γ of the vector v.
    pub scale: f64,
    /// Vector b, the target of γv.
    pub towards: Vec<f64>,
    /// Constant c that is added to the square.
    pub constant: f64,
}

impl Square {
    /// Value of the square for the vector v.
    pub fn at(&self, v: &[f64]) -> f64 {
        let dot: f64 = self.towards.iter().zip(v).map(|(b, v)| b * v).sum();
        let square: f64 = v.iter().map(|v| v * v).sum();
        self.scale * (self.scale * square - 2.0 * dot) + self.constant
    }
}

/// Number of squares whose rows are in the first program. At most this number is added in each iteration.
const ENTERING: usize = 24;
/// Maximum excess of a square without a row over the maximum of the squares with rows, relative to this maximum.
const EXCEEDS: f64 = 1e-10;
/// Threshold below which a singular value counts as zero.
const DEPENDENT: f64 = 1e-9;
/// Maximum number of programs that are solved.
const ROUNDS: usize = 40;

/// Point of a convex hull that minimises the maximum square, with the weights of the squares as proof.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastWorst {
    /// Weights of the squares. The point minimises the sum of the squares with these weights. The sum of the weights is 1, and each weight
    /// is at most its cap.
    pub weights: Vec<f64>,
    /// Weights of the points whose convex combination is the result. The sum of the weights is 1.
    pub parts: Vec<f64>,
    at: Vec<f64>,
    level: f64,
}

/// Point of the convex hull of `points` that minimises the maximum square. With `caps`, which are upper bounds of the weights, it minimises
/// the weighted mean of the largest squares. The squares should be of order 1. `None` if the solver fails.
///
/// ```
/// use splineqp::{Square, least_worst};
///
/// // Between −1 and 2 on a line: the worst distance is least in the middle, and both ends weigh as much.
/// let to = |x: f64| Square { scale: 1.0, towards: vec![x], constant: x * x };
/// let best = least_worst(&[vec![-3.0], vec![3.0]], &[to(-1.0), to(2.0)], None).unwrap();
/// assert!((best.weights[0] - 0.5).abs() < 1e-9 && (best.parts[1] - 3.5 / 6.0).abs() < 1e-9);
/// ```
pub fn least_worst(
    points: &[Vec<f64>],
    squares: &[Square],
    caps: Option<&[f64]>,
) -> Option<LeastWorst> {
    let last = points.last()?;
    let mut order: Vec<usize> = (0..squares.len()).collect();
    let mut rows = worst_first(squares, last, &mut order, ENTERING);
    if caps.is_some() {
        // With caps, all squares have a row from the start, because the rows must determine the level η above which squares count.
        rows = order.clone();
    }
    for _ in 0..ROUNDS {
        let best = solve(points, squares, caps, &rows)?;
        let mut open: Vec<usize> = (0..squares.len()).filter(|i| !rows.contains(i)).collect();
        open.retain(|i| squares[*i].at(&best.at) > best.level * (1.0 + EXCEEDS) + EXCEEDS);
        if open.is_empty() {
            return Some(best);
        }
        rows.extend(worst_first(squares, &best.at, &mut open, ENTERING));
    }
    None
}

fn worst_first(squares: &[Square], at: &[f64], of: &mut [usize], most: usize) -> Vec<usize> {
    let values: Vec<f64> = squares.iter().map(|q| q.at(at)).collect();
    of.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    of.iter().copied().take(most).collect()
}

/// Replaces the weights by the nearest weights for which the point is stationary on its face of the hull. With an interior-point method,
/// the point is accurate to ten digits, but the weights only to five.
fn refine(weights: &mut [f64], free: &[usize], squares: &[Square], bearing: &[&[f64]], at: &[f64]) {
    if free.is_empty() {
        return;
    }
    let gradient = |square: &Square| -> Vec<f64> {
        let both = at.iter().zip(&square.towards);
        both.map(|(v, b)| 2.0 * square.scale * (square.scale * v - b))
            .collect()
    };
    let along = |gradient: &[f64], point: &[f64]| -> f64 {
        let steps = point.iter().zip(at).map(|(p, a)| p - a);
        steps.zip(gradient).map(|(step, g)| step * g).sum()
    };
    let gradients: Vec<Vec<f64>> = free.iter().map(|i| gradient(&squares[*i])).collect();
    let equations = bearing.len() + 1;
    let mut matrix = DMatrix::zeros(equations, free.len());
    let mut missing = DVector::zeros(equations);
    for (row, point) in bearing.iter().enumerate() {
        for (column, gradient) in gradients.iter().enumerate() {
            matrix[(row, column)] = along(gradient, point);
        }
        let whole: f64 = (squares.iter().zip(weights.iter()))
            .filter(|(_, w)| **w > 0.0)
            .map(|(square, w)| w * along(&gradient(square), point))
            .sum();
        missing[row] = -whole;
    }
    matrix.row_mut(equations - 1).fill(1.0);
    missing[equations - 1] = 1.0 - weights.iter().sum::<f64>();
    let Ok(change) = matrix.svd(true, true).solve(&missing, DEPENDENT) else {
        return;
    };
    for (i, change) in free.iter().zip(change.iter()) {
        weights[*i] = (weights[*i] + change).max(0.0);
    }
}

/// Solution of the program with the rows of some squares. Without caps, the field `level` is the maximum of these squares. With caps, it is
/// infinite.
fn solve(
    points: &[Vec<f64>],
    squares: &[Square],
    caps: Option<&[f64]>,
    rows: &[usize],
) -> Option<LeastWorst> {
    let (k, dim) = (points.len(), points.first()?.len());
    let (rho, eta, above) = (k, k + 1, k + 2);
    let columns = k + 2 + if caps.is_some() { rows.len() } else { 0 };
    let mut q = vec![0.0; columns];
    q[eta] = 1.0;
    let mut entries: Vec<(usize, usize, f64)> = (0..k).map(|i| (0, i, 1.0)).collect();
    let mut b = vec![1.0];
    let positive: Vec<usize> = (0..k).chain(above..columns).collect();
    for i in positive {
        entries.push((b.len(), i, -1.0));
        b.push(0.0);
    }
    let first = b.len();
    for (place, square) in rows.iter().map(|i| &squares[*i]).enumerate() {
        let row = b.len();
        entries.push((row, rho, square.scale * square.scale));
        entries.push((row, eta, -1.0));
        for (i, point) in points.iter().enumerate() {
            let dot: f64 = square.towards.iter().zip(point).map(|(b, v)| b * v).sum();
            entries.push((row, i, -2.0 * square.scale * dot));
        }
        if let Some(caps) = caps {
            entries.push((row, above + place, -1.0));
            q[above + place] = caps[rows[place]];
        }
        b.push(-square.constant);
    }
    let linear = b.len() - 1;
    // First two rows of the cone ρ + 1 ≥ ‖(ρ − 1, 2v)‖, which is equivalent to ρ ≥ |v|².
    for end in [1.0, -1.0] {
        entries.push((b.len(), rho, -1.0));
        b.push(end);
    }
    for axis in 0..dim {
        let row = b.len();
        entries.extend(
            points
                .iter()
                .enumerate()
                .map(|(i, v)| (row, i, -2.0 * v[axis])),
        );
        b.push(0.0);
    }
    entries.retain(|e| e.2 != 0.0);
    let (i, j, values) = entries.into_iter().collect();
    let a = CscMatrix::new_from_triplets(b.len(), columns, i, j, values);
    let p = CscMatrix::zeros((columns, columns));
    let cones = [
        SupportedConeT::ZeroConeT(1),
        SupportedConeT::NonnegativeConeT(linear),
        SupportedConeT::SecondOrderConeT(2 + dim),
    ];
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(1e-10)
        .tol_gap_rel(1e-10)
        .tol_feas(1e-10)
        .max_threads(1)
        .build()
        .ok()?;
    let mut solver = prepared(&p, &q, &a, &b, &cones, settings).ok()?;
    run(&mut solver);
    let answer = &solver.solution;
    let solved = matches!(
        answer.status,
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress
    );
    if !solved || answer.x.iter().chain(&answer.z).any(|x| !x.is_finite()) {
        return None;
    }
    let mut parts: Vec<f64> = answer.x[..k].iter().map(|p| p.max(0.0)).collect();
    let whole: f64 = parts.iter().sum();
    parts.iter_mut().for_each(|p| *p /= whole);
    let mut at = vec![0.0; dim];
    for (part, point) in parts.iter().zip(points) {
        at.iter_mut().zip(point).for_each(|(a, v)| *a += part * v);
    }
    let mut weights = vec![0.0; squares.len()];
    for (i, z) in rows.iter().zip(&answer.z[first..]) {
        weights[*i] = z.max(0.0);
    }
    let between = |place: &usize| {
        let active = answer.z[first + place] > answer.s[first + place];
        let below_cap = caps.is_none() || answer.z[1 + k + place] > answer.x[above + place];
        active && below_cap
    };
    let free: Vec<usize> = (0..rows.len()).filter(between).map(|p| rows[p]).collect();
    let bearing = (0..k).filter(|i| answer.x[*i] > answer.z[1 + i]);
    let bearing: Vec<&[f64]> = bearing.map(|i| points[i].as_slice()).collect();
    refine(&mut weights, &free, squares, &bearing, &at);
    let total: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|w| *w /= total);
    let level = if caps.is_some() {
        f64::INFINITY
    } else {
        answer.x[eta]
    };
    (total > 0.0).then_some(LeastWorst {
        weights,
        parts,
        at,
        level,
    })
}
