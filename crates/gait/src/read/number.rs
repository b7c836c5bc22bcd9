//! Parsing of the numbers in a recording from bytes.

/// Content of a field in a delimited text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Field {
    /// A finite number, with the value that the text denotes.
    Number(f64),
    /// A missing value: an empty field, or a word such as `NaN`, `-`, `n/a`, `1.#QNAN`.
    Missing,
    /// Any other text, such as a name.
    Text,
}

/// Maximum length of a numeric field, bytes. A longer field is text.
const LONGEST: usize = 64;

/// Powers of ten up to the maximum number of decimals that [`short`] accepts.
const TEN: [f64; DIGITS + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
];

/// Maximum number of digits of a decimal integer that f64 always represents exactly.
const DIGITS: usize = 15;

/// Reads one field, ignoring spaces and quotes around it.
///
/// If `comma` is true, `,` is the decimal mark and `.` groups thousands.
pub(super) fn field(bytes: &[u8], comma: bool) -> Field {
    let b = trim(bytes);
    match b.first() {
        None => Field::Missing,
        Some(b'0'..=b'9' | b'-' | b'+' | b'.' | b',') => match short(b, comma) {
            Some((x, length)) if length == b.len() => Field::Number(x),
            _ => long(b, comma),
        },
        // Minus sign of Unicode.
        Some(0xE2) if b.starts_with(b"\xE2\x88\x92") => match field(&b[3..], comma) {
            Field::Number(x) => Field::Number(-x),
            other => other,
        },
        Some(_) => word(b),
    }
}

/// Number at the start of the bytes, with at most 15 digits and without exponent, and its length in bytes. It is the quotient of two exact
/// numbers and therefore correctly rounded.
#[inline]
pub(super) fn short(b: &[u8], comma: bool) -> Option<(f64, usize)> {
    let mark = if comma { b',' } else { b'.' };
    let first = *b.first()?;
    let start = usize::from(first == b'-' || first == b'+');
    let (mut at, mut digits, mut places) = (start, 0u64, None);
    while let Some(&c) = b.get(at) {
        let digit = c.wrapping_sub(b'0');
        if digit <= 9 {
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(digit));
        } else if c == mark && places.is_none() {
            places = Some(at + 1);
        } else {
            break;
        }
        at += 1;
    }
    let count = at - start - usize::from(places.is_some());
    if count == 0 || count > DIGITS {
        return None;
    }
    let size = digits as f64 / TEN[places.map_or(0, |from| at - from)];
    Some((if first == b'-' { -size } else { size }, at))
}

/// Value of a field; NaN if the field is not a number.
pub(super) fn value(bytes: &[u8], comma: bool) -> f64 {
    match field(bytes, comma) {
        Field::Number(x) => x,
        Field::Missing | Field::Text => f64::NAN,
    }
}

/// Removes spaces, tabs, carriage returns, quotes and zero bytes from both ends.
pub(super) fn trim(b: &[u8]) -> &[u8] {
    let kept = |c: &u8| !matches!(c, b' ' | b'\t' | b'\r' | b'"' | b'\'' | 0);
    let start = b.iter().position(kept).unwrap_or(b.len());
    let end = b.iter().rposition(kept).map_or(start, |last| last + 1);
    &b[start..end]
}

/// Characters that group thousands, in addition to point and comma: apostrophe, space, and their typographic forms.
const GROUPS: [&str; 5] = ["\u{2019}", "\u{202f}", "\u{a0}", "'", " "];

/// Reads the fields that `short` does not: numbers with exponents, many digits or grouped thousands, and unusual words for missing values.
fn long(b: &[u8], comma: bool) -> Field {
    let Ok(text) = std::str::from_utf8(b) else {
        return Field::Text;
    };
    if b.len() > LONGEST {
        return Field::Text;
    }
    let point = if comma { "." } else { "," };
    let mut groups = std::iter::once(point).chain(GROUPS);
    let group = groups.find(|group| text.contains(group)).unwrap_or(point);
    if !is_grouped(text, group) {
        return Field::Text;
    }
    let plain = text.replace(group, "");
    let plain: String = plain
        .chars()
        .map(|c| match c {
            ',' if comma => '.',
            'D' | 'd' => 'e', // exponent in Fortran
            c => c,
        })
        .collect();
    match plain.parse::<f64>() {
        Ok(x) if x.is_finite() => Field::Number(x),
        Ok(_) => Field::Missing,
        Err(_) if plain.contains('#') || plain.chars().all(|c| "-+.,".contains(c)) => {
            Field::Missing
        }
        Err(_) => word(b),
    }
}

/// Whether thousands separators, if any, separate groups of three digits and occur only before the decimal mark.
fn is_grouped(text: &str, mark: &str) -> bool {
    let mut groups = text.split(mark);
    let _leading = groups.next();
    let mut last = None;
    groups.all(|group| {
        let before_is_whole = last.replace(group.len() == 3).unwrap_or(true);
        let digits = group.bytes().take_while(u8::is_ascii_digit).count();
        before_is_whole && digits == 3
    })
}

fn word(b: &[u8]) -> Field {
    let mut nothing = "nan na n/a null none inf -inf -nan +inf missing -nan(ind)".split(' ');
    if nothing.any(|word| b.eq_ignore_ascii_case(word.as_bytes())) {
        Field::Missing
    } else {
        Field::Text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_agrees_with_the_standard_library() {
        for text in [
            "0",
            "-0.00",
            "745.4661142",
            "331.7057913303967",
            "1e-3",
            "+2.5E+02",
            ".5",
            "5.",
            "-22.9",
            "0.1",
            "123456789012345678",
            "0.000000000000001",
            "9007199254740993",
            "1.7976931348623157e308",
        ] {
            let expected: f64 = text.parse().unwrap();
            match field(text.as_bytes(), false) {
                Field::Number(x) => assert_eq!(x.to_bits(), expected.to_bits(), "{text}"),
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    #[test]
    fn decimal_commas_thousands_quotes_and_fortran_exponents_are_numbers() {
        assert_eq!(field(b" \"-12,5\" ", true), Field::Number(-12.5));
        assert_eq!(field(b"1.234,5", true), Field::Number(1234.5));
        assert_eq!(field(b"1.5D+02", false), Field::Number(150.0));
    }

    #[test]
    fn words_for_nothing_are_missing_and_other_words_are_text() {
        for nothing in [
            "", "  ", "NaN", "-", "n/a", "1.#QNAN", "-1.#IND", "1e999", "--",
        ] {
            assert_eq!(
                field(nothing.as_bytes(), false),
                Field::Missing,
                "{nothing}"
            );
        }
        for text in ["Left", "12:30:01", "1,5", "0x10", "1.2.3", "\u{e9}"] {
            assert_eq!(field(text.as_bytes(), false), Field::Text, "{text}");
        }
    }
}
