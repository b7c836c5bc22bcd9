//! Parameter of a machine with its interval.

use serde::Serialize;

use super::fit::Estimate;

/// Maximum relative width of the interval of an identified parameter.
pub(super) const WIDEST: f64 = 0.5;

/// A parameter of the machine, estimated from the log.
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
    /// Most likely value, SI.
    pub value: f64,
    /// Lower end of the 95 % interval; `None` if unbounded.
    pub low: Option<f64>,
    /// Upper end of the 95 % interval; `None` if unbounded.
    pub high: Option<f64>,
    /// Whether the log identifies the parameter.
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

    /// A parameter estimated by its inverse. If the inverse may be 0, the value is the minimum possible one.
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
