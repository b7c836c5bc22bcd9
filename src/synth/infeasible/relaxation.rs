//! What would let a refused cam exist: of every limit the smallest change with which the whole design
//! passes, found by designing it.
//!
//! The convex program's own elastic answer (`iis`) knows only its rows; a size that follows the law, a
//! check on the finished profile or the accuracy may still refuse. Here every stated value has been designed
//! with and has passed.

use std::sync::Arc;

use super::beside::beside;
use super::reasons::{changes, smallest_relaxations};
use super::relaxable::{Relaxable, relaxables};
use crate::cam::{Criterion, LimitKind, Verdict};
use crate::halt::Halt;
use crate::problem::{Note, Problem};
use crate::scene::{Family, Minimise};
use crate::synth::design::reason::Reason;
use crate::synth::design::{Conflicting, Design, Relaxation, Tier};
use crate::synth::search::Search;
use crate::synth::verdict::verdict;
use crate::units::Quantity;

/// The value is found to this part of it; costly designs to `COARSE`.
const FINE: f64 = 2e-5;
const COARSE: f64 = 1e-3;
/// Part by which a value from the convex program is enlarged for a design to pass with it …
const ROOM: f64 = 1e-3;
/// … and smaller ones, tried first to last where it does.
const LESS_ROOM: [f64; 2] = [0.0, 1e-4];
/// … and a value from the search.
const EDGES: [f64; 4] = [0.0, 1e-4, 1e-3, 1e-2];
/// A change by more than this factor, or by this share, makes another scene.
const FAR: f64 = 10.0;
/// The share that is tried first.
const SMALL: f64 = 0.01;
/// Part by which a value must be able to come back towards the old one for a better one to be sought.
const BACK: f64 = 1e-3;

impl Design {
    /// The design with its relaxations: those of a conflict are tried and corrected, those of a failed check
    /// computed. A design that passes stays as it is.
    #[must_use]
    pub fn relaxed(self) -> Design {
        self.relaxed_with(&Search::default())
    }

    /// The same in the search that made the design: with its cache and its end.
    #[must_use]
    pub fn relaxed_with(self, search: &Search) -> Design {
        // No limit changes the mean of the force, what is open about the recording, nor a law that is prescribed.
        let hopeless = self.reasons.iter().any(|reason| {
            matches!(
                reason,
                Reason::MeanForce { .. }
                    | Reason::RecordingKind { .. }
                    | Reason::RecordingClock { .. }
                    | Reason::RecordingMass { .. }
                    | Reason::RecordingClipped { .. }
                    | Reason::LiftJumps { .. }
                    | Reason::VelocityJumps { .. }
                    | Reason::LimitUnbounded { .. }
            )
        });
        if hopeless || passes(&self) {
            return self;
        }
        let problem = Arc::clone(&self.problem);
        with_relaxations(&problem, search, self)
    }
}

