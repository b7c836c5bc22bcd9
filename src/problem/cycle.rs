//! One cycle of the force, scaled to the machine, and how the cam's turn meets it.

use std::sync::Arc;

use super::Target;
use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::scene::Band;

/// One cycle of the force with its band, both at phase 0.
#[derive(Debug)]
pub struct Cycle {
    force: Arc<ForceCurve>,
    /// Lowest and highest force allowed.
    band: Option<[ForceCurve; 2]>,
}

impl Cycle {
    /// The cycle with a band about it.
    ///
    /// # Errors
    /// A band of one spread about a force that carries none.
    pub fn new(force: ForceCurve, band: Option<Band>) -> Result<Cycle> {
        let band = band.map(|band| band_about(&force, band)).transpose()?;
        let force = Arc::new(force);
        Ok(Cycle { force, band })
    }

    /// Target and band where the cam's turn begins at a phase of the cycle.
    pub fn at_phase(&self, phase: f64) -> (Option<Target>, Option<[ForceCurve; 2]>) {
        if phase == 0.0 {
            return (Some(Target::new(self.force.clone())), self.band.clone());
        }
        let begun = |curve: &ForceCurve| begun_at(curve, phase);
        let band = self.band.as_ref().map(|edges| edges.each_ref().map(begun));
        (Some(Target::new(begun(&self.force))), band)
    }
}

/// A cycle begun at a phase; samples taken elsewhere keep the mean force, which belongs to the whole cycle.
pub(super) fn begun_at(curve: &ForceCurve, phase: f64) -> ForceCurve {
    let begun = curve.begun_at(phase);
    let shift = curve.mean_n() - begun.mean_n();
    ForceCurve {
        force_n: begun.force_n.iter().map(|f| f + shift).collect(),
        ..begun
    }
}

/// Lowest and highest force of a band about a force, as cycles like it.
fn band_about(target: &ForceCurve, band: Band) -> Result<[ForceCurve; 2]> {
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
