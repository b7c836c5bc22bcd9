//! Machine of a scene: limits that act on the law, and keys for the simulation.

use gaitcam::criterion::LimitKind;
use gaitcam::dynamics::{hertz, touch};
use gaitcam::law::Law;
use gaitcam::problem::Note;
use gaitcam::scene;
use gaitcam::synth::Design;
use gaitcam_test_support::design_of;
use std::f64::consts::TAU;

fn fault(text: &str, change: &str) -> String {
    gaitcam_test_support::scene(text, &[change])
        .unwrap_err()
        .to_string()
}

fn check<'a>(s: &'a Design, name: &str) -> &'a gaitcam::cam::Check {
    s.checks.iter().find(|c| c.name.name() == name).unwrap()
}

fn peak_torque(s: &Design) -> f64 {
    (0..20_011)
        .map(|i| s.cam.law.svaj(TAU * f64::from(i) / 20_011.0))
        .map(|at| (s.problem.drive.force(at) * at.v).abs())
        .fold(0.0, f64::max)
}

#[test]
fn a_torque_limit_shapes_the_law_and_costs_accuracy() {
    let free = design_of(scene::DEFAULT, &[]);
    let most = peak_torque(&free);
    let spans = format!("law.spans={}", free.cam.law.poly().pieces());
    let rms = "accuracy.rms=50 %";
    let mut last = free.force.rms_error_n;
    for share in [0.97, 0.9, 0.8] {
        let limit = share * most;
        let change = format!("limits.torque={limit} N m");
        let s = design_of(scene::DEFAULT, &[&spans, rms, &change]);
        assert!(check(&s, "torque").pass, "{share}");
        assert!(peak_torque(&s) <= limit * (1.0 + 1e-6), "{share}");
        // What is given up is not thrown away: the limit is reached.
        assert!(peak_torque(&s) > limit * (1.0 - 2e-3), "{share}");
        assert!(s.force.rms_error_n > last);
        last = s.force.rms_error_n;
        assert!(s.binding.iter().any(|b| b.limit.name() == "torque"));
    }
    // A limit that is not reached changes nothing.
    let wide = design_of(scene::DEFAULT, &["limits.torque=1000 N m"]);
    assert_eq!(wide.coefficients, free.coefficients);
}

#[test]
fn a_pressure_limit_under_a_flat_face_is_a_row_of_the_program() {
    let base = ["cam.base_radius=40 mm", "accuracy.rms=50 %", "law.spans=8"];
    let free = design_of(scene::DEFAULT, &base);
    let steel = hertz::modulus(hertz::STEEL, hertz::STEEL);
    let worst = |s: &Design| {
        (0..7213)
            .map(|i| {
                let at = s.cam.law.svaj(TAU * f64::from(i) / 7213.0);
                let force = s.problem.drive.force(at);
                let here = touch(&s.cam.follower, s.problem.drive.speed, 0.0, at, force);
                hertz::line(here.normal, s.problem.cam.thickness, here.curvature, steel).pressure
            })
            .fold(0.0, f64::max)
    };
    let most = worst(&free);
    let limit = 0.95 * most;
    let change = format!("limits.hertz_pressure={limit} Pa");
    let mut changes = base.to_vec();
    changes.push(&change);
    let s = design_of(scene::DEFAULT, &changes);
    assert!(s.infeasible.is_none() && check(&s, "hertz_pressure").pass);
    let held = worst(&s);
    assert!(
        held <= limit * (1.0 + 1e-6) && held > 0.999 * limit,
        "{held} {limit}"
    );
    assert!(s.binding.iter().any(|b| b.limit.name() == "hertz_pressure"));
    assert!(s.force.rms_error_n > free.force.rms_error_n);
}

const RISE: &str = r#"
name = "rise"
[drive]
kind = "fixed-axis"
mass = "1 kg"
speed = "10 rad/s"
[machine]
natural_frequency = "5 Hz"
[law]
family = "spline"
spans = 24
[[law.dwell]]
from = "0 deg"
to = "60 deg"
lift = "0"
[[law.dwell]]
from = "170 deg"
to = "230 deg"
lift = "10 mm"
[cam]
follower = "flat-translating"
base_radius = "60 mm"
"#;

