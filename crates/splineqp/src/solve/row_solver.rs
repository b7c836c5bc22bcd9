//! Solvers of programs with finitely many rows, used between two separations.

use crate::Names;
use crate::program::{Failure, Program, Row, Values};

/// The optimum under rows, in the program's own units.
pub struct Point<N: Names> {
    /// Coefficients of the law.
    pub x: Vec<f64>,
    /// Values of the further variables.
    pub extra: Values,
    /// Tangents of the limits on root mean squares, with their multipliers.
    pub tangents: Vec<Row<N>>,
    /// Total iterations so far.
    pub iterations: usize,
}

/// A solver of quadratic programs under rows. A new solver needs a file, constants in the settings and a line in [`super`].
pub trait RowSolver<N: Names> {
    /// The optimum under the rows, with `margin` of each row's scale kept free. Multipliers are written into the rows.
    ///
    /// # Errors
    /// Infeasible rows, a solver that stops without an answer.
    fn solve(
        &mut self,
        program: &Program<N>,
        rows: &mut [Row<N>],
        margin: f64,
    ) -> Result<Point<N>, Failure<N>>;

    /// Notifies the solver that another row replaced this one since the last solution.
    fn replaced(&mut self, _row: usize) {}
}
