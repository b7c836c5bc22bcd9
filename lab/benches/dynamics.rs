//! Speed of the dynamic models on 1440 emitted points.

use gaitcam::cam::Cam;
use gaitcam::drive::Drive;
use gaitcam::dynamics::Surface;
use gaitcam::dynamics::contact::{self, Limits};
use gaitcam::dynamics::flexible::{self, Train};
use gaitcam::dynamics::{Emitted, recover};
use gaitcam::dynamics::{FollowerContact, Machine, Model, Run, simulate};
use gaitcam::scene::{self, Family, Scene, ShaftSpeed};
use gaitcam_test_support::thesis;

fn main() {
    divan::main();
}

fn emitted(cam: &Cam) -> Emitted {
    recover(&cam.follower, &cam.profile(1440)).expect("the thesis's cams are curves")
}

#[divan::bench]
fn recover_1440_points(bencher: divan::Bencher) {
    let cam = thesis::double_harmonic();
    let points = cam.profile(1440);
    bencher.bench(|| recover(&cam.follower, &points));
}

/// Required: ≤ 5 µs.
#[divan::bench]
fn rigid_cycle(bencher: divan::Bencher) {
    let cam = thesis::double_harmonic();
    let emitted = emitted(&cam);
    let drive = thesis::real(thesis::SPEED);
    let contact = FollowerContact::of(&cam.follower);
    bencher.bench(|| {
        let nodes = divan::black_box(&emitted.nodes);
        let forces: Vec<f64> = nodes.iter().map(|at| drive.force(*at)).collect();
        contact.torques(0.1, nodes, &forces)
    });
}

/// Required from the emitted lift to the steady state: ≤ 200 µs.
#[divan::bench]
fn flexible_cycle(bencher: divan::Bencher) {
    let emitted = emitted(&thesis::double_harmonic());
    let drive = thesis::real(thesis::SPEED);
    let train = Train::from_frequency(&drive, 30.0, 0.05).expect("a fine train");
    bencher.bench(|| flexible::steady(&emitted.law, &drive, &train));
}

/// Shafts of the footbridge: inertia, kg·m², and drop of the motor torque with speed, N·m per rad/s. An empty text is constant speed.
const SHAFTS: [&str; 7] = [
    "constant", "0.5, 2", "0.5, 10", "0.5, 50", "2, 2", "2, 10", "2, 50",
];

fn on_shaft(shaft: &str) -> Scene {
    let scene = scene::built_in("footbridge").and_then(|s| s.scene());
    let mut scene = scene.expect("a built-in scene");
    // Designs with and without a motor have the same family.
    scene.law.family = Family::Spline;
    if let Some((wheel, slope)) = shaft.split_once(", ") {
        scene.machine.inertia = wheel.parse().ok();
        scene.machine.motor.slope = slope.parse().ok();
    }
    scene
}

/// Required with the motor: ≤ 2 ms.
#[divan::bench(args = ["constant", "0.5, 10"])]
fn run_on_a_shaft(bencher: divan::Bencher, shaft: &str) {
    let mut scene = on_shaft(shaft);
    scene.law.shaft = ShaftSpeed::Constant;
    let design = scene.design().expect("a design");
    let run = design.emitted(&scene.machine, design.problem.drive);
    let run = run.expect("a rigid machine");
    bencher.bench(|| simulate(&run, Model::Rigid));
}

/// Required: with a motor ≤ 5 times the time without. The design needs two to four programs and about eight runs of the shaft.
#[divan::bench(args = SHAFTS)]
fn design_for_a_shaft(bencher: divan::Bencher, shaft: &str) {
    let scene = on_shaft(shaft);
    bencher.bench(|| scene.design());
}

fn bouncing() -> (Vec<Surface>, Drive) {
    let drive = thesis::real(27.0);
    let law = emitted(&thesis::double_harmonic()).law;
    (vec![Surface::new(law, &drive)], drive)
}

/// Required with ten impacts: ≤ 2 ms. For e = 0.5 there are about thirty before rest.
#[divan::bench]
fn contact_cycle(bencher: divan::Bencher) {
    let (surfaces, drive) = bouncing();
    let limits = Limits::default();
    bencher.bench(|| contact::run(&surfaces, &drive, 0.5, &limits));
}

#[divan::bench(args = ["rigid", "flexible", "contact", "auto"])]
fn whole_simulation(bencher: divan::Bencher, model: &str) {
    let cam = thesis::double_harmonic();
    let drive = thesis::real(27.0);
    let run = Run {
        profile: cam.profile(1440),
        cam,
        drive,
        target: None,
        machine: Machine {
            train: Train::from_frequency(&drive, 30.0, 0.05).ok(),
            restitution: 0.5,
            ..Machine::default()
        },
    };
    let model = Model::parse(model).expect("a model's name");
    bencher.bench(|| simulate(&run, model));
}
