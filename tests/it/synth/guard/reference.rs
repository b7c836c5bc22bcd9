//! Optimisation problem of a scene in the reference: splines, quadrature, demands eliminated by an orthonormal basis, limits at angles.

use super::asked::{Asked, Objective, Point};
use super::rows::{Extra, Limit, limits, only};
use super::splines::{ORDERS, Splines, gauss};
use super::swing::{Swing, swings};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Jerk, in lifts per rad³, whose mean square has the weight of a radius of one lift when the size is minimised.
const SIZE_JERK: f64 = 1e3;
/// Number of parts of a span at whose ends limits are sampled.
const SCANNED: usize = 20;
/// Number of parts between two samples of the target force, for a limit that follows it.
const SCANNED_BETWEEN: usize = 3;

/// Angle with the basis functions that are not zero there.
pub struct Place {
    pub span: usize,
    /// First and last angle of the piece on which the limits are smooth.
    pub ends: [f64; 2],
    pub theta: f64,
    pub values: [Vec<f64>; ORDERS],
}

/// Quadrature point: force of the basis functions, target value, weight.
struct Node {
    span: usize,
    row: Vec<f64>,
    wanted: f64,
    weight: f64,
}

/// Affine space x = origin + free·u, with f(x) = least + ½|u|² for an objective with a quadratic part.
pub struct Space {
    pub origin: DVector<f64>,
    pub free: DMatrix<f64>,
    pub least: f64,
    pub is_square: bool,
}

pub struct Reference<'a> {
    pub asked: &'a Asked,
    pub splines: Splines,
    pub limits: Vec<Limit>,
    pub extras: Vec<Extra>,
    pub swings: Vec<Swing>,
    pub scan: Vec<Place>,
    nodes: Vec<Node>,
}

impl<'a> Reference<'a> {
    pub fn new(asked: &'a Asked) -> Self {
        let splines = splines(asked);
        let (limits, extras) = limits(asked);
        let follows = limits.iter().any(|l| l.shape != 0.0);
        let (cuts, parts) = if follows {
            (cut_at_samples(asked, &splines), SCANNED_BETWEEN)
        } else {
            (splines.breaks().to_vec(), SCANNED)
        };
        let mut scan = Vec::new();
        for ends in cuts.windows(2) {
            let [a, b] = [ends[0], ends[1]];
            let span = splines.span_of(0.5 * (a + b));
            for k in 0..=parts {
                let theta = a + (b - a) * k as f64 / parts as f64;
                scan.push(Place {
                    span,
                    ends: [a, b],
                    theta,
                    values: splines.values(span, theta),
                });
            }
        }
        let nodes = nodes(asked, &splines);
        Reference {
            swings: swings(asked, &splines),
            asked,
            splines,
            limits,
            extras,
            scan,
            nodes,
        }
    }

    /// Quadratic part of the objective: half the mean square of the force error or of a derivative, or the term that is added to a size.
    pub fn square(&self, x: &[f64]) -> f64 {
        let of = |n: &Node| 0.5 * n.weight * (self.at(n, x) - n.wanted).powi(2);
        self.nodes.iter().map(of).sum()
    }

    fn at(&self, node: &Node, x: &[f64]) -> f64 {
        let columns = self.splines.columns(node.span);
        columns.zip(&node.row).map(|(i, b)| b * x[i]).sum()
    }

    /// Amplitude of a vibration, and the row in its direction.
    pub fn amplitude(&self, [q, p]: &Swing, x: &[f64]) -> (f64, DVector<f64>) {
        let x = DVector::from_column_slice(x);
        let state = [q.dot(&x), p.dot(&x)];
        let length = state[0].hypot(state[1]).max(f64::MIN_POSITIVE);
        (length, q * (state[0] / length) + p * (state[1] / length))
    }

