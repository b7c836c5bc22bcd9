//! Rotating cam with the data that its drawing shows.

use std::f64::consts::TAU;

use gaitcam::cam::{Bore, Cam};
use gaitcam::synth::Design;

use super::radii::farthest;
use gaitcam::synth::Edge;

/// Cam to be manufactured, with its bore and its thickness.
pub struct Piece<'a> {
    pub cam: &'a Cam,
    pub edge: Edge<'a>,
    /// Message key of the cam's name in a conjugate pair; `None` for a single cam.
    pub name: Option<&'static str>,
    pub bore: Option<Bore>,
    pub thickness: f64,
    pub clockwise: bool,
}

impl<'a> Piece<'a> {
    /// The rotating cam or cams of a design.
    pub fn all(design: &'a Design) -> Vec<Self> {
        let names = match design.conjugate {
            Some(_) => [Some("drawing-first"), Some("drawing-second")],
            None => [None, None],
        };
        let second = design.conjugate.as_ref().map(|pair| &pair.second);
        let cams: Vec<&Cam> = [&design.cam].into_iter().chain(second).collect();
        let edges = Edge::all(design).into_iter().zip(names);
        (cams.iter().zip(edges))
            .map(|(cam, (edge, name))| Piece {
                cam,
                edge,
                name,
                bore: design.problem.cam.hole(),
                thickness: design.problem.cam.thickness,
                clockwise: design.problem.drive.speed < 0.0,
            })
            .collect()
    }

    pub fn base(&self) -> f64 {
        self.cam.follower.base_radius()
    }

    pub fn prime(&self) -> f64 {
        self.cam.follower.prime_radius()
    }

    /// Radius, m, of the circle about the cam's centre that contains the profile and the prime circle.
    pub fn radius(&self) -> f64 {
        let [x, y] = farthest(&self.edge, 1440).p;
        libm::hypot(x, y).max(self.prime())
    }
}

/// Points on the edge of the bore, m: `count` points at equal angles, and the corners of the keyway.
pub fn bore_edge(bore: &Bore, count: usize) -> Vec<[f64; 2]> {
    let mut angles: Vec<f64> = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    angles.extend(bore.corners().iter().map(|a| a.rem_euclid(TAU)));
    angles.sort_by(f64::total_cmp);
    let at = |a: f64| [bore.edge(a) * libm::cos(a), bore.edge(a) * libm::sin(a)];
    angles.into_iter().map(at).collect()
}
