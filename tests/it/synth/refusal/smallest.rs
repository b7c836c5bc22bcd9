//! The smallest cam that satisfies all other limits determines the possible prime radii for any objective.

use gaitcam::force::{ForceCurve, force_curve};
use gaitcam::scene::{self, Source};
use gaitcam::synth::synthesise;

use super::relaxations::{good, proved};
use gaitcam_test_support::scene_of;

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

/// A law is found for a prime radius above the smallest with every objective. At 30° both pressure angles determine the offset; at 42.6° the
/// curvature does so too.
#[test]
fn a_cam_hardly_larger_than_the_smallest_is_built_whatever_is_minimised() {
    let force = force();
    let by_offset = [
        (1.0005, "force-error"),
        (1.02, "force-error"),
        (1.003, "peak-force-error"),
    ];
    let by_curvature = [
        (1.003, "force-error"),
        (1.26, "force-error"),
        (1.02, "jerk"),
    ];
    for (angle, above) in [("30", by_offset), ("42.6", by_curvature)] {
        let angle = format!("limits.pressure_angle={angle} deg");
        let smallest = synthesise(&scene_of(HEEL, &[&angle]), Some(&force)).unwrap();
        assert!(good(&smallest));
        for (factor, minimise) in above {
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

/// A smaller prime radius is rejected with sufficient changes, and smaller changes are not sufficient.
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