    /// Gradient of the quadratic part. Its matrix is added to `matrix`, if given.
    fn pull(&self, x: &[f64], matrix: Option<&mut DMatrix<f64>>) -> DVector<f64> {
        let mut gradient = DVector::zeros(x.len());
        for node in &self.nodes {
            let miss = node.weight * (self.at(node, x) - node.wanted);
            for (i, b) in self.splines.columns(node.span).zip(&node.row) {
                gradient[i] += miss * b;
            }
        }
        if let Some(matrix) = matrix {
            for node in &self.nodes {
                for (i, b) in self.splines.columns(node.span).zip(&node.row) {
                    for (j, c) in self.splines.columns(node.span).zip(&node.row) {
                        matrix[(i, j)] += node.weight * b * c;
                    }
                }
            }
        }
        gradient
    }

    /// Laws that satisfy the demands; `None` if these are contradictory. The lift is 0 at the angle `touching`.
    pub fn space(&self, touching: Option<f64>) -> Option<Space> {
        let n = self.splines.count();
        let mut demands = self.demands();
        if !self.asked.level_is_known() {
            let at = touching.unwrap_or(0.0);
            demands.push((self.row_at(at, 0), 0.0));
        }
        let (mut origin, rows) = particular(n, demands)?;
        let rest = complement(n, &rows);
        if self.nodes.is_empty() {
            return Some(Space {
                origin,
                free: rest * self.asked.length(),
                least: 0.0,
                is_square: false,
            });
        }
        let mut matrix = DMatrix::zeros(n, n);
        self.pull(origin.as_slice(), Some(&mut matrix));
        let inner = rest.transpose() * matrix * &rest;
        let factor = inner.cholesky()?;
        for _ in 0..3 {
            let gradient = self.pull(origin.as_slice(), None);
            origin -= &rest * factor.solve(&(rest.transpose() * gradient));
        }
        let free = factor.l().solve_lower_triangular(&rest.transpose())?;
        let least = self.square(origin.as_slice());
        Some(Space {
            origin,
            free: free.transpose(),
            least,
            is_square: true,
        })
    }

    fn row_at(&self, theta: f64, order: usize) -> Vec<f64> {
        let theta = theta.rem_euclid(TAU);
        let mut weights = [0.0; ORDERS];
        weights[order] = 1.0;
        (self.splines).row(self.splines.span_of(theta), theta, weights)
    }

    fn demands(&self) -> Vec<(Vec<f64>, f64)> {
        let mut out = Vec::new();
        for p in &self.asked.points {
            let orders = [Some(p.lift), velocity(p), p.acceleration];
            for (order, value) in orders.into_iter().enumerate() {
                out.extend(value.map(|value| (self.row_at(p.angle, order), value)));
            }
            // s, v and a are 0 on the base circle: a jerk would cut into it on one side.
            if p.lift == 0.0 && p.acceleration == Some(0.0) {
                out.push((self.row_at(p.angle, 3), 0.0));
            }
        }
        for d in &self.asked.dwells {
            let middle = if d.from < d.to {
                0.5 * (d.from + d.to)
            } else {
                (0.5 * (d.from + d.to) + 0.5 * TAU).rem_euclid(TAU)
            };
            for span in 0..self.splines.spans() {
                let ends = &self.splines.breaks()[span..span + 2];
                let half = 0.5 * (ends[1] - ends[0]);
                let apart = (0.5 * (ends[0] + ends[1]) - d.from).rem_euclid(TAU);
                if apart > (d.to - d.from).rem_euclid(TAU) {
                    continue;
                }
                // At rest: no velocity at as many places as it has coefficients.
                for k in 0..self.asked.degree {
                    let turn = std::f64::consts::PI * (k as f64 + 0.5) / self.asked.degree as f64;
                    let theta = ends[0] + half * (1.0 - turn.cos());
                    let weights = [0.0, 1.0, 0.0, 0.0];
                    out.push((self.splines.row(span, theta, weights), 0.0));
                }
            }
            out.extend(d.lift.map(|lift| (self.row_at(middle, 0), lift)));
        }
        out
    }

