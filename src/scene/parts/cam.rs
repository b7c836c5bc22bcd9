//! `[cam]`: the cam and its follower.

use crate::cam::{Bore, Closure, FollowerKind, Keyway, Making, Material, Measures, StatedMaterial};

/// Default plate thickness, m.
const THICKNESS: f64 = 0.01;

/// Cam and follower of a scene; lengths in m.
///
/// ```
/// use gaitcam::cam::FollowerKind;
/// use gaitcam::scene::CamSpec;
///
/// let cam = CamSpec { roller_radius: 0.01, bore: Some(0.012), ..CamSpec::new(FollowerKind::RollerTranslating) };
/// assert_eq!((cam.roller_radius, cam.hole().unwrap().radius()), (0.01, 0.006));
/// assert!(cam.base_radius.is_none());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CamSpec {
    /// Kind of follower, which determines the dimensions that the scene requires.
    pub follower: FollowerKind,
    /// Base radius; `None`: the minimum radius that satisfies the limits.
    pub base_radius: Option<f64>,
    /// Prime radius; `None`: the minimum radius that satisfies the limits.
    pub prime_radius: Option<f64>,
    /// Offset of the follower's line of motion; `None`: the offset for which the cam is smallest.
    pub offset: Option<f64>,
    /// Radius of the roller, or of the arc of a mushroom follower.
    pub roller_radius: f64,
    /// Distance from the cam centre to the pivot of an oscillating follower.
    pub pivot_distance: Option<f64>,
    /// Length of the arm of an oscillating follower.
    pub arm: Option<f64>,
    /// Whether the arm of an oscillating follower is in another plane than the cam. Its pivot may then be within the outline of the cam.
    pub pivot_beside: bool,
    /// Distance of the face of an oscillating flat follower from the pivot.
    pub face_offset: f64,
    /// Diameter of the bore, which is inside the base circle.
    pub bore: Option<f64>,
    /// Keyway of the bore; `None` without a keyway.
    pub keyway: Option<KeywaySpec>,
    /// Whether the position θ = 0 is engraved on the solid model.
    pub mark: bool,
    /// Thickness of the plate in the solid model.
    pub thickness: f64,
    /// Material, hardness and tolerances of the cam.
    pub making: Making,
    /// Material of the contact surface of the follower.
    pub follower_material: StatedMaterial,
    /// Distance between the two faces, or the two roller centres, of a constant-breadth cam. The law then contains only the first half turn.
    pub breadth: Option<f64>,
    /// Length of the travel of a translating cam; `None`: the total length of the segments.
    pub travel: Option<f64>,
    /// Number of turns of the law; more than one only for a barrel cam.
    pub turns: usize,
    /// Depth of the groove of a barrel cam; `None`: the diameter of the roller.
    pub depth: Option<f64>,
    /// Offset of the axes of two rollers from the axis of their stud, for a barrel cam; `None` for one roller.
    pub eccentricity: Option<f64>,
    /// Second cam of a conjugate pair; `None` for a single cam.
    pub conjugate: Option<ConjugateSpec>,
}

impl Default for CamSpec {
    fn default() -> CamSpec {
        CamSpec {
            follower: FollowerKind::default(),
            base_radius: None,
            prime_radius: None,
            offset: Some(0.0),
            roller_radius: 0.0,
            pivot_distance: None,
            arm: None,
            pivot_beside: false,
            face_offset: 0.0,
            bore: None,
            keyway: None,
            mark: false,
            thickness: THICKNESS,
            making: Making::default(),
            follower_material: StatedMaterial::default(),
            breadth: None,
            travel: None,
            turns: 1,
            depth: None,
            eccentricity: None,
            conjugate: None,
        }
    }
}

/// Specification of the keyway of the bore.
///
/// ```
/// use gaitcam::scene::{CamSpec, KeywaySpec};
///
/// // DIN 6885-1 specifies a keyway of 4 mm for a bore of 12 mm.
/// let cam = CamSpec { keyway: Some(KeywaySpec::Auto), bore: Some(0.012), ..CamSpec::default() };
/// assert_eq!(cam.hole().unwrap().keyway.unwrap().width, 0.004);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum KeywaySpec {
    /// The width that DIN 6885-1 specifies for the diameter of the bore.
    Auto,
    /// A given width from DIN 6885-1, m.
    Width(f64),
}

