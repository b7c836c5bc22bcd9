//! A step of Newton's method on the contacts: the program about a solution, in the solver's units.
//!
//! ```text
//! (H + Σ λ/(−c″) a′a′ᵀ + ε) d + Eᵀν + Aᵀλ = −(Hx + g)      E d = e − E x      A d − δ (λ − λ₀) = b − A x
//! ```

use super::Contacts;
use crate::synth::qp::basis::{Entries, apply};
use crate::synth::qp::clarabel::row_unit;
use crate::synth::qp::program::{EXTRAS, PEAK, Row, Solution};
use crate::synth::qp::quadratic_step::{self, Plane, Step};
use nalgebra::{DMatrix, DVector};

/// Raises of what holds a step while its matrix has no factor.
const RAISES: i32 = 4;
/// … by this factor.
const RAISED: f64 = 100.0;

/// The program about a solution, in the solver's units.
pub struct Local<'a> {
    contacts: &'a Contacts<'a>,
    from: &'a Solution,
    /// Units of the unknowns: coefficients first.
    units: Vec<f64>,
    objective: f64,
    matrix: DMatrix<f64>,
    /// What holds a step where nothing else does.
    held: f64,
    gradient: DVector<f64>,
}

impl<'a> Local<'a> {
    pub fn new(contacts: &'a Contacts<'a>, from: &'a Solution) -> Self {
        let program = contacts.program;
        let n = program.basis.columns();
        let objective = program.multiplier_unit(from.extra[PEAK]);
        let unit = |k: usize| match from.extra[PEAK].abs() {
            peak if k == PEAK && peak > 0.0 => peak,
            _ => program.length,
        };
        let mut units = vec![program.length; n];
        units.extend(contacts.free.iter().map(|&k| unit(k)));
        let mut stiff = program.hessian.clone();
        for row in from.active.iter().filter(|r| r.multiplier > 0.0) {
            let Some(falls) = contacts.sharpness(&from.x, row) else {
                continue;
            };
            let w = row.weights;
            let once = [0.0, w[0], w[1], w[2], w[3]];
            let slope = program.basis.row_on(row.peak.piece, row.peak.u, &once);
            for (p, &(i, a)) in slope.iter().enumerate() {
                for &(j, b) in &slope[..=p] {
                    stiff.add(i, j, row.multiplier / falls * a * b);
                }
            }
        }
        let mut matrix = DMatrix::<f64>::zeros(units.len(), units.len());
        for (i, j, value) in stiff.lower_entries() {
            matrix[(i, j)] = value * units[i] * units[j] / objective;
            matrix[(j, i)] = matrix[(i, j)];
        }
        let held = program.settings.contacts.held;
        (0..units.len()).for_each(|i| matrix[(i, i)] += held);
        let hx = program.hessian.times(&from.x[..n]);
        let of_law = (hx.iter().zip(&program.gradient)).map(|(h, g)| h + g);
        let beside = contacts.free.iter().map(|&k| program.cost[k]);
        let gradient = DVector::from_iterator(
            units.len(),
            (of_law.chain(beside).zip(&units)).map(|(g, unit)| g * unit / objective),
        );
        Local {
            contacts,
            from,
            units,
            objective,
            matrix,
            held,
            gradient,
        }
    }

    /// A row as a plane of the step, and the unit that it is divided by.
    fn plane(
        &self,
        (entries, extra, bound): (&Entries, &[f64; EXTRAS], f64),
        equal: bool,
    ) -> (Plane, f64) {
        let program = self.contacts.program;
        let scale = row_unit(entries, program.length);
        let mut normal = DVector::zeros(self.units.len());
        for &(i, v) in entries {
            normal[i] += v * self.units[i] / scale;
        }
        let n = program.basis.columns();
        for (c, &k) in self.contacts.free.iter().enumerate() {
            normal[n + c] += extra[k] * self.units[n + c] / scale;
        }
        let taken: f64 = (0..EXTRAS).map(|k| extra[k] * self.from.extra[k]).sum();
        let bound = (bound - taken - apply(entries, &self.from.x)) / scale;
        let plane = Plane {
            normal,
            bound,
            equal,
        };
        (plane, scale)
    }

