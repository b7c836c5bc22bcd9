//! Report on a design for several walkers, from their force errors.

use super::errors::{dot, measure, tail};
use crate::problem::Walkers;
use crate::scene::{ErrorMeasure, Robust};
use crate::synth::report::walkers::{OfPopulation, WalkerError};

/// Default fraction of the walkers that are not included in the mean of the largest errors.
const USUAL_TAIL: f64 = 0.9;

/// Report for the given mean square error and phase, rad, of each cycle.
pub fn report(walkers: &Walkers, squares: &[f64], phases: &[f64]) -> OfPopulation {
    let each = walkers.each.iter().zip(squares).zip(phases);
    let each = each.map(|((walker, square), phase)| {
        let error = walker.unit * square.sqrt();
        WalkerError {
            walker: walker.name.clone(),
            mass_kg: walker.drive.mass,
            speed_rad_per_s: walker.drive.speed,
            phase_rad: phase.rem_euclid(std::f64::consts::TAU),
            rms_error_percent: 100.0 * error / walker.target.mean_n().abs(),
            rms_error_n: error,
            share: walker.share,
            speed_m_per_s: walker.speed_m_per_s,
        }
    });
    let each: Vec<WalkerError> = each.collect();
    let shares: Vec<f64> = each.iter().map(|e| e.share).collect();
    let part = match walkers.robust {
        Robust::Tail(part) => part,
        Robust::Mean | Robust::Worst => USUAL_TAIL,
    };
    let [percent, newtons] = [ErrorMeasure::Relative, ErrorMeasure::Absolute].map(|measure| {
        let errors: Vec<f64> = each.iter().map(|e| e.measured(measure)).collect();
        let worst = errors.iter().fold(0.0_f64, |m, e| m.max(*e));
        [worst, dot(&errors, &shares), tail(part, &errors, &shares)]
    });
    let worst = (0..squares.len()).max_by(|i, j| squares[*i].total_cmp(&squares[*j]));
    let worst = worst.unwrap_or_default();
    OfPopulation {
        walkers: walkers.count,
        cycles: each.len(),
        robust: walkers.robust.to_string(),
        error: walkers.error.name(),
        objective_percent: 100.0 * measure(walkers.robust, squares, &shares).sqrt(),
        worst_percent: percent[0],
        mean_percent: percent[1],
        cvar_percent: percent[2],
        worst_n: newtons[0],
        mean_n: newtons[1],
        cvar_n: newtons[2],
        worst_walker: each[worst].walker.clone(),
        gap: 0.0,
        bound_percent: None,
        rounds: 0,
        worst,
        each,
    }
}
