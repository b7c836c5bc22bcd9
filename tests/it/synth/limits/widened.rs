//! Relaxed and tightened limits. A relaxed limit never worsens the objective by more than the gap of the certificate and never makes a cam
//! unacceptable. The accuracy is such a limit too (docs/verdict.md).

use gaitcam::cam::Verdict;
use gaitcam::force::{Feet, ForceCurve, force_curve, model};
use gaitcam::scene::keys::{self, Relax};
use gaitcam::scene::{self, Minimise, Scene, Source};
use gaitcam::synth::{Design, synthesise};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Factor for the number of cases, from GAITCAM_GUARD.
fn times() -> u32 {
    let asked = std::env::var("GAITCAM_GUARD").ok();
    asked.and_then(|n| n.parse().ok()).unwrap_or(0)
}

fn passes(design: &Design) -> bool {
    design.verdict != Verdict::Unacceptable
}

/// Objective of the design, in the unit of its certificate, and the gap of the certificate.
fn objective(design: &Design, minimise: Minimise) -> (f64, f64) {
    let value = match minimise {
        Minimise::Energy(order) => {
            let samples = 40_000;
            let square = |i: usize| {
                let at = design
                    .cam
                    .law
                    .svaj((i as f64 + 0.5) / samples as f64 * std::f64::consts::TAU);
                [at.s, at.v, at.a, at.j][order].powi(2)
            };
            0.5 * (0..samples).map(square).sum::<f64>() / samples as f64
        }
        Minimise::Peak(order) => {
            let (low, high) = design.cam.law.extremes(order);
            high.value.max(-low.value)
        }
        _ => design.cam.follower.prime_radius(),
    };
    // A local optimum is as far from the best one as its lower bound leaves open; a touching angle that was searched for has
    // to be found as well.
    let gap = design.solver.certificate.map_or(f64::INFINITY, |c| {
        c.global_gap.unwrap_or(c.relative_gap) * c.size
    });
    (value, gap)
}

const HEEL: [f64; 9] = [11.0, 12.0, 15.0, 18.0, 20.0, 22.0, 25.0, 28.0, 30.0];

/// Built-in scene and its force; `None` if the user provides the recording.
fn built_in(name: &str) -> Option<(Scene, Option<ForceCurve>)> {
    let scene = scene::built_in(name).unwrap().scene().ok()?;
    let force = scene.gait.as_ref().and_then(|gait| match &gait.source {
        Source::Model(_) | Source::Harmonics(_) => gait.model_force().ok().flatten(),
        Source::File(path) => {
            let bytes = scene::built_in_file(path)?;
            let options = gait.read_options(None).ok()?;
            Some(force_curve(path, bytes, &options, gait.feet).unwrap())
        }
    });
    Some((scene, force))
}

/// The cam for a narrow pressure angle satisfies every wider limit, and the size only decreases.
#[test]
fn a_wider_pressure_angle_keeps_the_heel_tester_acceptable() {
    let every = if times() > 0 { 1 } else { 3 };
    let (scene, force) = built_in("heel_tester_fitted").unwrap();
    let mut before = f64::INFINITY;
    for angle in HEEL.iter().step_by(every) {
        let with = scene
            .with("limits.pressure_angle", &format!("{angle} deg"))
            .unwrap();
        let design = synthesise(&with, force.as_ref()).unwrap();
        assert_eq!(
            design.verdict,
            Verdict::Acceptable,
            "{angle}: {:?}",
            design.reasons
        );
        let radius = design.cam.follower.prime_radius();
        assert!(radius < before, "{angle}: {radius} {before}");
        before = radius;
    }
}

#[derive(Debug, Clone)]
struct Wish {
    minimise: usize,
    frequency: f64,
    spans: u32,
    accuracy: f64,
    /// Limits as indices in `LIMITS`, with the position in their range.
    limits: Vec<(usize, f64)>,
    /// Index of the limit that is relaxed. The accuracy is the last one.
    widened: usize,
    by: f64,
}

