//! Lift of a follower and the slope of the lift, from a given contact point.

use crate::cam::{Arm, Follower, Geometry, ProfilePoint};

/// Whether a contact point determines the slope of the lift; false for a knife edge.
pub fn slopes_known(follower: &Follower) -> bool {
    follower.is_flat() || follower.roller_radius() > 0.0
}

/// Lift above the base circle (prime circle), m (rad for an arm), and slope of the lift for a contact at `point`. `None` if the follower
/// cannot reach the point. A contact point does not determine the slope of a knife edge, which is returned as 0.
pub fn height_and_slope(follower: &Follower, point: &ProfilePoint) -> Option<(f64, f64)> {
    let frame = Geometry::new(follower).frame(point.theta);
    let p = frame.in_space([point.x, point.y]);
    let radius = follower.roller_radius();
    let (height, slope) = match *follower {
        Follower::FlatTranslating { base_radius } => (p[1] - base_radius, p[0]),
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            ..
        } => swung_face(follower, p, pivot_distance, face_offset)?,
        Follower::RollerTranslating { .. } | Follower::MushroomTranslating { .. } => {
            above(p, follower.offset(), radius, follower.start_height())
        }
        Follower::RollerOscillating { .. } | Follower::MushroomOscillating { .. } => {
            on_arm(follower, p)?
        }
        Follower::TranslatingCam { base_height, .. } => {
            unrolled(p, base_height + radius, radius, 1.0)
        }
        Follower::Barrel { radius: scale, .. } => unrolled(p, 0.0, radius, scale),
    };
    (height.is_finite() && slope.is_finite()).then_some((height, slope))
}

/// Lift and slope of a translating follower with a roller or arc that touches the profile at `p`. The centre of the circle is above `p` on
/// the line x = e, with the offset e. The vector (side, up) from `p` to the centre is perpendicular to the tangent of the pitch curve. With
/// the height Y of the centre, this condition is Y·side + (Y′ − e)·up = 0.
fn above(p: [f64; 2], offset: f64, radius: f64, rest: f64) -> (f64, f64) {
    if radius == 0.0 {
        return (p[1] - rest, 0.0);
    }
    let side = offset - p[0];
    let up = (radius * radius - side * side).sqrt();
    let centre = p[1] + up;
    (centre - rest, offset - centre * side / up)
}

/// Lift and slope of a follower with a roller or arc of radius Rf on a translating cam or a barrel. The vector from the centre of the
/// circle to the contact is (q, −1)·Rf/√(1 + q²), with the slope q of the pitch curve in the unrolled plane.
fn unrolled(p: [f64; 2], rest: f64, radius: f64, scale: f64) -> (f64, f64) {
    if radius == 0.0 {
        return (p[1] - rest, 0.0);
    }
    let up = (radius * radius - p[0] * p[0]).sqrt();
    (p[1] + up - rest, scale * p[0] / up)
}

/// Lift ξ − ξ₀, rad, and slope dξ/dθ of an arm with a roller or arc that touches the profile at `p`. The arm is at the angle ξ, and at ξ₀
/// on the prime circle. The centre C is at the arm length from the pivot and at the roller radius from `p`. Of the two solutions, the one
/// with the larger ξ is used. The slope is (J·C)·n/(C′·n), with the contact normal n, C′ = dC/dξ, and J the rotation by 90°.
fn on_arm(follower: &Follower, p: [f64; 2]) -> Option<(f64, f64)> {
    let Arm { pivot, length: arm } = follower.arm()?;
    let side = pivot.signum();
    let radius = follower.roller_radius();
    let away = [-side * (p[0] - pivot), p[1]];
    let far = libm::hypot(away[0], away[1]);
    let (gap, sum) = (arm - far, arm + far);
    // Triangle of pivot, contact and centre: tan(δ/2), without the cancellation of an arc cosine.
    let open = ((radius - gap) * (radius + gap)).max(0.0) / ((sum - radius) * (sum + radius));
    if (radius - gap.abs()) < -1e-12 * arm {
        return None;
    }
    let angle = libm::atan2(away[1], away[0]) + 2.0 * libm::atan(open.sqrt());
    let (sin, cos) = libm::sincos(angle);
    let centre = [pivot - side * arm * cos, arm * sin];
    let normal = [centre[0] - p[0], centre[1] - p[1]];
    let across = centre[0] * normal[1] - centre[1] * normal[0];
    let along = arm * (side * sin * normal[0] + cos * normal[1]);
    let slope = if radius > 0.0 { across / along } else { 0.0 };
    Some((angle - follower.start_angle()?, slope))
}

/// Lift ξ − ξ₀, rad, and slope dξ/dθ of an arm with a flat face that touches the profile at P = `p`. The arm is at the angle ξ, and at ξ₀
/// on the base circle. The angle ξ satisfies (P − pivot)·n = f, with the face offset f, the normal n = (σ sin ξ, cos ξ), and σ = ±1 for a
/// pivot at ±x. Along the face, the contact is at −σ c cos ξ·v/(1 + v) from the foot of the perpendicular from the cam centre. Here c is
/// the distance from the cam centre to the pivot, and v = σ dξ/dθ.
fn swung_face(follower: &Follower, p: [f64; 2], pivot: f64, offset: f64) -> Option<(f64, f64)> {
    let (c, side) = (pivot.abs(), pivot.signum());
    let away = [side * p[0] - c, p[1]];
    let angle = libm::atan2(away[0], away[1]) + libm::acos(offset / libm::hypot(away[0], away[1]));
    let (sin, cos) = libm::sincos(angle);
    let along = side * sin * p[1] - cos * p[0];
    let part = -side * along / (c * cos);
    Some((angle - follower.start_angle()?, side * part / (1.0 - part)))
}
