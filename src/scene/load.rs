//! From TOML to a [`Scene`].

use toml::{Table, Value};

use super::table::Reader;
use super::{Family, Minimise, Scene};
use crate::drive::DriveKind;
use crate::error::{Error, Result};
use crate::units::Dimension;

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
    let gait = root.table("gait")?.map(super::gait::read).transpose()?;
    // The follower decides what lift and angle are measured in.
    let cam = super::cam::read(root.table("cam")?)?;
    let drive = super::drive::read(root.table("drive")?, &cam)?;
    let law = super::law::read(root.table("law")?, &cam, gait.as_ref())?;
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

pub(super) fn lift_dimension(oscillating: bool, order: u8) -> Dimension {
    match (oscillating, order) {
        (true, 0) => Dimension::Angle,
        (true, n) => Dimension::AnglePerAngle(n),
        (false, 0) => Dimension::Length,
        (false, n) => Dimension::LengthPerAngle(n),
    }
}

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
        if matches!(law.minimise, Some(Minimise::Weighed(_))) {
            return only_splines("law.weigh");
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
