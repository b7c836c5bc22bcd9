//! Motion of one turn that approximates a square wave as closely as limits on velocity and acceleration permit.

use splineqp::poly::SplineSpace;
use splineqp::{Basis, Derivative, Failure, Limit, Program, Quadratic, certificate};
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
    for (name, derivative, most) in [
        ("velocity", Derivative::First, 2.0),
        ("acceleration", Derivative::Second, 6.0),
    ] {
        let side = Limit::on(name, derivative);
        program
            .limits
            .extend([side.at_most(most), side.at_least(-most)]);
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
