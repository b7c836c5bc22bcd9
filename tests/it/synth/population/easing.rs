//! Effect of a limit of the scene on the errors of all walkers.

use super::with;
use gaitcam::synth::Design;

fn error(design: &Design) -> f64 {
    let population = design.population.as_ref().unwrap();
    population.objective_percent / 100.0 * design.force.target_mean_n
}

#[test]
fn an_eased_limit_begins_at_the_limit_of_the_scene_and_gives_the_error_of_the_walkers_that_its_design_has()
 {
    for (key, value, eased, si) in [
        ("limits.force_max", "1100 N", "1101.1 N", 1100.0),
        ("limits.force_min", "520 N", "519.48 N", 520.0),
        ("limits.acceleration", "4 m/s^2", "4.004 m/s^2", 4.0),
        ("limits.jerk", "80 m/s^3", "80.08 m/s^3", 80.0),
        ("limits.stroke", "40 mm", "40.04 mm", 0.04),
    ] {
        let of = |value: &str| {
            let changes = [
                ("gait.step_frequency", "1.6 Hz:2.1 Hz:4"),
                ("law.spans", "24"),
                ("accuracy.rms", "none"),
                (key, value),
            ];
            with(&changes).design().unwrap()
        };
        let [design, wider] = [of(value), of(eased)];
        let easing = &design.easing[0];
        assert!((easing.from / si - 1.0).abs() < 1e-9, "{key}: {easing:?}");
        assert!(
            ((easing.to - easing.from).abs() / si - 0.01).abs() < 1e-9,
            "{key}: {easing:?}"
        );
        assert!(
            (easing.before / error(&design) - 1.0).abs() < 1e-6,
            "{key}: {easing:?}"
        );
        // To first order the mean square falls with the limit: by a tenth of what is said where it is eased by a tenth as much.
        let said = 0.1 * (easing.before.powi(2) - easing.after.powi(2));
        let gained = error(&design).powi(2) - error(&wider).powi(2);
        assert!(
            gained > 0.0 && (said / gained - 1.0).abs() < 0.1,
            "{key}: {said} {gained}"
        );
    }
}
