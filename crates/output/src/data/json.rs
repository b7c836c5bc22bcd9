//! `summary.json`: the design in numbers. A number that does not exist (no curvature, no face) is null.

use serde::{Serialize, Serializer};
use serde_json::{Map, Value};

use crate::Timing;
use gaitcam::cam::{Continuity, Criterion};
use gaitcam::synth::{
    Binding, Certificate, Design, Doubt, Easing, End, FIGURES, Figures, ForceReport, Functions,
    Infeasible, LoadFactor, Reason, Relaxation,
};
use gaitcam::wording::Language;

/// The summary of a design.
///
/// Extremes are those of the continuous law. An infeasible outcome also says which limits conflict and
/// what the smallest change of each would be (`to` is null where none helps).
pub fn summary(synthesis: &Design, time: Timing) -> Value {
    // Plain structs of numbers and strings with string keys: this cannot fail.
    serde_json::to_value(Summary::new(synthesis, time)).unwrap_or(Value::Null)
}

/// A reason as its code with its data.
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

/// A number that may be infinite: JSON has no such number, so it is the string `inf` or `-inf`. NaN is null.
struct Real(f64);

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            f64::INFINITY => serializer.serialize_str("inf"),
            f64::NEG_INFINITY => serializer.serialize_str("-inf"),
            x => serializer.serialize_f64(x),
        }
    }
}

#[derive(Serialize)]
struct Summary<'a> {
    name: &'a str,
    outcome: &'static str,
    verdict: &'static str,
    reason: String,
    reasons: Vec<Value>,
    verdict_text: VerdictText,
    continuity: Continuity,
    cam_das: &'static str,
    force: &'a ForceReport,
    drive: DriveSummary,
    law: LawSummary<'a>,
    cam: CamSummary,
    machine: Map<String, Value>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    load_factors: Vec<LoadFactor>,
    #[serde(skip_serializing_if = "Option::is_none")]
    recording: Option<Value>,
    checks: Vec<CheckSummary>,
    binding: &'a [Binding],
    easing: &'a [Easing],
    #[serde(skip_serializing_if = "Option::is_none")]
    infeasible: Option<InfeasibleSummary<'a>>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    relaxations: &'a [Relaxation],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    relaxed_together: &'a [Relaxation],
    out_of_time: bool,
    remarks: Vec<String>,
    solver: Solver,
    time: Total,
}

/// The reasons for the verdict as sentences.
#[derive(Serialize)]
struct VerdictText {
    en: String,
    es: String,
}

impl VerdictText {
    fn new(synthesis: &Design) -> Self {
        VerdictText {
            en: synthesis.reason(Language::En),
            es: synthesis.reason(Language::Es),
        }
    }
}

#[derive(Serialize)]
struct DriveSummary {
    kind: &'static str,
    mass_kg: f64,
    speed_rad_per_s: f64,
}

#[derive(Serialize)]
struct LawSummary<'a> {
    family: &'a str,
    pieces: usize,
    degree: usize,
    functions: &'a Functions,
    coefficients: &'a [f64],
    /// Phase of the force cycle at cam angle 0.
    phase_rad: f64,
    stroke_m: f64,
    v_max_m_per_rad: Real,
    v_min_m_per_rad: Real,
    a_max_m_per_rad2: Real,
    a_min_m_per_rad2: Real,
    j_max_m_per_rad3: Real,
    j_min_m_per_rad3: Real,
    #[serde(skip_serializing_if = "Option::is_none")]
    polydyne: Option<PolydyneSummary>,
}

/// The end of a flexible follower, for which the cam is cut. The force is the end's; stroke, velocity,
/// acceleration and jerk above are the cam's. Misses are deviations in the flexible simulation: of this
/// cam, and of one cut to the law of the end.
#[derive(Serialize)]
struct PolydyneSummary {
    stiffness_n_per_m: f64,
    damping_n_s_per_m: f64,
    end_stroke_m: f64,
    end_miss_m: Option<f64>,
    force_miss_rms_n: Option<f64>,
    force_miss_max_n: Option<f64>,
    plain_force_miss_rms_n: Option<f64>,
}

impl PolydyneSummary {
    fn new(end: &End) -> Self {
        PolydyneSummary {
            stiffness_n_per_m: end.stiffness,
            damping_n_s_per_m: end.damping,
            end_stroke_m: end.law.stroke(),
            end_miss_m: end.miss.map(|m| m.lift.value),
            force_miss_rms_n: end.miss.map(|m| m.force_rms),
            force_miss_max_n: end.miss.map(|m| m.force_max),
            plain_force_miss_rms_n: end.plain_miss.map(|m| m.force_rms),
        }
    }
}

#[derive(Serialize)]
struct CamSummary {
    follower: &'static str,
    base_radius_m: f64,
    prime_radius_m: f64,
    offset_m: f64,
    rho_min_m: Real,
    rho_min_at_rad: f64,
    pressure_angle_max_rad: f64,
    pressure_angle_min_rad: f64,
    face_width_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    second: Option<SecondCamSummary>,
}

/// The second cam of a pair.
#[derive(Serialize)]
struct SecondCamSummary {
    base_radius_m: f64,
    prime_radius_m: f64,
    rho_min_m: Real,
    rho_min_at_rad: f64,
}

