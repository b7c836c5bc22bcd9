//! What one good costs in another: fronts, weighed objectives, law and size found together. Every claim is held against a
//! dense scan or a second solve.

use std::f64::consts::TAU;

use super::targets::{mean_square_jerk, read, solved, young};
use gaitcam::Problem;
use gaitcam::scene;
use gaitcam::synth::{Design, Figures, synthesise, trade, traded};

#[test]
fn the_front_falls_and_ends_at_the_unlimited_law() {
    let target = young();
    for (pair, spans) in [
        ("force_error:jerk", 16),
        ("stroke:force_error", 16),
        ("force_error:prime_radius", 12),
    ] {
        let spans = format!("law.spans={spans}");
        let roller = [
            spans.as_str(),
            "cam.follower=roller-translating",
            "cam.roller_radius=6 mm",
            "cam.bore=auto",
            "limits.curvature=2 mm",
            "limits.stroke=none",
        ];
        let changes: &[&str] = if pair.contains("radius") {
            &roller
        } else {
            &roller[..1]
        };
        let scene = read(changes);
        let against = traded(pair).unwrap();
        let of = |design: &Design| against.value(&Figures::of(design));
        let problem = Problem::resolve(&scene, Some(&target)).unwrap();
        let front = trade(&problem, against, 8).unwrap();
        assert!(front.len() >= 6, "{pair}: {}", front.len());
        for t in &front {
            assert!(
                of(&t.design) <= t.allowed * (1.0 + 1e-6),
                "{pair}: {} of {}",
                of(&t.design),
                t.allowed
            );
        }
        for pair_of in front.windows(2) {
            assert!(pair_of[1].allowed > pair_of[0].allowed);
            assert!(
                pair_of[1].design.force.rms_error_n
                    <= pair_of[0].design.force.rms_error_n * (1.0 + 1e-6),
                "{pair}: {} after {}",
                pair_of[1].design.force.rms_error_n,
                pair_of[0].design.force.rms_error_n
            );
        }
        let free = synthesise(&scene, Some(&target)).unwrap();
        let last = &front[front.len() - 1].design;
        assert!(
            (last.force.rms_error_n / free.force.rms_error_n - 1.0).abs() < 1e-2,
            "{pair}"
        );
    }
}

#[test]
fn words_that_name_no_front_are_refused() {
    for pair in ["force_error", "jerk:stroke", "force_error:beauty"] {
        let error = traded(pair).unwrap_err().to_string();
        assert!(error.contains("prime_radius"), "{error}");
    }
}

/// A law through a point to a dwell under a follower that swings about a pivot at 80 mm; `rest` is what follows in `[cam]`.
fn swinging(minimise: &str, rest: &str) -> Design {
    swinging_on(40, minimise, rest)
}

fn swinging_on(spans: usize, minimise: &str, rest: &str) -> Design {
    let text = format!(
        r#"
        name = "arm"
        [drive]
        kind = "fixed-axis"
        speed = "10 rad/s"
        [law]
        family = "spline"
        spans = {spans}
        minimise = "{minimise}"
        [[law.point]]
        angle = "130 deg"
        lift = "16 deg"
        [[law.dwell]]
        from = "260 deg"
        to = "360 deg"
        lift = "0 deg"
        [cam]
        pivot_distance = "80 mm"
        {rest}
        "#
    );
    let table: toml::Table = text.parse().unwrap();
    synthesise(&scene::read(&table).unwrap(), None).unwrap()
}

