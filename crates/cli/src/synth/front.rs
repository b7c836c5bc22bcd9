//! `gaitcam synth --front`: what one good costs in another, as a table and a picture.

use serde_json::json;

use super::SynthArgs;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words::{self, fixed};
use crate::input;
use gaitcam::Problem;
use gaitcam::error::Result;
use gaitcam::synth::{Figure, Figures, ForceReport, Trade, trade, traded};
use gaitcam::wording::people;
use gaitcam_app::folder::Folder;
use gaitcam_output::sweep_plots::{self, Quantity};

/// Points of the front when nothing is said.
const POINTS: u32 = 20;
/// Figures of front.csv after the one that is traded off, by their columns in sweeps.
const COLUMNS: [&str; 11] = [
    "force_rms_error_n",
    "force_rms_error_percent",
    "force_max_error_n",
    "prime_radius_m",
    "stroke_m",
    "torque_max_n_m",
    "torque_rms_n_m",
    "power_max_w",
    "power_mean_w",
    "liftoff_speed_rad_per_s",
    "hertz_pressure_max_pa",
];

/// Computes the front and writes front.csv, front.svg and front.png; exit code 3 when it is empty.
pub fn run(args: &SynthArgs, pair: &str) -> Result<u8> {
    let against = traded(pair).map_err(input::at_flag("--front"))?;
    let input = input::scene(&args.scene)?;
    let path = input::result_folder(&input, args.out.as_deref(), "-front")?;
    let folder = Folder::open(&path)?;
    let target = input.target()?;
    let points = args.points.unwrap_or(POINTS) as usize;
    let problem = Problem::resolve(&input.scene, target.as_ref())?;
    let front = trade(&problem, against, points)?;
    if front.is_empty() {
        report(words::text("trade-none"));
        return Ok(NO_SUCH_CAM);
    }
    folder.write("front.csv", csv(against, &front).as_bytes())?;
    let column = |name: &str, of: &dyn Fn(&Trade) -> f64| Quantity {
        label: words::column(name),
        values: front.iter().map(of).collect(),
        words: Vec::new(),
    };
    let (unit, factor) = people(against.unit);
    let x = Quantity {
        label: format!("{}, {unit}", quantity_name(against)),
        ..column(against.key, &|t| factor * value(against, t))
    };
    let y = column("force_rms_error_n", &|t| force(t).rms_error_n);
    let line = x.values.iter().copied().zip(y.values.iter().copied());
    let line: Vec<(f64, f64)> = line.collect();
    let title = title(&input.scene.name, against);
    let picture = sweep_plots::front(&title, &x, &y, &line, None).in_language(language::current());
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
        print(&table(&input.scene.name, against, &front));
        print(&super::files_in(folder.path(), "front.png"));
    }
    Ok(BUILT)
}

fn quantity_name(against: &Figure) -> String {
    let name = against.trade.unwrap_or_default();
    words::text(&format!("trade-{}", name.replace('_', "-")))
}

fn title(name: &str, against: &Figure) -> String {
    let arguments = json!({"name": name, "quantity": quantity_name(against)});
    words::fill("trade-title", &arguments)
}

/// Force against target, N.
fn force(t: &Trade) -> ForceReport {
    t.design.force.newtons(&t.design.problem.drive)
}

/// Value of a figure in a design, SI.
fn value(figure: &Figure, t: &Trade) -> f64 {
    figure.value(&Figures::of(&t.design))
}

fn csv(against: &Figure, front: &[Trade]) -> String {
    let figures = COLUMNS
        .iter()
        .filter_map(|column| Figure::of_column(column));
    let figures: Vec<&Figure> = figures.filter(|f| f.column != against.column).collect();
    let mut out = format!("allowed_{},{}", against.key, against.key);
    for figure in &figures {
        out += &format!(",{}", figure.key);
    }
    out += ",tier,verdict\n";
    for t in front {
        let own = Figures::of(&t.design);
        out += &format!("{},{}", t.allowed, against.value(&own));
        for figure in &figures {
            out.push(',');
            let value = figure.value(&own);
            if !value.is_nan() {
                out += &value.to_string();
            }
        }
        let (tier, verdict) = (t.design.solver.tier.name(), t.design.verdict.name());
        out += &format!(",{tier},{verdict}\n");
    }
    out
}

fn table(name: &str, against: &Figure, front: &[Trade]) -> String {
    let (unit, factor) = people(against.unit);
    let mut out = vec![
        title(name, against),
        format!(
            "  {:>16} {unit:<5} {:>14} {:>12}",
            quantity_name(against),
            words::text("trade-rms"),
            words::text("trade-percent")
        ),
    ];
    for t in front {
        let f = force(t);
        out.push(format!(
            "  {:>16} {:<5} {:>14} {:>12}",
            fixed(factor * value(against, t), 4),
            "",
            fixed(f.rms_error_n, 4),
            fixed(f.rms_error_percent_of_mean, 4)
        ));
    }
    out.join("\n")
}
