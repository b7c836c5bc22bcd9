//! Limit on a root mean square: closed form for harmonics, certificates, and the limit of feasibility.

use splineqp::poly::SplineSpace;
use splineqp::{
    Basis, Failure, Limit, MeanSquare, PEAK, Program, Quadratic, RmsLimit, Values, certificate,
    only, pointwise,
};
use std::f64::consts::TAU;

/// f = 1 + Σ cos(nθ)/n + sin(nθ)/n² over the first `count` harmonics.
fn wave(count: usize) -> impl Fn(f64) -> f64 {
    move |x| {
        let wave = |n: usize| {
            let n = n as f64;
            (n * x).cos() / n + (n * x).sin() / (n * n)
        };
        1.0 + (1..=count).map(wave).sum::<f64>()
    }
}

fn splines() -> Basis {
    Basis::Spline {
        space: SplineSpace::periodic_uniform(5, 24, TAU),
        closed: true,
    }
}

fn program(basis: Basis, order: usize, most: f64) -> Program<()> {
    let half = MeanSquare::distance(&basis, &[1.0], 40, pointwise(wave(4)));
    let mut energy = Quadratic::zero(&basis);
    if order > 0 {
        energy.add_energy(&basis, order, 1.0);
    }
    let mut program = Program::new(basis, energy, Vec::new(), 1.0);
    program.rms.push(RmsLimit {
        name: "distance",
        half,
        most,
        meaning: (),
    });
    program
}

/// Minimum of ½ mean(s‴²) within an RMS distance e of f: aₙ = λ fₙ/(λ + n⁶), with the λ for which the distance is e.
#[test]
fn the_smoothest_harmonics_near_a_wave_have_their_closed_form() {
    for most in [0.4, 0.1, 0.01, 1e-4] {
        let program = program(Basis::Harmonic { count: 4 }, 3, most);
        let left = |lambda: f64| {
            let square = |n: usize| {
                let n = n as f64;
                let part = n.powi(6) / (lambda + n.powi(6));
                0.5 * part * part * (n.powi(-2) + n.powi(-4))
            };
            (1..=4).map(square).sum::<f64>().sqrt()
        };
        let (mut low, mut high) = (1e-12_f64, 1e12_f64);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if left(middle) > most {
                low = middle;
            } else {
                high = middle;
            }
        }
        let solution = program.solve().unwrap();
        for n in 1..=4 {
            let part = low / (low + (n as f64).powi(6));
            let (a, b) = (1.0 / n as f64, 1.0 / (n * n) as f64);
            let [x, y] = [solution.x[2 * n - 1], solution.x[2 * n]];
            assert!(
                (x - part * a).abs() < 1e-7 && (y - part * b).abs() < 1e-7,
                "{most} {n}"
            );
        }
        let proof = certificate(&program, &solution);
        assert!(
            proof.proves_optimum() && proof.keeps_limits(),
            "{most} {proof:?}"
        );
        // The multiplier is what a wider distance is worth: dJ/de = λ e.
        let worth = solution.active[0].multiplier;
        assert!((worth - low * most).abs() < 1e-4 * worth, "{most} {worth}");
    }
}

/// Program that minimises the peak of the acceleration, a radius above all slopes, or an energy of this order.
fn minimising(order: usize, most: f64) -> Program<()> {
    let energy = if order < 2 { 0 } else { order };
    let mut program = program(splines(), energy, most);
    program
        .limits
        .push(Limit::on("highest", only(0, 1.0)).at_most(2.9));
    let radius = program.variable("radius", 1.0, 0.0);
    for sign in [1.0, -1.0] {
        let peak = Limit::on("peak", only(2, sign)).at_most(1.0).minimised();
        let mut slope = Limit::on("slope", only(1, sign)).at_most(0.0);
        slope.extra[radius] = -1.0;
        match order {
            0 => program.limits.push(peak),
            1 => program.limits.push(slope),
            _ => (),
        }
    }
    match order {
        0 => program.cost[PEAK] = 1.0,
        1 => {
            program.cost[radius] = 1.0;
            let mut jerk = Quadratic::zero(&program.basis);
            jerk.add_energy(&program.basis, 3, 1e-6);
            program.hessian = jerk.hessian;
        }
        _ => (),
    }
    program
}

/// Every kind of objective together with another limit; the bound is not worse than that of a tighter limit.
#[test]
fn the_optimum_is_proved_and_falls_as_the_limit_widens() {
    for order in 0..=4 {
        let mut before: Option<f64> = None;
        for most in [0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 1.0] {
            let program = minimising(order, most);
            let solution = match program.solve() {
                Err(Failure::Infeasible) if before.is_none() => continue,
                other => other.unwrap(),
            };
            let proof = certificate(&program, &solution);
            assert!(
                proof.proves_optimum() && proof.keeps_limits(),
                "{order} {most} {proof:?}"
            );
            let value = program.merit(&solution);
            let most = before.map_or(f64::INFINITY, |b| b + proof.duality_gap + 1e-12);
            assert!(value <= most, "{order} {most} {value}");
            before = Some(value);
        }
        assert!(before.is_some());
    }
}

/// The minimum of the root mean square with another limit is the limit of feasibility.
#[test]
fn laws_exist_down_to_the_least_distance() {
    for order in 0..=4 {
        let least = minimising(order, 0.1).of_least_rms("distance").unwrap();
        let nearest = least.solve().unwrap();
        let edge = (2.0 * least.merit(&nearest)).sqrt();
        let inside = minimising(order, edge * (1.0 + 1e-6));
        assert!(
            inside
                .violation(&inside.solve().unwrap().x, &Values::NONE)
                .is_finite()
        );
        let outside = minimising(order, edge * (1.0 - 1e-6));
        assert!(matches!(outside.solve(), Err(Failure::Infeasible)));
    }
}

/// Each coefficient has a multiplier μ of its distance and one of the mean square of its slope. A second limit that just permits the slope of the
/// first optimum changes nothing. A tighter one is satisfied, with a certificate.
#[test]
fn several_root_mean_squares_are_limited_together() {
    for basis in [Basis::Harmonic { count: 4 }, splines()] {
        let one = program(basis.clone(), 3, 0.1);
        let first = one.solve().unwrap();
        let half = MeanSquare::distance(&basis, &[0.0, 1.0], 40, pointwise(|_| 0.0));
        let slope = half.root(&first.x);
        for part in [1.001, 0.999] {
            let mut both = one.clone();
            both.rms.push(RmsLimit {
                name: "slope",
                half: half.clone(),
                most: part * slope,
                meaning: (),
            });
            let solution = both.solve().unwrap();
            let proof = certificate(&both, &solution);
            assert!(
                proof.proves_optimum() && proof.keeps_limits(),
                "{part} {proof:?}"
            );
            let [own, before] = [both.merit(&solution), one.merit(&first)];
            if part > 1.0 {
                assert!((own - before).abs() < 1e-6 * before, "{own} {before}");
            } else {
                assert!(own > before && half.root(&solution.x) < slope);
            }
        }
    }
}

#[test]
fn a_distance_that_no_law_has_is_infeasible() {
    let mut program = program(Basis::Harmonic { count: 2 }, 3, 1e-3);
    assert!(matches!(program.solve(), Err(Failure::Infeasible)));
    program.rms[0].most = 1.0;
    assert!(program.solve().is_ok());
}
