//! Extremes of curvature, pressure angle and contact travel over the continuous law.

use super::Geometry;
use crate::cam::{Cam, Curvature, Follower};
use crate::law::Svaj;
use crate::poly::Extreme;

impl Cam {
    /// Minimum and maximum pressure angle φ, rad. It is positive if the force is rotated counter-clockwise from the motion, as during a
    /// rise. It is zero for a translating flat face. For a flat face on an arm, sin φ = f/L, with the face offset f and the distance L from
    /// the pivot to the contact.
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
            // tan φ = v/scale is linear in the law, so its extremes are exact.
            Geometry::Unrolled(unrolled) => self
                .law
                .extremes_of([0.0, 1.0 / unrolled.scale, 0.0, 0.0], 0.0),
            _ => self.law.extremes_by(|at| geometry.contact(at).tan_pressure),
        };
        let angle = |e: Extreme| e.map(libm::atan);
        (angle(low), angle(high))
    }

    /// Maximum absolute pressure angles, rad, during the rise (ds/dθ > 0) and during the fall of the follower; 0 without a rise or a fall.
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
        tangents.map(|side| side.map_or(none, |range| Extreme::largest(range).map(libm::atan)))
    }

    /// Minimum convex and concave radii of the finished profile.
    ///
    /// For a translating flat face, the radius of curvature is Rb + s + a, with the base radius Rb, the lift s and its second derivative a.
    /// Its extremes are exact. A flat face cannot touch a concave flank, so its minimum radius is signed and no concave radius is given.
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

    /// Range of the contact on the follower, m: minimum and maximum position. On a flat face, positions are measured from the foot of the
    /// perpendicular on the face. The perpendicular starts at the cam centre (translating) or at the pivot (oscillating, as in CAM-DAS). On
    /// a mushroom they are measured along the chord from the middle of the arc. `None` for rollers and knife edges.
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

    /// Position of the contact on the follower at one instant of the motion, m, measured as in [`Cam::contact_travel`]. On a roller it is
    /// measured along the chord from the middle of the roller.
    pub fn contact_along(&self, at: Svaj) -> f64 {
        Geometry::new(&self.follower).travel(at)
    }

    /// Minimum and maximum radius of the finished profile about the centre of the shaft, m, with their cam angles; `None` for unrolled
    /// profiles.
    ///
    /// Where the distance of the profile from the centre is extreme, the normal of the profile is radial and the follower is at rest. At
    /// this point, the profile radius equals the radius of a base circle. It is the base circle on which the follower would have the same
    /// position at s = 0. The result is exact for a profile without undercut.
    pub fn radii(&self) -> Option<[Extreme; 2]> {
        let follower = &self.follower;
        let start = follower.start_place();
        let at = |lift: Extreme| lift.map(|s| follower.base_radius_at(start + s));
        let (low, high) = self.law.extremes(0);
        (!follower.is_unrolled()).then(|| [at(low), at(high)])
    }

    /// Minimum length of a flat or mushroom face, m. It is the length of the contact range on the face. For a translating flat face, it is
    /// max v − min v (Campillo de Blas 2017). `None` for rollers and knife edges.
    pub fn face_width(&self) -> Option<f64> {
        self.contact_travel()
            .map(|(low, high)| high.value - low.value)
    }
}

/// Radius of curvature of a finished convex flank, m, from the maximum curvature of its pitch curve; infinite if no part is convex.
pub(in crate::cam) fn finished_radius(curvature: Extreme, roller: f64) -> Extreme {
    curvature.map(|bend| {
        if bend > 0.0 {
            1.0 / bend - roller
        } else {
            f64::INFINITY
        }
    })
}
