//! Two cams on one shaft: the second turned back, and the lift of whichever stands higher.

use crate::law::Law;
use crate::poly::{PiecewisePoly, bernstein};

/// The law seen `angle` later: s(θ − angle), for a second cam turned back by `angle` on the same shaft.
///
/// The law must be closed over one turn and keep its first angle; a wave or a piece cut by the new
/// beginning is split there.
pub fn shifted(law: &Law, angle: f64) -> Law {
    let (start, length) = law.extent();
    let angle = angle.rem_euclid(length);
    let poly = law.combination([1.0, 0.0, 0.0, 0.0], 0.0);
    let cut = start + length - angle;
    let (mut head, mut tail) = (Vec::new(), Vec::new());
    for i in 0..poly.pieces() {
        let (a, b) = (poly.breaks()[i], poly.breaks()[i + 1]);
        let within = (cut - a) / (b - a);
        // A cut within rounding of a break is that break.
        if within >= 1.0 - 1e-9 {
            tail.push((a + angle, poly.piece(i).to_vec()));
        } else if within <= 1e-9 {
            head.push((a + angle - length, poly.piece(i).to_vec()));
        } else {
            let (left, right) = bernstein::split(poly.piece(i), within);
            tail.push((a + angle, left));
            head.push((start, right));
        }
    }
    let mut breaks: Vec<f64> = head
        .iter()
        .chain(&tail)
        .map(|p: &(f64, Vec<f64>)| p.0)
        .collect();
    breaks[0] = start;
    breaks.push(start + length);
    let coef = head.into_iter().chain(tail).flat_map(|p| p.1).collect();
    Law::from_poly(
        PiecewisePoly::new(breaks, poly.degree(), coef),
        law.is_closed(),
    )
}

/// The lift of the higher of two polynomial laws at every angle: breaks of both, and new ones where they
/// cross. Its slope steps up at the crossings, which are impacts.
pub fn envelope(one: &Law, other: &Law) -> Law {
    let mut breaks: Vec<f64> = one.breaks().iter().chain(other.breaks()).copied().collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|b, a| *b - *a < 1e-9);
    let (start, length) = one.extent();
    if let Some(last) = breaks.last_mut() {
        *last = start + length;
    }
    let degree = one.poly().degree().max(other.poly().degree());
    let (a, b) = (
        cut(one.poly(), &breaks, degree),
        cut(other.poly(), &breaks, degree),
    );
    let difference = PiecewisePoly::combine(&[(1.0, &a), (-1.0, &b)], 0.0);
    let mut finer = breaks.clone();
    // Roots within rounding of a break are that break.
    let apart = |r: &f64| breaks.iter().all(|x| (x - r).abs() > 1e-9);
    finer.extend(difference.roots().iter().filter(|r| apart(r)));
    finer.sort_by(f64::total_cmp);
    finer.dedup_by(|b, a| *b - *a < 1e-9);
    let (a, b) = (
        cut(one.poly(), &finer, degree),
        cut(other.poly(), &finer, degree),
    );
    let coef = (0..a.pieces())
        .flat_map(|i| {
            let higher = bernstein::eval(a.piece(i), 0.5) >= bernstein::eval(b.piece(i), 0.5);
            if higher {
                a.piece(i).to_vec()
            } else {
                b.piece(i).to_vec()
            }
        })
        .collect();
    Law::from_poly(PiecewisePoly::new(finer, degree, coef), one.is_closed())
}

/// The law on finer breaks.
fn cut(p: &PiecewisePoly, breaks: &[f64], degree: usize) -> PiecewisePoly {
    let mut coef = Vec::with_capacity((breaks.len() - 1) * (degree + 1));
    for pair in breaks.windows(2) {
        let (i, _) = p.locate(0.5 * (pair[0] + pair[1]));
        let (from, to) = (p.breaks()[i], p.breaks()[i + 1]);
        let (u, w) = (
            (pair[0] - from) / (to - from),
            (pair[1] - from) / (to - from),
        );
        let (_, right) = bernstein::split(p.piece(i), u);
        let (middle, _) = bernstein::split(&right, (w - u) / (1.0 - u));
        coef.extend(bernstein::elevate(&middle, degree));
    }
    PiecewisePoly::new(breaks.to_vec(), degree, coef)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::Cam;
    use crate::dynamics::{recover::recover, thesis};
    use std::f64::consts::PI;

    #[test]
    fn the_second_cam_is_the_first_half_a_turn_later() {
        for n in [360, 361] {
            let cam: Cam = thesis::double_harmonic();
            let one = recover(&cam.follower, &cam.profile(n)).unwrap().law;
            let other = shifted(&one, PI);
            let both = envelope(&one, &other);
            for i in 0..1000 {
                let t = 0.006_283 * f64::from(i);
                let (a, b) = (one.svaj(t).s, one.svaj(t - PI).s);
                assert!((other.svaj(t).s - b).abs() < 1e-15);
                assert!((both.svaj(t).s - a.max(b)).abs() < 1e-15);
            }
            let steps = both.joints().iter().filter(|j| j.jump.v > 1e-6).count();
            assert_eq!(steps, 2);
        }
    }
}
