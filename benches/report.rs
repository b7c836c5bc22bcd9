//! Every number that was asked of gaitcam in seconds, bytes or rows, measured; this writes
//! reports/benchmarks.md. Numbers of accuracy are tests; the table's second half names them.

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use gaitcam::cam::{Cam, Follower, smallest_prime_circle};
use gaitcam::drive::Drive;
use gaitcam::dynamics::contact::{self, Limits};
use gaitcam::dynamics::flexible::{self, Train};
use gaitcam::dynamics::recover;
use gaitcam::dynamics::surface::Surface;
use gaitcam::dynamics::touch;
use gaitcam::error::{Error, Result};
use gaitcam::force::{Feet, ForceCurve, ReadOptions, cycle, model, read, stances};
use gaitcam::halt::Halt;
use gaitcam::law::Svaj;
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene::{self, Scene};
use gaitcam::sweep::{Axis, Method, NamedScene, Plan, Runner, Sampling};
use gaitcam::synth::synthesise;
use gaitcam_evidence::thesis;
use gaitcam_evidence::tiers::{Bound, Task, spectral};
use rayon::prelude::*;

/// One line of the table.
struct Line {
    area: &'static str,
    what: &'static str,
    asked: String,
    /// The median.
    measured: String,
    /// The fastest run, which other programs on the machine disturbed least; empty for ratios.
    fastest: String,
    met: bool,
    /// Whether the fastest run meets the number.
    met_once: bool,
}

/// Median and fastest of several runs, s.
#[derive(Clone, Copy)]
struct Times {
    median: f64,
    fastest: f64,
}

impl Times {
    /// The slower of two.
    fn or(self, other: Times) -> Times {
        if other.median > self.median {
            other
        } else {
            self
        }
    }
}

#[derive(Default)]
struct Report(Vec<Line>);

impl Report {
    /// A time that may be at most `asked` seconds.
    fn time(&mut self, area: &'static str, what: &'static str, asked: f64, found: Times) {
        self.0.push(Line {
            area,
            what,
            asked: format!("≤ {}", duration(asked)),
            measured: duration(found.median),
            fastest: duration(found.fastest),
            met: found.median <= asked,
            met_once: found.fastest <= asked,
        });
    }

    /// A number of things a second that must be at least `asked`.
    fn rate(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: f64,
        things: u64,
        found: Times,
    ) {
        let [median, fastest] = [found.median, found.fastest].map(|s| things as f64 / s);
        self.0.push(Line {
            area,
            what,
            asked: format!("≥ {asked:.0}/s"),
            measured: format!("{median:.0}/s"),
            fastest: format!("{fastest:.0}/s"),
            met: median >= asked,
            met_once: fastest >= asked,
        });
    }

    /// A ratio that must be at least `asked`.
    fn at_least(&mut self, area: &'static str, what: &'static str, asked: f64, found: f64) {
        self.ratio(area, what, format!("≥ {asked}"), found, found >= asked);
    }

    /// A ratio that may be at most `asked`.
    fn at_most(&mut self, area: &'static str, what: &'static str, asked: f64, found: f64) {
        self.ratio(area, what, format!("≤ {asked}"), found, found <= asked);
    }

    /// A number that is stated beside those that were asked for.
    fn stated(&mut self, area: &'static str, what: &'static str, found: String) {
        self.0.push(Line {
            area,
            what,
            asked: String::new(),
            measured: found,
            fastest: String::new(),
            met: true,
            met_once: true,
        });
    }

    fn ratio(
        &mut self,
        area: &'static str,
        what: &'static str,
        asked: String,
        found: f64,
        met: bool,
    ) {
        self.0.push(Line {
            area,
            what,
            asked,
            measured: format!("{found:.2}"),
            fastest: String::new(),
            met,
            met_once: false,
        });
    }
}

fn duration(s: f64) -> String {
    match s {
        s if s < 1e-3 => format!("{:.1} µs", 1e6 * s),
        s if s < 1.0 => format!("{:.2} ms", 1e3 * s),
        s => format!("{s:.2} s"),
    }
}

/// Runs after a warm-up: up to 101 in about half a second, at least five.
fn times<T>(mut run: impl FnMut() -> T) -> Times {
    black_box(run());
    let start = Instant::now();
    let mut all = Vec::new();
    while all.len() < 5 || (all.len() < 101 && start.elapsed().as_secs_f64() < 0.5) {
        let one = Instant::now();
        black_box(run());
        all.push(one.elapsed().as_secs_f64());
    }
    all.sort_by(f64::total_cmp);
    Times {
        median: all[all.len() / 2],
        fastest: all[0],
    }
}

