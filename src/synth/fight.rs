//! Why no law keeps the loads: the smallest set of limits that fight, and the least relaxation of each, as
//! [`super::conflict`] has it for limits that are convex.

use super::answer::{Infeasible, Relaxation};
use super::conflict::told;
use super::loads::Loads;
use super::nonconvex::Beyond;
use super::qp::{Meaning, Program};
use super::sequence;
use crate::cam::Measures;

/// A limit is eased to no more than this many times its value.
const MOST: f64 = 1e6;
/// The least relaxation is known to this part of itself.
const RESOLVED: f64 = 1e-4;

/// Explains a program whose solutions keep every limit but the loads.
pub fn explain(program: &Program, beyond: Beyond, measures: Measures) -> Infeasible {
    let loads = beyond.loads.map_or(Vec::new(), |l| l.named());
    let mut names: Vec<&'static str> = Vec::new();
    for name in program
        .limits
        .iter()
        .map(|l| l.name)
        .chain(loads.iter().map(|l| l.0))
    {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let mut kept = names.clone();
    for name in &names {
        let without: Vec<&'static str> = kept.iter().copied().filter(|n| n != name).collect();
        if !keeps(&only(program, &without), only_loads(beyond, &without)) {
            kept = without;
        }
    }
    let (program, beyond) = (only(program, &kept), only_loads(beyond, &kept));
    let relaxations = kept
        .iter()
        .filter_map(|name| match loads.iter().find(|l| l.0 == *name) {
            Some(&(_, from)) => Some(relax_load(&program, beyond, name, from)),
            None => relax_limit(&program, beyond, name),
        })
        .collect();
    told(&kept, relaxations, measures)
}

fn only(program: &Program, names: &[&'static str]) -> Program {
    let mut out = program.clone();
    out.limits
        .retain(|l| l.is_peak() || names.contains(&l.name));
    out
}

fn only_loads(beyond: Beyond, names: &[&'static str]) -> Beyond {
    let left_out = |loads: Loads| {
        loads
            .named()
            .into_iter()
            .filter(|l| !names.contains(&l.0))
            .fold(loads, |loads, (name, _)| loads.with(name, None))
    };
    Beyond {
        loads: beyond.loads.map(left_out),
        ..beyond
    }
}

/// Whether a law was found that keeps everything.
fn keeps(program: &Program, beyond: Beyond) -> bool {
    let solved = program.solve().ok();
    solved.is_some_and(|own| sequence::feasible(program, &own, beyond).is_some())
}

fn relax_load(program: &Program, beyond: Beyond, name: &str, from: f64) -> Relaxation {
    let to = least(from, |value| {
        let loads = beyond.loads.map(|l| l.with(name, Some(value)));
        keeps(program, Beyond { loads, ..beyond })
    });
    Relaxation {
        limit: name.to_string(),
        from,
        to,
    }
}

/// `None` for what is no positive number of the scene that may grow.
fn relax_limit(program: &Program, beyond: Beyond, name: &'static str) -> Option<Relaxation> {
    let first = program.limits.iter().find(|l| l.name == name)?;
    let Meaning::Value { factor, offset } = first.meaning else {
        return None;
    };
    let from = factor * first.bound + offset;
    if factor <= 0.0 || from <= 0.0 {
        return None;
    }
    let to = least(from, |value| {
        let mut eased = program.clone();
        for limit in eased.limits.iter_mut().filter(|l| l.name == name) {
            limit.bound = (value - offset) / factor;
        }
        keeps(&eased, beyond)
    });
    Some(Relaxation {
        limit: name.to_string(),
        from,
        to,
    })
}

/// The least value above `from` that is enough, found by doubling and halving; every value returned was
/// seen to be enough.
fn least(from: f64, enough: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut low, mut high) = (from, 2.0 * from);
    while !enough(high) {
        low = high;
        high *= 2.0;
        if high > MOST * from {
            return None;
        }
    }
    while high - low > RESOLVED * high {
        let middle = 0.5 * (low + high);
        if enough(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}
