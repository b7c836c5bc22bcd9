//! Files that are written are read back by independent readers.

mod every_format;
mod gait;
mod pictures;
mod report;
mod simulation;
mod summary;
mod tables;
mod texts;
mod words;

use gaitcam_output::Timing;

/// Computing time of the designs, as in summaries.
const TIME: Timing = Timing {
    solve_s: 0.001,
    total_s: 0.1,
};
