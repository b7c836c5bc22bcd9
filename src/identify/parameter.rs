//! Parameter of a machine with its confidence interval.

use serde::Serialize;

use super::fit::Estimate;

/// Maximum width of the interval of an identified parameter, relative to its value.
pub(super) const WIDEST: f64 = 0.5;

/// Estimate of a parameter of the machine, from one or several logs.
///
/// ```
/// use gaitcam::identify::Parameter;
///
/// let mass = Parameter { key: "drive.mass", value: 71.4, low: Some(71.2), high: Some(71.6), identifiable: true };
/// assert_eq!(serde_json::to_value(&mass).unwrap()["key"], "drive.mass");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// Key of the scene, or `log.…` and `guide.…` for parameters without a key: `log.bias` (N), `log.delay` (s), `log.scale`, `guide.damping`
    /// (N·s/m), `guide.friction` (N).
    pub key: &'static str,
    /// Estimated value, in SI units.
    pub value: f64,
    /// Lower end of the 95 % confidence interval; `None` if unbounded.
    pub low: Option<f64>,
    /// Upper end of the 95 % confidence interval; `None` if unbounded.
    pub high: Option<f64>,
    /// Whether the logs identify the parameter. The interval of an identified parameter excludes 0 and is not wider than half the value.
    pub identifiable: bool,
}

impl Parameter {
    pub(super) fn of(key: &'static str, found: Estimate, is_positive: bool) -> Parameter {
        let Estimate { value, ends } = found;
        let [low, high] = ends.map(|x| if is_positive { x.max(0.0) } else { x });
        let end = |x: f64| x.is_finite().then_some(x);
        Parameter {
            key,
            value,
            low: end(low),
            high: end(high),
            identifiable: low * high > 0.0 && high - low <= WIDEST * value.abs(),
        }
    }

    /// A parameter whose reciprocal was estimated. If the estimated reciprocal is 0, the value is the lower end of the interval.
    pub(super) fn inverse(key: &'static str, found: Estimate) -> Parameter {
        let of = Parameter::of(key, found, true);
        let inverse = |x: f64| (x > 0.0).then(|| 1.0 / x);
        let [low, high] = [of.high.and_then(inverse), of.low.and_then(inverse)];
        let value = inverse(of.value).or(low).unwrap_or(0.0);
        Parameter {
            value,
            low,
            high,
            ..of
        }
    }

    pub(super) fn unknown(key: &'static str, value: f64) -> Parameter {
        let (low, high, identifiable) = (None, None, false);
        Parameter {
            key,
            value,
            low,
            high,
            identifiable,
        }
    }
}
