//! Least-squares fit of a linear model to several logs. It determines parameters with physical signs, phase shifts of the logs, and confidence
//! intervals.

use std::ops::Range;

use super::cycles::{Averaged, derivative, shifted};
use super::least_squares::{Bounded, Column, difference, dot, inverse, product};

/// Number of trial values of a phase shift per turn. The best value is then refined.
const SHIFTS: usize = 720;
const STEPS: usize = 20;
/// Number of standard deviations by which the sum of squares of the residual must exceed its mean for pure noise. Only then does the residual count
/// as a repeatable error.
pub(super) const EXCESS: f64 = 3.0;

/// Estimate of a parameter, with the ends of its 95 % interval. The ends are infinite if the data do not determine the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Estimate {
    pub value: f64,
    pub ends: [f64; 2],
}

/// Result of a least-squares fit to several logs.
pub(super) struct Fit {
    /// Unknown phase shifts with their intervals.
    pub shifts: Vec<Estimate>,
    pub each: Vec<Estimate>,
    /// Cycles of every log, shifted to the phase of the machine.
    pub measured: Vec<Averaged>,
    /// Sum of squares of the mean residual of each log.
    pub left: Vec<f64>,
    /// Repeatable part of the sum of squares in `left`, for each log.
    pub repeats: Vec<f64>,
    /// Variance of each coefficient of the repeatable residual. The residual is treated as `harmonics` harmonics of equal variance.
    pub component: f64,
    pub harmonics: usize,
}

/// An unknown phase shift: a common delay of several logs, or the phase of one log.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shift {
    pub range: [f64; 2],
    /// Phase delay of each log per unit of the unknown shift, rad; 0 for logs that are not shifted.
    pub rates: Vec<f64>,
}

/// Cycles of several logs, concatenated to one vector, with their unknown phase shifts.
#[derive(Clone, Copy)]
struct Stack<'a> {
    runs: &'a [Averaged],
    shifts: &'a [Shift],
}

impl Stack<'_> {
    fn phase(self, run: usize, at: &[f64]) -> f64 {
        let parts = self.shifts.iter().zip(at);
        parts.map(|(shift, x)| shift.rates[run] * x).sum()
    }

    /// Mean cycles of all logs, shifted by their phases.
    fn means(self, at: &[f64]) -> Vec<f64> {
        let runs = self.runs.iter().enumerate();
        let mean = |(i, run): (usize, &Averaged)| shifted(&run.mean, self.phase(i, at));
        runs.flat_map(mean).collect()
    }

    /// Range of the entries of one log in the concatenated vector.
    fn part(self, run: usize) -> Range<usize> {
        let length = |r: &Averaged| r.mean.len();
        let from = self.runs[..run].iter().map(length).sum();
        from..from + length(&self.runs[run])
    }

    fn parts(self) -> impl Iterator<Item = Range<usize>> {
        (0..self.runs.len()).map(move |i| self.part(i))
    }

    /// Derivatives of the shifted means with respect to the unknown phase shifts.
    fn slopes(self, model: &[f64]) -> Vec<Vec<f64>> {
        let of_run = |shift: &Shift, run: usize| -> Vec<f64> {
            let slope = derivative(&model[self.part(run)]);
            slope.iter().map(|x| -shift.rates[run] * x).collect()
        };
        let slope = |shift: &Shift| {
            (0..self.runs.len())
                .flat_map(|i| of_run(shift, i))
                .collect()
        };
        self.shifts.iter().map(slope).collect()
    }
}

/// Fits the columns to the mean cycles of several logs, with the best phase shifts. The search for the shifts begins at `start`.
pub(super) fn fit(columns: &[Column], runs: &[Averaged], shifts: &[Shift], start: &[f64]) -> Fit {
    let solver = Bounded::new(columns);
    let stack = Stack { runs, shifts };
    let mut at = start.to_vec();
    for place in 0..at.len() {
        at[place] = best_shift(&solver, stack, &at, place);
    }
    let mut values = solver.solve(&stack.means(&at)).0;
    for _ in 0..if shifts.is_empty() { 0 } else { STEPS } {
        let model = solver.model(&values);
        let left = difference(&stack.means(&at), &model);
        // Gauss–Newton step: a joint least-squares fit of the free columns and of the derivatives with respect to the shifts.
        let free = (0..values.len()).filter(|i| solver.is_free(&values, *i));
        let mut used: Vec<Vec<f64>> = free.map(|i| solver.scaled(i)).collect();
        let count = used.len();
        used.extend(stack.slopes(&model));
        let moved = product(&inverse(&used), &left);
        let mut largest = 0.0_f64;
        for (place, shift) in shifts.iter().enumerate() {
            let step = moved[count + place];
            let [low, high] = shift.range;
            at[place] = (at[place] + step).clamp(low, high);
            largest = shift
                .rates
                .iter()
                .fold(largest, |m, r| m.max((r * step).abs()));
        }
        values = solver.solve(&stack.means(&at)).0;
        if largest < 1e-12 {
            break;
        }
    }
    intervals(&solver, stack, &values, &at)
}

