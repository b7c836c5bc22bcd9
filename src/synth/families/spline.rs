//! Spline family: minimum force error or another objective, with equalities and limits.

use super::formulation;
use super::solved::{SolvedLaw, solved_law};
use crate::error::Result;
use crate::problem::{Note, Problem};
use crate::scene::{Family, Minimise};
use crate::synth::optimum::{self, Optimum, Sought};
use crate::synth::qp;
use crate::synth::search::Search;
use crate::units::Quantity;

/// Minimum automatic number of spans.
const FEWEST: usize = 3;
/// Maximum automatic number of spans.
const MOST_AUTO_SPANS: usize = 400;
/// Number of spans for laws without a target force.
const SPANS_WITHOUT_FORCE: usize = 48;
/// Minimum automatic number of spans of a law with a force band.
const FEWEST_IN_BAND: usize = 8;
/// Maximum automatic number of spans of a law with a force band or a limited force error.
const MOST_IN_BAND: usize = 120;
/// Factor between successive trial numbers of spans if limits are active.
const GROWTH: f64 = 1.5;
/// Minimum relative decrease of the force error for which the number of spans is increased again.
pub const WORTHWHILE: f64 = 0.02;
/// Number of spans below which there may be no feasible law if limits are active. Below this number, the force error may increase with the
/// number of spans.
pub const TELLING: usize = 12;

/// Spline law of a problem, with the method of its solution.
pub fn spline_law(problem: &Problem, search: &Search) -> Sought<SolvedLaw> {
    let (mut optimum, spans) = match fit(problem, search)? {
        Ok(found) => found,
        Err(refusal) => return Ok(Err(refusal)),
    };
    optimum::with_profile(problem, search, &mut optimum);
    let (objective, report) = (problem.objective(), optimum.report());
    Ok(Ok(SolvedLaw {
        degree: problem.spline_degree,
        spans,
        ..solved_law(problem, &optimum, Family::Spline, objective, report)
    }))
}

/// How the number of spans is determined.
enum Spans {
    /// The given number. The scene contains it, or it is the default without a target force.
    Given(usize),
    /// The minimum number in a range, from the first to the second value, for which the force band or the accuracy is feasible.
    Fewest(usize, usize),
    /// A number that is sufficient for the given RMS force error, N, without limits. If limits are active, the number may be increased.
    AtLeast(usize, f64),
}

/// Optimum with the number of spans in the scene, or with an automatic number. The second value is the sufficient number of spans. The
/// returned optimum may have more spans.
fn fit(problem: &Problem, search: &Search) -> Sought<(Optimum, usize)> {
    let optimum = match spans(problem, search)? {
        Spans::Given(spans) => solve(problem, search, spans)?,
        Spans::Fewest(from, most) => fewest(problem, search, from, most)?,
        Spans::AtLeast(spans, wanted) => return while_worthwhile(problem, search, spans, wanted),
    };
    Ok(optimum.map(|optimum| {
        let spans = optimum.formulation.pieces;
        (optimum, spans)
    }))
}

/// How the number of spans of a problem is determined, with the number at which the search begins.
fn spans(problem: &Problem, search: &Search) -> Result<Spans> {
    if let Some(spans) = problem.law.spans {
        return Ok(Spans::Given(spans));
    }
    if problem.band.is_some() {
        let from = search.least_spans.max(FEWEST_IN_BAND);
        return Ok(Spans::Fewest(from, from.max(MOST_IN_BAND)));
    }
    let of_force = [Minimise::ForceError, Minimise::PeakForceError];
    let follows = problem.target.is_some() && of_force.contains(&problem.objective());
    let wanted = match problem.limited_error() {
        _ if follows => problem.wanted_error(),
        Some(most) => most,
        None => return Ok(Spans::Given(SPANS_WITHOUT_FORCE)),
    };
    let spans = problem.spans_without_limits(wanted, search.least_spans, || {
        fewest_without_limits(problem, search, wanted)
    })?;
    Ok(if follows {
        Spans::AtLeast(spans, wanted)
    } else {
        let spans = spans.max(SPANS_WITHOUT_FORCE);
        Spans::Fewest(spans, spans.max(MOST_IN_BAND))
    })
}

/// Minimum number of spans for which the force error without limits is at most `wanted`, N. It is a lower bound of the number with limits, and
/// is fast to compute.
fn fewest_without_limits(problem: &Problem, search: &Search, wanted: f64) -> Result<usize> {
    let mut spans = search.least_spans.max(FEWEST);
    while spans < MOST_AUTO_SPANS {
        let (program, force) = formulation::unlimited(problem, search, spans)?;
        match qp::solve_equalities(&program) {
            Ok(u) if force.root(&u.x) <= wanted => break,
            _ => spans = (spans + 1 + spans / 40).min(MOST_AUTO_SPANS),
        }
    }
    Ok(spans)
}

/// Next larger trial number of spans or harmonics.
pub fn larger(size: usize) -> usize {
    let next = (size as f64 * GROWTH) as usize;
    next.max(size + 1).min(MOST_AUTO_SPANS)
}

