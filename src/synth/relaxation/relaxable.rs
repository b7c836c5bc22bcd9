//! Relaxable values of a scene: step sizes, trial values and rounding. The key table states which keys are relaxable, and in which direction.

use crate::cam::Criterion;
use crate::problem::Problem;
use crate::scene::keys::{self, Key, Range, Relax};
use crate::synth::report::named::criterion_of;

/// Factor by which a limit is relaxed so that it has no effect.
const AWAY: f64 = 1e4;
/// Factor by which a size limit of the cam is relaxed so that it has no effect.
const FAR_LARGER: f64 = 30.0;
/// Pressure angle, rad, at which a limit has no effect.
const STEEPEST: f64 = 1.55;

/// A value of the scene that may be relaxed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxable {
    /// Entry of the key table to which the value belongs.
    pub key: &'static Key,
    relax: Relax,
    criterion: Criterion,
}

/// Relaxable values of a problem, each with its present value, in the order of the report.
pub fn relaxables(problem: &Problem) -> Vec<(Relaxable, f64)> {
    let of = |key: &'static Key| {
        let relax = key.relax?;
        let criterion = criterion_of(key)?;
        let knob = Relaxable {
            key,
            relax,
            criterion,
        };
        // The default accuracy is also checked, so it may be relaxed by a value in the scene.
        let usual = || {
            let allowed = problem.allowed_error().filter(|_| knob.is_accuracy())?;
            let mean = problem.target_mean();
            (mean > 0.0).then_some(allowed / mean)
        };
        Some((knob, problem.value(criterion).or_else(usual)?))
    };
    keys::relaxable().filter_map(of).collect()
}

impl Relaxable {
    /// Criterion by which conflicts and suggested changes name the value.
    pub fn criterion(self) -> Criterion {
        self.criterion
    }

    /// Whether the value is the accuracy. The accuracy is relative to the mean force, while its check is in newtons.
    pub fn is_accuracy(self) -> bool {
        self.key.section() == "accuracy"
    }

    /// Whether a check measures the value.
    pub fn is_measured_by(self, check: Criterion) -> bool {
        match self.key.limit {
            Some(kind) => kind.is_measured_by(check),
            None => self.is_accuracy() && check == Criterion::RmsError,
        }
    }

    /// The problem in which the value of this key is `value`.
    pub fn with(self, problem: &Problem, value: f64) -> Problem {
        problem.with(self.criterion, value)
    }

    /// Whether a larger value is a weaker limit, as for upper limits.
    pub fn grows(self) -> bool {
        self.relax == Relax::Up
    }

    /// Direction of the weaker limit: +1 if a larger value is weaker, otherwise −1.
    pub fn sign(self) -> f64 {
        if self.grows() { 1.0 } else { -1.0 }
    }

    /// A value at which the limit has no effect. `from` is the present value, and `force` the magnitude of the force, N.
    pub fn away(self, from: f64, force: f64) -> f64 {
        match (self.key.range, self.relax) {
            (Range::Acute, _) => STEEPEST,
            (Range::Any, _) => from + self.sign() * AWAY * force.max(from.abs()),
            (Range::NotNegative, Relax::Down) => 0.0,
            (_, Relax::Down) => from / AWAY,
            (_, Relax::Up) if self.key.section() == "cam" => FAR_LARGER * from,
            (_, Relax::Up) => AWAY * from,
        }
    }

    /// The value `from` relaxed by the fraction `share`.
    pub fn eased(self, from: f64, share: f64, force: f64) -> f64 {
        match (self.key.range, self.relax) {
            (Range::Acute, _) => (from * (1.0 + share)).min(STEEPEST),
            (Range::Any, Relax::Down) => from - share * from.abs().max(force),
            (_, Relax::Down) => from / (1.0 + share),
            (_, Relax::Up) => from * (1.0 + share),
        }
    }

    /// The value relaxed by the fraction `room` and rounded towards the weaker limit.
    pub fn with_room(self, value: f64, room: f64) -> f64 {
        self.rounded(value + room * value.abs() * self.sign())
    }

    /// The value rounded to four digits (an angle to 0.01°), towards the weaker limit.
    pub fn rounded(self, value: f64) -> f64 {
        self.on_step(value, 1e-9)
    }

    /// The next rounded value, which is a weaker limit.
    pub fn after(self, value: f64) -> f64 {
        self.on_step(value + 1e-3 * self.step(value) * self.sign(), 0.0)
    }

    /// Difference between adjacent rounded values.
    pub fn step(self, value: f64) -> f64 {
        match self.key.range {
            Range::Acute => 1e-2_f64.to_radians(),
            _ => 10_f64.powi(-self.decimals(value)),
        }
    }

    /// Number of decimals of a value with four significant digits; negative above 10 000. Forces are rounded to at most micronewtons.
    fn decimals(self, value: f64) -> i32 {
        let least = if self.key.range == Range::Any {
            1e-3
        } else {
            1e-9
        };
        3 - libm::log10(value.abs().max(least)).floor() as i32
    }

    /// The value rounded to a multiple of the step, towards the weaker limit. A value closer to a multiple than the fraction `same` of a step is
    /// rounded to that multiple.
    fn on_step(self, value: f64, same: f64) -> f64 {
        let steps = value / self.step(value);
        let whole = if self.grows() {
            (steps - same).ceil()
        } else {
            (steps + same).floor()
        };
        match self.key.range {
            // Division gives the floating-point number nearest to the decimal value. A product with a step below 1 would change the last
            // digit.
            Range::Acute => whole * self.step(value),
            _ if self.decimals(value) > 0 => whole / 10_f64.powi(self.decimals(value)),
            _ => whole * self.step(value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_rounded_to_four_digits_towards_the_weaker_limit() {
        let of = |path: &str| {
            let key = keys::relaxable().find(|k| k.path == path).unwrap();
            Relaxable {
                key,
                relax: key.relax.unwrap(),
                criterion: criterion_of(key).unwrap(),
            }
        };
        let (stroke, force) = (of("limits.stroke"), of("limits.force_min"));
        for (value, weaker, next) in [
            (0.048_213_7, 0.048_22, 0.048_23),
            (0.013_97, 0.013_97, 0.013_98),
            (1.0, 1.0, 1.001),
            (65_432.1, 65_440.0, 65_450.0),
        ] {
            assert_eq!(stroke.rounded(value).to_string(), weaker.to_string());
            assert_eq!(
                stroke.after(stroke.rounded(value)).to_string(),
                next.to_string()
            );
        }
        assert_eq!(force.rounded(512.37).to_string(), "512.3");
        assert_eq!(force.after(512.3).to_string(), "512.2");
        assert_eq!([0.0, 1.9e-7].map(|f| force.rounded(f)), [0.0, 0.0]);
        let angle = of("limits.pressure_angle");
        let degrees = angle.rounded(33.281_f64.to_radians()).to_degrees();
        assert!((degrees - 33.29).abs() < 1e-9, "{degrees}");
    }
}
