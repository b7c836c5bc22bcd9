//! The optimum of a law of many spans on given contacts: its rows as demands, one factor and one correction.

use super::chain::Chain;
use super::scaled::Scaled;
use super::system::{Line, Matrix};
use crate::synth::qp::lifted::Lifted;
use crate::synth::qp::program::{Program, Row};

/// Minimises the program's objective and Σ ½ weight (row·x − bound)² of the stiff rows with every contact on its bound.
/// Returns coefficients and the contacts' multipliers.
pub fn on_contacts(
    program: &Program,
    lifted: &Lifted,
    contacts: &[Row],
    stiff: &[(Row, f64)],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let rows: Vec<Row> = contacts
        .iter()
        .chain(stiff.iter().map(|s| &s.0))
        .cloned()
        .collect();
    let mut scaled = Scaled::of_many_spans(program, lifted, &rows, 0.0)?;
    let objective = program.objective_unit();
    let system = &mut scaled.system;
    let Matrix::Chained(chain, windowed) = &system.matrix else {
        return None;
    };
    let before = system.demands.len();
    let mut weights = vec![0.0; system.bounds.len()];
    let mut held = Vec::with_capacity(contacts.len());
    for (row, &(index, unit)) in scaled.kept.iter().enumerate() {
        if let Some(own) = index.checked_sub(contacts.len()) {
            weights[row] = stiff[own].1 * unit * unit / objective;
        } else {
            held.push((index, unit));
            let entries = windowed.entries(&chain.layout, row);
            system.demands.push(Line::new(entries, system.bounds[row]));
        }
    }
    let factor = chain.factor(windowed, &weights, &system.demands, &[])?;
    let n = system.gradient.len();
    let (mut u, mut nu) = (vec![0.0; n], vec![0.0; system.demands.len()]);
    // Twice: what the first pass leaves to rounding.
    for _ in 0..2 {
        let mut off = left(chain, &system.gradient, &u);
        let mut pulls = windowed.values(&chain.layout, &u);
        for ((pull, weight), bound) in pulls.iter_mut().zip(&weights).zip(&system.bounds) {
            *pull = weight * (bound - *pull);
        }
        windowed.add_to(&chain.layout, &pulls, &mut off);
        let mut missed = Vec::with_capacity(nu.len());
        for (demand, nu) in system.demands.iter().zip(&nu) {
            demand.add_to(&mut off, -nu);
            missed.push(demand.bound - demand.of(&u));
        }
        let more = factor.solve(chain, &mut off, &missed);
        u.iter_mut().zip(&off).for_each(|(u, d)| *u += d);
        nu.iter_mut().zip(&more).for_each(|(nu, d)| *nu += d);
    }
    let mut pushes = vec![0.0; contacts.len()];
    for (&(index, unit), nu) in held.iter().zip(&nu[before..]) {
        pushes[index] = nu * objective / unit;
    }
    Some((scaled.law(program, &u), pushes))
}

/// −(H u + q).
fn left(chain: &Chain, gradient: &[f64], u: &[f64]) -> Vec<f64> {
    let hu = chain.times(u);
    hu.iter().zip(gradient).map(|(h, q)| -(h + q)).collect()
}
