//! Rows of plain numbers, read in one pass over their bytes: most of a long recording.

use super::layout::{Layout, Separator};
use crate::force::read::number::{EXACT, TEN};

/// Most digits of a number that this reader takes.
const DIGITS: usize = 17;

/// Reads the wanted fields (numbers from 0, ascending) of the row that `rest` begins with; the length of the row with
/// its line end.
///
/// `None`, with `row` in any state, for a row that needs more care: one that has anything but digits, signs and one
/// decimal mark in a field up to the last wanted one, that lacks such a field, or is the last without a line end.
#[inline]
pub(super) fn plain_row(
    rest: &[u8],
    layout: Layout,
    wanted: &[usize],
    row: &mut [f64],
) -> Option<usize> {
    let Separator::Byte(separator) = layout.separator else {
        return None;
    };
    let mark = if layout.comma { b',' } else { b'.' };
    let (mut at, mut next, mut column) = (0, 0, 0);
    while next < wanted.len() {
        let first = *rest.get(at)?;
        at += usize::from(first == b'-' || first == b'+');
        let start = at;
        let mut mantissa = 0u64;
        digits(rest, &mut at, &mut mantissa);
        let (mut count, mut behind) = (at - start, 0);
        if rest.get(at) == Some(&mark) {
            at += 1;
            let start = at;
            digits(rest, &mut at, &mut mantissa);
            behind = at - start;
            count += behind;
        }
        let end = *rest.get(at)?;
        if count == 0 || count > DIGITS || mantissa > EXACT {
            return None;
        }
        let last = matches!(end, b'\n' | b'\r');
        if end != separator && !last {
            return None;
        }
        if wanted[next] == column {
            let size = mantissa as f64 / TEN[behind];
            row[next] = if first == b'-' { -size } else { size };
            next += 1;
        }
        if last {
            break;
        }
        at += 1;
        column += 1;
    }
    if next < wanted.len() {
        return None;
    }
    // The last separator is passed already; a line end is not.
    let end = rest[at..].iter().position(|&b| b == b'\n')?;
    Some(at + end + 1)
}

/// Adds the digits at a place to a number, and passes over them.
#[inline]
fn digits(rest: &[u8], at: &mut usize, mantissa: &mut u64) {
    while let Some(c) = rest.get(*at) {
        let digit = c.wrapping_sub(b'0');
        if digit > 9 {
            return;
        }
        *mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
        *at += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::super::layout::Fields;
    use super::*;
    use crate::force::read::number::value;

    #[test]
    fn every_row_is_read_as_field_by_field_or_left_to_it() {
        let dot = |byte: u8, comma: bool| Layout {
            separator: Separator::Byte(byte),
            comma,
        };
        let mut plain = 0;
        for (layout, text) in [
            (dot(b',', false), "0.001,745.46,-0.00\n"),
            (dot(b',', false), "1,2,3,words, and more\r\n"),
            (dot(b',', false), "+5,.5,5.\r\n"),
            (dot(b';', true), "0,125;-12,5;1e3\n"),
            (dot(b';', true), "0,125;-12,5;1.234,5\n"),
            (dot(b'\t', false), "1\t\t3\n"),
            (dot(b'\t', false), " 1\t2\t3\n"),
            (dot(b',', false), "1,2\n3,4,5\n"),
            (dot(b',', false), "1,2,3"),
            (dot(b',', false), "123456789012345678,1,2\n"),
            (dot(b',', false), "9007199254740993,1,2\n"),
            (dot(b',', false), "1.2.3,1,2\n"),
            (dot(b',', false), "-,1,2\n"),
            (dot(b',', false), "00:00.1,1,2\n"),
        ] {
            let wanted = [0, 1, 2];
            let mut row = [f64::NAN; 3];
            let Some(length) = plain_row(text.as_bytes(), layout, &wanted, &mut row) else {
                continue;
            };
            plain += 1;
            let line = text.split_inclusive('\n').next().unwrap();
            assert_eq!(length, line.len(), "{text:?}");
            let fields = Fields::new(line.trim_end().as_bytes(), layout);
            let slow: Vec<f64> = fields.take(3).map(|f| value(f, layout.comma)).collect();
            let bits = |row: &[f64]| row.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
            assert_eq!(bits(&row), bits(&slow), "{text:?}");
        }
        assert_eq!(plain, 3);
        let mut row = [0.0; 2];
        let some = plain_row(b"7,8,9,10\n", dot(b',', false), &[1, 3], &mut row);
        assert_eq!((some, row), (Some(9), [8.0, 10.0]));
    }
}
