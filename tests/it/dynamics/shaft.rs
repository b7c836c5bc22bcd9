//! The shaft under its motor, compared with closed forms and an independent integration in time.

use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::{Drive, Motor, TorqueLine};
use gaitcam::dynamics::{Model, Outcome, Run, Shaft, simulate};
use gaitcam::law::Law;
use std::f64::consts::TAU;

fn motor(slope: f64, inertia: f64) -> Motor {
    Motor {
        line: TorqueLine::Slope(slope),
        nominal: None,
        inertia,
        friction: 0.0,
        gear: 1.0,
        efficiency: 1.0,
    }
}

/// Law of two harmonics with a block of 70 kg.
fn shaker(follower: Follower) -> Run {
    let law = Law::harmonic(0.03, &[(0.004, 0.02), (0.002, -0.001)]);
    let cam = Cam::new(law, follower).unwrap();
    Run::new(cam, Drive::moving_axis(70.0, 9.81, TAU * 1.85), 1440)
}

fn flat() -> Run {
    shaker(Follower::FlatTranslating { base_radius: 0.05 })
}

fn run(run: &Run, motor: Motor) -> (Outcome, Shaft) {
    let mut run = run.clone();
    run.machine.motor = Some(motor);
    let out = simulate(&run, Model::Rigid).unwrap();
    let shaft = out.shaft.unwrap();
    (out, shaft)
}

/// Steady force at equal angles and mean speed from the law, by classical Runge-Kutta steps in time for θ and ω. The integrator is independent of the
/// product's.
fn in_time(run: &Run, motor: &Motor, no_load: f64, mut omega: f64, rows: usize) -> (Vec<f64>, f64) {
    let (law, drive, mu) = (&run.cam.law, &run.drive, run.machine.friction);
    let reach = match run.cam.follower {
        Follower::FlatTranslating { base_radius } => base_radius,
        _ => 0.0,
    };
    // Under a flat face T = F v + μ F (Rb + s).
    let rates = |[theta, w]: [f64; 2]| {
        let at = law.svaj(theta);
        let arm = at.v
            + if reach > 0.0 {
                mu * (reach + at.s)
            } else {
                0.0
            };
        let still = drive.rest_force + drive.spring_rate * at.s + drive.damping * w * at.v;
        let still = still + drive.mass * w * w * at.a;
        let torque = motor.torque(w, no_load)[0] - motor.friction - arm * still;
        let rate = torque / (motor.inertia + arm * drive.mass * at.v);
        ([w, rate], still + drive.mass * at.v * rate)
    };
    let mut theta = 0.0;
    let (mut forces, mut time) = (vec![0.0; rows], 0.0);
    let fine = 8;
    for turn in 0..400 {
        let first = omega;
        time = 0.0;
        for (row, force) in forces.iter_mut().enumerate() {
            *force = rates([theta, omega]).1;
            // A step of time to the next angle, found by two corrections, then split evenly.
            let goal = TAU * (row + 1) as f64 / rows as f64;
            let mut span = (goal - theta) / omega;
            for round in 0..6 {
                let mut state = [theta, omega];
                let h = span / f64::from(fine);
                for _ in 0..fine {
                    let add = |k: [f64; 2], f: f64| [state[0] + f * k[0], state[1] + f * k[1]];
                    let k1 = rates(state).0;
                    let k2 = rates(add(k1, 0.5 * h)).0;
                    let k3 = rates(add(k2, 0.5 * h)).0;
                    let k4 = rates(add(k3, h)).0;
                    let mean = |i: usize| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0;
                    state = [state[0] + h * mean(0), state[1] + h * mean(1)];
                }
                if round == 5 {
                    time += span;
                    (theta, omega) = (goal, state[1]);
                } else {
                    span += (goal - state[0]) / state[1];
                }
            }
        }
        theta = 0.0;
        if turn > 3 && (omega - first).abs() < 1e-12 * omega {
            break;
        }
    }
    (forces, TAU / time)
}

#[test]
fn the_motion_is_that_of_an_independent_integration_in_time() {
    let spring = |mut run: Run| {
        run.drive = Drive {
            rest_force: 400.0,
            damping: 60.0,
            ..Drive::fixed_axis(20.0, 5000.0, 9.0)
        };
        run
    };
    let knife = Follower::RollerTranslating {
        prime_radius: 0.06,
        offset: 0.005,
        roller_radius: 0.0,
    };
    let rubbing = |mut run: Run| {
        run.machine.friction = 0.1;
        run
    };
    for (case, inertia, slope) in [
        (flat(), 0.5, 10.0),
        (flat(), 0.5, 2.0),
        (flat(), 2.0, 50.0),
        (spring(flat()), 0.3, 5.0),
        (rubbing(flat()), 0.5, 10.0),
        (shaker(knife), 0.5, 10.0),
    ] {
        let motor = Motor {
            friction: 1.5,
            ..motor(slope, inertia)
        };
        let (out, shaft) = run(&case, motor.clone());
        assert!(shaft.energy_balance.abs() < 1e-9, "{shaft:?}");
        let first = out.rows[0].speed;
        let (forces, mean) = in_time(&case, &motor, shaft.no_load_speed, first, 360);
        assert!((mean / case.drive.speed - 1.0).abs() < 1e-6, "{mean}");
        let weight = case.drive.rest_force;
        for (i, force) in forces.iter().enumerate() {
            let own = out.rows[4 * i].contact_force;
            assert!(
                (own - force).abs() < 1e-5 * weight,
                "{i} {own} {force} {shaft:?}"
            );
        }
    }
}

