//! Approximation of a closed profile by a periodic cubic B-spline.

use gaitcam::synth::Edge;

const MM: f64 = 1000.0;
/// Minimum and maximum number of spans of a spline.
const SPANS: [usize; 2] = [64, 16384];

/// Periodic cubic B-spline with uniform knots, counter-clockwise, mm.
pub struct Spline {
    pub control: Vec<[f64; 2]>,
}

impl Spline {
    /// Spline within `tolerance` m of the edge. The number of spans is doubled until it is sufficient. The result is `None` if the maximum number
    /// is not sufficient.
    pub fn within(edge: &Edge, tolerance: f64) -> Option<Self> {
        let mut spans = SPANS[0];
        while spans <= SPANS[1] {
            let spline = Spline::through(edge, spans);
            if spline.deviation(edge) <= MM * tolerance {
                return Some(spline);
            }
            spans *= 2;
        }
        None
    }

    /// Spline through `n` points of the edge at equal steps of the cam angle. It is counter-clockwise, in the direction opposite to the profile.
    fn through(edge: &Edge, n: usize) -> Self {
        let points: Vec<[f64; 2]> = (0..n)
            .map(|i| edge.at(angle(edge, n, i as f64)).p.map(|x| MM * x))
            .collect();
        let x = cyclic(points.iter().map(|p| p[0]).collect());
        let y = cyclic(points.iter().map(|p| p[1]).collect());
        Spline {
            control: x.into_iter().zip(y).map(|(x, y)| [x, y]).collect(),
        }
    }

    /// Control point with the index `i` modulo the number of control points.
    fn at(&self, i: usize) -> [f64; 2] {
        self.control[i % self.control.len()]
    }

    /// Maximum distance from the exact edge along its normal, mm, measured at ⅓, ½ and ⅔ of every span.
    fn deviation(&self, edge: &Edge) -> f64 {
        let n = self.control.len();
        let mut worst = 0.0_f64;
        for i in 0..n {
            for u in [1.0 / 3.0, 0.5, 2.0 / 3.0] {
                let w: f64 = 1.0 - u;
                let weights = [
                    w * w * w,
                    3.0 * u * u * u - 6.0 * u * u + 4.0,
                    3.0 * w * w * w - 6.0 * w * w + 4.0,
                    u * u * u,
                ];
                let mut p = [0.0; 2];
                for (k, weight) in weights.into_iter().enumerate() {
                    let c = self.at(i + n - 1 + k);
                    p = [p[0] + weight * c[0] / 6.0, p[1] + weight * c[1] / 6.0];
                }
                let q = edge.at(angle(edge, n, i as f64 + u));
                let d = [p[0] - MM * q.p[0], p[1] - MM * q.p[1]];
                worst = worst.max((d[0] * q.t[1] - d[1] * q.t[0]).abs());
            }
        }
        worst
    }

    /// Control points of the clamped B-spline that equals the spans `from` … `to` of this spline.
    pub fn part(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        let n = self.control.len();
        let mix = |all: &[(f64, usize)]| {
            let mut p = [0.0; 2];
            for &(weight, i) in all {
                let c = self.at(i);
                p = [p[0] + weight * c[0], p[1] + weight * c[1]];
            }
            p
        };
        let end = |i: usize| mix(&[(1.0 / 6.0, i + n - 1), (4.0 / 6.0, i), (1.0 / 6.0, i + 1)]);
        let mut out = vec![end(from), mix(&[(2.0 / 3.0, from), (1.0 / 3.0, from + 1)])];
        out.extend((from + 1..to).map(|i| self.at(i)));
        out.push(mix(&[(1.0 / 3.0, to + n - 1), (2.0 / 3.0, to)]));
        out.push(end(to));
        out
    }
}

/// Cam angle, rad, of point `i` of `n`, which are numbered in the direction opposite to the profile.
fn angle(edge: &Edge, n: usize, i: f64) -> f64 {
    let breaks = edge.breaks();
    let (start, end) = (breaks[0], breaks[breaks.len() - 1]);
    end - (end - start) * i / n as f64
}

/// Solves (c₋ + 4c + c₊)/6 = p with periodic ends, by the Thomas algorithm with the Sherman–Morrison formula.
fn cyclic(points: Vec<f64>) -> Vec<f64> {
    let n = points.len();
    // The corner entries are removed by adding their contributions to both end rows.
    let gamma = -4.0;
    let mut diagonal = vec![4.0; n];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= 1.0 / gamma;
    let solve = |mut right: Vec<f64>| {
        let mut above = vec![0.0; n];
        let mut pivot = diagonal[0];
        right[0] /= pivot;
        for i in 1..n {
            above[i - 1] = 1.0 / pivot;
            pivot = diagonal[i] - above[i - 1];
            right[i] = (right[i] - right[i - 1]) / pivot;
        }
        for i in (0..n - 1).rev() {
            right[i] -= above[i] * right[i + 1];
        }
        right
    };
    let plain = solve(points.into_iter().map(|p| 6.0 * p).collect());
    let mut corner = vec![0.0; n];
    corner[0] = gamma;
    corner[n - 1] = 1.0;
    let corner = solve(corner);
    let share = (plain[0] + plain[n - 1] / gamma) / (1.0 + corner[0] + corner[n - 1] / gamma);
    plain
        .iter()
        .zip(&corner)
        .map(|(p, c)| p - share * c)
        .collect()
}
