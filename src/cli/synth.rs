//! `gaitcam synth`: the main job.

use std::path::PathBuf;
use std::time::Instant;

use super::files::Folder;
use super::{BUILT, NO_SUCH_CAM, SynthArgs, input, say};
use crate::emit::{self, Timing};
use crate::error::Result;
use crate::synth::{Synthesis, synthesise};

/// Designs the cam and writes its files; exit code 3 when there is no such cam.
pub fn run(args: &SynthArgs) -> Result<u8> {
    let start = Instant::now();
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
    write_files(&folder, &design, args.points as usize, solve_s, start)?;
    let time = Timing {
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let summary =
        serde_json::to_string_pretty(&emit::json::summary(&design, time)).unwrap_or_default();
    folder.write("summary.json", summary.as_bytes())?;
    if args.json {
        say(&summary);
    } else {
        say(&words(&design, time));
        say(&format!(
            "Files in {}; open {} first.",
            folder.path().display(),
            folder.path().join("report.html").display()
        ));
    }
    let good = design.infeasible.is_none() && design.checks.iter().all(|c| c.pass);
    Ok(if good { BUILT } else { NO_SUCH_CAM })
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
        return folder.write("report.html", emit::report::html(design, time()).as_bytes());
    }
    folder.write("law.csv", emit::csv::law(design, points).as_bytes())?;
    folder.write("profile.csv", emit::csv::profile(design, points).as_bytes())?;
    folder.write("profile.dxf", &emit::dxf::profile(design, points))?;
    folder.write("profile.svg", emit::svg::profile(design, points).as_bytes())?;
    for (name, picture) in [
        ("svaj", emit::plots::svaj(design)),
        ("force", emit::plots::force(design)),
        ("cam", emit::plots::cam(design)),
    ] {
        folder.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        folder.write(&format!("{name}.png"), &picture.png())?;
    }
    folder.write("report.html", emit::report::html(design, time()).as_bytes())
}

/// The result for people: what was found, how well, and what limits it.
fn words(design: &Synthesis, time: Timing) -> String {
    let mut out = vec![
        format!("{}: {}", design.name, design.verdict.name()),
        format!("  {}", design.reason),
    ];
    let mm = |x: f64| format!("{:.3} mm", 1e3 * x);
    if design.target.is_some() {
        let f = &design.force;
        out.push(format!(
            "  force     {:.2} … {:.2} N, mean {:.2} N; misses the target by {:.3} N RMS ({:.3} % of the mean), {:.3} N at most",
            f.min_n, f.max_n, f.mean_n, f.rms_error_n, f.rms_error_percent_of_mean, f.max_error_n
        ));
    }
    let (pieces, stroke) = (design.cam.law.poly().pieces(), design.cam.law.stroke());
    out.push(format!(
        "  law       {}, degree {}, {pieces} pieces, stroke {}",
        design.family,
        design.degree,
        if design.cam.follower.name().contains("oscillating") {
            format!("{:.4}°", stroke.to_degrees())
        } else {
            mm(stroke)
        }
    ));
    out.push(format!(
        "  drive     {}, {:.4} kg, {:.4} rad/s ({:.2} rpm)",
        design.drive.kind.name(),
        design.drive.mass,
        design.drive.speed,
        design.drive.speed * 30.0 / std::f64::consts::PI
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
        let value = |x: f64| crate::synth::in_units(&check.name, x);
        out.push(format!(
            "  {mark}      {:<20} {} (limit {}) at {:.2}°",
            check.name,
            value(check.worst),
            value(check.limit),
            check.at.to_degrees()
        ));
    }
    for binding in &design.binding {
        out.push(format!(
            "  binds     {} at {:.2}°",
            binding.limit,
            binding.at.to_degrees()
        ));
    }
    for remark in &design.remarks {
        out.push(format!("  note      {remark}"));
    }
    out.push(format!(
        "  solved    {} tier, {:.3} ms of {:.0} ms: {}",
        design.solver.tier.name(),
        1e3 * time.solve_s,
        1e3 * time.total_s,
        design.solver.status
    ));
    out.join("\n")
}
