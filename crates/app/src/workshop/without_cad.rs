//! Replacement for the module of CAD and manufacturing files in a build without the feature `cad`. No such files are made. Their names are
//! available, so that files of earlier results can be removed.

use gaitcam::error::{Error, Result};
use gaitcam::synth::Design;
use gaitcam_output::{Language, Timing};

use super::piece::Piece;

/// Content of a file with remarks on the file. The content is `None` if the file cannot be made.
pub(crate) type Exported = Result<(Option<Vec<u8>>, Vec<Remark>)>;

/// Options of the files for manufacturing. Without the feature `cad` there are no options.
#[derive(Debug, Clone, Copy, Default)]
pub struct Workshop {}

/// Remarks on files for manufacturing. Without the feature `cad` there are no remarks.
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

    pub(crate) fn make(&self, _: Piece, _: &Design, _: Timing, _: usize, _: Language) -> Exported {
        Ok((None, Vec::new()))
    }
}
