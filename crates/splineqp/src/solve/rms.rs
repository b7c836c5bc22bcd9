//! Limit on a root mean square √(2 q), satisfied up to rounding errors by a search for a weight or a peak.
//!
//! **Start.** The interior-point method solves the program with the limit as a cone. The law is accurate to about 1e-6, which is sufficient
//! for the steps of a sequence of programs. The multiplier of the limit is the start of the search for a weight. The search for a peak
//! starts from the law with the minimum root mean square. It ends immediately if the law with the minimum peak satisfies the limit.
//!
//! **Weight.** Let x(μ) be the optimum of J + μ q subject to the other limits. Its value q(x(μ)) decreases with the weight μ. If √(2 q)
//! equals `most`, x(μ) is also the optimum of J subject to √(2 q) ≤ `most`. The multiplier of the tangent is then μ·most, because the
//! gradients of J and of the active rows sum to −μ∇q (Boyd and Vandenberghe, Convex Optimization, §5.5.3). Every method for quadratic
//! objectives can therefore be used. The certificate needs only one additional row.
//!
//! **Peak.** If J is only a peak t, each step minimises q subject to t ≤ p. The search determines the p for which the minimum of q is the
//! permitted value. This minimum is also the optimum of the original program, with μ = 1/Σλ over the rows of the peak (van den Berg and
//! Friedlander, SIAM J. Sci. Comput. 31, 2008, §2). The other limits alone may determine the minimum peak. The feasible set just above this
//! minimum is then as small as the rounding errors. In this case, the search ends with the certificate of the minimum peak without the
//! limit on q.
//!
//! **Result.** The law is interpolated between two iterates so that q has the permitted value. The limits are convex, so the interpolated
//! law satisfies them. Weight and multipliers are interpolated with the same fraction τ. The remaining gradient is τ(1 − τ) Δμ Δ∇q, which
//! is of second order.
//!
//! Logarithms and exponentials are computed by the same library on every machine, because their last bit can change the coefficients of a
//! nearly constant law by 1e-4.

use crate::Names;
use crate::program::{
    Failure, PEAK, Program, RmsLimit, Row, Solution, Stop, Values, make_constant,
};
use crate::solve::exchange;

/// Lower bound of the root mean square divided by its limit. It keeps the logarithm of this ratio finite.
const SMALL: f64 = 1e-2;

/// Iterate of the search: optimum for a weight or for a peak.
struct Trial<N: Names> {
    /// Logarithm of the weight μ or of the peak p.
    number: f64,
    /// The weight μ; 0 if no limit with the peak is active.
    weight: f64,
    /// Logarithm of the ratio of the root mean square to its limit.
    excess: f64,
    solution: Solution<N>,
}

/// Quantity that the search varies: the weight μ or the peak p.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Weight,
    Peak,
}

struct Search<'a, N: Names> {
    program: &'a Program<N>,
    limit: &'a RmsLimit<N>,
    way: Way,
    /// Active rows of the last optimum, which are initial rows of the next program.
    seeds: Vec<Row<N>>,
    /// Law with the minimum peak subject to the other limits; `None` if it is not computed.
    least: Option<Solution<N>>,
}

/// Optimum with a limit on a root mean square and all other limits.
pub fn solve<N: Names>(
    program: &Program<N>,
    limit: &RmsLimit<N>,
) -> Result<Solution<N>, Failure<N>> {
    let mut search = Search::new(program, limit);
    let first = match search.way {
        Way::Peak => {
            let nearest = search.of_the_nearest()?;
            match search.without_limit() {
                Ok(least) if search.keeps(&least) => return Ok(least),
                least => search.least = least.ok(),
            }
            nearest
        }
        Way::Weight => match search.begin() {
            Some(number) => search.at(number)?,
            None => match search.without_limit() {
                Ok(plain) if limit.excess(&plain.x) <= 0.0 => return Ok(plain),
                // Without the limit, the objective may be unbounded.
                Ok(_) | Err(Failure::Numerical { .. }) => search.of_the_nearest()?,
                Err(failure) => return Err(failure),
            },
        },
    };
    if let Some([inside, outside]) = search.bracket(first)? {
        return search.between(inside, outside);
    }
    let least = search.least.take();
    let least = least.map_or_else(|| search.without_limit(), Ok)?;
    search.held_up(least)
}

