//! Optima with known closed forms, limits that hold between samples, and conditions that contradict each other.

use splineqp::poly::{PiecewisePoly, SplineSpace};
use splineqp::{
    Basis, Derivative, Equality, Limit, PEAK, Quadratic, pointwise, solve_by_interior_point,
};
use std::f64::consts::PI;

type Program = splineqp::Program<()>;
type Failure = splineqp::Failure<()>;

/// Rest to rest on [0, 1] with h = 1; the first n − 1 derivatives are zero at both ends.
fn rest_to_rest(n: usize, degree: usize, breaks: &[f64]) -> Program {
    let inner = breaks.len() - 2;
    let space = SplineSpace::clamped(degree, breaks, &vec![1; inner]);
    let basis = Basis::Spline {
        space,
        closed: false,
    };
    let mut equalities = Vec::new();
    for order in 0..n {
        let mut w = [0.0; 5];
        w[order] = 1.0;
        let last = breaks.len() - 2;
        let demand = |piece, u, value| Equality {
            name: "at rest",
            entries: basis.row_on(piece, u, &w),
            value,
        };
        equalities.push(demand(0, 0.0, 0.0));
        equalities.push(demand(last, 1.0, if order == 0 { 1.0 } else { 0.0 }));
    }
    let zero = Quadratic::zero(&basis);
    Program::new(basis, zero, equalities, 1.0)
}

fn derivative(program: &Program, x: &[f64], order: usize) -> PiecewisePoly {
    let mut weights = [0.0; 5];
    weights[order] = 1.0;
    program.basis.combination(x, &weights)
}

fn uniform(n: usize) -> Vec<f64> {
    (0..=n).map(|i| i as f64 / n as f64).collect()
}

fn with_energy(mut p: Program, order: usize) -> Program {
    let mut q = Quadratic::zero(&p.basis);
    q.add_energy(&p.basis, order, 2.0);
    p.hessian = q.hessian;
    p
}

fn two_sided(order: usize, bound: f64) -> Vec<Limit<()>> {
    [1.0, -1.0]
        .map(|sign| {
            let mut weights = [0.0; 5];
            weights[order] = sign;
            Limit {
                domain: (0.0, 1.0),
                ..Limit::on("peak", weights).at_most(bound).scaled(1.0)
            }
        })
        .to_vec()
}

fn minimise_peak(program: &mut Program, order: usize) {
    program
        .limits
        .extend(two_sided(order, 0.0).into_iter().map(Limit::minimised));
    program.cost[PEAK] = 1.0;
}

#[test]
fn least_energy_rest_to_rest_is_3_4_5_and_4_5_6_7() {
    // theory §8: 12, 720, 100800 for n = 2, 3, 4.
    for (n, degree, expected) in [(2, 3, 12.0), (3, 5, 720.0), (4, 7, 100_800.0)] {
        let program = with_energy(rest_to_rest(n, degree, &[0.0, 0.3, 1.0]), n);
        let solution = program.solve().unwrap();
        let value = program.objective(&solution.x);
        assert!((value / expected - 1.0).abs() < 1e-9, "{n}: {value}");
    }
}

#[test]
fn free_end_acceleration_gives_jerk_energy_120() {
    let mut program = with_energy(rest_to_rest(2, 5, &[0.0, 0.5, 1.0]), 3);
    program.equalities.truncate(4);
    let solution = program.solve().unwrap();
    assert!((program.objective(&solution.x) / 120.0 - 1.0).abs() < 1e-9);
}

#[test]
fn least_peaks_are_4_32_and_384() {
    // theory §8: switches at (1 − cos kπ/n)/2 put the optimum inside the spline space.
    for (n, expected) in [(2_usize, 4.0), (3, 32.0), (4, 384.0)] {
        let breaks: Vec<f64> = (0..=n)
            .map(|k| 0.5 * (1.0 - (k as f64 * PI / n as f64).cos()))
            .collect();
        let mut program = rest_to_rest(n, n, &breaks);
        minimise_peak(&mut program, n);
        let solution = program.solve().unwrap();
        let peak = solution.extra[PEAK];
        assert!((peak / expected - 1.0).abs() < 1e-6, "{n}: {peak}");
    }
}

/// Multipliers that do not balance the cost of a further variable prove nothing.
#[test]
fn a_certificate_sees_the_gradient_of_a_peak() {
    let mut program = rest_to_rest(2, 3, &uniform(16));
    minimise_peak(&mut program, 2);
    let solution = program.solve().unwrap();
    assert!(splineqp::certificate(&program, &solution).stationarity < 1e-6);
    program.cost[PEAK] = 2.0;
    let other = splineqp::certificate(&program, &solution);
    assert!(other.stationarity > 0.1, "{}", other.stationarity);
}

