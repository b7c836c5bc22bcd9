//! Rows of `[law]`: what the law may be.

use super::kind::{Idle, Kind, Measure, Range};
use super::row::{Access, Key, entry, given_entry, number, optional_entry, other, plain};
use super::value::Value;
use crate::law::Rise;
use crate::scene::{Family, Minimise, Scene, Weigh};
use crate::units::Dimension as D;

/// Most spans of a spline: beyond this the law is a table, not a law.
const MOST_SPANS: usize = 10_000;
/// Highest degree of a polynomial.
const HIGHEST_DEGREE: usize = 30;
/// Most harmonics.
const MOST_HARMONICS: usize = 400;

/// Lift and its derivatives by the cam's angle.
const fn lift(order: u8) -> Measure {
    match order {
        0 => Measure::by_arm(D::Length, D::Angle),
        n => Measure::by_arm(D::LengthPerAngle(n), D::AnglePerAngle(n)),
    }
}

/// Why a key does nothing, unless the family is one of `families`.
fn unless(scene: &Scene, families: &[Family]) -> Option<Idle> {
    (!families.contains(&scene.law.family)).then_some(Idle::Family)
}

const FITTED: [Family; 3] = [Family::Auto, Family::Ladder, Family::Spline];

fn fitted(scene: &Scene) -> Option<Idle> {
    unless(scene, &FITTED)
}

fn fitted_or_polynomial(scene: &Scene) -> Option<Idle> {
    fitted(scene).filter(|_| scene.law.family != Family::Polynomial)
}

fn program(scene: &Scene) -> Option<Idle> {
    unless(scene, &[Family::Program])
}

/// The weights of the objective, made where they are missing.
fn weigh(scene: &mut Scene) -> &mut Weigh {
    if !matches!(scene.law.minimise, Some(Minimise::Weighed(_))) {
        scene.law.minimise = Some(Minimise::Weighed(Weigh::default()));
    }
    match &mut scene.law.minimise {
        Some(Minimise::Weighed(weigh)) => weigh,
        _ => unreachable!("it was set above"),
    }
}

/// Access to one weight of the objective.
macro_rules! weigh {
    ($field:ident) => {
        Access {
            get: |s, _| match s.law.minimise? {
                Minimise::Weighed(weigh) => weigh.$field.map(Value::Number),
                _ => None,
            },
            set: |s, _, v| {
                weigh(s).$field = v.number();
                Ok(())
            },
        }
    };
}

/// Access to an optional count.
macro_rules! count {
    ($field:ident) => {
        Access {
            get: |s, _| s.law.$field.map(Value::Count),
            set: |s, _, v| {
                s.law.$field = v.count();
                Ok(())
            },
        }
    };
}

/// Access to a truth value.
macro_rules! flag {
    ($field:ident) => {
        Access {
            get: |s, _| Some(Value::Flag(s.law.$field)),
            set: |s, _, v| {
                s.law.$field = v == Value::Flag(true);
                Ok(())
            },
        }
    };
}

/// A number that an entry of a list may leave out.
const fn part(path: &'static str, measure: Measure, access: Access) -> Key {
    number(path, measure, Range::Any, access).default("")
}

pub static ROWS: &[Key] = &[
    other(
        "law.family",
        Kind::Choice(|| Family::NAMES.map(|n| n.0).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.law.family.name().to_string())),
            set: |s, _, v| {
                let word = v.text();
                if let Some((_, family)) = Family::NAMES.into_iter().find(|n| n.0 == word) {
                    s.law.family = family;
                }
                Ok(())
            },
        },
    ),
    other("law.degree", Kind::Count(1, HIGHEST_DEGREE), count!(degree))
        .default("auto")
        .idle_when(fitted_or_polynomial),
    other("law.spans", Kind::Count(1, MOST_SPANS), count!(spans))
        .default("auto")
        .idle_when(fitted),
    other(
        "law.harmonics",
        Kind::Count(1, MOST_HARMONICS),
        count!(harmonics),
    )
    .default("auto")
    .idle_when(|s| unless(s, &[Family::Auto, Family::Ladder, Family::Harmonic])),
    other(
        "law.minimise",
        Kind::Choice(|| Minimise::NAMES.map(|n| n.0).to_vec()),
        Access {
            get: |s, _| {
                let found = Minimise::NAMES
                    .into_iter()
                    .find(|n| Some(n.1) == s.law.minimise);
                found.map(|n| Value::Text(n.0.to_string()))
            },
            set: |s, _, v| {
                let word = v.text();
                let found = Minimise::NAMES.into_iter().find(|n| n.0 == word);
                s.law.minimise = found.map(|n| n.1);
                Ok(())
            },
        },
    )
    .idle_when(fitted),
    plain(
        "law.weigh.force_error",
        D::Percent,
        Range::Positive,
        weigh!(force_error),
    )
    .default("")
    .read_again()
    .idle_when(fitted),
    plain(
        "law.weigh.prime_radius",
        D::Length,
        Range::Positive,
        weigh!(prime_radius),
    )
    .default("")
    .read_again()
    .idle_when(fitted),
    number(
        "law.weigh.jerk",
        Measure::by_arm(D::Jerk, D::AngularJerk),
        Range::Positive,
        weigh!(jerk),
    )
    .default("")
    .read_again()
    .idle_when(fitted),
    other("law.monotone", Kind::Flag, flag!(monotone))
        .default("false")
        .idle_when(fitted),
    other("law.polydyne", Kind::Flag, flag!(polydyne)).default("false"),
    number(
        "law.point.N.angle",
        Measure::same(D::Angle),
        Range::Any,
        given_entry!(law.points, angle),
    )
    .default("")
    .required()
    .idle_when(fitted_or_polynomial),
    part(
        "law.point.N.lift",
        lift(0),
        optional_entry!(law.points, lift),
    ),
    part(
        "law.point.N.force",
        Measure::same(D::Force),
        optional_entry!(law.points, force),
    ),
    part(
        "law.point.N.velocity",
        lift(1),
        optional_entry!(law.points, velocity),
    ),
    part(
        "law.point.N.acceleration",
        lift(2),
        optional_entry!(law.points, acceleration),
    ),
    part(
        "law.point.N.jerk",
        lift(3),
        optional_entry!(law.points, jerk),
    ),
    part(
        "law.dwell.N.from",
        Measure::same(D::Angle),
        given_entry!(law.dwells, from),
    )
    .required()
    .idle_when(fitted),
    part(
        "law.dwell.N.to",
        Measure::same(D::Angle),
        given_entry!(law.dwells, to),
    )
    .required(),
    part(
        "law.dwell.N.lift",
        lift(0),
        optional_entry!(law.dwells, lift),
    ),
    other(
        "law.segment.N.motion",
        Kind::Text,
        Access {
            get: |s, i| Some(Value::Text(s.law.segments.get(i)?.motion.written())),
            set: |s, i, v| {
                entry(&mut s.law.segments, i).motion = Rise::from_name(&v.text())?;
                Ok(())
            },
        },
    )
    .default("dwell"),
    part(
        "law.segment.N.lift",
        lift(0),
        given_entry!(law.segments, lift),
    )
    .default("0"),
    number(
        "law.segment.N.angle",
        Measure::same(D::Angle),
        Range::Positive,
        given_entry!(law.segments, angle),
    )
    .default("")
    .only(|s| !s.cam.is_straight())
    .required()
    .idle_when(program),
    number(
        "law.segment.N.length",
        Measure::same(D::Length),
        Range::Positive,
        given_entry!(law.segments, angle),
    )
    .default("")
    .only(|s| s.cam.is_straight())
    .required()
    .idle_when(program),
];
