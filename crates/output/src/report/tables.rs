//! The report's tables: checks, active limits, the design's data, how it was solved.

use std::fmt::Write;

use super::heading;
use crate::Timing;
use crate::escape::escaped;
use crate::number::{degrees, millimetres, number, range};
use crate::words::Words;
use gaitcam::cam::{Check, Criterion, Follower, Measures, Unit};
use gaitcam::synth::{Design, Tier, unit};

/// Share of a limit that counts as standing on it.
const ON_THE_LIMIT: f64 = 0.005;

/// A value of a limit in the unit people use; SI without a unit where the limit is not known here.
pub fn shown(measures: Measures, limit: Criterion, value: f64) -> String {
    let unit = unit(measures, limit);
    let value = unit.factor * value;
    // Rounding of what is nothing.
    let value = if value.abs() < 1e-9 { 0.0 } else { value };
    unit.after(&number(value, 4))
}

/// How far the worst value stays from its limit, as a share of the limit; negative when violated.
fn margin(check: &Check) -> f64 {
    let gap = (check.worst - check.limit).abs();
    let share = if check.limit == 0.0 {
        if gap == 0.0 { 0.0 } else { f64::INFINITY }
    } else {
        gap / check.limit.abs()
    };
    if check.pass { share } else { -share }
}

/// Opens a table; the columns of `numbers` are set flush right.
fn open(out: &mut String, words: &Words, columns: &[&str], numbers: std::ops::Range<usize>) {
    out.push_str("<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>");
    for (i, key) in columns.iter().enumerate() {
        let class = if numbers.contains(&i) {
            " class=\"n\""
        } else {
            ""
        };
        let name = escaped(&words.text(key));
        let _ = write!(out, "<th scope=\"col\"{class}>{name}</th>");
    }
    out.push_str("</tr></thead>\n<tbody>\n");
}

fn close(out: &mut String) {
    out.push_str("</tbody></table></div>\n");
}

/// Opens a row with its name.
fn row(out: &mut String, name: &str) {
    let _ = write!(out, "<tr><th scope=\"row\">{}</th>", escaped(name));
}

fn cells(out: &mut String, values: &[&str]) {
    for value in values {
        let _ = write!(out, "<td class=\"n\">{}</td>", escaped(value));
    }
    out.push_str("</tr>\n");
}

/// Every check with its light.
pub fn checks(out: &mut String, synthesis: &Design, words: &Words) {
    if synthesis.checks.is_empty() {
        return;
    }
    let measures = synthesis.cam.follower.measures();
    heading(out, &words.text("report-checks"));
    let columns = [
        "report-check",
        "report-state",
        "report-worst",
        "report-limit",
        "report-margin",
        "report-place",
    ];
    open(out, words, &columns, 2..6);
    for check in &synthesis.checks {
        let margin = margin(check);
        let (light, state) = if !check.pass {
            ("bad", "report-violated")
        } else if margin <= ON_THE_LIMIT {
            ("fair", "report-at-limit")
        } else {
            ("good", "report-satisfied")
        };
        let margin = if margin.is_finite() {
            format!("{:+.1} %", 100.0 * margin).replace('-', "−")
        } else {
            "—".into()
        };
        row(out, &words.name(check.name.name()));
        let _ = write!(
            out,
            "<td class=\"state\"><span class=\"{light}\"><span class=\"dot\"></span>{}</span></td>",
            escaped(&words.text(state))
        );
        let worst = shown(measures, check.name, check.worst);
        let none = || "—".to_string();
        let limit = match check.name {
            // No more than rounding.
            Criterion::Interference | Criterion::SecondInterference => none(),
            _ => shown(measures, check.name, check.limit),
        };
        let place = match check.name {
            // Of the whole turn.
            Criterion::RmsError => none(),
            _ => measures.place(check.at, 1),
        };
        cells(out, &[&worst, &limit, &margin, &place]);
    }
    close(out);
}

/// An active limit: its name, its largest multiplier and where that is, how many points it holds at.
struct Active {
    limit: Criterion,
    multiplier: f64,
    at: f64,
    points: usize,
}

