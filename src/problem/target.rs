//! The wanted force in step with the cam, and the band about it.

use std::f64::consts::TAU;

use crate::error::{Result, SynthError};
use crate::force::ForceCurve;
use crate::scene::{Band, PhaseWeight};

/// One turn of wanted force, as the fits read it thousands of times.
#[derive(Debug, Clone)]
pub struct Target {
    /// The cycle, beginning at cam angle 0.
    pub curve: ForceCurve,
    /// Its cubics between the samples, N.
    cubics: Vec<[f64; 4]>,
}

impl Target {
    /// The cycle with its cubics.
    pub fn new(curve: ForceCurve) -> Self {
        Target {
            cubics: curve.cubics(),
            curve,
        }
    }

    /// Mean force, N.
    pub fn mean_n(&self) -> f64 {
        self.curve.mean_n()
    }

    /// Force at an angle of the first turn, N.
    pub fn at(&self, theta: f64) -> f64 {
        let mut out = [0.0];
        self.on(theta, 0.0, &[(0.0, 0.0)], &mut out);
        out[0]
    }

    /// The same at places u ∈ [0, 1] of a range of the first turn, given with their weights.
    pub fn on(&self, start: f64, width: f64, places: &[(f64, f64)], out: &mut [f64]) {
        let n = self.cubics.len();
        let per_angle = n as f64 / TAU;
        let (first, step) = (start * per_angle, width * per_angle);
        for (f, (place, _)) in out.iter_mut().zip(places) {
            let x = first + place * step;
            let i = (x as u32 as usize).min(n - 1);
            let u = x - i as f64;
            let [a, b, c, d] = self.cubics[i];
            let v = 1.0 - u;
            *f = v * v * (v * a + 3.0 * u * b) + u * u * (3.0 * v * c + u * d);
        }
    }
}

/// Weight of the force error at a phase of the cycle; where ranges overlap the last one counts.
pub fn weight_at(weights: &[PhaseWeight], phase: f64) -> f64 {
    let at = phase.rem_euclid(TAU);
    let inside = |w: &&PhaseWeight| {
        if w.from < w.to {
            at >= w.from && at < w.to
        } else {
            at >= w.from || at < w.to
        }
    };
    weights.iter().rev().find(inside).map_or(1.0, |w| w.weight)
}

/// Lowest and highest force of a band about the target, as cycles like it.
///
/// # Errors
/// A band of one spread about a target that carries none.
pub fn band_about(target: &ForceCurve, band: Band) -> Result<[ForceCurve; 2]> {
    let half: Vec<f64> = match (band, &target.spread_n) {
        (Band::Width(width), _) => vec![width; target.force_n.len()],
        (Band::Spread, Some(spread)) => spread.clone(),
        (Band::Spread, None) => {
            return Err(SynthError::NoSpread.at_key("gait.band"));
        }
    };
    let edge = |sign: f64| {
        let forces = target.force_n.iter().zip(&half);
        target.with_forces(forces.map(|(f, h)| f + sign * h).collect())
    };
    Ok([edge(-1.0), edge(1.0)])
}
