//! Certificates of optima, and of laws that are only near an optimum. An independent evaluation, which shares no code with the solver, confirms them.

use splineqp::poly::SplineSpace;
use splineqp::*;
use std::f64::consts::TAU;

type Program = splineqp::Program<()>;
type Solution = splineqp::Solution<()>;

/// Cardinal B-spline of a degree on [0, degree + 1], by its recursion.
fn cardinal(degree: usize, x: f64) -> f64 {
    if degree == 0 {
        return f64::from(u8::from((0.0..1.0).contains(&x)));
    }
    let d = degree as f64;
    (x * cardinal(degree - 1, x) + (d + 1.0 - x) * cardinal(degree - 1, x - 1.0)) / d
}

/// Derivative of a uniform periodic spline over one turn at n points of every span, from differences of its coefficients.
fn samples(x: &[f64], degree: usize, order: usize, n: usize) -> Vec<f64> {
    let spans = x.len();
    let c = differences(x, order);
    let left = degree - order;
    let table: Vec<Vec<f64>> = (0..n)
        .map(|k| {
            let u = k as f64 / n as f64;
            (0..=left)
                .map(|j| cardinal(left, u + (left - j) as f64))
                .collect()
        })
        .collect();
    (0..spans * n)
        .map(|i| {
            let (span, basis) = (i / n, &table[i % n]);
            // Derivatives keep the index of the last function on a span.
            let first = span + (degree / spans + 1) * spans - left;
            let terms = basis.iter().enumerate();
            terms.map(|(j, b)| b * c[(first + j) % spans]).sum()
        })
        .collect()
}

/// Derivative of a uniform periodic spline at one position, in spans.
fn value(x: &[f64], degree: usize, order: usize, place: f64) -> f64 {
    let span = (place as usize).min(x.len() - 1);
    let (c, left) = (differences(x, order), degree - order);
    let first = span + (degree / x.len() + 1) * x.len() - left;
    (0..=left)
        .map(|j| cardinal(left, place - span as f64 + (left - j) as f64) * c[(first + j) % x.len()])
        .sum()
}

/// Coefficients of a derivative.
fn differences(x: &[f64], order: usize) -> Vec<f64> {
    let (spans, step) = (x.len(), TAU / x.len() as f64);
    let mut c = x.to_vec();
    for _ in 0..order {
        c = (0..spans)
            .map(|i| (c[i] - c[(i + spans - 1) % spans]) / step)
            .collect();
    }
    c
}

/// A program with the data for checking its law.
struct Case {
    program: Program,
    degree: usize,
    target: fn(f64, f64) -> f64,
    seed: f64,
}

impl Case {
    /// Periodic splines that approximate waves, with derivatives limited to fractions of those of the unlimited law.
    fn new(number: usize) -> Self {
        let (degree, spans) = (3 + number % 5, 10 + 3 * (number % 6));
        let seed = 0.7 * number as f64;
        let target = |x: f64, seed: f64| {
            (2.0 * x + seed).sin() + 0.6 * (4.0 * x).cos() + 0.3 * (5.0 * x + 2.0 * seed).sin()
        };
        let basis = Basis::Spline {
            space: SplineSpace::periodic_uniform(degree, spans, TAU),
            closed: true,
        };
        let mut distance = splineqp::Quadratic::zero(&basis);
        let at = move |x| target(x, seed);
        distance.add_distance(&basis, &[1.0], 24, pointwise(at), None);
        let mut program = Program::new(basis, distance, Vec::new(), 1.0);
        let free = program.solve().unwrap();
        for order in [1, 2].into_iter().take(1 + number % 2) {
            let largest = samples(&free.x, degree, order, 50);
            let largest = largest.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let bound = (0.55 + 0.05 * (number % 8) as f64) * largest;
            for sign in [1.0, -1.0] {
                let mut weights = [0.0; 5];
                weights[order] = sign;
                program
                    .limits
                    .push(Limit::on("derivative", weights).at_most(bound));
            }
        }
        Case {
            program,
            degree,
            target,
            seed,
        }
    }

    /// Optimum with every bound multiplied by `factor`.
    fn solved(&self, factor: f64) -> Solution {
        let mut other = self.program.clone();
        other.limits.iter_mut().for_each(|l| l.bound *= factor);
        let mut solution = other.solve().unwrap();
        // Rows and violation are those of the program itself.
        solution.active.iter_mut().for_each(|r| r.bound /= factor);
        solution.violation = self.program.violation(&solution.x, &solution.extra);
        solution
    }

    /// Half the mean squared distance from the target, by Simpson's rule.
    fn objective(&self, x: &[f64]) -> f64 {
        let n = 64;
        let law = samples(x, self.degree, 0, n);
        let mut sum = 0.0;
        for (i, s) in law.iter().enumerate() {
            let theta = TAU * i as f64 / law.len() as f64;
            let weight = if i % 2 == 0 { 2.0 } else { 4.0 } / 3.0;
            sum += weight * (s - (self.target)(theta, self.seed)).powi(2);
        }
        0.5 * sum / law.len() as f64
    }

