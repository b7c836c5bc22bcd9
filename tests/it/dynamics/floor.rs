//! Laws for a moving floor, and the steady motion of the floor.

use std::f64::consts::TAU;

use gaitcam::cam::Verdict;
use gaitcam::dynamics::{Floor, FloorMode, FloorMotion, Model, simulate};
use gaitcam::synth::Design;
use gaitcam::{Scene, scene};

const KEY: &str = "machine.floor.damping";

fn with(changes: &[(&str, &str)]) -> gaitcam::error::Result<Scene> {
    let mut table = scene::built_in("footbridge")?.scene()?.to_table();
    for (key, value) in changes {
        scene::set(&mut table, &format!("{key}={value}"))?;
    }
    scene::read(&table)
}

fn bridge<'a>(mass: &'a str, frequency: &'a str, damping: &'a str) -> Vec<(&'a str, &'a str)> {
    vec![
        ("machine.floor.mass", mass),
        ("machine.floor.frequency", frequency),
        ("machine.floor.damping", damping),
    ]
}

fn design(changes: &[(&str, &str)]) -> Design {
    with(changes).unwrap().design().unwrap()
}

fn mode(mass: f64, frequency: f64, damping: f64) -> FloorMode {
    FloorMode {
        mass,
        frequency,
        damping,
        ordinate: 1.0,
        key: KEY,
    }
}

