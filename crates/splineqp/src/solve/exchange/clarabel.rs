//! Interface to the Clarabel solver.

use crate::Names;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverError, SolverStatus,
    SupportedConeT,
};

use crate::basis::{Entries, row_unit};
use crate::program::{Ball, Failure, PEAK, Program, RmsLimit, Row, Stop, Values, Variable};
use crate::solve::row_solver::{Point, RowSolver};

/// Passes the problem to the solver: minimise ½xᵀPx + qᵀx with b − Ax in the cones.
///
/// # Errors
///
/// The sizes do not match.
pub fn prepared(
    p: &CscMatrix<f64>,
    q: &[f64],
    a: &CscMatrix<f64>,
    b: &[f64],
    cones: &[SupportedConeT<f64>],
    settings: DefaultSettings<f64>,
) -> Result<DefaultSolver<f64>, SolverError> {
    DefaultSolver::new(p, q, a, b, cones, settings)
}

/// Solves the prepared problem. The result is in the field `solution` of the solver.
pub fn run(solver: &mut DefaultSolver<f64>) {
    solver.solve();
}

/// Interior-point method, which restarts with every set of rows. It is the only method for cones and limits on root mean squares.
#[derive(Default)]
pub struct InteriorPoint {
    iterations: usize,
}

impl<N: Names> RowSolver<N> for InteriorPoint {
    fn solve(
        &mut self,
        program: &Program<N>,
        rows: &mut [Row<N>],
        margin: f64,
    ) -> Result<Point<N>, Failure<N>> {
        let point = solved(program, rows, margin)?;
        self.iterations += point.iterations;
        Ok(Point {
            iterations: self.iterations,
            ..point
        })
    }
}

fn solved<N: Names>(
    program: &Program<N>,
    rows: &mut [Row<N>],
    margin: f64,
) -> Result<Point<N>, Failure<N>> {
    let (length, n) = (program.length, program.basis.columns());
    let scaling = Scaling::of(program, rows);
    let (p, q) = objective(program, &scaling);
    let balls: Option<Vec<Ball>> = program.rms.iter().map(RmsLimit::ball).collect();
    let balls = balls.ok_or(Failure::Infeasible)?;
    let (a, b, cones) = constraints(program, rows, &balls, &scaling, margin);
    let own = &program.settings.exchange;
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_iter(own.solver_iterations)
        .tol_gap_abs(own.solver_tolerance)
        .tol_gap_rel(own.solver_tolerance)
        .tol_feas(own.solver_tolerance)
        .max_threads(1)
        .build()
        .map_err(|_| Stop::Refused)?;
    let mut solver = prepared(&p, &q, &a, &b, &cones, settings).map_err(|_| Stop::Refused)?;
    let halt = program.halt.clone();
    solver.set_termination_callback(move |_| halt.is_asked());
    run(&mut solver);
    let answer = &solver.solution;
    accepted(answer.status)?;
    if answer.x.iter().any(|v| !v.is_finite()) {
        return Err(Stop::NumericalError.into());
    }
    let multipliers = &answer.z[program.equalities.len()..];
    for ((row, z), unit) in rows.iter_mut().zip(multipliers).zip(&scaling.rows) {
        row.multiplier = z * scaling.objective / unit;
    }
    let mut extra = Values::NONE;
    for (column, &k) in (n..).zip(&scaling.free) {
        extra[k] = answer.x[column] * scaling.variable(program, k);
    }
    let x: Vec<f64> = answer.x[..n].iter().map(|y| y * length).collect();
    let beside: usize = program.cones.iter().map(|c| 1 + c.tail.len()).sum();
    let of_cones = multipliers[rows.len() + beside..].chunks_exact(n + 1);
    let limited = program.rms.iter().zip(&balls).zip(of_cones);
    let tangents = limited.map(|((limit, ball), z)| {
        let multiplier = z[0] * scaling.objective / ball.radius;
        limit.tangent(&x, multiplier * limit.most / ball.radius)
    });
    let tangents = tangents.collect();
    Ok(Point {
        x,
        extra,
        tangents,
        iterations: answer.iterations as usize,
    })
}

/// Units by which the quantities of the program are divided, so that the numbers of the solver are about one.
struct Scaling {
    /// Further variables that are used in the program. Their columns follow the columns of the coefficients.
    free: Vec<Variable>,
    /// Unit of the peak variable.
    peak: f64,
    /// Unit by which the objective is divided.
    objective: f64,
    /// Unit by which each row is divided.
    rows: Vec<f64>,
}

impl Scaling {
    fn of<N: Names>(program: &Program<N>, rows: &[Row<N>]) -> Self {
        let unit = |row: &Row<N>| row_unit(&row.entries, program.length);
        let of_peak = rows.iter().filter(|r| r.extra[PEAK] != 0.0);
        let largest = of_peak.map(unit).fold(0.0, f64::max);
        let peak = if largest > 0.0 { largest } else { 1.0 };
        Scaling {
            free: program.free_variables(),
            peak,
            objective: program.multiplier_unit(peak),
            rows: rows.iter().map(unit).collect(),
        }
    }

