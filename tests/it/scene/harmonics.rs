//! User-defined load factors of the walking force: `gait.harmonics`.

use gaitcam::error::SceneError;
use gaitcam::scene::{self, Scene};
use gaitcam::synth::synthesise;
use std::f64::consts::TAU;

/// Factors and phases of SETRA 2006, section 3.2.1.
const SETRA: &str = r#"["0.4", "0.1 at -90 deg", "10 % at -0.25 rev"]"#;

fn footbridge(change: &str) -> gaitcam::error::Result<Scene> {
    let mut table = scene::table(scene::built_in("footbridge")?.toml)?;
    scene::set(&mut table, change)?;
    scene::read(&table)
}

#[test]
fn the_factors_of_setra_give_the_cam_of_setra_to_the_last_digit() {
    let made = |change: &str| {
        let scene = footbridge(change).unwrap();
        let force = scene.model_force().unwrap();
        synthesise(&scene, force.as_ref()).unwrap()
    };
    let (own, model) = (
        made(&format!("gait.harmonics={SETRA}")),
        made("gait.model=setra"),
    );
    let points = |d: &gaitcam::synth::Design| d.cam.profile(720);
    assert_eq!(points(&own), points(&model));
    assert_eq!(own.force.rms_error_n, model.force.rms_error_n);
    let factors = own.load_factors();
    for (k, factor) in [0.4, 0.1, 0.1].into_iter().enumerate() {
        assert!((factors[k].target - factor).abs() < 1e-12);
    }
}

#[test]
fn the_force_is_the_sum_of_its_sines() {
    let change = r#"gait.harmonics=["0.3 at 20 deg", "0", "5 % at -1 rad"]"#;
    let scene = footbridge(change).unwrap();
    let force = scene.model_force().unwrap().unwrap();
    assert_eq!(force.period_s, 1.0 / 1.85);
    for (i, given) in force.force_n.iter().enumerate() {
        let x = TAU * i as f64 / force.force_n.len() as f64;
        let sum = 1.0 + 0.3 * (x + TAU / 18.0).sin() + 0.05 * (3.0 * x - 1.0).sin();
        assert!((given - 700.0 * sum).abs() < 1e-9);
    }
    // A scene that is written reads back as itself.
    assert_eq!(scene::read(&scene.to_table()).unwrap(), scene);
}

#[test]
fn what_is_no_load_factor_is_named_with_what_would_do() {
    for (list, typed) in [
        (r#"["0.4 Hz"]"#, "0.4 Hz"),
        (r#"["-0.4"]"#, "-0.4"),
        (r#"["0.4", "0.1 at 3 mm"]"#, "0.1 at 3 mm"),
        (r#"["0.4", "nan"]"#, "nan"),
        (r#"["0.4", ""]"#, ""),
        (r#"["280 N"]"#, "280 N"),
    ] {
        let error = footbridge(&format!("gait.harmonics={list}")).unwrap_err();
        let known =
            matches!(error.fault(), Some(SceneError::NotHarmonic { typed: t }) if t == typed);
        assert!(known, "{list}: {error}");
        assert!(error.to_string().contains("gait.harmonics"), "{error}");
    }
    for list in ["0".to_string(), vec!["0.1"; 51].join(",")] {
        let error = footbridge(&format!("gait.harmonics={list}")).unwrap_err();
        assert!(
            matches!(error.fault(), Some(SceneError::Harmonics { most: 50, .. })),
            "{error}"
        );
    }
    let mut both = scene::table(scene::built_in("footbridge").unwrap().toml).unwrap();
    let gait = both["gait"].as_table_mut().unwrap();
    gait.insert("harmonics".to_string(), "0.4".into());
    let error = scene::read(&both).unwrap_err();
    assert_eq!(error.fault(), Some(&SceneError::FileAndModel));
    let one_foot = footbridge("gait.harmonics=0.4").and_then(|s| s.with("gait.feet", "left"));
    assert!(one_foot.unwrap().model_force().is_err());
}