fn main() {
    let mut report = Report::default();
    main_job(&mut report);
    ladder(&mut report);
    followers(&mut report);
    recordings(&mut report);
    dynamics(&mut report);
    sweeps(&mut report);
    charts(&mut report);
    let page = markdown(&report.0);
    print!("{page}");
    let path =
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("reports/benchmarks.md");
    std::fs::write(path, page).expect("reports/ can be written");
}

fn footbridge() -> (ForceCurve, Drive) {
    let target = model("young", Some(1.85), 700.0, Feet::Both).expect("a known model");
    let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
    (target, drive)
}

fn scene_with(changes: &[&str]) -> Scene {
    let mut table = scene::DEFAULT.parse().expect("the built-in scene");
    for change in changes {
        scene::set(&mut table, change).expect("a key of the scene");
    }
    scene::read(&table).expect("a scene")
}

fn turn(motion: &str, lift: f64, extent: Extent, length: f64) -> Law {
    let quarter = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).expect("in the catalogue"),
        lift,
        angle: 0.25 * length,
    };
    let segments = [
        quarter(motion, lift),
        quarter("dwell", 0.0),
        quarter(motion, -lift),
        quarter("dwell", 0.0),
    ];
    program(&segments, extent).expect("a quarter each fills the extent")
}

fn main_job(report: &mut Report) {
    let (target, _) = footbridge();
    let scene = scene_with(&[]);
    let seconds = times(|| synthesise(&scene, Some(&target)).expect("a law"));
    report.time(
        "main job",
        "default scene, synthesis without files",
        2e-3,
        seconds,
    );
    let cam = Cam {
        law: turn("3-4-5", 0.02, Extent::TURN, TAU),
        follower: Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.005,
            roller_radius: 0.01,
        },
    };
    let seconds = times(|| black_box(&cam).profile(3600));
    report.time(
        "main job",
        "roller profile of 3600 points, curvature and pressure angle",
        1e-4,
        seconds,
    );
}

fn ladder(report: &mut Report) {
    let (curve, drive) = footbridge();
    let samples = (0..1000)
        .map(|i| curve.at(TAU * f64::from(i) / 1000.0))
        .collect();
    let thousand = ForceCurve::from_samples("1000", curve.period_s, samples).expect("a curve");
    let seconds = times(|| spectral(black_box(&thousand), drive, 20).expect("no resonance"));
    report.time(
        "synthesis",
        "spectral tier, 1000 samples, 20 harmonics",
        20e-6,
        seconds,
    );
    let task = |spans: usize| Task {
        target: &curve,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    };
    let seconds = times(|| black_box(task(32)).free().expect("a law"));
    report.time(
        "synthesis",
        "equality tier, quintic of 32 spans",
        20e-6,
        seconds,
    );
    let [short, long] = [1000, 10_000].map(|n| times(|| task(n).free().expect("a law")));
    report.at_most(
        "synthesis",
        "equality tier: fastest time of 10 000 spans over 1000 (linear: 10)",
        12.0,
        long.fastest / short.fastest,
    );
    let free = task(32).free().expect("a law").law;
    let held = |percent: f64| {
        let bounds = [2, 3].map(|order| {
            let (low, high) = free.extremes(order);
            let most = 0.01 * percent * high.value.max(-low.value);
            Bound { order, most }
        });
        let task = Task {
            bounds: &bounds,
            ..task(32)
        };
        times(|| black_box(&task).exchange().expect("feasible"))
    };
    report.time(
        "synthesis",
        "certified QP, 32 spans, acceleration and jerk at 95 % of the free law's",
        3e-4,
        held(95.0),
    );
    let [a, b, c, d] = [80.0, 60.0, 45.0, 30.0].map(held);
    report.time(
        "synthesis",
        "certified QP, 32 spans, the slowest of 80, 60, 45, 30 %",
        1e-3,
        a.or(b).or(c).or(d),
    );
    let scene = scene_with(&[
        "limits.jerk=150 m/s^3",
        "limits.acceleration=5 m/s^2",
        "law.spans=32",
    ]);
    let seconds = times(|| synthesise(&scene, Some(&curve)).expect("a law"));
    report.time(
        "synthesis",
        "whole scene of 32 spans with jerk, acceleration and curvature limits",
        1e-3,
        seconds,
    );
    let law = turn("3-4-5", 0.02, Extent::TURN, TAU);
    let seconds = times(|| smallest_prime_circle(black_box(&law), PI / 6.0, PI / 6.0, None));
    report.time(
        "synthesis",
        "closed-form prime circle, exact extrema of the law",
        10e-6,
        seconds,
    );
}

