//! Interface to Clarabel.

use crate::Names;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverError, SolverStatus,
    SupportedConeT,
};

use crate::basis::row_unit;
use crate::program::{EXTRAS, Failure, OFFSET, PEAK, Program, RADIUS, RISE, Row, Stop};

/// Minimise ½xᵀPx + qᵀx with b − Ax in the cones, in the solver's hands. Clarabel's code is generic: every crate that makes or
/// runs a solver of its own compiles it whole, so all ask here.
///
/// # Errors
/// Where sizes do not agree.
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

/// Solves what is prepared; the answer is the solver's `solution`.
pub fn run(solver: &mut DefaultSolver<f64>) {
    solver.solve();
}

/// What the interior-point method returns, in the program's own units.
pub struct Point {
    /// Coefficients.
    pub x: Vec<f64>,
    /// Further variables.
    pub extra: [f64; EXTRAS],
    /// Iterations.
    pub iterations: usize,
}

/// Solves with the rows given; multipliers are written back into them. `margin` (relative to each
/// limit's scale) is kept free inside every limit.
pub fn solve<N: Names>(
    program: &Program<N>,
    rows: &mut [Row<N>],
    margin: f64,
) -> Result<Point, Failure<N>> {
    let length = program.length;
    let n = program.basis.columns();
    let columns = Columns::new(program, rows, n);
    let weight = program.multiplier_unit(columns.unit[PEAK]);

    let p = upper_triangle(
        &program.hessian.lower_entries(),
        columns.total,
        length * length / weight,
    );
    let mut q: Vec<f64> = program
        .gradient
        .iter()
        .map(|g| g * length / weight)
        .collect();
    q.resize(columns.total, 0.0);
    for k in 0..EXTRAS {
        if let Some(column) = columns.of[k] {
            // The peak has a unit of its own and stands alone in the objective.
            q[column] = if k == PEAK {
                program.cost[k].signum()
            } else {
                program.cost[k] * length / weight
            };
        }
    }

    let mut b = Vec::new();
    let mut triplets = Triplets::default();
    for e in &program.equalities {
        let unit = row_unit(&e.entries, length);
        let r = b.len();
        triplets.extend(r, e.entries.iter().map(|&(i, v)| (i, v * length / unit)));
        b.push(e.value / unit);
    }
    let equalities = b.len();
    let mut units = Vec::with_capacity(rows.len());
    for row in rows.iter() {
        let entries = &row.entries;
        let unit = row_unit(entries, length);
        let r = b.len();
        triplets.extend(r, entries.iter().map(|&(i, v)| (i, v * length / unit)));
        for k in 0..EXTRAS {
            if let (Some(column), true) = (columns.of[k], row.extra[k] != 0.0) {
                triplets.push(r, column, row.extra[k] * columns.unit[k] / unit);
            }
        }
        b.push((row.bound - margin * row.scale) / unit);
        units.push(unit);
    }
    let mut cones = vec![
        SupportedConeT::ZeroConeT(equalities),
        SupportedConeT::NonnegativeConeT(rows.len()),
    ];
    if program.cone {
        for k in [RADIUS, RISE, OFFSET] {
            if let Some(column) = columns.of[k] {
                triplets.push(b.len(), column, -1.0);
            }
            b.push(0.0);
        }
        cones.push(SupportedConeT::SecondOrderConeT(3));
    }
    let a = triplets.matrix(b.len(), columns.total);
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
    for ((row, z), unit) in rows.iter_mut().zip(&answer.z[equalities..]).zip(&units) {
        row.multiplier = z * weight / unit;
    }
    let mut extra = [0.0; EXTRAS];
    for (k, value) in extra.iter_mut().enumerate() {
        if let Some(column) = columns.of[k] {
            *value = answer.x[column] * columns.unit[k];
        }
    }
    Ok(Point {
        x: answer.x[..n].iter().map(|y| y * length).collect(),
        extra,
        iterations: answer.iterations as usize,
    })
}

/// Whether a status comes with a point; a program close to infeasible counts as infeasible.
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

/// Columns of the further variables, and their units.
pub struct Columns {
    pub of: [Option<usize>; EXTRAS],
    pub unit: [f64; EXTRAS],
    pub total: usize,
}

impl Columns {
    pub fn new<N: Names>(program: &Program<N>, rows: &[Row<N>], n: usize) -> Self {
        let mut of = [None; EXTRAS];
        let mut total = n;
        for (k, present) in program.present().into_iter().enumerate() {
            if present {
                of[k] = Some(total);
                total += 1;
            }
        }
        let largest = rows
            .iter()
            .filter(|r| r.extra[PEAK] != 0.0)
            .fold(0.0_f64, |m, r| m.max(row_unit(&r.entries, program.length)));
        let mut unit = [program.length; EXTRAS];
        unit[PEAK] = if largest > 0.0 { largest } else { 1.0 };
        Columns { of, unit, total }
    }
}

fn upper_triangle(lower: &[(usize, usize, f64)], columns: usize, factor: f64) -> CscMatrix<f64> {
    let mut t = Triplets::default();
    for &(i, j, value) in lower {
        t.push(j, i, value * factor);
    }
    t.matrix(columns, columns)
}

#[derive(Default)]
struct Triplets {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Triplets {
    fn push(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }

    fn extend(&mut self, row: usize, entries: impl Iterator<Item = (usize, f64)>) {
        for (column, value) in entries.filter(|e| e.1 != 0.0) {
            self.push(row, column, value);
        }
    }

    fn matrix(self, m: usize, n: usize) -> CscMatrix<f64> {
        CscMatrix::new_from_triplets(m, n, self.rows, self.columns, self.values)
    }
}
