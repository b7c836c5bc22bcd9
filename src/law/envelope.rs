//! Laws derived from laws: a phase shift, and the higher of two.

use super::{Law, pieces::Pieces};

/// Parts shorter than this share of the extent are rounding of a crossing.
const SLIVER: f64 = 1e-12;

impl Law {
    /// The closed law as it looks when the cam is mounted `ahead` rad ahead: s(θ + ahead), on the same
    /// extent. Open laws come back unchanged.
    #[must_use]
    pub fn ahead(&self, ahead: f64) -> Law {
        let (start, length) = self.extent();
        let cut = self.wrap(start + ahead);
        if !self.is_closed() || cut == start {
            return self.clone();
        }
        let mut pieces = Pieces::starting_at(start);
        pieces.push_part(self, cut, start + length);
        pieces.push_part(self, start, cut);
        pieces.end_exactly_at(start + length);
        match pieces.finish(true) {
            Some(law) => law,
            None => self.clone(),
        }
    }

    /// The higher of two laws on the same extent at every θ, with the angles at which the lead changes
    /// (`true`: from there on the first is the higher one, or they are equal). The wrap counts as a change
    /// when it is one.
    pub fn higher_of(first: &Law, second: &Law) -> (Law, Vec<(f64, bool)>) {
        let (start, length) = first.extent();
        let changes = lead_changes(first, second);
        let mut pieces = Pieces::starting_at(start);
        let mut starts: Vec<f64> = changes.iter().map(|c| c.0).collect();
        starts.push(start + length);
        if starts[0] > start {
            // The last lead of the turn also opens it.
            let lead = changes[changes.len() - 1].1;
            pieces.push_part(if lead { first } else { second }, start, starts[0]);
        }
        for (i, &(from, lead)) in changes.iter().enumerate() {
            pieces.push_part(if lead { first } else { second }, from, starts[i + 1]);
        }
        pieces.end_exactly_at(start + length);
        let law = match pieces.finish(first.is_closed()) {
            Some(law) => law,
            None => first.clone(),
        };
        (law, changes)
    }
}

/// Starts of the stretches on which one of the laws leads, in order; at least one. A stretch on which
/// they are equal counts to the first.
fn lead_changes(first: &Law, second: &Law) -> Vec<(f64, bool)> {
    let (start, length) = first.extent();
    let scale = first.stroke().max(second.stroke());
    let mut cuts = vec![start];
    for law in [first, second] {
        cuts.extend_from_slice(law.breaks());
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| (*a - *b).abs() <= SLIVER * length);
    let difference = |x: f64| first.svaj(x).s - second.svaj(x).s;
    let mut found: Vec<f64> = Vec::new();
    for w in cuts.windows(2) {
        found.push(w[0]);
        let on = [w[0], w[1]];
        let proxy = crate::poly::stand_in(&on, 1e-13, |_, x| difference(x) / scale.max(1e-300));
        found.extend(
            proxy
                .roots()
                .into_iter()
                .map(|x| polish(x, w[0], w[1], &difference)),
        );
    }
    found.push(start + length);
    found.sort_by(f64::total_cmp);
    found.dedup_by(|a, b| (*a - *b).abs() <= SLIVER * length);
    let mut changes: Vec<(f64, bool)> = Vec::new();
    for w in found.windows(2) {
        let lead = difference(0.5 * (w[0] + w[1])) >= -1e-14 * scale;
        if changes.last().is_none_or(|c| c.1 != lead) {
            changes.push((w[0], lead));
        }
    }
    // The turn's first stretch continues its last one: no change at the wrap.
    if first.is_closed() && changes.len() > 1 && changes[0].1 == changes[changes.len() - 1].1 {
        changes.remove(0);
    }
    changes
}

/// Halving around a root of the stand-in until the true difference changes sign within rounding.
fn polish(x: f64, low: f64, high: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let reach = 1e-6 * (high - low);
    let (mut a, mut b) = ((x - reach).max(low), (x + reach).min(high));
    if f(a) * f(b) >= 0.0 {
        return x;
    }
    let rising = f(a) < 0.0;
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if (f(middle) < 0.0) == rising {
            a = middle;
        } else {
            b = middle;
        }
    }
    0.5 * (a + b)
}
