//! Motion that a controller executes from a file: polynomials between the points, in the number type of the controller.

use gaitcam::law::Law;
use gaitcam::poly::PiecewisePoly;

use super::Number;
use super::table::{Node, Table};

/// Curve data that a file contains, in the units of the file.
pub enum Curve {
    /// Lift, velocity and acceleration at both ends of every polynomial segment.
    Segments(Vec<[Node; 2]>),
    /// Positions, with the slopes of the spline at both ends if the file contains them.
    Points {
        points: Vec<[f64; 2]>,
        slopes: Option<[f64; 2]>,
    },
}

impl Curve {
    /// Quintic segments through points, each given by x, y, y′ and y″.
    pub fn through(nodes: &[[f64; 4]]) -> Curve {
        let node = |n: [f64; 4]| Node {
            x: n[0],
            y: n[1],
            v: n[2],
            a: n[3],
        };
        Curve::Segments(nodes.windows(2).map(|w| [node(w[0]), node(w[1])]).collect())
    }
}

/// The executed motion as a law, with positions in rad (translating cam: m) and lifts in m (oscillating follower: rad).
pub fn motion(curve: &Curve, table: &Table, number: Number) -> Law {
    let [fx, fy] = table.factors;
    let (degree, breaks, pieces): (usize, Vec<f64>, Vec<f64>) = match curve {
        Curve::Segments(segments) => {
            let left = segments.iter().map(|s| s[0].x);
            let last = segments.iter().map(|s| s[1].x).next_back();
            (
                5,
                left.chain(last).collect(),
                segments.iter().flat_map(quintic).collect(),
            )
        }
        Curve::Points { points, slopes } => {
            let m = match (slopes, table.closed) {
                (Some(ends), _) => clamped(points, *ends),
                (None, true) => periodic(points),
                (None, false) => clamped(
                    points,
                    [chord(&points[..2]), chord(&points[points.len() - 2..])],
                ),
            };
            let pieces = points
                .windows(2)
                .zip(m.windows(2))
                .flat_map(|(p, m)| cubic(p, m));
            (3, points.iter().map(|p| p[0]).collect(), pieces.collect())
        }
    };
    let breaks = breaks.into_iter().map(|x| x / fx).collect();
    let pieces = pieces.into_iter().map(|y| number.nearest(y) / fy).collect();
    Law::from_poly(PiecewisePoly::new(breaks, degree, pieces), table.closed)
}

/// Bernstein coefficients of the quintic with the lifts, velocities and accelerations at both ends.
fn quintic(ends: &[Node; 2]) -> [f64; 6] {
    let [p, q] = ends;
    let h = q.x - p.x;
    [
        p.y,
        p.y + h / 5.0 * p.v,
        p.y + 2.0 * h / 5.0 * p.v + h * h / 20.0 * p.a,
        q.y - 2.0 * h / 5.0 * q.v + h * h / 20.0 * q.a,
        q.y - h / 5.0 * q.v,
        q.y,
    ]
}

/// Bernstein coefficients of the cubic with the lifts and slopes at both ends.
fn cubic(p: &[[f64; 2]], m: &[f64]) -> [f64; 4] {
    let h = p[1][0] - p[0][0];
    [
        p[0][1],
        p[0][1] + h / 3.0 * m[0],
        p[1][1] - h / 3.0 * m[1],
        p[1][1],
    ]
}

fn chord(p: &[[f64; 2]]) -> f64 {
    (p[1][1] - p[0][1]) / (p[1][0] - p[0][0])
}

/// Slopes at the points of the cubic spline with given end slopes (de Boor, A Practical Guide to Splines, IV).
fn clamped(points: &[[f64; 2]], ends: [f64; 2]) -> Vec<f64> {
    let n = points.len();
    let (mut rows, mut right) = (vec![[0.0, 1.0, 0.0]; n], vec![0.0; n]);
    (right[0], right[n - 1]) = (ends[0], ends[1]);
    for i in 1..n - 1 {
        (rows[i], right[i]) = row(&points[i - 1..i + 1], &points[i..i + 2]);
    }
    tridiagonal(&rows, right)
}

