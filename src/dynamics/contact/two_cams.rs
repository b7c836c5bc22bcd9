//! Maximum of the lifts of two cams on one shaft.

use crate::law::Law;
use crate::poly::{PiecewisePoly, bernstein};

/// Maximum of two polynomial laws at every angle. It has the breaks of both laws and further breaks where the laws cross. At the crossings
/// its slope increases abruptly, which causes impacts.
pub fn envelope(one: &Law, other: &Law) -> Law {
    let mut breaks: Vec<f64> = one.breaks().iter().chain(other.breaks()).copied().collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|b, a| *b - *a < 1e-9);
    let (start, length) = one.extent();
    if let Some(last) = breaks.last_mut() {
        *last = start + length;
    }
    let degree = one.poly().degree().max(other.poly().degree());
    let both = |breaks: &[f64]| [one, other].map(|law| cut(law.poly(), breaks, degree));
    let [a, b] = both(&breaks);
    let difference = PiecewisePoly::combine(&[(1.0, &a), (-1.0, &b)], 0.0);
    let mut finer = breaks.clone();
    // A root that differs from a break only by rounding errors counts as this break.
    let apart = |r: &f64| breaks.iter().all(|x| (x - r).abs() > 1e-9);
    finer.extend(difference.roots().iter().filter(|r| apart(r)));
    finer.sort_by(f64::total_cmp);
    finer.dedup_by(|b, a| *b - *a < 1e-9);
    let [a, b] = both(&finer);
    let coef = (0..a.pieces())
        .flat_map(|i| {
            let higher = bernstein::eval(a.piece(i), 0.5) >= bernstein::eval(b.piece(i), 0.5);
            if higher { &a } else { &b }.piece(i).to_vec()
        })
        .collect();
    Law::from_poly(PiecewisePoly::new(finer, degree, coef), one.is_closed())
}

/// The polynomial on the finer breaks `breaks`, with its degree raised to `degree`.
fn cut(p: &PiecewisePoly, breaks: &[f64], degree: usize) -> PiecewisePoly {
    let on = |pair: &[f64]| {
        let (i, _) = p.locate(0.5 * (pair[0] + pair[1]));
        let (from, to) = (p.breaks()[i], p.breaks()[i + 1]);
        let [low, high] = [pair[0], pair[1]].map(|x| (x - from) / (to - from));
        bernstein::elevate(&bernstein::between(p.piece(i), low, high), degree)
    };
    let coef = breaks.windows(2).flat_map(on).collect();
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
            let other = one.ahead(-PI);
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
