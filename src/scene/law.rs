//! `[law]`: what the law may be.

use super::load::lift_dimension;
use super::table::Reader;
use super::{CamSpec, Dwell, Family, Gait, LawPoint, LawSpec, Minimise, SegmentSpec, Weigh};
use crate::error::{Error, Place, Result};
use crate::law::Rise;
use crate::units::Dimension;

/// Most spans of a spline: beyond this the law is a table, not a law.
const MOST_SPANS: usize = 10_000;
pub fn read(reader: Option<Reader>, cam: &CamSpec, gait: Option<&Gait>) -> Result<LawSpec> {
    let mut spec = LawSpec {
        family: Family::Spline,
        degree: None,
        spans: None,
        harmonics: None,
        minimise: None,
        monotone: false,
        polydyne: false,
        points: Vec::new(),
        dwells: Vec::new(),
        segments: Vec::new(),
    };
    let Some(mut r) = reader else {
        spec.family = unnamed(&spec, gait);
        return Ok(spec);
    };
    let family = r.choice("family", &Family::NAMES)?;
    let degrees = if family == Some(Family::Polynomial) {
        (1, 30)
    } else {
        (3, 9)
    };
    spec.degree = r.count("degree", degrees.0, degrees.1)?;
    spec.spans = r.count("spans", 1, MOST_SPANS)?;
    spec.harmonics = r.count("harmonics", 1, 400)?;
    spec.minimise = r.choice("minimise", &Minimise::NAMES)?;
    if let Some(weigh) = weigh(&mut r, gait.is_some(), cam)? {
        if spec.minimise.is_some() {
            return Err(
                Error::key("law.minimise", "law.weigh already says what is minimised")
                    .help("leave out one of the two"),
            );
        }
        spec.minimise = Some(Minimise::Weighed(weigh));
    }
    let of_force = [Minimise::ForceError, Minimise::PeakForceError];
    if gait.is_none() && spec.minimise.is_some_and(|m| of_force.contains(&m)) {
        return Err(
            Error::key("law.minimise", "there is no force to come near to")
                .help("add [gait], or minimise \"jerk\", \"peak-acceleration\" …"),
        );
    }
    spec.monotone = r.flag("monotone")?.unwrap_or(false);
    spec.polydyne = r.flag("polydyne")?.unwrap_or(false);
    let length = |order| lift_dimension(cam.is_oscillating(), order);
    for mut p in r.tables("point")? {
        let key = p.name("angle");
        let angle = p.quantity("angle", Dimension::Angle)?;
        spec.points.push(LawPoint {
            angle: angle.ok_or_else(|| {
                Error::key(&key, "a point needs its angle").help("write angle = \"56.88 deg\"")
            })?,
            lift: p.quantity("lift", length(0))?,
            force: p.quantity("force", Dimension::Force)?,
            velocity: p.quantity("velocity", length(1))?,
            acceleration: p.quantity("acceleration", length(2))?,
            jerk: p.quantity("jerk", length(3))?,
        });
        p.finish()?;
    }
    for mut d in r.tables("dwell")? {
        let missing = |key: String| {
            Error::key(&key, "a dwell needs it")
                .help("write from = \"256.32 deg\", to = \"360 deg\"")
        };
        let (from_key, to_key) = (d.name("from"), d.name("to"));
        spec.dwells.push(Dwell {
            from: d
                .quantity("from", Dimension::Angle)?
                .ok_or_else(|| missing(from_key))?,
            to: d
                .quantity("to", Dimension::Angle)?
                .ok_or_else(|| missing(to_key))?,
            lift: d.quantity("lift", length(0))?,
        });
        d.finish()?;
    }
    for mut s in r.tables("segment")? {
        let (key, named) = (s.name("angle"), s.name("motion"));
        let motion = Rise::from_name(s.text("motion")?.unwrap_or(Rise::Dwell.name()))
            .map_err(|e| e.at(Place::Key(named)))?;
        spec.segments.push(SegmentSpec {
            motion,
            lift: s.quantity("lift", length(0))?.unwrap_or(0.0),
            angle: if cam.is_straight() {
                let length = s.name("length");
                s.positive("length", Dimension::Length)?.ok_or_else(|| {
                    Error::key(&length, "a segment of a translating cam needs its length")
                        .help("write length = \"40 mm\"")
                })?
            } else {
                s.positive("angle", Dimension::Angle)?.ok_or_else(|| {
                    Error::key(&key, "a segment needs its angle").help("write angle = \"90 deg\"")
                })?
            },
        });
        s.finish()?;
    }
    r.finish()?;
    spec.family = family.unwrap_or_else(|| unnamed(&spec, gait));
    Ok(spec)
}

/// `[law.weigh]`: force error, size and jerk against each other.
fn weigh(r: &mut Reader, has_force: bool, cam: &CamSpec) -> Result<Option<Weigh>> {
    let Some(mut r) = r.table("weigh")? else {
        return Ok(None);
    };
    let jerk = if cam.is_oscillating() {
        Dimension::AngularJerk
    } else {
        Dimension::Jerk
    };
    let weigh = Weigh {
        force_error: r.positive("force_error", Dimension::Percent)?,
        prime_radius: r.positive("prime_radius", Dimension::Length)?,
        jerk: r.positive("jerk", jerk)?,
    };
    r.finish()?;
    if weigh == Weigh::default() {
        return Err(Error::key("law.weigh", "it says nothing").help(
            "say how much counts as one: force_error = \"1 %\", prime_radius = \"20 mm\", jerk = \"100 m/s^3\"",
        ));
    }
    if weigh.force_error.is_some() && !has_force {
        return Err(
            Error::key("law.weigh.force_error", "there is no force to come near to")
                .help("add [gait], or leave it out"),
        );
    }
    let sized = cam.follower.is_translating() && !cam.follower.is_mushroom();
    let free = cam.prime_radius.is_none() && cam.base_radius.is_none();
    if weigh.prime_radius.is_some() && !(sized && free) {
        return Err(
            Error::key("law.weigh.prime_radius", "the size of this cam is not free").help(
                "it is for translating flat faces, rollers and knife edges without a given radius",
            ),
        );
    }
    Ok(Some(weigh))
}

/// The family of a scene that names none: the ladder, unless something is asked that only splines have.
fn unnamed(law: &LawSpec, gait: Option<&Gait>) -> Family {
    let follows_a_plain_force = gait.is_some_and(|g| g.band.is_none() && g.weights.is_empty());
    let of_splines = law.degree.is_some()
        || law.spans.is_some()
        || law.monotone
        || law.polydyne
        || matches!(law.minimise, Some(m) if m != Minimise::ForceError)
        || !(law.points.is_empty() && law.dwells.is_empty() && law.segments.is_empty());
    match (follows_a_plain_force && !of_splines, law.harmonics) {
        (true, None) => Family::Ladder,
        (true, Some(_)) => Family::Harmonic,
        (false, _) => Family::Spline,
    }
}
