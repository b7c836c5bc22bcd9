//! The summary of a design on the console: verdict, reasons, numbers; at most 25 lines.

use gaitcam::cam::{Check, Measures};
use gaitcam::synth::{Binding, Synthesis, in_units};
use gaitcam_output::Timing;

/// Most lines of one kind; the rest is counted and stands in summary.json.
const CHECKS: usize = 7;
const FAILED_CHECKS: usize = 6;
const ACTIVE_LIMITS: usize = 4;
const SENSITIVITIES: usize = 2;
const NOTES: usize = 2;

/// The summary for people.
pub fn text(design: &Synthesis, time: Timing) -> String {
    let mut out = vec![
        format!("{}: {}", design.name, design.verdict.name()),
        format!("  {}", design.reason()),
    ];
    out.extend(failed_checks(design));
    out.extend(force(design));
    out.push(law(design));
    out.push(drive(design));
    out.push(cam(design));
    out.extend(machine(design));
    out.extend(passed_checks(design));
    out.extend(active_limits(design));
    out.extend(sensitivities(design));
    let notes: Vec<String> = design.remarks().iter().map(|r| row("note", r)).collect();
    out.extend(at_most(NOTES, notes, "notes"));
    out.extend(solver(design, time));
    out.join("\n")
}

fn row(name: &str, text: &str) -> String {
    format!("  {name:<9} {text}")
}

/// The first `most` lines, and how many more there are.
fn at_most(most: usize, mut lines: Vec<String>, what: &str) -> Vec<String> {
    if lines.len() > most {
        let left = lines.len() - (most - 1);
        lines.truncate(most - 1);
        lines.push(row("", &format!("{left} more {what} in summary.json")));
    }
    lines
}

fn check_line(mark: &str, check: &Check, measures: Measures) -> String {
    let value = |x: f64| in_units(measures, &check.name, x);
    row(
        mark,
        &format!(
            "{} {} (limit {}) at {}",
            check.name,
            value(check.worst),
            value(check.limit),
            measures.place(check.at, 2)
        ),
    )
}

fn failed_checks(design: &Synthesis) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let failed = design.checks.iter().filter(|c| !c.pass);
    let lines = failed.map(|c| check_line("FAIL", c, measures)).collect();
    at_most(FAILED_CHECKS, lines, "failed checks")
}

fn passed_checks(design: &Synthesis) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let passed = design.checks.iter().filter(|c| c.pass);
    let lines: Vec<String> = passed.map(|c| check_line("ok", c, measures)).collect();
    let failed = (design.checks.len() - lines.len()).min(FAILED_CHECKS);
    at_most(CHECKS - failed, lines, "passed checks")
}

/// A force that is zero to its last printed digit, printed without a minus sign.
fn without_negative_zero(newtons: f64) -> f64 {
    if newtons.abs() < 0.005 { 0.0 } else { newtons }
}

fn force(design: &Synthesis) -> Vec<String> {
    if design.target.is_none() {
        return Vec::new();
    }
    let f = &design.force;
    vec![
        row(
            "force",
            &format!(
                "error {:.2} N RMS ({:.3} % of the mean), {:.2} N maximum",
                f.rms_error_n, f.rms_error_percent_of_mean, f.max_error_n
            ),
        ),
        row(
            "",
            &format!(
                "{:.2} … {:.2} N, mean {:.2} N",
                without_negative_zero(f.min_n),
                f.max_n,
                f.mean_n
            ),
        ),
    ]
}

fn law(design: &Synthesis) -> String {
    let lift = design.cam.follower.measures().lift(0);
    let decimals = if lift.name == "°" { 4 } else { 3 };
    let stroke = format!("{:.decimals$}", lift.factor * design.cam.law.stroke());
    let pieces = design.cam.law.poly().pieces();
    let order = match (design.degree, pieces) {
        (0, _) => String::new(),
        (degree, 1) => format!(", degree {degree}"),
        (degree, pieces) => format!(", degree {degree}, {pieces} pieces"),
    };
    row(
        "law",
        &format!("{}{order}, stroke {}", design.family, lift.after(&stroke)),
    )
}

