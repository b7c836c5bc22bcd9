//! `gaitcam synth`: the main job.

mod results;
mod trade;

use std::path::PathBuf;
use std::time::Instant;

use super::{BUILT, NO_SUCH_CAM, SynthArgs, explain, hand_over, input, say};
use gaitcam::error::{Error, Place, Result};
use gaitcam::synth::{Synthesis, relaxed, synthesise};
use gaitcam::units::{Dimension, parse};
use gaitcam_output::folder::Folder;
use gaitcam_output::{self as output, Timing};

/// Designs the cam and writes its files; exit code 3 when there is no such cam.
pub fn run(args: &SynthArgs) -> Result<u8> {
    if let Some(pair) = &args.front {
        return trade::run(args, pair);
    }
    let start = Instant::now();
    let points = rows(args)?;
    let tool = args
        .tool
        .as_deref()
        .map(|t| parse(t, Dimension::Length).map_err(|e| e.at(Place::Argument("--tool".into()))))
        .transpose()?;
    let input = input::scene(&args.scene)?;
    let folder = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("out").join(&input.scene.name));
    let folder = Folder::open(&folder)?;
    let target = input.target()?;
    let solving = Instant::now();
    let design = synthesise(&input.scene, target.as_ref())?;
    let solve_s = solving.elapsed().as_secs_f64();
    let design = relaxed(&input.scene, target.as_ref(), design);
    let scene = input.resolved();
    let scene_text = toml::to_string(&scene).unwrap_or_default();
    let earlier = results::earlier(folder.path(), &scene_text);
    write_files(&folder, &design, points, solve_s, start)?;
    let time = Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let mut remarks = Vec::new();
    if design.infeasible.is_none() {
        if args.solid {
            remarks = hand_over::workshop(&folder, &design, time)?;
        }
        if let Some(radius) = tool {
            remarks.extend(hand_over::cutter(&folder, &design, radius, points)?);
        }
    }
    let reasons = if args.explain && design.infeasible.is_none() {
        Some(explain::lines(
            &input.scene,
            target.as_ref(),
            &design,
            points,
        )?)
    } else {
        None
    };
    folder.write("scene.toml", scene_text.as_bytes())?;
    let mut summary = output::json::summary(&design, time);
    summary["scene"] = serde_json::to_value(&scene).unwrap_or_default();
    if let Some(lines) = &reasons {
        summary["explain"] = explain::json(lines);
    }
    let summary = serde_json::to_string_pretty(&summary).unwrap_or_default();
    folder.write("summary.json", summary.as_bytes())?;
    results::clear(&folder, earlier);
    if args.json {
        say(&summary);
    } else {
        if args.verbose {
            say(&sequence(&design));
        }
        say(&words(&design, time));
        if let Some(lines) = &reasons {
            say(&explain::words(&design.name, lines));
        }
        for remark in remarks {
            say(&format!("  note      {remark}"));
        }
        say(&format!(
            "Files in {}; open {} first.",
            folder.path().display(),
            folder.path().join("report.html").display()
        ));
    }
    let good = design.infeasible.is_none() && design.checks.iter().all(|c| c.pass);
    Ok(if good { BUILT } else { NO_SUCH_CAM })
}

/// Rows of law.csv and profile.csv when nothing is said.
const ROWS: u32 = 1440;
/// Fewer rows draw no cam.
const FEWEST_ROWS: u32 = 16;

fn rows(args: &SynthArgs) -> Result<usize> {
    let rows = args.points.unwrap_or(ROWS);
    if rows < FEWEST_ROWS {
        let place = Place::Argument("--points".into());
        return Err(Error::new(format!("{rows} rows draw no cam"))
            .at(place)
            .help(format!(
                "give {FEWEST_ROWS} or more; fewer are for --front only"
            )));
    }
    Ok(rows as usize)
}

/// Everything but summary.json. Without a law that keeps the limits there is no profile to cut, so only
/// the report is written.
fn write_files(
    folder: &Folder,
    design: &Synthesis,
    points: usize,
    solve_s: f64,
    start: Instant,
) -> Result<()> {
    let time = || Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    if design.infeasible.is_some() {
        return folder.write(
            "report.html",
            output::report::html(design, time()).as_bytes(),
        );
    }
    folder.write("law.csv", output::csv::law(design, points).as_bytes())?;
    folder.write(
        "profile.csv",
        output::csv::profile(design, points).as_bytes(),
    )?;
    if let Some(pair) = &design.conjugate {
        let second = output::csv::points(&pair.second_profile(points));
        folder.write("second_profile.csv", second.as_bytes())?;
    }
    folder.write("profile.dxf", &output::dxf::profile(design, points))?;
    folder.write(
        "profile.svg",
        output::svg::profile(design, points).as_bytes(),
    )?;
    for (name, picture) in [
        ("svaj", output::plots::svaj(design)),
        ("force", output::plots::force(design)),
        ("cam", output::plots::cam(design)),
    ] {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        folder.write(&format!("{name}.png"), &picture.png())?;
    }
    folder.write(
        "report.html",
        output::report::html(design, time()).as_bytes(),
    )
}

