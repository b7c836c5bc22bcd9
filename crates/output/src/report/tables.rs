//! The report's tables: checks, binding limits, the design in numbers, how it was found.

use std::fmt::Write;

use crate::Timing;
use crate::escape::escaped;
use crate::number::{degrees, number, range};
use gaitcam::cam::{Check, Follower, Measures, Unit};
use gaitcam::synth::{Synthesis, Tier};

/// Share of a limit that counts as standing on it.
const ON_THE_LIMIT: f64 = 0.005;

/// A limit's name as one says it.
pub fn spoken(name: &str) -> String {
    name.replace(['_', '-'], " ")
}

/// A value of a limit in the unit people use; SI without a unit where the limit is not known here.
pub fn shown(measures: Measures, limit: &str, value: f64) -> String {
    let unit = measures.limit(limit);
    unit.after(&number(unit.factor * value, 4))
}

/// How far the worst value stays from its limit, as a share of the limit; negative when broken.
fn margin(check: &Check) -> f64 {
    let gap = (check.worst - check.limit).abs();
    let share = if check.limit == 0.0 {
        if gap == 0.0 { 0.0 } else { f64::INFINITY }
    } else {
        gap / check.limit.abs()
    };
    if check.pass { share } else { -share }
}

/// Every check with its light.
pub fn checks(out: &mut String, synthesis: &Synthesis) {
    if synthesis.checks.is_empty() {
        return;
    }
    let measures = synthesis.cam.follower.measures();
    out.push_str(
        "<h2>Checks</h2>\n<div class=\"scroll\"><table><tr><th>Check</th><th>State</th><th class=\"n\">Worst</th>\
         <th class=\"n\">Limit</th><th class=\"n\">Margin</th><th class=\"n\">At</th></tr>\n",
    );
    for check in &synthesis.checks {
        let margin = margin(check);
        let (light, state) = if !check.pass {
            ("bad", "broken")
        } else if margin <= ON_THE_LIMIT {
            ("fair", "on the limit")
        } else {
            ("good", "holds")
        };
        let margin = if margin.is_finite() {
            format!("{:+.1} %", 100.0 * margin).replace('-', "−")
        } else {
            "—".into()
        };
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td class=\"state\"><span class=\"{light}\"><span class=\"dot\"></span>{state}</span></td>\
             <td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{margin}</td><td class=\"n\">{}</td></tr>",
            escaped(&spoken(&check.name)),
            shown(measures, &check.name, check.worst),
            shown(measures, &check.name, check.limit),
            measures.place(check.at, 1)
        );
    }
    out.push_str("</table></div>\n");
}

/// The limits that shape the law.
pub fn binding(out: &mut String, synthesis: &Synthesis) {
    out.push_str("<h2>Limits that bind</h2>\n");
    if synthesis.binding.is_empty() {
        out.push_str(if synthesis.checks.iter().all(|c| c.pass) {
            "<p>None: the law is what the force asks for, and every limit has room.</p>\n"
        } else {
            "<p>None: no limit took part in shaping the law.</p>\n"
        });
        return;
    }
    out.push_str(
        "<div class=\"scroll\"><table><tr><th>Limit</th><th class=\"n\">At</th>\
         <th class=\"n\">Multiplier (SI)</th></tr>\n",
    );
    let measures = synthesis.cam.follower.measures();
    for b in &synthesis.binding {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>",
            escaped(&spoken(&b.limit)),
            measures.place(b.at, 1),
            number(b.multiplier, 4)
        );
    }
    out.push_str(
        "</table></div>\n<p class=\"note\">The multiplier is what the objective gains per unit by which the \
         limit is eased: the limit with the largest one is the first to talk about.</p>\n",
    );
    easing(out, synthesis);
}

/// What one per cent more of each binding limit would buy.
fn easing(out: &mut String, synthesis: &Synthesis) {
    if synthesis.easing.is_empty() {
        return;
    }
    out.push_str(
        "<div class=\"scroll\"><table><tr><th>Ease this by 1 %</th><th class=\"n\">From</th><th class=\"n\">To</th>\
         <th>and this</th><th class=\"n\">falls from</th><th class=\"n\">to about</th></tr>\n",
    );
    let measures = synthesis.cam.follower.measures();
    for e in &synthesis.easing {
        let (name, unit, factor) = e.in_words(measures);
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{name}</td>\
             <td class=\"n\">{} {unit}</td><td class=\"n\">{} {unit}</td></tr>",
            escaped(&spoken(&e.limit)),
            shown(measures, &e.limit, e.from),
            shown(measures, &e.limit, e.to),
            number(factor * e.before, 5),
            number(factor * e.after, 5)
        );
    }
    out.push_str("</table></div>\n");
}

/// Drive, law and cam in numbers.
pub fn numbers(out: &mut String, synthesis: &Synthesis) {
    out.push_str("<h2>The design in numbers</h2>\n<div class=\"columns\">\n");
    table(out, "Drive", &drive(synthesis));
    table(out, "Law", &law(synthesis));
    table(out, "Cam", &cam(synthesis));
    out.push_str("</div>\n");
}

