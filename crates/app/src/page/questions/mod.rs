//! Requests of the page, with one file per kind of request.

pub mod catalogue;
pub mod design;
pub mod export;
pub mod range;
pub mod recording;
pub mod relax;
pub mod runs;
pub mod variation;
