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
        let Digits {
            mantissa,
            count,
            behind,
        } = digits(rest, &mut at, mark);
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

/// The digits of a number without sign.
struct Digits {
    /// All of them as one whole number.
    mantissa: u64,
    /// How many.
    count: usize,
    /// How many of them stand behind the decimal mark.
    behind: usize,
}

/// Reads digits with at most one decimal mark, and passes over them: the first eight bytes at once, what is left one
/// by one.
#[inline]
fn digits(rest: &[u8], at: &mut usize, mark: u8) -> Digits {
    let start = *at;
    let mut found = Digits {
        mantissa: 0,
        count: 0,
        behind: 0,
    };
    let mut marked = false;
    if let Some(block) = rest.get(start..).and_then(|r| r.first_chunk::<8>()) {
        let (value, taken, before) = eight(u64::from_le_bytes(*block), mark);
        marked = before < taken;
        found.mantissa = value;
        found.count = taken - usize::from(marked);
        found.behind = found.count - before;
        *at += taken;
        // Whatever follows fewer than eight bytes is no digit, and no first mark.
        if taken < 8 {
            return found;
        }
    }
    while let Some(&c) = rest.get(*at) {
        let digit = c.wrapping_sub(b'0');
        if digit <= 9 {
            let more = found.mantissa.wrapping_mul(10);
            found.mantissa = more.wrapping_add(u64::from(digit));
            found.count += 1;
            found.behind += usize::from(marked);
        } else if c == mark && !marked {
            marked = true;
        } else {
            break;
        }
        *at += 1;
    }
    found
}

/// The number that eight bytes (the first lowest) begin with: its digits as a whole number, the bytes that it takes,
/// the digits before the mark. Without a mark all bytes taken are digits before it.
#[inline]
fn eight(bytes: u64, mark: u8) -> (u64, usize, usize) {
    let others = no_digits(bytes);
    let before = others.trailing_zeros() as usize / 8;
    if before == 8 {
        return (joined(bytes), 8, 8);
    }
    let place = 8 * before;
    let (digits, taken, count) = if (bytes >> place) as u8 == mark {
        // The mark is left out; what stood behind it moves up.
        let low = (1u64 << place) - 1;
        let rest = others & !(0xFF << place);
        let taken = rest.trailing_zeros() as usize / 8;
        ((bytes & low) | ((bytes >> 8) & !low), taken, taken - 1)
    } else {
        (bytes, before, before)
    };
    if count == 0 {
        return (0, taken, before);
    }
    (joined(digits << (8 * (8 - count))), taken, before)
}

/// Bits in every byte that is no digit, none in the others.
#[inline]
fn no_digits(bytes: u64) -> u64 {
    const EACH: u64 = 0x0101_0101_0101_0101;
    let high = (bytes & (0xF0 * EACH)) ^ (0x30 * EACH);
    // Adding 6 carries into the upper half of the byte where the lower half is above 9.
    let low = ((bytes & (0x0F * EACH)) + 0x06 * EACH) & (0xF0 * EACH);
    high | low
}

/// Eight digits, the first lowest and those missing in front 0, as a whole number: pairs, then fours, then all.
#[inline]
fn joined(digits: u64) -> u64 {
    let digits = digits & 0x0F0F_0F0F_0F0F_0F0F;
    let pairs = (digits.wrapping_mul(10 * 256 + 1) >> 8) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs.wrapping_mul(100 * 65_536 + 1) >> 16) & 0x0000_FFFF_0000_FFFF;
    fours.wrapping_mul(10_000 * (1 << 32) + 1) >> 32
}

#[cfg(test)]
mod tests {
    use super::super::layout::Fields;
    use super::*;
    use crate::force::read::number::value;

    #[test]
    fn eight_bytes_at_once_are_the_digits_one_by_one() {
        let mut cases = 0;
        for whole in [
            "",
            "0",
            "7",
            "42",
            "745",
            "1234",
            "86399",
            "123456",
            "9999999",
            "00000000",
            "123456789",
        ] {
            for part in [
                "",
                ".",
                ".0",
                ".5",
                ".46",
                ".999",
                ".1234567",
                ".12345678901",
                "..5",
                ".5.5",
            ] {
                for end in [
                    "\n",
                    ",1\n",
                    ",",
                    "",
                    "e5\n",
                    "/",
                    ":",
                    "\u{ff}\u{ff}",
                    "-1,2,3,4,5\n",
                ] {
                    let text = format!("{whole}{part}{end}");
                    let slow: Vec<u8> = text
                        .bytes()
                        .scan(false, |marked, c| {
                            let first =
                                c == b'.' && !std::mem::replace(marked, *marked || c == b'.');
                            (c.is_ascii_digit() || first).then_some(c)
                        })
                        .collect();
                    let digits_only = slow.iter().filter(|c| c.is_ascii_digit());
                    let mantissa = digits_only
                        .clone()
                        .fold(0u64, |m, c| 10 * m + u64::from(c - b'0'));
                    let behind = slow
                        .iter()
                        .position(|&c| c == b'.')
                        .map_or(0, |p| slow.len() - p - 1);
                    let mut at = 0;
                    let found = super::digits(text.as_bytes(), &mut at, b'.');
                    assert_eq!(
                        (found.mantissa, found.count, found.behind, at),
                        (mantissa, digits_only.count(), behind, slow.len()),
                        "{text:?}"
                    );
                    cases += 1;
                }
            }
        }
        assert_eq!(cases, 11 * 10 * 9);
    }

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
