//! Several cams for many walkers, compared with all possible assignments.

use std::f64::consts::TAU;

use gaitcam::cover::{Assigned, Cover, covers, folds, served_by};
use gaitcam::force::{ForceCurve, Walker};
use gaitcam::synth::Search;
use gaitcam::{Scene, scene};

/// Walkers with these step frequencies and load factors, in phase, with different weights.
fn walkers(of: &[(&str, f64, [f64; 2])]) -> ForceCurve {
    let each = of.iter().enumerate().map(|(w, (name, f, [a, b]))| {
        let weight = 700.0 + 60.0 * ((3 * w) % 7) as f64;
        let at = |i: usize| {
            let x = TAU * i as f64 / 256.0;
            weight * (1.0 + a * x.sin() + b * (2.0 * x + 0.3).sin())
        };
        let curve = ForceCurve::from_samples(name, 1.0 / f, (0..256).map(at).collect()).unwrap();
        Walker::new(name, curve)
    });
    ForceCurve::of_walkers(each.collect()).unwrap()
}

/// Seven different walkers.
fn seven() -> ForceCurve {
    walkers(&[
        ("A", 1.6, [0.30, 0.08]),
        ("B", 1.7, [0.36, 0.02]),
        ("C", 1.9, [0.34, 0.10]),
        ("D", 2.0, [0.48, 0.05]),
        ("E", 1.8, [0.22, 0.06]),
        ("F", 2.1, [0.40, 0.14]),
        ("G", 1.75, [0.45, 0.11]),
    ])
}

fn with(changes: &[(&str, &str)]) -> Scene {
    let scene = scene::built_in("footbridge").unwrap().scene().unwrap();
    let usual = [("law.spans", "12"), ("accuracy.rms", "none")];
    let all = usual.iter().chain(changes);
    all.fold(scene, |s, (key, value)| s.with(key, value).unwrap())
}

fn objective(scene: &Scene, each: &[Assigned]) -> f64 {
    let errors = each.iter().map(|a| a.error.measured(scene.law.error));
    if scene.law.robust.to_string() == "worst" {
        errors.fold(0.0, f64::max)
    } else {
        (errors.map(|e| e * e).sum::<f64>() / each.len() as f64).sqrt()
    }
}

/// Minimum objective over all 63 assignments of seven walkers to two cams.
fn least_of_all(scene: &Scene, force: &ForceCurve) -> f64 {
    let population = force.population.as_ref().unwrap();
    let group = |code: u32, value: u32| -> f64 {
        let own = population.walkers.iter().enumerate();
        let own = own
            .filter(|(i, _)| (code >> i) & 1 == value)
            .map(|(_, w)| w.clone());
        let force = ForceCurve::of_walkers(own.collect()).unwrap();
        let report = scene.design_for(&force).unwrap().population.unwrap();
        let errors = report.each.iter().map(|e| e.measured(scene.law.error));
        match scene.law.robust.to_string().as_str() {
            "worst" => errors.fold(0.0, f64::max),
            _ => errors.map(|e| e * e).sum(),
        }
    };
    let mut best = f64::INFINITY;
    for code in 1..64 {
        let (a, b) = (group(code, 0), group(code, 1));
        best = best.min(match scene.law.robust.to_string().as_str() {
            "worst" => a.max(b),
            _ => ((a + b) / 7.0).sqrt(),
        });
    }
    best
}

#[test]
fn two_cams_for_seven_walkers_are_the_best_of_all_assignments_and_above_the_bound() {
    let force = seven();
    let cases = [
        ("worst", "relative", "60 mm", "99 m/s^2"),
        ("mean", "relative", "60 mm", "99 m/s^2"),
        ("worst", "relative", "34 mm", "4.5 m/s^2"),
        ("mean", "relative", "34 mm", "4.5 m/s^2"),
        ("worst", "absolute", "34 mm", "4.5 m/s^2"),
        ("mean", "absolute", "60 mm", "99 m/s^2"),
    ];
    for (robust, error, stroke, acceleration) in cases {
        let scene = with(&[
            ("law.robust", robust),
            ("law.error", error),
            ("limits.stroke", stroke),
            ("limits.acceleration", acceleration),
        ]);
        let found = covers(&scene, &force, 7, &Search::default()).unwrap();
        let two = objective(&scene, &found[1].each);
        let least = least_of_all(&scene, &force);
        assert!(
            (two / least - 1.0).abs() < 1e-6,
            "{robust} {stroke}: {two} {least}"
        );
        for cover in &found {
            let own = objective(&scene, &cover.each);
            let bound = cover.bound.unwrap();
            assert!(
                bound <= own * (1.0 + 1e-9),
                "{robust} {stroke}: {bound} {own}"
            );
        }
        // One cam for all and a cam for each are proved.
        for number in [1, 7] {
            let own = objective(&scene, &found[number - 1].each);
            let gap = 1.0 - found[number - 1].bound.unwrap() / own;
            assert!(gap < 1e-5, "{robust} {stroke} {number}: {gap}");
        }
        assert!(
            found
                .windows(2)
                .all(|w| objective(&scene, &w[1].each)
                    <= objective(&scene, &w[0].each) * (1.0 + 1e-9))
        );
    }
}

