//! How we know: the source papers' numbers computed again, speed charted against accuracy, and the
//! thesis's experiment run again.
//!
//! The lab is no part of the product. Every function here computes its numbers at the moment
//! of the call and returns or writes a report; the command `gaitcam-lab` calls them.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod benchmarks;
pub(crate) mod chart;
pub(crate) mod experiment;
pub(crate) mod markdown;
pub mod measure;
pub mod reproduce;
pub mod tiers;
pub(crate) mod timing;
pub mod twins;

/// An internal error of this crate.
pub(crate) fn fault(what: impl Into<String>) -> gaitcam::error::Error {
    gaitcam::error::Error::own("lab", what)
}
