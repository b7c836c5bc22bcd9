//! A limit on a root mean square, compared with the whole program as one cone program of Clarabel. The cone has the rows of the quadrature; the other
//! limits have rows on a dense grid.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SupportedConeT};
use splineqp::poly::{SplineSpace, gauss_legendre};
use splineqp::{
    Basis, Limit, MeanSquare, Program, Quadratic, RmsLimit, certificate, only, pointwise,
};
use std::f64::consts::TAU;

/// Number of rows of the grid.
const GRID: usize = 12_000;
/// Number of quadrature nodes per span.
const NODES: usize = 8;

fn wave(x: f64) -> f64 {
    1.0 + (1..=4).fold(0.0, |sum, n| {
        let n = f64::from(n);
        sum + (n * x).cos() / n + (n * x).sin() / (n * n)
    })
}

fn program(order: usize, most: f64, highest: f64) -> Program<()> {
    let basis = Basis::Spline {
        space: SplineSpace::periodic_uniform(5, 24, TAU),
        closed: true,
    };
    let half = MeanSquare::distance(&basis, &[1.0], NODES, pointwise(wave));
    let mut energy = Quadratic::zero(&basis);
    energy.add_energy(&basis, order, 1.0);
    let mut program = Program::new(basis, energy, Vec::new(), 1.0);
    program.rms.push(RmsLimit {
        name: "distance",
        half,
        most,
        meaning: (),
    });
    let limit = Limit::on("highest", only(0, 1.0)).at_most(highest);
    program.limits.push(limit);
    program
}

/// Minimum energy with the same limits, from one cone program. It is below the optimum because the grid omits points.
fn reference(program: &Program<()>, highest: f64) -> f64 {
    let n = program.basis.columns();
    let (mut rows, mut columns, mut values, mut b) = (vec![], vec![], vec![], vec![]);
    let mut push = |entries: &[(usize, f64)], factor: f64, bound: f64| {
        for &(i, v) in entries {
            rows.push(b.len());
            columns.push(i);
            values.push(factor * v);
        }
        b.push(bound);
    };
    for k in 0..GRID {
        let at = TAU * k as f64 / GRID as f64;
        push(&program.basis.row(at, &[1.0]), 1.0, highest);
    }
    push(&[], 0.0, program.rms[0].most);
    let breaks = program.basis.breaks();
    for (piece, ends) in breaks.windows(2).enumerate() {
        for (u, weight) in gauss_legendre(NODES) {
            let width = ends[1] - ends[0];
            let root = (weight * width / TAU).sqrt();
            let row = program.basis.row_on(piece, u, &[1.0]);
            push(&row, root, root * wave(ends[0] + u * width));
        }
    }
    let cone = b.len() - GRID;
    let mut upper = (vec![], vec![], vec![]);
    for (i, j, v) in program.hessian.lower_entries() {
        upper.0.push(j);
        upper.1.push(i);
        upper.2.push(v);
    }
    let p = CscMatrix::new_from_triplets(n, n, upper.0, upper.1, upper.2);
    let a = CscMatrix::new_from_triplets(b.len(), n, rows, columns, values);
    let cones = [
        SupportedConeT::NonnegativeConeT(GRID),
        SupportedConeT::SecondOrderConeT(cone),
    ];
    let settings = DefaultSettings {
        verbose: false,
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(&p, &vec![0.0; n], &a, &b, &cones, settings).unwrap();
    solver.solve();
    solver.solution.obj_val
}

#[test]
fn one_cone_program_has_the_same_optimum() {
    for order in [2, 3, 4] {
        for (most, highest) in [(0.1, 2.9), (0.2, 2.8), (0.3, 2.6), (0.3, 5.0), (0.5, 2.2)] {
            let program = program(order, most, highest);
            let solution = program.solve().unwrap();
            let proof = certificate(&program, &solution);
            assert!(proof.proves_optimum() && proof.keeps_limits(), "{proof:?}");
            let (own, other) = (program.merit(&solution), reference(&program, highest));
            assert!(
                (own - other).abs() < 2e-6 * own,
                "{order} {most} {highest}: {own} {other}"
            );
        }
    }
}
