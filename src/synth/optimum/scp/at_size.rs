//! Limits that are not convex, at the size that a solution of a program has.

use crate::law::Law;
use crate::synth::limits::{NonconvexLimits, ProfileSize, clearances};
use crate::synth::qp::{ByVariable, Limit, OFFSET, Program, RADIUS, RISE, Solution, Variable};

/// The nonconvex limits of a program, and which sizes are among its variables.
pub struct AtSize {
    limits: NonconvexLimits,
    /// Sizes that a solution has.
    present: ByVariable<bool>,
    /// Those that a step may change.
    free: ByVariable<bool>,
}

impl AtSize {
    /// Of a program: where it has the size among its variables, the size in `limits` is ignored.
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

    /// The same where no step changes a size.
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

    /// Smallest h/w of each limit over a solution's law.
    pub fn clear(&self, program: &Program, solution: &Solution) -> Vec<f64> {
        clearances(&Law::of(&program.basis, &solution.x), &self.of(solution))
    }
}
