//! Solvers of programs with finitely many rows, used by the iterations that add rows.

use crate::Names;
use crate::program::{Failure, Program, Row, Values};

/// Optimum with finitely many rows, in the units of the program.
pub struct Point<N: Names> {
    /// Coefficients of the law.
    pub x: Vec<f64>,
    /// Values of the further variables.
    pub extra: Values,
    /// Tangents of the limits on root mean squares, with their multipliers.
    pub tangents: Vec<Row<N>>,
    /// Total number of iterations of the solver so far.
    pub iterations: usize,
}

/// Solver of quadratic programs with finitely many rows. A new solver needs a file, constants in the settings and a line in [`super`].
pub trait RowSolver<N: Names> {
    /// Computes the optimum with the rows, each of which is tightened by `margin` times its scale. The multipliers are written to the rows.
    ///
    /// # Errors
    ///
    /// - The rows are infeasible.
    /// - The solver stops without a result.
    fn solve(
        &mut self,
        program: &Program<N>,
        rows: &mut [Row<N>],
        margin: f64,
    ) -> Result<Point<N>, Failure<N>>;

    /// Notifies the solver that the row with this index has been replaced since the last solution.
    fn replaced(&mut self, _row: usize) {}
}