/// The limits that shape the law, each once.
fn gathered(synthesis: &Design) -> Vec<Active> {
    let mut all: Vec<Active> = Vec::new();
    for b in &synthesis.binding {
        let Some(known) = all.iter_mut().find(|a| a.limit == b.limit) else {
            all.push(Active {
                limit: b.limit,
                multiplier: b.multiplier,
                at: b.at,
                points: 1,
            });
            continue;
        };
        known.points += 1;
        if b.multiplier.abs() > known.multiplier.abs() {
            (known.multiplier, known.at) = (b.multiplier, b.at);
        }
    }
    all
}

/// The limits that shape the law.
pub fn active(out: &mut String, synthesis: &Design, words: &Words) {
    heading(out, &words.text("report-active-limits"));
    if synthesis.binding.is_empty() {
        super::paragraph(out, &words.text("report-no-active-limits"));
        return;
    }
    let columns = [
        "report-limit",
        "report-times",
        "report-multiplier",
        "report-place",
    ];
    open(out, words, &columns, 1..4);
    let measures = synthesis.cam.follower.measures();
    for a in gathered(synthesis) {
        row(out, &words.name(a.limit.name()));
        let (points, place) = (a.points.to_string(), measures.place(a.at, 1));
        cells(out, &[&points, &number(a.multiplier, 4), &place]);
    }
    close(out);
    note(out, &words.text("report-multiplier-note"));
    easing(out, synthesis, words);
}

fn note(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(text));
}

/// What one per cent more of each active limit would buy.
fn easing(out: &mut String, synthesis: &Design, words: &Words) {
    if synthesis.easing.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "<h3>{}</h3>",
        escaped(&words.text("report-sensitivity"))
    );
    let columns = [
        "report-limit",
        "report-from",
        "report-to",
        "report-objective",
        "report-now",
        "report-predicted",
    ];
    open(out, words, &columns, 1..6);
    let measures = synthesis.cam.follower.measures();
    for e in &synthesis.easing {
        let (name, unit, factor) = e.in_words(measures, words.language());
        row(out, &words.name(e.limit.name()));
        let from = shown(measures, e.limit, e.from);
        let to = shown(measures, e.limit, e.to);
        let [before, after] =
            [e.before, e.after].map(|x| format!("{} {unit}", number(factor * x, 5)));
        cells(out, &[&from, &to, &name, &before, &after]);
    }
    close(out);
}

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

/// Harmonics of target and achieved force as parts of the weight, as codes for footbridges quote them.
fn load_factors(out: &mut String, synthesis: &Design, words: &Words) {
    let all = synthesis.load_factors();
    if all.is_empty() {
        return;
    }
    let weight = number(
        synthesis.weight_n.unwrap_or(synthesis.force.target_mean_n),
        4,
    );
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
        row(out, &number(f.of_step, 2));
        let angled = |factor: f64, phase: f64| {
            let angle = number(phase.to_degrees(), 3);
            format!("{factor:.4} ∠ {angle}°")
        };
        let frequency = format!("{} Hz", number(f.frequency_hz, 4));
        let target = angled(f.target, f.target_phase_rad);
        let achieved = angled(f.achieved, f.achieved_phase_rad);
        cells(out, &[&frequency, &target, &achieved]);
    }
    out.push_str("</table></div>\n");
}