/// All limits for the default scene: key, range of values, unit, and whether a larger value allows more.
const LIMITS: [(&str, [f64; 2], &str, bool); 12] = [
    ("stroke", [30.0, 80.0], "mm", true),
    ("velocity", [0.1, 0.6], "m/s", true),
    ("acceleration", [2.0, 8.0], "m/s^2", true),
    ("jerk", [30.0, 200.0], "m/s^3", true),
    ("force_min", [200.0, 600.0], "N", false),
    ("force_max", [800.0, 1300.0], "N", true),
    ("curvature", [1.0, 20.0], "mm", false),
    ("prime_radius", [20.0, 200.0], "mm", true),
    ("torque", [5.0, 60.0], "N m", true),
    ("power", [50.0, 600.0], "W", true),
    ("torque_rate", [20.0, 300.0], "N m/rad", true),
    ("hertz_pressure", [20.0, 200.0], "MPa", true),
];

const OBJECTIVES: [(&str, Minimise); 5] = [
    ("acceleration", Minimise::Energy(2)),
    ("jerk", Minimise::Energy(3)),
    ("peak-acceleration", Minimise::Peak(2)),
    ("peak-jerk", Minimise::Peak(3)),
    ("size", Minimise::Size),
];

fn wish() -> impl Strategy<Value = Wish> {
    (
        0..OBJECTIVES.len(),
        1.5..2.2_f64,
        10..20_u32,
        0.01..0.12_f64,
        prop::collection::vec((0..LIMITS.len(), 0.0..1.0_f64), 1..4),
        0..12_usize,
        1.01..2.0_f64,
    )
        .prop_map(
            |(minimise, frequency, spans, accuracy, limits, widened, by)| Wish {
                minimise,
                frequency,
                spans,
                accuracy,
                widened: widened % (limits.len() + 1),
                limits,
                by,
            },
        )
}

/// Design of a case in which one limit is multiplied by `by`.
fn with(wish: &Wish, by: f64) -> Design {
    let by = |i: usize| if i == wish.widened { by } else { 1.0 };
    let mut changes = vec![
        format!("gait.step_frequency={} Hz", wish.frequency),
        format!("law.spans={}", wish.spans),
        "law.family=spline".to_string(),
        format!("law.minimise={}", OBJECTIVES[wish.minimise].0),
        format!(
            "accuracy.rms={} %",
            100.0 * by(wish.limits.len()) * wish.accuracy
        ),
    ];
    if OBJECTIVES[wish.minimise].1 == Minimise::Size {
        let size = [
            "cam.follower=flat-translating",
            "cam.base_radius=auto",
            "limits.curvature=5 mm",
        ];
        changes.extend(size.map(String::from));
    }
    for (i, (limit, share)) in wish.limits.iter().enumerate() {
        let (key, [low, high], unit, up) = LIMITS[*limit];
        let value = low + share * (high - low);
        let value = if up { value * by(i) } else { value / by(i) };
        changes.push(format!("limits.{key}={value} {unit}"));
    }
    let scene = gaitcam_test_support::scene(scene::DEFAULT, &changes).unwrap();
    let force = model("young", Some(wish.frequency), 700.0, Feet::Both).unwrap();
    synthesise(&scene, Some(&force)).unwrap()
}