impl<'a, N: Names> Search<'a, N> {
    fn new(program: &'a Program<N>, limit: &'a RmsLimit<N>) -> Self {
        let is_flat =
            program.hessian.largest_diagonal() == 0.0 && program.gradient.iter().all(|g| *g == 0.0);
        let mut costs = program.cost.iter();
        let way = if is_flat && costs.all(|(k, cost)| (cost != 0.0) == (k == PEAK)) {
            Way::Peak
        } else {
            Way::Weight
        };
        Search {
            program,
            limit,
            way,
            seeds: Vec::new(),
            least: None,
        }
    }

    /// Logarithm of the weight from the program with the limit as a cone. `None` if this program has no solution, or if the limit has no
    /// multiplier.
    fn begin(&mut self) -> Option<f64> {
        let mut rough = self.program.clone();
        rough.settings.tolerance = self.program.settings.rms.rough;
        let found = exchange::solve(&rough).ok()?;
        let is_tangent = |r: &&Row<N>| self.limit.is_tangent(r);
        let weight = found.active.iter().find(is_tangent)?.multiplier / self.limit.most;
        self.seeds = found.active;
        self.seeds.retain(|r| r.limit.is_some());
        Some(libm::log(weight))
    }

    /// Whether a law satisfies the limit to the tolerance.
    fn keeps(&self, law: &Solution<N>) -> bool {
        self.limit.excess(&law.x) <= self.program.settings.tolerance
    }

    /// Law with the minimum root mean square subject to the other limits.
    fn nearest(&self) -> Result<Solution<N>, Failure<N>> {
        let near = self
            .program
            .of_least_rms(self.limit.name)
            .ok_or(Stop::Refused)?;
        let near = near.solve()?;
        if !self.keeps(&near) {
            return Err(Failure::Infeasible);
        }
        Ok(near)
    }

    /// First iterate. In the search for a peak, it is the law with the minimum root mean square. In the search for a weight, it is the
    /// optimum with equal weights of objective and root mean square.
    fn of_the_nearest(&mut self) -> Result<Trial<N>, Failure<N>> {
        let mut near = self.nearest()?;
        let program = self.program;
        match self.way {
            Way::Weight => {
                let hessian = &self.limit.half.whole.hessian;
                let square = hessian.largest_diagonal() * program.length.powi(2);
                self.at(libm::log(program.objective_unit() / square))
            }
            Way::Peak => {
                near.extra[PEAK] = program.own_peak(&near.x, &near.extra);
                let peak = near.extra[PEAK].max(f64::MIN_POSITIVE);
                Ok(self.tried(libm::log(peak), 0.0, near))
            }
        }
    }

    /// Optimum without the limit on the root mean square.
    fn without_limit(&self) -> Result<Solution<N>, Failure<N>> {
        let mut plain = self.program.weighing(self.limit, 0.0);
        plain.seeds.retain(|r| r.limit.is_some());
        plain.solve()
    }

    /// Result if the search finds no two optima on opposite sides of the limit. The optimum without the limit is returned if it satisfies
    /// the limit. Otherwise, a law with practically the minimum peak subject to the other limits is returned if it satisfies the limit. If
    /// neither law satisfies the limit, the result has no certificate. It is the law of the exchange method or the law with the minimum
    /// root mean square.
    fn held_up(&mut self, least: Solution<N>) -> Result<Solution<N>, Failure<N>> {
        if self.keeps(&least) {
            return Ok(least);
        }
        if self.way == Way::Peak {
            let near = self.at(self.lowest(&least))?;
            if near.excess <= 0.0 {
                return Ok(Solution {
                    active: least.active,
                    ..near.solution
                });
            }
        }
        // Without such a law, the law with the smaller violation is returned without a proof. It comes from the exchange method, or has the
        // minimum root mean square.
        let mut near = self.nearest()?;
        near.active.clear();
        near.extra[PEAK] = self.program.own_peak(&near.x, &near.extra);
        near.violation = self.program.violation(&near.x, &near.extra);
        Ok(match exchange::solve(self.program) {
            Ok(law) if law.violation < near.violation => law,
            _ => near,
        })
    }

