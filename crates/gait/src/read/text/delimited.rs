//! Delimited text: its lines, its separator and its decimal mark.

use std::borrow::Cow;
use std::path::Path;

use super::vectors::flattened;
use crate::read::number::{Field, field, trim};
use crate::recording::ReadOptions;

/// Separator between two fields of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Separator {
    /// A single character with this byte value.
    Byte(u8),
    /// One or more spaces or tabs.
    Blanks,
}

/// Field separator and decimal mark of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Delimiters {
    pub separator: Separator,
    /// Whether the decimal mark is a comma.
    pub comma: bool,
}

/// A position in a text: byte offset from 0 and line number from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Position {
    pub offset: usize,
    pub line: usize,
}

impl Position {
    pub const START: Position = Position { offset: 0, line: 1 };
}

/// A text file with the options of the user.
pub(crate) struct TextFile<'a> {
    pub path: &'a Path,
    /// Text of the file without byte-order mark, in UTF-8 or a single-byte encoding.
    pub bytes: &'a [u8],
    pub delimiters: Delimiters,
    pub options: &'a ReadOptions,
}

impl<'a> TextFile<'a> {
    pub fn new(path: &'a Path, bytes: &'a [u8], options: &'a ReadOptions) -> Self {
        let delimiters = detect(bytes);
        TextFile {
            path,
            bytes,
            delimiters,
            options,
        }
    }
}

/// Lines of a text with their positions, without line ends.
#[derive(Clone)]
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    pub at: Position,
}

impl<'a> Lines<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Lines::from(bytes, Position::START)
    }

    pub fn from(bytes: &'a [u8], at: Position) -> Self {
        Lines { bytes, at }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (Position, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.bytes.get(self.at.offset..)?;
        if rest.is_empty() {
            return None;
        }
        let here = self.at;
        let end = rest.iter().position(|&b| b == b'\n');
        let line = &rest[..end.unwrap_or(rest.len())];
        self.at.offset += end.map_or(rest.len(), |e| e + 1);
        self.at.line += 1;
        Some((here, line.strip_suffix(b"\r").unwrap_or(line)))
    }
}

/// Converts the text of a table to a standard form: one number per cell, and lines that end with `\n`.
///
/// Byte-order marks are removed, UTF-16 and single carriage returns are converted, and cells that contain vectors are split.
pub(crate) fn plain(bytes: &[u8]) -> Cow<'_, [u8]> {
    if let Some(flat) = flattened(bytes) {
        return Cow::Owned(flat);
    }
    if let Some(rest) = bytes.strip_prefix(b"\xEF\xBB\xBF") {
        return Cow::Borrowed(rest);
    }
    let wide = |rest: &[u8], order: fn([u8; 2]) -> u16| -> Vec<u8> {
        let (pairs, _) = rest.as_chunks();
        let units: Vec<u16> = pairs.iter().copied().map(order).collect();
        String::from_utf16_lossy(&units).into_bytes()
    };
    if let Some(rest) = bytes.strip_prefix(b"\xFF\xFE") {
        return Cow::Owned(wide(rest, u16::from_le_bytes));
    }
    if let Some(rest) = bytes.strip_prefix(b"\xFE\xFF") {
        return Cow::Owned(wide(rest, u16::from_be_bytes));
    }
    let start = &bytes[..bytes.len().min(1 << 16)];
    if start.contains(&b'\r') && !start.contains(&b'\n') {
        let ends = |&b: &u8| if b == b'\r' { b'\n' } else { b };
        return Cow::Owned(bytes.iter().map(ends).collect());
    }
    Cow::Borrowed(bytes)
}

/// Decodes bytes as text: UTF-8 if valid, otherwise Latin-1.
pub(crate) fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(s) => s.to_string(),
        Err(_) => bytes.iter().map(|&b| char::from(b)).collect(),
    }
}

/// Number of lines from which separator and decimal mark are determined.
const SAMPLE: usize = 60;

/// Determines separator and decimal mark from the lines of numbers. Several lines are taken from each part of the text.
pub(crate) fn detect(bytes: &[u8]) -> Delimiters {
    let mut sample: Vec<&[u8]> = Vec::new();
    for part in 0..4 {
        let mut lines = Lines::new(bytes);
        lines.at.offset = bytes.len() / 4 * part;
        let skip = usize::from(part > 0); // the line at this position may be incomplete
        let numeric = lines.skip(skip).take(400).map(|(_, l)| l).filter(|l| {
            let first = trim(l).first();
            first.is_some_and(|c| c.is_ascii_digit() || b"+-.,;".contains(c))
        });
        sample.extend(numeric.take(SAMPLE / 4));
    }
    let all_have = |b: u8| {
        let having = sample.iter().filter(|l| l.contains(&b)).count();
        having > 0 && 2 * having > sample.len()
    };
    let plain = [b'\t', b';', b'|'].into_iter().find(|b| all_have(*b));
    let separator = if let Some(byte) = plain {
        Separator::Byte(byte)
    } else if all_have(b',') && !sample.iter().all(|l| blanks_part_decimal_commas(l))
        || sample.is_empty() && bytes.contains(&b',')
    {
        Separator::Byte(b',')
    } else {
        Separator::Blanks
    };
    let plain = Delimiters {
        separator,
        comma: false,
    };
    let has_comma = |l: &&[u8]| Fields::new(l, plain).any(is_decimal_comma);
    // If commas separate the fields, a field with a decimal comma must be quoted.
    let quoted = |l: &&[u8]| {
        Fields::new(l, plain).any(|f| trim(f).len() < f.trim_ascii().len() && is_decimal_comma(f))
    };
    Delimiters {
        separator,
        comma: if separator == Separator::Byte(b',') {
            sample.iter().any(quoted)
        } else {
            sample.iter().any(has_comma)
        },
    }
}