impl CamSpec {
    /// Elastic constants of the materials of cam and follower.
    pub fn materials(&self) -> [Material; 2] {
        [
            self.making.stated.material(),
            self.follower_material.material(),
        ]
    }

    /// Contact modulus E* of the materials of cam and follower, Pa.
    pub fn contact_modulus(&self) -> f64 {
        let [cam, follower] = self.materials();
        1.0 / (cam.compliance() + follower.compliance())
    }

    /// Allowable contact pressure, Pa: the lower value of cam and follower. The value of the cam is given, or follows from its hardness or its
    /// material. `None` if no value is known.
    pub fn allowable_pressure(&self) -> Option<f64> {
        let making = &self.making;
        let of_hardness = making.hardness.map(|h| h.allowable_pressure());
        let stated = making.stated.allowable_pressure;
        let of_cam = stated
            .or(of_hardness)
            .or_else(|| making.stated.allowable_pressure());
        let of_follower = self.follower_material.allowable_pressure();
        of_cam.into_iter().chain(of_follower).reduce(f64::min)
    }

    /// Cam for a kind of follower, whose size is determined by the design.
    #[must_use]
    pub fn new(follower: FollowerKind) -> CamSpec {
        CamSpec {
            follower,
            ..CamSpec::default()
        }
    }

    /// Base radius and prime radius, m; `None` if the scene does not prescribe the size.
    pub fn given_radii(&self) -> Option<[f64; 2]> {
        let roller = self.roller_radius;
        match (self.base_radius, self.prime_radius) {
            (Some(base), prime) => Some([base, prime.unwrap_or(base + roller)]),
            (None, prime) => prime.map(|prime| [prime - roller, prime]),
        }
    }

    /// Default distance from the pivot at which the force acts on an arm, m. It is the length of the arm, or the pivot distance for a flat face.
    /// `None` for a translating follower.
    pub fn lever(&self) -> Option<f64> {
        let arm = if self.follower.is_flat() {
            self.pivot_distance.map(f64::abs)
        } else {
            self.arm
        };
        arm.filter(|_| self.is_oscillating())
    }

    /// Bore for the shaft, with its keyway. The keyway is omitted if the standard has no keyway for the diameter of the bore. `None` without a
    /// bore.
    pub fn hole(&self) -> Option<Bore> {
        let diameter = self.bore?;
        let keyway = self.keyway.and_then(|spec| match spec {
            KeywaySpec::Auto => Keyway::for_shaft(diameter),
            KeywaySpec::Width(width) => Keyway::of_width(width),
        });
        Some(Bore { diameter, keyway })
    }
}

/// Second cam of a conjugate pair. Exactly one of the first three dimensions must be given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ConjugateSpec {
    /// Distance between the two faces or the two roller centres of translating followers, m.
    pub distance: Option<f64>,
    /// Angle between the two arms of an oscillating follower, rad.
    pub angle: Option<f64>,
    /// Base radius of the second cam, m.
    pub base_radius: Option<f64>,
    /// Radius of the second roller, m; `None`: the radius of the first roller.
    pub roller_radius: Option<f64>,
}

impl ConjugateSpec {
    /// Dimension that determines the pair; `None` unless exactly one dimension is given.
    pub fn closure(&self) -> Option<Closure> {
        match (self.distance, self.angle, self.base_radius) {
            (Some(distance), None, None) => Some(Closure::Distance(distance)),
            (None, Some(angle), None) => Some(Closure::Angle(angle)),
            (None, None, Some(base)) => Some(Closure::SecondBaseRadius(base)),
            _ => None,
        }
    }
}

impl CamSpec {
    /// Whether the follower oscillates, so that its law is in rad.
    pub fn is_oscillating(&self) -> bool {
        self.follower.is_oscillating()
    }

    /// Kind of motion of cam and follower, which determines the units of the law.
    pub fn measures(&self) -> Measures {
        self.follower.measures()
    }

    /// Whether the cam translates, so that its law is a function of the travel in m.
    pub fn is_straight(&self) -> bool {
        self.follower == FollowerKind::TranslatingCam
    }
}