#[test]
fn a_wider_limit_never_worsens_a_design() {
    let cases = 60 + 600 * times();
    let mut runner = TestRunner::new(Config {
        failure_persistence: None,
        cases,
        ..Config::default()
    });
    let (mut passed, mut bound, mut proved, mut kinds) = (0, 0, 0, [0; LIMITS.len() + 1]);
    let counted = std::cell::RefCell::new((&mut passed, &mut bound, &mut proved, &mut kinds));
    let held = |wish: Wish| {
        let (narrow, wide) = (with(&wish, 1.0), with(&wish, wish.by));
        let minimise = OBJECTIVES[wish.minimise].1;
        if !passes(&narrow) {
            return Ok(());
        }
        prop_assert!(passes(&wide), "{:?}", wide.reasons);
        let ((before, _), (after, gap)) =
            (objective(&narrow, minimise), objective(&wide, minimise));
        prop_assert!(
            after <= before * (1.0 + 1e-8) + gap,
            "{after} {before} {gap}: {:?}",
            wide.solver
        );
        let mut counted = counted.borrow_mut();
        *counted.0 += 1;
        let widened = wish.limits.get(wish.widened);
        counted.3[widened.map_or(LIMITS.len(), |l| l.0)] += 1;
        *counted.1 += usize::from(
            narrow
                .binding
                .iter()
                .any(|b| b.limit.name() == "accuracy.rms"),
        );
        // Where a constant law is nearly sufficient, the objective is nearly 0.
        let proved = |d: &Design| d.solver.certificate.is_some_and(|c| c.proves_optimum());
        *counted.2 += usize::from(proved(&narrow) && proved(&wide));
        Ok(())
    };
    runner.run(&wish(), held).unwrap();
    println!(
        "{passed} of {cases} pass, {bound} with the accuracy active, {proved} proved; widened by kind {kinds:?}"
    );
    assert!(passed >= 20 && bound >= 10);
    assert!(times() == 0 || kinds.iter().all(|n| *n > 0), "{kinds:?}");
}

/// For a force that is symmetric in time, the angle of symmetry is a local maximum of the objective over the touching angle. No law that touches
/// there is best for a large accuracy limit. With the short stroke, programs whose weights of the accuracy differ by a millionth begin with equal
/// contacts up to rounding.
#[test]
fn a_wider_accuracy_never_takes_a_larger_cam() {
    let symmetric = Wish {
        minimise: 4,
        frequency: 1.674_598_489_889_618_6,
        spans: 10,
        accuracy: 0.093,
        limits: vec![(11, 0.86)],
        widened: 1,
        by: 1.0,
    };
    let short = Wish {
        frequency: 1.971_636_159_894_994,
        spans: 17,
        accuracy: 0.116_117_032_459_230_33,
        limits: vec![(0, 0.0), (11, 0.408_714_658_529_500_1)],
        widened: 2,
        ..symmetric.clone()
    };
    let tenths: Vec<f64> = (0..10).map(|i| 1.0 + 0.1 * f64::from(i)).collect();
    let found = vec![1.0, 1.6, 1.646_823_327_043_303_3, 1.7];
    for (wish, factors, least) in [(symmetric, tenths, 0.0778), (short, found, 0.3084)] {
        let radius = |by: &f64| with(&wish, *by).cam.follower.prime_radius();
        let radii: Vec<f64> = factors.iter().map(radius).collect();
        let falls = |pair: &[f64]| pair[1] < pair[0] * (1.0 + 1e-6);
        assert!(radii.windows(2).all(falls), "{radii:?}");
        assert!(radii.last().is_some_and(|r| *r < least), "{radii:?}");
    }
}

/// Every numeric limit of every built-in scene is relaxed and tightened by 5 %.
#[test]
fn a_wider_limit_never_fails_a_built_in_scene() {
    let mut tried = 0;
    for one in scene::SCENES {
        let Some((scene, force)) = built_in(one.name) else {
            continue;
        };
        let limits = keys::relaxable().filter(|k| k.section() != "cam");
        let given: Vec<_> = limits
            .filter_map(|k| Some((k, k.number(&scene)?)))
            .collect();
        let own = passes(&synthesise(&scene, force.as_ref()).unwrap());
        for (key, value) in given {
            let up = if key.relax == Some(Relax::Up) {
                1.0
            } else {
                -1.0
            };
            for weaker in [1.0, -1.0] {
                let mut changed = scene.clone();
                let by = 0.05 * value.abs() * up * weaker;
                // One key for two limits is read with the scene, and stands in a test of its own.
                if !key.set_number(&mut changed, 0, value + by) {
                    continue;
                }
                let other = passes(&synthesise(&changed, force.as_ref()).unwrap());
                let monotone = if weaker > 0.0 {
                    other >= own
                } else {
                    other <= own
                };
                assert!(
                    monotone,
                    "{} {} {value} {by}: {own} {other}",
                    one.name, key.path
                );
                tried += 1;
            }
        }
    }
    assert!(tried >= 20, "{tried}");
}
