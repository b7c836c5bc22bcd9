//! A program in the units of the solver: lengths in typical lifts, rows and objective near one, counted from the
//! optimum without limits.

use super::chain::{Chain, Layout, Windowed};
use super::system::{Found, Line, Matrix, System};
use crate::synth::qp::band::ArrowMatrix;
use crate::synth::qp::basis::{Basis, Entries};
use crate::synth::qp::clarabel::{Columns, Point, row_unit};
use crate::synth::qp::equality;
use crate::synth::qp::lifted::Lifted;
use crate::synth::qp::program::{EXTRAS, OFFSET, PEAK, Program, RADIUS, RISE, Row};
use std::sync::Arc;

/// A row of which the demands leave open less than this part of its length is none.
const IMPLIED: f64 = 1e-9;
/// … and one of which they leave less than this part of its square is measured by what is left.
const NEARLY: f64 = 1e-4;
/// … and that is broken by more than this, in its own unit, is broken by the demands.
const BROKEN: f64 = 1e-9;
/// Roundings kept free inside limits of many spans.
const ROUNDINGS: f64 = 0.5;

/// A program as the method solves it.
pub struct Scaled {
    pub system: System,
    /// The law from which unknowns count.
    start: Vec<f64>,
    columns: Columns,
    /// Index and unit of each row that the demands leave open.
    pub kept: Vec<(usize, f64)>,
}

/// What all solutions of one program of many spans have in common.
pub struct Base {
    pub chain: Chain,
    /// The law from which unknowns count.
    start: Vec<f64>,
    /// Its coefficients of all orders.
    derivatives: Vec<f64>,
    /// The objective's gradient there.
    gradient: Vec<f64>,
}

impl Base {
    fn new(program: &Program, lifted: &Lifted, highest: usize, beside: usize) -> Self {
        let layout = Layout::new(lifted, highest);
        let start = start(program);
        let derivatives = lifted.derivatives_to(&start, highest);
        let by_length = program.length / program.objective_unit();
        let mut gradient = vec![0.0; layout.unknowns() + beside];
        let n = lifted.dimension();
        for (at, pull) in lifted.pull(&derivatives).into_iter().enumerate() {
            if at / n <= highest {
                gradient[layout.own(at / n, at % n)] = pull * by_length;
            }
        }
        Base {
            chain: Chain::new(layout, lifted, program.length * by_length, beside),
            start,
            derivatives,
            gradient,
        }
    }
}

/// A row that the demands leave open.
struct Kept {
    index: usize,
    unit: f64,
    window: Option<usize>,
    entries: Entries,
    bound: f64,
}

/// Over what a law's rows stand.
enum Over<'a> {
    /// The coefficients of the lift.
    Lift,
    /// Those of its derivatives too; the law's own at the start beside them.
    Chain(&'a Lifted, &'a Layout, &'a [f64]),
}

impl Over<'_> {
    /// Window, entries and value at the start of a limit's row.
    fn row(&self, row: &Row, start: &[f64]) -> (Option<usize>, Entries, f64) {
        match self {
            Over::Lift => (None, row.entries.clone(), value(&row.entries, start)),
            Over::Chain(lifted, layout, derivatives) => {
                let entries = lifted.row(row.peak.piece, row.peak.u, &row.weights);
                let at_start = value(&entries, derivatives);
                let window = (!entries.is_empty()).then(|| layout.window_of(&entries));
                (window, layout.row(&entries), at_start)
            }
        }
    }

    /// A demand, which is one on the coefficients of the lift.
    fn demand(&self, entries: &Entries) -> Entries {
        match self {
            Over::Lift => entries.clone(),
            Over::Chain(_, layout, _) => layout.of_lift(entries),
        }
    }

    /// Unknown of the last coefficient of the lift, or of its mean.
    fn level(&self, basis: &Basis) -> usize {
        match (self, basis) {
            (Over::Chain(_, layout, _), _) => layout.own(0, basis.columns() - 1),
            (_, Basis::Spline { .. }) => basis.columns() - 1,
            (_, Basis::Harmonic { .. }) => 0,
        }
    }
}

fn value(entries: &Entries, x: &[f64]) -> f64 {
    entries.iter().map(|&(i, a)| a * x[i]).sum()
}