#[test]
fn every_follower_under_every_drive_turns_as_in_an_independent_integration_in_time() {
    let (arm, prime_radius, roller_radius) = (0.12, 0.07, 0.015);
    let (pivot_distance, offset, arc_radius) = (0.15, 0.005, 0.03);
    let followers = [
        Follower::FlatTranslating { base_radius: 0.05 },
        Follower::RollerTranslating {
            prime_radius,
            offset,
            roller_radius,
        },
        Follower::MushroomTranslating {
            prime_radius,
            offset,
            arc_radius,
        },
        Follower::RollerOscillating {
            pivot_distance,
            arm,
            prime_radius,
            roller_radius,
        },
        Follower::MushroomOscillating {
            pivot_distance,
            arm,
            prime_radius,
            arc_radius,
        },
        Follower::FlatOscillating {
            pivot_distance,
            face_offset: 0.0,
            base_radius: 0.05,
        },
        Follower::Barrel {
            radius: 0.08,
            roller_radius,
        },
    ];
    let law = Law::harmonic(0.03, &[(0.004, 0.02), (0.002, -0.001)]);
    let speed = TAU * 1.85;
    let drives = [
        Drive::moving_axis(70.0, 9.81, speed),
        Drive {
            rest_force: 400.0,
            damping: 60.0,
            ..Drive::fixed_axis(20.0, 5000.0, speed)
        },
        Drive {
            rest_force: 50.0,
            ..Drive::hydraulic(2e11, 0.01, speed)
        },
    ];
    let curve = vec![[0.0, 60.0], [10.0, 40.0], [12.0, 10.0], [14.0, -80.0]];
    let lines = [
        TorqueLine::Slope(10.0),
        TorqueLine::Stall(120.0),
        TorqueLine::Curve(curve),
    ];
    let mut ran = 0;
    for (f, follower) in followers.into_iter().enumerate() {
        for (d, drive) in drives.into_iter().enumerate() {
            let lever = if follower.is_oscillating() { 0.9 } else { 1.0 };
            let cam = Cam::new(law.clone(), follower).unwrap();
            let case = Run::new(cam, drive.at_lever(lever), 1440);
            let motor = Motor {
                line: lines[(f + d) % 3].clone(),
                friction: 1.5,
                ..motor(10.0, 0.8)
            };
            let (out, shaft) = run(&case, motor.clone());
            let first = out.rows[0].speed;
            let (forces, mean) = in_time(&case, &motor, shaft.no_load_speed, first, 360);
            let name = format!(
                "{follower:?} {:?} {:?}: ripple {}",
                drive.kind, motor.line, shaft.ripple
            );
            assert!(
                shaft.ripple > 0.001 && shaft.energy_balance.abs() < 1e-9,
                "{name}"
            );
            // A curve has corners where the integration loses an order.
            assert!(
                (mean / case.drive.speed - 1.0).abs() < 1e-5,
                "{name} {mean}"
            );
            let size = forces.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            for (i, force) in forces.iter().enumerate() {
                let own = out.rows[4 * i].contact_force;
                assert!(
                    (own - force).abs() < 2e-5 * size,
                    "{name}: {i} {own} {force}"
                );
            }
            ran += 1;
        }
    }
    assert_eq!(ran, 21);
}

#[test]
fn the_largest_torque_of_the_motor_is_that_between_the_steps_of_the_solution() {
    // From the speeds of the rows.
    let motor = motor(10.0, 0.5);
    let case = flat();
    let (out, shaft) = run(&case, motor.clone());
    let speeds = out.rows.iter().map(|r| r.speed);
    let torques = speeds.map(|w| motor.torque(w, shaft.no_load_speed)[0].abs());
    let most = torques.fold(0.0, f64::max);
    // Beside the top a row is at most half a step: the parabola falls by less than 1e-5.
    assert!(shaft.motor_torque_max_n_m >= most && shaft.motor_torque_max_n_m < most * (1.0 + 1e-5));
}

#[test]
fn a_constant_load_gives_the_point_on_the_motor_line() {
    // A disc under a face: no lift, friction μ F Rb alone. T = μ F Rb + T_f at every speed, ω₀ = ω + T/k.
    let mut case = flat();
    case.cam = Cam::new(Law::harmonic(0.0, &[]), case.cam.follower).unwrap();
    case.profile = case.cam.profile(1440);
    case.machine.friction = 0.2;
    let motor = Motor {
        friction: 2.0,
        gear: 5.0,
        efficiency: 0.8,
        ..motor(10.0, 0.3)
    };
    let (_, shaft) = run(&case, motor);
    let torque = 0.2 * 70.0 * 9.81 * 0.05 + 2.0;
    assert!((shaft.no_load_speed - (case.drive.speed + torque / 10.0)).abs() < 1e-10);
    assert!(shaft.ripple < 1e-12);
    assert!((shaft.motor_torque_rms_n_m - torque / 4.0).abs() < 1e-10);
    assert!((shaft.motor_power_mean_w - torque * case.drive.speed / 0.8).abs() < 1e-8);
}

