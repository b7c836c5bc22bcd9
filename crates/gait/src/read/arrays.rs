//! One cycle of force from arrays of the caller, without assumptions.

use super::cycle_file::sampled;
use crate::curve::ForceCurve;
use crate::error::{ForceError, Placed, ReadError, Result};
use crate::quantity::seconds;

/// One cycle from times, s, and forces, N.
///
/// The first sample may be repeated at the end. Without a `period`, s, the cycle ends one sampling interval after its last sample.
///
/// # Errors
///
/// Arrays of different lengths; fewer than four samples; values that are not finite; times that do not increase; samples after the end of
/// the period. The keys in the errors are `t_s`, `f_n` and `period_s`.
pub fn of_arrays(
    name: &str,
    t_s: &[f64],
    f_n: &[f64],
    period_s: Option<f64>,
) -> Result<ForceCurve> {
    if t_s.len() != f_n.len() {
        let (times, forces) = (t_s.len(), f_n.len());
        return Err(ForceError::Lengths { times, forces }.at_key("f_n"));
    }
    for (key, values) in [("t_s", t_s), ("f_n", f_n)] {
        if let Some(sample) = values.iter().position(|x| !x.is_finite()) {
            return Err(ForceError::SampleNotFinite { sample }.at_key(key));
        }
    }
    if let Some(w) = t_s.windows(2).find(|w| w[1] <= w[0]) {
        let (time, after) = (w[1], w[0]);
        return Err(ReadError::TimeBackwards { time, after }.at_key("t_s"));
    }
    if let Some(period) = period_s.filter(|p| !(p.is_finite() && *p > 0.0)) {
        let period = seconds(period);
        return Err(ForceError::PeriodNotPositive { period }.at_key("period_s"));
    }
    sampled(name, t_s, f_n, period_s).map_err(|e| e.at_key("t_s"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Place;
    use std::f64::consts::TAU;

    #[test]
    fn equal_steps_are_taken_as_they_stand_and_others_interpolated() {
        let force = |t: f64| 700.0 + 200.0 * (TAU * t / 0.5).sin();
        let even: Vec<f64> = (0..500).map(|i| 0.001 * f64::from(i)).collect();
        let f: Vec<f64> = even.iter().map(|&t| force(t)).collect();
        let curve = of_arrays("f", &even, &f, None).unwrap();
        assert_eq!(curve.force_n, f);
        assert!((curve.period_s - 0.5).abs() < 1e-12);
        let odd: Vec<f64> = even
            .iter()
            .map(|t| t + 0.0004 * (TAU * t / 0.1).sin())
            .collect();
        let f: Vec<f64> = odd.iter().map(|&t| force(t)).collect();
        let curve = of_arrays("f", &odd, &f, Some(0.5)).unwrap();
        let worst = (0..1000).map(|i| TAU * f64::from(i) / 1000.0);
        let worst = worst.fold(0.0_f64, |m, x| {
            m.max((curve.at(x) - force(0.5 * x / TAU)).abs())
        });
        assert!(worst < 0.05, "{worst}");
    }

    #[test]
    fn arrays_that_are_no_cycle_are_refused_at_their_argument() {
        let t = [0.0, 0.1, 0.2, 0.3];
        let place = |t: &[f64], f: &[f64], p| of_arrays("f", t, f, p).unwrap_err().place;
        let key = |k: &str| Place::Key(k.to_string());
        assert_eq!(place(&t, &t[..3], None), key("f_n"));
        assert_eq!(place(&t, &[1.0, f64::NAN, 1.0, 1.0], None), key("f_n"));
        assert_eq!(place(&[0.0, 0.2, 0.1, 0.3], &t, None), key("t_s"));
        assert_eq!(place(&[], &[], None), key("t_s"));
        assert_eq!(place(&t, &t, Some(0.2)), key("t_s"));
        assert_eq!(place(&t, &t, Some(-1.0)), key("period_s"));
    }
}
