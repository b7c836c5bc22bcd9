//! Fast reader for rows that contain only simple numbers. Most rows of a long recording are such rows.

use super::delimited::{Delimiters, Separator};
use crate::read::number::short;

/// Reads the selected fields (numbers from 0, ascending) of the row at the start of `rest`. Returns the length of the row with its line
/// end.
///
/// `None` if the general reader must parse the row. In such a row, a field is not a short number, a field is missing, or there is no line
/// end. The content of `row` is then undefined.
#[inline]
pub(super) fn plain_row(
    rest: &[u8],
    delimiters: Delimiters,
    places: &[usize],
    row: &mut [f64],
) -> Option<usize> {
    let Separator::Byte(separator) = delimiters.separator else {
        return None;
    };
    let (mut at, mut next) = (0, 0);
    for column in 0..=*places.last()? {
        let (x, length) = short(&rest[at..], delimiters.comma)?;
        let end = *rest.get(at + length)?;
        let is_last = next + 1 == places.len() && places[next] == column;
        let is_ended = end == separator || is_last && matches!(end, b'\n' | b'\r');
        if !is_ended {
            return None;
        }
        if places[next] == column {
            row[next] = x;
            next += 1;
        }
        at += length + 1;
    }
    // The byte after the last selected field may be the line end.
    let end = rest[at - 1..].iter().position(|&b| b == b'\n')?;
    Some(at + end)
}

#[cfg(test)]
mod tests {
    use super::super::delimited::Fields;
    use super::*;
    use crate::read::number::value;

    #[test]
    fn every_row_is_read_as_field_by_field_or_left_to_it() {
        let dot = |byte: u8, comma: bool| Delimiters {
            separator: Separator::Byte(byte),
            comma,
        };
        let mut plain = 0;
        for (delimiters, text) in [
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
            let places = [0, 1, 2];
            let mut row = [f64::NAN; 3];
            let Some(length) = plain_row(text.as_bytes(), delimiters, &places, &mut row) else {
                continue;
            };
            plain += 1;
            let line = text.split_inclusive('\n').next().unwrap();
            assert_eq!(length, line.len(), "{text:?}");
            let fields = Fields::new(line.trim_end().as_bytes(), delimiters);
            let slow: Vec<f64> = fields.take(3).map(|f| value(f, delimiters.comma)).collect();
            let bits = |row: &[f64]| row.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
            assert_eq!(bits(&row), bits(&slow), "{text:?}");
        }
        assert_eq!(plain, 3);
        let mut row = [0.0; 2];
        let some = plain_row(b"7,8,9,10\n", dot(b',', false), &[1, 3], &mut row);
        assert_eq!((some, row), (Some(9), [8.0, 10.0]));
    }
}