#[test]
fn least_peak_acceleration_under_a_jerk_limit_follows_the_closed_form() {
    // theory §8: A*(J) = (J/4)(1 − √(1 − 32/J)); breaks on the ramp ends make it exact.
    for (jerk, n, expected) in [(32.0, 8, 8.0), (36.0, 12, 6.0), (50.0, 20, 5.0)] {
        let mut program = rest_to_rest(3, 3, &uniform(n));
        program.limits = two_sided(3, jerk);
        minimise_peak(&mut program, 2);
        let solution = program.solve().unwrap();
        let closed = jerk / 4.0 * (1.0 - (1.0 - 32.0 / jerk).max(0.0).sqrt());
        assert!((closed - expected).abs() < 1e-12);
        let peak = solution.extra[PEAK];
        assert!((peak / expected - 1.0).abs() < 1e-6, "J = {jerk}: {peak}");
        assert!(solution.violation < 1e-6);
    }
}

/// Dwell, rise to 1 at ½, return; the first n − 1 derivatives are zero at both ends.
fn rise_and_return(n: usize, degree: usize, breaks: &[f64]) -> Program {
    let mut program = rest_to_rest(n, degree, breaks);
    for e in &mut program.equalities {
        e.value = 0.0;
    }
    let entries = program.basis.row(0.5, &[1.0]);
    program.equalities.push(Equality {
        name: "again",
        entries,
        value: 1.0,
    });
    program
}

#[test]
fn dwell_rise_return_optima_are_found() {
    // theory §8: min ∫a² = 192, min ∫j² = 20480, min peak |a| = 16, min peak |j| = 48(2 + √2).
    for (n, degree, expected) in [(2, 3, 192.0), (3, 5, 20_480.0)] {
        let program = with_energy(rise_and_return(n, degree, &uniform(4)), n);
        let value = program.objective(&program.solve().unwrap().x);
        assert!((value / expected - 1.0).abs() < 1e-9, "{n}: {value}");
    }
    let mut program = rise_and_return(2, 2, &uniform(8));
    minimise_peak(&mut program, 2);
    let peak = program.solve().unwrap().extra[PEAK];
    assert!((peak / 16.0 - 1.0).abs() < 1e-6, "{peak}");
    // The switches of the jerk are irrational; fine uniform breaks come near enough.
    let mut program = rise_and_return(3, 3, &uniform(400));
    minimise_peak(&mut program, 3);
    let peak = program.solve().unwrap().extra[PEAK];
    let exact = 48.0 * (2.0 + 2.0_f64.sqrt());
    assert!(
        (peak / exact - 1.0).abs() < 1e-4 && peak > exact * (1.0 - 1e-6),
        "{peak} {exact}"
    );
}

#[test]
fn a_jerk_limit_below_32_is_infeasible() {
    let mut program = with_energy(rest_to_rest(3, 5, &uniform(24)), 3);
    program.limits = two_sided(3, 31.9);
    assert_eq!(program.solve().unwrap_err(), Failure::Infeasible);
}

#[test]
fn a_jerk_limit_on_quintics_holds_between_samples() {
    // theory §9: one sample per span lets a limit of 50 reach 197.9; exchange must not.
    let mut program = with_energy(rest_to_rest(3, 5, &uniform(16)), 2);
    program.limits = two_sided(3, 50.0);
    let solution = program.solve().unwrap();
    let jerk = derivative(&program, &solution.x, 3);
    let worst = (0..100_000)
        .map(|i| jerk.eval(f64::from(i) / 100_000.0).abs())
        .fold(0.0, f64::max);
    assert!(worst < 50.0 * (1.0 + 2e-9), "{worst}");
    assert!(worst > 49.9, "the limit should bind: {worst}");
    assert!(solution.active.iter().all(|r| r.multiplier > 0.0) && !solution.active.is_empty());
}

#[test]
fn contradicting_demands_are_named() {
    let mut program = with_energy(rest_to_rest(3, 5, &uniform(4)), 3);
    let mut again = program.equalities[1].clone();
    again.name = "again";
    again.value = 2.0;
    program.equalities.push(again.clone());
    assert_eq!(
        program.solve().unwrap_err(),
        Failure::Inconsistent {
            equalities: vec!["again"]
        }
    );
    again.value = 1.0;
    program.equalities.pop();
    program.equalities.push(again);
    assert!(
        program.solve().is_ok(),
        "a repeated demand is no contradiction"
    );
}

/// Closed quintics that approximate a force with two peaks, with derivatives limited to a fraction of those of the unlimited law.
fn humps(degree: usize, spans: usize, parts: &[(usize, f64)]) -> Program {
    let space = SplineSpace::periodic_uniform(degree, spans, 2.0 * PI);
    let basis = Basis::Spline {
        space,
        closed: true,
    };
    let mut q = Quadratic::zero(&basis);
    let hump = |x: f64| (2.0 * x).sin() + 0.6 * (4.0 * x).cos() + 0.2 * (6.0 * x + 0.4).sin();
    q.add_distance(&basis, &[0.0, 0.0, 1.0], 24, pointwise(hump), None);
    let mut program = Program::new(basis, q, Vec::new(), 0.3);
    let free = program.solve().unwrap();
    for &(order, part) in parts {
        let (low, high) = derivative(&program, &free.x, order).extremes();
        let bound = part * high.value.max(-low.value);
        for mut limit in two_sided(order, bound) {
            limit.domain = (0.0, 2.0 * PI);
            program.limits.push(limit);
        }
    }
    program
}

