//! A program in the units of the solver: lengths in typical lifts, rows and objective near one, counted from the
//! optimum without limits.

use super::system::{Found, Line, System};
use crate::synth::qp::band::ArrowMatrix;
use crate::synth::qp::basis::Basis;
use crate::synth::qp::clarabel::{Columns, Point, row_unit};
use crate::synth::qp::double::{Double, Number};
use crate::synth::qp::equality;
use crate::synth::qp::lifted::Lifted;
use crate::synth::qp::program::{EXTRAS, OFFSET, PEAK, Program, RADIUS, RISE, Row};

/// A row of which the demands leave open less than this part of its length is none.
const IMPLIED: f64 = 1e-9;
/// … and one of which they leave less than this part of its square is measured by what is left.
const NEARLY: f64 = 1e-4;
/// … and that is broken by more than this, in its own unit, is broken by the demands.
const BROKEN: f64 = 1e-9;
/// Roundings kept free inside limits of many spans.
const ROUNDINGS: f64 = 16.0;

/// A program as the method solves it.
pub struct Scaled<T> {
    pub system: System<T>,
    /// The law from which unknowns count.
    start: Vec<f64>,
    columns: Columns,
    /// Index and unit of each row that the demands leave open.
    kept: Vec<(usize, f64)>,
}

/// What differs between numbers of usual and of twice the digits.
struct Parts<T> {
    hessian: ArrowMatrix<T>,
    /// Hx + g at the start.
    pull: Vec<T>,
    demands: Vec<Vec<(usize, T)>>,
    rows: Vec<Vec<(usize, T)>>,
}

impl Scaled<Double> {
    /// Matrix and rows from the derivatives' own coefficients, which keep the digits.
    pub fn of_many_spans(
        program: &Program,
        lifted: &Lifted,
        rows: &[Row],
        margin: f64,
    ) -> Option<Self> {
        let start = start(program);
        let folded = lifted.in_full();
        let x: Vec<Double> = start.iter().map(|&x| Double::of(x)).collect();
        let mut pull = folded.hessian.times(&x);
        for (p, &g) in pull.iter_mut().zip(&folded.gradient) {
            *p = *p + g;
        }
        let exact = |entries: &[(usize, f64)]| {
            let wide = entries.iter().map(|&(i, v)| (i, Double::of(v)));
            wide.collect::<Vec<_>>()
        };
        let parts = Parts {
            hessian: folded.hessian.clone(),
            pull,
            demands: program
                .equalities
                .iter()
                .map(|e| exact(&e.entries))
                .collect(),
            rows: (rows.iter())
                .map(|r| lifted.full_row(&folded, r.peak.piece, r.peak.u, &r.weights))
                .collect(),
        };
        Self::of(program, rows, margin, start, parts)
    }
}

impl Scaled<f64> {
    /// Matrix and rows as the program has them.
    pub fn of_few_spans(program: &Program, rows: &[Row], margin: f64) -> Option<Self> {
        let start = start(program);
        let mut pull = program.hessian.times(&start);
        for (p, g) in pull.iter_mut().zip(&program.gradient) {
            *p += g;
        }
        let parts = Parts {
            hessian: program.hessian.clone(),
            pull,
            demands: (program.equalities.iter())
                .map(|e| e.entries.clone())
                .collect(),
            rows: rows.iter().map(|r| r.entries.clone()).collect(),
        };
        Self::of(program, rows, margin, start, parts)
    }
}

