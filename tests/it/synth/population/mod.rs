//! One cam for many walkers, compared with closed forms and an independent conic program.

mod cones;
mod easing;
mod sweep;

use std::f64::consts::TAU;

use gaitcam::force::{ForceCurve, Walker};
use gaitcam::{Scene, scene};

/// Generator of random numbers in [0, 1) by Marsaglia's xorshift.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (self.next().max(1e-300), self.next());
        (-2.0 * a.ln()).sqrt() * (TAU * b).cos()
    }
}

/// Walkers with load factors near those of Young, 2001, with (cosine, sine) of each harmonic relative to the weight.
fn people(count: usize, harmonics: usize, spread: f64) -> Vec<(Walker, Vec<(f64, f64)>)> {
    let mut random = Random(88_172_645_463_325_252);
    let person = |i: usize| {
        let weight = 9.81 * (70.0 + 12.0 * random.normal()).clamp(45.0, 110.0);
        let f = (1.87 + 0.186 * random.normal()).clamp(1.4, 2.4);
        let mean = [
            0.37 * (f - 0.95),
            0.054 + 0.0088 * f,
            0.026 + 0.015 * f,
            0.010 + 0.0204 * f,
        ];
        let wave = |n: usize| {
            let a = mean.get(n).copied().unwrap_or(0.008) * (1.0 + 0.16 * spread * random.normal());
            let phase = if n == 0 {
                0.0
            } else {
                0.5 * spread * random.normal()
            };
            (a * phase.sin(), a * phase.cos())
        };
        let waves: Vec<(f64, f64)> = (0..harmonics).map(wave).collect();
        let at = |j: usize| {
            let x = TAU * j as f64 / 1024.0;
            let sum = (1..).zip(&waves).map(|(n, (c, s))| {
                let (sin, cos) = (f64::from(n) * x).sin_cos();
                c * cos + s * sin
            });
            weight * (1.0 + sum.sum::<f64>())
        };
        let curve = ForceCurve::from_samples("", 1.0 / f, (0..1024).map(at).collect()).unwrap();
        (Walker::new(&format!("W{i:03}"), curve), waves)
    };
    (0..count).map(person).collect()
}

fn force(people: &[(Walker, Vec<(f64, f64)>)]) -> ForceCurve {
    ForceCurve::of_walkers(people.iter().map(|p| p.0.clone()).collect()).unwrap()
}

fn with(changes: &[(&str, &str)]) -> Scene {
    let scene = scene::built_in("footbridge").unwrap().scene().unwrap();
    changes
        .iter()
        .fold(scene, |s, (key, value)| s.with(key, value).unwrap())
}

#[test]
fn the_cam_of_one_walker_is_the_cam_of_his_cycle() {
    let one = people(1, 6, 1.0);
    let limited = [("limits.stroke", "40 mm"), ("law.spans", "24")];
    for robust in ["mean", "worst", "cvar 0.9"] {
        let scene = with(&[limited[0], limited[1], ("law.robust", robust)]);
        let population = scene.design_for(&force(&one)).unwrap();
        let alone = scene.design_for(&one[0].0.curve).unwrap();
        for (a, b) in population.coefficients.iter().zip(&alone.coefficients) {
            assert!((a - b).abs() < 1e-9 * 0.04, "{a} {b}");
        }
        assert_eq!(population.verdict, alone.verdict);
        let own = population.population.unwrap();
        let percent = alone.force.rms_error_percent_of_mean;
        assert!((own.worst_percent / percent - 1.0).abs() < 1e-9);
    }
}

/// The objective is Σ p (ω²a/g − y)² with the acceleration a of the cam and y = F/G − 1. Up to a constant, it is the distance to g·Σ p ω² y/Σ p ω⁴.
#[test]
fn the_cam_of_the_mean_error_is_the_cam_of_the_weighted_mean_curve() {
    let people = people(9, 6, 1.0);
    let scene = with(&[("law.spans", "24"), ("limits.stroke", "35 mm")]);
    let design = scene.design_for(&force(&people)).unwrap();
    let speed = |w: &Walker| TAU / w.curve.period_s;
    let whole: f64 = people.iter().map(|(w, _)| speed(w).powi(4)).sum();
    let mean: Vec<f64> = (0..1024)
        .map(|i| {
            let part = |(w, _): &(Walker, _)| {
                speed(w).powi(2) * (w.curve.force_n[i] / w.curve.mean_n() - 1.0) / whole
            };
            people.iter().map(part).sum::<f64>()
        })
        .collect();
    // At 12 rad/s under 700 N this curve is that acceleration.
    let own = mean.iter().map(|y| 700.0 * (1.0 + 144.0 * y)).collect();
    let curve = ForceCurve::from_samples("", TAU / 12.0, own).unwrap();
    let alone = scene.design_for(&curve).unwrap();
    for (a, b) in design.coefficients.iter().zip(&alone.coefficients) {
        // The cubics of a mean curve are not quite the mean of the cubics.
        assert!((a - b).abs() < 1e-7 * 0.035, "{a} {b}");
    }
}