/// Velocity and acceleration over the last of many turns, from angle 0. The modes under the inertia of the shaker and the force of the others are
/// integrated by the Runge-Kutta method of order 4. By F = M (g + d″ + z″), M φ² is part of the modal mass.
fn integrated(
    modes: &[FloorMode],
    mass: f64,
    omega: f64,
    still: impl Fn(f64) -> f64,
) -> Vec<[f64; 2]> {
    const STEPS: usize = 4000;
    let [m] = modes else { panic!("one mode") };
    let own = TAU * m.frequency;
    let slope = |t: f64, y: [f64; 2]| {
        let force = still(omega * t);
        let a = (-force / (m.mass + mass))
            - m.mass / (m.mass + mass) * (2.0 * m.damping * own * y[1] + own * own * y[0]);
        [y[1], a]
    };
    let h = TAU / omega / STEPS as f64;
    let (mut y, mut last) = ([0.0; 2], Vec::new());
    // Until e^(−2πζ n) is 1e-11.
    for turn in 0..(4.0 / m.damping) as usize {
        last.clear();
        for i in 0..STEPS {
            let t = h * (turn * STEPS + i) as f64;
            last.push(slope(t, y));
            let add = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let k1 = slope(t, y);
            let k2 = slope(t + 0.5 * h, add(y, k1, 0.5 * h));
            let k3 = slope(t + 0.5 * h, add(y, k2, 0.5 * h));
            let k4 = slope(t + h, add(y, k3, h));
            for j in 0..2 {
                y[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
            }
        }
    }
    last
}

#[test]
fn the_steady_motion_is_that_of_an_integration_over_time() {
    let floor = Floor {
        modes: vec![mode(3000.0, 1.9, 0.02)],
        walkers: vec![(0.0, 1.0)],
    };
    let (mass, omega) = (71.0, TAU * 1.85);
    let still = |x: f64| 230.0 * x.cos() + 40.0 * (2.0 * x).sin() + 15.0 * (3.0 * x).cos();
    let own = [(230.0, 0.0), (0.0, 40.0), (15.0, 0.0)];
    let none = [(0.0, 0.0); 3];
    let pressed = floor.pressed(mass, omega, &own, &none).unwrap();
    let motion = FloorMotion::of(&floor.acceleration(omega, &pressed).unwrap());
    moves_as(motion, &integrated(&floor.modes, mass, omega, still));
}

/// Asserts that the floor moves as in `rows`. The peaks of two samplings of a turn at 4000 points differ by 1e-6.
fn moves_as(motion: FloorMotion, rows: &[[f64; 2]]) {
    let peak = rows.iter().fold(0.0_f64, |m, x| m.max(x[1].abs()));
    let rms = mean(rows, |x| x[1] * x[1]).sqrt();
    let [own_peak, own_rms] = [
        motion.acceleration_peak_m_per_s2,
        motion.acceleration_rms_m_per_s2,
    ];
    assert!((own_peak / peak - 1.0).abs() < 1e-5, "{own_peak} {peak}");
    assert!((own_rms / rms - 1.0).abs() < 1e-6, "{own_rms} {rms}");
}

fn mean(rows: &[[f64; 2]], of: impl Fn(&[f64; 2]) -> f64) -> f64 {
    rows.iter().map(of).sum::<f64>() / rows.len() as f64
}

#[test]
fn limits_of_the_force_hold_for_the_true_force_on_the_moving_floor() {
    for (mass, frequency, damping) in [
        ("10000 kg", "1.85 Hz", "0.01"),
        ("1500 kg", "2 Hz", "0.01"),
        ("10000 kg", "1.85 Hz", "0.004"),
    ] {
        let mut changes = bridge(mass, frequency, damping);
        changes.extend([
            ("limits.force_min", "600 N"),
            ("limits.stroke", "200 mm"),
            ("accuracy.rms", "none"),
        ]);
        let found = design(&changes);
        assert_eq!(found.verdict, Verdict::Acceptable, "{mass} {damping}");
        let floor = found.problem.machine.floor().unwrap();
        let (drive, law) = (found.problem.drive, &found.cam.law);
        let still = |x: f64| drive.force(law.svaj(x));
        let rows = integrated(&floor.modes, drive.mass, drive.speed, still);
        let forces = rows.iter().enumerate().map(|(i, x)| {
            let angle = TAU * i as f64 / rows.len() as f64;
            still(angle) + drive.mass * x[1]
        });
        let low = forces.fold(f64::INFINITY, f64::min);
        assert!((low - 600.0).abs() < 1e-3, "{low}");
        moves_as(found.floor.unwrap(), &rows);
    }
}

/// Harmonics of the force of a harmonic law on the moving floor, N, from one frequency response each.
fn felt(floor: &Floor, mass: f64, omega: f64, law: &[(f64, f64)], count: usize) -> Vec<(f64, f64)> {
    let mut still = vec![(0.0, 0.0); count];
    for (n, (own, (a, b))) in (1..).zip(still.iter_mut().zip(law)) {
        let size = -mass * (f64::from(n) * omega).powi(2);
        *own = (size * a, size * b);
    }
    floor
        .pressed(mass, omega, &still, &vec![(0.0, 0.0); count])
        .unwrap()
}

/// Maximum of a sum of harmonics.
fn highest(terms: &[(f64, f64)]) -> f64 {
    let at = |i: i32| {
        let x = TAU * f64::from(i) / 1440.0;
        let wave = |(n, (a, b)): (i32, &(f64, f64))| {
            let (sine, cosine) = (f64::from(n) * x).sin_cos();
            a * cosine + b * sine
        };
        (1..).zip(terms).map(wave).sum::<f64>()
    };
    (0..1440).map(at).fold(f64::MIN, f64::max)
}

/// None of the random harmonic laws within the limit has a smaller force error on the floor that it moves.
#[test]
fn the_best_law_is_that_on_the_floor_that_responds_to_it() {
    for (mass, frequency, damping, key, limit) in [
        ("3000 kg", "3.6 Hz", "0.01", "limits.jerk", 40.0),
        ("1500 kg", "2 Hz", "0.02", "limits.jerk", 40.0),
        ("2000 kg", "1.7 Hz", "0.01", "limits.jerk", 60.0),
        ("1500 kg", "2 Hz", "0.02", "limits.force_max", 900.0),
        ("2000 kg", "3.6 Hz", "0.01", "limits.force_max", 850.0),
    ] {
        let of_force = key == "limits.force_max";
        let text = format!("{limit} {}", if of_force { "N" } else { "m/s^3" });
        let mut changes = bridge(mass, frequency, damping);
        changes.extend([
            ("law.family", "harmonic"),
            ("law.harmonics", "3"),
            (key, text.as_str()),
            ("accuracy.rms", "none"),
        ]);
        let found = design(&changes);
        assert!(found.solver.certified, "{mass} {:?}", found.solver.doubt);
        let floor = found.problem.machine.floor().unwrap();
        let (mass, omega) = (found.problem.drive.mass, found.problem.drive.speed);
        let curve = found.problem.target_in_time().unwrap();
        let own: Vec<(f64, f64)> = (found.coefficients[1..].chunks_exact(2))
            .map(|c| (c[0], c[1]))
            .collect();
        let target: Vec<(f64, f64)> = (1..=8)
            .map(|n| {
                let part = |i: i32| {
                    let x = TAU * f64::from(i) / 4096.0;
                    let (sine, cosine) = (f64::from(n) * x).sin_cos();
                    let force = curve.at(x) / 2048.0;
                    (force * cosine, force * sine)
                };
                let parts = (0..4096).map(part);
                parts.fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1))
            })
            .collect();
        let of = |law: &[(f64, f64)]| {
            let forces = felt(&floor, mass, omega, law, target.len());
            let square =
                |(f, t): (&(f64, f64), &(f64, f64))| (f.0 - t.0).powi(2) + (f.1 - t.1).powi(2);
            (0.5 * forces.iter().zip(&target).map(square).sum::<f64>()).sqrt()
        };
        let least = of(&own);
        assert!(
            (least / found.force.rms_error_n - 1.0).abs() < 1e-6,
            "{least}"
        );
        // Both grow with the law, which the walker's weight is not part of.
        let used = |law: &[(f64, f64)]| match of_force {
            true => highest(&felt(&floor, mass, omega, law, law.len())) / (limit - 700.0),
            false => {
                let third = |(n, (a, b)): (i32, &(f64, f64))| {
                    let factor = (f64::from(n) * omega).powi(3) / limit;
                    (-factor * b, factor * a)
                };
                let jerk: Vec<(f64, f64)> = (1..).zip(law).map(third).collect();
                let other: Vec<(f64, f64)> = jerk.iter().map(|(a, b)| (-a, -b)).collect();
                highest(&jerk).max(highest(&other))
            }
        };
        assert!((used(&own) - 1.0).abs() < 1e-3, "{key} {}", used(&own));
        let mut seed = 7_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
        };
        let length = own[0].0.hypot(own[0].1);
        let mut nearest = f64::INFINITY;
        for trial in 0..4000 {
            let size = length * 10_f64.powi(-1 - trial % 4);
            let other: Vec<(f64, f64)> = (own.iter())
                .map(|(a, b)| (a + size * draw(), b + size * draw()))
                .collect();
            let kept = used(&other).recip().min(1.0);
            let other: Vec<(f64, f64)> = other.iter().map(|(a, b)| (kept * a, kept * b)).collect();
            nearest = of(&other).min(nearest);
        }
        assert!(nearest > least * (1.0 - 1e-5), "{nearest} {least}");
        assert!(nearest < least * 1.001, "{nearest} {least}");
    }
}

