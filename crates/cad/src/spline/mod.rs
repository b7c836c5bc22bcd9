//! Approximation of an edge by cubic B-splines.

mod interpolant;
mod periodic;

use interpolant::clamped;
pub use interpolant::{FEWEST, Interpolant};

use self::periodic::Spline;
use gaitcam::synth::{Edge, EdgePoint};

const MM: f64 = 1000.0;
/// Maximum number of spans of the spline for one part of an open edge.
const MOST: usize = 16384;

/// Clamped cubic B-spline in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamped {
    /// Control points (x, y), mm.
    pub control: Vec<[f64; 2]>,
    /// Multiplicities and values of the knots.
    pub knots: Vec<(usize, f64)>,
}

/// Consecutive splines within `tolerance` m of an edge.
///
/// A closed edge is approximated by one periodic C² spline, counter-clockwise, which is divided into `parts` clamped splines. An open edge is
/// approximated by one spline per span of the law, in the direction of increasing θ. `None` if the edge is undercut, or if the maximum number of
/// spans is not sufficient.
pub fn along(edge: &Edge, tolerance: f64, parts: usize) -> Option<Vec<Clamped>> {
    if edge.is_undercut() {
        return None;
    }
    if !edge.is_closed() {
        let pieces = edge.breaks().windows(2);
        return pieces
            .map(|pair| piece(edge, [pair[0], pair[1]], tolerance))
            .collect();
    }
    let spline = Spline::within(edge, tolerance)?;
    let n = spline.control.len();
    let part = |k: usize| {
        let control = spline.part(k * n / parts, (k + 1) * n / parts);
        let spans = control.len() - 3;
        let knots = clamped(1..spans, spans);
        Clamped { control, knots }
    };
    Some((0..parts).map(part).collect())
}

/// Spline within `tolerance` m of the edge between two cam angles, rad, in the direction from the first angle to the second. `None` if the maximum
/// number of spans is not sufficient.
pub fn piece(edge: &Edge, [from, to]: [f64; 2], tolerance: f64) -> Option<Clamped> {
    let mut spans = FEWEST;
    while spans <= MOST {
        let at = |i: f64| -> EdgePoint { edge.at(from + (to - from) * i / spans as f64) };
        let points: Vec<[f64; 2]> = (0..=spans)
            .map(|i| at(i as f64).p.map(|x| MM * x))
            .collect();
        let space = Interpolant::new(spans);
        let control = space.control(&points);
        let astray = |i: usize| {
            let x = 0.25 * i as f64;
            let (p, q) = (space.at(&control, x), at(x));
            ((p[0] - MM * q.p[0]) * q.t[1] - (p[1] - MM * q.p[1]) * q.t[0]).abs()
        };
        let worst = (0..4 * spans).map(astray).fold(0.0, f64::max);
        if worst <= MM * tolerance {
            let knots = space.knots();
            return Some(Clamped { control, knots });
        }
        spans *= 2;
    }
    None
}