    /// Unit by which a further variable is divided.
    fn variable<N: Names>(&self, program: &Program<N>, k: Variable) -> f64 {
        if k == PEAK {
            self.peak
        } else {
            program.typical(k)
        }
    }
}

/// Matrix P and vector q of the objective.
fn objective<N: Names>(program: &Program<N>, scaling: &Scaling) -> (CscMatrix<f64>, Vec<f64>) {
    let (length, weight) = (program.length, scaling.objective);
    let total = program.basis.columns() + scaling.free.len();
    let factor = length * length / weight;
    let lower = program.hessian.lower_entries().into_iter();
    let p = matrix(
        total,
        total,
        lower.map(|(i, j, value)| (j, i, value * factor)),
    );
    let mut q: Vec<f64> = (program.gradient.iter())
        .map(|g| g * length / weight)
        .collect();
    q.extend(scaling.free.iter().map(|&k| match program.cost[k] {
        // The peak has its own unit, in which its cost is 1 or −1.
        cost if k == PEAK => cost.signum(),
        cost => cost * program.typical(k) / weight,
    }));
    (p, q)
}

/// A, b and the cones: equalities, rows, the cones of the program, and the limits on root mean squares.
fn constraints<N: Names>(
    program: &Program<N>,
    rows: &[Row<N>],
    balls: &[Ball],
    scaling: &Scaling,
    margin: f64,
) -> (CscMatrix<f64>, Vec<f64>, Vec<SupportedConeT<f64>>) {
    let (length, n) = (program.length, program.basis.columns());
    let columns = || (n..).zip(scaling.free.iter().copied());
    let (mut entries, mut b) = (Vec::new(), Vec::new());
    let scaled = |r: usize, row: &Entries, unit: f64| -> Vec<(usize, usize, f64)> {
        let all = row.iter().map(|&(i, v)| (r, i, v * length / unit));
        all.filter(|e| e.2 != 0.0).collect()
    };
    for e in &program.equalities {
        let unit = row_unit(&e.entries, length);
        entries.extend(scaled(b.len(), &e.entries, unit));
        b.push(e.value / unit);
    }
    for (row, &unit) in rows.iter().zip(&scaling.rows) {
        let r = b.len();
        entries.extend(scaled(r, &row.entries, unit));
        for (column, k) in columns().filter(|(_, k)| row.extra[*k] != 0.0) {
            entries.push((
                r,
                column,
                row.extra[k] * scaling.variable(program, k) / unit,
            ));
        }
        b.push((row.bound - margin * row.scale) / unit);
    }
    let mut cones = vec![
        SupportedConeT::ZeroConeT(program.equalities.len()),
        SupportedConeT::NonnegativeConeT(rows.len()),
    ];
    for cone in &program.cones {
        let unit = scaling.variable(program, cone.head);
        for member in cone.members() {
            let column = columns().find(|(_, k)| *k == member).map(|c| c.0);
            let own = scaling.variable(program, member) / unit;
            entries.extend(column.map(|column| (b.len(), column, -own)));
            b.push(0.0);
        }
        cones.push(SupportedConeT::SecondOrderConeT(1 + cone.tail.len()));
    }
    for ball in balls {
        let first = b.len() + 1;
        b.push(1.0 - margin);
        b.extend(ball.shift.iter().map(|h| h / ball.radius));
        let part = length / ball.radius;
        entries.extend((ball.factor.entries()).map(|(i, j, l)| (first + j, i, -l * part)));
        cones.push(SupportedConeT::SecondOrderConeT(n + 1));
    }
    (matrix(b.len(), n + scaling.free.len(), entries), b, cones)
}

/// Checks whether the solver ended with a solution. A nearly infeasible program counts as infeasible.
fn accepted<N: Names>(status: SolverStatus) -> Result<(), Failure<N>> {
    Err(match status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            return Ok(());
        }
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
            Failure::Infeasible
        }
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Stop::Unbounded.into(),
        SolverStatus::MaxIterations | SolverStatus::MaxTime => Stop::IterationLimit.into(),
        SolverStatus::CallbackTerminated => Stop::OutOfTime.into(),
        SolverStatus::Unsolved | SolverStatus::NumericalError => Stop::NumericalError.into(),
    })
}

/// Sparse matrix from its entries (row, column, value).
fn matrix(
    rows: usize,
    columns: usize,
    entries: impl IntoIterator<Item = (usize, usize, f64)>,
) -> CscMatrix<f64> {
    let (i, j, values) = entries.into_iter().collect();
    CscMatrix::new_from_triplets(rows, columns, i, j, values)
}