/// An arm on a given base circle: without help the law breaks its pressure angle or its curvature.
#[test]
fn the_law_of_an_arm_gives_way_to_pressure_angle_and_curvature() {
    let scene = |follower: &str, limits: &str, rest: &str| {
        swinging(
            "jerk",
            &format!("follower = \"{follower}\"\n{rest}\n[limits]\n{limits}"),
        )
    };
    let arm = "arm = \"65 mm\"\nroller_radius = \"8 mm\"\nbase_radius = \"32 mm\"";
    let free = scene("roller-oscillating", "", arm);
    let (low, high) = free.cam.pressure_angle_extremes();
    let limit = 0.9 * high.value.max(-low.value);
    let limits = format!("pressure_angle = \"{limit} rad\"");
    let held = scene("roller-oscillating", &limits, arm);
    assert_eq!(
        held.solver.tier.name(),
        "scp",
        "{}",
        held.solver.status(gaitcam::wording::Language::En)
    );
    assert!(held.checks.iter().all(|c| c.pass), "{:?}", held.checks);
    let (low, high) = held.cam.pressure_angle_extremes();
    assert!(high.value.max(-low.value) <= limit * (1.0 + 1e-6));
    assert!(
        high.value.max(-low.value) > limit * 0.999,
        "the limit binds"
    );
    assert!(
        held.solver
            .steps
            .windows(2)
            .all(|s| s[1].merit <= s[0].merit)
    );

    let face = "face_offset = \"5 mm\"\nbase_radius = \"30 mm\"";
    let free = scene("flat-oscillating", "", face);
    let sharp = free.cam.curvature().convex.value;
    let wanted = if sharp > 0.0 { 1.15 * sharp } else { 2e-3 };
    let limits = format!("curvature = \"{} mm\"", 1e3 * wanted);
    let held = scene("flat-oscillating", &limits, face);
    assert!(held.checks.iter().all(|c| c.pass), "{:?}", held.checks);
    assert!(held.cam.curvature().convex.value >= wanted * (1.0 - 1e-6));
    assert!(
        held.cam.curvature().convex.value <= wanted * 1.01,
        "the limit binds"
    );
}

/// (e/e₁)² + R/R₁ + (j/j₁)² of a finished design, jerk by a dense scan in time.
fn price(design: &Design, one: [Option<f64>; 3]) -> f64 {
    let force = design.force.rms_error_n / design.force.target_mean_n;
    let jerk = mean_square_jerk(design).sqrt() * design.problem.drive.speed.powi(3);
    let radius = design.cam.follower.prime_radius();
    one[0].map_or(0.0, |e| (force / e).powi(2))
        + one[1].map_or(0.0, |r| radius / r)
        + one[2].map_or(0.0, |j| (jerk / j).powi(2))
}

/// With an offset given, too: a price on D = √(Rp² − e²) makes the cam 0.2 % too small and the objective 5e-5 larger.
#[test]
fn a_weighed_radius_is_the_prime_radius_at_any_offset() {
    let target = young();
    for (offset, rounded) in [(0.0, false), (12.0, false), (-15.0, false), (12.0, true)] {
        let offset = format!("cam.offset={offset} mm");
        let roller = [
            "law.spans=16",
            "cam.follower=roller-translating",
            "cam.roller_radius=5 mm",
            "limits.pressure_angle=30 deg",
            "accuracy.rms=50 %",
            &offset,
            if rounded {
                "limits.curvature=5 mm"
            } else {
                "limits.curvature=none"
            },
        ];
        let with = |more: &[&str]| solved(&[&roller[..], more].concat(), &target);
        let one = [Some(0.05), Some(0.01), None];
        let weighed = with(&["law.weigh.force_error=5 %", "law.weigh.prime_radius=10 mm"]);
        let own = price(&weighed, one);
        let radius = weighed.cam.follower.prime_radius();
        let failed: Vec<_> = weighed.checks.iter().filter(|c| !c.pass).collect();
        assert!(failed.is_empty(), "{offset}: {failed:?}");
        for k in [-40, -10, -3, -2, -1, 1, 2, 3, 10, 40] {
            let other = 1e3 * radius * (1.0 + 0.001 * f64::from(k));
            let other = with(&[&format!("limits.prime_radius={other:.9} mm")]);
            if other.checks.iter().all(|c| c.pass) {
                let other = price(&other, one);
                assert!(own <= other * (1.0 + 1e-6), "{offset} {k}: {own} {other}");
            }
        }
    }
}

