//! Solution of the linear system of a step, which is sparse, symmetric and indefinite.

use rsparse::data::{Sprs, Trpl};

/// Minimum ratio of a diagonal entry to the maximum entry of its column for which the diagonal entry is used as the pivot. Other pivots
/// cause fill-in.
const THRESHOLD: f64 = 0.1;
/// Number of iterative refinements of a solution.
const CORRECTIONS: usize = 2;
/// Ordering of the unknowns in `rsparse`; 0 is minimum degree for the pattern of A + Aᵀ.
const ORDERING: i8 = 0;

/// Solution of A y = b. The lower triangle of A is given as (row, column, value). Values at the same position are added. `None` if A is
/// singular.
pub fn symmetric_solution(lower: &[(usize, usize, f64)], b: &[f64]) -> Option<Vec<f64>> {
    // The ordering of `rsparse` needs at least two unknowns, so a single unknown is solved directly.
    if let [b] = b {
        let a: f64 = lower.iter().map(|entry| entry.2).sum();
        return Some(vec![b / a]).filter(|y| y[0].is_finite());
    }
    let mut entries = lower.to_vec();
    entries.sort_by_key(|&(i, j, _)| (i, j));
    entries.dedup_by(|more, kept| {
        let is_same = (more.0, more.1) == (kept.0, kept.1);
        kept.2 += if is_same { more.2 } else { 0.0 };
        is_same
    });
    let mut triplets = Trpl::new();
    for (i, j, value) in entries {
        triplets.append(i, j, value);
        if i != j {
            triplets.append(j, i, value);
        }
    }
    let matrix = triplets.to_sprs();
    let mut symbolic = rsparse::sqr(&matrix, ORDERING, false);
    let factor = rsparse::lu(&matrix, &mut symbolic, THRESHOLD).ok()?;
    let solved = |b: &[f64]| {
        let mut x = permuted(factor.pinv.as_deref(), b);
        rsparse::lsolve(&factor.l, &mut x);
        rsparse::usolve(&factor.u, &mut x);
        permuted(symbolic.q.as_deref(), &x)
    };
    let mut y = solved(b);
    for _ in 0..CORRECTIONS {
        let left = residual(&matrix, &y, b);
        y.iter_mut().zip(solved(&left)).for_each(|(y, d)| *y += d);
    }
    y.iter().all(|v| v.is_finite()).then_some(y)
}

/// Vector whose entry `order[k]` is the entry k of x.
fn permuted(order: Option<&[isize]>, x: &[f64]) -> Vec<f64> {
    let Some(order) = order else {
        return x.to_vec();
    };
    let mut out = vec![0.0; x.len()];
    order
        .iter()
        .zip(x)
        .for_each(|(&to, x)| out[to as usize] = *x);
    out
}

/// Residual b − A y.
fn residual(matrix: &Sprs<f64>, y: &[f64], b: &[f64]) -> Vec<f64> {
    let turned: Vec<f64> = y.iter().map(|v| -v).collect();
    rsparse::gaxpy(matrix, &turned, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// Pseudo-random number between −1 and 1 for an index.
    fn scatter(i: usize) -> f64 {
        let mixed = (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        ((mixed ^ (mixed >> 29)) >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
    }

    /// Matrix with a band of `n` unknowns and `m` rows of six entries each; two entries at the same position are added.
    fn step(n: usize, m: usize) -> Vec<(usize, usize, f64)> {
        let mut lower: Vec<(usize, usize, f64)> = (0..n).map(|i| (i, i, 1e-9)).collect();
        for i in 0..n {
            let near = i.saturating_sub(4)..=i;
            lower.extend(near.map(|j| (i, j, scatter(7 * i + j) * 10f64.powi((i % 5) as i32 - 4))));
        }
        for r in 0..m {
            let first = r * (n - 6) / m;
            lower.extend((first..first + 6).map(|j| (n + r, j, scatter(11 * r + j))));
            lower.push((n + r, n + r, -1e-13));
        }
        lower
    }

    #[test]
    fn solutions_are_those_of_the_dense_system() {
        for (n, m) in [(12, 0), (30, 7), (120, 60), (200, 150)] {
            let lower = step(n, m);
            let mut dense = DMatrix::<f64>::zeros(n + m, n + m);
            for &(i, j, value) in &lower {
                dense[(i, j)] += value;
                if i != j {
                    dense[(j, i)] += value;
                }
            }
            let b: Vec<f64> = (0..n + m).map(|i| scatter(1000 + i)).collect();
            let own = symmetric_solution(&lower, &b).unwrap();
            let b = DVector::from_vec(b);
            let lu = dense.clone().lu();
            let mut other = lu.solve(&b).unwrap();
            for _ in 0..2 {
                other += lu.solve(&(&b - &dense * &other)).unwrap();
            }
            let apart = (DVector::from_vec(own) - &other).amax() / other.amax();
            assert!(apart < 1e-7, "{n} {m}: {apart:e}");
        }
    }

    #[test]
    fn a_singular_system_has_no_solution() {
        let twice = [(0, 0, 1.0), (1, 0, 1.0), (1, 1, 1.0)];
        assert!(symmetric_solution(&twice, &[1.0, 2.0]).is_none());
        assert_eq!(symmetric_solution(&[(0, 0, 4.0)], &[2.0]), Some(vec![0.5]));
        assert!(symmetric_solution(&[(0, 0, 0.0)], &[2.0]).is_none());
        let unknown = [(0, 0, f64::NAN), (1, 1, 1.0)];
        assert!(symmetric_solution(&unknown, &[1.0, 2.0]).is_none());
    }
}