    /// Logarithm of the smallest peak that is tried. This peak is slightly above `least`, the minimum peak subject to the other limits.
    fn lowest(&self, least: &Solution<N>) -> f64 {
        libm::log(least.extra[PEAK].max(f64::MIN_POSITIVE)) + self.program.settings.rms.pinch
    }

    fn tried(&self, number: f64, weight: f64, solution: Solution<N>) -> Trial<N> {
        Trial {
            number,
            weight,
            // An error of zero is treated as a very small one, because its logarithm is infinite.
            excess: libm::log((1.0 + self.limit.excess(&solution.x)).max(SMALL)),
            solution,
        }
    }

    fn at(&mut self, number: f64) -> Result<Trial<N>, Failure<N>> {
        if self.program.halt.is_asked() {
            return Err(Stop::OutOfTime.into());
        }
        let value = libm::exp(number);
        let tried = match self.way {
            Way::Weight => {
                let mut program = self.program.weighing(self.limit, value);
                program.seeds.clone_from(&self.seeds);
                self.tried(number, value, program.solve()?)
            }
            Way::Peak => {
                let mut values = Values::NONE;
                values[PEAK] = value;
                let under = self.program.clone().with_constant(&[PEAK], &values);
                let mut program = under.of_least_rms(self.limit.name).ok_or(Stop::Refused)?;
                program.seeds.clone_from(&self.seeds);
                for row in &mut program.seeds {
                    make_constant(&mut row.bound, &mut row.extra, &[PEAK], &values);
                }
                let (solution, weight) = self.of_peak(program.solve()?, value);
                self.tried(number, weight, solution)
            }
        };
        let active = tried.solution.active.iter();
        let of_limit = active.filter(|r| r.limit.is_some());
        self.seeds = of_limit.cloned().collect();
        Ok(tried)
    }

    /// Converts the law with minimum q for a given peak to a solution with the peak as its objective. Also returns the weight μ.
    fn of_peak(&self, mut solution: Solution<N>, peak: f64) -> (Solution<N>, f64) {
        let of_peak = |row: &Row<N>| {
            row.limit
                .map_or(0.0, |i| self.program.limits[i].extra[PEAK])
        };
        let rows = solution.active.iter();
        let all: f64 = rows.map(|r| r.multiplier * of_peak(r).abs()).sum();
        let weight = if all > 0.0 {
            self.program.cost[PEAK] / all
        } else {
            0.0
        };
        for row in &mut solution.active {
            row.multiplier *= weight;
            row.extra[PEAK] = of_peak(row);
            row.bound += row.extra[PEAK] * peak;
        }
        solution.extra[PEAK] = peak;
        (solution, weight)
    }

    /// Whether the program may have a solution for a nearby weight or peak after this failure.
    fn may_differ_beside(&self, failure: &Failure<N>) -> bool {
        match failure {
            Failure::Infeasible => self.way == Way::Peak,
            Failure::Numerical { stop } => *stop != Stop::OutOfTime,
            Failure::Inconsistent { .. } => false,
        }
    }

