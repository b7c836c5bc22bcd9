//! Least squares of a linear model with physical signs, a shift of the phase, and intervals.

use nalgebra::{DMatrix, DVector};

use super::cycles::{Averaged, derivative, shifted};

/// Singular values below this fraction of the largest count as zero; columns are normalised.
const RANK: f64 = 1e-9;
/// Number of trial shifts around a turn before the best is refined, and number of refinement steps.
const SHIFTS: usize = 720;
const STEPS: usize = 20;
/// Number of standard deviations by which the residual's energy must exceed the noise for a repeatable error.
pub(super) const EXCESS: f64 = 3.0;

/// One column of the linear model.
#[derive(Debug, Clone)]
pub(super) struct Column {
    pub values: Vec<f64>,
    pub is_positive: bool,
}

/// A parameter with the ends of its 95 % interval, which are infinite if the columns do not determine it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Estimate {
    pub value: f64,
    pub ends: [f64; 2],
}

/// Result of the fit.
pub(super) struct Fit {
    /// Phase delay of the log, rad.
    pub shift: Estimate,
    pub each: Vec<Estimate>,
    /// The cycles shifted to the phase of the machine.
    pub measured: Averaged,
    /// Energy of the repeatable mean residual per harmonic, from the first.
    pub repeats: Vec<f64>,
    /// Variance of a component of the repeatable residual in its effective harmonics.
    pub component: f64,
}

/// Range of shifts, from the first to the last, rad.
pub(super) type Shifts = [f64; 2];

/// Fits columns to the mean of cycles at the best shift.
pub(super) fn fit(columns: &[Column], cycles: &Averaged, shifts: Shifts) -> Fit {
    let solver = Bounded::new(columns);
    let mut shift = best_shift(&solver, &cycles.mean, shifts);
    let is_free = shifts[1] > shifts[0];
    let mut values = solver.solve(&shifted(&cycles.mean, shift)).0;
    for _ in 0..if is_free { STEPS } else { 0 } {
        let y = shifted(&cycles.mean, shift);
        let slope = solver.direction(&values);
        let left = difference(&y, &solver.model(&values));
        // What the other columns cannot follow of the shift.
        let own = solver.without_free(&slope, &values);
        let size = dot(&own, &own);
        let step = if size > 0.0 {
            dot(&own, &left) / size
        } else {
            0.0
        };
        let next = (shift + step).clamp(shifts[0], shifts[1]);
        (values, shift) = (solver.solve(&shifted(&cycles.mean, next)).0, next);
        if step.abs() < 1e-12 {
            break;
        }
    }
    let measured = cycles.map(|c| shifted(c, shift));
    let slope = is_free.then(|| solver.direction(&values));
    intervals(&solver, &values, slope, measured, shift)
}

/// The intervals include all columns, also those at their bound, which a repeatable force may cause.
fn intervals(
    solver: &Bounded,
    values: &[f64],
    slope: Option<Vec<f64>>,
    measured: Averaged,
    shift: f64,
) -> Fit {
    let columns = (0..values.len()).map(|i| solver.scaled(i));
    let used: Vec<Vec<f64>> = columns.chain(slope).collect();
    let operator = inverse(&used);
    let model = solver.model(values);
    let residuals = measured.map(|c| {
        let left = difference(c, &model);
        let moved = product(&operator, &left);
        (0..left.len())
            .map(|j| left[j] - used.iter().zip(&moved).map(|(u, x)| u[j] * x).sum::<f64>())
            .collect()
    });
    let left = difference(&measured.mean, &model);
    let (repeats, component, degrees) = repeatable(&left, &residuals.variance());
    let cycles = measured.each.len();
    let half = |row: &Vec<f64>| {
        let size = dot(row, row);
        let noise = measured.map(|c| vec![dot(row, c)]).variance()[0];
        let noise = t95(cycles - 1) * noise.sqrt();
        let doubt = t95(degrees) * (component * size).sqrt();
        let is_seen = row.iter().all(|x| x.is_finite()) && size > 0.0;
        if is_seen {
            noise.hypot(doubt)
        } else {
            f64::INFINITY
        }
    };
    // About the least squares without signs, whose scatter this is; the value within the signs is one of the possible ones.
    let estimate = |value: f64, row: Option<&Vec<f64>>, scale: f64| {
        let known = row.map(|row| (value + dot(row, &left), half(row)));
        let (centre, half) = known
            .filter(|k| k.1.is_finite())
            .unwrap_or((value, f64::INFINITY));
        Estimate {
            value: value / scale,
            ends: [
                (centre - half).min(value) / scale,
                (centre + half).max(value) / scale,
            ],
        }
    };
    let count = values.len();
    let each = (0..count).map(|i| estimate(values[i], operator.get(i), solver.scales[i]));
    let shift = estimate(shift, operator.get(count), 1.0);
    Fit {
        shift,
        each: each.collect(),
        measured,
        repeats,
        component,
    }
}