    /// Rows where the law touches the base circle: −a ≤ 0 at a point. Beside a dwell, where s, v and a are 0, the jerk has the sign of a rise.
    pub fn touched(&self) -> Vec<(usize, f64, [f64; ORDERS])> {
        let asked = self.asked;
        let mut out = Vec::new();
        for p in asked
            .points
            .iter()
            .filter(|p| p.lift == 0.0 && p.acceleration.is_none())
        {
            out.push((self.splines.span_of(p.angle), p.angle, only(2, -1.0)));
        }
        for d in asked.dwells.iter().filter(|d| d.lift == Some(0.0)) {
            let after = self.splines.span_of(d.to.rem_euclid(TAU));
            out.push((after, self.splines.breaks()[after], only(3, -1.0)));
            let n = self.splines.spans();
            let before = (self.splines.span_of(d.from.rem_euclid(TAU)) + n - 1) % n;
            out.push((before, self.splines.breaks()[before + 1], only(3, 1.0)));
        }
        out
    }

    /// Left side of a limit for a law, minus its bound without the further variable.
    pub fn excess(&self, limit: &Limit, span: usize, theta: f64, x: &[f64]) -> f64 {
        let at = self.splines.law(span, theta, x);
        let sum: f64 = (0..ORDERS).map(|d| limit.weights[d] * at[d]).sum();
        sum - self.bound(limit, theta)
    }

    pub fn bound(&self, limit: &Limit, theta: f64) -> f64 {
        let shape = match &self.asked.target {
            Some((target, _)) if limit.shape != 0.0 => {
                limit.shape * (target.at(theta) - self.asked.rest)
            }
            _ => 0.0,
        };
        limit.bound + shape
    }
}

/// Velocity at a point; zero on the base circle, which is touched without slope.
fn velocity(p: &Point) -> Option<f64> {
    p.velocity.or((p.lift == 0.0).then_some(0.0))
}

/// Splines with equal spans. Each dwell is a span with two continuous derivatives at its ends, and the other spans divide the motion.
fn splines(asked: &Asked) -> Splines {
    if asked.dwells.is_empty() {
        return Splines::equal(asked.degree, asked.spans);
    }
    let mut ends = vec![0.0, TAU];
    for d in &asked.dwells {
        ends.extend([d.from, d.to]);
    }
    ends.retain(|x| (0.0..=TAU).contains(x));
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let rests = |a: f64, b: f64| {
        let inside = |d: &super::asked::Dwell| {
            (0.5 * (a + b) - d.from).rem_euclid(TAU) < (d.to - d.from).rem_euclid(TAU)
        };
        asked.dwells.iter().any(inside)
    };
    let parts: Vec<(f64, f64, bool)> = ends
        .windows(2)
        .map(|w| (w[0], w[1], rests(w[0], w[1])))
        .collect();
    let moving: f64 = parts.iter().filter(|p| !p.2).map(|p| p.1 - p.0).sum();
    let (mut breaks, mut multiplicity) = (Vec::new(), Vec::new());
    for (i, &(a, b, rest)) in parts.iter().enumerate() {
        let before = parts[(i + parts.len() - 1) % parts.len()].2;
        let count = if rest {
            1
        } else {
            ((asked.spans as f64 * (b - a) / moving).round() as usize).max(1)
        };
        for k in 0..count {
            breaks.push(a + (b - a) * k as f64 / count as f64);
            let corner = k == 0 && before != rest;
            multiplicity.push(if corner { asked.degree - 2 } else { 1 });
        }
    }
    breaks.push(TAU);
    Splines::new(asked.degree, breaks, &multiplicity)
}

/// Breaks of the splines, of the weights and of the target force.
fn cut_at_samples(asked: &Asked, splines: &Splines) -> Vec<f64> {
    let mut cuts = splines.breaks().to_vec();
    cuts.extend(asked.ranges.iter().flat_map(|r| [r.from, r.to]));
    if let Some((target, _)) = &asked.target {
        let n = target.force_n.len();
        cuts.extend((1..n).map(|i| TAU * i as f64 / n as f64));
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    }
    cuts
}

