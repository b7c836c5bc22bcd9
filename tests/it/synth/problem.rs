//! Values that a problem determines once, and results for demands that cannot be satisfied.

use gaitcam::Problem;
use gaitcam::force::{Feet, model};
use gaitcam::problem::Note;
use gaitcam::scene::Scene;
use gaitcam::synth::{Reason, synthesise};

fn read(text: &str) -> Scene {
    gaitcam_test_support::scene::<&str>(text, &[]).unwrap()
}

const FLAT: &str = r#"
name = "flat"
[gait]
model = "kerr"
step_frequency = "1.986 Hz"
body_weight = "700 N"
feet = "both"
[drive]
kind = "moving-axis"
[cam]
follower = "flat-translating"
base_radius = "6.47 mm"
[limits]
curvature = "23.6 mm"
stroke = "34.57 mm"
[accuracy]
rms = "none"
[law]
family = "spline"
degree = 4
spans = 12
"#;

/// A flat face has no roller. Base circle and prime circle are therefore equal, whichever key is given.
#[test]
fn base_and_prime_radius_of_a_flat_face_are_one_size() {
    let force = model("kerr", Some(1.986), 700.0, Feet::Both).unwrap();
    let by_base = read(FLAT);
    let by_prime = read(&FLAT.replace("base_radius", "prime_radius"));
    let sizes = |scene: &Scene| {
        let problem = Problem::resolve(scene, Some(&force)).unwrap();
        [problem.base_radius(), problem.prime_radius()]
    };
    let given = [Some(6.47e-3); 2];
    assert_eq!((sizes(&by_base), sizes(&by_prime)), (given, given));
    let [one, other] = [by_base, by_prime].map(|s| synthesise(&s, Some(&force)).unwrap());
    assert!(one.infeasible.is_none() && one.checks.iter().all(|c| c.pass));
    assert_eq!(one.coefficients, other.coefficients);
    assert_eq!(one.verdict, other.verdict);
}

/// Scene with a point on the base circle that has a velocity. The law goes below the base circle for any limits.
const BELOW: &str = r#"
name = "below"
[drive]
kind = "fixed-axis"
speed = "1.7 rad/s"
mass = "2 kg"
[cam]
follower = "flat-translating"
[limits]
acceleration = "1.9 m/s^2"
[law]
family = "spline"
degree = 5
spans = 12
[[law.point]]
angle = "90 deg"
lift = "0 mm"
velocity = "5 mm/rad"
[[law.point]]
angle = "200 deg"
lift = "10 mm"
"#;

#[test]
fn demands_below_the_base_circle_are_an_infeasible_answer_that_names_them() {
    let design = synthesise(&read(BELOW), None).unwrap();
    let why = design.infeasible.as_ref().unwrap();
    assert!(
        matches!(why.reasons[..], [Reason::DemandsInfeasible { .. }]),
        "{}",
        why.sentence(gaitcam::wording::Language::En)
    );
    assert!(
        why.conflict.len() == 2 && why.names().iter().all(|n| n.starts_with("law.point[1]")),
        "{:?}",
        why.conflict
    );
    assert_eq!(design.verdict.name(), "unacceptable");
}

/// The hub diameter is 1.5 times the shaft diameter. An automatic base circle leaves this wall around every bore; a smaller wall of a given base
/// circle is reported.
#[test]
fn an_automatic_base_circle_leaves_the_wall_of_a_hub() {
    let text = gaitcam_test_support::scene_file("footbridge");
    for bore in [0.006, 0.012, 0.03, 0.08] {
        for keyway in ["", "auto"] {
            let mut changes = vec![format!("cam.bore={bore} m")];
            if !keyway.is_empty() && bore > 0.006 {
                changes.push(format!("cam.keyway={keyway}"));
            }
            let noted = |changes: &[String]| {
                let design = gaitcam_test_support::design(&text, changes).unwrap();
                let thin = |n: &Note| matches!(n, Note::ThinWall { .. });
                (
                    design.cam.follower.base_radius(),
                    design.notes.iter().any(thin),
                )
            };
            let (base, thin) = noted(&changes);
            assert!(
                base >= 0.75 * bore * (1.0 - 1e-12) && !thin,
                "{changes:?}: {base}"
            );
            changes.push(format!("cam.base_radius={} m", 0.98 * base));
            assert!(noted(&changes).1, "{changes:?}");
        }
    }
}
