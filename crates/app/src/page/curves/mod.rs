//! Curves of a design over the cam angle or travel, in customary units, for the diagrams of the page.

mod contour;
mod walkers;

use serde::Serialize;

use gaitcam::cam::{Measures, ProfilePoint, Unit};
use gaitcam::criterion::{Diagram, LimitKind};
use gaitcam::law::Svaj;
use gaitcam::scene::keys;
use gaitcam::synth::Design;
use gaitcam_output::curve;

pub use contour::Colour;
use contour::{Contour, Place, contour, places};

const MM: f64 = 1e3;
/// Unit of lengths in the diagrams.
const LENGTH: Unit = Unit {
    factor: MM,
    name: "mm",
};
/// Maximum radius of curvature in the diagram, as a multiple of the prime radius. Where the radius is larger, the profile is nearly
/// straight.
const STRAIGHT: f64 = 3.0;

/// Fraction of a curve's maximum below which a value counts as a rounding error and is shown as zero.
const ROUNDING: f64 = 1e-9;

/// Number for the page, rounded to six significant digits. `None`, which is null in JSON, represents a missing value.
type Shown = Option<f64>;

fn short(x: f64) -> Shown {
    if x == 0.0 || !x.is_finite() {
        return x.is_finite().then_some(0.0);
    }
    let scale = libm::pow(10_f64, 5.0 - libm::log10(x.abs()).floor());
    let short = (x * scale).round() / scale;
    Some(if short.is_finite() { short } else { x })
}

/// All curves of a design, sampled at the same cam angles.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curves {
    /// Cam angles, or positions of a translating cam, in `unit`. A break of the law appears twice, once for each side of the break.
    pub theta: Vec<Shown>,
    /// First cam angle, or first position of the travel, in `unit`.
    pub start: f64,
    /// Angle of one turn, or length of the travel, in `unit`.
    pub length: f64,
    /// Unit of the cam angle or travel, such as `°`.
    pub unit: &'static str,
    /// Diagrams of the page. The first one shows the force.
    pub panels: Vec<Panel>,
    /// Contour of the cam with its colours.
    pub contour: Contour,
    /// Points at which a limit is active or violated.
    pub places: Vec<Place>,
}

/// Diagram of one quantity over the cam angle or travel, with its limits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Panel {
    /// Name of the quantity in JSON data: `force`, `s`, `v` …
    pub id: &'static str,
    /// Unit of the values in the diagram, such as `mm`.
    pub unit: &'static str,
    /// Curves of the diagram, each with its role: `main`, `target`, `low`, `high` or `worst`.
    pub lines: Vec<Line>,
    /// Horizontal lines of the diagram, which show limits or the nominal speed.
    pub levels: Vec<Level>,
}

/// Horizontal line in a diagram. It shows a limit or, in the speed diagram, the nominal speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Level {
    /// Height of the line, in the unit of the diagram.
    pub y: Shown,
    /// Key of the scene that sets the limit. It is empty for the nominal speed and for a limit without a key.
    pub key: &'static str,
    /// Value from which the limit is measured, in the unit of the diagram; `None` if the line itself is the limit.
    pub from: Shown,
}

/// One curve of a diagram.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Line {
    /// Role of the curve: `main`, `target`, `low`, `high` or `worst`. `low` and `high` are the edges of a band. `worst` is the target force
    /// of the walker with the maximum error.
    pub role: &'static str,
    /// Values of the curve at the angles of [`Curves::theta`], in the unit of the diagram.
    pub y: Vec<Shown>,
}

/// Function that selects one of lift, velocity, acceleration and jerk.
type Pick = fn(&Svaj) -> f64;

/// Motion, force and contact point at one cam angle.
struct Sample {
    theta: f64,
    at: Svaj,
    force: f64,
    point: ProfilePoint,
}

/// Curves of a design for all diagrams, with the contour coloured by `colour`.
pub fn curves(design: &Design, colour: Colour) -> Curves {
    let cam = &design.cam;
    let measures = cam.follower.measures();
    let angle = measures.angle();
    let (start, length) = cam.law.extent();
    let samples = samples(design);
    Curves {
        theta: samples
            .iter()
            .map(|s| short(angle.factor * s.theta))
            .collect(),
        start: angle.factor * start,
        length: angle.factor * length,
        unit: angle.name,
        panels: panels(design, &samples),
        contour: contour(design, &samples, colour),
        places: places(design),
    }
}

fn samples(design: &Design) -> Vec<Sample> {
    let mut drive = design.problem.drive;
    if design.is_idle() {
        // Without mass, spring, damping and preload, the force is zero. The force of a moved mass of 1 kg is shown instead.
        drive.mass = 1.0;
    }
    let force = |theta: f64, at: Svaj| match &design.end {
        Some(end) => drive.force(end.law.svaj(theta)),
        None if design.is_idle() => drive.force(at),
        None => design.force_at(theta),
    };
    let cam = &design.cam;
    let motion = curve::motion(&cam.law).into_iter();
    motion
        .map(|(theta, at)| Sample {
            theta,
            at,
            force: force(theta, at),
            point: cam.point(theta),
        })
        .collect()
}

fn line_of(role: &'static str, samples: &[Sample], value: impl Fn(&Sample) -> f64) -> Line {
    let y: Vec<f64> = samples.iter().map(value).collect();
    let most = y
        .iter()
        .filter(|x| x.is_finite())
        .fold(0.0_f64, |m, x| m.max(x.abs()));
    // A value that is only the rounding error of a difference of large numbers is shown as zero.
    let shown = |x: f64| short(if x.abs() < ROUNDING * most { 0.0 } else { x });
    let y = y.into_iter().map(shown).collect();
    Line { role, y }
}