    /// The step under these rows; its active ones with their multipliers.
    pub fn solved(&self, rows: &[Row]) -> Option<Solution> {
        let program = self.contacts.program;
        let demands = program.equalities.len();
        let (planes, scales) = self.planes(rows);
        let rough = (0..RAISES).find_map(|raise| {
            let mut matrix = self.matrix.clone();
            let held = self.held * (RAISED.powi(raise) - 1.0);
            (0..self.units.len()).for_each(|i| matrix[(i, i)] += held);
            quadratic_step::solve(&matrix.cholesky()?, &self.gradient, &planes)
        })?;
        let active: Vec<usize> = (0..planes.len())
            .filter(|&i| planes[i].equal || rough.pushes[i] > 0.0)
            .collect();
        let weights = |i: usize| rows[i - demands].multiplier * scales[i] / self.objective;
        let step = self.with_last_digits(&planes, &active, demands, weights);
        let pulls = |step: &Step| {
            let of_rows = || step.pushes[demands..].iter();
            let largest = of_rows().fold(0.0_f64, |m, p| m.max(p.abs()));
            let most = program.settings.local_reduction.negative_multiplier * largest;
            of_rows().any(|p| *p < -most)
        };
        let step = step.filter(|s| !pulls(s)).unwrap_or(rough);
        Some(self.moved(rows, &scales, &active, step))
    }

    /// The step with all rows as equalities, whatever their multipliers' signs.
    pub fn held(&self, rows: &[Row]) -> Option<Solution> {
        let (planes, scales) = self.planes(rows);
        let demands = self.contacts.program.equalities.len();
        let all: Vec<usize> = (0..planes.len()).collect();
        let weights = |i: usize| rows[i - demands].multiplier * scales[i] / self.objective;
        let step = self.with_last_digits(&planes, &all, demands, weights)?;
        Some(self.moved(rows, &scales, &all, step))
    }

    /// Demands and rows as planes, and their units.
    fn planes(&self, rows: &[Row]) -> (Vec<Plane>, Vec<f64>) {
        let none = [0.0; EXTRAS];
        (self.contacts.program.equalities.iter())
            .map(|e| self.plane((&e.entries, &none, e.value), true))
            .chain((rows.iter()).map(|r| self.plane((&r.entries, &r.extra, r.bound), false)))
            .unzip()
    }

    /// The solution after a step, with the rows that it holds.
    fn moved(&self, rows: &[Row], scales: &[f64], active: &[usize], step: Step) -> Solution {
        let program = self.contacts.program;
        let demands = program.equalities.len();
        let mut next = self.from.clone();
        let n = program.basis.columns();
        (0..n).for_each(|i| next.x[i] += step.way[i] * self.units[i]);
        for (c, &k) in self.contacts.free.iter().enumerate() {
            next.extra[k] += step.way[n + c] * self.units[n + c];
        }
        next.active = (active.iter().filter(|&&i| i >= demands))
            .map(|&i| Row {
                multiplier: step.pushes[i] * self.objective / scales[i],
                ..rows[i - demands].clone()
            })
            .collect();
        next.iterations += 1;
        next
    }

    /// The same with the active planes as equalities.
    fn with_last_digits(
        &self,
        planes: &[Plane],
        active: &[usize],
        demands: usize,
        multiplier: impl Fn(usize) -> f64,
    ) -> Option<Step> {
        let columns = self.units.len();
        let size = columns + active.len();
        let settings = &self.contacts.program.settings;
        let mut kkt = DMatrix::<f64>::zeros(size, size);
        kkt.view_mut((0, 0), (columns, columns))
            .copy_from(&self.matrix);
        let mut rhs = DVector::<f64>::zeros(size);
        rhs.rows_mut(0, columns).copy_from(&(-&self.gradient));
        for (r, &i) in active.iter().enumerate() {
            let at = columns + r;
            for (c, value) in planes[i].normal.iter().enumerate() {
                kkt[(at, c)] = *value;
                kkt[(c, at)] = *value;
            }
            rhs[at] = planes[i].bound;
            if i >= demands {
                kkt[(at, at)] = -settings.contacts.light;
                rhs[at] -= settings.contacts.light * multiplier(i);
            }
        }
        let lu = kkt.clone().lu();
        let mut y = lu.solve(&rhs)?;
        for _ in 0..2 {
            y += lu.solve(&(&rhs - &kkt * &y))?;
        }
        if !y.iter().all(|v| v.is_finite()) {
            return None;
        }
        let mut pushes = vec![0.0; planes.len()];
        for (r, &i) in active.iter().enumerate() {
            pushes[i] = y[columns + r];
        }
        Some(Step {
            way: y.rows(0, columns).into_owned(),
            pushes,
        })
    }
}
