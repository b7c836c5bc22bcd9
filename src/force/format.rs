//! Kinds of file that hold a recording.

use std::fmt;

use serde::Serialize;
use strum::VariantNames;

use crate::wording::{Language, sentence};

/// What kind of file a recording was read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Format {
    /// C3D, with the processor whose number format it uses.
    C3d {
        /// Number format.
        processor: Processor,
        /// How samples are stored.
        storage: Storage,
    },
    /// OpenSim storage with a header of `name`, `datacolumns`, `datarows`.
    OpenSimOld,
    /// OpenSim storage with a header of `version`, `nRows`, `nColumns`.
    OpenSimNew,
    /// Text with `[Force Data]` and key lines.
    ForceData,
    /// Device export of Vicon Nexus.
    Nexus,
    /// Text export of pressure insoles.
    Insole,
    /// Text export of Kistler BioWare.
    BioWare,
    /// Text export of Qualisys.
    Qualisys,
    /// AMTI text without header.
    Amti,
    /// Converter counts of Motion Analysis.
    ConverterCounts,
    /// One stance per row.
    StanceTable,
    /// Delimited text with a header.
    Text {
        /// What stands between fields.
        separator: SeparatorName,
        /// Decimal mark.
        decimal: DecimalMark,
    },
    /// Delimited text without a header.
    HeaderlessText {
        /// What stands between fields.
        separator: SeparatorName,
        /// Decimal mark.
        decimal: DecimalMark,
    },
}

/// Number format of a C3D file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Processor {
    /// Little endian, IEEE floats.
    Intel,
    /// Little endian words, VAX floats.
    #[serde(rename = "DEC")]
    Dec,
    /// Big endian, IEEE floats.
    #[serde(rename = "SGI")]
    Sgi,
}

/// How samples of a C3D file are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum Storage {
    Integers,
    Floats,
}

/// What stands between two fields of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum SeparatorName {
    Tab,
    Semicolon,
    Bar,
    Comma,
    Blank,
}

/// The decimal mark of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum DecimalMark {
    Point,
    Comma,
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&sentence(Language::En, "format", self))
    }
}
