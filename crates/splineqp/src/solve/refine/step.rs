//! Newton step for the active points. The linearised program about a solution is solved in scaled units (symbols: see the module `refine`).
//!
//! ```text
//! (H + Σ λ/(−c″) a′a′ᵀ + ε) d + Eᵀν + Aᵀλ = −(Hx + g)      E d = e − E x      A d − δ (λ − λ₀) = b − A x
//! ```

use super::Contacts;
use super::sparse::symmetric_solution;
use crate::Names;
use crate::band::{ArrowFactor, ArrowMatrix};
use crate::basis::{Entries, apply, row_unit};
use crate::program::{PEAK, Row, Solution, Values, Variable};
use crate::solve::active_set::dual::Dual;

/// Plane aᵀd ≤ bound, or aᵀd = bound, for the step d. The entries of a are of order 1.
struct Plane {
    entries: Entries,
    bound: f64,
    equal: bool,
}

/// Step in scaled units, with the multipliers of the planes. The multiplier of an inactive plane is 0.
struct Step {
    way: Vec<f64>,
    multipliers: Vec<f64>,
}

/// The linearised program about a solution, in scaled units.
pub struct Local<'a, N: Names> {
    contacts: &'a Contacts<'a, N>,
    from: &'a Solution<N>,
    /// Units of the unknowns: coefficients first, then further variables.
    units: Vec<f64>,
    objective: f64,
    matrix: ArrowMatrix,
    /// Proximal weight ε of the step.
    held: f64,
    gradient: Vec<f64>,
}