/// The minimum jerk at a given accuracy falls by the multiplier of the accuracy, which includes the response of the floor.
#[test]
fn easing_the_accuracy_on_a_floor_buys_what_its_multiplier_promises() {
    let of = |accuracy: &str| {
        let mut changes = bridge("2000 kg", "3.6 Hz", "0.01");
        changes.extend([
            ("law.family", "spline"),
            ("law.spans", "12"),
            ("law.minimise", "jerk"),
            ("accuracy.rms", accuracy),
        ]);
        design(&changes)
    };
    let (own, eased) = (of("3 %"), of("3.03 %"));
    assert!(own.solver.certified && eased.solver.certified);
    let [own, eased] = [&own, &eased].map(|d| &d.easing[0]);
    let part = (own.before - eased.before) / (own.before - own.after);
    // Of second order in the change.
    assert!((part - 1.0).abs() < 0.01, "{part}");
}

#[test]
fn limits_by_time_are_those_of_the_law_on_a_moving_floor() {
    for (order, key, unit, limit) in [
        (1, "limits.velocity", "m/s", 0.2),
        (2, "limits.acceleration", "m/s^2", 3.0),
        (3, "limits.jerk", "m/s^3", 40.0),
    ] {
        let text = format!("{limit} {unit}");
        let mut changes = bridge("10000 kg", "1.85 Hz", "0.01");
        changes.extend([(key, text.as_str()), ("accuracy.rms", "none")]);
        let found = design(&changes);
        assert_eq!(found.verdict, Verdict::Acceptable, "{key}");
        let (low, high) = found.cam.law.extremes(order);
        let largest = high.value.max(-low.value) * found.problem.drive.speed.powi(order as i32);
        assert!((largest / limit - 1.0).abs() < 1e-6, "{key}: {largest}");
    }
}

