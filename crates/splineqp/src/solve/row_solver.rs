//! Solvers of programs whose limits are finitely many rows: what the rounds of exchange ask between two separations.

use crate::Names;
use crate::program::{Failure, Program, Row, Values};

/// The optimum under rows, in the program's own units.
pub struct Point<N: Names> {
    /// Coefficients.
    pub x: Vec<f64>,
    /// Further variables.
    pub extra: Values,
    /// Tangents of the limits on root mean squares, with their multipliers.
    pub tangents: Vec<Row<N>>,
    /// Iterations so far.
    pub iterations: usize,
}

/// A solver of quadratic programs under rows. Another one costs its file, its constants in the settings and the line in
/// [`super`] that chooses it.
pub trait RowSolver<N: Names> {
    /// The optimum under the rows, with `margin` of each row's scale kept free. Multipliers are written into the rows.
    ///
    /// # Errors
    /// Rows that leave nothing, a solver that stops without an answer.
    fn solve(
        &mut self,
        program: &Program<N>,
        rows: &mut [Row<N>],
        margin: f64,
    ) -> Result<Point<N>, Failure<N>>;

    /// Tells that another row has taken the place of this one since the last solution.
    fn replaced(&mut self, _row: usize) {}
}
