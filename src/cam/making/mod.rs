//! Manufacturing data of a cam: material, surface, tolerance, hole, hub.

use serde::Serialize;

mod bore;
mod hardness;

pub use bore::{Bore, Keyway};
pub use hardness::{Hardness, HardnessScale};

use super::{Cam, Hole};

/// Material, surface, tolerance, and what is added to the plate; lengths in m.
///
/// ```
/// use gaitcam::cam::{Bore, Cam, Follower, Hub, Making};
/// use gaitcam::law::Law;
///
/// // A disc of 31 mm about (1 mm, 0): the hole that balances it lies on the side of the centre.
/// let law = Law::harmonic(0.001, &[(0.0, 0.001)]);
/// let cam = Cam::new(law, Follower::FlatTranslating { base_radius: 0.03 })?;
/// let bore = Some(Bore::plain(0.012));
/// assert!(Making::default().balance_hole(&cam, bore).is_none());
/// let making = Making { balance: true, ..Making::default() };
/// assert!(making.balance_hole(&cam, bore).unwrap().centre[0] > 0.0);
/// // Under a hub as large as the cam there is no room for it.
/// let hub = Some(Hub { diameter: 0.058, length: 0.01 });
/// assert!(Making { hub, ..making }.balance_hole(&cam, bore).is_none());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::synthesise;
///
/// let mut scene = scene::built_in("camdas_03_flat")?.scene()?;
/// scene.cam.hub_diameter = Some(0.03);
/// let design = synthesise(&scene, None)?;
/// let hub = design.problem.cam.making().hub.unwrap();
/// assert_eq!((hub.diameter, hub.length), (0.03, design.problem.cam.thickness));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Hub {
    /// Diameter, m.
    pub diameter: f64,
    /// Height above the plate, m.
    pub length: f64,
}

impl Making {
    /// The hole that balances the plate, if it is requested and fits; m.
    pub fn balance_hole(&self, cam: &Cam, bore: Option<Bore>) -> Option<Hole> {
        if !self.balance {
            return None;
        }
        // The hole must lie outside the hub.
        let hub = self.hub.map(|hub| Bore::plain(hub.diameter));
        let reach = |bore: Option<Bore>| bore.map_or(0.0, |b| b.reach());
        let inner = reach(hub).max(reach(bore));
        cam.balance_hole_outside(bore, inner)
    }

    /// Whether the plate is to be balanced and is not, for want of room.
    pub fn leaves_unbalanced(&self, cam: &Cam, bore: Option<Bore>) -> bool {
        let is_balanced = || cam.body(bore).is_some_and(|body| body.is_balanced());
        self.balance && self.balance_hole(cam, bore).is_none() && !is_balanced()
    }
}
