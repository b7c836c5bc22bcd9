//! A motion of one turn that follows a square wave as well as limits on velocity and acceleration permit.

use splineqp::poly::SplineSpace;
use splineqp::{Basis, Failure, Limit, Program, Quadratic, certificate};
use std::f64::consts::{PI, TAU};

fn main() -> Result<(), Failure<()>> {
    let space = SplineSpace::periodic_uniform(5, 32, TAU);
    let basis = Basis::Spline {
        space,
        closed: true,
    };
    let mut distance = Quadratic::zero(&basis);
    let square = |start: f64, width: f64, rule: &[(f64, f64)], out: &mut [f64]| {
        for (value, (u, _)) in out.iter_mut().zip(rule) {
            *value = if start + u * width < PI { 1.0 } else { -1.0 };
        }
    };
    distance.add_distance(&basis, &[1.0], 8, square, None);
    let mut program: Program<()> = Program::new(basis, distance, Vec::new(), 1.0);
    for (order, name, bound) in [(1, "velocity", 2.0), (2, "acceleration", 6.0)] {
        for sign in [1.0, -1.0] {
            let mut weights = [0.0; 5];
            weights[order] = sign;
            program.limits.push(Limit::new(name, weights, bound, bound));
        }
    }
    let solution = program.solve()?;
    let proof = certificate(&program, &solution);
    println!("mean square error  {:.6}", 2.0 * program.merit(&solution));
    println!("relative gap       {:.1e}", proof.relative_gap);
    println!("largest violation  {:.1e}", proof.violation);
    for row in &solution.active {
        println!("{:<13} active at {:7.3} rad", row.name, row.peak.at);
    }
    Ok(())
}