fn followers(report: &mut Report) {
    let straight = 0.2;
    let cams = [
        (
            turn("3-4-5", 0.3, Extent::TURN, TAU),
            Follower::RollerOscillating {
                pivot_distance: 0.08,
                arm: 0.06,
                prime_radius: 0.05,
                roller_radius: 0.01,
            },
        ),
        (
            turn("3-4-5", 0.2, Extent::TURN, TAU),
            Follower::FlatOscillating {
                pivot_distance: 0.1,
                face_offset: 0.01,
                base_radius: 0.04,
            },
        ),
        (
            turn("3-4-5", 0.02, Extent::TURN, TAU),
            Follower::FlatTranslating { base_radius: 0.04 },
        ),
        (
            turn("3-4-5", 0.02, Extent::TURN, TAU),
            Follower::MushroomTranslating {
                prime_radius: 0.14,
                offset: 0.0,
                arc_radius: 0.1,
            },
        ),
        (
            turn("3-4-5", 0.02, Extent::Length(straight), straight),
            Follower::TranslatingCam {
                base_height: 0.02,
                roller_radius: 0.008,
            },
        ),
        (
            turn("3-4-5", 0.04, Extent::TURN, TAU),
            Follower::Barrel {
                radius: 0.03,
                roller_radius: 0.005,
            },
        ),
    ];
    let slowest = cams
        .into_iter()
        .map(|(law, follower)| {
            let cam = Cam { law, follower };
            times(|| black_box(&cam).profile(3600))
        })
        .reduce(Times::or)
        .expect("six followers");
    report.time(
        "cams",
        "profile of 3600 points, the slowest of six other followers",
        150e-6,
        slowest,
    );
}

/// A walk at 1 kHz of so many rows: time, left and right force.
fn walk(rows: usize) -> Vec<u8> {
    let foot = |i: usize, lead: usize| {
        let x = ((i + lead) % 1100) as f64 / 680.0;
        let a = PI * x;
        if x < 1.0 {
            700.0 * (a.sin() + 0.35 * (3.0 * a).sin())
        } else {
            0.0
        }
    };
    let mut text = String::from("time,fz_left,fz_right\n");
    for i in 0..rows {
        let (left, right) = (foot(i, 100), foot(i, 650));
        let _ = writeln!(text, "{}.{:03},{left:.3},{right:.3}", i / 1000, i % 1000);
    }
    text.into_bytes()
}

fn recordings(report: &mut Report) {
    let [minutes, hour] = [360_000, 3_600_000].map(|rows| {
        let bytes = walk(rows);
        times(|| {
            let r = read(Path::new("walk.csv"), &bytes, &ReadOptions::default()).expect("a walk");
            cycle(&r, &stances(&r), Feet::Both).expect("a cycle")
        })
    });
    report.time("force", "one hour at 1 kHz read and averaged", 2.0, hour);
    report.at_most(
        "force",
        "fastest time of one hour over six minutes (linear: 10)",
        12.0,
        hour.fastest / minutes.fastest,
    );
}

fn dynamics(report: &mut Report) {
    let cam = thesis::double_harmonic();
    let emitted = recover(&cam.follower, &cam.profile(1440)).expect("a curve");
    let drive = thesis::real(thesis::SPEED);
    let torques = || -> Vec<f64> {
        let of = |at: &Svaj| touch(&cam.follower, drive.speed, 0.1, *at, drive.force(*at)).torque;
        black_box(&emitted.nodes).iter().map(of).collect()
    };
    let seconds = times(torques);
    report.time("dynamics", "rigid, cycle of 1440 points", 50e-6, seconds);
    let train = Train::from_frequency(&drive, 30.0, 0.05).expect("a fine train");
    let seconds = times(|| flexible::steady(black_box(&emitted.law), &drive, &train));
    report.time(
        "dynamics",
        "flexible, exact, from emitted lift to steady state",
        200e-6,
        seconds,
    );
    let fast = thesis::real(27.0);
    let surfaces = [Surface::new(emitted.law, &fast)];
    let bounce = 0.5;
    let seconds = times(|| contact::run(&surfaces, &fast, bounce, &Limits::default()));
    report.time(
        "dynamics",
        "contact, about thirty impacts (asked for ten)",
        2e-3,
        seconds,
    );
}

