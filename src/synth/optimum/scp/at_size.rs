//! Non-convex limits, evaluated for the size of the cam that a solution contains.

use crate::law::Law;
use crate::synth::limits::{NonconvexLimits, ProfileSize, clearances};
use crate::synth::qp::{ByVariable, Limit, OFFSET, Program, RADIUS, RISE, Solution, Variable};

/// Non-convex limits of a program in which sizes may be variables.
pub struct AtSize {
    limits: NonconvexLimits,
    /// Sizes that are variables of the program.
    present: ByVariable<bool>,
    /// Sizes that a step may change.
    free: ByVariable<bool>,
}

impl AtSize {
    /// Creates the limits for a program. If the size is a variable of the program, the size in `limits` is ignored.
    pub fn new(limits: NonconvexLimits, program: &Program) -> Self {
        let mut present = program.present();
        // An offset that is fixed by a limit counts as given.
        let holds = |l: &Limit| l.is_on_variables_alone() && l.extra[OFFSET] != 0.0;
        present[OFFSET] &= !program.limits.iter().any(holds);
        AtSize {
            limits,
            present,
            free: present,
        }
    }

    /// The same limits, but a step may not change the sizes.
    pub fn held(&self) -> Self {
        AtSize {
            limits: self.limits.clone(),
            present: self.present,
            free: ByVariable::default(),
        }
    }

    /// Sizes that a step may change.
    pub fn free(&self) -> ByVariable<bool> {
        self.free
    }

    /// The limits for the size of the cam that a solution contains.
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

    /// Minimum clearance h/w of each limit over the law of a solution.
    pub fn clear(&self, program: &Program, solution: &Solution) -> Vec<f64> {
        clearances(&Law::of(&program.basis, &solution.x), &self.of(solution))
    }
}
