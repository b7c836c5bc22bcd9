//! The rows of the key table, and the conditions on which rows depend.

use std::f64::consts::TAU;

use super::field::{Access, Field, Words, entry, field};
use super::kind::Range::{Acute, Any, Between, NotNegative, Positive};
use super::kind::Relax::{Down, Up};
use super::kind::{Idle, Kind, Measure, Range};
use super::row::Key;
use super::special::{
    ACCURACY, FILE, FOLLOWER_MATERIAL, FORCE_MIN, HARMONICS, HERTZ_PRESSURE, LEARNED_FORCE,
    MATERIAL, MODEL, NONE, OFFSET, PRESSURE_ANGLE, STEP_FREQUENCY, both_sides, constant, limit,
    one_side,
};
use crate::cam::{FollowerKind, Stock};
use crate::drive::DriveKind;
use crate::force::{self, Feet, Kind as Movement};
use crate::law::Rise;
use crate::scene::{
    ErrorMeasure, Family, ForceScale, Gait, LimitKind, Minimise, Scene, ShaftSpeed,
};
use crate::units::Dimension::{self, *};

/// Maximum number of spans of a spline. With more spans, a certified optimum in reasonable time is not guaranteed.
const MOST_SPANS: usize = 400;
/// Maximum degree of a polynomial.
const HIGHEST_DEGREE: usize = 30;
/// Maximum number of harmonics.
const MOST_HARMONICS: usize = 400;
/// Maximum weight of a range of phases. With a larger weight, rounding errors of the mean square exceed the effect of the other phases.
const LARGEST_WEIGHT: f64 = 1e6;
/// Maximum number of walkers on a structure.
const MOST_WALKERS: usize = 1000;
/// Maximum number of turns of a barrel cam.
const MOST_TURNS: usize = 100;

