//! What is written, read back by readers that did not write it.

mod cad;
mod designs;
mod drawing;
mod drawings;
mod every_format;
mod machining;
mod pictures;
mod readers;
mod report;
mod sheets;
mod summary;
mod tables;
mod words;
mod workshop;

use gaitcam_output::Timing;

/// How long the designs took, as summaries say it.
const TIME: Timing = Timing {
    solve_s: 0.001,
    total_s: 0.1,
};
