//! Pictures of a front, and the report page that contains them.

use std::path::Path;

use serde_json::json;

use super::shown::row_name;
use super::{Evaluation, SHOWN, objective};
use crate::console::language;
use crate::console::words;
use gaitcam::error::Result;
use gaitcam::sweep::Point;
use gaitcam_app::folder::Folder;
use gaitcam_output::Picture;
use gaitcam_output::sweep_plots::{self, Quantity, unit_for_people};
use gaitcam_output::sweep_report;

/// Maximum number of lines or dots in a picture.
const DRAWN: usize = 3000;

/// A picture of the page, as a tuple: file name without ending, heading, picture.
type Drawn = (&'static str, String, Picture);

/// Writes the pictures of the front, and the page report.html that contains them.
pub fn write(
    file: &Path,
    folder: &Folder,
    evaluated: &Evaluation,
    front: &[&Point],
    best: &Point,
) -> Result<()> {
    let name = file
        .file_name()
        .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let drawn = pictures(&name, evaluated, front, best);
    for (file, _, picture) in &drawn {
        folder.write_picture(file, picture)?;
    }
    let page = page(&name, evaluated, front, best, &drawn);
    let html = sweep_report::html(&page, language::current());
    folder.write("report.html", html.as_bytes())
}

/// Every k-th value, so that a picture has at most [`DRAWN`] lines or dots.
fn fewer(mut q: Quantity) -> Quantity {
    let step = q.values.len().div_ceil(DRAWN).max(1);
    q.values = q.values.into_iter().step_by(step).collect();
    q
}

/// Pictures of the table: front for two or more objectives, heat map for exactly two varied keys, and parallel coordinates.
fn pictures(name: &str, evaluated: &Evaluation, front: &[&Point], best: &Point) -> Vec<Drawn> {
    let kept = &evaluated.kept;
    let varied: Vec<usize> = (0..kept.inputs.len())
        .filter(|&k| kept.inputs[k].varies())
        .collect();
    let inputs: Vec<Quantity> = varied.iter().map(|&k| kept.inputs[k].quantity()).collect();
    let goals: Vec<Quantity> = (kept.goals.iter())
        .zip(&evaluated.objectives)
        .map(|(values, objective)| Quantity {
            label: words::column(&objective.name),
            values: values.clone(),
            words: Vec::new(),
        })
        .collect();
    let mut drawn = Vec::new();
    if let [x, y, ..] = &goals[..] {
        let picture = plane(name, evaluated, [x, y], front, best);
        drawn.push(("front", words::text("front-heading-front"), picture));
    }
    if let ([x, y], Some(z)) = (&inputs[..], goals.first()) {
        let shown = unit_for_people(&z.label).0;
        let (title, sense) = if evaluated.objectives[0].maximised {
            ("front-picture-largest", sweep_plots::Best::Largest)
        } else {
            ("front-picture-least", sweep_plots::Best::Least)
        };
        let title = words::fill(title, &json!({"name": name, "text": shown}));
        let picture = sweep_plots::heat_map(&title, [x, y, z], sense, language::current());
        drawn.push(("heat", words::text("front-heading-heat"), picture));
    }
    if inputs.len() + goals.len() > 1 {
        let all: Vec<Quantity> = inputs.into_iter().chain(goals).map(fewer).collect();
        let picture = parallel(name, evaluated, &varied, all, front, best);
        drawn.push(("parallel", words::text("front-heading-parallel"), picture));
    }
    drawn
}

/// Picture of the first two objectives for the sampled designs, with the front.
fn plane(
    name: &str,
    evaluated: &Evaluation,
    [x, y]: [&Quantity; 2],
    front: &[&Point],
    best: &Point,
) -> Picture {
    let [a, b] = [0, 1].map(|k| &evaluated.objectives[k]);
    let place = |p: &Point| (a.value(p.values[0]), b.value(p.values[1]));
    let points: Vec<(f64, f64)> = front.iter().map(|p| place(p)).collect();
    let title = words::fill("front-picture-front", &json!({"name": name}));
    let (x, y) = (fewer(x.clone()), fewer(y.clone()));
    sweep_plots::front(
        &title,
        &x,
        &y,
        &points,
        Some(place(best)),
        None,
        language::current(),
    )
}

fn parallel(
    name: &str,
    evaluated: &Evaluation,
    varied: &[usize],
    mut all: Vec<Quantity>,
    front: &[&Point],
    best: &Point,
) -> Picture {
    // The front is added last, so that every point of the front has a line.
    let start = all[0].values.len();
    for p in front {
        for (k, q) in varied.iter().zip(&mut all) {
            let input = &evaluated.kept.inputs[*k];
            q.values.push(input.place(&p.cells[input.column]));
        }
        let goals = &mut all[varied.len()..];
        for ((cost, objective), q) in p.values.iter().zip(&evaluated.objectives).zip(goals) {
            q.values.push(objective.value(*cost));
        }
    }
    let lines: Vec<usize> = (start..start + front.len()).collect();
    let winner = front
        .iter()
        .position(|p| p.row == best.row)
        .map(|i| start + i);
    let title = words::fill("front-picture-parallel", &json!({"name": name}));
    sweep_plots::parallel(&title, &all, &lines, winner, language::current())
}

fn page<'a>(
    name: &str,
    evaluated: &Evaluation,
    front: &[&Point],
    best: &Point,
    drawn: &'a [Drawn],
) -> sweep_report::Page<'a> {
    let labels: Vec<String> = evaluated.objectives.iter().map(objective::label).collect();
    let shown = |p: &Point| -> Vec<String> {
        let both = evaluated.objectives.iter().zip(&p.values);
        both.map(|(o, cost)| objective::shown(o, *cost)).collect()
    };
    let counts = json!({"seen": evaluated.kept.seen.to_string(),
        "candidates": evaluated.kept.candidates.to_string(), "front": front.len().to_string(),
        "text": labels.join("; "), "row": best.row.to_string()});
    let mut sentence = words::fill("front-page-counts", &counts);
    if evaluated.left_out > 0 {
        let count = json!({"count": evaluated.left_out});
        sentence.push(' ');
        sentence.push_str(&words::fill("front-page-low-speed", &count));
    }
    let rows = front.iter().take(SHOWN).map(|p| {
        let name = row_name(&evaluated.columns, p);
        std::iter::once(name).chain(shown(p)).collect()
    });
    let cards = labels.iter().cloned().zip(shown(best));
    let cells = evaluated.columns.names.iter().zip(&best.cells);
    sweep_report::Page {
        title: words::fill("front-page-title", &json!({"name": name})),
        words: sentence,
        cards: cards
            .map(|(label, value)| (label, value, words::text("front-best")))
            .collect(),
        pictures: drawn
            .iter()
            .map(|(_, heading, picture)| (heading.as_str(), picture))
            .collect(),
        tables: vec![
            (
                words::text("front-table"),
                sweep_report::Table {
                    head: std::iter::once(words::text("front-row"))
                        .chain(labels)
                        .collect(),
                    rows: rows.collect(),
                },
            ),
            (
                words::text("front-best-table"),
                sweep_report::Table {
                    head: vec![words::text("front-column"), words::text("front-value")],
                    rows: cells
                        .map(|(name, cell)| vec![name.clone(), read(cell)])
                        .collect(),
                },
            ),
        ],
    }
}

/// Text of a table cell. Numbers have the decimal sign of the output language.
fn read(cell: &str) -> String {
    let number = |x| gaitcam::wording::exact(language::current(), x);
    cell.parse().map_or_else(|_| cell.to_string(), number)
}
