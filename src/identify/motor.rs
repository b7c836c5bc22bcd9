//! Slope of the motor line and inertia of the shaft, from the energy balance of the cycle, for logs with measured speed.
//!
//! The balance is T = J α + F v, plus friction. T is the torque at the camshaft, J the inertia, α the angular acceleration, F the force and
//! v the velocity ds/dθ. If the log contains the torque, the balance gives J and the mean friction. Otherwise the line T = T₀ − d ω of the
//! motor in the scene replaces the torque. The balance is then −F v = J α + d (ω − ω̄) − T̄, with the mean speed ω̄ and the mean torque T̄.

use super::cycles::derivative;
use super::fit::fit;
use super::fitted::Fitted;
use super::least_squares::Column;
use super::model::{ANGLES, angle};
use super::parameter::Parameter;
use crate::synth::Design;

/// Inertia, and slope of the motor line or friction torque, if the logs determine them. With several logs, the estimate with the narrowest interval
/// is used for each parameter.
pub(super) fn parameters(design: &Design, fitted: &Fitted) -> Vec<Parameter> {
    let mut narrowest: Vec<Parameter> = Vec::new();
    for next in (0..fitted.runs.len()).flat_map(|run| of_run(design, fitted, run)) {
        let width = |p: &Parameter| p.high.zip(p.low).map_or(f64::INFINITY, |(h, l)| h - l);
        match narrowest.iter_mut().find(|p| p.key == next.key) {
            Some(known) if width(&next) < width(known) => *known = next,
            Some(_) => {}
            None => narrowest.push(next),
        }
    }
    narrowest
}

fn of_run(design: &Design, fitted: &Fitted, place: usize) -> Vec<Parameter> {
    let run = &fitted.runs[place];
    let Some(shaft) = run.cycles.shaft.as_ref().filter(|_| run.cycles.by_angle) else {
        return Vec::new();
    };
    let torque = run.cycles.torque.as_ref();
    if torque.is_none() && !design.problem.machine.motor.is_given() {
        return Vec::new();
    }
    let count = shaft.mean.len();
    let clock = &run.clock;
    let law = design.pressing();
    let speed = |i: usize| clock.speed[i];
    let columns = |effect: &dyn Fn(usize) -> f64, is_positive| Column {
        values: clock.harmonics(&(0..ANGLES).map(effect).collect::<Vec<_>>(), count),
        is_positive,
    };
    let slope = clock.at_angles(&derivative(&shaft.mean));
    let inertia = columns(&|i| speed(i) * slope[i], true);
    let constant = columns(&|_| 1.0, torque.is_some());
    let line = columns(&|i| speed(i) - run.cycles.speed, true);
    // Column for the zero offset of the load cell. Without it, the other columns would represent this offset.
    let bias = columns(&|i| law.svaj(angle(i)).v, false);
    // Torque F·v that the force requires at the camshaft, for every cycle.
    let load = |force: &[f64]| {
        let force = clock.at_angles(force);
        let power: Vec<f64> = (0..ANGLES)
            .map(|i| force[i] * law.svaj(angle(i)).v)
            .collect();
        clock.harmonics(&power, count)
    };
    let mut left = fitted.fit.measured[place].map(load);
    for (i, cycle) in left.each.iter_mut().enumerate() {
        for (j, x) in cycle.iter_mut().enumerate() {
            *x = torque.map_or(0.0, |t| t.each[i][j]) - *x;
        }
    }
    let left = left.map(<[f64]>::to_vec);
    let (columns, keys) = match torque {
        Some(_) => (
            vec![inertia, constant, bias],
            ["machine.inertia", "machine.friction_torque"],
        ),
        None => (
            vec![inertia, line, constant, bias],
            ["machine.inertia", "machine.motor.slope"],
        ),
    };
    let found = fit(&columns, &[left], &[], &[]);
    let each = keys.into_iter().zip(found.each);
    each.map(|(key, found)| Parameter::of(key, found, true))
        .collect()
}
