//! Fixed-point iteration of design and machine state: each design is computed for the state that the previous design causes.

use crate::error::Result;

/// Maximum number of designs in the iteration.
const ROUNDS: usize = 30;
/// Number of earlier iterates used by the acceleration.
const MEMORY: usize = 5;
/// Minimum independent fraction of a residual difference. If a smaller fraction is linearly independent of the later differences, the
/// difference is not used.
const DEPENDENT: f64 = 1e-6;

/// A design with the machine state that it causes.
pub struct Round<D> {
    /// Design that is computed in this iterate.
    pub design: D,
    /// Machine state that the design causes.
    pub made: Vec<f64>,
    /// Whether a law exists for this iterate.
    pub has_law: bool,
}

/// Result of the fixed-point iteration.
pub struct FixedPoint<D> {
    /// Final design of the iteration.
    pub design: D,
    /// State that the final design causes; `None` if the iteration has converged.
    pub made: Option<Vec<f64>>,
    /// Number of designs that were computed.
    pub rounds: usize,
    /// Ratio of the last residual to the previous residual; `None` after a single iterate.
    pub contraction: Option<f64>,
    /// Residual of the final iterate: maximum difference between the assumed state and the caused state.
    pub difference: f64,
}

/// Iterates until the state caused by a design differs from the assumed state by at most `allowed`. If an iterate has no law, or if the
/// iteration does not converge, the result is the design with the minimum residual.
///
/// # Errors
///
/// The errors of a single design.
pub fn settled<D>(
    mut given: Vec<f64>,
    allowed: f64,
    mut round: impl FnMut(&[f64]) -> Result<Round<D>>,
) -> Result<FixedPoint<D>> {
    let mut path: Vec<[Vec<f64>; 2]> = Vec::new();
    let mut best: Option<(f64, Round<D>)> = None;
    let (mut before, mut contraction) = (None, None);
    loop {
        let next = round(&given)?;
        let off = difference(&next.made, &given);
        let size = largest_difference(&next.made, &given);
        contraction = before.map(|before| size / before).or(contraction);
        before = Some(size);
        let rounds = path.len() + 1;
        if size <= allowed {
            return Ok(FixedPoint {
                design: next.design,
                made: None,
                rounds,
                contraction,
                difference: size,
            });
        }
        path.push([next.made.clone(), off]);
        let has_law = next.has_law;
        if best.as_ref().is_none_or(|b| has_law && size < b.0) {
            best = Some((size, next));
        }
        if let Some((difference, best)) = best.take_if(|_| !has_law || rounds == ROUNDS) {
            return Ok(FixedPoint {
                design: best.design,
                made: Some(best.made),
                rounds,
                contraction,
                difference,
            });
        }
        given = accelerated(&path[path.len().saturating_sub(MEMORY + 1)..]);
    }
}

/// Maximum absolute difference between the entries of two states.
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn subtract(from: &mut [f64], part: f64, of: &[f64]) {
    from.iter_mut().zip(of).for_each(|(x, y)| *x -= part * y);
}

/// Next assumed state: the combination of iterates with the minimum residual (Anderson acceleration; Walker and Ni 2011).
fn accelerated(path: &[[Vec<f64>; 2]]) -> Vec<f64> {
    let Some([made, off]) = path.last() else {
        return Vec::new();
    };
    let (mut next, mut rest) = (made.clone(), off.clone());
    let mut directions: Vec<[Vec<f64>; 2]> = Vec::new();
    for pair in path.windows(2).rev() {
        let [mut made, mut off] = [0, 1].map(|k| difference(&pair[1][k], &pair[0][k]));
        let size = dot(&off, &off).sqrt();
        for [other, direction] in &directions {
            let part = dot(direction, &off);
            subtract(&mut off, part, direction);
            subtract(&mut made, part, other);
        }
        let left = dot(&off, &off).sqrt();
        if left > DEPENDENT * size {
            let unit = |of: Vec<f64>| of.iter().map(|x| x / left).collect::<Vec<_>>();
            let (made, off) = (unit(made), unit(off));
            let part = dot(&off, &rest);
            subtract(&mut rest, part, &off);
            subtract(&mut next, part, &made);
            directions.push([made, off]);
        }
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_map_of_two_unknowns_that_expands_settles_in_three_rounds() {
        // x ↦ A x + b with eigenvalues −3 and 0.5. Plain fixed-point iteration diverges.
        let map = |x: &[f64]| vec![-3.0 * x[0] + 1.0, 2.0 * x[0] + 0.5 * x[1] - 1.0];
        let mut count = 0;
        let found = settled(vec![5.0, -7.0], 1e-12, |x| {
            count += 1;
            Ok(Round {
                design: x.to_vec(),
                made: map(x),
                has_law: true,
            })
        });
        let found = found.unwrap();
        // x = 1/4, y = 2 (2/4 − 1) = −1.
        assert!((found.design[0] - 0.25).abs() < 1e-12 && (found.design[1] + 1.0).abs() < 1e-12);
        assert!(count <= 5 && found.rounds == count, "{count}");
    }

    #[test]
    fn a_round_without_a_law_ends_with_the_nearest_law() {
        let found = settled(vec![1.0], 1e-9, |x| {
            let has_law = x[0] > 0.4;
            Ok(Round {
                design: x[0],
                made: vec![0.5 * x[0] - 1.0],
                has_law,
            })
        });
        assert_eq!(found.unwrap().design, 1.0);
    }
}
