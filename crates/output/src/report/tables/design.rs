//! The design in numbers: drive, law, cam, machine, load factors.

use std::fmt::Write;

use super::{Rows, cells, row, table};
use crate::report::heading;
use crate::words::Words;
use gaitcam::cam::{Follower, Measures, Unit};
use gaitcam::drive::DriveKind;
use gaitcam::synth::Design;
use gaitcam_base::text::escaped;
use gaitcam_base::text::{degrees, millimetres, number, range};

/// Drive, law and cam in numbers.
pub fn numbers(out: &mut String, synthesis: &Design, words: &Words) {
    heading(out, &words.text("report-data"));
    out.push_str("<div class=\"columns\">\n");
    table(out, words, "report-drive", &drive(synthesis, words));
    table(out, words, "report-law", &law(synthesis, words));
    table(out, words, "report-cam", &cam(synthesis, words));
    let machine = machine(synthesis, words);
    if !machine.is_empty() {
        table(out, words, "report-loads", &machine);
    }
    load_factors(out, synthesis, words);
    out.push_str("</div>\n");
}

/// A factor that prints as zero has no phase.
const LEAST_FACTOR: f64 = 5e-5;

/// Harmonics of target and achieved force as parts of the weight, as codes for footbridges quote them.
fn load_factors(out: &mut String, synthesis: &Design, words: &Words) {
    let all = synthesis.load_factors();
    if all.is_empty() {
        return;
    }
    let weight = synthesis
        .problem
        .weight_n
        .unwrap_or(synthesis.force.target_mean_n);
    let weight = number(synthesis.problem.drive.newtons(weight), 4);
    let name = escaped(&words.fill("report-load-factors", &[("weight", &weight)]));
    let _ = write!(out, "<div><h3>{name}</h3><table><tr>");
    let heads = [
        "report-harmonic",
        "report-frequency",
        "report-factor-target",
        "report-factor-achieved",
    ];
    for head in heads {
        let _ = write!(out, "<th scope=\"col\">{}</th>", escaped(&words.text(head)));
    }
    out.push_str("</tr>\n");
    for f in &all {
        row(out, &format!("{}", f.of_step));
        let angled = |factor: f64, phase: f64| {
            if factor < LEAST_FACTOR {
                return format!("{factor:.4}");
            }
            let tenths = (10.0 * phase.to_degrees()).round();
            // Half a turn has one name, and zero no sign.
            let angle = if tenths == -1800.0 {
                1800.0
            } else {
                tenths + 0.0
            } / 10.0;
            format!("{factor:.4} ∠ {angle:.1}°").replace('-', "−")
        };
        let frequency = format!("{} Hz", number(f.frequency_hz, 4));
        let target = angled(f.target, f.target_phase_rad);
        let achieved = angled(f.achieved, f.achieved_phase_rad);
        cells(out, &[frequency, target, achieved]);
    }
    out.push_str("</table></div>\n");
}

fn drive(synthesis: &Design, words: &Words) -> Rows {
    let d = &synthesis.problem.drive;
    let measures = synthesis.cam.follower.measures();
    let shown = |unit: Unit, x: f64| unit.after(&number(unit.factor * x, 5));
    let round = match measures {
        Measures::Straight => ("report-one-pass", synthesis.cam.law.extent().1),
        _ => ("report-one-turn", std::f64::consts::TAU),
    };
    let swings = measures == Measures::Oscillating;
    let either = |moment, force| if swings { moment } else { force };
    let mut rows = vec![
        ("report-machine", words.name(d.kind.name())),
        ("report-row-speed", shown(measures.speed(), d.speed)),
        (round.0, format!("{} s", number(round.1 / d.speed.abs(), 5))),
        (
            either("report-moment-at-rest", "report-force-at-rest"),
            shown(measures.force(), d.rest_force),
        ),
    ];
    if d.mass != 0.0 {
        let name = either("report-inertia", "report-mass");
        rows.push((name, shown(measures.mass(), d.mass)));
    }
    if d.spring_rate != 0.0 {
        let oil = d.kind == DriveKind::Hydraulic;
        rows.push((
            if oil {
                "report-column"
            } else {
                "report-spring"
            },
            shown(measures.spring_rate(), d.spring_rate),
        ));
    }
    if d.damping != 0.0 {
        rows.push(("report-damping", shown(measures.damping(), d.damping)));
    }
    rows
}

