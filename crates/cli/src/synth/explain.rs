//! `gaitcam synth --explain`: explains which models were selected and why others were not.

use gaitcam::dynamics::{Machine, Model, Run, simulate};
use gaitcam::synth::{Design, PassedOver};
use serde_json::{Value, json};

use crate::console::language;
use crate::console::table::{Side, table};
use crate::console::words::{self, fill, fixed, name};

/// One choice in the model selection, with its reason.
pub struct Choice {
    /// Subject of the choice: "family", "solver", "shaft" or "dynamics".
    subject: &'static str,
    chosen: String,
    because: String,
}

/// All model choices for a design. `points` is the number of points on the profile.
pub fn lines(design: &Design, points: usize) -> Vec<Choice> {
    let mut out = vec![family(design), solver(design)];
    out.extend(shaft(design));
    out.extend(dynamics(design, points));
    out
}

/// Choice of the law family. If a simpler family was rejected, the text states why.
fn family(design: &Design) -> Choice {
    let values = json!({"family": design.family.name(), "degree": design.degree});
    let passed_over = design.solver.passed_over.as_ref();
    let missed = |p: &PassedOver| p.sentence(language::current());
    Choice {
        subject: "family",
        chosen: fill("explain-family-degree", &values),
        because: passed_over.map_or_else(|| words::text("explain-none-passed-over"), missed),
    }
}

fn solver(design: &Design) -> Choice {
    let solver = &design.solver;
    Choice {
        subject: "solver",
        chosen: name(solver.tier.name()),
        because: solver.method.sentence(language::current()),
    }
}

/// Choice between constant and varying speed of the shaft for the design of the law. The reason is an estimate from inertia and energy.
fn shaft(design: &Design) -> Option<Choice> {
    let on_shaft = design.shaft.as_ref()?;
    let forecast = on_shaft.forecast;
    let percent = |x: f64| fixed(x, 3);
    let values = json!({"ripple": percent(100.0 * forecast.ripple),
        "change": percent(forecast.force_change_percent_of_mean),
        "neglected": percent(forecast.neglected_percent_of_mean),
        "enough": forecast.is_negligible.to_string()});
    let chosen = match on_shaft.rounds {
        0 => "explain-constant-speed",
        _ => "explain-motor",
    };
    Some(Choice {
        subject: "shaft",
        chosen: words::text(chosen),
        because: fill("explain-forecast", &values),
    })
}

/// Dynamic model that a simulation would select for this cam in a machine without spring or backlash.
fn dynamics(design: &Design, points: usize) -> Option<Choice> {
    let run = Run {
        profile: design.cam.profile(points),
        target: None,
        cam: design.cam.clone(),
        drive: design.problem.drive,
        machine: Machine::default(),
    };
    let closed = design.cam.law.is_closed();
    let chosen = closed.then(|| simulate(&run, Model::Auto).ok()).flatten()?;
    Some(Choice {
        subject: "dynamics",
        chosen: name(chosen.model.name()),
        because: chosen.why.sentence(language::current()),
    })
}

/// The choices as a table for the console. `name` is the name of the design.
pub fn text(name: &str, lines: &[Choice]) -> String {
    let rows = lines.iter().flat_map(|line| {
        let because = fill("explain-because", &json!({"reason": line.because}));
        [
            vec![words::name(line.subject), line.chosen.clone()],
            vec![String::new(), because],
        ]
    });
    let title = fill("explain-title", &json!({"name": name}));
    let rows: Vec<_> = rows.collect();
    format!("{title}\n{}", table(&rows, &[Side::Left]))
}

/// The choices as JSON, for the key `explain` of summary.json.
pub fn json(lines: &[Choice]) -> Value {
    lines
        .iter()
        .map(|l| json!({"subject": l.subject, "chosen": l.chosen, "because": l.because}))
        .collect()
}
