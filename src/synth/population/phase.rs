//! Adjustable phases of the walkers' cycles. The problem is not convex, so laws and phases are optimised alternately.
//!
//! For a lower bound, every harmonic of every walker may have its own phase. Then only amplitudes matter: |γ Ψₙ − Yₙ| ≥ |γ |Ψₙ| − |Yₙ||. Ψₙ
//! is harmonic n of the force, Yₙ harmonic n of the walker's scaled target, and γ the factor of the walker. The bound is the optimum of a
//! problem with equal phases and without limits.

use std::f64::consts::TAU;

use super::errors::{Aim, norm};
use super::weights::Weights;
use crate::drive::Drive;
use crate::law::Law;
use crate::poly::amplitudes;
use crate::problem::{Served, Walkers};

/// Number of equally spaced angles at which the force of a law is evaluated.
const SAMPLES: usize = 1024;
/// Number of harmonics from which the phase of a walker is determined.
const HARMONICS: usize = 100;
/// Number of trial phases on an equally spaced grid over the turn.
const TRIED: usize = 720;
const STEPS: usize = 6;
/// Maximum number of iterations for the lower bound.
const ROUNDS: usize = 60;

/// Cosine and sine amplitudes of the harmonics 1, 2, … of equally spaced samples.
fn waves(samples: &[f64]) -> Vec<(f64, f64)> {
    amplitudes(samples)
        .into_iter()
        .skip(1)
        .take(HARMONICS)
        .collect()
}

/// Cosine and sine amplitudes of the force of a law, N.
pub fn of_law(drive: &Drive, law: &Law) -> Vec<(f64, f64)> {
    let at = (0..SAMPLES).map(|i| TAU * i as f64 / SAMPLES as f64);
    waves(&at.map(|x| drive.force(law.svaj(x))).collect::<Vec<_>>())
}

/// Delay of a walker's cycle, rad, for which the cycle fits the force best. `force` contains cosine and sine amplitudes of the force from
/// the first harmonic on.
pub fn best(force: &[(f64, f64)], walker: &Served) -> f64 {
    let own = waves(&walker.target.force_n);
    let terms: Vec<[f64; 3]> = (1..)
        .zip(force.iter().zip(&own))
        .map(|(n, ((a, b), (c, d)))| [f64::from(n), a * c + b * d, a * d - b * c])
        .collect();
    let correlation = |phase: f64| -> f64 {
        let term = |[n, c, s]: &[f64; 3]| c * libm::cos(n * phase) + s * libm::sin(n * phase);
        terms.iter().map(term).sum()
    };
    let places = (0..TRIED).map(|i| TAU * i as f64 / TRIED as f64);
    let mut phase = places.fold((0.0, f64::NEG_INFINITY), |best, x| {
        let value = correlation(x);
        if value > best.1 { (x, value) } else { best }
    });
    for _ in 0..STEPS {
        let mut slope = [0.0; 2];
        for [n, c, s] in &terms {
            let (sin, cos) = libm::sincos(n * phase.0);
            slope[0] += n * (s * cos - c * sin);
            slope[1] -= n * n * (c * cos + s * sin);
        }
        let next = phase.0 - slope[0] / slope[1].min(-f64::MIN_POSITIVE);
        let value = correlation(next);
        if value <= phase.1 {
            break;
        }
        phase = (next, value);
    }
    phase.0
}

/// Targets that do not depend on the phase: the amplitudes of each walker's harmonics, divided by the unit of this walker.
pub fn amplitudes_of(walkers: &Walkers) -> Vec<Aim> {
    let aim = |walker: &Served| {
        let own = waves(&walker.target.force_n);
        let part = walker.unit * 2.0_f64.sqrt();
        Aim {
            scale: walker.factor / walker.unit,
            towards: own
                .iter()
                .map(|(a, b)| libm::hypot(*a, *b) / part)
                .collect(),
            left: 0.0,
        }
    };
    walkers.each.iter().map(aim).collect()
}

/// Lower bound of the objective over all phases and laws, as a mean square.
pub fn bound(walkers: &Walkers) -> f64 {
    let aims = amplitudes_of(walkers);
    let shares: Vec<f64> = walkers.each.iter().map(|w| w.share).collect();
    let mut weights = Weights::new(walkers.robust, &shares, &aims);
    let mut next = Some(shares.clone());
    for _ in 0..ROUNDS {
        let Some(own) = next.take() else { break };
        let mut force = vec![0.0; aims[0].towards.len()];
        let mut whole = 0.0;
        for (aim, weight) in aims.iter().zip(&own) {
            whole += weight * aim.scale * aim.scale;
            let part = weight * aim.scale;
            force
                .iter_mut()
                .zip(&aim.towards)
                .for_each(|(f, y)| *f += part * y);
        }
        force.iter_mut().for_each(|f| *f /= whole);
        debug_assert!(norm(&force).is_finite());
        weights.take(&own, force, 0.0);
        if !weights.is_proved() {
            next = weights.next(true);
        }
    }
    weights.lower
}
