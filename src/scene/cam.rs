//! The cam of a scene: which lengths each follower has.

use super::table::Reader;
use super::{CamSpec, ConjugateSpec, Family, Scene};
use crate::cam::{Closure, FollowerKind};
use crate::drive::DriveKind;
use crate::error::{Error, Result};
use crate::units::Dimension;

/// Plate thickness of solids when nothing is said, m.
const THICKNESS: f64 = 0.01;
/// Most turns of a barrel's groove.
const MOST_TURNS: usize = 100;

/// Reads `[cam]`. Keys that a follower does not have are refused.
pub(super) fn read(reader: Option<Reader>) -> Result<CamSpec> {
    let mut spec = CamSpec {
        follower: FollowerKind::default(),
        base_radius: None,
        prime_radius: None,
        offset: None,
        roller_radius: 0.0,
        pivot_distance: None,
        arm: None,
        pivot_beside: false,
        face_offset: 0.0,
        bore: None,
        thickness: THICKNESS,
        breadth: None,
        travel: None,
        turns: 1,
        depth: None,
        eccentricity: None,
        conjugate: None,
    };
    let Some(mut r) = reader else { return Ok(spec) };
    let kinds = FollowerKind::ALL.map(|k| (k.name(), k));
    let kind = r.choice("follower", &kinds)?.unwrap_or_default();
    spec.follower = kind;
    spec.thickness = r
        .positive("thickness", Dimension::Length)?
        .unwrap_or(THICKNESS);
    spec.base_radius = r.positive("base_radius", Dimension::Length)?;
    spec.prime_radius = r.positive("prime_radius", Dimension::Length)?;
    if kind != FollowerKind::TranslatingCam {
        spec.bore = r.positive("bore", Dimension::Length)?;
    }
    let needed = |r: &mut Reader, key, why: &str, example: &str| {
        let name = r.name(key);
        r.positive(key, Dimension::Length)?
            .ok_or_else(|| Error::key(&name, why).help(format!("write for example {example}")))
    };
    if kind.has_roller() {
        spec.roller_radius = needed(
            &mut r,
            "roller_radius",
            "a roller follower needs it",
            "\"10 mm\"",
        )?;
    } else if kind.is_mushroom() {
        spec.roller_radius = needed(
            &mut r,
            "arc_radius",
            "a mushroom needs its arc",
            "\"60 mm\"",
        )?;
    }
    // The main job's default scene may be changed to any translating follower.
    if kind.is_translating() {
        spec.offset = r.quantity("offset", Dimension::Length)?;
        spec.breadth = r.positive("breadth", Dimension::Length)?;
    }
    if spec.is_oscillating() {
        let distance = r.name("pivot_distance");
        let pivot = r
            .quantity("pivot_distance", Dimension::Length)?
            .ok_or_else(|| {
                Error::key(&distance, "an oscillating follower needs its pivot")
                    .help("write for example \"80 mm\"; negative puts it on the other side")
            })?;
        spec.pivot_distance = Some(pivot);
        spec.pivot_beside = r.flag("pivot_beside")?.unwrap_or(false);
        if kind == FollowerKind::FlatOscillating {
            spec.face_offset = r.quantity("face_offset", Dimension::Length)?.unwrap_or(0.0);
        } else {
            spec.arm = Some(needed(
                &mut r,
                "arm",
                "an oscillating follower needs its arm",
                "\"70 mm\"",
            )?);
        }
    }
    if kind == FollowerKind::TranslatingCam {
        spec.travel = r.positive("travel", Dimension::Length)?;
    } else if kind == FollowerKind::Barrel {
        spec.turns = r.count("turns", 1, MOST_TURNS)?.unwrap_or(1);
        spec.depth = r.positive("depth", Dimension::Length)?;
        spec.eccentricity = r.positive("roller_eccentricity", Dimension::Length)?;
    } else if let Some(pair) = r.table("conjugate")? {
        spec.conjugate = Some(conjugate(pair, &spec)?);
    }
    r.finish()?;
    Ok(spec)
}

