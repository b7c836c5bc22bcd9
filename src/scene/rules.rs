//! Checks of combinations of keys in a scene.

use std::f64::consts::TAU;

use toml::{Table, Value as Toml};

use super::{Family, KeywaySpec, LimitKind, Minimise, Scene, Source};
use crate::cam::{Keyway, Unit};
use crate::drive::DriveKind;
use crate::error::{Placed, Result, SceneError};
use crate::units::{Dimension, Quantity};
use crate::wording::{self, Language};

/// Minimum degree of a spline for which a polydyne cam has a continuous acceleration.
const POLYDYNE_DEGREE: usize = 5;
/// Permitted degrees of a spline.
const SPLINE_DEGREES: std::ops::RangeInclusive<usize> = 3..=9;
/// Tolerance of angles at the ends of the cycle, rad.
const ANGLE: f64 = 1e-9;

/// Checks that the keys of a scene are consistent with each other.
///
/// # Errors
///
/// The keys are inconsistent. The error contains the key that must be changed.
pub fn check(scene: &Scene) -> Result<()> {
    check_typed(scene, Typed(None))
}

/// The scene as written by the user, from which messages quote values; `None` if it is not available.
#[derive(Clone, Copy)]
pub(super) struct Typed<'a>(pub Option<&'a Table>);

impl<'a> Typed<'a> {
    pub fn value(self, path: &str) -> Option<&'a Toml> {
        let mut parts = path.split('.');
        let first = self.0?.get(parts.next()?)?;
        parts.try_fold(first, |at, part| at.as_table()?.get(part))
    }

    fn gives(self, path: &str) -> bool {
        self.value(path).is_some()
    }

    /// Value of a key as written by the user. If it is not available, the number with a common unit.
    fn text(self, path: &str, value: f64, dimension: Dimension) -> String {
        match self.value(path) {
            Some(Toml::String(typed)) if typed != "auto" => typed.clone(),
            _ => {
                let unit = Unit::of(dimension);
                unit.after(&wording::exact(Language::En, unit.factor * value))
            }
        }
    }
}

