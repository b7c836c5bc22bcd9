//! Size of the cam in a problem.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Problem;
use crate::cam::Bore;
use crate::law::Law;
use crate::scene::{CamSpec, LimitKind, Limits, Minimise};

/// Fraction of the range of prime radii that is excluded at each end of the range, for oscillating followers.
const STRETCHED: f64 = 1e-4;

impl Problem {
    /// Method that determines the size of the cam.
    pub fn size(&self) -> Size {
        match self.cam.given_radii() {
            Some([base, prime]) => Size::Given { base, prime },
            None if self.size_is_wanted() => Size::Sought,
            None => Size::AfterLaw,
        }
    }

    /// Radius of the prime circle, m; `None` if the size is not given.
    pub fn prime_radius(&self) -> Option<f64> {
        match self.size() {
            Size::Given { prime, .. } => Some(prime),
            Size::Sought | Size::AfterLaw => None,
        }
    }

    /// Radius of the base circle, m; `None` if the size is not given.
    pub fn base_radius(&self) -> Option<f64> {
        match self.size() {
            Size::Given { base, .. } => Some(base),
            Size::Sought | Size::AfterLaw => None,
        }
    }

    /// Whether the size is a variable of the program, because the objective or a limit depends on it.
    fn size_is_wanted(&self) -> bool {
        let priced = match self.objective() {
            Minimise::Size => true,
            _ => [LimitKind::PrimeRadius, LimitKind::Diameter]
                .iter()
                .any(|kind| self.limits[*kind].is_some()),
        };
        // If the given dimensions permit no size, the size is not a variable. The search for the size after the law then reports the error.
        let limit = self.limits[LimitKind::PrimeRadius].unwrap_or(f64::INFINITY);
        let has_room = |[least, most]: [f64; 2]| least < most.min(limit);
        priced
            && self.cam.follower.has_size_beside_law()
            && self.reach_of_arm().is_none_or(has_room)
    }

    /// Minimum and maximum radius of the prime circle for an oscillating follower, m. In this range, the pivot is outside the prime circle
    /// and the follower reaches this circle. `None` for other followers.
    pub fn reach_of_arm(&self) -> Option<[f64; 2]> {
        let swings = self.cam.follower.is_oscillating();
        let pivot = self.cam.pivot_distance.filter(|_| swings)?;
        let [least, most] = if self.cam.follower.is_flat() {
            [0.0, pivot + self.cam.face_offset]
        } else {
            let arm = self.cam.arm?;
            [(pivot - arm).abs(), pivot + arm]
        };
        let least = least.max(self.outside_bore() + self.cam.roller_radius);
        let most = most.min(pivot);
        // If the arm points at the cam centre, its angle has no derivative with respect to the radius. This can occur at the ends of the
        // range.
        let room = STRETCHED * (most - least);
        Some([least + room, most - room])
    }

    /// Offset of the follower's line of motion, m; `None` if the design determines it. The default for a mushroom follower is 0.
    pub fn offset(&self) -> Option<f64> {
        let usual = self.cam.follower.is_mushroom().then_some(0.0);
        self.cam.offset.or(usual)
    }

    /// Length by which the law is multiplied to give a length in m. It is the pivot distance, m, for an oscillating follower and 1
    /// otherwise.
    pub fn lever(&self) -> f64 {
        let swings = self.cam.follower.is_oscillating();
        let pivot = self.cam.pivot_distance.filter(|_| swings);
        pivot.map_or(1.0, f64::abs)
    }

    /// Minimum base radius with a sufficient wall around the bore, m; 0 without a bore.
    pub fn outside_bore(&self) -> f64 {
        self.cam.hole().map_or(0.0, |hole| hole.least_base_radius())
    }

    /// Lower bound of a base radius that the design determines, m, before the law is computed.
    pub fn hub_radius(&self) -> f64 {
        hub_radius(&self.cam, &self.limits, None)
    }

    /// Lower bound of a base radius that the design determines for a law, m. It leaves the wall of a hub around the bore.
    pub fn hub_radius_for(&self, law: &Law) -> f64 {
        let translates = self.cam.follower.is_translating();
        let highest = translates.then(|| law.extremes(0).1.value);
        hub_radius(&self.cam, &self.limits, highest)
    }

    /// Maximum pressure angles during rise and fall that determine the size of the cam, rad. They are the limits of the scene. For a flat
    /// face, a missing limit is 90°. It is also 90° if the scene limits only the other direction and switches off the default limit.
    /// Otherwise it is 30°.
    pub fn sizing_pressure_angles(&self) -> [f64; 2] {
        let sides = self.limits.pressure_angles();
        let one_alone = sides[0].is_some() != sides[1].is_some();
        let is_free = self.limits.unjudged.pressure_angle && one_alone;
        let usual = if is_free || self.cam.follower.is_flat() {
            FRAC_PI_2
        } else {
            USUAL_PRESSURE_ANGLE
        };
        sides.map(|side| side.unwrap_or(usual))
    }
}

/// Default maximum pressure angle that determines the size of a cam, rad. 30° is a common rule.
pub const USUAL_PRESSURE_ANGLE: f64 = PI / 6.0;

/// Method that determines the size of the cam. For a flat face, base and prime circle coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Size {
    /// The size is fixed, and the law must fit it.
    Given {
        /// Radius of the fixed base circle, m.
        base: f64,
        /// Radius of the fixed prime circle, m.
        prime: f64,
    },
    /// Size and law are variables of the same program. The size is minimised or limited.
    Sought,
    /// The law is determined first. The size is then the minimum size for this law.
    AfterLaw,
}

/// Lower bound of a base radius that the design determines, m. It leaves the wall of a hub around the bore, if the limits on prime radius
/// and diameter permit this wall. `highest` is the maximum lift, m. If it is `None` and the diameter is limited, the bound leaves only the
/// minimum wall around the bore.
pub(crate) fn hub_radius(cam: &CamSpec, limits: &Limits, highest: Option<f64>) -> f64 {
    let of_prime = limits[LimitKind::PrimeRadius].map_or(f64::INFINITY, |r| r - cam.roller_radius);
    let of_diameter = match (limits[LimitKind::Diameter], highest) {
        (None, _) => f64::INFINITY,
        (Some(diameter), Some(highest)) => 0.5 * diameter - highest,
        (Some(_), None) => 0.0,
    };
    let most = of_prime.min(of_diameter);
    let hub = |hole: Bore| hole.hub_radius().min(most).max(hole.least_base_radius());
    cam.hole().map_or(0.0, hub)
}
