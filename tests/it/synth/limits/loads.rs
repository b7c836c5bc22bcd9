//! Limits on the loads of shaft and contact: torque, its rate, pressure. They are tested as rows, and where no law is feasible.

use gaitcam::cam::Check;
use gaitcam::dynamics::{hertz, touch};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, Tier, synthesise};
use std::f64::consts::TAU;

fn scene_and_force(text: &str, changes: &[&str]) -> (Scene, Option<ForceCurve>) {
    let scene = gaitcam_test_support::scene(text, changes).unwrap();
    let force = scene.model_force().unwrap();
    (scene, force)
}

fn design(text: &str, changes: &[&str]) -> Design {
    let (scene, force) = scene_and_force(text, changes);
    synthesise(&scene, force.as_ref()).unwrap()
}

/// Design with the changes by which it passes.
fn relaxed_design(text: &str, changes: &[&str]) -> Design {
    let (scene, force) = scene_and_force(text, changes);
    let design = synthesise(&scene, force.as_ref()).unwrap();
    design.relaxed()
}

fn check<'a>(s: &'a Design, name: &str) -> &'a Check {
    s.checks.iter().find(|c| c.name.name() == name).unwrap()
}

const ANGLES: usize = 20_011;

fn angles() -> impl Iterator<Item = f64> {
    (0..ANGLES).map(|i| TAU * i as f64 / ANGLES as f64)
}

/// Largest |T|, and largest |dT/dθ| by central differences.
fn torques(s: &Design) -> [f64; 2] {
    let torque = |x: f64| {
        let at = s.cam.law.svaj(x);
        s.problem.drive.force(at) * at.v
    };
    let d = 1e-5;
    angles().fold([0.0_f64; 2], |[t, r], x| {
        let rate = (torque(x + d) - torque(x - d)) / (2.0 * d);
        [t.max(torque(x).abs()), r.max(rate.abs())]
    })
}

fn pressure(s: &Design) -> f64 {
    let steel = hertz::modulus(hertz::STEEL, hertz::STEEL);
    angles()
        .map(|x| {
            let at = s.cam.law.svaj(x);
            let here = touch(
                &s.cam.follower,
                s.problem.drive.speed,
                0.0,
                at,
                s.problem.drive.force(at),
            );
            hertz::line(here.normal, s.problem.cam.thickness, here.curvature, steel).pressure
        })
        .fold(0.0, f64::max)
}

const OPEN: [&str; 2] = ["accuracy.rms=50 %", "law.spans=12"];

#[test]
fn the_rate_of_the_torque_is_held_and_costs_accuracy() {
    let free = design(scene::DEFAULT, &OPEN);
    let most = torques(&free);
    let mut last = free.force.rms_error_n;
    for share in [0.97, 0.85, 0.7] {
        let limit = format!("limits.torque_rate={} N m/rad", share * most[1]);
        let s = design(scene::DEFAULT, &[&OPEN[..], &[limit.as_str()]].concat());
        let rate = check(&s, "torque_rate");
        assert!(rate.pass && s.infeasible.is_none(), "{share}: {rate:?}");
        let held = torques(&s)[1];
        assert!(
            held <= rate.limit * (1.0 + 1e-6),
            "{share}: {held} {rate:?}"
        );
        assert!(held > rate.limit * (1.0 - 1e-3), "{share}: {held} {rate:?}");
        assert!(s.force.rms_error_n > last);
        assert!(s.binding.iter().any(|b| b.limit.name() == "torque_rate"));
        assert_eq!(s.solver.tier, Tier::Scp);
        last = s.force.rms_error_n;
    }
}

