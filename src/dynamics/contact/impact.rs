//! Impacts of a rigid mass. The separation speed is the approach speed multiplied by the coefficient of restitution.

use crate::error::{DynamicsError, Result};

/// Result of an instantaneous impact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pulse {
    /// Separation speed, m/s; 0 if the surfaces stay together.
    pub rebound: f64,
    /// Impulse of the impact, N·s.
    pub impulse: f64,
}

impl Pulse {
    /// Impact of `mass` kg at `speed` m/s ≥ 0 with the coefficient of restitution `e`.
    pub fn new(mass: f64, speed: f64, e: f64) -> Pulse {
        Pulse {
            rebound: e * speed,
            impulse: mass * (1.0 + e) * speed,
        }
    }
}

/// Checks that a coefficient of restitution is in [0, 1].
///
/// # Errors
///
/// The coefficient is outside [0, 1].
pub fn check_restitution(e: f64) -> Result<()> {
    if (0.0..=1.0).contains(&e) {
        return Ok(());
    }
    Err(DynamicsError::Restitution { restitution: e }.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn momentum_before_and_after_differs_by_the_impulse() {
        let pulse = Pulse::new(2.0, 0.5, 0.3);
        assert!((pulse.rebound - 0.15).abs() < 1e-16);
        assert!((pulse.impulse - 2.0 * (0.5 + 0.15)).abs() < 1e-15);
    }

    #[test]
    fn restitution_outside_its_range_is_refused() {
        assert!(check_restitution(1.2).is_err() && check_restitution(f64::NAN).is_err());
        assert!(check_restitution(-0.1).is_err() && check_restitution(1.0).is_ok());
    }
}
