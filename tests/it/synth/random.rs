//! Random scenes lead to an error message, to a cam that satisfies every limit on a dense scan, or to a conflict whose smallest relaxation is
//! feasible.

use gaitcam::criterion::Criterion;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::scene;
use gaitcam::synth::{Design, Relaxation, synthesise};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::RefCell;
use std::f64::consts::TAU;

/// Tolerance of the scan: the tolerance of a certified law, and rounding of the samples.
const SLACK: f64 = 1.01e-9;
/// Number of points of the scan.
const SCANNED: u32 = 100_000;

#[derive(Debug, Clone)]
struct Wish {
    frequency: f64,
    spans: u32,
    degree: u32,
    stroke: Option<f64>,
    acceleration: Option<f64>,
    jerk: Option<f64>,
    force_min: Option<f64>,
}

fn wish() -> impl Strategy<Value = Wish> {
    let maybe = |low: f64, high: f64| prop::option::of(low..high);
    (
        1.4..2.4_f64,
        6..24_u32,
        3..7_u32,
        maybe(10.0, 80.0),
        maybe(1.0, 12.0),
        maybe(20.0, 400.0),
        maybe(0.0, 600.0),
    )
        .prop_map(
            |(frequency, spans, degree, stroke, acceleration, jerk, force_min)| Wish {
                frequency,
                spans,
                degree,
                stroke,
                acceleration,
                jerk,
                force_min,
            },
        )
}

fn changes(wish: &Wish) -> Vec<String> {
    let mut out = vec![
        format!("gait.step_frequency={} Hz", wish.frequency),
        format!("law.spans={}", wish.spans),
        format!("law.degree={}", wish.degree),
        "law.family=spline".to_string(),
    ];
    let mut push = |key: &str, value: Option<f64>, unit: &str| {
        out.extend(value.map(|v| format!("limits.{key}={v} {unit}")));
    };
    push("stroke", wish.stroke, "mm");
    push("acceleration", wish.acceleration, "m/s^2");
    push("jerk", wish.jerk, "m/s^3");
    push("force_min", wish.force_min, "N");
    out
}

fn design(changes: &[String], target: &ForceCurve) -> Result<Design, String> {
    let scene = gaitcam_test_support::scene(scene::DEFAULT, changes).map_err(|e| e.to_string())?;
    synthesise(&scene, Some(target)).map_err(|e| e.to_string())
}

/// Result of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Met {
    /// An error message instead of a design.
    Words,
    /// A design that passes every check; whether the law is certified.
    Built(bool),
    /// Only the accuracy is not reached, because of the number of spans.
    Inaccurate,
    /// No design; the number of tried relaxations, which are all feasible.
    Refused(usize),
}

/// Extremes of a dense scan: range of the lift, maximum acceleration and jerk, minimum force.
struct Scan {
    stroke: f64,
    acceleration: f64,
    jerk: f64,
    force: f64,
}

fn scan(design: &Design) -> Result<Scan, TestCaseError> {
    let speed = design.problem.drive.speed;
    let (mut low, mut high, mut a, mut j, mut force) =
        (f64::MAX, f64::MIN, 0.0_f64, 0.0_f64, f64::MAX);
    for i in 0..SCANNED {
        let at = design.cam.law.svaj(TAU * f64::from(i) / f64::from(SCANNED));
        prop_assert!(
            [at.s, at.v, at.a, at.j].iter().all(|x| x.is_finite()),
            "{at:?}"
        );
        (low, high) = (low.min(at.s), high.max(at.s));
        a = a.max(at.a.abs() * speed.powi(2));
        j = j.max(at.j.abs() * speed.powi(3));
        force = force.min(design.problem.drive.force(at));
    }
    Ok(Scan {
        stroke: high - low,
        acceleration: a,
        jerk: j,
        force,
    })
}

/// Checks every limit of the case on the scan.
fn limits_hold(wish: &Wish, scan: &Scan) -> Result<(), TestCaseError> {
    let under = |value: f64, limit: Option<f64>| limit.is_none_or(|l| value <= l * (1.0 + SLACK));
    let Scan {
        stroke,
        acceleration,
        jerk,
        force,
    } = *scan;
    prop_assert!(
        under(stroke, wish.stroke.map(|x| 1e-3 * x)),
        "stroke {stroke}"
    );
    prop_assert!(
        under(acceleration, wish.acceleration),
        "acceleration {acceleration}"
    );
    prop_assert!(under(jerk, wish.jerk), "jerk {jerk}");
    prop_assert!(
        wish.force_min.is_none_or(|f| force >= f - SLACK * 700.0),
        "force {force}"
    );
    Ok(())
}

/// Checks that each relaxation is feasible by itself. Returns the number of tried relaxations.
fn relaxations_build(
    relaxations: &[Relaxation],
    asked: &[String],
    target: &ForceCurve,
) -> Result<usize, TestCaseError> {
    let mut tried = 0;
    for relaxation in relaxations {
        let Some(to) = relaxation.to else { continue };
        let unit = match relaxation.limit.name() {
            "stroke" => "m",
            "acceleration" => "m/s^2",
            "jerk" => "m/s^3",
            "force_min" => "N",
            _ => continue,
        };
        // A millionth beyond the edge itself, which is decided by rounding.
        let room = if unit == "N" {
            -1e-6 * 700.0
        } else {
            1e-6 * to
        };
        let change = format!("limits.{}={} {unit}", relaxation.limit.name(), to + room);
        let again = design(&[asked, &[change]].concat(), target).map_err(TestCaseError::fail)?;
        prop_assert!(
            again.infeasible.is_none(),
            "{relaxation:?} does not help: {:?}",
            again.infeasible
        );
        tried += 1;
    }
    Ok(tried)
}