/// The sequence ends at a local optimum: along feasible directions to other laws that satisfy the torque limit, the force error grows.
#[test]
fn a_law_at_its_torque_limit_is_a_local_optimum() {
    let free = design(scene::DEFAULT, &OPEN);
    let most = torques(&free)[0];
    let at = |share: f64| {
        let limit = format!("limits.torque={} N m", share * most);
        design(scene::DEFAULT, &[&OPEN[..], &[limit.as_str()]].concat())
    };
    let s = at(0.8);
    let certificate = s.solver.certificate.unwrap();
    assert!(certificate.relative_gap < 1e-5, "{certificate:?}");
    assert!(certificate.stationarity < 1e-5, "{certificate:?}");
    // Its multipliers foretell what a little more torque buys.
    let gain: f64 = s
        .binding
        .iter()
        .filter(|b| b.limit.name() == "torque")
        .map(|b| b.multiplier)
        .sum();
    let more = at(0.801);
    let half_square = |s: &Design| 0.5 * s.force.rms_error_n.powi(2);
    let found = (half_square(&s) - half_square(&more)) / (0.001 * most);
    assert!((found / gain - 1.0).abs() < 0.02, "{found} {gain}");
}

const LIFT: &str = r#"
name = "press"
[drive]
kind = "fixed-axis"
mass = "2 kg"
spring_rate = "4 kN/m"
preload = "300 N"
speed = "120 rpm"
[law]
family = "spline"
spans = 30
[[law.dwell]]
from = "0 deg"
to = "90 deg"
lift = "0"
[[law.dwell]]
from = "170 deg"
to = "240 deg"
lift = "12 mm"
[cam]
follower = "flat-translating"
base_radius = "80 mm"
"#;

#[test]
fn limits_that_leave_no_law_say_so_with_the_smallest_relaxation() {
    let free = design(LIFT, &[]);
    let most = torques(&free)[0];
    for (name, unit) in [("torque", "N m"), ("torque_rate", "N m/rad")] {
        let asked = 0.2 * most;
        let change = format!("limits.{name}={asked} {unit}");
        let s = relaxed_design(LIFT, &[&change]);
        let why = s
            .infeasible
            .as_ref()
            .unwrap_or_else(|| panic!("{name}: {:?}", s.checks));
        assert_eq!(why.names(), [name]);
        let to = why.relaxations[0].to.unwrap();
        assert!(
            to > asked,
            "{}",
            why.sentence(gaitcam::wording::Language::En)
        );
        // What it says works, and a little less does not.
        let eased = design(LIFT, &[&format!("limits.{name}={to} {unit}")]);
        assert!(
            eased.infeasible.is_none() && check(&eased, name).pass,
            "{name}"
        );
        let less = design(LIFT, &[&format!("limits.{name}={} {unit}", 0.99 * to)]);
        assert_eq!(less.verdict.name(), "unacceptable", "{name}");
    }
    // Lifting 12 mm against the spring is work: no torque below its mean over the rise can do it.
    let work = 300.0 * 0.012 + 0.5 * 4000.0 * 0.012 * 0.012;
    let s = relaxed_design(LIFT, &[&format!("limits.torque={} N m", 0.2 * most)]);
    let to = s.infeasible.unwrap().relaxations[0].to.unwrap();
    let mean = work / 80f64.to_radians();
    assert!(to > mean && to < 1.6 * mean, "{to} {mean}");
}

#[test]
fn a_band_that_fights_the_torque_is_named_beside_it() {
    // A band keeps the force, so the law cannot rest; the torque it needs is more than allowed.
    let changes = ["gait.band=15 N", "law.spans=12"];
    let free = design(scene::DEFAULT, &changes);
    let most = torques(&free)[0];
    let limit = format!("limits.torque={} N m", 0.5 * most);
    let s = relaxed_design(scene::DEFAULT, &[changes[0], changes[1], &limit]);
    let why = s.infeasible.unwrap();
    assert_eq!(
        why.names(),
        ["band", "torque"],
        "{}",
        why.sentence(gaitcam::wording::Language::En)
    );
    let to = |name: &str| {
        let one = why
            .relaxations
            .iter()
            .find(|r| r.limit.name() == name)
            .unwrap();
        one.to.unwrap()
    };
    let torque = format!("limits.torque={} N m", to("torque"));
    let eased = design(scene::DEFAULT, &[changes[0], changes[1], &torque]);
    assert!(eased.infeasible.is_none() && eased.checks.iter().all(|c| c.pass));
}

