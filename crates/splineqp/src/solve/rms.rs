//! A limit on a root mean square, by the weight at which it holds with equality.
//!
//! With weight μ on q the optimum x(μ) of J + μ q keeps the other limits, and √(2 q(x(μ))) falls as μ grows. Where it is
//! `most`, x(μ) is the optimum under √(2 q) ≤ `most` and μ·most the multiplier of its tangent: J's gradient and the active
//! rows leave −μ∇q (Boyd and Vandenberghe, Convex Optimization, §5.5.3). So every method for quadratic objectives serves,
//! and the proof is theirs with one row more.

use crate::Names;
use crate::program::{EXTRAS, Failure, Program, RmsLimit, Row, Solution, Stop};

/// Factor of the weight from one optimum to the next until the limit lies between two.
const FACTOR: f64 = 30.0;
/// Factors tried.
const MOST_FACTORS: usize = 12;
/// Weights tried between two.
const MOST_WEIGHTS: usize = 40;
/// Weights nearer to each other than this part are one.
const SAME_WEIGHT: f64 = 1e-11;
/// Gap that the law may leave for being inside the limit, as a part of the objective.
const GAP: f64 = 1e-9;

/// The optimum of x(μ) at one weight.
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
    iterations: usize,
    rounds: usize,
    /// Contacts of the last optimum.
    seeds: Vec<Row<N>>,
}

/// The optimum under a limit on a root mean square and all others.
pub fn solve<N: Names>(
    program: &Program<N>,
    limit: &RmsLimit<N>,
) -> Result<Solution<N>, Failure<N>> {
    let plain = match program.weighing(limit, 0.0).solve() {
        Ok(plain) if limit.excess(&plain.x) <= 0.0 => return Ok(plain),
        Ok(plain) => Some(plain),
        // Without the limit the objective may have no least value.
        Err(Failure::Numerical { stop }) if stop != Stop::OutOfTime => None,
        Err(failure) => return Err(failure),
    };
    let near = program.of_least_rms().ok_or(Stop::Refused)?.solve()?;
    if limit.excess(&near.x) > program.settings.tolerance {
        return Err(Failure::Infeasible);
    }
    let mut search = Search {
        program,
        limit,
        iterations: near.iterations,
        rounds: near.rounds,
        seeds: Vec::new(),
    };
    let first = search.first_weight(plain.as_ref(), &near);
    let (inside, outside) = search.bracket(first)?;
    search.between(inside, outside)
}