/// Keys of the names, and values.
pub(super) type Rows = Vec<(&'static str, String)>;

/// A table of two columns under its name.
pub(super) fn table(out: &mut String, words: &Words, name: &str, rows: &Rows) {
    let name = escaped(&words.text(name));
    let _ = write!(out, "<div><h3>{name}</h3><table>");
    for (key, value) in rows {
        row(out, &words.text(key));
        let _ = write!(out, "<td>{}</td></tr>", escaped(value));
    }
    out.push_str("</table></div>\n");
}

fn drive(synthesis: &Design, words: &Words) -> Rows {
    let d = &synthesis.drive;
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
        rows.push((
            "report-spring",
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
    let mut rows = vec![("report-family", words.name(&synthesis.family))];
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
        let rate = synthesis.drive.speed.powi(order as i32);
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
    let rows = [
        (
            "report-torque-max",
            m.torque_max_n_m.map(|t| plain(t, "N·m")),
        ),
        (
            "report-torque-rms",
            m.torque_rms_n_m.map(|t| plain(t, "N·m")),
        ),
        ("report-power-max", m.power_max_w.map(|p| plain(p, "W"))),
        ("report-power-mean", m.power_mean_w.map(|p| plain(p, "W"))),
        (
            "report-liftoff-speed",
            m.liftoff_speed_rad_per_s
                .map(|w| speed.after(&number(speed.factor * w, 5))),
        ),
        (
            "report-hertz-pressure",
            m.hertz_pressure_max_pa
                .filter(|p| p.is_finite())
                .map(|p| plain(1e-6 * p, "MPa")),
        ),
        ("report-hertz-allowable", allowable(synthesis, words)),
    ];
    let known = rows.into_iter();
    known
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
}

/// Pressure that the hardness of the surface bears, with the margin.
fn allowable(synthesis: &Design, words: &Words) -> Option<String> {
    let hardness = synthesis.making.hardness?;
    let borne = hardness.allowable_pressure();
    let pressure = synthesis.machine().hertz_pressure_max_pa;
    let margin = pressure
        .filter(|p| *p > 0.0)
        .map_or(f64::INFINITY, |p| borne / p);
    let arguments = [
        ("pressure", number(1e-6 * borne, 4)),
        ("hardness", hardness.to_string()),
        ("margin", number(margin, 3)),
    ];
    let arguments = arguments
        .each_ref()
        .map(|(key, value)| (*key, value.as_str()));
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

/// How the answer was found, and what was remarked on the way.
pub fn solution(out: &mut String, synthesis: &Design, time: Timing, words: &Words) {
    let solver = &synthesis.solver;
    let how = match solver.tier {
        Tier::Spectral => "report-spectral",
        Tier::Equality => "report-equality",
        Tier::Qp => "report-qp",
        Tier::Socp => "report-socp",
        Tier::Scp => "report-scp",
    };
    let built = synthesis.infeasible.is_none();
    heading(
        out,
        &words.text(if built {
            "report-solution"
        } else {
            "report-attempt"
        }),
    );
    let spent = format!("{} ms", number(1000.0 * time.solve_s, 3));
    let iterations = solver.iterations.to_string();
    let arguments = [
        ("how", words.text(how)),
        ("time", spent),
        ("iterations", iterations),
    ];
    let arguments = arguments
        .each_ref()
        .map(|(name, text)| (*name, text.as_str()));
    let mut text = words.fill("report-solved", &arguments);
    text += &sentence(&solver.status(words.language()));
    if built {
        text.push(' ');
        text += &words.text("report-verified");
        text.push(' ');
        text += &match solver.doubt {
            Some(doubt) => {
                let why = doubt.sentence(words.language());
                words.fill("report-uncertified", &[("why", why.as_str())])
            }
            None if solver.certificate.is_some() => words.text("report-certified"),
            None => String::new(),
        };
    }
    super::paragraph(out, &text);
    if let Some(c) = &solver.certificate {
        let [gap, stationarity, violation] =
            [c.relative_gap, c.stationarity, c.violation].map(|x| match x {
                0.0 => "0".to_string(),
                x => format!("{x:.1e}"),
            });
        let arguments = [
            ("gap", gap.as_str()),
            ("stationarity", &stationarity),
            ("violation", &violation),
        ];
        note(out, &words.fill("report-certificate", &arguments));
    }
    if !synthesis.notes.is_empty() {
        let head = escaped(&words.text("report-remarks"));
        let _ = write!(out, "<h3>{head}</h3>\n<ul>\n");
        for remark in synthesis.remarks(words.language()) {
            let _ = writeln!(out, "<li>{}</li>", escaped(&remark));
        }
        out.push_str("</ul>\n");
    }
}

/// A status as a sentence of its own after another; nothing for an empty one.
fn sentence(status: &str) -> String {
    let mut letters = status.trim().trim_end_matches('.').chars();
    letters.next().map_or(String::new(), |first| {
        let text: String = first.to_uppercase().chain(letters).collect();
        format!(" {text}.")
    })
}
