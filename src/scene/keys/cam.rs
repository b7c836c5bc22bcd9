//! Rows of `[cam]`: the cam and its follower.

use super::kind::{Idle, Kind, Measure, Range, Relax};
use super::row::{Access, Key, given, key, optional, other, plain};
use super::value::Value;
use crate::cam::{FollowerKind, Hardness};
use crate::error::SceneError;
use crate::scene::{ConjugateSpec, KeywaySpec, Scene};
use crate::units::Dimension as D;

/// Most turns of a barrel's groove.
const MOST_TURNS: usize = 100;

fn follower(scene: &Scene) -> FollowerKind {
    scene.cam.follower
}

fn is_straight(scene: &Scene) -> bool {
    scene.cam.is_straight()
}

fn is_barrel(scene: &Scene) -> bool {
    follower(scene) == FollowerKind::Barrel
}

/// Disc cams may have a second one beside them.
fn is_disc(scene: &Scene) -> bool {
    !is_straight(scene) && !is_barrel(scene)
}

fn pair(scene: &mut Scene) -> &mut ConjugateSpec {
    scene.cam.conjugate.get_or_insert_default()
}

/// Access to an optional number of the second cam.
macro_rules! conjugate {
    ($field:ident) => {
        Access {
            get: |s, _| s.cam.conjugate?.$field.map(Value::Number),
            set: |s, _, v| {
                pair(s).$field = v.number();
                Ok(())
            },
        }
    };
}