/// Repeatable part of a mean residual whose entries have these variances: energy per harmonic, variance of a component in its effective number of
/// harmonics (participation ratio), and that number.
fn repeatable(left: &[f64], variance: &[f64]) -> (Vec<f64>, f64, usize) {
    let pair = |x: &[f64], n: usize| x[2 * n - 1] + x[2 * n];
    let squares: Vec<f64> = left.iter().map(|x| x * x).collect();
    let count = left.len() / 2;
    let total: f64 = squares[1..].iter().sum();
    let noise: f64 = variance[1..].iter().sum();
    let fourth: f64 = variance[1..].iter().map(|v| v * v).sum();
    if total <= noise + EXCESS * (2.0 * fourth).sqrt() {
        return (vec![0.0; count], 0.0, count);
    }
    let excess = |n: usize| (pair(&squares, n) - pair(variance, n)).max(0.0);
    let energy: Vec<f64> = (1..=count).map(excess).collect();
    let sum: f64 = energy.iter().sum();
    let harmonics = (sum * sum / energy.iter().map(|p| p * p).sum::<f64>()).max(1.0);
    (energy, sum / (2.0 * harmonics), harmonics as usize)
}

fn best_shift(solver: &Bounded, mean: &[f64], [from, to]: Shifts) -> f64 {
    let step = std::f64::consts::TAU / SHIFTS as f64;
    let tried = (0..=((to - from) / step) as usize).map(|i| from + step * i as f64);
    let error = |shift: f64| (shift, solver.solve(&shifted(mean, shift)).1);
    let best = tried.map(error).min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or(from, |b| b.0)
}