fn panels(design: &Design, samples: &[Sample]) -> Vec<Panel> {
    let measures = design.cam.follower.measures();
    let speed = design.problem.drive.speed;
    let mut out = vec![force(design, samples)];
    let picks: [(Diagram, Pick); 4] = [
        (Diagram::Lift, |m| m.s),
        (Diagram::Velocity, |m| m.v),
        (Diagram::Acceleration, |m| m.a),
        (Diagram::Jerk, |m| m.j),
    ];
    for (order, (diagram, pick)) in picks.into_iter().enumerate() {
        let unit = if order == 0 {
            measures.lift(0)
        } else {
            measures.by_time(order)
        };
        let factor = unit.factor * speed.powi(order as i32);
        let line = line_of("main", samples, |s| factor * pick(&s.at));
        out.push(panel(design, diagram, unit, vec![line]));
    }
    out.push(radius(design, samples));
    out.push(contact(design, samples));
    let torque = if measures == Measures::Straight {
        "N"
    } else {
        "N·m"
    };
    let unit = |name| Unit { factor: 1.0, name };
    let line = line_of("main", samples, |s| s.force * s.at.v);
    out.push(panel(design, Diagram::Torque, unit(torque), vec![line]));
    let turning = |s: &Sample| design.speed_and_time(s.theta).0;
    let line = line_of("main", samples, |s| s.force * s.at.v * turning(s));
    out.push(panel(design, Diagram::Power, unit("W"), vec![line]));
    if design.shaft.is_some() {
        let line = line_of("main", samples, turning);
        out.push(Panel {
            levels: vec![Level {
                y: short(speed),
                key: "",
                from: None,
            }],
            ..panel(design, Diagram::Speed, unit("rad/s"), vec![line])
        });
    }
    out
}

fn panel(design: &Design, diagram: Diagram, unit: Unit, lines: Vec<Line>) -> Panel {
    let shown = lines
        .first()
        .into_iter()
        .flat_map(|line| line.y.iter().flatten());
    let lowest = shown.fold(f64::INFINITY, |low, y| low.min(*y));
    Panel {
        id: diagram.name(),
        unit: unit.name,
        levels: levels(design, diagram, unit.factor, lowest),
        lines,
    }
}

fn force(design: &Design, samples: &[Sample]) -> Panel {
    let law = &design.cam.law;
    let unit = design.cam.follower.measures().force();
    let mut lines = vec![line_of("main", samples, |s| s.force)];
    if let Some(target) = design.target() {
        lines.push(line_of("target", samples, |s| {
            curve::target_at(target, law, s.theta)
        }));
    }
    if let Some([low, high]) = design.band() {
        lines.push(line_of("low", samples, |s| {
            curve::target_at(low, law, s.theta)
        }));
        lines.push(line_of("high", samples, |s| {
            curve::target_at(high, law, s.theta)
        }));
    }
    lines.extend(walkers::lines(design, samples));
    panel(design, Diagram::Force, unit, lines)
}

fn radius(design: &Design, samples: &[Sample]) -> Panel {
    let cam = &design.cam;
    let radii = samples.iter().map(|s| s.point.rho.abs());
    let most = curve::largest_radius(cam, STRAIGHT, radii);
    let rho = |s: &Sample| {
        if s.point.rho.abs() > most {
            f64::NAN
        } else {
            MM * s.point.rho
        }
    };
    panel(
        design,
        Diagram::Radius,
        LENGTH,
        vec![line_of("main", samples, rho)],
    )
}

/// Diagram of the pressure angle in degrees, or of the contact displacement on a flat face in mm.
fn contact(design: &Design, samples: &[Sample]) -> Panel {
    let cam = &design.cam;
    if cam.contact_travel().is_some() {
        let line = line_of("main", samples, |s| MM * cam.contact_along(s.at));
        return panel(design, Diagram::Contact, LENGTH, vec![line]);
    }
    let angle = |s: &Sample| match &design.groove {
        Some(groove) => groove.pressure_angle(s.theta, groove.depth().0),
        None => s.point.pressure_angle,
    };
    let unit = Unit {
        factor: 180.0 / std::f64::consts::PI,
        name: "°",
    };
    let line = line_of("main", samples, |s| angle(s).to_degrees());
    panel(design, Diagram::PressureAngle, unit, vec![line])
}

/// Horizontal lines of the limits in a diagram. `factor` converts SI units to the unit of the diagram.
fn levels(design: &Design, diagram: Diagram, factor: f64, lowest: f64) -> Vec<Level> {
    let mut out = Vec::new();
    for check in &design.checks {
        let Some(kind) = check.name.limit() else {
            continue;
        };
        let Some((_, lines)) = kind.facts().diagram.filter(|shown| shown.0 == diagram) else {
            continue;
        };
        let key = key(design, kind);
        let from = lines.origin(lowest).and_then(short);
        let heights = lines.heights(factor * check.limit, lowest).into_iter();
        let level = |y: f64| Level {
            y: short(y),
            key,
            from,
        };
        out.extend(heights.map(level).filter(|level| level.y.is_some()));
    }
    out
}

/// Key that sets a limit, or an empty text. One key sets the limits of the pressure angle during rise and during fall, unless the scene
/// limits one of them separately.
fn key(design: &Design, kind: LimitKind) -> &'static str {
    let both = LimitKind::PressureAngle;
    let alone = design.problem.value(kind.into()).is_some();
    let is_of_both = both.is_measured_by(kind.into()) && !alone;
    let own = if is_of_both { both } else { kind };
    keys::of_limit(own).map_or("", |key| key.path)
}
