//! Relaxations stated for a machine that moves with its cam are sufficient on that machine.

use gaitcam::Problem;
use gaitcam::cam::Verdict;
use gaitcam::criterion::Criterion;
use gaitcam::scene;
use gaitcam::synth::{Search, design};

/// Motor whose speed varies by some percent under the load of the cam.
const MOTOR: [(&str, &str); 2] = [
    ("machine.motor.slope", "10 N m s/rad"),
    ("machine.inertia", "2 kg m^2"),
];
/// Footbridge of 40 t whose first natural frequency is near the step frequency.
const FLOOR: [(&str, &str); 3] = [
    ("machine.floor.mass", "4e4 kg"),
    ("machine.floor.frequency", "2.1 Hz"),
    ("machine.floor.damping", "0.02"),
];

fn problem(changes: &[(&str, &str)]) -> Problem {
    let mut table = scene::table(scene::DEFAULT).unwrap();
    for (key, value) in changes {
        scene::set(&mut table, &format!("{key}={value}")).unwrap();
    }
    let scene = scene::read(&table).unwrap();
    Problem::resolve(&scene, scene.model_force().unwrap().as_ref()).unwrap()
}

#[test]
fn each_change_printed_for_a_motor_or_a_floor_is_sufficient_when_designed_again() {
    let limits = [
        ("limits.stroke", "40 mm"),
        ("limits.acceleration", "2 m/s^2"),
        ("limits.force_max", "850 N"),
    ];
    let mut printed = 0;
    for machine in [&MOTOR[..], &FLOOR[..]] {
        for limit in limits {
            let asked = problem(&[machine, &[limit]].concat());
            let refused = design(&asked, &Search::default()).unwrap();
            assert_eq!(refused.verdict, Verdict::Unacceptable, "{limit:?}");
            assert!(refused.problem.on_shaft.is_some(), "{limit:?}");
            let passes = |problem: &Problem| {
                let design = design(problem, &Search::default()).unwrap();
                design.verdict != Verdict::Unacceptable
            };
            let relaxed = refused.relaxed();
            let single = relaxed.relaxations.iter();
            for change in single.filter(|r| r.limit != Criterion::Inertia) {
                let Some(to) = change.to else { continue };
                let changed = asked.with(change.limit, to);
                assert!(passes(&changed), "{limit:?}: {} = {to}", change.key);
                printed += 1;
            }
            if !relaxed.together.is_empty() {
                let together = relaxed.together.iter();
                let all = together.fold(asked.clone(), |p, r| p.with(r.limit, r.to.unwrap()));
                assert!(passes(&all), "{limit:?}: {:?}", relaxed.together);
                printed += 1;
            }
        }
    }
    assert!(printed >= 8, "{printed}");
}