/// What the design asks of a rigid machine without friction.
fn machine(design: &Design) -> Map<String, Value> {
    let figures = Figures::of(design);
    let own = FIGURES.iter().filter(|f| f.section == "machine");
    let own = own.map(|f| (f.key, f.value(&figures)));
    let hardness = design.making.hardness;
    let allowable = hardness.map_or(f64::NAN, |h| h.allowable_pressure());
    own.chain([("hertz_pressure_allowable_pa", allowable)])
        .map(|(key, x)| {
            (
                key.to_string(),
                serde_json::to_value(Real(x)).unwrap_or_default(),
            )
        })
        .collect()
}

#[derive(Serialize)]
struct CheckSummary {
    name: Criterion,
    worst: Real,
    limit: Real,
    at_rad: f64,
    pass: bool,
}

#[derive(Serialize)]
struct InfeasibleSummary<'a> {
    conflict: Vec<String>,
    relaxations: &'a [Relaxation],
    words: String,
}

#[derive(Serialize)]
struct Solver {
    tier: &'static str,
    status: String,
    iterations: usize,
    solve_s: f64,
    certified: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    doubt: Option<Doubt>,
    certificate: Option<Certificate>,
}

#[derive(Serialize)]
struct Total {
    total_s: f64,
}

impl<'a> Summary<'a> {
    fn new(synthesis: &'a Design, time: Timing) -> Self {
        let solver = &synthesis.solver;
        Summary {
            name: &synthesis.name,
            outcome: if synthesis.infeasible.is_some() {
                "infeasible"
            } else {
                "built"
            },
            verdict: synthesis.verdict.name(),
            reason: synthesis.reason(Language::En),
            reasons: synthesis.reasons.iter().map(coded).collect(),
            verdict_text: VerdictText::new(synthesis),
            continuity: Continuity::of(&synthesis.cam),
            cam_das: synthesis.cam.cam_das_class().name(),
            force: &synthesis.force,
            drive: DriveSummary {
                kind: synthesis.drive.kind.name(),
                mass_kg: synthesis.drive.mass,
                speed_rad_per_s: synthesis.drive.speed,
            },
            law: LawSummary::new(synthesis),
            cam: CamSummary::new(synthesis),
            machine: machine(synthesis),
            load_factors: synthesis.load_factors(),
            recording: (synthesis.target.as_ref())
                .and_then(|t| t.recording.as_ref())
                .map(|r| r.json()),
            checks: synthesis
                .checks
                .iter()
                .map(|c| CheckSummary {
                    name: c.name,
                    worst: Real(c.worst),
                    limit: Real(c.limit),
                    at_rad: c.at,
                    pass: c.pass,
                })
                .collect(),
            binding: &synthesis.binding,
            easing: &synthesis.easing,
            infeasible: synthesis.infeasible.as_ref().map(InfeasibleSummary::new),
            relaxations: &synthesis.relaxations,
            relaxed_together: &synthesis.together,
            out_of_time: synthesis.out_of_time,
            remarks: synthesis.remarks(Language::En),
            solver: Solver {
                tier: solver.tier.name(),
                status: solver.status(Language::En),
                iterations: solver.iterations,
                solve_s: time.solve_s,
                certified: solver.certified,
                doubt: solver.doubt,
                certificate: solver.certificate,
            },
            time: Total {
                total_s: time.total_s,
            },
        }
    }
}

impl<'a> LawSummary<'a> {
    fn new(synthesis: &'a Design) -> Self {
        let law = &synthesis.cam.law;
        let [(v_min, v_max), (a_min, a_max), (j_min, j_max)] =
            [1, 2, 3].map(|k| synthesis.cam.derivative_extremes(k));
        LawSummary {
            family: &synthesis.family,
            pieces: law.poly().pieces(),
            degree: synthesis.degree,
            functions: &synthesis.functions,
            coefficients: &synthesis.coefficients,
            phase_rad: synthesis.phase,
            stroke_m: law.stroke(),
            v_max_m_per_rad: Real(v_max.value),
            v_min_m_per_rad: Real(v_min.value),
            a_max_m_per_rad2: Real(a_max.value),
            a_min_m_per_rad2: Real(a_min.value),
            j_max_m_per_rad3: Real(j_max.value),
            j_min_m_per_rad3: Real(j_min.value),
            polydyne: synthesis.end.as_ref().map(PolydyneSummary::new),
        }
    }
}

impl CamSummary {
    fn new(synthesis: &Design) -> Self {
        let cam = &synthesis.cam;
        let curvature = cam.curvature();
        let (phi_min, phi_max) = synthesis.pressure_angle_extremes();
        CamSummary {
            follower: cam.follower.name(),
            base_radius_m: cam.follower.base_radius(),
            prime_radius_m: cam.follower.prime_radius(),
            offset_m: cam.follower.offset(),
            rho_min_m: Real(curvature.convex.value),
            rho_min_at_rad: curvature.convex.at,
            pressure_angle_max_rad: phi_max.value,
            pressure_angle_min_rad: phi_min.value,
            face_width_m: cam.face_width(),
            second: synthesis.conjugate.as_ref().map(|pair| {
                let (second, convex) = (&pair.second, pair.second.curvature().convex);
                SecondCamSummary {
                    base_radius_m: second.follower.base_radius(),
                    prime_radius_m: second.follower.prime_radius(),
                    rho_min_m: Real(convex.value),
                    rho_min_at_rad: convex.at,
                }
            }),
        }
    }
}

impl<'a> InfeasibleSummary<'a> {
    fn new(answer: &'a Infeasible) -> Self {
        InfeasibleSummary {
            conflict: answer.names(),
            relaxations: &answer.relaxations,
            words: answer.sentence(Language::En),
        }
    }
}
