//! `summary.json`: the design as numbers. Undefined numbers, such as the curvature of a straight profile or the face width of a roller,
//! are null.

use serde_json::{Map, Value, json};

use crate::Timing;
use gaitcam::cam::{Cam, Continuity, Verdict};
use gaitcam::drive::Drive;
use gaitcam::error::Error;
use gaitcam::synth::{Design, Doubt, End, FIGURES, Figures, OnShaft, Reason};
use gaitcam::wording::Language;

/// Summary of a design as JSON.
///
/// Extremes are those of the continuous law. For an infeasible design, the summary also lists the conflicting limits and the minimum
/// sufficient change of each limit. The new value `to` is null if no change of this limit alone is sufficient.
pub fn summary(design: &Design, time: Timing) -> Value {
    let mut out = Map::new();
    let mut put = |key: &str, value: Value| out.insert(key.to_string(), value);
    let outcome = match (&design.infeasible, design.out_of_time) {
        (Some(_), _) => "infeasible",
        (None, true) => "out-of-time",
        (None, false) => "built",
    };
    put("name", json!(design.problem.name));
    put("outcome", json!(outcome));
    put("verdict", json!(design.verdict.name()));
    put("reason", json!(design.reason(Language::En)));
    put("reasons", design.reasons.iter().map(coded).collect());
    put(
        "verdict_text",
        json!({"en": design.reason(Language::En), "es": design.reason(Language::Es)}),
    );
    put("continuity", json!(Continuity::of(&design.cam)));
    put("cam_das", json!(design.cam.cam_das_class().name()));
    put("force", force(design));
    put("drive", drive(design));
    put("law", law(design));
    put("cam", cam(design));
    put("machine", machine(design));
    let load_factors = design.load_factors();
    if !load_factors.is_empty() {
        put("load_factors", json!(load_factors));
    }
    let target = design.target();
    if let Some(recording) = target.and_then(|t| t.recording.as_ref()) {
        put("recording", recording.json());
    }
    put("checks", checks(design));
    put("binding", json!(design.binding));
    put("easing", json!(design.easing));
    if let Some(answer) = &design.infeasible {
        let words = answer.sentence(Language::En);
        let (conflict, relaxations) = (answer.names(), &answer.relaxations);
        put(
            "infeasible",
            json!({"conflict": conflict, "relaxations": relaxations, "words": words}),
        );
    }
    if !design.relaxations.is_empty() {
        put("relaxations", json!(design.relaxations));
    }
    if !design.together.is_empty() {
        put("relaxed_together", json!(design.together));
    }
    if let Some(on_shaft) = &design.shaft {
        put("shaft", json!(on_shaft.shaft));
        put("force_time", json!(on_shaft.force_time));
        put("shaft_design", shaft_design(design, on_shaft));
    }
    if let Some(population) = &design.population {
        put("population", json!(population));
    }
    if let Some(floor) = &design.floor {
        put("floor", json!(floor));
    }
    if let Some(walker) = design.walker() {
        put("walker", json!(walker));
    }
    put("out_of_time", json!(design.out_of_time));
    put("remarks", json!(design.remarks(Language::En)));
    put("solver", solver(design, time));
    put("time", json!({"total_s": time.total_s}));
    Value::Object(out)
}

/// Data of a design with varying shaft speed: convergence of the iteration between design and simulation, force error of the law for
/// constant speed, estimated ripple, and sensitivity of the force error to machine parameters.
fn shaft_design(design: &Design, on_shaft: &OnShaft) -> Value {
    json!({
        "rounds": on_shaft.rounds,
        "contraction": on_shaft.contraction,
        "at_constant_speed": on_shaft.at_constant_speed,
        "forecast": on_shaft.forecast,
        "sensitivity": design.sensitivity(),
    })
}

/// Summary of a scene without a cam: the reason, and the scene key to which the reason refers.
pub fn summary_without_cam(name: &str, error: &Error, total_s: f64) -> Value {
    let place = error.place.to_string();
    let key = place.trim_end_matches(": ");
    let [en, es] = [Language::En, Language::Es].map(|language| error.sentence(language));
    json!({
        "name": name,
        "outcome": "infeasible",
        "verdict": Verdict::Unacceptable.name(),
        "reason": en,
        "reasons": [{"code": error.code(), "key": key}],
        "verdict_text": {"en": en, "es": es},
        "infeasible": {"conflict": [key], "relaxations": [], "words": en},
        "solver": null,
        "time": {"total_s": total_s},
    })
}

/// JSON object with the code of a reason and its data.
fn coded(reason: &Reason) -> Value {
    let mut out = match serde_json::to_value(reason) {
        Ok(Value::Object(variant)) => match variant.into_iter().next() {
            Some((_, Value::Object(fields))) => fields,
            _ => Map::new(),
        },
        _ => Map::new(),
    };
    out.insert("code".to_string(), reason.code().into());
    Value::Object(out)
}

/// Converts a number that may be infinite. JSON has no infinite numbers, so they become the strings `inf` and `-inf`. NaN becomes null.
fn real(x: f64) -> Value {
    match x {
        f64::INFINITY => json!("inf"),
        f64::NEG_INFINITY => json!("-inf"),
        x => json!(x),
    }
}