pub static ROWS: &[Key] = &[
    other(
        "cam.follower",
        Kind::Choice(|| FollowerKind::ALL.map(FollowerKind::name).to_vec()),
        Access {
            get: |s, _| Some(Value::Text(s.cam.follower.name().to_string())),
            set: |s, _, v| {
                s.cam.follower = FollowerKind::named(&v.text()).unwrap_or_default();
                Ok(())
            },
        },
    )
    .default("flat-translating"),
    plain(
        "cam.prime_radius",
        D::Length,
        Range::Positive,
        optional!(cam.prime_radius),
    )
    .relax(Relax::Up),
    plain(
        "cam.base_radius",
        D::Length,
        Range::Positive,
        optional!(cam.base_radius),
    )
    .relax(Relax::Up),
    key(
        "cam.offset",
        Kind::NumberOr(Measure::same(D::Length), "auto"),
        Range::Any,
        Access {
            get: |s, _| {
                Some(
                    s.cam
                        .offset
                        .map_or(Value::Text("auto".into()), Value::Number),
                )
            },
            set: |s, _, v| {
                s.cam.offset = v.number();
                Ok(())
            },
        },
    )
    .default("0")
    .only(|s| follower(s).is_translating())
    .idle_when(|s| (follower(s) == FollowerKind::FlatTranslating).then_some(Idle::Follower)),
    plain(
        "cam.roller_radius",
        D::Length,
        Range::Positive,
        given!(cam.roller_radius),
    )
    .default("")
    .only(|s| follower(s).has_roller())
    .required(),
    plain(
        "cam.arc_radius",
        D::Length,
        Range::Positive,
        given!(cam.roller_radius),
    )
    .default("")
    .only(|s| follower(s).is_mushroom())
    .required(),
    plain(
        "cam.pivot_distance",
        D::Length,
        Range::Any,
        optional!(cam.pivot_distance),
    )
    .default("")
    .only(|s| follower(s).is_oscillating())
    .required(),
    plain("cam.arm", D::Length, Range::Positive, optional!(cam.arm))
        .default("")
        .only(|s| follower(s).is_oscillating() && !follower(s).is_flat())
        .required(),
    plain(
        "cam.face_offset",
        D::Length,
        Range::Any,
        given!(cam.face_offset),
    )
    .default("0")
    .only(|s| follower(s) == FollowerKind::FlatOscillating),
    other(
        "cam.pivot_beside",
        Kind::Flag,
        Access {
            get: |s, _| Some(Value::Flag(s.cam.pivot_beside)),
            set: |s, _, v| {
                s.cam.pivot_beside = v == Value::Flag(true);
                Ok(())
            },
        },
    )
    .default("false")
    .only(|s| follower(s).is_oscillating()),
    plain("cam.bore", D::Length, Range::Positive, optional!(cam.bore))
        .default("")
        .relax(Relax::Down)
        .only(|s| !is_straight(s)),
    key(
        "cam.keyway",
        Kind::NumberOr(Measure::same(D::Length), "auto"),
        Range::Positive,
        Access {
            get: |s, _| {
                s.cam.keyway.map(|spec| match spec {
                    KeywaySpec::Auto => Value::Text("auto".into()),
                    KeywaySpec::Width(width) => Value::Number(width),
                })
            },
            set: |s, _, v| {
                s.cam.keyway = Some(v.number().map_or(KeywaySpec::Auto, KeywaySpec::Width));
                Ok(())
            },
        },
    )
    .default("")
    .only(|s| !is_straight(s)),
    other(
        "cam.mark",
        Kind::Flag,
        Access {
            get: |s, _| Some(Value::Flag(s.cam.mark)),
            set: |s, _, v| {
                s.cam.mark = v == Value::Flag(true);
                Ok(())
            },
        },
    )
    .default("false")
    .only(|s| !is_straight(s)),
    plain(
        "cam.thickness",
        D::Length,
        Range::Positive,
        given!(cam.thickness),
    )
    .default("10 mm"),
    other(
        "cam.material",
        Kind::Text,
        Access {
            get: |s, _| s.cam.making.material.clone().map(Value::Text),
            set: |s, _, v| {
                s.cam.making.material = Some(v.text()).filter(|text| !text.trim().is_empty());
                Ok(())
            },
        },
    ),
    other(
        "cam.hardness",
        Kind::Text,
        Access {
            get: |s, _| s.cam.making.hardness.map(|h| Value::Text(h.to_string())),
            set: |s, _, v| {
                let typed = v.text();
                let read = Hardness::parse(&typed);
                s.cam.making.hardness = Some(read.ok_or(SceneError::NotHardness { typed })?);
                Ok(())
            },
        },
    ),
    plain(
        "cam.roughness",
        D::Length,
        Range::Positive,
        optional!(cam.making.roughness),
    )
    .default(""),
    plain(
        "cam.tolerance",
        D::Length,
        Range::Positive,
        optional!(cam.making.tolerance),
    )
    .default(""),
    other(
        "cam.balance",
        Kind::Flag,
        Access {
            get: |s, _| Some(Value::Flag(s.cam.making.balance)),
            set: |s, _, v| {
                s.cam.making.balance = v == Value::Flag(true);
                Ok(())
            },
        },
    )
    .default("false")
    .only(is_disc),
    plain(
        "cam.hub.diameter",
        D::Length,
        Range::Positive,
        optional!(cam.hub_diameter),
    )
    .default("")
    .only(is_disc),
    plain(
        "cam.hub.length",
        D::Length,
        Range::Positive,
        optional!(cam.hub_length),
    )
    .default("")
    .only(is_disc),
    plain(
        "cam.breadth",
        D::Length,
        Range::Positive,
        optional!(cam.breadth),
    )
    .default("")
    .only(|s| follower(s).is_translating()),
    plain(
        "cam.travel",
        D::Length,
        Range::Positive,
        optional!(cam.travel),
    )
    .only(is_straight),
    other(
        "cam.turns",
        Kind::Count(1, MOST_TURNS),
        Access {
            get: |s, _| Some(Value::Count(s.cam.turns)),
            set: |s, _, v| {
                s.cam.turns = v.count().unwrap_or(1);
                Ok(())
            },
        },
    )
    .default("1")
    .only(is_barrel),
    plain(
        "cam.depth",
        D::Length,
        Range::Positive,
        optional!(cam.depth),
    )
    .only(is_barrel),
    plain(
        "cam.roller_eccentricity",
        D::Length,
        Range::Positive,
        optional!(cam.eccentricity),
    )
    .default("")
    .only(is_barrel),
    plain(
        "cam.conjugate.distance",
        D::Length,
        Range::Positive,
        conjugate!(distance),
    )
    .default("")
    .only(|s| is_disc(s) && !follower(s).is_oscillating()),
    plain(
        "cam.conjugate.angle",
        D::Angle,
        Range::Positive,
        conjugate!(angle),
    )
    .default("")
    .only(|s| follower(s).is_oscillating()),
    plain(
        "cam.conjugate.base_radius",
        D::Length,
        Range::Positive,
        conjugate!(base_radius),
    )
    .default("")
    .only(is_disc),
    plain(
        "cam.conjugate.roller_radius",
        D::Length,
        Range::Positive,
        conjugate!(roller_radius),
    )
    .only(|s| is_disc(s) && (follower(s).has_roller() || follower(s).is_mushroom())),
];
