//! Optimum with only equality constraints. It needs one factorisation of H and the solution of a dense system whose size is the number of
//! equalities.

use super::band::{ArrowFactor, ArrowMatrix};
use super::basis::{Basis, apply, dense};
use super::program::{Equality, Failure, Program, Stop};
use crate::Names;

/// Optimum subject to the equalities only, with the factorised Hessian.
pub struct Unlimited {
    /// H, made positive definite by adding multiples of the outer products of the equalities.
    pub hessian: ArrowMatrix,
    /// Cholesky factor of the Hessian.
    pub factor: ArrowFactor,
    /// Negative gradient −g of the linear part that belongs to `hessian`.
    pub pull: Vec<f64>,
    /// Coefficients of the optimum subject to the equalities only.
    pub x: Vec<f64>,
    /// Index of the coefficient that has an additional quadratic term to fix the level, and the weight of this term. `None` if the
    /// objective or the equalities fix the level.
    pub pin: Option<(usize, f64)>,
}

/// Minimises ½xᵀHx + gᵀx subject to the equalities.
///
/// H may be singular in directions that the equalities fix. Multiples of the outer products of the equalities make H positive definite
/// without changing the constrained optimum. The level of the law may be undetermined. On a moving axis, for example, the force does not
/// depend on the level of the lift. In this case, a quadratic term is added for one coefficient. Its weight is small if limits determine
/// the level.
///
/// # Errors
///
/// The equalities contradict each other, or the matrix of the objective cannot be factorised.
pub fn solve<N: Names>(program: &Program<N>) -> Result<Unlimited, Failure<N>> {
    let (hessian, pin) = regular(program);
    let factor = hessian.clone().factor().ok_or(Stop::SingularObjective)?;
    let pull: Vec<f64> = augmented_gradient(program).iter().map(|g| -g).collect();
    let mut x = pull.clone();
    factor.solve(&mut x);
    if !program.equalities.is_empty() {
        x = correct(program, &factor, x)?;
    }
    Ok(Unlimited {
        hessian,
        factor,
        pull,
        x,
        pin,
    })
}

/// Weight ρ of the normalised outer products of the equalities: the maximum diagonal entry of H, or 1 if H is zero.
fn penalty<N: Names>(program: &Program<N>) -> f64 {
    let h = program.hessian.largest_diagonal();
    if h > 0.0 { h } else { 1.0 }
}

/// Equalities at a single angle, whose outer products fit into the band. Equalities on an integral over the law are only part of the dense
/// system.
fn local<N: Names>(program: &Program<N>) -> impl Iterator<Item = &Equality<N>> {
    let widest = match &program.basis {
        Basis::Spline { space, .. } => space.degree() + 1,
        Basis::Harmonic { .. } => usize::MAX,
    };
    program
        .equalities
        .iter()
        .filter(move |e| e.entries.len() <= widest)
}

fn regular<N: Names>(program: &Program<N>) -> (ArrowMatrix, Option<(usize, f64)>) {
    let mut h = program.hessian.clone();
    let rho = penalty(program);
    for e in local(program) {
        let norm: f64 = e.entries.iter().map(|e| e.1 * e.1).sum();
        let weight = if norm > 0.0 { rho / norm } else { 0.0 };
        for (p, &(i, a)) in e.entries.iter().enumerate() {
            for &(j, b) in &e.entries[..=p] {
                h.add(i, j, weight * a * b);
            }
        }
    }
    let mut pin = None;
    if program.level_is_open() {
        let at = match program.basis {
            Basis::Spline { .. } => h.dimension() - 1,
            Basis::Harmonic { .. } => 0,
        };
        let moved = program.limits.iter().any(|l| l.weights[0] != 0.0) || !program.fixed.is_empty();
        let weight = if moved {
            program.settings.equality.light_pin * rho
        } else {
            rho
        };
        h.add(at, at, weight);
        pin = Some((at, weight));
    }
    (h, pin)
}

/// Maximum decrease ½rᵀH⁻¹r of an objective with the gradient r, for the augmented H with fixed level. `None` if H is singular in further
/// directions.
pub fn largest_decrease<N: Names>(program: &Program<N>, gradient: &[f64]) -> Option<f64> {
    let factor = regular(program).0.factor()?;
    let mut whitened = gradient.to_vec();
    factor.forward(&mut whitened);
    Some(0.5 * whitened.iter().map(|w| w * w).sum::<f64>())
}

