//! What is written, read back by readers that did not write it.

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

/// How long the designs took, as summaries say it.
const TIME: Timing = Timing {
    solve_s: 0.001,
    total_s: 0.1,
};