/// Force of the cam and its errors; null if the machine has neither a force nor a target. Without a target, the mean of the target and the
/// errors are null.
fn force(design: &Design) -> Value {
    if design.problem.drive.is_idle() && design.target().is_none() {
        return Value::Null;
    }
    let mut out = json!(design.force.newtons(&design.problem.drive));
    if design.target().is_none() {
        for key in [
            "rms_error_n",
            "max_error_n",
            "rms_error_percent_of_mean",
            "target_mean_n",
        ] {
            out[key] = Value::Null;
        }
    }
    out
}

fn drive(design: &Design) -> Value {
    let drive = &design.problem.drive;
    json!({"kind": drive.kind.name(), "mass_kg": drive.mass, "speed_rad_per_s": drive.speed})
}

fn law(design: &Design) -> Value {
    let law = &design.cam.law;
    let [(v_min, v_max), (a_min, a_max), (j_min, j_max)] =
        [1, 2, 3].map(|k| design.cam.derivative_extremes(k));
    let mut out = json!({
        "family": design.family,
        "pieces": law.poly().pieces(),
        "degree": design.degree,
        "functions": design.functions,
        "coefficients": design.coefficients,
        // Phase of the force cycle at cam angle 0, rad.
        "phase_rad": design.problem.phase,
        "stroke_m": law.stroke(),
        "v_max_m_per_rad": real(v_max.value),
        "v_min_m_per_rad": real(v_min.value),
        "a_max_m_per_rad2": real(a_max.value),
        "a_min_m_per_rad2": real(a_min.value),
        "j_max_m_per_rad3": real(j_max.value),
        "j_min_m_per_rad3": real(j_min.value),
    });
    if let Some(end) = &design.end {
        out["polydyne"] = polydyne(end, &design.problem.drive);
    }
    out
}

/// Data of the follower end for which a polydyne cam is designed. The force of the law is the force at this end.
/// Stroke, velocity, acceleration and jerk of the law are those at the cam. Keys with `miss` contain deviations in the simulation with a
/// flexible follower. The keys `end_miss_m`, `force_miss_rms_n` and `force_miss_max_n` describe this cam. The key `plain_force_miss_rms_n`
/// describes a cam whose lift equals the motion of the follower end.
fn polydyne(end: &End, drive: &Drive) -> Value {
    let newtons = |force: f64| drive.newtons(force);
    json!({
        "stiffness_n_per_m": end.stiffness,
        "damping_n_s_per_m": end.damping,
        "end_stroke_m": end.law.stroke(),
        "end_miss_m": end.miss.map(|m| m.lift.value),
        "force_miss_rms_n": end.miss.map(|m| newtons(m.force_rms)),
        "force_miss_max_n": end.miss.map(|m| newtons(m.force_max)),
        "plain_force_miss_rms_n": end.plain_miss.map(|m| newtons(m.force_rms)),
    })
}

fn cam(design: &Design) -> Value {
    let cam = &design.cam;
    let convex = cam.curvature().convex;
    let (phi_min, phi_max) = design.pressure_angle_extremes();
    let radius = |end: usize| cam.radii().map(|radii| radii[end].value);
    let mut out = json!({
        "follower": cam.follower.name(),
        "base_radius_m": cam.follower.base_radius(),
        "prime_radius_m": cam.follower.prime_radius(),
        "radius_min_m": radius(0),
        "radius_max_m": radius(1),
        "offset_m": cam.follower.offset(),
        "rho_min_m": real(convex.value),
        "rho_min_at_rad": convex.at,
        "pressure_angle_max_rad": phi_max.value,
        "pressure_angle_min_rad": phi_min.value,
        "face_width_m": cam.face_width(),
    });
    if let Some(pair) = &design.conjugate {
        out["second"] = second(&pair.second);
    }
    out
}

/// Second cam of a conjugate pair.
fn second(cam: &Cam) -> Value {
    let convex = cam.curvature().convex;
    json!({
        "base_radius_m": cam.follower.base_radius(),
        "prime_radius_m": cam.follower.prime_radius(),
        "rho_min_m": real(convex.value),
        "rho_min_at_rad": convex.at,
    })
}

/// Loads of the design for a rigid machine without friction.
fn machine(design: &Design) -> Value {
    let figures = Figures::of(design);
    let own = FIGURES.iter().filter(|f| f.section == "machine");
    let own = own.map(|f| (f.key, f.value(&figures)));
    let allowable = design.problem.cam.allowable_pressure();
    let allowable = allowable.unwrap_or(f64::NAN);
    let all = own.chain([("hertz_pressure_allowable_pa", allowable)]);
    all.map(|(key, x)| (key, real(x))).collect()
}

fn checks(design: &Design) -> Value {
    let checks = design.checks.iter().map(|c| {
        json!({
            "name": c.name,
            "worst": real(c.worst),
            "limit": real(c.limit),
            "at_rad": c.at,
            "pass": c.pass,
        })
    });
    checks.collect()
}

fn solver(design: &Design, time: Timing) -> Value {
    let solver = &design.solver;
    let mut out = json!({
        "tier": solver.tier.name(),
        "status": solver.status(Language::En),
        "iterations": solver.iterations,
        "solve_s": time.solve_s,
        "certified": solver.certified,
    });
    if let Some(doubt) = solver.doubt {
        out["doubt"] = json!(doubt);
    }
    out["certificate"] = json!(solver.certificate);
    if solver.doubt == Some(Doubt::FixedMotion) && solver.certificate.is_some() {
        out["certificate"]["scope"] = json!(Doubt::FixedMotion);
    }
    out
}
