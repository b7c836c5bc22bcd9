//! Verification: the numbers of the source papers recomputed, charts of speed against accuracy, and the experiment of the thesis repeated.
//!
//! The lab is not part of the product. Every function computes its numbers when it is called and returns or writes a report; the command
//! `gaitcam-lab` calls them.
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

/// Internal error of this crate.
pub(crate) fn fault(what: impl Into<String>) -> gaitcam::error::Error {
    gaitcam::error::Error::own("lab", what)
}
