//! Trade-offs between objectives: fronts, and law and size found together. Every result is compared with a dense scan or a second solution.

use super::targets::{mean_square_jerk, read};
use gaitcam::Problem;
use gaitcam::scene;
use gaitcam::synth::{Design, Figures, Search, synthesise, trade, traded};
use gaitcam_test_support::young;

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
        let front = trade(&problem, against, 8, &Search::default()).unwrap();
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

/// Law through a point to a dwell with an oscillating follower whose pivot is at 80 mm. `rest` is the rest of the table `[cam]`.
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

/// An arm on a given base circle: the law without these limits violates pressure angle or curvature.
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

#[test]
fn a_weighed_objective_is_refused_with_the_advice_to_use_the_front() {
    for change in ["law.weigh.jerk=10 m/s^3", "law.weigh.prime_radius=10 mm"] {
        let error = gaitcam_test_support::design(scene::DEFAULT, &[change]).unwrap_err();
        assert!(error.to_string().contains("--front"), "{error}");
    }
}

/// A law found together with the size has a smaller cam than a law found before the size. The objective and the limit on the size lead to the same
/// radius.
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

/// The smallest cam with an arm is as small with many spans as with few, and a limit slightly above it is satisfied.
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

/// The size of a cam found after its law cannot be minimised. The message says so, and there is no other optimum.
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