impl<T: Number> Scaled<T> {
    fn of(
        program: &Program,
        rows: &[Row],
        margin: f64,
        start: Vec<f64>,
        parts: Parts<T>,
    ) -> Option<Self> {
        let n = program.basis.columns();
        let (length, weight) = (program.length, program.objective_unit());
        let columns = Columns::new(program, rows, n);
        let beside = columns.total - n;
        let (band, border) = parts.hessian.pattern();
        let mut hessian = ArrowMatrix::zero(columns.total, band, border + beside);
        let factor = T::of(length) * T::of(length) / T::of(weight);
        for (i, j, value) in parts.hessian.lower_entries() {
            hessian.add(i, j, value * factor);
        }
        let by_length = T::of(length) / T::of(weight);
        let mut gradient: Vec<T> = parts.pull.iter().map(|&p| p * by_length).collect();
        gradient.resize(columns.total, T::of(0.0));
        for k in 0..EXTRAS {
            if let Some(column) = columns.of[k] {
                // The peak has a unit of its own and stands alone in the objective.
                gradient[column] = T::of(if k == PEAK {
                    program.cost[k].signum()
                } else {
                    program.cost[k] * length / weight
                });
            }
        }
        let at_start = |entries: &[(usize, T)]| {
            let terms = entries.iter().map(|&(i, a)| a * T::of(start[i]));
            terms.fold(T::of(0.0), |sum, term| sum + term)
        };
        let scaled = |entries: &[(usize, T)], unit: f64| -> Vec<(usize, T)> {
            let by = T::of(length) / T::of(unit);
            entries.iter().map(|&(i, a)| (i, a * by)).collect()
        };
        let mut demands = Vec::with_capacity(program.equalities.len());
        for (demand, entries) in program.equalities.iter().zip(&parts.demands) {
            let unit = row_unit(&demand.entries, length);
            let bound = (T::of(demand.value) - at_start(entries)) / T::of(unit);
            demands.push(Line::new(scaled(entries, unit), bound));
        }
        let moves_level = |r: &Row| r.weights[0] != 0.0 || r.limit.is_none();
        if program.level_is_open() && !rows.iter().any(moves_level) {
            let level = match program.basis {
                Basis::Spline { .. } => n - 1,
                Basis::Harmonic { .. } => 0,
            };
            demands.push(Line::new(vec![(level, T::of(1.0))], T::of(0.0)));
        }
        let implied = Implied::by(program);
        let mut lines = Vec::with_capacity(rows.len());
        let mut kept = Vec::with_capacity(rows.len());
        for (index, (row, entries)) in rows.iter().zip(&parts.rows).enumerate() {
            let beside = row.extra.iter().any(|e| *e != 0.0);
            let free = if beside { 1.0 } else { implied.free(row) };
            if free < IMPLIED {
                // What the demands fix on the wrong side of a limit is a question for the caller.
                let value: f64 = row.entries.iter().map(|&(i, a)| a * start[i]).sum();
                if value - row.bound > BROKEN * row_unit(&row.entries, length) {
                    return None;
                }
                continue;
            }
            let unit = row_unit(&row.entries, length) * free;
            let mut line = scaled(entries, unit);
            for k in 0..EXTRAS {
                if let (Some(column), true) = (columns.of[k], row.extra[k] != 0.0) {
                    line.push((column, T::of(row.extra[k] * columns.unit[k] / unit)));
                }
            }
            let kept_free = margin * row.scale + rounding(program, row);
            let bound = T::of(row.bound - kept_free) - at_start(entries);
            lines.push(Line::new(line, bound / T::of(unit)));
            kept.push((index, unit));
        }
        let mut cone = None;
        if program.cone {
            cone = Some([columns.of[RADIUS]?, columns.of[RISE]?, columns.of[OFFSET]?]);
        }
        let value = (program.objective(&start) + program.constant).abs() / weight;
        Some(Scaled {
            system: System {
                hessian,
                gradient,
                demands,
                rows: lines,
                cone,
                value,
            },
            start,
            columns,
            kept,
        })
    }

    /// What was found, in the program's own units.
    pub fn point(&self, program: &Program, rows: &mut [Row], found: Found<T>) -> Point {
        let weight = program.multiplier_unit(self.columns.unit[PEAK]);
        rows.iter_mut().for_each(|row| row.multiplier = 0.0);
        for (z, &(index, unit)) in found.pushes.iter().zip(&self.kept) {
            rows[index].multiplier = z * weight / unit;
        }
        let length = T::of(program.length);
        let moved = self.start.iter().zip(&found.unknowns);
        let mut extra = [0.0; EXTRAS];
        for (k, value) in extra.iter_mut().enumerate() {
            if let Some(column) = self.columns.of[k] {
                *value = found.unknowns[column].rounded() * self.columns.unit[k];
            }
        }
        Point {
            x: moved
                .map(|(&x, &u)| (T::of(x) + u * length).rounded())
                .collect(),
            extra,
            iterations: found.iterations,
        }
    }
}

/// What differences of the lift's coefficients leave uncertain of a limit, where room can be kept.
fn rounding(program: &Program, row: &Row) -> f64 {
    if program.lifted.is_none() || row.scale == 0.0 {
        return 0.0;
    }
    let size: f64 = row.entries.iter().map(|e| e.1.abs()).sum();
    ROUNDINGS * f64::EPSILON * size * program.length
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