/// Confidence intervals of the parameters. Parameters at their bound are also treated as unknown, because a repeatable force may have moved them to
/// the bound.
fn intervals(solver: &Bounded, stack: Stack, values: &[f64], at: &[f64]) -> Fit {
    let runs = stack.runs.iter().enumerate();
    let turned = |(i, run): (usize, &Averaged)| run.map(|c| shifted(c, stack.phase(i, at)));
    let measured: Vec<Averaged> = runs.map(turned).collect();
    let model = solver.model(values);
    let columns = (0..values.len()).map(|i| solver.scaled(i));
    let used: Vec<Vec<f64>> = columns.chain(stack.slopes(&model)).collect();
    let operator = inverse(&used);
    let left = difference(&stack.means(at), &model);
    // Noise variance of the residual, from the scatter of the residuals over the cycles of each log.
    let mut variance = vec![0.0; left.len()];
    for (run, part) in measured.iter().zip(stack.parts()) {
        let residuals = run.map(|c| {
            let mut own = vec![0.0; left.len()];
            own[part.clone()].copy_from_slice(c);
            let moved = product(&operator, &own);
            for (column, x) in used.iter().zip(&moved) {
                own.iter_mut().zip(column).for_each(|(o, u)| *o -= u * x);
            }
            own
        });
        let own = residuals.variance();
        variance.iter_mut().zip(own).for_each(|(v, o)| *v += o);
    }
    let (repeats, component, harmonics) = repeatable(stack, &left, &variance);
    let degrees = measured.iter().map(|r| r.each.len() - 1).sum();
    let half = |row: &Vec<f64>| {
        let scatter = |(run, part): (&Averaged, Range<usize>)| {
            run.map(|c| vec![dot(&row[part.clone()], c)]).variance()[0]
        };
        let noise: f64 = measured.iter().zip(stack.parts()).map(scatter).sum();
        let noise = t95(degrees) * noise.sqrt();
        let size = size(stack, row);
        let doubt = t95(harmonics) * (component * size).sqrt();
        let is_seen = row.iter().all(|x| x.is_finite()) && size > 0.0;
        if is_seen {
            libm::hypot(noise, doubt)
        } else {
            f64::INFINITY
        }
    };
    // Interval about the least-squares estimate without sign constraints, because the scatter belongs to this estimate. It also contains the value
    // with sign constraints.
    let estimate = |value: f64, row: Option<&Vec<f64>>, scale: f64| {
        let known = row.map(|row| (value + dot(row, &left), half(row)));
        let (centre, half) = known
            .filter(|k| k.1.is_finite())
            .unwrap_or((value, f64::INFINITY));
        Estimate {
            value: value / scale,
            ends: [
                (centre - half).min(value) / scale,
                (centre + half).max(value) / scale,
            ],
        }
    };
    let count = values.len();
    let each = (0..count).map(|i| estimate(values[i], operator.get(i), solver.scales[i]));
    let shifts = at.iter().zip(count..);
    let shifts = shifts.map(|(x, i)| estimate(*x, operator.get(i), 1.0));
    let energy = |part: Range<usize>| dot(&left[part.clone()], &left[part]);
    Fit {
        shifts: shifts.collect(),
        each: each.collect(),
        left: stack.parts().map(energy).collect(),
        measured,
        repeats,
        component,
        harmonics,
    }
}

