//! The one place that speaks to Clarabel.

use std::borrow::Cow;

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverError, SolverStatus,
    SupportedConeT,
};

use super::basis::Entries;
use super::lifted::Lifted;
use super::program::{EXTRAS, Failure, OFFSET, PEAK, Program, RADIUS, RISE, Row, Stop};

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
    /// Variables beside the law.
    pub extra: [f64; EXTRAS],
    /// Iterations.
    pub iterations: usize,
    /// Coefficients of a law on the way there, well inside the rows, where one was kept.
    pub inside: Option<Vec<f64>>,
}

/// Solves with the rows given; multipliers are written back into them. `margin` (relative to each
/// limit's scale) is kept free inside every limit.
pub fn solve(program: &Program, rows: &mut [Row], margin: f64) -> Result<Point, Failure> {
    let length = program.length;
    let weight = program.objective_unit();
    let law = Unknowns::new(program, rows);
    let columns = Columns::new(program, rows, law.count);

    let p = upper_triangle(
        &law.hessian(program),
        columns.total,
        length * length / weight,
    );
    let mut q: Vec<f64> = law
        .gradient(program)
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
    law.tie(&mut triplets, &mut b);
    let equalities = b.len();
    let mut units = Vec::with_capacity(rows.len());
    for row in rows.iter() {
        let entries = law.entries(row);
        let unit = row_unit(&entries, length);
        let r = b.len();
        triplets.extend(r, entries.iter().map(|&(i, v)| (i, v * length / unit)));
        for k in 0..EXTRAS {
            if let (Some(column), true) = (columns.of[k], row.extra[k] != 0.0) {
                triplets.push(r, column, row.extra[k] * columns.unit[k] / unit);
            }
        }
        b.push((row.bound - margin * row.scale - law.rounding(row, length)) / unit);
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
    let own = &program.settings.interior_point;
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_iter(own.iterations)
        .tol_gap_abs(own.tolerance)
        .tol_gap_rel(own.tolerance)
        .tol_feas(own.tolerance)
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
    let weight = program.multiplier_unit(columns.unit[PEAK]);
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
        x: law.coefficients(&answer.x, length),
        extra,
        iterations: answer.iterations as usize,
        inside: None,
    })
}

/// Whether a status comes with a point; a program close to infeasible counts as infeasible.
fn accepted(status: SolverStatus) -> Result<(), Failure> {
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

/// The unknowns that stand for the law: its coefficients, or for many spans those of its derivatives too.
struct Unknowns<'a> {
    roundings: f64,
    lifted: Option<&'a Lifted>,
    /// Highest derivative among them.
    order: usize,
    count: usize,
}

impl<'a> Unknowns<'a> {
    fn new(program: &'a Program, rows: &[Row]) -> Self {
        let roundings = program.settings.interior_point.roundings;
        let lifted = program.lifted.as_ref();
        let lifted = lifted.filter(|l| rows.iter().all(|r| l.carries(&r.weights)));
        let Some(lifted) = lifted else {
            return Unknowns {
                roundings,
                lifted,
                order: 0,
                count: program.basis.columns(),
            };
        };
        let needed = rows.iter().map(|r| lifted.highest(&r.weights)).max();
        let order = lifted.used().max(needed.unwrap_or(0));
        Unknowns {
            roundings,
            lifted: Some(lifted),
            order,
            count: (order + 1) * lifted.dimension(),
        }
    }

    fn hessian(&self, program: &Program) -> Vec<(usize, usize, f64)> {
        match self.lifted {
            Some(lifted) => lifted.blocks().to_vec(),
            None => program.hessian.lower_entries(),
        }
    }

    fn gradient(&self, program: &'a Program) -> &'a [f64] {
        match self.lifted {
            Some(lifted) => &lifted.gradient()[..self.count],
            None => &program.gradient,
        }
    }

    /// c′ᵢ = fᵢ (cᵢ − cᵢ₋₁) from each order to the next.
    fn tie(&self, triplets: &mut Triplets, b: &mut Vec<f64>) {
        let Some(lifted) = self.lifted else {
            return;
        };
        let n = lifted.dimension();
        for (order, factors) in lifted.factors()[..self.order].iter().enumerate() {
            for (i, &f) in factors.iter().enumerate() {
                let (own, before) = (order * n + i, order * n + (i + n - 1) % n);
                let r = b.len();
                triplets.push(r, own, f);
                triplets.push(r, before, -f);
                triplets.push(r, own + n, -1.0);
                b.push(0.0);
            }
        }
    }

    fn entries<'r>(&self, row: &'r Row) -> Cow<'r, Entries> {
        match self.lifted {
            Some(lifted) => {
                let mut entries = lifted.row(row.peak.piece, row.peak.u, &row.weights);
                entries.extend(&row.touching);
                Cow::Owned(entries)
            }
            None => Cow::Borrowed(&row.entries),
        }
    }

    /// What differences of the lift's coefficients will leave uncertain of a limit, where room can be kept.
    fn rounding(&self, row: &Row, length: f64) -> f64 {
        if self.lifted.is_none() || row.scale == 0.0 {
            return 0.0;
        }
        let size: f64 = row.entries.iter().map(|e| e.1.abs()).sum();
        self.roundings * f64::EPSILON * size * length
    }

    fn coefficients(&self, y: &[f64], length: f64) -> Vec<f64> {
        let Some(lifted) = self.lifted else {
            return y[..self.count].iter().map(|y| y * length).collect();
        };
        let n = lifted.dimension();
        let highest: Vec<f64> = y[self.order * n..self.count]
            .iter()
            .map(|y| y * length)
            .collect();
        let level = length * y[..n].iter().sum::<f64>() / n as f64;
        lifted.integrated(&vec![0.0; n], &highest, self.order, level)
    }
}

/// Where the variables beside the law stand among the columns, and their units.
pub struct Columns {
    pub of: [Option<usize>; EXTRAS],
    pub unit: [f64; EXTRAS],
    pub total: usize,
}

impl Columns {
    pub fn new(program: &Program, rows: &[Row], n: usize) -> Self {
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

/// Size of a row's terms for coefficients of typical size; the length for a row on sizes alone.
pub fn row_unit(entries: &[(usize, f64)], length: f64) -> f64 {
    let unit = entries
        .iter()
        .fold(0.0_f64, |m, e| m.max((e.1 * length).abs()));
    // A row on a size alone.
    if unit > 0.0 { unit } else { length }
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
