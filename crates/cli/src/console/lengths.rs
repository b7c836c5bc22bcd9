//! Unit in which lengths are displayed, selected by `--units`.

use clap::{Args, ValueEnum};
use gaitcam_base::wording::{LengthUnit, display_lengths_in};

/// Units in which lengths can be displayed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub enum Lengths {
    #[default]
    Mm,
    #[value(alias = "in")]
    Inch,
}

impl Lengths {
    /// Selects this unit for all lengths that are displayed from now on.
    pub fn display(self) {
        display_lengths_in(match self {
            Lengths::Mm => LengthUnit::Millimetre,
            Lengths::Inch => LengthUnit::Inch,
        });
    }
}

/// Option of commands that write lengths for users only. Tables in CSV and JSON are in SI units.
#[derive(Args, Debug, Clone, Copy)]
pub struct LengthArgs {
    /// Unit of lengths in messages, reports and pictures
    #[arg(long, value_name = "UNIT", value_enum, default_value_t = Lengths::Mm)]
    pub units: Lengths,
}