/// Ratio of the variance of an estimate to the variance of a coefficient of the repeatable residual. It is the larger of two values. One
/// value is for residuals that are independent in each log, the other for a residual that is equal in all logs.
fn size(stack: Stack, row: &[f64]) -> f64 {
    let longest = stack.runs.iter().map(|r| r.mean.len()).max().unwrap_or(0);
    let mut sum = vec![0.0; longest];
    for part in stack.parts() {
        sum.iter_mut().zip(&row[part]).for_each(|(s, x)| *s += x);
    }
    dot(row, row).max(dot(&sum, &sum))
}

/// Repeatable part of the mean residual `left`, whose entries have the noise variances `variance`. Returns the repeatable sum of squares of each
/// log, the variance of one coefficient, and the effective number of harmonics (participation ratio). With several logs, the mean value of each
/// log's residual is counted in addition to its harmonics.
fn repeatable(stack: Stack, left: &[f64], variance: &[f64]) -> (Vec<f64>, f64, usize) {
    let pairs = |part: Range<usize>| -> Vec<(Range<usize>, f64)> {
        let mean = (stack.runs.len() > 1).then(|| (part.start..part.start + 1, 2.0));
        let harmonics = (part.start + 1..part.end).step_by(2);
        let harmonics = harmonics.map(|i| (i..i + 2, 1.0));
        mean.into_iter().chain(harmonics).collect()
    };
    let parts: Vec<Vec<(Range<usize>, f64)>> = stack.parts().map(pairs).collect();
    let squares: Vec<f64> = left.iter().map(|x| x * x).collect();
    let all = parts.iter().flatten();
    let sum = |of: &dyn Fn(usize) -> f64| -> f64 {
        let own = |(pair, weight): &(Range<usize>, f64)| weight * pair.clone().map(of).sum::<f64>();
        all.clone().map(own).sum()
    };
    let (total, noise) = (sum(&|i| squares[i]), sum(&|i| variance[i]));
    let fourth = sum(&|i| variance[i] * variance[i]);
    if total <= noise + EXCESS * (2.0 * fourth).sqrt() {
        return (vec![0.0; parts.len()], 0.0, left.len() / 2);
    }
    let excess = |(pair, weight): &(Range<usize>, f64)| {
        let own = pair.clone().map(|i| squares[i] - variance[i]);
        weight * own.sum::<f64>().max(0.0)
    };
    let energy: Vec<f64> = all.clone().map(excess).collect();
    let sum: f64 = energy.iter().sum();
    let harmonics = (sum * sum / energy.iter().map(|p| p * p).sum::<f64>()).max(1.0);
    let by_run = parts.iter().map(|p| p.iter().map(excess).sum());
    (
        by_run.collect(),
        sum / (2.0 * harmonics),
        harmonics as usize,
    )
}

/// Best of equally spaced values of one unknown phase shift. The other shifts are fixed.
fn best_shift(solver: &Bounded, stack: Stack, at: &[f64], place: usize) -> f64 {
    let Shift { range, rates } = &stack.shifts[place];
    let rate = rates.iter().fold(0.0_f64, |m, r| m.max(*r));
    let step = std::f64::consts::TAU / SHIFTS as f64 / rate;
    let count = ((range[1] - range[0]) / step) as usize;
    let tried = (0..=count).map(|i| range[0] + step * i as f64);
    let error = |x: f64| {
        let mut at = at.to_vec();
        at[place] = x;
        (x, solver.solve(&stack.means(&at)).1)
    };
    let best = tried.map(error).min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or(range[0], |b| b.0)
}

/// Quantile 0.975 of Student's t distribution: tabulated for few degrees of freedom, otherwise by the Cornish–Fisher expansion.
pub(super) fn t95(degrees: usize) -> f64 {
    const FEW: [f64; 6] = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447];
    if let Some(known) = FEW.get(degrees.max(1) - 1) {
        return *known;
    }
    let (z, n) = (1.959_963_984_540_054_f64, degrees as f64);
    let first = (z.powi(3) + z) / 4.0;
    let second = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
    let third = (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / 384.0;
    z + first / n + second / (n * n) + third / (n * n * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (degrees, known) in [
            (1, 12.706),
            (4, 2.776),
            (5, 2.571),
            (7, 2.365),
            (10, 2.228),
            (30, 2.042),
            (120, 1.980),
        ] {
            assert!(
                (t95(degrees) - known).abs() < 2e-3,
                "{degrees}: {}",
                t95(degrees)
            );
        }
    }
}