    /// Maximum relative excess over a bound: maxima on a grid, each with a golden-section search between its neighbours.
    fn excess(&self, x: &[f64]) -> f64 {
        let n = 100;
        let of_limit = |limit: &Limit<()>| {
            let order = limit.highest_order();
            let sign = limit.weights[order];
            let values = samples(x, self.degree, order, n);
            let all = values.len();
            let highest = values.iter().fold(0.0_f64, |m, v| m.max(sign * v));
            let at = |place: f64| {
                sign * value(
                    x,
                    self.degree,
                    order,
                    place.rem_euclid(all as f64) / n as f64,
                )
            };
            let near = (0..all).filter(|&i| {
                let [before, own, after] = [i + all - 1, i, i + 1].map(|k| sign * values[k % all]);
                own >= before && own >= after && own > 0.999 * highest
            });
            let tops = near.map(|i| golden_section(i as f64 - 1.0, i as f64 + 1.0, at));
            tops.fold(highest, f64::max) / limit.bound - 1.0
        };
        self.program
            .limits
            .iter()
            .map(of_limit)
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Maximum of a unimodal function between two positions.
fn golden_section(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..50 {
        let [a, b] = [high - part * (high - low), low + part * (high - low)];
        if f(a) < f(b) {
            low = a;
        } else {
            high = b;
        }
    }
    f(0.5 * (low + high))
}

pub fn is_certified(proof: &Certificate) -> bool {
    proof.keeps_limits() && proof.proves_optimum()
}

#[test]
fn what_is_certified_keeps_its_limits_and_is_within_a_millionth_of_the_optimum() {
    let (mut optima, mut worse, mut outside) = (0, 0, 0);
    for number in 0..40 {
        let case = Case::new(number);
        let best = case.solved(1.0);
        let least = case.objective(&best.x);
        let stated = case.program.merit(&best);
        assert!(
            (stated / least - 1.0).abs() < 1e-7,
            "{number}: {stated} {least}"
        );
        let apart = [-12, -11, -10, -9, -8, -7, -6, -5, -4, -3].map(|e| 10_f64.powi(e));
        let factors = apart.iter().flat_map(|e| [1.0 - e, 1.0 + e]).chain([1.0]);
        for factor in factors {
            let other = case.solved(factor);
            let proof = certificate(&case.program, &other);
            let above = case.objective(&other.x) / least - 1.0;
            let excess = case.excess(&other.x);
            optima += usize::from(factor == 1.0 && is_certified(&proof));
            worse += usize::from(above > 1.1e-6 && proof.stationarity < PROVED);
            outside += usize::from(excess > 1e-9 && proof.proves_optimum());
            let words =
                format!("{number}, bounds times {factor}: {above:.2e} {excess:.2e} {proof:?}");
            // A smaller objective than the optimum's is bought with an excess of the limits.
            assert!(above > -1e-6 || excess > 1e-9, "{words}");
            assert!(proof.violation > excess - 1e-10, "{words}");
            assert!(proof.duality_gap / least > above - 1e-8, "{words}");
            if is_certified(&proof) {
                assert!(excess <= 5e-10 && above <= 1e-6, "{words}");
            }
        }
    }
    assert!(optima >= 38, "{optima} certified");
    assert!(worse >= 60, "{worse} told by their gap alone");
    assert!(outside >= 60, "{outside} told by their violation alone");
}

/// Multipliers that do not balance the gradient prove nothing, however small the resulting gap is.
#[test]
fn multipliers_of_another_objective_do_not_certify() {
    for number in 0..40 {
        let case = Case::new(number);
        let mut other = case.solved(1.0);
        other
            .active
            .iter_mut()
            .for_each(|r| r.multiplier *= 1.0 + 1e-3);
        let proof = certificate(&case.program, &other);
        assert!(!is_certified(&proof), "{number}: {proof:?}");
    }
}

/// The optimum for a condition that is changed by δ satisfies all conditions except this one. Its gap is νδ, the difference from the optimum for the
/// original condition.
#[test]
fn a_missed_demand_counts_in_the_gap_with_its_price() {
    for (degree, spans) in [(3, 8), (5, 16), (7, 24)] {
        let space = SplineSpace::periodic_uniform(degree, spans, TAU);
        let basis = Basis::Spline {
            space,
            closed: true,
        };
        let sine = |start: f64, width: f64, rule: &[(f64, f64)], out: &mut [f64]| {
            for (value, (u, _)) in out.iter_mut().zip(rule) {
                *value = (start + u * width).sin();
            }
        };
        let program = |value: f64| {
            let mut distance = Quadratic::zero(&basis);
            distance.add_distance(&basis, &[1.0], 8, sine, None);
            let entries = basis.row(1.0, &[1.0, 0.0, 0.0, 0.0]);
            let demand = Equality {
                name: "there",
                entries,
                value,
            };
            Program::new(basis.clone(), distance, vec![demand], 1.0)
        };
        let asked = program(0.2);
        let optimum = asked.solve().unwrap();
        for off in [-1e-3, -1e-6, 1e-6, 1e-3] {
            let beside = program(0.2 + off).solve().unwrap();
            let change = asked.objective(&beside.x) - asked.objective(&optimum.x);
            let gap = certificate(&asked, &beside).duality_gap;
            // Of second order in δ the two differ by half the curvature.
            let bend = 10.0 * off * off;
            assert!(
                (gap - change.abs()).abs() < bend + 1e-13,
                "{gap:e} {change:e}"
            );
            assert!(gap > 1e-3 * off.abs(), "{gap:e} for {off:e}");
            // A demand in another unit is the same demand.
            let mut other = asked.clone();
            for demand in &mut other.equalities {
                demand.value *= 1e-6;
                demand.entries.iter_mut().for_each(|e| e.1 *= 1e-6);
            }
            let same = certificate(&other, &beside).duality_gap;
            assert!((same / gap - 1.0).abs() < 1e-6, "{gap:e} {same:e}");
        }
    }
}

/// Without limits, the gap of a law is the difference between its objective and the minimum, to second order in the deviation.
#[test]
fn the_gap_of_any_law_without_limits_is_its_distance_from_the_optimum() {
    for number in 0..20 {
        let mut case = Case::new(number);
        case.program.limits.clear();
        let best = case.program.solve().unwrap();
        for size in [1e-6, 1e-4, 1e-2] {
            let mut other = best.clone();
            for (i, x) in other.x.iter_mut().enumerate() {
                *x += size * (1.7 * i as f64 + case.seed).sin();
            }
            let above = case.program.objective(&other.x) - case.program.objective(&best.x);
            let proof = certificate(&case.program, &other);
            let words = format!("{number} {size:e}: {above:e} {proof:?}");
            // Both objectives are differences of terms of the size of 1.
            let off = (proof.duality_gap - above).abs();
            assert!(off < 1e-6 * above + 1e-15, "{words}");
            assert!(proof.stationarity > 1e-3 * size, "{words}");
        }
    }
}

/// The force of springs and masses does not determine the level of the lift, and limits on the lift move it; their multipliers are in balance.
#[test]
fn limits_on_an_open_level_are_certified_by_balanced_multipliers() {
    let spline = Basis::Spline {
        space: SplineSpace::periodic_uniform(5, 16, TAU),
        closed: true,
    };
    let mut gaps = Vec::new();
    let bases = [spline, Basis::Harmonic { count: 6 }];
    for (basis, unit) in bases
        .iter()
        .flat_map(|b| [1.0, 1e-3, 1e3].map(|u| (b.clone(), u)))
    {
        let mut distance = Quadratic::zero(&basis);
        let wave = pointwise(move |x: f64| unit * ((2.0 * x).sin() + 0.4 * (3.0 * x).cos()));
        distance.add_distance(&basis, &[0.0, 0.0, 1.0], 16, wave, None);
        let mut program = Program::new(basis, distance, Vec::new(), unit);
        let free = program.solve().unwrap();
        let lift = |s: &Solution| {
            let law = program.basis.combination(&s.x, &[1.0, 0.0, 0.0, 0.0, 0.0]);
            let all: Vec<f64> = (0..500)
                .map(|i| law.eval(TAU * f64::from(i) / 500.0))
                .collect();
            let low = all.iter().fold(f64::INFINITY, |m, v| m.min(*v));
            all.iter().fold(0.0_f64, |m, v| m.max(v - low))
        };
        let half = 0.4 * lift(&free);
        for sign in [1.0, -1.0] {
            let weights = [sign, 0.0, 0.0, 0.0, 0.0];
            program
                .limits
                .push(Limit::on("level", weights).at_most(half));
        }
        let solution = program.solve().unwrap();
        assert!(solution.active.len() >= 2);
        let proof = certificate(&program, &solution);
        assert!(is_certified(&proof), "{proof:?}");
        // The same law with its multipliers on one side only proves nothing.
        let mut one_sided = solution;
        let above = one_sided.active[0].entries[0].1.signum();
        one_sided
            .active
            .retain(|r| r.entries[0].1.signum() == above);
        let proof = certificate(&program, &one_sided);
        assert!(!is_certified(&proof));
        gaps.push(proof.relative_gap);
    }
    // A relative gap is the same in any unit of length.
    for of_basis in gaps.chunks(3) {
        assert!(
            of_basis
                .iter()
                .all(|g| (g / of_basis[0] - 1.0).abs() < 1e-5),
            "{gaps:?}"
        );
    }
}
