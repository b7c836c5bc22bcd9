//! `gaitcam sweep --tolerance`: effect of manufacturing tolerances on the force error of one design.

use std::fmt::Write;

use serde_json::json;

use super::partial::with_ending;
use super::{SweepArgs, arguments, work};
use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::{self, print, print_json};
use crate::console::words::{self, number};
use crate::input::searching;
use crate::input::{self, SceneArgs};
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::sweep::{Spread, Subject};
use gaitcam::synth::sentences;
use gaitcam::units::Dimension;
use gaitcam_app::folder::write_whole;
use gaitcam_output::sweep_plots::{Quantity, histogram};
use gaitcam_output::sweep_report::{Page, Table, html};

/// Maximum number of samples. The limit is necessary because all samples are in memory.
const MOST: u64 = 20_000_000;

/// Varies a design within its manufacturing tolerances, and writes the samples and a report. The exit code is 3 if there is no design.
pub fn run(args: &SweepArgs) -> Result<u8> {
    let at_flag = input::at_flag("--tolerance");
    let question = arguments::question(args)?.question;
    let flag = |e: Error| e.placed(Place::Argument("--tolerance".to_string()));
    let Subject::Scatter(scattered) = question.subject().map_err(flag)? else {
        return Err(CliError::NoSample.at_argument("--sample"));
    };
    if args.out.extension().is_none_or(|e| e != "csv") {
        return Err(CliError::ScatterCsv.at_argument("--out"));
    }
    scattered.read().map_err(&at_flag)?;
    let band = input::quantity("--band", args.band.as_deref(), Dimension::Ratio)?;
    let count = scattered.count;
    if count > MOST {
        let (count, most) = (count.to_string(), MOST.to_string());
        return Err(CliError::TooManySamples { count, most }.at_argument("--sample"));
    }
    let input = input::scene(&SceneArgs {
        scene: args.scenes.first().cloned(),
        set: args.set.clone(),
    })?;
    let design = searching::answer(&input)?.built()?;
    if let Some(infeasible) = &design.infeasible {
        let why = sentences(&infeasible.reasons, language::current());
        let why = json!({"why": why});
        terminal::report(words::fill("sweep-no-design", &why));
        return Ok(NO_SUCH_CAM);
    }
    let runner = scattered.runner(&design).map_err(&at_flag)?;
    let records = runner.run(0..count, work::jobs(args.jobs), &|| false);
    write_whole(&args.out, records.csv().as_bytes())?;
    let percents = records.numbers("force_rms_error_percent");
    let percents = percents.unwrap_or_default().to_vec();
    let spread = Spread::of(&percents, band.map(|b| 100.0 * b))
        .ok_or_else(|| CliError::NoSample.at_argument("--sample"))?;
    let own = design.force.rms_error_percent_of_mean;
    let page = with_ending(&args.out, ".report.html");
    let html = report(args, &design.problem.name, own, percents, &spread, band);
    write_whole(&page, html.as_bytes())?;
    if args.json {
        let object = json!({
            "samples": count, "own_percent": own, "mean_percent": spread.mean, "deviation_percent": spread.deviation,
            "p5_percent": spread.quantiles[0], "median_percent": spread.quantiles[1], "p95_percent": spread.quantiles[2],
            "largest_percent": spread.largest, "band_percent": band.map(|b| 100.0 * b), "yield": spread.within,
        });
        print_json(&object);
    } else {
        print(&summary(&design.problem.name, own, count, &spread, band));
        let (file, page) = (args.out.display().to_string(), page.display().to_string());
        let files = json!({"file": file, "page": page});
        print(&words::fill("sweep-scatter-files", &files));
    }
    Ok(BUILT)
}

fn summary(name: &str, own: f64, count: u64, s: &Spread, band: Option<f64>) -> String {
    let [p5, median, p95] = s.quantiles.map(number);
    let head = json!({"name": name, "count": count.to_string(), "own": number(own)});
    let spread = json!({"mean": number(s.mean), "deviation": number(s.deviation),
        "p5": p5, "p95": p95, "median": median, "largest": number(s.largest)});
    let mut out = format!(
        "{}\n  {}",
        words::fill("sweep-samples", &head),
        words::fill("sweep-spread", &spread)
    );
    if let (Some(band), Some(within)) = (band, s.within) {
        let share = json!({"within": number(100.0 * within), "band": number(100.0 * band)});
        let _ = write!(out, "\n  {}", words::fill("sweep-yield", &share));
    }
    out
}

fn report(
    args: &SweepArgs,
    name: &str,
    own: f64,
    percents: Vec<f64>,
    s: &Spread,
    band: Option<f64>,
) -> String {
    let quantity = Quantity {
        label: words::text("scatter-axis"),
        values: percents,
        words: Vec::new(),
    };
    let (by_design, limit) = (words::text("scatter-own"), words::text("scatter-band"));
    let mut levels = vec![(own, by_design.as_str())];
    if let Some(band) = band {
        levels.push((100.0 * band, limit.as_str()));
    }
    let named = json!({"name": name});
    let title = words::fill("scatter-picture", &named);
    let picture = histogram(&title, &quantity, &levels, language::current());
    let heading = words::text("scatter-heading");
    let tolerances = Table {
        head: vec![words::text("scatter-tolerance")],
        rows: args.tolerance.iter().map(|t| vec![t.clone()]).collect(),
    };
    let page = Page {
        title: words::fill("scatter-title", &named),
        words: words::text("scatter-how"),
        cards: cards(own, s, band),
        pictures: vec![(&heading, &picture)],
        tables: vec![(words::text("scatter-tolerances"), tolerances)],
    };
    html(&page, language::current())
}

/// Key figures of the report, each as (heading, value, remark).
fn cards(own: f64, s: &Spread, band: Option<f64>) -> Vec<(String, String, String)> {
    let percent = |x: f64| format!("{} %", number(x));
    let card = |key: &str, x: f64| (words::text(key), percent(x), String::new());
    let (name, value, _) = card("scatter-by-design", own);
    let mut out = vec![
        (name, value, words::text("scatter-of-mean")),
        card("scatter-median", s.quantiles[1]),
        card("scatter-below", s.quantiles[2]),
        card("scatter-largest", s.largest),
    ];
    if let (Some(band), Some(within)) = (band, s.within) {
        let (name, value, _) = card("scatter-yield", 100.0 * within);
        let band = json!({"band": number(100.0 * band)});
        out.push((name, value, words::fill("scatter-within", &band)));
    }
    out
}