/// All keys, in the order of a scene file. A row must follow the rows on which its conditions depend. The columns are path, kind and range of the
/// value, default, field, and conditions.
#[rustfmt::skip]
pub static KEYS: &[Key] = &[
    row("name", TEXT, "cam", field!(name)),

    row("gait.file",            TEXTS,                                "",      FILE),
    row("gait.model",           MODELS,                               "",      MODEL),
    row("gait.harmonics",       TEXTS,                                "",      HARMONICS),
    row("gait.step_frequency",  number(Frequency, Positive).or_several(), "auto", STEP_FREQUENCY).idle_when(over_recordings),
    row("gait.body_weight",     number(Force, Positive),              "auto",  field!(gait?.body_weight)).idle_when(over_recordings),
    row("gait.time",            TEXT,                                 "",      field!(gait?.time)).idle_when(over_models),
    row("gait.force",           TEXTS,                                "",      field!(gait?.force)).idle_when(over_models),
    row("gait.unit",            TEXT,                                 "",      field!(gait?.unit)).idle_when(over_models),
    row("gait.rate",            number(Frequency, Positive),          "auto",  field!(gait?.rate)).idle_when(over_models),
    row("gait.mass",            number(Mass, Positive),               "auto",  field!(gait?.mass)).idle_when(over_models),
    row("gait.period",          number(Time, Positive),               "auto",  field!(gait?.period)).idle_when(over_models),
    row("gait.span",            number(Angle, Between(0.0, TAU)),    "auto",  field!(gait?.span)).idle_when(over_models),
    row("gait.noise",           number(Force, NotNegative),           "auto",  field!(gait?.noise)).idle_when(over_models),
    row("gait.kind",            words::<Movement>(),                  "",      field!(gait?.kind)).idle_when(over_models),
    row("gait.accept",          TEXT,                                 "",      field!(gait?.accept)).idle_when(over_models),
    row("gait.leave_out",       TEXTS,                                "",      field!(gait?.leave_out)).idle_when(over_models),
    row("gait.adjust",          TEXTS,                                "auto",  field!(gait?.adjust)),
    row("gait.feet",            words::<Feet>(),                      "both",  field!(gait?.feet)),
    row("gait.scale",           words::<ForceScale>(),                "none",  field!(gait?.scale)).idle_when(off_moving_axis),
    row("gait.band",            number(Force, Positive).or("spread"), "",      field!(gait?.band)),
    row("gait.phase",           number(Angle, Any).or("free"),        "0 deg", field!(gait?.phase)),
    row("gait.weight.N.from",   number(Angle, Any),                   "",      field!(gait?.weights[N].from)).required(),
    row("gait.weight.N.to",     number(Angle, Any),                   "",      field!(gait?.weights[N].to)).required(),
    row("gait.weight.N.weight", number(Ratio, Between(0.0, LARGEST_WEIGHT)), "", field!(gait?.weights[N].weight)).required(),

    row("cam.follower",                words::<FollowerKind>(),             "flat-translating", field!(cam.follower)),
    row("cam.prime_radius",            number(Length, Positive),            "auto",             field!(cam.prime_radius)).relax(Up),
    row("cam.base_radius",             number(Length, Positive),            "auto",             field!(cam.base_radius)).relax(Up),
    row("cam.offset",                  number(Length, Any).or("auto"),      "0",                OFFSET).only(translates).idle_when(flat_translating),
    row("cam.roller_radius",           number(Length, Positive),            "",                 field!(cam.roller_radius)).only(has_roller).required(),
    row("cam.arc_radius",              number(Length, Positive),            "",                 field!(cam.roller_radius)).only(is_mushroom).required(),
    row("cam.pivot_distance",          number(Length, Any),                 "",                 field!(cam.pivot_distance)).only(is_on_arm).required(),
    row("cam.arm",                     number(Length, Positive),            "",                 field!(cam.arm)).only(|s| is_on_arm(s) && !is_flat(s)).required(),
    row("cam.face_offset",             number(Length, Any),                 "0",                field!(cam.face_offset)).only(|s| is_on_arm(s) && is_flat(s)),
    row("cam.pivot_beside",            FLAG,                                "false",            field!(cam.pivot_beside)).only(is_on_arm),
    row("cam.bore",                    number(Length, Positive),            "",                 field!(cam.bore)).relax(Down).only(turns),
    row("cam.keyway",                  number(Length, Positive).or("auto"), "",                 field!(cam.keyway)).only(turns),
    row("cam.mark",                    FLAG,                                "false",            field!(cam.mark)).only(is_disc),
    row("cam.thickness",               number(Length, Positive),            "10 mm",            field!(cam.thickness)),
    row("cam.material",                TEXT,                                "",                 MATERIAL),
    row("cam.material.young",              number(Pressure, Positive),      "",      constant!(material.young)),
    row("cam.material.poisson",            number(Ratio, Between(0.0, 0.5)), "",     constant!(material.poisson)),
    row("cam.material.allowable_pressure", number(Pressure, Positive),      "",      constant!(material.allowable_pressure)),
    row("cam.follower_material",                    words::<Stock>(),               "", FOLLOWER_MATERIAL),
    row("cam.follower_material.young",              number(Pressure, Positive),      "",      constant!(follower_material.young)),
    row("cam.follower_material.poisson",            number(Ratio, Between(0.0, 0.5)), "",     constant!(follower_material.poisson)),
    row("cam.follower_material.allowable_pressure", number(Pressure, Positive),      "",      constant!(follower_material.allowable_pressure)),
    row("cam.hardness",                TEXT,                                "",                 field!(cam.making.hardness)),
    row("cam.roughness",               number(Length, Positive),            "",                 field!(cam.making.roughness)).only(is_disc),
    row("cam.tolerance",               number(Length, Positive),            "",                 field!(cam.making.tolerance)).only(is_disc),
    row("cam.breadth",                 number(Length, Positive),            "",                 field!(cam.breadth)).only(translates),
    row("cam.travel",                  number(Length, Positive),            "auto",             field!(cam.travel)).only(is_straight),
    row("cam.turns",                   count(MOST_TURNS),                   "1",                field!(cam.turns)).only(is_barrel),
    row("cam.depth",                   number(Length, Positive),            "auto",             field!(cam.depth)).only(is_barrel),
    row("cam.roller_eccentricity",     number(Length, Positive),            "",                 field!(cam.eccentricity)).only(is_barrel),
    row("cam.conjugate.distance",      number(Length, Positive),            "",                 field!(cam.conjugate?.distance)).only(|s| is_disc(s) && !is_on_arm(s)),
    row("cam.conjugate.angle",         number(Angle, Positive),             "",                 field!(cam.conjugate?.angle)).only(is_on_arm),
    row("cam.conjugate.base_radius",   number(Length, Positive),            "",                 field!(cam.conjugate?.base_radius)).only(is_disc),
    row("cam.conjugate.roller_radius", number(Length, Positive),            "auto",             field!(cam.conjugate?.roller_radius)).only(|s| is_disc(s) && (has_roller(s) || is_mushroom(s))),

    row("drive.kind",                words::<DriveKind>(),                "",           field!(drive.kind)),
    row("drive.mass",                number(Mass, Positive),              "auto",       field!(drive.mass)).only(|s| !is_on_arm(s)).idle_when(hydraulic),
    row("drive.inertia",             number(Inertia, Positive),           "auto",       field!(drive.mass)).only(is_on_arm).idle_when(hydraulic),
    row("drive.lever",               number(Length, Positive),            "auto",       field!(drive.lever)).only(is_on_arm),
    row("drive.speed",               SPEED,                               "auto",       field!(drive.speed)),
    row("drive.gravity",             number(Acceleration, Positive),      "9.81 m/s^2", field!(drive.gravity)),
    row("drive.spring_rate",         by_arm(SpringRate, AngularRate, NotNegative), "0", field!(drive.spring_rate)).only(is_fixed_axis),
    row("drive.preload",             by_arm(Force, Torque, Any),          "0",          field!(drive.preload)).only(is_fixed_axis),
    row("drive.damping",             number(Damping, NotNegative),        "0",          field!(drive.damping)).only(|s| is_fixed_axis(s) && !is_on_arm(s)),
    row("drive.pressure_per_volume", number(PressurePerVolume, Positive), "",           field!(drive.pressure_per_volume)).only(is_hydraulic).required(),
    row("drive.piston_radius",       number(Length, Positive),            "",           field!(drive.piston_radius)).only(is_hydraulic).required(),

    row("law.family",               words::<Family>(),                   "",      field!(law.family)),
    row("law.degree",               count(HIGHEST_DEGREE),               "auto",  field!(law.degree)).idle_when(neither_fitted_nor_polynomial),
    row("law.spans",                count(MOST_SPANS),                   "auto",  field!(law.spans)).idle_when(not_fitted),
    row("law.harmonics",            count(MOST_HARMONICS),               "auto",  field!(law.harmonics)).idle_when(not_harmonic),
    row("law.minimise",             words::<Minimise>(),                 "",      field!(law.minimise)).idle_when(not_fitted),
    row("law.robust",               TEXT,                                "mean",  field!(law.robust)).idle_when(no_force),
    row("law.error",                words::<ErrorMeasure>(),             "relative", field!(law.error)).idle_when(no_force),
    row("law.monotone",             FLAG,                                "false", field!(law.monotone)).idle_when(not_fitted),
    row("law.polydyne",             FLAG,                                "false", field!(law.polydyne)),
    row("law.shaft",                words::<ShaftSpeed>(),               "motor", field!(law.shaft)).only(turns).idle_when(no_motor),
    row("law.point.N.angle",        number(Angle, Any),                  "",      field!(law.points[N].angle)).required().idle_when(neither_fitted_nor_polynomial),
    row("law.point.N.lift",         lift(0),                             "",      field!(law.points[N].lift)),
    row("law.point.N.force",        number(Force, Any),                  "",      field!(law.points[N].force)),
    row("law.point.N.velocity",     lift(1),                             "",      field!(law.points[N].velocity)),
    row("law.point.N.acceleration", lift(2),                             "",      field!(law.points[N].acceleration)),
    row("law.point.N.jerk",         lift(3),                             "",      field!(law.points[N].jerk)),
    row("law.dwell.N.from",         number(Angle, Any),                  "",      field!(law.dwells[N].from)).required().idle_when(not_fitted),
    row("law.dwell.N.to",           number(Angle, Any),                  "",      field!(law.dwells[N].to)).required(),
    row("law.dwell.N.lift",         lift(0),                             "",      field!(law.dwells[N].lift)),
    row("law.segment.N.motion",     TEXT,                                "dwell", field!(law.segments[N].motion)),
    row("law.segment.N.lift",       lift(0),                             "0",     field!(law.segments[N].lift)),
    row("law.segment.N.angle",      number(Angle, Positive),             "",      field!(law.segments[N].angle)).only(|s| !is_straight(s)).required().idle_when(no_program),
    row("law.segment.N.length",     number(Length, Positive),            "",      field!(law.segments[N].angle)).only(is_straight).required().idle_when(no_program),

    limit!("limits.stroke",         Stroke,        by_arm(Length, Angle, Positive)),
    limit!("limits.velocity",       Velocity,      by_arm(Speed, AngularSpeed, Positive)),
    limit!("limits.acceleration",   Acceleration,  by_arm(Acceleration, AngularAcceleration, Positive)),
    limit!("limits.jerk",           Jerk,          by_arm(Jerk, AngularJerk, Positive)),
    row("limits.force_min",         by_arm(Force, Torque, Any).or(NONE), "", FORCE_MIN).limit(LimitKind::ForceMin),
    limit!("limits.force_max",      ForceMax,      by_arm(Force, Torque, Any)),
    limit!("limits.curvature",      Curvature,     number(Length, NotNegative)),
    row("limits.pressure_angle",    number(Angle, Acute).or(NONE), "", PRESSURE_ANGLE).limit(LimitKind::PressureAngle).read_again(),
    row("limits.pressure_angle_rise", number(Angle, Acute).or(NONE), "", one_side!(PressureAngleRise)).limit(LimitKind::PressureAngleRise),
    row("limits.pressure_angle_fall", number(Angle, Acute).or(NONE), "", one_side!(PressureAngleFall)).limit(LimitKind::PressureAngleFall),
    limit!("limits.prime_radius",   PrimeRadius,   number(Length, Positive)),
    limit!("limits.diameter",       Diameter,      number(Length, Positive)).idle_when(unrolled),
    limit!("limits.face_width",     FaceWidth,     number(Length, Positive)).idle_when(no_face),
    limit!("limits.torque",         Torque,        number(Torque, Positive)),
    limit!("limits.power",          Power,         number(Power, Positive)),
    limit!("limits.power_mean",     PowerMean,     number(Power, Positive)).idle_when(undamped),
    limit!("limits.torque_rate",    TorqueRate,    number(AngularRate, Positive)),
    row("limits.hertz_pressure", number(Pressure, Positive).or(NONE), "", HERTZ_PRESSURE).limit(LimitKind::HertzPressure),
    limit!("limits.residual",       Residual,      by_arm(Length, Angle, Positive)).idle_when(no_dwell),

    row("machine.natural_frequency", number(Frequency, Positive),               "",     field!(machine.natural_frequency)),
    row("machine.stiffness",         by_arm(SpringRate, AngularRate, Positive), "",     field!(machine.stiffness)),
    row("machine.damping_ratio",     number(Ratio, NotNegative),                "0.05", field!(machine.damping_ratio)).idle_when(rigid),
    row("machine.friction",          number(Ratio, NotNegative),                "0",    field!(machine.friction)).idle_when(rolls),
    row("machine.restitution",       number(Ratio, Between(0.0, 1.0)),          "0",    field!(machine.restitution)),
    row("machine.second_cam",        number(Angle, Any),                        "",     field!(machine.second_cam)),
    row("machine.motor.slope",         number(AngularDamping, Positive),        "",     field!(machine.motor.slope)).only(turns),
    row("machine.motor.stall_torque",  number(Torque, Positive),                "",     field!(machine.motor.stall_torque)).only(turns),
    row("machine.motor.no_load_speed", number(AngularSpeed, Positive),          "auto", field!(machine.motor.no_load_speed)).only(turns),
    row("machine.motor.rated_torque",      number(Torque, Positive),            "",     field!(machine.motor.rated_torque)).only(turns),
    row("machine.motor.rated_speed",       number(AngularSpeed, Positive),      "",     field!(machine.motor.rated_speed)).only(turns),
    row("machine.motor.synchronous_speed", number(AngularSpeed, Positive),      "auto", field!(machine.motor.synchronous_speed)).only(turns).idle_when(no_motor),
    row("machine.motor.inertia",           number(Inertia, NotNegative),        "0",    field!(machine.motor.inertia)).only(turns).idle_when(no_motor),
    row("machine.motor.curve",         TEXT,                                    "",     field!(machine.motor.curve)).only(turns),
    row("machine.motor.gear",          number(Ratio, Between(1e-3, 1e3)),       "1",    field!(machine.motor.gear)).only(turns).idle_when(no_motor),
    row("machine.motor.efficiency",    number(Ratio, Between(0.01, 1.0)),       "1",    field!(machine.motor.efficiency)).only(turns).idle_when(no_motor),
    row("machine.inertia",             number(Inertia, Positive),               "",     field!(machine.inertia)).only(turns).idle_when(no_motor),
    row("machine.friction_torque",     number(Torque, NotNegative),             "0",    field!(machine.friction_torque)).only(turns).idle_when(no_motor),
    row("machine.learned_force",       TEXTS,                                   "",     LEARNED_FORCE).only(turns),

    row("machine.floor.mass",          number(Mass, Positive),                  "",     field!(machine.floor.mass)),
    row("machine.floor.frequency",     number(Frequency, Positive),             "",     field!(machine.floor.frequency)),
    row("machine.floor.damping",       number(Ratio, NotNegative),              "",     field!(machine.floor.damping)),
    row("machine.floor.ordinate",      number(Ratio, NotNegative),              "1",    field!(machine.floor.ordinate)).idle_when(no_floor),
    row("machine.floor.mode.N.mass",      number(Mass, Positive),               "",     field!(machine.modes[N].mass)).required(),
    row("machine.floor.mode.N.frequency", number(Frequency, Positive),          "",     field!(machine.modes[N].frequency)).required(),
    row("machine.floor.mode.N.damping",   number(Ratio, NotNegative),           "",     field!(machine.modes[N].damping)).required(),
    row("machine.floor.mode.N.ordinate",  number(Ratio, NotNegative),           "1",    field!(machine.modes[N].ordinate)),
    row("machine.walkers.count",       count(MOST_WALKERS),                     "1",    field!(machine.walkers.count)).idle_when(no_floor),
    row("machine.walkers.phases",      TEXTS,                                   "",     field!(machine.walkers.phases)).idle_when(no_floor),
    row("machine.walkers.weights",     TEXTS,                                   "",     field!(machine.walkers.weights)).idle_when(no_floor),

    row("accuracy.rms", number(Percent, Positive).or(NONE), "auto", ACCURACY).relax(Up).idle_when(no_force),
];