type Rule = fn(&Scene, Typed) -> std::result::Result<(), (&'static str, SceneError)>;

/// All rules, in the order in which they are checked.
const RULES: [Rule; 13] = [
    name,
    force,
    objective,
    limits,
    machine,
    size,
    keyway,
    circles,
    motion,
    pair,
    splines,
    polydyne,
    completeness,
];

/// Checks a scene as [`check`] does. Messages quote the values as written by the user.
pub(super) fn check_typed(scene: &Scene, typed: Typed) -> Result<()> {
    weighed_phases(scene)?;
    for rule in RULES {
        rule(scene, typed).map_err(|(key, fault)| fault.at_key(key))?;
    }
    Ok(())
}

/// Rejects a weighted range of the cycle if one of its ends is outside the cycle or if both ends are equal.
fn weighed_phases(scene: &Scene) -> Result<()> {
    let inside = |x: f64| (-ANGLE..=TAU + ANGLE).contains(&x);
    let weights = scene.gait.iter().flat_map(|gait| &gait.weights);
    for (number, weight) in (1..).zip(weights) {
        let end = if !inside(weight.from) || weight.from == weight.to {
            "from"
        } else if !inside(weight.to) {
            "to"
        } else {
            continue;
        };
        let (from, to) = (Quantity::angle(weight.from), Quantity::angle(weight.to));
        let fault = SceneError::NoPhases { from, to };
        return Err(fault.at_key(&format!("gait.weight.{number}.{end}")));
    }
    Ok(())
}

type Verdict = std::result::Result<(), (&'static str, SceneError)>;

fn name(scene: &Scene, _: Typed) -> Verdict {
    let name = &scene.name;
    let no_file = |c: char| c.is_control() || matches!(c, '/' | '\\' | '\u{202e}');
    if name.trim().is_empty() || name.contains(no_file) || name.starts_with(['.', '-', '~']) {
        let typed = name.clone();
        return Err(("name", SceneError::OutputName { typed }));
    }
    Ok(())
}

fn force(scene: &Scene, typed: Typed) -> Verdict {
    let Some(gait) = &scene.gait else {
        return Ok(());
    };
    let sources = ["gait.file", "gait.model", "gait.harmonics"];
    if sources.iter().filter(|key| typed.gives(key)).count() > 1 {
        return Err(("gait", SceneError::FileAndModel));
    }
    if matches!(&gait.source, Source::File(path) if path.as_os_str().is_empty()) {
        return Err(("gait.file", SceneError::NoForceNamed));
    }
    let covered: f64 = (gait.weights.iter())
        .map(|w| (w.to - w.from).rem_euclid(TAU))
        .map(|length| if length < ANGLE { TAU } else { length })
        .sum();
    if covered >= TAU - ANGLE && gait.weights.iter().all(|w| w.weight == 0.0) {
        return Err(("gait.weight", SceneError::NothingWeighed));
    }
    Ok(())
}

fn objective(scene: &Scene, _: Typed) -> Verdict {
    let (law, cam) = (&scene.law, &scene.cam);
    let no_force = scene.gait.is_none();
    let sized = cam.follower.has_size_beside_law();
    match law.minimise {
        Some(Minimise::ForceError | Minimise::PeakForceError) if no_force => {
            return Err(("law.minimise", SceneError::NoForceToFollow));
        }
        Some(Minimise::Size) if !sized => {
            return Err(("law.minimise", SceneError::SizeNotFree));
        }
        _ => {}
    }
    if let Some(degree) = law.degree
        && law.family != Family::Polynomial
        && !SPLINE_DEGREES.contains(&degree)
    {
        let typed = degree.to_string();
        return Err(("law.degree", SceneError::SplineDegree { typed }));
    }
    if let (Some(degree), Some(Minimise::Energy(order) | Minimise::Peak(order))) =
        (law.degree, law.minimise)
        && degree < order
    {
        let fault = SceneError::DegreeBelowObjective { degree, order };
        return Err(("law.degree", fault));
    }
    Ok(())
}

fn limits(scene: &Scene, typed: Typed) -> Verdict {
    let limits = &scene.limits;
    if let (Some(low), Some(high)) = (limits[LimitKind::ForceMin], limits[LimitKind::ForceMax])
        && low >= high
    {
        let pressing = if scene.cam.is_oscillating() {
            Dimension::Torque
        } else {
            Dimension::Force
        };
        let low = typed.text("limits.force_min", low, pressing);
        let high = typed.text("limits.force_max", high, pressing);
        return Err(("limits.force_min", SceneError::ForceRange { low, high }));
    }
    Ok(())
}

fn machine(scene: &Scene, _: Typed) -> Verdict {
    let machine = &scene.machine;
    if machine.stiffness.is_some() && machine.natural_frequency.is_some() {
        return Err(("machine.stiffness", SceneError::FrequencyAndStiffness));
    }
    if scene.limits[LimitKind::Residual].is_some() && machine.natural_frequency.is_none() {
        return Err((
            "machine.natural_frequency",
            SceneError::ResidualWithoutFrequency,
        ));
    }
    if machine.has_floor() {
        let moves = scene.drive.kind == DriveKind::MovingAxis;
        if !moves || scene.gait.is_none() || scene.law.polydyne {
            return Err(("machine.floor", SceneError::FloorNeedsShaker));
        }
    }
    machine.check_floor()?;
    machine.check_motor()
}

/// Checks that at most one key determines the size of the cam.
fn size(scene: &Scene, _: Typed) -> Verdict {
    let cam = &scene.cam;
    if cam.base_radius.is_some() && cam.prime_radius.is_some() {
        return Err(("cam.prime_radius", SceneError::BaseAndPrime));
    }
    if cam.breadth.is_none() {
        return Ok(());
    }
    if cam.base_radius.is_some() || cam.prime_radius.is_some() {
        return Err(("cam.breadth", SceneError::RadiusAndBreadth));
    }
    if scene.law.family != Family::Program {
        return Err(("cam.breadth", SceneError::BreadthWithoutProgram));
    }
    Ok(())
}

/// Checks that the keyway fits the bore and has a standard width.
fn keyway(scene: &Scene, typed: Typed) -> Verdict {
    let Some(spec) = scene.cam.keyway else {
        return Ok(());
    };
    let at = |fault| Err(("cam.keyway", fault));
    let Some(bore) = scene.cam.bore else {
        return at(SceneError::KeywayWithoutBore);
    };
    let length = |path: &str, value: f64| typed.text(path, value, Dimension::Length);
    match spec {
        KeywaySpec::Auto if Keyway::for_shaft(bore).is_none() => {
            let bore = length("cam.bore", bore);
            at(SceneError::NoKeywayForBore { bore })
        }
        KeywaySpec::Width(width) if Keyway::of_width(width).is_none() => {
            let widths: Vec<String> = Keyway::widths()
                .map(|w| format!("{:.0}", 1e3 * w))
                .collect();
            let width = length("cam.keyway", width);
            at(SceneError::NoKeywayOfWidth {
                width,
                widths: widths.join(", "),
            })
        }
        KeywaySpec::Width(width) if width >= bore => {
            let (width, bore) = (length("cam.keyway", width), length("cam.bore", bore));
            at(SceneError::KeywayTooWide { width, bore })
        }
        _ => Ok(()),
    }
}

/// Checks that the base radius is positive and that the base circle encloses the bore with its keyway. The offset must be smaller than the
/// prime radius.
fn circles(scene: &Scene, typed: Typed) -> Verdict {
    let cam = &scene.cam;
    let length = |path: &str, value: f64| typed.text(path, value, Dimension::Length);
    let base = match (cam.base_radius, cam.prime_radius) {
        (Some(base), _) => base,
        (None, Some(prime)) => prime - cam.roller_radius,
        _ => return Ok(()),
    };
    if base <= 0.0 {
        let key = if cam.follower.is_mushroom() {
            "cam.arc_radius"
        } else {
            "cam.roller_radius"
        };
        let roller = length(key, cam.roller_radius);
        let base = Quantity::new(base, Dimension::Length);
        return Err((
            "cam.prime_radius",
            SceneError::RollerFillsPrime { roller, base },
        ));
    }
    if let Some(hole) = cam.hole().filter(|hole| base <= hole.reach()) {
        let fault = SceneError::BaseInBore {
            base: length("cam.base_radius", base),
            bore: length("cam.bore", hole.diameter),
            least: Quantity::new(hole.reach(), Dimension::Length),
        };
        return Err(("cam.base_radius", fault));
    }
    let prime = base + cam.roller_radius;
    if let Some(offset) = cam.offset.filter(|e| e.abs() >= prime) {
        let offset = length("cam.offset", offset);
        let prime = length("cam.prime_radius", prime);
        return Err((
            "cam.offset",
            SceneError::OffsetReachesPrime { offset, prime },
        ));
    }
    Ok(())
}

/// Checks three conditions. A target force requires a rotating cam with a law over one turn. Several turns and translating cams require a
/// programme. An arm requires a drive with a fixed axis.
fn motion(scene: &Scene, _: Typed) -> Verdict {
    let cam = &scene.cam;
    if cam.is_oscillating() && scene.drive.kind == DriveKind::MovingAxis {
        return Err(("drive.kind", SceneError::ArmOnMovingAxis));
    }
    if !(cam.is_straight() || cam.turns > 1) {
        return Ok(());
    }
    if scene.gait.is_some() {
        let follower = cam.follower.name();
        return Err(("gait", SceneError::ForceNeedsTurn { follower }));
    }
    let program = scene.law.family == Family::Program;
    if cam.turns > 1 && !program {
        return Err(("law.family", SceneError::TurnsNeedProgram));
    }
    if cam.is_straight() && !program {
        return Err(("law.family", SceneError::LengthNeedsProgram));
    }
    Ok(())
}

fn pair(scene: &Scene, _: Typed) -> Verdict {
    let key = if scene.cam.is_oscillating() {
        "cam.conjugate.angle"
    } else {
        "cam.conjugate.distance"
    };
    match &scene.cam.conjugate {
        Some(pair) if pair.closure().is_none() => Err((key, SceneError::PairNotClosed)),
        _ => Ok(()),
    }
}

/// Checks that a force band, phase weights and the peak force error are used only with a spline.
fn splines(scene: &Scene, _: Typed) -> Verdict {
    let law = &scene.law;
    let Some(gait) = &scene.gait else {
        return Ok(());
    };
    if matches!(law.family, Family::Spline | Family::Auto) {
        return Ok(());
    }
    let key = if gait.band.is_some() {
        "gait.band"
    } else if !gait.weights.is_empty() {
        "gait.weight"
    } else {
        match law.minimise {
            Some(Minimise::PeakForceError) => "law.minimise",
            _ => return Ok(()),
        }
    };
    let family = law.family.name();
    Err((key, SceneError::OnlySplines { family }))
}

/// Checks the requirements of a polydyne cam: a flexible follower, a smooth law, and a rotating cam without constant breadth.
fn polydyne(scene: &Scene, _: Typed) -> Verdict {
    let (law, machine) = (&scene.law, &scene.machine);
    if !law.polydyne {
        return Ok(());
    }
    if machine.natural_frequency.is_none() && machine.stiffness.is_none() {
        return Err(("machine.stiffness", SceneError::PolydyneWithoutStiffness));
    }
    if law.family == Family::DoubleHarmonic {
        let family = law.family.name();
        return Err(("law.family", SceneError::PolydyneFamily { family }));
    }
    if law.family == Family::Spline && law.degree.is_some_and(|d| d < POLYDYNE_DEGREE) {
        return Err(("law.degree", SceneError::PolydyneDegree));
    }
    if scene.cam.is_straight() {
        return Err(("cam.follower", SceneError::PolydyneOnSlide));
    }
    if scene.cam.breadth.is_some() {
        return Err(("cam.breadth", SceneError::PolydyneBreadth));
    }
    Ok(())
}

/// Checks that the scene determines the law: by a target force, points, dwells or segments. Without a target force, the speed must be given, and on a
/// moving axis the mass.
fn completeness(scene: &Scene, _: Typed) -> Verdict {
    let law = &scene.law;
    let no_force = scene.gait.is_none();
    match law.family {
        Family::Program if law.segments.is_empty() => {
            return Err(("law.segment", SceneError::ProgramWithoutSegments));
        }
        Family::Polynomial if law.points.len() < 2 => {
            return Err(("law.point", SceneError::PolynomialWithoutPoints));
        }
        Family::Polynomial | Family::Program => {}
        _ if no_force && law.points.is_empty() && law.dwells.is_empty() => {
            return Err(("gait", SceneError::NothingAsked));
        }
        _ => {}
    }
    if no_force && scene.drive.speed.is_none() {
        return Err(("drive.speed", SceneError::NoSpeed));
    }
    if no_force && scene.drive.kind == DriveKind::MovingAxis && scene.drive.mass.is_none() {
        return Err(("drive.mass", SceneError::NoMass));
    }
    Ok(())
}