#[test]
fn the_shaft_works_as_much_as_the_damping_of_the_floor_uses() {
    let found = design(&bridge("10000 kg", "1.85 Hz", "0.01"));
    let run = found
        .emitted(&found.problem.machine, found.problem.drive)
        .unwrap();
    let worked = simulate(&run, Model::Auto).unwrap().torque.mean * found.problem.drive.speed;
    let drive = found.problem.drive;
    let floor = found.problem.machine.floor().unwrap();
    let [m] = floor.modes[..] else { panic!() };
    let still = |x: f64| drive.force(found.cam.law.svaj(x));
    let rows = integrated(&floor.modes, drive.mass, drive.speed, still);
    let lost = 2.0 * m.damping * TAU * m.frequency * m.mass * mean(&rows, |x| x[0] * x[0]);
    assert!((worked / lost - 1.0).abs() < 1e-9, "{worked} {lost}");
}

#[test]
fn the_resonance_curve_shows_a_peak_that_is_narrower_than_its_steps() {
    let mut changes = bridge("10000 kg", "1.8537 Hz", "0.0003");
    changes.push(("limits.stroke", "2 m"));
    let found = design(&changes);
    let curve = found.resonance();
    let top = curve.iter().max_by(|a, b| {
        a.motion
            .acceleration_rms_m_per_s2
            .total_cmp(&b.motion.acceleration_rms_m_per_s2)
    });
    let top = top.unwrap();
    let first = 700.0 * 0.37 * (1.85 - 0.95) / (2.0 * 0.0003 * 1e4);
    let rms = top.motion.acceleration_rms_m_per_s2 * 2_f64.sqrt();
    assert!((top.step_frequency - 1.8537).abs() < 1e-9 && (rms / first - 1.0).abs() < 1e-3);
}

#[test]
fn the_resonance_curve_of_the_cam_is_that_of_simulations_at_other_speeds() {
    let found = design(&bridge("10000 kg", "1.7 Hz", "0.01"));
    let curve = found.resonance();
    for at in curve.iter().step_by(23) {
        let mut drive = found.problem.drive;
        drive.speed *= at.step_frequency / 1.85;
        let run = found.emitted(&found.problem.machine, drive).unwrap();
        let moved = simulate(&run, Model::Rigid).unwrap().floor.unwrap();
        let [own, other] = [at.of_cam, moved].map(|m| m.acceleration_rms_m_per_s2);
        assert!(
            (own / other - 1.0).abs() < 1e-5,
            "{} {own} {other}",
            at.step_frequency
        );
    }
}

#[test]
fn only_the_rigid_model_has_a_floor() {
    let found = design(&bridge("10000 kg", "1.85 Hz", "0.01"));
    let run = found
        .emitted(&found.problem.machine, found.problem.drive)
        .unwrap();
    for model in [Model::Contact, Model::Flexible] {
        let error = simulate(&run, model).unwrap_err();
        assert!(error.place.to_string().contains("machine.floor"));
    }
    let out = simulate(&run, Model::Rigid).unwrap();
    assert!(out.floor.is_some() && out.liftoff_speed.is_none());
    let report = found.machine();
    assert!(report.torque_max_n_m.is_some());
    assert_eq!(report.liftoff_speed_rad_per_s, None);
    // Of the true force, as simulated.
    let (own, run) = (report.hertz_pressure_max_pa.unwrap(), out.hertz.unwrap());
    assert!((own / run.contact.pressure - 1.0).abs() < 1e-4, "{own}");
}

#[test]
fn one_mode_in_resonance_moves_by_the_force_over_twice_damping_and_stiffness() {
    let (m, hz, zeta, force) = (8000.0, 2.1, 0.006, 250.0);
    let floor = Floor {
        modes: vec![mode(m, hz, zeta)],
        walkers: vec![(0.0, 1.0)],
    };
    let omega = TAU * hz;
    let (a, b) = floor.acceleration(omega, &[(force, 0.0)]).unwrap()[0];
    let moved = a.hypot(b) / (omega * omega);
    let stiffness = m * omega * omega;
    assert!((moved / (force / (2.0 * zeta * stiffness)) - 1.0).abs() < 1e-12);
    // Downwards and a quarter of a turn late: z = −F/(2ζk) sin Ωt, z″ = F/(2ζm) sin Ωt.
    assert!(a.abs() < 1e-12 && b > 0.0);
}