/// Values that a row accepts: kind and range.
struct Takes(Kind, Range);

impl Takes {
    /// Also accepts a word in place of the number.
    const fn or(self, word: &'static str) -> Takes {
        match self {
            Takes(Kind::Number(measure), range) => Takes(Kind::NumberOr(measure, word), range),
            other => other,
        }
    }

    /// Also accepts a range or a distribution in place of the number.
    const fn or_several(self) -> Takes {
        match self {
            Takes(Kind::Number(measure), range) => Takes(Kind::NumberOrSeveral(measure), range),
            other => other,
        }
    }
}

const FLAG: Takes = Takes(Kind::Flag, Any);
const TEXT: Takes = Takes(Kind::Text, Any);
/// The name of a published load model.
const MODELS: Takes = Takes(
    Kind::Choice(|| force::catalogue().iter().map(|m| m.name).collect()),
    Any,
);
const TEXTS: Takes = Takes(Kind::Texts, Any);
/// Speed of the cam: an angular speed, or a velocity for a translating cam.
const SPEED: Takes = Takes(
    Kind::Number(Measure {
        straight: Speed,
        ..Measure::same(AngularSpeed)
    }),
    Positive,
);

/// A number with a unit of the given dimension.
const fn number(dimension: Dimension, range: Range) -> Takes {
    by_arm(dimension, dimension, range)
}

