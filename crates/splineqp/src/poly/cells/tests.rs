use super::*;
use crate::poly::{PiecewisePoly, gauss_legendre};
use std::f64::consts::TAU;

/// A rough function of smoothly joined cubics.
fn rough(n: usize) -> Cells {
    let value = |i: usize| 700.0 + 300.0 * (0.7 * i as f64).sin() + 50.0 * ((i % 5) as f64);
    let slope = |i: usize| 100.0 * (0.9 * i as f64).cos();
    let ends = |of: &dyn Fn(usize) -> f64| (0..=n).map(|i| of(i % n)).collect();
    Cells::new(ends(&value), ends(&slope), TAU)
}

fn pieces(cells: &Cells) -> PiecewisePoly {
    let n = cells.count();
    let breaks = (0..n).map(|i| TAU * i as f64 / n as f64).chain([TAU]);
    let coef = (0..n).flat_map(|i| cells.cubic(i));
    PiecewisePoly::new(breaks.collect(), 3, coef.collect())
}

/// A piecewise polynomial with pieces of different widths and with jumps between them.
fn wave(n: usize, degree: usize) -> PiecewisePoly {
    let place = |i: usize| TAU * (i as f64 / n as f64).powf(1.1);
    let breaks = (0..n).map(place).chain([TAU]).collect();
    let coef = (0..n * (degree + 1)).map(|i| 700.0 + 300.0 * (i as f64 * 0.7).sin());
    PiecewisePoly::new(breaks, degree, coef.collect())
}

#[test]
fn distance_is_that_of_the_difference_built_piece_by_piece() {
    let shapes = [
        (7, 3),
        (1, 1),
        (12, 4),
        (3, 9),
        (40, 5),
        (300, 2),
        (64, 3),
        (2, 13),
    ];
    for (n, degree) in shapes {
        for count in [5, 64, 1000] {
            let (cells, own) = (rough(count), wave(n, degree));
            let target = pieces(&cells);
            let cut = own.cut_at(target.breaks());
            let target = target.cut_at(cut.breaks());
            let difference = PiecewisePoly::combine(&[(1.0, &cut), (-1.0, &target)], 0.0);
            let (low, high) = difference.extremes();
            let found = cells.distance(&own);
            let square = difference.integral_of_square();
            assert!(
                (found.square / square - 1.0).abs() < 1e-12,
                "{n} {degree} {count}: {found:?} {square}"
            );
            let largest = high.value.max(-low.value);
            assert!(
                (found.largest / largest - 1.0).abs() < 1e-12,
                "{n} {degree} {count}: {found:?} {largest}"
            );
        }
    }
}

#[test]
fn a_function_is_no_distance_from_itself() {
    for (count, parts) in [(64, 64), (64, 1), (50, 100)] {
        let cells = rough(count);
        let finer: Vec<f64> = (1..parts).map(|i| TAU * i as f64 / parts as f64).collect();
        let found = cells.distance(&pieces(&cells).cut_at(&finer));
        assert!(found.largest < 1e-11 && found.square < 1e-22, "{found:?}");
    }
}

/// Comparison with quadrature between the ends of cells: for whole cells, for parts of one, and across several ends.
#[test]
fn the_nearest_polynomial_has_the_moments_of_the_function() {
    let cells = rough(96);
    let cell = TAU / 96.0;
    let even: Vec<f64> = (0..=32).map(|i| TAU * f64::from(i) / 32.0).collect();
    let uneven: Vec<f64> = (0..=300)
        .map(|i| TAU * (f64::from(i) / 300.0).powf(1.3))
        .collect();
    let parts = [0.0, 0.3, 0.7, 1.0, 1.2, 2.2, 40.5, 96.0].map(|x| x * cell);
    for breaks in [&even[..], &uneven, &parts, &[0.0, TAU]] {
        for degree in 0..=9 {
            let (rule, fine) = (gauss_legendre(degree + 1), gauss_legendre(8));
            let values = cells.nearest(breaks, degree);
            assert_eq!(values.len(), rule.len() * (breaks.len() - 1));
            for (ends, values) in breaks.windows(2).zip(values.chunks_exact(rule.len())) {
                let (start, width) = (ends[0], ends[1] - ends[0]);
                let mut pieces: Vec<f64> = (0..=96).map(|i| f64::from(i) * cell).collect();
                pieces.retain(|x| *x > start && *x < ends[1]);
                let pieces = [&ends[..1], &pieces, &ends[1..]].concat();
                for power in 0..=degree as i32 {
                    let moment = |u: f64, f: f64| f * (2.0 * u - 1.0).powi(power);
                    let own = rule.iter().zip(values);
                    let own: f64 = own.map(|((u, w), f)| w * moment(*u, *f)).sum();
                    let exact = pieces.windows(2).flat_map(|p| {
                        let part = (p[1] - p[0]) / width;
                        fine.iter()
                            .map(move |(u, w)| (p[0] + u * (p[1] - p[0]), w * part))
                    });
                    let exact: f64 = exact
                        .map(|(x, w)| w * moment((x - start) / width, cells.at(x)))
                        .sum();
                    // Values are of the size 1000; the power basis loses three digits at degree 9.
                    let apart = (own - exact).abs();
                    assert!(apart < 1e-9, "{degree} {power}: {own} {exact}");
                }
            }
        }
    }
}

#[test]
fn the_mean_square_is_that_of_the_pieces() {
    let cells = rough(64);
    let pieces = pieces(&cells);
    let apart = PiecewisePoly::combine(&[(1.0, &pieces)], -650.0);
    let exact = apart.integral_of_square() / TAU;
    assert!((cells.mean_square_from(650.0) / exact - 1.0).abs() < 1e-14);
}
