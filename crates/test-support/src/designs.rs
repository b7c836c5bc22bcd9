//! Designs with known results, built from the public types.

use std::sync::Arc;

use gaitcam::Problem;
use gaitcam::cam::{Cam, Check, Follower, Verdict, smallest_base_radius};
use gaitcam::criterion::{Criterion, LimitKind};
use gaitcam::drive::Drive;
use gaitcam::force::ForceCurve;
use gaitcam::law::Law;
use gaitcam::poly::{Extreme, PiecewisePoly, bernstein};
use gaitcam::problem::Note;
use gaitcam::scene::{CamSpec, DriveSpec, Family, KeywaySpec, Scene};
use gaitcam::synth::{
    Binding, Conflicting, Design, ForceReport, Functions, Infeasible, Method, Reason, Relaxation,
    SolverReport, Tier,
};
use gaitcam::units::{G, LBF, Quantity};

const TAU: f64 = std::f64::consts::TAU;
const INCH: f64 = 0.0254;

/// A problem without conditions and limits. These designs are not computed from it.
fn problem(name: &str, drive: Drive, target: Option<ForceCurve>) -> Problem {
    let spec = DriveSpec {
        speed: Some(1.0),
        ..DriveSpec::moving_axis(1.0)
    };
    let scene = Scene {
        name: name.into(),
        drive: spec,
        ..Scene::default()
    };
    let problem = Problem::resolve(&scene, None).unwrap();
    problem.against(drive, target)
}

/// Report of a certified solution without active limits.
fn solved_by(tier: Tier, iterations: usize) -> SolverReport {
    SolverReport {
        tier,
        method: Method::NoLimitActive,
        passed_over: None,
        iterations,
        certified: true,
        doubt: None,
        certificate: None,
        steps: Vec::new(),
    }
}

/// Design with only this cam: no pair, bore or note, and no limit.
fn plain(problem: Problem, cam: Cam, force: ForceReport) -> Design {
    let mut out = crate::design::<&str>(gaitcam::scene::DEFAULT, &[]).unwrap();
    out.problem = Arc::new(problem);
    (out.cam, out.force) = (cam, force);
    (out.functions, out.coefficients, out.degree) = (Functions::Fourier, Vec::new(), 0);
    (out.verdict, out.reasons) = (Verdict::Acceptable, Vec::new());
    (out.checks, out.binding, out.easing) = (Vec::new(), Vec::new(), Vec::new());
    out.solver = solved_by(Tier::Spectral, 0);
    out.notes = Vec::new();
    out
}

/// Amplitude relative to the weight, and phase, of the first harmonics of both feet.
const FACTORS: [(f64, f64); 4] = [(0.37, 0.0), (0.054, 0.7), (0.026, 1.9), (0.01, 2.4)];

/// Force of both feet at 1.85 Hz for a given weight, with a spread.
fn both_feet(weight: f64) -> ForceCurve {
    let force = |theta: f64| {
        let waves = FACTORS
            .iter()
            .enumerate()
            .map(|(i, (a, p))| a * ((i + 1) as f64 * theta + p).sin());
        weight * (1.0 + waves.sum::<f64>())
    };
    let samples: Vec<f64> = (0..360)
        .map(|i| force(TAU * f64::from(i) / 360.0))
        .collect();
    let mut target =
        ForceCurve::from_samples("Young, 1.85 Hz, 700 N", 1.0 / 1.85, samples).unwrap();
    let spread = (0..360).map(|i| 24.0 + 10.0 * (TAU * f64::from(i) / 180.0).sin());
    target.spread_n = Some(spread.collect());
    target
}