fn law(synthesis: &Design, words: &Words) -> Rows {
    let law = &synthesis.cam.law;
    let mut rows = vec![("report-family", words.name(synthesis.family.name()))];
    // A harmonic law is one piece of no degree.
    if synthesis.degree > 0 {
        rows.push(("report-pieces", law.poly().pieces().to_string()));
        rows.push(("report-degree", synthesis.degree.to_string()));
    }
    let measures = synthesis.cam.follower.measures();
    let lift = measures.lift(0);
    let stroke = number(lift.factor * law.stroke(), 5);
    rows.push(("report-row-stroke", lift.after(&stroke)));
    let names = [
        ["report-velocity", "report-velocity-time"],
        ["report-acceleration", "report-acceleration-time"],
        ["report-jerk", "report-jerk-time"],
    ];
    for (name, order) in names.into_iter().zip(1..) {
        let (low, high) = law.extremes(order);
        let shown = |unit: Unit, rate: f64| {
            let scale = unit.factor * rate;
            unit.after(&range(scale * low.value, scale * high.value, 4))
        };
        rows.push((name[0], shown(measures.lift(order), 1.0)));
        let rate = synthesis.problem.drive.speed.powi(order as i32);
        rows.push((name[1], shown(measures.by_time(order), rate)));
    }
    rows
}

fn cam(synthesis: &Design, words: &Words) -> Rows {
    let cam = &synthesis.cam;
    let mm = |x: f64| millimetres(x, 5);
    let follower = &cam.follower;
    let mut rows = vec![
        ("report-follower", words.name(follower.name())),
        (base_key(follower), mm(follower.base_radius())),
    ];
    let curvature = cam.curvature();
    if follower.roller_radius() > 0.0 {
        if !follower.is_unrolled() {
            rows.push(("report-prime-circle", mm(follower.prime_radius())));
        }
        rows.push(("report-roller-radius", mm(follower.roller_radius())));
        if follower.measures() == Measures::Translating && !follower.is_unrolled() {
            rows.push(("report-offset", mm(follower.offset())));
        }
    }
    rows.push(("report-convex-radius", mm(curvature.convex.value)));
    let at = follower.measures().place(curvature.convex.at, 1);
    rows.push(("report-found-at", at));
    if let Some(concave) = curvature.concave {
        rows.push(("report-concave-radius", mm(-concave.value)));
    }
    if let Some(width) = cam.face_width() {
        rows.push(("report-face-width", mm(width)));
    } else {
        let (low, high) = synthesis.pressure_angle_extremes();
        let range = format!("{} … {}", degrees(low.value), degrees(high.value));
        rows.push(("report-pressure-angle", range));
    }
    rows
}

/// Torque, power, lift-off and pressure, where they are defined.
fn machine(synthesis: &Design, words: &Words) -> Rows {
    let m = synthesis.machine();
    let measures = synthesis.cam.follower.measures();
    let speed = measures.speed();
    let plain = |x: f64, unit: &str| format!("{}\u{a0}{unit}", number(x, 4));
    let torque = |t: Option<f64>| t.map(|t| plain(t, "N·m"));
    let liftoff = (m.liftoff_speed_rad_per_s).map(|w| speed.after(&number(speed.factor * w, 5)));
    let pressure = m.hertz_pressure_max_pa.filter(|p| p.is_finite());
    let pressure = pressure.map(|p| plain(1e-6 * p, "MPa"));
    let rows = [
        ("report-torque-max", torque(m.torque_max_n_m)),
        ("report-torque-rms", torque(m.torque_rms_n_m)),
        ("report-power-max", m.power_max_w.map(|p| plain(p, "W"))),
        ("report-power-mean", m.power_mean_w.map(|p| plain(p, "W"))),
        ("report-liftoff-speed", liftoff),
        ("report-hertz-pressure", pressure),
        ("report-hertz-allowable", allowable(synthesis, words)),
    ];
    let defined = rows.into_iter();
    let defined = defined.filter_map(|(name, value)| Some((name, value?)));
    defined.collect()
}

/// Pressure that the hardness of the surface bears, with the margin.
fn allowable(synthesis: &Design, words: &Words) -> Option<String> {
    let hardness = synthesis.problem.cam.making().hardness?;
    let borne = hardness.allowable_pressure();
    let pressure = synthesis.machine().hertz_pressure_max_pa;
    let margin = pressure
        .filter(|p| *p > 0.0)
        .map_or(f64::INFINITY, |p| borne / p);
    let arguments = [
        ("pressure", &*number(1e-6 * borne, 4)),
        ("hardness", &hardness.to_string()),
        ("margin", &number(margin, 3)),
    ];
    Some(words.fill("report-hertz-borne", &arguments))
}

/// What a follower's base radius is called.
pub fn base_key(follower: &Follower) -> &'static str {
    match follower {
        Follower::TranslatingCam { .. } => "report-row-base-height",
        Follower::Barrel { .. } => "report-row-barrel",
        _ => "report-row-base-circle",
    }
}
