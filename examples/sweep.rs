//! Designs a grid of scenes on all cores.
//!
//! `cargo run --release --example sweep`
use std::error::Error;

use gaitcam::scene;
use gaitcam::sweep::Sweep;

pub fn main() -> Result<(), Box<dyn Error>> {
    let scene = scene::built_in("footbridge")?.scene()?;
    let table = Sweep::over(&scene, &["gait.step_frequency=1.5 Hz:2.2 Hz:8"])?.table()?;
    let column = |name| table.numbers(name).ok_or("no such column");
    let (frequencies, strokes) = (column("gait.step_frequency_hz")?, column("stroke_m")?);
    for (frequency, stroke) in frequencies.iter().zip(strokes) {
        println!("{frequency:.1} Hz: {:.2} mm", 1e3 * stroke);
    }
    // Young's first factor grows with the frequency about as ω² does: the stroke hardly changes.
    assert!(strokes.iter().all(|s| (0.03..0.07).contains(s)));
    Ok(())
}
