//! Measurement of all times, sizes and rates with a limit; writes reports/benchmarks.md. Tests check the accuracy, and the second half of the table
//! names them.

mod cams;
mod cases;
mod dynamics;
mod recordings;
mod stored;
mod sweeps;
mod synthesis;
mod table;
mod tested;

use std::path::Path;

use gaitcam::error::Result;
use gaitcam_app::folder::Folder;
use table::Report;

/// Measures and writes benchmarks.md. Returns the results outside their limits without a reason in the table.
///
/// # Errors
///
/// A folder or file that cannot be written.
pub fn write(out: &Path, say: &mut dyn FnMut(&str)) -> Result<Vec<&'static str>> {
    let folder = Folder::open(out)?;
    let mut report = Report::default();
    synthesis::main_job(&mut report);
    cams::roller(&mut report);
    synthesis::tiers(&mut report);
    cams::followers(&mut report);
    recordings::recordings(&mut report);
    dynamics::dynamics(&mut report);
    sweeps::sweeps(&mut report);
    stored::charts(&mut report, out);
    let page = table::markdown(&report.0);
    say(&page);
    folder.write("benchmarks.md", page.as_bytes())?;
    Ok(table::unexplained(&report.0))
}