#[test]
fn the_power_put_into_the_floor_is_what_its_damping_uses() {
    let modes = vec![mode(3000.0, 1.9, 0.02), mode(5000.0, 4.3, 0.01)];
    let floor = Floor {
        modes: modes.clone(),
        walkers: vec![(0.0, 1.0)],
    };
    let omega = TAU * 1.85;
    let force = [(230.0, 20.0), (-7.0, 40.0), (15.0, 3.0)];
    let answer = floor.acceleration(omega, &force).unwrap();
    let single = |m: &FloorMode| Floor {
        modes: vec![*m],
        walkers: Vec::new(),
    };
    let (mut power, mut lost) = (0.0, 0.0);
    for n in 1..=3 {
        let w = n as f64 * omega;
        // Velocity: of a cos + b sin as acceleration (a sin − b cos)/w.
        let ((a, b), (c, s)) = (answer[n - 1], force[n - 1]);
        power -= 0.5 * (-b * c + a * s) / w;
        for m in &modes {
            let (a, b) = single(m).acceleration(omega, &force).unwrap()[n - 1];
            let velocity = a.hypot(b) / w;
            lost += m.mass * m.damping * TAU * m.frequency * velocity * velocity;
        }
    }
    assert!(
        lost > 1.0 && (power / lost - 1.0).abs() < 1e-9,
        "{power} {lost}"
    );
}

#[test]
fn a_floor_of_endless_mass_is_no_floor() {
    let still = design(&[]);
    let heavy = design(&bridge("1e12 kg", "1.9 Hz", "0.01"));
    assert_eq!(heavy.verdict, still.verdict);
    assert!((heavy.force.rms_error_n - still.force.rms_error_n).abs() < 1e-6);
    for i in 0..50 {
        let x = TAU * f64::from(i) / 50.0;
        assert!((heavy.cam.law.svaj(x).s - still.cam.law.svaj(x).s).abs() < 1e-9);
    }
    let motion = heavy.floor.unwrap();
    assert!(motion.acceleration_peak_m_per_s2 < 1e-7 && motion.comfort.setra() == "maximum");
}

#[test]
fn the_force_on_the_moving_floor_is_the_wanted_one() {
    for (mass, frequency, damping) in [
        ("10000 kg", "1.85 Hz", "0.01"),
        ("2000 kg", "1.7 Hz", "0.02"),
        ("3000 kg", "3.8 Hz", "0.005"),
    ] {
        let changes = bridge(mass, frequency, damping);
        let found = design(&changes);
        let percent = found.force.rms_error_percent_of_mean;
        assert_eq!(found.verdict, Verdict::Acceptable, "{mass} {frequency}");
        let run = found
            .emitted(&found.problem.machine, found.problem.drive)
            .unwrap();
        let out = simulate(&run, Model::Auto).unwrap();
        let simulated = 100.0 * out.force.rms_error.unwrap() / found.force.mean_n;
        assert!((simulated - percent).abs() < 0.01, "{simulated} {percent}");
        let (own, run) = (found.floor.unwrap(), out.floor.unwrap());
        let ratio = run.acceleration_peak_m_per_s2 / own.acceleration_peak_m_per_s2;
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
        // The law for a stiff floor misses there.
        let still = design(&[]);
        let run = still
            .emitted(&found.problem.machine, still.problem.drive)
            .unwrap();
        let missed = simulate(&run, Model::Auto)
            .unwrap()
            .force
            .rms_error
            .unwrap();
        println!(
            "{mass} {frequency}: {percent} % corrected, {} % not, {own:?}",
            100.0 * missed / still.force.mean_n
        );
        assert!(100.0 * missed / still.force.mean_n > 2.0 * percent);
    }
}

#[test]
fn the_shaker_feels_the_floor_in_harmonics_that_only_the_others_press() {
    let floor = Floor {
        modes: vec![mode(3000.0, 3.8, 0.005), mode(20_000.0, 7.1, 0.02)],
        walkers: vec![(0.0, 1.0), (1.0, 1.0)],
    };
    let (mass, speed) = (71.4, 11.62);
    let others = [(280.0, 30.0), (-70.0, 12.0), (40.0, -9.0), (8.0, 21.0)];
    for count in 0..=4 {
        let own = |n: usize| {
            if n < count {
                300.0 / (n + 1) as f64
            } else {
                1e-15
            }
        };
        let still: Vec<(f64, f64)> = (0..4).map(|n| (own(n), -0.4 * own(n))).collect();
        let pressed = floor.pressed(mass, speed, &still, &others).unwrap();
        let sum = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 + b.0, a.1 + b.1);
        let all: Vec<(f64, f64)> = pressed.iter().zip(&others).map(sum).collect();
        let moved = floor.acceleration(speed, &all).unwrap();
        // F = P + M z″.
        for ((f, p), z) in pressed.iter().zip(&still).zip(&moved) {
            let off = [f.0 - p.0 - mass * z.0, f.1 - p.1 - mass * z.1];
            assert!(off[0].hypot(off[1]) < 1e-9, "{count}: {off:?}");
        }
    }
}

