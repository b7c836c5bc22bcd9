//! Free flight of the moved mass: m ÿ + c ẏ + k y + F₀ = 0 in closed form over the cam angle.
//!
//! Division by mω² gives y″ + γ y′ + κ y + f = 0, with γ = c/(mω), κ = k/(mω²) and f = F₀/(mω²). The initial values are y₀, y₀′ and y₀″. S
//! is the response to a unit initial velocity, and I = ∫S. The solution y = y₀ + y₀′(S + γI) + y₀″ I has no cancellation for a small
//! stiffness or damping. Without spring and damper, the flight is a parabola.

/// Value of (γ + √κ)·(angle since the start) below which S and I are computed by series.
const SERIES_PHASE: f64 = 0.5;
/// Number of terms of the series: 0.5²⁴/24! is far below rounding errors.
const SERIES_TERMS: usize = 24;

/// Free flight as a function of the angle since its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// Start angle of the flight, rad.
    pub start: f64,
    /// Height at the start, m.
    pub y: f64,
    /// Slope dy/dθ at the start, m/rad.
    pub rate: f64,
    /// Curvature d²y/dθ² at the start, m/rad².
    pub curvature: f64,
    /// Stiffness k/(mω²), per rad².
    pub kappa: f64,
    /// Damping c/(mω), per rad.
    pub gamma: f64,
}

impl Flight {
    /// Height and slope at an angle not before the start, m and m/rad.
    pub fn at(&self, theta: f64) -> (f64, f64) {
        let t = theta - self.start;
        let (s, slope, area) = self.fundamental(t);
        let c = slope + self.gamma * s;
        (
            self.y + self.rate * (s + self.gamma * area) + self.curvature * area,
            self.rate * c + self.curvature * s,
        )
    }

    /// Upper bound of −y″ at all later angles, m/rad².
    pub fn steepest_fall(&self) -> f64 {
        if self.kappa == 0.0 {
            // y″ decays from its initial value, so this value determines the bound.
            return (-self.curvature).max(0.0);
        }
        // y″ satisfies the same homogeneous equation, so (y″)² + (y‴)²/κ does not increase.
        let third = -self.gamma * self.curvature - self.kappa * self.rate;
        libm::hypot(self.curvature, third / self.kappa.sqrt())
    }

    /// S, S′ and ∫S at the angle `t` since the start, rad. S solves y″ + γ y′ + κ y = 0 with S(0) = 0 and S′(0) = 1. ∫S is the integral of
    /// S from 0.
    fn fundamental(&self, t: f64) -> (f64, f64, f64) {
        if self.gamma == 0.0 && self.kappa == 0.0 {
            return (t, 1.0, 0.5 * t * t);
        }
        if (self.gamma + self.kappa.sqrt()) * t < SERIES_PHASE {
            return self.series(t);
        }
        let half = 0.5 * self.gamma;
        let discriminant = half * half - self.kappa;
        let spread = discriminant.abs().sqrt();
        let (s, slope) = if spread * t < 1e-4 {
            let decay = libm::exp(-half * t);
            let q = discriminant * t * t;
            (
                decay * t * (1.0 + q / 6.0),
                decay * (1.0 + q / 2.0 - half * t * (1.0 + q / 6.0)),
            )
        } else if discriminant < 0.0 {
            let decay = libm::exp(-half * t);
            let (sin, cos) = libm::sincos(spread * t);
            (decay * sin / spread, decay * (cos - half * sin / spread))
        } else {
            let fast = -half - spread;
            let slow = self.kappa / fast;
            let (e1, e2) = (libm::exp(slow * t), libm::exp(fast * t));
            (
                (e1 - e2) / (2.0 * spread),
                (slow * e1 - fast * e2) / (2.0 * spread),
            )
        };
        let area = if self.kappa > 0.0 {
            (1.0 - slope - self.gamma * s) / self.kappa
        } else {
            (t - s) / self.gamma
        };
        (s, slope, area)
    }

    fn series(&self, t: f64) -> (f64, f64, f64) {
        // S = Σ aₖ tᵏ with a₁ = 1, (k + 2)(k + 1) aₖ₊₂ = −γ(k + 1) aₖ₊₁ − κ aₖ.
        let (mut before, mut term) = (0.0, t);
        let (mut s, mut slope, mut area) = (0.0, 0.0, 0.0);
        for k in 1..SERIES_TERMS {
            let order = k as f64;
            s += term;
            slope += order * term / t.max(f64::MIN_POSITIVE);
            area += term * t / (order + 1.0);
            let next = -(self.gamma * t * order * term + self.kappa * t * t * before)
                / ((order + 1.0) * order);
            (before, term) = (term, next);
        }
        if t == 0.0 {
            (0.0, 1.0, 0.0)
        } else {
            (s, slope, area)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flight(kappa: f64, gamma: f64) -> Flight {
        Flight {
            start: 0.5,
            y: 0.02,
            rate: 0.013,
            curvature: -0.008,
            kappa,
            gamma,
        }
    }

    #[test]
    fn every_regime_obeys_its_equation() {
        for (kappa, gamma) in [
            (0.0, 0.0),
            (0.0, 3.0),
            (4.0, 0.0),
            (4.0, 0.3),
            (4.0, 4.0),
            (4.0, 9.0),
            (1e-9, 0.0),
            (900.0, 1.0),
        ] {
            let f = flight(kappa, gamma);
            // Central differences of y′ check the equation of motion y″ + γ y′ + κ(y − y₀) = y₀″ + γ y₀′.
            let h = 1e-4;
            for i in 1..40 {
                let t = 0.5 + 0.07 * f64::from(i);
                let (y, rate) = f.at(t);
                let second = (f.at(t + h).1 - f.at(t - h).1) / (2.0 * h);
                let left = second + gamma * rate + kappa * (y - f.y);
                let right = f.curvature + gamma * f.rate;
                assert!(
                    (left - right).abs() < 1e-6 * (1.0 + kappa),
                    "{kappa} {gamma} {t}"
                );
                let slope = (f.at(t + h).0 - f.at(t - h).0) / (2.0 * h);
                assert!(
                    (slope - rate).abs() < 1e-7 * (1.0 + kappa),
                    "{kappa} {gamma} {t}"
                );
                assert!(second >= -f.steepest_fall() * (1.0 + 1e-6) - 1e-9);
            }
        }
    }

    #[test]
    fn series_and_closed_form_meet() {
        for (kappa, gamma) in [(4.0, 0.0), (4.0, 0.3), (4.0, 9.0), (0.0, 3.0)] {
            let f = flight(kappa, gamma);
            let t = SERIES_PHASE / (gamma + kappa.sqrt());
            let (a, b) = (
                f.fundamental(t * (1.0 - 1e-12)),
                f.fundamental(t * (1.0 + 1e-12)),
            );
            assert!(
                (a.0 - b.0).abs() < 1e-11 && (a.1 - b.1).abs() < 1e-11 && (a.2 - b.2).abs() < 1e-11
            );
        }
    }
}
