//! Limits on the pressure angle on rise and fall.

use std::f64::consts::FRAC_PI_2;

use super::finished::GEOMETRY;
use super::slack::Slack;
use crate::cam::{Check, Criterion, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Limit, Meaning, OFFSET, RISE, structural};

/// Pressure angle in place of no limit, for code that needs its tangent.
pub const NEARLY_RIGHT: f64 = FRAC_PI_2 - 1e-3;

/// Limits on rise and fall, in this order.
pub const SIDES: [LimitKind; 2] = [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall];
/// Sign of the velocity minus the offset for which the limit of the same index in [`SIDES`] is active.
const SIGNS: [f64; 2] = [1.0, -1.0];

/// Linear constraint on the pressure angle of one side: `side`·(m v − e) ≤ `tan`·(s + D). m = 1 over the whole turn; m = 0 at a reversal of the
/// follower (v = 0).
///
/// While the follower moves in the direction of a side, the constraint of this side limits |φ|. At a reversal both limits hold, so that |e| ≤ tan
/// φ·(s + D) with the smaller tangent. With these constraints, φ of the opposite sign is within its limit between reversals too.
#[derive(Debug, Clone, Copy)]
pub struct AngleRow {
    /// Name of the limit.
    pub name: LimitKind,
    /// Tangent of the allowed angle.
    pub tan: f64,
    /// Sign of the side: +1 if a larger velocity is limited, −1 if a smaller one is.
    pub side: f64,
    /// Whether the factor m of the velocity is 1; otherwise it is 0.
    pub moves: bool,
}

/// Constraints for limits on rise and fall. Each limit results in the constraint of its side (m = 1). The smaller tangent also results in a
/// constraint with m = 0 for the reversal on the other side.
pub fn angle_rows(tangents: [Option<f64>; 2]) -> Vec<AngleRow> {
    let row = |name: LimitKind, tan: f64, side: f64, moves: bool| AngleRow {
        name,
        tan,
        side,
        moves,
    };
    let mut out = Vec::new();
    for (i, tan) in tangents.into_iter().enumerate() {
        out.extend(tan.map(|tan| row(SIDES[i], tan, SIGNS[i], true)));
        let other = tangents[1 - i];
        if let Some(tan) = tan.filter(|tan| other.is_none_or(|other| *tan < other)) {
            out.push(row(SIDES[i], tan, SIGNS[1 - i], false));
        }
    }
    out
}

impl AngleRow {
    /// Row for a roller on a translating follower, with the lift scaled to `scale` and the bound without size and offset.
    fn limit(self, scale: f64) -> Limit {
        let velocity = if self.moves { self.side } else { 0.0 };
        structural(self.name, [-self.tan, velocity, 0.0, 0.0, 0.0], 0.0, scale)
    }

    /// Row on a prime circle of given radius and offset.
    fn on_circle(self, prime: f64, e: f64) -> Limit {
        let (tan, offset) = (self.tan, self.side * e);
        let rise = (prime * prime - e * e).max(0.0).sqrt();
        let mut limit = self.limit(prime);
        limit.bound = tan * rise + offset;
        Meaning::PrimeRadius { tan, offset }.of(limit)
    }

    /// Row with D, and e if it is free, among the variables.
    fn sized(self, length: f64, offset: Option<f64>) -> Limit {
        let mut limit = Meaning::PressureAngle.of(self.limit(length));
        limit.bound = self.side * offset.unwrap_or(0.0);
        limit.extra[RISE] = -self.tan;
        if offset.is_none() {
            limit.extra[OFFSET] = -self.side;
        }
        limit
    }
}

/// Rows ±(v − e) ≤ tan φ·(s + D) (theory §6), on a given prime circle or with D, and e if it is free, among the variables (`is_sized`).
pub fn rows(problem: &Problem, is_sized: bool) -> Vec<Limit> {
    let kind = problem.cam.follower;
    let prime = problem.prime_radius();
    if !(is_sized || prime.is_some()) || !kind.is_translating() || kind.is_flat() {
        return Vec::new();
    }
    let (tangents, offset) = match prime {
        Some(_) => {
            let angles = problem.limits.pressure_angles();
            let given = problem.cam.offset.unwrap_or(0.0);
            (angles.map(|side| side.map(libm::tan)), Some(given))
        }
        None => {
            let angles = problem.sizing_pressure_angles();
            let tangent = |angle: f64| Some(libm::tan(angle.min(NEARLY_RIGHT)));
            (angles.map(tangent), problem.offset())
        }
    };
    // For a line of motion through the centre, the pressure angle is zero at a reversal of the follower.
    let rows = angle_rows(tangents).into_iter();
    let rows = rows.filter(|row| row.moves || offset != Some(0.0));
    let row_of = |row: AngleRow| match prime {
        Some(prime) => row.on_circle(prime, offset.unwrap_or(0.0)),
        None => row.sized(problem.length(), offset),
    };
    rows.map(row_of).collect()
}

/// Clearance of a roller on an arm: t c sin ξ ∓ (A(1 + ξ′) − c cos ξ),
pub fn arm_slack(at: Svaj, c: f64, arm: f64, rest: f64, row: AngleRow) -> Slack {
    let (sin, cos) = libm::sincos(rest + at.s);
    let (tan, side) = (row.tan, row.side);
    let moves = if row.moves { 1.0 } else { 0.0 };
    Slack {
        h: tan * c * sin - side * (arm * (1.0 + moves * at.v) - c * cos),
        w: c,
        largest: tan * c + arm,
        by_lift: tan * c * cos - side * c * sin,
        by_velocity: -side * moves * arm,
        ..Slack::none(row.name)
    }
}

/// Default bounds of the pressure angle on a side without a limit, for any machine and for slow ones: those of CAM-DAS (Serrano Muñoz 2010). A flat
/// face has none.
pub fn usual_pressure_angle(problem: &Problem) -> Option<[f64; 2]> {
    if problem.limits.unjudged.pressure_angle {
        return None;
    }
    let any_machine: f64 = match problem.cam.follower {
        FollowerKind::FlatTranslating | FollowerKind::FlatOscillating => return None,
        FollowerKind::RollerOscillating
        | FollowerKind::KnifeOscillating
        | FollowerKind::MushroomOscillating => 35.0,
        FollowerKind::RollerTranslating
        | FollowerKind::KnifeTranslating
        | FollowerKind::MushroomTranslating
        | FollowerKind::TranslatingCam
        | FollowerKind::Barrel => 30.0,
    };
    Some([any_machine, 45.0].map(f64::to_radians))
}

/// Check of the finished cam's pressure angle on rise and fall with the limits or default bounds.
pub fn checks(problem: &Problem, worst: [Extreme; 2]) -> Vec<Check> {
    let usual = usual_pressure_angle(problem).map(|[_, slow]| slow);
    (SIDES.into_iter().zip(worst))
        .filter_map(|(name, worst)| {
            let limit = problem.limits[name].or(usual)?;
            Some(Check::of(name, worst, limit, GEOMETRY))
        })
        .collect()
}

/// Whether a check is for a side without a limit in the scene, on either cam.
pub fn is_usual(problem: &Problem, check: Criterion) -> bool {
    let open = SIDES
        .into_iter()
        .filter(|side| problem.limits[*side].is_none());
    let mut names = open
        .map(Criterion::from)
        .flat_map(|side| [side, side.of_second_cam()]);
    names.any(|name| name == check)
}
