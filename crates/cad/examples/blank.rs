//! Writes a cam as an outline and as a solid: `cargo run --release -p gaitcam-cad --example blank [FOLDER]`.

use std::path::PathBuf;

use gaitcam::scene::built_in;
use gaitcam::synth::synthesise;
use gaitcam_cad::gcode::Milling;
use gaitcam_cad::{Units, dxf, gcode, step};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.unwrap_or_else(std::env::temp_dir);
    let scene = built_in("camdas_01_roller")?.scene()?;
    let design = synthesise(&scene, None)?;
    let outline = dxf::profile(
        &design,
        720,
        dxf::Content::CutOnly,
        dxf::Curves::default(),
        Units::Millimetres,
    );
    std::fs::write(folder.join("profile.dxf"), outline)?;
    std::fs::write(folder.join("cam.step"), step::solid(&design)?)?;
    std::fs::write(
        folder.join("cutter.nc"),
        &gcode::milling(&design, &Milling::of(0.003))?[0],
    )?;
    println!("profile.dxf, cam.step, cutter.nc in {}", folder.display());
    Ok(())
}
