//! A limit on a root mean square, by the weight at which it holds with equality.
//!
//! With weight μ on q the optimum x(μ) of J + μ q keeps the other limits, and √(2 q(x(μ))) falls as μ grows. Where it is
//! `most`, x(μ) is the optimum under √(2 q) ≤ `most` and μ·most the multiplier of its tangent: J's gradient and the active
//! rows leave −μ∇q (Boyd and Vandenberghe, Convex Optimization, §5.5.3). So every method for quadratic objectives serves,
//! and the proof is theirs with one row more.
//!
//! Between two weights the law is taken on the line from one optimum to the other, where q is what is allowed: all
//! limits hold there. With weight and multipliers mixed in the same proportion t it leaves t(1 − t) Δμ Δ∇q of the gradient, which
//! is of second order.

use crate::Names;
use crate::program::{Failure, Program, RmsLimit, Row, Solution, Stop};

/// The optimum of J + μ q.
struct Tried<N: Names> {
    /// ln μ.
    weight: f64,
    /// ln of the root mean square over what is allowed.
    excess: f64,
    solution: Solution<N>,
}

struct Search<'a, N: Names> {
    program: &'a Program<N>,
    limit: &'a RmsLimit<N>,
    /// Contacts of the last optimum.
    seeds: Vec<Row<N>>,
}

/// The optimum under a limit on a root mean square and all others.
pub fn solve<N: Names>(
    program: &Program<N>,
    limit: &RmsLimit<N>,
) -> Result<Solution<N>, Failure<N>> {
    let settings = &program.settings.rms;
    // The rows of a law between two optima are those of both.
    let mut seeds: Vec<Row<N>> = Vec::new();
    for row in program.seeds.iter().filter(|r| r.limit.is_some()) {
        if !seeds.iter().any(|s| s.coincides(row, settings.coincident)) {
            seeds.push(row.clone());
        }
    }
    let mut search = Search {
        program,
        limit,
        seeds,
    };
    let neighbour = program.seeds.iter().find(|r| limit.is_tangent(r));
    if let Some(tangent) = neighbour.filter(|r| r.multiplier > 0.0) {
        let weight = (tangent.multiplier / limit.most).ln();
        let near = search.bracket(weight, settings.near_step, settings.near_steps);
        if let Ok(Some([inside, outside])) = near {
            return search.between(inside, outside);
        }
    }
    let mut plain = program.weighing(limit, 0.0);
    plain.seeds.retain(|r| r.limit.is_some());
    match plain.solve() {
        Ok(plain) if limit.excess(&plain.x) <= 0.0 => return Ok(plain),
        // Without the limit the objective may have no least value.
        Ok(_) | Err(Failure::Numerical { .. }) => (),
        Err(failure) => return Err(failure),
    }
    let near = program.of_least_rms().ok_or(Stop::Refused)?.solve()?;
    if limit.excess(&near.x) > program.settings.tolerance {
        return Err(Failure::Infeasible);
    }
    let square = limit.half.hessian.largest_diagonal() * program.length.powi(2);
    let first = (program.objective_unit() / square).ln();
    let bracket = search.bracket(first, settings.step, settings.steps)?;
    let [inside, outside] = bracket.ok_or(Stop::NoProgress)?;
    search.between(inside, outside)
}

