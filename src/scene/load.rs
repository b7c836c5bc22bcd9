//! From TOML to a [`Scene`].

use std::path::PathBuf;

use toml::{Table, Value};

use super::table::Reader;
use super::{
    Band, CamSpec, DriveSpec, Dwell, Family, Gait, LawPoint, LawSpec, Minimise, Phase, PhaseWeight,
    Scene, SegmentSpec, Source,
};
use crate::drive::DriveKind;
use crate::error::{Error, Result};
use crate::gait::Feet;
use crate::units::{Dimension, G};

/// Most spans of a spline: beyond this the law is a table, not a law.
const MOST_SPANS: usize = 10_000;
/// Weight of the walker that the load models were published for, N.
const MODEL_WEIGHT: f64 = 700.0;

/// Reads a scene from its table. Errors name the dotted key.
pub fn read(table: &Table) -> Result<Scene> {
    let scene = read_keys(table)?;
    consistent(&scene)?;
    Ok(scene)
}

/// The same, each key by itself: whether the keys go together is not asked.
pub fn read_keys(table: &Table) -> Result<Scene> {
    let mut root = Reader::new(table, "");
    let name = root.text("name")?.unwrap_or("cam").to_string();
    if name.is_empty() || name.contains(['/', '\\', '\0']) || name.starts_with('.') {
        return Err(
            Error::key("name", format!("\"{name}\" cannot name an output folder"))
                .help("use letters, digits, - and _"),
        );
    }
    let gait = root.table("gait")?.map(gait).transpose()?;
    // The follower decides what lift and angle are measured in.
    let cam = super::cam::read(root.table("cam")?)?;
    let drive = drive(root.table("drive")?, &cam)?;
    let law = law(root.table("law")?, &cam, gait.as_ref())?;
    let limits = super::limits::limits(root.table("limits")?, cam.is_oscillating())?;
    let rms = super::limits::accuracy(root.table("accuracy")?)?;
    let machine = super::limits::machine(root.table("machine")?, cam.is_oscillating())?;
    root.finish()?;
    if limits.residual.is_some() && machine.natural_frequency.is_none() {
        return Err(
            Error::key("machine.natural_frequency", "a limit on vibration needs it")
                .help("write for example \"60 Hz\" under [machine]"),
        );
    }
    Ok(Scene {
        name,
        gait,
        drive,
        law,
        cam,
        limits,
        machine,
        rms,
    })
}

/// The table at a dotted path, made where it is missing; entries of a list go by their number from 1 on:
/// `law.segment.2`.
fn inside<'t>(table: &'t mut Table, path: &[&str]) -> std::result::Result<&'t mut Table, String> {
    let [part, rest @ ..] = path else {
        return Ok(table);
    };
    if let Some(number) = rest.first().filter(|n| n.parse::<usize>().is_ok())
        && !table.contains_key(*part)
    {
        return Err(format!("there is no {part}.{number}; none is given"));
    }
    let entry = table
        .entry((*part).to_string())
        .or_insert_with(|| Value::Table(Table::new()));
    match entry {
        Value::Table(inner) => inside(inner, rest),
        Value::Array(list) => {
            let given = list.len();
            let [number, rest @ ..] = rest else {
                return Err(format!(
                    "{part} is a list of {given}; write {part}.1 for the first"
                ));
            };
            let index = number.parse::<usize>().ok().and_then(|k| k.checked_sub(1));
            match index.and_then(|i| list.get_mut(i)) {
                Some(Value::Table(inner)) => inside(inner, rest),
                _ => Err(format!("there is no {part}.{number}; {given} are given")),
            }
        }
        _ => Err(format!("{part} is a value, not a table")),
    }
}

/// Changes one value: `set(table, "limits.stroke=40 mm")`. The value is taken as TOML where it is a
/// number, truth value, array or quoted text, and as plain text otherwise.
pub fn set(table: &mut Table, assignment: &str) -> Result<()> {
    let fault =
        |what: String| Error::argument("--set", what).help("write --set 'limits.stroke=40 mm'");
    let (key, value) = assignment
        .split_once('=')
        .ok_or_else(|| fault(format!("\"{assignment}\" has no =")))?;
    let value = value.trim();
    let parsed = format!("x = {value}")
        .parse::<Table>()
        .ok()
        .and_then(|mut t| t.remove("x"));
    let value = parsed.unwrap_or_else(|| Value::String(value.to_string()));
    let parts: Vec<&str> = key.trim().split('.').collect();
    let (last, path) = parts
        .split_last()
        .ok_or_else(|| fault("empty key".to_string()))?;
    let at = inside(table, path).map_err(|what| fault(format!("\"{key}\": {what}")))?;
    // A recording takes the place of the scene's model and the other way round.
    match key.trim() {
        "gait.file" => drop(at.remove("model")),
        "gait.model" => drop(at.remove("file")),
        _ => {}
    }
    at.insert((*last).to_string(), value);
    Ok(())
}

