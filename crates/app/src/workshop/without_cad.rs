//! Build without CAD. The names of the workshop files are known, so that earlier files are removed, but no file is made.

use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_output::{Language, Timing};

use super::piece::Piece;

/// Content of a file, if it can be made, with remarks on it.
pub(crate) type Made = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// Options of the workshop files; there are none without the feature `cad`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Workshop {}

/// Remarks on workshop files; there are none without the feature `cad`.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {}

impl Remark {
    pub(crate) fn forbids_program(&self) -> bool {
        match *self {}
    }

    /// Reason why a file could not be made.
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