/// Linear part g − ρ Σ value·row/|row|² of the objective that belongs to the augmented H.
fn augmented_gradient<N: Names>(program: &Program<N>) -> Vec<f64> {
    let mut g = program.gradient.clone();
    let rho = penalty(program);
    for e in local(program) {
        let norm: f64 = e.entries.iter().map(|e| e.1 * e.1).sum();
        if norm > 0.0 {
            for &(i, a) in &e.entries {
                g[i] -= rho / norm * e.value * a;
            }
        }
    }
    g
}

/// Projects `x` onto the equalities along H⁻¹Eᵀ. Dependent equalities are omitted, in the order of their pivots. It is an error if the
/// result does not satisfy them.
fn correct<N: Names>(
    program: &Program<N>,
    factor: &ArrowFactor,
    mut x: Vec<f64>,
) -> Result<Vec<f64>, Failure<N>> {
    let settings = &program.settings.equality;
    let equalities = &program.equalities;
    let k = equalities.len();
    let directions: Vec<Vec<f64>> = equalities
        .iter()
        .map(|e| {
            let mut y = dense(&e.entries, x.len());
            factor.solve(&mut y);
            y
        })
        .collect();
    // S = E H⁻¹ Eᵀ, scaled to a unit diagonal.
    let raw = |i: usize, j: usize| apply(&equalities[i].entries, &directions[j]);
    let unit: Vec<f64> = (0..k).map(|i| raw(i, i).max(0.0).sqrt()).collect();
    let safe = |u: f64| if u > 0.0 { u } else { 1.0 };
    let s: Vec<Vec<f64>> = (0..k)
        .map(|i| {
            (0..k)
                .map(|j| raw(i, j) / (safe(unit[i]) * safe(unit[j])))
                .collect()
        })
        .collect();
    let (kept, dependent) = by_pivots(s.clone(), settings.dependent);
    let rank = kept.len();
    let matrix = nalgebra::DMatrix::from_fn(rank, rank, |i, j| s[kept[i]][kept[j]]);
    let decomposed = matrix.lu();
    // The second pass reduces the residual that the condition number of S causes.
    for _ in 0..2 {
        let rhs = nalgebra::DVector::from_fn(rank, |i, _| {
            let e = &equalities[kept[i]];
            (e.value - apply(&e.entries, &x)) / safe(unit[kept[i]])
        });
        let Some(lambda) = decomposed.solve(&rhs) else {
            return Err(Stop::SingularEqualities.into());
        };
        for (i, &equality) in kept.iter().enumerate() {
            let step = lambda[i] / safe(unit[equality]);
            for (xi, d) in x.iter_mut().zip(&directions[equality]) {
                *xi += step * d;
            }
        }
    }
    let missed: Vec<N::Equality> = dependent
        .iter()
        .map(|&i| &equalities[i])
        .filter(|e| e.missed(&x, program.length) > settings.consistent)
        .map(|e| e.name)
        .collect();
    if missed.is_empty() {
        Ok(x)
    } else {
        Err(Failure::Inconsistent { equalities: missed })
    }
}

/// Indices of the rows of a symmetric matrix, ordered by the pivots of its Cholesky factor. The second list contains the rows whose pivots
/// would be below `dependent`.
fn by_pivots(mut s: Vec<Vec<f64>>, dependent: f64) -> (Vec<usize>, Vec<usize>) {
    let mut order: Vec<usize> = (0..s.len()).collect();
    for p in 0..s.len() {
        let (best, pivot) = (p..s.len())
            .map(|q| (q, s[order[q]][order[q]]))
            .fold((p, f64::NEG_INFINITY), |b, c| if c.1 > b.1 { c } else { b });
        if pivot < dependent {
            let rest = order.split_off(p);
            return (order, rest);
        }
        order.swap(p, best);
        let o = order[p];
        let rest = &order[p + 1..];
        for &r in rest {
            let f = s[r][o] / pivot;
            for &c in rest {
                s[r][c] -= f * s[o][c];
            }
        }
    }
    (order, Vec::new())
}

impl<N: Names> Equality<N> {
    /// Residual of the equality for coefficients of typical size `length`, relative to the size of the equality.
    pub(crate) fn missed(&self, x: &[f64], length: f64) -> f64 {
        let size = self.entries.iter().fold(0.0_f64, |m, e| m.max(e.1.abs())) * length;
        (apply(&self.entries, x) - self.value).abs() / size.max(self.value.abs())
    }
}