impl<N: Names> Search<'_, N> {
    fn at(&mut self, weight: f64) -> Result<Tried<N>, Failure<N>> {
        if self.program.halt.is_asked() {
            return Err(Stop::OutOfTime.into());
        }
        let mut program = self.program.weighing(self.limit, weight.exp());
        program.seeds.clone_from(&self.seeds);
        let solution = program.solve()?;
        let of_limit = solution.active.iter().filter(|r| r.limit.is_some());
        self.seeds = of_limit.cloned().collect();
        let excess = (1.0 + self.limit.excess(&solution.x)).ln();
        Ok(Tried {
            weight,
            excess,
            solution,
        })
    }

    /// Optima that keep the limit and exceed it; `None` where no weight tried does one of both.
    fn bracket(
        &mut self,
        first: f64,
        mut step: f64,
        most: usize,
    ) -> Result<Option<[Tried<N>; 2]>, Failure<N>> {
        let mut here = self.at(first)?;
        let holds = here.excess <= 0.0;
        for _ in 0..most {
            let next = self.at(here.weight + if holds { -step } else { step })?;
            if (next.excess <= 0.0) != holds {
                let both = if holds { [here, next] } else { [next, here] };
                return Ok(Some(both));
            }
            here = next;
            step *= 2.0;
        }
        Ok(None)
    }

    /// The law at which the limit holds with equality, by false position (Illinois) on the logarithms.
    fn between(
        &mut self,
        mut inside: Tried<N>,
        mut outside: Tried<N>,
    ) -> Result<Solution<N>, Failure<N>> {
        let (mut low, mut high) = (outside.excess, inside.excess);
        let mut was_inside = None;
        let settings = &self.program.settings.rms;
        for _ in 0..settings.weights {
            let apart = inside.weight - outside.weight;
            if self.is_one(&inside, &outside) || apart <= settings.same_weight {
                break;
            }
            let share = (low / (low - high)).clamp(1e-3, 1.0 - 1e-3);
            let next = self.at(outside.weight + share * apart)?;
            let is_inside = next.excess <= 0.0;
            let again = was_inside == Some(is_inside);
            was_inside = Some(is_inside);
            if is_inside {
                (high, inside) = (next.excess, next);
                low *= if again { 0.5 } else { 1.0 };
            } else {
                (low, outside) = (next.excess, next);
                high *= if again { 0.5 } else { 1.0 };
            }
        }
        Ok(self.met(inside, &outside))
    }

    /// Whether the law between two optima is one to the accuracy wanted: its gap is below Δμ Δq.
    fn is_one(&self, inside: &Tried<N>, outside: &Tried<N>) -> bool {
        let weights = inside.weight.exp() - outside.weight.exp();
        let squares = self.limit.most.powi(2) * (outside.excess - inside.excess);
        let size = self.program.merit(&inside.solution).abs();
        let settings = &self.program.settings;
        weights * squares <= settings.rms.gap.max(0.01 * settings.tolerance) * size
    }

    /// The law between two optima at which q is what is allowed, with the rows of both and the tangent of the limit.
    fn met(&self, inside: Tried<N>, outside: &Tried<N>) -> Solution<N> {
        let (limit, other) = (self.limit, &outside.solution);
        let mut out = inside.solution;
        let pairs = other.x.iter().zip(&out.x);
        let way: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
        let along = |values: &[f64]| values.iter().zip(&way).map(|(v, d)| v * d).sum::<f64>();
        let bent = along(&limit.half.hessian.times(&way));
        let slope = along(&limit.half.hessian.times(&out.x)) + along(&limit.half.gradient);
        // ½ bent t² + slope t = room.
        let room = 0.5 * limit.most.powi(2) - limit.half.value(&out.x);
        let root = (slope * slope + 2.0 * bent * room).max(0.0).sqrt();
        let part = 2.0 * room / (slope + root);
        let part = if part > 0.0 { part.min(1.0) } else { 0.0 };
        let mix = |own: &mut f64, other: f64| *own += part * (other - *own);
        (out.x.iter_mut().zip(&other.x)).for_each(|(own, x)| mix(own, *x));
        (out.extra.iter_mut().zip(other.extra)).for_each(|(own, e)| mix(own, e));
        out.active
            .iter_mut()
            .for_each(|r| mix(&mut r.multiplier, 0.0));
        out.active.extend(other.active.iter().map(|r| Row {
            multiplier: part * r.multiplier,
            ..r.clone()
        }));
        let mut weight = inside.weight.exp();
        mix(&mut weight, outside.weight.exp());
        out.active.push(limit.tangent(&out.x, weight * limit.most));
        Solution {
            violation: self.program.violation(&out.x, &out.extra),
            used_rows: true,
            iterations: out.iterations + other.iterations,
            rounds: out.rounds + other.rounds,
            ..out
        }
    }
}
