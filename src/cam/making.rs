//! What the workshop is told of a cam beside its shape.

use super::{Bore, Cam, Hardness, Hole};

/// Material, surface, tolerance, and what is added to the plate; lengths in m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Making {
    /// The material by its designation; `None` = steel.
    pub material: Option<String>,
    /// Hardness of the surface.
    pub hardness: Option<Hardness>,
    /// Arithmetical mean roughness Ra of the profile.
    pub roughness: Option<f64>,
    /// Half width of the tolerance on the profile.
    pub tolerance: Option<f64>,
    /// Whether the hole that balances the cam is bored.
    pub balance: bool,
    /// The hub on the upper face.
    pub hub: Option<Hub>,
}

/// A round boss about the shaft, on the upper face of the plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hub {
    /// Diameter, m.
    pub diameter: f64,
    /// How far it stands out of the plate, m.
    pub length: f64,
}

impl Making {
    /// The hole that balances the plate, where one is wanted and has room; m.
    pub fn balance_hole(&self, cam: &Cam, bore: Option<Bore>) -> Option<Hole> {
        if !self.balance {
            return None;
        }
        // Nothing may be bored under the hub.
        let hub = self.hub.map(|hub| Bore::plain(hub.diameter));
        let reach = |bore: Option<Bore>| bore.map_or(0.0, |b| b.reach());
        let inner = reach(hub).max(reach(bore));
        cam.balance_hole_outside(bore, inner)
    }
}