fn drive(design: &Synthesis) -> String {
    let measures = design.cam.follower.measures();
    let mass = match design.drive.mass {
        0.0 => String::new(),
        mass => format!("{mass:.4} {}, ", measures.mass().name),
    };
    let speed = measures.speed_words(design.drive.speed, 4);
    row(
        "drive",
        &format!("{}, {mass}{speed}", design.drive.kind.name()),
    )
}

fn cam(design: &Synthesis) -> String {
    let mm = |x: f64| format!("{:.3} mm", 1e3 * x);
    let follower = &design.cam.follower;
    row(
        "cam",
        &format!(
            "{}, base radius {}, prime radius {}, smallest convex radius {}",
            follower.name(),
            mm(follower.base_radius()),
            mm(follower.prime_radius()),
            mm(design.cam.curvature().convex.value)
        ),
    )
}

/// Torque, power, lift-off and pressure, where they are defined.
fn machine(design: &Synthesis) -> Option<String> {
    let m = design.machine();
    let measures = design.cam.follower.measures();
    let torque = m.torque_max_n_m.zip(m.torque_rms_n_m);
    let parts = [
        torque.map(|(most, rms)| format!("torque {most:.4} N·m maximum, {rms:.4} N·m RMS")),
        m.power_max_w
            .map(|most| format!("power {most:.3} W maximum")),
        m.liftoff_speed_rad_per_s
            .map(|w| format!("lift-off at {}", measures.speed_words(w, 4))),
        m.hertz_pressure_max_pa
            .filter(|p| p.is_finite())
            .map(|p| format!("Hertz pressure {:.1} MPa", 1e-6 * p)),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| row("machine", &parts.join(", ")))
}

/// The contact points of one active limit, gathered.
struct ActiveLimit<'a> {
    strongest: &'a Binding,
    points: usize,
}

/// One line per active limit, the largest multiplier first.
fn active_limits(design: &Synthesis) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let mut limits: Vec<ActiveLimit> = Vec::new();
    for binding in &design.binding {
        let known = limits
            .iter_mut()
            .find(|a| a.strongest.limit == binding.limit);
        match known {
            None => limits.push(ActiveLimit {
                strongest: binding,
                points: 1,
            }),
            Some(active) => {
                active.points += 1;
                if binding.multiplier.abs() > active.strongest.multiplier.abs() {
                    active.strongest = binding;
                }
            }
        }
    }
    let size = |a: &ActiveLimit| a.strongest.multiplier.abs();
    limits.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let lines = limits.iter().map(|a| {
        let place = measures.place(a.strongest.at, 2);
        let places = match a.points {
            1 => format!("at {place}"),
            n => format!("at {n} points, largest multiplier at {place}"),
        };
        row("active", &format!("limit {} {places}", a.strongest.limit))
    });
    at_most(ACTIVE_LIMITS, lines.collect(), "active limits")
}

fn sensitivities(design: &Synthesis) -> Vec<String> {
    let measures = design.cam.follower.measures();
    let lines = design.easing.iter().map(|easing| {
        let (name, unit, factor) = easing.in_words(measures);
        row(
            "relaxing",
            &format!(
                "{} by 1 % to {}: {name} {:.5} {unit} instead of {:.5} {unit}",
                easing.limit,
                in_units(measures, &easing.limit, easing.to),
                factor * easing.after,
                factor * easing.before
            ),
        )
    });
    at_most(SENSITIVITIES, lines.collect(), "sensitivities")
}

fn solver(design: &Synthesis, time: Timing) -> Vec<String> {
    let solver = &design.solver;
    let mut out = vec![row(
        "solved",
        &format!(
            "{} tier, {:.3} ms of {:.0} ms: {}",
            solver.tier.name(),
            1e3 * time.solve_s,
            1e3 * time.total_s,
            solver.status()
        ),
    )];
    if let Some(c) = &solver.certificate {
        out.push(row(
            "optimum",
            &format!(
                "relative duality gap {:.1e}, KKT residual {:.1e}, constraint violation {:.1e}",
                c.relative_gap, c.stationarity, c.violation
            ),
        ));
    }
    out
}