/// The sequence of convex programs, step by step.
fn sequence(design: &Synthesis) -> String {
    let solver = &design.solver;
    let mut out = vec![format!(
        "{}: {} step(s) of a sequence of convex programs",
        design.name,
        solver.steps.len()
    )];
    if solver.steps.is_empty() {
        out.push("  none was needed: one convex program (or less) has the answer".to_string());
        return out.join("\n");
    }
    out.push(
        "  step   prime radius          objective   room to the sharpest   part taken".to_string(),
    );
    for (i, step) in solver.steps.iter().enumerate() {
        out.push(format!(
            "  {:>4} {:>11.6} mm {:>18.10e} {:>22.3e} {:>12.4}",
            i + 1,
            1e3 * step.prime_radius,
            step.merit,
            step.clearance,
            step.taken
        ));
    }
    out.push(format!("  ended because {}", solver.ended));
    out.join("\n")
}

/// A force that is zero to its last printed digit, without a sign that would not be true.
fn unsigned_zero(newtons: f64) -> f64 {
    if newtons.abs() < 0.005 { 0.0 } else { newtons }
}

/// The result for people: what was found, how well, and what limits it.
fn words(design: &Synthesis, time: Timing) -> String {
    let mut out = vec![
        format!("{}: {}", design.name, design.verdict.name()),
        format!("  {}", design.reason()),
    ];
    let measures = design.cam.follower.measures();
    let mm = |x: f64| format!("{:.3} mm", 1e3 * x);
    let place = |at: f64| measures.place(at, 2);
    let in_units = |name: &str, x: f64| gaitcam::synth::in_units(measures, name, x);
    if design.target.is_some() {
        let f = &design.force;
        out.push(format!(
            "  force     {:.2} … {:.2} N, mean {:.2} N; misses the target by {:.3} N RMS ({:.3} % of the mean), {:.3} N at most",
            unsigned_zero(f.min_n), f.max_n, f.mean_n, f.rms_error_n, f.rms_error_percent_of_mean, f.max_error_n
        ));
    }
    let (pieces, stroke) = (design.cam.law.poly().pieces(), design.cam.law.stroke());
    let lift = measures.lift(0);
    let decimals = if lift.name == "°" { 4 } else { 3 };
    out.push(format!(
        "  law       {}, degree {}, {pieces} pieces, stroke {}",
        design.family,
        design.degree,
        lift.after(&format!("{:.decimals$}", lift.factor * stroke))
    ));
    out.push(format!(
        "  drive     {}, {:.4} {}, {}",
        design.drive.kind.name(),
        design.drive.mass,
        measures.mass().name,
        measures.speed_words(design.drive.speed, 4)
    ));
    let cam = &design.cam;
    out.push(format!(
        "  cam       {}, base radius {}, prime radius {}, smallest convex radius {}",
        cam.follower.name(),
        mm(cam.follower.base_radius()),
        mm(cam.follower.prime_radius()),
        mm(cam.curvature().convex.value)
    ));
    for check in &design.checks {
        let mark = if check.pass { "ok  " } else { "FAIL" };
        let value = |x: f64| in_units(&check.name, x);
        out.push(format!(
            "  {mark}      {:<20} {} (limit {}) at {}",
            check.name,
            value(check.worst),
            value(check.limit),
            place(check.at)
        ));
    }
    for binding in &design.binding {
        out.push(format!(
            "  binds     {} at {}",
            binding.limit,
            place(binding.at)
        ));
    }
    for easing in &design.easing {
        let (name, unit, factor) = easing.in_words(measures);
        out.push(format!(
            "  1 % more  {} {} instead of {}: {name} about {:.5} {unit} instead of {:.5} {unit}",
            easing.limit,
            in_units(&easing.limit, easing.to),
            in_units(&easing.limit, easing.from),
            factor * easing.after,
            factor * easing.before
        ));
    }
    for remark in design.remarks() {
        out.push(format!("  note      {remark}"));
    }
    out.push(format!(
        "  solved    {} tier, {:.3} ms of {:.0} ms: {}",
        design.solver.tier.name(),
        1e3 * time.solve_s,
        1e3 * time.total_s,
        design.solver.status
    ));
    if let Some(c) = &design.solver.certificate {
        out.push(format!(
            "  proof     within {:.1e} of the optimum; conditions hold to {:.1e}, limits to {:.1e}",
            c.relative_gap, c.stationarity, c.violation
        ));
    }
    out.join("\n")
}
