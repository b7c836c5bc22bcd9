//! The cam in motion, with no more model than the scene needs.

pub mod contact;
pub mod design;
pub mod flexible;
pub mod flight;
pub mod hertz;
pub mod impact;
pub mod linear;
pub mod motor;
pub mod profile_curve;
pub mod rigid;
pub mod shaft;
pub mod surface;
pub mod thesis;

use crate::law::Law;
use crate::poly::PiecewisePoly;

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
            let (left, right) = crate::poly::bernstein::split(poly.piece(i), within);
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
