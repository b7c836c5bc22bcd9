//! `gaitcam-lab reproduce`: recomputed numbers of the papers.

use std::path::Path;

use super::{Class, reproduce};
use crate::experiment::{self, pictures::pictures};
use gaitcam::error::Result;
use gaitcam_app::folder::Folder;

/// Writes reproduction.md, reproduction.csv and the pictures, and dynamics.md with the experiment of the thesis.
///
/// # Errors
///
/// A folder or file that cannot be written.
pub fn write(out: &Path, say: &mut dyn FnMut(&str)) -> Result<()> {
    let folder = Folder::open(out)?;
    let result = reproduce()?;
    folder.write("reproduction.md", result.markdown().as_bytes())?;
    folder.write("reproduction.csv", result.csv().as_bytes())?;
    folder.write("dynamics.md", experiment::report()?.as_bytes())?;
    for (name, picture) in pictures()?.iter().chain(&result.pictures) {
        folder.write_picture(name, picture)?;
    }
    say(&format!("{} numbers of the papers:", result.rows.len()));
    for class in Class::ALL {
        say(&format!("  {:>4}  {}", result.count(class), class.name()));
    }
    for m in &result.methods {
        say(&format!(
            "  {:<36} {:.3} N RMS ({:.3} turned), stroke {:.2} mm",
            m.name,
            m.rms,
            m.rms_turned,
            1e3 * m.stroke
        ));
    }
    say(&format!(
        "Report in {}",
        folder.path().join("reproduction.md").display()
    ));
    Ok(())
}
