//! Extremes of curvature, pressure angle and contact travel over the continuous law.

use super::Geometry;
use crate::cam::{Cam, Curvature, Follower};
use crate::law::Svaj;
use crate::poly::Extreme;

impl Cam {
    /// Smallest and largest pressure angle, rad, signed: positive if the force is rotated counter-clockwise from the motion, as on a rise. Zero for a
    /// translating flat face; sin φ = f/L for one on an arm, with L from pivot to contact.
    pub fn pressure_angle_extremes(&self) -> (Extreme, Extreme) {
        if self.follower.is_flat() && self.follower.face_offset() == 0.0 {
            let zero = Extreme {
                at: self.law.extent().0,
                value: 0.0,
            };
            return (zero, zero);
        }
        let geometry = Geometry::new(&self.follower);
        let (low, high) = match geometry {
            // tan φ = v/scale is linear in the law: exact roots.
            Geometry::Unrolled(unrolled) => self
                .law
                .extremes_of([0.0, 1.0 / unrolled.scale, 0.0, 0.0], 0.0),
            _ => self.law.extremes_by(|at| geometry.contact(at).tan_pressure),
        };
        let angle = |e: Extreme| e.map(f64::atan);
        (angle(low), angle(high))
    }

    /// Largest |pressure angle|, rad, where the follower rises (ds/dθ > 0) and where it falls; 0 without such a part.
    pub fn pressure_angles_by_motion(&self) -> [Extreme; 2] {
        let geometry = Geometry::new(&self.follower);
        let on_axis = matches!(geometry, Geometry::Unrolled(_)) || self.follower.offset() == 0.0;
        if on_axis && !self.follower.kind().is_oscillating() {
            // tan φ has the sign of v.
            let (low, high) = self.pressure_angle_extremes();
            let size = |e: Extreme, sign: f64| e.map(|angle| (sign * angle).max(0.0));
            return [size(high, 1.0), size(low, -1.0)];
        }
        let none = Extreme {
            at: self.law.extent().0,
            value: 0.0,
        };
        let tangents = self
            .law
            .extremes_on_rise_and_fall(|at| geometry.contact(at).tan_pressure);
        tangents.map(|side| side.map_or(none, |range| Extreme::largest(range).map(f64::atan)))
    }

    /// Sharpest convex and concave points of the finished profile.
    ///
    /// Flat translating: exact extremes of Rb + s + a. A flat face cannot touch a concave flank, so its
    /// smallest radius is signed and there is no concave side.
    pub fn curvature(&self) -> Curvature {
        let geometry = Geometry::new(&self.follower);
        let flat = |low: Extreme| Curvature {
            convex: low,
            concave: None,
            undercut: low.value < 0.0,
        };
        match self.follower {
            Follower::FlatTranslating { base_radius } => {
                let weights = [1.0, 0.0, 1.0, 0.0];
                return flat(self.law.extremes_of(weights, base_radius).0);
            }
            Follower::FlatOscillating { .. } => {
                return flat(self.law.extremes_by(|at| geometry.contact(at).rho).0);
            }
            _ => {}
        }
        let (low, high) = self.law.extremes_by(|at| geometry.pitch_curvature(at));
        let radius = geometry.radius();
        let convex = finished_radius(high, radius);
        Curvature {
            convex,
            concave: (low.value < 0.0).then(|| low.map(|bend| 1.0 / bend - radius)),
            undercut: convex.value < 0.0,
        }
    }

    /// Range of the contact on the follower, m: minimum and maximum distance along a flat face from the foot of the cam's centre (translating) or of
    /// the pivot (oscillating, as in CAM-DAS), along a mushroom's chord from the arc's middle. `None` for rollers and knife edges.
    pub fn contact_travel(&self) -> Option<(Extreme, Extreme)> {
        match self.follower {
            Follower::FlatTranslating { .. } => Some(self.law.extremes(1)),
            Follower::FlatOscillating { .. }
            | Follower::MushroomTranslating { .. }
            | Follower::MushroomOscillating { .. } => {
                let geometry = Geometry::new(&self.follower);
                Some(self.law.extremes_by(|at| geometry.travel(at)))
            }
            _ => None,
        }
    }

    /// Position of the contact on the follower at one instant of the motion, m, as in [`Cam::contact_travel`]; on a roller along the chord from its
    /// middle.
    pub fn contact_along(&self, at: Svaj) -> f64 {
        Geometry::new(&self.follower).travel(at)
    }

    /// Minimum length of the flat (or mushroom's) face, m: the range of the contact on it; max v − min v for a translating flat face (Campillo de
    /// Blas 2017). `None` for rollers and knife edges.
    pub fn face_width(&self) -> Option<f64> {
        self.contact_travel()
            .map(|(low, high)| high.value - low.value)
    }
}

/// Radius of a finished convex flank from the largest curvature of its pitch curve: infinite without one.
pub(in crate::cam) fn finished_radius(curvature: Extreme, roller: f64) -> Extreme {
    curvature.map(|bend| {
        if bend > 0.0 {
            1.0 / bend - roller
        } else {
            f64::INFINITY
        }
    })
}