/// A number whose dimension is `arm` for followers on an arm, and `other` for all others.
const fn by_arm(other: Dimension, arm: Dimension, range: Range) -> Takes {
    Takes(Kind::Number(Measure::by_arm(other, arm)), range)
}

/// A number for the derivative of the lift of the given order with respect to the cam angle.
const fn lift(order: u8) -> Takes {
    match order {
        0 => by_arm(Length, Angle, Any),
        n => by_arm(LengthPerAngle(n), AnglePerAngle(n), Any),
    }
}

/// A whole number from 1 to `most`.
const fn count(most: usize) -> Takes {
    Takes(Kind::Count(1, most), Any)
}

/// A word of the closed set of the type `T`.
const fn words<T: Words>() -> Takes {
    Takes(
        Kind::Choice(|| T::words().into_iter().map(|w| w.0).collect()),
        Any,
    )
}

const fn row(path: &'static str, takes: Takes, default: &'static str, access: Access) -> Key {
    Key::new(path, takes.0, takes.1, default, access)
}

fn has_roller(scene: &Scene) -> bool {
    scene.cam.follower.has_roller()
}

fn is_mushroom(scene: &Scene) -> bool {
    scene.cam.follower.is_mushroom()
}

fn is_flat(scene: &Scene) -> bool {
    scene.cam.follower.is_flat()
}