fn none(_: usize, _: &Scene) -> Result<ForceCurve> {
    Err(Error::own("no-recordings", "no recordings"))
}

/// The kernel over so many rows.
fn swept(changes: &[&str], vary: &[&str], rows: u64, threads: usize) -> Times {
    let mut table = scene::DEFAULT.parse().expect("the default scene");
    for change in changes {
        scene::set(&mut table, change).expect("a change");
    }
    let plan = Plan {
        scenes: vec![NamedScene {
            name: "footbridge".to_string(),
            table,
        }],
        list: None,
        axes: vary
            .iter()
            .map(|v| Axis::parse(v, true).expect("an axis"))
            .collect(),
        sampling: Sampling::Sample {
            method: Method::Latin,
            count: rows,
            seed: 1,
        },
    };
    let runner = Runner::of_plan(&plan, &none, &Halt::never, None);
    times(|| runner.run(0..rows, threads, &|| false).len())
}

fn sweeps(report: &mut Report) {
    let both = [
        "gait.step_frequency=1.5 Hz:2.4 Hz",
        "gait.body_weight=400 N:1000 N",
    ];
    // Short runs: one in many is not interrupted by other programs.
    let rows = 3200;
    let spectral = |threads| swept(&["law.family=harmonic"], &both, rows, threads);
    let (one, two) = (spectral(1), spectral(2));
    report.rate(
        "sweep",
        "spectral designs, each with a speed of its own, one thread",
        100_000.0,
        rows,
        one,
    );
    report.rate(
        "sweep",
        "spectral designs, each with a speed of its own, two threads",
        100_000.0,
        rows,
        two,
    );
    report.at_least(
        "sweep",
        "two threads over one, fastest runs",
        1.8,
        one.fastest / two.fastest,
    );
    let changes = ["law.spans=32", "accuracy.rms=20 %"];
    let rows = 64;
    let qp = swept(&changes, &["limits.stroke=40 mm:48 mm"], rows, 2);
    report.rate(
        "sweep",
        "certified QP scenes of 32 spans, the stroke binding, two threads",
        4000.0,
        rows,
        qp,
    );
}

/// What `gaitcam chart` and benches/peers/run.py last wrote.
fn charts(report: &mut Report) {
    let reports = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("reports");
    let page = std::fs::read_to_string(reports.join("speed_accuracy.md")).unwrap_or_default();
    let on = page.matches("The default lies on the front.").count();
    let off = page
        .matches("The default does not lie on the front.")
        .count();
    report.0.push(Line {
        area: "evidence",
        what: "charts whose default lies on the Pareto front (last `gaitcam chart`)",
        asked: format!("{} of {}", on + off, on + off),
        measured: format!("{on} of {}", on + off),
        fastest: String::new(),
        met: off == 0 && on > 0,
        met_once: false,
    });
    let peers = page.split("\n## Peers\n").nth(1).unwrap_or_default();
    for line in peers.lines().filter(|l| l.starts_with("| ")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        against(report, &cells);
        process(report, &cells);
    }
}

/// A row of the table of peers: the kernel with what the peer is given, and what a user gets.
fn against(report: &mut Report, cells: &[&str]) {
    let (kernel, more) = match cells.get(2) {
        Some(peer) if peer.starts_with("cvxpy") => (
            "cvxpy's time over the kernel's, jerk limit on 32 given spans",
            "cvxpy's time over that of the public call: cam, checks and proof included",
        ),
        Some(peer) if peer.starts_with("scipy") => (
            "scipy's time over the kernel's, least squares on 32 given spans",
            "scipy's time over that of the public call: spans sought, cam, checks and proof included",
        ),
        Some(peer) if peer.starts_with("DAQP 0") => (
            "DAQP's time over the kernel's, acceleration and jerk at 95 %, matrices at hand (DAQP: 224 rows of two sides)",
            "DAQP's time over the kernel's with its matrices assembled from the force",
        ),
        Some(peer) if peer.starts_with("mechanism") => (
            "time of `mechanism` over the kernel's, double-dwell roller cam of 3600 points",
            "",
        ),
        _ => return,
    };
    let number = |k: usize| cells.get(k).and_then(|c| c.parse::<f64>().ok());
    if let (Some(ratio), Some(asked)) = (number(7), number(10)) {
        report.at_least("peers", kernel, asked, ratio);
    }
    if let Some(ratio) = number(9) {
        report.stated("peers", more, format!("{ratio:.1}"));
    }
}

