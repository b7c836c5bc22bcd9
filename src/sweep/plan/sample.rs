//! Evenly distributed points in the unit cube: Latin hypercube and Sobol sequence. Each point is computed only from its index.

use gaitcam_base::random::{mixed, unit};
use serde::{Deserialize, Serialize};

/// Sampling method for the values of the axes.
///
/// ```
/// use gaitcam::sweep::Method;
///
/// // Each of ten intervals of the axis contains one of ten points.
/// let mut slices: Vec<u64> = (0..10).map(|i| (10.0 * Method::Latin.coordinate(i, 10, 0, 1)) as u64).collect();
/// slices.sort_unstable();
/// assert_eq!(slices, (0..10).collect::<Vec<u64>>());
/// ```
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, strum::IntoStaticStr, Serialize, Deserialize,
)]
#[strum(serialize_all = "kebab-case")]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Latin hypercube. Each axis is divided into N equal intervals, and each interval contains exactly one of the N points, at a random
    /// position.
    #[default]
    Latin,
    /// Sobol sequence. Its points fill the unit cube evenly. A larger number of points continues the same sequence.
    Sobol,
}

/// Maximum number of axes for which the Sobol sequence is available.
pub const SOBOL_AXES: usize = 21;

impl Method {
    /// Name of the method on the command line.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Coordinate of the point `index` on the axis `axis`, in [0, 1). `count` is the number of points. Equal values of `seed` give equal
    /// points.
    pub fn coordinate(self, index: u64, count: u64, axis: usize, seed: u64) -> f64 {
        match self {
            Method::Latin => latin(index, count, axis, seed),
            Method::Sobol => sobol(index, axis),
        }
    }
}

fn latin(index: u64, count: u64, axis: usize, seed: u64) -> f64 {
    let key = mixed(seed ^ mixed(axis as u64 + 1));
    let slice = permuted(index, count, key);
    let within = unit(mixed(key ^ mixed(slice)));
    ((slice as f64 + within) / count as f64).min(1.0 - f64::EPSILON / 2.0)
}

/// Permutation of 0 … count − 1 that is computed without a table. A Feistel network with four rounds permutes the numbers below the next
/// power of two with an even exponent. The network is applied again until the result is below `count`.
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = 64 - count.saturating_sub(1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1_u64 << half) - 1;
    let mut x = index;
    loop {
        let (mut left, mut right) = (x >> half, x & mask);
        for round in 0..4 {
            let f = mixed(key ^ mixed(right + (round << 40)));
            (left, right) = (right, left ^ (f & mask));
        }
        x = left << half | right;
        if x < count {
            return x;
        }
    }
}

/// Degree, coefficients of the primitive polynomial and first direction numbers for the axes 2, 3, … (Joe and Kuo 2008, table
/// new-joe-kuo-6).
const JOE_KUO: [(u32, u32, &[u64]); SOBOL_AXES - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
];

/// Number of bits of a Sobol coordinate. It is sufficient for 2⁴⁰ points.
const SOBOL_BITS: u32 = 40;

fn sobol(index: u64, axis: usize) -> f64 {
    let gray = index ^ (index >> 1);
    let mut x = 0_u64;
    if axis == 0 {
        x = gray.reverse_bits() >> (64 - SOBOL_BITS);
    } else {
        let (degree, polynomial, first) = JOE_KUO[(axis - 1).min(SOBOL_AXES - 2)];
        let degree = degree as usize;
        let mut m = [0_u64; SOBOL_BITS as usize];
        let used = (64 - gray.leading_zeros()).min(SOBOL_BITS) as usize;
        for k in 0..used {
            m[k] = if k < degree {
                first[k]
            } else {
                let mut v = m[k - degree] ^ (m[k - degree] << degree);
                for i in 1..degree {
                    if polynomial >> (degree - 1 - i) & 1 == 1 {
                        v ^= m[k - i] << i;
                    }
                }
                v
            };
            if gray >> k & 1 == 1 {
                x ^= m[k] << (SOBOL_BITS as usize - 1 - k);
            }
        }
    }
    x as f64 / (1_u64 << SOBOL_BITS) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latin_puts_one_point_into_every_slice_of_every_axis() {
        for count in [1_u64, 2, 7, 100, 1000] {
            for axis in 0..5 {
                let mut seen = vec![false; count as usize];
                for i in 0..count {
                    let x = Method::Latin.coordinate(i, count, axis, 42);
                    seen[(x * count as f64) as usize] = true;
                }
                assert!(seen.iter().all(|s| *s), "{count} {axis}");
            }
        }
    }

    #[test]
    fn sobol_fills_the_dyadic_slices_of_every_axis_evenly() {
        for axis in 0..SOBOL_AXES {
            for bits in 0..10 {
                let count = 1_usize << bits;
                let mut seen = vec![0; count];
                for i in 0..count {
                    seen[(Method::Sobol.coordinate(i as u64, 0, axis, 0) * count as f64)
                        as usize] += 1;
                }
                assert!(seen.iter().all(|s| *s == 1), "axis {axis}, {count} points");
            }
        }
    }

    #[test]
    fn sobol_begins_as_published() {
        // Example output of the program of Joe and Kuo for three axes: points 1 to 5 in Gray-code order.
        let expected = [
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
        ];
        for (i, point) in expected.iter().enumerate() {
            for (axis, x) in point.iter().enumerate() {
                assert_eq!(Method::Sobol.coordinate(i as u64 + 1, 0, axis, 0), *x);
            }
        }
    }
}
