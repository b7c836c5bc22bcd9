//! File formats of recordings, and their properties.

use std::fmt;

use serde::Serialize;
use strum::VariantNames;

use crate::wording::{Language, sentence};

/// File format of a recording.
///
/// ```
/// use gaitcam_gait::{Format, ReadOptions, SeparatorName, read};
///
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/recordings/made_walk.csv"));
/// let recording = read("walk.csv".as_ref(), bytes, &ReadOptions::default())?;
/// assert!(matches!(recording.format, Format::Text { separator: SeparatorName::Comma, .. }));
/// assert_eq!(recording.format.to_string(), "comma separated text");
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Format {
    /// C3D file. Its number format depends on the computer that wrote it.
    C3d {
        /// Number format of the computer that wrote the file.
        processor: Processor,
        /// Form in which the samples are stored.
        storage: Storage,
    },
    /// Text exported by a program.
    Export {
        /// Name of the program, with the file ending if it identifies the kind of export.
        program: &'static str,
    },
    /// Table with one whole stance per row.
    StanceTable,
    /// Delimited text with a header.
    Text {
        /// Separator between two fields.
        separator: SeparatorName,
        /// Decimal mark of the numbers in the file.
        decimal: DecimalMark,
    },
    /// Delimited text without a header.
    HeaderlessText {
        /// Separator between two fields.
        separator: SeparatorName,
        /// Decimal mark of the numbers in the file.
        decimal: DecimalMark,
    },
}

/// Number format of a C3D file.
///
/// ```
/// use gaitcam_gait::{Format, Processor, Storage};
///
/// // DEC floats differ from IEEE floats. A C3D file contains the type of its processor.
/// let file = Format::C3d { processor: Processor::Dec, storage: Storage::Floats };
/// assert!(file.to_string().contains("DEC"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Processor {
    /// Little-endian numbers, with floating-point numbers in the IEEE format.
    Intel,
    /// Little-endian words, with floating-point numbers in the VAX format.
    #[serde(rename = "DEC")]
    Dec,
    /// Big-endian numbers, with floating-point numbers in the IEEE format.
    #[serde(rename = "SGI")]
    Sgi,
}

/// Storage of the samples of a C3D file.
///
/// ```
/// use gaitcam_gait::{Format, Processor, Storage};
///
/// let file = Format::C3d { processor: Processor::Intel, storage: Storage::Integers };
/// assert!(file.to_string().contains("integer"), "{file}");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum Storage {
    Integers,
    Floats,
}

/// Field separator of a text.
///
/// ```
/// use gaitcam_gait::{DecimalMark, Format, SeparatorName};
///
/// let text = Format::Text { separator: SeparatorName::Semicolon, decimal: DecimalMark::Comma };
/// assert!(text.to_string().starts_with("semicolon separated text"), "{text}");
/// ```
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

/// Decimal mark of a text.
///
/// ```
/// use gaitcam_gait::{DecimalMark, Format, ReadOptions, read};
///
/// // With semicolons between the fields, 1,5 is one and a half.
/// let text = "time (s);Fz (N)\n0,0;700,5\n0,1;701,5\n0,2;700,5\n0,3;701,5\n";
/// let recording = read("a.csv".as_ref(), text.as_bytes(), &ReadOptions::default())?;
/// assert!(matches!(recording.format, Format::Text { decimal: DecimalMark::Comma, .. }));
/// assert!((recording.rate_hz - 10.0).abs() < 1e-9);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
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
