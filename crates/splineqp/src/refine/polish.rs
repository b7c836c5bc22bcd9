//! Solves once more with the active rows as equalities, for the digits that an interior-point method leaves unresolved.

use crate::Names;
use crate::basis::apply;
use crate::exchange::clarabel::{Point, row_unit};
use crate::program::{EXTRAS, PEAK, Program, Row};
use nalgebra::{DMatrix, DVector};

/// Improves the point where that is possible without breaking a row or turning a multiplier negative;
/// otherwise returns it as it came. Multipliers of rows found inactive become 0.
pub fn polish<N: Names>(
    program: &Program<N>,
    rows: &mut [Row<N>],
    point: &Point,
) -> (Vec<f64>, [f64; EXTRAS]) {
    let as_given = (point.x.clone(), point.extra);
    let active = active_rows(program, rows, point);
    let mut inactive = vec![true; rows.len()];
    active.iter().for_each(|&i| inactive[i] = false);
    for (row, inactive) in rows.iter_mut().zip(inactive) {
        if inactive {
            row.multiplier = 0.0;
        }
    }
    // A cone's surface is curved: what is active on it is not linear.
    if program.cone {
        return as_given;
    }
    let settings = &program.settings.refinement;
    let n = program.basis.columns();
    let present = program.present();
    let free: Vec<usize> = (0..EXTRAS).filter(|&k| present[k]).collect();
    let columns = n + free.len();
    let k = program.equalities.len() + active.len();
    if columns + k > program.settings.refinement.largest {
        return as_given;
    }
    // Work in units of `length` and scaled rows, as the solver did, so that pivots mean something.
    let length = program.length;
    let objective = program.objective_unit();
    let unit_of = |k: usize| {
        if k == PEAK && point.extra[PEAK] != 0.0 {
            point.extra[PEAK].abs()
        } else {
            length
        }
    };
    let mut kkt = DMatrix::<f64>::zeros(columns + k, columns + k);
    for (i, j, value) in program.hessian.lower_entries() {
        let v = value * length * length / objective;
        kkt[(i, j)] = v;
        kkt[(j, i)] = v;
    }
    let mut rhs = DVector::<f64>::zeros(columns + k);
    for i in 0..n {
        rhs[i] = -program.gradient[i] * length / objective;
    }
    for (c, &k) in free.iter().enumerate() {
        rhs[n + c] = -program.cost[k] * unit_of(k) / objective;
    }
    let mut units = Vec::with_capacity(k);
    let demands = program
        .equalities
        .iter()
        .map(|e| (&e.entries, [0.0; EXTRAS], e.value));
    let touching = active
        .iter()
        .map(|&i| (&rows[i].entries, rows[i].extra, rows[i].bound));
    for (r, (entries, extra, bound)) in demands.chain(touching).enumerate() {
        let unit = row_unit(entries, length);
        let mut put = |column: usize, value: f64| {
            kkt[(columns + r, column)] = value / unit;
            kkt[(column, columns + r)] = value / unit;
        };
        for &(i, v) in entries {
            put(i, v * length);
        }
        for (c, &k) in free.iter().enumerate() {
            put(n + c, extra[k] * unit_of(k));
        }
        rhs[columns + r] = bound / unit;
        units.push(unit);
    }
    let lu = kkt.clone().lu();
    let Some(mut y) = lu.solve(&rhs) else {
        return as_given;
    };
    if let Some(correction) = lu.solve(&(&rhs - &kkt * &y)) {
        y += correction;
    }
    let residual = (&rhs - &kkt * &y).amax();
    if !residual.is_finite() || residual > settings.polish_residual * (1.0 + rhs.amax()) {
        return as_given;
    }
    let first = columns + program.equalities.len();
    let signs_hold = (0..active.len()).all(|r| y[first + r] > -settings.polish_negative * y.amax());
    let x: Vec<f64> = (0..n).map(|i| y[i] * length).collect();
    let mut extra = [0.0; EXTRAS];
    for (c, &k) in free.iter().enumerate() {
        extra[k] = y[n + c] * unit_of(k);
    }
    let before = program.violation(&point.x, &point.extra);
    if !signs_hold || program.violation(&x, &extra) > before.max(settings.polish_violation) {
        return as_given;
    }
    for (r, &index) in active.iter().enumerate() {
        let unit = units[program.equalities.len() + r];
        rows[index].multiplier = (y[first + r] * objective / unit).max(0.0);
    }
    (x, extra)
}

/// Rows whose multiplier outweighs their slack, both in the solver's scaled units.
fn active_rows<N: Names>(program: &Program<N>, rows: &[Row<N>], point: &Point) -> Vec<usize> {
    let objective = program.multiplier_unit(point.extra[PEAK]);
    rows.iter()
        .enumerate()
        .filter(|(_, row)| {
            let unit = row_unit(&row.entries, program.length);
            let beside: f64 = (0..EXTRAS).map(|k| row.extra[k] * point.extra[k]).sum();
            let slack = (row.bound - beside - apply(&row.entries, &point.x)) / unit;
            row.multiplier * unit / objective > slack.max(0.0)
        })
        .map(|(i, _)| i)
        .collect()
}
