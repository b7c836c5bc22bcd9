//! One cycle of wanted vertical force.

use crate::error::{Error, Result};

/// One cycle of vertical force, sampled at equal steps of phase and continued periodically.
///
/// Sample `i` of `n` stands at cam angle θ = 2π·i/n (heel strike at 0) and time `period_s`·i/n.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceCurve {
    /// What the curve is, for reports: "Young 2001, 1.85 Hz" or "walk1.forces, 3 strides".
    pub name: String,
    /// Duration of one cycle, s; positive.
    pub period_s: f64,
    /// Force at equal steps of phase, N; at least 4 samples, all finite.
    pub force_n: Vec<f64>,
    /// Step-to-step standard deviation at the same phases, N, where several cycles were averaged.
    pub spread_n: Option<Vec<f64>>,
    /// Mass of the walker, kg, where it is known.
    pub mass_kg: Option<f64>,
}

impl ForceCurve {
    /// A curve from equal-phase samples of one cycle (the first sample is not repeated at the end).
    ///
    /// Fails on fewer than 4 samples, on a value that is not finite, on a period that is not positive.
    pub fn from_samples(name: &str, period_s: f64, force_n: Vec<f64>) -> Result<Self> {
        if force_n.len() < 4 {
            return Err(Error::new(format!(
                "a force cycle of {} samples says nothing about its shape",
                force_n.len()
            ))
            .help("give at least 4 samples per cycle"));
        }
        if let Some(i) = force_n.iter().position(|f| !f.is_finite()) {
            return Err(Error::new(format!("force sample {i} is {}", force_n[i]))
                .help("every sample must be a finite number of newtons"));
        }
        if !(period_s.is_finite() && period_s > 0.0) {
            return Err(Error::new(format!("a cycle cannot last {period_s} s"))
                .help("the period must be positive"));
        }
        Ok(ForceCurve {
            name: name.to_string(),
            period_s,
            force_n,
            spread_n: None,
            mass_kg: None,
        })
    }

    /// Mean force over the cycle, N.
    pub fn mean_n(&self) -> f64 {
        self.force_n.iter().sum::<f64>() / self.force_n.len() as f64
    }
}
