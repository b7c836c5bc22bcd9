//! `gaitcam synth --front`: computes a Pareto front of two objectives, as a table and a picture.

use serde_json::json;

use super::SynthArgs;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::table::{Side, table};
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input;
use gaitcam::Problem;
use gaitcam::error::Result;
use gaitcam::sweep::{Field, Records};
use gaitcam::synth::{FIGURES, Figure, Figures, ForceReport, Search, Trade, trade, traded};
use gaitcam_app::folder::Folder;
use gaitcam_output::sweep_plots::{self, Quantity};

/// Default number of points on the front.
const POINTS: u32 = 20;

/// Computes the front and writes front.csv, front.svg and front.png. The exit code is 3 if the front is empty.
pub fn run(args: &SynthArgs, pair: &str) -> Result<u8> {
    let against = traded(pair).map_err(input::at_flag("--front"))?;
    let input = input::scene(&args.scene)?;
    let path = input::result_folder(&input, args.out.as_deref(), "-front")?;
    let folder = Folder::open(&path)?;
    let target = input.target()?;
    let points = args.points.unwrap_or(POINTS) as usize;
    let problem = Problem::resolve(&input.scene, target.as_ref())?;
    let limit = args.time.of_design();
    let front = trade(&problem, against, points, &Search::until(limit.clone()))?;
    if limit.was_heard() {
        report(words::text("trade-stopped"));
    }
    if front.is_empty() && limit.was_heard() {
        return Ok(NO_SUCH_CAM);
    }
    if front.is_empty() {
        report(words::text("trade-none"));
        return Ok(NO_SUCH_CAM);
    }
    folder.write("front.csv", csv(against, &front).as_bytes())?;
    let column = |figure: &Figure| Quantity {
        label: words::column(figure.column),
        values: front.iter().map(|t| value(figure, t)).collect(),
        words: Vec::new(),
    };
    // The first figure of `FIGURES` is the RMS force error.
    let (x, y) = (column(against), column(&FIGURES[0]));
    let line = x.values.iter().copied().zip(y.values.iter().copied());
    let line: Vec<(f64, f64)> = line.collect();
    let title = title(&input.scene.name, against);
    let allowed = problem.largest_error().map(|e| problem.drive.newtons(e));
    let picture = sweep_plots::front(&title, &x, &y, &line, None, allowed, language::current());
    folder.write_picture("front", &picture)?;
    if args.json {
        let rows: Vec<_> = front
            .iter()
            .map(|t| {
                json!({against.key: value(against, t), "allowed": t.allowed,
                    "rms_error_n": force(t).rms_error_n,
                    "max_error_n": force(t).max_error_n,
                    "tier": t.design.solver.tier.name(), "verdict": t.design.verdict.name()})
            })
            .collect();
        print_json(&rows.into());
    } else {
        print(&lines(&input.scene.name, against, &front));
        print(&super::files_in(folder.path(), "front.png"));
    }
    Ok(if limit.was_heard() {
        NO_SUCH_CAM
    } else {
        BUILT
    })
}

fn title(name: &str, against: &Figure) -> String {
    let arguments = json!({"name": name, "quantity": against.label(language::current())});
    words::fill("trade-title", &arguments)
}

/// Force data of a design on the front, with forces and errors in N.
fn force(t: &Trade) -> ForceReport {
    t.design.force.newtons(&t.design.problem.drive)
}

/// Value of a quantity for a design on the front, in SI units.
fn value(figure: &Figure, t: &Trade) -> f64 {
    figure.value(&Figures::of(&t.design))
}

fn csv(against: &Figure, front: &[Trade]) -> String {
    let numbers = |name: &str, of: &dyn Fn(&Trade) -> f64| {
        Field::numbers(name, front.iter().map(of).collect())
    };
    let figure = |f: &Figure| numbers(f.key, &|t| value(f, t));
    let allowed = numbers(&format!("allowed_{}", against.key), &|t| t.allowed);
    let mut fields = vec![allowed, figure(against)];
    let others = FIGURES.iter().filter(|f| f.column != against.column);
    fields.extend(others.map(figure));
    let tiers = front.iter().map(|t| t.design.solver.tier.name());
    let verdicts = front.iter().map(|t| t.design.verdict.name());
    fields.extend([
        Field::words("tier", tiers),
        Field::words("verdict", verdicts),
    ]);
    Records { fields }.csv()
}

fn lines(name: &str, against: &Figure, front: &[Trade]) -> String {
    let language = language::current();
    let error = ["force_rms_error_n", "force_rms_error_percent"].map(Figure::of_column);
    let figures: Vec<&Figure> = std::iter::once(against)
        .chain(error.into_iter().flatten())
        .collect();
    let head = figures.iter().map(|f| f.label(language)).collect();
    let row = |t: &Trade| -> Vec<String> {
        let (own, measures) = (Figures::of(&t.design), t.design.cam.follower.measures());
        let cell = |f: &&Figure| f.text(f.value(&own), measures, language);
        figures.iter().map(cell).collect()
    };
    let rows: Vec<_> = std::iter::once(head).chain(front.iter().map(row)).collect();
    format!("{}\n{}", title(name, against), table(&rows, &[Side::Right]))
}