/// Gauss points of the quadratic part of the objective. For a force, each piece of span and target has four points, which are exact for the square of
/// the target.
fn nodes(asked: &Asked, splines: &Splines) -> Vec<Node> {
    let parts = match asked.objective {
        Objective::ForceError => vec![(None, 1.0)],
        Objective::Energy(order) => vec![(Some(order), 1.0)],
        Objective::Size => vec![(Some(3), 1.0 / (asked.length() * SIZE_JERK * SIZE_JERK))],
        Objective::Peak(_) | Objective::PeakForceError => Vec::new(),
    };
    let one = |(order, factor)| part(asked, splines, order, factor);
    parts.into_iter().flat_map(one).collect()
}

/// Gauss points of one term: the force, or a derivative.
fn part(asked: &Asked, splines: &Splines, order: Option<usize>, factor: f64) -> Vec<Node> {
    let cuts = if order.is_none() {
        cut_at_samples(asked, splines)
    } else {
        splines.breaks().to_vec()
    };
    let rule = gauss(if order.is_some() {
        asked.degree + 1
    } else {
        4.max(asked.degree + 1)
    });
    let [k, c, m] = asked.weights;
    let weights = order.map_or([k, c, m, 0.0], |order| {
        std::array::from_fn(|d| f64::from(u8::from(d == order)))
    });
    let mut out = Vec::new();
    for ends in cuts.windows(2) {
        let middle = 0.5 * (ends[0] + ends[1]);
        let span = splines.span_of(middle);
        let own = order.map_or_else(|| asked.weight(middle), |_| 1.0);
        for (u, w) in &rule {
            let theta = ends[0] + u * (ends[1] - ends[0]);
            let values = splines.values(span, theta);
            let row = (0..=asked.degree)
                .map(|k| (0..ORDERS).map(|d| weights[d] * values[d][k]).sum())
                .collect();
            let target = asked.target.as_ref().filter(|_| order.is_none());
            out.push(Node {
                span,
                row,
                wanted: target.map_or(0.0, |t| t.0.at(theta) - asked.rest),
                weight: factor * own * w * (ends[1] - ends[0]) / TAU,
            });
        }
    }
    out
}

/// Solution of the demands, and an orthonormal basis of their rows; `None` if they are contradictory.
fn particular(
    n: usize,
    demands: Vec<(Vec<f64>, f64)>,
) -> Option<(DVector<f64>, Vec<DVector<f64>>)> {
    let (mut origin, mut rows) = (DVector::zeros(n), Vec::<DVector<f64>>::new());
    for (row, value) in demands {
        let row = DVector::from_vec(row);
        let left = value - row.dot(&origin);
        let own = off(&rows, row.clone());
        if own.norm() > 1e-9 * row.norm() {
            origin += &own * (left / own.norm_squared());
            rows.push(own.normalize());
        } else if left.abs() > 1e-9 * (value.abs() + row.norm() * origin.amax()) {
            return None;
        }
    }
    Some((origin, rows))
}

/// Component of a vector that is orthogonal to orthonormal rows.
fn off(rows: &[DVector<f64>], mut x: DVector<f64>) -> DVector<f64> {
    for _ in 0..2 {
        for r in rows {
            x -= r * r.dot(&x);
        }
    }
    x
}

/// Orthonormal basis of the complement of the rows.
fn complement(n: usize, rows: &[DVector<f64>]) -> DMatrix<f64> {
    let mut all = rows.to_vec();
    let mut left: Vec<DVector<f64>> = (0..n)
        .map(|i| {
            off(
                &all,
                DVector::from_fn(n, |k, _| f64::from(u8::from(k == i))),
            )
        })
        .collect();
    while all.len() < n {
        let longest = (0..n).max_by(|a, b| left[*a].norm().total_cmp(&left[*b].norm()));
        let own = off(&all, left[longest.unwrap_or(0)].normalize()).normalize();
        for x in &mut left {
            *x -= &own * own.dot(x);
        }
        all.push(own);
    }
    let own = &all[rows.len()..];
    DMatrix::from_fn(n, own.len(), |i, j| own[j][i])
}