fn gait(mut r: Reader) -> Result<Gait> {
    let file = r.text("file")?;
    let model = r.text("model")?;
    let feet = r.text("feet")?;
    let key = r.name("feet");
    let feet: Feet = feet
        .unwrap_or("both")
        .parse()
        .map_err(|e: Error| e.at(crate::error::Place::Key(key)))?;
    let to_mass = r
        .choice("scale", &[("none", false), ("to-mass", true)])?
        .unwrap_or(false);
    let step_frequency_hz = r.positive("step_frequency", Dimension::Frequency)?;
    let body_weight_n = r.positive("body_weight", Dimension::Force)?;
    let time = r.text("time")?.map(str::to_string);
    let force = r.texts("force")?;
    let unit = r.text("unit")?.map(str::to_string);
    let rate_hz = r.positive("rate", Dimension::Frequency)?;
    let mass_kg = r.positive("mass", Dimension::Mass)?;
    let source = match (file, model) {
        (Some(path), None) => Source::File {
            path: PathBuf::from(path),
            time,
            force,
            unit,
            rate_hz,
            mass_kg,
        },
        (None, Some(name)) => Source::Model {
            name: name.to_string(),
            step_frequency_hz,
            body_weight_n: body_weight_n.unwrap_or(MODEL_WEIGHT),
        },
        (Some(_), Some(_)) => {
            return Err(Error::key("gait", "says both file and model")
                .help("keep one: file = \"walk.mot\" or model = \"young\""));
        }
        (None, None) => {
            return Err(Error::key("gait.file", "no recording and no model is named").help(
                "give --set gait.file=walk.mot, or write file = \"walk.mot\" or model = \"young\"; \
                 leave [gait] out for a classical programme",
            ));
        }
    };
    let band = match r.text("band")? {
        Some("spread") => Some(Band::Spread),
        Some(_) => r.positive("band", Dimension::Force)?.map(Band::Width),
        None => None,
    };
    let phase = match r.text("phase")? {
        Some("free") => Phase::Free,
        _ => Phase::At(r.quantity("phase", Dimension::Angle)?.unwrap_or(0.0)),
    };
    let weights = weights(&mut r)?;
    r.finish()?;
    Ok(Gait {
        source,
        feet,
        to_mass,
        band,
        weights,
        phase,
    })
}

fn weights(r: &mut Reader) -> Result<Vec<PhaseWeight>> {
    let mut out = Vec::new();
    for mut w in r.tables("weight")? {
        let missing = |key: String| {
            Error::key(&key, "a weight needs it")
                .help("write from = \"0 deg\", to = \"60 deg\", weight = 4")
        };
        let (from_key, to_key, weight_key) = (w.name("from"), w.name("to"), w.name("weight"));
        let one = PhaseWeight {
            from: w
                .quantity("from", Dimension::Angle)?
                .ok_or_else(|| missing(from_key.clone()))?,
            to: w
                .quantity("to", Dimension::Angle)?
                .ok_or_else(|| missing(to_key))?,
            weight: w
                .not_negative("weight", Dimension::Ratio)?
                .ok_or_else(|| missing(weight_key.clone()))?,
        };
        if one.weight > LARGEST_WEIGHT {
            return Err(Error::key(
                &weight_key,
                format!("{} drowns the rest of the cycle", one.weight),
            )
            .help("weights from 0 to 1000000; 1 is what all else has"));
        }
        let inside = |x: f64| (-1e-9..=std::f64::consts::TAU + 1e-9).contains(&x);
        if !inside(one.from) || !inside(one.to) || one.from == one.to {
            return Err(Error::key(
                &from_key,
                format!(
                    "{:.3}° to {:.3}° is no range of one cycle",
                    one.from.to_degrees(),
                    one.to.to_degrees()
                ),
            )
            .help("phases run from 0 to 360 deg; a range over the end has to < from"));
        }
        out.push(one);
        w.finish()?;
    }
    let turn = std::f64::consts::TAU;
    let covered: f64 = (out.iter())
        .map(|w: &PhaseWeight| (w.to - w.from).rem_euclid(turn))
        .map(|length| if length < 1e-9 { turn } else { length })
        .sum();
    if covered >= turn - 1e-9 && out.iter().all(|w| w.weight == 0.0) {
        return Err(
            Error::key(&r.name("weight"), "no phase of the cycle counts")
                .help("give one range a weight above 0"),
        );
    }
    Ok(out)
}