#[test]
fn two_hundred_walkers_under_limits_have_a_proved_worst_error_and_limits_that_hold_for_all() {
    let people = people(200, 8, 0.3);
    let limits = [
        ("law.spans", "32"),
        ("limits.stroke", "40 mm"),
        ("limits.acceleration", "5 m/s^2"),
        ("limits.jerk", "150 m/s^3"),
        ("accuracy.rms", "none"),
    ];
    let mean = with(&limits).design_for(&force(&people)).unwrap();
    let of_mean = mean.population.unwrap();
    for robust in ["worst", "cvar 0.9"] {
        let scene = with(&limits).with("law.robust", robust).unwrap();
        let design = scene.design_for(&force(&people)).unwrap();
        assert!(design.solver.certified && design.checks.iter().all(|c| c.pass));
        let own = design.population.as_ref().unwrap();
        assert!(own.gap <= 1e-6);
        if robust == "worst" {
            assert!(own.worst_percent < of_mean.worst_percent);
        } else {
            assert!(own.cvar_percent < of_mean.cvar_percent);
        }
        assert!(own.mean_percent > of_mean.mean_percent);
        let law = &design.cam.law;
        for order in [2, 3] {
            let [low, high] = [law.extremes(order).0, law.extremes(order).1];
            let most = low.value.abs().max(high.value.abs());
            let fastest = own
                .each
                .iter()
                .fold(0.0_f64, |m, w| m.max(w.speed_rad_per_s));
            let bound = [5.0, 150.0][order - 2];
            assert!(most * fastest.powi(order as i32) <= bound * (1.0 + 1e-6));
        }
    }
}

/// Torque, power, torque rate and contact force of every walker's machine at 3600 angles, from law, mass and speed only.
#[test]
fn limits_on_loads_and_force_hold_for_every_walker_of_random_populations() {
    let mut built = 0;
    for (count, seed) in [(20, 1), (40, 2), (80, 3), (300, 4)] {
        let mut people = people(count, 4, 0.3);
        // Weight has nothing to do with speed: light ones walk fast, too.
        let mut random = Random(u64::wrapping_mul(seed, 0x9e37_79b9_7f4a_7c15));
        for (walker, _) in &mut people {
            let factor = 0.5 + 1.5 * random.next();
            let force = walker.curve.force_n.iter().map(|f| factor * f).collect();
            walker.curve = walker.curve.with_forces(force);
        }
        for (key, bound, robust) in [
            ("limits.torque", "24 N m", "mean"),
            ("limits.power", "220 W", "worst"),
            ("limits.torque_rate", "90 N m/rad", "mean"),
            ("limits.force_min", "150 N", "worst"),
        ] {
            let scene = with(&[
                ("law.spans", "16"),
                (key, bound),
                ("law.robust", robust),
                ("accuracy.rms", "none"),
            ]);
            let design = scene.design_for(&force(&people)).unwrap();
            let law = &design.cam.law;
            let (mut most, mut least) = (0.0_f64, f64::INFINITY);
            for walker in &design.population.as_ref().unwrap().each {
                let (mass, speed) = (walker.mass_kg, walker.speed_rad_per_s);
                for i in 0..3600 {
                    let at = law.svaj(TAU * f64::from(i) / 3600.0);
                    let force = mass * (9.81 + speed * speed * at.a);
                    let load = match key {
                        "limits.torque" => force * at.v,
                        "limits.power" => force * at.v * speed,
                        "limits.torque_rate" => mass * speed * speed * at.j * at.v + force * at.a,
                        _ => 0.0,
                    };
                    most = most.max(load.abs());
                    least = least.min(force);
                }
            }
            assert!(least >= -1e-6, "{key} {count}: contact force {least} N");
            let name = key.trim_start_matches("limits.");
            let check = design
                .checks
                .iter()
                .find(|c| c.name.name() == name)
                .unwrap();
            let own = if key == "limits.force_min" {
                least
            } else {
                most
            };
            // The extreme lies between the angles, and not far from one.
            let above = match key {
                "limits.force_min" => own - check.worst,
                _ => check.worst.abs() - own,
            };
            assert!(
                above >= -1e-9 * own && above < 1e-3 * own,
                "{key} {count}: {own} {check:?}"
            );
            if design.infeasible.is_none() {
                assert!(check.pass, "{key} {count}: {check:?}");
                built += 1;
            }
        }
    }
    assert!(built >= 12, "{built} of 16 were built");
}

