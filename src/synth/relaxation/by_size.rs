//! Relaxations for a scene whose smallest cam exceeds the limit on the prime radius. Each trial changes one value and computes the smallest
//! cam. The prime radius of this cam is compared with the limit.

use super::relaxable::Relaxable;
use crate::cam::LimitKind;
use crate::problem::{Problem, Size};
use crate::scene::{Family, Minimise};
use crate::synth::design::Design;
use crate::synth::search::Search;
use crate::synth::synthesis::kept;

/// Maximum number of trials of one value.
const TRIALS: usize = 12;
/// Factor by which the limit on the prime radius is multiplied to make it inactive.
const NO_LIMIT: f64 = 10.0;
/// Relative extension of a step beyond the value that the slope predicts, so that the smallest cam satisfies the limit after the step.
const BEYOND: f64 = 0.02;
/// Relative first step if the slope is unknown.
const FIRST_STEP: f64 = 0.05;

/// The smallest cam of a scene, whose prime radius exceeds its limit.
pub struct BySize<'a> {
    /// Problem of the smallest cam.
    open: Problem,
    search: &'a Search,
    /// Limit on the prime radius, m.
    most: f64,
    smallest: Design,
}

impl<'a> BySize<'a> {
    /// Computes the smallest cam. `None` if law and size are not variables of one program, or if the smallest cam satisfies the limit.
    pub fn of(problem: &Problem, search: &'a Search) -> Option<Self> {
        let kind = LimitKind::PrimeRadius;
        let most = problem.limits[kind]?;
        if problem.size() != Size::Sought || problem.law.family != Family::Spline {
            return None;
        }
        let open = problem.with(kind.into(), NO_LIMIT * most);
        let open = open.minimising(Minimise::Size);
        let smallest = kept(&open, search).ok()??;
        (radius(&smallest) > most).then_some(BySize {
            open,
            search,
            most,
            smallest,
        })
    }

    /// Value for which the smallest cam has the permitted size; `None` if no value is sufficient. The value is found by regula falsi, with
    /// the first slope from the multipliers. `range` contains a value for which the cam is too large, and a value at which the relaxed limit
    /// has no effect.
    pub fn value(
        &self,
        number: Relaxable,
        range: [f64; 2],
        precise: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        if number.key.limit == Some(LimitKind::PrimeRadius) {
            return Some(radius(&self.smallest));
        }
        let binds = |limit| number.is_measured_by(limit);
        if !self.smallest.binding.iter().any(|b| binds(b.limit)) {
            return None;
        }
        let [mut fails, free] = range;
        let mut outside = radius(&self.smallest) - self.most;
        let mut step = match self.worth(number) {
            worth if worth > 0.0 => outside / worth,
            _ => FIRST_STEP * fails.abs(),
        };
        let mut works: Option<(f64, f64)> = None;
        for _ in 0..TRIALS {
            let value = match works {
                None => fails + number.sign() * ((1.0 + BEYOND) * step).min((free - fails).abs()),
                Some((inner, inside)) => {
                    let room = 0.5 * precise(inner) / (inner - fails).abs();
                    if room >= 0.5 {
                        return Some(inner);
                    }
                    let part = (outside / (outside - inside)).clamp(room, 1.0 - room);
                    fails + part * (inner - fails)
                }
            };
            let smallest = kept(&number.with(&self.open, value), self.search).ok()??;
            let found = radius(&smallest) - self.most;
            if found > 0.0 && value == free {
                return None;
            }
            let slope = (outside - found) / (value - fails).abs();
            if found > 0.0 {
                step = if slope > 0.0 {
                    found / slope
                } else {
                    f64::INFINITY
                };
                (fails, outside) = (value, found);
                // The weight of the unchanged end of the range is halved (Illinois method), so that this end moves too.
                if let Some((_, inside)) = &mut works {
                    *inside *= 0.5;
                }
            } else {
                if -found <= slope * precise(value) {
                    return Some(value);
                }
                works = Some((value, found));
            }
        }
        works.map(|(value, _)| value)
    }

    /// Decrease of the prime radius of the smallest cam per unit by which a value is relaxed.
    fn worth(&self, number: Relaxable) -> f64 {
        let all = self.smallest.easing.iter();
        let own = all.filter(|easing| number.is_measured_by(easing.limit));
        own.map(|e| (e.before - e.after) / (e.to - e.from).abs())
            .sum()
    }
}

fn radius(design: &Design) -> f64 {
    design.cam.follower.prime_radius()
}
