//! The smallest cam that keeps all other limits says which prime radii are possible, whatever is minimised.

use gaitcam::force::{ForceCurve, force_curve};
use gaitcam::scene::{self, Source};
use gaitcam::synth::synthesise;

use super::relaxations::{good, proved, scene_of};

const FOOTBRIDGE: &str = include_str!("../../../../scenes/footbridge.toml");
const HEEL: &str = include_str!("../../../../scenes/heel_tester_fitted.toml");

fn force() -> ForceCurve {
    let scene = scene::built_in("heel_tester_fitted").unwrap();
    let gait = scene.scene().unwrap().gait.unwrap();
    let Source::File(path) = &gait.source else {
        unreachable!("the heel tester's force is a file")
    };
    let bytes = scene::built_in_file(path).unwrap();
    let options = gait.read_options(None).unwrap();
    force_curve(path, bytes, &options, gait.feet).unwrap()
}

/// A law for a cam of any radius above the smallest is found under every objective: at 30° both pressure angles fix the offset,
/// at 42.6° the curvature shares in it.
#[test]
fn a_cam_hardly_larger_than_the_smallest_is_built_whatever_is_minimised() {
    let force = force();
    for angle in ["30", "42.6"] {
        let angle = format!("limits.pressure_angle={angle} deg");
        let smallest = synthesise(&scene_of(HEEL, &[&angle]), Some(&force)).unwrap();
        assert!(good(&smallest));
        for (factor, minimise) in [
            (1.0005, "force-error"),
            (1.003, "force-error"),
            (1.02, "force-error"),
            (1.26, "force-error"),
            (1.003, "peak-force-error"),
            (1.02, "jerk"),
        ] {
            let radius = 1e3 * factor * smallest.cam.follower.prime_radius();
            let changes = [
                &angle,
                &format!("limits.prime_radius={radius} mm"),
                &format!("law.minimise={minimise}"),
                "accuracy.rms=50 %",
            ];
            let design = synthesise(&scene_of(HEEL, &changes), Some(&force)).unwrap();
            assert!(good(&design), "{changes:?}: {:?}", design.reasons);
        }
    }
}

/// The same of random rollers, curvatures, pressure angles, spans and accuracies under the walker of 700 N; the largest error is
/// minimised in one of them, because it takes seconds.
#[test]
fn random_cams_hardly_larger_than_the_smallest_are_built() {
    let mut seed = 12345_u64;
    let mut random = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        low + (high - low) * (seed >> 33) as f64 / f64::from(u32::MAX >> 1)
    };
    let objectives = ["force-error", "jerk", "acceleration", "size"];
    for case in 0..9 {
        let set = [
            format!("cam.roller_radius={:.3} mm", random(5.0, 20.0)),
            "cam.follower=roller-translating".to_string(),
            "cam.offset=auto".to_string(),
            format!("limits.pressure_angle={:.2} deg", random(18.0, 45.0)),
            format!("limits.curvature={:.3} mm", random(1.0, 25.0)),
            format!("gait.step_frequency={:.4} Hz", random(1.5, 2.3)),
            format!("law.spans={}", random(14.0, 40.0) as u32),
            "law.family=spline".to_string(),
            format!("accuracy.rms={:.2} %", random(1.0, 6.0)),
        ];
        let design = |more: [String; 2]| {
            let mut all: Vec<&str> = set.iter().map(String::as_str).collect();
            all.extend(more.iter().map(String::as_str).filter(|m| !m.is_empty()));
            let scene = scene_of(FOOTBRIDGE, &all);
            synthesise(&scene, scene.model_force().unwrap().as_ref()).unwrap()
        };
        let smallest = design(["law.minimise=size".to_string(), String::new()]);
        assert!(good(&smallest), "{case}: {:?}", smallest.reasons);
        let peak = (case == 8).then_some("peak-force-error");
        for (k, minimise) in objectives.into_iter().chain(peak).enumerate() {
            let factor = [1.0005, 1.005, 1.02, 1.01, 1.05][k];
            let radius = 1e3 * factor * smallest.cam.follower.prime_radius();
            let limit = format!("limits.prime_radius={radius} mm");
            let built = design([limit.clone(), format!("law.minimise={minimise}")]);
            assert!(
                good(&built),
                "{case} {minimise} {limit}: {:?}",
                built.reasons
            );
        }
    }
}

/// A smaller one is refused with values that serve, and less of each does not.
#[test]
fn a_cam_smaller_than_the_smallest_is_refused_with_what_would_do() {
    let force = force();
    let far = proved(HEEL, Some(&force), &["limits.prime_radius=45 mm"]);
    assert_eq!(far, ["pressure_angle", "prime_radius"]);
    let near = proved(
        HEEL,
        Some(&force),
        &["limits.prime_radius=50 mm", "law.minimise=force-error"],
    );
    assert_eq!(near, ["curvature", "pressure_angle", "prime_radius"]);
}
