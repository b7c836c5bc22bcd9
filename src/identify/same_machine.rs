//! Check that several logs are from the same machine.

use super::cycles::{CHANGE, SURPRISE};
use super::fit::Fit;
use super::least_squares::dot;
use super::log::Log;
use super::model::{Effect, Term};
use super::parameter::Parameter;
use super::run::Run;
use crate::error::{LogError, Result};
use crate::scene::{Scene, keys};
use crate::synth::Design;
use crate::units::{Dimension, Quantity};

/// Difference between two estimates, divided by the sum of the half widths of their 95 % intervals, above which the logs are from different
/// machines.
const APART: f64 = 1.5;

/// Rejects logs that no common set of parameters fits. `together` is the joint fit of all logs, and `alone` the separate fit of each log.
pub(super) fn check(
    (design, scene): (&Design, &Scene),
    (logs, runs): (&[Log], &[Run]),
    terms: &[Term],
    together: &Fit,
    alone: &[Fit],
) -> Result<()> {
    for (i, fit) in alone.iter().enumerate() {
        for (before, run) in alone[..i].iter().zip(runs) {
            if let Some(fault) = differs(scene, terms, fit, before, &run.name) {
                return Err(logs[i].refused(fault));
            }
        }
    }
    for (i, own) in alone.iter().enumerate() {
        let force = &runs[i].cycles.force;
        let alternating = dot(&force.mean[1..], &force.mean[1..]);
        let noise: f64 = force.variance().iter().sum();
        let excess = together.left[i] - own.left[0];
        if excess > CHANGE * CHANGE * alternating && excess > SURPRISE * (own.left[0] + noise) {
            let rms =
                |energy: f64| Quantity::force(design.problem.drive.newtons((0.5 * energy).sqrt()));
            let (together, alone) = (rms(together.left[i]), rms(own.left[0]));
            return Err(logs[i].refused(LogError::Inconsistent { together, alone }));
        }
    }
    Ok(())
}

/// Error for the first parameter whose identified values differ between two logs; `None` if all agree.
fn differs(
    scene: &Scene,
    terms: &[Term],
    own: &Fit,
    before: &Fit,
    other: &str,
) -> Option<LogError> {
    terms.iter().enumerate().find_map(|(j, term)| {
        let of = |fit: &Fit| match term.effect {
            Effect::Compliance => Parameter::inverse(term.key, fit.each[j]),
            _ => Parameter::of(term.key, fit.each[j], term.is_positive),
        };
        let [a, b] = [own, before].map(of);
        let half = |p: &Parameter| p.high.zip(p.low).map(|(high, low)| 0.5 * (high - low));
        let room = half(&a)? + half(&b)?;
        let is_apart = (a.value - b.value).abs() > APART * room;
        let dimension = match term.key {
            "guide.damping" => Dimension::Damping,
            key => keys::find(key)
                .and_then(|k| k.dimension(scene))
                .unwrap_or(Dimension::Force),
        };
        let quantity = |p: Parameter| Quantity::new(p.value, dimension);
        (a.identifiable && b.identifiable && is_apart).then(|| LogError::OtherMachine {
            key: term.key.to_string(),
            value: quantity(a),
            before: quantity(b),
            other: other.to_string(),
        })
    })
}