/// Least squares with some non-negative unknowns (Lawson and Hanson 1974), on normalised columns.
struct Bounded {
    columns: DMatrix<f64>,
    is_positive: Vec<bool>,
    scales: Vec<f64>,
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl Bounded {
    fn new(columns: &[Column]) -> Bounded {
        let size = |c: &Column| dot(&c.values, &c.values).sqrt();
        let scales: Vec<f64> = columns.iter().map(size).collect();
        let rows = columns.first().map_or(0, |c| c.values.len());
        let columns_of = |i: usize, j: usize| columns[j].values[i] / scales[j];
        let matrix = DMatrix::from_fn(rows, columns.len(), columns_of);
        let qr = matrix.clone().qr();
        Bounded {
            is_positive: columns.iter().map(|c| c.is_positive).collect(),
            q: qr.q(),
            r: qr.r(),
            columns: matrix,
            scales,
        }
    }

    fn scaled(&self, i: usize) -> Vec<f64> {
        self.columns.column(i).as_slice().to_vec()
    }

    fn is_free(&self, values: &[f64], i: usize) -> bool {
        !self.is_positive[i] || values[i] > 0.0
    }

    fn model(&self, values: &[f64]) -> Vec<f64> {
        let sum = &self.columns * DVector::from_column_slice(values);
        sum.as_slice().to_vec()
    }

    /// Change of the shifted cycles per predicted shift.
    fn direction(&self, values: &[f64]) -> Vec<f64> {
        let minus = |x: f64| -x;
        derivative(&self.model(values))
            .into_iter()
            .map(minus)
            .collect()
    }

    /// A column minus its projection on the free ones.
    fn without_free(&self, column: &[f64], values: &[f64]) -> Vec<f64> {
        let free = (0..values.len()).filter(|i| self.is_free(values, *i));
        let used: Vec<Vec<f64>> = free.map(|i| self.scaled(i)).collect();
        let moved = product(&inverse(&used), column);
        let follow = |j: usize| used.iter().zip(&moved).map(|(u, x)| u[j] * x).sum::<f64>();
        (0..column.len()).map(|j| column[j] - follow(j)).collect()
    }

    /// Unknowns, and the remaining sum of squares.
    fn solve(&self, y: &[f64]) -> (Vec<f64>, f64) {
        let y = DVector::from_column_slice(y);
        let right = self.q.tr_mul(&y);
        let count = self.scales.len();
        let mut passive: Vec<bool> = self.is_positive.iter().map(|p| !p).collect();
        let mut x = self.passive(&right, &passive);
        for _ in 0..4 * count {
            let gradient = self.r.tr_mul(&(&right - &self.r * &x));
            let pulls = (0..count).filter(|i| !passive[*i] && gradient[*i] > RANK * right.norm());
            let Some(next) = pulls.max_by(|a, b| gradient[*a].total_cmp(&gradient[*b])) else {
                break;
            };
            passive[next] = true;
            loop {
                let full = self.passive(&right, &passive);
                let negative = |i: &usize| passive[*i] && self.is_positive[*i] && full[*i] <= 0.0;
                let blocked = (0..count).filter(negative);
                let part = |i: usize| x[i] / (x[i] - full[i]).max(f64::MIN_POSITIVE);
                let first = blocked.min_by(|a, b| part(*a).total_cmp(&part(*b)));
                let Some(first) = first else {
                    x = full;
                    break;
                };
                let part = part(first).clamp(0.0, 1.0);
                x = &x + part * (full - &x);
                (passive[first], x[first]) = (false, 0.0);
            }
        }
        let left = (&right - &self.r * &x).norm_squared();
        (
            x.as_slice().to_vec(),
            y.norm_squared() - right.norm_squared() + left,
        )
    }

    fn passive(&self, right: &DVector<f64>, passive: &[bool]) -> DVector<f64> {
        let places: Vec<usize> = (0..passive.len()).filter(|i| passive[*i]).collect();
        let mut out = DVector::zeros(passive.len());
        if places.is_empty() {
            return out;
        }
        let svd = self.r.select_columns(&places).svd(true, true);
        let limit = RANK * svd.singular_values.max();
        if let Ok(found) = svd.solve(right, limit) {
            places
                .iter()
                .zip(found.iter())
                .for_each(|(i, x)| out[*i] = *x);
        }
        out
    }
}

/// Rows of the pseudoinverse of a matrix of columns; a row is not finite where a column is a combination of the others.
fn inverse(columns: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let Some(first) = columns.first() else {
        return Vec::new();
    };
    let sizes: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
    let matrix = DMatrix::from_fn(first.len(), columns.len(), |i, j| columns[j][i] / sizes[j]);
    let svd = matrix.svd(true, true);
    let (Some(u), Some(vt)) = (&svd.u, &svd.v_t) else {
        return vec![vec![f64::NAN; first.len()]; columns.len()];
    };
    let limit = RANK * svd.singular_values.max();
    let entry = |j: usize, i: usize| -> f64 {
        let terms = (0..svd.singular_values.len()).map(|k| {
            let (v, s) = (vt[(k, j)], svd.singular_values[k]);
            match s > limit {
                true => v * u[(i, k)] / s,
                false if v.abs() > 1e-6 => f64::NAN,
                false => 0.0,
            }
        });
        terms.sum::<f64>() / sizes[j]
    };
    (0..columns.len())
        .map(|j| (0..first.len()).map(|i| entry(j, i)).collect())
        .collect()
}

fn product(rows: &[Vec<f64>], y: &[f64]) -> Vec<f64> {
    let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
    rows.iter().map(|row| finite(dot(row, y))).collect()
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Quantile 0.975 of Student's t: tabulated for few degrees of freedom, beyond them the expansion of Cornish and Fisher.
pub(super) fn t95(degrees: usize) -> f64 {
    const FEW: [f64; 6] = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447];
    if let Some(known) = FEW.get(degrees.max(1) - 1) {
        return *known;
    }
    let (z, n) = (1.959_963_984_540_054_f64, degrees as f64);
    let first = (z.powi(3) + z) / 4.0;
    let second = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
    let third = (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / 384.0;
    z + first / n + second / (n * n) + third / (n * n * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (degrees, known) in [
            (1, 12.706),
            (4, 2.776),
            (5, 2.571),
            (7, 2.365),
            (10, 2.228),
            (30, 2.042),
            (120, 1.980),
        ] {
            assert!(
                (t95(degrees) - known).abs() < 2e-3,
                "{degrees}: {}",
                t95(degrees)
            );
        }
    }

    #[test]
    fn bounded_solution_satisfies_the_conditions_of_its_optimum() {
        // x ≥ 0, gradient ≥ 0 where x = 0, gradient = 0 where x > 0; on every sign of two directions.
        let columns = [
            [1.0, 2.0, 0.0, 1.0],
            [0.5, 1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0, 0.2],
        ];
        let columns = columns.map(|c| Column {
            values: c.to_vec(),
            is_positive: true,
        });
        let solver = Bounded::new(&columns);
        for k in 0..64_i32 {
            let y: Vec<f64> = (0..4).map(|i| f64::from(k >> i & 3) - 1.5).collect();
            let (x, left) = solver.solve(&y);
            let error = difference(&y, &solver.model(&x));
            assert!((dot(&error, &error) - left).abs() < 1e-12);
            for (i, x) in x.iter().enumerate() {
                let gradient = dot(&solver.scaled(i), &error);
                assert!(*x >= 0.0 && gradient < 1e-9 && (*x == 0.0 || gradient > -1e-9));
            }
        }
    }
}
