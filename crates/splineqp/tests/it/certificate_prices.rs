//! Certificates for peaks and sizes, which have a cost, compared with closed forms.

use crate::certificate::is_certified;
use splineqp::poly::SplineSpace;
use splineqp::*;

type Program = splineqp::Program<()>;
type Solution = splineqp::Solution<()>;

/// Minimum peak of a derivative from rest to rest, with a spline of `n` pieces.
fn least_peak(n: usize, scale: f64) -> Program {
    let breaks: Vec<f64> = (0..=n)
        .map(|k| 0.5 * (1.0 - (k as f64 * std::f64::consts::PI / n as f64).cos()))
        .collect();
    let space = SplineSpace::clamped(n + 1, &breaks, &vec![2; n - 1]);
    let basis = Basis::Spline {
        space,
        closed: false,
    };
    let mut equalities = Vec::new();
    for order in 0..n {
        for (piece, u) in [(0, 0.0), (n - 1, 1.0)] {
            let mut weights = [0.0; 5];
            weights[order] = 1.0;
            equalities.push(splineqp::Equality {
                name: "at rest",
                entries: basis.row_on(piece, u, &weights),
                value: if order == 0 { u } else { 0.0 },
            });
        }
    }
    let zero = splineqp::Quadratic::zero(&basis);
    let mut program = Program::new(basis, zero, equalities, 1.0);
    program.cost[PEAK] = 1.0;
    for sign in [1.0, -1.0] {
        let mut weights = [0.0; 5];
        weights[n] = sign;
        let mut limit = Limit::on("peak", weights)
            .at_most(0.0)
            .scaled(scale)
            .minimised();
        limit.domain = (0.0, 1.0);
        program.limits.push(limit);
    }
    program
}

/// Theory §8: the minimum peaks of the second and third derivative from rest to rest are 4 and 32. The scale of the limit, which the exchange uses
/// for violations, is much larger.
#[test]
fn a_certified_peak_is_the_peak_of_the_law() {
    for (n, least) in [(2_usize, 4.0), (3, 32.0)] {
        for scale in [1.0, 1e3, 1e6] {
            let program = least_peak(n, scale);
            let solution = program.solve().unwrap();
            let proof = certificate(&program, &solution);
            let mut weights = [0.0; 5];
            weights[n] = 1.0;
            let law = program.basis.combination(&solution.x, &weights);
            let grid = (0..=2000).map(|i| law.eval(f64::from(i) / 2000.0).abs());
            let (own, stated) = (grid.fold(0.0, f64::max), solution.extra[PEAK]);
            assert!(own <= stated * (1.0 + 1e-12), "{n} {scale}: {own} {stated}");
            assert!(is_certified(&proof), "{n} {scale}: {proof:?}");
            assert!((own / least - 1.0).abs() < 1e-6, "{n} {scale}: {own}");
        }
    }
}

/// All multipliers are 1 ‰ too large, so that 1 ‰ of the cost of the peak remains. It is compared with the terms, which are the cost and 1.001 times
/// the cost, or with an objective that is large relative to the peak.
#[test]
fn what_is_left_of_a_price_counts_by_its_terms_or_by_the_objective() {
    for (n, peak) in [(2, 4.0), (3, 32.0)] {
        let mut program = least_peak(n, 1.0);
        let mut solution = program.solve().unwrap();
        solution
            .active
            .iter_mut()
            .for_each(|r| r.multiplier *= 1.001);
        for (constant, expected) in [(0.0, 1e-3 / 2.001), (1e3 * peak, 1e-6)] {
            program.constant = constant;
            let left = certificate(&program, &solution).stationarity;
            assert!(
                (left / expected - 1.0).abs() < 1e-3,
                "{n} {constant}: {left:e}"
            );
        }
        // A peak that is nothing beside the scale of its limits is none.
        program.constant = 0.0;
        program.limits.iter_mut().for_each(|l| l.scale = 1e9);
        let size = certificate(&program, &solution).size;
        let least = program.settings.certificate.least_objective * 1e9;
        assert!((size / least - 1.0).abs() < 1e-12, "{size} {least}");
    }
}

/// If only the sizes have costs and these point out of the cone, no law is optimal. The violation is ‖(D, e)‖ − Rp relative to the maximum cost.
#[test]
fn prices_of_sizes_outside_their_cone_prove_nothing() {
    for (radius, rise, offset, left) in [
        (1.0, 2.0, 0.0, 0.5),
        (1.0, 3.0, 4.0, 1.0),
        (2.0, 1.0, 1.0, 0.0),
    ] {
        let basis = Basis::Harmonic { count: 2 };
        let zero = Quadratic::zero(&basis);
        let mut program = Program::new(basis, zero, Vec::new(), 1.0);
        let costs = [("radius", radius), ("rise", rise), ("offset", offset)];
        let [radius, tail @ ..] = costs.map(|(name, cost)| program.variable(name, 1.0, cost));
        program.cone("sizes", radius, &tail);
        let solution = Solution {
            x: vec![0.0; program.basis.columns()],
            extra: Values::NONE,
            active: Vec::new(),
            used_rows: false,
            iterations: 0,
            rounds: 0,
            violation: 0.0,
        };
        let found = certificate(&program, &solution).stationarity;
        assert!((found - left).abs() < 1e-12, "{found} {left}");
    }
}