#[test]
fn walkers_of_three_kinds_have_three_cams_and_parts_of_an_error_add_up() {
    let kinds = [
        (1.6, [0.30, 0.08]),
        (1.9, [0.34, 0.10]),
        (2.1, [0.40, -0.14]),
    ];
    let names: Vec<String> = (0..12).map(|i| format!("W{i:02}")).collect();
    let of: Vec<(&str, f64, [f64; 2])> = (names.iter().enumerate())
        .map(|(i, n)| (n.as_str(), kinds[i % 3].0, kinds[i % 3].1))
        .collect();
    let force = walkers(&of);
    let scene = with(&[("law.spans", "24")]);
    let found = covers(&scene, &force, 4, &Search::default()).unwrap();
    let cams = |c: &Cover| -> Vec<usize> { c.each.iter().map(|a| a.cam).collect() };
    let three = cams(&found[2]);
    assert!((0..12).all(|i| three[i] == three[i % 3]), "{three:?}");
    assert!(found[2].worst < 0.02 * found[1].worst);
    for assigned in found.iter().flat_map(|c| &c.each) {
        let sum: f64 = assigned.parts_percent.iter().map(|p| p * p).sum();
        assert!((sum.sqrt() / assigned.error.rms_error_percent - 1.0).abs() < 1e-9);
        // The mass is that of each walker: nothing is left of the mean force.
        assert!(assigned.parts_percent[0] < 1e-9);
    }
    let again = served_by(&found[2].scene, &found[2].cams, &force).unwrap();
    assert_eq!(again, found[2].each);
}

/// The error of the same force at another speed is attributed to the size; that of another weight on a machine with fixed mass to the mean.
#[test]
fn an_error_is_attributed_to_what_causes_it() {
    let force = walkers(&[("slow", 1.6, [0.3, 0.1]), ("fast", 2.2, [0.3, 0.1])]);
    let scene = with(&[("law.spans", "24")]);
    let one = &covers(&scene, &force, 1, &Search::default()).unwrap()[0];
    for assigned in &one.each {
        let [mean, size, shape] = assigned.parts_percent;
        assert!(
            size > 1.0 && mean < 1e-9 && shape < 0.05 * size,
            "{:?}",
            assigned.parts_percent
        );
    }
    let of = |force: &ForceCurve| force.population.as_ref().unwrap().walkers.clone();
    let mut heavy = of(&walkers(&[("heavy", 1.8, [0.3, 0.1])]));
    heavy[0].curve = heavy[0]
        .curve
        .with_forces(heavy[0].curve.force_n.iter().map(|f| 1.2 * f).collect());
    let mut both = of(&walkers(&[("light", 1.8, [0.3, 0.1])]));
    both.extend(heavy);
    let force = ForceCurve::of_walkers(both).unwrap();
    let scene = with(&[("drive.mass", "78 kg"), ("law.spans", "24")]);
    let one = &covers(&scene, &force, 1, &Search::default()).unwrap()[0];
    for assigned in &one.each {
        let [mean, size, shape] = assigned.parts_percent;
        assert!(mean > 3.0 * size.max(shape), "{:?}", assigned.parts_percent);
    }
}

