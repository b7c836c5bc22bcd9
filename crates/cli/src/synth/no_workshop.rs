//! A command without CAD: no argument asks for files for the workshop.

use clap::Args;

use crate::input::Input;
use gaitcam::cam::Measures;
use gaitcam::error::Result;
use gaitcam_app::{Remark, Workshop};

/// Nothing to ask for.
#[derive(Args, Debug, Default)]
pub struct WorkshopArgs {}

impl WorkshopArgs {
    /// Nothing is asked for.
    pub fn asked(&self) -> Result<Workshop> {
        Ok(Workshop {})
    }
}

/// No drawing has a title.
pub fn titled(workshop: Workshop, _: &Input) -> Workshop {
    workshop
}

/// There are no files to remark on.
pub fn sentence(remark: &Remark, _: Measures) -> String {
    match *remark {}
}