impl Scaled {
    /// Over the derivatives' own coefficients, which keep the digits.
    pub fn of_many_spans(
        program: &Program,
        lifted: &Lifted,
        rows: &[Row],
        margin: f64,
        base: &mut Option<Arc<Base>>,
    ) -> Option<Self> {
        let limits = program.limits.iter().map(|l| lifted.highest(&l.weights));
        let own = program.fixed.iter().map(|r| lifted.highest(&r.weights));
        let asked = rows.iter().map(|r| lifted.highest(&r.weights));
        let highest = limits.chain(own).chain(asked).max();
        let highest = highest.unwrap_or(0).max(lifted.used());
        let beside = program.present().iter().filter(|p| **p).count();
        let known = base.take().filter(|b| b.chain.layout.highest == highest);
        let base = base.insert(match known {
            Some(known) => known,
            None => Arc::new(Base::new(program, lifted, highest, beside)),
        });
        let chain = &base.chain;
        let columns = Columns::new(program, rows, chain.layout.unknowns());
        let over = Over::Chain(lifted, &chain.layout, &base.derivatives);
        let (start, gradient) = (base.start.clone(), base.gradient.clone());
        let (mut out, mut lines) =
            Self::of(program, rows, margin, (start, columns, gradient), &over)?;
        out.system.demands.extend(chain.layout.closing());
        lines.sort_by_key(|line| line.window.unwrap_or(usize::MAX));
        out.take_bounds(&lines);
        let lines: Vec<(Option<usize>, Entries)> =
            lines.into_iter().map(|l| (l.window, l.entries)).collect();
        let rows = Windowed::new(&chain.layout, &lines);
        out.system.matrix = Matrix::Chained(Arc::clone(base), rows);
        out.system.size = out.system.unbalanced(&out.system.gradient);
        Some(out)
    }

    /// Over the coefficients of the lift, as the program has them.
    pub fn of_few_spans(program: &Program, rows: &[Row], margin: f64) -> Option<Self> {
        let n = program.basis.columns();
        let columns = Columns::new(program, rows, n);
        let start = start(program);
        let by_length = program.length / program.objective_unit();
        let mut gradient = program.hessian.times(&start);
        for (p, g) in gradient.iter_mut().zip(&program.gradient) {
            *p = (*p + g) * by_length;
        }
        gradient.resize(columns.total, 0.0);
        let (band, border) = program.hessian.pattern();
        let mut hessian = ArrowMatrix::zero(columns.total, band, border + columns.total - n);
        for (i, j, value) in program.hessian.lower_entries() {
            hessian.add(i, j, value * program.length * by_length);
        }
        let counted = (start, columns, gradient);
        let (mut out, lines) = Self::of(program, rows, margin, counted, &Over::Lift)?;
        out.take_bounds(&lines);
        let lines = lines.into_iter().map(|l| Line::new(l.entries, l.bound));
        out.system.matrix = Matrix::Banded(hessian, lines.collect());
        out.system.size = out.system.unbalanced(&out.system.gradient);
        Some(out)
    }

    fn of(
        program: &Program,
        rows: &[Row],
        margin: f64,
        (start, columns, mut gradient): (Vec<f64>, Columns, Vec<f64>),
        over: &Over,
    ) -> Option<(Self, Vec<Kept>)> {
        let (length, weight) = (program.length, program.objective_unit());
        for k in 0..EXTRAS {
            if let Some(column) = columns.of[k] {
                // The peak has a unit of its own and stands alone in the objective.
                gradient[column] = if k == PEAK {
                    program.cost[k].signum()
                } else {
                    program.cost[k] * length / weight
                };
            }
        }
        let scaled = |entries: Entries, unit: f64| -> Entries {
            let by = length / unit;
            entries.into_iter().map(|(i, a)| (i, a * by)).collect()
        };
        let mut demands = Vec::with_capacity(program.equalities.len());
        for demand in &program.equalities {
            let unit = row_unit(&demand.entries, length);
            let bound = (demand.value - value(&demand.entries, &start)) / unit;
            demands.push(Line::new(scaled(over.demand(&demand.entries), unit), bound));
        }
        let moves_level = |r: &Row| r.weights[0] != 0.0 || r.limit.is_none();
        if program.level_is_open() && !rows.iter().any(moves_level) {
            let level = over.level(&program.basis);
            demands.push(Line::new(vec![(level, 1.0)], 0.0));
        }
        let implied = Implied::by(program);
        let largest = start.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let mut lines = Vec::with_capacity(rows.len());
        for (index, row) in rows.iter().enumerate() {
            let beside = row.extra.iter().any(|e| *e != 0.0);
            let free = if beside { 1.0 } else { implied.free(row) };
            if free < IMPLIED {
                // What the demands fix on the wrong side of a limit is a question for the caller.
                let missed = value(&row.entries, &start) - row.bound;
                if missed > BROKEN * row_unit(&row.entries, length) {
                    return None;
                }
                continue;
            }
            let (window, entries, at_start) = over.row(row, &start);
            let unit = row_unit(&entries, length) * free;
            let mut line = scaled(entries, unit);
            for k in 0..EXTRAS {
                if let (Some(column), true) = (columns.of[k], row.extra[k] != 0.0) {
                    line.push((column, row.extra[k] * columns.unit[k] / unit));
                }
            }
            let kept_free = margin * row.scale + rounding(program, row, largest);
            lines.push(Kept {
                index,
                unit,
                window,
                entries: line,
                bound: (row.bound - kept_free - at_start) / unit,
            });
        }
        let mut cone = None;
        if program.cone {
            cone = Some([columns.of[RADIUS]?, columns.of[RISE]?, columns.of[OFFSET]?]);
        }
        let value = (program.objective(&start) + program.constant).abs() / weight;
        let out = Scaled {
            system: System {
                matrix: Matrix::Banded(ArrowMatrix::zero(0, 0, 0), Vec::new()),
                gradient,
                size: 0.0,
                demands,
                bounds: Vec::new(),
                cone,
                value,
            },
            start,
            columns,
            kept: Vec::new(),
        };
        Some((out, lines))
    }