/// Three equal cycles of each of twelve walkers. If cycles instead of walkers were left out, one cam per walker would seem perfect for new walkers.
#[test]
fn walkers_left_out_are_served_worse_than_those_designed_for() {
    let names: Vec<String> = (0..12).map(|i| format!("W{i:02}")).collect();
    let mut of = Vec::new();
    for (i, name) in names.iter().enumerate() {
        let x = i as f64;
        let factors = [0.3 + 0.1 * (2.3 * x).sin(), 0.08 + 0.05 * (1.7 * x).cos()];
        of.extend(
            [0.0, 0.001, 0.002].map(|d| (name.as_str(), 1.8 + 0.2 * (3.1 * x).sin() + d, factors)),
        );
    }
    let force = walkers(&of);
    let scene = with(&[("law.robust", "worst")]);
    let rows = folds(&scene, &force, 3, &Search::default()).unwrap();
    // Nine walkers at most are known where twelve are, four of them in the smaller sample.
    let known: Vec<usize> = rows.iter().map(|r| r.walkers).collect();
    assert!(
        known.contains(&4) && known.contains(&9) && rows.iter().any(|r| r.cams == 3),
        "{known:?}"
    );
    for row in &rows {
        assert!(row.out_worst > row.in_worst, "{row:?}");
        assert!(
            row.out_mean > 1.05 * row.in_mean || row.cams == 1,
            "{row:?}"
        );
    }
}

/// Root of the minimum mean square of the worst part over all assignments of five walkers to two cams. For given walkers it is the maximum of the
/// sums m CVaR over the shares m of the cams in the worst part (convex duality). It is found by a ternary search.
fn least_tail_of_all(scene: &Scene, force: &ForceCurve, part: f64) -> f64 {
    let walkers = &force.population.as_ref().unwrap().walkers;
    let all = walkers.len();
    // m of the worst 1 − part, and what the mean square of a group's worst then adds.
    let of_group = |group: &[usize], m: f64| -> f64 {
        let own = group.iter().map(|i| walkers[*i].clone()).collect();
        let worst = m * (1.0 - part) * all as f64 / group.len() as f64;
        let robust = match worst {
            x if x >= 1.0 => "mean".to_string(),
            x if x <= 1e-9 => "worst".to_string(),
            x => format!("cvar {}", 1.0 - x),
        };
        let scene = scene.with("law.robust", &robust).unwrap();
        let force = ForceCurve::of_walkers(own).unwrap();
        let report = scene.design_for(&force).unwrap().population.unwrap();
        let mut squares: Vec<f64> = (report.each.iter())
            .map(|e| e.rms_error_percent.powi(2))
            .collect();
        squares.sort_by(|a, b| b.total_cmp(a));
        let (mut left, mut sum) = (worst.min(1.0) * group.len() as f64, 0.0);
        for square in squares {
            sum += square * left.clamp(0.0, 1.0);
            left -= 1.0;
        }
        sum / ((1.0 - part) * all as f64)
    };
    let mut best = f64::INFINITY;
    for code in 1..1_u32 << (all - 1) {
        let groups =
            [0, 1].map(|c| -> Vec<usize> { (0..all).filter(|i| (code >> i) & 1 == c).collect() });
        let most = groups
            .each_ref()
            .map(|g| (g.len() as f64 / ((1.0 - part) * all as f64)).min(1.0));
        let value = |m: f64| of_group(&groups[0], m) + of_group(&groups[1], 1.0 - m);
        let (mut low, mut high) = (1.0 - most[1], most[0]);
        for _ in 0..12 {
            let (a, b) = ((2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0);
            if value(a) < value(b) {
                low = a;
            } else {
                high = b;
            }
        }
        best = best.min(value(0.5 * (low + high)));
    }
    best.sqrt()
}

#[test]
fn two_cams_for_the_worst_part_of_five_walkers_are_nearly_the_best_of_all_and_above_the_bound() {
    let all = seven().population.as_ref().unwrap().walkers.clone();
    let force = ForceCurve::of_walkers(all[..5].to_vec()).unwrap();
    for part in [0.4, 0.7] {
        let scene = with(&[
            ("law.robust", &format!("cvar {part}")),
            ("limits.stroke", "40 mm"),
        ]);
        let found = covers(&scene, &force, 5, &Search::default()).unwrap();
        let least = least_tail_of_all(&scene, &force, part);
        let two = found[1].objective;
        assert!(two < 1.01 * least, "{part}: {two} {least}");
        for cover in &found {
            let (own, bound) = (cover.objective, cover.bound.unwrap());
            assert!(bound <= own * (1.0 + 1e-9), "{part}: {bound} {own}");
        }
        for number in [1, 5] {
            let cover = &found[number - 1];
            let gap = 1.0 - cover.bound.unwrap() / cover.objective;
            assert!(gap < 1e-5, "{part} {number}: {gap}");
        }
    }
}

#[test]
fn one_walker_has_no_cover_and_the_error_names_the_key() {
    let one = walkers(&[("A", 1.6, [0.3, 0.1])]);
    let error = covers(&with(&[]), &one, 2, &Search::default()).unwrap_err();
    assert!(error.to_string().contains("gait.file"), "{error}");
}