/// A row of the table of whole processes.
fn process(report: &mut Report, cells: &[&str]) {
    let asked = match cells.get(1) {
        Some(&"gaitcam synth, all files") => ("whole process, all files", 0.030),
        Some(&"gaitcam synth --no-png") => ("whole process, --no-png", 0.015),
        Some(&"gaitcam synth --json, no files") => ("whole process, --json without files", 0.004),
        _ => return,
    };
    let time = cells.get(2).and_then(|c| c.strip_suffix(" ms"));
    if let Some(milliseconds) = time.and_then(|t| t.parse::<f64>().ok()) {
        let median = 1e-3 * milliseconds;
        let found = Times {
            median,
            fastest: median,
        };
        report.time("main job", asked.0, asked.1, found);
    }
}

/// Numbers of accuracy and where they are held.
const TESTED: [(&str, &str, &str); 21] = [
    (
        "main job",
        "C3…C8 of the heel tester to 0.001, theory §2 to 4 digits",
        "main_job",
    ),
    (
        "main job",
        "peaks of the fitted heel tester to 0.01 lb, none above 110.29 lb",
        "main_job",
    ),
    (
        "main job",
        "footbridge ≤ 0.5 % RMS with ≤ 24 spans, stroke 49.2 ± 0.2 mm",
        "main_job",
    ),
    (
        "main job",
        "envelope to 1e-9 m, gap below 1e-7 m at 1440 points",
        "put_back",
    ),
    (
        "synthesis",
        "optima of theory §8 to 1e-6",
        "unit tests of synth",
    ),
    (
        "synthesis",
        "prime circles of theory §6 to 1e-6",
        "cam_geometry",
    ),
    (
        "synthesis",
        "co-designed heel tester: prime radius ≤ 2.05 in",
        "main_job",
    ),
    (
        "synthesis",
        "no limit exceeded by more than 1e-9 on 100 000 points",
        "random_scenes",
    ),
    ("cams", "factors of theory §7 to 1e-5", "laws"),
    ("cams", "theory §2–§5 recomputed", "reproduce"),
    ("cams", "conjugates to 1e-12, breadth to 1e-9 m", "cams"),
    (
        "force",
        "stances, mass and peaks of every file",
        "gait_files, gait_c3d",
    ),
    ("force", "float and integer copies within 0.1 N", "gait_c3d"),
    (
        "dynamics",
        "rigid and contact agree to 1e-6 N below lift-off",
        "unit tests of dynamics",
    ),
    (
        "dynamics",
        "lift-off speeds to 1e-6, residual vibrations to 1e-6",
        "unit tests of dynamics",
    ),
    (
        "dynamics",
        "a lossless bounce keeps its energy to 1e-9 over 1000 impacts",
        "unit tests of dynamics",
    ),
    (
        "sweep",
        "killed and resumed sweeps end in the same table",
        "sweep",
    ),
    (
        "sweep",
        "10 million rows in Parquet ≤ 3 minutes, resumed in ≤ 5 s",
        "by hand: 20 s, 0.06 s",
    ),
    (
        "evidence",
        "the richer choice moves the force by less than stated",
        "explain",
    ),
    (
        "evidence",
        "integrators break where theory §10 says, to 1 %",
        "stability",
    ),
    ("evidence", "profile.dxf within 0.1 µm", "emit"),
];

fn markdown(lines: &[Line]) -> String {
    let mut out = String::from(
        "# Benchmarks\n\nWritten by `cargo run --release -p gaitcam-evidence --features benchmarks --example benchmarks` (benches/report.rs): medians after a warm-up, release build, \
         on the wall; the fastest run beside them, because other programs ran on the machine too. Peers and whole processes \
         are time of the processor, of the last run of benches/peers/run.py.\n\n\
         | area | what | asked | median | fastest | |\n|---|---|---|---|---|---|\n",
    );
    for l in lines {
        let mark = match (l.met, l.met_once) {
            _ if l.asked.is_empty() => "",
            (true, _) => "met",
            (false, true) => "met when undisturbed",
            (false, false) => "**missed**",
        };
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {mark} |",
            l.area, l.what, l.asked, l.measured, l.fastest
        );
    }
    out.push_str(
        "\nNumbers of accuracy hold or a test fails:\n\n| area | number | held by |\n|---|---|---|\n",
    );
    for (area, number, by) in TESTED {
        let _ = writeln!(out, "| {area} | {number} | {by} |");
    }
    out
}