fn drive(reader: Option<Reader>, cam: &CamSpec) -> Result<DriveSpec> {
    // Only a cam that turns under a sliding follower can carry its own shaft.
    let usual = if cam.is_oscillating() || cam.is_straight() || cam.follower == "barrel" {
        DriveKind::FixedAxis
    } else {
        DriveKind::MovingAxis
    };
    let mut spec = DriveSpec {
        kind: usual,
        mass: None,
        speed: None,
        gravity: G,
        pressure_per_volume: 0.0,
        piston_radius: 0.0,
        spring_rate: 0.0,
        preload: 0.0,
        damping: 0.0,
    };
    let Some(mut r) = reader else { return Ok(spec) };
    let kinds = [
        DriveKind::MovingAxis,
        DriveKind::FixedAxis,
        DriveKind::Hydraulic,
    ]
    .map(|k| (k.name(), k));
    spec.kind = r.choice("kind", &kinds)?.unwrap_or(usual);
    let arm = cam.is_oscillating();
    spec.mass = r.positive("mass", Dimension::Mass)?;
    if arm {
        if spec.mass.is_some() {
            return Err(Error::key(
                "drive.mass",
                "an arm's lift is an angle, on which no mass acts",
            )
            .help("give its moment of inertia about the pivot: inertia = \"0.02 kg m^2\""));
        }
        spec.mass = r.positive("inertia", Dimension::Inertia)?;
    }
    let per_time = if cam.is_straight() {
        Dimension::Speed
    } else {
        Dimension::AngularSpeed
    };
    spec.speed = r.positive("speed", per_time)?;
    spec.gravity = r.positive("gravity", Dimension::Acceleration)?.unwrap_or(G);
    match spec.kind {
        DriveKind::MovingAxis => {}
        DriveKind::FixedAxis => {
            spec.spring_rate = r
                .not_negative(
                    "spring_rate",
                    if arm {
                        Dimension::AngularRate
                    } else {
                        Dimension::SpringRate
                    },
                )?
                .unwrap_or(0.0);
            let preload = if arm {
                Dimension::Torque
            } else {
                Dimension::Force
            };
            spec.preload = r.quantity("preload", preload)?.unwrap_or(0.0);
            if !arm {
                spec.damping = r
                    .not_negative("damping", Dimension::Damping)?
                    .unwrap_or(0.0);
            }
        }
        DriveKind::Hydraulic => {
            let missing = |key: &str, example: &str| {
                Error::key(&format!("drive.{key}"), "a hydraulic drive needs it")
                    .help(format!("write for example {example}"))
            };
            spec.pressure_per_volume = r
                .positive("pressure_per_volume", Dimension::PressurePerVolume)?
                .ok_or_else(|| missing("pressure_per_volume", "\"30 psi/in^3\""))?;
            spec.piston_radius = r
                .positive("piston_radius", Dimension::Length)?
                .ok_or_else(|| missing("piston_radius", "\"0.75 in\""))?;
        }
    }
    r.finish()?;
    Ok(spec)
}

