//! Solving once more with the active rows as equalities: the digits an interior-point method leaves out.

use super::cones::Point;
use super::problem::{Program, Row};

/// Larger systems are left as the solver gave them.
const LARGEST: usize = 500;

/// Improves the point where that is possible without breaking a row or turning a multiplier negative;
/// otherwise returns it as it came. Multipliers of rows found inactive become 0.
pub fn polish(
    program: &Program,
    rows: &mut [Row],
    point: &Point,
    has_peak: bool,
) -> (Vec<f64>, Option<f64>) {
    let as_given = (point.x.clone(), point.peak);
    let n = program.basis.columns();
    let columns = n + usize::from(has_peak);
    let active = active_rows(program, rows, point);
    for (i, row) in rows.iter_mut().enumerate() {
        if !active.contains(&i) {
            row.multiplier = 0.0;
        }
    }
    let k = program.equalities.len() + active.len();
    if columns + k > LARGEST {
        return as_given;
    }
    // Work in units of `length` and scaled rows, as the solver did, so that pivots mean something.
    let length = program.length;
    let h_unit = program.objective_unit();
    let t_unit = point
        .peak
        .map_or(1.0, |t| if t == 0.0 { 1.0 } else { t.abs() });
    let mut kkt = nalgebra::DMatrix::<f64>::zeros(columns + k, columns + k);
    for (i, j, value) in program.hessian.lower_entries() {
        let v = value * length * length / h_unit;
        kkt[(i, j)] = v;
        kkt[(j, i)] = v;
    }
    let mut rhs = nalgebra::DVector::<f64>::zeros(columns + k);
    for i in 0..n {
        rhs[i] = -program.gradient[i] * length / h_unit;
    }
    if has_peak {
        rhs[n] = -1.0;
    }
    let mut units = Vec::with_capacity(k);
    let mut put = |r: usize,
                   entries: &[(usize, f64)],
                   bound: f64,
                   is_peak: bool,
                   rhs: &mut nalgebra::DVector<f64>| {
        let unit = entries
            .iter()
            .fold(0.0_f64, |m, e| m.max((e.1 * length).abs()))
            .max(f64::MIN_POSITIVE);
        for &(i, v) in entries {
            kkt[(columns + r, i)] = v * length / unit;
            kkt[(i, columns + r)] = v * length / unit;
        }
        if is_peak {
            kkt[(columns + r, n)] = -t_unit / unit;
            kkt[(n, columns + r)] = -t_unit / unit;
            rhs[columns + r] = 0.0;
        } else {
            rhs[columns + r] = bound / unit;
        }
        units.push(unit);
    };
    for (r, e) in program.equalities.iter().enumerate() {
        put(r, &e.entries, e.value, false, &mut rhs);
    }
    let first = program.equalities.len();
    for (r, &index) in active.iter().enumerate() {
        let limit = &program.limits[rows[index].limit];
        put(
            first + r,
            &rows[index].entries,
            limit.bound,
            limit.is_peak,
            &mut rhs,
        );
    }
    let lu = kkt.clone().lu();
    let Some(mut y) = lu.solve(&rhs) else {
        return as_given;
    };
    if let Some(correction) = lu.solve(&(&rhs - &kkt * &y)) {
        y += correction;
    }
    let residual = (&rhs - &kkt * &y).amax();
    if !residual.is_finite() || residual > 1e-9 * (1.0 + rhs.amax()) {
        return as_given;
    }
    let signs_hold = (0..active.len()).all(|r| y[columns + first + r] > -1e-7 * y.amax());
    let x: Vec<f64> = (0..n).map(|i| y[i] * length).collect();
    let t = has_peak.then(|| y[n] * t_unit);
    if !signs_hold || program.violation(&x, t) > program.violation(&point.x, point.peak).max(1e-9) {
        return as_given;
    }
    for (r, &index) in active.iter().enumerate() {
        rows[index].multiplier = (y[columns + first + r] * h_unit / units[first + r]).max(0.0);
    }
    (x, t)
}

/// Rows whose multiplier outweighs their slack, both in the solver's scaled units.
fn active_rows(program: &Program, rows: &[Row], point: &Point) -> Vec<usize> {
    let h_unit = (program.hessian.largest_diagonal() * program.length * program.length)
        .max(f64::MIN_POSITIVE);
    rows.iter()
        .enumerate()
        .filter(|(_, row)| {
            let limit = &program.limits[row.limit];
            let unit = row
                .entries
                .iter()
                .fold(0.0_f64, |m, e| m.max((e.1 * program.length).abs()))
                .max(f64::MIN_POSITIVE);
            let bound = if limit.is_peak {
                point.peak.unwrap_or(0.0)
            } else {
                limit.bound
            };
            let slack = (bound - super::basis::apply(&row.entries, &point.x)) / unit;
            row.multiplier * unit / h_unit > slack.max(0.0)
        })
        .map(|(i, _)| i)
        .collect()
}
