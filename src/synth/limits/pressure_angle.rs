//! Limits on the pressure angle during rise and fall.

use std::f64::consts::FRAC_PI_2;

use super::finished::GEOMETRY;
use super::slack::Slack;
use crate::cam::{Check, Criterion, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::poly::Extreme;
use crate::problem::Problem;
use crate::synth::qp::{Limit, Meaning, OFFSET, RISE, structural};

/// Pressure angle, rad, that replaces a missing limit where a finite tangent is needed.
pub const NEARLY_RIGHT: f64 = FRAC_PI_2 - 1e-3;

/// Limits on the pressure angle during rise and fall, in this order.
pub const SIDES: [LimitKind; 2] = [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall];
/// Sign of v − e at which the limit of the same index in [`SIDES`] applies.
const SIGNS: [f64; 2] = [1.0, -1.0];

/// Linear constraint on the pressure angle of one side: `side`·(m v − e) ≤ `tan`·(s + D). Here v = ds/dθ is the slope of the lift s, e is the
/// offset, and D is the height of the roller centre at s = 0. The constraint with m = 1 limits the pressure angle over the whole turn. The
/// constraint with m = 0 is the condition at a reversal of the follower (v = 0).
///
/// While the follower moves in the direction of a side (rise or fall), the constraint of this side limits |φ|. At a reversal both limits
/// apply, so that |e| ≤ tan φ·(s + D) with the smaller tangent. Between the reversals, a pressure angle φ of the opposite sign is therefore
/// within its limit too.
#[derive(Debug, Clone, Copy)]
pub struct AngleRow {
    /// Name of the limit.
    pub name: LimitKind,
    /// Tangent of the permitted pressure angle.
    pub tan: f64,
    /// Sign of the side: +1 if the constraint is an upper limit on the velocity, −1 if it is a lower limit.
    pub side: f64,
    /// Whether the factor m of the velocity is 1; otherwise m is 0.
    pub moves: bool,
}

/// Constraints for the limits on rise and fall, given as tangents. Each limit gives a constraint with m = 1 for its own direction of motion.
/// The smaller limit, or the only one, also gives a constraint with m = 0 for the other direction (see [`AngleRow`]).
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
    /// The constraint as a limit of the convex program for a translating roller, with the length scale `scale`, m. The caller adds size and
    /// offset to the limit.
    fn limit(self, scale: f64) -> Limit {
        let velocity = if self.moves { self.side } else { 0.0 };
        structural(self.name, [-self.tan, velocity, 0.0, 0.0, 0.0], 0.0, scale)
    }

    /// The limit for a prime circle of radius `prime` and the offset `e`, m.
    fn on_circle(self, prime: f64, e: f64) -> Limit {
        let (tan, offset) = (self.tan, self.side * e);
        let rise = (prime * prime - e * e).max(0.0).sqrt();
        let mut limit = self.limit(prime);
        limit.bound = tan * rise + offset;
        Meaning::PrimeRadius { tan, offset }.of(limit)
    }

    /// The limit with the height D as a variable. The offset e is a variable too if it is not given.
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

/// Limits ±(v − e) ≤ tan φ·(s + D) of a problem (theory §6). Either the prime circle is given, or D is a variable (`is_sized`). In the second
/// case, e is also a variable if the offset is free.
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

/// Clearance h = t c sin ξ ∓ (A(1 + m ξ′) − c cos ξ) of the pressure-angle limit for a roller on an arm. Here t is the tangent of the
/// permitted angle, A the arm length, c the pivot distance, and ξ the arm angle. The factor m is defined at [`AngleRow`].
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

/// Default bounds of the pressure angle, rad, for a side without a limit. The first bound applies to any machine, the second bound only to
/// slow machines. The values are taken from CAM-DAS (Serrano Muñoz 2010). `None` for a flat face, or if the scene switches the check off.
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

/// Checks of the pressure angle of the finished cam during rise and fall, against the limits of the scene or the default bounds.
pub fn checks(problem: &Problem, worst: [Extreme; 2]) -> Vec<Check> {
    let usual = usual_pressure_angle(problem).map(|[_, slow]| slow);
    (SIDES.into_iter().zip(worst))
        .filter_map(|(name, worst)| {
            let limit = problem.limits[name].or(usual)?;
            Some(Check::of(name, worst, limit, GEOMETRY))
        })
        .collect()
}

/// Whether a check refers to a side (rise or fall) without a limit in the scene. The check may be of either cam of a pair.
pub fn is_usual(problem: &Problem, check: Criterion) -> bool {
    let open = SIDES
        .into_iter()
        .filter(|side| problem.limits[*side].is_none());
    let mut names = open
        .map(Criterion::from)
        .flat_map(|side| [side, side.of_second_cam()]);
    names.any(|name| name == check)
}
