//! Target force on an oscillating follower: F·L is the moment about the pivot, s is an angle.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use gaitcam::Problem;
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::scene::{self, Gait, Scene};
use gaitcam::synth::Design;
use gaitcam::synth::synthesise;
use gaitcam::synth::{self, Figures, Search};

const MEAN: f64 = 60.0;
const SWING: f64 = 25.0;

/// Target force F = 60 N + 25 N sin θ with a period of 0.5 s.
fn sine() -> ForceCurve {
    let at = |i| MEAN + SWING * (TAU * f64::from(i) / 720.0).sin();
    ForceCurve::from_samples("a sine", 0.5, (0..720).map(at).collect()).unwrap()
}

fn design(toml: &str) -> Design {
    let toml = format!("[gait]\nmodel = \"young\"\n{toml}");
    let scene = Scene {
        gait: Some(Gait::given()),
        ..scene::parse(&toml).unwrap()
    };
    let design = synthesise(&scene, Some(&sine())).unwrap();
    assert!(design.infeasible.is_none(), "{:?}", design.reasons);
    design
}

const ROLLER: &str = r#"follower = "roller-oscillating"
roller_radius = "10 mm"
pivot_distance = "120 mm"
arm = "100 mm"
"#;
const FLAT: &str = r#"follower = "flat-oscillating"
pivot_distance = "100 mm"
"#;

/// Asserts that the lift is mean + amplitude·sin θ, rad, and that the force in N equals the target.
fn follows(design: &Design, mean: f64, amplitude: f64) {
    for i in 0..36 {
        let theta = TAU * f64::from(i) / 36.0;
        let lift = mean + amplitude * theta.sin();
        let own = design.cam.law.svaj(theta);
        let off = own.s - lift;
        assert!(
            off.abs() < 2e-3 * amplitude,
            "θ = {theta}: {} {lift}",
            own.s
        );
    }
    let stroke = design.cam.law.stroke();
    assert!((stroke / (2.0 * amplitude) - 1.0).abs() < 2e-3);
    let force = Figures::of(design).force;
    let near = |x: f64, y: f64| assert!((x / y - 1.0).abs() < 5e-3, "{x} {y}");
    near(force.target_mean_n, MEAN);
    near(force.mean_n, MEAN);
    near(force.max_n, MEAN + SWING);
    near(force.min_n, MEAN - SWING);
    assert!(force.rms_error_n < 5e-3 * MEAN);
}

#[test]
fn a_piston_on_an_arm_gives_the_force_at_its_lever() {
    // The piston at L moves L·s and presses with (P/V) A² L s.
    for (cam, key, lever) in [
        (ROLLER, "", 0.1),
        (ROLLER, "lever = \"150 mm\"", 0.15),
        (FLAT, "", 0.1),
        (FLAT, "lever = \"80 mm\"", 0.08),
    ] {
        let drive = format!(
            "[drive]\nkind = \"hydraulic\"\npressure_per_volume = \"5e10 Pa/m^3\"\npiston_radius = \"12 mm\"\n{key}\n[cam]\n"
        );
        let design = design(&(drive + cam));
        let rate = 5e10 * (PI * 0.012 * 0.012).powi(2);
        follows(&design, MEAN / (rate * lever), SWING / (rate * lever));
    }
}

#[test]
fn a_spring_on_an_arm_gives_the_force_at_its_lever() {
    // F L = M₀ + k s + J ω² s″: the first harmonic of s is F₁ L / (k − J ω²).
    for (cam, lever) in [(ROLLER, 0.1), (FLAT, 0.1)] {
        let drive = "[drive]\nkind = \"fixed-axis\"\nspring_rate = \"40 N m/rad\"\npreload = \"2 N m\"\ninertia = \"0.02 kg m^2\"\n[cam]\n";
        let design = design(&(drive.to_string() + cam));
        let speed = TAU / 0.5;
        let stiffness = 40.0 - 0.02 * speed * speed;
        follows(
            &design,
            (MEAN * lever - 2.0) / 40.0,
            SWING * lever / stiffness,
        );
    }
}

#[test]
fn a_point_that_gives_a_force_on_an_arm_gives_it_at_its_lever() {
    // The closed curve through 30 N and 90 N on a spring of 40 N·m/rad at 0.1 m.
    let toml = format!(
        "[drive]\nkind = \"fixed-axis\"\nspeed = \"1 rad/s\"\nspring_rate = \"40 N m/rad\"\n[law]\nfamily = \"spline\"\n\
         point = [{{ angle = \"0 deg\", force = \"30 N\" }}, {{ angle = \"180 deg\", force = \"90 N\" }}]\n[cam]\n{ROLLER}"
    );
    let design = synthesise(&scene::parse(&toml).unwrap(), None).unwrap();
    let lift = |theta| design.cam.law.svaj(theta).s;
    assert!((lift(0.0) - 30.0 * 0.1 / 40.0).abs() < 1e-9);
    assert!((lift(PI) - 90.0 * 0.1 / 40.0).abs() < 1e-9);
}

#[test]
fn an_arm_too_short_is_refused_before_any_law_is_sought() {
    let toml = format!(
        "[drive]\nkind = \"fixed-axis\"\nspeed = \"1 rad/s\"\nspring_rate = \"40 N m/rad\"\n[law]\nfamily = \"spline\"\n\
         point = [{{ angle = \"0 deg\", lift = \"0 rad\" }}, {{ angle = \"180 deg\", lift = \"0.1 rad\" }}]\n\
         [cam]\n{}prime_radius = \"15 mm\"\n",
        ROLLER.replace("100 mm", "60 mm")
    );
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    let halt = Halt::when(move || count.fetch_add(1, Relaxed) > 0);
    let problem = Problem::resolve(&scene::parse(&toml).unwrap(), None).unwrap();
    let fault = synth::design(&problem, &Search::until(halt)).unwrap_err();
    assert!(fault.to_string().starts_with("cam: the arm of"), "{fault}");
    assert_eq!(asked.load(Relaxed), 0, "{fault}");
}