fn with_relaxations(problem: &Problem, search: &Search, mut design: Design) -> Design {
    let numbers = relaxables(problem);
    if numbers.is_empty() {
        return design;
    }
    let known: Vec<Relaxation> = design
        .infeasible
        .as_ref()
        .map_or_else(Vec::new, |i| i.relaxations.clone());
    let relaxing = Relaxing {
        problem,
        search,
        force: design
            .force
            .target_mean_n
            .abs()
            .max(design.drive.rest_force.abs()),
        precision: match design.solver.tier {
            Tier::Spectral | Tier::Equality => FINE,
            _ => COARSE,
        },
    };
    let relaxation = |&(number, from): &(Relaxable, f64), halt: &Halt| {
        if halt.is_asked() {
            return None;
        }
        let hint = known
            .iter()
            .find(|r| r.limit == number.criterion())
            .and_then(|r| r.to);
        let search = search.ended_by(halt);
        let relaxing = Relaxing {
            search: &search,
            ..relaxing
        };
        let to = match relaxing.own_accuracy(number, &design) {
            Some(own) => own,
            None => relaxing.smallest(number, from, hint),
        };
        to.map(|to| told(number, from, to))
    };
    let tried = beside(&numbers, &search.halt, relaxation);
    let found: Vec<Relaxation> = tried.into_iter().flatten().collect();
    let measures = problem.cam.measures();
    let (cures, together) = if found.is_empty() && !search.halt.is_asked() {
        relaxing.several(&numbers, &design.reasons)
    } else {
        let far = found.iter().all(|r| relaxing.is_far(r)) && !found.is_empty();
        let cure = if far {
            Reason::FarRelaxations {
                changes: changes(&found, measures),
            }
        } else {
            smallest_relaxations(&found, measures)
        };
        (vec![cure], Vec::new())
    };
    match &mut design.infeasible {
        Some(infeasible) => {
            // Members of the conflict whose change does not help are listed without a value.
            let helpless = known.iter().filter(|k| {
                !found.iter().any(|f| f.limit == k.limit)
                    && infeasible.conflict.contains(&Conflicting::Limit(k.limit))
            });
            let helpless: Vec<Relaxation> = helpless
                .map(|k| Relaxation {
                    to: None,
                    ..k.clone()
                })
                .collect();
            infeasible.reasons.truncate(1);
            infeasible.reasons.extend(cures);
            infeasible.relaxations = [found.clone(), helpless].concat();
            design.reasons.clone_from(&infeasible.reasons);
        }
        None => {
            // With the size in the relaxation the law changes too: the radius that this law needs does not apply.
            let resized = (numbers.iter())
                .any(|(number, _)| number.key.section() == "cam" && is_found(&found, *number));
            let own = |r: &Reason| matches!(r, Reason::BaseRadiusWorks { .. });
            design.reasons.retain(|r| !(resized && own(r)));
            design.reasons.extend(cures);
        }
    }
    design.relaxations = found;
    if search.halt.is_asked() && !design.out_of_time {
        design.out_of_time = true;
        design.notes.push(Note::OutOfTime);
    }
    design.together = together;
    design
}

fn is_found(found: &[Relaxation], number: Relaxable) -> bool {
    found.iter().any(|f| f.key == number.key.path)
}

fn passes(design: &Design) -> bool {
    design.verdict != Verdict::Unacceptable
}

/// The problem with these values.
fn changed(problem: &Problem, values: &[(Relaxable, f64)]) -> Problem {
    let start = problem.clone();
    (values.iter()).fold(start, |problem, (number, value)| {
        number.with(&problem, *value)
    })
}

fn told(number: Relaxable, from: f64, to: f64) -> Relaxation {
    Relaxation {
        limit: number.criterion(),
        key: number.key.path,
        from,
        to: Some(to),
    }
}

/// The whole design, where it passes.
fn passing(problem: &Problem, search: &Search) -> Option<Design> {
    let search = search.for_passing_designs();
    let design = crate::synth::passing_design(problem, &search).ok()?;
    passes(&design).then_some(design)
}

struct Relaxing<'a> {
    problem: &'a Problem,
    /// Its cache and its end.
    search: &'a Search,
    /// Size of the force, N.
    force: f64,
    precision: f64,
}