/// Both feet at 1.85 Hz with four harmonics, a flat face and a moving axis. The law is the spectral inverse plus 0.33 % in the fourth harmonic, so
/// that there is a force error.
pub fn footbridge() -> Design {
    let (weight, speed) = (700.0, TAU * 1.85);
    let mass = weight / G;
    let mut terms = Vec::new();
    for (i, (a, p)) in FACTORS.iter().enumerate() {
        let n = (i + 1) as f64;
        let scale = -weight * a / (mass * n * n * speed * speed);
        let scale = if i == 3 { 1.33 * scale } else { scale };
        terms.push((scale * p.sin(), scale * p.cos()));
    }
    let law = Law::harmonic(0.0, &terms);
    let (low, _) = law.extremes(0);
    let law = law.raised(-low.value);
    let rho = 0.005;
    // A shaft of 40 mm has to pass as well.
    let base_radius = smallest_base_radius(&law, rho).max(0.025);
    let drive = Drive::moving_axis(mass, G, speed);
    let (low, high) = drive.force_curve(&law).extremes();
    let amplitude = 0.33 * 0.01 * weight;
    let stroke = Extreme {
        at: 0.0,
        value: law.stroke(),
    };
    let cam = Cam {
        law,
        follower: Follower::FlatTranslating { base_radius },
    };
    let sharpest = cam.curvature().convex;
    let force = ForceReport {
        rms_error_n: amplitude / 2f64.sqrt(),
        max_error_n: amplitude,
        rms_error_percent_of_mean: 100.0 * amplitude / 2f64.sqrt() / weight,
        target_mean_n: weight,
        mean_n: weight,
        min_n: low.value,
        max_n: high.value,
    };
    let phase = Quantity::angle(0.5);
    let problem = problem("footbridge", drive, Some(both_feet(weight)));
    let mut out = plain(problem, cam, force);
    out.family = Family::Harmonic;
    out.coefficients = terms.iter().flat_map(|t| [t.0, t.1]).collect();
    out.reasons = vec![Reason::AllHold];
    out.checks = vec![
        Check::of(LimitKind::Stroke, stroke, 0.06, 1e-9),
        Check::of(LimitKind::Curvature, sharpest, rho, 1e-9),
        Check::of(LimitKind::ForceMin, low, 0.0, 1e-9),
    ];
    out.binding = vec![Binding {
        limit: LimitKind::Curvature.into(),
        multiplier: 1.0,
        at: sharpest.at,
    }];
    out.notes = vec![Note::NoBaseCircle, Note::Phase { phase }];
    out
}

/// Critical points of Vargas and León (2024), s and lb, joined by cubic steps.
fn critical_points() -> ForceCurve {
    let points: [(f64, f64); 6] = [
        (0.0, 0.0),
        (0.079, 110.282),
        (0.172, 79.338),
        (0.276, 106.667),
        (0.356, 0.0),
        (0.5, 0.0),
    ];
    let force = |t: f64| {
        let i = points.windows(2).position(|w| t < w[1].0).unwrap_or(4);
        let (a, b) = (points[i], points[i + 1]);
        let u = (t - a.0) / (b.0 - a.0);
        LBF * (a.1 + (b.1 - a.1) * u * u * (3.0 - 2.0 * u))
    };
    let samples: Vec<f64> = (0..500).map(|i| force(f64::from(i) / 1000.0)).collect();
    ForceCurve::from_samples("Vargas and León 2024, critical points", 0.5, samples).unwrap()
}

