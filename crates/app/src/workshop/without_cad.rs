//! Without CAD: files of the workshop are known by name, so that those of an earlier result are removed; none is made.

use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_output::{Language, Timing};

use super::piece::Piece;

/// The bytes of a file, if it can be made, with remarks about it.
pub(crate) type Made = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// Nothing is asked for.
#[derive(Debug, Clone, Copy, Default)]
pub struct Workshop {}

/// There are no files to remark on.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {}

impl Remark {
    pub(crate) fn forbids_program(&self) -> bool {
        match *self {}
    }

    /// Why a file could not be made.
    pub fn into_fault(self) -> Option<Error> {
        match self {}
    }
}

impl Workshop {
    pub(crate) fn asks(&self, _: Piece) -> bool {
        false
    }

    pub(crate) fn make(&self, _: Piece, _: &Design, _: Timing, _: usize, _: Language) -> Made {
        Ok((None, Vec::new()))
    }
}
