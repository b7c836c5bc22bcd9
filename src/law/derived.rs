//! Laws derived from another law: reversed, shifted, or combined.

use super::{Law, pieces::Pieces};
use crate::poly::PiecewisePoly;

/// Fraction of a span within which an angle counts as equal to a break.
const AT_BREAK: f64 = 1e-9;

impl Law {
    /// Weighted sum of laws. `None` unless all laws are polynomial and have the same breaks.
    pub(crate) fn mixed(parts: &[(f64, &Law)]) -> Option<Law> {
        let first = parts.first()?.1;
        let alike =
            |law: &Law| law.breaks() == first.breaks() && law.waves.iter().all(Vec::is_empty);
        if !parts.iter().all(|(_, law)| alike(law)) {
            return None;
        }
        let sum = |of: &dyn Fn(&Law) -> Option<PiecewisePoly>| {
            let terms: Option<Vec<(f64, PiecewisePoly)>> = parts
                .iter()
                .map(|(part, law)| Some((*part, of(law)?)))
                .collect();
            let terms = terms?;
            let terms: Vec<(f64, &PiecewisePoly)> = terms.iter().map(|(p, t)| (*p, t)).collect();
            Some(PiecewisePoly::combine(&terms, 0.0))
        };
        let mut out = Law::from_poly(sum(&|law| Some(law.poly.clone()))?, first.closed);
        let of = |k: usize| sum(&|law| Some(law.derivatives.as_ref()?[k].clone()));
        if let (Some(v), Some(a), Some(j)) = (of(0), of(1), of(2)) {
            out.derivatives = Some([v, a, j].into());
        }
        Some(out)
    }

    /// The reversed law s(−θ), for a clockwise cam. Its extent is mirrored about zero.
    #[must_use]
    pub fn reversed(&self) -> Law {
        let poly = self.poly();
        let breaks: Vec<f64> = poly.breaks().iter().rev().map(|b| -b).collect();
        let pieces = poly.pieces();
        let mut coef = Vec::with_capacity(pieces * (poly.degree() + 1));
        let mut waves: Vec<Vec<_>> = Vec::with_capacity(pieces);
        for i in (0..pieces).rev() {
            coef.extend(poly.piece(i).iter().rev());
            let width = poly.breaks()[i + 1] - poly.breaks()[i];
            let mirrored = self.waves(i).iter().map(|w| w.mirrored(width));
            waves.push(mirrored.collect());
        }
        let poly = PiecewisePoly::new(breaks, poly.degree(), coef);
        Law::with_waves(poly, waves, self.is_closed())
    }

    /// Law of a cam that is mounted with the angle of advance `ahead`, rad: s(θ + ahead), on the same extent. An open law is unchanged.
    #[must_use]
    pub fn ahead(&self, ahead: f64) -> Law {
        let (start, length) = self.extent();
        let cut = self.near_break(self.wrap(start + ahead));
        if !self.is_closed() || cut == start {
            return self.clone();
        }
        let mut pieces = Pieces::starting_at(start);
        pieces.push_part(self, cut, start + length);
        pieces.push_part(self, start, cut);
        pieces.end_exactly_at(start + length);
        pieces.finish(true)
    }

    /// The break that equals an angle up to rounding errors; otherwise the angle itself.
    fn near_break(&self, theta: f64) -> f64 {
        let (i, u) = self.poly().locate(theta);
        match u {
            u if u <= AT_BREAK => self.breaks()[i],
            u if u >= 1.0 - AT_BREAK => self.wrap(self.breaks()[i + 1]),
            _ => theta,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Extent, Rise, Segment, program};

    #[test]
    fn a_mirrored_law_runs_backwards() {
        let segment = |motion, lift, angle| Segment {
            motion,
            lift,
            angle,
        };
        let pi = std::f64::consts::PI;
        let law = program(
            &[
                segment(Rise::ModifiedSine, 0.01, 0.75 * pi),
                segment(Rise::Poly345, -0.01, 0.75 * pi),
                segment(Rise::Dwell, 0.0, 0.5 * pi),
            ],
            Extent::TURN,
        )
        .unwrap();
        let back = law.reversed();
        for i in 0..100 {
            let t = 0.0628 * f64::from(i) + 0.01;
            let (a, b) = (law.svaj(t), back.svaj(-t));
            assert!((a.s - b.s).abs() < 1e-15 && (a.v + b.v).abs() < 1e-15);
            assert!((a.a - b.a).abs() < 1e-14 && (a.j + b.j).abs() < 1e-13);
        }
    }
}