/// Increases the number of spans while the force error under active limits decreases sufficiently. Returns the best optimum and the sufficient
/// number of spans.
fn while_worthwhile(
    problem: &Problem,
    search: &Search,
    mut spans: usize,
    wanted: f64,
) -> Sought<(Optimum, usize)> {
    let mut best: Option<(f64, Optimum)> = None;
    loop {
        let optimum = match (solve(problem, search, spans)?, best.take()) {
            (Err(_), Some((_, earlier))) => {
                let spans = earlier.formulation.pieces;
                return Ok(Ok((earlier, spans)));
            }
            (Err(why), None)
                if !search.halt.is_asked()
                    && (spans < TELLING || spans < MOST_IN_BAND && why.is_of_accuracy()) =>
            {
                spans = (2 * spans).max(TELLING);
                continue;
            }
            (Err(why), None) => return Ok(Err(why)),
            (Ok(optimum), earlier) => {
                best = earlier;
                optimum
            }
        };
        let error = optimum.force_error();
        let reached = error <= wanted;
        let earlier = best.as_ref().filter(|_| spans >= TELLING);
        let enough = earlier.filter(|(e, _)| error > e * (1.0 - WORTHWHILE));
        let enough = enough.map(|(_, earlier)| earlier.formulation.pieces);
        let better = match best {
            Some(earlier) if earlier.0 <= error => earlier,
            _ => (error, optimum),
        };
        if reached || enough.is_some() || spans >= MOST_AUTO_SPANS || search.halt.is_asked() {
            return Ok(Ok((better.1, enough.unwrap_or(spans))));
        }
        best = Some(better);
        spans = larger(spans);
    }
}

/// Optimum with the minimum number of spans, from `spans` to `most`, for which a law is feasible. If no number is feasible, the reason for the
/// last number is returned. Only a force band or an accuracy can become feasible with more spans.
fn fewest(problem: &Problem, search: &Search, mut spans: usize, most: usize) -> Sought<Optimum> {
    loop {
        match solve(problem, search, spans)? {
            Err(why)
                if spans < most
                    && !search.halt.is_asked()
                    && (problem.band.is_some() || why.is_of_accuracy()) =>
            {
                spans = ((spans as f64 * GROWTH) as usize).min(most);
            }
            outcome => return Ok(outcome),
        }
    }
}

/// Optimum with a given number of spans.
fn solve(problem: &Problem, search: &Search, spans: usize) -> Sought<Optimum> {
    let formulation = formulation::of_spline(problem, search, spans)?;
    Ok(optimum::solve(problem, search, formulation))
}

/// Ratio of the automatic accuracies with and without sensor noise above which a note is added.
const NOTED: f64 = 1.05;
/// Automatic number of spans above which a note states the reason.
const MANY: usize = 100;

/// Notes on the automatic number of spans (or of harmonics in closed form). They state whether the spread or the noise of the recording
/// limits this number, or whether the required accuracy needs many spans.
pub fn notes_on_size(problem: &Problem, family: Family, spans: usize) -> Vec<Note> {
    let is_spline = family == Family::Spline;
    let auto = match problem.law.family {
        Family::Spline => problem.law.spans.is_none(),
        asked => asked == Family::Auto,
    };
    let many = is_spline && spans > MANY && problem.law.spans.is_none();
    if !auto || problem.objective() != Minimise::ForceError {
        let most = problem.limited_error().map(Quantity::force);
        let note = match most.filter(|_| problem.band.is_none()) {
            Some(error) => Note::ManySpans { spans, error },
            None => Note::ManySpansInBand { spans },
        };
        return many.then_some(note).into_iter().collect();
    }
    let size = if is_spline { "spans" } else { "harmonics" };
    let error = Quantity::force(problem.wanted_error());
    let noise = problem.sensor_noise();
    let limited = problem.error_at_noise().map(|limit| match noise > 0.0 {
        true => (limit > NOTED * problem.asked_error()).then_some(Note::SensorNoise {
            size,
            noise: Quantity::force(noise),
            error,
        }),
        false => Some(Note::Noise { size, error }),
    });
    let many = many.then_some(Note::ManySpans { spans, error });
    limited.flatten().into_iter().chain(many).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::LimitKind;
    use crate::scene::built_in;

    /// With a stroke of 20 mm, the force error exceeds the default accuracy. A search for passing designs detects this by the lower bound of the
    /// error. With a larger stroke, a law exists.
    #[test]
    fn a_search_for_passing_designs_refuses_an_accuracy_that_no_law_reaches() {
        let scene = built_in("footbridge").unwrap().scene().unwrap();
        let with = [
            ("law.family", "spline"),
            ("law.spans", "24"),
            ("limits.stroke", "20 mm"),
        ];
        let scene = (with.iter()).fold(scene, |s, (key, value)| s.with(key, value).unwrap());
        let force = scene.model_force().unwrap();
        let problem = Problem::resolve(&scene, force.as_ref()).unwrap();
        let search = Search::default();
        assert!(spline_law(&problem, &search).unwrap().is_ok());
        let search = search.for_passing_designs();
        assert!(spline_law(&problem, &search).unwrap().is_err());
        let wide = problem.with(LimitKind::Stroke.into(), 1.0);
        assert!(spline_law(&wide, &search).unwrap().is_ok());
    }
}
