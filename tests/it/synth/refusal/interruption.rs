//! A search for relaxations ends when it is asked to.

use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use gaitcam::halt::Halt;
use gaitcam::synth::{Search, synthesise};

use super::relaxations::good;
use gaitcam_test_support::{scene_of, young};

/// Limits that leave no law near the force, on spans enough for the search to take its time.
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