/// The weighed optimum is the cheapest point of the front that the limit on the size alone draws.
#[test]
fn a_weighed_objective_finds_the_cheapest_point_of_the_front() {
    let target = young();
    let face = [
        "law.spans=16",
        "limits.curvature=40 mm",
        "cam.bore=5 mm",
        "accuracy.rms=50 %",
        "limits.stroke=100 mm",
    ];
    let one = [Some(0.05), Some(0.010), None];
    let with = |more: &[&str]| solved(&[&face[..], more].concat(), &target);
    let weighed = with(&["law.weigh.force_error=5 %", "law.weigh.prime_radius=10 mm"]);
    assert!(
        weighed.checks.iter().all(|c| c.pass),
        "{}",
        weighed.reason(gaitcam::wording::Language::En)
    );
    let found = price(&weighed, one);
    let radius = weighed.cam.follower.prime_radius();
    let mut cheapest = f64::INFINITY;
    for k in -10..=10 {
        let limit = format!(
            "limits.prime_radius={:.9} mm",
            1e3 * radius * (1.0 + 0.01 * f64::from(k))
        );
        let other = with(&[&limit]);
        if other.checks.iter().all(|c| c.pass) {
            cheapest = cheapest.min(price(&other, one));
        }
    }
    assert!(
        found <= cheapest * (1.0 + 1e-6),
        "{found} against {cheapest}"
    );
    assert!(
        found > cheapest * (1.0 - 1e-4),
        "{found} against {cheapest}"
    );
    let free = with(&[]);
    assert!(
        radius < 0.98 * free.cam.follower.prime_radius(),
        "the price of the size is felt"
    );
}

/// A roller's cone weighs the same way as the flat face's rows.
#[test]
fn a_weighed_roller_gets_smaller_where_the_force_error_is_cheap() {
    let target = young();
    let roller = [
        "law.spans=16",
        "cam.follower=roller-translating",
        "cam.roller_radius=5 mm",
        "cam.bore=5 mm",
        "limits.pressure_angle=30 deg",
        "limits.curvature=none",
        "accuracy.rms=50 %",
    ];
    let small = |e: &str| {
        let weigh = [e, "law.weigh.prime_radius=10 mm"];
        solved(&[&roller[..], &weigh].concat(), &target)
    };
    let (near, far) = (
        small("law.weigh.force_error=0.5 %"),
        small("law.weigh.force_error=10 %"),
    );
    assert!(far.cam.follower.prime_radius() < near.cam.follower.prime_radius() - 1e-3);
    assert!(far.force.rms_error_n > near.force.rms_error_n);
    assert!(
        price(&near, [Some(0.005), Some(0.01), None])
            <= price(&far, [Some(0.005), Some(0.01), None])
    );
    assert!(
        price(&far, [Some(0.1), Some(0.01), None]) <= price(&near, [Some(0.1), Some(0.01), None])
    );
}

/// Force and jerk alone: a quadratic whose gradient vanishes at the answer, by differences along other laws.
#[test]
fn a_weighed_jerk_is_at_its_least_along_every_other_law() {
    let target = young();
    let one = [Some(0.02), None, Some(150.0)];
    let base = ["law.spans=16", "accuracy.rms=50 %", "limits.stroke=100 mm"];
    let with = |more: &[&str]| solved(&[&base[..], more].concat(), &target);
    let weighed = with(&["law.weigh.force_error=2 %", "law.weigh.jerk=150 m/s^3"]);
    let (near, smooth) = (
        with(&[]),
        with(&["law.weigh.force_error=40 %", "law.weigh.jerk=150 m/s^3"]),
    );
    let found = price(&weighed, one);
    for other in [&near, &smooth] {
        // Laws between the optimum and another one: dearer by the square of the way.
        let at = |part: f64| {
            let errors: Vec<f64> = (0..20_000)
                .map(|i| TAU * f64::from(i) / 20_000.0)
                .map(|x| {
                    let (a, b) = (weighed.cam.law.svaj(x), other.cam.law.svaj(x));
                    let mix = |p: f64, q: f64| p + part * (q - p);
                    let force = mix(
                        weighed.problem.drive.force(a),
                        weighed.problem.drive.force(b),
                    ) - target.at(x);
                    let jerk = mix(a.j, b.j) * weighed.problem.drive.speed.powi(3);
                    (force / 700.0 / 0.02).powi(2) + (jerk / 150.0).powi(2)
                })
                .collect();
            errors.iter().sum::<f64>() / 20_000.0
        };
        assert!((at(0.0) / found - 1.0).abs() < 1e-5);
        let (here, back, there) = (at(0.0), at(-0.01), at(0.01));
        assert!(back > here && there > here, "{back} {here} {there}");
        assert!(
            (there - back).abs() < 1e-3 * (there + back - 2.0 * here),
            "flat at the answer"
        );
    }
}