const ROLLER: [&str; 4] = [
    "cam.follower=roller-translating",
    "cam.roller_radius=12 mm",
    "accuracy.rms=50 %",
    "law.spans=12",
];

#[test]
fn pressure_under_a_roller_is_held_by_the_sequence() {
    let mut base = ROLLER.to_vec();
    base.extend(["cam.prime_radius=70 mm", "cam.offset=5 mm"]);
    let free = design(scene::DEFAULT, &base);
    let most = pressure(&free);
    let mut last = free.force.rms_error_n;
    for share in [0.98, 0.94] {
        let limit = format!("limits.hertz_pressure={} Pa", share * most);
        let s = design(scene::DEFAULT, &[&base[..], &[limit.as_str()]].concat());
        let held = check(&s, "hertz_pressure");
        assert!(s.infeasible.is_none() && held.pass, "{share}: {held:?}");
        let worst = pressure(&s);
        assert!(
            worst <= held.limit * (1.0 + 1e-6) && worst > 0.999 * held.limit,
            "{worst} {held:?}"
        );
        assert!(s.binding.iter().any(|b| b.limit.name() == "hertz_pressure"));
        assert!(s.force.rms_error_n > last);
        last = s.force.rms_error_n;
    }
}

#[test]
fn a_size_that_is_free_grows_until_the_pressure_is_kept() {
    // Found after the law: the smallest cam that keeps the pressure, which it therefore reaches.
    for follower in [&["cam.follower=flat-translating"][..], &ROLLER[..2]] {
        let mut base = follower.to_vec();
        base.extend(&OPEN);
        let free = design(scene::DEFAULT, &base);
        let limit = format!("limits.hertz_pressure={} Pa", 0.95 * pressure(&free));
        let s = design(scene::DEFAULT, &[&base[..], &[limit.as_str()]].concat());
        let held = check(&s, "hertz_pressure");
        assert!(
            held.pass && (held.worst / held.limit - 1.0).abs() < 1e-5,
            "{held:?}"
        );
        assert!(s.cam.follower.prime_radius() > free.cam.follower.prime_radius());
        assert_eq!(s.coefficients, free.coefficients);
    }
}

#[test]
fn law_and_base_circle_keep_the_pressure_together() {
    let base = [&OPEN[..], &["limits.prime_radius=45 mm"]].concat();
    let most = pressure(&design(scene::DEFAULT, &base));
    let limit = format!("limits.hertz_pressure={} Pa", 0.9 * most);
    let both = [&base[..], &[limit.as_str()]].concat();
    let s = design(scene::DEFAULT, &both);
    assert!(s.infeasible.is_none(), "{:?}", s.infeasible);
    assert!(
        check(&s, "hertz_pressure").pass && check(&s, "prime_radius").pass,
        "{:?}",
        s.checks
    );
}

#[test]
fn harmonics_keep_the_pressure_under_a_flat_face_too() {
    let base = [
        "law.family=harmonic",
        "law.harmonics=6",
        "cam.base_radius=40 mm",
        "accuracy.rms=50 %",
    ];
    let most = pressure(&design(scene::DEFAULT, &base));
    let limit = format!("limits.hertz_pressure={} Pa", 0.95 * most);
    let s = design(scene::DEFAULT, &[&base[..], &[limit.as_str()]].concat());
    assert!(s.infeasible.is_none() && check(&s, "hertz_pressure").pass);
    assert!(pressure(&s) <= 0.95 * most * (1.0 + 1e-6));
    assert_eq!(s.family.name(), "harmonic");
}