/// Slopes at the points of the periodic cubic spline. Its matrix differs from the tridiagonal matrix of an open spline by a rank-one matrix. The
/// equations are therefore solved with the Sherman–Morrison formula.
fn periodic(points: &[[f64; 2]]) -> Vec<f64> {
    let n = points.len() - 1;
    let row_of = |i: usize| match i {
        0 => row(&points[n - 1..], &points[..2]),
        i => row(&points[i - 1..i + 1], &points[i..i + 2]),
    };
    let (mut rows, right): (Vec<[f64; 3]>, Vec<f64>) = (0..n).map(row_of).unzip();
    let (corner, back, pivot) = (rows[n - 1][2], rows[0][0], -rows[0][1]);
    rows[0][1] -= pivot;
    rows[n - 1][1] -= corner * back / pivot;
    let mut joint = vec![0.0; n];
    (joint[0], joint[n - 1]) = (pivot, corner);
    let (x, z) = (tridiagonal(&rows, right), tridiagonal(&rows, joint));
    let along = |y: &[f64]| y[0] + back / pivot * y[n - 1];
    let share = along(&x) / (1.0 + along(&z));
    let mut m: Vec<f64> = x.iter().zip(&z).map(|(x, z)| x - share * z).collect();
    m.push(m[0]);
    m
}

/// Equation for the slope at the point between two intervals. The second derivatives on both sides of the point are equal. Returns three
/// coefficients and the right side.
fn row(before: &[[f64; 2]], after: &[[f64; 2]]) -> ([f64; 3], f64) {
    let [h, k] = [before, after].map(|p| p[1][0] - p[0][0]);
    (
        [k, 2.0 * (h + k), h],
        3.0 * (k * chord(before) + h * chord(after)),
    )
}

/// Solution of a diagonally dominant tridiagonal system. A row contains the coefficients left of the diagonal, on it and right of it.
fn tridiagonal(rows: &[[f64; 3]], mut right: Vec<f64>) -> Vec<f64> {
    let n = rows.len();
    let mut upper = vec![0.0; n];
    for i in 0..n {
        let before = if i > 0 {
            (upper[i - 1], right[i - 1])
        } else {
            (0.0, 0.0)
        };
        let pivot = rows[i][1] - rows[i][0] * before.0;
        upper[i] = rows[i][2] / pivot;
        right[i] = (right[i] - rows[i][0] * before.1) / pivot;
    }
    for i in (0..n - 1).rev() {
        right[i] -= upper[i] * right[i + 1];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_have_equal_second_derivatives_on_both_sides_of_every_point() {
        let x = [0.0, 0.7, 1.1, 2.0, 2.6, 3.5, 4.4, 5.0, 5.9];
        let points: Vec<[f64; 2]> = x
            .iter()
            .map(|x| [*x, (x * std::f64::consts::TAU / 5.9).sin()])
            .collect();
        let second = |p: &[[f64; 2]], m: &[f64], end: bool| {
            let c = cubic(p, m);
            let h = p[1][0] - p[0][0];
            let bend = if end {
                c[3] - 2.0 * c[2] + c[1]
            } else {
                c[2] - 2.0 * c[1] + c[0]
            };
            6.0 / (h * h) * bend
        };
        let n = x.len() - 1;
        for (m, closed) in [
            (clamped(&points, [1.0, 1.1]), false),
            (periodic(&points), true),
        ] {
            let of = |i: usize, end: bool| second(&points[i..i + 2], &m[i..i + 2], end);
            for i in 1..n {
                assert!((of(i - 1, true) - of(i, false)).abs() < 1e-12);
            }
            assert!(!closed || (of(n - 1, true) - of(0, false)).abs() < 1e-12);
        }
    }
}