fn holds(wish: &Wish) -> Result<Met, TestCaseError> {
    let target = model("young", Some(wish.frequency), 700.0, Feet::Both)
        .map_err(|e| TestCaseError::fail(e.to_string()))?;
    let asked = changes(wish);
    let answer = match design(&asked, &target) {
        Ok(answer) => answer,
        Err(words) => {
            prop_assert!(words.len() > 10, "{words}");
            return Ok(Met::Words);
        }
    };
    let scan = scan(&answer)?;
    if let Some(conflict) = &answer.infeasible {
        let tried = relaxations_build(&conflict.relaxations, &asked, &target)?;
        return Ok(Met::Refused(tried));
    }
    // The accuracy may be out of reach of the spans given; every other limit is held or in conflict.
    if answer.checks.iter().any(|c| !c.pass) {
        let broken: Vec<_> = (answer.checks.iter())
            .filter(|c| !c.pass && c.name != Criterion::RmsError)
            .collect();
        prop_assert!(broken.is_empty(), "neither held nor refused: {broken:?}");
        return Ok(Met::Inaccurate);
    }
    limits_hold(wish, &scan)?;
    Ok(Met::Built(answer.solver.certified))
}

fn run(cases: u32) {
    let mut runner = TestRunner::new(Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    });
    let met = RefCell::new(Vec::new());
    let seen = runner.run(&wish(), |w| {
        met.borrow_mut().push(holds(&w)?);
        Ok(())
    });
    let met = met.into_inner();
    let count = |wanted: &dyn Fn(&Met) -> bool| met.iter().filter(|m| wanted(m)).count();
    let relaxations = met.iter().map(|m| match m {
        Met::Refused(tried) => *tried,
        _ => 0,
    });
    println!(
        "{} scenes: {} built, {} of them certified; {} miss the accuracy alone; {} refused, with {} relaxations that \
         build; {} words",
        met.len(),
        count(&|m| matches!(m, Met::Built(_))),
        count(&|m| *m == Met::Built(true)),
        count(&|m| *m == Met::Inaccurate),
        count(&|m| matches!(m, Met::Refused(_))),
        relaxations.sum::<usize>(),
        count(&|m| *m == Met::Words),
    );
    seen.unwrap();
}

#[test]
fn a_thousand_random_scenes_are_built_as_promised_or_refused_with_a_way_out() {
    run(1000);
}

/// A former error: two maxima beside a break shared a row and exceeded the limit by 6·10⁻⁹ of the stroke.
#[test]
fn two_crests_beside_a_break_keep_the_stroke() {
    let wish = Wish {
        frequency: 1.610886000734358,
        spans: 6,
        degree: 4,
        stroke: Some(10.529663550278704),
        acceleration: None,
        jerk: None,
        force_min: None,
    };
    holds(&wish).unwrap();
}

/// A former error: a law exceeded the limit by 1.2·10⁻⁸ of its stroke.
#[test]
fn a_stroke_beside_an_acceleration_is_kept_on_few_spans() {
    let wish = Wish {
        frequency: 1.5542227221256322,
        spans: 13,
        degree: 4,
        stroke: Some(11.57893718192274),
        acceleration: Some(1.0977178895776742),
        jerk: None,
        force_min: None,
    };
    holds(&wish).unwrap();
}

#[test]
#[ignore = "an hour"]
fn a_hundred_thousand_random_scenes_are_built_as_promised_or_refused_with_a_way_out() {
    let scenes = std::env::var("SCENES").map_or(100_000, |n| n.parse().unwrap());
    run(scenes);
}

/// Scene files with changed, repeated or missing bytes lead to a scene or an error message, never to a panic.
#[test]
fn mutated_scene_files_are_read_or_refused() {
    let mut runner = TestRunner::new(Config {
        cases: 2000,
        failure_persistence: None,
        ..Config::default()
    });
    let edits = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4_u8), 1..6);
    let result = runner.run(&edits, |edits| {
        let mut bytes = scene::DEFAULT.as_bytes().to_vec();
        for (index, byte, kind) in edits {
            let at = index.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => drop(bytes.remove(at)),
                2 => bytes.insert(at, byte),
                _ => {
                    let piece = bytes[at..(at + 12).min(bytes.len())].to_vec();
                    bytes.splice(at..at, piece);
                }
            }
        }
        if let Some(table) = String::from_utf8(bytes)
            .ok()
            .and_then(|t| t.parse::<toml::Table>().ok())
        {
            match scene::read(&table) {
                Ok(scene) => prop_assert!(scene.rms.is_none_or(f64::is_finite)),
                Err(e) => prop_assert!(e.to_string().len() > 10),
            }
        }
        Ok(())
    });
    result.unwrap();
}
