//! Runs one kernel at a time. `lab/instructions/run.py` counts its instructions with callgrind.
//!
//! Without an argument, the names of the kernels are printed. A kernel runs twice, because tables that all designs share are computed in the first
//! run. Only the second run is counted, in [`counted`].

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;

use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::Drive;
use gaitcam::dynamics::Surface;
use gaitcam::dynamics::contact::{self, Limits};
use gaitcam::dynamics::flexible::{self, Train};
use gaitcam::dynamics::recover;
use gaitcam::force::{Feet, ForceCurve, ReadOptions, cycle, model, read, stances};
use gaitcam::halt::Halt;
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene::{self, Scene};
use gaitcam::sweep::{Files, Plan, Sampling, Subject, Sweep};
use gaitcam::synth::{Design, synthesise};
use gaitcam_lab::tiers::{Bound, Task};
use gaitcam_output::{Language, Timing, csv, plots, report};
use gaitcam_test_support::thesis;

/// Names of the kernels, each with a function that prepares its work.
type Kernels = [(&'static str, fn() -> Box<dyn FnMut()>); 10];

const KERNELS: Kernels = [
    ("default design", || {
        let (scene, force) = (default_scene(&[]), footbridge());
        Box::new(move || drop(black_box(synthesise(&scene, Some(&force)))))
    }),
    ("least squares on 32 spans", || {
        let (force, drive) = (footbridge(), walker());
        Box::new(move || drop(black_box(task(&force, drive, &[]).free())))
    }),
    ("certified program, acceleration and jerk at 95 %", || {
        let (force, drive) = (footbridge(), walker());
        let bounds = bounds(&force, drive);
        Box::new(move || drop(black_box(task(&force, drive, &bounds).exchange())))
    }),
    ("sweep of ten strokes", || {
        sweep(&[], "limits.stroke=35 mm:60 mm:10")
    }),
    ("sweep of a thousand harmonic designs", || {
        let weights = "gait.body_weight=400 N:1000 N:1000";
        sweep(&["law.family=harmonic"], weights)
    }),
    ("roller profile of 3600 points", || {
        let cam = Cam {
            law: double_dwell(),
            follower: Follower::RollerTranslating {
                prime_radius: 0.05,
                offset: 0.005,
                roller_radius: 0.01,
            },
        };
        Box::new(move || drop(black_box(cam.profile(3600))))
    }),
    ("a minute of walking read", || {
        let text = walk(60_000);
        Box::new(move || {
            let recording = read(Path::new("walk.csv"), &text, &ReadOptions::default());
            let recording = recording.expect("a walk");
            drop(black_box(cycle(
                &recording,
                &stances(&recording),
                Feet::Both,
            )));
        })
    }),
    ("flexible follower and impacts", || {
        let cam = thesis::double_harmonic();
        let law = recover(&cam.follower, &cam.profile(1440))
            .expect("a curve")
            .law;
        let drive = thesis::real(thesis::SPEED);
        let train = Train::from_frequency(&drive, 30.0, 0.05).expect("a fine train");
        let fast = thesis::real(27.0);
        Box::new(move || {
            drop(black_box(flexible::steady(&law, &drive, &train)));
            let surfaces = [Surface::new(law.clone(), &fast)];
            drop(black_box(contact::run(
                &surfaces,
                &fast,
                0.5,
                &Limits::default(),
            )));
        })
    }),
    ("report and tables", || {
        let design = default_design();
        Box::new(move || {
            let page = report::html(&design, Timing::default(), Language::En);
            drop(black_box((
                page,
                csv::law(&design, 1440),
                csv::profile(&design, 1440),
            )));
        })
    }),
    ("picture of the force as PNG", || {
        let design = default_design();
        Box::new(move || drop(black_box(plots::force(&design, Language::En).png())))
    }),
];

/// Function whose instructions callgrind counts.
#[inline(never)]
fn counted(work: &mut dyn FnMut()) {
    work();
}

fn main() {
    let Some(name) = std::env::args().nth(1) else {
        for (name, _) in KERNELS {
            println!("{name}");
        }
        return;
    };
    let kernel = KERNELS
        .iter()
        .find(|k| k.0 == name)
        .expect("a kernel's name");
    let mut work = kernel.1();
    work();
    counted(&mut *work);
}

fn default_scene(changes: &[&str]) -> Scene {
    scene::read(&table(changes)).expect("a scene")
}

fn table(changes: &[&str]) -> toml::Table {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a key of the scene");
    }
    table
}

fn footbridge() -> ForceCurve {
    model("young", Some(1.85), 700.0, Feet::Both).expect("a known model")
}

fn walker() -> Drive {
    Drive::moving_axis(700.0 / 9.81, 9.81, TAU * 1.85)
}

fn default_design() -> Design {
    synthesise(&default_scene(&[]), Some(&footbridge())).expect("a design")
}

fn task<'a>(target: &'a ForceCurve, drive: Drive, bounds: &'a [Bound]) -> Task<'a> {
    Task {
        target,
        drive,
        degree: 5,
        spans: 32,
        bounds,
    }
}

/// Limits on acceleration and jerk at 95 % of the peaks of the law without limits.
fn bounds(force: &ForceCurve, drive: Drive) -> [Bound; 2] {
    let free = task(force, drive, &[]).free().expect("a law");
    [2, 3].map(|order| {
        let (low, high) = free.extremes(order);
        let most = 0.95 * high.value.max(-low.value);
        Bound { order, most }
    })
}

fn double_dwell() -> Law {
    let quarter = |motion, lift| Segment {
        motion,
        lift,
        angle: 0.25 * TAU,
    };
    let segments = [
        quarter(Rise::Poly345, 0.02),
        quarter(Rise::Dwell, 0.0),
        quarter(Rise::Poly345, -0.02),
        quarter(Rise::Dwell, 0.0),
    ];
    program(&segments, Extent::TURN).expect("a full turn")
}

/// Recording of walking with `rows` rows at 1 kHz: time, left and right force.
fn walk(rows: usize) -> Vec<u8> {
    let foot = |i: usize, lead: usize| {
        let x = ((i + lead) % 1100) as f64 / 680.0;
        let a = std::f64::consts::PI * x;
        let stance = 700.0 * (a.sin() + 0.35 * (3.0 * a).sin());
        if x < 1.0 { stance } else { 0.0 }
    };
    let mut text = String::from("time,fz_left,fz_right\n");
    for i in 0..rows {
        let (left, right) = (foot(i, 100), foot(i, 650));
        let _ = writeln!(text, "{}.{:03},{left:.3},{right:.3}", i / 1000, i % 1000);
    }
    text.into_bytes()
}

/// Work on the rows of a sweep, each time with empty caches.
fn sweep(changes: &[&str], vary: &str) -> Box<dyn FnMut()> {
    let plan = Plan::of(table(changes), &[vary], Sampling::Grid).expect("an axis");
    let sweep = Sweep::with_files(Subject::Designs(plan), Files::new()).expect("a plan");
    let rows = sweep.rows().expect("a number of rows");
    Box::new(move || {
        let runner = sweep.runner(&Halt::never, None).expect("a plan");
        drop(black_box(runner.run(0..rows, 1, &|| false)));
    })
}