/// Pressure of every walker's machine on the emitted cam, from law, mass, speed and base radius only, and the curvature.
#[test]
fn the_checks_are_those_of_the_emitted_cam_where_its_size_is_automatic() {
    use gaitcam::dynamics::hertz::{STEEL, modulus};
    let mut built = 0;
    for (count, bound) in [(5, "300 MPa"), (20, "250 MPa"), (60, "400 MPa")] {
        for (family, robust) in [("harmonic", "mean"), ("spline", "worst")] {
            let scene = with(&[
                ("law.family", family),
                ("law.robust", robust),
                ("limits.hertz_pressure", bound),
                ("cam.bore", "12 mm"),
                ("accuracy.rms", "none"),
            ]);
            let mut people = people(count, 4, 0.3);
            let mut random = Random((count as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            for (walker, _) in &mut people {
                let factor = 0.6 + random.next();
                let force = walker.curve.force_n.iter().map(|f| factor * f).collect();
                walker.curve = walker.curve.with_forces(force);
            }
            let design = scene.design_for(&force(&people)).unwrap();
            let (law, base) = (&design.cam.law, design.cam.follower.base_radius());
            let unit =
                modulus(STEEL, STEEL) / (std::f64::consts::PI * design.problem.cam.thickness);
            let mut worst = 0.0_f64;
            for walker in &design.population.as_ref().unwrap().each {
                let (mass, speed) = (walker.mass_kg, walker.speed_rad_per_s);
                for i in 0..3600 {
                    let at = law.svaj(TAU * f64::from(i) / 3600.0);
                    let force = mass * (9.81 + speed * speed * at.a);
                    worst = worst.max(unit * force / (base + at.s + at.a));
                }
            }
            let check = |name: &str| {
                let named = |c: &&gaitcam::cam::Check| c.name.name() == name;
                design.checks.iter().find(named).unwrap()
            };
            let pressure = check("hertz_pressure");
            let part = worst.sqrt() / pressure.worst;
            assert!(
                part < 1.0 + 1e-9 && part > 0.999,
                "{count}: {part} of {pressure:?}"
            );
            let convex = design.cam.curvature().convex.value;
            assert!(
                (check("curvature").worst / convex - 1.0).abs() < 1e-9,
                "{count}: {convex}"
            );
            built += usize::from(design.infeasible.is_none() && pressure.pass);
        }
    }
    assert!(built >= 4, "{built} of 6 were built");
}

#[test]
fn settings_without_a_form_for_several_walkers_are_refused_with_their_key() {
    let people = people(3, 4, 0.3);
    let flexible = ("machine.natural_frequency", "12 Hz");
    let cases: [(&[(&str, &str)], &str); 3] = [
        (&[("gait.band", "20 N")], "gait.band"),
        (
            &[flexible, ("law.degree", "7"), ("law.polydyne", "true")],
            "law.polydyne",
        ),
        (
            &[("drive.mass", "70 kg"), ("gait.adjust", "mass")],
            "gait.adjust",
        ),
    ];
    for (changes, key) in cases {
        let error = with(changes).design_for(&force(&people)).unwrap_err();
        assert!(error.to_string().contains(key), "{error}");
    }
}

/// Cycles of one shape with different phases. With a phase for each walker, all have the error of one cycle, and the bound proves optimality.
#[test]
fn phases_that_are_set_for_each_walker_bring_cycles_of_one_shape_into_step() {
    let [(first, _)] = <[_; 1]>::try_from(people(1, 4, 0.3)).unwrap();
    let turned = |i: u32| {
        let curve = first.curve.begun_at(0.4 * f64::from(i));
        Walker::new(&format!("W{i}"), curve)
    };
    let force = ForceCurve::of_walkers((0..5).map(turned).collect()).unwrap();
    let at_worst = [
        ("law.family", "harmonic"),
        ("law.harmonics", "2"),
        ("law.robust", "worst"),
    ];
    let alone = with(&at_worst).design_for(&first.curve).unwrap();
    let fixed = with(&at_worst)
        .design_for(&force)
        .unwrap()
        .population
        .unwrap();
    let scene = with(&at_worst)
        .with("gait.adjust", "mass, speed, phase")
        .unwrap();
    let own = scene.design_for(&force).unwrap().population.unwrap();
    let percent = alone.force.rms_error_percent_of_mean;
    assert!(
        fixed.worst_percent > 2.0 * percent,
        "{} {percent}",
        fixed.worst_percent
    );
    assert!(
        (own.worst_percent / percent - 1.0).abs() < 1e-3,
        "{} {percent}",
        own.worst_percent
    );
    assert!(own.bound_percent.unwrap() <= own.worst_percent);
    assert_eq!(fixed.bound_percent, None);
}

#[test]
fn what_would_help_several_walkers_is_their_own_error() {
    let scene = with(&[
        ("gait.step_frequency", "1.4 Hz:2.4 Hz:5"),
        ("law.robust", "worst"),
        ("accuracy.rms", "0.5 %"),
        ("law.family", "spline"),
        ("law.spans", "16"),
    ]);
    let design = scene.design().unwrap().relaxed();
    let [only] = &design.relaxations[..] else {
        panic!("{:?}", design.relaxations);
    };
    assert_eq!(only.key, "accuracy.rms");
    let worst = design.population.as_ref().unwrap().worst_percent;
    let to = 100.0 * only.to.unwrap();
    assert!(to >= worst && to < 1.01 * worst, "{to} {worst}");
    assert!(
        design
            .notes
            .iter()
            .all(|n| !format!("{n:?}").contains("accuracy.rms"))
    );
}

/// One of three walkers has an eighth harmonic, and the mean has a third of it. This is small enough for the few spans that the mean needs.
#[test]
fn spans_left_open_are_those_that_the_worst_walker_needs() {
    let person = |i: usize| {
        let high = if i == 2 { 0.02 } else { 0.0 };
        let at = |j: usize| {
            let x = TAU * j as f64 / 1024.0;
            700.0 * (1.0 + 0.3 * x.sin() + high * (8.0 * x).sin())
        };
        let curve = ForceCurve::from_samples("", 0.5, (0..1024).map(at).collect()).unwrap();
        Walker::new(&format!("W{i}"), curve)
    };
    let force = ForceCurve::of_walkers((0..3).map(person).collect()).unwrap();
    let usual = [("law.family", "spline"), ("accuracy.rms", "none")];
    let size = |robust: &str, spans: &str| {
        let scene = with(&usual).with("law.robust", robust).unwrap();
        let design = scene
            .with("law.spans", spans)
            .unwrap()
            .design_for(&force)
            .unwrap();
        let own = design.population.unwrap();
        (design.cam.law.breaks().len() - 1, own.worst_percent)
    };
    let (of_mean, _) = size("mean", "auto");
    let (few, many) = (size("worst", &of_mean.to_string()).1, size("worst", "60").1);
    assert!(many < 0.8 * few, "{many} {few}");
    let (of_worst, error) = size("worst", "auto");
    assert!(
        of_worst > of_mean && error < 1.05 * many,
        "{of_worst} {of_mean}: {error} {many}"
    );
}

/// A spring drive with mass and preload only differs by one factor at another speed, like a hydraulic drive. With mass and spring together this does
/// not hold.
#[test]
fn the_speed_is_set_for_each_walker_on_every_drive_that_allows_it() {
    let mass = [
        ("drive.kind", "fixed-axis"),
        ("drive.mass", "60 kg"),
        ("drive.preload", "700 N"),
    ];
    let spring = [mass[0], mass[1], mass[2], ("drive.spring_rate", "20 N/mm")];
    let chamber = [
        ("drive.piston_radius", "20 mm"),
        ("drive.pressure_per_volume", "1e10 Pa/m^3"),
        ("drive.kind", "hydraulic"),
    ];
    let common = [
        ("gait.step_frequency", "1.5 Hz:2.2 Hz:5"),
        ("law.robust", "worst"),
        ("accuracy.rms", "none"),
    ];
    let design = |drive: &[(&str, &str)], speed: Option<&str>| {
        let given = speed.map(|s| ("drive.speed", s));
        let mut table = scene::built_in("footbridge")
            .unwrap()
            .scene()
            .unwrap()
            .to_table();
        for (key, value) in drive.iter().chain(&common).chain(&given) {
            scene::set(&mut table, &format!("{key}={value}")).unwrap();
        }
        let scene = scene::read(&table).unwrap();
        gaitcam::synth::synthesise(&scene, scene.model_force().unwrap().as_ref()).unwrap()
    };
    for (drive, is_set) in [(&mass[..], true), (&chamber, true), (&spring, false)] {
        let free = design(drive, None);
        let speeds: Vec<f64> = (free.problem.walkers.as_ref().unwrap().each.iter())
            .map(|w| w.drive.speed)
            .collect();
        assert_eq!(
            (speeds[0] / speeds[4] - 1.5 / 2.2).abs() < 1e-9,
            is_set,
            "{speeds:?}"
        );
        let fixed = design(drive, Some("11.6 rad/s"));
        let worst = |d: &gaitcam::synth::Design| d.population.as_ref().unwrap().worst_percent;
        let [free, fixed] = [worst(&free), worst(&fixed)];
        assert!(!is_set || free <= fixed + 1e-6, "{free} {fixed}");
    }
}