impl<N: Names> Search<'_, N> {
    /// ln μ of the chord between the ends of the trade of J against q, or of their units where J has no such end.
    fn first_weight(&self, plain: Option<&Solution<N>>, near: &Solution<N>) -> f64 {
        let (own, half) = (self.program, &self.limit.half);
        let chord = plain.map(|plain| {
            let worth = own.merit(near) - own.merit(plain);
            worth / (half.value(&plain.x) - half.value(&near.x))
        });
        // Sizes and peaks have no value where the root mean square alone is small.
        let is_told = |chord: &f64| own.cost == [0.0; EXTRAS] && *chord > 0.0 && chord.is_finite();
        let square = half.hessian.largest_diagonal() * own.length.powi(2);
        let unit = own.objective_unit() / square;
        chord.filter(is_told).unwrap_or(unit).ln()
    }

    fn at(&mut self, weight: f64) -> Result<Tried<N>, Failure<N>> {
        if self.program.halt.is_asked() {
            return Err(Stop::OutOfTime.into());
        }
        let mut program = self.program.weighing(self.limit, weight.exp());
        if !self.seeds.is_empty() {
            program.seeds.clone_from(&self.seeds);
        }
        let solution = program.solve()?;
        self.iterations += solution.iterations;
        self.rounds += solution.rounds;
        let of_limit = solution.active.iter().filter(|r| r.limit.is_some());
        self.seeds = of_limit.cloned().collect();
        let excess = (1.0 + self.limit.excess(&solution.x)).ln();
        Ok(Tried {
            weight,
            excess,
            solution,
        })
    }

    /// Weights with which the limit holds and does not hold.
    fn bracket(&mut self, first: f64) -> Result<(Tried<N>, Option<Tried<N>>), Failure<N>> {
        let mut here = self.at(first)?;
        let holds = here.excess <= 0.0;
        for _ in 0..MOST_FACTORS {
            let step = if holds { -FACTOR.ln() } else { FACTOR.ln() };
            let next = self.at(here.weight + step)?;
            if (next.excess <= 0.0) != holds {
                return Ok(if holds {
                    (here, Some(next))
                } else {
                    (next, Some(here))
                });
            }
            here = next;
        }
        if holds {
            Ok((here, None))
        } else {
            Err(Stop::NoProgress.into())
        }
    }

    /// The weight at which the limit holds with equality, by false position (Illinois) on the logarithms.
    fn between(
        &mut self,
        mut inside: Tried<N>,
        outside: Option<Tried<N>>,
    ) -> Result<Solution<N>, Failure<N>> {
        let Some(mut outside) = outside else {
            return Ok(self.finished(inside.solution, inside.weight));
        };
        let (mut low, mut high) = (outside.excess, inside.excess);
        for _ in 0..MOST_WEIGHTS {
            let apart = inside.weight - outside.weight;
            if self.is_near(&inside) || apart <= SAME_WEIGHT {
                break;
            }
            let share = (low / (low - high)).clamp(1e-3, 1.0 - 1e-3);
            let Ok(next) = self.at(outside.weight + share * apart) else {
                break;
            };
            if next.excess <= 0.0 {
                (high, inside) = (next.excess, next);
                low *= 0.5;
            } else {
                (low, outside) = (next.excess, next);
                high *= 0.5;
            }
        }
        let weight = inside.weight;
        let met = self.met(&inside.solution, &outside.solution);
        Ok(self.finished(met, weight))
    }

    /// Whether the room that a law leaves inside the limit costs nothing.
    fn is_near(&self, tried: &Tried<N>) -> bool {
        let worth = tried.weight.exp() * self.limit.most.powi(2) * tried.excess.abs();
        let size = self.program.merit(&tried.solution).abs();
        worth <= GAP.max(self.program.settings.tolerance) * size
    }

    /// The law between two at which q is what is allowed: it keeps all limits that both keep.
    fn met(&self, inside: &Solution<N>, outside: &Solution<N>) -> Solution<N> {
        let mut out = inside.clone();
        let way: Vec<f64> = (outside.x.iter().zip(&inside.x))
            .map(|(a, b)| a - b)
            .collect();
        let half = &self.limit.half;
        let bent: f64 = (half.hessian.times(&way).iter().zip(&way))
            .map(|(h, d)| h * d)
            .sum();
        let pulled = half.hessian.times(&inside.x);
        let slope: f64 = (pulled.iter().zip(&half.gradient).zip(&way))
            .map(|((h, g), d)| (h + g) * d)
            .sum();
        // ½ bent t² + slope t = room.
        let room = 0.5 * self.limit.most.powi(2) - half.value(&inside.x);
        let root = (slope * slope + 2.0 * bent * room).max(0.0).sqrt();
        let part = 2.0 * room / (slope + root);
        if !(part > 0.0 && part <= 1.0) {
            return out;
        }
        (out.x.iter_mut().zip(&way)).for_each(|(x, d)| *x += part * d);
        for (own, other) in out.extra.iter_mut().zip(outside.extra) {
            *own += part * (other - *own);
        }
        out
    }

    /// A law with the tangent of the limit among its rows.
    fn finished(&self, mut solution: Solution<N>, weight: f64) -> Solution<N> {
        let multiplier = weight.exp() * self.limit.most;
        let tangent = self.limit.tangent(&solution.x, multiplier);
        solution.active.push(tangent);
        Solution {
            violation: self.program.violation(&solution.x, &solution.extra),
            used_rows: true,
            iterations: self.iterations,
            rounds: self.rounds,
            ..solution
        }
    }
}