fn conjugate(mut r: Reader, spec: &CamSpec) -> Result<ConjugateSpec> {
    let (key, closing) = if spec.is_oscillating() {
        let angle = r.positive("angle", Dimension::Angle)?;
        ("cam.conjugate.angle", angle.map(Closure::Angle))
    } else {
        let distance = r.positive("distance", Dimension::Length)?;
        ("cam.conjugate.distance", distance.map(Closure::Distance))
    };
    let base = r.positive("base_radius", Dimension::Length)?;
    let roller_radius = if spec.roller_radius > 0.0 {
        r.positive("roller_radius", Dimension::Length)?
    } else {
        None
    };
    r.finish()?;
    let closure = match (closing, base) {
        (Some(closure), None) => closure,
        (None, Some(base)) => Closure::SecondBaseRadius(base),
        _ => {
            return Err(Error::key(key, "says neither or both of this and base_radius").help(
                "give the distance of both faces or roller centres (arms: the angle between them), or the second cam's base_radius",
            ));
        }
    };
    Ok(ConjugateSpec {
        closure,
        roller_radius,
    })
}

/// Demands on the cam that only the whole scene can contradict.
pub(super) fn consistent(scene: &Scene) -> Result<()> {
    let cam = &scene.cam;
    if let (Some(_), Some(_)) = (cam.base_radius, cam.prime_radius) {
        return Err(Error::key(
            "cam.prime_radius",
            "base_radius is given as well, and one follows from the other",
        )
        .help("leave one of them out"));
    }
    if cam.breadth.is_some() && (cam.base_radius.is_some() || cam.prime_radius.is_some()) {
        return Err(Error::key(
            "cam.breadth",
            "the base circle follows from the breadth: half of what the lift leaves of it",
        )
        .help("leave base_radius and prime_radius out"));
    }
    if cam.breadth.is_some() && scene.law.family != Family::Program {
        return Err(Error::key(
            "cam.breadth",
            "constant breadth needs a programme whose halves mirror each other",
        )
        .help("set law.family = \"program\" with segments"));
    }
    let base = match (cam.base_radius, cam.prime_radius) {
        (Some(base), _) => Some(base),
        (None, Some(prime)) => Some(prime - cam.roller_radius),
        _ => None,
    };
    if let Some(base) = base.filter(|b| *b <= 0.0) {
        return Err(Error::key(
            "cam.prime_radius",
            format!(
                "the roller (or arc) of {:.4} mm leaves a base circle of {:.4} mm",
                1e3 * cam.roller_radius,
                1e3 * base
            ),
        )
        .help("the prime radius must exceed the roller's"));
    }
    if let (Some(bore), Some(base)) = (cam.bore, base)
        && base <= 0.5 * bore
    {
        return Err(Error::key(
            "cam.base_radius",
            format!("{base} m lies inside the bore of {bore} m"),
        )
        .help(format!("make it larger than {} m", 0.5 * bore)));
    }
    let prime = base.map(|b| b + cam.roller_radius);
    if let (Some(prime), Some(offset)) = (prime, cam.offset)
        && offset.abs() >= prime
    {
        return Err(Error::key(
            "cam.offset",
            format!("{offset} m reaches the prime circle of {prime} m"),
        )
        .help("the offset must be smaller than the prime radius"));
    }
    force_needs_a_sliding_follower(scene)
}

/// Forces are related to a lift in metres over one turn; other motions take programmes only.
fn force_needs_a_sliding_follower(scene: &Scene) -> Result<()> {
    let cam = &scene.cam;
    let other = cam.is_oscillating() || cam.is_straight() || cam.turns > 1;
    if !other {
        return Ok(());
    }
    if scene.gait.is_some() {
        return Err(Error::key(
            "gait",
            format!(
                "a wanted force shapes a lift in metres over one turn, which {} does not make",
                cam.follower.name()
            ),
        )
        .help("use a translating follower, or leave [gait] out and give a programme"));
    }
    if (cam.is_straight() || cam.turns > 1) && scene.law.family != Family::Program {
        return Err(Error::key(
            "law.family",
            format!(
                "a law over {} is given as a programme",
                if cam.turns > 1 {
                    "several turns"
                } else {
                    "a length"
                }
            ),
        )
        .help("set law.family = \"program\" with segments"));
    }
    if cam.is_oscillating() && scene.drive.kind != DriveKind::FixedAxis {
        return Err(Error::key(
            "drive.kind",
            "an arm's lift is an angle, which no mass or spring in newtons acts on",
        )
        .help("use kind = \"fixed-axis\"; inertia, spring_rate and preload then count about the pivot"));
    }
    Ok(())
}
