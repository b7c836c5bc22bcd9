//! Further variables of a program in addition to the spline coefficients, and their cones.

use super::Program;
use crate::Names;
use std::ops::{Index, IndexMut};

/// Maximum number of further variables, including the peak.
const MOST: usize = 8;

/// The peak: a bound that is minimised. Every program declares this variable. It is used if a limit or a cost refers to it.
pub const PEAK: Variable = Variable(0);

/// A further variable, given by its index in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Variable(usize);

impl Variable {
    /// The `n`th declared variable, counted from 1; 0 is [`PEAK`].
    pub const fn nth(n: usize) -> Self {
        assert!(n < MOST, "a program has few variables beside its spline");
        Variable(n)
    }

    /// Iterator over all variables, used or not.
    pub fn all() -> impl Iterator<Item = Variable> {
        (0..MOST).map(Variable)
    }
}

/// One entry for each variable.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ByVariable<T>([T; MOST]);

/// One number for each variable: weights, costs or values.
pub type Values = ByVariable<f64>;

impl<T> Index<Variable> for ByVariable<T> {
    type Output = T;
    #[inline]
    fn index(&self, variable: Variable) -> &T {
        &self.0[variable.0]
    }
}

impl<T> IndexMut<Variable> for ByVariable<T> {
    #[inline]
    fn index_mut(&mut self, variable: Variable) -> &mut T {
        &mut self.0[variable.0]
    }
}

impl<T: Copy> ByVariable<T> {
    /// Iterator over the variables and their entries.
    pub fn iter(&self) -> impl Iterator<Item = (Variable, T)> + '_ {
        Variable::all().map(|k| (k, self[k]))
    }
}

impl Values {
    /// The value zero for every variable.
    pub const NONE: Values = ByVariable([0.0; MOST]);

    /// Whether all entries are 0.
    pub fn is_none(&self) -> bool {
        *self == Values::NONE
    }

    /// Dot product. It is the sum over all variables of the entry of `self` times the entry of `other`.
    #[inline]
    pub fn dot(&self, other: &Values) -> f64 {
        self.0.iter().zip(&other.0).map(|(a, b)| a * b).sum()
    }
}

/// Name and properties of a declared variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Declared {
    /// Name of the variable for the caller.
    pub name: &'static str,
    /// Typical value, used as unit of the solver.
    pub typical: f64,
    /// Order of the derivative of the law whose minimum is this variable; `None` for an independent variable.
    pub least_of: Option<usize>,
}

/// Second-order cone: the head is at least the Euclidean norm of the tail.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone<N: Names> {
    /// Name of the cone for users.
    pub name: N::Limit,
    /// Variable that is at least the norm.
    pub head: Variable,
    /// Variables whose norm is computed.
    pub tail: Vec<Variable>,
}

impl<N: Names> Cone<N> {
    /// Euclidean norm of the tail for given values of the variables.
    pub fn norm(&self, values: &Values) -> f64 {
        let tail = self.tail.iter().map(|&k| values[k]);
        tail.fold(0.0, libm::hypot)
    }

    /// Variables of the cone, the head first.
    pub fn members(&self) -> impl Iterator<Item = Variable> + '_ {
        std::iter::once(self.head).chain(self.tail.iter().copied())
    }
}

impl<N: Names> Program<N> {
    /// Declares a variable with a name, a typical value (the unit of the solver) and a cost in the objective.
    ///
    /// # Panics
    ///
    /// If more than seven variables are declared.
    pub fn variable(&mut self, name: &'static str, typical: f64, cost: f64) -> Variable {
        let variable = Variable::nth(self.variables.len() + 1);
        self.variables.push(Declared {
            name,
            typical,
            least_of: None,
        });
        self.cost[variable] = cost;
        variable
    }

    /// Declares the minimum of a derivative of the law as a variable. It is the lower end of a range of values with free position.
    ///
    /// # Panics
    ///
    /// If more than seven variables are declared.
    pub fn least_value(&mut self, name: &'static str, order: usize, typical: f64) -> Variable {
        let variable = self.variable(name, typical, 0.0);
        if let Some(declared) = self.variables.last_mut() {
            declared.least_of = Some(order);
        }
        variable
    }

    /// Adds a cone: `head` is at least the norm of `tail`. A variable may be in at most one cone.
    pub fn cone(&mut self, name: impl Into<N::Limit>, head: Variable, tail: &[Variable]) {
        self.cones.push(Cone {
            name: name.into(),
            head,
            tail: tail.to_vec(),
        });
    }