impl<'a, N: Names> Local<'a, N> {
    pub fn new(contacts: &'a Contacts<'a, N>, from: &'a Solution<N>) -> Self {
        let program = contacts.program;
        let n = program.basis.columns();
        let objective = program.multiplier_unit(from.extra[PEAK]);
        let unit = |k: Variable| match from.extra[PEAK].abs() {
            peak if k == PEAK && peak > 0.0 => peak,
            _ => program.typical(k),
        };
        let mut units = vec![program.length; n];
        units.extend(contacts.free.iter().map(|&k| unit(k)));
        let stiff = contacts.with_curvature(program.hessian.clone(), from);
        let (band, border) = stiff.shape();
        let mut matrix = ArrowMatrix::zero(units.len(), band, border + contacts.free.len());
        for (i, j, value) in stiff.lower_entries() {
            matrix.add(i, j, value * units[i] * units[j] / objective);
        }
        let held = program.settings.refinement.held;
        (0..units.len()).for_each(|i| matrix.add(i, i, held));
        let hx = program.hessian.times(&from.x[..n]);
        let of_law = (hx.iter().zip(&program.gradient)).map(|(h, g)| h + g);
        let beside = contacts.free.iter().map(|&k| program.cost[k]);
        let gradient = (of_law.chain(beside).zip(&units))
            .map(|(g, unit)| g * unit / objective)
            .collect();
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

    /// Converts a row to a plane of the step. The second value is the unit by which the row is divided.
    fn plane(
        &self,
        (entries, extra, bound): (&Entries, &Values, f64),
        equal: bool,
    ) -> (Plane, f64) {
        let program = self.contacts.program;
        let scale = row_unit(entries, program.length);
        let own = entries.iter().map(|&(i, v)| (i, v * self.units[i] / scale));
        let n = program.basis.columns();
        let columns = (n..).zip(&self.contacts.free);
        let others = columns.map(|(c, &k)| (c, extra[k] * self.units[c] / scale));
        let normal: Entries = own.chain(others.filter(|e| e.1 != 0.0)).collect();
        let bound = (bound - extra.dot(&self.from.extra) - apply(entries, &self.from.x)) / scale;
        let plane = Plane {
            entries: normal,
            bound,
            equal,
        };
        (plane, scale)
    }

    /// Solution after the step of the quadratic program with the given rows. Its active rows have the new multipliers.
    pub fn solved(&self, rows: &[Row<N>]) -> Option<Solution<N>> {
        let program = self.contacts.program;
        let demands = program.equalities.len();
        let (planes, scales) = self.planes(rows);
        let settings = &program.settings.refinement;
        let rough = (0..settings.raises).find_map(|raise| {
            let held = self.held * (settings.raised.powi(raise) - 1.0);
            self.quadratic_step(&self.factor(held)?, &planes)
        })?;
        let active: Vec<usize> = (0..planes.len())
            .filter(|&i| planes[i].equal || rough.multipliers[i] > 0.0)
            .collect();
        let weights = |i: usize| rows[i - demands].multiplier * scales[i] / self.objective;
        let step = self.with_last_digits(&planes, &active, demands, weights);
        let is_negative = |step: &Step| {
            let of_rows = || step.multipliers[demands..].iter();
            let largest = of_rows().fold(0.0_f64, |m, p| m.max(p.abs()));
            let most = program.settings.refinement.negative_multiplier * largest;
            of_rows().any(|p| *p < -most)
        };
        let step = step.filter(|s| !is_negative(s)).unwrap_or(rough);
        Some(self.moved(rows, &scales, &active, step))
    }

    /// Cholesky factor of the matrix with `held` added to the diagonal.
    fn factor(&self, held: f64) -> Option<ArrowFactor> {
        let mut matrix = self.matrix.clone();
        (0..self.units.len()).for_each(|i| matrix.add(i, i, held));
        matrix.factor()
    }

    /// Solution of the quadratic program with the planes; `None` if the planes are infeasible.
    fn quadratic_step(&self, factor: &ArrowFactor, planes: &[Plane]) -> Option<Step> {
        let settings = &self.contacts.program.settings.refinement;
        let n = self.units.len();
        let pull: Vec<f64> = self.gradient.iter().map(|g| -g).collect();
        let most_steps = settings.steps_per_unknown * n;
        let mut set = Dual::new(factor, pull, vec![0.0; n], settings.dependent, most_steps);
        for plane in planes.iter().filter(|p| p.equal) {
            set.hold(None, &plane.entries, plane.bound, 0.0);
        }
        set.refresh();
        let mut left_out = vec![false; planes.len()];
        loop {
            let held = set.held(planes.len());
            let open = |i: &usize| !planes[*i].equal && !left_out[*i] && !held[*i];
            let excess = |i: usize| apply(&planes[i].entries, &set.x) - planes[i].bound;
            let worst = (0..planes.len())
                .filter(open)
                .map(|i| (i, excess(i)))
                .max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((i, _)) = worst.filter(|w| w.1 > settings.step_resolved) else {
                set.refresh();
                break;
            };
            match set.bring_in(i, &planes[i].entries, planes[i].bound) {
                Ok(()) => (),
                Err(stuck) if stuck.excess < settings.rounding => left_out[i] = true,
                Err(_) => return None,
            }
        }
        let mut multipliers = vec![0.0; planes.len()];
        set.multipliers().for_each(|(i, m)| multipliers[i] = m);
        Some(Step {
            way: set.x,
            multipliers,
        })
    }

    /// Solution after the step with all rows as equalities, regardless of the signs of their multipliers.
    pub fn held(&self, rows: &[Row<N>]) -> Option<Solution<N>> {
        let (planes, scales) = self.planes(rows);
        let demands = self.contacts.program.equalities.len();
        let all: Vec<usize> = (0..planes.len()).collect();
        let weights = |i: usize| rows[i - demands].multiplier * scales[i] / self.objective;
        let step = self.with_last_digits(&planes, &all, demands, weights)?;
        Some(self.moved(rows, &scales, &all, step))
    }

    /// Equalities and rows as planes of the step, with the units by which they are divided.
    fn planes(&self, rows: &[Row<N>]) -> (Vec<Plane>, Vec<f64>) {
        let none = Values::NONE;
        (self.contacts.program.equalities.iter())
            .map(|e| self.plane((&e.entries, &none, e.value), true))
            .chain((rows.iter()).map(|r| self.plane((&r.entries, &r.extra, r.bound), false)))
            .unzip()
    }

    /// Solution after a step, with its active rows and their multipliers.
    fn moved(&self, rows: &[Row<N>], scales: &[f64], active: &[usize], step: Step) -> Solution<N> {
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
                multiplier: step.multipliers[i] * self.objective / scales[i],
                ..rows[i - demands].clone()
            })
            .collect();
        next.iterations += 1;
        next
    }

    /// The step with the active planes as equalities, computed again with higher accuracy by a sparse linear system.
    fn with_last_digits(
        &self,
        planes: &[Plane],
        active: &[usize],
        demands: usize,
        multiplier: impl Fn(usize) -> f64,
    ) -> Option<Step> {
        let columns = self.units.len();
        let light = self.contacts.program.settings.refinement.light;
        let mut kkt: Vec<(usize, usize, f64)> = self.matrix.lower_entries();
        let mut rhs: Vec<f64> = self.gradient.iter().map(|g| -g).collect();
        for (r, &i) in active.iter().enumerate() {
            let at = columns + r;
            kkt.extend(planes[i].entries.iter().map(|&(c, value)| (at, c, value)));
            rhs.push(planes[i].bound);
            if i >= demands {
                kkt.push((at, at, -light));
                rhs[at] -= light * multiplier(i);
            }
        }
        let y = symmetric_solution(&kkt, &rhs)?;
        let mut multipliers = vec![0.0; planes.len()];
        for (r, &i) in active.iter().enumerate() {
            multipliers[i] = y[columns + r];
        }
        Some(Step {
            way: y[..columns].to_vec(),
            multipliers,
        })
    }
}