    /// The program's rows among the system's, in its order.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        self.kept.iter().map(|k| k.0)
    }

    fn take_bounds(&mut self, lines: &[Kept]) {
        self.system.bounds = lines.iter().map(|l| l.bound).collect();
        self.kept = lines.iter().map(|l| (l.index, l.unit)).collect();
    }

    /// What was found, in the program's own units.
    pub fn point(&self, program: &Program, rows: &mut [Row], found: Found) -> Point {
        let weight = program.multiplier_unit(self.columns.unit[PEAK]);
        rows.iter_mut().for_each(|row| row.multiplier = 0.0);
        for (z, &(index, unit)) in found.pushes.iter().zip(&self.kept) {
            rows[index].multiplier = z * weight / unit;
        }
        let mut extra = [0.0; EXTRAS];
        for (k, value) in extra.iter_mut().enumerate() {
            if let Some(column) = self.columns.of[k] {
                *value = found.unknowns[column] * self.columns.unit[k];
            }
        }
        Point {
            x: self.law(program, &found.unknowns),
            extra,
            iterations: found.iterations,
            inside: None,
        }
    }

    /// Coefficients of the lift.
    pub fn law(&self, program: &Program, unknowns: &[f64]) -> Vec<f64> {
        match (&self.system.matrix, &program.lifted) {
            (Matrix::Chained(base, _), Some(lifted)) => {
                let layout = &base.chain.layout;
                layout.lift(lifted, &self.start, unknowns, program.length)
            }
            _ => {
                let moved = self.start.iter().zip(unknowns);
                moved.map(|(x, u)| x + u * program.length).collect()
            }
        }
    }
}

/// What the lift's coefficients leave uncertain of a limit, where room can be kept: `largest` is the largest of them.
fn rounding(program: &Program, row: &Row, largest: f64) -> f64 {
    if program.lifted.is_none() || row.scale == 0.0 {
        return 0.0;
    }
    let size: f64 = row.entries.iter().map(|e| e.1.abs()).sum();
    ROUNDINGS * f64::EPSILON * size * largest
}

/// The rows of the demands as an orthonormal basis: a limit's row in their span says nothing, or cannot be mended.
struct Implied(Vec<Vec<f64>>);

impl Implied {
    fn by(program: &Program) -> Self {
        let mut kept = Implied(Vec::new());
        for demand in &program.equalities {
            let mut row = vec![0.0; program.basis.columns()];
            for &(i, a) in &demand.entries {
                row[i] += a;
            }
            let before = length(&row);
            kept.take_out(&mut row);
            kept.take_out(&mut row);
            let left = length(&row);
            if left > IMPLIED * before {
                row.iter_mut().for_each(|x| *x /= left);
                kept.0.push(row);
            }
        }
        kept
    }

    fn take_out(&self, row: &mut [f64]) {
        for q in &self.0 {
            let part: f64 = q.iter().zip(&*row).map(|(q, x)| q * x).sum();
            for (x, q) in row.iter_mut().zip(q) {
                *x -= part * q;
            }
        }
    }

    /// Part of a row's length that the demands leave open.
    fn free(&self, row: &Row) -> f64 {
        let whole: f64 = row.entries.iter().map(|e| e.1 * e.1).sum();
        let mut left = whole;
        for q in &self.0 {
            let part: f64 = row.entries.iter().map(|&(i, a)| q[i] * a).sum();
            left -= part * part;
        }
        if left > NEARLY * whole || whole == 0.0 {
            return 1.0;
        }
        // Little is left: the difference of squares has no digits of it.
        let mut rest = vec![0.0; self.0.first().map_or(0, Vec::len)];
        for &(i, a) in &row.entries {
            rest[i] += a;
        }
        self.take_out(&mut rest);
        self.take_out(&mut rest);
        length(&rest) / whole.sqrt()
    }
}

fn length(row: &[f64]) -> f64 {
    row.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The optimum without limits, where the objective alone has one.
fn start(program: &Program) -> Vec<f64> {
    match equality::solve(program) {
        Ok(unlimited) => program.on_base_circle(unlimited.x),
        Err(_) => vec![0.0; program.basis.columns()],
    }
}
