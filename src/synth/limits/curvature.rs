//! Limits and checks of the profile of the finished cam: minimum convex radius of curvature, undercut, roller in concave parts, and
//! interference.

use super::finished::GEOMETRY;
use super::slack::{ProfileSize, Slack};
use crate::cam::{Body, Cam, Check, Criterion, Follower, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Limit, Meaning, RADIUS, structural};

/// Number of profile points for the interference check.
const INTERFERENCE_POINTS: usize = 360;
/// Depth of interference, relative to the prime radius, up to which the interference counts as a rounding error.
const TOUCH: f64 = 1e-6;
/// Weights of a limit on −(s + a), with the lift s and its second derivative a. The radius of curvature under a flat face is Rb + s + a
/// (theory §6).
const BEND: [f64; 5] = [-1.0, 0.0, -1.0, 0.0, 0.0];

/// Limit Rb + s + a ≥ ρ for a flat face. The base radius Rb is given, or it is a variable of the program (`is_sized`).
pub fn row(problem: &Problem, is_sized: bool) -> Option<Limit> {
    let rho = problem.limits[LimitKind::Curvature];
    let (base, rho, scale) = if is_sized {
        (0.0, rho.unwrap_or(0.0), problem.length())
    } else {
        let base = problem.base_radius()?;
        (base, rho?, base)
    };
    let meaning = Meaning::Value {
        factor: -1.0,
        offset: base,
    };
    let limit = structural(LimitKind::Curvature, BEND, base - rho, scale);
    let mut limit = meaning.of(limit);
    if is_sized {
        limit.extra[RADIUS] = -1.0;
    }
    (problem.cam.follower == FollowerKind::FlatTranslating).then_some(limit)
}

/// Clearance h = w^{3/2}/ρ − (w + vY − aX) of the curvature limit for a translating roller, with X = D + s, Y = v − e and w = X² + Y²
/// (symbols as in `slack`).
pub fn roller_slack(at: Svaj, size: ProfileSize) -> Slack {
    let (x, y) = (size.rise + at.s, at.v - size.offset);
    let w = x * x + y * y;
    let root = w.sqrt();
    let by_x = 3.0 * x * root / size.rho - (2.0 * x - at.a);
    let by_y = 3.0 * y * root / size.rho - (2.0 * y + at.v);
    Slack {
        h: w * root / size.rho - (w + at.v * y - at.a * x),
        w,
        largest: w * root / size.rho,
        by_lift: by_x,
        by_rise: by_x,
        by_velocity: by_y - y,
        by_acceleration: x,
        by_offset: -by_y,
        ..Slack::none(LimitKind::Curvature)
    }
}

/// Clearance h = W^{3/2}/ρ − K of the curvature limit for a roller on an arm. Here ρ is the minimum radius of curvature of the pitch curve,
/// A the arm length, c the pivot distance, ξ the arm angle, and q = 1 + ξ′. The terms are W = A²q² − 2cAq cos ξ + c² and K = A²q³ − cAq(1 +
/// q) cos ξ − cAξ″ sin ξ + c².
pub fn arm_slack(at: Svaj, c: f64, arm: f64, rest: f64, rho: f64) -> Slack {
    let (sin, cos) = libm::sincos(rest + at.s);
    let (s, p, q) = (arm * sin, arm * cos, 1.0 + at.v);
    let w = arm * arm * q * q - 2.0 * c * p * q + c * c;
    let k = arm * arm * q.powi(3) - c * p * q * (1.0 + q) - c * s * at.a + c * c;
    let root = w.sqrt();
    let by_w = 1.5 * root / rho;
    Slack {
        h: w * root / rho - k,
        w,
        largest: w * root / rho,
        by_lift: by_w * 2.0 * c * s * q - (c * s * q * (1.0 + q) - c * p * at.a),
        by_velocity: by_w * (2.0 * arm * arm * q - 2.0 * c * p)
            - (3.0 * arm * arm * q * q - c * p * (1.0 + 2.0 * q)),
        by_acceleration: c * s,
        ..Slack::none(LimitKind::Curvature)
    }
}

/// Clearance h = (ρ_face − ρ) q³ of a flat face on an arm, with the face angle ξ and q = 1 + ξ′. The minimum permitted radius is ρ. The
/// radius of curvature ρ_face is defined in theory §6 and includes the offset of the face.
pub fn face_slack(at: Svaj, c: f64, offset: f64, rest: f64, rho: f64) -> Slack {
    let (sin, cos) = libm::sincos(rest + at.s);
    let q = 1.0 + at.v;
    let twice = 2.0 * q - 1.0;
    let room = offset - rho;
    Slack {
        h: c * sin * twice * q + c * cos * at.a + room * q.powi(3),
        w: c,
        largest: c * sin * (twice * q).abs() + (room * q.powi(3)).abs(),
        by_lift: c * cos * twice * q - c * sin * at.a,
        by_velocity: c * sin * (4.0 * q - 1.0) + 3.0 * room * q * q,
        by_acceleration: c * cos,
        ..Slack::none(LimitKind::Curvature)
    }
}

/// Checks of the convex and concave radii of curvature of a profile. A negative convex radius always fails the check, because the profile
/// then intersects itself.
pub fn checks(problem: &Problem, cam: &Cam) -> Vec<Check> {
    let curvature = cam.curvature();
    let wanted = problem.limits[LimitKind::Curvature].unwrap_or(0.0);
    let mut convex = Check::of(LimitKind::Curvature, curvature.convex, wanted, GEOMETRY);
    // On the smallest cam with a permitted cusp, the radius of curvature is zero up to rounding errors relative to the size of the cam.
    let rounding = GEOMETRY * cam.follower.prime_radius();
    convex.pass |= wanted == 0.0 && curvature.convex.value.abs() <= rounding;
    convex.pass &= !curvature.undercut || curvature.convex.value.abs() <= rounding;
    let mut out = vec![convex];
    let roller = cam.follower.roller_radius();
    if let Some(concave) = curvature.concave.filter(|_| roller > 0.0) {
        // The roller must fit into the concave part: |ρ_cam| ≥ R_f.
        let worst = concave.map(|radius| -radius);
        out.push(Check::of(Criterion::Concave, worst, roller, GEOMETRY));
    }
    out
}

/// Check of the interference of roller or face with other parts of the profile. `None` if interference is impossible, as for a translating
/// flat face on a convex cam. `None` also for a barrel and for an undercut profile.
pub fn interference(cam: &Cam) -> Option<Check> {
    match cam.follower {
        Follower::FlatTranslating { .. } | Follower::Barrel { .. } => return None,
        _ if cam.curvature().undercut => return None,
        _ => {}
    }
    let tolerance = TOUCH * cam.follower.prime_radius();
    let deepest = cam
        .interference(INTERFERENCE_POINTS, 0.0, tolerance)
        .into_iter()
        .filter(|i| i.body != Body::Arm)
        .max_by(|a, b| a.depth.total_cmp(&b.depth));
    let (at, value) = deepest.map_or((cam.law.extent().0, 0.0), |i| (i.at, i.depth));
    let worst = Extreme { at, value };
    let mut check = Check::of(Criterion::Interference, worst, tolerance, 0.0);
    check.pass = deepest.is_none();
    Some(check)
}
