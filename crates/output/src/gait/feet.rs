//! Table of mean values over the stances of each foot, and of quantities that depend on both feet.

use gaitcam::force::{Cycle, Foot, Kind, Point, Stance, Stances};
use gaitcam::units::G;

use super::table::Lines;

/// Mean and sample standard deviation of `values`; `None` for fewer than two values.
fn spread(values: &[f64]) -> Option<(f64, f64)> {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
    (n > 1.0).then(|| (mean, (square / (n - 1.0)).sqrt()))
}

impl Lines {
    /// Writes the peaks, the valley and the stance duration of each foot as mean ± standard deviation. For walking with stances of both
    /// named feet, it also writes double support, cadence and symmetry index. The symmetry index of the impulses is 200 (right −
    /// left)/(right + left), %.
    pub(super) fn feet(&mut self, stances: &Stances, cycle: &Cycle) {
        let words = self.words;
        let (weight, period) = (cycle.mass_kg * G, cycle.curve.period_s);
        let of = |foot: Option<Foot>| -> Vec<&Stance> {
            let own = stances.used.iter().filter(|s| s.foot == foot && !s.unlike);
            own.filter(|s| s.mass_kg.is_none()).collect()
        };
        let feet = [Some(Foot::Left), Some(Foot::Right), None].map(|foot| (foot, of(foot)));
        if feet.iter().all(|(_, own)| own.len() < 2) {
            return;
        }
        self.line(format_args!("\n{}", words.text("gait-feet-columns")));
        for (foot, own) in feet.iter().filter(|(_, own)| own.len() > 1) {
            let mut row = format!("{:<9} {:>3}", self.foot(*foot), own.len());
            let force = |of: fn(&Stance) -> Option<Point>| -> Vec<f64> {
                let points = own.iter().filter_map(|s| of(s));
                points.map(|p| p.force_n / weight).collect()
            };
            for of in [
                Stance::first_peak,
                |s: &Stance| s.valley,
                Stance::second_peak,
            ] {
                let cell = spread(&force(of)).map_or("-".to_string(), |(mean, deviation)| {
                    format!("{} ± {}", words.fixed(mean, 3), words.fixed(deviation, 3))
                });
                row.push_str(&format!("  {cell:>13}"));
            }
            let shares = own.iter().map(|s| 100.0 * s.duration_s() / period);
            if let Some((mean, deviation)) = spread(&shares.collect::<Vec<f64>>()) {
                let [mean, deviation] = [mean, deviation].map(|x| words.fixed(x, 1));
                row.push_str(&format!("  {mean:>5} ± {deviation}"));
            }
            self.line(row);
        }
        let [(_, left), (_, right), _] = &feet;
        if left.is_empty() || right.is_empty() || cycle.kind != Kind::Walking {
            return;
        }
        let mean = |own: &[&Stance], of: fn(&Stance) -> f64| {
            own.iter().map(|s| of(s)).sum::<f64>() / own.len() as f64
        };
        let [l, r] = [left, right].map(|own| mean(own, |s| s.impulse_ns));
        let both: f64 = [left, right]
            .map(|own| mean(own, Stance::duration_s))
            .iter()
            .sum();
        let numbers = [
            ("gait-double-support", 100.0 * (both / period - 1.0), "%"),
            ("gait-cadence", 120.0 / period, "/min"),
            ("gait-symmetry", 200.0 * (r - l) / (r + l), "%"),
        ];
        for (key, value, unit) in numbers {
            self.row(key, format_args!("{} {unit}", words.fixed(value, 1)));
        }
    }
}
