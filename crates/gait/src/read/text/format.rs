//! What kind of text a file is.

use super::header::Table;
use super::layout::{Layout, Separator, TextFile};
use crate::recording::{DecimalMark, Format, SeparatorName};

/// The kind of a text, from its header and the shape of its table.
pub(super) fn format(file: &TextFile, table: &Table, head: &[String]) -> Format {
    let says = |what: &str| head.iter().any(|l| l.to_lowercase().contains(what));
    let starts = |what: &str| head.iter().any(|l| l.to_lowercase().starts_with(what));
    if starts("endheader") {
        return if starts("datacolumns") || starts("datarows") {
            Format::OpenSimOld
        } else {
            Format::OpenSimNew
        };
    }
    if says("[force data]") {
        return Format::ForceData;
    }
    if starts("devices") && table.names.iter().any(|n| n.to_lowercase().contains("sub")) {
        return Format::Nexus;
    }
    if says("insoles") {
        return Format::Insole;
    }
    if says("bioware") {
        return Format::BioWare;
    }
    if starts("no_of_") || starts("force_plate") {
        return Format::Qualisys;
    }
    let extension = file.path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let (separator, decimal) = described(file.layout);
    if !table.names.is_empty() {
        return Format::Text { separator, decimal };
    }
    if extension.eq_ignore_ascii_case("asc") && separator == SeparatorName::Comma {
        return Format::Amti;
    }
    Format::HeaderlessText { separator, decimal }
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
