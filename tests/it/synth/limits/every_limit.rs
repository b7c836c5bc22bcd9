//! Every limit of the key table is held against the finished design.

use gaitcam::scene::keys::{self, Relax, Value};
use gaitcam::scene::{self, LimitKind};
use gaitcam::synth::synthesise;

const RISE_AND_FALL: &str = r#"
name = "rise and fall"
[drive]
kind = "fixed-axis"
mass = "1 kg"
preload = "50 N"
speed = "60 rpm"
[machine]
natural_frequency = "20 Hz"
[law]
family = "program"
[[law.segment]]
motion = "3-4-5"
lift = "20 mm"
angle = "60 deg"
[[law.segment]]
motion = "3-4-5"
lift = "-20 mm"
angle = "60 deg"
[[law.segment]]
motion = "dwell"
angle = "240 deg"
[cam]
follower = "roller-translating"
roller_radius = "5 mm"
prime_radius = "60 mm"
"#;

/// The same under a flat face, which alone has a width.
fn with_flat_face() -> String {
    RISE_AND_FALL
        .replace("roller-translating", "flat-translating")
        .replace("roller_radius = \"5 mm\"\n", "")
        .replace("prime_radius", "base_radius")
}

#[test]
fn every_limit_that_is_too_tight_has_a_check_that_fails() {
    for &kind in LimitKind::ALL {
        let text = match kind {
            LimitKind::FaceWidth => with_flat_face(),
            _ => RISE_AND_FALL.to_string(),
        };
        let mut scene = scene::parse(&text).unwrap();
        let key = keys::of_limit(kind).unwrap();
        let tight = match key.relax {
            Some(Relax::Up) => 1e-9,
            _ => 1e6,
        };
        key.set(&mut scene, 0, Value::Number(tight)).unwrap();
        let design = synthesise(&scene, None).unwrap();
        let measured = |name| kind.is_measured_by(name);
        let found = design.checks.iter().filter(|c| measured(c.name));
        let failed: Vec<bool> = found.map(|c| c.pass).collect();
        assert!(!failed.is_empty(), "{kind:?} has no check");
        assert!(!failed.contains(&true), "{kind:?}: {:?}", design.checks);
    }
}