#[test]
fn walkers_in_step_add_and_walkers_half_a_turn_apart_cancel_the_first_harmonic() {
    let peak = |count: &str, phases: &str| {
        let mut changes = bridge("50000 kg", "1.85 Hz", "0.01");
        changes.extend([
            ("machine.walkers.count", count),
            ("machine.walkers.phases", phases),
        ]);
        let motion = design(&changes).floor.unwrap();
        motion.acceleration_peak_m_per_s2
    };
    let one = design(&bridge("50000 kg", "1.85 Hz", "0.01"))
        .floor
        .unwrap();
    let one = one.acceleration_peak_m_per_s2;
    assert!((peak("3", "0 deg, 0 deg, 0 deg") / one - 3.0).abs() < 0.02);
    let mut heavier = bridge("50000 kg", "1.85 Hz", "0.01");
    heavier.extend([
        ("machine.walkers.count", "2"),
        ("machine.walkers.phases", "0 deg, 0 deg"),
        ("machine.walkers.weights", "700 N, 1400 N"),
    ]);
    let both = design(&heavier).floor.unwrap();
    assert!(
        (both.acceleration_peak_m_per_s2 / peak("3", "0 deg, 0 deg, 0 deg") - 1.0).abs() < 1e-9
    );
    assert!(peak("2", "0 deg, 180 deg") < 0.2 * one);
}

#[test]
fn the_classes_change_at_the_accelerations_of_the_guides() {
    for (peak, class, setra) in [
        (0.49, "CL1", "maximum"),
        (0.51, "CL2", "mean"),
        (1.01, "CL3", "minimum"),
        (2.51, "CL4", "unacceptable"),
    ] {
        let motion = FloorMotion::of(&[(0.0, peak)]);
        assert!((motion.acceleration_rms_m_per_s2 - peak / 2_f64.sqrt()).abs() < 1e-12);
        let of = (motion.comfort.hivoss(), motion.comfort.setra());
        assert_eq!(of, (class, setra));
    }
    assert!(
        (FloorMotion::of(&[(1.0, 0.0), (0.5, 0.0)]).acceleration_peak_m_per_s2 - 1.5).abs() < 1e-9
    );
}

#[test]
fn a_floor_that_cannot_be_is_refused_with_its_key() {
    let refused = |changes: &[(&str, &str)]| {
        let error = with(changes).and_then(|s| s.design()).unwrap_err();
        (error.place.to_string(), error.to_string())
    };
    let (place, said) = refused(&bridge("10000 kg", "1.85 Hz", "0"));
    assert!(
        place.contains("machine.floor.damping") && said.contains("1.85 Hz"),
        "{place} {said}"
    );
    let (place, _) = refused(&[("machine.floor.mass", "10000 kg")]);
    assert!(place.contains("machine.floor.frequency"), "{place}");
    let mut phases = bridge("10000 kg", "1.85 Hz", "0.01");
    phases.extend([
        ("machine.walkers.count", "3"),
        ("machine.walkers.phases", "0 deg, 10 deg"),
    ]);
    assert!(refused(&phases).0.contains("machine.walkers.phases"));
    let mut weights = bridge("10000 kg", "1.85 Hz", "0.01");
    weights.extend([
        ("machine.walkers.count", "2"),
        ("machine.walkers.weights", "700 N, -1 N"),
    ]);
    assert!(refused(&weights).0.contains("machine.walkers.weights"));
    let modes = "[{ mass = \"1e4 kg\", frequency = \"5 Hz\", damping = 0.01 }, \
                 { mass = \"1e4 kg\", frequency = \"3.7 Hz\", damping = 0 }]";
    let (place, said) = refused(&[("machine.floor.mode", modes)]);
    assert!(place.contains("machine.floor.mode.2.damping") && said.contains("3.7 Hz"));
}