#[test]
fn weighings_that_say_nothing_or_too_much_are_refused() {
    let target = young();
    let refused = |changes: &[&str], word: &str| {
        let mut table: toml::Table = scene::DEFAULT.parse().unwrap();
        let scene = changes
            .iter()
            .try_for_each(|change| scene::set(&mut table, change))
            .and_then(|()| scene::read(&table));
        let error = scene
            .and_then(|s| synthesise(&s, Some(&target)))
            .unwrap_err()
            .to_string();
        assert!(error.contains(word), "{error}");
    };
    refused(&["law.weigh.jerk=0 m/s^3"], "not positive");
    refused(&["law.weigh.radius=10 mm"], "unknown key");
    refused(
        &["law.weigh.jerk=10 m/s^3", "law.minimise=jerk"],
        "law.minimise",
    );
    refused(
        &["law.weigh.jerk=10 m/s^3", "law.family=harmonic"],
        "law.weigh",
    );
    refused(
        &["law.weigh.prime_radius=10 mm", "cam.base_radius=40 mm"],
        "size",
    );
}

/// A law that is found together with its cam's size fits a smaller cam than the size found after the law, and the
/// objective and the limit on the size end at the same radius.
#[test]
fn law_and_size_under_a_follower_that_swings_are_found_together() {
    let design = |follower: &str, minimise: &str, limit: Option<f64>| {
        let most = limit.map_or(String::new(), |r| format!("prime_radius = \"{r} m\""));
        swinging(
            minimise,
            &format!("{follower}\ncurvature = \"8 mm\"\n{most}"),
        )
    };
    let arm = "follower = \"roller-oscillating\"\narm = \"65 mm\"\nroller_radius = \"8 mm\"\nbore = \"6 mm\"\n[limits]\npressure_angle = \"35 deg\"";
    let face = "follower = \"flat-oscillating\"\nface_offset = \"5 mm\"\n[limits]";
    for follower in [arm, face] {
        let radius = |d: &Design| d.cam.follower.prime_radius();
        let holds = |d: &Design| d.infeasible.is_none() && d.checks.iter().all(|c| c.pass);
        let after = design(follower, "jerk", None);
        let smallest = design(follower, "size", None);
        assert!(holds(&smallest), "{:?}", smallest.checks);
        let (least, usual) = (radius(&smallest), radius(&after));
        assert!(least < 0.95 * usual, "{least} {usual}");
        let between = design(follower, "jerk", Some(0.5 * (least + usual)));
        assert!(holds(&between), "{:?}", between.checks);
        assert!(radius(&between) <= 0.5 * (least + usual) * (1.0 + 1e-8));
        assert!(mean_square_jerk(&between) > mean_square_jerk(&after));
        assert!(mean_square_jerk(&between) < mean_square_jerk(&smallest));
        assert!(holds(&design(follower, "jerk", Some(1.01 * least))));
        assert!(!holds(&design(follower, "jerk", Some(0.97 * least))));
    }
    // A limit that the arm cannot reach is missed by the cam of the law alone, and nothing that was not written is named.
    let unreached = design(arm, "jerk", Some(1e-6));
    let missed: Vec<_> = unreached.checks.iter().filter(|c| !c.pass).collect();
    assert_eq!(missed.len(), 1, "{missed:?}");
    assert_eq!(missed[0].name.name(), "prime_radius");
}