/// Degree-8 polynomial of Vargas and León (2024) with its roller (theory §2): Rp 3 in, roller 1 in, no offset.
pub fn heel_tester() -> Design {
    let (speed, beta) = (4.0 * std::f64::consts::PI, 256.32_f64.to_radians());
    // s = Σ Cₖ (θ/β)ᵏ in inches.
    let c = [
        0.0, 0.0, 0.0, 612.721, -4057.255, 10696.565, -13873.375, 8822.470, -2201.126,
    ]
    .map(|x| x * INCH);
    let rise: Vec<f64> = bernstein::from_power(&c);
    let pieces = [rise, vec![0.0; 9]].concat();
    let law = Law::from_poly(PiecewisePoly::new(vec![0.0, beta, TAU], 8, pieces), true);
    let psi = LBF / INCH.powi(2);
    let drive = Drive::hydraulic(30.0 * psi / INCH.powi(3), 0.75 * INCH, speed);
    let cam = Cam {
        law,
        follower: Follower::RollerTranslating {
            prime_radius: 3.0 * INCH,
            offset: 0.0,
            roller_radius: INCH,
        },
    };
    let (low, high) = drive.force_curve(&cam.law).extremes();
    let (phi_low, phi_high) = cam.pressure_angle_extremes();
    let limit = 30.0_f64.to_radians();
    let falling = Extreme {
        at: phi_low.at,
        value: -phi_low.value,
    };
    let force = ForceReport {
        rms_error_n: 36.0,
        max_error_n: 84.0,
        rms_error_percent_of_mean: 15.0,
        target_mean_n: 285.0,
        mean_n: 305.0,
        min_n: low.value,
        max_n: high.value,
    };
    let at = Quantity::angle(0.0);
    let convex = cam.curvature().convex;
    let problem = problem("heel_tester", drive, Some(critical_points()));
    let mut out = plain(problem, cam, force);
    out.family = Family::Polynomial;
    out.functions = Functions::Monomial { range: [0.0, TAU] };
    out.coefficients = c.to_vec();
    out.degree = 8;
    out.verdict = Verdict::NotForHighSpeed;
    out.reasons = vec![Reason::AccelerationJumps { at }];
    out.checks = vec![
        Check::of(LimitKind::PressureAngleRise, phi_high, limit, 1e-9),
        Check::of(LimitKind::PressureAngleFall, falling, limit, 1e-9),
        Check::of(LimitKind::Curvature, convex, 0.005, 1e-9),
    ];
    out.solver = solved_by(Tier::Equality, 1);
    out
}

/// An infeasible design: the footbridge with a stroke that is much too small.
#[allow(dead_code)] // not every user of these designs needs it
pub fn impossible() -> Design {
    let mut s = footbridge();
    Arc::make_mut(&mut s.problem).name = "footbridge <stroke & limit>".into();
    s.infeasible = Some(Infeasible {
        conflict: vec![
            Conflicting::Limit(LimitKind::Stroke.into()),
            Conflicting::Limit(Criterion::Accuracy),
        ],
        relaxations: vec![
            Relaxation {
                limit: LimitKind::Stroke.into(),
                key: "limits.stroke",
                from: 0.03,
                to: Some(0.0483),
            },
            Relaxation {
                limit: Criterion::Accuracy,
                key: "accuracy.rms",
                from: 0.005,
                to: None,
            },
        ],
        reasons: vec![Reason::LimitInfeasible {
            limit: LimitKind::Stroke.into(),
        }],
    });
    s.verdict = Verdict::Unacceptable;
    s.checks[0].limit = 0.03;
    s.checks[0].pass = false;
    s.force.rms_error_n = f64::NAN;
    s
}

/// Limiting cases of designs: zero lift, a knife edge, an open law, no target.
pub fn odd_ones() -> Vec<Design> {
    let mut still = footbridge();
    still.cam.law = Law::harmonic(0.0, &[]);
    let mut knife = heel_tester();
    knife.cam.follower = Follower::RollerTranslating {
        prime_radius: 0.06,
        offset: 0.01,
        roller_radius: 0.0,
    };
    Arc::make_mut(&mut knife.problem).target = None;
    let mut open = footbridge();
    let rise = PiecewisePoly::new(vec![0.5, 2.0], 3, vec![0.0, 0.0, 0.01, 0.01]);
    open.cam.law = Law::from_poly(rise, false);
    Arc::make_mut(&mut open.problem).name = String::new();
    vec![still, knife, open]
}

/// The design with changed numbers of its cam, without another synthesis.
#[must_use]
pub fn with_cam(mut design: Design, change: impl FnOnce(&mut CamSpec)) -> Design {
    let mut cam = design.problem.cam.clone();
    change(&mut cam);
    design.problem = Arc::new(design.problem.with_cam(cam));
    design
}

/// The design with a bore of a given diameter, m, and with the keyway of the standard if `is_keyed`.
#[must_use]
pub fn with_bore(design: Design, diameter: f64, is_keyed: bool) -> Design {
    with_cam(design, |cam| {
        cam.bore = Some(diameter);
        cam.keyway = is_keyed.then_some(KeywaySpec::Auto);
    })
}
