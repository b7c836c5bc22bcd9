//! Conversion of texts to cells of a CSV file, and back.

use std::borrow::Cow;

/// A text as a CSV cell. If a spreadsheet would interpret the text as a formula, an apostrophe is added before it. Numbers are unchanged.
///
/// ```
/// use gaitcam_base::text::{cell_text, text_cell};
///
/// assert_eq!(text_cell("=A1.csv"), "'=A1.csv");
/// assert_eq!(cell_text("'=A1.csv"), "=A1.csv");
/// assert_eq!(text_cell("-4.5"), "-4.5");
/// ```
pub fn text_cell(text: &str) -> Cow<'_, str> {
    match begins_like_formula(text) {
        true => Cow::Owned(format!("'{text}")),
        false => Cow::Borrowed(text),
    }
}

/// Original text of a cell that [`text_cell`] returned.
pub fn cell_text(cell: &str) -> &str {
    let text = cell.strip_prefix('\'');
    text.filter(|text| begins_like_formula(text))
        .unwrap_or(cell)
}

/// A text as a CSV cell, in quotation marks if it contains a comma, a quotation mark or a line break.
pub fn quoted(text: &str) -> Cow<'_, str> {
    match text.contains([',', '"', '\n', '\r']) {
        true => Cow::Owned(format!("\"{}\"", text.replace('"', "\"\""))),
        false => Cow::Borrowed(text),
    }
}

/// Cells of a CSV line, without spaces at both ends and without the quotation marks that [`quoted`] adds.
///
/// ```
/// use gaitcam_base::text::{cells, quoted};
///
/// let line = format!("{}, 1.5,", quoted("S 06, \"left\""));
/// assert_eq!(cells(&line, ','), ["S 06, \"left\"", "1.5", ""]);
/// ```
pub fn cells(line: &str, separator: char) -> Vec<Cow<'_, str>> {
    let mut inside = false;
    let ends = |c: char| {
        inside ^= c == '"';
        c == separator && !inside
    };
    line.split(ends).map(|cell| unquoted(cell.trim())).collect()
}

fn unquoted(cell: &str) -> Cow<'_, str> {
    let inner = cell.strip_prefix('"').and_then(|c| c.strip_suffix('"'));
    inner.map_or(Cow::Borrowed(cell), |c| Cow::Owned(c.replace("\"\"", "\"")))
}

/// Whether a text starts like a formula, possibly after apostrophes. `text_cell` therefore adds an apostrophe also to a formula that
/// already has apostrophes. Removing one apostrophe then always restores the original text.
fn begins_like_formula(text: &str) -> bool {
    let begins = |c: char| matches!(c, '=' | '+' | '-' | '@' | '\t' | '\r');
    text.trim_start_matches('\'').starts_with(begins) && text.parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_reads_back_and_none_begins_like_a_formula() {
        let mut texts = vec![String::new()];
        for _ in 0..4 {
            let longer =
                |t: &String| ["'", "=", "+", "-", "@", "5", "a"].map(|c| format!("{t}{c}"));
            texts = texts
                .iter()
                .flat_map(longer)
                .chain([String::new()])
                .collect();
        }
        for text in texts {
            let cell = text_cell(&text);
            assert_eq!(cell_text(&cell), text);
            let is_number = cell.parse::<f64>().is_ok();
            assert!(
                is_number || !cell.starts_with(['=', '+', '-', '@']),
                "{cell}"
            );
        }
    }
}