fn is_on_arm(scene: &Scene) -> bool {
    scene.cam.is_oscillating()
}

fn translates(scene: &Scene) -> bool {
    scene.cam.follower.is_translating()
}

fn is_straight(scene: &Scene) -> bool {
    scene.cam.is_straight()
}

fn turns(scene: &Scene) -> bool {
    !is_straight(scene)
}

fn is_barrel(scene: &Scene) -> bool {
    scene.cam.follower == FollowerKind::Barrel
}

fn is_disc(scene: &Scene) -> bool {
    turns(scene) && !is_barrel(scene)
}

fn is_fixed_axis(scene: &Scene) -> bool {
    scene.drive.kind == DriveKind::FixedAxis
}

fn is_hydraulic(scene: &Scene) -> bool {
    scene.drive.kind == DriveKind::Hydraulic
}

fn over_recordings(scene: &Scene) -> Option<Idle> {
    let recording = scene.gait.as_ref().is_some_and(Gait::is_recording);
    recording.then_some(Idle::Recording)
}

fn over_models(scene: &Scene) -> Option<Idle> {
    let model = scene.gait.as_ref().is_some_and(|g| !g.is_recording());
    model.then_some(Idle::Model)
}

fn no_force(scene: &Scene) -> Option<Idle> {
    scene.gait.is_none().then_some(Idle::NoForce)
}

