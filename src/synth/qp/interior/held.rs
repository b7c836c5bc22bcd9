//! The optimum of a law of many spans on given contacts, and how far a gradient says it is off, by one factor each.
//!
//! Contacts are held on their bounds by a penalty and multipliers that take up what it leaves (Bertsekas, Constrained
//! Optimization and Lagrange Multiplier Methods, ch. 2): rows that depend on each other, as those on an arc do, are held
//! as one, and cost stays in proportion to the spans.

use super::MOST_DEMANDS;
use super::chain::{Chain, Layout, Windowed};
use super::scaled::Scaled;
use super::system::{Line, Matrix};
use crate::synth::qp::lifted::Lifted;
use crate::synth::qp::program::{Equality, Program, Row};

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

/// ½rᵀH⁻¹r: what an objective whose gradient by the lift's coefficients is r can still fall while the demands hold and an
/// open level stays. `None` where the demands leave a change of the law that the objective does not see.
pub fn fall(program: &Program, lifted: &Lifted, gradient: &[f64]) -> Option<f64> {
    if program.equalities.len() > MOST_DEMANDS {
        return None;
    }
    let chain = Chain::new(Layout::new(lifted, lifted.used()), lifted, 1.0, 0);
    let layout = &chain.layout;
    let kept = |e: &Equality| Line::new(layout.of_lift(&e.entries), 0.0);
    let mut demands: Vec<Line> = program.equalities.iter().map(kept).collect();
    if program.level_is_open() {
        demands.push(Line::new(vec![(layout.own(0, 0), 1.0)], 0.0));
    }
    demands.extend(layout.closing());
    let factor = chain.factor(&Windowed::new(layout, &[]), &[], &demands, &[])?;
    let mut step = vec![0.0; layout.unknowns()];
    for (i, &g) in gradient.iter().enumerate() {
        step[layout.own(0, i)] = g;
    }
    factor.solve(&chain, &mut step, &vec![0.0; demands.len()]);
    let own = gradient.iter().enumerate();
    let fallen: f64 = own.map(|(i, g)| 0.5 * g * step[layout.own(0, i)]).sum();
    (fallen >= 0.0).then_some(fallen)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::SplineSpace;
    use crate::synth::qp::basis::Basis;
    use crate::synth::qp::objective::{Quadratic, pointwise};
    use std::f64::consts::TAU;

    /// An objective ½ mean(s″²) whose gradient is H d falls by ½ mean(d″²) = ½·81/2 for d = sin 3θ, also where the lift's
    /// own matrix has no digits left.
    #[test]
    fn a_gradient_says_how_far_an_objective_falls() {
        for spans in [100, 1000, 10_000] {
            let basis = Basis::Spline {
                space: SplineSpace::periodic_uniform(5, spans, TAU),
                closed: true,
            };
            let mut energy = Quadratic::zero(&basis);
            energy.add_distance(&basis, &[0.0, 0.0, 1.0], 7, pointwise(|_| 0.0), None);
            let program = Program::new(basis, energy, Vec::new(), 1.0);
            let lifted = program.lifted.as_ref().unwrap();
            let width = TAU / spans as f64;
            let wave: Vec<f64> = (0..spans).map(|i| (3.0 * i as f64 * width).sin()).collect();
            let gradient = lifted.folded(lifted.pull(&lifted.derivatives(&wave)));
            // A quintic B-spline is the sixth convolution of the box: sin 3θ comes back smaller by (sin x/x)⁶, x = 3h/2.
            let x = 1.5 * width;
            let expected = 0.25 * 81.0 * (x.sin() / x).powi(12);
            let found = fall(&program, lifted, &gradient).unwrap();
            assert!(
                (found / expected - 1.0).abs() < (x * x).powi(3) + 1e-9,
                "{spans}: {found} {expected}"
            );
        }
    }
}