/// The smallest cam under an arm is as small on many spans as on few, and a limit just above it is kept.
#[test]
fn the_smallest_cam_under_an_arm_does_not_depend_on_the_number_of_spans() {
    let arm = "follower = \"roller-oscillating\"\narm = \"65 mm\"\nroller_radius = \"8 mm\"\nbore = \"6 mm\"\n[limits]\npressure_angle = \"35 deg\"";
    let face = "follower = \"flat-oscillating\"\nface_offset = \"5 mm\"\n[limits]";
    for follower in [arm, face] {
        let design = |spans: usize, minimise: &str, limit: Option<f64>| {
            let most = limit.map_or(String::new(), |r| format!("prime_radius = \"{r} m\""));
            let rest = format!("{follower}\ncurvature = \"8 mm\"\n{most}");
            let design = swinging_on(spans, minimise, &rest);
            assert!(
                design.checks.iter().all(|c| c.pass),
                "{spans} {minimise} {follower}: {:?}",
                design.checks
            );
            design.cam.follower.prime_radius()
        };
        let few = design(20, "size", None);
        for spans in [32, 47, 80, 100, 120] {
            let least = design(spans, "size", None);
            assert!(
                least <= few * (1.0 + 1e-7) && least > 0.99 * few,
                "{spans}: {least} {few}"
            );
            design(spans, "jerk", Some(1.03 * least));
        }
    }
}

/// The size of a cam that is found after its law is no objective: the answer says so instead of another optimum.
#[test]
fn a_size_that_follows_the_law_is_no_objective() {
    let barrel = "follower = \"barrel\"\nroller_radius = \"5 mm\"";
    let mushroom = "follower = \"mushroom-oscillating\"\narc_radius = \"12 mm\"\npivot_distance = \"130 mm\"\narm = \"100 mm\"";
    for (follower, lift) in [(barrel, "16 mm"), (mushroom, "5 deg")] {
        let text = format!(
            "[drive]\nkind = \"fixed-axis\"\nspeed = \"10 rad/s\"\n[law]\nfamily = \"spline\"\nminimise = \"size\"\n[[law.point]]\nangle = \"130 deg\"\nlift = \"{lift}\"\n[cam]\n{follower}\n"
        );
        let table: toml::Table = text.parse().unwrap();
        let refused = scene::read(&table).unwrap_err().to_string();
        assert!(refused.contains("law.minimise"), "{refused}");
    }
}

/// The radius of a roller cam beside a given offset is R ≥ ‖(D, e)‖: the sum of its parts is what laws on given prime circles
/// cost, and no other circle costs less.
#[test]
fn a_weighed_radius_beside_an_offset_is_certified_and_the_best_of_all_circles() {
    let text = "name = \"w\"\n[gait]\nmodel = \"young\"\nstep_frequency = \"1.9 Hz\"\nbody_weight = \"700 N\"\nfeet = \"both\"\n[drive]\nkind = \"fixed-axis\"\nmass = \"3 kg\"\nspring_rate = \"9000 N/m\"\npreload = \"50 N\"\ndamping = \"60 N s/m\"\n[cam]\nfollower = \"roller-translating\"\nroller_radius = \"4 mm\"\n[accuracy]\nrms = \"none\"\n[limits]\npressure_angle = \"25 deg\"\n[law]\nfamily = \"spline\"\ndegree = 5\nspans = 12\n";
    let weighed = format!("{text}[law.weigh]\nforce_error = \"5 %\"\nprime_radius = \"60 mm\"\n");
    for offset in [-20, -12, -6, 0, 6, 12, 20] {
        let offset = format!("cam.offset={offset} mm");
        let design = gaitcam_test_support::design(&weighed, &[offset.as_str()]).unwrap();
        assert!(design.solver.certified, "{offset}: {:?}", design.solver);
        let cost = |error_percent: f64, radius: f64| (error_percent / 5.0).powi(2) + radius / 0.06;
        let radius = design.cam.follower.prime_radius();
        let own = cost(design.force.rms_error_percent_of_mean, radius);
        for part in [0.99, 1.0, 1.01] {
            // Smaller than the roller no circle is.
            if part * radius < 4e-3 {
                continue;
            }
            let circle = format!("cam.prime_radius={} m", part * radius);
            let given = gaitcam_test_support::design(text, &[offset.as_str(), &circle]).unwrap();
            if given.infeasible.is_some() {
                assert!(part < 1.01, "{offset}: a larger circle is refused");
                continue;
            }
            let other = cost(given.force.rms_error_percent_of_mean, part * radius);
            let least = if part == 1.0 { -1e-6 } else { 1e-7 };
            assert!(
                other > own * (1.0 + least),
                "{offset} {part}: {other} {own}"
            );
            assert!(
                part != 1.0 || other < own * (1.0 + 1e-6),
                "{offset}: {other} {own}"
            );
        }
    }
}