/// The offset has no effect for a translating flat face. Returns the reason, or `None` for other followers.
fn flat_translating(scene: &Scene) -> Option<Idle> {
    (is_flat(scene) && translates(scene)).then_some(Idle::Follower)
}

/// A limit on the diameter applies only to a disc cam. Returns the reason for other cams, or `None` for a disc cam.
fn unrolled(scene: &Scene) -> Option<Idle> {
    (!is_disc(scene)).then_some(Idle::Follower)
}

/// A limit on the length of the face applies only to a flat or arc-shaped face. Returns the reason for other followers, or `None` for such
/// a face.
fn no_face(scene: &Scene) -> Option<Idle> {
    let has_face = is_flat(scene) || scene.cam.follower.is_mushroom();
    (!has_face).then_some(Idle::Follower)
}

/// Without damping and without a learned force, the mean power is 0, so a limit on it has no effect. Returns the reason, or `None`
/// otherwise.
fn undamped(scene: &Scene) -> Option<Idle> {
    let gives_back = scene.drive.damping == 0.0 && scene.machine.learned_force.is_empty();
    gives_back.then_some(Idle::Drive)
}

fn off_moving_axis(scene: &Scene) -> Option<Idle> {
    (scene.drive.kind != DriveKind::MovingAxis).then_some(Idle::Drive)
}

fn hydraulic(scene: &Scene) -> Option<Idle> {
    is_hydraulic(scene).then_some(Idle::Drive)
}

/// Sliding friction has no effect for a roller. Returns the reason, or `None` for other followers.
fn rolls(scene: &Scene) -> Option<Idle> {
    has_roller(scene).then_some(Idle::Follower)
}

/// Keys of the follower's vibration have no effect for a rigid follower. Returns the reason, or `None` for a flexible follower.
fn rigid(scene: &Scene) -> Option<Idle> {
    let machine = &scene.machine;
    let is_flexible = machine.natural_frequency.is_some() || machine.stiffness.is_some();
    (!is_flexible).then_some(Idle::RigidFollower)
}

/// Without a motor torque, the speed is constant, so keys of the motor and the shaft have no effect. Returns the reason, or `None` with a
/// motor.
fn no_motor(scene: &Scene) -> Option<Idle> {
    (!scene.machine.motor.is_given()).then_some(Idle::NoMotor)
}

/// Walkers have no effect on a rigid floor. Returns the reason, or `None` for a moving floor.
fn no_floor(scene: &Scene) -> Option<Idle> {
    (!scene.machine.has_floor()).then_some(Idle::StiffFloor)
}

/// A limit on the vibration in a dwell has no effect for a law without dwells. Returns the reason, or `None` for a law with a dwell.
fn no_dwell(scene: &Scene) -> Option<Idle> {
    let law = &scene.law;
    let rests = law.segments.iter().any(|s| s.motion == Rise::Dwell);
    (!rests && law.dwells.is_empty()).then_some(Idle::NoDwell)
}

fn unless(scene: &Scene, families: &[Family]) -> Option<Idle> {
    (!families.contains(&scene.law.family)).then_some(Idle::Family)
}

fn not_fitted(scene: &Scene) -> Option<Idle> {
    unless(scene, &[Family::Auto, Family::Spline])
}

fn neither_fitted_nor_polynomial(scene: &Scene) -> Option<Idle> {
    not_fitted(scene).filter(|_| scene.law.family != Family::Polynomial)
}

fn not_harmonic(scene: &Scene) -> Option<Idle> {
    unless(scene, &[Family::Auto, Family::Harmonic])
}

fn no_program(scene: &Scene) -> Option<Idle> {
    unless(scene, &[Family::Program])
}
