//! One cycle of wanted vertical force.

use std::f64::consts::TAU;

use crate::error::{Error, Result};
use crate::poly::{PiecewisePoly, bernstein};

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

impl ForceCurve {
    /// Force at cam angle `theta`, rad, any turn: cubic interpolation without overshoot, N.
    pub fn at(&self, theta: f64) -> f64 {
        let n = self.force_n.len();
        let x = (theta / TAU).rem_euclid(1.0) * n as f64;
        let i = (x as usize).min(n - 1);
        let u = x - i as f64;
        bernstein::eval(&self.cubic(i), u)
    }

    /// The whole cycle as a piecewise cubic over θ ∈ [0, 2π], N.
    pub fn curve(&self) -> PiecewisePoly {
        let n = self.force_n.len();
        // TAU·n/n need not be TAU: the last break is set, not computed.
        let breaks = (0..n)
            .map(|i| TAU * i as f64 / n as f64)
            .chain([TAU])
            .collect();
        let coef = self.cubics().into_iter().flatten().collect();
        PiecewisePoly::new(breaks, 3, coef)
    }

    /// Bernstein coefficients of the cubic between each sample and the next, N.
    pub fn cubics(&self) -> Vec<[f64; 4]> {
        let f = &self.force_n;
        let n = f.len();
        // Two samples before the first and three after the last, so that nothing wraps in the loops.
        let around: Vec<f64> = f.iter().cycle().skip(n - 2).take(n + 5).copied().collect();
        let slopes: Vec<f64> = (around.windows(5))
            .map(|w| slope([w[0], w[1], w[2], w[3], w[4]]))
            .collect();
        (around[2..].windows(2).zip(slopes.windows(2)))
            .map(|(f, s)| [f[0], f[0] + s[0] / 3.0, f[1] - s[1] / 3.0, f[1]])
            .collect()
    }

    /// The curve with every force multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let times = |x: &Vec<f64>| x.iter().map(|f| f * factor).collect();
        ForceCurve {
            force_n: times(&self.force_n),
            spread_n: self.spread_n.as_ref().map(times),
            ..self.clone()
        }
    }

    /// The same cycle begun at another phase, rad: sample 0 of the new curve is the old one at `phase`.
    #[must_use]
    pub fn begun_at(&self, phase: f64) -> Self {
        let n = self.force_n.len();
        let moved = |curve: &Self| {
            (0..n)
                .map(|i| curve.at(phase + TAU * i as f64 / n as f64))
                .collect()
        };
        let spread_n = self
            .spread_n
            .as_ref()
            .map(|s| moved(&self.with_forces(s.clone())));
        ForceCurve {
            force_n: moved(self),
            spread_n,
            ..self.clone()
        }
    }

    /// The same cycle with other forces, N, one for each sample.
    #[must_use]
    pub fn with_forces(&self, force_n: Vec<f64>) -> Self {
        ForceCurve {
            force_n,
            spread_n: None,
            ..self.clone()
        }
    }

    /// Bernstein coefficients of the cubic between samples i and i + 1.
    fn cubic(&self, i: usize) -> [f64; 4] {
        let n = self.force_n.len();
        let (f0, f1) = (self.force_n[i], self.force_n[(i + 1) % n]);
        [
            f0,
            f0 + self.slope(i) / 3.0,
            f1 - self.slope(i + 1) / 3.0,
            f1,
        ]
    }

    /// Slope per sample at sample `i`.
    fn slope(&self, i: usize) -> f64 {
        let n = self.force_n.len();
        slope([n - 2, n - 1, 0, 1, 2].map(|k| self.force_n[(i + k) % n]))
    }
}

/// Slope per sample at the middle of five samples: the fourth-order centred difference, held within three
/// times the smaller neighbouring step, so that a sharp heel strike is not overshot (Fritsch and Carlson's
/// bound). At a local extreme of the samples half that bound applies to either sign, so that a smooth peak
/// between two samples is not flattened.
fn slope(f: [f64; 5]) -> f64 {
    let (before, after) = (f[2] - f[1], f[3] - f[2]);
    let centred = (8.0 * (f[3] - f[1]) - (f[4] - f[0])) / 12.0;
    let smaller = before.abs().min(after.abs());
    let bound = if before * after > 0.0 {
        3.0 * smaller
    } else {
        1.5 * smaller
    };
    if before * after > 0.0 && centred * before < 0.0 {
        return 0.0;
    }
    centred.clamp(-bound, bound)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_curves_are_interpolated_to_third_order_or_better() {
        let f = |x: f64| 700.0 + 250.0 * x.sin() + 40.0 * (3.0 * x).cos();
        let worst = |n: usize| {
            let samples = (0..n).map(|i| f(TAU * i as f64 / n as f64)).collect();
            let curve = ForceCurve::from_samples("test", 0.5, samples).unwrap();
            (0..5000)
                .map(|i| TAU * f64::from(i) / 5000.0)
                .fold(0.0_f64, |m, x| m.max((curve.at(x) - f(x)).abs()))
        };
        let (coarse, fine) = (worst(128), worst(1024));
        assert!(fine < 2e-4 && fine < coarse / 60.0, "{coarse} {fine}");
    }

    #[test]
    fn a_cycle_begun_elsewhere_is_the_same_cycle() {
        let samples = (0..200)
            .map(|i| 700.0 + 250.0 * (TAU * f64::from(i) / 200.0).sin())
            .collect();
        let mut curve = ForceCurve::from_samples("test", 0.5, samples).unwrap();
        curve.spread_n = Some((0..200).map(f64::from).collect());
        // A quarter turn is fifty samples.
        let moved = curve.begun_at(TAU / 4.0);
        for i in 0..200 {
            assert!((moved.force_n[i] - curve.force_n[(i + 50) % 200]).abs() < 1e-9);
        }
        assert!((moved.spread_n.unwrap()[0] - 50.0).abs() < 1e-9);
        let there_and_back = curve.begun_at(0.3).begun_at(-0.3);
        for (a, b) in there_and_back.force_n.iter().zip(&curve.force_n) {
            // Third order at a crest: 2e-4 N at 1024 samples (above) are 0.027 N at 200.
            assert!((a - b).abs() < 0.03, "{a} {b}");
        }
    }

    #[test]
    fn a_step_is_not_overshot() {
        let samples = (0..40)
            .map(|i| if (10..30).contains(&i) { 800.0 } else { 0.0 })
            .collect();
        let curve = ForceCurve::from_samples("step", 1.0, samples).unwrap();
        let (low, high) = curve.curve().extremes();
        assert!(low.value >= 0.0 && high.value <= 800.0);
    }

    #[test]
    fn impossible_cycles_are_refused() {
        assert!(ForceCurve::from_samples("x", 1.0, vec![1.0]).is_err());
        assert!(ForceCurve::from_samples("x", 0.0, vec![1.0; 8]).is_err());
        assert!(ForceCurve::from_samples("x", 1.0, vec![1.0, f64::NAN, 1.0, 1.0]).is_err());
    }
}
