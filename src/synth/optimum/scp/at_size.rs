//! Nonconvex limits at the size of a program's solution.

use crate::law::Law;
use crate::synth::limits::{NonconvexLimits, ProfileSize, clearances};
use crate::synth::qp::{ByVariable, Limit, OFFSET, Program, RADIUS, RISE, Solution, Variable};

/// The nonconvex limits of a program, with the sizes among its variables.
pub struct AtSize {
    limits: NonconvexLimits,
    /// Sizes among the variables of the program.
    present: ByVariable<bool>,
    /// Sizes that a step may change.
    free: ByVariable<bool>,
}

impl AtSize {
    /// The limits of a program: if it has the size among its variables, the size in `limits` is ignored.
    pub fn new(limits: NonconvexLimits, program: &Program) -> Self {
        let mut present = program.present();
        // An offset that a limit holds is given.
        let holds = |l: &Limit| l.is_on_variables_alone() && l.extra[OFFSET] != 0.0;
        present[OFFSET] &= !program.limits.iter().any(holds);
        AtSize {
            limits,
            present,
            free: present,
        }
    }

    /// The limits with a fixed size.
    pub fn held(&self) -> Self {
        AtSize {
            limits: self.limits.clone(),
            present: self.present,
            free: ByVariable::default(),
        }
    }

    /// The sizes that a step may change.
    pub fn free(&self) -> ByVariable<bool> {
        self.free
    }

    /// The limits at a solution.
    pub fn of(&self, solution: &Solution) -> NonconvexLimits {
        let given = self.limits.size();
        let of = |k: Variable, given: f64| {
            if self.present[k] {
                solution.extra[k]
            } else {
                given
            }
        };
        self.limits.at_size(ProfileSize {
            rise: of(RISE, given.rise),
            offset: of(OFFSET, given.offset),
            radius: of(RADIUS, given.radius),
            rho: given.rho,
        })
    }

    /// Minimum clearance h/w of each limit over a solution's law.
    pub fn clear(&self, program: &Program, solution: &Solution) -> Vec<f64> {
        clearances(&Law::of(&program.basis, &solution.x), &self.of(solution))
    }
}