/// Residual amplitude after the motion from `from` to `to` of a law with continuous velocity: |∫ a(θ) e^{−irθ} dθ|/r by Simpson's rule on each piece.
fn left_over(law: &Law, from: f64, to: f64, ratio: f64) -> f64 {
    const PARTS: usize = 400;
    let inner = |b: &f64| *b > from + 1e-6 && *b < to - 1e-6;
    let breaks = law.breaks().iter().copied();
    let ends: Vec<f64> = [from]
        .into_iter()
        .chain(breaks.filter(inner))
        .chain([to])
        .collect();
    let (mut cos, mut sin) = (0.0, 0.0);
    for pair in ends.windows(2) {
        let step = (pair[1] - pair[0]) / PARTS as f64;
        for k in 0..=PARTS {
            let theta = pair[0] + step * k as f64;
            let weight = match k {
                0 | PARTS => 1.0,
                _ if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            // From inside the piece: the acceleration may jump at its ends.
            let inside = theta.clamp(pair[0] + 1e-9, pair[1] - 1e-9);
            let part = weight * step / 3.0 * law.svaj(inside).a;
            cos += part * (ratio * theta).cos();
            sin += part * (ratio * theta).sin();
        }
    }
    cos.hypot(sin) / ratio
}

#[test]
fn a_dwell_is_left_quiet_where_vibration_is_limited() {
    let ratio = TAU * 5.0 / 10.0;
    let motion = (60f64.to_radians(), 170f64.to_radians());
    let undamped = "machine.damping_ratio=0";
    let free = design_of(RISE, &[undamped]);
    let rings = left_over(&free.cam.law, motion.0, motion.1, ratio);
    assert!(rings > 1e-4, "{rings}");
    let s = design_of(RISE, &[undamped, "limits.residual=0.001 mm"]);
    assert!(check(&s, "residual").pass, "{:?}", s.checks);
    for (from, to) in [motion, (230f64.to_radians(), TAU)] {
        let quiet = left_over(&s.cam.law, from, to, ratio);
        // What was left in the dwell before goes on beside it.
        assert!(quiet < 2e-6, "{quiet}");
    }
    // Asked for more than it leaves anyway, the law stays as it is.
    let wide = design_of(RISE, &[undamped, "limits.residual=50 mm"]);
    assert_eq!(wide.coefficients, free.coefficients);
}

#[test]
fn what_is_said_of_the_machine_must_make_sense() {
    for (change, words) in [
        ("machine.restitution=1.2", "outside 0 … 1"),
        ("machine.friction=-0.1", "negative"),
        ("machine.natural_frequency=60 mm", "wrong dimension"),
        ("machine.frictoin=0.1", "did you mean \"friction\""),
        ("limits.torque=0 N m", "not positive"),
        ("limits.hertz_pressure=5 N", "wrong dimension"),
    ] {
        let got = fault(RISE, change);
        assert!(got.contains(words), "{change}: {got}");
    }
    let got = fault(scene::DEFAULT, "limits.residual=1 mm");
    assert!(got.contains("machine.natural_frequency"), "{got}");
}

#[test]
fn an_arm_has_inertia_not_mass() {
    let arm = std::fs::read_to_string("scenes/camdas_02_oscillating_roller.toml").unwrap();
    let s = design_of(
        &arm,
        &[
            "drive.inertia=0.02 kg m^2",
            "drive.preload=2 N m",
            "drive.spring_rate=3 N m/rad",
        ],
    );
    assert_eq!(
        (
            s.problem.drive.mass,
            s.problem.drive.rest_force,
            s.problem.drive.spring_rate
        ),
        (0.02, 2.0, 3.0)
    );
    assert!(fault(&arm, "drive.mass=1 kg").contains("inertia"));
    assert!(fault(&arm, "drive.preload=1 N").contains("wrong dimension"));
    let got = fault(&arm, "drive.kind=moving-axis");
    assert!(got.contains("fixed pivot"), "{got}");
}

#[test]
fn an_eccentric_asks_of_the_machine_what_its_closed_form_says() {
    // s = e(1 − cos θ) under a weight: F = M(g + ω²e cos θ), T = F e sin θ (theory §3).
    let text = "name = \"eccentric\"\n\
        drive = { kind = \"moving-axis\", mass = \"2 kg\", speed = \"12 rad/s\" }\n\
        cam = { follower = \"flat-translating\", base_radius = \"30 mm\", thickness = \"10 mm\" }\n\
        [law]\nfamily = \"program\"\n\
        [[law.segment]]\nmotion = \"simple-harmonic\"\nlift = \"20 mm\"\nangle = \"180 deg\"\n\
        [[law.segment]]\nmotion = \"simple-harmonic\"\nlift = \"-20 mm\"\nangle = \"180 deg\"\n";
    let s = design_of(text, &[]);
    let (mass, e, speed) = (2.0, 0.01, 12.0_f64);
    let g = s.problem.drive.rest_force / mass;
    let bend = speed * speed * e;
    let machine = s.machine();
    let near = |value: Option<f64>, wanted: f64| {
        let value = value.unwrap();
        assert!((value / wanted - 1.0).abs() < 1e-9, "{value} {wanted}");
    };
    // dT/dθ = 0 where 2 ω²e cos²θ + g cos θ = ω²e.
    let cos = ((g * g + 8.0 * bend * bend).sqrt() - g) / (4.0 * bend);
    let most = mass * (g + bend * cos) * e * (1.0 - cos * cos).sqrt();
    near(machine.torque_max_n_m, most);
    near(machine.power_max_w, most * speed);
    let rms = mass * e * (0.5 * (g * g + 0.25 * bend * bend)).sqrt();
    near(machine.torque_rms_n_m, rms);
    assert_eq!(machine.power_mean_w, Some(0.0));
    near(machine.liftoff_speed_rad_per_s, (g / e).sqrt());
    // The disc's radius is base radius and eccentricity together.
    let steel = hertz::modulus(hertz::STEEL, hertz::STEEL);
    let pressed = hertz::line(mass * (g + bend), 0.01, 1.0 / 0.04, steel);
    near(machine.hertz_pressure_max_pa, pressed.pressure);
    // Without any load nothing is defined.
    let idle = text.replace(
        "kind = \"moving-axis\", mass = \"2 kg\"",
        "kind = \"fixed-axis\"",
    );
    assert_eq!(design_of(&idle, &[]).machine(), Default::default());
}

/// Maximum pressure at one depth of a groove, from its formulas at many angles.
fn sampled_in_groove(s: &Design, radius: f64) -> f64 {
    let groove = s.groove.as_ref().unwrap();
    let roller = groove.roller_radius();
    let steel = hertz::modulus(hertz::STEEL, hertz::STEEL);
    let square = (0..40_000).map(|i| {
        let at = s
            .cam
            .law
            .svaj(std::f64::consts::TAU * f64::from(i) / 40_000.0);
        let force = s.problem.drive.force(at);
        let length = (1.0 + (at.v / radius).powi(2)).sqrt();
        // The upper wall bears a pull, and bends the other way.
        let bulge = -force.signum() * at.a / (radius * radius * length.powi(3));
        force.abs() * length / (roller * (1.0 - roller * bulge))
    });
    let most = square.fold(0.0, f64::max);
    (most * steel / (std::f64::consts::PI * s.problem.cam.thickness)).sqrt()
}

#[test]
fn a_groove_is_judged_at_its_floor_and_at_its_rim_on_the_wall_that_bears() {
    let text = "name = \"groove\"\n[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\n\
        [cam]\nfollower = \"barrel\"\nroller_radius = \"6 mm\"\ndepth = \"12 mm\"\nbase_radius = \"40 mm\"\nthickness = \"10 mm\"\n\
        [law]\nfamily = \"program\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"25 mm\"\nangle = \"180 deg\"\n\
        [[law.segment]]\nmotion = \"cycloidal\"\nlift = \"-25 mm\"\nangle = \"180 deg\"\n";
    let mut governed = [false; 2];
    for changes in [
        &["drive.preload=500 N"][..],
        &["drive.mass=3 kg"],
        &["drive.mass=3 kg", "drive.preload=4 N"],
    ] {
        let s = design_of(text, changes);
        let (floor, rim) = s.groove.as_ref().unwrap().depth();
        let at = [floor, rim].map(|radius| sampled_in_groove(&s, radius));
        let most = at[0].max(at[1]);
        governed[usize::from(at[1] > at[0])] = true;
        let told = s.machine().hertz_pressure_max_pa.unwrap();
        assert!(
            (told / most - 1.0).abs() < 1e-6,
            "{changes:?} {told} {at:?}"
        );
        // The check is of the same number.
        for (part, pass) in [(1.001, true), (0.999, false)] {
            let limit = format!("limits.hertz_pressure={} Pa", part * told);
            let limited = design_of(text, &[changes, &[&limit]].concat());
            let check = limited
                .checks
                .iter()
                .find(|c| c.name == LimitKind::HertzPressure);
            assert_eq!(check.unwrap().pass, pass, "{changes:?}");
        }
    }
    assert_eq!(governed, [true; 2], "floor and rim");
}

#[test]
fn a_flat_face_presses_where_force_over_radius_is_highest() {
    let s = design_of(
        scene::DEFAULT,
        &["cam.base_radius=60 mm", "law.family=spline", "law.spans=9"],
    );
    let steel = hertz::modulus(hertz::STEEL, hertz::STEEL);
    let most = (0..60_000)
        .map(|i| {
            s.cam
                .law
                .svaj(std::f64::consts::TAU * f64::from(i) / 60_000.0)
        })
        .map(|at| s.problem.drive.force(at) / (0.06 + at.s + at.a))
        .fold(0.0, f64::max);
    let pressed = hertz::line(most, s.problem.cam.thickness, 1.0, steel).pressure;
    let told = s.machine().hertz_pressure_max_pa.unwrap();
    assert!(
        told >= pressed && told < pressed * (1.0 + 1e-7),
        "{told} {pressed}"
    );
}

const ECCENTRIC: &str = r#"
    name = "eccentric"
    [drive]
    kind = "fixed-axis"
    mass = "2 kg"
    spring_rate = "1 N/mm"
    preload = "100 N"
    speed = "10 rad/s"
    [law]
    family = "program"
    [[law.segment]]
    motion = "simple-harmonic"
    lift = "20 mm"
    angle = "180 deg"
    [[law.segment]]
    motion = "simple-harmonic"
    lift = "-20 mm"
    angle = "180 deg"
    [cam]
    follower = "roller-translating"
    roller_radius = "10 mm"
"#;

#[test]
fn base_circle_and_hole_are_judged_by_the_shaft_that_carries_the_torque() {
    // A shaft that carries T at a shear stress of 40 MPa: T = π d³ τ/16.
    let torque = peak_torque(&design_of(ECCENTRIC, &["cam.prime_radius=20 mm"]));
    let shaft = (16.0 * torque / (std::f64::consts::PI * 40e6)).cbrt();
    for (share, told) in [(1e-3, true), (0.99, true), (1.01, false), (10.0, false)] {
        let prime = 10e-3 + 0.5 * share * shaft;
        let design = design_of(ECCENTRIC, &[&format!("cam.prime_radius={prime} m")]);
        let found = design.notes.iter().find_map(|note| match note {
            Note::ThinShaft { circle, shaft, .. } => Some((circle.value, shaft.value)),
            _ => None,
        });
        assert_eq!(found.is_some(), told, "{share}");
        if let Some((across, least)) = found {
            assert!((across / (share * shaft) - 1.0).abs() < 1e-9);
            assert!((least / shaft - 1.0).abs() < 1e-6);
        }
    }
    // A hole is judged by the same shaft: one that is too thin breaks no rule, one eight times as wide is doubtful.
    for (share, told) in [(0.5, false), (7.9, false), (8.1, true), (25.4, true)] {
        let design = design_of(ECCENTRIC, &[&format!("cam.bore={} m", share * shaft)]);
        let notes = design.notes.iter();
        let shafts = notes.filter_map(|note| match note {
            Note::LargeBore { bore, shaft, .. } => Some(bore.value / shaft.value / share),
            Note::ThinShaft { .. } => Some(f64::NAN),
            _ => None,
        });
        let shafts: Vec<f64> = shafts.collect();
        assert_eq!(shafts.len(), usize::from(told), "{share}: {shafts:?}");
        assert!(shafts.iter().all(|s| (s - 1.0).abs() < 1e-6), "{shafts:?}");
    }
}
