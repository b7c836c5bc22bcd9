//! Rows of the reference for Clarabel, scaled to suitable units.

use super::judge::Judged;
use super::solve::{Exchange, Row};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};
use nalgebra::DVector;

/// Units and tolerances. If rounding stops the solver with the first pair, the others are tried.
const TRIES: [(f64, f64); 6] = [
    (1.0, 1e-12),
    (1.0, 1e-10),
    (0.1, 1e-11),
    (10.0, 1e-11),
    (100.0, 1e-11),
    (1.0, 1e-9),
];
/// Maximum residuals and gap of a valid result, in the solver's units.
const GOOD: f64 = 1e-7;
/// Maximum dual residual, in the solver's units. The bound is reduced by it.
const GOOD_DUAL: f64 = 1e-5;

/// u, the further variables, and the dual value. `Err(None)`: the rows allow no law.
pub type Answer = Result<(DVector<f64>, Vec<f64>, f64), Option<String>>;

impl Exchange<'_> {
    /// First valid result. For a linear program, whose residuals reduce the bound most, the highest bound of all tries if the first is insufficient.
    pub fn solved(&self, unit: f64, from: &[f64]) -> Answer {
        let mut best: Answer = Err(Some(String::new()));
        for (times, tolerance) in TRIES {
            let highest = match &best {
                Ok((.., bound)) if self.is_square() || *bound >= self.aim.enough => return best,
                Ok((.., bound)) => *bound,
                Err(Some(_)) => f64::NEG_INFINITY,
                Err(None) => return best,
            };
            let answer = self.clarabel(times * unit, tolerance, from);
            let is_higher = matches!(&answer, Ok((.., bound)) if *bound > highest);
            if best.is_err() || is_higher {
                best = answer;
            }
        }
        best
    }

    /// Initial unit of u: distance to the farthest row that the law without limits violates.
    pub fn first_unit(&self, start: &Judged) -> f64 {
        if !self.space.is_square {
            return 1.0;
        }
        let longest = self.rows.iter().map(|r| r.own.norm()).fold(0.0, f64::max);
        let long = self.rows.iter().filter(|r| r.own.norm() > 1e-3 * longest);
        let far = long.map(|r| {
            let beside: Vec<f64> = start.extras.iter().copied().chain([0.0]).collect();
            (r.taken(&beside) - r.bound) / r.own.norm()
        });
        let far = far.filter(|f| f.is_finite());
        let far = far.fold(0.0, f64::max);
        // A row that the law touches is broken by rounding alone.
        let size = start.value.abs().sqrt();
        if far > 1e-9 * size { far } else { size }
    }

    /// Scales of the rows for laws of size `unit`, and units of the further variables, which move their rows as far as the law does.
    fn scales(&self, unit: f64) -> (Vec<f64>, Vec<f64>) {
        let longest = self.rows.iter().map(|r| r.own.norm()).fold(0.0, f64::max);
        let length = |r: &Row| {
            let own = r.own.norm();
            // A row of a variable alone is as long as that makes it.
            let least = if r.beside.is_empty() {
                0.0
            } else {
                1e-3 * longest
            };
            own.max(least) * unit
        };
        let lengths: Vec<f64> = self.rows.iter().map(length).collect();
        let of = |k: usize| {
            let mine = self.rows.iter().zip(&lengths);
            let mine =
                mine.filter_map(|(r, l)| Some(l / r.beside.iter().find(|e| e.0 == k)?.1.abs()));
            mine.fold(0.0, f64::max).max(1e-300)
        };
        let units = (0..self.costs().len()).map(of).collect();
        (lengths, units)
    }

    /// Constraint matrix for Clarabel over u and the further variables, which are measured relative to `from`.
    fn matrix(
        &self,
        unit: f64,
        lengths: &[f64],
        units: &[f64],
        from: &[f64],
    ) -> (CscMatrix<f64>, Vec<f64>) {
        let n = self.space.free.ncols();
        let (mut i, mut j, mut v, mut b) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (at, (row, length)) in self.rows.iter().zip(lengths).enumerate() {
            let mut put = |column: usize, value: f64| {
                i.push(at);
                j.push(column);
                v.push(value / length);
            };
            (row.own.iter().enumerate()).for_each(|(column, a)| put(column, a * unit));
            let mut bound = row.bound;
            for &(k, e) in &row.beside {
                put(n + k, e * units[k]);
            }
            bound -= row.taken(from);
            b.push(bound / length);
        }
        let columns = n + units.len();
        (CscMatrix::new_from_triplets(b.len(), columns, i, j, v), b)
    }

    fn clarabel(&self, unit: f64, tolerance: f64, from: &[f64]) -> Answer {
        let (n, own_costs) = (self.space.free.ncols(), self.costs());
        let (lengths, units) = self.scales(unit);
        let (a, b) = self.matrix(unit, &lengths, &units, from);
        let costs = own_costs.iter().zip(&units).map(|(cost, unit)| cost * unit);
        let square = if self.is_square() { unit * unit } else { 0.0 };
        let weight = costs.clone().fold(square, f64::max);
        let all = n + own_costs.len();
        let diagonal = vec![square / weight; n];
        let p =
            CscMatrix::new_from_triplets(all, all, (0..n).collect(), (0..n).collect(), diagonal);
        let q: Vec<f64> = std::iter::repeat_n(0.0, n)
            .chain(costs.map(|c| c / weight))
            .collect();
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_threads(1)
            .tol_gap_abs(tolerance)
            .tol_gap_rel(tolerance)
            .tol_feas(tolerance)
            .build()
            .map_err(|e| Some(e.to_string()))?;
        let cones = [SupportedConeT::NonnegativeConeT(b.len())];
        let mut solver = DefaultSolver::new(&p, &q, &a, &b, &cones, settings)
            .map_err(|e| Some(e.to_string()))?;
        solver.solve();
        let answer = &solver.solution;
        let gap = (answer.obj_val - answer.obj_val_dual).abs();
        match answer.status {
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return Err(None);
            }
            SolverStatus::Solved => {}
            _ if answer.r_prim < GOOD
                && answer.r_dual < GOOD_DUAL
                && gap < GOOD * answer.obj_val.abs().max(1.0) => {}
            status => return Err(Some(format!("{status:?}, gap {gap:e}"))),
        }
        let u = DVector::from_fn(n, |k, _| unit * answer.x[k]);
        let beside = (0..own_costs.len()).map(|k| from[k] + units[k] * answer.x[n + k]);
        let constant: f64 = own_costs.iter().zip(from).map(|(cost, y)| cost * y).sum();
        let length = answer.x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let dual = answer.obj_val_dual - answer.r_dual * length;
        Ok((
            u,
            beside.collect(),
            if self.seeks_room {
                0.0
            } else {
                self.space.least
            } + constant
                + weight * dual,
        ))
    }
}
