//! What kind of text a file is.

use super::header::Table;
use super::layout::{Layout, Separator, TextFile};
use crate::recording::{DecimalMark, Format, SeparatorName};

/// The kind of a text, from its header and the shape of its table.
pub(super) fn format(file: &TextFile, table: &Table, head: &[String]) -> Format {
    let says = |what: &str| head.iter().any(|l| l.to_lowercase().contains(what));
    let starts = |what: &str| head.iter().any(|l| l.to_lowercase().starts_with(what));
    let sub_frames = || table.names.iter().any(|n| n.to_lowercase().contains("sub"));
    let counted = starts("datacolumns") || starts("datarows");
    let known = [
        (starts("endheader") && counted, Format::OpenSimOld),
        (starts("endheader"), Format::OpenSimNew),
        (says("[force data]"), Format::ForceData),
        (starts("devices") && sub_frames(), Format::Nexus),
        (says("insoles"), Format::Insole),
        (says("bioware"), Format::BioWare),
        (starts("no_of_") || starts("force_plate"), Format::Qualisys),
    ];
    if let Some((_, format)) = known.into_iter().find(|(is_so, _)| *is_so) {
        return format;
    }
    let (separator, decimal) = described(file.layout);
    if !table.names.is_empty() {
        return Format::Text { separator, decimal };
    }
    let extension = file.path.extension().and_then(|e| e.to_str());
    match (extension, separator) {
        (Some(e), SeparatorName::Comma) if e.eq_ignore_ascii_case("asc") => Format::Amti,
        _ => Format::HeaderlessText { separator, decimal },
    }
}

fn described(layout: Layout) -> (SeparatorName, DecimalMark) {
    let separator = match layout.separator {
        Separator::Byte(b'\t') => SeparatorName::Tab,
        Separator::Byte(b';') => SeparatorName::Semicolon,
        Separator::Byte(b'|') => SeparatorName::Bar,
        Separator::Byte(_) => SeparatorName::Comma,
        Separator::Blanks => SeparatorName::Blank,
    };
    let decimal = if layout.comma {
        DecimalMark::Comma
    } else {
        DecimalMark::Point
    };
    (separator, decimal)
}