fn law(reader: Option<Reader>, cam: &CamSpec, gait: Option<&Gait>) -> Result<LawSpec> {
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
        let key = s.name("angle");
        spec.segments.push(SegmentSpec {
            motion: s.text("motion")?.unwrap_or("dwell").to_string(),
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

pub(super) fn lift_dimension(oscillating: bool, order: u8) -> Dimension {
    match (oscillating, order) {
        (true, 0) => Dimension::Angle,
        (true, n) => Dimension::AnglePerAngle(n),
        (false, 0) => Dimension::Length,
        (false, n) => Dimension::LengthPerAngle(n),
    }
}

/// Largest weight of a phase: beyond it the mean square loses the other phases' digits.
const LARGEST_WEIGHT: f64 = 1e6;

/// Demands that only the whole scene can contradict.
fn consistent(scene: &Scene) -> Result<()> {
    super::cam::consistent(scene)?;
    let law = &scene.law;
    if let Some(gait) = &scene.gait
        && !matches!(law.family, Family::Spline | Family::Ladder)
    {
        let only_splines = |key: &str| {
            let family = law.family.name();
            Err(
                Error::key(key, format!("a {family} law is not fitted to it"))
                    .help("use law.family = \"spline\""),
            )
        };
        if gait.band.is_some() {
            return only_splines("gait.band");
        }
        if !gait.weights.is_empty() {
            return only_splines("gait.weight");
        }
        if law.minimise == Some(Minimise::PeakForceError) {
            return only_splines("law.minimise");
        }
    }
    polydyne(scene)?;
    match law.family {
        Family::Program if law.segments.is_empty() => {
            return Err(Error::key("law.segment", "a program needs its segments").help(
                "write [[law.segment]] motion = \"cycloidal\" lift = \"10 mm\" angle = \"90 deg\" for each",
            ));
        }
        Family::Polynomial if law.points.len() < 2 => {
            return Err(
                Error::key("law.point", "a polynomial needs at least two points").help(
                    "write [[law.point]] angle = \"0 deg\" lift = \"0\" velocity = \"0\" for each",
                ),
            );
        }
        Family::Polynomial | Family::Program => {}
        _ if scene.gait.is_none() && law.points.is_empty() && law.dwells.is_empty() => {
            return Err(Error::key("gait", "nothing is asked of the law").help(
                "add [gait] with a force, [[law.point]]s, or family = \"program\" with segments",
            ));
        }
        _ => {}
    }
    if scene.gait.is_none() && scene.drive.speed.is_none() {
        return Err(Error::key(
            "drive.speed",
            "\"auto\" needs a force cycle to take the speed from",
        )
        .help("write for example \"60 rpm\""));
    }
    if scene.gait.is_none()
        && scene.drive.kind == DriveKind::MovingAxis
        && scene.drive.mass.is_none()
    {
        return Err(Error::key(
            "drive.mass",
            "\"auto\" needs a force cycle to take the mass from",
        )
        .help("write for example \"70 kg\""));
    }
    Ok(())
}

/// What a polydyne cam needs of the scene.
fn polydyne(scene: &Scene) -> Result<()> {
    let (law, machine) = (&scene.law, &scene.machine);
    if !law.polydyne {
        return Ok(());
    }
    if machine.natural_frequency.is_none() && machine.stiffness.is_none() {
        return Err(Error::key(
            "machine.stiffness",
            "a polydyne cam needs to know how the follower gives",
        )
        .help("write stiffness = \"9 kN/m\" or natural_frequency = \"60 Hz\" under [machine]"));
    }
    if matches!(law.family, Family::Auto | Family::DoubleHarmonic) {
        return Err(Error::key(
            "law.family",
            format!(
                "a polydyne cam needs a law with four continuous derivatives, which {} does not promise",
                law.family.name()
            ),
        )
        .help("use family = \"spline\" or \"harmonic\", or a program of 5-6-7-8-9 segments"));
    }
    if law.family == Family::Spline && law.degree.is_some_and(|d| d < POLYDYNE_DEGREE) {
        return Err(Error::key(
            "law.degree",
            "a polydyne cam has the force in its lift: below degree 5 its acceleration would jump",
        )
        .help("use degree 5 to 9; each degree above 5 also takes in one term of the damping"));
    }
    if scene.cam.is_straight() {
        return Err(Error::key(
            "cam.follower",
            "a polydyne cam has to turn: a slide that ends has no steady motion",
        )
        .help("leave law.polydyne out, or use another follower"));
    }
    if scene.cam.breadth.is_some() {
        return Err(Error::key(
            "cam.breadth",
            "a polydyne cam keeps no breadth: the follower gives differently half a turn later",
        )
        .help("leave law.polydyne or cam.breadth out"));
    }
    Ok(())
}

/// Least degree of a spline whose polydyne cam has a continuous acceleration.
const POLYDYNE_DEGREE: usize = 5;
