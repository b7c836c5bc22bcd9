//! Evaluation of a law, independent of its solver: objective and maximum excess, from samples refined by parabolas.

use super::reference::{Place, Reference};
use super::rows::Limit;
use super::swing;

/// Evaluation of a law, independent of its solver: optimal further variables, objective and maximum excess.
pub struct Judged {
    pub extras: Vec<f64>,
    pub value: f64,
    pub excess: f64,
    /// Largest excess; negative if the law is inside every limit.
    pub room: f64,
    pub worst: &'static str,
    /// Relative excess over the optimum that an uncertified law states.
    pub stated: f64,
}

/// Left side minus bound at the sampled angles.
fn samples(reference: &Reference, limit: &Limit, x: &[f64]) -> Vec<f64> {
    let sample = |place: &Place| {
        let mut sum = -reference.bound(limit, place.theta);
        for (d, weight) in limit.weights.iter().enumerate().filter(|w| *w.1 != 0.0) {
            let columns = reference.splines.columns(place.span).zip(&place.values[d]);
            sum += weight * columns.map(|(c, b)| x[c] * b).sum::<f64>();
        }
        sum
    };
    reference.scan.iter().map(sample).collect()
}

/// Positions of the largest violations: local maxima in each span, refined by parabolas.
pub fn crests(
    reference: &Reference,
    limit: &Limit,
    x: &[f64],
    above: f64,
) -> Vec<(usize, f64, f64)> {
    let samples = samples(reference, limit, x);
    let mut out = Vec::new();
    for (i, place) in reference.scan.iter().enumerate() {
        let beside = |k: usize| {
            (reference.scan.get(k))
                .filter(|p| p.ends == place.ends)
                .map(|p| (p.theta, samples[k]))
        };
        let (before, after) = (beside(i.wrapping_sub(1)), beside(i + 1));
        let lower = |other: Option<(f64, f64)>| other.is_none_or(|o| o.1 <= samples[i]);
        // What a crest between samples can rise above them.
        let further = [beside(i.wrapping_sub(2)), before, after, beside(i + 2)];
        let spread: f64 = further
            .iter()
            .flatten()
            .map(|o| (samples[i] - o.1).abs())
            .sum();
        if !lower(before) || !lower(after) || samples[i] + spread <= above {
            continue;
        }
        let mut best = (place.span, place.theta, samples[i]);
        let mut step = after.or(before).map_or(0.0, |o| (o.0 - place.theta).abs());
        let ends = place.ends;
        for _ in 0..3 {
            let at = |t: f64| reference.excess(limit, place.span, t, x);
            let middle = best.1.clamp(ends[0] + step, ends[1] - step);
            let [low, mid, high] = [middle - step, middle, middle + step].map(|t| (t, at(t)));
            let bend = low.1 - 2.0 * mid.1 + high.1;
            let shift = if bend < 0.0 {
                0.5 * step * (low.1 - high.1) / bend
            } else {
                0.0
            };
            let tip = middle + shift.clamp(-2.0 * step, 2.0 * step);
            let tip = tip.clamp(ends[0], ends[1]);
            for (t, e) in [low, mid, high, (tip, at(tip))] {
                if e > best.2 {
                    best = (place.span, t, e);
                }
            }
            step *= 0.1;
        }
        if best.2 > above {
            out.push(best);
        }
    }
    out
}

/// Maximum of left side minus bound.
fn largest(reference: &Reference, limit: &Limit, x: &[f64]) -> f64 {
    let samples = samples(reference, limit, x);
    let top = samples.iter().fold(f64::NEG_INFINITY, |m, s| m.max(*s));
    let all = crests(reference, limit, x, top);
    all.iter().fold(top, |m, c| m.max(c.2))
}

/// Evaluates a law with optimal further variables.
pub fn judge(reference: &Reference, x: &[f64]) -> Judged {
    let tops: Vec<f64> = (reference.limits.iter())
        .map(|l| largest(reference, l, x))
        .collect();
    // A variable that lowers left sides (weight −1) is what they need; one that raises them what they leave.
    let extras: Vec<f64> = (0..reference.extras.len())
        .map(|k| {
            let mine = reference
                .limits
                .iter()
                .zip(&tops)
                .filter(|(l, _)| l.extra.is_some_and(|e| e.0 == k));
            let down = mine
                .clone()
                .filter(|(l, _)| l.extra.is_some_and(|e| e.1 > 0.0));
            let below = down.map(|(_, top)| -top).reduce(f64::min);
            below.unwrap_or_else(|| mine.map(|(_, top)| *top).fold(f64::NEG_INFINITY, f64::max))
        })
        .collect();
    let (mut excess, mut worst) = (f64::NEG_INFINITY, "");
    for (limit, top) in reference.limits.iter().zip(&tops) {
        let taken = limit.extra.map_or(0.0, |(k, e)| e * extras[k]);
        let part = (top + taken) / limit.scale;
        if part > excess {
            (excess, worst) = (part, limit.name);
        }
    }
    let most = reference.asked.train.map_or(0.0, |t| t.most);
    for swing in &reference.swings {
        let size = most.max(swing::PART * reference.asked.length());
        let part = (reference.amplitude(swing, x).0 - most) / size;
        if part > excess {
            (excess, worst) = (part, "residual");
        }
    }
    let costs: f64 = (reference.extras.iter().zip(&extras))
        .map(|(e, y)| e.cost * y)
        .sum();
    Judged {
        value: reference.square(x) + costs,
        extras,
        excess: excess.max(0.0),
        room: excess,
        worst,
        stated: super::compare::AGREED,
    }
}