    /// Name of a variable for the caller; "peak" for [`PEAK`].
    pub fn name_of(&self, variable: Variable) -> &'static str {
        self.declared(variable).map_or("peak", |d| d.name)
    }

    /// Typical value of a variable. For the peak, it is the typical size of the coefficients.
    pub(crate) fn typical(&self, variable: Variable) -> f64 {
        self.declared(variable).map_or(self.length, |d| d.typical)
    }

    fn declared(&self, variable: Variable) -> Option<&Declared> {
        self.variables.get(variable.0.checked_sub(1)?)
    }

    /// Whether each variable is used in the cost, a limit, a permanent row or a cone.
    pub fn present(&self) -> ByVariable<bool> {
        let mut out = ByVariable([false; MOST]);
        for k in Variable::all() {
            out[k] = self.cost[k] != 0.0
                || self.limits.iter().any(|l| l.extra[k] != 0.0)
                || self.fixed.iter().any(|r| r.extra[k] != 0.0)
                || self.is_in_cone(k);
        }
        out
    }

    /// Variables that are used in the program.
    pub fn free_variables(&self) -> Vec<Variable> {
        let present = self.present();
        Variable::all().filter(|&k| present[k]).collect()
    }

    /// Whether a cone contains a variable.
    pub(crate) fn is_in_cone(&self, variable: Variable) -> bool {
        self.cones
            .iter()
            .any(|c| c.members().any(|k| k == variable))
    }

    /// Variables that are the minimum of the law or of a derivative, with the order of the derivative.
    pub(crate) fn least_values(&self) -> impl Iterator<Item = (Variable, usize)> + '_ {
        let declared = Variable::all().skip(1).zip(&self.variables);
        declared.filter_map(|(k, d)| Some((k, d.least_of?)))
    }

    /// The program with the given variables as constants. Their costs, and the cones that contain them, are removed.
    #[must_use]
    pub fn with_constant(mut self, variables: &[Variable], values: &Values) -> Program<N> {
        for limit in &mut self.limits {
            make_constant(&mut limit.bound, &mut limit.extra, variables, values);
        }
        for row in self.fixed.iter_mut().chain(&mut self.seeds) {
            make_constant(&mut row.bound, &mut row.extra, variables, values);
        }
        variables.iter().for_each(|&k| self.cost[k] = 0.0);
        self.cones
            .retain(|c| !c.members().any(|k| variables.contains(&k)));
        self
    }
}

/// Replaces the given variables by their values, and moves their terms to the bound.
pub(crate) fn make_constant(
    bound: &mut f64,
    extra: &mut Values,
    variables: &[Variable],
    values: &Values,
) {
    for &k in variables {
        *bound -= extra[k] * values[k];
        extra[k] = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Basis, Quadratic};

    #[test]
    fn variables_keep_the_order_of_their_declaration() {
        let basis = Basis::Harmonic { count: 1 };
        let zero = Quadratic::zero(&basis);
        let mut program: Program<()> = Program::new(basis, zero, Vec::new(), 2.0);
        let radius = program.variable("radius", 0.04, 3.0);
        let lowest = program.least_value("lowest", 0, 0.01);
        assert_eq!([radius, lowest], [Variable::nth(1), Variable::nth(2)]);
        assert_eq!(
            [program.typical(radius), program.typical(PEAK)],
            [0.04, 2.0]
        );
        assert_eq!(program.name_of(lowest), "lowest");
        assert_eq!(program.free_variables(), [radius]);
        assert_eq!(program.least_values().collect::<Vec<_>>(), [(lowest, 0)]);
        program.cone("cone", radius, &[lowest]);
        assert_eq!(program.free_variables(), [radius, lowest]);
        let constant = program.with_constant(&[lowest], &Values::NONE);
        assert!(constant.cones.is_empty());
    }

    #[test]
    fn a_norm_is_that_of_the_tail() {
        let [head, a, b] = [1, 2, 3].map(Variable::nth);
        let cone: Cone<()> = Cone {
            name: "cone",
            head,
            tail: vec![a, b],
        };
        let mut values = Values::NONE;
        (values[head], values[a], values[b]) = (9.0, 3.0, -4.0);
        assert_eq!(cone.norm(&values), 5.0);
    }
}
