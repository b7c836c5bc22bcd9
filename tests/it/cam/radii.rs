//! Radii of the profile, and the limit on the diameter, against dense points of the profile.

use super::{oscillating, roller};
use gaitcam::LimitKind;
use gaitcam::cam::{Cam, Follower, ProfilePoint};
use gaitcam::scene;
use gaitcam_test_support::{design_of, turn};

const POINTS: usize = 20_000;

fn distances(cam: &Cam) -> [f64; 2] {
    let of = |p: &ProfilePoint| p.x.hypot(p.y);
    let all: Vec<f64> = cam.profile(POINTS).iter().map(of).collect();
    [
        all.iter().copied().fold(f64::INFINITY, f64::min),
        all.iter().copied().fold(0.0, f64::max),
    ]
}

#[test]
fn radii_of_every_follower_are_those_of_dense_points() {
    let law = turn(&[
        ("cycloidal", 0.02, 100.0),
        ("dwell", 0.0, 60.0),
        ("3-4-5", -0.02, 120.0),
        ("dwell", 0.0, 80.0),
    ]);
    let translating = [
        Follower::FlatTranslating { base_radius: 0.06 },
        roller(0.05, 0.0, 0.01),
        roller(0.05, 0.012, 0.01),
        roller(0.05, -0.012, 0.0),
        Follower::MushroomTranslating {
            prime_radius: 0.09,
            offset: 0.0,
            arc_radius: 0.04,
        },
    ];
    let translating = translating.map(|follower| Cam::new(law.clone(), follower).unwrap());
    for cam in translating.into_iter().chain(oscillating()) {
        let [least, most] = cam.radii().unwrap().map(|end| end.value);
        let [low, high] = distances(&cam);
        assert!(
            (least - low).abs() < 1e-7 && (most - high).abs() < 1e-7,
            "{cam:?}"
        );
    }
}

/// A fitted cam of a follower, without a limit on the accuracy.
fn fitted(cam: &str) -> String {
    format!(
        "[gait]\nmodel = \"young\"\nstep_frequency = \"1.85 Hz\"\nbody_weight = \"700 N\"\n[cam]\n{cam}\n\
         [law]\nfamily = \"spline\"\nspans = 12\n[accuracy]\nrms = \"none\"\n[limits]\ncurvature = \"4 mm\"\n"
    )
}

/// Every follower under limits on the diameter from a tight to a wide one: a design that passes is not larger, and its stated diameter is that of
/// dense points.
#[test]
fn no_design_that_passes_is_larger_than_its_limit() {
    let roller = "follower = \"roller-translating\"\nroller_radius = \"8 mm\"";
    let built_in = |name: &str| scene::built_in(name).unwrap().toml.to_string();
    let scenes = [
        fitted("follower = \"flat-translating\""),
        fitted("follower = \"flat-translating\"\nbase_radius = \"30 mm\""),
        fitted(roller),
        fitted(&format!("{roller}\noffset = \"auto\"")),
        fitted(&format!("{roller}\noffset = \"7 mm\"")),
        fitted(&format!(
            "{roller}\noffset = \"6 mm\"\nprime_radius = \"60 mm\""
        )),
        fitted("follower = \"mushroom-translating\"\narc_radius = \"60 mm\""),
        built_in("camdas_02_oscillating_roller"),
        built_in("camdas_04_oscillating_flat"),
        built_in("camdas_07_conjugate_roller"),
    ];
    let (mut passed, mut failed, mut eased) = (0, 0, 0);
    for text in scenes {
        let natural = 2.0 * design_of(&text, &[]).cam.radii().unwrap()[1].value;
        for step in 0..8 {
            let limit = natural * (0.8 + 0.06 * f64::from(step));
            let design = design_of(&text, &[&format!("limits.diameter={limit} m")]);
            let largest = 2.0 * distances(&design.cam)[1];
            let own = design.checks.iter().find(|c| c.name == LimitKind::Diameter);
            let own = own.expect("the limit is checked");
            let difference = (own.worst - largest).abs();
            assert!(
                difference < 1e-6 * largest,
                "{text} {}: {largest}",
                own.worst
            );
            for easing in (design.easing.iter()).filter(|e| e.limit == LimitKind::Diameter) {
                let values = [easing.from / limit, easing.to / limit];
                assert!((values[0] - 1.0).abs() < 1e-9, "{text} {limit}: {easing:?}");
                assert!(
                    (values[1] - 1.01).abs() < 1e-9,
                    "{text} {limit}: {easing:?}"
                );
                assert!(easing.after <= easing.before, "{text} {limit}: {easing:?}");
                eased += 1;
            }
            if own.pass {
                passed += 1;
                assert!(largest <= limit * (1.0 + 1e-8), "{text} {limit}: {largest}");
            } else {
                failed += 1;
            }
        }
    }
    assert!(passed >= 40, "{passed} pass, {failed} fail");
    assert!(eased >= 10, "{eased} sensitivities to the diameter");
}

/// Where the size is part of the program the limit is met, and a smaller diameter has a larger force error.
#[test]
fn a_limit_on_the_diameter_of_a_fitted_cam_is_met_and_priced() {
    let text = fitted("follower = \"flat-translating\"");
    let error = |diameter: f64| {
        let design = design_of(&text, &[&format!("limits.diameter={diameter} mm")]);
        let failed: Vec<_> = design.checks.iter().filter(|c| !c.pass).collect();
        assert!(
            failed.is_empty(),
            "{diameter}: {failed:?} {:?}",
            design.reasons
        );
        let largest = 2e3 * distances(&design.cam)[1];
        assert!(largest <= diameter * (1.0 + 1e-8), "{largest} {diameter}");
        design.force.rms_error_n
    };
    let errors = [95.0, 85.0, 75.0, 65.0].map(error);
    assert!(
        errors.windows(2).all(|pair| pair[1] > pair[0]),
        "{errors:?}"
    );
}
