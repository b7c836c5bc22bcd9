//! `gaitcam-lab chart`: measurement of speed against accuracy on this machine.

mod controllers;
mod dynamics;
mod export;
mod force;
mod geometry;
mod ladder;
mod limits;
mod motor;
mod reference;
mod walkers;

use std::path::Path;
use std::time::Instant;

use crate::chart::{self, Row};
use crate::timing::{Times, Watch};
use gaitcam::drive::Drive;
use gaitcam::error::Result;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::Law;
use gaitcam_app::folder::Folder;

/// Measures every chart and writes tables and pictures.
///
/// # Errors
///
/// A folder or file that cannot be written.
pub fn write(quick: bool, out: &Path, say: &mut dyn FnMut(&str)) -> Result<()> {
    let folder = Folder::open(out)?;
    let start = Instant::now();
    let watch = Watch::new(quick);
    let mut charts = Vec::new();
    for measure in [
        force::smooth,
        force::heel,
        limits::chart,
        geometry::chart,
        dynamics::vibration,
        dynamics::flight,
        export::chart,
        motor::chart,
        walkers::chart,
        controllers::chart,
    ] {
        let chart = measure(&watch)?;
        let place = match chart.default_on_front() {
            Some(true) => ", default on the front",
            Some(false) => ", default off the front",
            None => "",
        };
        say(&format!(
            "{}: {} rows{place}",
            chart.title,
            chart.rows.len()
        ));
        charts.push(chart);
    }
    for c in &charts {
        folder.write_picture(&c.file, &chart::picture(c))?;
    }
    folder.write("speed_accuracy.csv", chart::csv(&charts).as_bytes())?;
    let machine = machine(quick);
    ladder::write(&watch, &folder, &machine)?;
    let page = folder.path().join("speed_accuracy.md");
    let peers = std::fs::read_to_string(&page).map_or(String::new(), |old| peers(&old));
    folder.write(
        "speed_accuracy.md",
        chart::markdown(&charts, &machine, &peers).as_bytes(),
    )?;
    say(&format!(
        "{} charts in {:.1} s; open {}",
        charts.len(),
        start.elapsed().as_secs_f64(),
        page.display()
    ));
    Ok(())
}

/// Section on peers at the end of the page, written by lab/peers/speed/run.py. It is kept unchanged.
fn peers(page: &str) -> String {
    let start = page.find("\n## Peers\n");
    start.map_or(String::new(), |at| page[at..].to_string())
}

/// Description of the computer, for the header.
fn machine(quick: bool) -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|l| l.starts_with("model name"))?;
            Some(line.split(':').nth(1)?.trim().to_string())
        });
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    format!(
        "Processor: {}, {cores} cores, one used; {} {}; gaitcam {}, {} build{}.",
        cpu.unwrap_or_else(|| "unknown".to_string()),
        std::env::consts::OS,
        std::env::consts::ARCH,
        env!("CARGO_PKG_VERSION"),
        if cfg!(debug_assertions) {
            "debug"
        } else {
            "release"
        },
        if quick {
            ", quick run (few repetitions)"
        } else {
            ""
        }
    )
}

impl Times {
    fn row(self, method: &str, size: impl Into<String>, error: f64) -> Row {
        Row {
            method: method.to_string(),
            size: size.into(),
            error,
            seconds: self.median,
            quartiles: self.quartiles,
            runs: self.runs,
            ..Row::default()
        }
    }
}

/// Force of both feet of 700 N at 1.85 steps per second, as in the default scene, with its moving axis.
fn footbridge() -> Result<(ForceCurve, Drive)> {
    let target = model("young", Some(1.85), 700.0, Feet::Both)?;
    let drive = Drive::moving_axis(
        target.mean_n() / 9.81,
        9.81,
        std::f64::consts::TAU / target.period_s,
    );
    Ok((target, drive))
}

/// RMS difference between the force of a law and the target at `DENSE` angles, relative to the mean target.
fn force_error(drive: &Drive, law: &Law, target: &ForceCurve) -> f64 {
    rms_error(|x| drive.force(law.svaj(x)), target)
}

/// Number of angles at which forces are compared with the exact result. They differ from those of the fits.
const DENSE: usize = 4001;

fn rms_error(force: impl Fn(f64) -> f64, target: &ForceCurve) -> f64 {
    let sum: f64 = (0..DENSE)
        .map(|i| std::f64::consts::TAU * (i as f64 + 0.5) / DENSE as f64)
        .map(|x| (force(x) - target.at(x)).powi(2))
        .sum();
    (sum / DENSE as f64).sqrt() / target.mean_n().abs()
}
