//! A law run backwards.

use crate::law::Law;
use crate::poly::PiecewisePoly;

/// The law run backwards: s(−θ), for a cam that turns clockwise. Its extent is mirrored about zero.
pub fn backwards(law: &Law) -> Law {
    let poly = law.poly();
    let breaks: Vec<f64> = poly.breaks().iter().rev().map(|b| -b).collect();
    let pieces = poly.pieces();
    let mut coef = Vec::with_capacity(pieces * (poly.degree() + 1));
    let mut waves = Vec::new();
    for i in (0..pieces).rev() {
        coef.extend(poly.piece(i).iter().rev());
        let width = poly.breaks()[i + 1] - poly.breaks()[i];
        waves.push(
            law.waves(i)
                .iter()
                .map(|w| w.mirrored(width))
                .collect::<Vec<_>>(),
        );
    }
    if waves.iter().all(Vec::is_empty) {
        waves.clear();
    }
    let poly = PiecewisePoly::new(breaks, poly.degree(), coef);
    Law::with_waves(poly, waves, law.is_closed())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::thesis;

    #[test]
    fn a_mirrored_law_runs_backwards() {
        let law = thesis::double_harmonic().law;
        let back = backwards(&law);
        for i in 0..100 {
            let t = 0.0628 * f64::from(i) + 0.01;
            let (a, b) = (law.svaj(t), back.svaj(-t));
            assert!((a.s - b.s).abs() < 1e-15 && (a.v + b.v).abs() < 1e-15);
            assert!((a.a - b.a).abs() < 1e-14 && (a.j + b.j).abs() < 1e-13);
        }
    }
}