type Rows = Vec<(&'static str, String)>;

fn table(out: &mut String, name: &str, rows: &Rows) {
    let _ = write!(out, "<div><h3>{name}</h3><table>");
    for (what, value) in rows {
        let _ = write!(out, "<tr><td>{what}</td><td>{}</td></tr>", escaped(value));
    }
    out.push_str("</table></div>\n");
}

fn drive(synthesis: &Synthesis) -> Rows {
    let d = &synthesis.drive;
    let measures = synthesis.cam.follower.measures();
    let shown = |unit: Unit, x: f64| unit.after(&number(unit.factor * x, 5));
    let round = match measures {
        Measures::Straight => ("one pass", synthesis.cam.law.extent().1),
        _ => ("one turn", std::f64::consts::TAU),
    };
    let at_rest = match measures {
        Measures::Oscillating => "moment at rest",
        _ => "force at rest",
    };
    let mut rows = vec![
        ("machine", spoken(d.kind.name())),
        ("speed", shown(measures.speed(), d.speed)),
        (round.0, format!("{} s", number(round.1 / d.speed.abs(), 5))),
        (at_rest, shown(measures.force(), d.rest_force)),
    ];
    if d.mass != 0.0 {
        rows.push((measures.mass_words(), shown(measures.mass(), d.mass)));
    }
    if d.spring_rate != 0.0 {
        let name = match measures {
            Measures::Oscillating => "moment per angle",
            _ => "force per lift",
        };
        rows.push((name, shown(measures.spring_rate(), d.spring_rate)));
    }
    if d.damping != 0.0 {
        rows.push(("damping", shown(measures.damping(), d.damping)));
    }
    rows
}

fn law(synthesis: &Synthesis) -> Rows {
    let law = &synthesis.cam.law;
    let mut rows = vec![
        ("family", spoken(&synthesis.family)),
        ("pieces", law.poly().pieces().to_string()),
    ];
    if synthesis.degree > 0 {
        rows.push(("degree", synthesis.degree.to_string()));
    }
    let measures = synthesis.cam.follower.measures();
    let lift = measures.lift(0);
    let stroke = number(lift.factor * law.stroke(), 5);
    rows.push(("stroke", lift.after(&stroke)));
    let names = [
        ["velocity", "velocity by time"],
        ["acceleration", "acceleration by time"],
        ["jerk", "jerk by time"],
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

fn cam(synthesis: &Synthesis) -> Rows {
    let cam = &synthesis.cam;
    let mm = |x: f64| format!("{} mm", number(1000.0 * x, 5));
    let follower = &cam.follower;
    let mut rows = vec![
        ("follower", spoken(follower.name())),
        (base_name(follower), mm(follower.base_radius())),
    ];
    let curvature = cam.curvature();
    if follower.roller_radius() > 0.0 {
        if !follower.is_unrolled() {
            rows.push(("prime circle", mm(follower.prime_radius())));
        }
        rows.push(("roller radius", mm(follower.roller_radius())));
        if follower.measures() == Measures::Translating && !follower.is_unrolled() {
            rows.push(("offset", mm(follower.offset())));
        }
    }
    rows.push(("smallest convex radius", mm(curvature.convex.value)));
    let at = follower.measures().place(curvature.convex.at, 1);
    rows.push(("found at", at));
    if let Some(concave) = curvature.concave {
        rows.push(("tightest concave radius", mm(-concave.value)));
    }
    if let Some(width) = cam.face_width() {
        rows.push(("face width", mm(width)));
    } else {
        let (low, high) = synthesis.pressure_angle_extremes();
        let range = format!("{} … {}", degrees(low.value), degrees(high.value));
        rows.push(("pressure angle", range));
    }
    rows
}

/// What a follower's base radius is called.
pub fn base_name(follower: &Follower) -> &'static str {
    match follower {
        Follower::TranslatingCam { .. } => "base height",
        Follower::Barrel { .. } => "barrel's radius",
        _ => "base circle",
    }
}

/// How the answer was found, and what was remarked on the way.
pub fn solution(out: &mut String, synthesis: &Synthesis, time: Timing) {
    let solver = &synthesis.solver;
    let how = match solver.tier {
        Tier::Spectral => "in closed form, harmonic by harmonic",
        Tier::Equality => "by least squares with equalities, in one factorisation",
        Tier::Qp => "as a convex quadratic program",
        Tier::Socp => "as a second-order cone program",
        Tier::Scp => "as a sequence of convex programs",
    };
    let status = sentence(&solver.status());
    let spent = format!(
        "in {} ms ({} iterations)",
        number(1000.0 * time.solve_s, 3),
        solver.iterations
    );
    let _ = if synthesis.infeasible.is_some() {
        writeln!(
            out,
            "<h2>What was tried</h2>\n<p>The search ran {how}, {spent}. {status}</p>"
        )
    } else {
        let certified = if solver.certified {
            "Every limit was confirmed on the continuous law, between the samples too."
        } else {
            "The limits were not confirmed between the samples."
        };
        writeln!(
            out,
            "<h2>How it was solved</h2>\n<p>Solved {how}, {spent}. {status}{certified}</p>"
        )
    };
    if let Some(c) = &solver.certificate {
        let _ = writeln!(
            out,
            "<p class=\"note\">Proof: no law of this family that keeps these limits has an objective lower by more than {:.1e} of it; \
             the optimality conditions hold to {:.1e}, the limits to {:.1e}.</p>",
            c.relative_gap, c.stationarity, c.violation
        );
    }
    if !synthesis.notes.is_empty() {
        out.push_str("<h3>Remarks</h3>\n<ul>\n");
        for remark in synthesis.remarks() {
            let _ = writeln!(out, "<li>{}</li>", escaped(&remark));
        }
        out.push_str("</ul>\n");
    }
}

/// A status as a sentence of its own, escaped; nothing for an empty one.
fn sentence(status: &str) -> String {
    let mut letters = status.trim().trim_end_matches('.').chars();
    match letters.next() {
        None => String::new(),
        Some(first) => {
            let text: String = first.to_uppercase().chain(letters).collect();
            format!("{}. ", escaped(&text))
        }
    }
}
