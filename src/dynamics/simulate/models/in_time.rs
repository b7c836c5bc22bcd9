//! Conversion of a law to a function of time, for a shaft with varying speed.

use std::f64::consts::TAU;

use crate::dynamics::shaft::Motion;
use crate::law::Law;
use crate::poly::PiecewisePoly;

/// Distance from a break at which the motion on each side is evaluated, rad.
const SIDE: f64 = 1e-10;

/// Lift as a function of the elapsed fraction of the period, rad (2π for one period). Polynomials of degree 5 extend between `breaks` and
/// the breaks of the shaft motion.
pub fn in_time(law: &Law, breaks: &[f64], clock: &Motion) -> Law {
    let start = law.extent().0;
    let mut marks: Vec<f64> = clock
        .breaks()
        .chain(breaks.iter().map(|b| b - start))
        .collect();
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|b, a| *b - *a < 10.0 * SIDE);
    let value = |x: f64| {
        let [phase, rate, bend, _] = clock.phase(x.clamp(0.0, TAU - SIDE));
        let at = law.svaj(start + x);
        let slope = at.v / rate;
        [phase, at.s, slope, (at.a - slope * bend) / (rate * rate)]
    };
    let mut breaks = vec![0.0];
    let mut coefficients = Vec::with_capacity(6 * marks.len());
    for ends in marks.windows(2) {
        let [from, to] = [value(ends[0] + SIDE), value(ends[1] - SIDE)];
        let end = if ends[1] == TAU {
            TAU
        } else {
            clock.phase(ends[1])[0]
        };
        let h = end - breaks[breaks.len() - 1];
        let [d, e] = [h * from[2] / 5.0, h * h * from[3] / 20.0];
        let [f, g] = [h * to[2] / 5.0, h * h * to[3] / 20.0];
        let (y, z) = (from[1], to[1]);
        coefficients.extend([y, y + d, y + 2.0 * d + e, z - 2.0 * f + g, z - f, z]);
        breaks.push(end);
    }
    Law::from_poly(PiecewisePoly::new(breaks, 5, coefficients), true)
}