impl Relaxing<'_> {
    /// The design with one value changed, where it passes.
    fn tried(&self, number: Relaxable, value: f64) -> Option<Design> {
        passing(&number.with(self.problem, value), self.search)
    }

    /// The value of the convex program, or a little more, where the design passes with it and not with less.
    fn near(&self, number: Relaxable, hint: f64) -> Option<f64> {
        let eased = |room: f64| number.rounded(hint + room * hint.abs() * number.sign());
        // Next to the edge of what exists a program is hard to solve: where a little room does not help, nothing does.
        let weakest = eased(ROOM);
        self.tried(number, weakest)?;
        for room in LESS_ROOM {
            let to = eased(room);
            if self.tried(number, to).is_none() {
                continue;
            }
            let back = to - BACK * to.abs() * number.sign();
            return (room > 0.0 || self.tried(number, back).is_none()).then_some(to);
        }
        Some(weakest)
    }

    /// The value nearest to `from` with which the design passes, rounded to the weak side.
    fn smallest(&self, number: Relaxable, from: f64, hint: Option<f64>) -> Option<f64> {
        if let Some(to) = hint.and_then(|hint| self.near(number, hint)) {
            return Some(to);
        }
        let free = number.away(from, self.force);
        let design = self.tried(number, free)?;
        // What the unlimited design needs is sufficient, and often the answer.
        let needed = design
            .checks
            .iter()
            .filter(|c| number.is_measured_by(c.name))
            .map(|c| {
                if number.is_accuracy() {
                    c.worst / self.force_mean()
                } else {
                    c.worst
                }
            })
            .reduce(|a, b| if number.grows() { a.max(b) } else { a.min(b) });
        let (mut works, mut fails) = (free, from);
        // At its own edge a design may fail that passes with a little room.
        for (needed, room) in needed.iter().flat_map(|n| EDGES.map(|room| (n, room))) {
            let value = number.rounded(needed + room * needed.abs() * number.sign());
            if self.tried(number, value).is_some() {
                works = value;
                break;
            }
            fails = value;
        }
        // No law needs less than one that was found to need the least.
        if let Some(least) = needed.filter(|_| self.is_minimised(number)) {
            fails = least;
        }
        let size = from.abs().max(1e-3 * works.abs());
        while !self.search.halt.is_asked()
            && (works - fails).abs() > self.precision * works.abs().max(size)
        {
            // Wide intervals are bisected geometrically.
            let apart = if fails > 0.0 { works / fails } else { 1.0 };
            let middle = if apart > 4.0 {
                (works * fails).sqrt()
            } else {
                0.5 * (works + fails)
            };
            if self.tried(number, middle).is_some() {
                works = middle;
            } else {
                fails = middle;
            }
        }
        // At the boundary of feasibility a program may fail numerically; a slightly weaker one is solved.
        EDGES
            .iter()
            .map(|room| number.rounded(works + room * works.abs() * number.sign()))
            .find(|&to| to == works || self.tried(number, to).is_some())
    }

    /// Whether the law is chosen to make it small.
    fn is_minimised(&self, number: Relaxable) -> bool {
        let is_size = number.key.limit == Some(LimitKind::PrimeRadius);
        is_size && self.problem.objective() == Minimise::Size
    }

    /// With given spans the error that is minimised does not depend on the accuracy: then only the accuracy of the design itself can help, and
    /// only if nothing else fails. The outer `None` where it has to be searched for.
    fn own_accuracy(&self, number: Relaxable, design: &Design) -> Option<Option<f64>> {
        let law = &self.problem.law;
        let given = law.spans.is_some() && law.family == Family::Spline;
        if !number.is_accuracy() || !given || self.problem.limited_error().is_some() {
            return None;
        }
        if design.infeasible.is_some() {
            return Some(None);
        }
        let to = number.rounded(design.force.rms_error_n / self.force_mean());
        let eased = number.with(self.problem, to);
        let mut checks = design.checks.clone();
        checks.retain(|c| c.name != Criterion::RmsError);
        let (verdict, _) = verdict(&eased, &design.cam, &checks, &design.force);
        Some((verdict != Verdict::Unacceptable).then_some(to))
    }

    fn force_mean(&self) -> f64 {
        let mean = self.problem.target_mean();
        if mean > 0.0 {
            mean
        } else {
            self.force.max(f64::MIN_POSITIVE)
        }
    }

    /// Whether a relaxation changes the scene beyond recognition.
    fn is_far(&self, relaxation: &Relaxation) -> bool {
        let Some(to) = relaxation.to else {
            return false;
        };
        let (from, to) = (relaxation.from.abs(), to.abs());
        from.max(to) > FAR * from.min(to).max(1e-3 * self.force_or(from))
    }

    fn force_or(&self, other: f64) -> f64 {
        if other > 0.0 { 0.0 } else { self.force }
    }

    /// Reasons and values for changes of several limits, where no single change is sufficient.
    fn several(
        &self,
        numbers: &[(Relaxable, f64)],
        known: &[Reason],
    ) -> (Vec<Reason>, Vec<Relaxation>) {
        if let Some((share, all)) = self.together(numbers) {
            let share = Quantity::share(share);
            return (vec![Reason::AllTogether { share }], all);
        }
        let measures = self.problem.cam.measures();
        let free: Vec<(Relaxable, f64)> = (numbers.iter())
            .map(|&(number, from)| (number, number.away(from, self.force)))
            .collect();
        let without = changed(self.problem, &free);
        match crate::synth::design(&without, self.search) {
            Ok(design) if !passes(&design) => {
                let mut reasons = vec![Reason::NotTheLimits];
                reasons.extend(design.reasons.into_iter().filter(|r| !known.contains(r)));
                return (reasons, Vec::new());
            }
            Ok(_) => {}
            Err(_) => return (vec![Reason::NoRelaxation], Vec::new()),
        }
        // Limits that cannot hold even without the others.
        let out_of_reach = |&(number, from): &(Relaxable, f64), halt: &Halt| {
            let own = |&(other, far): &(Relaxable, f64)| {
                let value = if other == number { from } else { far };
                (other, value)
            };
            let others: Vec<(Relaxable, f64)> = free.iter().map(own).collect();
            let alone = changed(self.problem, &others);
            let search = self.search.ended_by(halt);
            if halt.is_asked() || passing(&alone, &search).is_some() {
                return None;
            }
            let relaxing = Relaxing {
                problem: &alone,
                search: &search,
                ..*self
            };
            let to = relaxing.smallest(number, from, None)?;
            Some((number, from, to))
        };
        let tried = beside(numbers, &self.search.halt, out_of_reach);
        let hopeless: Vec<(Relaxable, f64, f64)> = tried.into_iter().flatten().collect();
        if hopeless.is_empty() {
            return (vec![Reason::NoRelaxation], Vec::new());
        }
        let out_of_reach: Vec<Relaxation> = (hopeless.iter())
            .map(|&(number, from, to)| told(number, from, to))
            .collect();
        // Each at its own boundary, they may conflict with each other or with the other limits.
        let alone: Vec<(Relaxable, f64)> = hopeless.iter().map(|h| (h.0, h.2)).collect();
        let reached = changed(self.problem, &alone);
        let relaxing = Relaxing {
            problem: &reached,
            ..*self
        };
        let all: Vec<(Relaxable, f64)> = (numbers.iter())
            .map(|&(number, from)| {
                let value = alone.iter().find(|a| a.0 == number).map_or(from, |a| a.1);
                (number, value)
            })
            .collect();
        let eased = relaxing
            .together(&alone)
            .or_else(|| relaxing.together(&all));
        match eased {
            Some((_, mut values)) => {
                for value in &mut values {
                    let own = numbers.iter().find(|n| n.0.criterion() == value.limit);
                    value.from = own.map_or(value.from, |n| n.1);
                }
                let changes = changes(&values, measures);
                (vec![Reason::FarTogether { changes }], values)
            }
            None => {
                let changes = changes(&out_of_reach, measures);
                (vec![Reason::OutOfReach { changes }], Vec::new())
            }
        }
    }

    /// The smallest share by which all limits can be relaxed together, with the values.
    fn together(&self, numbers: &[(Relaxable, f64)]) -> Option<(f64, Vec<Relaxation>)> {
        let eased = |part: f64| -> Vec<(Relaxable, f64)> {
            let by = |&(k, from): &(Relaxable, f64)| (k, k.eased(from, part, self.force));
            numbers.iter().map(by).collect()
        };
        let holds =
            |part: f64| passing(&changed(self.problem, &eased(part)), self.search).is_some();
        if !holds(FAR) {
            return None;
        }
        let (mut works, mut fails) = (FAR, 0.0);
        while works - fails > 1e-2 * works && !self.search.halt.is_asked() {
            // A small share is sought first, then far apart the middle by ratio.
            let middle = match works / fails {
                apart if apart.is_infinite() => SMALL,
                apart if apart > 4.0 => (works * fails).sqrt(),
                _ => 0.5 * (works + fails),
            };
            if works <= SMALL && fails == 0.0 {
                break;
            }
            if holds(middle) {
                works = middle;
            } else {
                fails = middle;
            }
        }
        let all = (eased(works).into_iter().zip(numbers))
            .map(|((number, to), &(_, from))| told(number, from, to));
        Some((works, all.collect()))
    }
}
