//! Every number that was asked of gaitcam in seconds, bytes or rows, measured; this writes
//! reports/benchmarks.md. Numbers of accuracy are tests; the table's second half names them.

mod cams;
mod cases;
mod dynamics;
mod recordings;
mod stored;
mod sweeps;
mod synthesis;
mod table;
mod tested;
mod timing;

use std::path::Path;

use table::Report;

fn main() {
    let mut report = Report::default();
    synthesis::main_job(&mut report);
    cams::roller(&mut report);
    synthesis::tiers(&mut report);
    cams::followers(&mut report);
    recordings::recordings(&mut report);
    dynamics::dynamics(&mut report);
    sweeps::sweeps(&mut report);
    stored::charts(&mut report);
    let page = table::markdown(&report.0);
    print!("{page}");
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("reports/benchmarks.md");
    std::fs::write(path, page).expect("reports/ can be written");
    let unexplained = table::unexplained(&report.0);
    assert!(
        unexplained.is_empty(),
        "missed without a reason beside it: {unexplained:?}"
    );
}
