//! Writes every hand-over file of two designs into a folder and prints what each took.

#[path = "../tests/designs/mod.rs"]
mod designs;

use std::path::PathBuf;
use std::time::Instant;

use gaitcam::emit::dxf::{Options, Version};
use gaitcam::emit::solid::{self, Plate};
use gaitcam::emit::{self, Timing};

fn main() -> std::io::Result<()> {
    let root: PathBuf = std::env::args().nth(1).unwrap_or("out/emit".into()).into();
    for design in [
        designs::footbridge(),
        designs::heel_tester(),
        designs::impossible(),
    ] {
        let dir = root.join(design.name.split(' ').next().unwrap_or("x"));
        let dir = if design.infeasible.is_some() {
            root.join("impossible")
        } else {
            dir
        };
        std::fs::create_dir_all(&dir)?;
        let begin = Instant::now();
        let mut files: Vec<(&str, Vec<u8>, f64)> = Vec::new();
        let mut timed = |name, render: &dyn Fn() -> Vec<u8>| {
            let start = Instant::now();
            let bytes = render();
            files.push((name, bytes, start.elapsed().as_secs_f64()));
        };
        let time = Timing {
            solve_s: 0.0012,
            total_s: 0.21,
        };
        timed("law.csv", &|| emit::csv::law(&design, 1440).into_bytes());
        timed("profile.csv", &|| {
            emit::csv::profile(&design, 1440).into_bytes()
        });
        timed("summary.json", &|| {
            emit::json::summary(&design, time).to_string().into_bytes()
        });
        timed("profile.dxf", &|| emit::dxf::profile(&design, 1440));
        timed("profile.svg", &|| {
            emit::svg::profile(&design, 1440).into_bytes()
        });
        timed("svaj.svg", &|| {
            emit::plots::svaj(&design).svg().into_bytes()
        });
        timed("force.svg", &|| {
            emit::plots::force(&design).svg().into_bytes()
        });
        timed("cam.svg", &|| emit::plots::cam(&design).svg().into_bytes());
        timed("svaj.png", &|| emit::plots::svaj(&design).png());
        timed("force.png", &|| emit::plots::force(&design).png());
        timed("cam.png", &|| emit::plots::cam(&design).png());
        timed("report.html", &|| {
            emit::report::html(&design, time).into_bytes()
        });
        let total = begin.elapsed().as_secs_f64();
        let mut timed = |name, render: &dyn Fn() -> Vec<u8>| {
            let start = Instant::now();
            let bytes = render();
            files.push((name, bytes, start.elapsed().as_secs_f64()));
        };
        let plate = Plate {
            thickness: 0.012,
            bore: Some(0.016),
            points: 1440,
        };
        let options = |version| Options {
            points: 1440,
            version,
            bore: Some(0.016),
        };
        timed("r2010.dxf", &|| {
            emit::dxf::drawing(&design, options(Version::R2010))
        });
        timed("arcs.dxf", &|| {
            emit::dxf::arcs(&design, 1e-6, options(Version::R2000))
                .map(|d| d.bytes)
                .unwrap_or_default()
        });
        timed("arcs_r12.dxf", &|| {
            emit::dxf::arcs(&design, 1e-6, options(Version::R12))
                .map(|d| d.bytes)
                .unwrap_or_default()
        });
        timed("cam.stl", &|| {
            solid::stl(&design, plate).unwrap_or_default()
        });
        timed("cam.3mf", &|| {
            solid::threemf(&design, plate).unwrap_or_default()
        });
        timed("cam.xlsx", &|| {
            emit::xlsx::workbook(&design, time).unwrap_or_default()
        });
        timed("cutter.csv", &|| {
            emit::cutter::path(&design, 0.006, 1440)
                .map(|p| emit::cutter::csv(&p).into_bytes())
                .unwrap_or_default()
        });
        for (name, bytes, seconds) in &files {
            println!("{:>9.2} ms {:>9} B  {name}", 1e3 * seconds, bytes.len());
            std::fs::write(dir.join(name), bytes)?;
        }
        println!(
            "{:>9.2} ms  {}: all that synth writes by default",
            1e3 * total,
            design.name
        );
    }
    Ok(())
}
