//! Default family of a scene: harmonics in closed form if they satisfy the limits, otherwise a spline.

use gaitcam::criterion::LimitKind;
use gaitcam::scene::{Family, Scene};
use gaitcam::synth::{Design, PassedOver, synthesise};

const SCENE: &str = r#"
[gait]
model = "young"
step_frequency = "1.85 Hz"
body_weight = "700 N"
feet = "both"

[drive]
kind = "moving-axis"
"#;

fn read(more: &str) -> Scene {
    gaitcam_test_support::scene::<&str>(&format!("{SCENE}{more}"), &[]).unwrap()
}

fn built(more: &str) -> Design {
    let target = gaitcam_test_support::young();
    synthesise(&read(more), Some(&target)).unwrap()
}

#[test]
fn four_harmonics_of_youngs_load_are_its_law() {
    let design = built("");
    assert_eq!(
        (design.family.name(), design.solver.tier.name()),
        ("harmonic", "spectral")
    );
    // Young's model has the mean and four harmonics (theory §12): the inverse leaves nothing.
    assert_eq!(design.coefficients.len(), 9);
    assert!(design.force.rms_error_percent_of_mean < 1e-4);
    assert!(design.infeasible.is_none() && design.checks.iter().all(|c| c.pass));
}

#[test]
fn a_lower_accuracy_takes_fewer_harmonics() {
    let design = built("[accuracy]\nrms = \"4 %\"\n");
    assert_eq!(design.coefficients.len(), 7);
    assert!(design.force.rms_error_percent_of_mean <= 4.0);
}

#[test]
fn a_limit_that_harmonics_break_hands_over_to_a_spline_and_says_so() {
    let free = built("");
    let (low, high) = free.cam.law.extremes(3);
    let peak = high.value.max(-low.value) * free.problem.drive.speed.powi(3);
    let design = built(&format!("[limits]\njerk = \"{} m/s^3\"\n", 0.8 * peak));
    assert_eq!(design.family.name(), "spline");
    assert!(
        design
            .checks
            .iter()
            .all(|c| c.pass || c.name.name() == "rms_error")
    );
    assert!(
        matches!(&design.solver.passed_over, Some(PassedOver::Check { check, .. }) if *check == LimitKind::Jerk),
        "{}",
        design.solver.status(gaitcam::wording::Language::En)
    );
    // Held where it does not bind, the limit changes nothing.
    let loose = built(&format!("[limits]\njerk = \"{} m/s^3\"\n", 1.01 * peak));
    assert_eq!(loose.coefficients, free.coefficients);
}

#[test]
fn what_only_splines_have_asks_for_a_spline() {
    for asked in [
        "[law]\ndegree = 4\n",
        "[law]\nspans = 24\n",
        "[law]\nminimise = \"jerk\"\n",
        "[[law.dwell]]\nfrom = \"10 deg\"\nto = \"40 deg\"\n",
    ] {
        assert_eq!(read(asked).law.family, Family::Spline, "{asked}");
    }
    assert_eq!(read("[law]\nharmonics = 3\n").law.family, Family::Harmonic);
    assert_eq!(read("[law]\nfamily = \"auto\"\n"), read(""));
    let dwell = "[law]\nfamily = \"auto\"\n[[law.dwell]]\nfrom = \"10 deg\"\nto = \"40 deg\"\n";
    assert_eq!(built(dwell).family.name(), "spline");
}

/// Harmonics with a flat face, like splines: a smaller amplitude always has a smaller cam.
#[test]
fn harmonics_keep_a_limit_on_the_size_as_splines_do() {
    const SPRING: &str = r#"
name = "spring"
[gait]
model = "young"
step_frequency = "1.9 Hz"
body_weight = "600 N"
[drive]
kind = "fixed-axis"
mass = "1 kg"
spring_rate = "10 N/mm"
preload = "150 N"
[cam]
follower = "flat-translating"
[limits]
curvature = "5 mm"
[accuracy]
rms = "none"
"#;
    for harmonics in ["3", "8"] {
        let of = |changes: &[(&str, &str)]| {
            let mut scene = gaitcam_test_support::scene::<&str>(SPRING, &[]).unwrap();
            let family = [("law.family", "harmonic"), ("law.harmonics", harmonics)];
            for (key, value) in family.iter().chain(changes) {
                scene = scene.with(key, value).unwrap();
            }
            synthesise(&scene, scene.model_force().unwrap().as_ref()).unwrap()
        };
        let needed = of(&[]).cam.follower.prime_radius();
        let mut last = 0.0;
        for part in [0.95, 0.8, 0.6] {
            let limit = format!("{} mm", 1e3 * part * needed);
            let small = of(&[("limits.prime_radius", &limit), ("cam.bore", "1 mm")]);
            assert!(good(&small), "{harmonics} {part} {:?}", small.reasons);
            assert!(small.solver.certified, "{harmonics} {part}");
            assert!(small.force.rms_error_n > last);
            last = small.force.rms_error_n;
        }
    }
}

fn good(design: &Design) -> bool {
    design.infeasible.is_none() && design.checks.iter().all(|c| c.pass)
}