#[test]
fn active_set_and_interior_point_find_the_same_optimum() {
    type Parts = &'static [(usize, f64)];
    let cases: [(usize, usize, Parts); 7] = [
        (5, 32, &[(2, 0.95), (3, 0.95)]),
        (5, 32, &[(2, 0.6), (3, 0.6)]),
        (5, 32, &[(2, 0.3), (3, 0.3)]),
        (5, 24, &[(1, 0.5), (2, 0.7), (3, 0.8)]),
        (3, 40, &[(2, 0.8), (3, 0.4)]),
        (7, 20, &[(3, 0.5), (0, 0.9)]),
        (4, 64, &[(3, 0.2)]),
    ];
    for (degree, spans, parts) in cases {
        let program = humps(degree, spans, parts);
        let ours = program.solve().unwrap();
        let other = solve_by_interior_point(&program).unwrap();
        let (a, b) = (program.objective(&ours.x), program.objective(&other.x));
        // Both keep the limits to 1e-9 or a little more; the objective follows at about that.
        assert!(
            (a - b).abs() < 2e-7 * b.abs(),
            "{degree} {spans} {parts:?}: {a} {b}"
        );
        assert!(ours.violation <= 1e-9, "{parts:?}: {}", ours.violation);
        assert!(ours.active.iter().all(|r| r.multiplier > 0.0));
    }
}

#[test]
fn limits_hold_on_a_dense_scan_of_the_law() {
    for part in [0.9, 0.5, 0.25] {
        let program = humps(5, 32, &[(2, part), (3, part)]);
        let solution = program.solve().unwrap();
        for limit in &program.limits {
            let side = program.basis.combination(&solution.x, &limit.weights);
            let worst = (0..100_000)
                .map(|i| side.eval(2.0 * PI * f64::from(i) / 100_000.0))
                .fold(f64::NEG_INFINITY, f64::max);
            assert!(worst <= limit.bound * (1.0 + 2e-9), "{part}: {worst}");
        }
    }
}

#[test]
fn the_gradient_of_the_objective_is_the_push_of_the_active_rows() {
    let program = humps(5, 32, &[(2, 0.5), (3, 0.4)]);
    let solution = program.solve().unwrap();
    let mut rest = program.hessian.times(&solution.x);
    for (r, g) in rest.iter_mut().zip(&program.gradient) {
        *r += g;
    }
    let size = program.gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
    for row in &solution.active {
        for &(i, a) in &row.entries {
            rest[i] += row.multiplier * a;
        }
    }
    let left = rest.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    assert!(left < 1e-7 * size, "{left:.2e} of {size:.2e}");
}

#[test]
fn a_crest_on_a_break_is_held_like_any_other() {
    // Symmetric about a break: the highest lift stands on it, to rounding on either side.
    for (degree, spans) in [(3, 8), (4, 8), (5, 8), (3, 16), (5, 12)] {
        let space = SplineSpace::periodic_uniform(degree, spans, 2.0 * PI);
        let basis = Basis::Spline {
            space,
            closed: true,
        };
        let mut q = Quadratic::zero(&basis);
        q.add_distance(
            &basis,
            &[1.0],
            24,
            pointwise(|x| -x.sin() - 0.1 * (3.0 * x).sin()),
            None,
        );
        let mut program = Program::new(basis, q, Vec::new(), 1.0);
        let mut limit = Limit::on("stroke", Derivative::Value).at_most(0.7);
        limit.domain = (0.0, 2.0 * PI);
        program.limits.push(limit);
        let solution = program.solve().unwrap();
        let highest = derivative(&program, &solution.x, 0).extremes().1.value;
        assert!((highest - 0.7).abs() < 1e-8, "{degree} {spans}: {highest}");
    }
}

#[test]
fn best_single_polynomials_of_least_peak_acceleration_are_found() {
    // theory §8, to the digits printed there; an even degree adds nothing to the odd one below.
    let table = [
        (5, 5.7735, 1e-4),
        (6, 5.7735, 1e-4),
        (7, 5.6113, 1e-4),
        (8, 5.6113, 1e-4),
        (9, 4.6575, 1e-4),
        (10, 4.6575, 1e-4),
        (11, 4.627, 1e-3),
        (12, 4.627, 1e-3),
        (13, 4.353, 1e-3),
        (15, 4.342, 1e-3),
        (17, 4.222, 1e-3),
        (21, 4.153, 1e-3),
    ];
    for (degree, printed, digit) in table {
        let mut program = rest_to_rest(3, degree, &[0.0, 1.0]);
        minimise_peak(&mut program, 2);
        let peak = program.solve().unwrap().extra[PEAK];
        assert!(
            (peak - printed).abs() < 0.6 * digit,
            "{degree}: {peak} {printed}"
        );
    }
}
