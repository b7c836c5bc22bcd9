//! The optimum of a law of many spans on given contacts, by one factor.
//!
//! Contacts are held on their bounds by a penalty and multipliers that take up what it leaves (Bertsekas, Constrained
//! Optimization and Lagrange Multiplier Methods, ch. 2): rows that depend on each other, as those on an arc do, are held
//! as one, and cost stays in proportion to the spans.

use super::scaled::Scaled;
use super::system::Matrix;
use crate::synth::qp::lifted::Lifted;
use crate::synth::qp::program::{Program, Row};

/// Weight of a contact in the solver's units.
const PENALTY: f64 = 1e6;
/// Passes with one factor; each leaves a millionth of the one before.
const PASSES: usize = 4;

/// Minimises the program's objective and Σ ½ weight (row·x − bound)² of the stiff rows with every contact on its bound.
/// Returns coefficients and the contacts' multipliers.
pub fn on_contacts(
    program: &Program,
    lifted: &Lifted,
    contacts: &[Row],
    stiff: &[(Row, f64)],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let stiff_rows = stiff.iter().map(|s| &s.0);
    let rows: Vec<Row> = contacts.iter().chain(stiff_rows).cloned().collect();
    let scaled = Scaled::of_many_spans(program, lifted, &rows, 0.0, &mut None)?;
    let objective = program.objective_unit();
    let system = &scaled.system;
    let Matrix::Chained(base, windowed) = &system.matrix else {
        return None;
    };
    let chain = &base.chain;
    let mut weights = Vec::with_capacity(rows.len());
    let mut pushes = Vec::with_capacity(rows.len());
    for &(index, unit) in &scaled.kept {
        let stiffness = index.checked_sub(contacts.len());
        weights.push(stiffness.map_or(PENALTY, |i| stiff[i].1 * unit * unit / objective));
        pushes.push(stiffness.map_or(rows[index].multiplier * unit / objective, |_| 0.0));
    }
    let factor = chain.factor(windowed, &weights, &system.demands, &[])?;
    let n = system.gradient.len();
    let (mut u, mut nu) = (vec![0.0; n], vec![0.0; system.demands.len()]);
    for _ in 0..PASSES {
        let hu = chain.times(&u);
        let mut off: Vec<f64> = (hu.iter().zip(&system.gradient))
            .map(|(h, q)| -(h + q))
            .collect();
        let values = windowed.values(&chain.layout, &u);
        let over = values.iter().zip(&system.bounds).zip(&weights).zip(&pushes);
        let pulls: Vec<f64> = over.map(|(((v, b), w), z)| -(z + w * (v - b))).collect();
        windowed.add_to(&chain.layout, &pulls, &mut off);
        let mut missed = Vec::with_capacity(nu.len());
        for (demand, nu) in system.demands.iter().zip(&nu) {
            demand.add_to(&mut off, -nu);
            missed.push(demand.bound - demand.of(&u));
        }
        let more = factor.solve(chain, &mut off, &missed);
        u.iter_mut().zip(&off).for_each(|(u, d)| *u += d);
        nu.iter_mut().zip(&more).for_each(|(nu, d)| *nu += d);
        let values = windowed.values(&chain.layout, &u);
        for (row, &(index, _)) in scaled.kept.iter().enumerate() {
            if index < contacts.len() {
                pushes[row] += PENALTY * (values[row] - system.bounds[row]);
            }
        }
    }
    let mut multipliers = vec![0.0; contacts.len()];
    for (&(index, unit), push) in scaled.kept.iter().zip(&pushes) {
        if let Some(own) = multipliers.get_mut(index) {
            *own = push * objective / unit;
        }
    }
    Some((scaled.law(program, &u), multipliers))
}
