//! Additional variables of a cam's program. They are the sizes of the cam, the minimum lift, and the end of the contact range on a flat
//! face.

use super::{Program, Solution, TOLERANCE, Values, Variable};

/// Base radius of a flat-faced cam, or prime radius Rp of a roller cam, m.
pub const RADIUS: Variable = Variable::nth(1);
/// Height D of the roller centre above the cam centre at s = 0, m.
pub const RISE: Variable = Variable::nth(2);
/// Offset e of the follower, m.
pub const OFFSET: Variable = Variable::nth(3);
/// Minimum lift, m, from which the stroke is measured if the level of the lift is fixed.
pub const LOWEST: Variable = Variable::nth(4);
/// Minimum derivative of the lift with respect to the cam angle, m/rad. It is the lower end of the contact range on a flat face of limited
/// length.
pub const FACE_END: Variable = Variable::nth(5);
/// Variables for the size of the cam, which form the cone Rp ≥ ‖(D, e)‖.
pub const SIZES: [Variable; 3] = [RADIUS, RISE, OFFSET];

/// Declares the additional variables in a new program. Unused variables have no effect.
pub fn declare(program: &mut Program) {
    let length = program.length;
    for name in ["Rp", "D", "e"] {
        program.variable(name, length, 0.0);
    }
    program.least_value("lowest lift", 0, length);
    program.least_value("face end", 1, length);
}

/// The program with the sizes of a solution as constants, enlarged by the fraction `room`. Without a cone, the solver is accurate up to rounding
/// errors.
pub fn held(program: &Program, solution: &Solution, room: f64) -> Program {
    let mut sizes = solution.extra;
    sizes[RISE] *= 1.0 + room;
    sizes[RADIUS] *= 1.0 + room;
    let mut held = program.clone();
    held.seeds = program.seeds_of(&solution.active);
    held.settings.tolerance = TOLERANCE;
    held.with_constant(&SIZES, &sizes)
}

/// Whether the sizes satisfy those limits that contain no other variable.
pub fn keep(program: &Program, sizes: &Values) -> bool {
    let limits = program.limits.iter();
    let mut alone = limits.filter(|l| l.is_on_variables_alone());
    alone.all(|l| l.room(sizes) >= -program.settings.tolerance * l.size(l.bound))
}

/// Sizes clamped to the upper limits that contain only sizes.
pub fn within(program: &Program, sizes: &Values) -> Values {
    let mut out = *sizes;
    let limits = program.limits.iter();
    for limit in limits.filter(|l| l.is_on_variables_alone()) {
        for k in SIZES.into_iter().filter(|&k| limit.extra[k] > 0.0) {
            out[k] = out[k].min(limit.bound / limit.extra[k]);
        }
    }
    for cone in &program.cones {
        let part = out[cone.head] / sizes[cone.head];
        if part < 1.0 {
            cone.tail.iter().for_each(|&k| out[k] = part * sizes[k]);
        }
    }
    out
}

/// The program in which the limits that contain only sizes are relaxed to the given sizes. The sizes with an upper limit have the given cost.
pub fn priced(program: &Program, sizes: &Values, cost: f64) -> Program {
    let mut priced = program.clone();
    let limits = priced.limits.iter_mut();
    for limit in limits.filter(|l| l.is_on_variables_alone()) {
        limit.bound += (-limit.room(sizes)).max(0.0);
        for k in SIZES.into_iter().filter(|&k| limit.extra[k] > 0.0) {
            priced.cost[k] = priced.cost[k].max(cost);
        }
    }
    priced
}

#[cfg(test)]
mod tests {
    use super::super::{Basis, Limit, PEAK, Quadratic};
    use super::*;
    use crate::criterion::Criterion;

    fn program() -> Program {
        let basis = Basis::Harmonic { count: 1 };
        let zero = Quadratic::zero(&basis);
        let mut program = Program::new(basis, zero, Vec::new(), 0.01);
        declare(&mut program);
        program
    }

    /// A program with a limit of 5 on Rp and with the cone of the sizes.
    fn limited() -> Program {
        let mut program = program();
        let mut most = Limit::on(Criterion::BaseCircle, [0.0; 5]).at_most(5.0);
        most.extra[RADIUS] = 1.0;
        program.limits.push(most);
        program.cone(Criterion::BaseCircle, RADIUS, &[RISE, OFFSET]);
        program
    }

    fn sizes(radius: f64) -> Values {
        let mut sizes = Values::NONE;
        (sizes[RADIUS], sizes[RISE], sizes[OFFSET]) = (radius, 0.8 * radius, 0.6 * radius);
        sizes
    }

    #[test]
    fn names_belong_to_the_variables_that_are_declared() {
        let program = program();
        let names = [PEAK, RADIUS, RISE, OFFSET, LOWEST, FACE_END].map(|k| program.name_of(k));
        assert_eq!(names, ["peak", "Rp", "D", "e", "lowest lift", "face end"]);
        assert!(program.free_variables().is_empty());
    }

    #[test]
    fn sizes_shrink_together_to_their_limit() {
        let program = limited();
        assert!(keep(&program, &sizes(5.0)) && !keep(&program, &sizes(5.1)));
        let within = within(&program, &sizes(10.0));
        assert_eq!(within, sizes(5.0));
    }

    #[test]
    fn a_price_replaces_a_limit_that_is_exceeded() {
        let priced = priced(&limited(), &sizes(10.0), 2.0);
        assert_eq!((priced.limits[0].bound, priced.cost[RADIUS]), (10.0, 2.0));
    }
}
