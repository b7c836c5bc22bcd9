//! Pressure angle of rise and fall compared with the profile.

use gaitcam::cam::{Cam, Verdict};
use gaitcam::criterion::LimitKind;
use gaitcam::scene;
use gaitcam::scene::Scene;
use gaitcam::synth::{Design, synthesise};

const SIDES: [LimitKind; 2] = [LimitKind::PressureAngleRise, LimitKind::PressureAngleFall];

/// Maximum |pressure angle| of rise and fall, from samples.
fn sampled(cam: &Cam) -> [f64; 2] {
    let (start, length) = cam.law.extent();
    let mut worst = [0.0_f64; 2];
    for i in 0..20_000 {
        let theta = start + length * (f64::from(i) + 0.5) / 20_000.0;
        let side = usize::from(cam.law.svaj(theta).v < 0.0);
        worst[side] = worst[side].max(cam.point(theta).pressure_angle.abs());
    }
    worst
}

fn stated(design: &Design) -> [f64; 2] {
    SIDES.map(|side| design.checks.iter().find(|c| c.name == side).unwrap().worst)
}

fn footbridge(changes: &[(&str, &str)]) -> Scene {
    let start = scene::built_in("footbridge").unwrap().scene().unwrap();
    let mut table = start.to_table();
    for (key, text) in changes.iter().chain(&[("accuracy.rms", "none")]) {
        scene::set(&mut table, &format!("{key}={text}")).unwrap();
    }
    scene::read(&table).unwrap()
}

#[test]
fn rise_and_fall_are_told_by_the_motion() {
    let (mut tried, mut passed) = (0, 0);
    for follower in [
        "roller-translating",
        "knife-translating",
        "mushroom-translating",
    ] {
        for offset in ["auto", "0 mm", "15 mm", "-15 mm"] {
            for (key, angle) in [
                ("rise", 5.0),
                ("fall", 12.0),
                ("rise", 40.0),
                ("fall", 28.0),
            ] {
                let mut changes = vec![("cam.follower", follower), ("cam.offset", offset)];
                match follower {
                    "roller-translating" => changes.push(("cam.roller_radius", "10 mm")),
                    "mushroom-translating" => changes.push(("cam.arc_radius", "40 mm")),
                    _ => {}
                }
                let key = format!("limits.pressure_angle_{key}");
                let text = format!("{angle} deg");
                changes.push((&key, &text));
                let scene = footbridge(&changes);
                let force = scene.model_force().unwrap();
                let Ok(design) = synthesise(&scene, force.as_ref()) else {
                    continue;
                };
                tried += 1;
                let own = sampled(&design.cam);
                for (own, stated) in own.into_iter().zip(stated(&design)) {
                    let apart = stated - own;
                    assert!(
                        (-1e-9..1e-3).contains(&apart),
                        "{changes:?}: {own} {stated}"
                    );
                }
                if design.verdict == Verdict::Unacceptable {
                    continue;
                }
                passed += 1;
                let limits = design.problem.limits.pressure_angles();
                let bounds = limits.map(|limit| limit.unwrap_or(45_f64.to_radians()));
                for (own, bound) in own.into_iter().zip(bounds) {
                    assert!(own <= bound * (1.0 + 1e-6), "{changes:?}: {own} {bound}");
                }
            }
        }
    }
    assert!(tried >= 40 && passed >= 30, "{tried} {passed}");
}