#[test]
fn a_large_wheel_swings_by_its_energy_over_its_inertia_and_an_endless_one_not_at_all() {
    let case = flat();
    // ΔE of F v at constant speed, by quadrature of the law.
    let work = |n: usize| {
        let torque = |i: usize| {
            let at = case.cam.law.svaj(TAU * (i as f64 + 0.5) / n as f64);
            case.drive.force(at) * at.v * TAU / n as f64
        };
        let works = (0..n).scan(0.0, |sum, i| {
            *sum += torque(i);
            Some(*sum)
        });
        works.fold((0.0_f64, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)))
    };
    let (low, high) = work(100_000);
    let wheel = 1e4;
    let (_, shaft) = run(&case, motor(1e-3, wheel));
    let ripple = (high - low) / (wheel * case.drive.speed.powi(2));
    assert!(
        (shaft.ripple / ripple - 1.0).abs() < 1e-3,
        "{} {ripple}",
        shaft.ripple
    );
    let (out, _) = run(&case, motor(10.0, 1e13));
    let plain = simulate(&case, Model::Rigid).unwrap();
    for (a, b) in out.rows.iter().zip(&plain.rows) {
        assert!((a.contact_force - b.contact_force).abs() < 1e-9 * 70.0 * 9.81);
        assert!((a.time - b.time).abs() < 1e-9 && (a.speed - b.speed).abs() < 1e-9);
    }
}

#[test]
fn a_small_wheel_keeps_turning_where_the_supply_is_free() {
    // The moved mass carries the shaft over the top: no inertia is needed, and the integration in time keeps the mean speed.
    let case = flat();
    let soft = |inertia: f64| Motor {
        line: TorqueLine::Stall(4.0),
        friction: 1.0,
        ..motor(0.0, inertia)
    };
    let (_, large) = run(&case, soft(5.0));
    assert_eq!(large.least_inertia_kg_m2, 0.0, "{large:?}");
    for inertia in [0.5, 0.1, 0.05] {
        let (out, shaft) = run(&case, soft(inertia));
        let first = out.rows[0].speed;
        let (_, mean) = in_time(&case, &soft(inertia), shaft.no_load_speed, first, 360);
        let off = mean / case.drive.speed - 1.0;
        assert!(off.abs() < 1e-4, "{inertia} {off} {shaft:?}");
    }
}

#[test]
fn a_shaft_starts_from_rest_where_its_motor_lifts_the_mass_at_every_angle() {
    // Without inertia to help, a slow start passes where the stall torque exceeds the static torque M g v everywhere.
    let case = flat();
    let velocity = (0..7200).map(|i| case.cam.law.svaj(TAU * f64::from(i) / 7200.0).v);
    let hardest = 70.0 * 9.81 * velocity.fold(0.0, f64::max);
    let stall = |torque: f64| Motor {
        line: TorqueLine::Stall(torque),
        ..motor(0.0, 2.0)
    };
    let (_, strong) = run(&case, stall(3.0 * hardest));
    assert_eq!(strong.stops_at_rad, None);
    let (_, weak) = run(&case, stall(0.2 * hardest));
    assert!(weak.stops_at_rad.is_some_and(|at| at > 0.0), "{weak:?}");
}

#[test]
fn the_contact_model_is_refused_under_a_motor_and_auto_reports_the_pull_of_the_rigid_one() {
    let mut case = flat();
    case.drive = Drive::moving_axis(70.0, 9.81, 27.0);
    case.machine.motor = Some(motor(10.0, 2.0));
    let refusal = simulate(&case, Model::Contact).unwrap_err();
    assert!(refusal.to_string().contains("machine.motor"), "{refusal}");
    let auto = simulate(&case, Model::Auto).unwrap();
    assert_eq!(auto.model, Model::Rigid);
    assert!(auto.contact_lost && auto.force.min < 0.0);
    assert!(auto.next.is_none());
}

#[test]
fn the_smallest_force_under_a_motor_is_that_between_the_rows() {
    let mut case = flat();
    case.machine.motor = Some(motor(10.0, 0.5));
    let fine = simulate(&case, Model::Rigid).unwrap();
    case.profile = case.cam.profile(90);
    let coarse = simulate(&case, Model::Rigid).unwrap();
    let rows = coarse.rows.iter().map(|r| r.contact_force);
    let sampled = rows.fold(f64::INFINITY, f64::min);
    let weight = case.drive.rest_force;
    assert!((coarse.force.min - fine.force.min).abs() < 1e-4 * weight);
    assert!(sampled - fine.force.min > 1e-4 * weight, "{sampled}");
}
