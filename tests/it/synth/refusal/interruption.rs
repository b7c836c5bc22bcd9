//! A search for relaxations ends on request.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use gaitcam::Problem;
use gaitcam::cam::Verdict;
use gaitcam::halt::Halt;
use gaitcam::synth::{Reason, Search, design, synthesise};

use super::relaxations::good;
use gaitcam_test_support::{scene_file, scene_of, young};

/// Scene whose limits allow no law near the force, with enough spans for a long search.
const CRAMPED: &str = r#"
name = "cramped"
[gait]
model = "young"
step_frequency = "1.85 Hz"
body_weight = "700 N"
[drive]
kind = "fixed-axis"
mass = "5 kg"
spring_rate = "8000 N/m"
preload = "100 N"
[law]
family = "spline"
spans = 400
[cam]
follower = "roller-translating"
prime_radius = "60 mm"
roller_radius = "8 mm"
[limits]
stroke = "50 mm"
acceleration = "30 m/s^2"
jerk = "900 m/s^3"
velocity = "2 m/s"
force_min = "10 N"
force_max = "2000 N"
pressure_angle = "40 deg"
"#;

#[test]
fn an_end_that_only_the_callers_thread_hears_is_heard_while_relaxations_run() {
    let scene = scene_of(CRAMPED, &[]);
    let force = young();
    let design = synthesise(&scene, Some(&force)).unwrap();
    assert!(!good(&design));
    let caller = thread::current().id();
    let first: Arc<OnceLock<Instant>> = Arc::default();
    let begun = Arc::clone(&first);
    let halt = Halt::when(move || {
        let begun = begun.get_or_init(Instant::now);
        thread::current().id() == caller && begun.elapsed() > Duration::from_millis(20)
    });
    let relaxed = design.relaxed_with(&Search::until(halt));
    let took = first.get().unwrap().elapsed();
    assert!(relaxed.out_of_time);
    // Unheard, the search takes many times as long; heard, the time of one look and of one step, on busy cores too.
    assert!(took < Duration::from_secs(2), "{took:?}");
}

#[test]
fn only_a_search_that_was_cut_short_is_out_of_time() {
    let mut cut = 0;
    for (name, changes) in [
        ("footbridge", &[][..]),
        (
            "footbridge",
            &["law.family=spline", "law.spans=40", "limits.stroke=40 mm"],
        ),
        (
            "footbridge",
            &["law.minimise=peak-snap", "law.spans=24", "accuracy.rms=5 %"],
        ),
        (
            "footbridge",
            &["law.family=spline", "law.spans=24", "limits.stroke=30 mm"],
        ),
        (
            "footbridge",
            &[
                "cam.follower=roller-translating",
                "cam.roller_radius=8 mm",
                "limits.pressure_angle=30 deg",
                "law.family=spline",
                "law.spans=16",
            ],
        ),
    ] {
        let scene = scene_of(&scene_file(name), changes);
        let force = scene.model_force().unwrap();
        let problem = Problem::resolve(&scene, force.as_ref()).unwrap();
        let looks = Arc::new(AtomicUsize::new(0));
        let counted = Arc::clone(&looks);
        let halt = Halt::when(move || {
            counted.fetch_add(1, Ordering::Relaxed);
            false
        });
        let whole = design(&problem, &Search::until(halt)).unwrap();
        let looks = looks.load(Ordering::Relaxed);
        for part in [0, looks / 3, looks / 2, looks.saturating_sub(1), looks] {
            let halt = Halt::never().or_after(part);
            let Ok(found) = design(&problem, &Search::until(halt)) else {
                continue;
            };
            let case = format!("{name} {changes:?}, {part} of {looks} looks");
            // The time is over once the last look was taken, but nothing was cut.
            assert!(part < looks || !found.out_of_time, "{case}");
            if found.out_of_time && found.infeasible.is_none() {
                cut += 1;
                assert_eq!(found.verdict, Verdict::Unacceptable, "{case}");
                assert_eq!(found.reasons[0], Reason::OutOfTime, "{case}");
                assert!(!found.reasons.contains(&Reason::AllHold), "{case}");
            } else if !found.out_of_time {
                assert_eq!(found.verdict, whole.verdict, "{case}");
                assert_eq!(found.reasons, whole.reasons, "{case}");
            }
        }
    }
    assert!(cut >= 3, "{cut}");
}