    /// Two optima, one on each side of the limit; `None` if the search finds none.
    fn bracket(&mut self, mut here: Trial<N>) -> Result<Option<[Trial<N>; 2]>, Failure<N>> {
        let settings = self.program.settings.rms;
        let holds = here.excess <= 0.0;
        let (mut step, growth) = match self.way {
            Way::Peak => (settings.peak_step, 2.0),
            Way::Weight => (
                (settings.step * here.excess.abs()).clamp(settings.least_step, 1.0),
                4.0,
            ),
        };
        for _ in 0..settings.steps {
            let mut number = here.number + if holds { -step } else { step };
            if let Some(lowest) = self.least.as_ref().map(|least| self.lowest(least)) {
                number = number.max(lowest);
                if here.number <= lowest {
                    return Ok(None);
                }
            }
            let next = match self.at(number) {
                // Either the other limits are infeasible with such a small peak, or rounding errors stopped the solver.
                Err(failure) if self.may_differ_beside(&failure) => {
                    step *= 0.25;
                    continue;
                }
                next => next?,
            };
            if (next.excess <= 0.0) != holds {
                let both = if holds { [here, next] } else { [next, here] };
                return Ok(Some(both));
            }
            here = next;
            step *= growth;
        }
        Ok(None)
    }

    /// Law for which the limit is active, by false position (Illinois) on the logarithms.
    fn between(
        &mut self,
        mut inside: Trial<N>,
        mut outside: Trial<N>,
    ) -> Result<Solution<N>, Failure<N>> {
        let (mut low, mut high) = (outside.excess, inside.excess);
        let (mut was_inside, mut was_stopped) = (None, false);
        let settings = &self.program.settings.rms;
        for _ in 0..settings.weights {
            let apart = inside.number - outside.number;
            if self.is_one(&inside, &outside) || apart <= settings.same_weight {
                break;
            }
            let share = (low / (low - high)).clamp(1e-3, 1.0 - 1e-3);
            let next = match self.at(outside.number + share * apart) {
                Err(failure) if self.may_differ_beside(&failure) && !was_stopped => {
                    (was_stopped, low, high) = (true, 1.0, -1.0);
                    continue;
                }
                next => next?,
            };
            was_stopped = false;
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

    /// Whether interpolation between two optima is sufficiently accurate. The product Δμ Δq is an upper bound of the duality gap and must
    /// be within the tolerance.
    fn is_one(&self, inside: &Trial<N>, outside: &Trial<N>) -> bool {
        let weights = (inside.weight - outside.weight).abs();
        let squares = self.limit.most.powi(2) * (outside.excess - inside.excess);
        let size = self.program.merit(&inside.solution).abs();
        let settings = &self.program.settings;
        inside.weight > 0.0
            && weights * squares <= settings.rms.gap.max(0.01 * settings.tolerance) * size
    }

    /// Interpolates between two optima so that the limit is active. The result has the active rows of both optima and the tangent of the
    /// limit.
    fn met(&self, inside: Trial<N>, outside: &Trial<N>) -> Solution<N> {
        let (limit, other) = (self.limit, &outside.solution);
        let mut out = inside.solution;
        let pairs = other.x.iter().zip(&out.x);
        let way: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
        let (slope, bent) = limit.half.along(&out.x, &way);
        // Root of ½ bent t² + slope t = room.
        let room = 0.5 * limit.most.powi(2) - limit.half.value(&out.x);
        let root = (slope * slope + 2.0 * bent * room).max(0.0).sqrt();
        let part = 2.0 * room / (slope + root);
        let part = if part > 0.0 { part.min(1.0) } else { 0.0 };
        let mix = |own: &mut f64, other: f64| *own += part * (other - *own);
        (out.x.iter_mut().zip(&other.x)).for_each(|(own, x)| mix(own, *x));
        other
            .extra
            .iter()
            .for_each(|(k, value)| mix(&mut out.extra[k], value));
        out.active
            .iter_mut()
            .for_each(|r| mix(&mut r.multiplier, 0.0));
        out.active.extend(other.active.iter().map(|r| Row {
            multiplier: part * r.multiplier,
            ..r.clone()
        }));
        let mut weight = inside.weight;
        mix(&mut weight, outside.weight);
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