/// Whether a line contains at least two numbers with a decimal comma, separated by spaces: `0,00 12,5 3`.
fn blanks_part_decimal_commas(line: &[u8]) -> bool {
    let mut words = 0;
    for word in line
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty())
    {
        words += 1;
        if field(word, true) == Field::Text || word.ends_with(b",") {
            return false;
        }
    }
    words >= 2
}

fn is_decimal_comma(f: &[u8]) -> bool {
    // In a clock time, only the seconds may have a decimal comma.
    let last = f.rsplit(|&b| b == b':').next().unwrap_or(f);
    last.contains(&b',') && matches!(field(last, true), Field::Number(_))
}

/// Fields of a line. A field in double quotes may contain the separator character.
#[derive(Clone)]
pub(crate) struct Fields<'a> {
    rest: Option<&'a [u8]>,
    separator: Separator,
}

impl<'a> Fields<'a> {
    pub fn new(line: &'a [u8], delimiters: Delimiters) -> Self {
        let rest = match delimiters.separator {
            Separator::Blanks => Some(line.trim_ascii()).filter(|l| !l.is_empty()),
            Separator::Byte(_) => Some(line),
        };
        Fields {
            rest,
            separator: delimiters.separator,
        }
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest?;
        match self.separator {
            Separator::Byte(s) => {
                let from = closing_quote(rest);
                let end = rest[from..].iter().position(|&b| b == s).map(|e| e + from);
                self.rest = end.map(|e| &rest[e + 1..]);
                Some(&rest[..end.unwrap_or(rest.len())])
            }
            Separator::Blanks => {
                let end = rest.iter().position(u8::is_ascii_whitespace);
                self.rest = end.map(|e| rest[e..].trim_ascii_start());
                Some(&rest[..end.unwrap_or(rest.len())])
            }
        }
    }
}

/// Position in `rest` from which the separator is searched: after the closing quote if the field is quoted, otherwise 0.
fn closing_quote(rest: &[u8]) -> usize {
    let inside = rest.strip_prefix(b"\"").unwrap_or(&[]);
    let end = inside.iter().position(|&b| b == b'"');
    end.map_or(0, |e| e + 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separator_and_decimal_mark_are_found_from_the_numbers() {
        let found = |t: &str| {
            let l = detect(t.as_bytes());
            (l.separator, l.comma)
        };
        let b = Separator::Byte;
        assert_eq!(found("t,f\n0.0,1.5\n0.1,2\n"), (b(b','), false));
        assert_eq!(found("t;f\n0,0;1,5\n0,1;2\n"), (b(b';'), true));
        assert_eq!(found("t\tf\n0,0\t1,5\n0,1\t2\n"), (b(b'\t'), true));
        assert_eq!(found("t f\n0,0 1,5\n0,1   2\n"), (Separator::Blanks, true));
        assert_eq!(
            found("t f\n 0.0 1.5\n 0.1   2\n"),
            (Separator::Blanks, false)
        );
        assert_eq!(found("0, 1\n1, 2\n"), (b(b','), false));
        let quoted = "t,f\n\"0,000\",\"1,5\"\n\"0,001\",\"2,25\"\n";
        assert_eq!(found(quoted), (b(b','), true));
        assert_eq!(found("\"t\",\"f\"\n\"0.0\",\"1.5\"\n"), (b(b','), false));
    }

    #[test]
    fn lines_of_every_system_and_encoding_come_out_plain() {
        assert_eq!(&*plain(b"a\rb\r"), b"a\nb\n");
        assert_eq!(&*plain(b"\xFF\xFEa\0\n\0"), b"a\n");
        assert_eq!(&*plain(b"\xEF\xBB\xBFa"), b"a");
        assert_eq!(text(b"Gr\xF6\xDFe"), "Größe");
        let all: Vec<_> = Lines::new(b"a\r\n\nb").map(|(p, l)| (p.line, l)).collect();
        assert_eq!(all, [(1, &b"a"[..]), (2, b""), (3, b"b")]);
    }

    #[test]
    fn quoted_fields_may_hold_the_separator() {
        let delimiters = Delimiters {
            separator: Separator::Byte(b','),
            comma: false,
        };
        let fields: Vec<_> = Fields::new(b"\"a,b\",c,", delimiters).collect();
        assert_eq!(fields, [&b"\"a,b\""[..], b"c", b""]);
    }
}
